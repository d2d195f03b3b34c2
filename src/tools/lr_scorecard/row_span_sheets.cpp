// Rows for sheets that are no single flat plate: caps, curled leaves, discs with holes, strips, crosses, snow crystals.
#include "tools/falls/random.h"
#include "tools/falls/regime.h"
#include "tools/lr_scorecard/span_bodies.h"
#include "tools/lr_scorecard/span_falls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace lr::scorecard {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;
constexpr double degree = pi / 180.0;
constexpr double judged = 0.4; // the last part of a fall

Vector3d normal_of(const Sample& s) {
    return s.orientation * Vector3d::UnitZ();
}

double tilt_of(const Sample& s) { // degrees, either side up
    return std::acos(std::min(1.0, std::abs(normal_of(s).y()))) / degree;
}

std::string with(const char* what, double value, const char* unit) {
    char text[64];
    std::snprintf(text, sizeof text, "%s %.4g %s", what, value, unit);
    return text;
}

std::vector<Track> drop(const Context& context, const Asset& asset, double duration, uint64_t seed,
                        uint32_t falls = 200) {
    return record(asset, game_run(context, 4, duration), released_anyhow(context.quick ? 50 : falls, seed));
}

// Share of falls that end with the +z side up.
double share_upright(const std::vector<Track>& tracks) {
    std::vector<bool> upright;
    for (const Track& t : tracks) {
        const std::span<const Sample> end = end_of(t.samples, judged);
        upright.push_back(std::all_of(end.begin(), end.end(), [](const Sample& s) { return normal_of(s).y() > 0.0; }));
    }
    return share_of(upright);
}

double mean_tilt(const std::vector<Track>& tracks) {
    double sum = 0.0, count = 0.0;
    for (const Track& t : tracks)
        for (const Sample& s : end_of(t.samples, judged)) {
            sum += tilt_of(s);
            count += 1.0;
        }
    return sum / count;
}
} // namespace

RowResult run_cap(const Context& context) {
    RowResult result;
    static constexpr std::array<double, 4> rises{0.0, 0.05, 0.1, 0.2};
    const double diameter = 0.06, areal = 0.1; // m, kg/m^2
    std::array<std::vector<Track>, rises.size()> tracks;
    // Of 200 falls the share of the flattest cap has a standard error of 0.015, and is 0.004 above the check.
    context.parallel(rises.size(),
                     [&](size_t i) { tracks[i] = drop(context, bake_cap(diameter, rises[i], areal), 6.0, 63, 2000); });
    // A cap sinks steadily, so its reference is a disc that sinks broadside, C_D 1.17 (Hoerner 1965).
    const double broadside = std::sqrt(2.0 * areal * 9.81 / (Fluid{}.density * 1.17));
    result.show("flat disc: descent broadside", broadside, "m/s");
    result.show("flat disc: descent, any release", mean_descent(tracks[0], judged).mean, "m/s");
    std::vector<LinePlot> plots;
    for (size_t i = 0; i < rises.size(); ++i) {
        const std::string name = i == 0 ? "flat disc" : with("rise", rises[i], "d");
        plots.push_back(side_view("Cap, " + name, tracks[i], 5, 2.5, 0.6, {Vector3d::UnitX(), 0.12, 4}));
        if (i == 0) continue;
        result.add(name + ": share that is convex side down, and stays", Rule::at_least, share_upright(tracks[i]), 0.95,
                   0.0);
        result.add(name + ": descent over the flat disc's, broadside", Rule::at_most,
                   mean_descent(tracks[i], judged).mean / broadside, 1.10, 0.0);
        result.show(name + ": mean tilt", mean_tilt(tracks[i]), "deg");
    }
    result.pictures.push_back(
        {"cap.svg", draw(plots, 4, {380.0, 420.0}), "Caps of 60 mm, any release; strokes: a diameter, enlarged."});
    return result;
}

