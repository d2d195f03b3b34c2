#include "fuzz/api/model.h"

#include <set>

namespace fuzz {

uint64_t hash_of(const World& w) {
    uint64_t hash = 0;
    if (LR_CALL(lr_world_hash)(w.at, &hash) != LR_OK) defect("lr_world_hash", "failed");
    return hash;
}

lr_world_info info_of(const World& w) {
    lr_world_info info = initialised(LR_CALL(lr_world_info_init));
    if (LR_CALL(lr_world_get_info)(w.at, &info) != LR_OK) defect("lr_world_get_info", "failed");
    return info;
}

lr_batch_view view_of(const World& w, lr_batch batch) {
    lr_batch_view view = initialised(LR_CALL(lr_batch_view_init));
    if (LR_CALL(lr_batch_get_view)(w.at, batch, &view) != LR_OK) defect("lr_batch_get_view", "failed");
    return view;
}

void remember(std::vector<lr_body>& stale, lr_body id) {
    if (stale.size() >= 16) stale.erase(stale.begin());
    stale.push_back(id);
}

lr_body Fuzzer::pick_body(World& w, uint8_t byte) const {
    static const std::vector<lr_body> none;
    if (w.state.batches.empty()) return pick(none, w.stale_bodies, byte);
    return pick(w.state.batches[byte % w.state.batches.size()].bodies, w.stale_bodies, byte);
}

Fuzzer::~Fuzzer() {
    for (World& w : worlds) {
        if (w.at) check_world(w);
        LR_CALL(lr_world_destroy)(w.at);
        if (w.memory->live() != 0) defect("lr_world_destroy", "memory is lost", static_cast<int64_t>(w.memory->live()));
    }
    for (lr_asset* asset : assets) LR_CALL(lr_asset_release)(asset);
}

Call::Call(Fuzzer& fuzzer, World& world, const char* function, Expected& expected)
    : fuzzer_(fuzzer), world_(world), function_(function), expected_(expected), null_(!world.at || fuzzer.in.null(0)) {
    if (null_) expected_.add(LR_ERROR_NULL_ARGUMENT);
    if (world_.state.loose) expected_.forgive();
    if (world_.at && (expected_.may_fail() || world_.memory->armed())) {
        compared_ = true;
        hash_ = hash_of(world_);
        info_ = info_of(world_);
    }
    world_.memory->begin();
}

bool Call::ended(lr_status status) {
    if (world_.memory->refused()) expected_.may(LR_ERROR_OUT_OF_MEMORY);
    if (world_.state.loose) {
        for (lr_status any : {LR_ERROR_CAPACITY, LR_ERROR_STALE_BODY, LR_ERROR_STALE_BATCH, LR_ERROR_STALE_COLLIDER,
                              LR_ERROR_STALE_WIND_SOURCE, LR_ERROR_INVALID_ARGUMENT})
            expected_.may(any);
    }
    if (!expected_.allows(status)) defect(function_, "status", status);
    if (world_.memory->refused() && status == LR_OK) defect(function_, "has no memory, and does not say so");
    if (status != LR_OK && compared_) {
        lr_world_info now = info_of(world_);
        now.memory_bytes = info_.memory_bytes; // reserved memory can stay
        if (hash_of(world_) != hash_) defect(function_, "was refused, and changed the world", status);
        if (std::memcmp(&now, &info_, sizeof now) != 0)
            defect(function_, "was refused, and changed the counts", status);
    }
    if (status == LR_OK && fuzzer_.in.hostile()) world_.state.wild = true;
    return status == LR_OK;
}

namespace {

void check_body(const World& w, const Batch& b, const lr_batch_view& view, uint32_t i) {
    lr_body_state s = initialised(LR_CALL(lr_body_state_init));
    if (LR_CALL(lr_body_get_state)(w.at, view.ids[i], &s) != LR_OK)
        defect("lr_body_get_state", "a body of the view is stale");
    if (s.noise_seed != view.noise_seed[i]) defect("lr_body_get_state", "noise_seed");
    if ((s.sleep_state == LR_SLEEP_ASLEEP) != (i >= view.awake_count)) defect("lr_body_get_state", "resting");
    if (std::memcmp(&s.scale, &view.scale[i], 4) != 0) defect("lr_body_get_state", "scale is not that of the view");
    for (size_t k = 0; k < 3; ++k)
        if (std::memcmp(&s.position[k], &view.position[k][i], 4) != 0)
            defect("lr_body_get_state", "position is not that of the view");
    // For any arguments: docs/reference/bodies.md. Velocities in a snapshot are finite; the next step checks them.
    const auto square = [](const auto& v) {
        double sum = 0.0;
        for (float x : v) sum += static_cast<double>(x) * static_cast<double>(x);
        return sum;
    };
    for (float x : s.position)
        if (!(std::abs(x) <= 1e10f)) defect("lr_body_get_state", "a position out of physics");
    if (!std::isfinite(square(s.linear_velocity)) || !std::isfinite(square(s.angular_velocity)))
        defect("lr_body_get_state", "a velocity is not finite");
    const double turn = square(s.orientation);
    if (!(turn >= 0.979 && turn <= 1.021)) defect("lr_body_get_state", "an orientation is no unit quaternion");
    if (w.state.loose) return;
    if (!(square(s.linear_velocity) <= 4.01e12) || !(square(s.angular_velocity) <= 1.01e18))
        defect("lr_body_get_state", "a velocity out of physics");
    if (!(s.scale >= 0.0009f && s.scale <= 1001.0f) || !(s.age >= 0.0f)) defect("lr_body_get_state", "scale or age");
    if (w.state.wild || b.desc.integrator == LR_INTEGRATOR_RK4) return;
    if (!(turn > 0.998 && turn < 1.002)) defect("lr_world_step", "an orientation is not a unit quaternion");
}

void check_batch(World& w, Batch& b) {
    const lr_batch_view view = view_of(w, b.id);
    if (w.state.loose) b.bodies.assign(view.ids, view.ids + view.count);
    if (view.count != b.bodies.size()) defect("lr_batch_get_view", "count", view.count);
    if (view.capacity != b.desc.capacity) defect("lr_batch_get_view", "capacity", view.capacity);
    if (view.awake_count > view.count) defect("lr_batch_get_view", "awake_count", view.awake_count);
    if (reinterpret_cast<uintptr_t>(view.position[0]) % 64 != 0 || reinterpret_cast<uintptr_t>(view.age) % 64 != 0)
        defect("lr_batch_get_view", "alignment");
    if (!w.state.loose &&
        std::set<lr_body>(view.ids, view.ids + view.count) != std::set<lr_body>(b.bodies.begin(), b.bodies.end()))
        defect("lr_batch_get_view", "ids are not those of the bodies");
    float low[3], high[3];
    if (LR_CALL(lr_batch_get_bounds)(w.at, b.id, low, high) != LR_OK) defect("lr_batch_get_bounds", "failed");
    for (uint32_t i = 0; i < view.count; ++i) {
        check_body(w, b, view, i);
        for (size_t k = 0; k < 3; ++k)
            if (!(low[k] < view.position[k][i] && view.position[k][i] < high[k]))
                defect("lr_batch_get_bounds", "a body outside", i);
    }
}

} // namespace

void check_world(World& w) {
    uint64_t bodies = 0, awake = 0;
    for (Batch& b : w.state.batches) {
        check_batch(w, b);
        bodies += b.bodies.size();
        awake += view_of(w, b.id).awake_count;
    }
    const lr_world_info info = info_of(w);
    if (info.batch_count != w.state.batches.size()) defect("lr_world_get_info", "batch_count", info.batch_count);
    if (info.body_count != bodies) defect("lr_world_get_info", "body_count", static_cast<int64_t>(info.body_count));
    if (info.awake_count != awake) defect("lr_world_get_info", "awake_count", static_cast<int64_t>(info.awake_count));
    if (info.worker_count != w.desc.worker_count && !w.desc.jobs.enqueue)
        defect("lr_world_get_info", "worker_count", info.worker_count);
    if (info.memory_bytes != w.memory->live()) defect("lr_world_get_info", "memory_bytes");
    if (w.state.loose) return;
    if (info.collider_count != w.state.colliders.size()) defect("lr_world_get_info", "collider_count");
    if (info.substep_count != w.state.substeps) defect("lr_world_get_info", "substep_count");
    if (info.time != w.state.time) defect("lr_world_get_info", "time");
    for (const Collider& c : w.state.colliders) {
        lr_collider_state s = initialised(LR_CALL(lr_collider_state_init));
        if (LR_CALL(lr_collider_get_state)(w.at, c.id, &s) != LR_OK)
            defect("lr_collider_get_state", "a live one is stale");
        if (s.kind != c.desc.kind) defect("lr_collider_get_state", "kind", s.kind);
    }
    for (const Batch& b : w.state.batches) {
        if (LR_CALL(lr_batch_is_valid)(w.at, b.id) != 1) defect("lr_batch_is_valid", "0 for a live one");
        for (lr_body id : b.bodies)
            if (LR_CALL(lr_body_is_valid)(w.at, id) != 1) defect("lr_body_is_valid", "0 for a live one");
    }
    for (const Collider& c : w.state.colliders)
        if (LR_CALL(lr_collider_is_valid)(w.at, c.id) != 1) defect("lr_collider_is_valid", "0 for a live one");
    for (const Wind& wind : w.state.winds)
        if (LR_CALL(lr_wind_source_is_valid)(w.at, wind.id) != 1) defect("lr_wind_source_is_valid", "0 for a live one");
    for (lr_batch id : w.stale_batches)
        if (!w.find(id) && LR_CALL(lr_batch_is_valid)(w.at, id) != 0)
            defect("lr_batch_is_valid", "1 for a destroyed one");
    lr_body_state s = initialised(LR_CALL(lr_body_state_init));
    for (lr_body id : w.stale_bodies)
        if (!w.owner(id) && (LR_CALL(lr_body_get_state)(w.at, id, &s) != LR_ERROR_STALE_BODY ||
                             LR_CALL(lr_body_is_valid)(w.at, id) != 0))
            defect("lr_body_get_state", "a destroyed body is alive");
}

} // namespace fuzz
