// A picture of the samples' rasteriser as the bytes of a PNG file.
#pragma once

#include "image/picture.h"

#include <png.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace lr::tools {

inline std::vector<uint8_t> encode_png(const Picture& picture) {
    png_image image = {};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.width());
    image.height = static_cast<png_uint_32>(picture.height());
    image.format = PNG_FORMAT_RGB;
    const std::vector<uint8_t> pixels = picture.srgb();
    png_alloc_size_t size = 0;
    const bool sized = png_image_write_to_memory(&image, nullptr, &size, 0, pixels.data(), 0, nullptr) != 0;
    std::vector<uint8_t> bytes(size);
    if (!sized || !png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr))
        throw std::runtime_error(std::string("libpng: ") + image.message);
    bytes.resize(size);
    return bytes;
}
} // namespace lr::tools
