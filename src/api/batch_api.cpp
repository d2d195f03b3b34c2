// Batches: creation, turbulence, loads, divisor, views, rules and emitters.
#include "api/checked_call.h"
#include "api/struct_conversion.h"
#include "world/batch/lifecycle.h"

namespace lr::api {
namespace {

bool one_of(int32_t value, int32_t last) {
    return value >= 0 && value <= last;
}

// Null if valid, else the reason.
const char* wrong_in(const lr_batch_desc& d) {
    if (d.capacity == 0 || d.capacity > max_capacity) return "capacity is not 1 to 2^26";
    if (!one_of(d.load_model, LR_LOADS_AERODYNAMIC)) return "unknown load_model";
    if (!one_of(d.clock, LR_CLOCK_AGE)) return "unknown clock";
    if (!one_of(d.table_end, LR_TABLE_LOOP)) return "unknown table_end";
    if (!one_of(d.integrator, LR_INTEGRATOR_SPLITTING)) return "unknown integrator";
    if (!in_range(d.variation, 0.0, 0.5)) return "variation is not 0 to 0.5";
    return wrong_in(Gains{.damping = wide(d.damping_gain), .noise = wide(d.noise_gain)});
}

// Distance between written elements; 0 if stride or alignment does not fit elements of `bytes`.
uint64_t step_of(uint64_t stride, uint32_t bytes, const void* dst) {
    const uint64_t step = stride == 0 ? bytes : stride;
    const bool fits = step >= bytes && step % 4 == 0 && step <= (uint64_t{1} << 32);
    return fits && reinterpret_cast<uintptr_t>(dst) % 4 == 0 ? step : 0;
}

TableHead head_of(const lr_turbulence_table& t) {
    return {t.count, t.stationary, wide(t.dt), wide(t.u0), wide(t.l), wide(t.c0)};
}

Outcome check(const lr_turbulence_table& t) {
    if (!finite(t.dt, t.u0, t.l, t.c0)) return LR_ERROR_NOT_FINITE;
    const TableHead head = head_of(t);
    if (const char* why = wrong_in(head)) return invalid(why);
    if (!t.chi || !t.epsilon) return LR_ERROR_NULL_ARGUMENT;
    for (uint32_t i = 0; i < t.count; ++i) {
        if (!finite(t.chi[i], t.epsilon[i])) return LR_ERROR_NOT_FINITE;
        if (const char* why = wrong_in(head.sample(t.chi[i], t.epsilon[i]))) return invalid(why);
    }
    return {};
}
} // namespace

static void record_argument(Call& call, const lr_turbulence_table* table) {
    lr_turbulence_table t{};
    if (!call.reads(table)) return;
    copy_struct(table, t);
    const recording::TableRecord record{t.count, t.dt, t.u0, t.l, t.c0, t.stationary, t.reserved};
    call.value(static_cast<uint32_t>(recording::Where::here));
    call.raw(&record, sizeof record);
    call.shared_array(t.chi, sizeof(float) * uint64_t{t.count});
    call.shared_array(t.epsilon, sizeof(float) * uint64_t{t.count});
}
} // namespace lr::api

using namespace lr;
using namespace lr::api;

