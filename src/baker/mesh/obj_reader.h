// Wavefront OBJ: positions and faces, in double precision, with line numbers in every fault.
#pragma once

#include "baker/mesh/mesh.h"

#include <string_view>

namespace lr::baker {

// Consecutive polygons of one object and group.
struct SoupPart {
    std::size_t first_polygon = 0;        // to that of the next part
    std::size_t object = 0;               // number of its object
    std::vector<std::string> own_names;   // of the object and its mesh; can be empty
    std::vector<std::string> group_names; // of its groups and parent nodes
    std::string material;                 // can be empty
};

// The polygons of a file before triangulation.
struct PolygonSoup {
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::vector<uint32_t>> polygons;
    std::vector<SoupPart> parts;    // each with at least one polygon
    double declared_unit = 0.0;     // the unit that the file states, in metres; 0: none
    std::size_t ignored_points = 0; // points and lines, which have no surface
};

// Blanks are spaces, tabs and ends of lines.
bool is_blank(char c);

// Removes and returns the next word between blanks; empty at the end.
std::string_view next_word(std::string_view& rest);

// A number in any locale: also 0,5. One too small is 0, one too large infinite.
bool parse_coordinate(std::string_view word, double& value);

bool parse_obj(std::string_view text, PolygonSoup& out, Faults& faults);

// Ear clipping in the plane of each polygon's Newell normal. first_face: of each of the soup's parts. False if an index is out of range.
bool triangulate(const PolygonSoup& soup, Mesh& out, std::vector<std::size_t>& first_face, Faults& faults);
} // namespace lr::baker
