// The behaviour in the paper's figures, as numbers of a fall.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "recorded_falls.h"

// Alternating extremes of a series, each at least `height` from the one before.
std::vector<std::size_t> reversals(const std::vector<double>& series, double height);

struct LeafFall {
    double descent = 0.0;    // m/s, height lost over time, second half
    double helix = 0.0;      // turns of the heading, net
    double coherence = 0.0;  // net over total turning of the heading
    double rolls = 0.0;      // turns about the long axis, in either direction
    double overturns = 0.0;  // number of times that the other face came up
    double side_turns = 0.0; // reversals of the path's main horizontal direction
    bool helical() const;    // at least one turn, mostly in one direction
    bool side_to_side() const;
};

// Long axis x, thin axis z.
LeafFall measure_leaf(const Track& track);

struct PlaneFlight {
    double pitch = 0.0;   // degrees: the nose's largest angle with the horizontal
    double heading = 0.0; // degrees: the nose's largest net turn about the vertical
    bool front() const { return pitch >= 45.0; }
    bool sideways() const { return heading >= 45.0; }
};

PlaneFlight measure_plane(const Track& track); // nose x

struct Sinking {
    double descent = 0.0;    // m/s, second half
    double tilt = 0.0;       // degrees: the largest, of the thin axis from the vertical
    double across = 0.0;     // swing of the thin axis across its main direction, divided by the swing along it
    double reversals = 0.0;  // of the tilt, in the main direction and across it, by 2 degrees or more
    double directions = 0.0; // number of the two directions with a swing of at least 5 degrees root mean square
};

Sinking measure_sinking(const Track& track); // thin axis z