RowResult run_bowls(const Context& context) {
    RowResult result;
    struct Bowl {
        const char* name;
        double half_angle;       // of a cone, degrees; 0: half a sphere
        double drag_coefficient; // convex side first (Hoerner 1965)
        double surface;          // over the opening
    };
    static constexpr std::array<Bowl, 4> bowls{{{"cone of 60 degrees", 30.0, 0.50, 2.0},
                                                {"cone of 90 degrees", 45.0, 0.72, std::numbers::sqrt2},
                                                {"cone of 120 degrees", 60.0, 0.95, 2.0 * std::numbers::inv_sqrt3},
                                                {"half a sphere", 0.0, 0.40, 2.0}}};
    const double diameter = 0.1, areal = 0.1; // m, kg/m^2
    std::array<std::vector<Track>, bowls.size()> tracks;
    context.parallel(bowls.size(), [&](size_t i) {
        tracks[i] = drop(context, bake_bowl(diameter, bowls[i].half_angle, areal), 8.0, 66);
    });
    std::vector<LinePlot> plots;
    for (size_t i = 0; i < bowls.size(); ++i) {
        const Bowl& b = bowls[i];
        const std::string name = b.name;
        const double speed = std::sqrt(2.0 * areal * b.surface * 9.81 / (Fluid{}.density * b.drag_coefficient));
        result.add(name + ": share that is convex side down, and stays", Rule::at_least, share_upright(tracks[i]), 0.95,
                   0.0);
        result.add(name + ": descent", Rule::relative, mean_descent(tracks[i], judged).mean, speed, 0.2, "m/s");
        plots.push_back(side_view("Bowl, " + name, tracks[i], 5, 5.0, 0.8, {Vector3d::UnitZ(), 0.2, 6}));
    }
    result.pictures.push_back(
        {"bowls.svg", draw(plots, 4, {380.0, 420.0}), "Bowls of 10 cm, any release; strokes: their axes, enlarged."});
    return result;
}

RowResult run_curled_leaf(const Context& context) {
    RowResult result;
    static constexpr std::array<double, 5> twists{0.0, 6.0, -6.0, 12.0, -12.0}; // 1/m
    std::array<std::vector<Track>, twists.size()> tracks;
    context.parallel(twists.size(), [&](size_t i) {
        tracks[i] = drop(context, bake_curled_leaf(0.04, 0.08, 12.0, twists[i], 0.08), 6.0, 64);
    });
    std::array<double, twists.size()> rate{},
        leftward{}; // rad/s, mean magnitude; share that turns to the left from above
    for (size_t i = 0; i < twists.size(); ++i) {
        std::vector<bool> left;
        for (const Track& t : tracks[i]) {
            const double spin = spin_of(end_of(t.samples, judged));
            rate[i] += std::abs(spin) / static_cast<double>(tracks[i].size());
            left.push_back(spin > 0.0);
        }
        leftward[i] = share_of(left);
    }
    result.show("twist 0: rate about the vertical", rate[0], "rad/s");
    for (size_t i = 1; i < twists.size(); i += 2) {
        const std::string name = with("twist", twists[i], "/m");
        result.add(name + ": rate about the vertical", Rule::at_least, 0.5 * (rate[i] + rate[i + 1]), 10.0, 0.0,
                   "rad/s");
        const double handed = std::abs(leftward[i] - leftward[i + 1]);
        const std::string what = name + ": turns one way more often than its mirror image, share";
        if (i == 1)
            result.add(what, Rule::at_least, handed, 0.6, 0.0);
        else
            result.show(what, handed);
        result.show(name + ": descent", mean_descent(tracks[i], judged).mean, "m/s");
    }
    std::vector<LinePlot> plots;
    for (size_t i : {size_t{0}, size_t{1}, size_t{3}})
        plots.push_back(side_view("Curled leaf, " + with("twist", twists[i], "/m"), tracks[i], 4, 2.5, 0.7,
                                  {Vector3d::UnitY(), 0.12, 2}));
    result.pictures.push_back({"curled-leaf.svg", draw(plots, 3), "Curled leaves, any release; strokes: their ribs."});
    return result;
}

