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

Look look_for(const std::string& name) {
    if (name.find("petal") != std::string::npos) return Look::petal;
    if (name.find("confetti") != std::string::npos || name.find("paper") != std::string::npos) return Look::paper;
    return Look::leaf;
}

} // namespace

ContactSheet::ContactSheet(const Options& options, const Storm& storm)
    : picture_(options.width, options.height + (options.frames > 1 ? gap + strip_height(options) : 0),
               from_srgb(22, 20, 18)) {
    renderer_ = std::make_unique<Renderer>(options.width, options.height);
    for (std::size_t k = 0; k < storm.kinds().size(); ++k) {
        const Storm::Kind& kind = storm.kinds()[k];
        const std::string path = mesh_for(options, k, kind.path);
        const Mesh mesh = path.empty() ? ellipse_card(kind.info) : load_obj(path, kind.info);
        const double ratio = 2.0 * static_cast<double>(mesh.radius()) / kind.info.length_d;
        if (ratio < 0.6 || ratio > 2.5) {
            std::fprintf(stderr, "leaf_storm: %s is %.2g times the size of %s: is it in metres, and the right one?\n",
                         path.c_str(), ratio, kind.path.c_str());
        }
        const std::string name = std::filesystem::path(path.empty() ? kind.path : path).stem().string();
        bodies_.push_back({kind.batch, renderer_->add_kind(mesh, look_for(name), kind.count)});
    }
    const std::uint64_t steps = options.steps();
    for (int i = 1; i <= options.frames; ++i) {
        const auto part = static_cast<double>(i) / options.frames;
        const auto step =
            std::max<std::uint64_t>(1, static_cast<std::uint64_t>(part * static_cast<double>(steps) + 0.5));
        if (i == options.frames) {
            tiles_.push_back({0, 0, options.width, options.height, steps});
        } else {
            tiles_.push_back({(i - 1) * (strip_width(options) + gap), options.height + gap, strip_width(options),
                              strip_height(options), step});
        }
    }
}

bool ContactSheet::due(std::uint64_t step) const {
    return taken_ < tiles_.size() && step >= tiles_[taken_].step;
}

void ContactSheet::take(const Storm& storm) {
    const Tile& tile = tiles_[taken_++];
    const auto pixels = renderer_->draw(storm.world(), bodies_, storm.box(), tile.width, tile.height);
    picture_.paste_srgba(pixels, tile.width, tile.height, tile.left, tile.top);

    char text[96];
    std::snprintf(text, sizeof text, "t = %.1f s", storm.info().time);
    const double height = std::max(11.0, tile.width / 96.0), margin = 1.1 * height;
    const double width = text_width(height, text);
    const int box_width = static_cast<int>(width + 1.6 * height), box_height = static_cast<int>(2.1 * height);
    const int left = tile.left + static_cast<int>(margin), low = tile.top + tile.height - static_cast<int>(margin);
    picture_.fill(left, low - box_height, box_width, box_height, {0.0f, 0.0f, 0.0f}, 0.5f);
    write_text(picture_, {left + 0.9 * height, low - 0.55 * height}, height, from_srgb(250, 240, 225), text);
}
