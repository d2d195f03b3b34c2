// Outlines of an alpha mask: the iso-line at a threshold, as nested loops.
#pragma once

#include "baker/card/alpha_mask.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace lr::baker {

using Loop = std::vector<Eigen::Vector2d>; // pixels, y up; the opaque side is on the left

// Integrals over what is within outlines: area, first and second moments about the origin.
struct PlaneMoments {
    double area = 0.0;
    Eigen::Vector2d first = Eigen::Vector2d::Zero();
    Eigen::Matrix2d second = Eigen::Matrix2d::Zero();

    PlaneMoments& operator+=(const PlaneMoments& other);
};

// Those of a hole are negative.
PlaneMoments moments(const Loop& loop, const Eigen::Vector2d& origin);

// Positive for an outer outline, negative for a hole.
double signed_area(const Loop& loop);
double perimeter(const Loop& loop);

// One connected opaque region. loops[0] is its outer outline, the others are its holes.
struct Piece {
    std::vector<Loop> loops;
    double area = 0.0; // pixels^2
};

// A closed hole.
struct Pinhole {
    std::size_t pixel;    // one within it, counted row by row
    PlaneMoments moments; // negative; pixels, about the centre of the image
};

struct Outlines {
    std::vector<Piece> pieces; // largest first
    std::vector<Pinhole> pinholes;
    std::size_t specks = 0; // number of ignored regions
    bool stairs = false;    // most of the outline is between fully opaque and fully transparent pixels
    double speck_area = 0.0, pinhole_area = 0.0; // total, pixels^2
};

// Marching squares with linear interpolation between pixel centres. At a saddle the opaque corners are joined if the bilinear interpolant is opaque
// at its saddle point (Nielson and Hamann 1991, The asymptotic decider). Loops never touch. threshold: of the opacity, above 0 and below 1. Ignores
// regions and closes holes smaller than `speck` times the largest region; with `keep_pinholes` the largest of these holes stay, until the closed ones
// are together less than a hundredth of it. Restores corners that the pixel grid has cut off. Faults 222 and 224.
bool trace_outlines(const AlphaMask& mask, double threshold, double speck, bool keep_pinholes, const std::string& where,
                    Outlines& out, Faults& faults);
} // namespace lr::baker
