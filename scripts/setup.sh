#!/usr/bin/env bash
# Installs what the project needs on Debian 12, and nothing when it is all there. Later steps need no network.
#   scripts/setup.sh [build|test|bench|battery] [arm64]   build: library, baker, samples; test: that and what only tests use;
#                                                   battery: build and what scripts/noise_battery.sh runs;
#                                                   arm64: also a cross compiler and an emulator of 64-bit ARM
set -euo pipefail

packages=(
    g++ cmake ninja-build pkg-config python3
    libhwy-dev                                   # kernel: SIMD
    libflatbuffers-dev flatbuffers-compiler      # asset format
    libccd-dev                                   # contact: convex pairs
    libeigen3-dev libassimp-dev                  # baker
    libpng-dev libboost-dev                      # baker: images and triangulation of cards
    libcli11-dev nlohmann-json3-dev              # command lines, reports
    libegl-dev libopengl-dev libgl-dev libegl1 libopengl0 libgl1-mesa-dri   # pictures without a display
)
if [ "${1:-build}" = bench ]; then               # test, and what docs/performance.md is made with
    packages+=(libmujoco-dev libbullet-dev libode-dev)   # peers of lr_bench, each optional
    packages+=(valgrind python3-matplotlib)              # instructions; the plot
    set -- test "${@:2}"
fi
if [ "${1:-build}" = test ]; then
    packages+=(doctest-dev libbenchmark-dev binutils clang-14 libclang-rt-14-dev clang-format clang-tidy doxygen)
    packages+=(mono-mcs mono-runtime libmono-corlib4.5-cil)   # C#: build rules of the Unreal plugin
fi
if [ "${1:-build}" = battery ]; then
    packages+=(dieharder)
fi
if [[ " $* " == *" arm64 "* ]]; then
    packages+=(g++-aarch64-linux-gnu qemu-user-static)
fi

missing=()
for package in "${packages[@]}"; do
    [ "$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null)" = "install ok installed" ] || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
    echo "set-up: all ${#packages[@]} Debian packages are installed"
    exit 0
fi

sudo=()
if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
        echo "set-up: not root and no sudo. Install these by hand: ${missing[*]}" >&2
        exit 1
    fi
    sudo=(sudo)
fi
echo "set-up: installing ${missing[*]}"
"${sudo[@]}" apt-get update -qq
"${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
echo "set-up: done"
