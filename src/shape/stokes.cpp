#include "shape/stokes.h"

#include "shape/lamb.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lr::shape {

double carlson_rf(double x, double y, double z) {
    double mean = 0.0;
    for (int i = 0; i < 64; ++i) {
        mean = (x + y + z) / 3.0;
        const double dx = (mean - x) / mean, dy = (mean - y) / mean, dz = -(dx + dy);
        // The remainder of the series is of sixth order in the differences: 2e-3 leaves 1e-17.
        if (std::max({std::abs(dx), std::abs(dy), std::abs(dz)}) < 2e-3) {
            const double e2 = dx * dy - dz * dz, e3 = dx * dy * dz;
            return (1.0 - e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0 - 3.0 * e2 * e3 / 44.0) / std::sqrt(mean);
        }
        const double sx = std::sqrt(x), sy = std::sqrt(y), sz = std::sqrt(z);
        const double lambda = sx * sy + sx * sz + sy * sz;
        x = 0.25 * (x + lambda);
        y = 0.25 * (y + lambda);
        z = 0.25 * (z + lambda);
    }
    return 1.0 / std::sqrt(mean);
}

StokesResistance stokes_resistance(const std::array<double, 3>& semi_axes) {
    const double unit = std::max({semi_axes[0], semi_axes[1], semi_axes[2]});
    std::array<double, 3> square;
    for (size_t i = 0; i < 3; ++i) square[i] = semi_axes[i] * semi_axes[i] / (unit * unit);
    std::array<double, 3> sorted = square;
    std::sort(sorted.begin(), sorted.end());
    if (sorted[1] < 1e-12)
        for (double& s : square) s = std::max(s, 1e-12);

    // chi + a_i^2 alpha_i of Happel & Brenner, 5-11.19, is 2 R_F + 2/3 a_i^2 R_D(.., a_i^2); for a_i = 0 the second
    // term vanishes although R_D does not stay finite.
    const double rf = carlson_rf(square[0], square[1], square[2]);
    std::array<double, 3> weighted{};
    for (size_t i = 0; i < 3; ++i)
        if (square[i] > 0.0) weighted[i] = square[i] * carlson_rd(square[(i + 1) % 3], square[(i + 2) % 3], square[i]);
    StokesResistance out{};
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3, k = (i + 2) % 3;
        out.translation[i] = 24.0 * std::numbers::pi / (3.0 * rf + weighted[i]) * unit;
        out.rotation[i] =
            8.0 * std::numbers::pi * (square[j] + square[k]) / (weighted[j] + weighted[k]) * (unit * unit * unit);
    }
    return out;
}

} // namespace lr::shape
