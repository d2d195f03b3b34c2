#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the WebAssembly package and runs its tests, against an installed package of the native library.
#   bindings/web/test.sh PREFIX
set -uo pipefail
prefix=$(cd "${1:?usage: bindings/web/test.sh PREFIX}" && pwd)
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
web=$root/bindings/web work=$root/build/web/test package=$root/build/web/package wasm=$root/build/web/wasm
passed=0 failed=0 skipped=0
rm -rf "$work" && mkdir -p "$work"

step() { # name, command
    local name=$1 start=$SECONDS
    shift
    if "$@" >"$work/step.log" 2>&1; then
        passed=$((passed + 1)) && echo "passed: $name ($((SECONDS - start)) s)"
    else
        failed=$((failed + 1)) && echo "FAILED: $name" && tail -n 40 "$work/step.log" | sed 's/^/    /'
        return 1
    fi
}
skip() { # what, missing tool, how to install it
    skipped=$((skipped + 1))
    echo "SKIPPED: $1, for want of $2: $3"
}
finish() {
    echo "web: $passed passed, $failed failed$([ $skipped -eq 0 ] || echo ", $skipped skipped")"
    [ $failed -eq 0 ]
    exit
}

if [ -x /usr/bin/python3 ] && /usr/bin/python3 -c 'import clang.cindex' 2>/dev/null; then
    step "generated files are what the header says" /usr/bin/python3 "$root/bindings/generator/javascript.py" --check
else
    skip "the check of generated files" python3-clang-14 "scripts/setup.sh test"
fi
for need in clang++-14:clang-14 wasm-ld-14:lld-14 node:nodejs cmake:cmake ninja:ninja-build; do
    command -v "${need%%:*}" >/dev/null || { skip "everything else" "${need#*:}" "scripts/setup.sh test" && finish; }
done
for need in /usr/include/wasm32-wasi/stdlib.h:wasi-libc /usr/lib/llvm-14/lib/wasm32-wasi/libc++.a:libc++-14-dev-wasm32; do
    [ -e "${need%%:*}" ] || { skip "everything else" "${need#*:}" "scripts/setup.sh test" && finish; }
done
step "package" "$web/build.sh" --tests || finish
sed 's/^/    /' "$work/step.log"

# All scenes, with the hashes of all processors.
determinism() {
    node "$root/cmake/cross/run_wasi.mjs" "$wasm/tests/tests_determinism.wasm" \
        --test-case="held hashes,every instruction set is named,*sees*,*order of bodies*" >"$work/determinism.log" 2>&1
    local status=$?
    cat "$work/determinism.log"
    # Only these may have been skipped.
    [ $status -eq 0 ] && grep -q 'instruction sets: WebAssembly' "$work/determinism.log" && grep -Eq '[4-9] passed' "$work/determinism.log"
}
step "held hashes" determinism
step "held snapshot, from and to other processors" \
    "$root/tests/snapshot_travel/check.sh" "$wasm/tests/snapshot_file.wasm" node "$root/cmake/cross/run_wasi.mjs"

native() {
    "$prefix/bin/lr_bake" mesh "$root/assets/leaf.obj" -o "$work/leaf.lrb" --density 350 --quiet &&
        cc -std=c99 -O2 -Wall -Wextra -Werror "$web/tests/storm.c" -I"$prefix/include" -L"$prefix/lib" -llangevin_rigid \
            -Wl,-rpath,"$prefix/lib" -o "$work/storm" &&
        "$work/storm" "$work/leaf.lrb" 2000 60 "$work/storm.snapshot" >"$work/native.txt" && cat "$work/native.txt"
}
step "native storm to compare with" native || finish
export LR_PACKAGE=$package LR_LEAF=$work/leaf.lrb LR_NATIVE=$work/native.txt LR_SNAPSHOT=$work/storm.snapshot
step "wrapper" node --expose-gc --test "$web/tests/wrapper.test.mjs"
step "sample" node "$package/examples/fall.mjs" "$work/leaf.lrb"

if tsc=$(command -v tsc); then
    mkdir -p "$work/types" && cp "$web/tests/types.mts" "$work/types" && ln -sfn "$package" "$work/types/langevin-rigid"
    types() { (cd "$work/types" && "$tsc" --noEmit --strict --module nodenext --moduleResolution nodenext --target es2022 --lib es2022,dom types.mts); }
    step "types" types
else
    skip "the check of types" TypeScript "apt-get install node-typescript, or npm install --global typescript"
fi
if chromium=$(command -v chromium || command -v google-chrome); then
    step "site" "$web/site.sh" "$prefix"
    step "page in a browser" node "$web/tests/page.mjs" "$chromium" "$root/build/web/site" "$work"
else
    skip "the page" Chromium "scripts/setup.sh test browser"
fi
finish
