// Added mass of bodies of solids and sheets, which may cross, touch or lie in each other.
#pragma once

#include "baker/added_mass/added_mass.h"
#include "baker/mesh/body_parts.h"

namespace lr::baker {

// Removes the faces of solids inside other solids, and sheets inside solids.
BodyParts outer_skin(const BodyParts& parts);

// The faces that sheets have within solids, of sheets that have others `outside`.
std::vector<Face> covered_sheets(const BodyParts& parts, std::vector<Face> outside);

// Solves for all faces as sheets, which includes fluid enclosed in solids, and subtracts its inertia (trapped_fluid_inertia). Parts that cross
// without common vertices leave gaps; a rigid motion drives little flow through them, since the pressures inside and outside are nearly equal.
// cluster() coarsens larger meshes until the equations can be solved, at the cost of a larger error. The result is no less than that of the sheets
// alone with their covered faces: panels that cross can let much fluid through, a quarter of that at a feather's vane. Fluid density 1.
bool compute_mixed_added_mass(const BodyParts& parts, const Eigen::Vector3d& centre, AddedMass& out, Faults& faults,
                              const Progress& progress = {}, const AddedMassOptions& options = {});

// For a solution with coarse elements, about the origin, whose energy is too small. No body inside a convex hull moves more fluid than the hull with
// all that it contains (Thomson's theorem): takes the middle of both, if its error is smaller.
void bound_by_hull(const Mesh& mesh, bool is_sheet, AddedMass& out, const AddedMassOptions& options);
} // namespace lr::baker
