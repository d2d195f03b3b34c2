#include "kernel/loads/station_constants.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

using Vector = std::array<double, 3>;

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

void put(const Vector& from, double factor, float* to) {
    for (size_t i = 0; i < 3; ++i) to[i] = static_cast<float>(from[i] * factor);
}

// Upper triangle of s + sign a a^T.
void put_outer(double s, double sign, const Vector& a, float* to) {
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = i; j < 3; ++j) *to++ = static_cast<float>((i == j ? s : 0.0) + sign * a[i] * a[j]);
}

void make_station(const StationData& from, double d, double start_drag, StationConstants& to) {
    Vector r{}, axis[3];
    for (size_t i = 0; i < 3; ++i) r[i] = from.place[i] / d;
    for (size_t k = 0; k < 3; ++k) {
        std::copy_n(from.axes.begin() + static_cast<std::ptrdiff_t>(3 * k), 3, axis[k].begin());
        put(axis[k], 1.0, to.along[k]);
        put(cross(r, axis[k]), 1.0, to.along[k] + 3);
        put(axis[k], 1.0, to.axes + 3 * k);
        put_outer(0.0, 1.0, axis[k], to.outer[k]);
    }
    put(r, 1.0, to.place);
    put_outer(r[0] * r[0] + r[1] * r[1] + r[2] * r[2], -1.0, r, to.spread);
    put(from.drag, 0.5 * d, to.drag);
    put(from.drag_blunt, 0.5 * d, to.drag_blunt);
    put(from.drag_layer, d * std::sqrt(d), to.drag_layer);
    put(from.drag_stokes, d * d, to.drag_stokes);
    put(from.spin_lift, 1.0, to.spin_lift);
    put(from.spin_drag, 1.0 / (d * d), to.spin_drag);
    put(from.spin_drag_stream, 1.0 / d, to.spin_drag_stream);
    put(from.spin_drag_stokes, 1.0, to.spin_drag_stokes);
    const double strongest = std::max({from.spin_drag[0], from.spin_drag[1], from.spin_drag[2]});
    put(from.spin_drag, strongest > 0.0 ? 1.0 / strongest : 0.0, to.spin_weight);
    for (size_t k = 0; k < 2; ++k) {
        to.lift[k] = static_cast<float>(0.5 * d * from.plate_lift[k]);
        to.vortex[k] = static_cast<float>(0.5 * d * from.plate_vortex[k]);
        to.lift_arm[k] = static_cast<float>(from.lift_arm[k] / d);
        to.stall[k] = static_cast<float>(1.0 / std::max(from.plate_stall[k], 1e-3));
    }
    to.plate_drag = static_cast<float>(0.5 * d * from.plate_drag);
    to.start_drag = static_cast<float>(0.5 * d * from.plate_drag * start_drag);
    to.separated_shedding = static_cast<float>(from.separated_shedding);
    to.camber = static_cast<float>(from.camber);
}
} // namespace

void make_stations(const AssetData& asset, const AerodynamicData& loads, StationSet& out) {
    const bool own = loads == asset.aerodynamics;
    out.count = own ? static_cast<uint32_t>(std::min(asset.stations.size(), most_stations)) : 0;
    for (size_t i = 0; i < out.count; ++i)
        make_station(asset.stations[i], asset.length_d, asset.aerodynamics.start_drag, out.station[i]);
}
} // namespace lr
