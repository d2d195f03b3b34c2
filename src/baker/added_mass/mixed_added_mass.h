// Added mass of bodies of solids and sheets, which may cross, touch or lie in each other.
#pragma once

#include "baker/added_mass/added_mass.h"
#include "baker/mesh/body_parts.h"

namespace lr::baker {

// The faces of solids that lie inside other solids, and sheets within solids, are no part of the surface: `parts` without them.
BodyParts outer_skin(const BodyParts& parts);

// Solves for all faces as sheets, with fluid enclosed in the solids, and subtracts the inertia of that fluid (trapped_fluid_inertia). Parts
// that cross without common vertices leave gaps; a rigid motion drives little flow through them, as the pressure inside is nearly that outside.
// Larger meshes are made coarser by cluster(), to the size where the equations can be solved; the error tells. Fluid density 1.
bool compute_mixed_added_mass(const BodyParts& parts, const Eigen::Vector3d& centre, AddedMass& out, Faults& faults,
                              const Progress& progress = {}, const AddedMassOptions& options = {});

// For a solution of coarse elements, about the origin, whose energy is too small. No body in a convex hull moves more fluid than the hull and all that it
// holds (Thomson's theorem): takes the middle between both, if that states a smaller error.
void bound_by_hull(const Mesh& mesh, bool is_sheet, AddedMass& out, const AddedMassOptions& options);
} // namespace lr::baker
