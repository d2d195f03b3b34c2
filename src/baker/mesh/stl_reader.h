// STL as text, in double precision. assimp ends names at the first blank, and wants a normal in each facet.
#pragma once

#include "baker/mesh/obj_reader.h"

namespace lr::baker {

// Whether this is STL as text. Binary files can begin with "solid" too.
bool is_text_stl(std::string_view bytes);

// Keywords in any case. The name of a solid is the rest of its line.
bool parse_stl(std::string_view text, PolygonSoup& out, Faults& faults);
} // namespace lr::baker
