// An alpha-cut card, which is what foliage is in engines: a flat mesh of what the alpha channel of a texture leaves standing.
#pragma once

#include "baker/card/alpha_mask.h"
#include "baker/mesh/mesh.h"

#include <cstddef>
#include <optional>
#include <string>

namespace lr::baker {

struct CardOptions {
    double width = 0.0;           // m, of the whole image, transparent borders included; pixels are square
    double alpha = 0.5;           // the outline runs where the opacity has this value
    std::size_t triangles = 2000; // about as many; more if narrow parts need them
    MaskChannel channel = MaskChannel::alpha;
    // Of separate regions, by size, 1 for the largest. Nothing: the largest, with a warning that names the others.
    std::optional<std::size_t> piece;
    bool all_pieces = false; // as one body
    double speck = 1e-3;     // regions and holes below this part of the largest region are left out
};

struct CardReport {
    std::size_t image_width = 0, image_height = 0;
    std::size_t pieces = 0, holes = 0; // regions in the image; holes of the mesh
    double area = 0.0, outline = 0.0;  // of the mesh, m^2 and m
    double traced_area = 0.0;          // of the mask within the outline, before anything was simplified, m^2
    double edge = 0.0;                 // length that was aimed at, m
    double smallest_angle = 0.0;       // degrees
};

// The mesh lies in z = 0 with the centre of the image as its origin, x along the image's width, y up the image, and faces counter-
// clockwise seen from +z: it lies on a card of that width as the image does. Faults 101 to 104, 221 to 225, 301, 302.
bool read_card(const std::string& path_utf8, const CardOptions& options, Mesh& out, CardReport& report, Faults& faults);

// The same from memory. where: what faults call it.
bool read_card_memory(const void* bytes, std::size_t size, const CardOptions& options, const std::string& where,
                      Mesh& out, CardReport& report, Faults& faults);

} // namespace lr::baker
