// Draws the ground, the objects on it, and the shadows of bodies near it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "ground/park.h"
#include "langevin_rigid.h"
#include "mesh.h"
#include "renderer/renderer.h"

class Scenery {
public:
    // Create after the Renderer, whose context is current.
    explicit Scenery(const Park& park);
    ~Scenery();
    Scenery(const Scenery&) = delete;
    Scenery& operator=(const Scenery&) = delete;

    // Makes bodies of this batch, drawn as `mesh`, cast shadows.
    void add_kind(lr_batch batch, const Mesh& mesh);
    void draw(const lr_world* world, const Frame& frame);

private:
    struct Piece {
        unsigned array = 0, vertices = 0, indices = 0;
        int index_count = 0;
    };
    struct Kind {
        lr_batch batch;
        Vector long_axis, wide_axis; // m, half axes of the body seen along its thin axis, body frame
    };
    struct Shadow {
        float middle[3], dark, along[3], across[3], soft;
    };
    void draw_pieces(const Frame& frame) const;
    void collect(const lr_world* world, const Kind& kind, const Frame& frame);

    const Park& park_;
    std::vector<Piece> pieces_;
    std::vector<Kind> kinds_;
    std::vector<Shadow> shadows_;
    unsigned solid_program_ = 0, shadow_program_ = 0, shadow_array_ = 0, shadow_buffer_ = 0;
};
