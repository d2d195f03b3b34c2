// Hashes of what a world holds.
#pragma once

#include <cstdint>

namespace lr {

// A bijection of 64 bits with good avalanche (Steele, Lea, Flood 2014, the finaliser of SplitMix64).
constexpr uint64_t mix64(uint64_t v) {
    v = (v ^ v >> 30) * 0xbf58476d1ce4e5b9ull;
    v = (v ^ v >> 27) * 0x94d049bb133111ebull;
    return v ^ v >> 31;
}

} // namespace lr
