// 3MF, which slicers and CAD programs write: assimp 5.2 ends the process on objects made of components, and drops the unit.
#pragma once

#include "baker/mesh/obj_reader.h"

#include <cstddef>
#include <string>

namespace lr::baker {

// bytes: the archive. Reads the objects on the build plate with their transforms; without a plate, all objects. where: for faults.
bool read_3mf(const void* bytes, std::size_t size, const std::string& where, PolygonSoup& out, Faults& faults);
} // namespace lr::baker
