// Simplifies outlines at constant area.
#pragma once

#include "baker/card/outline.h"

namespace lr::baker {

// Collapses edges to a point that keeps the area, smallest displacement first (Kronenfeld, Stanislawski, Buttenfield and Brockmeyer 2020,
// Simplification of polylines by segment collapse). No part of an outline moves by more than `tolerance` pixels or a quarter of its distance to other
// parts, so stems keep their width and outlines never cross. An edge shorter than `shortest` has a tolerance larger by its length, or by a fifth of
// `shortest` if that is less, because it would cost many small triangles.
void simplify_outlines(std::vector<Loop>& loops, double tolerance, double shortest);
} // namespace lr::baker
