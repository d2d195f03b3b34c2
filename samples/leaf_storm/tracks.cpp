// SPDX-License-Identifier: MIT
#include "tracks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "failure.h"
#include "storm.h"

namespace {

struct Instant {
    double x, y, depth;           // m, from the point of release
    std::array<double, 3> normal; // of the leaf's plane, world frame
};

std::array<double, 3> world_axis(const float* q, int axis) {
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    if (axis == 0) return {1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)};
    if (axis == 1) return {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)};
    return {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)};
}

std::vector<std::vector<Instant>> fall(const Options& options, const lr_asset* asset, int axis, double& every) {
    const float still[3] = {0.0f, 0.0f, 0.0f};
    const WorldPointer world = create_world(options, still);
    const lr_batch batch = create_batch(world.get(), asset, options.track_count, options);
    auto descs = storm::births({}, options.seed, 0, options.track_count, still);
    for (lr_body_desc& desc : descs) desc.scale = 1.0f;
    std::vector<lr_body> bodies(descs.size());
    check(lr_body_create(world.get(), batch, descs.data(), options.track_count, bodies.data()), "bodies of the tracks");

    // The storm's substep, sampled about 120 times a second.
    const double substep = options.dt / options.substeps;
    const auto together = static_cast<std::uint32_t>(std::clamp(std::floor(1.0 / (120.0 * substep)), 1.0, 65536.0));
    every = substep * together;
    const auto looks = static_cast<std::size_t>(std::ceil(options.track_seconds / every));
    std::vector<std::vector<Instant>> tracks(bodies.size());
    lr_body_state state;
    check(lr_body_state_init(&state, sizeof state), "lr_body_state_init");
    for (std::size_t look = 0; look <= looks; ++look) {
        if (look > 0) check(lr_world_step(world.get(), static_cast<float>(every), together), "step of the tracks");
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            check(lr_body_get_state(world.get(), bodies[i], &state), "state of a track");
            tracks[i].push_back(
                {state.position[0], state.position[1], state.position[2], world_axis(state.orientation, axis)});
        }
    }
    return tracks;
}

Colour hue(std::size_t i) {
    // Multiples of the golden angle: neighbours differ.
    const double turn = 2.0 * std::numbers::pi * 0.381966 * static_cast<double>(i);
    const auto channel = [&](double phase) { return static_cast<int>(105.0 + 95.0 * std::cos(turn + phase)); };
    return from_srgb(channel(0.0), static_cast<int>(0.8 * channel(-2.1)), channel(2.1));
}

} // namespace

Picture draw_tracks(const Options& options) {
    const AssetPointer asset = load_asset(options.assets.front());
    lr_asset_info info;
    check(lr_asset_info_init(&info, sizeof info), "lr_asset_info_init");
    check(lr_asset_get_info(asset.get(), &info), "asset info");
    double every = 0.0;
    const auto tracks = fall(options, asset.get(), thin_axis(info), every);

    // Rows of falls. Cells are as wide as the median fall needs, so some falls reach into their neighbours.
    const std::size_t count = tracks.size();
    std::vector<double> widths;
    double deepest = 0.0;
    for (const auto& track : tracks) {
        double reach = 0.0;
        for (const Instant& at : track) {
            reach = std::max(reach, std::abs(at.x - track[0].x));
            deepest = std::max(deepest, track[0].y - at.y);
        }
        widths.push_back(reach);
    }
    std::sort(widths.begin(), widths.end());
    const double d = info.length_d;
    const double cell = std::max(2.2 * d, 1.3 * widths[widths.size() * 3 / 4]), row_height = deepest + 2.0 * d;
    auto rows = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(count) * cell / row_height * 1.15)));
    rows = std::clamp<std::size_t>(rows, 1, count);
    const std::size_t columns = (count + rows - 1) / rows;
    const double edge = std::max(widths.back() - 0.5 * cell, 0.0) + d;
    const double wide = static_cast<double>(columns) * cell + 2.0 * edge; // m
    const double scale = options.width / wide;                            // px per metre
    const double header = 64.0, footer = 24.0;
    const int height =
        std::min(16384, static_cast<int>(header + footer + scale * row_height * static_cast<double>(rows)));
    Picture picture(options.width, height, {1.0f, 1.0f, 1.0f});

    const auto ticks = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(0.025 / every)));
    for (std::size_t i = 0; i < count; ++i) {
        const double left = edge + cell * (0.5 + static_cast<double>(i % columns));
        const double top = d + row_height * static_cast<double>(i / columns);
        const auto on_page = [&](const Instant& at) {
            return Point{scale * (left + at.x - tracks[i][0].x), header + scale * (top + tracks[i][0].y - at.y)};
        };
        const Colour ink = hue(i), pale = mixed(ink, {1.0f, 1.0f, 1.0f}, 0.55f);
        for (std::size_t k = 0; k + 1 < tracks[i].size(); ++k) {
            picture.line(on_page(tracks[i][k]), on_page(tracks[i][k + 1]), 1.2, pale);
        }
        for (std::size_t k = 0; k < tracks[i].size(); k += ticks) {
            // A disc of half the leaf's length: a line if edge-on, dark from above, pale from below.
            const auto& n = tracks[i][k].normal;
            const double across = std::hypot(n[0], n[1]), half = 0.25 * d * scale;
            const Point along = across > 1e-6 ? Point{half * n[1] / across, half * n[0] / across} : Point{half, 0.0};
            picture.ellipse(on_page(tracks[i][k]), along, std::abs(n[2]), n[2] > 0.0 ? ink : pale, 0.55f);
            const Point p = on_page(tracks[i][k]);
            picture.line({p.x - along.x, p.y - along.y}, {p.x + along.x, p.y + along.y}, 1.6, ink);
        }
    }

    char text[160];
    std::snprintf(text, sizeof text, "%zu falls of %s from rest, %.1f s, still air, a mark every %.3f s", count,
                  info.name, options.track_seconds, every * static_cast<double>(ticks));
    const Colour black = from_srgb(40, 40, 44);
    double bar = 10.0; // m; the largest of 1, 2, 5 times a power of ten within a fifth of the width
    for (int k = 0; bar * scale > 0.2 * options.width; ++k) bar /= k % 3 == 1 ? 2.5 : 2.0;
    const double right = options.width - 24.0, beside = right - bar * scale - 48.0;
    write_text(picture, {24.0, 36.0}, 15.0 * std::min(1.0, beside / text_width(15.0, text)), black, text);
    picture.line({right - bar * scale, 40.0}, {right, 40.0}, 2.0, black);
    picture.line({right - bar * scale, 34.0}, {right - bar * scale, 46.0}, 2.0, black);
    picture.line({right, 34.0}, {right, 46.0}, 2.0, black);
    std::snprintf(text, sizeof text, bar >= 1.0 ? "%.0f m" : "%.0f cm", bar >= 1.0 ? bar : 100.0 * bar);
    write_text(picture, {right - 0.5 * (bar * scale + text_width(13.0, text)), 28.0}, 13.0, black, text);
    return picture;
}
