// Bowls: on their convex side a stream parts early, in their hollow it is caught.
#pragma once

#include "asset/asset_data.h"
#include "baker/aerodynamics/surface_parts.h"

namespace lr::baker {

// Towards the convex side; as long as the share by which the normal force of a stream onto that side is less, and of one into the hollow more, than that
// of as many plates. Zero for flat surfaces and tubes.
Eigen::Vector3d hollow_of(const Part& part, double size);

// The station that stands for these faces of a body with this hollow: its share of it, an early stall, and the normal force of its open sides alone.
void shape_as_wall(const Part& part, const Eigen::Vector3d& hollow, StationData& out);
} // namespace lr::baker
