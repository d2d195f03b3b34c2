#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Builds the libraries bundled in a package as static libraries from Debian's sources, into build/packaging/PLATFORM/dependencies. Does
# nothing if they were built from the same sources with the same flags.
#   packaging/build_dependencies.sh linux-x64|windows-x64|linux-arm64 [--runtime]
# --runtime: only the runtime's dependencies, into build/packaging/PLATFORM/runtime-dependencies
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source packaging/platforms.sh

select_platform "${1:?which platform}"
folder=$(platform_folder "$platform")
sources=$PWD/build/sources
runtime=false
prefix=$folder/dependencies
if [ "${2:-}" = --runtime ]; then
    runtime=true
    prefix=$folder/runtime-dependencies
    scripts/debian_source.sh "$sources" highway >/dev/null
else
    packaging/fetch_sources.sh >/dev/null
fi
jobs=${LR_JOBS:-$(nproc)}

# No contraction, which would differ between ARM and x86. No paths in the code.
# Sections by function, so that the linker drops unused functions.
flags="-ffp-contract=off -fno-fast-math -fvisibility=hidden -ffunction-sections -fdata-sections -w -ffile-prefix-map=$sources=. -ffile-prefix-map=$folder=."
# GCC for 64-bit Windows assumes what does not hold of stack slots and inline functions (cmake/compile_flags.cmake).
[ "$platform" != windows-x64 ] || flags+=" -Wa,-muse-unaligned-vector-move -fno-ipa-ra"

stamp="$( (cat "$sources/versions" packaging/build_dependencies.sh
    find packaging/cmake -type f -print0 | sort -z | xargs -0 cat
    printf '%s\n' "${toolchain[@]}" | sed -n 's/.*TOOLCHAIN_FILE=//p' | xargs -r cat) | sha256sum | cut -c1-16)"
if [ -e "$prefix/stamp" ] && [ "$(cat "$prefix/stamp")" = "$stamp" ]; then
    echo "dependencies of $platform: already built"
    exit 0
fi
rm -rf "$prefix" "$prefix.build"
mkdir -p "$prefix"/{lib/cmake,lib/pkgconfig,include} "$prefix.build"
start=$SECONDS

# Hides libraries and pkg-config files of the build machine.
export PKG_CONFIG_LIBDIR=$prefix/lib/pkgconfig PKG_CONFIG_PATH=
common=("${toolchain[@]}" -G Ninja -DCMAKE_BUILD_TYPE=Release "-DCMAKE_C_FLAGS=$flags" "-DCMAKE_CXX_FLAGS=$flags"
    "-DCMAKE_C_FLAGS_RELEASE=-O2 -DNDEBUG" "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG" -DCMAKE_POSITION_INDEPENDENT_CODE=ON
    "-DCMAKE_INSTALL_PREFIX=$prefix" -DCMAKE_INSTALL_LIBDIR=lib "-DCMAKE_PREFIX_PATH=$prefix" "-DCMAKE_FIND_ROOT_PATH=$prefix"
    -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF -DBUILD_SHARED_LIBS=OFF)
build() { # name, source folder, target ("install": also installs), arguments of CMake
    local name=$1 source=$2 target=$3 log=$prefix.build/$1.log
    if ! { cmake -S "$source" -B "$prefix.build/$name" "${common[@]}" "${@:4}" &&
        cmake --build "$prefix.build/$name" -j "$jobs" --target "$target"; } >"$log" 2>&1; then
        tail -n 40 "$log" >&2
        echo "$name could not be built for $platform: $log" >&2
        exit 1
    fi
}
built() { cp "$prefix.build/$1" "$prefix/$2"; } # for libraries without install rules

build highway "$sources/highway" install -DHWY_ENABLE_TESTS=OFF -DHWY_ENABLE_EXAMPLES=OFF -DHWY_ENABLE_CONTRIB=OFF \
    -DHWY_FORCE_STATIC_LIBS=ON -DHWY_SYSTEM_GTEST=OFF

# Header-only libraries of the build machine, linked one by one, so that a cross compiler finds no other headers. The native compiler
# searches /usr/include anyway; without other paths it shares its compiler cache with the test builds.
include=$prefix/include
[ "$platform" != linux-x64 ] || include=/usr/include
for header in eigen3 boost nlohmann CLI flatbuffers doctest utf8.h utf8; do
    [ -e "/usr/include/$header" ] || { echo "no /usr/include/$header: scripts/setup.sh package" >&2; exit 1; }
    [ "$include" = /usr/include ] || ln -s "/usr/include/$header" "$include/$header"
