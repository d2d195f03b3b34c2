// Bakes a mesh that a test has made.
#pragma once

#include "baker/bake.h"

#include <doctest/doctest.h>

#include <vector>

namespace lr::test {

// With a coarse turbulence table.
inline bool bake_mesh(const baker::Mesh& mesh, AssetData& out, baker::BakeOptions options = {}, Faults* told = nullptr,
                      uint32_t stations = 1) {
    std::vector<double> positions;
    std::vector<uint32_t> indices;
    for (const Eigen::Vector3d& v : mesh.vertices) positions.insert(positions.end(), v.data(), v.data() + 3);
    for (const baker::Face& f : mesh.faces) indices.insert(indices.end(), f.begin(), f.end());
    options.mesh_path = "mesh";
    options.mesh_arrays = baker::MeshArrays{positions, indices};
    options.cells = {8, 8, 8};
    options.stations = stations;
    Faults faults;
    const bool good = baker::bake(options, out, faults);
    for (const Fault& f : faults) INFO(f.what);
    if (told) *told = faults;
    return good;
}
} // namespace lr::test
