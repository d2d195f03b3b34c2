#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The sources of libccd from Debian's archive, which the WebAssembly build compiles along: its library there is for other processors.
#   fetch_libccd.sh DIRECTORY     nothing to do when DIRECTORY/libccd-2.1 is there
set -euo pipefail
to=$1
[ ! -e "$to/libccd-2.1/src/ccd.c" ] || exit 0
mkdir -p "$to"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/lists/partial"
# In lists of its own: the machine's are left alone, which mostly name no sources.
cat >"$work/libccd.sources" <<SOURCES
Types: deb-src
URIs: ${LR_DEBIAN_MIRROR:-http://deb.debian.org/debian}
Suites: bookworm
Components: main
Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg
SOURCES
apt=(-qq -o Dir::Etc::SourceParts=/dev/null -o "Dir::Etc::SourceList=$work/libccd.sources" -o "Dir::State::Lists=$work/lists"
    -o "Dir::Cache=$work" -o APT::Sandbox::User=root)
cd "$work"
apt-get "${apt[@]}" update
apt-get "${apt[@]}" source --download-only libccd # checks the archive's signatures
tar -xf libccd_2.1.orig.tar.gz -C "$to"
echo "sources of libccd: $to/libccd-2.1"
