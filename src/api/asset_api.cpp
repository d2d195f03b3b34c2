#include "api/aerodynamics.h"
#include "api/arguments.h"
#include "asset/asset.h"
#include "asset/asset_bytes.h"
#include "format/asset_file.h"
#include "shape/ellipsoid.h"

#include <algorithm>
#include <vector>

namespace {

using lr::api::guarded;

lr_status status_of(const lr::Faults& faults) {
    for (const lr::Fault& f : faults) {
        if (f.severity != lr::Severity::error) continue;
        switch (f.id) {
        case lr::FaultId::asset_too_short:
        case lr::FaultId::asset_foreign:
            return LR_ERROR_ASSET_FORMAT;
        case lr::FaultId::asset_newer_version:
            return LR_ERROR_ASSET_VERSION;
        case lr::FaultId::asset_corrupt:
        case lr::FaultId::asset_checksum:
        case lr::FaultId::file_too_large:
            return LR_ERROR_ASSET_CORRUPT;
        default:
            return LR_ERROR_ASSET_INVALID;
        }
    }
    return LR_OK;
}

lr_status load(const void* bytes, uint64_t size, lr_asset** out) {
    lr::AssetData data;
    lr::Faults faults;
    if (!lr::read_asset(bytes, static_cast<size_t>(size), data, faults)) return status_of(faults);
    *out = new lr_asset(std::move(data), lr::asset_format_version);
    return LR_OK;
}

} // namespace

extern "C" {

lr_status lr_asset_load_file(const char* path_utf8, lr_asset** out) {
    const lr::FloatMode mode;
    if (!out) return LR_ERROR_NULL_ARGUMENT;
    *out = nullptr;
    if (!path_utf8) return LR_ERROR_NULL_ARGUMENT;
    return guarded([&]() -> lr_status {
        std::vector<unsigned char> bytes;
        const lr_status status = lr::read_asset_bytes(path_utf8, bytes);
        if (status != LR_OK) return status;
        return load(bytes.data(), bytes.size(), out);
    });
}

lr_status lr_asset_load_memory(const void* bytes, uint64_t size, lr_asset** out) {
    const lr::FloatMode mode;
    if (!out) return LR_ERROR_NULL_ARGUMENT;
    *out = nullptr;
    if (!bytes) return LR_ERROR_NULL_ARGUMENT;
    return guarded([&] { return load(bytes, size, out); });
}

lr_status lr_asset_check_memory(const void* bytes, uint64_t size, lr_fault_fn report, void* user) {
    const lr::FloatMode mode;
    if (!bytes) return LR_ERROR_NULL_ARGUMENT;
    return guarded([&] {
        lr::AssetData data;
        lr::Faults faults;
        lr::read_asset(bytes, static_cast<size_t>(size), data, faults);
        if (report)
            for (const lr::Fault& f : faults)
                report(user, static_cast<uint32_t>(f.id), f.where.c_str(), f.what.c_str(), f.remedy.c_str());
        return status_of(faults);
    });
}

lr_status lr_ellipsoid_desc_init(lr_ellipsoid_desc* desc, uint32_t struct_size) {
    const lr_status status = lr::api::begin_init(desc, struct_size);
    if (status != LR_OK) return status;
    const lr::shape::EllipsoidSpec initial;
    desc->fluid_density = initial.fluid_density;
    desc->fluid_viscosity = initial.fluid_viscosity;
    desc->intensity = initial.intensity;
    return LR_OK;
}

lr_status lr_asset_create_ellipsoid(const lr_ellipsoid_desc* desc, lr_asset** out) {
    const lr::FloatMode mode;
    if (!out) return LR_ERROR_NULL_ARGUMENT;
    *out = nullptr;
    lr_ellipsoid_desc d;
    const lr_status status = lr::api::read_struct(desc, d);
    if (status != LR_OK) return status;
    const double scalars[] = {d.density, d.fluid_density, d.fluid_viscosity, d.intensity};
    if (!lr::api::finite(d.semi_axes) || !lr::api::finite(d.center_of_mass) || !lr::api::finite(scalars))
        return LR_ERROR_NOT_FINITE;
    if (d.reserved != 0) return LR_ERROR_INVALID_ARGUMENT;
    return guarded([&]() -> lr_status {
        lr::shape::EllipsoidSpec spec;
        std::copy(d.semi_axes, d.semi_axes + 3, spec.semi_axes.begin());
        std::copy(d.center_of_mass, d.center_of_mass + 3, spec.center_of_mass.begin());
        spec.density = d.density;
        spec.fluid_density = d.fluid_density;
        spec.fluid_viscosity = d.fluid_viscosity;
        spec.intensity = d.intensity;
        lr::AssetData data;
        lr::Faults faults;
        if (!lr::shape::ellipsoid_body(spec, data, faults)) return LR_ERROR_INVALID_ARGUMENT;
        data.turbulence = lr::shape::decay_table(data, d.intensity);
        if (!lr::check_asset(data, faults)) return LR_ERROR_INVALID_ARGUMENT;
        *out = new lr_asset(std::move(data), 0);
        return LR_OK;
    });
}

lr_status lr_asset_retain(lr_asset* asset) {
    if (!asset) return LR_ERROR_NULL_ARGUMENT;
    lr::retain(*asset);
    return LR_OK;
}

void lr_asset_release(lr_asset* asset) {
    lr::release(asset);
}

lr_status lr_asset_info_init(lr_asset_info* info, uint32_t struct_size) {
    return lr::api::begin_init(info, struct_size);
}

lr_status lr_asset_get_info(const lr_asset* asset, lr_asset_info* info) {
    const lr::FloatMode mode;
    if (!asset) return LR_ERROR_NULL_ARGUMENT;
    const lr_status status = lr::api::check_size(info);
    if (status != LR_OK) return status;
    const lr::AssetData& d = asset->data;
    lr_asset_info out{};
    out.flags = asset->diagonal ? LR_ASSET_DIAGONAL : 0;
    // Cut before the last whole character that does not fit.
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
    out.format_version = asset->format_version;
    out.content_hash = asset->content_hash;
    lr::api::write_struct(out, info);
    return LR_OK;
}

lr_status lr_aerodynamics_init(lr_aerodynamics* aerodynamics, uint32_t struct_size) {
    const lr_status status = lr::api::begin_init(aerodynamics, struct_size);
    if (status == LR_OK) lr::api::write_struct(lr::api::to_struct({}), aerodynamics);
    return status;
}

lr_status lr_asset_get_aerodynamics(const lr_asset* asset, lr_aerodynamics* aerodynamics) {
    const lr::FloatMode mode;
    if (!asset) return LR_ERROR_NULL_ARGUMENT;
    const lr_status status = lr::api::check_size(aerodynamics);
    if (status == LR_OK) lr::api::write_struct(lr::api::to_struct(asset->data.aerodynamics), aerodynamics);
    return status;
}

} // extern "C"
