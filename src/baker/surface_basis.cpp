#include "baker/surface_basis.h"

namespace lr::baker {

SurfaceBasis closed_basis(const Mesh& mesh) {
    SurfaceBasis basis;
    basis.unknowns = mesh.vertices.size();
    basis.corners.resize(mesh.faces.size());
    for (std::size_t t = 0; t < mesh.faces.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) basis.corners[t][k].plus = static_cast<int32_t>(mesh.faces[t][k]);
    return basis;
}

} // namespace lr::baker
