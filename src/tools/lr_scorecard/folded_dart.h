// The paper's plane: a dart folded from a square, with all layers of paper.
#pragma once

#include "tools/lr_scorecard/measured_bodies.h"

namespace lr::scorecard {

struct Dart {
    Triangles surface, layers; // m, nose at the origin, tail towards -x, up +z
};

// Folds: in half; corners to the middle line (45 degrees); new edges to it (22.5); wings out from the keel (7.5), rising by one in ten. uneven: rad
// by which the 22.5 degree fold is larger on the left.
Dart folded_dart(double side, double uneven);
} // namespace lr::scorecard
