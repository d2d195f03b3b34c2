#!/usr/bin/env bash
# Writes the API reference as HTML from the public headers into build/api/html. Doxygen's warnings are errors.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
mkdir -p build/api
version=$(awk '/define LR_VERSION_(MAJOR|MINOR|PATCH)/ { v = v (v == "" ? "" : ".") $3 } END { print v }' include/langevin_rigid.h)
(
    cat scripts/api_reference/Doxyfile
    echo "PROJECT_NUMBER = $version"
    echo "OUTPUT_DIRECTORY = build/api"
) | doxygen -
echo "API reference of version $version: build/api/html/index.html"