RowResult run_holes(const Context& context) {
    RowResult result;
    // Of two sheets of paper: I* 0.1 without the hole, Re 3400. Without a hole such discs tumble (Field et al. 1997).
    static constexpr std::array<double, 5> holes{0.0, 0.3, 0.5, 0.7, 0.8};
    const double diameter = 0.04, areal = 0.098;
    std::array<std::vector<Track>, holes.size()> tracks;
    context.parallel(holes.size(), [&](size_t i) {
        Run run = game_run(context, 1, 6.0); // as 1/60 s x 4, but sampled at each step: tumbling is quick
        run.dt = 1.0f / 240.0f;
        run.interval = static_cast<double>(run.dt);
        tracks[i] = record(bake_ring(diameter, holes[i], areal), run, released_anyhow(context.quick ? 30 : 100, 65));
    });
    std::array<double, holes.size()> tumbling{}, fluttering{};
    std::vector<LinePlot> plots;
    for (size_t i = 0; i < holes.size(); ++i) {
        RegimeLimits limits;
        limits.tumbling_run = 2;
        for (const Track& t : tracks[i]) {
            std::vector<Vector3d> normals;
            for (const Sample& s : end_of(t.samples, 0.5)) normals.push_back(normal_of(s));
            const RegimeMeasures m = measure_regime(normals, up(), limits);
            tumbling[i] += m.tumbling_share / static_cast<double>(tracks[i].size());
            fluttering[i] += (m.half_turns == 0.0 ? 1.0 : 0.0) / static_cast<double>(tracks[i].size());
        }
        const std::string name = with("hole", holes[i], "d");
        result.show(name + ": share of the time tumbling", tumbling[i]);
        result.show(name + ": share that never turns over", fluttering[i]);
        plots.push_back(side_view("Disc, " + name, tracks[i], 4, 3.0, 0.7, {Vector3d::UnitX(), 0.1, 12}));
    }
    result.add("no hole: share of the time tumbling", Rule::at_least, tumbling.front(), 0.5, 0.0);
    result.add("hole 0.8 d: share that never turns over (flutters)", Rule::at_least, fluttering.back(), 0.8, 0.0);
    // Between tumbling and flutter discs are chaotic, so the tumbling share need not fall with every step.
    double most = 0.0;
    for (size_t i = 0; i < holes.size(); ++i)
        if (holes[i] >= 0.5) most = std::max(most, tumbling[i]);
    result.add("holes of 0.5 d and more: largest time tumbling, over that without a hole", Rule::at_most,
               most / tumbling.front(), 0.5, 0.0);
    LinePlot shares{"Share of the time tumbling", "hole over diameter", "share"};
    shares.from_zero = true;
    Series line{"", "#1f5fa8", {}};
    line.marker = Marker::disc;
    for (size_t i = 0; i < holes.size(); ++i) line.points.push_back({holes[i], tumbling[i]});
    shares.series.push_back(std::move(line));
    plots.push_back(std::move(shares));
    result.pictures.push_back(
        {"holes.svg", draw(plots, 3), "Discs of 40 mm with a hole, any release; strokes: a diameter, enlarged."});
    return result;
}

