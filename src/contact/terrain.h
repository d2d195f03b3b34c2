// Bodies against single triangles: of meshes, and of heightfields, which are solid below.
#pragma once

#include "contact/contact_set.h"

namespace lr {

struct Triangle {
    Vector corners[3]; // m, collider frame
    Vector normal;     // unit
    uint8_t hidden;    // as in MeshGeometry
    bool one_sided;
};

Triangle mesh_triangle(const MeshGeometry& mesh, uint32_t index);
// Whether a box reaches into that around a triangle.
bool reaches(const Box& box, const Triangle& t);

struct HeightPoint {
    float height; // m
    Vector normal;
};
// The triangle of a heightfield below or above a place within its outline.
HeightPoint height_at(const HeightfieldGeometry& field, float x, float z);

// Cells of a heightfield that a box reaches into, [first, last); none where it is outside.
struct Cells {
    uint32_t first[2], last[2];
};
Cells cells_between(const HeightfieldGeometry& field, const Box& box);
// One of the two triangles of a cell; `hidden` is not set.
Triangle field_triangle(const HeightfieldGeometry& field, uint32_t i, uint32_t k, bool second);

// alone: without the parts around it, so that no edge is left to them.
void add_mesh(const PlacedBody& body, const MeshGeometry& mesh, ColliderPart part, float margin, ContactSet& set,
              bool alone = false);
void add_heightfield(const PlacedBody& body, const HeightfieldGeometry& field, float margin, ContactSet& set);

} // namespace lr
