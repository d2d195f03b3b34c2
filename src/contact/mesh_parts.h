// Triangles of a mesh in an order in which neighbours lie together, cut into parts for the broad phase.
#pragma once

#include "contact/geometry_store.h"

#include <cstdint>
#include <vector>

namespace lr {

inline constexpr uint32_t most_part_triangles = 8;

// Puts the triangles (3 indices each, in range) into a new order and says which of them make parts; large ones are alone.
// The same for the same mesh everywhere. May throw std::bad_alloc.
void make_mesh_parts(const float* vertices, uint32_t* indices, uint32_t triangle_count, std::vector<MeshPart>& parts);

} // namespace lr
