#!/usr/bin/env bash
# From a mesh to a leaf storm: set-up, build, bake, 20,000 leaves in wind and on the ground, pictures and tables; a viewer. Results in demo/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

step() { printf '\n== %s\n' "$*"; }

step "Set-up"
scripts/setup.sh build
source scripts/compiler_cache.sh

mkdir -p build demo
step "Build and install the library and the baker"
cmake --preset release -DLR_BUILD_TESTS=OFF -B build/demo >build/demo-configure.log 2>&1 ||
    { cat build/demo-configure.log; exit 1; }
cmake --build build/demo
cmake --install build/demo --prefix build/demo/install >/dev/null

step "Build the samples as an outside user would: against the installed package"
cmake -S samples -B build/demo-samples -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_PREFIX_PATH="$PWD/build/demo/install" >build/demo-samples-configure.log 2>&1 ||
    { cat build/demo-samples-configure.log; exit 1; }
cmake --build build/demo-samples

step "Bake the leaf"
build/demo/install/bin/lr_bake mesh assets/leaf.obj -o demo/leaf.lrb --unit m --density 350 --report demo/leaf.json

step "A first body: samples/hello.c"
build/demo-samples/hello

step "The storm"
build/demo-samples/leaf_storm --asset demo/leaf.lrb --mesh assets/leaf.obj --count 20000 --seconds 10 \
    --wind 2,0,0.5 --threads "$(nproc)" --png demo/leaf_storm.png --tracks demo/tracks.png \
    --csv demo/leaf_storm.csv --json demo/leaf_storm.json

step "Leaves land, lie, are walked through, and blow away"
build/demo-samples/leaf_storm --asset demo/leaf.lrb --mesh assets/leaf.obj --count 20000 --seconds 19.5 \
    --ground --walk 11.5 --gusts 15.5 --check --threads "$(nproc)" --at 3,6,11,14.5,17,19.5 --width 960 --height 540 \
    --png demo/leaves_on_the_ground.png --json demo/leaves_on_the_ground.json

step "Leaves lie on leaves: a heap, somebody walks through it, and a gust takes it"
build/demo-samples/leaf_storm --asset demo/leaf.lrb --mesh assets/leaf.obj --count 1800 --ground --heap --fall 2 \
    --walk 1.6 --gusts 6 --gust-speed 5 --substeps 2 --seconds 7.3 --check --threads "$(nproc)" \
    --at 1.2,2.8,4.4,5.1,6.7,7.3 --width 960 --height 540 --png demo/a_heap_of_leaves.png --json demo/a_heap_of_leaves.json

step "A look through the viewer: samples/viewer"
build/demo-samples/viewer --seconds 12 --count 9000 --trails --threads "$(nproc)" --png demo/viewer.png

printf '\nLook at demo/leaf_storm.png (the storm), demo/tracks.png (single falls), demo/leaves_on_the_ground.png,\ndemo/a_heap_of_leaves.png, and demo/viewer.png. On a desktop: build/demo-samples/viewer\n'
