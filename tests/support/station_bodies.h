// Bodies with stations for tests: assets from data, with numbers of no real body.
#pragma once

#include "asset/asset_file.h"
#include "asset/closed_forms/ellipsoid_asset.h"
#include "support/random.h"
#include "support/scene.h"
#include "support/vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace test {

inline Asset load(const lr::AssetData& data) {
    const std::vector<uint8_t> bytes = lr::write_asset(data);
    lr_asset* asset = nullptr;
    REQUIRE(lr_asset_load_memory(bytes.data(), bytes.size(), &asset) == LR_OK);
    return Asset(asset);
}

inline lr::AssetData ellipsoid_data(const lr::shape::EllipsoidSpec& spec) {
    lr::AssetData data;
    lr::Faults faults;
    REQUIRE(lr::shape::ellipsoid_body(spec, data, faults));
    data.turbulence = lr::shape::decay_table(data, 1.0);
    return data;
}
// Without gusts and shed vortices the loads only take energy.
inline void calm(lr::AerodynamicData& a) {
    a.intensity = a.shedding_noise = a.shedding_moment = a.shedding_rate_moment = 0.0;
}

// Rows chord, span, normal of a frame turned by some tenths of a radian. Without the C library's functions, whose bits differ between systems.
inline std::array<double, 9> turned_axes(Vec half_turn) {
    const Matrix3 r = rotation(normalised({half_turn[0], half_turn[1], half_turn[2], 1.0}));
    return {r[0][0], r[0][1], r[0][2], r[1][0], r[1][1], r[1][2], r[2][0], r[2][1], r[2][2]};
}

// A plate of this area (m^2) and about this width, with every kind of load.
inline lr::StationData some_station(double area, double width) {
    lr::StationData s;
    const double volume = area * width, rod = std::sqrt(width);
    s.drag = {0.02 * area, 0.03 * area, 0.1 * area}, s.drag_blunt = {0.01 * area, 0.02 * area, 0.05 * area};
    s.drag_layer = {1.0 * area / rod, 1.2 * area / rod, 0.5 * area / rod};
    s.drag_stokes = {3.0 * area / width, 4.0 * area / width, 5.0 * area / width};
    s.plate_lift = {3.0 * area, 1.5 * area, 0.0}, s.plate_vortex = {2.0 * area, 3.0 * area, 0.0};
    s.plate_stall = {0.2, 0.3, 0.25};
    s.spin_lift = {0.4 * volume, 0.6 * volume, 0.1 * volume};
    s.spin_drag = {0.02 * volume * width * width, 0.03 * volume * width * width, 0.01 * volume * width * width};
    s.spin_drag_stream = {0.05 * volume * width, 0.04 * volume * width, 0.02 * volume * width};
    s.spin_drag_stokes = {1.0 * volume, 2.0 * volume, 1.5 * volume};
    s.plate_drag = 1.3 * area;
    s.lift_arm = {0.15 * width, 0.1 * width, 0.0};
    s.hollow = {0.1, 0.05, 0.2};
    s.separated_shedding = 0.2 * volume;
    s.camber = 0.05;
    return s;
}

// `count` stations about a body of length d, each tilted differently. One random number per statement, because arguments have no order.
inline std::vector<lr::StationData> some_stations(size_t count, double d, uint64_t seed) {
    Random random(seed);
    std::vector<lr::StationData> all;
    for (size_t i = 0; i < count; ++i) {
        const double area = random.uniform(0.5, 1.5) * 0.2 * d * d / static_cast<double>(count);
        const double width = random.uniform(0.15, 0.3) * d;
        lr::StationData s = some_station(area, width);
        Vec half_turn{};
        for (double& x : half_turn) x = random.uniform(-0.15, 0.15);
        s.axes = turned_axes(half_turn);
        for (double& x : s.place) x = random.uniform(-0.35, 0.35) * d;
        s.place[2] *= 0.15;
        s.camber *= random.uniform(-1.0, 1.0);
        all.push_back(s);
    }
    return all;
}

// Scales all loads that are proportional to area, for a part of a station at the same place.
inline lr::StationData part_of(lr::StationData s, double share) {
    for (auto* v : {&s.drag, &s.drag_blunt, &s.drag_layer, &s.drag_stokes, &s.plate_lift, &s.plate_vortex, &s.spin_lift,
                    &s.spin_drag, &s.spin_drag_stream, &s.spin_drag_stokes})
        for (double& x : *v) x *= share;
    s.plate_drag *= share, s.separated_shedding *= share;
    return s;
}

// A sheet with its weight off centre and five stations.
inline Asset winged() {
    lr::shape::EllipsoidSpec spec;
    spec.semi_axes = {0.03, 0.02, 0.0005}, spec.density = 400.0;
    spec.center_of_mass = {0.004, -0.002, 0.0001};
    lr::AssetData data = ellipsoid_data(spec);
    data.stations = some_stations(5, data.length_d, 5);
    return load(data);
}

} // namespace test
