#include "world/snapshot.h"

#include "contact/collider_snapshot.h"
#include "field/wind_snapshot.h"
#include "kernel/aerodynamics.h"
#include "world/snapshot_parts.h"
#include "world/world.h"

#include <cmath>
#include <cstddef>
#include <cstring>
#include <new>
#include <type_traits>

namespace lr {
namespace {

constexpr uint64_t magic = 0x31304e53444c524cull; // "LRLDSN01", little-endian
constexpr uint32_t version = 8;

struct Header {
    uint64_t magic;
    uint32_t version;
    uint32_t batch_slots;
    uint64_t size;     // of everything
    uint64_t checksum; // of everything but this field
    uint64_t seed;
    uint64_t step_count, substep_count;
    double time;
    Pacing::Record pacing;
    float gravity[3];
    float wind[3];
    uint32_t next_key;
    uint32_t pair_count; // of BatchPairs, behind the colliders
};

struct BatchHeader {
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
static_assert(std::is_trivially_copyable_v<BatchHeader>);
static_assert(sizeof(Header) % 8 == 0 && sizeof(BatchHeader) % 8 == 0 && sizeof(BatchPairs::Pair) % 8 == 0);

// Over all words but the checksum's own. Each step is a bijection of the state: one changed word always changes the
// sum.
uint64_t checksum(const unsigned char* bytes, uint64_t size) {
    uint64_t sum = size;
    uint64_t word = 0;
    for (uint64_t i = 0; i + 8 <= size; i += 8) {
        if (i == offsetof(Header, checksum)) continue;
        std::memcpy(&word, bytes + i, 8);
        sum = (sum ^ word) * 0x9e3779b97f4a7c15ull;
        sum ^= sum >> 32;
    }
    return sum;
}

uint64_t even(uint64_t words) {
    return (words + 1) / 2 * 2;
} // 32-bit words, kept to 8 bytes

// Without the parts that only some batches have, which follow.
uint64_t batch_bytes(const BatchHeader& h) {
    const uint64_t bodies = (uint64_t{h.fields} + 1) * even(h.count) + 2 * uint64_t{h.count};
    return 4 * (bodies + 2 * even(h.capacity) + 2 * even(h.table_count));
}

} // namespace

// Reads and writes a batch's arrays in one order, given as visits of (pointer, words).
class SnapshotAccess {
public:
    static BatchHeader header(const lr_world::BatchSlot& slot) {
        BatchHeader h{};
        h.generation = slot.generation;
        h.body_generation = slot.body_generation;
        if (!slot.batch) return h;
        const Batch& b = *slot.batch;
        h.content_hash = b.asset().content_hash;
        h.capacity = b.capacity_;
        h.count = b.count_;
        h.first_generation = b.first_generation_;
        h.last_generation = b.last_generation_;
        h.free_first = b.free_first_;
        h.free_last = b.free_last_;
        h.fields = static_cast<uint32_t>(b.fields());
        h.table_count = static_cast<uint32_t>(b.table_.size() / 2);
        h.inverse_dt = b.step.table.inverse_dt;
        h.speed_alpha = b.step.body.speed_alpha;
        h.speed_beta = b.step.body.speed_beta;
        h.gains = b.settings_.gains;
        h.stationary = b.stationary_;
        h.aerodynamics = b.aerodynamics_;
        h.pace = b.pace.record();
        h.parts = parts_of(b);
        return h;
    }

    template <class Visit> static void visit(Batch& b, uint32_t count, Buffer<float>& table, Visit&& visit) {
        for (size_t f = 0; f < b.fields(); ++f) visit(b.arrays_.field[f], count);
        visit(b.arrays_.key, count);
        visit(b.ids_.data(), 2 * uint64_t{count});
        visit(b.dense_.data(), b.capacity_);
        visit(b.generations_.data(), b.capacity_);
        visit(table.data(), table.size() / 2);
        visit(table.data() + table.size() / 2, table.size() / 2);
    }
    static Buffer<float>& table(Batch& b) { return b.table_; }

