#include "contact/distance.h"

#include "kernel/closest-inl.h"

namespace lr {
namespace {

using Lane = HWY_NAMESPACE::OnePair<double, Double3, true, 40>;
// Of the square of the distance. Of the pair's size, below which a distance has no direction that means anything.
constexpr double converged = 1e-7, touching = 1e-7;

// From the collider to the body, unit: a guess of the normal.
Double3 between(const PlacedBody& body, const PlacedCollider& collider) {
    Double3 out = to_double(body.center) - collider.middle();
    if (collider.count == 0 && !collider.hull) {
        const auto beyond = [](double v, double h) { return v < -h ? v + h : v > h ? v - h : 0.0; };
        const Double3 half = collider.half;
        out = {beyond(out.x, half.x), beyond(out.y, half.y), beyond(out.z, half.z)};
    }
    const double size = length(out);
    return size > 0.0 ? 1.0 / size * out : Double3{0.0, 1.0, 0.0};
}

} // namespace

Nearest nearest_points(const PlacedBody& body, const PlacedCollider& collider, double enough) {
    const auto support = [&](Double3 direction) {
        const Double3 on_body = body.support(-direction);
        return HWY_NAMESPACE::Corner<Lane>{on_body - collider.support(direction), on_body};
    };
    const auto found =
        HWY_NAMESPACE::closest<Lane>(support, between(body, collider), enough, touching, 0.5 * converged);
    // Where rounding kept the rounds from closing, the best normal seen is not that of the last points.
    const bool overlap = found.overlap || !(found.lower >= 0.0);
    return {overlap, found.distance, found.lower, found.normal, found.on_a, found.on_a - found.v};
}

} // namespace lr
