// The supported targets, for builds without CMake too; CMakeLists.txt checks the same.
#pragma once

#include <cstdint>

#if UINTPTR_MAX < UINT64_MAX && !defined(__wasm32__)
#error "Langevin Rigid is tested on 64-bit targets and on wasm32 alone: no other 32-bit target has known bits."
#endif
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "Langevin Rigid needs a little-endian target: assets and snapshots are little-endian."
#endif
