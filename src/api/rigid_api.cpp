// Assets from numbers.
#include "api/aerodynamics.h"
#include "api/arguments.h"
#include "asset/asset.h"
#include "format/asset_file.h"
#include "shape/aerodynamics.h"
#include "shape/ellipsoid.h"

#include <algorithm>

using lr::api::finite;
using lr::api::in_range;

namespace {

bool possible(const lr_rigid_desc& d) {
    if (d.reserved != 0 || !in_range(d.mass, 1e-18, 1e12) || !in_range(d.volume, 1e-21, 1e12) ||
        !in_range(d.fluid_density, 1e-3, 1e6) || !in_range(d.fluid_viscosity, 1e-9, 1e3) ||
        !in_range(d.intensity, 0.0, 10.0))
        return false;
    for (double extent : d.extents)
        if (!in_range(extent, 1e-8, 1e4)) return false;
    return true;
}

lr_status create(const lr_rigid_desc& d, const lr::AerodynamicData* loads, lr_asset** out) {
    lr::AssetData data;
    data.name = "rigid";
    data.provenance.source = "rigid";
    data.mass = d.mass;
    data.volume = d.volume;
    data.density = d.mass / d.volume;
    std::copy(d.center_of_buoyancy, d.center_of_buoyancy + 3, data.center_of_buoyancy.begin());
    std::copy(d.inertia, d.inertia + 9, data.inertia.begin());
    for (size_t i = 0; i < 36; ++i) data.added_mass[i] = d.added_mass[i] / d.fluid_density;
    data.fluid_density = d.fluid_density;
    data.fluid_viscosity = d.fluid_viscosity;
    std::array<double, 3> semi_axes{}, along{};
    for (size_t i = 0; i < 3; ++i) {
        semi_axes[i] = 0.5 * d.extents[i];
        // Without any added mass the fluid displaced is what turbulence acts on.
        along[i] = std::max(data.added_mass[i * 7], d.volume);
    }
    lr::shape::set_scales(semi_axes, along, data);
    data.turbulence = lr::shape::decay_table(data, d.intensity);
    data.aerodynamics = loads ? *loads : lr::shape::default_aerodynamics(lr::shape::ellipsoid_geometry(semi_axes));
    lr::Faults faults;
    if (!lr::check_asset(data, faults)) return LR_ERROR_INVALID_ARGUMENT;
    *out = new lr_asset(std::move(data), 0, {d.extents[0], d.extents[1], d.extents[2]});
    return LR_OK;
}

} // namespace

extern "C" {

lr_status lr_rigid_desc_init(lr_rigid_desc* desc, uint32_t struct_size) {
    const lr_status status = lr::api::begin_init(desc, struct_size);
    if (status != LR_OK) return status;
    desc->fluid_density = 1.2;
    desc->fluid_viscosity = 1.5e-5;
    desc->intensity = 1.0;
    return LR_OK;
}

lr_status lr_asset_create_rigid(const lr_rigid_desc* desc, lr_asset** out) {
    const lr::FloatMode mode;
    if (!out) return LR_ERROR_NULL_ARGUMENT;
    *out = nullptr;
    lr_rigid_desc d;
    lr_status status = lr::api::read_struct(desc, d);
    if (status != LR_OK) return status;
    const double scalars[] = {d.mass, d.volume, d.fluid_density, d.fluid_viscosity, d.intensity};
    if (!finite(scalars) || !finite(d.inertia) || !finite(d.added_mass) || !finite(d.center_of_buoyancy) ||
        !finite(d.extents))
        return LR_ERROR_NOT_FINITE;
    if (!possible(d)) return LR_ERROR_INVALID_ARGUMENT;
    lr_aerodynamics a;
    if (d.aerodynamics) {
        status = lr::api::read_loads(d.aerodynamics, a);
        if (status != LR_OK) return status;
    }
    return lr::api::guarded([&] {
        const lr::AerodynamicData loads = d.aerodynamics ? lr::api::from_struct(a) : lr::AerodynamicData{};
        return create(d, d.aerodynamics ? &loads : nullptr, out);
    });
}

} // extern "C"
