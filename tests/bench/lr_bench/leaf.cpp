#include "lr_bench/leaf.h"

#include <algorithm>
#include <cmath>

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
