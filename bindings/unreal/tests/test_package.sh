#!/usr/bin/env bash
# package.py must refuse what cannot work, with a reason: test_package.sh PACKAGE_PY PREFIX BUILD_DIR
# SPDX-License-Identifier: MIT
set -euo pipefail
package="$1" prefix="$2" build="$3"
rm -rf "$build"
mkdir -p "$build/empty" "$build/other/LangevinRigid" "$build/changed/include" "$build/changed/lib"
refuse() { # WANTED ARGUMENTS...
    local wanted="$1"
    shift
    if python3 "$package" "$@" >"$build/log.txt" 2>&1; then echo "not refused: $*"; exit 1; fi
    grep -q -- "$wanted" "$build/log.txt" || { echo "refused for another reason: $*"; cat "$build/log.txt"; exit 1; }
}
refuse 'no langevin_rigid library in' --native "$build/empty" --out "$build/a"
refuse 'is for Linux, not for Win64' --native "Win64=$prefix" --out "$build/a"
refuse 'two of --native are for the same platform' --native "$prefix" --native "$prefix" --out "$build/a"
refuse 'is not this plugin' --native "$prefix" --out "$build/other"
cp -L "$prefix/lib/liblangevin_rigid.so" "$build/changed/lib/"
sed 's/LR_VERSION_MINOR 1/LR_VERSION_MINOR 2/' "$prefix/include/langevin_rigid.h" >"$build/changed/include/langevin_rigid.h"
refuse 'all must be of one version' --native "$prefix" --native "$build/changed" --out "$build/a"
rm "$build/changed/include/langevin_rigid.h"
refuse 'is missing' --native "$build/changed" --out "$build/a"
# A library that it needs and that is given goes along; twice into the same folder is fine.
needed="$(ldd "$prefix/lib/liblangevin_rigid.so" | awk '$1 ~ /^lib(ccd|hwy)/ {print $3; exit}')"
if [[ -n $needed ]]; then
    python3 "$package" --native "$prefix" --also "$needed" --out "$build/a" >/dev/null 2>&1
    test -f "$build/a/LangevinRigid/Source/ThirdParty/LangevinRigidLibrary/lib/Linux/$(basename "$needed")"
fi
python3 "$package" --native "$prefix" --out "$build/a" >/dev/null 2>&1
test -s "$build/a/LangevinRigid/Licenses/LICENSE"
test ! -e "$build/a/LangevinRigid/Source/ThirdParty/LangevinRigidLibrary/lib/Linux/$(basename "${needed:-none}")"
