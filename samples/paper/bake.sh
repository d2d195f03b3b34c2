#!/bin/sh
# Bakes the bodies of paper_figures: an asset and a report for each.
#   samples/paper/bake.sh LR_BAKE ASSETS OUTPUT_DIR      (lr_bake; the folder assets of the project; where to write)
# SPDX-License-Identifier: MIT
set -eu
[ $# -eq 3 ] || { sed -n '2,3p' "$0" >&2; exit 1; }
lr_bake=$1 assets=$2 out=$3
mkdir -p "$out"

bake() { # NAME MESH OPTIONS...
    name=$1 mesh=$2
    shift 2
    "$lr_bake" mesh "$assets/$mesh" -o "$out/$name.lrb" --report "$out/$name.json" --name "$name" --if-changed --quiet "$@"
}

bake leaf ellipsoid_leaf.obj --density 800
# Paper of 80 g/m^2: a surface for the air; the layers of the folded square give its mass.
for folded in paper_plane paper_plane_uneven; do
    bake "${folded#paper_}" "${folded}_surface.obj" --sheet --thickness 0.0001 --areal-density 0.08 \
        --mass-from "$assets/${folded}_layers.obj"
done
# Rubber just heavier than water: the paper gives no density.
bake rubber ellipsoid_rubber.obj --density 1100 --fluid water
bake rubber_coarse ellipsoid_rubber_coarse.obj --density 1100 --fluid water
# Fig. 2: with this density the leaf has the paper's Reynolds number of 3.8e3, in an empty stream and in its own wake.
bake table ellipsoid_leaf.obj --density 623 --grid 32,32,16
bake table_wake ellipsoid_leaf.obj --density 623 --grid 32,32,16 --wake
# The paper's time for a table is for this grid.
bake table_paper_grid ellipsoid_leaf.obj --density 623 --grid 32,32,8
