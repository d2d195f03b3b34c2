// Refines a mesh where its surface is curved.
#pragma once

#include "baker/mesh/mesh.h"

#include <cstddef>

namespace lr::baker {

// Repeatedly splits the edges of a closed mesh along which the normal turns by more than `turn` radians, with midpoints on the curve
// that has these normals at its ends. Creases stay creases and follow the surfaces on both sides. Stops before exceeding `panel_limit`.
// origin: the original face of each face, updated by the cuts.
Mesh refine_curved(const Mesh& mesh, double turn, std::size_t panel_limit, std::vector<uint32_t>* origin = nullptr);
} // namespace lr::baker
