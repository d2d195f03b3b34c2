// Fewer vertices for an outline, at the same area.
#pragma once

#include "baker/card/outline.h"

namespace lr::baker {

// Collapses edges, the one that moves the outline least first, to a point that keeps the area (Kronenfeld, Stanislawski, Buttenfield
// and Brockmeyer 2020, Simplification of polylines by segment collapse). No part of an outline moves by more than `tolerance` pixels, nor by
// more than a quarter of its distance to other parts, so that stems keep their width and nothing comes to cross. For edges below
// `shortest` half their length is added to the tolerance: what they would cost in small triangles, they are not worth.
void simplify_outlines(std::vector<Loop>& loops, double tolerance, double shortest);

} // namespace lr::baker
