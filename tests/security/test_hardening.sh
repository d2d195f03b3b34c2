#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# check_hardening.sh and check_imports.sh refuse libraries and programs that lack a single flag.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
cat >library.c <<'C'
#include <stdio.h>
#include <stdlib.h>
int lr_length(const char* text, int n);
int lr_length(const char* text, int n) {
    char copy[64];
    int length = snprintf(copy, sizeof copy, "%*s", n, text);
    return length + copy[n & 63] CALL;
}
C
echo 'int main(void) { return 0; }' >program.c
flags=(-O2 -fPIC -shared '-DCALL=' -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2 -fstack-protector-strong -Wl,-z,relro,-z,now,-z,noexecstack)
case $(uname -m) in
x86_64) flags+=(-fcf-protection=full) unmarked=-fcf-protection=none ;;
aarch64) flags+=(-mbranch-protection=standard) unmarked=-mbranch-protection=none ;;
esac
good=true
expect() { # accepted or refused, expected message, flags
    "${CC:-cc}" "${flags[@]}" "${@:3}" library.c -o library.so
    local said result=accepted
    said=$("$here/check_hardening.sh" library.so 2>&1) || result=refused
    [[ $result = "$1" && $said = *"$2"* ]] || { echo "FAILED: ${*:3}: $result: $said"; good=false; }
}
expect accepted "hardening: 1"
expect refused "no RELRO" -Wl,-z,norelro
expect refused "lazy binding" -Wl,-z,lazy
expect refused "stack is executable" -Wl,-z,execstack
expect refused "no stack protector" -fno-stack-protector
expect refused "no fortified" -D_FORTIFY_SOURCE=0 -Wno-builtin-macro-redefined -w
expect refused "do not begin with" "$unmarked"
expect_program() {
    "${CC:-cc}" "${@:3}" -Wl,-z,relro,-z,now,-z,noexecstack program.c -o program
    local said result=accepted
    said=$("$here/check_hardening.sh" --plain program 2>&1) || result=refused
    [[ $result = "$1" && $said = *"$2"* ]] || { echo "FAILED: a program with ${*:3}: $result: $said"; good=false; }
}
expect_program accepted "hardening: 1" -fPIE -pie
expect_program refused "not position-independent" -fno-pie -no-pie

echo "__snprintf_chk __stack_chk_fail __stack_chk_guard __cxa_finalize __gmon_start__ _ITM_deregisterTMCloneTable _ITM_registerTMCloneTable" | tr ' ' '\n' >list.txt
"${CC:-cc}" "${flags[@]}" library.c -o library.so
"$here/check_imports.sh" library.so list.txt >/dev/null || { echo "FAILED: imports of the list are refused"; good=false; }
"${CC:-cc}" "${flags[@]}" -UCALL '-DCALL=+(getenv("HOME") != 0)' library.c -o library.so
! "$here/check_imports.sh" library.so list.txt >/dev/null || { echo "FAILED: getenv passes"; good=false; }
echo getenv >>list.txt
! "$here/check_imports.sh" library.so list.txt >/dev/null || { echo "FAILED: getenv passes where the list has it"; good=false; }
$good && echo "hardening: what lacks one thing is refused"
