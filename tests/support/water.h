// Worlds with water, for tests.
#pragma once

#include "support/scene.h"

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

} // namespace test
