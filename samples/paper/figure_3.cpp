// Fig. 3: a piece of paper released at 75 and 30 degrees.
// SPDX-License-Identifier: MIT
#include <cstdio>

#include "chart.h"
#include "fall_measures.h"
#include "figures.h"
#include "panel.h"

namespace {

constexpr double drawn_depth = 1.2; // m

std::size_t end_of(const Track& track) {
    for (std::size_t i = 0; i < track.size(); ++i) {
        if (track[i].position[1] < -drawn_depth) return i;
    }
    return track.size() - 1;
}

} // namespace

void figure_3(const Options& options, const std::string& part, Numbers& numbers) {
    const bool steep = part == "3a";
    const double angle = steep ? 75.0 : 30.0;
    const Actor leaf =
        load_actor(options, "leaf", "ellipsoid_leaf.obj", from_srgb(62, 134, 62), from_srgb(232, 168, 60), false);
    Random random(options.seed);
    std::vector<Release> releases(options.falls);
    for (Release& release : releases) { // the long axis points down by the angle, within a degree
        const double roll = random.within(-1.0, 1.0);
        release.turn = after(lying(), after(rotation({0.0, 1.0, 0.0}, (angle + random.within(-1.0, 1.0)) * degree),
                                            rotation({1.0, 0.0, 0.0}, roll * degree)));
    }
    Picture picture(1000, 940, {1.0f, 1.0f, 1.0f});
    char text[160];
    std::snprintf(text, sizeof text, "leaf 8 x 2 cm, released at %.0f degrees", angle);
    write_centred(picture, {500, 24}, 13.0, ink(), text);
    const View side = View::from(25.0, 12.0), above = View::above();
    struct Shown {
        Track track;
        std::size_t last;
        double share;
    };
    std::vector<Shown> shown;
    const Frame fall_frame{0, 74, 490, 604}, above_frame{0, 716, 490, 200};
    double fall_scale = 0.0, above_scale = 0.0;
    for (const LoadModel& model : both_models) {
        Run run;
        run.loads = model.loads;
        run.seed = options.seed;
        const std::vector<Track> tracks = record(leaf.asset.get(), run, releases);
        std::vector<bool> as_paper, helical, side_to_side, rolling;
        double descent = 0.0, rolls = 0.0, helix = 0.0;
        for (const Track& track : tracks) {
            const LeafFall fall = measure_leaf(track);
            helical.push_back(fall.helical());
            side_to_side.push_back(fall.side_to_side());
            rolling.push_back(fall.rolls >= 2.0);
            as_paper.push_back(steep ? fall.helical() : fall.side_to_side());
            descent += fall.descent / options.falls;
            rolls += fall.rolls / options.falls;
            helix += std::abs(fall.helix) / options.falls;
        }
        const double share = share_of(as_paper);
        numbers.judge(part, model.name,
                      steep ? "share that falls in a helix (a turn or more in 3 s, most of it one way)"
                            : "share that tumbles from side to side (2 overturns, 2 reversals in 3 s)",
                      share, "", steep ? "helical trajectory" : "side-to-side tumbling", share >= 0.5);
        numbers.show(part, model.name, steep ? "share that tumbles from side to side" : "share that falls in a helix",
                     share_of(steep ? side_to_side : helical), "");
        numbers.show(part, model.name, "turns of the heading in 3 s", helix, "");
        numbers.judge(part, model.name, "share that turns about the long axis (twice in 3 s)", share_of(rolling), "",
                      "secondary motion about the major axis", share_of(rolling) >= 0.5);
        numbers.show(part, model.name, "turns about the long axis in 3 s", rolls, "");
        numbers.show(part, model.name, "descent", descent, "m/s", "not given; real paper 0.7 to 0.8");
        const std::size_t chosen = first_of(as_paper), last = end_of(tracks[chosen]);
        fall_scale = std::max(fall_scale, fitting(fall_frame, side, leaf, tracks[chosen], 0, last));
        above_scale = std::max(above_scale, fitting(above_frame, above, leaf, tracks[chosen], 0, last));
        shown.push_back({tracks[chosen], last, share});
    }
    for (std::size_t m = 0; m < shown.size(); ++m) {
        const double left = 500.0 * static_cast<double>(m) + 5.0;
        const auto& [track, last, share] = shown[m];
        const std::size_t stride = std::max<std::size_t>(1, last / 40);
        std::snprintf(text, sizeof text, "%s: %.0f %% of %u falls %s", both_models[m].name, 100.0 * share,
                      options.falls, steep ? "in a helix" : "side to side");
        write_centred(picture, {left + 245, 46}, 11.0, ink(), text);
        std::snprintf(text, sizeof text, "this one: %.2f s, every %.0f ms", track[last].time,
                      1e3 * (track[stride].time - track[0].time));
        write_centred(picture, {left + 245, 64}, 10.0, ink(), text);
        draw_fall(picture, {left, fall_frame.top, fall_frame.width, fall_frame.height}, side, leaf, track, 0, last,
                  stride, fall_scale);
        write_text(picture, {left + 6, 704}, 10.0, ink(), "from above");
        draw_fall(picture, {left, above_frame.top, above_frame.width, above_frame.height}, above, leaf, track, 0, last,
                  stride, above_scale);
    }
    picture.line({500, 40}, {500, 930}, 1.0, pale());
    picture.line({10, 688}, {990, 688}, 1.0, pale());
    save(options, part, picture);
}
