// Any bytes as an OBJ, STL, PLY, Collada or arrays: numbered faults, or a solid of positive volume, or a sheet with consistent
// refinement and unknowns.
#include "baker/added_mass/added_mass.h"
#include "baker/added_mass/rim_refinement.h"
#include "baker/added_mass/surface_basis.h"
#include "baker/fault_text.h"
#include "baker/mesh/collada_check.h"
#include "baker/mesh/mass_properties.h"
#include "baker/mesh/mesh.h"
#include "baker/mesh/mesh_check.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

namespace {

using namespace lr;
using namespace lr::baker;

void require(bool good) {
    if (!good) std::abort();
}

// A third of the bytes are coordinates, of few values, so that some coincide; the rest are indices.
bool read_arrays(const uint8_t* data, size_t size, Mesh& mesh, Faults& faults) {
    const size_t share = size / 3;
    std::vector<double> positions(share);
    for (size_t i = 0; i < share; ++i) positions[i] = static_cast<int8_t>(data[i]);
    const std::vector<uint32_t> indices(data + share, data + size);
    return read_mesh_arrays(positions, indices, {}, mesh, faults);
}

void solid(Mesh mesh, const Faults& read) {
    Faults faults = read;
    const bool good = check_and_repair(mesh, faults);
    require(good != has_error(faults));
    require(!good || compute_mass_properties(mesh).volume > 0.0);
}

void sheet(Mesh mesh, const Faults& read) {
    constexpr std::size_t few = 60;
    Faults faults = read;
    const bool good = check_sheet(mesh, faults);
    require(good != has_error(faults));
    if (!good || mesh.faces.size() > few) return;
    const double area = compute_sheet_mass_properties(mesh, 1e-3).area;
    const Mesh fine = refine_sheet(mesh, {2 * few, 2});
    require(!(std::abs(compute_sheet_mass_properties(fine, 1e-3).area - area) > 1e-6 * area));
    const SurfaceBasis basis = sheet_basis(fine);
    require(basis.corners.size() == fine.faces.size());
    for (const auto& panel : basis.corners)
        for (const CornerUnknowns& c : panel)
            require(c.plus < static_cast<int32_t>(basis.unknowns) && c.minus < static_cast<int32_t>(basis.unknowns));
    AddedMass m;
    const bool solved = compute_sheet_added_mass(mesh, Eigen::Vector3d::Zero(), {0, 2}, m, faults);
    require(solved != has_error(faults));
    require(!solved || m.value.allFinite());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    if (size < 1) return 0;
    constexpr unsigned readers = 6;
    static constexpr const char* extensions[readers] = {"obj", "stl", "ply", "dae", nullptr, "off"};
    const char* extension = extensions[data[0] % readers];
    Faults faults;
    if (extension && extension == std::string_view("dae")) { // this does not test assimp itself
        const bool good = check_collada({reinterpret_cast<const char*>(data) + 1, size - 1}, faults);
        require(good != has_error(faults));
        return 0;
    }
    Mesh mesh;
    const bool read = extension ? read_mesh_memory(data + 1, size - 1, extension, 1.0, mesh, faults)
                                : read_arrays(data + 1, size - 1, mesh, faults);
    require(read != has_error(faults));
    if (!read) return 0;
    solid(mesh, faults);
    sheet(mesh, faults);
    return 0;
}
