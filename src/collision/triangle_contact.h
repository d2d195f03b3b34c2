// Bodies against single triangles, of meshes and of heightfields.
#pragma once

#include "collision/contact_points.h"

namespace lr {

struct Triangle {
    Vector corners[3]; // m, collider frame
    Vector normal;     // unit
    uint8_t hidden;    // as in MeshGeometry
    bool one_sided, turned;
};

Triangle mesh_triangle(const MeshGeometry& mesh, uint32_t index);
bool reaches(const Box& box, const Triangle& t);
// Cosine between normals of triangles that count as one surface.
inline constexpr float facing = 0.5f;
// Whether a point, seen along the normal, lies inside the triangle, at least `reach` (m) from its edges.
bool is_over(const Triangle& t, Vector point, float reach = 0.0f);

struct HeightPoint {
    float height; // m
    Vector normal;
};
// The heightfield's triangle below or above a place within its outline.
HeightPoint height_at(const HeightfieldGeometry& field, float x, float z);

// Cells of a heightfield that a box overlaps, [first, last); none if it is outside.
struct Cells {
    uint32_t first[2], last[2];
};
Cells cells_between(const HeightfieldGeometry& field, const Box& box);
// One of the two triangles of a cell; `hidden` is not set.
Triangle field_triangle(const HeightfieldGeometry& field, uint32_t i, uint32_t k, bool second);

// alone: the mesh part is tested without its neighbours, so all edges collide here.
void add_mesh(ContactPoints& set, const MeshGeometry& mesh, ColliderPart part, bool alone = false);
// The normal, on its side, of the triangle that a centre of mass is over, if one is nearer than `least`, which becomes its distance; else 0.
Vector face_of_center(const MeshGeometry& mesh, ColliderPart part, Vector center, float& least);
// The triangle with one side only, its front or its back.
Triangle one_side(Triangle t, bool front);
// Adds contacts at the ridges of a one-sided triangle.
void add_ridges(ContactPoints& set, const Triangle& t);
void add_heightfield(ContactPoints& set, const HeightfieldGeometry& field);
} // namespace lr
