// The drawn mesh of a body, as in drawing/mesh.h, that frees itself.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

extern "C" {
#include "drawing/mesh.h"
}

using Vertex = mesh_vertex;

struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    float radius() const;   // m, about the centre of mass
    body_mesh view() const; // for functions that do not change it, as long as this exists
};

// Failures of drawing/ become exceptions (Failure).
void throw_failures();

// Reads an OBJ in metres, and moves its origin to the centre of mass; without a path the ellipsoid with the asset's inertia. Throws
// Failure.
Mesh load_mesh(const std::string& path, const lr_asset_info& info);
