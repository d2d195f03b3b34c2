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
template <class T> bool is_struct_size(uint32_t size) {
    return is_struct_size(size, sizeof(T), first_size<T>);
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
// recordings contain it.
template <class T> void copy_struct(const T* given, T& out) {
    const size_t size = std::min<size_t>(given->struct_size, sizeof(T));
    std::memcpy(static_cast<void*>(&out), given, size);
    out.struct_size = static_cast<uint32_t>(size);
}
template <class T> lr_status read_struct(const T* given, T& out) {
    const lr_status status = check_size(given);
    if (given && status == LR_OK) copy_struct(given, out);
    return status;
}

// An array of structs. The stride is the struct_size of the first; all elements must have the same.
template <class T> class ArrayOf {
public:
    explicit ArrayOf(const T* first) : first_(first), stride_(first->struct_size) {}
    lr_status read(uint32_t i, T& out) const {
        const auto* const bytes = reinterpret_cast<const unsigned char*>(first_) + uint64_t{stride_} * i;
        // First: an element with a larger struct_size than the stride would be read past the array's end.
        uint32_t size = 0;
        std::memcpy(&size, bytes, sizeof size);
        if (size != stride_) return LR_ERROR_STRUCT_SIZE;
        return read_struct(reinterpret_cast<const T*>(bytes), out);
    }
    // An element that read() has accepted.
    void copy(uint32_t i, T& out) const {
        copy_struct(reinterpret_cast<const T*>(reinterpret_cast<const unsigned char*>(first_) + uint64_t{stride_} * i),
                    out);
    }

private:
    const T* first_;
    uint32_t stride_;
};

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
