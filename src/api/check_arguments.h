// Checks that every exported function shares.
#pragma once

#include "base/allocator.h"
#include "base/float_mode.h"
#include "base/last_error.h"
#include "base/supported_platform.h"
#include "kernel/limits.h"
#include "langevin_rigid.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>

namespace lr::api {

// A refusal outside of worlds, which would log it.
inline lr_status told(const char* function, const Outcome& outcome) {
    if (outcome.refused()) note_error(function, outcome.why ? outcome.why : lr_status_string(outcome.status));
    return outcome.status;
}

// No struct of this API comes near it: a size above it is not a size.
inline constexpr uint32_t max_struct_size = 65536;

// Of this header or of a newer one, whose structs are larger.
template <class T> bool is_struct_size(uint32_t size) {
    return size >= sizeof(T) && size <= max_struct_size;
}

template <class T>
concept Sized = requires(T s) {
    s.struct_size;
};

// The tail of a larger struct must be zero: it would ask for what this library cannot do.
inline lr_status check_size(const void* given, size_t own) {
    if (!given) return LR_ERROR_NULL_ARGUMENT;
    uint32_t size = 0; // the first field
    std::memcpy(&size, given, sizeof size);
    if (size < own || size > max_struct_size) return LR_ERROR_STRUCT_SIZE;
    const auto* bytes = static_cast<const unsigned char*>(given);
    for (size_t i = own; i < size; ++i)
        if (bytes[i] != 0) return LR_ERROR_STRUCT_SIZE;
    return LR_OK;
}
template <class T> lr_status check_size(const T* given) {
    return check_size(given, sizeof(T));
}

// Of one that check_size() has taken: with this header's size, whatever the caller's header has. Snapshots and recordings hold it.
template <class T> void copy_struct(const T* given, T& out) {
    out = *given;
    out.struct_size = sizeof(T);
}
template <class T> lr_status read_struct(const T* given, T& out) {
    const lr_status status = check_size(given);
    if (given && status == LR_OK) copy_struct(given, out);
    return status;
}

// An array of structs whose stride is the struct_size of the first, the same in all of them.
template <class T> class ArrayOf {
public:
    explicit ArrayOf(const T* first) : first_(first), stride_(first->struct_size) {}
    lr_status read(uint32_t i, T& out) const {
        const auto* const bytes = reinterpret_cast<const unsigned char*>(first_) + uint64_t{stride_} * i;
        // Before anything else is read: an element that says it is longer than the stride would be read past its end.
        uint32_t size = 0;
        std::memcpy(&size, bytes, sizeof size);
        if (size != stride_) return LR_ERROR_STRUCT_SIZE;
        return read_struct(reinterpret_cast<const T*>(bytes), out);
    }
    // A struct that has been read before.
    void copy(uint32_t i, T& out) const {
        copy_struct(reinterpret_cast<const T*>(reinterpret_cast<const unsigned char*>(first_) + uint64_t{stride_} * i),
                    out);
    }

private:
    const T* first_;
    uint32_t stride_;
};

// Writes a result and keeps the caller's size. check_size() has taken it.
template <class T> void write_struct(const T& from, T* to) {
    const uint32_t size = to->struct_size;
    *to = from;
    to->struct_size = size;
}

// Nothing that the library calls may throw across the ABI.
template <class F> lr_status guarded(F&& body) noexcept {
#if defined(__cpp_exceptions)
    try {
        return unless_out_of_memory(body);
    } catch (...) {
        return LR_ERROR_INTERNAL;
    }
#else
    return unless_out_of_memory(body);
#endif
}

} // namespace lr::api
