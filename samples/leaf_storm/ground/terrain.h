// Gently rolling ground, level with y = 0 at its borders: heights of a smooth function of place, and the triangles
// between them that bodies land on.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "mesh.h"
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
    // Of the triangle that is there, as the collider has it; outside the nearest one.
    Place at(double x, double z) const;
    Mesh mesh() const;

private:
    std::vector<float> heights_;
    double lowest_ = 0.0;
};
