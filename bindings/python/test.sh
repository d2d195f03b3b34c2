#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds and runs all tests of the Python package against an installed package:  test.sh PREFIX
# PYTHON: the interpreter, by default the first of python3 and /usr/bin/python3 that has NumPy. BLENDER: by default blender.
set -uo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
prefix=$(cd "${1:?usage: test.sh PREFIX}" && pwd)
work=$root/build/python
rm -rf "$work"
mkdir -p "$work"
passed=0 failed=0 skipped=0
unset PYTHONPATH LANGEVIN_RIGID_BAKE
export PYTHONDONTWRITEBYTECODE=1 PYTHONFAULTHANDLER=1

finish() {
    summary="$passed passed, $failed failed"
    [ $skipped -eq 0 ] || summary="$summary, $skipped skipped"
    echo "python: $summary"
    [ $failed -eq 0 ]
    exit
}
skip() { # what, missing tool, how to install it
    echo "SKIPPED: $1, for want of $2: $3"
    skipped=$((skipped + 1))
}
run() { # what, command...
    local what=$1
    shift
    if "$@" >"$work/log" 2>&1; then
        passed=$((passed + 1))
        echo "ok: $what"
    else
        failed=$((failed + 1))
        echo "FAILED: $what"
        tail -n 60 "$work/log"
    fi
}
has() { "$python" -c "import $1" 2>/dev/null; }

python=${PYTHON:-}
for candidate in python3 /usr/bin/python3; do
    [ -n "$python" ] || ! command -v $candidate >/dev/null || ! $candidate -c 'import numpy' 2>/dev/null || python=$candidate
done
if [ -z "$python" ]; then
    skip "all of Python" "NumPy" "apt-get install python3-numpy"
    finish
fi
export PYTHON=$python LANGEVIN_RIGID_LIBRARY=$prefix/lib LR_TEST_PREFIX=$prefix

generator=/usr/bin/python3
if $generator -c 'import clang.cindex' 2>/dev/null; then
    run "generated files are what the header gives" $generator "$root/bindings/generator/python.py" --check
else
    skip "drift of the generated files" "libclang's Python" "apt-get install python3-clang-14"
fi

# The hash that samples/hello.c prints, from C.
if cc -std=c99 -I"$prefix/include" "$root/samples/hello.c" -o "$work/hello" -L"$prefix/lib" -llangevin_rigid -Wl,-rpath,"$prefix/lib"; then
    LR_TEST_HELLO_HASH=$("$work/hello" | sed -n 's/^state \([0-9a-f]*\).*/\1/p')
    export LR_TEST_HELLO_HASH
fi
tests() { # what, environment and command of an interpreter
    local what=$1
    shift
    if (cd "$here/tests" && LR_TEST_WORK=$work/tests "$@" -W error -m unittest discover) >"$work/unittest.log" 2>&1; then
        grep -E '^  100,000' "$work/unittest.log"
    else
        tail -n 60 "$work/unittest.log"
    fi
    local count bad left
    count=$(sed -n 's/^Ran \([0-9]*\) tests.*/\1/p' "$work/unittest.log" | tail -1)
    bad=$(sed -n 's/^FAILED.*(\(.*\))$/\1/p' "$work/unittest.log" | grep -oE '(failures|errors)=[0-9]+' | cut -d= -f2 | awk '{n += $1} END {print n + 0}')
    left=$(grep -oE 'skipped=[0-9]+' "$work/unittest.log" | tail -1 | cut -d= -f2)
    count=${count:-0} bad=${bad:-0} left=${left:-0}
    if [ "$count" -eq 0 ] || ! grep -qE '^(OK|FAILED)' "$work/unittest.log"; then bad=1 count=1; fi
    passed=$((passed + count - bad - left)) failed=$((failed + bad)) skipped=$((skipped + left))
    [ "$left" -eq 0 ] || echo "SKIPPED: $left tests of $what, for want of a C compiler: apt-get install gcc binutils"
    echo "$what: $count tests, $bad failed"
}
tests "unit tests" "$python"

