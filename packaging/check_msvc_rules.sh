#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Reads the source kit by clang with Microsoft's rules and layout (target, -fms-compatibility, 32-bit long, no __GNUC__), as far as that says
# something of Microsoft's compiler: of its standard library there is none here. A prelude reads MinGW's C headers and libc++ as MinGW has them; from
# there on only Microsoft's macros are seen. Text that clang accepts and Microsoft's compiler does not is looked for by name.
#   packaging/check_msvc_rules.sh [KIT]     default: the folder that packaging/make_source_kit.sh has made; about 90 s
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
kit=${1:-$(echo "$PWD"/build/packaging/source/stage/*)}
libcxx=/usr/lib/llvm-14/include/wasm32-wasi/c++/v1
mingw=/usr/x86_64-w64-mingw32/include
for needed in "$libcxx" "$mingw"; do [ -d "$needed" ] || { echo "no $needed: scripts/setup.sh test windows" >&2; exit 3; }; done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
{
    printf '#include <time.h>\n#include <stdlib.h>\nextern "C" int timespec_get(timespec*, int);\nextern "C" void* aligned_alloc(size_t, size_t);\n'
    grep -rhoE '^ *# *include +<[a-z_.0-9]+>' "$kit"/{src,include,third_party/hwy} | tr -d ' ' | sed 's/#include/#include /' | sort -u |
        grep -vE '<(.*intrin|arm_|riscv|wasm|windows|unistd|thread|mutex|condition_variable|fcntl|cpuid)' |
        sed 's/#include \(.*\)/#if __has_include(\1)\n&\n#endif/'
    printf '#include <immintrin.h>\n#include <limits>\n#include <string_view>\n#undef __GNUC__\n#undef __GNUC_MINOR__\n#undef __MINGW32__\n#undef __MINGW64__\n#define _MSC_VER 1936\n'
} >"$work/prelude.h"
cd "$kit"
flags=(--target=x86_64-pc-windows-msvc -fms-compatibility -fms-extensions -fdelayed-template-parsing -fsyntax-only -nostdlibinc
    -isystem "$libcxx" -isystem "$mingw" -U_MSC_VER -U_MSC_FULL_VER -D__MINGW32__ -D__MINGW64__ -D__GNUC__=4 -D__GNUC_MINOR__=2
    -D_LIBCPP_NO_VCRUNTIME -D_UCRT -Wno-everything -Werror=gnu -Werror=vla -Werror=c99-designator
    -Werror=zero-length-array -Wno-gnu-include-next
    -Iinclude -isystem third_party -DLR_STATIC -DLR_NO_OS -DHWY_WANT_SSSE3=1 -DHWY_WANT_SSE4=1)
failed=0 count=0
while read -r file; do
    count=$((count + 1))
    clang++-14 -std=c++20 "${flags[@]}" -include "$work/prelude.h" -Isrc "$file" >"$work/log" 2>&1 || {
        failed=$((failed + 1))
        echo "$file:"
        grep -E 'error' "$work/log" | head -n 5
    }
done < <(find src third_party -name '*.cpp' -o -name '*.cc')
# As its users include it, DLL and static.
for define in -DLR_STATIC -ULR_STATIC; do
    echo '#include <langevin_rigid.hpp>' >"$work/user.cpp"
    clang++-14 -std=c++17 "${flags[@]}" $define -include "$work/prelude.h" "$work/user.cpp" || failed=$((failed + 1))
done
# Words of GCC and clang, outside of the branches that Microsoft's compiler does not read.
gnu=$(for file in $(find src include -name '*.cpp' -o -name '*.h' -o -name '*.hpp' -o -name '*.inc'); do
    # Branches are chosen by a preprocessor that knows Microsoft's macros alone, and enters no header.
    sed 's/^ *# *include.*//' "$file" | clang++-14 -E -P -undef -D_MSC_VER=1936 -D_WIN32 -D_WIN64 -D_M_X64 -DHWY_COMPILER_MSVC=1936 -DLR_STATIC -x c++ -w - 2>/dev/null |
        grep -nE '__builtin_[a-z]|__attribute__|__extension__|__asm__|__int128' | sed "s|^|$file: |" || true
done)
gnu=$(grep -vE '__builtin_(prefetch|bit_cast)' <<<"$gnu" || true) # base/threads.h defines the one, that compiler has the other (19.27)
if [ -n "$gnu" ]; then echo "$gnu"; failed=$((failed + 1)); fi
echo "Microsoft's rules: $count files read, $failed complaints"
[ "$failed" -eq 0 ]
