// How a snapshot's bytes lie: the world's header, wind, surface, colliders, pairs of batches, and for each batch its header and its
// columns. All is little-endian, in 32-bit words, each piece padded to an even number of them. docs/reference/snapshots.md
#pragma once

#include "asset/asset.h"
#include "kernel/aerodynamics.h"
#include "kernel/batch_arrays.h"
#include "world/pace.h"
#include "world/pacing.h"
#include "world/snapshot_seal.h"

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace lr {

inline constexpr uint64_t snapshot_magic = 0x31304e53444c524cull; // "LRLDSN01"
// After a release any change of what follows, or of a record in it, takes the next. Others are refused.
inline constexpr uint32_t snapshot_version = 1;

struct SnapshotHeader {
    uint64_t magic;
    uint32_t version;
    uint32_t batch_slots;
    uint64_t size; // of everything
    uint64_t seal; // of everything but this field
    uint64_t seed;
    uint64_t step_count, substep_count;
    double time;
    Pacing::Record pacing;
    float gravity[3];
    float wind[3];
    uint32_t next_key;
    uint32_t pair_count; // of BatchPairs, behind the colliders
};

struct SnapshotBatch {
    uint64_t content_hash; // of the asset
    uint32_t capacity;     // 0 for a slot without a batch
    uint32_t count;
    uint32_t generation, body_generation; // of the slot
    uint32_t first_generation, last_generation;
    uint32_t free_first, free_last;
    uint32_t table_count;
    float inverse_dt;
    float speed_alpha, speed_beta;
    uint32_t parts;  // SnapshotPart
    uint32_t fields; // Batch::fields
    Gains gains;
    TurbulenceSample stationary;
    AerodynamicData aerodynamics;
    Pace::Record pace;
};
static_assert(std::is_trivially_copyable_v<SnapshotHeader> && std::is_trivially_copyable_v<SnapshotBatch>);
static_assert(offsetof(SnapshotHeader, seal) == seal_offset && sizeof(SnapshotHeader) >= 64);
static_assert(sizeof(SnapshotHeader) % 8 == 0 && sizeof(SnapshotBatch) % 8 == 0);

constexpr uint64_t even_words(uint64_t words) {
    return (words + 1) / 2 * 2;
}

// Columns of a batch in their order: fields, keys, ids, dense indices and generations of slots, both halves of the table; then those
// of its parts (world/snapshot_parts.h).
enum SnapshotColumn : uint32_t {
    column_key = field_count,
    column_ids,
    column_dense,
    column_generations,
    column_alpha,
    column_beta,
    column_parts // the first of them
};
// Words of one of the columns before column_parts, padding included; 0 for a field that the batch has not.
constexpr uint64_t column_words(const SnapshotBatch& h, uint32_t column) {
    if (column < field_count) return column < h.fields ? even_words(h.count) : 0;
    if (column == column_key) return even_words(h.count);
    if (column == column_ids) return 2 * uint64_t{h.count};
    if (column < column_alpha) return even_words(h.capacity);
    return even_words(h.table_count);
}
// Bytes of them all.
constexpr uint64_t columns_bytes(const SnapshotBatch& h) {
    uint64_t words = 0;
    for (uint32_t column = 0; column < column_parts; ++column) words += column_words(h, column);
    return 4 * words;
}

} // namespace lr
