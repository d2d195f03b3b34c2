// The checksum of snapshots: finds damage, not forgery.
#pragma once

#include <cstdint>

namespace lr {

// Where they hold it, in bytes from their beginning.
inline constexpr uint64_t seal_offset = 24;

// Over `size` bytes, a multiple of 8 and at least 64, of any alignment: 64-bit little-endian words, of which the seal's own counts as
// 0. Word i goes to sum i mod 8, each step of which is a bijection, as is each of putting the sums together: one changed word
// always changes the seal.
uint64_t seal_of(const unsigned char* bytes, uint64_t size);

} // namespace lr
