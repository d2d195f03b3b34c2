// Rows for bodies that fly along their span: winged seeds that spin, darts that glide, stall and turn.
#include "tools/falls/random.h"
#include "tools/lr_scorecard/span_bodies.h"
#include "tools/lr_scorecard/span_falls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

namespace lr::scorecard {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;
constexpr double degree = pi / 180.0, infinite = std::numeric_limits<double>::infinity();

struct SeedFall {
    bool turns = false;                           // steadily about the vertical on arrival
    double descent = 0.0, rate = 0.0, cone = 0.0; // m/s; turns a minute; degrees of the wing above the horizontal
    double after = std::numeric_limits<double>::infinity(); // m, fallen before it turns to the end
};

SeedFall measure_seed(const Track& track, double height) {
    SeedFall m;
    const std::span<const Sample> samples = fallen(track, height);
    const auto last = static_cast<size_t>(0.4 / track.interval); // 0.4 s: six turns
    if (samples.size() < 2 * last) return m;
    const std::span<const Sample> end = samples.last(last);
    const double spin = spin_of(end);
    const auto upright = [](const Sample& s) { return std::abs(s.spin.dot(up())) / s.spin.norm(); };
    double along = 0.0;
    for (const Sample& s : end) {
        along += upright(s) / static_cast<double>(last);
        m.cone += std::asin(std::clamp((s.orientation * Vector3d::UnitX()).y(), -1.0, 1.0)) / degree /
                  static_cast<double>(last);
    }
    m.descent = descent_of(end, track.interval);
    m.rate = std::abs(spin) * 60.0 / (2.0 * pi);
    m.turns = m.rate > 300.0 && along > 0.9 && std::abs(m.cone) < 50.0;
    if (!m.turns) return m;
    size_t first = samples.size();
    while (first > 0 && samples[first - 1].spin.dot(up()) / spin > 0.5 && upright(samples[first - 1]) > 0.7) --first;
    if (first < samples.size()) m.after = samples[0].position.y() - samples[first].position.y();
    return m;
}

struct SeedFalls {
    double share = 0.0, after = 0.0; // after: m of fall by which 90 % of all falls turn
    Statistic descent, rate, cone;
    std::vector<Track> tracks;
};

constexpr double seed_height = 10.0; // m

SeedFalls drop_seeds(const Context& context, const Asset& seed, uint32_t substeps) {
    Run run = game_run(context, substeps, 13.0);
    run.floor = -seed_height - 2.0; // heights of release differ by up to 2 m
    SeedFalls out;
    out.tracks = record(seed, run, released_anyhow(context.quick ? 60 : 200, 61));
    std::vector<double> descent, rate, cone, after;
    for (const Track& t : out.tracks) {
        const SeedFall m = measure_seed(t, seed_height);
        after.push_back(m.after);
        if (!m.turns) continue;
        descent.push_back(m.descent);
        rate.push_back(m.rate);
        cone.push_back(m.cone);
    }
    out.share = static_cast<double>(descent.size()) / static_cast<double>(after.size());
    std::sort(after.begin(), after.end());
    out.after = after[after.size() * 9 / 10];
    out.descent = summarise(std::move(descent));
    out.rate = summarise(std::move(rate));
    out.cone = summarise(std::move(cone));
    return out;
}

std::string name_of(const SeedShape& shape) {
    char text[48];
    std::snprintf(text, sizeof text, "%.0f mg, %.1f cm", 1e6 * shape.mass, 1e2 * shape.radius);
    return text;
}
} // namespace

