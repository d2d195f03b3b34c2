// Any bytes as an OBJ, STL or PLY: either numbered faults, or a mesh that has a positive volume.
#include "baker/mass_properties.h"
#include "baker/mesh.h"
#include "baker/mesh_check.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    if (size < 1) return 0;
    static constexpr const char* extensions[3] = {"obj", "stl", "ply"};
    lr::baker::Mesh mesh;
    lr::Faults faults;
    const bool ok = lr::baker::read_mesh_memory(data + 1, size - 1, extensions[data[0] % 3], 1.0, mesh, faults) &&
                    lr::baker::check_and_repair(mesh, faults);
    if (ok == lr::has_error(faults)) std::abort();
    if (ok && !(lr::baker::compute_mass_properties(mesh).volume > 0.0)) std::abort();
    return 0;
}
