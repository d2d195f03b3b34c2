// Reseals changed snapshots: their checksum is no secret.
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

namespace test {

// As in src/world/snapshot/snapshot.cpp: 64-bit words, except the one at byte 24, go in turn to eight sums.
inline void seal(std::vector<unsigned char>& bytes) {
    constexpr uint64_t factor = 0x9e3779b97f4a7c15ull;
    const auto take = [](uint64_t& sum, uint64_t word) {
        sum = (sum ^ word) * factor;
        sum ^= sum >> 32;
    };
    uint64_t sums[8];
    for (uint64_t k = 0; k < 8; ++k) sums[k] = (k + 1) * factor;
    for (size_t i = 0; i < (bytes.size() + 63) / 64 * 8; ++i) {
        uint64_t word = 0;
        if (i != 3 && 8 * i + 8 <= bytes.size()) std::memcpy(&word, bytes.data() + 8 * i, 8);
        take(sums[i % 8], word);
    }
    uint64_t all = bytes.size();
    for (uint64_t sum : sums) take(all, sum);
    std::memcpy(bytes.data() + 24, &all, 8);
}

} // namespace test
