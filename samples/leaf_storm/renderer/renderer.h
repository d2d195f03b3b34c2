// Draws a storm: bodies by instances, the transforms straight from the library into a buffer of the graphics card.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "langevin_rigid.h"
#include "mesh.h"
#include "renderer/egl_context.h"
#include "storm_scene.h"

enum class Look { leaf, petal, paper };

class Renderer {
public:
    // Frames may be as large as width x height (px). Throws Failure.
    Renderer(int width, int height);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // Returns the number by which `draw` knows it. capacity: the most bodies.
    std::size_t add_kind(const Mesh& mesh, Look look, std::uint32_t capacity);

    struct Bodies {
        lr_batch batch;
        std::size_t kind;
    };
    // 4 bytes a pixel, sRGB, rows from the top. The camera stands in the box and looks along -z.
    std::vector<std::uint8_t> draw(const lr_world* world, const std::vector<Bodies>& all, const storm::Box& box,
                                   int width, int height);

    std::string name() const { return context_.renderer(); }

private:
    static constexpr int levels = 3;
    struct Level {
        unsigned array = 0, vertices = 0, indices = 0;
        int index_count = 0;
    };
    struct Kind {
        Level level[levels];
        Look look;
        float radius; // m
        std::uint32_t capacity;
        unsigned transforms = 0, texture = 0; // 3 texels a body: the rows of its 3 x 4 matrix
    };
    struct Camera;
    void draw_kind(const lr_world* world, const Bodies& bodies, const Camera& camera);

    EglContext context_; // first in, last out
    std::vector<Kind> kinds_;
    unsigned body_program_ = 0, sky_program_ = 0, sky_array_ = 0, picked_ = 0;
    unsigned target_[2] = {0, 0}, colour_[2] = {0, 0}, depth_ = 0; // with samples, without
    int width_, height_;
};
