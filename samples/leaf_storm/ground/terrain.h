// Gently rolling ground, level with y = 0 at its borders: a smooth height function, sampled, and the triangles between the
// samples, on which bodies land.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "vectors.h"

class Terrain {
public:
    static constexpr float cell = 0.25f;       // m
    static constexpr std::uint32_t side = 81;  // samples along x and z: 20 m
    static constexpr float half_width = 10.0f; // m, about the origin

    explicit Terrain(std::uint64_t seed);

    const std::vector<float>& heights() const { return heights_; } // x varies fastest
    double lowest() const { return lowest_; }

    struct Place {
        double height; // m
        Vector normal; // unit, upwards
    };
    // Height and normal of the collider's triangle at a point; outside, of the nearest one.
    Place at(double x, double z) const;

private:
    std::vector<float> heights_;
    double lowest_ = 0.0;
};