RowResult run_seed(const Context& context) {
    RowResult result;
    // The first seed is measured. The others have its shape: descent goes with the root of the disc loading (Green 1980).
    const std::array<SeedShape, 4> shapes{
        {{}, {.mass = 60e-6, .radius = 0.025}, {.mass = 120e-6, .radius = 0.035}, {.mass = 400e-6, .radius = 0.06}}};
    std::array<SeedFalls, shapes.size()> falls;
    SeedFalls coarse;
    double widest = 0.0; // chord of the first
    std::array<lr_asset_info, shapes.size()> info{};
    context.parallel(shapes.size(), [&](size_t i) {
        const Seed seed = seed_mesh(shapes[i]);
        const Asset asset = bake_seed(seed);
        info[i] = info_of(asset);
        falls[i] = drop_seeds(context, asset, 4);
        if (i > 0) return;
        coarse = drop_seeds(context, asset, 2);
        widest = seed.widest;
    });
    const SeedFalls& main = falls[0];
    result.add("mass", Rule::relative, info[0].mass, 232e-6, 1e-3, "kg");
    result.add("centre of mass behind the leading edge, of the widest chord", Rule::absolute,
               info[0].center_of_mass[1] / widest, 0.30, 0.03);
    result.add("share that turns after 10 m, 1/60 s x 4", Rule::at_least, main.share, 0.95, 0.0);
    result.add("descent of those that turn", Rule::relative, main.descent.mean, 0.97, 0.15, "m/s");
    result.add("turns a minute", Rule::absolute, main.rate.mean, 1000.0, 200.0, "/min");
    result.add("fallen when 90 % of all turn", Rule::at_most, main.after, 3.0, 0.0, "m");
    result.show("wing above the horizontal", main.cone.mean, "deg");
    result.add("share that turns after 10 m, 1/60 s x 2", Rule::at_least, coarse.share, 0.90, 0.0);
    result.add("descent, 1/60 s x 2", Rule::relative, coarse.descent.mean, 0.97, 0.15, "m/s");
    const auto of_loading = [&](size_t i) { // over the speed of the disc loading
        const double disc = pi * shapes[i].radius * shapes[i].radius;
        return falls[i].descent.mean / std::sqrt(info[i].mass * 9.81 / (1.2 * disc));
    };
    for (size_t i = 1; i < shapes.size(); ++i) {
        result.add(name_of(shapes[i]) + ": share that turns", Rule::at_least, falls[i].share, 0.9, 0.0);
        result.add(name_of(shapes[i]) + ": descent by disc loading, over the first's", Rule::relative,
                   of_loading(i) / of_loading(0), 1.0, 0.2);
        result.show(name_of(shapes[i]) + ": descent", falls[i].descent.mean, "m/s");
        result.show(name_of(shapes[i]) + ": turns a minute", falls[i].rate.mean, "/min");
    }
    std::vector<LinePlot> plots;
    plots.push_back(side_view("Winged seed, any release", main.tracks, 6, 2.5, 0.55, {Vector3d::UnitX(), 0.16, 2}));
    LinePlot rate{"Turns about the vertical", "time (s)", "turns a minute"};
    for (size_t i = 0; i < std::min<size_t>(12, main.tracks.size()); ++i) {
        Series line{"", i % 2 ? "#2e7d43" : "#1f5fa8", {}};
        line.width = 1.0;
        const std::span<const Sample> samples = fallen(main.tracks[i], 4.0);
        for (size_t n = 0; n < samples.size(); ++n)
            line.points.push_back({main.tracks[i].interval * static_cast<double>(n),
                                   std::abs(samples[n].spin.dot(up())) * 60.0 / (2.0 * pi)});
        rate.series.push_back(std::move(line));
    }
    plots.push_back(std::move(rate));
    result.pictures.push_back(
        {"seed.svg", draw(plots, 2), "Winged seeds; strokes: their wings, enlarged, 1/30 s apart."});
    return result;
}

namespace {

struct DartFlight {
    double range = 0.0;     // m, when it is down
    double incidence = 0.0; // degrees, largest angle between nose and velocity
    double turn = 0.0;      // degrees, of the heading
    bool swoops = false;    // sinks more slowly, then faster again, by 0.3 m/s
};

DartFlight measure_flight(const Track& track, double height) {
    DartFlight m;
    const std::span<const Sample> samples = fallen(track, height);
    if (samples.size() < 8) return {0.0, infinite, infinite, false};
    const Vector3d displacement = samples.back().position - samples.front().position;
    m.range = std::hypot(displacement.x(), displacement.z());
    std::vector<double> climb;
    double before = 0.0, turned = 0.0;
    for (const Sample& s : samples) {
        const Vector3d nose = s.orientation * Vector3d::UnitX();
        m.incidence = std::max(m.incidence, std::atan2(nose.cross(s.velocity).norm(), nose.dot(s.velocity)) / degree);
        climb.push_back(s.velocity.y());
        const double heading = std::atan2(s.velocity.z(), s.velocity.x());
        turned += std::remainder(heading - before, 2.0 * pi) / degree;
        before = heading;
        m.turn = std::max(m.turn, std::abs(turned));
    }
    m.swoops = !peaks(climb, 0.3).empty();
    return m;
}

struct DartFlights {
    Statistic range, incidence, turn;
    double swooping = 0.0, turning = 0.0; // shares
    std::vector<Track> tracks;
};

// Thrown level along x within a degree.
DartFlights throw_darts(const Context& context, const Asset& dart, double speed, double height, uint32_t substeps) {
    Random random(62);
    std::vector<Start> starts(context.quick ? 30 : 100);
    const Eigen::AngleAxisd z_up(-0.5 * pi, Vector3d::UnitX());
    for (Start& s : starts) {
        s.orientation = Eigen::AngleAxisd(random.real(-1.0, 1.0) * degree, Vector3d::UnitZ()) *
                        Eigen::AngleAxisd(random.real(-1.0, 1.0) * degree, Vector3d::UnitX()) * z_up;
        s.velocity = Vector3d(speed, 0.0, 0.0);
    }
    Run run = game_run(context, substeps, 4.0 + height);
    run.floor = -height;
    DartFlights out;
    out.tracks = record(dart, run, starts);
    std::vector<double> range, incidence, turn;
    std::vector<bool> swoops, turns;
    for (const Track& t : out.tracks) {
        const DartFlight m = measure_flight(t, height);
        range.push_back(m.range);
        incidence.push_back(m.incidence);
        turn.push_back(m.turn);
        swoops.push_back(m.swoops);
        turns.push_back(m.turn > 180.0);
    }
    out.range = summarise(std::move(range));
    out.incidence = summarise(std::move(incidence));
    out.turn = summarise(std::move(turn));
    out.swooping = share_of(swoops);
    out.turning = share_of(turns);
    return out;
}
} // namespace

