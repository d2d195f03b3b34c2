#!/usr/bin/env bash
# Prepares demo/ for the editor: builds the addon into demo/addons, bakes the leaves of its scene.
#   bindings/godot/demo.sh PREFIX [DIRECTORY]      PREFIX: an installed package; DIRECTORY: for a copy of the project instead
# SPDX-License-Identifier: MIT
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tree=$(cd "$here/../.." && pwd)
prefix=$(cd "${1:?usage: demo.sh PREFIX [DIRECTORY]}" && pwd)
demo=${2:-$here/demo}
build=$tree/build/godot/demo
mkdir -p "$demo" "$build"
demo=$(cd "$demo" && pwd)
[ "$demo" = "$here/demo" ] || cp "$here/demo/project.godot" "$demo"
cmake -S "$here" -B "$build" -DCMAKE_PREFIX_PATH="$prefix" -DLANGEVIN_GODOT_OUTPUT="$demo/addons/langevin_rigid" >/dev/null
cmake --build "$build" --parallel 2 >/dev/null
for leaf in leaf leaf_maple; do
    cp "$tree/assets/$leaf.obj" "$demo/addons/langevin_rigid/demo/"
    LD_LIBRARY_PATH="$prefix/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}" \
        "$prefix/bin/lr_bake" mesh "$tree/assets/$leaf.obj" -o "$demo/addons/langevin_rigid/demo/$leaf.lrb" --density 350 --quiet
done
# The engine finds extensions through this list. Without it the first headless run does not know the classes, or crashes at its end.
mkdir -p "$demo/.godot"
echo "res://addons/langevin_rigid/langevin_rigid.gdextension" >"$demo/.godot/extension_list.cfg"
echo "ready: open $demo/project.godot in Godot 4.4 or later, and press play"
