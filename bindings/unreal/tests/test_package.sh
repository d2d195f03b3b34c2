#!/usr/bin/env bash
# package.py must refuse unusable input, with a reason: test_package.sh PACKAGE_PY PREFIX BUILD_DIR
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
refuse '--engine is a version' --native "$prefix" --engine 5.4 --out "$build/a"
refuse 'two of --native are for the same platform' --native "$prefix" --native "$prefix" --out "$build/a"
refuse 'is not this plugin' --native "$prefix" --out "$build/other"
cp -L "$prefix/lib/liblangevin_rigid.so" "$build/changed/lib/"
sed 's/LR_VERSION_MINOR 2/LR_VERSION_MINOR 3/' "$prefix/include/langevin_rigid.h" >"$build/changed/include/langevin_rigid.h"
refuse 'all must be of one version' --native "$prefix" --native "$build/changed" --out "$build/a"
rm "$build/changed/include/langevin_rigid.h"
refuse 'is missing' --native "$build/changed" --out "$build/a"
# All dependencies are packaged and found there; packaging twice into the same folder works.
for _ in 1 2; do python3 "$package" --native "$prefix" --out "$build/a" >"$build/log.txt" 2>&1; done
test -s "$build/a/LangevinRigid/Licenses/LICENSE"
native="$build/a/LangevinRigid/Source/ThirdParty/LangevinRigidLibrary/lib/Linux"
for library in "$native"/*.so*; do
    if ldd "$library" | grep -vE 'linux-vdso|ld-linux|lib(c|m|gcc_s|stdc\+\+|pthread|dl|rt)\.so' | grep '=>' | grep -vF " => $native/"; then
        echo "$library needs more than the system's and what is beside it"
        exit 1
    fi
done
# Without a missing dependency there is no package. With --also it is included.
mkdir -p "$build/lacking/lib" "$build/lacking/include" "$build/given"
cp -L "$prefix/lib/liblangevin_rigid.so" "$build/lacking/lib/"
cp "$prefix/include/langevin_rigid.h" "$build/lacking/include/"
echo 'int lr_test_nowhere;' | gcc -shared -fPIC -x c - -Wl,-soname,libnowhere.so.1 -o "$build/given/libnowhere.so.1"
patchelf --add-needed libnowhere.so.1 "$build/lacking/lib/liblangevin_rigid.so"
refuse 'needs libnowhere.so.1.*LR_SELF_CONTAINED' --native "$build/lacking" --out "$build/b"
if python3 "$package" --native "$build/lacking" --also "$build/given/libnowhere.so.1" --out "$build/b" >"$build/log.txt" 2>&1; then
    echo "a library without a known licence was taken"
    exit 1
fi
mkdir -p "$build/lacking/share/doc/nowhere"
echo 'Nowhere is free.' >"$build/lacking/share/doc/nowhere/copyright"
python3 "$package" --native "$build/lacking" --also "$build/given/libnowhere.so.1" --out "$build/b" >"$build/log.txt" 2>&1
test -f "$build/b/LangevinRigid/Source/ThirdParty/LangevinRigidLibrary/lib/Linux/libnowhere.so.1"
