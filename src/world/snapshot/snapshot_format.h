// Layout of a snapshot: header, wind sources, colliders, pairs of batches, touching bodies; then for each batch a header and its pieces. All
// little-endian and in multiples of 8 bytes. docs/reference/snapshots.md
#pragma once

#include "asset/asset.h"
#include "collision/colliders.h"
#include "environment/water.h"
#include "environment/wind_field.h"
#include "kernel/body_constants.h"
#include "world/batch/batch.h"
#include "world/batch/body_columns.h"
#include "world/batch/lifecycle.h"
#include "world/schedule/batch_schedule.h"
#include "world/sleep/sleeping_bodies.h"
#include "world/snapshot/snapshot_bytes.h"

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace lr {

// Colliders of a snapshot. Restoring takes two steps, so that nothing changes until all of it has been checked.
class ColliderSnapshot {
public:
    // Part of the snapshot's header.
    struct Head {
        uint32_t slots, count;
        uint32_t free_first, free_last;
    };
    static Head head(const Colliders& c) { return {c.used_, c.count_, c.free_first_, c.free_last_}; }
    // Size of slots and colliders after the header, a multiple of 8.
    static uint64_t bytes(const Head& head) {
        return sizeof(Slot) * uint64_t{head.slots} + sizeof(ColliderRecord) * uint64_t{head.count};
    }
    static void save(const Colliders& colliders, unsigned char* to);

    explicit ColliderSnapshot(Colliders& colliders) : to_(&colliders) {}

    // Checks the part, of which at most `size` bytes remain, and keeps `from` for commit().
    lr_status read(const Head& head, const unsigned char* from, uint64_t size);
    bool any() const { return head_.count != 0; }
    // After read(); cannot fail.
    void commit();

private:
    struct Slot {
        uint32_t generation;
        uint32_t link; // the next free slot, or `taken`
    };
    static constexpr uint32_t taken = UINT32_MAX - 1, none = UINT32_MAX;

    template <class Write> static bool visit(const Colliders& colliders, Write&& write);
    bool is_there() const;
    bool free_slots_make_a_chain() const;
    Slot slot(uint32_t i) const { return value_at<Slot>(slots_, i); }
    ColliderRecord record(uint32_t i) const;
    SharedGeometry* shared(const ColliderRecord& record) const;

    Colliders* to_;
    const unsigned char* slots_ = nullptr;
    Head head_{};
    bool same_ = false; // equal to the world's present colliders
};

// Wind sources of a snapshot, restored in the same two steps.
class WindSnapshot {
public:
    // Part of the snapshot's header.
    struct Head {
        float before[3];
        uint32_t sources;
        double drift[3];
        uint32_t generations[LR_MAX_WIND_SOURCES];
    };
    static_assert(sizeof(Head) % 8 == 0);
    static Head head(const WindField& field);
    // Size of the sources after the header.
    static uint64_t bytes(const Head& head) { return sizeof(Source) * uint64_t{head.sources}; }
    static void save(const WindField& field, unsigned char* to);

    // world_seed: of the field's world.
    WindSnapshot(WindField& field, uint64_t world_seed) : field_(&field), world_seed_(world_seed) {}
    ~WindSnapshot();
    WindSnapshot(const WindSnapshot&) = delete;
    WindSnapshot& operator=(const WindSnapshot&) = delete;

    // from: the sources, of at most `size` bytes. time, seed: of the saved world.
    lr_status read(const Head& head, const unsigned char* from, uint64_t size, double time, uint64_t seed);
    // After read(). The uniform wind is restored elsewhere.
    void commit();

private:
    struct Source {
        uint32_t slot;
        uint32_t reserved;
        SourcePhase phase;
        uint64_t samples; // hash of the samples
        unsigned char desc[source_bytes];
    };
    static_assert(sizeof(Source) % 8 == 0);
    bool is_there(const Source& saved, uint64_t seed) const;

    WindField* field_;
    uint64_t world_seed_;
    WindSource* sources_[WindField::capacity] = {}; // new sources
    bool kept_[WindField::capacity] = {};           // the field has an equal source, which stays
    Head head_{};
};

inline constexpr uint64_t snapshot_magic = 0x31304e53444c524cull; // "LRLDSN01"
// Raised after a release by any change of the layout or a record. Other versions are refused.
inline constexpr uint32_t snapshot_version = 2;

struct SnapshotHeader {
    uint64_t magic;
    uint32_t version;
    uint32_t batch_slots;
    uint64_t size; // of the whole snapshot
    uint64_t seal; // over all other fields and bytes
    uint64_t seed;
    uint64_t step_count, substep_count;
    double time;
    StepScheduler::Record pacing;
    float gravity[3];
    float wind[3];
    uint32_t next_noise_seed;
    uint32_t link_count;        // of BatchPairs, after the colliders
    uint64_t cached_pair_count; // of PairCache, after these
    WindSnapshot::Head wind_field;
    ColliderSnapshot::Head colliders;
    Water::Record surface;
};

// Fields of parts that are absent are 0.
struct SnapshotBatch {
    uint64_t content_hash; // of the asset
    uint32_t capacity;     // 0: a slot without batch
    uint32_t count, awake;
    uint32_t generation, body_generation; // of the slot
    uint32_t first_generation, last_generation;
    uint32_t free_first, free_last;
    uint32_t parts; // a bit for each ColumnPart present
    TableHead table;
    Gains gains;
    AerodynamicData aerodynamics;
    BatchClock::Record pace;
    BatchOptions options;
    uint64_t diverged;
    SleepingBodies::State sleep;
    lr_batch_contact contact;
    float force[force_components];
    uint32_t events; // ContactEvents::pending; 0 while events are off
    Lifecycle::State lifecycle;
};
static_assert(offsetof(SnapshotBatch, lifecycle) == offsetof(SnapshotBatch, events) + sizeof(uint32_t));
static_assert(std::is_trivially_copyable_v<SnapshotHeader> && std::is_trivially_copyable_v<SnapshotBatch>);
static_assert(sizeof(SnapshotHeader) >= 64);
static_assert(sizeof(SnapshotHeader) % 8 == 0 && sizeof(SnapshotBatch) % 8 == 0);

// Pieces of a batch: its columns; dense indices and generations, by slot; samples of its table; events still to be reported, by slot.
enum BatchPiece : uint32_t {
    piece_dense = column_count,
    piece_generations,
    piece_chi,
    piece_epsilon,
    piece_noted,
    piece_held,
    batch_pieces
};

// Size without padding.
constexpr uint64_t piece_bytes(const SnapshotBatch& h, uint32_t piece) {
    if (piece >= piece_noted)
        return h.events != 0 ? uint64_t{piece == piece_noted ? 1 : ContactEvents::held_bytes} * h.capacity : 0;
    if (piece >= piece_dense) return 4 * uint64_t{piece < piece_chi ? h.capacity : h.table.count};
    const Column& column = body_columns[piece];
    return column.saved && (h.parts >> column.part & 1u) != 0 ? uint64_t{column.width} * h.count : 0;
}

class SavedBatch {
public:
    explicit SavedBatch(const unsigned char* from)
        : header(value_at<SnapshotBatch>(from, 0)), pieces_(from + sizeof header) {
        for (uint32_t piece = 0; piece < batch_pieces && header.capacity != 0; ++piece) {
            begin_[piece] = size_;
            size_ += padded_bytes(piece_bytes(header, piece));
        }
    }
    uint64_t bytes() const { return sizeof header + size_; }
    const unsigned char* at(size_t piece) const { return pieces_ + begin_[piece]; }
    template <class T = uint32_t> T value(size_t piece, uint64_t index) const { return value_at<T>(at(piece), index); }
    SnapshotBatch header;

private:
    const unsigned char* pieces_;
    uint64_t begin_[batch_pieces] = {}, size_ = 0;
};
} // namespace lr
