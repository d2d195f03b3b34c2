// Settings of a whole batch: coefficients, gains, tables, forces.
#include "fuzz/api/model.h"
#include "support/aerodynamic_fields.h"

namespace fuzz {
namespace {

void aerodynamics(Fuzzer& f) {
    World& w = f.world();
    Input& in = f.in;
    const lr_batch id = f.pick_batch(w, in.handle(0));
    const Batch* const b = w.find(id);
    lr_aerodynamics a = initialised(LR_CALL(lr_aerodynamics_init));
    if (b && w.at && LR_CALL(lr_batch_get_aerodynamics)(w.at, id, &a) != LR_OK)
        defect("lr_batch_get_aerodynamics", "failed");
#define LR_FIELD(name, ...) a.name,
    in.change(a.axes, LR_AERODYNAMIC_VECTORS(LR_FIELD) LR_AERODYNAMIC_NUMBERS(LR_FIELD) a.reserved);
#undef LR_FIELD
    Expected e;
    if (!in.null(1)) {
        for (double x : a.axes) e.finite(x);
        for (const test::AerodynamicField& field : test::aerodynamic_fields)
            for (size_t k = 0; k < field.size; ++k) e.range(field.in(a)[k], field.least, field.most);
        e.add_if(a.reserved != 0, LR_ERROR_INVALID_ARGUMENT);
        e.may(LR_ERROR_INVALID_ARGUMENT); // axes that are not a rotation, or on the fast path not the body's
    }
    e.add_if(!b, LR_ERROR_STALE_BATCH);
    Given<lr_aerodynamics> given(in, a, 1, e, true);
    Call call(f, w, "lr_batch_set_aerodynamics", e);
    if (!call.ended(LR_CALL(lr_batch_set_aerodynamics)(call.world(), id, given.get())) || !given.get() || w.state.loose)
        return;
    lr_aerodynamics got = initialised(LR_CALL(lr_aerodynamics_init));
    if (LR_CALL(lr_batch_get_aerodynamics)(w.at, id, &got) != LR_OK || std::memcmp(&got, &a, sizeof a) != 0)
        defect("lr_batch_get_aerodynamics", "not what was set");
    if ((in.value(0) | in.value(1)) != 0 && in.flag(3)) w.state.wild = true; // coefficients of no real body
}

void gains(Fuzzer& f) {
    World& w = f.world();
    Input& in = f.in;
    lr_load_gains g = initialised(LR_CALL(lr_load_gains_init));
    in.change(g.drag, g.lift, g.spin_drag, g.turbulence, g.reserved);
    const lr_batch id = f.pick_batch(w, in.handle(0));
    Expected e;
    if (!in.null(1)) {
        for (float v : {g.drag, g.lift, g.spin_drag, g.turbulence}) e.range(v, 0.0, 100.0);
        e.add_if(g.reserved != 0, LR_ERROR_INVALID_ARGUMENT);
    }
    e.add_if(!w.find(id), LR_ERROR_STALE_BATCH);
    Given<lr_load_gains> given(in, g, 1, e, true);
    Call call(f, w, "lr_batch_set_load_gains", e);
    if (!call.ended(LR_CALL(lr_batch_set_load_gains)(call.world(), id, given.get()))) return;
    lr_load_gains got = initialised(LR_CALL(lr_load_gains_init));
    if (LR_CALL(lr_batch_get_load_gains)(w.at, id, &got) != LR_OK ||
        (given.get() && std::memcmp(&got, &g, sizeof g) != 0))
        defect("lr_batch_get_load_gains", "not what was set");
}

void table(Fuzzer& f) {
    World& w = f.world();
    Input& in = f.in;
    constexpr uint32_t most = 8;
    float chi[most], epsilon[most];
    for (uint32_t i = 0; i < most; ++i) chi[i] = epsilon[i] = 1.0f / static_cast<float>(i + 1);
    lr_turbulence_table t = initialised(LR_CALL(lr_turbulence_table_init));
    t.count = 1 + in.handle(1) % most, t.dt = 0.1f, t.u0 = 1.0f, t.l = 0.05f;
    in.change(t.count, t.dt, t.u0, t.l, t.c0, t.stationary, chi[0], epsilon[0], t.reserved);
    if (t.count > most && t.count <= 65536) t.count = most; // otherwise the caller would state a wrong length
    // Copied to blocks of exactly their size.
    std::vector<float> c(chi, chi + std::min(t.count, most)), s(epsilon, epsilon + std::min(t.count, most));
    t.chi = in.variant() == 1 && in.flag(flag_null) ? nullptr : c.data();
    t.epsilon = in.variant() == 2 && in.flag(flag_null) ? nullptr : s.data();
    const lr_batch id = f.pick_batch(w, in.handle(0));
    Expected e;
    if (!in.null(1)) {
        for (float v : {t.dt, t.u0, t.l, t.c0}) {
            e.range(v, 0.0, 1e30);
            e.add_if(v == 0.0f, LR_ERROR_INVALID_ARGUMENT);
            e.may_if(v < 1e-8f || v > 99.0f, LR_ERROR_INVALID_ARGUMENT);
        }
        e.add_if(t.count == 0 || t.count > 65536 || t.stationary >= t.count || t.reserved != 0,
                 LR_ERROR_INVALID_ARGUMENT);
        e.add_if(!t.chi || !t.epsilon, LR_ERROR_NULL_ARGUMENT);
        if (!c.empty() && t.chi && t.epsilon)
            for (float v : {c[0], s[0]}) {
                e.range(v, 0.0, 1e38);
                e.may_if(v > 1e8f, LR_ERROR_INVALID_ARGUMENT);
            }
    }
    e.add_if(!w.find(id), LR_ERROR_STALE_BATCH);
    Given<lr_turbulence_table> given(in, t, 1, e, true);
    Call call(f, w, "lr_batch_set_turbulence_table", e);
    if (!call.ended(LR_CALL(lr_batch_set_turbulence_table)(call.world(), id, given.get())) || !given.get()) return;
    lr_turbulence_table got = t;
    float chis[most], epsilons[most];
    if (LR_CALL(lr_batch_get_turbulence_table)(w.at, id, &got, chis, epsilons, most) != LR_OK || got.chi ||
        got.epsilon || !std::equal(c.begin(), c.end(), chis) || !std::equal(s.begin(), s.end(), epsilons))
        defect("lr_batch_get_turbulence_table", "not what was set");
    got.chi = t.chi, got.epsilon = t.epsilon;
    if (std::memcmp(&got, &t, sizeof t) != 0) defect("lr_batch_get_turbulence_table", "not what was set");
}

void field(Fuzzer& f) {
    World& w = f.world();
    Input& in = f.in;
    lr_batch_force d = initialised(LR_CALL(lr_batch_force_init));
    in.change(d.force, d.torque, d.acceleration, d.angular_acceleration, d.body_force, d.body_torque,
              d.body_acceleration, d.body_angular_acceleration, d.reserved);
    const lr_batch id = f.pick_batch(w, in.handle(0));
    Expected e;
    bool strong = false;
    if (!in.null(1)) {
        for (const auto* v : {&d.force, &d.torque, &d.acceleration, &d.angular_acceleration, &d.body_force,
                              &d.body_torque, &d.body_acceleration, &d.body_angular_acceleration}) {
            e.range(*v, -1e9, 1e9);
            for (float x : *v) strong = strong || x != 0.0f;
        }
        e.add_if(d.reserved != 0, LR_ERROR_INVALID_ARGUMENT);
    }
    e.add_if(!w.find(id), LR_ERROR_STALE_BATCH);
    Given<lr_batch_force> given(in, d, 1, e, true);
    Call call(f, w, "lr_batch_set_force", e);
    // Newtons on a leaf of a gram, for the whole life of the world.
    if (!call.ended(LR_CALL(lr_batch_set_force)(call.world(), id, given.get()))) return;
    if (strong) w.state.wild = true;
    lr_batch_force got = initialised(LR_CALL(lr_batch_force_init));
    const bool read = LR_CALL(lr_batch_get_force)(w.at, id, &got) == LR_OK;
    for (size_t k = 0; k < 3; ++k)
        if (!read || (given.get() && (got.force[k] != d.force[k] || got.body_torque[k] != d.body_torque[k])))
            defect("lr_batch_get_force", "not what was set");
}

} // namespace

std::vector<Named> load_operations() {
    return {{"aerodynamics", aerodynamics}, {"gains", gains}, {"table", table}, {"field", field}};
}

} // namespace fuzz
