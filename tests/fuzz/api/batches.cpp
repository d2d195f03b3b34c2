// Batches: creation, end, views, transforms, rates.
#include "fuzz/api/model.h"

namespace fuzz {
namespace {

void create(Fuzzer& f) {
    World& w = f.world();
    Input& in = f.in;
    lr_batch_desc d = initialised(LR_CALL(lr_batch_desc_init));
    const uint32_t capacities[] = {1, 2, 3, 4, 8, 12, 16, 33};
    d.capacity = capacities[in.handle(0) % 8];
    d.load_model = in.handle(0) / 8 % 4;
    d.integrator = in.handle(0) >= 240 ? LR_INTEGRATOR_RK4 : LR_INTEGRATOR_DEFAULT;
    d.clock = in.handle(1) % 2, d.table_end = in.handle(1) / 2 % 2;
    in.change(d.capacity, d.load_model, d.clock, d.table_end, d.integrator, d.damping_gain, d.noise_gain);
    if (in.variant() == 3 && in.handle(1) > 250) d.capacity = in.integer(in.handle(2));
    if (d.capacity > 40 && d.capacity <= 70000) d.capacity = 40;
    d.asset = f.pick_asset();
    Expected e;
    e.add_if(d.capacity == 0 || d.capacity > 1u << 26, LR_ERROR_INVALID_ARGUMENT);
    e.add_if(d.load_model < 0 || d.load_model > LR_LOADS_AERODYNAMIC, LR_ERROR_INVALID_ARGUMENT);
    e.add_if(d.clock < 0 || d.clock > 1 || d.table_end < 0 || d.table_end > 1 || d.integrator < 0 ||
                 d.integrator > LR_INTEGRATOR_SPLITTING,
             LR_ERROR_INVALID_ARGUMENT);
    e.range(d.damping_gain, 0.0, 100.0);
    e.range(d.noise_gain, 0.0, 100.0);
    if (in.null(3)) d.asset = nullptr, e.add(LR_ERROR_NULL_ARGUMENT);
    // Mass and fluid of this world can give a matrix without an inverse.
    e.may_if(d.asset && std::find(common_assets().begin(), common_assets().end(), d.asset) == common_assets().end(),
             LR_ERROR_INVALID_ARGUMENT);
    e.may_if(w.state.wild, LR_ERROR_INVALID_ARGUMENT);
    Given<lr_batch_desc> given(in, d, 1, e);
    e.add_if(in.null(2), LR_ERROR_NULL_ARGUMENT);
    Call call(f, w, "lr_batch_create", e);
    lr_batch id{77};
    const bool ok = call.ended(LR_CALL(lr_batch_create)(call.world(), given.get(), in.null(2) ? nullptr : &id));
    if (!in.null(2) && ok != (id.id != 0)) defect("lr_batch_create", "handle and status do not agree", id.id);
    if (!ok) return;
    if (w.find(id)) defect("lr_batch_create", "the handle of another", id.id);
    Batch b;
    b.id = id, b.desc = d;
    w.state.batches.push_back(b);
    w.past.push_back({d, {}});
    if (d.asset && std::find(common_assets().begin(), common_assets().end(), d.asset) == common_assets().end())
        w.state.wild = true;
}

void destroy(Fuzzer& f) {
    World& w = f.world();
    const lr_batch id = f.pick_batch(w, f.in.handle(0));
    const bool live = w.find(id) != nullptr;
    Expected e;
    e.add_if(!live, LR_ERROR_STALE_BATCH);
    Call call(f, w, "lr_batch_destroy", e);
    if (!call.ended(LR_CALL(lr_batch_destroy)(call.world(), id)) || !live) return;
    for (lr_body body : w.find(id)->bodies) remember(w.stale_bodies, body);
    std::erase_if(w.state.batches, [&](const Batch& b) { return b.id == id; });
    w.stale_batches.push_back(id);
    w.past.push_back({{}, id});
}

// A view, pace, or coefficients of any batch, in any size.
template <class T>
void get(Fuzzer& f, const char* name, lr_status (*init)(T*, uint32_t),
         lr_status (*function)(const lr_world*, lr_batch, T*)) {
    World& w = f.world();
    const lr_batch id = f.pick_batch(w, f.in.handle(0));
    Expected e;
    e.add_if(!w.find(id), LR_ERROR_STALE_BATCH);
    Given<T> given(f.in, initialised(init), 1, e);
    Call call(f, w, name, e);
    call.ended(function(call.world(), id, given.get()));
}

void queries(Fuzzer& f) {
    switch (f.in.handle(1) % 5) {
    case 0:
        return get(f, "lr_batch_get_view", LR_CALL(lr_batch_view_init), LR_CALL(lr_batch_get_view));
    case 1:
        return get(f, "lr_batch_get_pace", LR_CALL(lr_batch_pace_init), LR_CALL(lr_batch_get_pace));
    case 2:
        return get(f, "lr_batch_get_aerodynamics", LR_CALL(lr_aerodynamics_init), LR_CALL(lr_batch_get_aerodynamics));
    case 3:
        return get(f, "lr_batch_get_contact", LR_CALL(lr_batch_contact_init), LR_CALL(lr_batch_get_contact));
    default:
        return get(f, "lr_batch_get_counts", LR_CALL(lr_batch_counts_init), LR_CALL(lr_batch_get_counts));
    }
}

void velocities(Fuzzer& f, lr_batch id, uint64_t stride, uint32_t capacity, uint32_t count) {
    World& w = f.world();
    Input& in = f.in;
    const uint64_t step = stride == 0 ? 24 : stride;
    const bool fits = step >= 24 && step % 4 == 0;
    const uint32_t wanted = std::min(capacity, count);
    std::vector<float> room(fits && wanted != 0 ? ((wanted - 1) * step + 24) / 4 : 0);
    Expected e;
    e.add_if(!w.find(id), LR_ERROR_STALE_BATCH);
    e.add_if(!fits, LR_ERROR_INVALID_ARGUMENT);
    e.add_if(in.null(1) && wanted != 0, LR_ERROR_NULL_ARGUMENT);
    Call call(f, w, "lr_batch_write_velocities", e);
    uint32_t written = 77;
    float* const to = in.null(1) ? nullptr : room.data();
    const bool wild = w.state.wild;
    const bool ok = call.ended(LR_CALL(lr_batch_write_velocities)(call.world(), id, to, stride, capacity, &written));
    w.state.wild = wild;
    if (!w.state.loose && written != (ok ? wanted : 0)) defect("lr_batch_write_velocities", "written", written);
}

void transforms(Fuzzer& f) {
    World& w = f.world();
    Input& in = f.in;
    const lr_batch id = f.pick_batch(w, in.handle(0));
    const Batch* const b = w.find(id);
    const auto count = b ? static_cast<uint32_t>(b->bodies.size()) : 0u;
    int32_t format = in.handle(1) % 6;
    const uint32_t capacity = in.variant() % 2 == 1 ? in.handle(2) % 8 : count;
    uint64_t stride = in.value(0) % 4 == 0 ? 0 : 64u + in.value(0) / 4u * 4u;
    if (in.flag(flag_size)) {
        if (in.value(1) % 3 == 0) format = static_cast<int32_t>(in.integer(in.value(2)));
        if (in.value(1) % 3 == 1) stride = in.value(2) % 2 ? in.value(2) : in.value(2) % 4 * 4u;
    }
    const uint64_t bytes[] = {28, 32, 48, 48, 64, 64};
    const bool known = format >= 0 && format < 6;
    const uint64_t element = known ? bytes[format] : 64, step = stride == 0 ? element : stride;
    const uint32_t wanted = std::min(capacity, count);
    const bool fits = known && step >= element && step % 4 == 0;
    // Exactly the promised room.
    std::vector<float> room(fits && wanted != 0 ? ((wanted - 1) * step + element) / 4 : 0);
    Expected e;
    e.add_if(!b, LR_ERROR_STALE_BATCH);
    e.add_if(!fits, LR_ERROR_INVALID_ARGUMENT);
    e.add_if(in.null(1) && wanted != 0, LR_ERROR_NULL_ARGUMENT);
    Call call(f, w, "lr_batch_write_transforms", e);
    uint32_t written = 77;
    uint32_t* const out = in.null(2) ? nullptr : &written;
    float* const to = in.null(1) ? nullptr : room.data();
    const bool wild = w.state.wild;
    const bool ok = call.ended(LR_CALL(lr_batch_write_transforms)(call.world(), id, format, to, stride, capacity, out));
    w.state.wild = wild;
    if (out && !w.state.loose && written != (ok ? wanted : 0)) defect("lr_batch_write_transforms", "written", written);
    velocities(f, id, stride, capacity, count);
}

void rate(Fuzzer& f) {
    World& w = f.world();
    uint32_t divisor = 1 + f.in.handle(1) % 8;
    f.in.change(divisor);
    const lr_batch id = f.pick_batch(w, f.in.handle(0));
    Expected e;
    e.add_if(divisor < 1 || divisor > 1024, LR_ERROR_INVALID_ARGUMENT);
    e.add_if(!w.find(id), LR_ERROR_STALE_BATCH);
    Call call(f, w, "lr_batch_set_rate", e);
    call.ended(LR_CALL(lr_batch_set_rate)(call.world(), id, divisor));
}

void pairs(Fuzzer& f) {
    World& w = f.world();
    const lr_batch a = f.pick_batch(w, f.in.handle(0)), b = f.pick_batch(w, f.in.handle(1));
    const auto enabled = f.in.handle(2) < 200 ? static_cast<int32_t>(f.in.handle(2) % 4 != 0)
                                              : static_cast<int32_t>(f.in.integer(f.in.handle(2)));
    {
        Expected e;
        e.add_if(!w.find(a) || !w.find(b), LR_ERROR_STALE_BATCH);
        e.add_if(enabled != 0 && enabled != 1, LR_ERROR_INVALID_ARGUMENT);
        Call call(f, w, "lr_batch_set_body_contact", e);
        const bool wild = w.state.wild;
        if (!call.ended(LR_CALL(lr_batch_set_body_contact)(call.world(), a, b, enabled))) return;
        w.state.wild = wild;
    }
    Expected e;
    e.add_if(f.in.null(2), LR_ERROR_NULL_ARGUMENT);
    Call call(f, w, "lr_batch_get_body_contact", e);
    int32_t got = -1;
    const bool ok = call.ended(LR_CALL(lr_batch_get_body_contact)(call.world(), b, a, f.in.null(2) ? nullptr : &got));
    if (ok && got != enabled) defect("lr_batch_get_body_contact", "not what was set", got);
}

void contact(Fuzzer& f) {
    World& w = f.world();
    Input& in = f.in;
    lr_batch_contact c = initialised(LR_CALL(lr_batch_contact_init));
    c.flags = in.handle(1) % 4 == 0;
    in.change(c.layers, c.friction, c.restitution, c.rolling_resistance, c.flags, c.ground_effect, c.reserved,
              c.min_thickness);
    const lr_batch id = f.pick_batch(w, in.handle(0));
    Expected e;
    if (!in.null(1)) {
        e.range(c.friction, 0.0, 10.0);
        e.range(c.restitution, 0.0, 1.0);
        e.range(c.rolling_resistance, 0.0, 10.0);
        e.range(c.ground_effect, 0.0, 1.0);
        e.range(c.min_thickness, -1.0, 10.0);
        e.add_if(c.flags > 1 || c.reserved != 0, LR_ERROR_INVALID_ARGUMENT);
    }
    e.add_if(!w.find(id), LR_ERROR_STALE_BATCH);
    Given<lr_batch_contact> given(in, c, 1, e, true);
    Call call(f, w, "lr_batch_set_contact", e);
    call.ended(LR_CALL(lr_batch_set_contact)(call.world(), id, given.get()));
}

} // namespace

std::vector<Named> batch_operations() {
    return {
        {"batch_create", create}, {"batch_destroy", destroy}, {"batch_queries", queries}, {"transforms", transforms},
        {"rate", rate},           {"pairs", pairs},           {"contact", contact}};
}

} // namespace fuzz
