#pragma once

#include <cstddef>
#include <cstdint>

namespace lr {

// FNV-1a, 64 bits. Each step is a bijection of the state, so that a single changed byte always changes the result.
class Fnv1a {
public:
    void add(const void* bytes, size_t size) {
        const auto* p = static_cast<const unsigned char*>(bytes);
        for (size_t i = 0; i < size; ++i) add_byte(p[i]);
    }
    void add_byte(unsigned char b) { state_ = (state_ ^ b) * 0x100000001b3ull; }
    void add_u64(uint64_t v) {
        for (int i = 0; i < 8; ++i) add_byte(static_cast<unsigned char>(v >> (8 * i)));
    }
    uint64_t value() const { return state_; }

private:
    uint64_t state_ = 0xcbf29ce484222325ull;
};
} // namespace lr