namespace {

// Means over the falls that turn steadily about the body's y axis while it is about level.
struct Turning {
    double share = 0.0, spin = 0.0, down = 0.0, sideways = 0.0; // rad/s, m/s
    double speed() const { return std::hypot(down, sideways); }
    double angle() const { return std::atan2(down, sideways) / degree; } // below the horizontal
};

Turning turning_of(const std::vector<Track>& tracks) {
    Turning sum;
    double turn = 0.0;
    for (const Track& t : tracks) {
        const std::span<const Sample> end = end_of(t.samples, judged);
        double spin = 0.0, square = 0.0, steep = 0.0;
        Vector3d velocity = Vector3d::Zero();
        for (const Sample& s : end) {
            const Vector3d length = s.orientation * Vector3d::UnitY();
            const double about = s.spin.dot(length);
            steep += std::abs(length.y()) / static_cast<double>(end.size());
            spin += about / static_cast<double>(end.size());
            square += about * about / static_cast<double>(end.size());
            velocity += s.velocity / static_cast<double>(end.size());
        }
        if (!(std::abs(spin) > 0.7 * std::sqrt(square)) || steep > 0.5) continue;
        turn += 1.0;
        sum.spin += std::abs(spin);
        sum.down -= velocity.y();
        sum.sideways += std::hypot(velocity.x(), velocity.z());
    }
    if (turn > 0.0)
        sum = {turn / static_cast<double>(tracks.size()), sum.spin / turn, sum.down / turn, sum.sideways / turn};
    return sum;
}

// Speed of a long edge over that of the fall, of autorotating plates (Iversen 1979). aspect: length over width.
double tip_speed_of_plates(double aspect) {
    const double slope = aspect / (2.0 + std::sqrt(4.0 + aspect * aspect));
    return std::pow(slope * (2.0 - std::pow(aspect / (aspect + 0.595), 0.76)), 2.0 / 3.0);
}

// A playing card let go from rest, its long side (body y) level, with a hand's tilt of up to 3 degrees: broadside, or held upright.
std::vector<Start> let_go(uint32_t count, uint64_t seed, bool upright) {
    std::vector<Start> starts = released_anyhow(count, seed); // for their places
    Random random(seed + 1);
    const Vector3d above = upright ? Vector3d::UnitX() : Vector3d::UnitZ();
    const auto held = Eigen::Quaterniond::FromTwoVectors(above, up());
    for (Start& s : starts) {
        const Vector3d axis = random.orientation() * Vector3d::UnitX();
        s.orientation = Eigen::AngleAxisd(random.real(-3.0, 3.0) * degree, axis) * held;
    }
    return starts;
}

// Median distance from below the release to where the fall has gone this far down.
double landing_distance(const std::vector<Track>& tracks, double height) {
    std::vector<double> distances;
    for (const Track& t : tracks) {
        const std::span<const Sample> fall = fallen(t, height);
        if (fall.empty()) { // not finite
            distances.push_back(HUGE_VAL);
            continue;
        }
        const Vector3d way = fall.back().position - fall.front().position;
        distances.push_back(std::hypot(way.x(), way.z()));
    }
    std::sort(distances.begin(), distances.end());
    return quantile(distances, 0.5);
}
} // namespace

