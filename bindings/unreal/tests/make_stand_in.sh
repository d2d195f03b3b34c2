#!/usr/bin/env bash
# Makes an install prefix with a library whose exported functions do nothing, for packaging tests without a real library:
# make_stand_in.sh Win64|LinuxArm64 PREFIX OUT
# SPDX-License-Identifier: MIT
set -euo pipefail
platform="$1" prefix="$2" out="$3"
minor="$(sed -n 's/^#define LR_VERSION_MINOR //p' "$prefix/include/langevin_rigid.h")"
mkdir -p "$out/bin" "$out/lib" "$out/include"
cp "$prefix/include/langevin_rigid.h" "$out/include/"
# The version is the header's; the tests never call the other functions.
grep -oE '\blr_[a-z0-9_]+\(' "$prefix/include/langevin_rigid.h" | tr -d '(' | sort -u >"$out/names.txt"
exported="$(grep -A1 -oE 'LR_API [a-z0-9_* ]*\blr_[a-z0-9_]+\(' "$prefix/include/langevin_rigid.h" | grep -oE 'lr_[a-z0-9_]+\(' | tr -d '(' | sort -u)"
{
    for name in $exported; do
        if [[ $platform == Win64 ]]; then export='__declspec(dllexport)'; else export=; fi
        if [[ $name == lr_version ]]; then echo "$export unsigned $name(void) { return ${minor}u << 12; }"; else echo "$export int $name(void) { return -18; }"; fi
    done
} >"$out/stand_in.c"
if [[ $platform == Win64 ]]; then
    x86_64-w64-mingw32-gcc -shared -s "$out/stand_in.c" -o "$out/bin/liblangevin_rigid.dll" -Wl,--out-implib,"$out/lib/liblangevin_rigid.dll.a"
else
    aarch64-linux-gnu-gcc -shared -fPIC -s "$out/stand_in.c" -o "$out/lib/liblangevin_rigid.so.0.2.0" -Wl,-soname,liblangevin_rigid.so.0
    ln -sf liblangevin_rigid.so.0.2.0 "$out/lib/liblangevin_rigid.so"
fi
