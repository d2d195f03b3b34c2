// Draws a storm by instances. The library writes the transforms directly into a buffer of the graphics card.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "langevin_rigid.h"
#include "mesh.h"
#include "renderer/egl_context.h"
#include "storm_scene.h"

enum class Look { leaf, petal, paper };

// The camera's place, looking along -z, and the air in front of it.
struct View {
    float eye[3];    // m
    float pitch;     // rad, upwards
    float near, far; // m
    float haze;      // m: distance at which the air hides 63 %
    float sun[3];    // unit, towards it
};

// A view from inside the box.
View view_of(const storm::Box& box);

// A picture in progress.
struct Frame {
    const View& view;
    const float* to_clip; // 16 numbers, column-major

    // Makes a program with shader_air current, and sets its view and to_clip.
    void use(unsigned program) const;
};

class Renderer {
public:
    // Frames can be as large as width x height (px). Throws Failure.
    Renderer(int width, int height);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // Returns the kind's index for `draw`. capacity: largest number of bodies.
    std::size_t add_kind(const Mesh& mesh, Look look, std::uint32_t capacity);

    struct Bodies {
        lr_batch batch;
        std::size_t kind;
    };
    // 4 bytes per pixel, sRGB, rows from the top. first: draws everything besides bodies; may be empty.
    std::vector<std::uint8_t> draw(const lr_world* world, const std::vector<Bodies>& all, const View& view, int width,
                                   int height, const std::function<void(const Frame&)>& first = {});

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
        unsigned transforms = 0, texture = 0; // 3 texels per body: the rows of its 3 x 4 matrix
    };
    struct Camera;
    void draw_kind(const lr_world* world, const Bodies& bodies, const Camera& camera);

    EglContext context_; // first in, last out
    std::vector<Kind> kinds_;
    unsigned body_program_ = 0, sky_program_ = 0, sky_array_ = 0, picked_ = 0;
    unsigned target_[2] = {0, 0}, colour_[2] = {0, 0}, depth_ = 0; // with samples, without
    int width_, height_;
};
