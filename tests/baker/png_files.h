// PNG images of every kind, written with libpng, and masks to put into them.
#pragma once

#include <doctest/doctest.h>

#include <png.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace lr::test {

struct Opacity {
    std::size_t width = 0, height = 0;
    std::vector<double> value; // 0 to 1, from the top row down, as in files

    double& at(std::size_t x, std::size_t y) { return value[y * width + x]; }
    double at(std::size_t x, std::size_t y) const { return value[y * width + x]; }
};

// Covered part of each pixel, by n x n samples; y down, from the top left corner of the image.
inline Opacity draw(std::size_t width, std::size_t height, const std::function<bool(double, double)>& inside,
                    int n = 8) {
    Opacity mask{width, height, std::vector<double>(width * height, 0.0)};
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) {
            int count = 0;
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j)
                    count += inside(static_cast<double>(x) + (i + 0.5) / n, static_cast<double>(y) + (j + 0.5) / n);
            mask.at(x, y) = static_cast<double>(count) / (n * n);
        }
    return mask;
}

// Even-odd.
inline bool in_polygon(const std::vector<std::pair<double, double>>& corners, double x, double y) {
    bool inside = false;
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        const auto [ax, ay] = corners[j];
        const auto [bx, by] = corners[i];
        if ((ay > y) != (by > y) && x < ax + (bx - ax) * (y - ay) / (by - ay)) inside = !inside;
    }
    return inside;
}

struct PngKind {
    int color = PNG_COLOR_TYPE_RGB_ALPHA;
    int depth = 8;
    bool interlaced = false;
    bool transparency = true; // tRNS of palettes
};

// Writes opacity to the alpha channel, to a palette of 256 opacities, or, without either, to the colour.
inline std::string png_file(const Opacity& mask, const PngKind& kind = {}) {
    std::string bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    REQUIRE(info != nullptr);
    png_set_write_fn(
        png, &bytes,
        [](png_structp p, png_bytep data, png_size_t size) {
            static_cast<std::string*>(png_get_io_ptr(p))->append(reinterpret_cast<const char*>(data), size);
        },
        [](png_structp) {});
    png_set_compression_level(png, 1);
    png_set_IHDR(png, info, static_cast<png_uint_32>(mask.width), static_cast<png_uint_32>(mask.height), kind.depth,
                 kind.color, kind.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (kind.color == PNG_COLOR_TYPE_PALETTE) {
        png_color colors[256];
        png_byte alpha[256];
        for (int i = 0; i < 256; ++i) {
            const auto value = static_cast<png_byte>(i);
            colors[i] = {value, static_cast<png_byte>(255 - i), 7};
            alpha[i] = value;
        }
        png_set_PLTE(png, info, colors, 256);
        if (kind.transparency) png_set_tRNS(png, info, alpha, 256, nullptr);
    }
    png_write_info(png, info);
    const bool color = kind.color == PNG_COLOR_TYPE_RGB || kind.color == PNG_COLOR_TYPE_RGB_ALPHA;
    const bool alpha = (kind.color & PNG_COLOR_MASK_ALPHA) != 0;
    std::vector<std::vector<png_byte>> rows(mask.height);
    std::vector<png_bytep> pointers;
    for (std::size_t y = 0; y < mask.height; ++y) {
        for (std::size_t x = 0; x < mask.width; ++x) {
            const auto level = static_cast<unsigned>(std::lround(mask.at(x, y) * (kind.depth == 16 ? 65535 : 255)));
            const auto put = [&](unsigned value) {
                if (kind.depth == 16) rows[y].push_back(static_cast<png_byte>(value >> 8));
                rows[y].push_back(static_cast<png_byte>(value & 255));
            };
            for (int c = 0; c < (color ? 3 : 1); ++c) put(alpha ? static_cast<unsigned>(3 * x + y + 17) % 251 : level);
            if (alpha) put(level);
        }
        pointers.push_back(rows[y].data());
    }
    png_write_image(png, pointers.data());
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

} // namespace lr::test
