#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds and tests the C# binding against an installed package: bindings/csharp/test.sh PREFIX. Writes under build/csharp only.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
prefix=$(cd "${1:?usage: test.sh PREFIX}" && pwd)
build=$root/build/csharp
library=$(dirname "$(find "$prefix" -name liblangevin_rigid.so -print -quit)")
python=/usr/bin/python3
export PYTHONDONTWRITEBYTECODE=1
passed=0
failed=0
skipped=0

if ! command -v mcs > /dev/null || ! command -v mono > /dev/null; then
    echo "SKIPPED: C# binding, for want of mcs and mono: apt-get install mono-mcs mono-runtime libmono-corlib4.5-cil"
    echo "csharp: 0 passed, 0 failed, 1 skipped"
    exit 0
fi
mkdir -p "$build"
cd "$build"
rm -f ./*.dll ./*.exe

# step NAME COMMAND...: prints one line, and the output of a failed command
step() {
    local name=$1
    shift
    # In the background, because a condition would switch `set -e` off in all its commands.
    (set -e; "$@") > step.log 2>&1 &
    if wait $!; then
        passed=$((passed + 1))
        echo "ok      $name$(sed -n 's/^\(100,000 bodies: .*\|tests: .*\)$/; \1/p' step.log | tr -d '\n')"
    else
        failed=$((failed + 1))
        echo "FAILED  $name"
        sed 's/^/        /' step.log | tail -n 40
    fi
}

sources=("$here"/src/*.cs "$here"/src/Generated/*.cs)
compile=(mcs -unsafe -langversion:latest -warn:4 -warnaserror)

# The generator must stop at declarations without a rule, and not write something plausible.
strict() {
    refused '#define LR_NOVELTY_FIRST 1' 'LR_NOVELTY_FIRST: neither a limit nor in an enum'
    refused 'LR_API void lr_novelty(long double x);' 'no rule for the type'
}
refused() {
    sed "s|^#endif /\* LANGEVIN_RIGID_H \*/|$1\n&|" "$root/include/langevin_rigid.h" > novelty.h
    ! cmp -s novelty.h "$root/include/langevin_rigid.h"
    if "$python" "$root/bindings/generator/csharp.py" --header novelty.h --root "$build/novelty" > novelty.log 2>&1; then
        echo "taken: $1"
        return 1
    fi
    cat novelty.log
    grep -qF "$2" novelty.log
}
same_layout() {
    rm -rf layout && mkdir layout
    "$python" "$root/bindings/generator/csharp_layout.py" layout
    cc -std=c99 -Wall -Wextra -Werror -I"$prefix/include" layout/layout.c -o layout/layout
    layout/layout > layout/c.txt
    "${compile[@]}" -out:layout/Layout.exe layout/Layout.cs "${sources[@]}"
    mono layout/Layout.exe > layout/cs.txt
    [ "$(wc -l < layout/c.txt)" -gt 500 ]
    diff layout/c.txt layout/cs.txt
}
all_reached() {
    local missing=0 name
    for name in $(grep -ho 'extern [A-Za-z*]* lr_[a-z_]*' "$here"/src/Generated/Native.*.cs | grep -o 'lr_.*'); do
        grep -q "Native\.$name(" "${sources[@]}" || { echo "no class calls $name"; missing=1; }
    done
    return $missing
}
library_builds() {
    "${compile[@]}" -target:library -doc:LangevinRigid.xml -out:LangevinRigid.dll "${sources[@]}"
    "${compile[@]}" -d:NETSTANDARD2_1 -target:library -doc:spans.xml -out:LangevinRigid.Spans.dll "${sources[@]}"
}
run_tests() {
    "${compile[@]}" -debug ${1:+-d:$1} -out:Tests.exe "$here"/tests/*.cs "${sources[@]}"
    LANGEVIN_TEST_ASSET=$build/leaf.lrb LD_LIBRARY_PATH=$library timeout 100 mono --debug Tests.exe
}
# Wrong libraries, each in its own folder and process.
wrong_library() {
    local kind=$1 code=$2
    rm -rf "wrong/$kind" && mkdir -p "wrong/$kind"
    [ -z "$code" ] || echo "$code" | cc -shared -fPIC -x c - -o "wrong/$kind/liblangevin_rigid.so"
    [ "$kind" != damaged ] || echo "not a library" > "wrong/$kind/liblangevin_rigid.so"
    cp Tests.exe "wrong/$kind/"
    (cd "wrong/$kind" && LD_LIBRARY_PATH=. mono Tests.exe --load "$kind")
}
# Without code generation at run time, as for IL2CPP, iOS and WebGL. Compiles a local copy of Mono's corlib too.
ahead_of_time() {
    rm -rf aot && mkdir aot
    cp "$(dirname "$(readlink -f "$(command -v mono)")")/../lib/mono/4.5/mscorlib.dll" Tests.exe aot/
    cd aot
    export MONO_PATH=$PWD
    mono --aot=full mscorlib.dll > /dev/null
    mono --aot=full Tests.exe
    LANGEVIN_TEST_ASSET=$build/leaf.lrb LD_LIBRARY_PATH=$library timeout 100 mono --full-aot Tests.exe
}
leave() {
    LD_LIBRARY_PATH=$library timeout 20 mono --debug Tests.exe --leave
}
version() {
    local of_header
    of_header=$(sed -n 's/^#define LR_VERSION_M[AI][JN]OR \([0-9]*\)$/\1./p; s/^#define LR_VERSION_PATCH \([0-9]*\)$/\1/p' "$root/include/langevin_rigid.h" | tr -d '\n')
    grep -F "<Version>$of_header</Version>" "$here/LangevinRigid.csproj"
}
hello() {
    mcs -langversion:latest -warnaserror -r:LangevinRigid.dll -out:Hello.exe "$here/samples/Hello.cs"
    LD_LIBRARY_PATH=$library mono Hello.exe > hello.cs.txt
    cc -std=c99 "$root/samples/hello.c" -I"$prefix/include" -L"$library" -llangevin_rigid -o hello
    LD_LIBRARY_PATH=$library ./hello > hello.c.txt
    diff hello.c.txt hello.cs.txt
}

# The code of the guide, unchanged.
guide() {
    {
        echo 'using System; using LangevinRigid; static class Guide { static float lowest; static void Splash(Float3 p) { lowest = Math.Min(lowest, p.Y); }'
        echo 'static void Main() { var matrices = new float[16 * 10000];'
        sed -n '/^```csharp$/,/^```$/{/^```/!p}' "$root/docs/guide/languages.md"
        echo 'Console.WriteLine(matrices[13] + " " + view.Count); world.Dispose(); } }'
    } > Guide.cs
    mcs -langversion:latest -warnaserror -r:LangevinRigid.dll -out:Guide.exe Guide.cs
    LD_LIBRARY_PATH=$library mono Guide.exe | tee guide.txt
    grep -q '^4.99[0-9]* 10000$' guide.txt
}

if "$python" -c "import clang.cindex" 2> /dev/null; then
    step "generated sources are those of the header" "$python" "$root/bindings/generator/csharp.py" --check
    step "what no rule covers stops the generator" strict
    step "sizes, offsets and values are those of the C compiler" same_layout
else
    skipped=$((skipped + 3))
    echo "SKIPPED: generated sources and layouts, for want of libclang: apt-get install python3-clang-14"
fi
step "the project has the version of the header" version
step "every function is reached through the classes" all_reached
step "library and its documentation, without a warning" library_builds
step "asset for the tests" "$prefix/bin/lr_bake" mesh "$root/assets/leaf.obj" -o leaf.lrb --density 350 --quiet
step "tests with arrays (netstandard2.0)" run_tests ""
step "tests with spans (netstandard2.1)" run_tests NETSTANDARD2_1
step "tests compiled ahead of time, as for IL2CPP" ahead_of_time
step "no library" wrong_library missing ""
step "a damaged library" wrong_library damaged ""
step "another library of that name" wrong_library other "int lr_other(void) { return 1; }"
step "a newer library" wrong_library newer "unsigned lr_version(void) { return 99u << 12; }"
step "an older library" wrong_library older "unsigned lr_version(void) { return 0u << 12; }"
step "a program that ends without Dispose" leave
step "sample Hello: same bits as in C" hello
step "the lines of docs/guide/languages.md" guide

echo "csharp: $passed passed, $failed failed$([ $skipped -eq 0 ] || echo ", $skipped skipped")"
[ $failed -eq 0 ]
