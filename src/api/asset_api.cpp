// Assets: from files, from ellipsoids, and from numbers.
#include "api/struct_conversion.h"
#include "asset/asset.h"
#include "asset/asset_file.h"
#include "asset/closed_forms/ellipsoid_asset.h"
#include "asset/closed_forms/ellipsoid_formulas.h"

#include <algorithm>
#include <cstdio>
#include <vector>

namespace lr::api {
namespace {

lr_status status_of(const Faults& faults) {
    for (const Fault& f : faults) {
        if (f.severity != Severity::error) continue;
        switch (f.id) {
        case FaultId::asset_too_short:
        case FaultId::asset_foreign:
            return LR_ERROR_ASSET_FORMAT;
        case FaultId::asset_newer_version:
            return LR_ERROR_ASSET_VERSION;
        case FaultId::asset_corrupt:
        case FaultId::asset_checksum:
        case FaultId::file_too_large:
            return LR_ERROR_ASSET_CORRUPT;
        default:
            return LR_ERROR_ASSET_INVALID;
        }
    }
    return LR_OK;
}

// Runs `make` if `given` and `out` are not null. The reason of a refusal is the first error in the faults: where, what, and the remedy.
template <class Make> lr_status make_asset(const char* function, const void* given, lr_asset** out, const Make& make) {
    const FloatMode mode;
    if (out) *out = nullptr;
    Faults faults;
    const lr_status status = given && out ? guarded([&] { return make(*out, faults); }) : LR_ERROR_NULL_ARGUMENT;
    const auto first =
        std::find_if(faults.begin(), faults.end(), [](const Fault& f) { return f.severity == Severity::error; });
    char why[last_error_bytes - 32]; // the rest is for the name of the function
    if (first != faults.end()) {
        const char* const colon = first->where.empty() ? "" : ": ";
        std::snprintf(why, sizeof why, "%s%s%s %s", first->where.c_str(), colon, first->what.c_str(),
                      first->remedy.c_str());
    }
    return note_refusal(function, {status, first != faults.end() ? why : nullptr});
}

lr_status load(const void* bytes, uint64_t size, lr_asset*& out, Faults& faults) {
    AssetData data;
    if (!read_asset(bytes, static_cast<size_t>(size), data, faults)) return status_of(faults);
    out = new lr_asset(std::move(data), asset_format_version);
    return LR_OK;
}

// For assets without a file: adds a turbulence table for this intensity and checks the asset.
lr_status finish(AssetData&& data, double intensity, const std::array<double, 3>& extents, lr_asset*& out,
                 Faults& faults) {
    data.turbulence = shape::decay_table(data, intensity);
    if (!check_asset(data, faults)) return LR_ERROR_INVALID_ARGUMENT;
    out = new lr_asset(std::move(data), 0, extents);
    return LR_OK;
}

lr_status create(const lr_ellipsoid_desc& d, lr_asset*& out, Faults& faults) {
    if (!finite(d.semi_axes, d.center_of_mass, d.density, d.fluid_density, d.fluid_viscosity, d.intensity))
        return LR_ERROR_NOT_FINITE;
    shape::EllipsoidSpec spec;
    std::copy(d.semi_axes, d.semi_axes + 3, spec.semi_axes.begin());
    std::copy(d.center_of_mass, d.center_of_mass + 3, spec.center_of_mass.begin());
    spec.density = d.density;
    spec.fluid_density = d.fluid_density;
    spec.fluid_viscosity = d.fluid_viscosity;
    spec.intensity = d.intensity;
    AssetData data;
    if (!shape::ellipsoid_body(spec, data, faults)) return LR_ERROR_INVALID_ARGUMENT;
    return finish(std::move(data), d.intensity, {}, out, faults);
}

bool possible(const lr_rigid_desc& d, Faults& faults) {
    const auto good = [&](double value, double low, double high, const char* name) {
        return shape::in_range(value, low, high, name, faults);
    };
    return good(d.mass, 1e-18, 1e12, "mass") && good(d.volume, 1e-21, 1e12, "volume") &&
           good(d.fluid_density, 1e-3, 1e6, "fluid_density") && good(d.fluid_viscosity, 1e-9, 1e3, "fluid_viscosity") &&
           good(d.intensity, 0.0, 10.0, "intensity") &&
           std::all_of(d.extents, d.extents + 3, [&](double e) { return good(e, 1e-8, 1e4, "extents"); });
}

lr_status create(const lr_rigid_desc& d, lr_asset*& out, Faults& faults) {
    if (!finite(d.mass, d.volume, d.fluid_density, d.fluid_viscosity, d.intensity, d.inertia, d.added_mass,
                d.center_of_buoyancy, d.extents))
        return LR_ERROR_NOT_FINITE;
    if (!possible(d, faults)) return LR_ERROR_INVALID_ARGUMENT;
    AssetData data;
    if (d.aerodynamics)
        if (const lr_status status = read_loads(d.aerodynamics, data.aerodynamics); status != LR_OK) return status;
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
        // Turbulence acts on the added mass or, if that is more, on the displaced fluid.
        along[i] = std::max(data.added_mass[i * 7], d.volume);
    }
    shape::set_scales(semi_axes, along, data);
    if (!d.aerodynamics) data.aerodynamics = shape::default_aerodynamics(shape::ellipsoid_geometry(semi_axes));
    return finish(std::move(data), d.intensity, {d.extents[0], d.extents[1], d.extents[2]}, out, faults);
}

template <class Desc> lr_status create_asset(const char* function, const Desc* desc, lr_asset** out) {
    return make_asset(function, desc, out, [&](lr_asset*& asset, Faults& faults) {
        Desc d;
        const Outcome outcome = read_struct(desc, d);
        return outcome.refused() ? outcome.status : create(d, asset, faults);
    });
}

template <class S, class Fill> lr_status report(const char* function, const lr_asset* asset, S* to, const Fill& fill) {
    const FloatMode mode;
    const lr_status status = asset ? check_size(to) : LR_ERROR_NULL_ARGUMENT;
    if (status == LR_OK) write_struct(fill(*asset), to);
    return note_refusal(function, status);
}

lr_asset_info info_of(const lr_asset& asset) {
    const AssetData& d = asset.data;
    lr_asset_info out{};
    if (asset.diagonal) out.flags |= LR_ASSET_DIAGONAL;
    if (is_symmetric(asset.data, asset.data.aerodynamics)) out.flags |= LR_ASSET_SYMMETRIC;
    // Truncates between UTF-8 characters.
    size_t length = std::min(d.name.size(), sizeof out.name - 1);
    if (length < d.name.size())
        while (length > 0 && (static_cast<unsigned char>(d.name[length]) & 0xc0) == 0x80) --length;
    std::copy_n(d.name.data(), length, out.name);
    out.mass = d.mass;
    out.volume = d.volume;
    out.density = d.density;
    std::copy(d.center_of_mass.begin(), d.center_of_mass.end(), out.center_of_mass);
    std::copy(d.center_of_buoyancy.begin(), d.center_of_buoyancy.end(), out.center_of_buoyancy);
    std::copy(d.inertia.begin(), d.inertia.end(), out.inertia);
    for (size_t i = 0; i < 36; ++i) out.added_mass[i] = d.added_mass[i] * d.fluid_density;
    out.fluid_density = d.fluid_density;
    out.fluid_viscosity = d.fluid_viscosity;
    out.length_d = d.length_d;
    out.length_b = d.length_b;
    out.length_l = d.length_l;
    out.u0 = d.u0;
    out.reynolds = d.reynolds();
    out.c0 = d.turbulence.c0;
    out.turbulence_dt = d.turbulence.dt * d.length_l / d.u0;
    out.turbulence_count = static_cast<uint32_t>(d.turbulence.chi.size());
    out.hull_vertex_count = static_cast<uint32_t>(d.hull.vertices.size() / 3);
    out.hull_triangle_count = static_cast<uint32_t>(d.hull.triangles.size() / 3);
    out.format_version = asset.format_version;
    out.content_hash = asset.content_hash;
    return out;
}
} // namespace
} // namespace lr::api

