#include "shape/lamb.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lr::shape {

double carlson_rd(double x, double y, double z) {
    double sum = 0.0, factor = 1.0;
    for (int i = 0; i < 64; ++i) {
        const double mean = (x + y + 3.0 * z) / 5.0;
        const double spread = std::max({std::abs(mean - x), std::abs(mean - y), std::abs(mean - z)});
        // The remainder of the series below is of sixth order in spread / mean: 1e-3 leaves 1e-17.
        if (spread < 1e-3 * mean) {
            const double dx = (mean - x) / mean, dy = (mean - y) / mean, dz = -(dx + dy) / 3.0;
            const double e2 = dx * dy - 6.0 * dz * dz, e3 = (3.0 * dx * dy - 8.0 * dz * dz) * dz;
            const double e4 = 3.0 * (dx * dy - dz * dz) * dz * dz, e5 = dx * dy * dz * dz * dz;
            const double series = 1.0 - 3.0 * e2 / 14.0 + e3 / 6.0 + 9.0 * e2 * e2 / 88.0 - 3.0 * e4 / 22.0 -
                                  9.0 * e2 * e3 / 52.0 + 3.0 * e5 / 26.0;
            return 3.0 * sum + factor * series / (mean * std::sqrt(mean));
        }
        const double sx = std::sqrt(x), sy = std::sqrt(y), sz = std::sqrt(z);
        const double lambda = sx * sy + sx * sz + sy * sz;
        sum += factor / (sz * (z + lambda));
        factor *= 0.25;
        x = 0.25 * (x + lambda);
        y = 0.25 * (y + lambda);
        z = 0.25 * (z + lambda);
    }
    return 3.0 * sum;
}

EllipsoidAddedMass lamb_added_mass(const std::array<double, 3>& axes) {
    // Lengths relative to the largest axis, so that neither millimetres nor kilometres lose digits.
    const double unit = std::max({axes[0], axes[1], axes[2]});
    const std::array<double, 3> a{axes[0] / unit, axes[1] / unit, axes[2] / unit};
    const double abc = a[0] * a[1] * a[2];
    const double volume = 4.0 / 3.0 * std::numbers::pi * abc;

    // alpha_i = abc int_0^inf dl / ((a_i^2 + l) sqrt((a^2+l)(b^2+l)(c^2+l))) = 2/3 abc R_D(others, a_i^2); they add
    // to 2.
    std::array<double, 3> alpha;
    for (size_t i = 0; i < 3; ++i) {
        const double p = a[(i + 1) % 3], q = a[(i + 2) % 3];
        alpha[i] = 2.0 / 3.0 * abc * carlson_rd(p * p, q * q, a[i] * a[i]);
    }
    EllipsoidAddedMass out{};
    for (size_t i = 0; i < 3; ++i) {
        const double others = alpha[(i + 1) % 3] + alpha[(i + 2) % 3]; // 2 - alpha_i without cancellation
        out.translation[i] = volume * alpha[i] / others * unit * unit * unit;
    }
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const double aj2 = a[j] * a[j], ak2 = a[k] * a[k];
        const double difference = aj2 - ak2;
        const double wanted = alpha[k] - alpha[j];
        const double denominator = 2.0 * difference - (aj2 + ak2) * wanted;
        // Both vanish together about an axis of revolution; the quotient goes to zero with the fourth power of the
        // difference over the second.
        double d = 0.0;
        if (std::abs(difference) > 1e-7 * (aj2 + ak2))
            d = volume / 5.0 * difference * difference * wanted / denominator;
        out.rotation[i] = std::max(0.0, d) * (unit * unit * unit * unit * unit);
    }
    return out;
}

} // namespace lr::shape
