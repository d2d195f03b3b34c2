#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Debian's sources of the libraries that a package carries, into build/sources. Fetched once; later runs need no network.
#   packaging/fetch_sources.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/debian_source.sh build/sources highway libccd assimp draco libpng1.6 zlib
