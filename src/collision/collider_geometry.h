// Geometry of colliders, each in its own frame. Immutable once built; poses are elsewhere.
#pragma once

#include "base/pose.h"
#include "kernel/contact/collider_contact.h"

#include <cstddef>
#include <cstdint>

namespace lr {

enum class ColliderKind : int32_t { plane = 1, sphere, capsule, box, hull, heightfield, mesh };
constexpr bool has_data(ColliderKind kind) {
    return kind >= ColliderKind::hull;
}
constexpr bool has_flat_sides(ColliderKind kind) {
    return kind == ColliderKind::box || kind == ColliderKind::hull;
}
// A ground is solid below: a plane, or a heightfield within its outline.
constexpr bool is_ground(ColliderKind kind) {
    return kind == ColliderKind::plane || kind == ColliderKind::heightfield;
}

struct HullGeometry {
    uint32_t vertex_count, face_count;
    const float* vertices; // m, 3 a vertex
    const float* faces;    // 4 per face: outward unit normal n and d; inside n . x <= d. Coplanar faces are merged
    // Vertices of face f, counter-clockwise seen from outside: corners[corners[f]] up to corners[corners[f + 1]].
    const uint32_t* corners = nullptr;

    Vector corner(uint32_t i) const { return vector_of(vertices + size_t{3} * i); }
    Vector normal(uint32_t face) const { return vector_of(faces + size_t{4} * face); }
    float offset(uint32_t face) const { return faces[size_t{4} * face + 3]; }
    uint32_t corner_count(uint32_t face) const { return corners[face + 1] - corners[face]; }
    Vector corner(uint32_t face, uint32_t i) const { return corner(corners[corners[face] + i]); }
};

// Solid below its surface, along -y. Sample (i, k) is at (i spacing[0], height, k spacing[1]). The two triangles of a cell are
// (i, k) (i, k + 1) (i + 1, k + 1) and (i, k) (i + 1, k + 1) (i + 1, k).
struct HeightfieldGeometry {
    uint32_t counts[2];   // samples along x and z, each >= 2
    float spacing[2];     // m
    const float* heights; // m, x varies fastest
    float lowest, highest;
    float secant; // of the steepest triangle's angle, rounded up
    // Greatest height within each square of coarse_cells x coarse_cells cells and the squares around it.
    static constexpr uint32_t coarse_cells = 4;
    uint32_t coarse_counts[2];
    const float* coarse;

    float extent(uint32_t axis) const { return spacing[axis] * static_cast<float>(counts[axis] - 1); }
    HeightGrid grid() const {
        return {heights, {counts[0], counts[1]}, {1.0f / spacing[0], 1.0f / spacing[1]}, secant};
    }
    bool covers(float x, float z) const { return x >= 0.0f && z >= 0.0f && x <= extent(0) && z <= extent(1); }
};

// Triangles without an inside: both sides collide.
struct MeshGeometry {
    uint32_t vertex_count, triangle_count;
    const float* vertices;   // m
    const uint32_t* indices; // 3 a triangle
    const float* normals;    // unit, 3 a triangle, counter-clockwise front
    // Bits 0 to 2: edges (vertex k to k + 1) that are flat or hollow seen from the front, bits 3 to 5: from the back. Nothing can touch such an edge
    // alone, so it makes no contacts of its own. Also turned_triangle.
    const uint8_t* hidden_edges;
};
// The triangle is wound against the first one of its connected surface.
inline constexpr uint8_t turned_triangle = 64;

// Part of a mesh: triangles [first, first + count). Other kinds have none.
struct ColliderPart {
    uint32_t first, count;
};

struct MeshPart {
    Box box;
    ColliderPart part;
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
