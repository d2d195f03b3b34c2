#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a wheel that contains the native library and lr_bake:  wheel.sh PREFIX DIR
# PREFIX: an installed package, for Linux or (cross-built) for Windows. The wheel is for any Python 3 there, and has the same bytes each
# time. Needs pip, setuptools and wheel, no network.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
prefix=$(cd "$1" && pwd) out=$2
python=${PYTHON:-python3}
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-315532800} # 1980, where zip archives begin
umask 022
mkdir -p "$out"
out=$(cd "$out" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$here/langevin_rigid" "$here/pyproject.toml" "$here/README.md" "$work"
find "$work" -name __pycache__ -prune -exec rm -rf {} +
lib=$work/langevin_rigid/lib bin=$work/langevin_rigid/bin
mkdir -p "$lib" "$bin"
if [ -f "$prefix/bin/langevin_rigid.dll" ]; then # needs no other libraries
    cp "$prefix/bin/langevin_rigid.dll" "$lib"
    cp "$prefix/bin/lr_bake.exe" "$bin"
    tag=win_amd64
else
    # The library under the name that the loader wants, and its dependencies that a machine can lack.
    major=$("$python" -c "import re, sys; print(re.search(r'VERSION = \((\d+)', open(sys.argv[1]).read())[1])" "$work/langevin_rigid/_native.py")
    carry=$here/../../packaging/bundle_libraries.py
    /usr/bin/python3 "$carry" "$prefix/lib/liblangevin_rigid.so.$major" "$lib" "liblangevin_rigid.so.$major"
    /usr/bin/python3 "$carry" "$prefix/bin/lr_bake" "$bin" lr_bake
    # The tag that indexes and pip go by: the oldest glibc on which all files run, and a system with its C++ runtime.
    mapfile -t files < <(find "$lib" "$bin" -type f \( -name '*.so*' -o -name lr_bake \))
    floor=$("$here/../../packaging/glibc_floor.sh" "${files[@]}")
    floor=${floor#2.}
    runtime=$(for file in "${files[@]}"; do readelf --dyn-syms --wide "$file"; done | sed -n 's/.*UND .*@GLIBCXX_3\.4\.\([0-9]*\).*/\1/p' |
        sort -nu | tail -n 1)
    for known in 24:28 28:31 29:34 30:35 32:38 33:39; do # GLIBCXX_3.4.N of glibc 2.M's systems: auditwheel's policies
        if [ "${runtime:-0}" -le "${known%:*}" ]; then
            [ "$floor" -ge "${known#*:}" ] || [ "${runtime:-0}" -eq 0 ] || floor=${known#*:}
            known=
            break
        fi
    done
    [ -z "$known" ] || { echo "wheel.sh: no system is known to have GLIBCXX_3.4.$runtime" >&2; exit 1; }
    case $(readelf -h "$prefix/lib/liblangevin_rigid.so.$major" | sed -n 's/ *Machine: *//p') in
    *X86-64*) machine=x86_64 ;;
    AArch64) machine=aarch64 ;;
    *) echo "wheel.sh: the library's machine has no tag" >&2; exit 1 ;;
    esac
    tag=manylinux_2_${floor}_$machine
fi
# Licences, also of code that is compiled into the library or beside it.
cp "$here/../../LICENSE" "$work"
if [ -f "$prefix/THIRD_PARTY.md" ]; then
    cp -r "$prefix/THIRD_PARTY.md" "$prefix/licences" "$lib"
else
    mkdir "$lib/licences"
    cp /usr/share/doc/libhwy1/copyright "$lib/licences/highway.txt"
fi
find "$work" -type d -exec chmod 755 {} + -o -name 'lr_bake*' -exec chmod 755 {} + -o -exec chmod 644 {} +
cat >"$work/setup.py" <<PY
from setuptools import Distribution, setup
from wheel.bdist_wheel import bdist_wheel


class Native(Distribution):
    """Its files belong into platlib, which a wheel has at its root: to be unpacked where Python finds them."""

    def has_ext_modules(self):
        return True


class Carrying(bdist_wheel):
    """For any Python 3, but for one kind of machine."""

    def get_tag(self):
        return "py3", "none", "$tag"


setup(cmdclass={"bdist_wheel": Carrying}, distclass=Native)
PY
"$python" -m pip wheel --quiet --no-index --no-build-isolation --no-deps --wheel-dir "$out" "$work"
ls "$out"/langevin_rigid-*-"$tag".whl
