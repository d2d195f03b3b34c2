#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Checks built files for the flags of cmake/hardening.cmake: shared libraries and programs, ELF or PE. docs/maintainers/testing.md
#   check_hardening.sh [--plain] FILE...     --plain: files without the flags of shipped ones, such as tests
set -euo pipefail
faults=0
plain=false
if [ "${1:-}" = --plain ]; then plain=true; shift; fi
fault() {
    echo "$file: $1"
    faults=$((faults + 1))
}

check_elf() {
    local headers segments dynamic machine objdump=objdump readelf=readelf
    headers=$(readelf -hW "$file")
    segments=$(readelf -lW "$file")
    dynamic=$(readelf -dW "$file")
    machine=$(sed -n 's/.*Machine: *//p' <<<"$headers")
    grep -q 'Type: *DYN' <<<"$headers" || fault "not position-independent"
    if grep -q INTERP <<<"$segments"; then
        grep -q 'FLAGS_1.*PIE' <<<"$dynamic" || fault "a program, but no PIE"
    fi
    grep -q GNU_RELRO <<<"$segments" || fault "no RELRO segment"
    grep -qE '\(FLAGS(_1)?\).*(BIND_NOW|NOW)' <<<"$dynamic" || fault "lazy binding: its table stays writable"
    grep -q 'GNU_STACK.* RW ' <<<"$segments" || fault "the stack is executable, or nothing says that it is not"
    ! grep -qE 'LOAD.* RWE ' <<<"$segments" || fault "a segment that can be written and executed"
    ! grep -q TEXTREL <<<"$dynamic" || fault "relocations in code"
    $plain && return
    local imports
    imports=$(nm -D --undefined-only "$file")
    grep -q '__stack_chk_fail' <<<"$imports" || fault "no stack protector"
    grep -qE ' __[a-z]+_chk(@|$)' <<<"$imports" || fault "no fortified function"
    case $machine in
    *X86-64*) entry=endbr64 ;;
    *AArch64*) entry='paciasp|bti|hint.*#0x(19|22)' objdump=aarch64-linux-gnu-objdump ;;
    *) return ;;
    esac
    command -v "$objdump" >/dev/null || { echo "SKIPPED: $file: entries of functions, for want of $objdump"; return; }
    # Each exported function, or a program's main, begins with a landing mark for indirect calls.
    local exported count
    exported=$(nm -D --defined-only "$file" | awk '$2 == "T" && $3 ~ /^lr_/ { sub(/@.*/, "", $3); print $3 }')
    [ -n "$exported" ] || return 0
    count=$("$objdump" -d --no-show-raw-insn "$file" --section=.text | awk -v entry="$entry" '
        /^[0-9a-f]+ <lr_[a-z0-9_]+(@@[A-Za-z_0-9]+)?>:$/ { name = $2; getline; print name, ($0 ~ entry ? "marked" : "not") }' | sort | uniq)
    [ "$(grep -c ' marked$' <<<"$count")" -ge "$(wc -l <<<"$exported")" ] ||
        fault "exported functions that do not begin with $entry: $(grep ' not$' <<<"$count" | head -n 3 | tr '\n' ' ')"
}

check_pe() {
    local said
    said=$(x86_64-w64-mingw32-objdump -p "$file")
    for what in DYNAMIC_BASE NX_COMPAT HIGH_ENTROPY_VA; do
        grep -q "$what" <<<"$said" || fault "without $what"
    done
}

[ $# -gt 0 ] || { echo "which files" >&2; exit 2; }
for file; do
    [ -f "$file" ] || { echo "$file: no such file"; exit 2; }
    case $(head -c 4 "$file" | od -An -c | tr -d ' ') in
    177ELF) check_elf ;;
    MZ*) check_pe ;;
    *) fault "neither ELF nor PE" ;;
    esac
done
[ "$faults" -eq 0 ] || exit 1
echo "hardening: $# files"
