// Wavefront OBJ, positions and faces only, in double precision and with line numbers in every fault.
#pragma once

#include "baker/mesh.h"

#include <string_view>

namespace lr::baker {

// Polygons as they stand in a file, before triangulation.
struct PolygonSoup {
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::vector<uint32_t>> polygons;
    std::size_t parts = 0;          // objects or meshes with at least one polygon
    std::size_t ignored_points = 0; // points and lines, which have no surface
};

bool parse_obj(std::string_view text, PolygonSoup& out, Faults& faults);

// Ear clipping in the plane of each polygon's Newell normal. False if an index is out of range.
bool triangulate(const PolygonSoup& soup, Mesh& out, Faults& faults);

} // namespace lr::baker
