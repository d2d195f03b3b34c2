#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Checks that equal sources give equal bytes: builds the runtime library twice, in folders with different names and lengths, one outside
# the sources, at different times and in different environments. docs/maintainers/testing.md
#   scripts/check_reproducible.sh [CMAKE_ARGUMENT...]    the library, without a compiler cache: about 10 minutes on two cores
#   scripts/check_reproducible.sh quick                  a few objects, those most likely to contain a path or time
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
arguments=("$@")
quick=false
if [ "${1:-}" = quick ]; then quick=true arguments=(); fi
export LR_NO_COMPILER_CACHE=1 CCACHE_DISABLE=1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

sources=("$work/a" "$work/another place/with a longer name")
builds=("$work/a/out" "$work/elsewhere")
for copy in "${sources[@]}"; do
    mkdir -p "$copy"
    cp -r CMakeLists.txt cmake include src packaging LICENSE "$copy/"
done
find "${sources[1]}" -exec touch -d '2001-02-03 04:05:06' {} +

# Objects with an archive index, a generated header, tables of functions, texts of errors.
targets=(--target langevin_rigid)
if $quick; then
    targets=()
    for object in lr_core.dir/api/status_text.cpp lr_core.dir/asset/asset.cpp lr_core.dir/world/schedule/batch_schedule.cpp lr_assets.dir/asset/check_asset_values.cpp; do
        targets+=(--target "src/CMakeFiles/$object.o")
    done
fi
build() { # 0 or 1
    cmake -S "${sources[$1]}" -B "${builds[$1]}" -G Ninja -DCMAKE_BUILD_TYPE=Release -DLR_BUILD_BAKER=OFF -DLR_BUILD_TESTS=OFF \
        "${arguments[@]}" >"$work/log" 2>&1 &&
        cmake --build "${builds[$1]}" -j "${LR_JOBS:-$(nproc)}" "${targets[@]}" >"$work/log" 2>&1 || { tail -n 30 "$work/log"; exit 1; }
}
sums() { # 0 or 1
    (cd "${builds[$1]}" && find . \( -name '*.o' -o -name '*.a' -o -name '*.so.*.*.*' \) -type f | LC_ALL=C sort | xargs -d '\n' sha256sum)
}
(export TZ=UTC LC_ALL=C && umask 022 && build 0)
sleep 1 # a different second
(export TZ=Asia/Tokyo LC_ALL=C.UTF-8 USER=somebody SOURCE_DATE_EPOCH=1 && umask 077 && build 1)

sums 0 >"$work/first"
sums 1 >"$work/second"
if ! diff "$work/first" "$work/second" >"$work/diff"; then
    echo "not reproducible: these files differ"
    sed -n 's/^< [0-9a-f]*  /    /p' "$work/diff"
    exit 1
fi
if grep -raqF "$work" "${builds[@]}" --include='*.o' --include='*.so.*'; then
    echo "a file contains the path of its build folder"
    exit 1
fi
# Checks the check itself: an object that contains its path must differ.
for which in 0 1; do
    echo 'const char* where() { return __FILE__; }' >"${sources[$which]}/where.cpp"
    "${CXX:-c++}" -c "${sources[$which]}/where.cpp" -o "${builds[$which]}/where.o"
done
if diff <(sums 0) <(sums 1) >/dev/null; then
    echo "FAILED: the check missed a file that contains its path"
    exit 1
fi
echo "reproducible: $(wc -l <"$work/first") files are equal, $(grep -c '\.so' "$work/first" || true) of them libraries"
