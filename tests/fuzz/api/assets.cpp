// Assets: from numbers, from bytes, from files.
#include "fuzz/api/model.h"

#include "asset/asset_file.h"
#include "support/asset_bytes.h"

#include <string>
#include <sys/mman.h>
#include <unistd.h>

namespace fuzz {

const std::vector<unsigned char>& asset_bytes() {
    static const std::vector<unsigned char> bytes = lr::write_asset(test::leaf_data());
    return bytes;
}

// Light and heavy, diagonal and full, with and without a hull. Kept between runs.
const std::vector<lr_asset*>& common_assets() {
    static const auto& all = *[] { // never destroyed: LeakSanitizer still finds them at the end
        auto* const kept = new std::vector<lr_asset*>(4);
        std::vector<lr_asset*>& made = *kept;
        lr_ellipsoid_desc e = initialised(LR_CALL(lr_ellipsoid_desc_init));
        e.semi_axes[0] = 0.04, e.semi_axes[1] = 0.02, e.semi_axes[2] = 0.001, e.density = 500.0;
        lr_rigid_desc r = initialised(LR_CALL(lr_rigid_desc_init));
        r.mass = 0.01, r.volume = 2e-5;
        r.inertia[0] = 1e-5, r.inertia[4] = 4e-5, r.inertia[8] = 5e-5;
        r.added_mass[14] = 1e-3, r.added_mass[21] = 1e-7, r.added_mass[28] = 3e-7;
        r.extents[0] = 0.2, r.extents[1] = 0.1, r.extents[2] = 0.001;
        bool ok = LR_CALL(lr_asset_create_ellipsoid)(&e, &made[0]) == LR_OK &&
                  LR_CALL(lr_asset_load_memory)(asset_bytes().data(), asset_bytes().size(), &made[1]) == LR_OK &&
                  LR_CALL(lr_asset_create_rigid)(&r, &made[2]) == LR_OK;
        e.semi_axes[1] = e.semi_axes[2] = 0.04, e.density = 1200.0, e.fluid_density = 1000.0, e.fluid_viscosity = 1e-6;
        ok = ok && LR_CALL(lr_asset_create_ellipsoid)(&e, &made[3]) == LR_OK;
        if (!ok) defect("lr_asset_create_*", "plain assets are refused");
        return kept;
    }();
    return all;
}

namespace {

// Checks that an asset exists exactly if the status says so. The asset is a reference: the call in the preceding argument writes
// it.
void made(Fuzzer& f, const char* function, const Expected& expected, lr_status status, lr_asset* const& asset) {
    if (!expected.allows(status)) defect(function, "status", status);
    if ((asset != nullptr) != (status == LR_OK)) defect(function, "asset and status do not agree", status);
    if (!asset) return;
    if (f.assets.size() < 10)
        f.assets.push_back(asset);
    else
        LR_CALL(lr_asset_release)(asset);
}

void ellipsoid(Fuzzer& f) {
    if (f.assets_left == 0) return;
    --f.assets_left;
    Input& in = f.in;
    Expected e;
    lr_ellipsoid_desc d = initialised(LR_CALL(lr_ellipsoid_desc_init));
    for (double& a : d.semi_axes) a = 0.05;
    d.density = 300.0;
    in.change(d.semi_axes, d.density, d.fluid_density, d.fluid_viscosity, d.intensity, d.center_of_mass, d.reserved);
    e.range(d.semi_axes, 1e-6, 1e3);
    e.range(d.intensity, 0.0, 10.0);
    double depth = 0.0, most = 0.0, least = 1e300;
    for (size_t i = 0; i < 3; ++i) {
        e.finite(d.center_of_mass[i]);
        const double part = d.center_of_mass[i] / d.semi_axes[i];
        depth += part * part;
        most = std::max(most, d.semi_axes[i]), least = std::min(least, d.semi_axes[i]);
    }
    for (double v : {d.density, d.fluid_density, d.fluid_viscosity}) {
        e.range(v, 0.0, 1e300);
        e.add_if(v == 0.0, LR_ERROR_INVALID_ARGUMENT);
        e.may_if(v < 1e-2 || v > 1e3, LR_ERROR_INVALID_ARGUMENT); // densities and viscosities of no real material
    }
    e.may_if(!(d.density >= 1e-3 && d.fluid_density >= 1e-3 && d.fluid_viscosity <= 1e3), LR_ERROR_INVALID_ARGUMENT);
    e.may_if(!(most <= 1e4 * least), LR_ERROR_INVALID_ARGUMENT);
    e.may_if(depth > 0.99, LR_ERROR_INVALID_ARGUMENT);
    e.add_if(depth > 1.01, LR_ERROR_INVALID_ARGUMENT);
    e.add_if(d.reserved != 0, LR_ERROR_INVALID_ARGUMENT);
    Given<lr_ellipsoid_desc> given(in, d, 1, e);
    lr_asset* asset = nullptr;
    e.add_if(in.null(2), LR_ERROR_NULL_ARGUMENT);
    made(f, "lr_asset_create_ellipsoid", e,
         LR_CALL(lr_asset_create_ellipsoid)(given.get(), in.null(2) ? nullptr : &asset), asset);
}

void rigid(Fuzzer& f) {
    if (f.assets_left == 0) return;
    --f.assets_left;
    Input& in = f.in;
    Expected e;
    lr_rigid_desc d = initialised(LR_CALL(lr_rigid_desc_init));
    d.mass = 0.01, d.volume = 2e-5;
    d.inertia[0] = d.inertia[4] = d.inertia[8] = 1e-5;
    for (double& x : d.extents) x = 0.05;
    in.change(d.mass, d.volume, d.inertia, d.added_mass, d.center_of_buoyancy, d.fluid_density, d.fluid_viscosity,
              d.extents, d.intensity, d.reserved);
    lr_aerodynamics a = initialised(LR_CALL(lr_aerodynamics_init));
    a.drag[0] = 0.01, a.lift[1] = 0.001;
    if (in.variant() == 1) d.aerodynamics = &a;
    if (in.variant() == 2) a.axes[0] = std::numeric_limits<double>::quiet_NaN(), d.aerodynamics = &a;
    e.add_if(in.variant() == 2, LR_ERROR_NOT_FINITE);
    for (double v : {d.mass, d.volume, d.fluid_density, d.fluid_viscosity, d.extents[0], d.extents[1], d.extents[2]}) {
        e.range(v, 0.0, 1e300);
        e.add_if(v == 0.0, LR_ERROR_INVALID_ARGUMENT);
    }
    for (double v : d.inertia) e.finite(v);
    for (double v : d.added_mass) e.finite(v);
    for (double v : d.center_of_buoyancy) e.finite(v);
    e.range(d.intensity, 0.0, 10.0);
    e.add_if(d.reserved != 0, LR_ERROR_INVALID_ARGUMENT);
    e.may(LR_ERROR_INVALID_ARGUMENT); // matrices of no real body
    Given<lr_rigid_desc> given(in, d, 1, e);
    lr_asset* asset = nullptr;
    e.add_if(in.null(2), LR_ERROR_NULL_ARGUMENT);
    made(f, "lr_asset_create_rigid", e, LR_CALL(lr_asset_create_rigid)(given.get(), in.null(2) ? nullptr : &asset),
         asset);
}

// The leaf's file, or a part of it; in another format, if the record says so.
std::vector<unsigned char> damaged(const Input& in, Expected& e) {
    std::vector<unsigned char> bytes = asset_bytes();
    const size_t at = (in.value(0) * 256u + in.value(1)) % bytes.size();
    switch (in.variant()) {
    case 0:
        return bytes;
    case 1:
        bytes.resize(at);
        break;
    case 2:
        bytes[at] = static_cast<unsigned char>(bytes[at] ^ (in.value(2) | 1u));
        break;
    default: // another kind of file: the record, repeated
        for (size_t i = 0; i < bytes.size(); ++i) bytes[i] = in.value(i % 6);
    }
    for (lr_status s : {LR_ERROR_ASSET_FORMAT, LR_ERROR_ASSET_VERSION, LR_ERROR_ASSET_CORRUPT, LR_ERROR_ASSET_INVALID})
        e.add(s);
    return bytes;
}

void load_memory(Fuzzer& f) {
    Expected e;
    const std::vector<unsigned char> bytes = damaged(f.in, e);
    lr_asset* asset = nullptr;
    e.add_if(f.in.null(1) || f.in.null(2), LR_ERROR_NULL_ARGUMENT);
    const std::unique_ptr<unsigned char[]> exact(new unsigned char[bytes.size() + 1]);
    std::copy(bytes.begin(), bytes.end(), exact.get() + 1);
    made(f, "lr_asset_load_memory", e,
         LR_CALL(lr_asset_load_memory)(f.in.null(1) ? nullptr : exact.get() + 1, bytes.size(),
                                       f.in.null(2) ? nullptr : &asset),
         asset);
}

void check_memory(Fuzzer& f) {
    Expected e;
    const std::vector<unsigned char> bytes = damaged(f.in, e);
    uint32_t faults = 0;
    e.add_if(f.in.null(1), LR_ERROR_NULL_ARGUMENT);
    const auto count = [](void* user, uint32_t number, const char* where, const char* what, const char* remedy) {
        if (number < 100 || number > 999 || !where || !what || !remedy) defect("lr_fault_fn", "an empty fault", number);
        ++*static_cast<uint32_t*>(user);
    };
    const lr_status status = LR_CALL(lr_asset_check_memory)(f.in.null(1) ? nullptr : bytes.data(), bytes.size(),
                                                            f.in.null(2) ? nullptr : +count, &faults);
    if (!e.allows(status)) defect("lr_asset_check_memory", "status", status);
    if (!f.in.null(1) && !f.in.null(2) && (faults != 0) != (status != LR_OK))
        defect("lr_asset_check_memory", "faults", faults);
}

void load_file(Fuzzer& f) {
    // A path that exists nowhere.
    static const std::string good = [] {
        const int file = memfd_create("leaf.lrb", 0);
        if (file < 0 || write(file, asset_bytes().data(), asset_bytes().size()) < 0) std::abort();
        return "/proc/self/fd/" + std::to_string(file);
    }();
    const char* const paths[] = {good.c_str(), "/dev/null", "/no/such/file", "", "/", "\xff\xfe"};
    const lr_status statuses[] = {LR_OK,
                                  LR_ERROR_FILE_READ, // a device
                                  LR_ERROR_FILE_NOT_FOUND,
                                  LR_ERROR_FILE_NOT_FOUND,
                                  LR_ERROR_FILE_READ,
                                  LR_ERROR_FILE_NOT_FOUND};
    const size_t which = f.in.value(0) % 6;
    Expected e;
    e.add_if(statuses[which] != LR_OK, statuses[which]);
    e.add_if(f.in.null(1) || f.in.null(2), LR_ERROR_NULL_ARGUMENT);
    lr_asset* asset = nullptr;
    made(f, "lr_asset_load_file", e,
         LR_CALL(lr_asset_load_file)(f.in.null(1) ? nullptr : paths[which], f.in.null(2) ? nullptr : &asset), asset);
}

void references(Fuzzer& f) {
    lr_asset* const asset = f.in.null(1) ? nullptr : f.pick_asset();
    const lr_status status = LR_CALL(lr_asset_retain)(asset);
    if (status != (asset ? LR_OK : LR_ERROR_NULL_ARGUMENT)) defect("lr_asset_retain", "status", status);
    LR_CALL(lr_asset_release)(asset);
    // Batches hold their own references.
    if (f.in.variant() == 3 && f.assets.size() > common_assets().size()) {
        const auto at = f.assets.begin() + f.in.selector() / 8u % static_cast<uint32_t>(f.assets.size());
        LR_CALL(lr_asset_release)(*at);
        f.assets.erase(at);
    }
}

void asset_info(Fuzzer& f) {
    Expected e;
    Given<lr_asset_info> info(f.in, initialised(LR_CALL(lr_asset_info_init)), 1, e);
    e.add_if(f.in.null(2), LR_ERROR_NULL_ARGUMENT);
    lr_status status = LR_CALL(lr_asset_get_info)(f.in.null(2) ? nullptr : f.pick_asset(), info.get());
    if (!e.allows(status)) defect("lr_asset_get_info", "status", status);
    if (status == LR_OK && (!(info.read().mass > 0.0) || !(info.read().length_d > 0.0) || info.read().name[63] != 0))
        defect("lr_asset_get_info", "numbers");
    Expected other;
    Given<lr_aerodynamics> a(f.in, initialised(LR_CALL(lr_aerodynamics_init)), 1, other);
    other.add_if(f.in.null(2), LR_ERROR_NULL_ARGUMENT);
    status = LR_CALL(lr_asset_get_aerodynamics)(f.in.null(2) ? nullptr : f.pick_asset(), a.get());
    if (!other.allows(status)) defect("lr_asset_get_aerodynamics", "status", status);
}

} // namespace

std::vector<Named> asset_operations() {
    return {{"ellipsoid", ellipsoid},       {"rigid", rigid},         {"load_memory", load_memory},
            {"check_memory", check_memory}, {"load_file", load_file}, {"references", references},
            {"asset_info", asset_info}};
}

} // namespace fuzz