# As users install it, in folders of the test.
if has pip && has setuptools && has wheel; then
    mkdir -p "$work/source" && cp -r "$here/langevin_rigid" "$here/pyproject.toml" "$here/README.md" "$work/source"
    run "pip install, offline" "$python" -m pip install --quiet --no-index --no-build-isolation --no-deps --target "$work/site" "$work/source"
    run "hello.py, installed" env PYTHONPATH="$work/site" bash -c "cd / && $python $here/samples/hello.py | grep -q 'state $LR_TEST_HELLO_HASH'"
    run "wheel with the library and the baker inside" "$here/wheel.sh" "$prefix" "$work/wheels"
    # As for Blender: unpacked like an archive.
    run "the wheel, unpacked" unzip -q "$work"/wheels/langevin_rigid-*-py3-none-manylinux_2_*_"$(uname -m)".whl -d "$work/carried"
    run "its tag is of the oldest glibc that it runs on, and pip takes it here" bash -c "
        floor=\$(find '$work/carried/langevin_rigid' -name '*.so*' -o -name lr_bake | xargs '$root/packaging/glibc_floor.sh') &&
        tag=\$(ls '$work'/wheels/*.whl | sed 's/.*manylinux_\([0-9]*\)_\([0-9]*\)_.*/\1.\2/') &&
        [ \"\$(printf '%s\n' \$tag \$floor | sort -V | tail -n 1)\" = \"\$tag\" ] &&
        '$python' -m pip install --quiet --no-index --no-deps --target '$work/by_tag' '$work'/wheels/*.whl"
    run "the wheel finds what it carries" bash -c "cd '$work/carried/langevin_rigid' && ! ldd lib/*.so* bin/lr_bake |
        grep -E 'lib(hwy|assimp).* => ' | grep -vF ' => $work/carried/'"
    run "hello.py and a bake with nothing but the wheel" env -u LANGEVIN_RIGID_LIBRARY PYTHONPATH="$work/carried" bash -c "cd / &&
        $python $here/samples/hello.py | grep -q 'state $LR_TEST_HELLO_HASH' &&
        $python -c 'import langevin_rigid as lr; assert \"carried\" in lr.library_path() and \"carried\" in lr.baker_path()
lr.bake(\"$root/assets/petal.obj\", \"$work/petal.lrb\", density=700)'"
    run "Blender's zip" "$python" "$here/extension.py" "$prefix" "$work/extension"
    run "Blender's zip and the wheel again, with the same bytes" bash -c "'$python' '$here/extension.py' '$prefix' '$work/again' &&
        cmp '$work'/extension/*.zip '$work'/again/*.zip && unzip -p '$work'/again/*.zip 'leaf_storm/wheels/*' | cmp - '$work'/wheels/*.whl"
    if has tomllib; then
        run "its manifest, by the rules of Blender 4.2" "$python" "$here/tests/extension_check.py" "$work"/extension/*.zip
    else
        skip "the manifest of Blender's zip" "tomllib" "Python 3.11"
    fi
    mkdir -p "$work/partial/bin" && cp -r "$prefix/lib" "$prefix/share" "$work/partial"
    run "no zip without the baker" bash -c "! '$python' '$here/extension.py' '$work/partial' '$work/none' && ! ls '$work'/none/*.zip"
else
    skip "installation by pip" "pip, setuptools and wheel" "apt-get install python3-pip python3-setuptools python3-wheel"
fi
export PYTHONPATH=$here
run "sample storm_to_usd.py" bash -c "$python $here/samples/storm_to_usd.py $root/assets/leaf.obj $work/storm.usda --count 100 --frames 24 &&
    PYTHONPATH=$here/tests $python -c 'import usda_reader; assert len(usda_reader.read(\"$work/storm.usda\").at(\"/Storm/Bodies\").attributes[\"positions\"][\"value\"]) == 24'"
if has matplotlib; then
    run "sample plot_fall.py" "$python" "$here/samples/plot_fall.py" "$work/fall.png"
else
    skip "sample plot_fall.py" "matplotlib" "apt-get install python3-matplotlib"
fi
if has mypy; then
    run "types, by mypy" "$python" -m mypy --config-file "$here/mypy.ini" --cache-dir "$work/mypy" "$here/langevin_rigid"
    run "types of a user's program, by mypy --strict" bash -c "cd '$work' && '$python' -m mypy --strict --cache-dir mypy \
        '$here'/tests/user_types.py '$here'/samples/{hello,storm_to_usd}.py"
else
    skip "types" "mypy" "apt-get install mypy"
fi
if command -v pyright >/dev/null; then
    run "types of a user's program, by pyright" pyright --pythonpath "$(command -v "$python")" "$here"/tests/user_types.py \
        "$here"/samples/{hello,storm_to_usd}.py
else
    skip "types of a user's program, by pyright" "pyright" "npm install -g pyright"
fi

blender=${BLENDER:-blender}
if ! command -v "$blender" >/dev/null; then
    skip "the add-on in a real Blender (it ran against a shim of bpy alone, which draws nothing)" "Blender" "scripts/setup.sh test blender"
elif ! "$blender" -b --factory-startup --python-exit-code 1 --python-expr 'import numpy' >"$work/log" 2>&1; then
    skip "the add-on in Blender" "NumPy in Blender's Python" "apt-get install python3-numpy, or a Blender that has it"
else
    mkdir -p "$work/blender" "$work/scripts/addons"
    run "the add-on in Blender, tests against what it evaluates" timeout 200 "$blender" -b --factory-startup \
        --python-exit-code 1 -P "$here/tests/blender_check.py" -- "$work/blender"
    grep '^SKIPPED' "$work/log"
    skipped=$((skipped + $(grep -c '^SKIPPED' "$work/log")))
    display=()
    ! command -v xvfb-run >/dev/null || display=(xvfb-run -a) # for Workbench, which is quicker than Cycles
    installed() { "${display[@]}" env -u LANGEVIN_RIGID_LIBRARY -u PYTHONPATH BLENDER_USER_SCRIPTS="$work/scripts" timeout 200 "$blender" -b \
        --factory-startup --python-exit-code 1 "$@"; }
    if ls "$work"/extension/*.zip >/dev/null 2>&1; then
        run "the zip, installed in Blender: leaves on a plane and a box, in a wind field" installed -P "$here/tests/blender_scene.py" -- \
            "$work"/extension/*.zip "$work/blender" "$work/blender/scene.png"
        run "the saved scene baked again by the command" installed "$work/blender/scene.blend" \
            -P "$work/scripts/addons/leaf_storm/__main__.py" -- --panel --frames 30 --export "$work/blender/scene.usda"
        rm -rf "$work"/scripts/addons/leaf_storm/wheels
        without() { set +o pipefail; installed --python-expr "import bpy, sys; bpy.ops.preferences.addon_enable(module='leaf_storm')" 2>&1 |
            grep "Leaf Storm needs langevin_rigid in Blender's Python: install the add-on's zip" >/dev/null; }
        run "the add-on without its wheel says what to do" without
    fi
    run "the add-on as a command" bash -c "timeout 60 '$blender' -b --factory-startup --python-exit-code 1 -P \
        '$here/blender/leaf_storm/__main__.py' -- --mesh '$root/assets/leaf.obj' --count 50 --frames 24 --cache '$work/blender/a.pc2' \
        --save '$work/blender/a.blend' && test -s '$work/blender/a.blend'"
fi
finish
