// Wind sources for tests, through the public API.
#pragma once

#include "support/scene.h"
#include "support/vector.h"

namespace test {

inline lr_wind_source_desc source_desc(int32_t kind) {
    lr_wind_source_desc d = initialised(lr_wind_source_desc_init);
    d.kind = kind;
    return d;
}
inline void set(float (&to)[3], float x, float y, float z) {
    to[0] = x, to[1] = y, to[2] = z;
}
inline lr_wind_source add_source(const World& w, const lr_wind_source_desc& d) {
    lr_wind_source source = 0;
    REQUIRE(lr_world_add_wind(w.get(), &d, &source) == LR_OK);
    return source;
}
inline void samples_of(const World& w, const std::vector<float>& positions, std::vector<float>& out) {
    out.resize(positions.size());
    REQUIRE(lr_world_sample_wind(w.get(), positions.data(), static_cast<uint32_t>(positions.size() / 3), out.data()) ==
            LR_OK);
}
inline Vec wind_at(const World& w, Vec x) {
    const float position[3] = {narrow(x[0]), narrow(x[1]), narrow(x[2])};
    float velocity[3] = {};
    REQUIRE(lr_world_sample_wind(w.get(), position, 1, velocity) == LR_OK);
    return vec(velocity);
}

// One of each kind that has a place, near the origin; a grid of which every sample is its own.
inline std::vector<lr_wind_source_desc> one_of_each(const std::vector<float>& samples) {
    std::vector<lr_wind_source_desc> all;
    const auto add = [&](int32_t kind) -> lr_wind_source_desc& {
        all.push_back(source_desc(kind));
        return all.back();
    };
    lr_wind_source_desc& gusts = add(LR_WIND_SOURCE_GUSTS);
    gusts.speed = 1.5f, gusts.period = 0.5f, gusts.spread = 0.4f;
    for (int32_t kind : {LR_WIND_SOURCE_RANKINE, LR_WIND_SOURCE_LAMB_OSEEN}) {
        lr_wind_source_desc& vortex = add(kind);
        set(vortex.position, 0.5f, -0.5f, 0.25f);
        set(vortex.direction, 0.2f, 1.0f, -0.1f);
        set(vortex.velocity, 1.0f, 0.0f, -0.5f);
        vortex.circulation = kind == LR_WIND_SOURCE_RANKINE ? 5.0f : -3.0f;
        vortex.size = 0.4f, vortex.radius = 3.0f, vortex.half_length = 4.0f;
    }
    for (int32_t kind : {LR_WIND_SOURCE_POINT_BLOWER, LR_WIND_SOURCE_LINE_BLOWER}) {
        lr_wind_source_desc& blower = add(kind);
        set(blower.position, -2.0f, 0.0f, 0.5f);
        set(blower.direction, 1.0f, 0.2f, 0.0f);
        set(blower.velocity, 0.0f, 0.3f, 0.0f);
        blower.speed = 6.0f, blower.size = 0.3f, blower.range = 6.0f, blower.half_length = 1.5f;
    }
    lr_wind_source_desc& turbulence = add(LR_WIND_SOURCE_TURBULENCE);
    turbulence.speed = 2.0f, turbulence.size = 0.5f, turbulence.octaves = 3;
    lr_wind_source_desc& grid = add(LR_WIND_SOURCE_GRID);
    set(grid.position, -2.0f, -2.0f, -2.0f);
    set(grid.velocity, 0.5f, 0.0f, 0.0f);
    grid.counts[0] = 4, grid.counts[1] = 3, grid.counts[2] = 5, grid.frames = 3;
    grid.period = 0.1f;
    grid.samples = samples.data();
    lr_wind_source_desc& ground = add(LR_WIND_SOURCE_GROUND);
    set(ground.position, 0.0f, -3.0f, 0.0f);
    set(ground.direction, 0.0f, 1.0f, 0.0f);
    ground.size = 0.03f;
    return all;
}
inline std::vector<float> grid_samples() {
    std::vector<float> samples(3 * 4 * 3 * 5 * 3);
    for (size_t i = 0; i < samples.size(); ++i) samples[i] = narrow(static_cast<double>(i * 37 % 101) / 25.0 - 2.0);
    return samples;
}

} // namespace test
