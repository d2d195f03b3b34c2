#include "shape/aerodynamics.h"
#include "shape/lamb.h"
#include "shape/portable_math.h"
#include "shape/stokes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace lr::shape {
namespace {

struct Node {
    double x, rest, weight; // rest: 1 - x, to its own last digit
};

// Tanh-sinh rule on [0, 1] (Takahasi & Mori 1974): nodes crowd at both ends, where the integrands of a flat or a slender
// ellipsoid turn sharply. A step of 0.09 leaves 1e-12 for moderate shapes and 1e-7 for one ten thousand times as long
// as thick.
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

    // Over an octant: u_z = x, and the azimuth by its half-tangent s.
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
