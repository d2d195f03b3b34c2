// Stanford PLY, ASCII and binary, positions and faces only.
#pragma once

#include "baker/mesh/obj_reader.h"

namespace lr::baker {

bool parse_ply(std::string_view bytes, PolygonSoup& out, Faults& faults);
} // namespace lr::baker
