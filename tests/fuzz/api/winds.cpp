// Wind of every kind, the callback, and water.
#include "fuzz/api/model.h"

namespace fuzz {
namespace {

constexpr size_t most_samples = 3 * 64;

// Of a grid: still, plain, not finite, too fast.
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

lr_wind_source_desc read_source(Input& in, Expected& e, uint32_t& kind_of_samples) {
    lr_wind_source_desc d = initialised(LR_CALL(lr_wind_source_desc_init));
    d.kind = 1 + in.handle(1) % 8;
    for (uint32_t& n : d.counts) n = 2;
    in.change(d.kind, d.position, d.direction, d.side, d.velocity, d.speed, d.circulation, d.size, d.radius,
              d.half_length, d.range, d.spread, d.period, d.reference_height, d.octaves, d.seed, d.outside, d.counts,
              d.frames, d.spacing, d.reserved);
    const uint64_t total = uint64_t{d.counts[0]} * d.counts[1] * d.counts[2];
    const bool grid = d.kind == LR_WIND_SOURCE_GRID;
    bool large = total > LR_MAX_WIND_SAMPLES || total * d.frames > LR_MAX_WIND_SAMPLES;
    for (uint32_t n : d.counts) large = large || n > LR_MAX_WIND_SAMPLES;
    // More than there are, but a number that must be read: the caller would be lying.
    if (!large && total * d.frames > most_samples / 3)
        for (uint32_t* n : {&d.counts[0], &d.counts[1], &d.counts[2], &d.frames}) *n = 2;
    kind_of_samples = in.handle(0) < 160 ? in.handle(0) % 2u : in.handle(0) % 4u;
    if (in.handle(0) < 240) d.samples = samples(kind_of_samples);

    e.range(d.position, -1e9, 1e9);
    e.range(d.velocity, -1000.0, 1000.0);
    e.range(d.speed, 0.0, 1000.0);
    e.range(d.size, 1e-4, 1e6);
    e.range(d.period, 0.0, 1e6);
    e.range(d.spread, 0.0, 1.0);
    e.range(d.half_length, 0.0, 1e6);
    for (float v : {d.circulation, d.radius, d.range, d.reference_height}) e.finite(v);
    for (float v : d.spacing) e.finite(v);
    for (float v : d.side) e.finite(v);
    for (float v : d.direction) e.finite(v);
    e.add_if(d.kind < LR_WIND_SOURCE_GUSTS || d.kind > LR_WIND_SOURCE_GROUND || d.reserved != 0,
             LR_ERROR_INVALID_ARGUMENT);
    if (d.kind != LR_WIND_SOURCE_TURBULENCE && !grid) e.length(d.direction, 1e-6, 1e9);
    if (d.kind == LR_WIND_SOURCE_LINE_BLOWER) e.length(d.side, 1e-6, 1e9), e.may(LR_ERROR_INVALID_ARGUMENT);
    if (d.kind == LR_WIND_SOURCE_RANKINE || d.kind == LR_WIND_SOURCE_LAMB_OSEEN) {
        e.range(d.circulation, -1e6, 1e6);
        e.range(d.radius, 0.0, 1e6);
        e.may_if(std::abs(d.circulation) > 5900.0f * d.size, LR_ERROR_INVALID_ARGUMENT); // faster than 1000 m/s
    }
    if (d.kind == LR_WIND_SOURCE_POINT_BLOWER || d.kind == LR_WIND_SOURCE_LINE_BLOWER) {
        e.range(d.range, 0.0, 1e6);
        e.add_if(d.range < d.size, LR_ERROR_INVALID_ARGUMENT);
    }
    e.add_if(d.kind == LR_WIND_SOURCE_TURBULENCE && (d.octaves < 1 || d.octaves > 4), LR_ERROR_INVALID_ARGUMENT);
    if (d.kind == LR_WIND_SOURCE_GROUND) {
        e.range(d.reference_height, 0.0, 1e6);
        e.add_if(d.reference_height < d.size, LR_ERROR_INVALID_ARGUMENT);
    }
    if (!grid) return d;
    e.range(d.spacing, 1e-4, 1e6);
    e.add_if(d.outside < 0 || d.outside > LR_WIND_OUTSIDE_REPEAT, LR_ERROR_INVALID_ARGUMENT);
    e.add_if(large || total == 0 || d.frames == 0, LR_ERROR_INVALID_ARGUMENT);
    if (d.samples && total * d.frames != 0 && !large) {
        e.add_if(kind_of_samples == 2, LR_ERROR_NOT_FINITE); // the first sample
        e.add_if(kind_of_samples == 3, LR_ERROR_INVALID_ARGUMENT);
    }
    return d;
}

void add(Fuzzer& f) {
    World& w = f.world();
    Expected e;
    uint32_t kind = 0;
    const lr_wind_source_desc d = read_source(f.in, e, kind);
    e.add_if(d.kind == LR_WIND_SOURCE_GRID && !d.samples, LR_ERROR_NULL_ARGUMENT);
    e.add_if(w.state.winds.size() >= LR_MAX_WIND_SOURCES, LR_ERROR_CAPACITY);
    Given<lr_wind_source_desc> given(f.in, d, 1, e);
    Call call(f, w, "lr_world_add_wind", e);
    lr_wind_source id = 77;
    const bool ok = call.ended(LR_CALL(lr_world_add_wind)(call.world(), given.get(), f.in.null(2) ? nullptr : &id));
    if (!f.in.null(2) && ok != (id != 0)) defect("lr_world_add_wind", "handle and status do not agree", id);
    if (!ok) return;
    if (f.in.null(2)) {
        w.state.loose = true; // its handle is lost
        return;
    }
    for (const Wind& other : w.state.winds)
        if (other.id == id && !w.state.loose) defect("lr_world_add_wind", "the handle of another", id);
    w.state.winds.push_back({id, d});
}

void update(Fuzzer& f) {
    World& w = f.world();
    Expected e;
    uint32_t kind = 0;
    lr_wind_source_desc d = read_source(f.in, e, kind);
    const lr_wind_source id = f.pick_wind(w, f.in.handle(2));
    Wind* found = nullptr;
    for (Wind& s : w.state.winds)
        if (s.id == id) found = &s;
    e.add_if(!found, LR_ERROR_STALE_WIND_SOURCE);
    bool kept = false;
    if (found && d.kind == LR_WIND_SOURCE_GRID && !d.samples) {
        const lr_wind_source_desc& o = found->desc;
        kept = o.kind == LR_WIND_SOURCE_GRID && std::equal(o.counts, o.counts + 3, d.counts) && o.frames == d.frames;
        e.add_if(!kept, LR_ERROR_NULL_ARGUMENT);
        e.may_if(!kept, LR_ERROR_INVALID_ARGUMENT);
    }
    Given<lr_wind_source_desc> given(f.in, d, 1, e);
    Call call(f, w, "lr_world_update_wind", e);
    if (!call.ended(LR_CALL(lr_world_update_wind)(call.world(), id, given.get())) || !found) return;
    if (kept) d.samples = found->desc.samples;
    found->desc = d;
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
    lr_wind_desc d = initialised(LR_CALL(lr_wind_desc_init));
    f.in.change(d.velocity, d.kind, d.reserved);
    Expected e;
    if (!f.in.null(1)) {
        e.range(d.velocity, -1000.0, 1000.0);
        e.add_if((d.kind != LR_WIND_NONE && d.kind != LR_WIND_UNIFORM) || d.reserved != 0, LR_ERROR_INVALID_ARGUMENT);
    }
    Given<lr_wind_desc> given(f.in, d, 1, e, true);
    Call call(f, w, "lr_world_set_wind", e);
    call.ended(LR_CALL(lr_world_set_wind)(call.world(), given.get()));
}

void callbacks(Fuzzer& f) {
    World& w = f.world();
    if (LR_CALL(lr_world_set_wind_callback)(nullptr, nullptr, nullptr) != LR_ERROR_NULL_ARGUMENT ||
        LR_CALL(lr_world_set_surface_callback)(nullptr, nullptr, nullptr) != LR_ERROR_NULL_ARGUMENT)
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
    lr_surface_desc d = initialised(LR_CALL(lr_surface_desc_init));
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
        // Along the normal, or nearly; a normal that is not upright meets the other waves in any way.
        e.may_if(d.wave_count != 0, LR_ERROR_INVALID_ARGUMENT);
    }
    Given<lr_surface_desc> given(in, d, 1, e, true);
    Call call(f, w, "lr_world_set_surface", e);
    call.ended(LR_CALL(lr_world_set_surface)(call.world(), given.get()));
}

} // namespace

std::vector<Named> wind_operations() {
    return {{"wind_add", add},        {"wind_update", update}, {"wind_remove", remove}, {"wind", uniform},
            {"callbacks", callbacks}, {"sample", sample},      {"surface", surface}};
}

} // namespace fuzz
