#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Debian's sources of the libraries that a package carries, with Debian's patches, into build/packaging/sources. They are fetched
# once; later runs need no network. apt's own lists stay as they are.
#   packaging/fetch_sources.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

suite=bookworm
names=(highway libccd assimp draco libpng1.6 zlib)
folder=$PWD/build/packaging/sources
complete=$folder/complete

if [ -e "$complete" ] && [ "$(cat "$complete")" = "$suite ${names[*]}" ]; then
    echo "sources: ${names[*]} are in build/packaging/sources"
    exit 0
fi
for tool in apt-get dpkg-source; do
    command -v "$tool" >/dev/null || { echo "sources: no $tool here: scripts/setup.sh package, on Debian" >&2; exit 1; }
done
rm -rf "$folder"
mkdir -p "$folder/apt/lists/partial" "$folder/apt/cache/archives/partial"
cat >"$folder/apt/debian.sources" <<EOF
Types: deb-src
URIs: ${LR_DEBIAN_MIRROR:-http://deb.debian.org/debian}
Suites: $suite
Components: main
Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg
EOF
options=(-qq -o "Dir::Etc::sourcelist=$folder/apt/debian.sources" -o Dir::Etc::sourceparts=/dev/null
    -o "Dir::State::lists=$folder/apt/lists" -o "Dir::Cache=$folder/apt/cache" -o APT::Sandbox::User=root)
cd "$folder"
log=$folder/fetch.log
apt-get "${options[@]}" update >"$log" 2>&1 || { cat "$log" >&2; exit 1; }
apt-get "${options[@]}" source --only-source "${names[@]}" >>"$log" 2>&1 || { tail -n 20 "$log" >&2; exit 1; }
# What it is called without its version, so that nothing else has to know that.
for name in "${names[@]}"; do
    found=("$name"-*/)
    [ ${#found[@]} -eq 1 ] && [ -d "${found[0]}" ] || { echo "sources: $name did not come as one folder" >&2; exit 1; }
    mv "${found[0]%/}" "$name"
    printf '%s %s\n' "$name" "$(dpkg-parsechangelog -l "$name/debian/changelog" -S Version)"
done | sort >versions
rm -rf apt
cat versions
echo "$suite ${names[*]}" >"$complete"
