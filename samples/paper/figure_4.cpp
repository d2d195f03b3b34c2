// Fig. 4: a paper plane launched at 0.2 m/s.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>

#include "chart.h"
#include "figures.h"
#include "measures.h"
#include "panel.h"

namespace {

constexpr double drawn_depth = 0.75; // m of a fall

struct Flights {
    std::vector<bool> front, sideways, both;
    double pitch = 0.0, heading = 0.0;
};

Flights measure(const std::vector<Track>& tracks, double seconds) {
    Flights flights;
    for (const Track& track : tracks) {
        Track part;
        for (const Pose& pose : track) {
            if (pose.time <= seconds + 1e-9) part.push_back(pose);
        }
        const PlaneFlight flight = measure_plane(part);
        flights.front.push_back(flight.front());
        flights.sideways.push_back(flight.sideways());
        flights.both.push_back(flight.front() && flight.sideways());
        flights.pitch += flight.pitch / static_cast<double>(tracks.size());
        flights.heading += flight.heading / static_cast<double>(tracks.size());
    }
    return flights;
}

// The sample at which the plane has turned both ways.
std::size_t turned_at(const Track& track) {
    Track part;
    for (const Pose& pose : track) {
        part.push_back(pose);
        if (part.size() % 4 != 0) continue;
        const PlaneFlight flight = measure_plane(part);
        if (flight.front() && flight.sideways()) break;
    }
    return part.size() - 1;
}

} // namespace

void figure_4(const Options& options, Numbers& numbers) {
    const Actor plane =
        load_actor(options, "plane", "paper_plane.obj", from_srgb(70, 120, 190), from_srgb(225, 130, 80), false);
    Random random(options.seed);
    std::vector<Release> releases(options.falls);
    for (Release& release : releases) { // level to a degree in pitch and roll
        const Quaternion pitch = rotation({0.0, 0.0, 1.0}, random.within(-1.0, 1.0) * degree);
        release.turn = after(after(pitch, rotation({1.0, 0.0, 0.0}, random.within(-1.0, 1.0) * degree)), lying());
        release.velocity = {0.2, 0.0, 0.0};
    }
    Picture picture(1000, 820, {1.0f, 1.0f, 1.0f});
    write_centred(picture, {500, 24}, 13.0, ink(), "paper plane of 8.3 cm, launched at 0.2 m/s");
    const View view = View::from(30.0, 18.0);
    const Frame frame{0, 76, 490, 730};
    struct Shown {
        Track track;
        std::size_t first, last;
        double share, scale;
    };
    std::vector<Shown> shown;
    for (const LoadModel& model : both_models) {
        Run run;
        run.loads = model.loads;
        run.seed = options.seed;
        const std::vector<Track> tracks = record(plane.asset.get(), run, releases);
        for (const double seconds : {1.5, 3.0}) {
            const Flights flights = measure(tracks, seconds);
            const std::string within = seconds < 2.0 ? ", within 1.5 s" : ", within 3 s";
            const double front = share_of(flights.front), sideways = share_of(flights.sideways);
            numbers.judge("4", model.name, "share that turns front (nose 45 degrees up or down)" + within, front, "",
                          "turns front", front >= 0.5);
            numbers.judge("4", model.name, "share that turns sideways (heading by 45 degrees)" + within, sideways, "",
                          "turns sideways", sideways >= 0.5);
            numbers.show("4", model.name, "largest pitch, mean" + within, flights.pitch, "degrees");
            numbers.show("4", model.name, "largest turn of the heading, mean" + within, flights.heading, "degrees");
        }
        const Flights flights = measure(tracks, run.seconds);
        const Track& track = tracks[first_of(flights.both)];
        const std::size_t last = std::min(turned_at(track) + 40, track.size() - 1);
        std::size_t first = last;
        while (first > 0 && track[first - 1].position[1] - track[last].position[1] < drawn_depth) --first;
        shown.push_back({track, first, last, share_of(flights.both), fitting(frame, view, plane, track, first, last)});
    }
    for (std::size_t m = 0; m < shown.size(); ++m) {
        const double left = 500.0 * static_cast<double>(m) + 5.0;
        const auto& [track, first, last, share, scale] = shown[m];
        char text[160];
        std::snprintf(text, sizeof text, "%s: %.0f %% of %u turn both ways in 3 s", both_models[m].name, 100.0 * share,
                      options.falls);
        write_centred(picture, {left + 245, 46}, 11.0, ink(), text);
        const std::size_t stride = std::max<std::size_t>(1, (last - first) / 10);
        std::snprintf(text, sizeof text, "this one from %.2f to %.2f s, every %.0f ms", track[first].time,
                      track[last].time, 1e3 * (track[stride].time - track[0].time));
        write_centred(picture, {left + 245, 64}, 10.0, ink(), text);
        draw_fall(picture, {left, frame.top, frame.width, frame.height}, view, plane, track, first, last, stride,
                  scale);
    }
    picture.line({500, 40}, {500, 810}, 1.0, pale());
    save(options, "4", picture);
}
