// Wavefront OBJ, positions and faces only, in double precision and with line numbers in every fault.
#pragma once

#include "baker/mesh/mesh.h"

#include <string_view>

namespace lr::baker {

// A run of polygons that belong together by name.
struct SoupPart {
    std::size_t first_polygon = 0;        // to the next part's
    std::size_t object = 0;               // parts of one object have the same
    std::vector<std::string> own_names;   // of the object and its mesh, some perhaps empty
    std::vector<std::string> group_names; // of all that it belongs to
};

// Polygons as they stand in a file, before triangulation.
struct PolygonSoup {
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::vector<uint32_t>> polygons;
    std::vector<SoupPart> parts;    // each with at least one polygon
    double declared_unit = 0.0;     // metres, by the file's own word; 0 without
    std::size_t ignored_points = 0; // points and lines, which have no surface
};

bool parse_obj(std::string_view text, PolygonSoup& out, Faults& faults);

// Ear clipping in the plane of each polygon's Newell normal. False if an index is out of range.
bool triangulate(const PolygonSoup& soup, Mesh& out, Faults& faults);

} // namespace lr::baker