using namespace lr;
using namespace lr::api;

extern "C" {

lr_status lr_asset_load_file(const char* path_utf8, lr_asset** out) {
    return make_asset("lr_asset_load_file", path_utf8, out, [&](lr_asset*& asset, Faults& faults) {
        std::vector<unsigned char> bytes;
        const lr_status status = read_asset_bytes(path_utf8, bytes);
        return status == LR_OK ? load(bytes.data(), bytes.size(), asset, faults) : status;
    });
}

lr_status lr_asset_load_memory(const void* bytes, uint64_t size, lr_asset** out) {
    return make_asset("lr_asset_load_memory", bytes, out,
                      [&](lr_asset*& asset, Faults& faults) { return load(bytes, size, asset, faults); });
}

lr_status lr_asset_check_memory(const void* bytes, uint64_t size, lr_fault_fn report, void* user) {
    const FloatMode mode;
    const auto check = [&]() -> lr_status {
        if (!bytes) return LR_ERROR_NULL_ARGUMENT;
        AssetData data;
        Faults faults;
        read_asset(bytes, static_cast<size_t>(size), data, faults);
        if (report)
            for (const Fault& f : faults)
                report(user, static_cast<uint32_t>(f.id), f.where.c_str(), f.what.c_str(), f.remedy.c_str());
        return status_of(faults);
    };
    return note_refusal("lr_asset_check_memory", guarded(check));
}

lr_status lr_asset_create_ellipsoid(const lr_ellipsoid_desc* desc, lr_asset** out) {
    return create_asset("lr_asset_create_ellipsoid", desc, out);
}

lr_status lr_asset_create_rigid(const lr_rigid_desc* desc, lr_asset** out) {
    return create_asset("lr_asset_create_rigid", desc, out);
}

lr_status lr_asset_retain(lr_asset* asset) {
    if (!asset) return note_refusal("lr_asset_retain", LR_ERROR_NULL_ARGUMENT);
    retain(*asset);
    return LR_OK;
}

void lr_asset_release(lr_asset* asset) {
    release(asset);
}

lr_status lr_asset_get_info(const lr_asset* asset, lr_asset_info* info) {
    return report("lr_asset_get_info", asset, info, info_of);
}

lr_status lr_asset_get_aerodynamics(const lr_asset* asset, lr_aerodynamics* aerodynamics) {
    return report("lr_asset_get_aerodynamics", asset, aerodynamics,
                  [](const lr_asset& a) { return to_struct(a.data.aerodynamics); });
}

} // extern "C"
