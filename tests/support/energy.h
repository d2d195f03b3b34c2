// Random motions, and the energies of bodies in them.
#pragma once

#include "support/random.h"
#include "support/reference_body.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace test {

// size: m, the smallest of the body; scales keep it above a micrometre.
inline lr_body_desc draw_motion(Random& random, double size) {
    lr_body_desc b = turned_anyhow(random);
    const double speed = random.logarithmic(0.01, 100.0), spin = random.logarithmic(0.1, 1000.0);
    for (float& v : b.linear_velocity) v = random.real(-speed, speed);
    for (float& w : b.angular_velocity) w = random.real(-0.57 * spin, 0.57 * spin);
    b.scale = static_cast<float>(std::max(random.logarithmic(0.01, 100.0), 1.001e-6 / size));
    return b;
}

// Kinetic energy of the motion through the fluid, of body and fluid together.
inline double energy(const ReferenceBody& body, const lr_batch_view& v, const std::vector<Velocity>& u, uint32_t i,
                     Vec wind) {
    const auto at = [&](const float* const* field, size_t k) { return wide(field[k][i]); };
    const Quat q{at(v.orientation, 0), at(v.orientation, 1), at(v.orientation, 2), at(v.orientation, 3)};
    const Six t = join(to_body(q, vec(u[i].linear) - wind), to_body(q, vec(u[i].angular))), p = body.mass * t;
    double sum = 0.0;
    for (size_t k = 0; k < 6; ++k) sum += 0.5 * t[k] * p[k];
    return sum;
}

} // namespace test
