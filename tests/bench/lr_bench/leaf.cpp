#include "lr_bench/leaf.h"

#include "asset/asset_file.h"
#include "asset/closed_forms/ellipsoid_asset.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lr_bench {

lr_asset* leaf_asset(bool ballasted) {
    lr_ellipsoid_desc desc;
    lr_ellipsoid_desc_init(&desc, sizeof desc);
    for (int k = 0; k < 3; ++k) desc.semi_axes[k] = leaf_semi_axes[k];
    desc.density = leaf_density;
    desc.fluid_density = air_density;
    desc.fluid_viscosity = air_viscosity;
    if (ballasted) desc.center_of_mass[0] = 0.004, desc.center_of_mass[1] = -0.001;
    lr_asset* asset = nullptr;
    return lr_asset_create_ellipsoid(&desc, &asset) == LR_OK ? asset : nullptr;
}

lr_asset* leaf_asset_of_stations(uint32_t count) {
    lr::shape::EllipsoidSpec spec;
    std::copy_n(leaf_semi_axes, 3, spec.semi_axes.begin());
    spec.density = leaf_density, spec.fluid_density = air_density, spec.fluid_viscosity = air_viscosity;
    spec.center_of_mass = {0.004, -0.001, 0.0};
    lr::AssetData data;
    lr::Faults faults;
    if (!lr::shape::ellipsoid_body(spec, data, faults)) return nullptr;
    data.turbulence = lr::shape::decay_table(data, 1.0);
    const lr::AerodynamicData& a = data.aerodynamics;
    for (uint32_t i = 0; i < count; ++i) {
        const auto part = [&](std::array<double, 3> v) { // its axes: the body's y, -x, z
            return std::array{v[1] / count, v[0] / count, v[2] / count};
        };
        lr::StationData s;
        s.axes = {0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0};
        s.place = data.center_of_buoyancy;
        s.place[0] += leaf_semi_axes[0] * ((2.0 * i + 1.0) / count - 1.0);
        s.drag = part(a.drag), s.drag_blunt = part(a.drag_blunt), s.drag_layer = part(a.drag_layer);
        s.drag_stokes = part(a.drag_stokes), s.plate_lift = part(a.plate_lift), s.plate_vortex = part(a.plate_vortex);
        s.plate_stall = {a.plate_stall[1], a.plate_stall[0], a.plate_stall[2]};
        s.spin_lift = part(a.spin_lift), s.spin_drag = part(a.spin_drag);
        s.spin_drag_stream = part(a.spin_drag_stream), s.spin_drag_stokes = part(a.spin_drag_stokes);
        s.plate_drag = a.plate_drag / count;
        s.lift_arm = {0.001, 0.001, 0.0}, s.separated_shedding = 1e-7 / count, s.camber = 0.02;
        data.stations.push_back(s);
    }
    const std::vector<uint8_t> bytes = lr::write_asset(data);
    lr_asset* asset = nullptr;
    return lr_asset_load_memory(bytes.data(), bytes.size(), &asset) == LR_OK ? asset : nullptr;
}

LeafConstants leaf_constants() {
    LeafConstants c{};
    lr_asset* const asset = leaf_asset(false);
    lr_asset_info info;
    lr_asset_info_init(&info, sizeof info);
    const bool known = asset && lr_asset_get_info(asset, &info) == LR_OK;
    lr_asset_release(asset);
    if (!known) return c;

    const double displaced = info.fluid_density * info.volume;
    double largest = 0.0;
    for (size_t k = 0; k < 3; ++k) largest = std::max(largest, info.added_mass[7 * k]);
    for (size_t k = 0; k < 3; ++k) {
        const double a = info.added_mass[7 * k], d = info.added_mass[7 * (k + 3)], j = info.inertia[4 * k];
        c.mass[k] = static_cast<float>(info.mass + a);
        c.inertia[k] = static_cast<float>(j + d);
        c.carried[k] = static_cast<float>(displaced + a);
        c.turned[k] = static_cast<float>(d + 0.02 * (displaced + largest) * j / info.mass); // viscous floor
    }
    c.weight = static_cast<float>(info.mass - displaced);
    // k0 = 3/2 U0^2 and epsilon0 = C_mu^(3/4) k0^(3/2)/l at an intensity of 1, over U0 and l.
    const double root = std::pow(0.09, 0.75);
    c.alpha = static_cast<float>((0.5 + 0.75 * info.c0) * root * std::sqrt(1.5) / info.length_l);
    c.beta2 = static_cast<float>(info.c0 * root * std::pow(1.5, 1.5) / info.length_l);
    c.ell = static_cast<float>(0.5 * info.length_d);
    c.drag = static_cast<float>(0.5 * air_density * 1.2 * 3.14159265358979 * leaf_semi_axes[0] * leaf_semi_axes[1]);
    return c;
}

} // namespace lr_bench
