# SPDX-License-Identifier: MIT
#
# Properties of each platform. Sourced by the other packaging scripts.

# Sets the tools that build and run a platform's programs; call in the tree's root. Fails and names the tools that are missing.
select_platform() { # platform
    platform=$1
    toolchain=() runner=() tools=(cmake ninja flatc)
    exe= suffix=tar.xz library=lib/liblangevin_rigid.so.0.2.0 strip=strip
    case $platform in
    linux-x64) tools+=(gcc g++ readelf objdump) ;;
    linux-arm64)
        toolchain=(-DCMAKE_TOOLCHAIN_FILE="$PWD/cmake/aarch64-linux-gnu.cmake")
        runner=(qemu-aarch64-static -L /usr/aarch64-linux-gnu)
        tools+=(aarch64-linux-gnu-g++ qemu-aarch64-static readelf)
        ;;
    windows-x64)
        toolchain=(-DCMAKE_TOOLCHAIN_FILE="$PWD/cmake/x86_64-w64-mingw32.cmake")
        runner=("$(find_wine)")
        tools+=(x86_64-w64-mingw32-g++-posix x86_64-w64-mingw32-objdump "${runner[0]}" zip)
        exe=.exe suffix=zip library=bin/langevin_rigid.dll strip=x86_64-w64-mingw32-strip
        ;;
    *)
        echo "unknown platform: $platform; use linux-x64, windows-x64, linux-arm64 or wasm" >&2
        return 2
        ;;
    esac
    local tool missing=()
    for tool in "${tools[@]}"; do command -v "$tool" >/dev/null || missing+=("$tool"); done
    [ ${#missing[@]} -eq 0 ] || { echo "$platform needs ${missing[*]}: scripts/setup.sh package $(setup_word "$platform")" >&2; return 3; }
}

# Debian installs it outside PATH.
find_wine() {
    local candidate
    for candidate in wine64 /usr/lib/wine/wine64 wine; do command -v "$candidate" && return; done
    echo wine64
}

setup_word() { # platform
    case $1 in windows-*) echo windows ;; *-arm64) echo arm64 ;; esac
}

platform_folder() { echo "$PWD/build/packaging/$1"; }
# At the same depth as other builds: relative source paths are then equal, so that the compiler cache can share objects with the tests.
platform_build() { echo "$PWD/build/package-$1"; }
