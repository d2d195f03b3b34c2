#include "base/bit_cast.h"
#include "kernel/body_constants.h"
#include "kernel/limits.h"
#include "world/snapshot/snapshot_format.h"
#include "world/world.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace lr {
namespace {

static_assert(std::endian::native == std::endian::little, "snapshots are little-endian, and are read where they lie");

SnapshotHeader header_of(const void* memory) {
    return value_at<SnapshotHeader>(static_cast<const unsigned char*>(memory), 0);
}

// Checksum against damage, not forgery, over 64-bit words with the seal as 0. Word i goes to sum i mod 8, so that no multiplication waits for the one
// before. Each step is a bijection of a sum, and so is combining sums: one changed word always changes the seal.
uint64_t seal_of(const unsigned char* bytes, uint64_t size) {
    constexpr uint64_t factor = 0x9e3779b97f4a7c15ull, block = 64;
    const auto take = [](uint64_t& sum, uint64_t word) {
        sum = (sum ^ word) * factor;
        sum ^= sum >> 32;
    };
    const auto word_at = [](const unsigned char* from) { return value_at<uint64_t>(from, 0); };
    // Separate variables stay in registers; compilers would vectorise an array.
    uint64_t a = 1 * factor, b = 2 * factor, c = 3 * factor, d = 4 * factor, e = 5 * factor, f = 6 * factor,
             g = 7 * factor, h = 8 * factor;
    const auto take_block = [&](const unsigned char* from) {
        take(a, word_at(from)), take(b, word_at(from + 8)), take(c, word_at(from + 16)), take(d, word_at(from + 24));
        take(e, word_at(from + 32)), take(f, word_at(from + 40)), take(g, word_at(from + 48));
        take(h, word_at(from + 56));
    };
    unsigned char part[block];
    std::memcpy(part, bytes, block);
    std::memset(part + offsetof(SnapshotHeader, seal), 0, 8);
    take_block(part);
    uint64_t at = block;
    for (; at + block <= size; at += block) take_block(bytes + at);
    if (at < size) {
        std::memset(part, 0, block);
        std::memcpy(part, bytes + at, static_cast<size_t>(size - at));
        take_block(part);
    }
    uint64_t all = size;
    for (const uint64_t sum : {a, b, c, d, e, f, g, h}) take(all, sum);
    return all;
}

// Writes the parts of a snapshot in order, or only counts their bytes.
class Writer {
public:
    explicit Writer(unsigned char* to) : begin_(to) {}
    template <class T> void record(const T& record) { bytes(&record, sizeof record); }
    void bytes(const void* from, uint64_t size) {
        const uint64_t padded = padded_bytes(size);
        if (begin_ && size != 0) {
            std::memset(begin_ + used_ + padded - 8, 0, 8);
            std::memcpy(begin_ + used_, from, static_cast<size_t>(size));
        }
        used_ += padded;
    }
    template <class Save> void part(uint64_t size, const Save& save) {
        if (begin_) save(begin_ + used_);
        used_ += size;
    }
    uint64_t used() const { return used_; }

private:
    unsigned char* begin_;
    uint64_t used_ = 0;
};

constexpr auto to_saved = [](auto& saved, const auto& live) {
    static_assert(sizeof saved == sizeof live);
    std::memcpy(&saved, &live, sizeof saved);
};
constexpr auto to_live = [](const auto& saved, auto& live) { to_saved(live, saved); };

// Calls move(saved, live) for the fields that a world and its header share.
template <class Header, class World, class Move> void move_world(Header& h, World& w, const Move& move) {
    move(h.seed, w.seed);
    move(h.step_count, w.step_count);
    move(h.substep_count, w.substep_count);
    move(h.time, w.time);
    move(h.gravity, w.gravity);
    move(h.wind, w.wind.uniform.wind);
    move(h.next_noise_seed, w.next_noise_seed);
}
template <class Header, class Slot, class Move> void move_slot(Header& h, Slot& slot, const Move& move) {
    move(h.generation, slot.generation);
    move(h.body_generation, slot.body_generation);
}

// Without branches, so that loops over columns vectorise.
bool bodies_consistent(const SavedBatch& s) {
    const SnapshotBatch& h = s.header;
    const auto number = [&](uint32_t column, uint32_t i) { return s.value<float>(column, i); };
    const auto wrong = [](bool good) { return good ? 0u : 1u; };
    uint32_t bad = 0;
    for (uint32_t c = 0; c < column_count; ++c) {
        const float low = body_columns[c].low, high = body_columns[c].high;
        if (piece_bytes(h, c) == 0 || (low == 0.0f && high == 0.0f)) continue;
        for (uint32_t i = 0; i < h.count; ++i) {
            const float v = number(c, i);
            bad |= wrong(v >= low) | wrong(v <= high);
        }
    }
    for (uint32_t i = 0; i < h.count; ++i) {
        const auto square = [&](uint32_t f) { return number(f, i) * number(f, i); };
        const float turn = square(field_qx) + square(field_qy) + square(field_qz) + square(field_qw);
        // The remainder must be below the age's last digit, or be the mark of a held body.
        const float age = number(field_age, i), remainder = number(field_age_remainder, i);
        bad |= wrong(turn >= shortest_turn) | wrong(turn <= longest_turn);
        bad |= wrong(std::abs(remainder) <= 0x1p-23f * age) & wrong(remainder == held_mark) &
               wrong(remainder == diverged_mark);
    }
    for (uint32_t i = h.awake; i < h.count; ++i)
        bad |= wrong(SleepingBodies::consistent(h.sleep, s.value<double>(column_birth, i)));
    return bad == 0;
}

// Slots may be those of destroyed colliders. has_body_contact: touching_body is allowed.
bool touched_consistent(const SavedBatch& s, bool has_body_contact) {
    if (piece_bytes(s.header, column_touching) == 0) return true;
    const uint32_t most = has_body_contact ? 1 : 0;
    uint32_t bad = 0;
    static_assert(most_touches == 4);
    for (uint32_t i = 0; i < s.header.count; ++i) {
        const auto is_body = [&](uint32_t k) { return s.value(column_touching + k, i) == touching_body ? 1u : 0u; };
        bad |= is_body(0) + is_body(1) + is_body(2) + is_body(3) > most ? 1u : 0u;
    }
    return bad == 0;
}

// Slots, ids and queue must describe the same set of bodies.
bool slots_consistent(const SavedBatch& s, uint32_t batch_index) {
    const SnapshotBatch& h = s.header;
    const auto dense = [&](uint32_t slot) { return s.value(piece_dense, slot); };
    const auto generation = [&](uint32_t slot) { return s.value(piece_generations, slot); };
    if (h.free_first > h.capacity || h.free_last >= h.capacity) return false;
    for (uint32_t i = 0; i < h.count; ++i) {
        const BodyHandle handle = unpack(s.value<lr_body>(column_ids, i));
        if (handle.batch != batch_index || handle.slot >= h.capacity || handle.generation == 0 ||
            dense(handle.slot) != i || generation(handle.slot) != handle.generation)
            return false;
    }
    uint32_t used = 0, bad = 0;
    static_assert(Batch::free_bit == 1u << 31);
    for (uint32_t slot = 0; slot < h.capacity; ++slot) {
        used += 1 - (dense(slot) >> 31);
        bad |= generation(slot) - 1 >= max_generation ? 1u : 0u;
    }
    if (bad != 0 || used != h.count || h.first_generation > max_generation || h.last_generation > max_generation)
        return false;
    // A free slot has this bit, so toggling gives the next slot; a dense index becomes an invalid slot.
    const auto next = [&](uint32_t slot) { return dense(slot) ^ Batch::free_bit; };
    return make_chain(h.free_first, h.free_last, h.capacity - h.count, h.capacity, next) &&
           (h.count == h.capacity || (dense(h.free_last) & Batch::free_bit) != 0);
}

bool table_consistent(const SavedBatch& s) {
    const TableHead& t = s.header.table;
    if (t.count == 0) return same(t, TableHead{});
    if (wrong_in(t)) return false;
    for (uint32_t i = 0; i < t.count; ++i)
        if (wrong_in(t.sample(s.value<float>(piece_chi, i), s.value<float>(piece_epsilon, i)))) return false;
    return true;
}
} // namespace

