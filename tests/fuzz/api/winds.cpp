// Wind of every kind, the callback, and water.
#include "fuzz/api/model.h"

namespace fuzz {
namespace {

constexpr size_t most_samples = 3 * 64;

// Samples of a grid: still, plain, not finite, too fast.
const float* samples(uint32_t kind) {
    static const auto all = [] {
        std::array<std::array<float, most_samples>, 4> s{};
        for (size_t i = 0; i < most_samples; ++i) s[1][i] = s[2][i] = s[3][i] = static_cast<float>(i % 7) - 3.0f;
        s[2][2] = std::numeric_limits<float>::quiet_NaN();
        s[3][1] = 1001.0f;
        return s;
    }();
    return all[kind % 4].data();
}

// Common to all kinds: a place, or a direction.
template <class D> void expect_place(Expected& e, const D& d) {
    if constexpr (requires { d.position; }) e.range(d.position, -1e9, 1e9);
    if constexpr (requires { d.velocity; }) e.range(d.velocity, -1000.0, 1000.0);
    if constexpr (requires { d.direction; }) e.length(d.direction, 1e-6, 1e9);
    if constexpr (requires { d.axis; }) e.length(d.axis, 1e-6, 1e9);
    if constexpr (requires { d.normal; }) e.length(d.normal, 1e-6, 1e9);
}

// Changes a desc, and states the expected result. Samples exist only for grids.
void read(Input& in, Expected& e, lr_gusts_desc& d, uint32_t&) {
    in.change(d.seed, d.direction, d.rms, d.angle_rms, d.integral_time);
    e.range(d.rms, 0.0, 1000.0);
    e.range(d.angle_rms, 0.0, 1.0);
    e.range(d.integral_time, 0.0, 1e6);
}
void read(Input& in, Expected& e, lr_vortex_desc& d, uint32_t&) {
    in.change(d.core, d.position, d.axis, d.velocity, d.circulation, d.core_radius, d.outer_radius, d.half_length);
    e.add_if(d.core != LR_VORTEX_LAMB_OSEEN && d.core != LR_VORTEX_RANKINE, LR_ERROR_INVALID_ARGUMENT);
    e.range(d.circulation, -1e6, 1e6);
    e.range(d.core_radius, 1e-4, 1e6);
    e.range(d.outer_radius, 0.0, 1e6);
    e.range(d.half_length, 0.0, 1e6);
    e.may_if(std::abs(d.circulation) > 5900.0f * d.core_radius, LR_ERROR_INVALID_ARGUMENT); // faster than 1000 m/s
}
void read(Input& in, Expected& e, lr_blower_desc& d, uint32_t&) {
    d.half_length = in.handle(1) % 2 ? 0.5f : 0.0f;
    in.change(d.position, d.direction, d.side, d.velocity, d.speed, d.nozzle_radius, d.half_length, d.range, d.spread);
    e.range(d.speed, 0.0, 1000.0);
    e.range(d.nozzle_radius, 1e-4, 1e6);
    e.range(d.half_length, 0.0, 1e6);
    e.range(d.range, 0.0, 1e6);
    e.range(d.spread, 0.0, 1.0);
    e.add_if(d.range < d.nozzle_radius, LR_ERROR_INVALID_ARGUMENT);
    for (float v : d.side) {
        e.finite(v);
        e.may_if(std::abs(v) > 1e18f, LR_ERROR_INVALID_ARGUMENT);
    }
    if (d.half_length > 0.0f) e.length(d.side, 1e-6, 1e9), e.may(LR_ERROR_INVALID_ARGUMENT);
}
void read(Input& in, Expected& e, lr_turbulence_desc& d, uint32_t&) {
    in.change(d.seed, d.octaves, d.velocity, d.rms, d.integral_length, d.eddy_life);
    e.range(d.rms, 0.0, 1000.0);
    e.range(d.integral_length, 1e-4, 1e6);
    e.range(d.eddy_life, 0.0, 1e6);
    e.add_if(d.octaves < 1 || d.octaves > 4, LR_ERROR_INVALID_ARGUMENT);
}
void read(Input& in, Expected& e, lr_wind_grid_desc& d, uint32_t& kind_of_samples) {
    for (uint32_t& n : d.counts) n = 2;
    in.change(d.outside, d.position, d.velocity, d.spacing, d.counts, d.frames, d.frame_time);
    const uint64_t total = uint64_t{d.counts[0]} * d.counts[1] * d.counts[2];
    bool large = total > LR_MAX_WIND_SAMPLES || total * d.frames > LR_MAX_WIND_SAMPLES;
    for (uint32_t n : d.counts) large = large || n > LR_MAX_WIND_SAMPLES;
    // Otherwise the caller would state more samples than it has.
    if (!large && total * d.frames > most_samples / 3)
        for (uint32_t* n : {&d.counts[0], &d.counts[1], &d.counts[2], &d.frames}) *n = 2;
    kind_of_samples = in.handle(0) < 160 ? in.handle(0) % 2u : in.handle(0) % 4u;
    if (in.handle(0) < 240) d.samples = samples(kind_of_samples);
    e.range(d.spacing, 1e-4, 1e6);
    e.range(d.frame_time, 0.0, 1e6);
    e.add_if(d.outside < 0 || d.outside > LR_WIND_OUTSIDE_REPEAT, LR_ERROR_INVALID_ARGUMENT);
    e.add_if(large || total == 0 || d.frames == 0, LR_ERROR_INVALID_ARGUMENT);
    if (d.samples && total * d.frames != 0 && !large) {
        e.add_if(kind_of_samples == 2, LR_ERROR_NOT_FINITE); // the first sample
        e.add_if(kind_of_samples == 3, LR_ERROR_INVALID_ARGUMENT);
    }
}
void read(Input& in, Expected& e, lr_ground_wind_desc& d, uint32_t&) {
    in.change(d.position, d.normal, d.velocity, d.roughness_length, d.reference_height);
    e.range(d.roughness_length, 1e-4, 1e6);
    e.range(d.reference_height, 0.0, 1e6);
    e.add_if(d.reference_height < d.roughness_length, LR_ERROR_INVALID_ARGUMENT);
}

AnyWind initial(size_t kind) {
    switch (kind) {
    case 0:
        return initialised(LR_CALL(lr_gusts_desc_init));
    case 1:
        return initialised(LR_CALL(lr_vortex_desc_init));
    case 2:
        return initialised(LR_CALL(lr_blower_desc_init));
    case 3:
        return initialised(LR_CALL(lr_turbulence_desc_init));
    case 4:
        return initialised(LR_CALL(lr_wind_grid_desc_init));
    default:
        return initialised(LR_CALL(lr_ground_wind_desc_init));
    }
}

void add(Fuzzer& f) {
    World& w = f.world();
    AnyWind any = initial(f.in.handle(1) % 6);
    std::visit(
        [&](auto& d) {
            Expected e;
            uint32_t kind = 0;
            read(f.in, e, d, kind);
            expect_place(e, d);
            if constexpr (requires { d.samples; }) e.add_if(!d.samples, LR_ERROR_NULL_ARGUMENT);
            e.add_if(w.state.winds.size() >= LR_MAX_WIND_SOURCES, LR_ERROR_CAPACITY);
            Given<std::remove_reference_t<decltype(d)>> given(f.in, d, 1, e);
            Call call(f, w, "lr_world_add_...", e);
            lr_wind_source id{77};
            const bool lost = f.in.null(2);
            const bool ok = call.ended(add_wind(call.world(), given.get(), lost ? nullptr : &id));
            if (!lost && ok != (id.id != 0)) defect("lr_world_add_...", "handle and status do not agree", id.id);
            if (!ok) return;
            if (lost) {
                w.state.loose = true; // its handle is unknown
                return;
            }
            for (const Wind& other : w.state.winds)
                if (other.id == id && !w.state.loose) defect("lr_world_add_...", "the handle of another", id.id);
            w.state.winds.push_back({id, d});
        },
        any);
}

Wind* find(World& w, lr_wind_source id) {
    for (Wind& s : w.state.winds)
        if (s.id == id) return &s;
    return nullptr;
}

// Mostly of the source's kind.
AnyWind for_source(Fuzzer& f, const Wind* found) {
    return initial(found && f.in.handle(1) < 200 ? found->desc.index() : f.in.handle(1) % 6);
}

void update(Fuzzer& f) {
    World& w = f.world();
    const lr_wind_source id = f.pick_wind(w, f.in.handle(2));
    Wind* const found = find(w, id);
    AnyWind any = for_source(f, found);
    std::visit(
        [&](auto& d) {
            using D = std::remove_reference_t<decltype(d)>;
            Expected e;
            uint32_t kind = 0;
            read(f.in, e, d, kind);
            expect_place(e, d);
            e.add_if(!found, LR_ERROR_STALE_WIND_SOURCE);
            const D* const old = found ? std::get_if<D>(&found->desc) : nullptr;
            e.add_if(found && !old, LR_ERROR_INVALID_ARGUMENT);
            bool kept = false;
            if constexpr (requires { d.samples; })
                if (found && !d.samples) {
                    kept = old && std::equal(old->counts, old->counts + 3, d.counts) && old->frames == d.frames;
                    e.add_if(!kept, LR_ERROR_NULL_ARGUMENT);
                    e.may_if(!kept, LR_ERROR_INVALID_ARGUMENT);
                }
            Given<D> given(f.in, d, 1, e);
            Call call(f, w, "lr_world_update_...", e);
            if (!call.ended(update_wind(call.world(), id, given.get())) || !found) return;
            if constexpr (requires { d.samples; })
                if (kept) d.samples = old->samples;
            found->desc = d;
        },
        any);
}

void get(Fuzzer& f) {
    World& w = f.world();
    const lr_wind_source id = f.pick_wind(w, f.in.handle(2));
    const Wind* const found = find(w, id);
    AnyWind any = for_source(f, found);
    std::visit(
        [&](auto& d) {
            using D = std::remove_reference_t<decltype(d)>;
            Expected e;
            e.add_if(!found, LR_ERROR_STALE_WIND_SOURCE);
            const D* const held = found ? std::get_if<D>(&found->desc) : nullptr;
            e.add_if(found && !held, LR_ERROR_INVALID_ARGUMENT);
            Given<D> given(f.in, d, 1, e);
            Call call(f, w, "lr_world_get_...", e);
            const bool wild = w.state.wild;
            const bool ok = call.ended(get_wind(call.world(), id, given.get()));
            w.state.wild = wild;
            if (!ok || !held || w.state.loose) return;
            D expected = *held, got = given.read();
            got.struct_size = expected.struct_size;
            if constexpr (requires { expected.samples; }) expected.samples = nullptr;
            if constexpr (requires {
                              expected.position;
                              expected.velocity;
                          }) // where it is now
                for (int k = 0; k < 3; ++k)
                    if (expected.velocity[k] != 0.0f || expected.position[k] == 0.0f)
                        expected.position[k] = got.position[k];
            if (std::memcmp(&got, &expected, sizeof got) != 0) defect("lr_world_get_...", "not as it was set", id.id);
        },
        any);
}

void remove(Fuzzer& f) {
    World& w = f.world();
    const lr_wind_source id = f.pick_wind(w, f.in.handle(0));
    const auto at = std::find_if(w.state.winds.begin(), w.state.winds.end(), [&](const Wind& s) { return s.id == id; });
    Expected e;
    e.add_if(at == w.state.winds.end(), LR_ERROR_STALE_WIND_SOURCE);
    Call call(f, w, "lr_world_remove_wind", e);
    if (!call.ended(LR_CALL(lr_world_remove_wind)(call.world(), id)) || at == w.state.winds.end()) return;
    w.stale_winds.push_back(id);
    w.state.winds.erase(at);
}

void uniform(Fuzzer& f) {
    World& w = f.world();
    float v[3] = {};
    f.in.change(v);
    Expected e;
    e.range(v, -1000.0, 1000.0);
    Call call(f, w, "lr_world_set_uniform_wind", e);
    if (!call.ended(LR_CALL(lr_world_set_uniform_wind)(call.world(), v[0], v[1], v[2]))) return;
    float got[3] = {};
    if (LR_CALL(lr_world_get_uniform_wind)(w.at, got) != LR_OK || !std::equal(v, v + 3, got))
        defect("lr_world_get_uniform_wind", "not as it was set");
}

void callbacks(Fuzzer& f) {
    World& w = f.world();
    if (LR_CALL(lr_world_set_wind_callback)(nullptr, nullptr, nullptr) != LR_ERROR_NULL_ARGUMENT ||
        LR_CALL(lr_world_set_water_callback)(nullptr, nullptr, nullptr) != LR_ERROR_NULL_ARGUMENT)
        defect("lr_world_set_wind_callback", "no world");
    if (!w.at) return;
    w.wind_callback = f.in.handle(0) % 4;
    w.surface_callback = f.in.handle(1) % 4;
    set_callbacks(w, w.at);
}

void sample(Fuzzer& f) {
    World& w = f.world();
    float at[3][3] = {};
    f.in.change(at);
    const uint32_t count = f.in.handle(0) % 4;
    float out[9];
    Expected e;
    for (uint32_t i = 0; i < count; ++i) e.range(at[i], -1e9, 1e9);
    e.add_if((f.in.null(1) || f.in.null(2)) && count != 0, LR_ERROR_NULL_ARGUMENT);
    Call call(f, w, "lr_world_sample_wind", e);
    const bool wild = w.state.wild;
    const bool ok = call.ended(LR_CALL(lr_world_sample_wind)(call.world(), f.in.null(1) ? nullptr : at[0], count,
                                                             f.in.null(2) ? nullptr : out));
    w.state.wild = wild;
    for (uint32_t i = 0; ok && i < 3 * count; ++i)
        if (!std::isfinite(out[i]) && !w.state.loose) defect("lr_world_sample_wind", "not finite", i);
}

void surface(Fuzzer& f) {
    World& w = f.world();
    Input& in = f.in;
    lr_water_desc d = initialised(LR_CALL(lr_water_desc_init));
    d.wave_count = in.handle(0) % 4;
    for (lr_wave& v : d.waves) v.direction[0] = 1.0f, v.length = 2.0f, v.amplitude = 0.1f;
    d.position[1] = in.variant() == 0 ? 0.0f : -0.1f;
    lr_wave& v = d.waves[0];
    in.change(d.wave_count, d.position, d.normal, d.density, d.viscosity, d.current, d.reach, v.direction, v.length,
              v.amplitude, v.phase);
    Expected e;
    if (!in.null(1)) {
        e.range(d.position, -1e9, 1e9);
        e.range(d.current, -1000.0, 1000.0);
        e.range(d.density, 1e-3, 1e6);
        e.range(d.viscosity, 1e-12, 1e3);
        e.range(d.reach, 0.0, 1e6);
        e.length(d.normal, 1e-6, 1e9);
        e.add_if(d.wave_count > LR_MAX_WAVES, LR_ERROR_INVALID_ARGUMENT);
        Expected wave;
        wave.range(v.length, 1e-3, 1e6);
        wave.range(v.phase, -1e6, 1e6);
        wave.range(v.amplitude, 0.0, static_cast<double>(v.length) / 7.0);
        wave.length(v.direction, 1e-6, 1e9);
        for (lr_status s : {LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT}) {
            if (d.wave_count != 0 && wave.fails() && !wave.allows(LR_OK) && wave.allows(s)) e.add(s);
            e.may_if(wave.may_fail(), s);
        }
        // Along the normal, or nearly; a normal that is not upright crosses the other waves at any angle.
        e.may_if(d.wave_count != 0, LR_ERROR_INVALID_ARGUMENT);
    }
    Given<lr_water_desc> given(in, d, 1, e, true);
    Call call(f, w, "lr_world_set_water", e);
    if (!call.ended(LR_CALL(lr_world_set_water)(call.world(), given.get()))) return;
    for (uint32_t i = d.wave_count; i < LR_MAX_WAVES; ++i) d.waves[i] = {}; // unused waves are not kept
    lr_water_desc got = initialised(LR_CALL(lr_water_desc_init));
    int32_t present = -7;
    if (LR_CALL(lr_world_get_water)(w.at, &got, &present) != LR_OK || present != (given.get() ? 1 : 0) ||
        (given.get() && std::memcmp(&got, &d, sizeof d) != 0))
        defect("lr_world_get_water", "not what was set", present);
}

} // namespace

std::vector<Named> wind_operations() {
    return {{"wind_add", add}, {"wind_update", update},  {"wind_remove", remove}, {"wind_get", get},
            {"wind", uniform}, {"callbacks", callbacks}, {"sample", sample},      {"surface", surface}};
}

} // namespace fuzz