RowResult run_strips(const Context& context) {
    RowResult result;
    struct Strip {
        double aspect, rise;
        bool checked = true; // false: a known weakness, many fall end first
    };
    static constexpr std::array<Strip, 8> strips{
        {{2.0, 0.0}, {3.0, 0.0}, {4.0, 0.0}, {6.0, 0.0}, {10.0, 0.0}, {5.0, 0.1}, {8.0, 0.1, false}, {12.0, 0.05}}};
    const double width = 0.02, areal = 0.08; // m, kg/m^2
    std::array<std::vector<Track>, strips.size()> tracks;
    context.parallel(strips.size(), [&](size_t i) {
        const Asset body = bake_strip(width, strips[i].aspect * width, strips[i].rise, areal);
        tracks[i] = drop(context, body, 6.0, 68);
    });
    std::array<Turning, strips.size()> turning;
    std::vector<LinePlot> plots;
    for (size_t i = 0; i < strips.size(); ++i) {
        const Strip& strip = strips[i];
        const Turning& t = turning[i] = turning_of(tracks[i]);
        char name[64];
        std::snprintf(name, sizeof name, strip.rise > 0.0 ? "%g:1, bent to a rise of %g" : "%g:1", strip.aspect,
                      strip.rise);
        const std::string of = name;
        plots.push_back(side_view("Strip " + of, tracks[i], 5, 2.5, 1.0, {Vector3d::UnitX(), 0.1, 1}));
        const std::string share = of + ": share that turns about its length";
        if (strip.checked)
            result.add(share, Rule::at_least, t.share, 0.75, 0.0);
        else
            result.show(share, t.share, "");
        result.show(of + ": descent of those", t.down, "m/s");
        result.show(of + ": horizontal speed", t.sideways, "m/s");
        result.show(of + ": turns a second", t.spin / (2.0 * pi), "/s");
        if (strip.rise > 0.0) continue;
        result.add(of + ": speed of its edges over that of the fall", Rule::relative, 0.5 * width * t.spin / t.speed(),
                   tip_speed_of_plates(strip.aspect), 0.2);
    }
    const Turning &shortest = turning[0], &longest = turning[4];
    // Wang et al.: with the aspect ratio descent and angle fall, spin and horizontal speed grow.
    result.add("10:1 over 2:1: descent", Rule::at_most, longest.down / shortest.down, 1.0, 0.0);
    result.add("10:1 over 2:1: angle below the horizontal", Rule::at_most, longest.angle() / shortest.angle(), 1.0,
               0.0);
    result.add("10:1 over 2:1: spin", Rule::at_least, longest.spin / shortest.spin, 1.0, 0.0);
    result.add("10:1 over 2:1: horizontal speed", Rule::at_least, longest.sideways / shortest.sideways, 1.0, 0.0);
    const double pressure = 0.5 * Fluid{}.density * longest.speed() * longest.speed();
    const double weight = areal * 9.81 / (pressure * longest.speed());
    result.add("10:1: mean lift coefficient", Rule::relative, weight * longest.sideways, 2.2, 0.25);
    result.add("10:1: mean drag coefficient", Rule::relative, weight * longest.down, 1.6, 0.25);
    // The old trick: cards that are held flat drop into a hat, cards that are held upright turn and glide past it.
    const Asset card = bake_strip(0.063, 0.088, 0.0, 0.32);
    std::array<std::vector<Track>, 2> dropped;
    context.parallel(2, [&](size_t i) {
        dropped[i] = record(card, game_run(context, 4, 2.5), let_go(context.quick ? 50 : 200, 69, i == 1));
    });
    const double flat = landing_distance(dropped[0], 1.5), upright = landing_distance(dropped[1], 1.5);
    result.add("playing card held upright: share that turns about its length", Rule::at_least,
               turning_of(dropped[1]).share, 0.6, 0.0);
    result.add("playing card held flat, 1.5 m down: lands beside the hand", Rule::at_most, flat, 0.2, 0.0, "m");
    result.add("held upright: as many times as far", Rule::at_least, upright / flat, 2.0, 0.0);
    result.pictures.push_back({"strips.svg", draw(plots, 4, {380.0, 420.0}),
                               "Paper strips 2 cm wide, any release; strokes: the width, enlarged."});
    return result;
}

