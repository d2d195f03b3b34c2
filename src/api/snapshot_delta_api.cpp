#include "world/snapshot_delta.h"

#include <cstdint>

namespace {

const unsigned char* bytes(const void* memory) {
    return static_cast<const unsigned char*>(memory);
}

bool overlap(const void* a, uint64_t a_size, const void* b, uint64_t b_size) {
    const uint64_t from = reinterpret_cast<uintptr_t>(a), other = reinterpret_cast<uintptr_t>(b);
    return from < other ? other - from < a_size : from - other < b_size;
}

} // namespace

extern "C" {

uint64_t lr_snapshot_delta_bound(uint64_t snapshot_size) {
    return lr::delta_bound(snapshot_size);
}

lr_status lr_snapshot_delta_encode(const void* base, uint64_t base_size, const void* snapshot, uint64_t snapshot_size,
                                   void* memory, uint64_t capacity, uint64_t* written) {
    if (written) *written = 0;
    if (!base || !snapshot || !memory) return LR_ERROR_NULL_ARGUMENT;
    if (overlap(memory, capacity, base, base_size) || overlap(memory, capacity, snapshot, snapshot_size))
        return LR_ERROR_INVALID_ARGUMENT;
    uint64_t used = 0;
    const lr_status status = lr::delta_encode(bytes(base), base_size, bytes(snapshot), snapshot_size,
                                              static_cast<unsigned char*>(memory), capacity, used);
    if (written) *written = used;
    return status;
}

lr_status lr_snapshot_delta_apply(const void* base, uint64_t base_size, const void* delta, uint64_t delta_size,
                                  void* memory, uint64_t capacity, uint64_t* written) {
    if (written) *written = 0;
    if (!base || !delta || (!memory && capacity != 0)) return LR_ERROR_NULL_ARGUMENT;
    if (memory && (overlap(memory, capacity, base, base_size) || overlap(memory, capacity, delta, delta_size)))
        return LR_ERROR_INVALID_ARGUMENT;
    uint64_t used = 0;
    const lr_status status = lr::delta_apply(bytes(base), base_size, bytes(delta), delta_size,
                                             static_cast<unsigned char*>(memory), capacity, used);
    if (written) *written = used;
    return status;
}

} // extern "C"