extern "C" {

lr_status lr_batch_create(lr_world* world, const lr_batch_desc* desc, lr_batch* out) {
    if (out) *out = {};
    const auto create = [](lr_world& w, lr_batch& handle, const lr_batch_desc& d) -> Outcome {
        if (!d.asset) return {LR_ERROR_NULL_ARGUMENT, "desc->asset is null"};
        if (!finite(d.damping_gain, d.noise_gain, d.variation)) return LR_ERROR_NOT_FINITE;
        if (const char* why = wrong_in(d)) return invalid(why);
        if (!accepted(w)) return LR_ERROR_OUT_OF_MEMORY;
        BatchSettings settings;
        settings.desc = d;
        settings.gains = {.damping = wide(d.damping_gain), .noise = wide(d.noise_gain)};
        const AssetData& asset = d.asset->data;
        settings.viscosity = w.fluid_viscosity > 0.0f ? wide(w.fluid_viscosity) : asset.fluid_viscosity;
        settings.fluid_density = w.fluid_density > 0.0f ? wide(w.fluid_density) : asset.fluid_density;
        return w.create_batch(*d.asset, d.capacity, settings, handle);
    };
    return change(world, args(Required(out), desc), create);
}

lr_status lr_batch_destroy(lr_world* world, lr_batch batch) {
    return change(world, args(batch), [batch](lr_world& w, Batch&) { w.destroy_batch(batch); });
}

int32_t lr_batch_is_valid(const lr_world* world, lr_batch batch) {
    return is_valid<Batch&>(world, batch);
}

lr_status lr_batch_set_turbulence_table(lr_world* world, lr_batch batch, const lr_turbulence_table* table) {
    return change(world, args(batch, table), [](lr_world& w, Batch& b, const lr_turbulence_table* t) -> Outcome {
        if (!t) return b.set_table(b.asset_table(), nullptr, nullptr) ? LR_OK : LR_ERROR_OUT_OF_MEMORY;
        if (const Outcome outcome = check(*t); outcome.refused()) return outcome;
        return accepted(w) && b.set_table(head_of(*t), t->chi, t->epsilon) ? LR_OK : LR_ERROR_OUT_OF_MEMORY;
    });
}

lr_status lr_batch_get_turbulence_table(const lr_world* world, lr_batch batch, lr_turbulence_table* table, float* chi,
                                        float* epsilon, uint32_t capacity) {
    return query(world, args(batch, table), [&](const lr_world&, const Batch& b, lr_turbulence_table& out) -> Outcome {
        const TableHead& head = b.table();
        out.count = head.count;
        out.stationary = head.stationary;
        out.dt = static_cast<float>(head.dt);
        out.u0 = static_cast<float>(head.u0);
        out.l = static_cast<float>(head.l);
        out.c0 = static_cast<float>(head.c0);
        if ((chi || epsilon) && capacity < head.count) {
            write_struct(out, table);
            return LR_ERROR_BUFFER_TOO_SMALL;
        }
        if (chi) std::copy_n(b.table_chi(), head.count, chi);
        if (epsilon) std::copy_n(b.table_epsilon(), head.count, epsilon);
        return {};
    });
}

lr_status lr_batch_set_rate(lr_world* world, lr_batch batch, uint32_t divisor) {
    return change(world, args(batch, divisor), [](lr_world&, Batch& b, uint32_t n) -> Outcome {
        if (n < 1 || n > BatchClock::largest_of_all) return invalid("divisor is not 1 to 1024");
        b.pace.set_divisor(n);
        return {};
    });
}

lr_status lr_batch_get_pace(const lr_world* world, lr_batch batch, lr_batch_pace* pace) {
    return query(world, args(batch, pace), [](const lr_world&, const Batch& b, lr_batch_pace& out) {
        const BatchClock::Record& r = b.pace.record();
        out.divisor = r.divisor;
        out.substeps = b.pace.granted();
        out.waited = r.steps;
        out.behind = r.behind;
        out.lost = r.lost;
        out.body_substeps = r.taken;
    });
}

lr_status lr_batch_set_divergence_policy(lr_world* world, lr_batch batch, int32_t policy) {
    return change(world, args(batch, policy), [](lr_world&, Batch& b, int32_t p) -> Outcome {
        BatchOptions options = b.options;
        options.divergence_policy = p;
        if (const char* why = wrong_in(options)) return invalid(why);
        if (p == LR_DIVERGENCE_REMOVE && !b.reserve_lifecycle()) return LR_ERROR_OUT_OF_MEMORY;
        b.options = options;
        return {};
    });
}

lr_status lr_batch_get_divergence_policy(const lr_world* world, lr_batch batch, int32_t* policy) {
    const auto get = [](const lr_world&, const Batch& b, int32_t& out) { out = b.options.divergence_policy; };
    return query(world, args(batch, Required(policy)), get);
}

lr_status lr_batch_get_view(const lr_world* world, lr_batch batch, lr_batch_view* view) {
    return query(world, args(batch, view), [](const lr_world&, const Batch& b, lr_batch_view& out) {
        const BatchArrays& a = b.arrays();
        out.count = b.count();
        out.capacity = b.capacity();
        for (size_t i = 0; i < 3; ++i) out.position[i] = a.field[field_x + i];
        for (size_t i = 0; i < 4; ++i) out.orientation[i] = a.field[field_qx + i];
        out.scale = a.field[field_scale];
        out.age = a.field[field_age];
        out.noise_seed = a.noise_seed;
        out.ids = b.ids();
        out.user = b.users();
        out.revision = b.revision();
        out.awake_count = b.awake();
    });
}

lr_status lr_batch_get_bounds(const lr_world* world, lr_batch batch, float* low, float* high) {
    const auto get = [](const lr_world&, const Batch& b, float* lows, float* highs) -> Outcome {
        if (!lows || !highs) return LR_ERROR_NULL_ARGUMENT;
        const Box box = b.box();
        put(box.low, lows);
        put(box.high, highs);
        return {};
    };
    return query(world, args(batch, low, high), get);
}

lr_status lr_batch_write_transforms(const lr_world* world, lr_batch batch, int32_t format, void* dst, uint64_t stride,
                                    uint32_t count, uint32_t* written) {
    if (written) *written = 0;
    return query(world, args(batch), [&](const lr_world& w, const Batch& b) -> Outcome {
        const uint32_t bytes = transform_bytes(format);
        if (bytes == 0) return invalid("unknown format");
        const uint64_t step = step_of(stride, bytes, dst);
        if (step == 0) return invalid("stride or alignment is wrong for this format");
        const uint32_t n = std::min(count, b.count());
        if (n == 0) return {};
        if (!dst) return LR_ERROR_NULL_ARGUMENT;
        w.target->write_transforms(b.arrays(), n, static_cast<float>(b.pace.behind()), format, dst, step);
        if (written) *written = n;
        return {};
    });
}

lr_status lr_batch_write_velocities(const lr_world* world, lr_batch batch, void* dst, uint64_t stride, uint32_t count,
                                    uint32_t* written) {
    if (written) *written = 0;
    return query(world, args(batch), [&](const lr_world&, const Batch& b) -> Outcome {
        const uint64_t step = step_of(stride, 6 * sizeof(float), dst);
        if (step == 0) return invalid("stride or alignment is wrong for 6 floats");
        const uint32_t n = std::min(count, b.count());
        if (n == 0) return {};
        if (!dst) return LR_ERROR_NULL_ARGUMENT;
        const BatchArrays& a = b.arrays();
        for (uint32_t i = 0; i < n; ++i) {
            auto* const to = reinterpret_cast<float*>(static_cast<unsigned char*>(dst) + step * i);
            const Rotation q = pose_of(a, i).rotation;
            put(to_world(q, vector_in(a.field, field_vx, i)), to);
            put(to_world(q, vector_in(a.field, field_wx, i)), to + 3);
        }
        if (written) *written = n;
        return {};
    });
}

lr_status lr_batch_set_aerodynamics(lr_world* world, lr_batch batch, const lr_aerodynamics* aerodynamics) {
    return change(world, args(batch, aerodynamics), [](lr_world&, Batch& b, const lr_aerodynamics* given) -> Outcome {
        if (!given) return b.set_aerodynamics(b.asset().data.aerodynamics, b.gains()) ? LR_OK : LR_ERROR_INTERNAL;
        AerodynamicData loads = b.asset().data.aerodynamics;
        if (const lr_status status = read_loads(given, loads); status != LR_OK) return status;
        if (const char* why = wrong_in(loads)) return invalid(why);
        return b.set_aerodynamics(loads, b.gains()) ? Outcome{} : invalid("center is farther than 2 d");
    });
}

lr_status lr_batch_get_aerodynamics(const lr_world* world, lr_batch batch, lr_aerodynamics* aerodynamics) {
    const auto get = [](const lr_world&, const Batch& b, lr_aerodynamics& out) { out = to_struct(b.aerodynamics()); };
    return query(world, args(batch, aerodynamics), get);
}

lr_status lr_batch_set_load_gains(lr_world* world, lr_batch batch, const lr_load_gains* gains) {
    return change(world, args(batch, gains), [](lr_world&, Batch& b, const lr_load_gains* given) -> Outcome {
        lr_load_gains g{};
        lr_load_gains_init(&g, sizeof g);
        if (given) g = *given;
        if (!finite(g.drag, g.lift, g.spin_drag, g.turbulence)) return LR_ERROR_NOT_FINITE;
        Gains all = b.gains();
        all.drag = wide(g.drag);
        all.lift = wide(g.lift);
        all.spin_drag = wide(g.spin_drag);
        all.turbulence = wide(g.turbulence);
        if (const char* why = wrong_in(all)) return invalid(why);
        return b.set_aerodynamics(b.aerodynamics(), all) ? LR_OK : LR_ERROR_INTERNAL;
    });
}

lr_status lr_batch_get_load_gains(const lr_world* world, lr_batch batch, lr_load_gains* gains) {
    return query(world, args(batch, gains), [](const lr_world&, const Batch& b, lr_load_gains& out) {
        out.drag = static_cast<float>(b.gains().drag);
        out.lift = static_cast<float>(b.gains().lift);
        out.spin_drag = static_cast<float>(b.gains().spin_drag);
        out.turbulence = static_cast<float>(b.gains().turbulence);
    });
}

lr_status lr_batch_set_rules(lr_world* world, lr_batch batch, const lr_batch_rules* rules) {
    return change(world, args(batch, rules), [](lr_world&, Batch& b, const lr_batch_rules* r) -> Outcome {
        if (!r) {
            if (b.lifecycle()) b.lifecycle()->set_rules(nullptr);
            return {};
        }
        if (const Outcome outcome = check(*r); outcome.refused()) return outcome;
        if (r->action == LR_END_RESPAWN && (!b.lifecycle() || !b.lifecycle()->has_emitter()))
            return invalid("LR_END_RESPAWN needs an emitter: set it first");
        if (!b.reserve_lifecycle()) return LR_ERROR_OUT_OF_MEMORY;
        b.lifecycle()->set_rules(r);
        if (b.sleeping()) b.sleeping()->ask_again();
        return {};
    });
}

lr_status lr_batch_get_rules(const lr_world* world, lr_batch batch, lr_batch_rules* rules, int32_t* present) {
    const auto get = [](const lr_world&, const Batch& b, lr_batch_rules& out, int32_t& there) {
        const bool any = b.lifecycle() && b.lifecycle()->has_rules();
        read_back(any ? &b.lifecycle()->state().rules : nullptr, lr_batch_rules_init, out, there);
    };
    return query(world, args(batch, rules, Required(present)), get);
}

lr_status lr_batch_set_emitter(lr_world* world, lr_batch batch, const lr_emitter_desc* desc) {
    return change(world, args(batch, desc), [](lr_world&, Batch& b, const lr_emitter_desc* d) -> Outcome {
        if (!d) {
            if (b.lifecycle() && b.lifecycle()->respawns()) return invalid("the rules respawn: change them first");
            if (b.lifecycle()) b.lifecycle()->set_emitter(nullptr);
            return {};
        }
        if (const Outcome outcome = check(*d); outcome.refused()) return outcome;
        if (!b.reserve_lifecycle()) return LR_ERROR_OUT_OF_MEMORY;
        b.lifecycle()->set_emitter(d);
        return {};
    });
}

lr_status lr_batch_get_emitter(const lr_world* world, lr_batch batch, lr_emitter_desc* desc, int32_t* present) {
    const auto get = [](const lr_world&, const Batch& b, lr_emitter_desc& out, int32_t& there) {
        const bool any = b.lifecycle() && b.lifecycle()->has_emitter();
        read_back(any ? &b.lifecycle()->state().emitter : nullptr, lr_emitter_desc_init, out, there);
    };
    return query(world, args(batch, desc, Required(present)), get);
}

lr_status lr_batch_spawn(lr_world* world, lr_batch batch, uint32_t count, lr_body* out_ids) {
    const auto emit = [](lr_world& w, Batch& b, uint32_t n, Out<lr_body> ids) -> Outcome {
        if (n == 0) return {};
        if (!b.lifecycle() || !b.lifecycle()->has_emitter()) return invalid("the batch has no emitter");
        if (n > b.capacity() - b.count()) return LR_ERROR_CAPACITY;
        b.lifecycle()->emit(b, w, n, ids.first);
        return {};
    };
    return change(world, args(batch, count, Out{out_ids, count}), emit);
}

lr_status lr_batch_spawn_box(lr_world* world, lr_batch batch, const float* low, const float* high, uint32_t count,
                             lr_body* out_ids) {
    const auto fill = [](lr_world& w, Batch& b, Triple from, Triple to, uint32_t n, Out<lr_body> ids) -> Outcome {
        if (!within(from, most_place) || !within(to, most_place)) return invalid("a corner is over 1e9 m away");
        if (from[0] > to[0] || from[1] > to[1] || from[2] > to[2]) return invalid("low is above high");
        if (n > b.capacity() - b.count()) return LR_ERROR_CAPACITY;
        if (!accepted(w)) return LR_ERROR_OUT_OF_MEMORY;
        spawn_in({vector_of(from), vector_of(to)}, b, w, n, ids.first);
        return {};
    };
    return change(world, args(batch, low, high, count, Out{out_ids, count}), fill);
}

lr_status lr_batch_get_counts(const lr_world* world, lr_batch batch, lr_batch_counts* counts) {
    return query(world, args(batch, counts), [](const lr_world&, const Batch& b, lr_batch_counts& out) {
        if (b.lifecycle()) b.lifecycle()->report(out);
        out.diverged = b.faults.last;
        out.total_diverged = b.faults.total;
    });
}

} // extern "C"
