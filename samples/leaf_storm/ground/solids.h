// Meshes of objects on the ground, about the origin of their colliders.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "mesh.h"
#include "vectors.h"

Mesh box_mesh(const Vector& half_extents);
Mesh capsule_mesh(double radius, double half_length); // along y
// The convex hull of a few points.
Mesh hull_mesh(const std::vector<Vector>& points);
