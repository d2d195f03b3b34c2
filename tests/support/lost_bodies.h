// Counts non-finite bodies after a step, through the public API.
#pragma once

#include "support/scene.h"
#include "support/vector.h"

#include <algorithm>
#include <cmath>

namespace test {

struct Extremes {
    uint32_t lost = 0;    // bodies with a number that is not finite
    double fastest = 0.0; // m/s, of the finite bodies

    void add(const World& world, lr_batch batch) {
        const lr_batch_view v = view_of(world, batch);
        const std::vector<Velocity> u = velocities_of(world, batch);
        for (uint32_t i = 0; i < v.count; ++i) {
            double sum = wide(v.orientation[3][i]);
            for (size_t k = 0; k < 3; ++k)
                sum +=
                    wide(v.position[k][i]) + wide(u[i].linear[k]) + wide(u[i].angular[k]) + wide(v.orientation[k][i]);
            if (std::isfinite(sum))
                fastest = std::max(fastest, length(vec(u[i].linear)));
            else
                ++lost;
        }
    }
};

} // namespace test
