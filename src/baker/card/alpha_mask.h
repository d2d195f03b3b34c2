// The opacity of an image, which cuts a leaf out of its card.
#pragma once

#include "asset/input_faults.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace lr::baker {

// luminance: of a separate black-and-white mask image. key: distance of the colour from the background colour `key`, fully opaque from half of a
// channel's range on.
enum class MaskChannel { alpha, luminance, key };

using KeyColour = std::array<uint8_t, 3>; // sRGB

struct AlphaMask {
    std::size_t width = 0, height = 0;
    std::vector<uint16_t> opacity; // 0 to 65535, row by row from the bottom: y points up

    Eigen::Vector2d centre() const {
        return 0.5 * Eigen::Vector2d(static_cast<double>(width), static_cast<double>(height));
    }

    // Transparent outside the image, so that its border closes every outline.
    double at(std::ptrdiff_t x, std::ptrdiff_t y) const {
        const bool outside =
            x < 0 || y < 0 || x >= static_cast<std::ptrdiff_t>(width) || y >= static_cast<std::ptrdiff_t>(height);
        return outside ? 0.0 : opacity[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)];
    }
};

constexpr std::size_t max_image_side = 16384;

// Reads any PNG: 1 to 16 bits, palette, interlaced. Faults 221 and, without an alpha channel, 222.
bool read_alpha_mask(const void* png, std::size_t size, MaskChannel channel, const KeyColour& key,
                     const std::string& where, AlphaMask& out, Faults& faults);
} // namespace lr::baker
