#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Fetches Debian's sources of the bundled libraries into build/sources, once; later runs need no network.
#   packaging/fetch_sources.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/debian_source.sh build/sources highway assimp draco libpng1.6 zlib
