// Executes recorded calls.
#include "tools/lr_replay/player.h"

#include <tuple>
#include <type_traits>

namespace lr::replay {
namespace {

using recording::Op;

// The output of a call that made bodies or colliders.
template <class H> uint64_t output_of(const std::vector<H>& ids, Scene& scene) {
    for (const H& made : ids) scene.made.push_back(made.id);
    if (ids.empty()) return 0;
    if (ids.size() == 1) return ids[0].id;
    recording::Hash hash(ids.size());
    hash.add(ids.data(), sizeof(H) * ids.size());
    return hash.value();
}

// Reads an argument as api/checked_call.h writes it.
template <class T> struct Read {
    explicit Read(Arguments& from) : v(from.value<T>()) {}
    T get() { return v; }
    T v;
};
template <class S> struct Read<const S*> {
    explicit Read(Arguments& from) : given(from.structure(s)) {}
    const S* get() { return given ? &s : nullptr; }
    S s{};
    bool given;
};
template <> struct Read<const float*> { // three floats
    explicit Read(Arguments& from) : three(from.array(12)) {}
    const float* get() { return three.as<float>(); }
    Array three;
};

// Calls whose arguments are numbers and single structs, or an array and its count.
template <class... A> lr_status play(lr_status (*function)(lr_world*, A...), Arguments& from, const Scene& scene) {
    std::tuple<Read<A>...> all{Read<A>(from)...}; // braces guarantee the order, left to right
    from.end();
    return std::apply([&](auto&... each) { return function(scene.world, each.get()...); }, all);
}
template <class T>
lr_status play(lr_status (*function)(lr_world*, const T*, uint32_t), Arguments& from, const Scene& scene) {
    if constexpr (requires(T handle) { handle.id; }) {
        const auto count = from.value<uint32_t>();
        const Array ids = from.array(sizeof(T) * uint64_t{count});
        from.end();
        return function(scene.world, ids.as<T>(), count);
    } else {
        uint32_t count = 0;
        std::vector<T> all;
        const bool given = from.structures(count, all);
        from.end();
        return function(scene.world, given ? all.data() : nullptr, count);
    }
}

// Reads the desc of a wind source. A grid must have as many samples as its counts, or none in an update that keeps them.
template <class D> bool source(Arguments& from, D& d, [[maybe_unused]] Array& samples) {
    if (!from.structure(d)) return false;
    if constexpr (requires { d.samples; }) {
        samples = from.array(Arguments::any);
        const uint64_t plane = uint64_t{d.counts[0]} * d.counts[1], solid = uint64_t{d.counts[2]} * d.frames;
        const uint64_t floats = samples.bytes.size() / sizeof(float);
        // A product of two counts fits into 64 bits. Division avoids the overflow of all four.
        if (samples.given && (samples.bytes.size() % 12 != 0 || plane == 0 || solid == 0 || (floats / 3) % plane != 0 ||
                              floats / 3 / plane != solid))
            Arguments::wrong("the samples do not match the counts of the grid");
        d.samples = samples.as<float>();
    }
    return true;
}

template <class D>
lr_status add_source(lr_status (*add)(lr_world*, const D*, lr_wind_source*), Arguments& from, const Scene& scene,
                     uint64_t& output) {
    D d;
    Array samples;
    const bool given = source(from, d, samples);
    from.end();
    lr_wind_source out{};
    const lr_status status = add(scene.world, given ? &d : nullptr, &out);
    output = out.id;
    return status;
}

namespace own { // functions named as in the API, without lr_

#define LR_SOURCE(name)                                                                                                \
    lr_status world_add_##name(Arguments& from, const Scene& scene, uint64_t& output) {                                \
        return add_source(&lr_world_add_##name, from, scene, output);                                                  \
    }
LR_SOURCE(gusts)
LR_SOURCE(vortex)
LR_SOURCE(blower)
LR_SOURCE(turbulence)
LR_SOURCE(wind_grid)
LR_SOURCE(ground_wind)
#undef LR_SOURCE

lr_status world_update_wind_grid(Arguments& from, const Scene& scene, uint64_t&) {
    const auto handle = from.value<lr_wind_source>();
    lr_wind_grid_desc d;
    Array samples;
    const bool given = source(from, d, samples);
    from.end();
    return lr_world_update_wind_grid(scene.world, handle, given ? &d : nullptr);
}

lr_status batch_create(Arguments& from, const Scene& scene, uint64_t& output) {
    recording::BatchRecord r;
    lr_batch out{};
    if (!from.plain(r)) return lr_batch_create(scene.world, nullptr, &out);
    from.end();
    if (r.asset >= scene.assets.size()) Arguments::wrong("its asset was not recorded");
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
    d.variation = r.variation;
    const lr_status status = lr_batch_create(scene.world, &d, &out);
    output = out.id;
    return status;
}

lr_status batch_set_turbulence_table(Arguments& from, const Scene& scene, uint64_t&) {
    const auto batch = from.value<lr_batch>();
    recording::TableRecord r;
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

lr_status batch_add_forces(Arguments& from, const Scene& scene, uint64_t&) {
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

// Space for the ids of `count` new bodies; none if the call will be refused.
std::vector<lr_body> room_for_ids(const Scene& scene, lr_batch batch, uint32_t count) {
    lr_batch_view view = LR_BATCH_VIEW_INIT;
    const bool fits = lr_batch_get_view(scene.world, batch, &view) == LR_OK && count <= view.capacity - view.count;
    return std::vector<lr_body>(fits ? count : 0);
}

lr_status batch_spawn(Arguments& from, Scene& scene, uint64_t& output) {
    const auto batch = from.value<lr_batch>();
    const auto count = from.value<uint32_t>();
    from.end();
    std::vector<lr_body> ids = room_for_ids(scene, batch, count);
    const lr_status status = lr_batch_spawn(scene.world, batch, count, ids.data());
    output = output_of(ids, scene);
    return status;
}

lr_status batch_spawn_box(Arguments& from, Scene& scene, uint64_t& output) {
    const auto batch = from.value<lr_batch>();
    const Array low = from.array(12), high = from.array(12);
    const auto count = from.value<uint32_t>();
    from.end();
    std::vector<lr_body> ids = room_for_ids(scene, batch, count);
    const lr_status status =
        lr_batch_spawn_box(scene.world, batch, low.as<float>(), high.as<float>(), count, ids.data());
    output = output_of(ids, scene);
    return status;
}

lr_status body_create(Arguments& from, Scene& scene, uint64_t& output) {
    const auto batch = from.value<lr_batch>();
    uint32_t count = 0;
    std::vector<lr_body_desc> descs;
    const bool given = from.structures(count, descs);
    from.end();
    std::vector<lr_body> ids(descs.size());
    const lr_status status =
        lr_body_create(scene.world, batch, given ? descs.data() : nullptr, count, given ? ids.data() : nullptr);
    output = output_of(ids, scene);
    return status;
}

lr_status collider_create(Arguments& from, Scene& scene, uint64_t& output) {
    uint32_t count = 0;
    std::vector<lr_collider_desc> descs;
    std::vector<Array> arrays; // an array's bytes stay in place when this vector grows
    const bool given = from.structures(count, descs, [&](lr_collider_desc& d) {
        arrays.push_back(from.array(12 * uint64_t{d.vertex_count}));
        d.vertices = arrays.back().as<float>();
        arrays.push_back(from.array(12 * uint64_t{d.triangle_count}));
        d.indices = arrays.back().as<uint32_t>();
        arrays.push_back(from.array(Arguments::any));
        const uint64_t heights = uint64_t{d.counts[0]} * d.counts[1];
        if (arrays.back().given && (heights > UINT64_MAX / 4 || arrays.back().bytes.size() != 4 * heights))
            Arguments::wrong("the heights do not match the counts of the field");
        d.heights = arrays.back().as<float>();
    });
    from.end();
    std::vector<lr_collider> ids(descs.size());
    const lr_status status =
        lr_collider_create(scene.world, given ? descs.data() : nullptr, count, given ? ids.data() : nullptr);
    output = output_of(ids, scene);
    return status;
}

lr_status world_wake_box(Arguments& from, const Scene& scene, uint64_t& output) {
    const Array low = from.array(12), high = from.array(12);
    from.end();
    uint32_t woken = 0;
    const lr_status status = lr_world_wake_box(scene.world, low.as<float>(), high.as<float>(), &woken);
    output = woken;
    return status;
}

lr_status body_set_sleep(Arguments& from, const Scene& scene, uint64_t&) {
    const auto rest = from.value<int32_t>();
    const auto count = from.value<uint32_t>();
    const Array ids = from.array(8 * uint64_t{count});
    from.end();
    return lr_body_set_sleep(scene.world, ids.as<lr_body>(), count, rest);
}

lr_status collider_set_material(Arguments& from, const Scene& scene, uint64_t&) {
    Read<const lr_material*> surface(from);
    const auto count = from.value<uint32_t>();
    const Array ids = from.array(8 * uint64_t{count});
    from.end();
    return lr_collider_set_material(scene.world, ids.as<lr_collider>(), count, surface.get());
}

lr_status world_set_simd_target(Arguments& from, const Scene&, uint64_t&) {
    from.value<int32_t>(); // ignored: bits do not depend on the instruction set
    from.end();
    return LR_OK;
}

lr_status world_set_wind_callback(Arguments& from, Scene& scene, uint64_t&) {
    const bool on = from.value<uint32_t>() != 0;
    from.end();
    return lr_world_set_wind_callback(scene.world, on ? &Answers::wind : nullptr, &scene.wind);
}

lr_status world_set_water_callback(Arguments& from, Scene& scene, uint64_t&) {
    const bool on = from.value<uint32_t>() != 0;
    from.end();
    return lr_world_set_water_callback(scene.world, on ? &Answers::surface : nullptr, &scene.surface);
}

lr_status world_snapshot_restore(Arguments& from, const Scene& scene, uint64_t&) {
    const Array memory = from.array(Arguments::any);
    from.end();
    return lr_world_snapshot_restore(scene.world, memory.as<unsigned char>(), memory.bytes.size());
}
} // namespace own
} // namespace

// calls.inc lists all recorded calls: LR_BY_TYPES decodes by argument types, LR_OWN has a function in `own`.
#define LR_BY_TYPES(name) LR_CALL(name, play(&lr_##name, from, scene))
#define LR_OWN(name) LR_CALL(name, own::name(from, scene, output))

const char* name_of(Op op) {
    switch (op) {
#define LR_CALL(name, make)                                                                                            \
    case recording::op_of("lr_" #name):                                                                                \
        return "lr_" #name;
#include "tools/lr_replay/calls.inc"
#undef LR_CALL
    }
    return nullptr;
}

lr_status perform(Op op, Arguments& from, Scene& scene, uint64_t& output) {
    output = 0;
    scene.made.clear();
    switch (op) {
#define LR_CALL(name, make)                                                                                            \
    case recording::op_of("lr_" #name):                                                                                \
        return make;
#include "tools/lr_replay/calls.inc"
#undef LR_CALL
    }
    throw Fault(FaultId::unknown_call, "a call of a newer library, number " + std::to_string(op));
}
} // namespace lr::replay
