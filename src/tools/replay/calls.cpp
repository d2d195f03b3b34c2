// Each recorded call, made again.
#include "tools/replay/player.h"

namespace lr::replay {
namespace {

using record::Op;

uint64_t output_of(const uint64_t* ids, size_t count) {
    if (count == 1) return ids[0];
    if (count == 0) return 0;
    record::Hash hash(count);
    hash.add(ids, sizeof(uint64_t) * count);
    return hash.value();
}

// A struct of a batch, or null.
template <class T>
lr_status set(lr_status (*function)(lr_world*, lr_batch, const T*), Arguments& from, const Scene& scene) {
    const auto batch = from.value<lr_batch>();
    T s;
    const bool given = from.structure(s);
    from.end();
    return function(scene.world, batch, given ? &s : nullptr);
}
template <class T> lr_status set(lr_status (*function)(lr_world*, const T*), Arguments& from, const Scene& scene) {
    T s;
    const bool given = from.structure(s);
    from.end();
    return function(scene.world, given ? &s : nullptr);
}
template <class T>
lr_status each(lr_status (*function)(lr_world*, const T*, uint32_t), Arguments& from, const Scene& scene) {
    uint32_t count = 0;
    std::vector<T> all;
    const bool given = from.structures(count, all);
    from.end();
    return function(scene.world, given ? all.data() : nullptr, count);
}

// A grid's samples, as many as its desc says; kept ones are not given.
bool source(Arguments& from, lr_wind_source_desc& d, Array& samples) {
    if (!from.structure(d)) return false;
    samples = from.array(Arguments::any);
    const uint64_t plane = uint64_t{d.counts[0]} * d.counts[1], solid = uint64_t{d.counts[2]} * d.frames;
    const uint64_t floats = samples.bytes.size() / sizeof(float);
    // Products of two counts fit; that of all four is looked at by a division.
    if (samples.given && d.kind == LR_WIND_SOURCE_GRID &&
        (samples.bytes.size() % 12 != 0 || plane == 0 || solid == 0 || (floats / 3) % plane != 0 ||
         floats / 3 / plane != solid))
        Arguments::wrong("samples of another number than their grid has");
    d.samples = samples.as<float>();
    return true;
}

lr_status add_wind(Arguments& from, const Scene& scene, uint64_t& output) {
    lr_wind_source_desc d;
    Array samples;
    const bool given = source(from, d, samples);
    from.end();
    lr_wind_source out = 0;
    const lr_status status = lr_world_add_wind(scene.world, given ? &d : nullptr, &out);
    output = out;
    return status;
}

lr_status update_wind(Arguments& from, const Scene& scene) {
    const auto handle = from.value<lr_wind_source>();
    lr_wind_source_desc d;
    Array samples;
    const bool given = source(from, d, samples);
    from.end();
    return lr_world_update_wind(scene.world, handle, given ? &d : nullptr);
}

lr_status create_batch(Arguments& from, const Scene& scene, uint64_t& output) {
    record::BatchRecord r;
    lr_batch out = 0;
    if (!from.plain(r)) return lr_batch_create(scene.world, nullptr, &out);
    from.end();
    if (r.asset >= scene.assets.size()) Arguments::wrong("an asset that it does not have");
    lr_batch_desc d;
    lr_batch_desc_init(&d, sizeof d);
    d.asset = scene.assets[r.asset];
    d.capacity = r.capacity;
    d.load_model = r.load_model;
    d.clock = r.clock;
    d.table_end = r.table_end;
    d.integrator = r.integrator;
    d.damping_gain = r.damping_gain;
    d.noise_gain = r.noise_gain;
    const lr_status status = lr_batch_create(scene.world, &d, &out);
    output = out;
    return status;
}

lr_status set_table(Arguments& from, const Scene& scene) {
    const auto batch = from.value<lr_batch>();
    record::TableRecord r;
    if (!from.plain(r)) return lr_batch_set_turbulence_table(scene.world, batch, nullptr);
    const uint64_t bytes = sizeof(float) * uint64_t{r.count};
    const Array chi = from.array(bytes), epsilon = from.array(bytes);
    from.end();
    lr_turbulence_table t;
    lr_turbulence_table_init(&t, sizeof t);
    t.count = r.count;
    t.dt = r.dt, t.u0 = r.u0, t.l = r.l, t.c0 = r.c0;
    t.stationary = r.stationary;
    t.reserved = r.reserved;
    t.chi = chi.as<float>();
    t.epsilon = epsilon.as<float>();
    return lr_batch_set_turbulence_table(scene.world, batch, &t);
}

lr_status add_forces(Arguments& from, const Scene& scene) {
    const auto batch = from.value<lr_batch>();
    lr_force_arrays a;
    if (!from.structure(a)) return lr_batch_add_forces(scene.world, batch, nullptr);
    Array rows[6];
    for (Array& row : rows) row = from.floats(a.count);
    from.end();
    a.stride = 0;
    for (size_t k = 0; k < 3; ++k) {
        a.force[k] = rows[k].as<float>();
        a.torque[k] = rows[3 + k].as<float>();
    }
    return lr_batch_add_forces(scene.world, batch, &a);
}

lr_status emit(Arguments& from, const Scene& scene, uint64_t& output) {
    const auto batch = from.value<lr_batch>();
    const auto count = from.value<uint32_t>();
    from.end();
    lr_batch_view view;
    lr_batch_view_init(&view, sizeof view);
    const bool there = lr_batch_get_view(scene.world, batch, &view) == LR_OK && count <= view.capacity - view.count;
    std::vector<lr_body> ids(there ? count : 0); // else it is refused
    const lr_status status = lr_batch_emit(scene.world, batch, count, there ? ids.data() : nullptr);
    output = output_of(ids.data(), ids.size());
    return status;
}

lr_status create_bodies(Arguments& from, const Scene& scene, uint64_t& output) {
    const auto batch = from.value<lr_batch>();
    uint32_t count = 0;
    std::vector<lr_body_desc> descs;
    const bool given = from.structures(count, descs);
    from.end();
    std::vector<lr_body> ids(descs.size());
    const lr_status status =
        lr_body_create(scene.world, batch, given ? descs.data() : nullptr, count, given ? ids.data() : nullptr);
    output = output_of(ids.data(), ids.size());
    return status;
}

lr_status create_colliders(Arguments& from, const Scene& scene, uint64_t& output) {
    uint32_t count = 0;
    std::vector<lr_collider_desc> descs;
    std::vector<Array> arrays; // whose bytes do not move when it grows
    const bool given = from.structures(count, descs, [&](lr_collider_desc& d) {
        arrays.push_back(from.array(12 * uint64_t{d.vertex_count}));
        d.vertices = arrays.back().as<float>();
        arrays.push_back(from.array(12 * uint64_t{d.triangle_count}));
        d.indices = arrays.back().as<uint32_t>();
        arrays.push_back(from.array(Arguments::any));
        const uint64_t heights = uint64_t{d.counts[0]} * d.counts[1];
        if (arrays.back().given && (heights > UINT64_MAX / 4 || arrays.back().bytes.size() != 4 * heights))
            Arguments::wrong("heights of another number than their field has");
        d.heights = arrays.back().as<float>();
    });
    from.end();
    std::vector<lr_collider> ids(descs.size());
    const lr_status status =
        lr_collider_create(scene.world, given ? descs.data() : nullptr, count, given ? ids.data() : nullptr);
    output = output_of(ids.data(), ids.size());
    return status;
}

lr_status wake_box(Arguments& from, const Scene& scene, uint64_t& output) {
    const Array low = from.array(12), high = from.array(12);
    from.end();
    uint32_t woken = 0;
    const lr_status status = lr_world_wake_box(scene.world, low.as<float>(), high.as<float>(), &woken);
    output = woken;
    return status;
}

lr_status set_surface_of_colliders(Arguments& from, const Scene& scene) {
    const auto count = from.value<uint32_t>();
    lr_collider_surface s;
    const bool given = from.structure(s);
    const Array ids = from.array(8 * uint64_t{count});
    from.end();
    return lr_collider_set_surface(scene.world, ids.as<lr_collider>(), count, given ? &s : nullptr);
}

} // namespace

lr_status perform(Op op, Arguments& from, Scene& scene, uint64_t& output) {
    lr_world* const w = scene.world;
    output = 0;
    switch (op) {
    case Op::world_step: {
        const auto dt = from.value<float>();
        const auto substeps = from.value<uint32_t>();
        from.end();
        return lr_world_step(w, dt, substeps);
    }
    case Op::world_set_gravity: {
        const Array gravity = from.array(12);
        from.end();
        return lr_world_set_gravity(w, gravity.as<float>());
    }
    case Op::world_set_simd_target: // of the machine that recorded: bits do not depend on it
        from.value<int32_t>();
        from.end();
        return LR_OK;
    case Op::world_set_wind:
        return set(&lr_world_set_wind, from, scene);
    case Op::world_add_wind:
        return add_wind(from, scene, output);
    case Op::world_update_wind:
        return update_wind(from, scene);
    case Op::world_remove_wind: {
        const auto handle = from.value<lr_wind_source>();
        from.end();
        return lr_world_remove_wind(w, handle);
    }
    case Op::world_set_wind_callback: {
        const bool on = from.value<uint32_t>() != 0;
        from.end();
        return lr_world_set_wind_callback(w, on ? &Answers::wind : nullptr, &scene.wind);
    }
    case Op::world_set_surface:
        return set(&lr_world_set_surface, from, scene);
    case Op::world_set_surface_callback: {
        const bool on = from.value<uint32_t>() != 0;
        from.end();
        return lr_world_set_surface_callback(w, on ? &Answers::surface : nullptr, &scene.surface);
    }
    case Op::world_set_budget: {
        const auto body_substeps = from.value<uint64_t>();
        from.end();
        return lr_world_set_budget(w, body_substeps);
    }
    case Op::world_snapshot_restore: {
        const Array memory = from.array(Arguments::any);
        from.end();
        return lr_world_snapshot_restore(w, memory.as<unsigned char>(), memory.bytes.size());
    }
    case Op::world_set_contact_events: {
        const auto capacity = from.value<uint32_t>();
        const auto kinds = from.value<uint32_t>();
        from.end();
        return lr_world_set_contact_events(w, capacity, kinds);
    }
    case Op::world_wake_box:
        return wake_box(from, scene, output);
    case Op::batch_create:
        return create_batch(from, scene, output);
    case Op::batch_destroy: {
        const auto batch = from.value<lr_batch>();
        from.end();
        return lr_batch_destroy(w, batch);
    }
    case Op::batch_set_turbulence_table:
        return set_table(from, scene);
    case Op::batch_set_aerodynamics:
        return set(&lr_batch_set_aerodynamics, from, scene);
    case Op::batch_set_load_gains:
        return set(&lr_batch_set_load_gains, from, scene);
    case Op::batch_set_rate: {
        const auto batch = from.value<lr_batch>();
        const auto divisor = from.value<uint32_t>();
        from.end();
        return lr_batch_set_rate(w, batch, divisor);
    }
    case Op::batch_add_forces:
        return add_forces(from, scene);
    case Op::batch_set_force:
        return set(&lr_batch_set_force, from, scene);
    case Op::batch_set_contact:
        return set(&lr_batch_set_contact, from, scene);
    case Op::batch_set_pair_contact: {
        const auto a = from.value<lr_batch>(), b = from.value<lr_batch>();
        const auto enabled = from.value<int32_t>();
        from.end();
        return lr_batch_set_pair_contact(w, a, b, enabled);
    }
    case Op::batch_set_fault_policy: {
        const auto batch = from.value<lr_batch>();
        const auto policy = from.value<int32_t>();
        from.end();
        return lr_batch_set_fault_policy(w, batch, policy);
    }
    case Op::batch_set_rules:
        return set(&lr_batch_set_rules, from, scene);
    case Op::batch_set_emitter:
        return set(&lr_batch_set_emitter, from, scene);
    case Op::batch_emit:
        return emit(from, scene, output);
    case Op::body_create:
        return create_bodies(from, scene, output);
    case Op::body_destroy: {
        const auto count = from.value<uint32_t>();
        const Array ids = from.array(8 * uint64_t{count});
        from.end();
        return lr_body_destroy(w, ids.as<lr_body>(), count);
    }
    case Op::body_set_state: {
        const auto body = from.value<lr_body>();
        lr_body_state s;
        const bool given = from.structure(s);
        from.end();
        return lr_body_set_state(w, body, given ? &s : nullptr);
    }
    case Op::body_set_rest: {
        const auto count = from.value<uint32_t>();
        const auto rest = from.value<int32_t>();
        const Array ids = from.array(8 * uint64_t{count});
        from.end();
        return lr_body_set_rest(w, ids.as<lr_body>(), count, rest);
    }
    case Op::body_add_force:
        return each(&lr_body_add_force, from, scene);
    case Op::collider_create:
        return create_colliders(from, scene, output);
    case Op::collider_destroy: {
        const auto count = from.value<uint32_t>();
        const Array ids = from.array(8 * uint64_t{count});
        from.end();
        return lr_collider_destroy(w, ids.as<lr_collider>(), count);
    }
    case Op::collider_move:
        return each(&lr_collider_move, from, scene);
    case Op::collider_set_surface:
        return set_surface_of_colliders(from, scene);
    }
    throw Fault(FaultId::unknown_call, "a call with the number " + std::to_string(static_cast<uint32_t>(op)));
}

} // namespace lr::replay