class SnapshotAccess {
public:
    static void save(const lr_world::BatchSlot& slot, const Colliders& colliders, Writer& to) {
        const SnapshotBatch h = header(slot, colliders);
        to.record(h);
        for (uint32_t piece = 0; piece < batch_pieces && slot.batch; ++piece)
            to.bytes(live(*slot.batch, piece), piece_bytes(h, piece));
    }

    // Checks everything and allocates memory, without visible changes.
    static lr_status check(const SavedBatch& s, uint64_t left, uint32_t index, Batch* batch,
                           const SnapshotHeader& world, bool has_body_contact, bool contact) {
        const SnapshotBatch& h = s.header;
        if ((h.capacity != 0) != (batch != nullptr)) return LR_ERROR_SNAPSHOT_MISMATCH;
        if (h.generation == 0 || h.generation > max_batch_generation || h.body_generation == 0 ||
            h.body_generation > max_generation || (!batch && has_body_contact) || h.parts >> column_parts != 0)
            return LR_ERROR_SNAPSHOT_FORMAT;
        if (!batch) return LR_OK;
        const auto has = [&](ColumnPart part) { return (h.parts >> part & 1u) != 0; };
        if (h.capacity != batch->capacity() || h.content_hash != batch->asset().content_hash || !has(part_body) ||
            has(part_gust) != batch->columns_.has(part_gust))
            return LR_ERROR_SNAPSHOT_MISMATCH;
        if (h.count > h.capacity || h.awake > h.count || (h.awake < h.count) != has(part_sleep) ||
            h.table.count > 65536 || !ContactEvents::consistent(h.events) || !usable_loads(h, *batch) ||
            !BatchClock::consistent(h.pace, world.time, world.substep_count) || wrong_in(h.options) ||
            !SleepingBodies::consistent(h.sleep) || !Lifecycle::consistent(h.lifecycle) || wrong_batch_force(h.force) ||
            h.contact.struct_size != sizeof h.contact || wrong_in(h.contact) || left < s.bytes() ||
            !slots_consistent(s, index) || !table_consistent(s) || !bodies_consistent(s) ||
            !touched_consistent(s, has_body_contact))
            return LR_ERROR_SNAPSHOT_FORMAT;
        // If divergence can end bodies, their records need room.
        const bool ends = has(part_life) || h.options.divergence_policy != LR_DIVERGENCE_AUTO || h.diverged != 0;
        batch->next_table_.reset();
        const bool room = (!has(part_user) || batch->reserve_users()) &&
                          (!has(part_forces) || batch->reserve_forces()) && (!ends || batch->reserve_lifecycle()) &&
                          (!has(part_sleep) || batch->reserve_sleep()) &&
                          (!(has(part_contact) || contact || has_body_contact) || batch->reserve_contact()) &&
                          (same_table(s, *batch) || read_table(s, *batch));
        return room ? LR_OK : LR_ERROR_OUT_OF_MEMORY;
    }

