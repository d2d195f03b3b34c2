// SPDX-License-Identifier: MIT
#include "image/png.h"

#include <png.h>
#include <string>
#include <vector>

#include "failure.h"

void write_png(const Picture& picture, OutputFile& file) {
    const std::vector<std::uint8_t> pixels = picture.srgb();
    png_image image = {};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.width());
    image.height = static_cast<png_uint_32>(picture.height());
    image.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = 0;
    std::vector<std::uint8_t> bytes;
    const bool sized = png_image_write_get_memory_size(image, size, 0, pixels.data(), 0, nullptr) != 0;
    if (sized) bytes.resize(size);
    if (!sized || !png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr)) {
        throw Failure("cannot encode " + file.path() + ": " + image.message, "try a smaller --width");
    }
    file.write(bytes.data(), size);
    file.commit();
}
