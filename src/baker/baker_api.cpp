// The public C++ API: converts types and catches all exceptions.
#include "langevin_rigid_baker.hpp"

#include "asset/asset_file.h"
#include "baker/asset_report.h"
#include "baker/bake.h"
#include "baker/bake_progress.h"
#include "baker/fault_text.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <new>
#include <thread>
#include <utility>

namespace langevin_rigid {
namespace {

namespace core = lr::baker;

// Thrown to cancel a bake; caught in this file.
struct Cancelled {};

class ProgressCall {
public:
    explicit ProgressCall(const BakeProgress& progress) : progress_(progress) {}

    // Solvers also report from their own threads, where the caller's function must not run and an exception cannot be thrown.
    void operator()(const char* phase, double fraction) {
        if (!progress_ || std::this_thread::get_id() != thread_) return;
        share_ = std::max(share_, core::overall_progress(phase, fraction));
        bool go_on = false;
        try {
            go_on = progress_(phase, share_);
        } catch (...) { // an exception of the caller cancels the bake
        }
        if (!go_on) throw Cancelled{};
    }

private:
    const BakeProgress& progress_;
    std::thread::id thread_ = std::this_thread::get_id();
    double share_ = 0.0;
};

core::Unit to_core(Unit unit) {
    switch (unit) {
    case Unit::metre:
        return core::Unit::m;
    case Unit::centimetre:
        return core::Unit::cm;
    case Unit::millimetre:
        return core::Unit::mm;
    case Unit::file:
        break;
    }
    return core::Unit::file;
}

core::UpAxis to_core(UpAxis up) {
    const auto axis = static_cast<std::int32_t>(up);
    return axis >= 0 && axis < 6 ? static_cast<core::UpAxis>(axis) : core::UpAxis::z;
}

core::BakeOptions to_core(const BakeOptions& o) {
    core::BakeOptions options;
    options.unit = to_core(o.unit);
    options.up = to_core(o.up);
    if (!o.mesh.empty()) options.mesh = o.mesh;
    options.density = o.density;
    options.fluid_density = o.fluid_density;
    options.fluid_viscosity = o.fluid_viscosity;
    options.cells = o.grid;
    options.intensity = o.intensity;
    options.center_of_mass = o.center_of_mass;
    if (!o.name.empty()) options.name = o.name;
    if (o.sheet) options.sheet = core::SheetOptions{o.sheet->thickness, o.sheet->areal_density};
    options.wake = o.wake;
    options.stations = o.stations;
    options.strict = o.strict;
    options.fill = o.fill;
    if (o.thickness != 0.0) options.thickness = o.thickness;
    options.size = o.size;
    if (o.mass) {
        core::MassOptions& mass = options.mass.emplace();
        mass.path = o.mass->path;
        if (o.mass->path.empty()) mass.arrays = core::MeshArrays{o.mass->positions, o.mass->indices};
    }
    if (o.card) {
        core::CardOptions& card = options.card.emplace();
        card.width = o.card->width;
        card.alpha = o.card->alpha;
        card.triangles = o.card->triangles;
        card.channel = o.card->luminance ? core::MaskChannel::luminance : core::MaskChannel::alpha;
        if (o.card->piece > 0) card.piece = o.card->piece;
        card.all_pieces = o.card->all_pieces;
        card.speck = o.card->speck;
    }
    return options;
}

BakeFault to_public(const lr::Fault& f) {
    return {static_cast<std::uint32_t>(f.id), f.severity == lr::Severity::error, f.where, f.what, f.remedy};
}

BakeFault error(lr::FaultId id, const char* where, const char* what, const char* remedy) {
    return {static_cast<std::uint32_t>(id), true, where, what, remedy};
}

template <class Work> BakeResult guarded(const Work& work) noexcept {
    BakeResult result;
    try {
        try {
            work(result);
            return result;
        } catch (const Cancelled&) {
            result.status = BakeStatus::cancelled;
            return result;
        } catch (const std::bad_alloc&) {
            result = {};
            result.faults.push_back(error(lr::FaultId::mesh_too_many_faces, "memory",
                                          "The bake does not fit into memory.",
                                          "Decimate the mesh, or use a coarser grid."));
        } catch (const std::exception& problem) {
            result = {};
            result.faults.push_back(error(lr::FaultId::mesh_unreadable, "baker", problem.what(),
                                          "Export the mesh again, as OBJ, STL, PLY or glTF."));
        }
    } catch (...) { // no memory for the fault
        result = {};
    }
    return result;
}

bool possible_mass(const core::BakeOptions& options, bool may_open, BakeResult& result) {
    if (!options.mass) return true;
    if (!may_open && !options.mass->arrays) {
        result.faults.push_back(error(lr::FaultId::parameter_out_of_range, "mass", "Only bake_file opens files.",
                                      "Give the mass mesh as positions and indices."));
        return false;
    }
    if (!options.mass->arrays ||
        (options.mass->arrays->positions.size() % 3 == 0 && options.mass->arrays->indices.size() % 3 == 0))
        return true;
    result.faults.push_back(error(lr::FaultId::mesh_bad_index, "mass",
                                  "The length of an array is not a multiple of three.",
                                  "Give three coordinates per vertex and three indices per triangle."));
    return false;
}

void run(const core::BakeOptions& options, bool may_open, const BakeProgress& progress, BakeResult& result) {
    if (!possible_mass(options, may_open, result)) return;
    lr::AssetData asset;
    lr::Faults faults;
    core::BakeTimings timings;
    core::StationErrors errors;
    core::BakeHooks hooks;
    hooks.station_errors = &errors;
    ProgressCall call(progress);
    const bool good = core::bake(
        options, asset, faults, &timings, [&](const char* phase, double part) { call(phase, part); }, hooks);
    for (const lr::Fault& f : faults) result.faults.push_back(to_public(f));
    if (!good) return;
    result.asset = lr::write_asset(asset);
    result.report = core::report_json(asset, faults, timings, errors);
    result.status = BakeStatus::done;
}

template <class Number>
BakeResult bake_arrays(const Number* positions, std::size_t vertices, const std::uint32_t* indices,
                       std::size_t triangles, const BakeOptions& o, const BakeProgress& progress) noexcept {
    return guarded([&](BakeResult& result) {
        if ((!positions && vertices > 0) || (!indices && triangles > 0) || vertices >= UINT32_MAX ||
            triangles > SIZE_MAX / 3) {
            result.faults.push_back(error(lr::FaultId::mesh_bad_index, "arrays",
                                          "An array is null or its count is too large.", "Check pointers and counts."));
            return;
        }
        const std::vector<double> copy(positions, positions + 3 * vertices);
        core::BakeOptions options = to_core(o);
        options.mesh_path = "mesh";
        options.card.reset();
        options.mesh_arrays = core::MeshArrays{copy, {indices, 3 * triangles}};
        run(options, false, progress, result);
    });
}
} // namespace

std::string to_string(const BakeFault& f) {
    return lr::to_string({static_cast<lr::FaultId>(f.number), f.is_error ? lr::Severity::error : lr::Severity::warning,
                          f.where, f.what, f.remedy});
}

BakeResult bake_file(const std::string& path, const BakeOptions& o, const BakeProgress& progress) noexcept {
    return guarded([&](BakeResult& result) {
        core::BakeOptions options = to_core(o);
        options.mesh_path = path;
        run(options, true, progress, result);
    });
}

BakeResult bake_memory(const void* bytes, std::size_t size, const std::string& file_name, const BakeOptions& o,
                       const BakeProgress& progress) noexcept {
    return guarded([&](BakeResult& result) {
        core::BakeOptions options = to_core(o);
        options.mesh_path = file_name;
        options.mesh_bytes = {static_cast<const std::uint8_t*>(bytes), bytes ? size : 0};
        run(options, false, progress, result);
    });
}

BakeResult bake_triangles(const float* positions, std::size_t vertices, const std::uint32_t* indices,
                          std::size_t triangles, const BakeOptions& o, const BakeProgress& progress) noexcept {
    return bake_arrays(positions, vertices, indices, triangles, o, progress);
}

BakeResult bake_triangles(const double* positions, std::size_t vertices, const std::uint32_t* indices,
                          std::size_t triangles, const BakeOptions& o, const BakeProgress& progress) noexcept {
    return bake_arrays(positions, vertices, indices, triangles, o, progress);
}

BakeResult bake_ellipsoid(const std::array<double, 3>& semi_axes, const BakeOptions& o,
                          const BakeProgress& progress) noexcept {
    return guarded([&](BakeResult& result) {
        core::BakeOptions options = to_core(o);
        options.up = core::UpAxis::z;
        options.mesh.reset();
        options.sheet.reset();
        options.card.reset();
        options.mass.reset();
        options.semi_axes = semi_axes;
        run(options, false, progress, result);
    });
}

const char* baker_version() noexcept {
    return core::baker_version();
}
} // namespace langevin_rigid
