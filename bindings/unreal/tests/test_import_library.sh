#!/usr/bin/env bash
# The .lib written by package.py: with MinGW's linker it gives a program that runs (if Wine is installed), with lld-link one that
# loads the DLL at the first call. test_import_library.sh THIRD_PARTY BUILD_DIR
# SPDX-License-Identifier: MIT
set -euo pipefail
third="$1" build="$2"
rm -rf "$build"
mkdir -p "$build"
lib="$third/lib/Win64/langevin_rigid.lib"
dll="$(ls "$third/lib/Win64/"*langevin_rigid*.dll)"
cat >"$build/main.c" <<'C'
#include <langevin_rigid.h>
int main(void) { return lr_version() >> 12 == LR_VERSION_MINOR ? 0 : 3; }
C
x86_64-w64-mingw32-gcc -I"$third/include" "$build/main.c" "$lib" -o "$build/main.exe"
x86_64-w64-mingw32-objdump -p "$build/main.exe" | grep "DLL Name: $(basename "$dll")" >/dev/null
# The library has exactly the DLL's functions.
x86_64-w64-mingw32-objdump -p "$dll" | grep -oE '\blr_[a-z0-9_]+$' | sort -u >"$build/exported.txt"
x86_64-w64-mingw32-nm "$lib" 2>/dev/null | grep -oE ' T lr_[a-z0-9_]+$' | awk '{print $2}' | sort -u >"$build/imported.txt"
test -s "$build/exported.txt"
diff "$build/exported.txt" "$build/imported.txt"
if command -v lld-link-14 >/dev/null; then
    cat >"$build/delayed.c" <<'C'
unsigned lr_version(void);
void* __delayLoadHelper2(void* descriptor, void** slot) { (void)descriptor, (void)slot; return 0; }
int mainCRTStartup(void) { return (int)lr_version(); }
C
    clang-14 --target=x86_64-pc-windows-msvc -c "$build/delayed.c" -o "$build/delayed.obj"
    lld-link-14 /nologo /subsystem:console /entry:mainCRTStartup /delayload:"$(basename "$dll")" "$build/delayed.obj" "$lib" \
        /out:"$build/delayed.exe"
    x86_64-w64-mingw32-objdump -p "$build/delayed.exe" >"$build/delayed.txt"
    ! grep -q "DLL Name: $(basename "$dll")" "$build/delayed.txt" || { echo "not delay-loaded"; exit 1; }
    grep -aq "$(basename "$dll")" "$build/delayed.exe"
    grep -E 'Entry d [0-9a-f]*[1-9a-f]' "$build/delayed.txt" >/dev/null || { echo "no delay import directory"; exit 1; }
fi
wine="$(command -v wine64 || ls /usr/lib/wine/wine64 2>/dev/null || true)"
if [[ -n $wine ]]; then
    cp "$dll" "$build/"
    (cd "$build" && mkdir -p ../wine && WINEPREFIX="$(cd .. && pwd)/wine" WINEDLLOVERRIDES="mscoree=;mshtml=" WINEDEBUG=-all timeout 100 "$wine" ./main.exe) || { echo "main.exe: $?"; exit 1; }
    echo "ran under Wine"
fi
