#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Fetches Debian's sources of libraries, with Debian's patches, from the package mirrors of this machine; apt checks their signatures.
#   scripts/debian_source.sh DIRECTORY NAME...     unpacks as DIRECTORY/NAME; skips names that exist
# Writes the versions to DIRECTORY/versions. Does not change apt's own lists.
set -euo pipefail
folder=$1
shift
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
names=()
for name in "$@"; do [ -e "$folder/$name/debian/changelog" ] || names+=("$name"); done
[ ${#names[@]} -gt 0 ] || exit 0
for tool in apt-get dpkg-source; do
    command -v "$tool" >/dev/null || { echo "sources of ${names[*]}: $tool is not installed: apt-get install dpkg-dev" >&2; exit 1; }
done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/parts" "$work/lists/partial" "$work/cache/archives/partial" "$work/unpacked"
# The machine's own lists mostly lack sources; these copies have them.
for list in /etc/apt/sources.list /etc/apt/sources.list.d/*; do
    to=$work/parts/$(basename "$list")
    case $list in
    *.list) [ ! -e "$list" ] || sed -n 's/^deb[[:space:]]/deb-src /p' "$list" >"$to" ;;
    *.sources) sed 's/^Types:.*/Types: deb-src/' "$list" >"$to" ;;
    esac
done
options=(-qq -o Dir::Etc::sourcelist=/dev/null -o "Dir::Etc::sourceparts=$work/parts" -o "Dir::State::lists=$work/lists"
    -o "Dir::Cache=$work/cache" -o APT::Sandbox::User=root)
cd "$work/unpacked"
apt() { apt-get "${options[@]}" "$@" >>"$work/log" 2>&1; }
failed() {
    tail -n 20 "$work/log" >&2
    echo "no sources of ${names[*]}: they are fetched once over the network from this machine's Debian mirrors" >&2
    exit 1
}
apt update || true # lists of third parties can fail; Debian's suffice
# With security updates, like the installed packages; not every mirror has their sources.
apt source --only-source "${names[@]}" || {
    rm -rf ./*
    apt source --only-source --target-release "$(. /etc/os-release && echo "$VERSION_CODENAME")" "${names[@]}" || failed
}
for name in "${names[@]}"; do
    found=("$name"-*/)
    [ ${#found[@]} -eq 1 ] && [ -d "${found[0]}" ] || { echo "sources of $name: expected one folder, found: ${found[*]}" >&2; exit 1; }
    rm -rf "${folder:?}/$name"
    mv "${found[0]%/}" "$folder/$name"
done
for each in "$folder"/*/debian/changelog; do
    name=$(basename "$(dirname "$(dirname "$each")")")
    printf '%s %s\n' "$name" "$(dpkg-parsechangelog -l "$each" -S Version)"
done | sort >"$folder/versions"
cat "$folder/versions"
