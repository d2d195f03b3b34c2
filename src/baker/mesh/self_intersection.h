// Faces of a mesh that cross, touch or cover each other.
#pragma once

#include "baker/mesh/mesh.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace lr::baker {

struct SelfIntersections {
    std::vector<std::pair<uint32_t, uint32_t>> pairs; // of faces, the lower number first, sorted
    bool complete = true;                             // false when the search was given up: there may be more
};

// Neighbours may meet in what they have in common, and nothing else: faces that share a corner (at exactly one position, whatever its
// number) only there, faces that share an edge only along it. Others must not even touch. Stops after `most` pairs, and where
// faces lie so thick that there would be no end.
// Faces must have an area. Exact.
SelfIntersections find_self_intersections(const Mesh& mesh, std::size_t most);

} // namespace lr::baker
