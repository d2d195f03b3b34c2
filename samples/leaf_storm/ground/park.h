// The park of --ground: rolling ground, a bench, a low wall, stones, and a walker who crosses it. And its wind: calm, until a
// gust comes.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "ground/terrain.h"
#include "langevin_rigid.h"
#include "options.h"

extern "C" {
#include "drawing/solids.h"
}

class Park {
public:
    // Adds its colliders and wind to the world.
    Park(const Options& options, lr_world* world);

    // Before each step: `to` is the time at its end, s.
    void move(double to);

    const Terrain& terrain() const { return terrain_; }
    const std::vector<ground_solid>& solids() const { return solids_; } // boxes, stones, and last the walker

    // The walker's position; null before and after the walk.
    const float* walker() const { return walks_ ? solids_.back().at : nullptr; }
    static constexpr float walker_radius = 0.24f, walker_half_length = 0.62f; // m

    // Position of the heap of --heap, m: on the walker's way.
    struct Place {
        float x, y, z;
    };
    Place heap() const;

    // Whether an object other than the ground can be under a point, or within `reach` (m) of it.
    bool furnished(double x, double z, double reach) const;

private:
    struct Footprint {
        double x, z, radius;
    };
    void add(ground_solid object, solid_look look, double radius);
    void add_ground();
    void add_furniture();
    void add_boundary_layer();
    void set_wind(double time);

    const Options& options_;
    lr_world* world_;
    Terrain terrain_;
    std::vector<ground_solid> solids_;
    std::vector<std::vector<float>> stones_; // their points
    std::vector<Footprint> footprints_;
    lr_collider last_{};
    bool walks_ = false;
    float wind_[3] = {0.0f, 0.0f, 0.0f};
};
