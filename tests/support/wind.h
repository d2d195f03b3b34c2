// Wind sources for tests, through the public API.
#pragma once

#include "support/scene.h"
#include "support/vector.h"

#include <variant>

namespace test {

using AnySource = std::variant<lr_gusts_desc, lr_vortex_desc, lr_blower_desc, lr_turbulence_desc, lr_wind_grid_desc,
                               lr_ground_wind_desc>;

// The calls of each kind, by the type of its desc.
#define LR_SOURCE(name)                                                                                                \
    inline lr_status add_wind(lr_world* w, const lr_##name##_desc* d, lr_wind_source* out) {                           \
        return lr_world_add_##name(w, d, out);                                                                         \
    }                                                                                                                  \
    inline lr_status update_wind(lr_world* w, lr_wind_source source, const lr_##name##_desc* d) {                      \
        return lr_world_update_##name(w, source, d);                                                                   \
    }                                                                                                                  \
    inline lr_status get_wind(const lr_world* w, lr_wind_source source, lr_##name##_desc* d) {                         \
        return lr_world_get_##name(w, source, d);                                                                      \
    }
LR_SOURCE(gusts)
LR_SOURCE(vortex)
LR_SOURCE(blower)
LR_SOURCE(turbulence)
LR_SOURCE(wind_grid)
LR_SOURCE(ground_wind)
#undef LR_SOURCE
inline lr_status add_wind(lr_world* w, const AnySource* any, lr_wind_source* out) {
    return std::visit([&](const auto& d) { return add_wind(w, &d, out); }, *any);
}
inline lr_status update_wind(lr_world* w, lr_wind_source source, const AnySource* any) {
    return std::visit([&](const auto& d) { return update_wind(w, source, &d); }, *any);
}

inline lr_vortex_desc vortex_desc(int32_t core = LR_VORTEX_LAMB_OSEEN) {
    lr_vortex_desc d = initialised(lr_vortex_desc_init);
    d.core = core;
    return d;
}
inline void set(float (&to)[3], float x, float y, float z) {
    to[0] = x, to[1] = y, to[2] = z;
}
template <class D> lr_wind_source add_source(const World& w, const D& d) {
    lr_wind_source source{};
    REQUIRE(add_wind(w.get(), &d, &source) == LR_OK);
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

// A source of each kind near the origin, in this order; each sample of the grid is unique.
enum class Source : size_t { gusts, rankine, lamb_oseen, round_blower, slot_blower, turbulence, grid, ground };
inline std::vector<AnySource> one_of_each(const std::vector<float>& samples) {
    std::vector<AnySource> all;
    lr_gusts_desc gusts = initialised(lr_gusts_desc_init);
    gusts.rms = 1.5f, gusts.integral_time = 0.5f, gusts.angle_rms = 0.4f;
    all.push_back(gusts);
    for (int32_t core : {LR_VORTEX_RANKINE, LR_VORTEX_LAMB_OSEEN}) {
        lr_vortex_desc vortex = vortex_desc(core);
        set(vortex.position, 0.5f, -0.5f, 0.25f);
        set(vortex.axis, 0.2f, 1.0f, -0.1f);
        set(vortex.velocity, 1.0f, 0.0f, -0.5f);
        vortex.circulation = core == LR_VORTEX_RANKINE ? 5.0f : -3.0f;
        vortex.core_radius = 0.4f, vortex.outer_radius = 3.0f, vortex.half_length = 4.0f;
        all.push_back(vortex);
    }
    for (float half_length : {0.0f, 1.5f}) {
        lr_blower_desc blower = initialised(lr_blower_desc_init);
        set(blower.position, -2.0f, 0.0f, 0.5f);
        set(blower.direction, 1.0f, 0.2f, 0.0f);
        set(blower.velocity, 0.0f, 0.3f, 0.0f);
        blower.speed = 6.0f, blower.nozzle_radius = 0.3f, blower.range = 6.0f, blower.half_length = half_length;
        all.push_back(blower);
    }
    lr_turbulence_desc turbulence = initialised(lr_turbulence_desc_init);
    turbulence.rms = 2.0f, turbulence.integral_length = 0.5f, turbulence.octaves = 3;
    all.push_back(turbulence);
    lr_wind_grid_desc grid = initialised(lr_wind_grid_desc_init);
    set(grid.position, -2.0f, -2.0f, -2.0f);
    set(grid.velocity, 0.5f, 0.0f, 0.0f);
    grid.counts[0] = 4, grid.counts[1] = 3, grid.counts[2] = 5, grid.frames = 3;
    grid.frame_time = 0.1f;
    grid.samples = samples.data();
    all.push_back(grid);
    lr_ground_wind_desc ground = initialised(lr_ground_wind_desc_init);
    set(ground.position, 0.0f, -3.0f, 0.0f);
    all.push_back(ground);
    return all;
}
inline AnySource one_of(Source source, const std::vector<float>& samples) {
    return one_of_each(samples)[static_cast<size_t>(source)];
}
inline std::vector<float> grid_samples() {
    std::vector<float> samples(3 * 4 * 3 * 5 * 3);
    for (size_t i = 0; i < samples.size(); ++i) samples[i] = narrow(static_cast<double>(i * 37 % 101) / 25.0 - 2.0);
    return samples;
}

} // namespace test
