// Draws a storm, or the park of --ground, by the renderer of samples/drawing.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh.h"
#include "storm.h"

extern "C" {
#include "drawing/bodies.h"
#include "drawing/landscape.h"
#include "drawing/picture.h"
#include "drawing/shadow.h"
}

class DrawnStorm {
public:
    struct Kind {
        Mesh mesh;
        std::string name; // tells how to colour it
    };
    // kinds: as the storm's. Throws Failure without OpenGL.
    DrawnStorm(const Options& options, const Storm& storm, std::vector<Kind> kinds);
    ~DrawnStorm();
    DrawnStorm(const DrawnStorm&) = delete;
    DrawnStorm& operator=(const DrawnStorm&) = delete;

    std::vector<std::uint8_t> draw(int width, int height); // 3 bytes per pixel, sRGB, rows from the top

private:
    const Storm& storm_;
    std::vector<Kind> kinds_;
    std::vector<body_mesh> meshes_;
    std::vector<drawn_batch> batches_;
    ::camera camera_{};
    float haze_;
    ::picture picture_{};
    ::shadow shadow_{};
    ::bodies bodies_{};
    ::landscape landscape_{};
};
