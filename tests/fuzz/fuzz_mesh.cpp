// Any bytes as an OBJ, STL or PLY, or as arrays in memory: either numbered faults, or a solid of positive volume, or a sheet
// with faces.
#include "baker/mass_properties.h"
#include "baker/mesh.h"
#include "baker/mesh_check.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace {

using namespace lr;
using namespace lr::baker;

// A third of the bytes are coordinates: small ones, so that some coincide, or any double; the rest are indices.
bool read_arrays(const uint8_t* data, size_t size, bool any_double, Mesh& mesh, Faults& faults) {
    const size_t share = size / 3;
    std::vector<double> positions(any_double ? share / sizeof(double) : share);
    if (any_double && !positions.empty()) std::memcpy(positions.data(), data, positions.size() * sizeof(double));
    for (size_t i = 0; i < positions.size() && !any_double; ++i) positions[i] = static_cast<int8_t>(data[i]);
    const std::vector<uint32_t> indices(data + share, data + size);
    return read_mesh_arrays(positions, indices, {}, mesh, faults);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    if (size < 1) return 0;
    static constexpr const char* extensions[3] = {"obj", "stl", "ply"};
    const unsigned kind = data[0] % 4;
    const bool sheet = (data[0] & 4) != 0;
    Mesh mesh;
    Faults faults;
    const bool ok = (kind < 3 ? read_mesh_memory(data + 1, size - 1, extensions[kind], 1.0, mesh, faults)
                              : read_arrays(data + 1, size - 1, (data[0] & 8) != 0, mesh, faults)) &&
                    (sheet ? check_sheet(mesh, faults) : check_and_repair(mesh, faults));
    if (ok == has_error(faults)) std::abort();
    if (ok && !sheet && !(compute_mass_properties(mesh).volume > 0.0)) std::abort();
    if (ok && sheet && mesh.faces.empty()) std::abort();
    for (const Face& f : mesh.faces)
        for (const uint32_t v : f)
            if (ok && v >= mesh.vertices.size()) std::abort();
    return 0;
}
