// Bytes of a snapshot in parts of multiples of 8 bytes; reading and writing need no alignment.
#pragma once

#include <cstdint>
#include <cstring>

namespace lr {

constexpr uint64_t padded_bytes(uint64_t bytes) {
    return (bytes + 7) / 8 * 8;
}

template <class T> T value_at(const unsigned char* from, uint64_t index) {
    T value;
    std::memcpy(static_cast<void*>(&value), from + sizeof(T) * index, sizeof(T));
    return value;
}

// Compares bits: 0 and -0 differ.
template <class T> bool same(const T& x, const T& y) {
    return std::memcmp(&x, &y, sizeof x) == 0; // NOLINT(bugprone-suspicious-memory-comparison)
}

// Whether `free` slots form a chain from first to last without repeats. next(slot): the successor; an invalid slot if `slot` is not free.
template <class Next> bool make_chain(uint32_t first, uint32_t last, uint32_t free, uint32_t slots, const Next& next) {
    uint32_t slot = first;
    for (uint32_t i = 0; i < free; ++i) {
        if (slot >= slots || (slot == last) != (i + 1 == free)) return false;
        slot = next(slot);
    }
    return true;
}
} // namespace lr
