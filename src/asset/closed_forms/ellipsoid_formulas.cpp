#include "asset/closed_forms/ellipsoid_formulas.h"

#include "base/portable_math.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace lr::shape {

double carlson_rd(double x, double y, double z) {
    double sum = 0.0, factor = 1.0;
    for (int i = 0; i < 64; ++i) {
        const double mean = (x + y + 3.0 * z) / 5.0;
        const double spread = std::max({std::abs(mean - x), std::abs(mean - y), std::abs(mean - z)});
        // The remainder of the series below is of sixth order in spread / mean, so 1e-3 leaves 1e-17.
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

    // alpha_i = abc int_0^inf dl / ((a_i^2 + l) sqrt((a^2+l)(b^2+l)(c^2+l))) = 2/3 abc R_D(others, a_i^2); they add to 2.
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
        // Both vanish about an axis of revolution, the numerator with the fourth power of the difference, the denominator with the second.
        double d = 0.0;
        if (std::abs(difference) > 1e-7 * (aj2 + ak2))
            d = volume / 5.0 * difference * difference * wanted / denominator;
        out.rotation[i] = std::max(0.0, d) * (unit * unit * unit * unit * unit);
    }
    return out;
}

double carlson_rf(double x, double y, double z) {
    double mean = 0.0;
    for (int i = 0; i < 64; ++i) {
        mean = (x + y + z) / 3.0;
        const double dx = (mean - x) / mean, dy = (mean - y) / mean, dz = -(dx + dy);
        // The remainder of the series is of sixth order in the differences, so 2e-3 leaves 1e-17.
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

    // chi + a_i^2 alpha_i of Happel & Brenner, 5-11.19, is 2 R_F + 2/3 a_i^2 R_D(.., a_i^2). For a_i = 0 the second term vanishes, although R_D is
    // infinite.
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

namespace {

struct Node {
    double x, rest, weight; // rest: 1 - x, without cancellation
};

// Tanh-sinh rule on [0, 1] (Takahasi & Mori 1974): nodes are dense at both ends, where the integrands of flat or slender ellipsoids are steep. A step
// of 0.09 has an error of 1e-12 for moderate shapes, and of 1e-7 for a body ten thousand times as long as thick.
std::vector<Node> unit_interval_rule() {
    constexpr double step = 0.09;
    std::vector<Node> nodes;
    for (int i = -35; i <= 35; ++i) {
        const double t = i * step;
        const double up = portable_exp(t), down = portable_exp(-t);
        const double far = portable_exp(-0.5 * std::numbers::pi * std::abs(up - down)); // e^(-pi sinh |t|)
        const double near = 1.0 / (1.0 + far), end = far / (1.0 + far);
        const bool high = i > 0;
        nodes.push_back(
            {high ? near : end, high ? end : near, near * end * 0.5 * std::numbers::pi * (up + down) * step});
    }
    return nodes;
}
} // namespace

// With the point (a u_x, b u_y, c u_z), u on the unit sphere, n dA = N dOmega, N_i = a_j a_k u_i, and
// n.(e_k x r) dA = a_k (a_j^2 - a_i^2) u_i u_j dOmega up to sign: all integrands are algebraic in u.
AerodynamicGeometry ellipsoid_geometry(const std::array<double, 3>& semi_axes) {
    const double unit = std::max({semi_axes[0], semi_axes[1], semi_axes[2]});
    std::array<double, 3> a{}, p{}, swing{};
    for (size_t i = 0; i < 3; ++i) a[i] = semi_axes[i] / unit;
    for (size_t k = 0; k < 3; ++k) {
        const size_t i = (k + 1) % 3, j = (k + 2) % 3;
        p[k] = a[i] * a[i] * a[j] * a[j];
        swing[k] = a[k] * std::abs((a[i] - a[j]) * (a[i] + a[j]));
    }
    const double unit2 = unit * unit, unit3 = unit2 * unit, unit5 = unit2 * unit3;
    AerodynamicGeometry out;
    out.volume = 4.0 / 3.0 * std::numbers::pi * a[0] * a[1] * a[2] * unit3;

    // Mean of u_k^2/|N| over the sphere (Carlson 1977, ch. 9): I_k = R_F(P)/2 - P_k R_D(.., P_k)/6, P_i = (a_j a_k)^2.
    // Then int n_k^2 dA = 4 pi P_k I_k, and their sum is the surface.
    const double rf = carlson_rf(p[0], p[1], p[2]);
    for (size_t k = 0; k < 3; ++k) {
        const size_t i = (k + 1) % 3, j = (k + 2) % 3;
        const double squared = 4.0 * std::numbers::pi * p[k] * (0.5 * rf - p[k] * carlson_rd(p[i], p[j], p[k]) / 6.0);
        const double silhouette = std::numbers::pi * a[i] * a[j];
        out.extent[k] = 2.0 * semi_axes[k];
        out.area[k] = silhouette * unit2;
        out.bluntness[k] = 0.5 * squared / silhouette;
        out.surface += squared * unit2;
    }

    // Over an octant: u_z = x, azimuth by its half-tangent s.
    const std::vector<Node> rule = unit_interval_rule();
    std::array<double, 3> stroke2{}, stroke3{}, rub{};
    for (const Node& turn : rule) {
        const double s = turn.x, bottom = 1.0 + s * s;
        const double cosine = turn.rest * (1.0 + s) / bottom, sine = 2.0 * s / bottom;
        for (const Node& height : rule) {
            const double ring2 = height.rest * (1.0 + height.x), ring = std::sqrt(ring2);
            const std::array<double, 3> u{ring * cosine, ring * sine, height.x};
            const double normal2 = p[0] * u[0] * u[0] + p[1] * u[1] * u[1] + p[2] * u[2] * u[2];
            const double normal = std::sqrt(normal2);
            const double weight = turn.weight * height.weight * 2.0 / bottom;
            for (size_t k = 0; k < 3; ++k) {
                const size_t i = (k + 1) % 3, j = (k + 2) % 3;
                const double c = swing[k] * u[i] * u[j];
                const double reach2 = a[i] * a[i] * u[i] * u[i] + a[j] * a[j] * u[j] * u[j];
                stroke2[k] += weight * c * c / normal;
                stroke3[k] += weight * c * c * c / normal2;
                rub[k] += weight * reach2 * std::sqrt(reach2) * normal;
            }
        }
    }
    for (size_t k = 0; k < 3; ++k) {
        out.stroke2[k] = 4.0 * stroke2[k] * (unit2 * unit2);
        out.stroke3[k] = 4.0 * stroke3[k] * unit5;
        out.rub[k] = 8.0 * rub[k] * unit5;
    }
    return out;
}
} // namespace lr::shape
