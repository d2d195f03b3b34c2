// What no body has, though each of its numbers could be one's.
#include "format/asset_file.h"
#include "format/matrix6.h"
#include "shape/body_scales.h"

#include <algorithm>

namespace lr {
namespace {

void fail(Faults& faults, const char* where, const char* what) {
    faults.push_back({FaultId::asset_inconsistent, Severity::error, where, what, "Bake the asset again."});
}

// The second moments of mass, trace/2 - I, are sums of squares. Those across a flat body are zero, and rounding leaves a little below.
bool has_moments_of_mass(const AssetData& d) {
    const double half_trace = 0.5 * (d.inertia[0] + d.inertia[4] + d.inertia[8]);
    std::array<double, 9> moments{};
    for (size_t i = 0; i < 9; ++i) moments[i] = (i % 4 == 0 ? 1.0 + 1e-6 : 0.0) - d.inertia[i] / half_trace;
    return is_positive_definite(rigid_mass_matrix(1.0, moments), 0.0);
}

// Not all on a line: a hundredth of the thickness is what the mass is spread about any axis, at least.
bool has_spread(const AssetData& d) {
    const double least = 1e-4 * d.mass * d.length_b * d.length_b, size = d.inertia[0] + d.inertia[4] + d.inertia[8];
    std::array<double, 9> beyond{};
    for (size_t i = 0; i < 9; ++i) beyond[i] = (d.inertia[i] - (i % 4 == 0 ? least : 0.0)) / size;
    return is_positive_definite(rigid_mass_matrix(1.0, beyond), 0.0);
}

// Along the axes of the body; d itself may lie across them.
double extent(const HullData& hull) {
    double largest = 0.0;
    for (size_t axis = 0; axis < 3; ++axis) {
        float low = hull.vertices[axis], high = low;
        for (size_t i = axis; i < hull.vertices.size(); i += 3)
            low = std::min(low, hull.vertices[i]), high = std::max(high, hull.vertices[i]);
        largest = std::max(largest, static_cast<double>(high) - static_cast<double>(low));
    }
    return largest;
}

} // namespace

bool check_plausible(const AssetData& d, Faults& faults) {
    const size_t before = faults.size();
    const double d1 = d.length_d, d2 = d1 * d1;
    // Ten cubes of the side d: the layers of a folded sheet may displace more than its hull holds.
    if (d.volume > 10.0 * d2 * d1) fail(faults, "volume", "The volume is far too large for the length d.");
    if (d.projected_area > 10.0 * d2) fail(faults, "projected_area", "The area is far too large for the length d.");
    if (d.length_b > 10.0 * d1) fail(faults, "lengths.b", "The thickness is far larger than the length d.");
    if (d.length_l > 10.0 * d1) fail(faults, "lengths.l", "The turbulence length is far larger than the length d.");
    // paper Eq. 1. It scales the turbulence that the body meets.
    const double u0 = shape::speed_scale(d.density, d.fluid_density, d.length_b);
    if (d.u0 > 10.0 * u0 || d.u0 < 0.1 * u0)
        fail(faults, "u0", "The speed does not fit the densities and the thickness.");
    if (!has_moments_of_mass(d))
        fail(faults, "inertia",
             "A principal moment of inertia is larger than the other two together: no mass lies so.");
    if (!has_spread(d)) fail(faults, "inertia", "A moment of inertia is far too small for the thickness.");
    if (!d.hull.vertices.empty() && extent(d.hull) < 0.5 * d1)
        fail(faults, "hull.vertices", "The hull is far smaller than the length d.");
    return faults.size() == before;
}

} // namespace lr
