#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Compares a shared library's imports with a committed list: a new name is a new ability of the runtime in its host.
# docs/maintainers/testing.md
#   check_imports.sh LIBRARY LIST
#   check_imports.sh --list LIBRARY     the names, for a list
set -euo pipefail
imports() {
    case $(head -c 4 "$1" | od -An -c | tr -d ' ') in
    MZ*) x86_64-w64-mingw32-objdump -p "$1" | awk '/DLL Name:/ { dll = $3 } /^\t[0-9a-f]+\t/ { print dll ":" $NF }' ;;
    *) nm -D --undefined-only "$1" | awk '{ sub(/@.*/, "", $NF); print $NF }' ;;
    esac | LC_ALL=C sort -u
}
if [ "$1" = --list ]; then
    imports "$2"
    exit
fi
# Forbidden in any list: other files, the network, other programs, other code, the environment, the end of the host.
never='^(.*:)?(getenv|secure_getenv|setenv|putenv|environ|system|popen|fork|vfork|exec[vl][pe]*|posix_spawn.*|socket|connect|bind|listen|accept4?|send(to|msg)?|recv(from|msg)?|getaddrinfo|gethostby.*|dlopen|dlsym|open|openat|creat|unlink|remove|rename|mkdir|rmdir|opendir|readdir|mkstemp|tmpfile|chmod|chdir|signal|sigaction|setlocale|exit|_exit|quick_exit|printf|puts|gets|scanf|strcpy|strcat|rand|srand|time|WSA.*|WinExec|ShellExecute.*|CreateProcess.*|CreateFile.*|Reg[A-Z].*)$'
# Exceptions: msvcrt's start-up code and winpthreads, which MinGW links into every DLL, have some; and the runtime reads one file, the asset.
allowed=$(sed 's/ *#.*//; /^$/d' "${2:?which list}" | LC_ALL=C sort -u)
bad=$(LC_ALL=C comm -23 <(imports "$1") <(echo "$allowed"))
banned=$(imports "$1" | grep -E "$never" | grep -vFx -f <(sed -n 's/^\([^ ]*\) *# \(by the C runtime\|lr_asset_load_file\).*/\1/p' "$2") || true)
[ -z "$bad" ] || { echo "$1 imports what $2 does not have:"; echo "$bad" | sed 's/^/    /'; }
[ -z "$banned" ] || { echo "$1 imports what no list may have:"; echo "$banned" | sed 's/^/    /'; }
[ -z "$bad$banned" ] || exit 1
echo "imports: $(imports "$1" | wc -l), all in $(basename "$2")"
