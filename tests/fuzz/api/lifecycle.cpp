// Rules, emitters, spawns on demand.
#include "fuzz/api/model.h"

namespace fuzz {
namespace {

void rules(Fuzzer& f) {
    World& w = f.world();
    Input& in = f.in;
    const lr_batch id = f.pick_batch(w, in.handle(0));
    Batch* const b = w.find(id);
    lr_batch_rules r = initialised(LR_CALL(lr_batch_rules_init));
    r.action = in.handle(1) % 4 == 0 ? LR_END_RESPAWN : LR_END_DESTROY;
    r.volume_count = in.handle(1) / 4 % 3;
    for (lr_kill_volume& v : r.volumes) v.size[1] = 1.0f, v.center[1] = -1.0f;
    lr_kill_volume& v = r.volumes[0];
    in.change(r.action, r.max_age, r.volume_count, v.shape, v.side, v.center, v.size);
    Expected e;
    if (!in.null(1)) {
        e.range(r.max_age, 0.0, 3e38);
        e.may_if(r.max_age > 1e8f, LR_ERROR_INVALID_ARGUMENT);
        e.add_if(r.action < 0 || r.action > LR_END_RESPAWN || r.volume_count > LR_MAX_KILL_VOLUMES,
                 LR_ERROR_INVALID_ARGUMENT);
        if (r.volume_count != 0) {
            e.range(v.center, -1e9, 1e9);
            for (float x : v.size) {
                e.finite(x);
                e.may_if(x < 0.0f || x > 1e9f || x < -1e9f, LR_ERROR_INVALID_ARGUMENT);
            }
            e.add_if(v.shape < 0 || v.shape > LR_VOLUME_SPHERE || v.side < 0 || v.side > LR_KILL_OUTSIDE,
                     LR_ERROR_INVALID_ARGUMENT);
            e.add_if(v.shape == LR_VOLUME_PLANE && v.size[0] == 0.0f && v.size[1] == 0.0f && v.size[2] == 0.0f,
                     LR_ERROR_INVALID_ARGUMENT);
        }
        e.add_if(b && r.action == LR_END_RESPAWN && !b->emitter, LR_ERROR_INVALID_ARGUMENT);
    }
    e.add_if(!b, LR_ERROR_STALE_BATCH);
    Given<lr_batch_rules> given(in, r, 1, e, true);
    Call call(f, w, "lr_batch_set_rules", e);
    if (!call.ended(LR_CALL(lr_batch_set_rules)(call.world(), id, given.get())) || !b) return;
    b->rules = given.get() != nullptr;
    lr_batch_rules got = initialised(LR_CALL(lr_batch_rules_init));
    int32_t present = -7;
    if (LR_CALL(lr_batch_get_rules)(w.at, id, &got, &present) != LR_OK || present != (b->rules ? 1 : 0) ||
        (b->rules && (got.action != r.action || got.volume_count != r.volume_count)))
        defect("lr_batch_get_rules", "not what was set", present);
    b->respawns = b->rules && r.action == LR_END_RESPAWN;
}

void emitter(Fuzzer& f) {
    World& w = f.world();
    Input& in = f.in;
    const lr_batch id = f.pick_batch(w, in.handle(0));
    Batch* const b = w.find(id);
    lr_emitter_desc d = initialised(LR_CALL(lr_emitter_desc_init));
    d.shape = in.handle(1) % 6, d.pose = in.handle(1) / 8 % 2;
    d.rate = static_cast<float>(in.handle(2) % 8) * 10.0f;
    if (in.handle(2) >= 128) d.burst_count = 1 + in.handle(2) % 4, d.burst_interval = 0.05f;
    in.change(d.shape, d.position, d.orientation, d.size, d.pose, d.body_orientation, d.direction, d.spread,
              d.speed_min, d.speed_max, d.spin_min, d.spin_max, d.scale_min, d.scale_max, d.rate, d.burst_interval,
              d.burst_count, d.reserved);
    Expected e;
    if (!in.null(1)) {
        e.range(d.position, -1e9, 1e9);
        e.range(d.size, 0.0, 1e9);
        e.length(d.orientation, 1e-5, 1e5);
        e.length(d.body_orientation, 1e-5, 1e5);
        e.length(d.direction, 1e-5, 1e5);
        e.range(d.spread, 0.0, 3.14159265358979);
        for (float v : {d.speed_min, d.speed_max, d.spin_min, d.spin_max}) e.range(v, 0.0, 1e6);
        for (float v : {d.scale_min, d.scale_max}) e.range(v, 0.001, 1000.0);
        e.add_if(d.speed_min > d.speed_max || d.spin_min > d.spin_max || d.scale_min > d.scale_max,
                 LR_ERROR_INVALID_ARGUMENT);
        e.range(d.rate, 0.0, 1e9);
        e.finite(d.burst_interval);
        if (d.burst_count != 0) e.range(d.burst_interval, 1e-4, 3e38);
        e.may_if(d.burst_interval < 0.0f || d.burst_interval > 1e8f || d.burst_count > 1u << 26,
                 LR_ERROR_INVALID_ARGUMENT);
        e.add_if(d.shape < 0 || d.shape > LR_EMIT_SPHERE_SURFACE || d.pose < 0 || d.pose > LR_POSE_FIXED ||
                     d.reserved != 0,
                 LR_ERROR_INVALID_ARGUMENT);
    } else {
        e.add_if(b && b->respawns, LR_ERROR_INVALID_ARGUMENT);
    }
    e.add_if(!b, LR_ERROR_STALE_BATCH);
    Given<lr_emitter_desc> given(in, d, 1, e, true);
    Call call(f, w, "lr_batch_set_emitter", e);
    if (!call.ended(LR_CALL(lr_batch_set_emitter)(call.world(), id, given.get())) || !b) return;
    b->emitter = given.get() != nullptr;
    lr_emitter_desc got = initialised(LR_CALL(lr_emitter_desc_init));
    int32_t present = -7;
    if (LR_CALL(lr_batch_get_emitter)(w.at, id, &got, &present) != LR_OK || present != (b->emitter ? 1 : 0) ||
        (b->emitter && std::memcmp(&got, &d, sizeof d) != 0))
        defect("lr_batch_get_emitter", "not what was set", present);
}

// function(world, batch, count, ids)
template <class Function> void spawned(Fuzzer& f, const char* name, bool box, Expected e, Function&& function) {
    World& w = f.world();
    const lr_batch id = f.pick_batch(w, f.in.handle(0));
    Batch* const b = w.find(id);
    const uint32_t count = f.in.handle(1) < 224 ? f.in.handle(1) % 5 : f.in.integer(f.in.handle(1));
    e.add_if(!b, LR_ERROR_STALE_BATCH);
    e.add_if(b && !box && count != 0 && !b->emitter, LR_ERROR_INVALID_ARGUMENT);
    e.add_if(b && count > b->desc.capacity - b->bodies.size(), LR_ERROR_CAPACITY);
    Call call(f, w, name, e);
    std::vector<lr_body> ids(std::min(count, 64u));
    const bool wild = w.state.wild;
    const bool ok = call.ended(function(call.world(), id, count, f.in.null(2) ? nullptr : ids.data()));
    w.state.wild = wild;
    if (!ok || !b || count == 0) return;
    const lr_batch_view view = view_of(w, id);
    if (!w.state.loose && view.count != b->bodies.size() + count) defect(name, "count", view.count);
    if (!f.in.null(2))
        for (lr_body body : ids)
            if (std::find(view.ids, view.ids + view.count, body) == view.ids + view.count) defect(name, "a stale id");
    b->bodies.assign(view.ids, view.ids + view.count);
}

void spawn_box(Fuzzer& f) {
    float low[3] = {-1.0f, 0.0f, -1.0f}, high[3] = {1.0f, 2.0f, 1.0f};
    f.in.change(low, high);
    Expected e;
    e.range(low, -1e9, 1e9);
    e.range(high, -1e9, 1e9);
    for (size_t k = 0; k < 3; ++k) e.add_if(low[k] > high[k], LR_ERROR_INVALID_ARGUMENT);
    e.add_if(f.in.null(1) || f.in.null(3), LR_ERROR_NULL_ARGUMENT);
    spawned(f, "lr_batch_spawn_box", true, e, [&](lr_world* w, lr_batch id, uint32_t count, lr_body* ids) {
        return LR_CALL(lr_batch_spawn_box)(w, id, f.in.null(1) ? nullptr : low, f.in.null(3) ? nullptr : high, count,
                                           ids);
    });
}

void spawn(Fuzzer& f) {
    if (f.in.handle(2) % 4 == 3) return spawn_box(f);
    spawned(f, "lr_batch_spawn", false, {}, LR_CALL(lr_batch_spawn));
}

void divergence_policy(Fuzzer& f) {
    World& w = f.world();
    const lr_batch id = f.pick_batch(w, f.in.handle(0));
    const auto policy = static_cast<int32_t>(f.in.handle(1) < 224 ? f.in.handle(1) % 3u : f.in.integer(f.in.handle(1)));
    Expected e;
    e.add_if(!w.find(id), LR_ERROR_STALE_BATCH);
    e.add_if(policy < LR_DIVERGENCE_AUTO || policy > LR_DIVERGENCE_REMOVE, LR_ERROR_INVALID_ARGUMENT);
    {
        Call call(f, w, "lr_batch_set_divergence_policy", e);
        if (!call.ended(LR_CALL(lr_batch_set_divergence_policy)(call.world(), id, policy))) return;
    }
    Expected none;
    none.add_if(f.in.null(2), LR_ERROR_NULL_ARGUMENT);
    Call call(f, w, "lr_batch_get_divergence_policy", none);
    int32_t got = -7;
    if (call.ended(LR_CALL(lr_batch_get_divergence_policy)(call.world(), id, f.in.null(2) ? nullptr : &got)) &&
        got != policy)
        defect("lr_batch_get_divergence_policy", "not what was set", got);
}

} // namespace

std::vector<Named> lifecycle_operations() {
    return {{"rules", rules}, {"emitter", emitter}, {"spawn", spawn}, {"divergence_policy", divergence_policy}};
}

} // namespace fuzz
