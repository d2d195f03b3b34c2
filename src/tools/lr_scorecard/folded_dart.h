// The paper's plane: a dart folded from a square, with every layer where the folds put it.
#pragma once

#include "tools/lr_scorecard/measured_bodies.h"

namespace lr::scorecard {

struct Dart {
    Triangles surface, layers; // m, nose at the origin, tail towards -x, up +z
};

// Folded in half, the corners to the middle line (45 degrees), those edges there again (22.5), and wings out from the keel
// (7.5), which rise by one in ten. uneven: rad by which the second of these folds goes farther on the left.
Dart folded_dart(double side, double uneven);

} // namespace lr::scorecard
