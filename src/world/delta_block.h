// 32 words as what they differ from 32 others: a byte that says how, and as many bits a word as the largest difference needs.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

namespace lr {

inline constexpr uint32_t block_words = 32;
inline constexpr uint64_t most_block_bytes = 1 + 4 + 4 * block_words;
inline constexpr uint32_t most_equal_blocks = 128;

// The byte: 1 to 32: bits of each difference, its sign in the lowest. 64 to 95: bits over the least of them, which comes first. 128 to
// 255: from 1 to 128 blocks that are equal.
inline constexpr uint32_t block_over_least = 64, block_equal = 128;

inline uint32_t bits_of(uint32_t value) {
    return 32 - static_cast<uint32_t>(std::countl_zero(value));
}
constexpr uint64_t packed_bytes(uint32_t count, uint32_t width) {
    return (uint64_t{count} * width + 7) / 8;
}

// Words of less than 2^width. Writes up to 7 bytes more than packed_bytes().
inline void pack(const uint32_t* words, uint32_t count, uint32_t width, unsigned char* to) {
    uint64_t bits = 0;
    uint32_t held = 0;
    for (uint32_t i = 0; i < count; ++i) {
        bits |= uint64_t{words[i]} << held;
        held += width;
        if (held < 32) continue;
        std::memcpy(to, &bits, 4);
        to += 4;
        bits >>= 32;
        held -= 32;
    }
    std::memcpy(to, &bits, 4);
}
// Reads up to 7 bytes more than packed_bytes().
inline void unpack_words(const unsigned char* from, uint32_t count, uint32_t width, uint32_t* words) {
    const uint64_t mask = (uint64_t{1} << width) - 1;
    for (uint32_t i = 0; i < count; ++i) {
        uint64_t bits;
        std::memcpy(&bits, from + i * width / 8, 8);
        words[i] = static_cast<uint32_t>(bits >> i * width % 8 & mask);
    }
}

// Writes up to most_block_bytes + 7; returns how many count. Blocks that are equal are for the caller.
inline uint64_t encode_block(const uint32_t* now, const uint32_t* was, uint32_t count, unsigned char* to) {
    uint32_t coded[block_words];
    uint32_t all = 0;
    int32_t least = INT32_MAX, most = INT32_MIN;
    for (uint32_t i = 0; i < count; ++i) {
        const auto difference = static_cast<int32_t>(now[i] - was[i]);
        least = std::min(least, difference);
        most = std::max(most, difference);
        coded[i] = static_cast<uint32_t>(difference) << 1 ^ static_cast<uint32_t>(difference >> 31);
        all |= coded[i];
    }
    const uint32_t width = std::max(bits_of(all), 1u);
    const uint32_t over = bits_of(static_cast<uint32_t>(most) - static_cast<uint32_t>(least));
    if (over < 32 && 4 + packed_bytes(count, over) < packed_bytes(count, width)) {
        *to++ = static_cast<unsigned char>(block_over_least + over);
        std::memcpy(to, &least, 4);
        for (uint32_t i = 0; i < count; ++i) coded[i] = now[i] - was[i] - static_cast<uint32_t>(least);
        pack(coded, count, over, to + 4);
        return 1 + 4 + packed_bytes(count, over);
    }
    *to++ = static_cast<unsigned char>(width);
    pack(coded, count, width, to);
    return 1 + packed_bytes(count, width);
}

// Bytes behind the one that says how; 0: it says nothing.
inline uint64_t coded_bytes(uint32_t how, uint32_t count) {
    if (how >= 1 && how <= 32) return packed_bytes(count, how);
    if (how >= block_over_least && how < block_over_least + 32) return 4 + packed_bytes(count, how - block_over_least);
    return 0;
}

// Reads up to 7 bytes more than coded_bytes(), which is not 0.
inline void decode_block(uint32_t how, const unsigned char* from, const uint32_t* was, uint32_t count, uint32_t* now) {
    uint32_t coded[block_words];
    if (how >= block_over_least) {
        uint32_t least;
        std::memcpy(&least, from, 4);
        unpack_words(from + 4, count, how - block_over_least, coded);
        for (uint32_t i = 0; i < count; ++i) now[i] = was[i] + coded[i] + least;
        return;
    }
    unpack_words(from, count, how, coded);
    for (uint32_t i = 0; i < count; ++i) now[i] = was[i] + (coded[i] >> 1 ^ (0u - (coded[i] & 1u)));
}

} // namespace lr
