// Object File Format (Geomview, CGAL): double precision, line numbers in faults.
#pragma once

#include "baker/mesh/obj_reader.h"

namespace lr::baker {

// OFF with the prefixes ST, C, N (texture coordinates, colours, normals) as text. Blank lines, comments and colours of faces may
// stand anywhere that Geomview allows.
bool parse_off(std::string_view text, PolygonSoup& out, Faults& faults);
} // namespace lr::baker
