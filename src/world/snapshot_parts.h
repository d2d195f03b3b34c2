// The parts of a batch's snapshot that only some batches have: forces, rules, emitter, lives.
#pragma once

#include "world/batch.h"

#include <cstdint>

namespace lr {

// Bits of a batch's header.
enum SnapshotPart : uint32_t {
    part_batch_force = 1,
    part_body_forces = 2,
    part_lifecycle = 4,
    part_rest = 8,
    part_contact = 16,
    part_settings = 32,
    part_faults = 64
};
inline constexpr uint32_t all_parts =
    part_batch_force | part_body_forces | part_lifecycle | part_rest | part_contact | part_settings | part_faults;

uint32_t parts_of(const Batch& batch);
// Bytes, a multiple of 8.
uint64_t parts_bytes(uint32_t parts, uint32_t count);
// Writes parts_bytes() of the batch's parts_of().
void save_parts(Batch& batch, unsigned char* to);
// Whether bytes that say to be these parts can be put back. meets_bodies: the batch is one of a pair.
bool parts_consistent(uint32_t parts, uint32_t count, bool meets_bodies, const unsigned char* from);
// Memory for what restore_parts() will need; changes nothing that can be seen. False when there is none.
bool reserve_parts(Batch& batch, uint32_t parts);
// After the bodies are back. Ends whatever the snapshot does not have.
void restore_parts(Batch& batch, uint32_t parts, uint32_t count, const unsigned char* from);

} // namespace lr
