#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a wheel that contains the native library and lr_bake:  wheel.sh PREFIX DIR
# PREFIX: an installed package. The wheel is for this platform and any Python 3. Needs pip, setuptools and wheel, no network.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
prefix=$(cd "$1" && pwd) out=$2
python=${PYTHON:-python3}
mkdir -p "$out"
out=$(cd "$out" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$here/langevin_rigid" "$here/pyproject.toml" "$here/README.md" "$work"
find "$work" -name __pycache__ -prune -exec rm -rf {} +
mkdir -p "$work/langevin_rigid/lib" "$work/langevin_rigid/bin"
# The library under the name that the loader wants, and its dependencies that a machine can lack.
major=$("$python" -c "import re, sys; print(re.search(r'VERSION = \((\d+)', open(sys.argv[1]).read())[1])" "$work/langevin_rigid/_native.py")
carry=$here/../../packaging/bundle_libraries.py
/usr/bin/python3 "$carry" "$prefix/lib/liblangevin_rigid.so.$major" "$work/langevin_rigid/lib" "liblangevin_rigid.so.$major"
/usr/bin/python3 "$carry" "$prefix/bin/lr_bake" "$work/langevin_rigid/bin" lr_bake
cp "$prefix"/share/doc/langevin_rigid/LICENSE.* "$work/langevin_rigid/lib/" # licenses of code that is compiled into the library
cat >"$work/setup.py" <<'PY'
from setuptools import Distribution, setup
from wheel.bdist_wheel import bdist_wheel


class Native(Distribution):
    """Its files belong into platlib, which a wheel has at its root: to be unpacked where Python finds them."""

    def has_ext_modules(self):
        return True


class Carrying(bdist_wheel):
    """For any Python 3, but for one kind of machine."""

    def get_tag(self):
        return "py3", "none", super().get_tag()[2]


setup(cmdclass={"bdist_wheel": Carrying}, distclass=Native)
PY
"$python" -m pip wheel --quiet --no-index --no-build-isolation --no-deps --wheel-dir "$out" "$work"
ls "$out"/langevin_rigid-*.whl