done
if [ "$include" = /usr/include ] && diff -qr --exclude=contrib "$prefix/include/hwy" /usr/include/hwy >/dev/null; then
    # The two definitions differ only in the declared visibility of functions, which the linker hides.
    rm -r "$prefix/include/hwy"
    sed -i 's/HWY_STATIC_DEFINE/HWY_SHARED_DEFINE/' "$prefix"/lib/cmake/hwy/*.cmake
fi
version_of() { dpkg-query -W -f='${Version}' "$1" | sed 's/^[0-9]*://; s/[-+~].*//'; }
header_package() { # CMake's name, target, include folder, Debian package
    mkdir -p "$prefix/lib/cmake/$1"
    sed -e "s|@TARGET@|$2|; s|@INCLUDE@|$3|" packaging/cmake/header_only.cmake.in >"$prefix/lib/cmake/$1/$1Config.cmake"
    sed -e "s|@VERSION@|$(version_of "$4")|" packaging/cmake/any_version.cmake.in >"$prefix/lib/cmake/$1/$1ConfigVersion.cmake"
}
header_package Eigen3 Eigen3::Eigen "$include/eigen3" libeigen3-dev
header_package nlohmann_json nlohmann_json::nlohmann_json "$include" nlohmann-json3-dev
header_package CLI11 CLI11::CLI11 "$include" libcli11-dev
header_package doctest doctest::doctest "$include" doctest-dev
cp /usr/lib/cmake/doctest/doctest.cmake /usr/lib/cmake/doctest/doctestAddTests.cmake "$prefix/lib/cmake/doctest/"
echo 'list(APPEND CMAKE_MODULE_PATH "${CMAKE_CURRENT_LIST_DIR}")' >>"$prefix/lib/cmake/doctest/doctestConfig.cmake"
mkdir -p "$prefix/lib/cmake/FlatBuffers" "$prefix/lib/cmake/draco"
sed -e "s|@INCLUDE@|$include|" packaging/cmake/FlatBuffersConfig.cmake.in >"$prefix/lib/cmake/FlatBuffers/FlatBuffersConfig.cmake"
cp packaging/cmake/dracoConfig.cmake "$prefix/lib/cmake/draco/"

complete() {
    cp "$sources/versions" "$prefix/versions"
    echo "$stamp" >"$prefix/stamp"
    echo "dependencies of $platform: built in $((SECONDS - start)) s"
    exit 0
}
! $runtime || complete

build compression packaging/cmake/compression install "-DZLIB_SOURCE=$sources/zlib"
build libpng "$sources/libpng1.6" install -DPNG_SHARED=OFF -DPNG_TESTS=OFF -DPNG_EXECUTABLES=OFF
build draco "$sources/draco" draco_static -DDRACO_TESTS=OFF -DDRACO_TRANSCODER_SUPPORTED=OFF
built draco/libdraco.a lib/
mkdir -p "$prefix/include/draco"
(cd "$sources/draco/src/draco" && find . -name '*.h' -exec cp --parents '{}' "$prefix/include/draco" ';')
find "$prefix.build/draco" -name draco_features.h -exec cp '{}' "$prefix/include/draco" ';'

# Only the importers that lr_bake uses; it has its own readers for OBJ and PLY.
build assimp "$sources/assimp" install -DASSIMP_BUILD_ALL_IMPORTERS_BY_DEFAULT=OFF -DASSIMP_BUILD_ALL_EXPORTERS_BY_DEFAULT=OFF \
    -DASSIMP_NO_EXPORT=ON -DASSIMP_BUILD_STL_IMPORTER=ON -DASSIMP_BUILD_GLTF_IMPORTER=ON -DASSIMP_BUILD_FBX_IMPORTER=ON \
    -DASSIMP_BUILD_COLLADA_IMPORTER=ON -DASSIMP_BUILD_TESTS=OFF -DASSIMP_BUILD_ASSIMP_TOOLS=OFF -DASSIMP_BUILD_SAMPLES=OFF \
    -DASSIMP_BUILD_ZLIB=OFF -DASSIMP_WARNINGS_AS_ERRORS=OFF -DASSIMP_IGNORE_GIT_HASH=ON -DASSIMP_INJECT_DEBUG_POSTFIX=OFF \
    "-DCMAKE_CXX_FLAGS=$flags -DASSIMP_ENABLE_DRACO=1"

complete
