// Handles: what the bits of lr_body and lr_batch mean. Generations start at 1, so that 0 is never a handle.
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
    return static_cast<lr_body>(h.slot) | static_cast<lr_body>(h.generation) << slot_bits |
           static_cast<lr_body>(h.batch) << (slot_bits + generation_bits);
}
inline BodyHandle unpack(lr_body id) {
    return {static_cast<uint32_t>(id) & (max_capacity - 1), static_cast<uint32_t>(id >> slot_bits) & max_generation,
            static_cast<uint32_t>(id >> (slot_bits + generation_bits))};
}

// After the last generation a slot begins again: a handle kept over 16 million lives of one slot may be taken for
// another.
inline uint32_t next_generation(uint32_t generation) {
    return generation == max_generation ? 1 : generation + 1;
}

struct BatchHandle {
    uint32_t index, generation;
};
inline constexpr uint32_t max_batch_generation = (1u << (32 - batch_bits)) - 1;

inline lr_batch pack(BatchHandle h) {
    return h.index | h.generation << batch_bits;
}
inline BatchHandle unpack_batch(lr_batch batch) {
    return {batch & ((1u << batch_bits) - 1), batch >> batch_bits};
}

struct ColliderHandle {
    uint32_t slot, generation;
};
inline lr_collider pack(ColliderHandle h) {
    return static_cast<lr_collider>(h.slot) | static_cast<lr_collider>(h.generation) << 32;
}
inline ColliderHandle unpack_collider(lr_collider collider) {
    return {static_cast<uint32_t>(collider), static_cast<uint32_t>(collider >> 32)};
}

} // namespace lr