RowResult run_cross(const Context& context) {
    RowResult result;
    const double length = 0.06, width = 0.012, area = 2.0 * length * width - width * width, areal = 0.1;
    const double radius = std::sqrt(area / pi);
    std::array<std::vector<Track>, 2> tracks; // cross, disc
    std::array<lr_asset_info, 2> info{};
    context.parallel(2, [&](size_t i) {
        const Asset body = i == 0 ? bake_cross(length, width, areal) : bake_disc(radius, 1e-4, areal, Fluid{});
        info[i] = info_of(body);
        tracks[i] = drop(context, body, 6.0, 66);
    });
    result.add("mass over the disc's", Rule::relative, info[0].mass / info[1].mass, 1.0, 2e-3);
    static constexpr std::array<const char*, 2> names{"cross", "disc of its area"};
    std::array<Statistic, 2> descent, sideways, across; // across: rad/s about horizontal axes
    std::vector<LinePlot> plots;
    for (size_t i = 0; i < 2; ++i) {
        std::vector<double> speed, rate;
        for (const Track& t : tracks[i]) {
            double path = 0.0, turned = 0.0;
            const std::span<const Sample> end = end_of(t.samples, judged);
            for (const Sample& s : end) {
                path += std::hypot(s.velocity.x(), s.velocity.z()) / static_cast<double>(end.size());
                turned += std::hypot(s.spin.x(), s.spin.z()) / static_cast<double>(end.size());
            }
            speed.push_back(path);
            rate.push_back(turned);
        }
        descent[i] = mean_descent(tracks[i], judged);
        sideways[i] = summarise(std::move(speed));
        across[i] = summarise(std::move(rate));
        const std::string name = names[i];
        result.show(name + ": descent", descent[i].mean, "m/s");
        result.show(name + ": horizontal speed", sideways[i].mean, "m/s");
        result.show(name + ": rate about horizontal axes", across[i].mean, "rad/s");
        plots.push_back(side_view("From any release: " + name, tracks[i], 5, 3.0, 0.6, {Vector3d::UnitX(), 0.1, 3}));
    }
    // Known: a cross sheds eddies of the width of its bars and meets the air far from its middle, so it turns more slowly than a compact disc of its
    // area and mass. The speed of this one was not measured.
    result.add("rate about horizontal axes, over the disc's", Rule::at_most, across[0].mean / across[1].mean, 0.8, 0.0);
    result.pictures.push_back({"cross.svg", draw(plots, 2),
                               "A cross of two bars and a disc of its area and mass; strokes: the bar, enlarged."});
    return result;
}

RowResult run_snow(const Context& context) {
    RowResult result;
    const Asset crystal = bake_snow_crystal(3e-3);
    const std::vector<Track> tracks = drop(context, crystal, 8.0, 67);
    std::vector<double> rocking;
    for (const Track& t : tracks) { // standard deviation of the normal's horizontal part
        const std::span<const Sample> end = end_of(t.samples, judged);
        Vector3d mean = Vector3d::Zero();
        double squares = 0.0;
        for (const Sample& s : end) mean += normal_of(s) / static_cast<double>(end.size());
        for (const Sample& s : end) {
            const Vector3d off = normal_of(s) - mean;
            squares += (off.x() * off.x() + off.z() * off.z()) / static_cast<double>(end.size());
        }
        rocking.push_back(std::asin(std::min(1.0, std::sqrt(squares))) / degree);
    }
    const Statistic rocks = summarise(std::move(rocking));
    result.show("mass", 1e9 * info_of(crystal).mass, "ug");
    result.add("descent", Rule::relative, mean_descent(tracks, judged).mean, 0.31, 0.2, "m/s");
    result.add("mean tilt", Rule::at_most, mean_tilt(tracks), 15.0, 0.0, "deg");
    result.add("rocks: standard deviation of the tilt, median", Rule::at_least, rocks.p50, 0.2, 0.0, "deg");
    result.add("rocks: standard deviation of the tilt, 95 %", Rule::at_most, rocks.p95, 20.0, 0.0, "deg");
    std::vector<LinePlot> plots{
        side_view("Snow crystal of 3 mm, any release", tracks, 5, 0.12, 0.02, {Vector3d::UnitX(), 0.005, 1})};
    LinePlot tilt{"Tilt", "time (s)", "tilt (degrees)"};
    for (size_t i = 0; i < std::min<size_t>(4, tracks.size()); ++i) {
        Series line{"", i % 2 ? "#2e7d43" : "#1f5fa8", {}};
        line.width = 1.0;
        for (size_t n = 0; n < tracks[i].samples.size(); ++n)
            line.points.push_back({tracks[i].interval * static_cast<double>(n), tilt_of(tracks[i].samples[n])});
        tilt.series.push_back(std::move(line));
    }
    plots.push_back(std::move(tilt));
    result.pictures.push_back({"snow.svg", draw(plots, 2), "Snow crystals; strokes: two opposite arms, enlarged."});
    return result;
}
} // namespace lr::scorecard
