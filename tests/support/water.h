// Worlds with water, for tests.
#pragma once

#include "support/scene.h"

#include <cmath>

namespace test {

inline constexpr double air_density = 1.2, water_density = 998.0; // kg/m^3, of the assets and of the desc

inline lr_water_desc water_desc() {
    return initialised(lr_water_desc_init);
}
inline void set_water(const World& w, const lr_water_desc& d) {
    REQUIRE(lr_world_set_water(w.get(), &d) == LR_OK);
}
// A sea of several waves that cross.
inline lr_water_desc sea() {
    lr_water_desc d = water_desc();
    d.wave_count = 3;
    d.waves[0] = {{1.0f, 0.0f, 0.2f}, 7.0f, 0.2f, 0.3f};
    d.waves[1] = {{-0.3f, 0.1f, 1.0f}, 3.0f, 0.1f, 2.0f};
    d.waves[2] = {{0.5f, 0.0f, -1.0f}, 1.1f, 0.05f, -1.0f};
    d.current[0] = 0.2f;
    return d;
}

inline lr_batch_desc with_loads(int32_t model, int32_t integrator = LR_INTEGRATOR_DEFAULT) {
    lr_batch_desc d = batch_desc();
    d.load_model = model;
    d.integrator = integrator;
    return d;
}
inline lr_body_desc at_height(double y) {
    lr_body_desc d = body_desc();
    d.position[1] = narrow(y);
    return d;
}
inline void no_turbulence(const World& w, lr_batch batch) {
    lr_load_gains gains = initialised(lr_load_gains_init);
    gains.turbulence = 0.0f;
    REQUIRE(lr_batch_set_load_gains(w.get(), batch, &gains) == LR_OK);
}

// Height of a floating ellipsoid's centre above the water, in half heights: density = f water + (1 - f) air.
inline double draught(double density) {
    const double f = (density - air_density) / (water_density - air_density);
    double low = -1.0, high = 1.0;
    for (int i = 0; i < 60; ++i) {
        const double s = 0.5 * (low + high);
        ((2.0 + 3.0 * s - s * s * s) / 4.0 < f ? low : high) = s;
    }
    return low;
}

// kg/s, damping by the waves that a body radiates as it heaves at its natural frequency. waterplane: m^2; volume: submerged, m^3; mass, and `moved`
// with added mass: kg; difference: of the waterplane's semi-axes, m.
inline double heave_damping(double waterplane, double volume, double mass, double moved, double difference = 0.0) {
    const double gravity = 9.81, number = water_density * waterplane / moved, omega = std::sqrt(gravity * number);
    const double deep = (water_density * volume + 1.6 * (moved - mass)) / moved;
    const double force =
        1.0 / (1.0 + deep + deep * deep / 2.0); // on the body in a wave, over that of the waterplane in a long one
    return 0.5 * water_density * omega * number * waterplane * waterplane * force * force /
           std::sqrt(1.0 + 0.25 * number * number * difference * difference);
}

} // namespace test
