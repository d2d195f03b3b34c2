// Measures how the bodies of a storm lie on the ground, by the vertices of their drawn meshes.
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
    std::uint64_t near_awake = 0; // awake, though less than 5 cm above the ground
    std::uint64_t below = 0;      // deeper than the tolerance in the ground, awake or asleep
    std::uint64_t trodden = 0;    // like below, but the walker stands on them
    std::uint64_t hovering = 0;   // asleep, more than the tolerance above the ground, with no other support
    std::uint64_t on_edge = 0;    // asleep on the ground, more than 60 degrees from flat
    double deepest = 0.0;         // m, below the ground
    double highest = 0.0;         // m, largest gap below bodies asleep where only the ground can support them
    double median_tilt = 0.0;     // degrees to the slope, of bodies asleep on the ground

    // thin: the body axis along which the body is thin.
    void add(const lr_batch_view& view, const Mesh& mesh, int thin, const Park& park);
    void finish();

private:
    std::uint64_t tilts_[91] = {}; // in degrees
};
