// What colliders are made of, each in its own frame. Static once built; poses are elsewhere.
#pragma once

#include "contact/pose.h"

#include <cstdint>

namespace lr {

enum class ColliderKind : int32_t { plane = 1, sphere, capsule, box, hull, heightfield, mesh };

struct HullGeometry {
    uint32_t vertex_count, face_count;
    const float* vertices; // m, 3 a vertex
    const float* faces;    // 4 a face: outward unit normal n and d; inside n . x <= d. Coplanar faces once
};

// Solid below its surface, along -y. Sample (i, k) is at (i spacing[0], height, k spacing[1]); each cell is two triangles,
// that with the corners (i, k) (i, k + 1) (i + 1, k + 1) and that with (i, k) (i + 1, k + 1) (i + 1, k).
struct HeightfieldGeometry {
    uint32_t counts[2];   // samples along x and z, each >= 2
    float spacing[2];     // m
    const float* heights; // m, x varies fastest
    float lowest, highest;
    float secant; // of the angle of its steepest triangle, or a little more
    // The greatest height within each square of coarse_cells x coarse_cells cells and in the squares around it.
    static constexpr uint32_t coarse_cells = 4;
    uint32_t coarse_counts[2];
    const float* coarse;
};

// Triangles without an inside: bodies meet them from both sides.
struct MeshGeometry {
    uint32_t vertex_count, triangle_count;
    const float* vertices;   // m
    const uint32_t* indices; // 3 a triangle
    const float* normals;    // unit, 3 a triangle, counter-clockwise front
    // A bit for each edge (vertex k to k + 1), on which the surface is no ridge seen from the front (bits 0 to 2) or
    // from the back (3 to 5): flat or hollow, so that nothing can touch the edge alone.
    const uint8_t* hidden_edges;
};

struct Geometry {
    ColliderKind kind;
    // sphere: radius; capsule: radius, half length of its axis along y; box: half extents. A plane is y = 0, solid below.
    float size[3];
    const HullGeometry* hull;
    const HeightfieldGeometry* heightfield;
    const MeshGeometry* mesh;
};

} // namespace lr
