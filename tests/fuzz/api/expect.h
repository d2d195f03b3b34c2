// Permitted results of a call, by the header alone, and structs as callers pass them.
#pragma once

#include "fuzz/api/input.h"
#include "langevin_rigid_research.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

namespace fuzz {

[[noreturn]] inline void defect(const char* function, const char* what, int64_t value = 0) {
    std::fprintf(stderr, "DEFECT in %s: %s (%lld)\n", function, what, static_cast<long long>(value));
    std::abort();
}

// Remembers the called functions of the library, for the test that none is missing.
bool note_reached(const char* function);
#define LR_CALL(function)                                                                                              \
    ([] {                                                                                                              \
        static const bool noted = ::fuzz::note_reached(#function);                                                     \
        return noted;                                                                                                  \
    }()                                                                                                                \
         ? function                                                                                                    \
         : function)

// Errors of which one must come, and errors that can.
class Expected {
public:
    void add(lr_status error) { must_ |= bit(error); }
    void add_if(bool wrong, lr_status error) {
        if (wrong) add(error);
    }
    void may(lr_status error) { may_ |= bit(error); }
    void may_if(bool perhaps, lr_status error) {
        if (perhaps) may(error);
    }
    void forgive() { may_ |= must_, must_ = 0; }
    template <class T> void finite(T value) { add_if(!std::isfinite(value), LR_ERROR_NOT_FINITE); }
    // Finite, and within its range.
    template <class T> void range(T value, double low, double high) {
        if (!std::isfinite(value))
            add(LR_ERROR_NOT_FINITE);
        else if (static_cast<double>(value) < static_cast<double>(static_cast<T>(low)) ||
                 static_cast<double>(value) > static_cast<double>(static_cast<T>(high)))
            add(LR_ERROR_INVALID_ARGUMENT);
    }
    template <class T, size_t N> void range(const T (&values)[N], double low, double high) {
        for (T v : values) range(v, low, high);
    }
    // Non-zero length, by squares in double.
    template <size_t N> void length(const float (&values)[N], double low, double high) {
        double square = 0.0;
        for (float v : values) {
            add_if(!std::isfinite(v), LR_ERROR_NOT_FINITE);
            square += static_cast<double>(v) * static_cast<double>(v);
        }
        if (!std::isfinite(square)) return;
        if (square == 0.0) add(LR_ERROR_INVALID_ARGUMENT);
        may_if(square < low * low || square > high * high, LR_ERROR_INVALID_ARGUMENT);
    }
    bool fails() const { return must_ != 0; }
    bool may_fail() const { return (must_ | may_) != 0; }
    bool allows(lr_status status) const {
        if (status == LR_OK) return must_ == 0;
        return status < 0 && status > -64 && ((must_ | may_) & bit(status)) != 0;
    }

private:
    static uint64_t bit(lr_status status) { return uint64_t{1} << -status; }
    uint64_t must_ = 0, may_ = 0;
};

// A struct in a block of exactly its stated size: AddressSanitizer detects accesses behind it.
template <class T> class Given {
public:
    Given(const Input& in, const T& value, uint32_t which, Expected& expected, bool nullable = false) {
        if (in.null(which)) {
            expected.add_if(!nullable, LR_ERROR_NULL_ARGUMENT);
            return;
        }
        uint32_t size = sizeof(T);
        size_t bytes = sizeof(T);
        bool tail = false;
        if (in.flag(flag_size)) {
            const uint32_t sizes[] = {0, 1, 4, sizeof(T) + 4, sizeof(T) + 8, 65536, 65537, 0xffffffffu};
            size = sizes[in.handle(2) % 8];
            tail = in.handle(2) % 8 == 4;
            bytes = size < 4 ? 4 : size > 65536 ? sizeof(T) : size;
            expected.add_if(size < 8 || size > 65536 || tail, LR_ERROR_STRUCT_SIZE);
        }
        block_.reset(new unsigned char[bytes]());
        std::memcpy(block_.get(), &value, bytes < sizeof(T) ? bytes : sizeof(T));
        std::memcpy(block_.get(), &size, sizeof size);
        if (tail) block_[bytes - 1] = 1;
    }
    T* get() { return reinterpret_cast<T*>(block_.get()); }
    // The struct as written by the library.
    T read() const {
        T out;
        std::memcpy(&out, block_.get(), sizeof out);
        return out;
    }

private:
    std::unique_ptr<unsigned char[]> block_;
};

// An array with the stride of its first element, in a block of exactly that size.
template <class T> class GivenArray {
public:
    GivenArray(const Input& in, const std::vector<T>& values, uint32_t which, Expected& expected) {
        if (values.empty()) return;
        if (in.null(which)) {
            expected.add(LR_ERROR_NULL_ARGUMENT);
            return;
        }
        const uint32_t kind = in.flag(flag_size) ? 1 + in.handle(2) % 4u : 0;
        const uint32_t stride = kind == 1 ? sizeof(T) + 8 : kind == 2 ? 4 : sizeof(T);
        block_.reset(new unsigned char[stride * values.size()]());
        for (size_t i = 0; i < values.size(); ++i) {
            unsigned char* const at = block_.get() + stride * i;
            std::memcpy(at, &values[i], stride < sizeof(T) ? stride : sizeof(T));
            std::memcpy(at, &stride, sizeof stride);
        }
        unsigned char* const last = block_.get() + stride * (values.size() - 1);
        const uint32_t longer = sizeof(T) + 8;
        if (kind == 3) std::memcpy(last, &longer, sizeof longer); // past the end, or not like the first
        if (kind == 4) std::memset(last, 0xff, 4);
        if (kind == 1 && in.variant() == 3) last[stride - 1] = 1, expected.add(LR_ERROR_STRUCT_SIZE);
        // A single element that states a larger size is valid if zeros follow; here nothing follows.
        if (kind == 3 && values.size() == 1) std::memcpy(last, &stride, sizeof stride);
        expected.add_if(kind == 2 || kind == 4 || (kind == 3 && values.size() > 1), LR_ERROR_STRUCT_SIZE);
    }
    T* get() { return reinterpret_cast<T*>(block_.get()); }

private:
    std::unique_ptr<unsigned char[]> block_;
};

template <class T> T initialised(lr_status (*init)(T*, uint32_t)) {
    T desc;
    std::memset(static_cast<void*>(&desc), 0xa5, sizeof desc);
    if (init(&desc, sizeof desc) != LR_OK) defect("an _init function", "its own size is refused");
    return desc;
}

} // namespace fuzz
