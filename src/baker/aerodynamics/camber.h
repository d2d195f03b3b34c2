// Camber of a strip from its section, by the theory of thin aerofoils.
#pragma once

#include "baker/aerodynamics/surface_parts.h"

#include <Eigen/Core>

namespace lr::baker {

// Minus the incidence of zero lift of a stream from the leading edge (Glauert 1926), so that lift towards the normal is positive. Section of the
// strip by the plane along chord (to the leading edge) and normal through `at`. Slopes are of the middle of all layers, relative to the chord
// direction, so that a tilt of the whole section counts as incidence. 0 for a section without length. The section's couple about mid-chord is Munk's,
// which Kirchhoff's equations have from the added mass of the cambered surface.
double camber_of(const Part& strip, const Eigen::Vector3d& at, const Eigen::Vector3d& chord,
                 const Eigen::Vector3d& normal);
} // namespace lr::baker
