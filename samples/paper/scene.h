// Bodies at many poses and their paths in a view, drawn by the CPU: orthographic, with hidden surfaces removed.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "image/picture.h"
#include "mesh.h"
#include "vectors.h"

// The view: unit vectors of the page in the world.
struct View {
    Vector right, up, towards;
    static View from(double azimuth,
                     double elevation); // degrees; azimuth 0 looks along -z, elevation above the horizon
    static View above();                // x to the right, z down the page
};

struct Frame {
    double left, top, width, height; // px
};

class Scene {
public:
    // Fits everything in `bounds` (world points) into the frame, with at least `metres_per_pixel`.
    Scene(Frame frame, const View& view, const std::vector<Vector>& bounds, double margin_metres);

    double metres_per_pixel() const { return metres_per_pixel_; }
    void set_metres_per_pixel(double value); // keeps the middle of the view

    // front: colour where the body-frame normal has positive z; back: elsewhere. Solids with `octants` alternate both colours, so
    // that rotation is visible.
    void body(const Mesh& mesh, const Vector& position, const Quaternion& turn, Colour front, Colour back,
              bool octants);
    void path(const std::vector<Vector>& points, double thickness_pixels, Colour colour);
    void draw(Picture& picture) const;

private:
    struct Pixel {
        Colour colour;
        float depth;
        bool used;
    };
    struct Screen {
        double x, y, depth;
    };

    Screen project(const Vector& world) const;
    void triangle(const std::array<Screen, 3>& corners, Colour colour);
    void put(int x, int y, double depth, Colour colour);

    Frame frame_;
    View view_;
    Vector centre_{};
    double metres_per_pixel_ = 1.0;
    int width_, height_; // of the finer grid, which is averaged at the end
    std::vector<Pixel> pixels_;
};
