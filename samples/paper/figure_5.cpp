// Fig. 5: a rubber ellipsoid in water, frames 50 ms apart, without and with the turbulence's loads.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "chart.h"
#include "failure.h"
#include "fall_measures.h"
#include "figures.h"
#include "panel.h"

namespace {

constexpr LoadModel models[] = {{"no loads", LR_LOADS_NONE}, both_models[0], both_models[1]};
constexpr std::size_t frames = 13;
constexpr std::size_t first_frame = 160, stride = 10; // samples of 5 ms
constexpr double apart = 0.075;                       // m to the right for each frame

// The pose relative to the body's position in the first frame.
Pose frame_of(const Track& track, std::size_t i) {
    Pose pose = track[first_frame + stride * i];
    pose.position = minus(pose.position, track[first_frame].position);
    return pose;
}

// A strip of frames, each to the right of the one before, as on film.
void draw_strip(Picture& picture, Frame frame, const Actor& actor, const Track& track, double metres_per_pixel) {
    const double half = 0.5 * apart * static_cast<double>(frames - 1);
    std::vector<Vector> places;
    for (std::size_t i = 0; i < frames; ++i) {
        places.push_back(plus(frame_of(track, i).position, {apart * static_cast<double>(i) - half, 0.0, 0.0}));
    }
    const View view = View::from(0.0, 8.0);
    Scene scene(frame, view, places, 0.04);
    scene.set_metres_per_pixel(metres_per_pixel);
    for (std::size_t i = 0; i < frames; ++i) {
        scene.body(actor.mesh, places[i], frame_of(track, i).turn, actor.front, actor.back, true);
    }
    scene.draw(picture);
}

Curve tilt_curve(const Track& track, const char* name, Colour colour, std::size_t axis) {
    Curve curve{name, colour, {}};
    for (const Pose& pose : track) {
        const Vector thin = turned(pose.turn, {0.0, 0.0, 1.0});
        curve.points.push_back({pose.time, std::asin(std::clamp(thin[axis], -1.0, 1.0)) / degree});
    }
    return curve;
}

} // namespace

void figure_5(const Options& options, Numbers& numbers) {
    const Actor ellipsoid =
        load_actor(options, "rubber", "ellipsoid_rubber.obj", from_srgb(190, 60, 50), from_srgb(240, 190, 170), true);
    lr_asset_info info;
    check(lr_asset_info_init(&info, sizeof info), "lr_asset_info_init");
    check(lr_asset_get_info(ellipsoid.asset.get(), &info), "asset info");
    Random random(options.seed);
    std::vector<Release> releases(options.falls);
    for (Release& release : releases) {
        const double azimuth = random.within(0.0, 360.0) * degree;
        release.turn = after(rotation({std::cos(azimuth), 0.0, std::sin(azimuth)}, 10.0 * degree), lying());
    }
    std::vector<Track> shown;
    double bare = 0.0;
    for (const LoadModel& model : models) {
        Run run;
        run.loads = model.loads;
        run.seed = options.seed;
        const std::vector<Track> tracks = record(ellipsoid.asset.get(), run, releases);
        std::vector<bool> several;
        double tilt = 0.0, across = 0.0, descent = 0.0, times = 0.0;
        for (const Track& track : tracks) {
            const Sinking sinking = measure_sinking(track);
            several.push_back(sinking.directions >= 2.0);
            tilt += sinking.tilt / options.falls;
            across += sinking.across / options.falls;
            descent += sinking.descent / options.falls;
            times += sinking.reversals / options.falls;
        }
        const bool none = model.loads == LR_LOADS_NONE;
        const std::string part = none ? "5a" : "5b";
        if (none) {
            bare = tilt;
            numbers.judge(part, model.name, "largest tilt in 3 s, released at 10 degrees", tilt, "degrees",
                          "small fluttering", tilt <= 20.0);
        } else {
            numbers.judge(part, model.name, "largest tilt in 3 s, over that without loads", tilt / bare, "",
                          "swings farther", tilt / bare >= 1.2);
            numbers.judge(part, model.name, "share that swings in two directions (5 degrees each)", share_of(several),
                          "", "oscillations in different directions", share_of(several) >= 0.5);
        }
        numbers.show(part, model.name, "swing across over swing along, mean", across, "");
        numbers.show(part, model.name, "reversals of the swing by 2 degrees or more in 3 s", times, "");
        if (none) {
            numbers.show(part, model.name, "descent", descent, "m/s", "without drag it accelerates throughout");
        } else {
            numbers.judge(part, model.name, "descent over the fall speed scale U0 of Eq. 1", descent / info.u0, "",
                          "falls down", descent / info.u0 >= 0.5);
        }
        shown.push_back(tracks.front());
    }
    constexpr double strip_width = 980.0;
    const double metres_per_pixel = (apart * static_cast<double>(frames - 1) + 0.09) / strip_width;
    std::vector<double> heights;
    double total = 40.0;
    for (const Track& track : shown) {
        double low = 0.0, high = 0.0;
        for (std::size_t i = 0; i < frames; ++i) {
            low = std::min(low, frame_of(track, i).position[1]);
            high = std::max(high, frame_of(track, i).position[1]);
        }
        heights.push_back((high - low + 0.09) / metres_per_pixel);
        total += heights.back() + 30.0;
    }
    Picture picture(1000, static_cast<int>(total + 270.0), {1.0f, 1.0f, 1.0f});
    write_centred(picture, {500, 24}, 13.0, ink(),
                  "rubber ellipsoid 1:2:4 cm in water, frames 50 ms apart from 0.8 s on");
    double top = 40.0;
    for (std::size_t m = 0; m < shown.size(); ++m) {
        write_text(picture, {14, top + 14}, 11.0, ink(), std::string(m == 0 ? "(a) " : "(b) ") + models[m].name);
        draw_strip(picture, {10, top + 20, strip_width, heights[m]}, ellipsoid, shown[m], metres_per_pixel);
        if (m == 0) draw_scale_bar(picture, {980, top + 30}, metres_per_pixel, 90.0);
        top += heights[m] + 30.0;
        picture.line({10, top - 4}, {990, top - 4}, 1.0, pale());
    }
    for (std::size_t m = 0; m < shown.size(); ++m) {
        draw_chart(
            picture, {10.0 + 328.0 * static_cast<double>(m), top + 4, 324, 260},
            std::string(models[m].name) + ": tilt, degrees", "time (s)",
            {tilt_curve(shown[m], "", from_srgb(31, 95, 168), 0), tilt_curve(shown[m], "", from_srgb(196, 72, 44), 2)});
    }
    save(options, "5", picture);
}
