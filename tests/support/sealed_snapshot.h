// A snapshot that somebody has changed, with its checksum made right again.
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

namespace test {

// src/world/snapshot.cpp: 64-bit words but the one at byte 24.
inline void seal(std::vector<unsigned char>& bytes) {
    uint64_t sum = bytes.size(), word = 0;
    for (size_t i = 0; i + 8 <= bytes.size(); i += 8) {
        if (i == 24) continue;
        std::memcpy(&word, bytes.data() + i, 8);
        sum = (sum ^ word) * 0x9e3779b97f4a7c15ull;
        sum ^= sum >> 32;
    }
    std::memcpy(bytes.data() + 24, &sum, 8);
}

} // namespace test
