// Forces, impulses and accelerations on single bodies.
#include "fuzz/api/model.h"

namespace fuzz {
namespace {

void on_bodies(Fuzzer& f) {
    World& w = f.world();
    Input& in = f.in;
    const uint32_t count = in.handle(0) % 4;
    std::vector<lr_body_force> forces(count, initialised(LR_CALL(lr_body_force_init)));
    Expected e;
    bool pushed = false;
    for (uint32_t i = 0; i < count; ++i) {
        lr_body_force& d = forces[i];
        d.body = f.pick_body(w, in.handle(1 + i % 2));
        d.mode = in.handle(1) % 4, d.frame = in.handle(2) % 2;
        d.flags = d.mode % 2 == 0 ? in.handle(2) / 2 % 2 : 0u;
        if (i == in.variant() % count) in.change(d.force, d.torque, d.point, d.mode, d.frame, d.flags, d.reserved);
        e.add_if(!w.owner(d.body), LR_ERROR_STALE_BODY);
        for (const auto* v : {&d.force, &d.torque, &d.point})
            for (float x : *v) e.finite(x), pushed = pushed || x != 0.0f;
        e.add_if(d.mode < 0 || d.mode > LR_FORCE_MODE_VELOCITY || d.frame < 0 || d.frame > 1 || d.flags > 1 ||
                     d.reserved != 0,
                 LR_ERROR_INVALID_ARGUMENT);
        e.add_if(d.flags == 1 && (d.mode == LR_FORCE_MODE_ACCELERATION || d.mode == LR_FORCE_MODE_VELOCITY),
                 LR_ERROR_INVALID_ARGUMENT);
        // More than 1e9 m/s^2 or 1e6 m/s, depending on masses and arms.
        e.may(LR_ERROR_INVALID_ARGUMENT);
    }
    GivenArray<lr_body_force> given(in, forces, 1, e);
    Call call(f, w, "lr_body_add_force", e);
    if (call.ended(LR_CALL(lr_body_add_force)(call.world(), given.get(), count)) && pushed) w.state.wild = true;
}

void on_batch(Fuzzer& f) {
    World& w = f.world();
    Input& in = f.in;
    const lr_batch id = f.pick_batch(w, in.handle(0));
    const Batch* const b = w.find(id);
    const auto bodies = b ? static_cast<uint32_t>(b->bodies.size()) : 0u;
    lr_force_arrays a = initialised(LR_CALL(lr_force_arrays_init));
    a.mode = in.handle(1) % 4, a.frame = in.handle(1) / 4 % 2;
    a.first = bodies == 0 ? 0 : in.handle(2) % bodies, a.count = bodies - a.first;
    a.stride = in.handle(1) / 8 % 3 * 4;
    float force[3] = {}, torque[3] = {};
    in.change(force, torque, a.mode, a.frame, a.first, a.count, a.stride);
    if (a.stride > 1024) a.stride = a.stride % 4;
    const uint64_t step = a.stride == 0 ? 4 : a.stride;
    Expected e;
    const bool inside = uint64_t{a.first} + a.count <= bodies;
    const uint32_t count = inside ? a.count : 0;
    // In blocks of exactly their size; the last body's value is the changed one.
    std::vector<float> values[6];
    for (size_t k = 0; k < 6; ++k) {
        values[k].resize(count == 0 ? 1 : (count - 1) * step / 4 + 1);
        values[k].back() = k < 3 ? force[k] : torque[k - 3];
        (k < 3 ? a.force[k] : a.torque[k - 3]) = values[k].data();
    }
    const uint32_t given_arrays = in.variant();
    for (size_t k = 0; k < 3; ++k) {
        if (given_arrays == 1) a.torque[k] = nullptr;
        if (given_arrays == 2) a.force[k] = nullptr;
    }
    if (in.null(3)) a.force[1] = nullptr;
    const bool one_missing = in.null(3) && given_arrays != 2; // and not all three
    e.add_if(one_missing, LR_ERROR_NULL_ARGUMENT);
    if (count != 0 && !one_missing) {
        for (float v : force)
            if (given_arrays != 2) e.finite(v);
        for (float v : torque)
            if (given_arrays != 1) e.finite(v);
        e.may(LR_ERROR_INVALID_ARGUMENT); // as above
    } else {
        e.may(LR_ERROR_NOT_FINITE);
    }
    e.add_if(!b, LR_ERROR_STALE_BATCH);
    e.add_if(!inside || a.mode < 0 || a.mode > 3 || a.frame < 0 || a.frame > 1 || a.stride % 4 != 0,
             LR_ERROR_INVALID_ARGUMENT);
    Given<lr_force_arrays> given(in, a, 1, e);
    Call call(f, w, "lr_batch_add_forces", e);
    if (w.state.loose) return; // the number of bodies is unknown
    if (call.ended(LR_CALL(lr_batch_add_forces)(call.world(), id, given.get())) && count != 0) w.state.wild = true;
}

} // namespace

std::vector<Named> force_operations() {
    return {{"force", on_bodies}, {"forces", on_batch}};
}

} // namespace fuzz