    // The slots, ids and queue of a snapshot must describe one and the same set of bodies.
    static bool consistent(const BatchHeader& h, uint32_t batch_index, const unsigned char* body) {
        const auto word = [&](uint64_t at) {
            uint32_t w;
            std::memcpy(&w, body + 4 * at, 4);
            return w;
        };
        const uint64_t ids = (uint64_t{h.fields} + 1) * even(h.count), dense = ids + 2 * uint64_t{h.count};
        const uint64_t generations = dense + even(h.capacity), table = generations + even(h.capacity);
        if (h.free_first > h.capacity || h.free_last >= h.capacity) return false;
        for (uint32_t i = 0; i < h.count; ++i) {
            uint64_t id;
            std::memcpy(&id, body + 4 * (ids + 2 * uint64_t{i}), 8);
            const BodyHandle handle = unpack(id);
            if (handle.batch != batch_index || handle.slot >= h.capacity || handle.generation == 0 ||
                word(dense + handle.slot) != i || word(generations + handle.slot) != handle.generation)
                return false;
        }
        uint32_t used = 0;
        for (uint32_t s = 0; s < h.capacity; ++s) {
            if ((word(dense + s) & Batch::free_bit) == 0) ++used;
            const uint32_t generation = word(generations + s);
            if (generation == 0 || generation > max_generation) return false;
        }
        if (used != h.count || h.first_generation > max_generation || h.last_generation > max_generation) return false;
        // As many different slots as are free: from the first on none comes twice, or the last would not come last.
        uint32_t slot = h.free_first;
        for (uint32_t i = h.count; i < h.capacity; ++i) {
            if (slot >= h.capacity || (word(dense + slot) & Batch::free_bit) == 0) return false;
            if ((slot == h.free_last) != (i + 1 == h.capacity)) return false;
            slot = word(dense + slot) & ~Batch::free_bit;
        }
        for (uint64_t i = 0; i < 2 * even(h.table_count); ++i) {
            float v; // alpha or beta^2, or the padding after them
            std::memcpy(&v, body + 4 * (table + i), 4);
            if (!(v >= 0.0f) || !std::isfinite(v)) return false;
        }
        return states_consistent(body, even(h.count), h.fields, h.count);
    }

