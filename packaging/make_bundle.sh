#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Makes the archive of one platform from the output of packaging/build_library.sh, and beside it Python's wheel and Blender's zip.
#   packaging/make_bundle.sh PLATFORM OUT
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source packaging/platforms.sh

select_platform "${1:?which platform}"
out=${2:?which folder}
folder=$(platform_folder "$platform")
version=$(sed -n 's/^project(langevin_rigid VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
name=langevin_rigid-$version-$platform
stage=$folder/stage/$name
rm -rf "$folder/stage"
mkdir -p "$stage"

for component in runtime bake; do
    cmake --install "$(platform_build "$platform")" --prefix "$stage" --component "$component" --strip >"$folder/install.log"
done
if [ "$platform" = windows-x64 ]; then
    # An import library for the linkers of Microsoft and LLVM, and the .def file, from which others can be made.
    {
        echo "LIBRARY langevin_rigid.dll"
        echo EXPORTS
        sed 's/^/    /' tests/api/exports.txt
    } >"$stage/lib/langevin_rigid.def"
    dlltool=$(command -v llvm-dlltool || command -v llvm-dlltool-14) ||
        { echo "windows-x64 needs llvm-dlltool: scripts/setup.sh package windows" >&2; exit 3; }
    "$dlltool" -m i386:x86-64 -d "$stage/lib/langevin_rigid.def" -l "$stage/lib/langevin_rigid.lib"
fi

mkdir -p "$stage/samples" "$stage/assets"
cp samples/hello.c samples/small/*.cpp "$stage/samples/"
cp packaging/sample.cmake "$stage/samples/CMakeLists.txt"
# Baked by the packaged lr_bake with the options in assets/README.md; once for all platforms of a run (LR_BAKED: a folder), as users do.
if [ -n "${LR_BAKED:-}" ]; then
    cp "$LR_BAKED"/*.lrb "$stage/assets/"
else
    export WINEDEBUG=${WINEDEBUG:--all}
    bake() { # asset, mesh, options
        "${runner[@]}" "$stage/bin/lr_bake$exe" mesh "assets/$2.obj" -o "$stage/assets/$1.lrb" "${@:3}" --quiet
    }
    bake leaf leaf --density 350
    bake leaf_maple leaf_maple --density 350
    bake petal petal --density 700
    bake confetti confetti --density 800
    bake samara samara --density 1716
    bake curled_leaf curled_leaf --density 330
    bake dart dart --density 1850 --center-of-mass 0.0396,0,0
    bake paper_plane paper_plane_surface --sheet --thickness 0.0001 --areal-density 0.08 --mass-from assets/paper_plane_layers.obj
fi
for mesh in leaf leaf_maple petal confetti samara curled_leaf dart paper_plane{,_surface,_layers}; do cp "assets/$mesh.obj" "$stage/assets/"; done
cp assets/README.md "$stage/assets/"

# C#'s sources. Other bindings are packages of their own: Python's below, engines' by packaging/package_engines.sh, the web's by package_wasm.sh.
git ls-files -z bindings/csharp | grep -zvE '^bindings/csharp/(tests/|test\.sh|\.gitignore)' | xargs -0 cp --parents -t "$stage"
mkdir -p "$stage/docs/guide" "$stage/docs/images"
cp docs/guide/{engines,languages}.md "$stage/docs/guide/"
grep -ho '\.\./images/[a-z_]*\.png' "$stage"/docs/guide/*.md | sort -u | sed 's|^\.\./|docs/|' | xargs -r cp -t "$stage/docs/images"

cp LICENSE "$stage/"
rm -rf "$stage/share"
python3 packaging/third_party.py --platform "$platform" --sources build/sources --out "$stage"
# A wheel with library, baker and licences, and Blender's zip, beside the archive.
{ PYTHON=/usr/bin/python3 bindings/python/wheel.sh "$stage" "$out" &&
    { [ "$platform" = linux-arm64 ] || PYTHON=/usr/bin/python3 bindings/python/extension.py "$stage" "$out"; }; } >"$folder/wheel.log" 2>&1 ||
    { cat "$folder/wheel.log" >&2; exit 1; }
floor=()
case $platform in
linux-*)
    floor=(--library-floor "$(packaging/glibc_floor.sh "$stage/$library")"
        --baker-floor "$(packaging/glibc_floor.sh "$stage/bin/lr_bake")")
    ;;
esac
python3 packaging/package_readme.py --platform "$platform" --version "$version" --stage "$stage" "${floor[@]}" \
    --docs docs/maintainers/releases.md
packaging/write_archive.sh "$folder/stage" "$name" "$out/$name.$suffix"
