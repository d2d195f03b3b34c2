#include "world/snapshot.h"

#include "contact/collider_snapshot.h"
#include "field/wind_snapshot.h"
#include "kernel/aerodynamics.h"
#include "kernel/limits.h"
#include "world/snapshot_format.h"
#include "world/snapshot_parts.h"
#include "world/world.h"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <new>

namespace lr {
namespace {

static_assert(sizeof(BatchPairs::Pair) % 8 == 0);

uint64_t even(uint64_t words) {
    return even_words(words);
}

uint32_t word_at(const unsigned char* from, uint64_t index) {
    uint32_t word;
    std::memcpy(&word, from + 4 * index, 4);
    return word;
}

SnapshotHeader header_of(const void* memory) {
    SnapshotHeader header;
    std::memcpy(&header, memory, sizeof header);
    return header;
}

} // namespace

// Reads and writes a batch's arrays in one order, given as visits of (pointer, words).
class SnapshotAccess {
public:
    static SnapshotBatch header(const lr_world::BatchSlot& slot) {
        SnapshotBatch h{};
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
    static bool consistent(const SnapshotBatch& h, const Batch& batch, uint32_t batch_index,
                           const unsigned char* body) {
        const unsigned char* const ids = body + 4 * (uint64_t{h.fields} + 1) * even(h.count);
        const unsigned char* const dense = ids + 8 * uint64_t{h.count};
        const unsigned char* const generations = dense + 4 * even(h.capacity);
        const unsigned char* const table = generations + 4 * even(h.capacity);
        if (h.free_first > h.capacity || h.free_last >= h.capacity) return false;
        for (uint32_t i = 0; i < h.count; ++i) {
            uint64_t id;
            std::memcpy(&id, ids + 8 * uint64_t{i}, 8);
            const BodyHandle handle = unpack(id);
            if (handle.batch != batch_index || handle.slot >= h.capacity || handle.generation == 0 ||
                word_at(dense, handle.slot) != i || word_at(generations, handle.slot) != handle.generation)
                return false;
        }
        // Loops over all words, without branches: in vectors.
        uint32_t used = 0, bad = 0;
        for (uint32_t s = 0; s < h.capacity; ++s) {
            used += 1 - (word_at(dense, s) >> 31);
            bad |= word_at(generations, s) - 1 >= max_generation ? 1u : 0u;
        }
        static_assert(Batch::free_bit == 1u << 31);
        if (bad != 0 || used != h.count || h.first_generation > max_generation || h.last_generation > max_generation)
            return false;
        // As many different slots as are free: from the first on none comes twice, or the last would not come last.
        uint32_t slot = h.free_first;
        for (uint32_t i = h.count; i < h.capacity; ++i) {
            if (slot >= h.capacity || (word_at(dense, slot) & Batch::free_bit) == 0) return false;
            if ((slot == h.free_last) != (i + 1 == h.capacity)) return false;
            slot = word_at(dense, slot) & ~Batch::free_bit;
        }
        return bad == 0 && usable_table(h, batch, table) && states_consistent(body, even(h.count), h.fields, h.count);
    }

    // No stronger than what can be asked for, by the asset or by whoever sets a table. Same operations, same order: no rounding between.
    static bool usable_table(const SnapshotBatch& h, const Batch& batch, const unsigned char* table) {
        double least = 0.0, most = 0.0;
        const TurbulenceSample strongest = batch.strongest_turbulence(h.stationary, least, most);
        BodyConstants speed{};
        speed.length = batch.step.body.length;
        set_speed_turbulence(strongest, h.gains, speed);
        const auto alpha = static_cast<float>(langevin_alpha(strongest.chi, strongest.c0, h.gains)),
                   beta = static_cast<float>(langevin_beta_squared(strongest.epsilon, strongest.c0, h.gains));
        uint32_t bad = 0;
        for (uint64_t i = 0; i < 2 * even(h.table_count); ++i) { // alpha or beta^2, or the padding after them
            const float v = std::bit_cast<float>(word_at(table, i));
            bad |= v >= 0.0f && v <= (i < even(h.table_count) ? alpha : beta) ? 0u : 1u;
        }
        return bad == 0 && in_range(h.inverse_dt, least, most) &&
               in_range(h.speed_alpha, 0.0, static_cast<double>(speed.speed_alpha)) &&
               in_range(h.speed_beta, 0.0, static_cast<double>(speed.speed_beta));
    }

    static void restore(lr_world::BatchSlot& slot, const SnapshotBatch& h, const unsigned char* body,
                        Buffer<float>* new_table) {
        slot.generation = h.generation;
        slot.body_generation = h.body_generation;
        Batch& b = *slot.batch;
        const uint32_t before = b.count_;
        const unsigned char* const parts = body + columns_bytes(h);
        forget_other_boxes(b, h, body, rest_begin(h.parts, h.count, parts));
        b.clear_lanes(h.count, before);
        for (uint32_t i = h.count; i < before; ++i) b.ids_[i] = 0;
        b.count_ = h.count;
        b.oldest_ = static_cast<double>(most_age);
        b.first_generation_ = h.first_generation;
        b.last_generation_ = h.last_generation;
        b.free_first_ = h.free_first;
        b.free_last_ = h.free_last;
        if (new_table && new_table->size() != 0) b.table_.swap(*new_table);
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
        b.pace.restore(h.pace);
        if (!same_loads(h, b)) {
            b.stationary_ = h.stationary;
            b.set_aerodynamics(h.aerodynamics, h.gains); // as it was when saved: it has been checked
        }
        restore_parts(b, h.parts, h.count, before, parts);
    }
    // Bodies at rest keep their boxes where they lie in the same place: made anew they would be the same. rest_begin: index of the
    // first that will be at rest.
    static void forget_other_boxes(Batch& b, const SnapshotBatch& h, const unsigned char* body, uint32_t rest_begin) {
        if (!b.resting_) return;
        const unsigned char* const dense =
            body + 4 * (even(h.count) * (h.fields + uint64_t{1}) + 2 * uint64_t{h.count});
        for (uint32_t i = b.awake_; i < b.count_; ++i) {
            const uint32_t slot = unpack(b.ids_[i]).slot, to = word_at(dense, slot);
            uint32_t other = to >= rest_begin && to < h.count ? 0 : 1;
            if (other == 0)
                for (size_t f : {field_x, field_y, field_z, field_qx, field_qy, field_qz, field_qw, field_scale})
                    other |= word_at(body, f * even(h.count) + to) ^ std::bit_cast<uint32_t>(b.arrays_.field[f][i]);
            if (other != 0) b.resting_->forget_box(slot);
        }
    }
    // Bit for bit: what differs in nothing but a zero's sign is only made anew.
    template <class T> static bool same(const T& x, const T& y) {
        return std::memcmp(&x, &y, sizeof x) == 0; // NOLINT(bugprone-suspicious-memory-comparison)
    }
    static bool same_loads(const SnapshotBatch& h, const Batch& b) {
        return same(h.gains, b.settings_.gains) && same(h.stationary, b.stationary_) &&
               same(h.aerodynamics, b.aerodynamics_);
    }
    static bool usable_loads(const SnapshotBatch& h, const Batch& b) {
        if (same_loads(h, b)) return true;
        // Without a table of its own there is no stationary sample.
        if (h.stationary.u0 != 0.0 ? wrong_in(h.stationary) != nullptr : !same(h.stationary, TurbulenceSample{}))
            return false;
        const bool own = same(h.aerodynamics, b.asset().data.aerodynamics);
        return !wrong_in(h.gains) && (own || !wrong_in(h.aerodynamics)) && b.can_use(h.aerodynamics, h.gains);
    }
    static uint64_t bytes(const SnapshotBatch& h) {
        return sizeof h + (h.capacity != 0 ? columns_bytes(h) + parts_bytes(h.parts, h.count) : 0);
    }
};

uint64_t snapshot_size(const lr_world& w) {
    uint64_t size = sizeof(SnapshotHeader) + WindSnapshot::bytes(w.wind) + sizeof(Surface::Record) +
                    ColliderSnapshot::bytes(w.colliders) + sizeof(BatchPairs::Pair) * uint64_t{w.pairs.count()};
    for (uint32_t i = 0; i < w.batch_slots; ++i) size += SnapshotAccess::bytes(SnapshotAccess::header(w.batches[i]));
    return size;
}

lr_status snapshot_save(const lr_world& w, void* memory, uint64_t size, uint64_t* written) {
    const uint64_t needed = snapshot_size(w);
    if (size < needed) return LR_ERROR_BUFFER_TOO_SMALL;
    auto* const begin = static_cast<unsigned char*>(memory);
    SnapshotHeader header{};
    header.magic = snapshot_magic;
    header.version = snapshot_version;
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
        const SnapshotBatch h = SnapshotAccess::header(w.batches[i]);
        std::memcpy(at, &h, sizeof h);
        at += sizeof h;
        if (h.capacity == 0) continue;
        Batch& batch = *w.batches[i].batch;
        SnapshotAccess::visit(batch, h.count, SnapshotAccess::table(batch), [&](const auto* from, uint64_t words) {
            if (words != 0) std::memcpy(at, from, static_cast<size_t>(4 * words));
            std::memset(at + 4 * words, 0, static_cast<size_t>(4 * (even(words) - words)));
            at += 4 * even(words);
        });
        save_parts(batch, h.parts, at);
        at += parts_bytes(h.parts, h.count);
    }
    header.seal = seal_of(begin, needed);
    std::memcpy(begin, &header, sizeof header);
    if (written) *written = needed;
    return LR_OK;
}

bool snapshot_is_whole(const void* memory, uint64_t size) {
    if (size < sizeof(SnapshotHeader)) return false;
    const auto header = header_of(memory);
    return header.magic == snapshot_magic && header.version == snapshot_version && header.size <= size &&
           header.size >= sizeof header && header.size % 8 == 0 &&
           seal_of(static_cast<const unsigned char*>(memory), header.size) == header.seal;
}

uint64_t snapshot_bytes(const void* memory) {
    return header_of(memory).size;
}

lr_status snapshot_restore(lr_world& w, const void* memory) {
    const auto* const begin = static_cast<const unsigned char*>(memory);
    const SnapshotHeader header = header_of(memory);
    if (wrong_gravity(header.gravity) || wrong_wind(header.wind) || !in_range(header.time, 0.0, most_time) ||
        header.next_key == 0 || !Pacing::consistent(header.pacing))
        return LR_ERROR_SNAPSHOT_FORMAT;
    if (header.batch_slots != w.batch_slots) return LR_ERROR_SNAPSHOT_MISMATCH;

    // First pass: everything is checked, and tables of another length get their memory.
    Buffer<Buffer<float>> tables;
    const auto new_table = [&](uint32_t batch, uint64_t floats) {
        if (tables.size() == 0) {
            if (!tables.allocate(w.allocator, w.batch_slots)) return false;
            for (uint32_t i = 0; i < w.batch_slots; ++i) new (&tables[i]) Buffer<float>();
        }
        return tables[batch].allocate(w.allocator, floats);
    };
    WindSnapshot wind(w.wind, w.seed);
    uint64_t wind_bytes = 0;
    Surface::Record surface{};
    ColliderSnapshot colliders(w.colliders);
    uint64_t collider_bytes = 0;
    BatchPairs new_pairs;
    bool same_pairs = false;
    const uint64_t pair_bytes = sizeof(BatchPairs::Pair) * uint64_t{header.pair_count};
    const auto check = [&]() -> lr_status {
        const lr_status windy =
            wind.read(begin + sizeof header, header.size - sizeof header, header.time, header.seed, wind_bytes);
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
        same_pairs = w.pairs.equal(begin + at, header.pair_count);
        if (!same_pairs && !new_pairs.fill(w.allocator, begin + at, header.pair_count)) return LR_ERROR_OUT_OF_MEMORY;
        const BatchPairs& pairs = same_pairs ? w.pairs : new_pairs;
        if (!w.reserve_left([&](uint32_t slot) { return pairs.meets(slot); })) return LR_ERROR_OUT_OF_MEMORY;
        at += pair_bytes;
        for (uint32_t i = 0; i < w.batch_slots; ++i) {
            SnapshotBatch h{};
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
            if (h.count > h.capacity || h.table_count == 0 || h.table_count > 65536 || (h.parts & ~all_parts) != 0 ||
                !SnapshotAccess::usable_loads(h, *batch) ||
                !Pace::consistent(h.pace, header.time, header.substep_count))
                return LR_ERROR_SNAPSHOT_FORMAT;
            const uint64_t bytes = columns_bytes(h);
            const uint64_t parts = parts_bytes(h.parts, h.count);
            if (header.size - at < bytes + parts || !SnapshotAccess::consistent(h, *batch, i, begin + at) ||
                !parts_consistent(h.parts, h.count, pairs.meets(i), begin + at + bytes))
                return LR_ERROR_SNAPSHOT_FORMAT;
            at += bytes + parts;
            if (h.table_count * 2ull != SnapshotAccess::table(*w.batches[i].batch).size() &&
                !new_table(i, 2ull * h.table_count))
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
        if (!same_pairs) w.pairs.swap(new_pairs);
        w.surface.restore(surface);
        for (uint32_t i = 0; i < w.batch_slots; ++i) {
            SnapshotBatch h{};
            std::memcpy(&h, at, sizeof h);
            at += sizeof h;
            if (h.capacity == 0) {
                w.batches[i].generation = h.generation;
                w.batches[i].body_generation = h.body_generation;
                continue;
            }
            SnapshotAccess::restore(w.batches[i], h, at, tables.size() != 0 ? &tables[i] : nullptr);
            at += columns_bytes(h) + parts_bytes(h.parts, h.count);
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
    for (size_t i = 0; i < tables.size(); ++i) tables[i].~Buffer<float>();
    return status;
}

} // namespace lr
