// SPDX-License-Identifier: MIT
#include "image/png.h"

#include <array>
#include <map>
#include <png.h>
#include <string>
#include <vector>

#include "failure.h"

namespace {

// pixels: in the format of `image`. Encodes, writes and commits.
void encode(png_image& image, const std::vector<std::uint8_t>& pixels, const void* palette, OutputFile& file) {
    png_alloc_size_t size = 0;
    std::vector<std::uint8_t> bytes;
    const bool sized = png_image_write_get_memory_size(image, size, 0, pixels.data(), 0, palette) != 0;
    if (sized) bytes.resize(size);
    if (!sized || !png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, palette)) {
        throw Failure("cannot encode " + file.path() + ": " + image.message, "try a smaller picture");
    }
    file.write(bytes.data(), size);
    file.commit();
}

png_image header(const Picture& picture) {
    png_image image = {};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.width());
    image.height = static_cast<png_uint_32>(picture.height());
    image.format = PNG_FORMAT_RGB;
    return image;
}

} // namespace

void write_png(const Picture& picture, OutputFile& file) {
    png_image image = header(picture);
    encode(image, picture.srgb(), nullptr, file);
}

void write_diagram_png(const Picture& picture, OutputFile& file) {
    const std::vector<std::uint8_t> pixels = picture.srgb();
    for (const int levels : {31, 15, 7, 5}) { // at most 216 colours
        std::map<std::array<std::uint8_t, 3>, std::uint8_t> numbers;
        std::vector<std::uint8_t> palette, indices;
        for (std::size_t i = 0; i < pixels.size(); i += 3) {
            std::array<std::uint8_t, 3> colour{};
            for (std::size_t k = 0; k < 3; ++k) {
                const int level = (pixels[i + k] * levels + 127) / 255;
                colour[k] = static_cast<std::uint8_t>(level * 255 / levels);
            }
            const auto [place, fresh] = numbers.try_emplace(colour, static_cast<std::uint8_t>(numbers.size()));
            if (fresh) palette.insert(palette.end(), colour.begin(), colour.end());
            if (numbers.size() > 256) break;
            indices.push_back(place->second);
        }
        if (numbers.size() > 256) continue;
        png_image image = header(picture);
        image.format = PNG_FORMAT_RGB_COLORMAP;
        image.colormap_entries = static_cast<png_uint_32>(numbers.size());
        encode(image, indices, palette.data(), file);
        return;
    }
}
