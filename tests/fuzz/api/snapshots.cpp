// Snapshots: into the same world, into others, into a second one with the same history; and invalid bytes.
#include "fuzz/api/model.h"

#include "support/reseal_snapshot.h"

namespace fuzz {
namespace {

int32_t last_target() {
    int32_t targets[LR_SIMD_PLAIN] = {};
    uint32_t count = 0;
    lr_simd_targets(targets, LR_SIMD_PLAIN, &count);
    return count > 0 ? targets[count - 1] : LR_SIMD_AUTO;
}

std::vector<unsigned char> save_bytes(const World& w) {
    std::vector<unsigned char> bytes(LR_CALL(lr_world_snapshot_size)(w.at));
    uint64_t written = 0;
    if (LR_CALL(lr_world_snapshot_save)(w.at, bytes.data(), bytes.size(), &written) != LR_OK || written != bytes.size())
        defect("lr_world_snapshot_save", "failed");
    return bytes;
}

void save(Fuzzer& f) {
    World& w = f.world();
    Input& in = f.in;
    const uint64_t size = LR_CALL(lr_world_snapshot_size)(w.at);
    if ((size != 0) != (w.at != nullptr))
        defect("lr_world_snapshot_size", "of no world, or none", static_cast<int64_t>(size));
    const uint64_t room = in.flag(flag_size) && size != 0 ? size - 1 - in.handle(0) % 64 : size;
    std::vector<unsigned char> bytes(room);
    Expected e;
    e.add_if(room < size, LR_ERROR_BUFFER_TOO_SMALL);
    e.add_if(in.null(1), LR_ERROR_NULL_ARGUMENT);
    Call call(f, w, "lr_world_snapshot_save", e);
    uint64_t written = 77;
    unsigned char none = 0;
    unsigned char* const to = in.null(1) ? nullptr : bytes.empty() ? &none : bytes.data();
    const bool ok =
        call.ended(LR_CALL(lr_world_snapshot_save)(call.world(), to, room, in.null(2) ? nullptr : &written));
    if (!in.null(2) && written != (ok ? size : 0))
        defect("lr_world_snapshot_save", "written", static_cast<int64_t>(written));
    if (!ok) return;
    Saved saved{bytes, w.state, w.past, hash_of(w)};
    if (f.saved.size() < 4)
        f.saved.push_back(std::move(saved));
    else
        f.saved[in.handle(1) % 4] = std::move(saved);
}

// The world must already have the data that snapshots only refer to.
bool has_data(const World& w, const State& needed) {
    const auto has_wind = [&](const AnyWind& any) {
        const auto* const d = std::get_if<lr_wind_grid_desc>(&any);
        return !d || std::any_of(w.state.winds.begin(), w.state.winds.end(), [&](const Wind& s) {
            const auto* const has = std::get_if<lr_wind_grid_desc>(&s.desc);
            return has && has->samples == d->samples && has->frames == d->frames &&
                   std::equal(d->counts, d->counts + 3, has->counts);
        });
    };
    const auto has_shape = [&](const lr_collider_desc& d) {
        return d.kind < LR_COLLIDER_HULL ||
               std::any_of(w.state.colliders.begin(), w.state.colliders.end(), [&](const Collider& c) {
                   return c.desc.kind == d.kind && c.desc.vertices == d.vertices && c.desc.indices == d.indices &&
                          c.desc.heights == d.heights && c.desc.vertex_count == d.vertex_count &&
                          c.desc.triangle_count == d.triangle_count &&
                          std::equal(d.counts, d.counts + 2, c.desc.counts) &&
                          std::equal(d.spacing, d.spacing + 2, c.desc.spacing);
               });
    };
    return std::all_of(needed.winds.begin(), needed.winds.end(), [&](const Wind& s) { return has_wind(s.desc); }) &&
           std::all_of(needed.colliders.begin(), needed.colliders.end(),
                       [&](const Collider& c) { return has_shape(c.desc); });
}

void restore(Fuzzer& f) {
    World& w = f.world();
    Input& in = f.in;
    if (f.saved.empty()) return;
    const Saved& from = f.saved[in.handle(0) % f.saved.size()];
    Expected e;
    const bool same_past = from.past == w.past;
    if (!same_past || !has_data(w, from.state)) e.may(LR_ERROR_SNAPSHOT_MISMATCH);
    e.may_if(from.state.loose, LR_ERROR_SNAPSHOT_FORMAT);
    e.add_if(in.null(1), LR_ERROR_NULL_ARGUMENT);
    Call call(f, w, "lr_world_snapshot_restore", e);
    if (!call.ended(LR_CALL(lr_world_snapshot_restore)(call.world(), in.null(1) ? nullptr : from.bytes.data(),
                                                       from.bytes.size())))
        return;
    if (!same_past) w.past.push_back({{}, {}}); // a unique history from now on
    w.state = from.state;
    if (hash_of(w) != from.hash)
        defect("lr_world_snapshot_restore", "the hash is not that of the world that was saved");
    check_world(w);
}

// Damaged, with a wrong checksum and with a right one.
void restore_damaged(Fuzzer& f) {
    World& w = f.world();
    Input& in = f.in;
    if (!w.at) return;
    std::vector<unsigned char> bytes = f.saved.empty() ? save_bytes(w) : f.saved[in.handle(0) % f.saved.size()].bytes;
    const bool sealed = in.variant() == 1 || in.variant() == 2;
    Expected e;
    for (lr_status s : {LR_ERROR_SNAPSHOT_FORMAT, LR_ERROR_SNAPSHOT_MISMATCH}) e.may(s);
    if (in.variant() == 3) {
        const size_t at = (in.value(0) * 256u + in.value(1)) % bytes.size();
        if (in.handle(1) % 2) {
            bytes.resize(at);
        } else if (in.handle(1) % 4 == 0) {
            bytes[at] ^= static_cast<unsigned char>(in.value(2) | 1u);
        } else {
            bytes = asset_bytes();
        }
        e.add(LR_ERROR_SNAPSHOT_FORMAT);
    } else if (sealed) {
        // Words of eight bytes, like most of its fields, or of four.
        for (size_t i = 0; i < 2; ++i) {
            const size_t word = in.variant() == 1 ? (in.value(3 * i) * 256u + in.value(3 * i + 1)) : in.value(3 * i);
            const size_t at = word % (bytes.size() / 4) * 4;
            const uint32_t bits = in.value(3 * i + 2) % 2 ? in.integer(in.value(3 * i + 2))
                                                          : std::bit_cast<uint32_t>(in.real(in.value(3 * i + 2)));
            std::memcpy(bytes.data() + at, &bits, 4);
        }
        test::seal(bytes);
    } else {
        bytes.assign(bytes.size(), in.value(0));
        e.add_if(true, LR_ERROR_SNAPSHOT_FORMAT);
    }
    const std::unique_ptr<unsigned char[]> exact(new unsigned char[bytes.size() + 1]);
    std::copy(bytes.begin(), bytes.end(), exact.get() + 1); // any alignment
    Call call(f, w, "lr_world_snapshot_restore", e);
    if (!call.ended(LR_CALL(lr_world_snapshot_restore)(call.world(), exact.get() + 1, bytes.size()))) return;
    w.state.loose = w.state.wild = true;
    w.past.push_back({{}, {}});
    check_world(w);
}

// An equal world with other workers and another instruction set restores its snapshot and continues with the same bits.
void twin(Fuzzer& f) {
    World& w = f.world();
    if (!w.at || w.state.loose) return;
    for (const Past& p : w.past)
        if (p.created.asset == nullptr && p.destroyed.id == 0) return; // restored from a world with another history
    World other;
    lr_world_desc d = w.desc;
    d.allocator = other.memory->hooks();
    d.jobs = hostile_jobs(f.in.handle(0));
    d.worker_count = d.jobs.enqueue ? 2 : f.in.handle(0) >= 248 ? 1 : 0;
    d.simd_target = f.in.handle(1) % 2 ? last_target() : LR_SIMD_AUTO;
    if (LR_CALL(lr_world_create)(&d, &other.at) != LR_OK) defect("lr_world_create", "a twin is refused");
    for (const Past& p : w.past) {
        lr_batch id{};
        const lr_status status = p.created.asset ? LR_CALL(lr_batch_create)(other.at, &p.created, &id)
                                                 : LR_CALL(lr_batch_destroy)(other.at, p.destroyed);
        if (status != LR_OK) defect("lr_batch_create", "not what a world did before", status);
    }
    for (const Wind& s : w.state.winds) {
        const auto* const grid = std::get_if<lr_wind_grid_desc>(&s.desc);
        if (grid && add_wind(other.at, grid, nullptr) != LR_OK)
            defect("lr_world_add_wind_grid", "not what a world did before");
    }
    for (const Collider& c : w.state.colliders) {
        lr_collider id{};
        if (c.desc.kind >= LR_COLLIDER_HULL && LR_CALL(lr_collider_create)(other.at, &c.desc, 1, &id) != LR_OK)
            defect("lr_collider_create", "not what a world did before");
    }
    // Calls leave events for the next step, and a world without events does not keep them.
    if (w.event_capacity != 0 && LR_CALL(lr_world_set_events)(other.at, w.event_capacity, LR_EVENTS_ALL) != LR_OK)
        defect("lr_world_set_events", "not what a world did before");
    const std::vector<unsigned char> bytes = save_bytes(w);
    const lr_status status = LR_CALL(lr_world_snapshot_restore)(other.at, bytes.data(), bytes.size());
    if (status != LR_OK) defect("lr_world_snapshot_restore", "a twin does not take it", status);
    if (hash_of(other) != hash_of(w)) defect("lr_world_snapshot_restore", "a twin has another hash");
    if (save_bytes(other) != bytes) defect("lr_world_snapshot_save", "a twin saves other bytes");
    other.wind_callback = w.wind_callback, other.surface_callback = w.surface_callback;
    set_callbacks(other, other.at);
    if (step_world(f, w, 1.0f / 60.0f, 2)) {
        if (LR_CALL(lr_world_step)(other.at, 1.0f / 60.0f, 2) != LR_OK) defect("lr_world_step", "failed");
        if (hash_of(other) != hash_of(w)) defect("lr_world_step", "a twin goes another way");
    }
    LR_CALL(lr_world_destroy)(other.at);
    if (other.memory->live() != 0) defect("lr_world_destroy", "memory is lost");
}

void hash(Fuzzer& f) {
    World& w = f.world();
    Expected e;
    e.add_if(f.in.null(2), LR_ERROR_NULL_ARGUMENT);
    Call call(f, w, "lr_world_hash", e);
    uint64_t out = 0;
    call.ended(LR_CALL(lr_world_hash)(call.world(), f.in.null(2) ? nullptr : &out));
}

} // namespace

std::vector<Named> snapshot_operations() {
    return {{"save", save}, {"restore", restore}, {"restore", restore}, {"restore_damaged", restore_damaged},
            {"twin", twin}, {"hash", hash}};
}

} // namespace fuzz
