// Counts non-finite bodies after a step, from outside.
#pragma once

#include "support/scene.h"
#include "support/vector.h"

#include <algorithm>
#include <cmath>

namespace test {

struct Extremes {
    uint32_t lost = 0;    // bodies with a number that is not finite
    double fastest = 0.0; // m/s, of the finite bodies

    void add(const lr_batch_view& v) {
        for (uint32_t i = 0; i < v.count; ++i) {
            double sum = wide(v.orientation[3][i]);
            for (size_t k = 0; k < 3; ++k)
                sum += wide(v.position[k][i]) + wide(v.velocity[k][i]) + wide(v.spin[k][i]) + wide(v.orientation[k][i]);
            if (std::isfinite(sum))
                fastest =
                    std::max(fastest, length({wide(v.velocity[0][i]), wide(v.velocity[1][i]), wide(v.velocity[2][i])}));
            else
                ++lost;
        }
    }
};

} // namespace test
