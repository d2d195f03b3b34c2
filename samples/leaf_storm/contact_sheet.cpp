// SPDX-License-Identifier: MIT
#include "contact_sheet.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>

namespace {

constexpr int gap = 12; // px

int strip_width(const Options& options) {
    return options.frames > 1 ? (options.width - gap * (options.frames - 2)) / (options.frames - 1) : 0;
}

int strip_height(const Options& options) {
    return strip_width(options) * options.height / options.width;
}

std::string mesh_for(const Options& options, std::size_t kind, const std::string& asset) {
    if (kind < options.meshes.size()) return options.meshes[kind];
    const std::filesystem::path path(asset);
    const std::string name = path.stem().string() + ".obj";
    for (const auto& folder : {path.parent_path(), path.parent_path() / "meshes"}) {
        std::error_code ignored;
        if (std::filesystem::is_regular_file(folder / name, ignored)) return (folder / name).string();
    }
    return {};
}

int columns(const Options& options) {
    return options.ground ? std::min(options.frames, 2) : 1;
}

int sheet_width(const Options& options) {
    return columns(options) * (options.width + gap) - gap;
}

int sheet_height(const Options& options) {
    if (!options.ground) return options.height + (options.frames > 1 ? gap + strip_height(options) : 0);
    const int rows = (options.frames + columns(options) - 1) / columns(options);
    return rows * (options.height + gap) - gap;
}

} // namespace

Mesh drawn_mesh(const Options& options, const Storm& storm, std::size_t kind, std::string& path) {
    const Storm::Kind& of = storm.kinds()[kind];
    path = mesh_for(options, kind, of.path);
    return load_mesh(path, of.info);
}

ContactSheet::ContactSheet(const Options& options, const Storm& storm)
    : picture_(sheet_width(options), sheet_height(options), from_srgb(22, 20, 18)) {
    std::vector<DrawnStorm::Kind> kinds;
    for (std::size_t k = 0; k < storm.kinds().size(); ++k) {
        const Storm::Kind& kind = storm.kinds()[k];
        std::string path;
        Mesh mesh = drawn_mesh(options, storm, k, path);
        const double ratio = 2.0 * static_cast<double>(mesh.radius()) / kind.info.length_d;
        if (ratio < 0.6 || ratio > 2.5) {
            std::fprintf(stderr, "leaf_storm: %s is %.2g times the size of %s: check the mesh and its unit\n",
                         path.c_str(), ratio, kind.path.c_str());
        }
        kinds.push_back({std::move(mesh), std::filesystem::path(path.empty() ? kind.path : path).stem().string()});
    }
    drawn_ = std::make_unique<DrawnStorm>(options, storm, std::move(kinds));
    for (int i = 0; i < options.frames; ++i) {
        const std::uint64_t step = options.frame_step(i);
        if (options.ground) {
            tiles_.push_back({i % columns(options) * (options.width + gap),
                              i / columns(options) * (options.height + gap), options.width, options.height, step});
        } else if (i + 1 == options.frames) {
            tiles_.push_back({0, 0, options.width, options.height, step});
        } else {
            tiles_.push_back({i * (strip_width(options) + gap), options.height + gap, strip_width(options),
                              strip_height(options), step});
        }
    }
}

bool ContactSheet::due(std::uint64_t step) const {
    return taken_ < tiles_.size() && step >= tiles_[taken_].step;
}

void ContactSheet::take(const Storm& storm) {
    const Tile& tile = tiles_[taken_++];
    picture_.paste_srgb(drawn_->draw(tile.width, tile.height), tile.width, tile.height, tile.left, tile.top);

    char text[96];
    std::snprintf(text, sizeof text, "t = %.1f s", storm.info().time);
    const double height = std::max(11.0, tile.width / 96.0), margin = 1.1 * height;
    const double width = text_width(height, text);
    const int box_width = static_cast<int>(width + 1.6 * height), box_height = static_cast<int>(2.1 * height);
    const int left = tile.left + static_cast<int>(margin), low = tile.top + tile.height - static_cast<int>(margin);
    picture_.fill(left, low - box_height, box_width, box_height, {0.0f, 0.0f, 0.0f}, 0.5f);
    write_text(picture_, {left + 0.9 * height, low - 0.55 * height}, height, from_srgb(250, 240, 225), text);
}
