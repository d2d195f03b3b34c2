// What the paper's figures show, as numbers of one fall.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "recorded_falls.h"

// Extremes of a series by turns, each at least `height` from the one before.
std::vector<std::size_t> reversals(const std::vector<double>& series, double height);

struct LeafFall {
    double descent = 0.0;    // m/s, height lost over time, second half
    double helix = 0.0;      // turns of the heading, net
    double coherence = 0.0;  // net over total turning of the heading
    double rolls = 0.0;      // turns about the long axis, to either side
    double overturns = 0.0;  // times the other face came up
    double side_turns = 0.0; // reversals of the path's main horizontal direction
    bool helical() const;    // a turn or more, most of it one way
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
    double across = 0.0;     // swing of the thin axis across its main direction over that along it
    double reversals = 0.0;  // of the tilt, in the main direction and across it, by 2 degrees or more
    double directions = 0.0; // of the two, how many swing by 5 degrees root mean square or more
};

Sinking measure_sinking(const Track& track); // thin axis z
