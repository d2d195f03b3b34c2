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

// Each part is one column or some, in the order of the bits: the force on the batch; forces on bodies by component; rules and
// emitter, lives; the record of rest, births; what contact notes; settings of contact; faults.
inline constexpr uint32_t part_columns = 1 + force_components + 2 + 2 + (1 + stay_rows + most_touched) + 1 + 1;

uint32_t parts_of(const Batch& batch);
// Words of a column, an even number; 0 for one of a part that is not there.
uint64_t part_column_words(uint32_t parts, uint32_t count, uint32_t column);
// Bytes of them all, a multiple of 8.
uint64_t parts_bytes(uint32_t parts, uint32_t count);
// The index of the first body at rest in parts that are consistent; `count` where none is.
uint32_t rest_begin(uint32_t parts, uint32_t count, const unsigned char* from);
// Writes parts_bytes() of parts, which are the batch's parts_of().
void save_parts(Batch& batch, uint32_t parts, unsigned char* to);
// Whether bytes that say to be these parts can be put back. meets_bodies: the batch is one of a pair.
bool parts_consistent(uint32_t parts, uint32_t count, bool meets_bodies, const unsigned char* from);
// Memory for what restore_parts() will need; changes nothing that can be seen. False when there is none.
bool reserve_parts(Batch& batch, uint32_t parts);
// After the bodies are back. Ends whatever the snapshot does not have. before: how many bodies there were.
void restore_parts(Batch& batch, uint32_t parts, uint32_t count, uint32_t before, const unsigned char* from);

} // namespace lr
