// How the bodies of a storm lie on the ground: counted by the vertices of what is drawn for them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "ground/park.h"
#include "langevin_rigid.h"
#include "mesh.h"

struct Lying {
    static constexpr double tolerance = 2e-3; // m

    double time = 0.0; // s
    std::uint64_t bodies = 0, at_rest = 0;
    std::uint64_t near_awake = 0; // move, though less than 5 cm above the ground
    std::uint64_t below = 0;      // reach deeper than the tolerance into the ground, at rest or not
    std::uint64_t trodden = 0;    // the same, but the walker stands on them
    std::uint64_t hovering = 0; // at rest, higher than the tolerance over the ground, with nothing else there to lie on
    std::uint64_t on_edge = 0;  // at rest on the ground, more than 60 degrees from flat
    double deepest = 0.0;       // m, below the ground
    double highest = 0.0;       // m, of the lowest points of those at rest where nothing but ground is
    double median_tilt = 0.0;   // degrees, of those at rest on the ground against its slope

    // thin: the body axis across which it is thin.
    void add(const lr_batch_view& view, const Mesh& mesh, int thin, const Park& park);
    void finish();

private:
    std::uint64_t tilts_[91] = {}; // in degrees
};