    static void restore(Batch& b, const SavedBatch& s, const Colliders& colliders) {
        const SnapshotBatch& h = s.header;
        const uint32_t before = b.count_, parts_before = parts_of(b);
        forget_other_boxes(b, s);
        move_batch(h, b, to_live);
        ++b.revision_;
        b.oldest_ = wide(most_age);
        b.columns_.clear(h.count, before);
        for (uint32_t piece = 0; piece < piece_chi; ++piece) {
            const uint64_t bytes = piece_bytes(h, piece);
            if (bytes != 0)
                std::memcpy(live(b, piece), s.at(piece), static_cast<size_t>(bytes));
            else if (!body_columns[piece].saved || (parts_before >> body_columns[piece].part & 1u) != 0)
                b.columns_.clear(0, h.count, piece, 1);
        }
        std::fill_n(b.cut_noted_.data(), b.cut_noted_.size(), uint8_t{0});
        b.pace.restore(h.pace);
        const bool other_table = b.next_table_.size() != 0;
        if (other_table || !same_loads(h, b)) {
            b.aerodynamics_ = h.aerodynamics;
            b.settings_.gains = h.gains;
            const TableHead head = !other_table ? b.table_head_ : h.table.count == 0 ? b.asset_table() : h.table;
            // Cannot fail after check().
            b.use_table(other_table ? b.next_table_ : b.table_, head, h.table.count == 0);
            b.next_table_.reset();
        }
        b.external.set_batch(h.force);
        b.external.restored((h.parts >> part_forces & 1u) != 0);
        b.set_contact(h.contact);
        b.faults.noted = 1; // bodies may have diverged since the last step
        b.faults.last = 0;
        if (b.lifecycle_) b.lifecycle_->restore(h.lifecycle);
        if (b.events() && h.events != 0)
            b.events()->resume(h.events, s.at(piece_noted), s.at(piece_held));
        else if (b.events()) // the snapshot has contacts, but no events
            b.events()->resume(b, colliders);
        b.columns_.clear(b.awake_, b.count_, field_vx, 6);
        b.columns_.clear(b.awake_, b.count_, column_force, force_components);
        if (!b.sleeping_) return;
        b.sleeping_->clear();
        for (uint32_t i = b.awake_; i < b.count_; ++i) b.lie_down(i);
        b.sleeping_->restore(h.sleep);
    }

private:
    // Calls move(saved, live) for the fields that a batch and its header share.
    template <class Header, class Move> static void move_batch(Header& h, auto& b, const Move& move) {
        move(h.count, b.count_);
        move(h.awake, b.awake_);
        move(h.first_generation, b.first_generation_);
        move(h.last_generation, b.last_generation_);
        move(h.free_first, b.free_first_);
        move(h.free_last, b.free_last_);
        move(h.options, b.options);
        move(h.diverged, b.faults.total);
    }
    static SnapshotBatch header(const lr_world::BatchSlot& slot, const Colliders& colliders) {
        SnapshotBatch h{};
        move_slot(h, slot, to_saved);
        if (!slot.batch) return h;
        const Batch& b = *slot.batch;
        move_batch(h, b, to_saved);
        h.content_hash = b.asset().content_hash;
        h.capacity = b.capacity_;
        h.table = saved_head(b);
        h.parts = parts_of(b);
        h.gains = b.settings_.gains;
        h.aerodynamics = b.aerodynamics_;
        h.pace = b.pace.record();
        if (b.awake_ < b.count_) h.sleep = b.sleeping_->state();
        h.contact = b.contact();
        if (b.events()) h.events = b.events()->pending(b, colliders);
        to_saved(h.force, b.external.batch());
        if (b.lifecycle_) h.lifecycle = b.lifecycle_->state();
        return h;
    }
    // Parts in use; all columns of the others are 0.
    static uint32_t parts_of(const Batch& b) {
        const auto bit = [](ColumnPart part, bool there) { return there ? 1u << part : 0u; };
        return bit(part_body, true) | bit(part_gust, b.columns_.has(part_gust)) | bit(part_sleep, b.awake_ < b.count_) |
               bit(part_life, b.lifecycle_ && b.lifecycle_->in_use()) | bit(part_forces, b.external.pending()) |
               bit(part_contact, b.any_contact()) | bit(part_user, b.columns_.any(column_user, b.count_));
    }
    static void* live(Batch& b, uint32_t piece) {
        if (piece < piece_dense) return b.columns_.bytes(piece);
        if (piece == piece_dense) return b.dense_.data();
        if (piece == piece_generations) return b.generations_.data();
        if (piece >= piece_noted)
            return !b.events() ? nullptr : piece == piece_noted ? b.events()->noted() : b.events()->held();
        return b.table_.data() + (piece == piece_chi ? 0 : b.table_head_.count);
    }
    // Boxes of sleeping bodies in the same place stay, since recomputing would give the same.
    static void forget_other_boxes(Batch& b, const SavedBatch& s) {
        for (uint32_t i = b.awake_; i < b.count_; ++i) {
            const uint32_t slot = unpack(b.ids()[i]).slot, to = s.value(piece_dense, slot);
            uint32_t other = to >= s.header.awake && to < s.header.count ? 0 : 1;
            if (other == 0)
                for (size_t f : {field_x, field_y, field_z, field_qx, field_qy, field_qz, field_qw, field_scale})
                    other |= s.value(f, to) ^ bit_cast<uint32_t>(b.arrays_.field[f][i]);
            if (other != 0) b.sleeping_->forget_box(slot);
        }
    }
    static TableHead saved_head(const Batch& b) { return b.asset_table_ ? TableHead{} : b.table_head_; }
    static bool same_table(const SavedBatch& s, const Batch& b) {
        const size_t bytes = sizeof(float) * s.header.table.count;
        return same(s.header.table, saved_head(b)) && std::memcmp(s.at(piece_chi), b.table_chi(), bytes) == 0 &&
               std::memcmp(s.at(piece_epsilon), b.table_epsilon(), bytes) == 0;
    }
    static bool read_table(const SavedBatch& s, Batch& b) {
        const TableHead& head = s.header.table;
        return head.count == 0 ? b.copy_table(b.asset_table(), nullptr, nullptr, b.next_table_)
                               : b.copy_table(head, s.at(piece_chi), s.at(piece_epsilon), b.next_table_);
    }
    static bool same_loads(const SnapshotBatch& h, const Batch& b) {
        return same(h.gains, b.settings_.gains) && same(h.aerodynamics, b.aerodynamics_);
    }
    static bool usable_loads(const SnapshotBatch& h, const Batch& b) {
        if (same_loads(h, b)) return true;
        const bool own = same(h.aerodynamics, b.asset().data.aerodynamics);
        BodyConstants ignored;
        return !wrong_in(h.gains) && (own || !wrong_in(h.aerodynamics)) &&
               b.make_loads(h.aerodynamics, h.gains, ignored);
    }
};

