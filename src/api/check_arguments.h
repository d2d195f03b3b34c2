// Argument checks shared by all exported functions.
#pragma once

#include "base/allocator.h"
#include "base/float_mode.h"
#include "base/last_error.h"
#include "base/supported_platform.h"
#include "kernel/limits.h"
#include "langevin_rigid_research.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace lr::api {

// Stores a refusal for lr_last_error; for calls without a world, which have no log.
inline lr_status note_refusal(const char* function, const Outcome& outcome) {
    if (outcome.refused()) note_error(function, outcome.why ? outcome.why : lr_status_string(outcome.status));
    return outcome.status;
}

// Far above the size of any struct of this API: a larger struct_size is uninitialised memory.
inline constexpr uint32_t max_struct_size = 65536;

// Size of a struct in its first release. Callers with that header are served; later fields then have their initial values.
template <class T> inline constexpr size_t first_size = sizeof(T);
template <> inline constexpr size_t first_size<lr_aerodynamics> = offsetof(lr_aerodynamics, plate_lift);

// own: size in this header; first: in the first release. A newer header's is larger.
inline bool is_struct_size(uint32_t size, size_t own, size_t first) {
    return (size >= own || size == first) && size <= max_struct_size;
}

template <class T>
concept Sized = requires(T s) {
    s.struct_size;
};

// The tail of a newer, larger struct must be zero: a set field would request a feature that this library lacks.
inline lr_status check_size(const void* given, size_t own, size_t first) {
    if (!given) return LR_ERROR_NULL_ARGUMENT;
    uint32_t size = 0; // the first field
    std::memcpy(&size, given, sizeof size);
    if (!is_struct_size(size, own, first)) return LR_ERROR_STRUCT_SIZE;
    const auto* bytes = static_cast<const unsigned char*>(given);
    for (size_t i = own; i < size; ++i)
        if (bytes[i] != 0) return LR_ERROR_STRUCT_SIZE;
    return LR_OK;
}
template <class T> lr_status check_size(const T* given) {
    return check_size(given, sizeof(T), first_size<T>);
}

// After check_size(). The copy has this header's struct_size, or that of the first release and leaves later fields of `out`, because snapshots and
// recordings contain it. own: size in this header.
inline void copy_struct(const void* given, void* out, size_t own) {
    uint32_t size = 0;
    std::memcpy(&size, given, sizeof size);
    size = std::min(size, static_cast<uint32_t>(own));
    std::memcpy(out, given, size);
    std::memcpy(out, &size, sizeof size);
}
template <class T> void copy_struct(const T* given, T& out) {
    copy_struct(given, static_cast<void*>(&out), sizeof(T));
}

// reserved: offset of a field that must be 0; `own` without one.
inline Outcome read_struct(const void* given, void* out, size_t own, size_t first, size_t reserved) {
    if (const lr_status status = check_size(given, own, first); status != LR_OK) return status;
    copy_struct(given, out, own);
    uint32_t value = 0;
    if (reserved < own) std::memcpy(&value, static_cast<unsigned char*>(out) + reserved, sizeof value);
    return invalid(value != 0 ? "reserved is not 0" : nullptr);
}
template <class T> Outcome read_struct(const T* given, T& out) {
    size_t reserved = sizeof(T);
    if constexpr (requires { out.reserved; }) {
        static_assert(sizeof out.reserved == sizeof(uint32_t));
        reserved = offsetof(T, reserved);
    }
    return read_struct(given, static_cast<void*>(&out), sizeof(T), first_size<T>, reserved);
}

// After check_size(). Writes a result but keeps the caller's struct_size.
template <class T> void write_struct(const T& from, T* to) {
    const uint32_t size = to->struct_size;
    std::memcpy(static_cast<void*>(to), &from, std::min<size_t>(size, sizeof(T)));
    to->struct_size = size;
}

// Keeps exceptions from crossing the ABI.
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