    static void restore(lr_world::BatchSlot& slot, const BatchHeader& h, const unsigned char* body,
                        Buffer<float>& new_table) {
        slot.generation = h.generation;
        slot.body_generation = h.body_generation;
        Batch& b = *slot.batch;
        for (uint32_t i = h.count; i < b.count_; ++i) b.clear_lane(i), b.ids_[i] = 0;
        b.count_ = h.count;
        b.first_generation_ = h.first_generation;
        b.last_generation_ = h.last_generation;
        b.free_first_ = h.free_first;
        b.free_last_ = h.free_last;
        if (new_table.size() != 0) b.table_.swap(new_table);
        visit(b, h.count, b.table_, [&](auto* to, uint64_t words) {
            if (words != 0) std::memcpy(to, body, static_cast<size_t>(4 * words));
            body += 4 * even(words);
        });
        b.step.table.alpha = b.table_.data();
        b.step.table.beta_squared = b.table_.data() + h.table_count;
        b.step.table.last = static_cast<float>(h.table_count - 1);
        b.step.table.inverse_dt = h.inverse_dt;
        b.step.body.speed_alpha = h.speed_alpha;
        b.step.body.speed_beta = h.speed_beta;
        b.stationary_ = h.stationary;
        b.pace.restore(h.pace);
        b.set_aerodynamics(h.aerodynamics, h.gains); // as it was when saved: it has been checked
    }
    static bool usable_loads(const BatchHeader& h, const Batch& b) {
        const Gains& g = h.gains;
        for (double v : {g.damping, g.noise, g.drag, g.lift, g.spin_drag, g.turbulence})
            if (!(v >= 0.0 && v <= 100.0)) return false;
        const TurbulenceSample& s = h.stationary;
        for (double v : {s.chi, s.epsilon, s.u0, s.l, s.c0})
            if (!(v >= 0.0 && v <= 1e12)) return false;
        if (s.u0 > 0.0 && !(s.l > 0.0)) return false;
        return is_usable(h.aerodynamics) && b.can_use(h.aerodynamics, g);
    }
};

uint64_t snapshot_size(const lr_world& w) {
    uint64_t size = sizeof(Header) + WindSnapshot::bytes(w.wind) + sizeof(Surface::Record) +
                    ColliderSnapshot::bytes(w.colliders) + sizeof(BatchPairs::Pair) * uint64_t{w.pairs.count()};
    for (uint32_t i = 0; i < w.batch_slots; ++i) {
        const BatchHeader h = SnapshotAccess::header(w.batches[i]);
        size += sizeof(BatchHeader);
        if (h.capacity != 0) size += batch_bytes(h) + parts_bytes(h.parts, h.count);
    }
    return size;
}

lr_status snapshot_save(const lr_world& w, void* memory, uint64_t size, uint64_t* written) {
    const uint64_t needed = snapshot_size(w);
    if (size < needed) return LR_ERROR_BUFFER_TOO_SMALL;
    auto* const begin = static_cast<unsigned char*>(memory);
    Header header{};
    header.magic = magic;
    header.version = version;
    header.batch_slots = w.batch_slots;
    header.size = needed;
    header.seed = w.seed;
    header.step_count = w.step_count;
    header.substep_count = w.substep_count;
    header.time = w.time;
    header.pacing = w.pacing.record();
    std::memcpy(header.gravity, w.gravity, sizeof header.gravity);
    std::memcpy(header.wind, w.wind.uniform.wind, sizeof header.wind);
    header.next_key = w.next_key;
    header.pair_count = w.pairs.count();
    std::memcpy(begin, &header, sizeof header);
    unsigned char* at = begin + sizeof header;
    WindSnapshot::save(w.wind, at);
    at += WindSnapshot::bytes(w.wind);
    const Surface::Record surface = w.surface.record();
    std::memcpy(at, &surface, sizeof surface);
    at += sizeof surface;
    ColliderSnapshot::save(w.colliders, at);
    at += ColliderSnapshot::bytes(w.colliders);
    w.pairs.visit([&](uint32_t low, uint32_t high) {
        const BatchPairs::Pair pair{low, high};
        std::memcpy(at, &pair, sizeof pair);
        at += sizeof pair;
    });
    for (uint32_t i = 0; i < w.batch_slots; ++i) {
        const BatchHeader h = SnapshotAccess::header(w.batches[i]);
        std::memcpy(at, &h, sizeof h);
        at += sizeof h;
        if (h.capacity == 0) continue;
        Batch& batch = *w.batches[i].batch;
        SnapshotAccess::visit(batch, h.count, SnapshotAccess::table(batch), [&](const auto* from, uint64_t words) {
            if (words != 0) std::memcpy(at, from, static_cast<size_t>(4 * words));
            std::memset(at + 4 * words, 0, static_cast<size_t>(4 * (even(words) - words)));
            at += 4 * even(words);
        });
        save_parts(batch, at);
        at += parts_bytes(h.parts, h.count);
    }
    header.checksum = checksum(begin, needed);
    std::memcpy(begin, &header, sizeof header);
    if (written) *written = needed;
    return LR_OK;
}

lr_status snapshot_restore(lr_world& w, const void* memory, uint64_t size) {
    const auto* const begin = static_cast<const unsigned char*>(memory);
    Header header{};
    if (size < sizeof header) return LR_ERROR_SNAPSHOT_FORMAT;
    std::memcpy(&header, begin, sizeof header);
    if (header.magic != magic || header.version != version || header.size > size || header.size < sizeof header ||
        header.size % 8 != 0)
        return LR_ERROR_SNAPSHOT_FORMAT;
    if (checksum(begin, header.size) != header.checksum) return LR_ERROR_SNAPSHOT_FORMAT;
    for (float v : header.gravity)
        if (!std::isfinite(v)) return LR_ERROR_SNAPSHOT_FORMAT;
    for (float v : header.wind)
        if (!std::isfinite(v)) return LR_ERROR_SNAPSHOT_FORMAT;
    if (!std::isfinite(header.time) || header.next_key == 0 || !Pacing::consistent(header.pacing))
        return LR_ERROR_SNAPSHOT_FORMAT;
    if (header.batch_slots != w.batch_slots) return LR_ERROR_SNAPSHOT_MISMATCH;

    // First pass: everything is checked, and tables of another length get their memory.
    Buffer<Buffer<float>> tables;
    if (!tables.allocate(w.allocator, w.batch_slots)) return LR_ERROR_OUT_OF_MEMORY;
    for (uint32_t i = 0; i < w.batch_slots; ++i) new (&tables[i]) Buffer<float>();
    WindSnapshot wind(w.wind);
    uint64_t wind_bytes = 0;
    Surface::Record surface{};
    ColliderSnapshot colliders(w.colliders);
    uint64_t collider_bytes = 0;
    BatchPairs pairs;
    const uint64_t pair_bytes = sizeof(BatchPairs::Pair) * uint64_t{header.pair_count};
    const auto check = [&]() -> lr_status {
        const lr_status windy = wind.read(begin + sizeof header, header.size - sizeof header, header.seed, wind_bytes);
        if (windy != LR_OK) return windy;
        uint64_t at = sizeof header + wind_bytes;
        if (header.size - at < sizeof surface) return LR_ERROR_SNAPSHOT_FORMAT;
        std::memcpy(static_cast<void*>(&surface), begin + at, sizeof surface);
        if (!Surface::consistent(surface)) return LR_ERROR_SNAPSHOT_FORMAT;
        at += sizeof surface;
        const lr_status solid = colliders.read(begin + at, header.size - at, collider_bytes);
        if (solid != LR_OK) return solid;
        at += collider_bytes;
        if (header.size - at < pair_bytes || !BatchPairs::consistent(begin + at, header.pair_count, header.batch_slots))
            return LR_ERROR_SNAPSHOT_FORMAT;
        if (!pairs.fill(w.allocator, begin + at, header.pair_count)) return LR_ERROR_OUT_OF_MEMORY;
        at += pair_bytes;
        for (uint32_t i = 0; i < w.batch_slots; ++i) {
            BatchHeader h{};
            if (header.size - at < sizeof h) return LR_ERROR_SNAPSHOT_FORMAT;
            std::memcpy(&h, begin + at, sizeof h);
            at += sizeof h;
            Batch* const batch = w.batches[i].batch;
            if ((h.capacity != 0) != (batch != nullptr)) return LR_ERROR_SNAPSHOT_MISMATCH;
            if (h.generation == 0 || h.generation > max_batch_generation || h.body_generation == 0 ||
                h.body_generation > max_generation || (!batch && pairs.meets(i)))
                return LR_ERROR_SNAPSHOT_FORMAT;
            if (!batch) continue;
            if (h.capacity != batch->capacity() || h.content_hash != batch->asset().content_hash)
                return LR_ERROR_SNAPSHOT_MISMATCH;
            if (h.fields != batch->fields()) return LR_ERROR_SNAPSHOT_MISMATCH;
            if (h.count > h.capacity || h.table_count == 0 || h.table_count > 65536 || !(h.inverse_dt > 0.0f) ||
                !std::isfinite(h.inverse_dt) || !std::isfinite(h.speed_alpha) || !std::isfinite(h.speed_beta) ||
                h.speed_alpha < 0.0f || h.speed_beta < 0.0f || (h.parts & ~all_parts) != 0 ||
                !SnapshotAccess::usable_loads(h, *batch) ||
                !Pace::consistent(h.pace, header.time, header.substep_count))
                return LR_ERROR_SNAPSHOT_FORMAT;
            const uint64_t bytes = batch_bytes(h);
            const uint64_t parts = parts_bytes(h.parts, h.count);
            if (header.size - at < bytes + parts || !SnapshotAccess::consistent(h, i, begin + at) ||
                !parts_consistent(h.parts, h.count, pairs.meets(i), begin + at + bytes))
                return LR_ERROR_SNAPSHOT_FORMAT;
            at += bytes + parts;
            if (h.table_count * 2ull != SnapshotAccess::table(*w.batches[i].batch).size() &&
                !tables[i].allocate(w.allocator, 2ull * h.table_count))
                return LR_ERROR_OUT_OF_MEMORY;
            if (!reserve_parts(*batch, h.parts)) return LR_ERROR_OUT_OF_MEMORY;
            if ((colliders.any() || pairs.meets(i)) && !batch->reserve_contact()) return LR_ERROR_OUT_OF_MEMORY;
        }
        return at == header.size ? LR_OK : LR_ERROR_SNAPSHOT_FORMAT;
    };
    const lr_status status = check();
    if (status == LR_OK) {
        const unsigned char* at = begin + sizeof header + wind_bytes + sizeof surface + collider_bytes + pair_bytes;
        wind.commit();
        colliders.commit();
        w.pairs.swap(pairs);
        w.surface.restore(surface);
        for (uint32_t i = 0; i < w.batch_slots; ++i) {
            BatchHeader h{};
            std::memcpy(&h, at, sizeof h);
            at += sizeof h;
            if (h.capacity == 0) {
                w.batches[i].generation = h.generation;
                w.batches[i].body_generation = h.body_generation;
                continue;
            }
            SnapshotAccess::restore(w.batches[i], h, at, tables[i]);
            at += batch_bytes(h);
            restore_parts(*w.batches[i].batch, h.parts, h.count, at);
            at += parts_bytes(h.parts, h.count);
        }
        w.seed = header.seed;
        w.step_count = header.step_count;
        w.substep_count = header.substep_count;
        w.pacing.restore(header.pacing);
        w.time = header.time;
        w.next_key = header.next_key;
        std::memcpy(w.gravity, header.gravity, sizeof header.gravity);
        std::memcpy(w.wind.uniform.wind, header.wind, sizeof header.wind);
        w.resume_contact_events();
    }
    for (uint32_t i = 0; i < w.batch_slots; ++i) tables[i].~Buffer<float>();
    return status;
}

} // namespace lr
