// Estimates of the errors of an added mass.
#pragma once

#include "baker/added_mass/boundary_operators.h"
#include "baker/added_mass/surface_correction.h"

#include <vector>

namespace lr::baker {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Currents = Eigen::Matrix<double, 3, 6>; // grad phi x n on one panel, one column per mode

std::vector<Currents> surface_currents(const SurfaceBasis& basis, const std::vector<Panel>& panels,
                                       const RigidModes& phi);

// Error of linear elements, not negative.
Matrix6 discretisation_error(const Mesh& mesh, const SurfaceBasis& basis, const BoundaryOperators& op,
                             const std::vector<Currents>& currents);

// Errors of flat panels. Moving the surface out by d changes the energy of the fluid, including displaced fluid, by d times the square of the
// velocity relative to the body (Hadamard).
struct GeometryErrors {
    // Curvature that restore_curved_volume does not know: of second order in the turn of the normal over a panel.
    Matrix6 curved = Matrix6::Zero();
    // Doubt whether the faces are facets or sample a curved surface.
    Matrix6 reading = Matrix6::Zero();
};

// Bounds of the entries of an energy that is at most `most` in every motion, not only along the axes. Off the diagonal x^T E y is the difference of
// the energies of x + y and x - y, bounded on both sides whatever the units of x and y.
Matrix6 bound_of_energy(const Matrix6& most);

// Difference between the faces as facets and as samples of a curved surface, for each panel.
struct Doubts {
    std::vector<double> gap;             // mean distance
    std::vector<Eigen::Matrix3d> energy; // of the flow by its slopes, over area and squared velocity of the body

    Doubts() = default;
    explicit Doubts(const CurvedSurface& surface);
    Doubts of(const std::vector<uint32_t>& origin) const; // for panels cut from these faces
};

GeometryErrors geometry_errors(const BoundaryOperators& op, const std::vector<Currents>& currents,
                               const CurvedSurface& surface, const Doubts& doubts);
} // namespace lr::baker