namespace {

void write(const lr_world& w, const SnapshotHeader& header, Writer& to) {
    to.record(header);
    to.part(WindSnapshot::bytes(header.wind_field), [&](unsigned char* at) { WindSnapshot::save(w.wind, at); });
    to.part(ColliderSnapshot::bytes(header.colliders),
            [&](unsigned char* at) { ColliderSnapshot::save(w.colliders, at); });
    to.bytes(w.pairs.links(), sizeof(uint32_t) * uint64_t{w.pairs.link_count()});
    to.bytes(w.pair_cache.pairs(), sizeof(CachedPair) * uint64_t{w.pair_cache.count()});
    for (uint32_t i = 0; i < w.batch_slots; ++i) SnapshotAccess::save(w.batches[i], w.colliders, to);
}
} // namespace

uint64_t snapshot_size(const lr_world& w) {
    SnapshotHeader header{};
    header.wind_field = WindSnapshot::head(w.wind);
    header.colliders = ColliderSnapshot::head(w.colliders);
    Writer counted(nullptr);
    write(w, header, counted);
    return counted.used();
}

lr_status snapshot_save(const lr_world& w, void* memory, uint64_t size, uint64_t* written) {
    SnapshotHeader header{};
    header.size = snapshot_size(w);
    if (size < header.size) return LR_ERROR_BUFFER_TOO_SMALL;
    header.magic = snapshot_magic;
    header.version = snapshot_version;
    header.batch_slots = w.batch_slots;
    header.pacing = w.pacing.record();
    header.link_count = w.pairs.link_count();
    header.cached_pair_count = w.pair_cache.count();
    header.wind_field = WindSnapshot::head(w.wind);
    header.colliders = ColliderSnapshot::head(w.colliders);
    header.surface = w.surface.record();
    move_world(header, w, to_saved);
    auto* const begin = static_cast<unsigned char*>(memory);
    Writer to(begin);
    write(w, header, to);
    header.seal = seal_of(begin, header.size);
    std::memcpy(begin, &header, sizeof header);
    if (written) *written = header.size;
    return LR_OK;
}

