#!/usr/bin/env bash
# From a mesh to a leaf storm: sets up, builds, bakes, and simulates 20,000 leaves in wind and on the ground. Pictures and tables are in demo/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

source scripts/steps.sh
step() { printf '\n== %s (%d:%02d)\n' "$*" $((SECONDS / 60)) $((SECONDS % 60)); }

step "Set-up"
scripts/setup.sh build
source scripts/compiler_cache.sh
read_cpu
SECONDS=0 cpu_of_setup=$cpu # the reported times exclude set-up
start_clock build/demo
mkdir -p demo

step "Build and install the library and the baker"
configure build/demo --preset release -DLR_BUILD_TESTS=OFF
cmake --build build/demo
cmake --install build/demo --prefix build/demo/install >/dev/null

step "Build the samples against the installed package, as a user would"
configure build/demo-samples -S samples -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$PWD/build/demo/install"
cmake --build build/demo-samples --target hello leaf_storm viewer viewer_assets

step "Bake the leaf"
build/demo/install/bin/lr_bake mesh assets/leaf.obj -o demo/leaf.lrb --unit m --density 350 --report demo/leaf.json

step "A first body: samples/hello.c"
build/demo-samples/hello

step "The storm"
build/demo-samples/leaf_storm --asset demo/leaf.lrb --mesh assets/leaf.obj --count 20000 --seconds 10 \
    --wind 2,0,0.5 --threads "$(nproc)" --png demo/leaf_storm.png --tracks demo/tracks.png \
    --csv demo/leaf_storm.csv --json demo/leaf_storm.json

step "Leaves land, lie, are kicked by a walker, and blow away"
build/demo-samples/leaf_storm --asset demo/leaf.lrb --mesh assets/leaf.obj --count 20000 --seconds 19.5 \
    --ground --walk 11.5 --gusts 15.5 --check --threads "$(nproc)" --at 3,6,11,14.5,17,19.5 --width 960 --height 540 \
    --png demo/leaves_on_the_ground.png --json demo/leaves_on_the_ground.json

step "A heap of leaves, a walker through it, and a gust"
build/demo-samples/leaf_storm --asset demo/leaf.lrb --mesh assets/leaf.obj --count 1800 --ground --heap --fall 2 \
    --walk 1.6 --gusts 6 --gust-speed 5 --substeps 2 --seconds 7.3 --check --threads "$(nproc)" \
    --at 1.2,2.8,4.4,5.1,6.7,7.3 --width 960 --height 540 --png demo/a_heap_of_leaves.png --json demo/a_heap_of_leaves.json

step "The viewer: samples/viewer"
build/demo-samples/viewer --seconds 12 --count 9000 --trails --threads "$(nproc)" --png demo/viewer.png
build/demo-samples/viewer --scene flight --seconds 4 --trails --threads "$(nproc)" --png demo/flight.png

read_cpu
note_time demo.sh $SECONDS $((cpu - cpu_of_setup))
printf '\nLook at demo/leaf_storm.png (the storm), demo/tracks.png (single falls), demo/leaves_on_the_ground.png,\ndemo/a_heap_of_leaves.png, demo/viewer.png,\nand demo/flight.png (winged seeds, curled leaves, darts). On a desktop: build/demo-samples/viewer\n'
