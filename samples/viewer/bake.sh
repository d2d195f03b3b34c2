#!/bin/sh
# Bakes the bodies of the viewer's scenes.
#   samples/viewer/bake.sh LR_BAKE ASSETS OUTPUT_DIR      (lr_bake; the folder assets of the project; where to write)
# SPDX-License-Identifier: MIT
set -eu
[ $# -eq 3 ] || { sed -n '2,3p' "$0" >&2; exit 1; }
lr_bake=$1 assets=$2 out=$3
mkdir -p "$out"

bake() { # NAME MESH OPTIONS...
    name=$1 mesh=$2
    shift 2
    "$lr_bake" mesh "$assets/$mesh" -o "$out/$name.lrb" --name "$name" --if-changed --quiet "$@"
}

bake leaf leaf.obj --density 350
bake leaf_maple leaf_maple.obj --density 350
bake paper paper.obj --density 800
bake petal petal.obj --density 700
bake confetti confetti.obj --density 800
bake paper_plane paper_plane_surface.obj --sheet --thickness 0.0001 --areal-density 0.08 \
    --mass-from "$assets/paper_plane_layers.obj"
bake samara samara.obj --density 1716
bake curled_leaf curled_leaf.obj --density 330
bake dart dart.obj --density 1850 --center-of-mass 0.0396,0,0
bake rubber ellipsoid_rubber.obj --density 1100
