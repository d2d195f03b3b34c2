// What leaves fall on with --ground: rolling ground, a bench, a low wall, stones, and somebody who walks across. And the wind
// there: calm, until a gust comes.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "ground/terrain.h"
#include "langevin_rigid.h"
#include "options.h"

class Park {
public:
    enum class Surface { soil, stone, wood, cloth }; // of the renderer's shader

    // Adds its colliders and wind to the world.
    Park(const Options& options, lr_world* world);

    // Before each step: `to` is the time at its end, s.
    void move(double to);

    struct Piece {
        Mesh mesh; // about `position`
        Surface surface;
        bool round;
        float position[3];
        float orientation[4];
    };
    const Terrain& terrain() const { return terrain_; }
    const std::vector<Piece>& pieces() const { return pieces_; } // boxes, stones, and last the walker

    // Where the walker stands; null before it comes and after it has gone.
    const float* walker() const { return walks_ ? pieces_.back().position : nullptr; }
    static constexpr float walker_radius = 0.24f, walker_half_length = 0.62f; // m

    // Where the heap of --heap comes to lie, m: on the walker's way.
    struct Place {
        float x, y, z;
    };
    Place heap() const;

    // Whether something else than the ground may be under a place, or within `reach` (m) of it.
    bool furnished(double x, double z, double reach) const;

private:
    struct Footprint {
        double x, z, radius;
    };
    void add(const lr_collider_desc& desc, Mesh mesh, Surface surface, double radius);
    void add_ground();
    void add_furniture();
    void add_boundary_layer();
    void set_wind(double time);

    const Options& options_;
    lr_world* world_;
    Terrain terrain_;
    std::vector<Piece> pieces_;
    std::vector<Footprint> footprints_;
    lr_collider last_{};
    bool walks_ = false;
    float wind_[3] = {0.0f, 0.0f, 0.0f};
};
