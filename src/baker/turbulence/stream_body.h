// Places a body in the stream of its turbulence table: attitude, domain, closed faces.
#pragma once

#include "baker/mesh/mesh.h"
#include "baker/turbulence/turbulence.h"

namespace lr::baker {

// Broadside, the mean attitude of a fluttering body: the principal axis with the largest projected area (the first of equal ones) is along the
// stream, +x, the longer of the other two along y. The centre of the body's box is at body_position(), moved along the stream by less than half a
// cell onto a layer of faces, so that a flat plate is one layer of closed faces on any grid.
//
// Sets domain_lengths, closed_faces and body_box for the given cells and length_d. The cross section is four times the body's extents along each axis
// (a whole multiple of that across a body narrower than a sixteenth of its length), so that the body's box covers the same share of the cells on any
// grid: a sixteenth of the section; a disc 5 %. Narrower bodies get the width of two cells. Along the stream there are 1.5 w ahead and d + 1.5 w
// behind, with w the square root of the product of the extents across.
//
// axes: principal axes in columns; projected_areas: along them. False, with a fault, if a position is not finite or the body
// closes no face of the grid.
bool put_in_stream(const Mesh& mesh, const Eigen::Matrix3d& axes, const Eigen::Vector3d& projected_areas,
                   TurbulenceOptions& options, Faults& faults);
} // namespace lr::baker
