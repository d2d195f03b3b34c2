// An alpha-cut card, as engines use for foliage: a flat mesh of the opaque part of a texture.
#pragma once

#include "baker/card/alpha_mask.h"
#include "baker/card/outline.h"
#include "baker/mesh/mesh.h"

#include <cstddef>
#include <optional>
#include <string>

namespace lr::baker {

struct CardOptions {
    double width = 0.0;           // m, of the whole image, transparent borders included; pixels are square
    double alpha = 0.5;           // opacity at the outline
    std::size_t triangles = 2000; // approximate number; more if narrow parts need them
    MaskChannel channel = MaskChannel::alpha;
    KeyColour key{};       // with MaskChannel::key
    std::string mask_path; // a PNG whose luminance replaces the channel; for callers, which read it. UTF-8
    // Which of several regions, by size; 1: the largest. Nothing: the largest, with a warning that lists the others.
    std::optional<std::size_t> piece;
    bool all_pieces = false; // bake all regions as one body
    double speck = 1e-3;     // ignore regions and holes smaller than this fraction of the largest region
};

struct CardReport {
    std::size_t image_width = 0, image_height = 0;
    std::size_t pieces = 0, holes = 0; // regions in the image; holes of the mesh
    double area = 0.0, outline = 0.0;  // of the mesh, m^2 and m
    double traced_area = 0.0;          // within the outline before simplification, m^2
    PlaneMoments opaque;     // of the image, before any smoothing and closing: m^2, m^3, m^4 in the mesh's frame
    double closed_gap = 0.0; // m, the widest gap of a frayed outline that was closed for the flow; 0: none
    // m, from the centre of the closed surface to that of the opaque one.
    Eigen::Vector2d off_centre = Eigen::Vector2d::Zero();
    double edge = 0.0;           // target edge length, m
    double smallest_angle = 0.0; // degrees
};

// The number of regions, each of which `piece` can choose; 0 and faults if there is no outline.
std::size_t count_card_pieces(const void* bytes, std::size_t size, const CardOptions& options, const std::string& where,
                              Faults& faults);

// The mesh is in z = 0 with its origin at the centre of the image, x along the image's width, y up, faces counter-clockwise seen
// from +z: it matches the image on a card of that width. Faults 101 to 104, 221 to 225, 301, 302.
bool read_card(const std::string& path_utf8, const CardOptions& options, Mesh& out, CardReport& report, Faults& faults);

// The same from memory. where: its name in faults.
bool read_card_memory(const void* bytes, std::size_t size, const CardOptions& options, const std::string& where,
                      Mesh& out, CardReport& report, Faults& faults);
} // namespace lr::baker
