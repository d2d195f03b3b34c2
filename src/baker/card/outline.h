// Outlines of an alpha mask: the iso-line at a threshold, as nested loops.
#pragma once

#include "baker/card/alpha_mask.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace lr::baker {

using Loop = std::vector<Eigen::Vector2d>; // pixels, y up; the opaque side lies to the left

// Positive for an outer outline, negative for a hole.
double signed_area(const Loop& loop);
double perimeter(const Loop& loop);

// One connected opaque region. loops[0] is its outer outline, the others are its holes.
struct Piece {
    std::vector<Loop> loops;
    double area = 0.0; // pixels^2
};

struct Outlines {
    std::vector<Piece> pieces;            // largest first
    std::size_t specks = 0, pinholes = 0; // left out
    bool stairs = false; // most of the outline runs between fully opaque and transparent pixels, without greys
    double speck_area = 0.0, pinhole_area = 0.0; // pixels^2, of all of them
};

// Marching squares with linear interpolation between pixel centres; at a saddle the opaque corners are joined if the bilinear
// interpolant is opaque at its saddle point (Nielson and Hamann 1991, The asymptotic decider). Loops never touch.
// threshold: of the opacity, above 0 and below 1. What is smaller than `speck` times the largest region is left out:
// regions, and holes, which are closed. Corners that the pixel grid cut off are put back. Faults 222 and 224.
bool trace_outlines(const AlphaMask& mask, double threshold, double speck, const std::string& where, Outlines& out,
                    Faults& faults);

} // namespace lr::baker
