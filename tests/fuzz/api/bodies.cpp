// Bodies: creation, end, states, sleep.
#include "fuzz/api/model.h"

#include <set>

namespace fuzz {
namespace {

template <class T> void expect_pose(const T& d, Expected& e) {
    e.range(d.position, -1e9, 1e9);
    e.range(d.linear_velocity, -1e6, 1e6);
    e.range(d.angular_velocity, -1e6, 1e6);
    e.range(d.scale, 0.001, 1000.0);
    e.range(d.age, 0.0, 3e38);
    e.may_if(d.age > 1e8f, LR_ERROR_INVALID_ARGUMENT);
    e.length(d.orientation, 1e-5, 1e5);
    if constexpr (requires { d.reserved; }) e.add_if(d.reserved != 0, LR_ERROR_INVALID_ARGUMENT);
}

void create(Fuzzer& f) {
    World& w = f.world();
    Input& in = f.in;
    const lr_batch id = f.pick_batch(w, in.handle(0));
    Batch* const b = w.find(id);
    const uint32_t count = in.handle(1) < 224 ? in.handle(1) % 5u : in.handle(1) % 16u;
    std::vector<lr_body_desc> descs(count, initialised(LR_CALL(lr_body_desc_init)));
    for (uint32_t i = 0; i < count; ++i) {
        descs[i].position[0] = 0.03f * static_cast<float>(i);
        descs[i].position[1] = 0.02f * static_cast<float>(in.selector());
    }
    Expected e;
    if (count != 0) {
        lr_body_desc& d = descs[in.variant() % count];
        in.change(d.position, d.orientation, d.linear_velocity, d.angular_velocity, d.scale, d.age, d.noise_seed,
                  d.reserved);
        d.user = d.noise_seed;
        expect_pose(d, e);
    }
    e.add_if(!b, LR_ERROR_STALE_BATCH);
    e.add_if(b && count > b->desc.capacity - b->bodies.size(), LR_ERROR_CAPACITY);
    GivenArray<lr_body_desc> given(in, descs, 1, e);
    Call call(f, w, "lr_body_create", e);
    std::vector<lr_body> ids(count);
    const bool ok =
        call.ended(LR_CALL(lr_body_create)(call.world(), id, given.get(), count, in.null(2) ? nullptr : ids.data()));
    if (!ok || !b) return;
    if (in.null(2)) { // then the caller does not know the ids
        const lr_batch_view view = view_of(w, id);
        ids.clear();
        for (uint32_t i = 0; i < view.count; ++i)
            if (std::find(b->bodies.begin(), b->bodies.end(), view.ids[i]) == b->bodies.end())
                ids.push_back(view.ids[i]);
        if (ids.size() != count && !w.state.loose) defect("lr_body_create", "count", static_cast<int64_t>(ids.size()));
    }
    for (lr_body body : ids) {
        if (!w.state.loose && (body.id == 0 || w.owner(body))) defect("lr_body_create", "the handle of another");
        b->bodies.push_back(body);
    }
}

std::vector<lr_body> some_bodies(Fuzzer& f, World& w, uint32_t count) {
    std::vector<lr_body> ids(count);
    for (uint32_t i = 0; i < count; ++i) ids[i] = f.pick_body(w, static_cast<uint8_t>(f.in.value(i) + i * 0));
    return ids;
}

void destroy(Fuzzer& f) {
    World& w = f.world();
    const uint32_t count = f.in.handle(0) % 6;
    const std::vector<lr_body> ids = some_bodies(f, w, count);
    Expected e;
    for (lr_body id : ids) e.add_if(!w.owner(id), LR_ERROR_STALE_BODY);
    e.add_if(std::set<lr_body>(ids.begin(), ids.end()).size() != ids.size(), LR_ERROR_STALE_BODY);
    e.add_if(f.in.null(1) && count != 0, LR_ERROR_NULL_ARGUMENT);
    Call call(f, w, "lr_body_destroy", e);
    if (!call.ended(LR_CALL(lr_body_destroy)(call.world(), f.in.null(1) ? nullptr : ids.data(), count))) return;
    for (lr_body id : ids) {
        if (Batch* const b = w.owner(id)) std::erase(b->bodies, id);
        remember(w.stale_bodies, id);
    }
}

void state(Fuzzer& f) {
    World& w = f.world();
    Input& in = f.in;
    const lr_body id = f.pick_body(w, in.handle(0));
    Expected e;
    e.add_if(!w.owner(id), LR_ERROR_STALE_BODY);
    if (in.variant() % 2 == 0) {
        Given<lr_body_state> given(in, initialised(LR_CALL(lr_body_state_init)), 1, e);
        Call call(f, w, "lr_body_get_state", e);
        call.ended(LR_CALL(lr_body_get_state)(call.world(), id, given.get()));
        return;
    }
    lr_body_state s = initialised(LR_CALL(lr_body_state_init));
    in.change(s.position, s.orientation, s.linear_velocity, s.angular_velocity, s.scale, s.age, s.noise_seed,
              s.sleep_state);
    s.user = ~uint64_t{s.noise_seed};
    if (!in.null(1)) expect_pose(s, e);
    Given<lr_body_state> given(in, s, 1, e);
    Call call(f, w, "lr_body_set_state", e);
    if (!call.ended(LR_CALL(lr_body_set_state)(call.world(), id, given.get())) || w.state.loose) return;
    lr_body_state got = initialised(LR_CALL(lr_body_state_init));
    if (LR_CALL(lr_body_get_state)(w.at, id, &got) != LR_OK ||
        std::memcmp(got.position, s.position, sizeof s.position) != 0 || got.scale != s.scale || got.user != s.user ||
        got.sleep_state != LR_SLEEP_AWAKE)
        defect("lr_body_set_state", "not what was set");
}

void rest(Fuzzer& f) {
    World& w = f.world();
    const uint32_t count = f.in.handle(0) % 6;
    const int32_t to = f.in.handle(1) < 224 ? static_cast<int32_t>(f.in.handle(1) % 3 != 0)
                                            : static_cast<int32_t>(f.in.integer(f.in.handle(1)));
    const std::vector<lr_body> ids = some_bodies(f, w, count);
    Expected e;
    for (lr_body id : ids) e.add_if(!w.owner(id), LR_ERROR_STALE_BODY);
    e.add_if(f.in.null(1) && count != 0, LR_ERROR_NULL_ARGUMENT);
    e.add_if(to != LR_SLEEP_AWAKE && to != LR_SLEEP_ASLEEP, LR_ERROR_INVALID_ARGUMENT);
    Call call(f, w, "lr_body_set_sleep", e);
    if (!call.ended(LR_CALL(lr_body_set_sleep)(call.world(), f.in.null(1) ? nullptr : ids.data(), count, to)) ||
        w.state.loose)
        return;
    lr_body_state got = initialised(LR_CALL(lr_body_state_init));
    for (lr_body id : ids)
        if (LR_CALL(lr_body_get_state)(w.at, id, &got) != LR_OK || got.sleep_state != to)
            defect("lr_body_set_sleep", "not what was set", got.sleep_state);
}

void wake_box(Fuzzer& f) {
    World& w = f.world();
    float low[3] = {-1.0f, -1.0f, -1.0f}, high[3] = {1.0f, 1.0f, 1.0f};
    f.in.change(low, high);
    Expected e;
    for (size_t k = 0; k < 3; ++k) {
        e.finite(low[k]), e.finite(high[k]);
        e.add_if(low[k] > high[k], LR_ERROR_INVALID_ARGUMENT);
    }
    e.add_if(f.in.null(1) || f.in.null(2), LR_ERROR_NULL_ARGUMENT);
    Call call(f, w, "lr_world_wake_box", e);
    uint32_t woken = 77;
    const uint64_t before = w.at ? info_of(w).awake_count : 0;
    const bool wild = w.state.wild;
    const bool ok = call.ended(LR_CALL(lr_world_wake_box)(
        call.world(), f.in.null(1) ? nullptr : low, f.in.null(2) ? nullptr : high, f.in.null(3) ? nullptr : &woken));
    w.state.wild = wild;
    if (f.in.null(3) || !w.at) return;
    // Bodies that sleep on those wake with them.
    if (woken > info_of(w).awake_count - before || (!ok && woken != 0)) defect("lr_world_wake_box", "woken", woken);
}

} // namespace

std::vector<Named> body_operations() {
    return {{"body_create", create},
            {"body_destroy", destroy},
            {"body_state", state},
            {"body_rest", rest},
            {"wake_box", wake_box}};
}

} // namespace fuzz
