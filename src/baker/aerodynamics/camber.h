// Camber of a strip from its section, by the theory of thin aerofoils.
#pragma once

#include "baker/aerodynamics/surface_parts.h"

#include <Eigen/Core>

namespace lr::baker {

struct Camber {
    double incidence =
        0.0; // at which a stream from the leading edge lifts nothing, with its sign reversed: lift towards the normal is positive
    double moment = 0.0; // Cm about the quarter chord, nose up
};

// Section of the strip by the plane along chord (to the leading edge) and normal through `at`. Slopes are those of the middle of all layers,
// relative to the chord direction, so that a tilt of the whole section against it counts as incidence. Sections with fewer than two points have none.
Camber camber_of(const Part& strip, const Eigen::Vector3d& at, const Eigen::Vector3d& chord,
                 const Eigen::Vector3d& normal);
} // namespace lr::baker
