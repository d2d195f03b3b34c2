// Finds faces of a mesh that cross, touch or cover each other.
#pragma once

#include "baker/mesh/mesh.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace lr::baker {

struct SelfIntersections {
    std::vector<std::pair<uint32_t, uint32_t>> pairs; // of faces, the lower number first, sorted
    bool complete = true;                             // false: the search ended early, there can be more
};

// Faces that share a corner (the same position, with any vertex number) must meet only there, faces that share an edge only along it, and other faces
// not at all. Exact. Stops after `most` pairs, or if faces are too dense to search. Faces must have an area.
SelfIntersections find_self_intersections(const Mesh& mesh, std::size_t most);
} // namespace lr::baker
