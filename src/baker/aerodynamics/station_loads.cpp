#include "baker/aerodynamics/station_loads.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace lr::baker {
namespace {

using Eigen::Vector3d;

Vector3d vector_of(const std::array<double, 3>& a) {
    return {a[0], a[1], a[2]};
}

// Normal force over rho/2, against the normal. u: the stream with camber as incidence. Stations stall more gradually than a whole plate.
double normal_force(const StationData& t, const Vector3d& u, bool whole) {
    const double along = u.x() * u.x() + u.y() * u.y(), s2 = along + u.z() * u.z();
    if (!(s2 > 0.0) || !(t.plate_drag > 0.0)) return 0.0;
    const double s = std::sqrt(s2), sine2 = u.z() * u.z() / s2;
    double attached = 0.0, slope = 0.0, vortex = 0.0;
    if (along > 0.0) {
        const double chord = u.x() * u.x() / along, span = u.y() * u.y() / along;
        slope = chord * t.plate_lift[0] + span * t.plate_lift[1];
        vortex = chord * t.plate_vortex[0] + span * t.plate_vortex[1];
        const double limit = 1.0 / std::max(chord / t.plate_stall[0] + span / t.plate_stall[1], 1.0);
        const double x = sine2 / limit * (sine2 / limit);
        const double left = (1.0 - limit) * (whole ? x * x : x);
        attached = 1.0 - sine2 + left > 0.0 ? (1.0 - sine2) / (1.0 - sine2 + left) : 0.0;
    }
    const Vector3d hollow = vector_of(t.hollow);
    return std::max(1.0 - hollow.dot(u) / s, 0.0) * u.z() *
           (attached * (slope * std::sqrt(along) + vortex * std::abs(u.z())) +
            (1.0 - attached) * t.plate_drag * s * (1.0 + 0.8 * along / s2));
}
} // namespace

Wrench loads_of(const StationData& t, const Motion& motion, double viscosity, double length, const Vector3d* lift) {
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> axes(t.axes.data());
    const Vector3d place = vector_of(t.place);
    const Vector3d u = axes * (motion.velocity + motion.spin.cross(place)), w = axes * motion.spin;
    const double s2 = u.squaredNorm(), s = std::sqrt(s2);
    const double reynolds = s * length / viscosity, blunt = reynolds / (reynolds + 8710.0);
    const double stream = lift ? s : std::abs(u.z());
    Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero(), circulation = Vector3d::Zero();
    const double most = std::max({t.spin_drag[0], t.spin_drag[1], t.spin_drag[2]});
    double whirl = 0.0;
    for (std::size_t k = 0; k < 3 && most > 0.0; ++k) {
        const double spin = w[static_cast<Eigen::Index>(k)];
        whirl += t.spin_drag[k] / most * spin * spin;
    }
    whirl = std::sqrt(whirl);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto at = static_cast<Eigen::Index>(k);
        const double part = s2 > 0.0 ? u[at] * u[at] / s2 : 0.0;
        force -= part * 0.5 * (t.drag[k] + t.drag_blunt[k] * blunt) * s * u;
        force[at] -= (t.drag_layer[k] * std::sqrt(viscosity * s) + t.drag_stokes[k] * viscosity) * u[at];
        circulation[at] = t.spin_lift[k] * w[at];
        if (s > 0.0 && lift) circulation[at] -= (*lift)[at] * u[(at + 1) % 3] * u[(at + 2) % 3] / s;
        moment[at] -=
            (t.spin_drag[k] * whirl + t.spin_drag_stream[k] * stream + t.spin_drag_stokes[k] * viscosity) * w[at];
    }
    force.z() -= 0.5 * normal_force(t, {u.x(), u.y(), u.z() - t.camber * std::abs(u.x())}, lift);
    force += circulation.cross(u);
    Wrench out;
    const Vector3d f = axes.transpose() * force;
    out << f, axes.transpose() * moment + place.cross(f);
    return out;
}

StationData as_station(const AerodynamicData& a, const Vector3d& center, Vector3d& lift) {
    StationData out;
    const auto n =
        static_cast<std::size_t>(std::max_element(a.broadside.begin(), a.broadside.end()) - a.broadside.begin());
    const auto turned = [&](const std::array<double, 3>& v) {
        return std::array{v[(n + 1) % 3], v[(n + 2) % 3], v[n]};
    };
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < 3; ++i) out.axes[3 * k + i] = a.axes[3 * ((n + 1 + k) % 3) + i];
    out.place = {center[0], center[1], center[2]};
#define LR_TURNED(name) out.name = turned(a.name);
    LR_TURNED(drag)
    LR_TURNED(drag_blunt)
    LR_TURNED(drag_layer)
    LR_TURNED(drag_stokes)
    LR_TURNED(plate_lift)
    LR_TURNED(plate_vortex)
    LR_TURNED(plate_stall)
    LR_TURNED(spin_lift)
    LR_TURNED(spin_drag)
    LR_TURNED(spin_drag_stream)
    LR_TURNED(spin_drag_stokes)
#undef LR_TURNED
    out.plate_drag = a.plate_drag;
    lift = vector_of(turned(a.lift));
    return out;
}

std::vector<Motion> test_motions(double speed, double size) {
    std::vector<Vector3d> sides;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (x || y || z) sides.push_back(Vector3d(x, y, z).normalized());
    const double spin = 2.0 * speed / size;
    std::vector<Motion> out;
    for (const Vector3d& side : sides) {
        out.push_back({speed * side, Vector3d::Zero()});
        out.push_back({Vector3d::Zero(), spin * side});
        for (Eigen::Index k = 0; k < 3; ++k) out.push_back({speed * side, spin * Vector3d::Unit(k)});
    }
    return out;
}

double difference(std::span<const Wrench> loads, std::span<const Wrench> reference) {
    double force = 0.0, moment = 0.0, all_force = 0.0, all_moment = 0.0;
    for (std::size_t i = 0; i < reference.size(); ++i) {
        const Wrench d = loads[i] - reference[i];
        force += d.head<3>().squaredNorm();
        moment += d.tail<3>().squaredNorm();
        all_force += reference[i].head<3>().squaredNorm();
        all_moment += reference[i].tail<3>().squaredNorm();
    }
    const auto ratio = [](double part, double whole) { return whole > 0.0 ? std::sqrt(part / whole) : 0.0; };
    return std::max(ratio(force, all_force), ratio(moment, all_moment));
}
} // namespace lr::baker
