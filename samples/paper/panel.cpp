// SPDX-License-Identifier: MIT
#include "panel.h"

#include <algorithm>

#include "chart.h"
#include "failure.h"
#include "image/png.h"

namespace {

std::vector<Vector> positions(const Track& track, std::size_t first, std::size_t last) {
    std::vector<Vector> points;
    for (std::size_t i = first; i <= last; ++i) points.push_back(track[i].position);
    return points;
}

} // namespace

Actor load_actor(const Options& options, const std::string& asset, const std::string& mesh, Colour front, Colour back,
                 bool octants) {
    Actor actor{load_asset(options.baked + "/" + asset + ".lrb"), {}, front, back, octants};
    lr_asset_info info;
    check(lr_asset_info_init(&info, sizeof info), "lr_asset_info_init");
    check(lr_asset_get_info(actor.asset.get(), &info), "asset info");
    actor.mesh = load_mesh(options.meshes + "/" + mesh, info);
    return actor;
}

Quaternion lying() {
    return rotation({1.0, 0.0, 0.0}, -90.0 * degree);
}

double fitting(Frame frame, const View& view, const Actor& actor, const Track& track, std::size_t first,
               std::size_t last) {
    return Scene(frame, view, positions(track, first, last), static_cast<double>(actor.mesh.radius()))
        .metres_per_pixel();
}

void draw_fall(Picture& picture, Frame frame, const View& view, const Actor& actor, const Track& track,
               std::size_t first, std::size_t last, std::size_t stride, double metres_per_pixel) {
    const std::vector<Vector> points = positions(track, first, last);
    Scene scene(frame, view, points, static_cast<double>(actor.mesh.radius()));
    scene.set_metres_per_pixel(metres_per_pixel);
    scene.path(points, 1.1, from_srgb(150, 155, 165));
    for (std::size_t i = first; i <= last; i += stride) {
        scene.body(actor.mesh, track[i].position, track[i].turn, actor.front, actor.back, actor.octants);
    }
    scene.draw(picture);
    draw_scale_bar(picture, {frame.left + frame.width - 8.0, frame.top + frame.height - 6.0}, metres_per_pixel, 90.0);
}

double share_of(const std::vector<bool>& seen) {
    return static_cast<double>(std::count(seen.begin(), seen.end(), true)) / static_cast<double>(seen.size());
}

std::size_t first_of(const std::vector<bool>& seen) {
    const auto found = std::find(seen.begin(), seen.end(), true);
    return found == seen.end() ? 0 : static_cast<std::size_t>(found - seen.begin());
}

void save(const Options& options, const std::string& figure, const Picture& picture) {
    OutputFile file(options.output_dir + "/figure_" + figure + ".png");
    write_diagram_png(picture, file);
}
