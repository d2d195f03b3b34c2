// A picture in linear light, and antialiased shapes for captions and diagrams.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

struct Colour {
    float r = 0.0f, g = 0.0f, b = 0.0f; // linear, 0 to 1
};

Colour from_srgb(int r, int g, int b); // 0 to 255 each
Colour mixed(Colour a, Colour b, float part_of_b);

struct Point {
    double x = 0.0, y = 0.0; // px, y down, pixel centres at .5
};

class Picture {
public:
    Picture(int width, int height, Colour fill);

    int width() const { return width_; }
    int height() const { return height_; }
    std::vector<std::uint8_t> srgb() const; // 3 bytes per pixel, rows from the top

    void paste_srgb(const std::vector<std::uint8_t>& pixels, int width, int height, int left,
                    int top); // 3 bytes per pixel
    void fill(int left, int top, int width, int height, Colour colour, float alpha);
    void line(Point a, Point b, double thickness, Colour colour, float alpha = 1.0f);
    // direction: of the long half axis (its length counts); minor: ratio of the short half axis to the long one.
    void ellipse(Point centre, Point direction, double minor, Colour colour, float alpha);

private:
    void blend(int x, int y, Colour colour, float alpha);

    int width_, height_;
    std::vector<Colour> pixels_;
};

// Letters as strokes: digits, small letters, . , : + = - / % ( ). height: px of a digit. Returns the width, px.
double write_text(Picture& picture, Point baseline, double height, Colour colour, std::string_view text);
double text_width(double height, std::string_view text);
