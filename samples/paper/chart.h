// Curves over time, and captions.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "image/picture.h"
#include "scene.h"

struct Curve {
    std::string name;
    Colour colour;
    std::vector<Point> points;
    bool dashed = false;
};

void draw_chart(Picture& picture, Frame frame, const std::string& title, const std::string& x_label,
                const std::vector<Curve>& curves);

// A scale bar of a round length with a label, its right end at `right`.
void draw_scale_bar(Picture& picture, Point right, double metres_per_pixel, double longest_pixels);

Colour ink();  // of text
Colour pale(); // of frames and grids
void write_centred(Picture& picture, Point baseline, double height, Colour colour, const std::string& text);
