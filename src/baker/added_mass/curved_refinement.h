// Smaller panels where a surface is curved.
#pragma once

#include "baker/mesh/mesh.h"

#include <cstddef>

namespace lr::baker {

// Splits edges of a closed mesh along which the normal turns by more than `turn` radians, again and again, and puts their middles where a curve
// with these normals at its ends runs. Creases
// stay creases, and follow the surfaces on both of their sides. Stops before there are more than `max_panels`.
Mesh refine_curved(const Mesh& mesh, double turn, std::size_t max_panels);

} // namespace lr::baker
