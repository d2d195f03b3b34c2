// Bowls: a stream separates early on their convex side and is caught in their hollow.
#pragma once

#include "asset/asset_data.h"
#include "baker/aerodynamics/surface_parts.h"

namespace lr::baker {

// Direction of the convex side. The length is the relative change of the normal force against as many plates: less for a stream onto the convex side,
// more for one into the hollow. Zero for flat surfaces and tubes.
Eigen::Vector3d hollow_of(const Part& part, double size);

// Adjusts the station of these faces of a body with this hollow: its share of the hollow, an early stall, and normal force only on open sides.
void shape_as_wall(const Part& part, const Eigen::Vector3d& hollow, StationData& out);
} // namespace lr::baker
