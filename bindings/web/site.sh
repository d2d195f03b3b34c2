#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Puts the page, the package and baked models into build/web/site, for any static file server.
#   bindings/web/site.sh PREFIX      after bindings/web/build.sh; PREFIX/bin/lr_bake bakes the models
set -euo pipefail
prefix=$(cd "${1:?usage: bindings/web/site.sh PREFIX}" && pwd)
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
site=$root/build/web/site
[ -e "$root/build/web/package/langevin_rigid.wasm" ] || { echo "no package yet: run bindings/web/build.sh" >&2; exit 1; }
rm -rf "$site" && mkdir -p "$site/models"
cp "$root"/bindings/web/page/* "$site"
cp -r "$root/build/web/package" "$site/package"
for model in leaf:350 leaf_maple:350 petal:700 confetti:800 samara:1716 curled_leaf:330; do # densities: assets/README.md
    "$prefix/bin/lr_bake" mesh "$root/assets/${model%:*}.obj" -o "$site/models/${model%:*}.lrb" --density "${model#*:}" --quiet
done
echo "site: $site (serve it by: python3 -m http.server --directory $site)"
