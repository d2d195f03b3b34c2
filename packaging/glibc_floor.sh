#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Prints the oldest glibc that these files run on: the highest version of their dynamic symbols.
#   packaging/glibc_floor.sh FILE...
set -euo pipefail
for file; do readelf --dyn-syms --wide "$file"; done |
    sed -n 's/.*UND .*@GLIBC_\([0-9.]*\).*/\1/p' | sort -uV | tail -n 1
