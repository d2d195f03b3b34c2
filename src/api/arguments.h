// Checks that every exported function shares.
#pragma once

#include "format/target.h"
#include "kernel/float_mode.h"
#include "kernel/limits.h"
#include "langevin_rigid.h"
#include "world/out_of_memory.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>

namespace lr::api {

using lr::in_range;

// No struct of this API comes near it: a size above it is not a size.
inline constexpr uint32_t max_struct_size = 65536;

// Of this header or of a newer one, whose structs are larger.
template <class T> bool is_struct_size(uint32_t size) {
    return size >= sizeof(T) && size <= max_struct_size;
}

// Begins an _init function: zeroes all that the caller has.
template <class T> lr_status begin_init(T* desc, uint32_t struct_size) {
    if (!desc) return LR_ERROR_NULL_ARGUMENT;
    if (!is_struct_size<T>(struct_size)) return LR_ERROR_STRUCT_SIZE;
    std::memset(static_cast<void*>(desc), 0, struct_size);
    desc->struct_size = struct_size;
    return LR_OK;
}

// The tail of a larger struct must be zero: it would ask for what this library cannot do.
template <class T> lr_status check_size(const T* given) {
    if (!given) return LR_ERROR_NULL_ARGUMENT;
    const uint32_t size = given->struct_size;
    if (!is_struct_size<T>(size)) return LR_ERROR_STRUCT_SIZE;
    const auto* bytes = reinterpret_cast<const unsigned char*>(given);
    for (size_t i = sizeof(T); i < size; ++i)
        if (bytes[i] != 0) return LR_ERROR_STRUCT_SIZE;
    return LR_OK;
}

// A copy with this header's size, whatever the caller's header has: snapshots and recordings hold it.
template <class T> lr_status read_struct(const T* given, T& out) {
    const lr_status status = check_size(given);
    if (status != LR_OK) return status;
    out = *given;
    out.struct_size = sizeof(T);
    return LR_OK;
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

template <class T, size_t N> bool finite(const T (&values)[N]) {
    for (T v : values)
        if (!std::isfinite(v)) return false;
    return true;
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
