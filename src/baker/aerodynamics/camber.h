// Camber of a strip from its section, by the theory of thin aerofoils.
#pragma once

#include "baker/aerodynamics/surface_parts.h"

#include <Eigen/Core>

namespace lr::baker {

// The incidence at which a stream from the leading edge lifts nothing, with its sign reversed (Glauert 1926): lift towards the normal is positive.
// Section of the strip by the plane along chord (to the leading edge) and normal through `at`. Slopes are those of the middle of all layers,
// relative to the chord direction, so that a tilt of the whole section against it counts as incidence. 0 for a section without length. The section's
// couple needs no number: about mid-chord it is Munk's, which Kirchhoff's equations have from the added mass of the cambered surface.
double camber_of(const Part& strip, const Eigen::Vector3d& at, const Eigen::Vector3d& chord,
                 const Eigen::Vector3d& normal);
} // namespace lr::baker