RowResult run_dart(const Context& context) {
    RowResult result;
    const Asset even = bake_dart({}), heavy_tail = bake_dart({.weight_place = 0.54}),
                twisted = bake_dart({.twist = 3.0});
    const lr_asset_info info = info_of(even);
    result.add("mass", Rule::relative, info.mass, 0.005, 1e-3, "kg");
    result.add("centre of mass behind the nose, of the length", Rule::absolute, -info.center_of_mass[0] / 0.2, 0.475,
               0.005);
    const DartFlights level = throw_darts(context, even, 5.0, 2.0, 4), coarse = throw_darts(context, even, 5.0, 2.0, 2),
                      tail = throw_darts(context, heavy_tail, 5.0, 2.0, 4),
                      tail_high = throw_darts(context, heavy_tail, 5.0, 10.0, 4),
                      turned = throw_darts(context, twisted, 5.0, 10.0, 4);
    result.add("thrown level at 5 m/s from 2 m: range, median", Rule::at_least, level.range.p50, 6.0, 0.0, "m");
    result.show("range, 5 % of the throws", level.range.p5, "m");
    result.show("largest incidence, median", level.incidence.p50, "deg");
    result.add("1/60 s x 2: range, median", Rule::at_least, coarse.range.p50, 6.0, 0.0, "m");
    result.show("weight at 54 %: range over that of the first", tail.range.p50 / level.range.p50);
    result.add("weight at 54 %: largest incidence (stall), median", Rule::at_least, tail.incidence.p50, 25.0, 0.0,
               "deg");
    result.add("weight at 54 %, from 10 m: share that swoops", Rule::at_least, tail_high.swooping, 0.9, 0.0);
    result.add("a wing twisted by 3 degrees, from 10 m: share that turns by 180 degrees", Rule::at_least,
               turned.turning, 0.9, 0.0);
    result.show("a wing twisted by 3 degrees: turn of the heading, median", turned.turn.p50, "deg");
    const Strokes strokes{Vector3d::UnitX(), 0.25, 4};
    std::vector<LinePlot> plots;
    plots.push_back(side_view("Dart, thrown level at 5 m/s", level.tracks, 4, 2.0, 0.0, strokes));
    plots.push_back(side_view("Weight at 54 % of the length", tail_high.tracks, 2, 10.0, 0.0, {strokes.axis, 0.4, 6}));
    LinePlot above{"A wing twisted by 3 degrees, from above", "x (m)", "z (m)"};
    above.equal_scale = true;
    for (size_t i = 0; i < std::min<size_t>(4, turned.tracks.size()); ++i) {
        Series path{"", "#b5402a", {}};
        path.width = 1.0;
        for (const Sample& s : fallen(turned.tracks[i], 10.0)) path.points.push_back({s.position.x(), s.position.z()});
        above.series.push_back(std::move(path));
    }
    plots.push_back(std::move(above));
    result.pictures.push_back({"dart.svg", draw(plots, 3), "Darts; strokes: nose to tail, enlarged."});
    return result;
}
} // namespace lr::scorecard
