// The meaning of the fuzzer's bytes: records of 12 bytes, one per call, so that a changed byte changes one argument of one call.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

namespace fuzz {

inline constexpr size_t record_bytes = 12;

// Bits of a record's flags. Bits 0 and 1: how many numbers of the desc are overridden.
inline constexpr uint8_t flag_size = 4, flag_null = 8; // a wrong struct_size; a null pointer
// Bits 4 and 5: which pointer is null. Bits 6 and 7: for the call.

class Input {
public:
    Input(const uint8_t* bytes, size_t size) : at_(bytes), left_(size) {}

    bool next() {
        if (left_ < record_bytes) return false;
        std::memcpy(record_.data(), at_, record_bytes);
        at_ += record_bytes, left_ -= record_bytes;
        hostile_ = false;
        return true;
    }
    uint8_t operation() const { return record_[0]; }
    uint8_t selector() const { return record_[2]; }           // selects world, asset, snapshot
    uint8_t handle(size_t i) const { return record_[3 + i]; } // three, or counts
    uint8_t value(size_t i) const { return record_[6 + i]; }  // six
    uint32_t variant() const { return record_[1] >> 6; }
    bool flag(uint8_t bit) const { return (record_[1] & bit) != 0; }
    bool null(uint32_t which) const { return flag(flag_null) && (record_[1] >> 4 & 3u) == which; }
    // Whether this record has a number beyond those of games: later results need not be physical.
    bool hostile() const { return hostile_; }

    // Overrides up to three of these numbers, or elements of these arrays, with the values below.
    template <class... Fields> void change(Fields&... fields) {
        const size_t total = (count(fields) + ...);
        for (size_t i = 0; i < (record_[1] & 3u); ++i) {
            size_t left = value(2 * i) % total;
            (change_one(fields, left, value(2 * i + 1)), ...);
        }
    }
    float real(uint8_t byte) {
        if (byte >= 176) hostile_ = true;
        return real_of(byte);
    }
    uint32_t integer(uint8_t byte) {
        static constexpr uint32_t odd[] = {0xffffffffu, 0x80000000u, 0x7fffffffu, 65535,     65536,       65537,
                                           1u << 26,    67108864u,   67108865u,   16777216u, 0xfffffffeu, 1u << 31,
                                           256,         257,         1024,        1025};
        if (byte < 176) return byte < 64 ? byte : byte % 8u;
        hostile_ = true;
        return odd[byte % 16];
    }

private:
    // 0 to 159: plain numbers of either sign from 0.001 to 100. 160 to 175: small round numbers. From 176: limits of the API, and
    // values beyond.
    static float real_of(uint8_t byte) {
        static constexpr float digit[] = {1.0f, 1.5f, 2.0f, 3.0f, 0.5f, 7.0f, 9.81f, 0.1f};
        static constexpr float power[] = {1.0f, 0.1f, 10.0f, 0.01f, 1.0f, 0.3f, 1.0f, 0.02f, 5.0f, 0.05f};
        constexpr float infinite = std::numeric_limits<float>::infinity();
        static constexpr float odd[] = {std::numeric_limits<float>::quiet_NaN(),
                                        infinite,
                                        -infinite,
                                        std::numeric_limits<float>::denorm_min(),
                                        -1e-40f,
                                        std::numeric_limits<float>::max(),
                                        -std::numeric_limits<float>::max(),
                                        std::numeric_limits<float>::min(),
                                        1e9f,
                                        -1e9f,
                                        1.0001e9f,
                                        1e6f,
                                        -1e6f,
                                        1.001e6f,
                                        1e3f,
                                        -1e3f,
                                        1001.0f,
                                        1e-3f,
                                        0.99e-3f,
                                        1e-4f,
                                        0.99e-4f,
                                        1e-6f,
                                        1e-12f,
                                        1e-13f,
                                        1e4f,
                                        -1e4f,
                                        1e18f,
                                        1e30f,
                                        -1e30f,
                                        3e19f,
                                        101.0f,
                                        10.5f};
        if (byte >= 176) return odd[byte % 32];
        if (byte >= 160) return static_cast<float>(byte - 160) * 0.25f;
        const float v = digit[byte % 8] * power[byte / 16];
        return byte % 16 < 8 ? v : -v;
    }
    template <class T> static constexpr size_t count(const T& field) {
        if constexpr (std::is_array_v<T>)
            return sizeof field / sizeof(std::remove_all_extents_t<T>);
        else
            return 1;
    }
    template <class T> void change_one(T& field, size_t& left, uint8_t byte) {
        const size_t n = count(field);
        if (left < n) {
            if constexpr (std::is_array_v<T>)
                set(reinterpret_cast<std::remove_all_extents_t<T>*>(&field)[left], byte);
            else
                set(field, byte);
            left = std::numeric_limits<size_t>::max(); // done
        } else if (left != std::numeric_limits<size_t>::max()) {
            left -= n;
        }
    }
    template <class T> void set(T& to, uint8_t byte) {
        if constexpr (std::is_floating_point_v<T>) {
            to = static_cast<T>(real(byte));
            if constexpr (std::is_same_v<T, double>) // beyond the range of a float
                if (byte >= 250) to = byte % 2 ? 1e300 : 1e-300;
        } else {
            to = static_cast<T>(integer(byte));
        }
    }

    const uint8_t* at_;
    size_t left_;
    std::array<uint8_t, record_bytes> record_{};
    bool hostile_ = false;
};

} // namespace fuzz
