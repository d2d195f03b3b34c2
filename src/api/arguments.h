// Checks that every exported function shares.
#pragma once

#include "format/target.h"
#include "kernel/float_mode.h"
#include "kernel/limits.h"
#include "langevin_rigid.h"
#include "world/out_of_memory.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>

namespace lr::api {

using lr::in_range;

// No struct of this API comes near it: a size above it is not a size.
inline constexpr uint32_t max_struct_size = 65536;

// Sizes that each struct had before it grew: what older callers give. When a struct grows, the size that it had in the last
// release comes here; tests/abi holds every released size against it.
template <class T> inline constexpr std::array<size_t, 0> earlier_sizes{};
template <>
inline constexpr std::array earlier_sizes<lr_world_desc>{offsetof(lr_world_desc, jobs),
                                                         offsetof(lr_world_desc, checks)};
template <> inline constexpr std::array earlier_sizes<lr_world_info>{offsetof(lr_world_info, collider_count)};
template <> inline constexpr std::array earlier_sizes<lr_batch_view>{offsetof(lr_batch_view, revision)};
template <> inline constexpr std::array earlier_sizes<lr_body_state>{offsetof(lr_body_state, resting)};
template <> inline constexpr std::array earlier_sizes<lr_batch_events>{offsetof(lr_batch_events, faulted)};

// Besides larger ones, of newer headers. Another one between would cut a field in two.
template <class T> bool is_struct_size(uint32_t size) {
    for (size_t earlier : earlier_sizes<T>)
        if (size == earlier) return true;
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

// A smaller struct of an older header is filled up with zeros; the tail of a larger one must be zero.
template <class T> lr_status check_size(const T* given) {
    if (!given) return LR_ERROR_NULL_ARGUMENT;
    const uint32_t size = given->struct_size;
    if (!is_struct_size<T>(size)) return LR_ERROR_STRUCT_SIZE;
    const auto* bytes = reinterpret_cast<const unsigned char*>(given);
    for (size_t i = sizeof(T); i < size; ++i)
        if (bytes[i] != 0) return LR_ERROR_STRUCT_SIZE;
    return LR_OK;
}

// What is kept has this header's size, whatever the caller's header has: snapshots and recordings hold it.
template <class T> lr_status read_struct(const T* given, T& out) {
    const lr_status status = check_size(given);
    if (status != LR_OK) return status;
    out = T{};
    std::memcpy(&out, given, given->struct_size < sizeof(T) ? given->struct_size : sizeof(T));
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

// Writes as much of a result as the caller has room for.
template <class T> void write_struct(const T& from, T* to) {
    const uint32_t size = to->struct_size;
    std::memcpy(static_cast<void*>(to), &from, size < sizeof(T) ? size : sizeof(T));
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
