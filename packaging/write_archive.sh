#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Writes FOLDER/NAME as an archive, with SHA256SUMS in it or in FOLDER/SUMS. Its bytes depend only on names and contents.
#   packaging/write_archive.sh FOLDER NAME FILE.tar.xz|FILE.tgz|FILE.zip [SUMS]
set -euo pipefail
folder=${1:?} name=${2:?} file=${3:?}
export LC_ALL=C TZ=UTC
epoch=${SOURCE_DATE_EPOCH:?}
cd "$folder"
(
    cd "${4:-$name}"
    find . -type f ! -name SHA256SUMS -printf '%P\0' | sort -z | xargs -0 sha256sum >SHA256SUMS
    find . -type d -exec chmod 755 '{}' +
    find . -type f -exec chmod u=rwX,go=rX '{}' +
)
find "$name" -exec touch --no-dereference --date="@$epoch" '{}' +
rm -f "$file"
case $file in
*.zip) find "$name" ! -type d | sort | zip -q -X -9 "$file" -@ ;;
*)
    press=(xz -9 --threads=1)
    [[ $file != *.tgz ]] || press=(gzip -9 --no-name)
    tar --create --sort=name --format=gnu --owner=0 --group=0 --numeric-owner --mtime="@$epoch" "$name" | "${press[@]}" >"$file"
    ;;
esac
echo "$file: $(stat -c %s "$file") bytes"
