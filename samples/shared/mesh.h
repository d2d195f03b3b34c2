// The drawn mesh of a body: triangles with normals and texture coordinates, in the body frame, coarser at a
// distance.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "langevin_rigid.h"

struct Vertex {
    float position[3]; // m, from the centre of mass, body axes
    float normal[3];
    float uv[2]; // u along the long axis, v across it, 0.5 in the middle; equal scale, as the asset meshes have it
};

struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    float radius() const; // m, about the centre of mass
};

// Reads an OBJ in metres, and moves its origin to the centre of mass. Throws Failure.
Mesh load_obj(const std::string& path, const lr_asset_info& info);

// The ellipse of the ellipsoid with the asset's inertia, for an asset without a mesh.
Mesh ellipse_card(const lr_asset_info& info);

// Merges the vertices in each cell of a grid and drops degenerate triangles. cell: m.
Mesh coarser(const Mesh& mesh, float cell);
