#include "world/snapshot_seal.h"

#include <bit>
#include <cstddef>
#include <cstring>
#include <initializer_list>

namespace lr {
namespace {

static_assert(std::endian::native == std::endian::little, "snapshots are little-endian, and are read where they lie");

constexpr uint64_t sums = 8, block = 8 * sums; // bytes
constexpr uint64_t factor = 0x9e3779b97f4a7c15ull;

void take(uint64_t& sum, uint64_t word) {
    sum = (sum ^ word) * factor;
    sum ^= sum >> 32;
}
uint64_t word_at(const unsigned char* from) {
    uint64_t word;
    std::memcpy(&word, from, 8);
    return word;
}

} // namespace

// Eight sums, so that no multiplication waits for the one before it.
uint64_t seal_of(const unsigned char* bytes, uint64_t size) {
    uint64_t a = 1 * factor, b = 2 * factor, c = 3 * factor, d = 4 * factor, e = 5 * factor, f = 6 * factor,
             g = 7 * factor, h = 8 * factor;
    const auto take_block = [&](const unsigned char* from) {
        take(a, word_at(from)), take(b, word_at(from + 8)), take(c, word_at(from + 16)), take(d, word_at(from + 24));
        take(e, word_at(from + 32)), take(f, word_at(from + 40)), take(g, word_at(from + 48));
        take(h, word_at(from + 56));
    };
    unsigned char part[block];
    std::memcpy(part, bytes, block);
    std::memset(part + seal_offset, 0, 8);
    take_block(part);
    uint64_t at = block;
    for (; at + block <= size; at += block) take_block(bytes + at);
    if (at < size) {
        std::memset(part, 0, block);
        std::memcpy(part, bytes + at, static_cast<size_t>(size - at));
        take_block(part);
    }
    uint64_t all = size;
    for (uint64_t sum : {a, b, c, d, e, f, g, h}) take(all, sum);
    return all;
}

} // namespace lr
