// Fig. 4: a paper plane launched at 0.2 m/s.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>

#include "chart.h"
#include "fall_measures.h"
#include "figures.h"
#include "panel.h"

namespace {

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

// The sample at which the plane has turned in both directions.
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

// The launched plane, and the drawn part of its fall: to the end of both turns, only the beginning, or all from above. No one
// folds exactly: in the uneven plane the second fold is a degree farther on one side.
enum class Part { end, beginning, from_above };
struct Launch {
    const char* name;
    const char* title;
    const char* asset;
    std::int32_t loads;
    Part part;
};
constexpr Launch launches[] = {
    {"LANGEVIN", "langevin", "plane", LR_LOADS_LANGEVIN, Part::end},
    {"AERODYNAMIC", "aerodynamic", "plane", LR_LOADS_AERODYNAMIC, Part::beginning},
    {"AERODYNAMIC, a fold 1 degree off", "aerodynamic, a fold 1 degree off", "plane_uneven", LR_LOADS_AERODYNAMIC,
     Part::from_above},
};

constexpr double drawn_depth = 0.75; // m, of a fall seen from the side

struct Shown {
    Track track;
    std::size_t first, last;
    double share;
};

Shown choose(const Launch& launch, const Track& track, double share) {
    const auto depth = [&](std::size_t i, std::size_t j) { return track[i].position[1] - track[j].position[1]; };
    Shown shown{track, 0, std::min(turned_at(track) + 40, track.size() - 1), share};
    if (launch.part == Part::beginning)
        while (depth(0, shown.last) > drawn_depth) --shown.last;
    else if (launch.part == Part::end)
        while (depth(shown.first, shown.last) > drawn_depth) ++shown.first;
    return shown;
}

} // namespace

void figure_4(const Options& options, Numbers& numbers) {
    std::vector<Actor> planes;
    for (const Launch& launch : launches)
        planes.push_back(load_actor(options, launch.asset, "paper_plane.obj", from_srgb(70, 120, 190),
                                    from_srgb(225, 130, 80), false));
    Random random(options.seed);
    std::vector<Release> releases(options.falls);
    for (Release& release : releases) { // level within a degree in pitch and roll
        const Quaternion pitch = rotation({0.0, 0.0, 1.0}, random.within(-1.0, 1.0) * degree);
        release.turn = after(after(pitch, rotation({1.0, 0.0, 0.0}, random.within(-1.0, 1.0) * degree)), lying());
        release.velocity = {0.2, 0.0, 0.0};
    }
    Picture picture(1000, 820, {1.0f, 1.0f, 1.0f});
    write_centred(picture, {500, 24}, 13.0, ink(), "paper plane of 8.3 cm, launched at 0.2 m/s");
    std::vector<Shown> shown;
    for (std::size_t l = 0; l < planes.size(); ++l) {
        const Launch& launch = launches[l];
        Run run;
        run.loads = launch.loads;
        run.seed = options.seed;
        const std::vector<Track> tracks = record(planes[l].asset.get(), run, releases);
        for (const double seconds : {1.5, 3.0}) {
            const Flights flights = measure(tracks, seconds);
            const std::string within = seconds < 2.0 ? ", within 1.5 s" : ", within 3 s";
            const double front = share_of(flights.front), sideways = share_of(flights.sideways);
            numbers.judge("4", launch.name, "share that turns front (nose 45 degrees up or down)" + within, front, "",
                          "turns front", front >= 0.5);
            numbers.judge("4", launch.name, "share that turns sideways (heading by 45 degrees)" + within, sideways, "",
                          "turns sideways", sideways >= 0.5);
            numbers.show("4", launch.name, "largest pitch, mean" + within, flights.pitch, "degrees");
            numbers.show("4", launch.name, "largest turn of the heading, mean" + within, flights.heading, "degrees");
        }
        const Flights flights = measure(tracks, run.seconds);
        const Track& track = tracks[first_of(flights.both)];
        shown.push_back(choose(launch, track, share_of(flights.both)));
    }
    const double width = 1000.0 / static_cast<double>(shown.size());
    for (std::size_t m = 0; m < shown.size(); ++m) {
        const auto& [track, first, last, share] = shown[m];
        const double left = width * static_cast<double>(m);
        const Frame frame{left + 5.0, 92, width - 10.0, 714};
        const bool above = launches[m].part == Part::from_above;
        const View view = above ? View::above() : View::from(30.0, 18.0);
        char text[160];
        const auto write = [&](double y, double size) {
            write_centred(picture, {left + 0.5 * width, y}, size, ink(), text);
        };
        std::snprintf(text, sizeof text, "%s", launches[m].title);
        write(46, 10.0);
        std::snprintf(text, sizeof text, "%.0f %% of %u turn both ways in 3 s", 100.0 * share, options.falls);
        write(63, 10.0);
        const std::size_t stride = std::max<std::size_t>(1, (last - first) / 10);
        std::snprintf(text, sizeof text, "%s%.2f to %.2f s, every %.0f ms", above ? "from above, " : "",
                      track[first].time, track[last].time, 1e3 * (track[stride].time - track[0].time));
        write(79, 10.0);
        draw_fall(picture, frame, view, planes[m], track, first, last, stride,
                  fitting(frame, view, planes[m], track, first, last));
        if (m > 0) picture.line({left, 40}, {left, 810}, 1.0, pale());
    }
    save(options, "4", picture);
}