bool snapshot_is_whole(const void* memory, uint64_t size) {
    const auto* const bytes = static_cast<const unsigned char*>(memory);
    // Stops early if this is no snapshot.
    if (size < sizeof(SnapshotHeader) || value_at<decltype(SnapshotHeader::magic)>(bytes, 0) != snapshot_magic)
        return false;
    const auto header = header_of(memory);
    return header.version == snapshot_version && header.size <= size && header.size >= sizeof header &&
           header.size % 8 == 0 && seal_of(bytes, header.size) == header.seal;
}

uint64_t snapshot_bytes(const void* memory) {
    return header_of(memory).size;
}

lr_status snapshot_restore(lr_world& w, const void* memory) {
    const auto* const begin = static_cast<const unsigned char*>(memory);
    const SnapshotHeader header = header_of(memory);
    if (wrong_gravity(header.gravity) || wrong_wind(header.wind) || !in_range(header.time, 0.0, most_time) ||
        header.next_noise_seed == 0 || !StepScheduler::consistent(header.pacing) || !Water::consistent(header.surface))
        return LR_ERROR_SNAPSHOT_FORMAT;
    if (header.batch_slots != w.batch_slots) return LR_ERROR_SNAPSHOT_MISMATCH;

    // Checks all before it changes anything.
    uint64_t at = sizeof header;
    const auto left = [&] { return header.size - at; };
    WindSnapshot wind(w.wind, w.seed);
    lr_status status = wind.read(header.wind_field, begin + at, left(), header.time, header.seed);
    if (status != LR_OK) return status;
    at += WindSnapshot::bytes(header.wind_field);
    ColliderSnapshot colliders(w.colliders);
    status = colliders.read(header.colliders, begin + at, left());
    if (status != LR_OK) return status;
    at += ColliderSnapshot::bytes(header.colliders);
    const uint64_t pair_bytes = padded_bytes(sizeof(uint32_t) * uint64_t{header.link_count});
    if (left() < pair_bytes) return LR_ERROR_SNAPSHOT_FORMAT;
    BatchPairs new_pairs;
    const bool same_pairs = w.pairs.equal(begin + at, header.link_count);
    if (!same_pairs) {
        if (!new_pairs.fill(w.allocator, begin + at, header.link_count)) return LR_ERROR_OUT_OF_MEMORY;
        if (!new_pairs.consistent(header.batch_slots)) return LR_ERROR_SNAPSHOT_FORMAT;
    }
    const BatchPairs& pairs = same_pairs ? w.pairs : new_pairs;
    if (!w.reserve_scratch() || !w.reserve_left([&](uint32_t slot) { return pairs.has_contact(slot); }))
        return LR_ERROR_OUT_OF_MEMORY;
    at += pair_bytes;
    const unsigned char* const cached_pairs = begin + at;
    const auto cached_count = static_cast<uint32_t>(header.cached_pair_count);
    if (header.cached_pair_count > left() / sizeof(CachedPair) || cached_count != header.cached_pair_count ||
        !PairCache::consistent(cached_pairs, cached_count, header.batch_slots))
        return LR_ERROR_SNAPSHOT_FORMAT;
    if (!w.pair_cache.reserve(w.allocator, cached_count)) return LR_ERROR_OUT_OF_MEMORY;
    at += sizeof(CachedPair) * header.cached_pair_count;
    const uint64_t batches = at;
    for (uint32_t i = 0; i < w.batch_slots; ++i) {
        if (left() < sizeof(SnapshotBatch)) return LR_ERROR_SNAPSHOT_FORMAT;
        const SavedBatch saved(begin + at);
        status =
            SnapshotAccess::check(saved, left(), i, w.batches[i].batch, header, pairs.has_contact(i), colliders.any());
        if (status != LR_OK) return status;
        at += saved.bytes();
    }
    if (left() != 0) return LR_ERROR_SNAPSHOT_FORMAT;

    wind.commit();
    colliders.commit();
    if (!same_pairs) w.pairs.swap(new_pairs);
    w.pair_cache.fill(cached_pairs, cached_count);
    w.surface.restore(header.surface);
    at = batches;
    for (uint32_t i = 0; i < w.batch_slots; ++i) {
        const SavedBatch saved(begin + at);
        move_slot(saved.header, w.batches[i], to_live);
        if (w.batches[i].batch) SnapshotAccess::restore(*w.batches[i].batch, saved, w.colliders);
        at += saved.bytes();
    }
    move_world(header, w, to_live);
    w.pacing.restore(header.pacing);
    w.events.begin_step();
    return LR_OK;
}
} // namespace lr
