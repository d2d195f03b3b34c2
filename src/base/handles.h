// The bits of handles. Generations start at 1, so 0 is never a handle.
#pragma once

#include "langevin_rigid.h"

#include <cstdint>

namespace lr {

inline constexpr uint32_t slot_bits = 26, generation_bits = 24, batch_bits = 14;
static_assert(slot_bits + generation_bits + batch_bits == 64);
inline constexpr uint32_t max_capacity = 1u << slot_bits;
inline constexpr uint32_t max_generation = (1u << generation_bits) - 1;
inline constexpr uint32_t max_batches = (1u << batch_bits) - 1;

struct BodyHandle {
    uint32_t slot, generation, batch;
};

inline lr_body pack(BodyHandle h) {
    return {uint64_t{h.slot} | uint64_t{h.generation} << slot_bits |
            uint64_t{h.batch} << (slot_bits + generation_bits)};
}
inline BodyHandle unpack(lr_body body) {
    return {static_cast<uint32_t>(body.id) & (max_capacity - 1),
            static_cast<uint32_t>(body.id >> slot_bits) & max_generation,
            static_cast<uint32_t>(body.id >> (slot_bits + generation_bits))};
}

// Generations of a slot wrap around: a handle kept over 16 million lives of its slot can match a later body.
inline uint32_t next_generation(uint32_t generation) {
    return generation == max_generation ? 1 : generation + 1;
}

struct BatchHandle {
    uint32_t index, generation;
};
inline constexpr uint32_t max_batch_generation = (1u << (32 - batch_bits)) - 1;

inline lr_batch pack(BatchHandle h) {
    return {h.index | h.generation << batch_bits};
}
inline BatchHandle unpack(lr_batch batch) {
    return {batch.id & ((1u << batch_bits) - 1), batch.id >> batch_bits};
}

struct ColliderHandle {
    uint32_t slot, generation;
};
inline lr_collider pack(ColliderHandle h) {
    return {uint64_t{h.slot} | uint64_t{h.generation} << 32};
}
inline ColliderHandle unpack(lr_collider collider) {
    return {static_cast<uint32_t>(collider.id), static_cast<uint32_t>(collider.id >> 32)};
}
} // namespace lr
