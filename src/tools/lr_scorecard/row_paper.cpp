// The cases of the paper's section 7, with its pictures expressed as numbers.
#include "baker/eigensystem.h"
#include "tools/falls/random.h"
#include "tools/falls/regime.h"
#include "tools/falls/statistics.h"
#include "tools/lr_scorecard/fall_recording.h"
#include "tools/lr_scorecard/folded_dart.h"
#include "tools/lr_scorecard/line_plot.h"
#include "tools/lr_scorecard/measured_bodies.h"
#include "tools/lr_scorecard/row.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace lr::scorecard {
namespace {

using std::numbers::pi;
constexpr double degree = pi / 180.0;

std::vector<LoadChoice> models() {
    std::vector<LoadChoice> out{{"LANGEVIN", LR_LOADS_LANGEVIN}};
    out.push_back({"AERODYNAMIC", LR_LOADS_AERODYNAMIC});
    return out;
}

// Thin axis z up.
Eigen::Quaterniond flat() {
    return Eigen::Quaterniond(Eigen::AngleAxisd(-0.5 * pi, Eigen::Vector3d::UnitX()));
}

double share(const std::vector<bool>& seen) {
    return static_cast<double>(std::count(seen.begin(), seen.end(), true)) / static_cast<double>(seen.size());
}

struct LeafFall {
    double heading = 0.0;   // net turns of the heading, signed
    double coherence = 0.0; // net turns over total turns
    double rolls = 0.0;     // turns about the long axis, in either direction
    double overturns = 0.0; // changes of the upper side
    double reversals = 0.0; // of the path's main horizontal direction
};

// The heading is the direction of motion over `smooth` samples, so that swings of flutter do not count as turns.
LeafFall measure_leaf(const Track& track, size_t smooth) {
    LeafFall m;
    double before = 0.0, total = 0.0, net = 0.0;
    for (size_t i = 0; i + smooth < track.samples.size(); i += smooth / 4) {
        const Eigen::Vector3d displacement = track.samples[i + smooth].position - track.samples[i].position;
        const double heading = std::atan2(displacement.z(), displacement.x());
        if (i > 0) {
            const double turn = std::remainder(heading - before, 2.0 * pi);
            net += turn;
            total += std::abs(turn);
        }
        before = heading;
    }
    m.heading = net / (2.0 * pi);
    m.coherence = total > 0.0 ? std::abs(net) / total : 0.0;
    std::vector<double> along;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const Sample& s : track.samples)
        mean += Eigen::Vector2d(s.velocity.x(), s.velocity.z()) / static_cast<double>(track.samples.size());
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const Sample& s : track.samples) {
        const Eigen::Vector2d v = Eigen::Vector2d(s.velocity.x(), s.velocity.z()) - mean;
        spread += v * v.transpose();
    }
    const Eigen::Vector2d main = baker::eigensystem(spread).vectors.col(1);
    double side = 0.0;
    for (const Sample& s : track.samples) {
        m.rolls += std::abs((s.orientation.conjugate() * s.spin).x()) * track.interval / (2.0 * pi);
        along.push_back(main.dot(Eigen::Vector2d(s.position.x(), s.position.z())));
        const double now = (s.orientation * Eigen::Vector3d::UnitZ()).y();
        if (std::abs(now) < 0.1) continue;
        if (side * now < 0.0) m.overturns += 1.0;
        side = now;
    }
    m.reversals = static_cast<double>(peaks(along, 0.01).size());
    for (double& x : along) x = -x;
    m.reversals += static_cast<double>(peaks(along, 0.01).size());
    return m;
}

std::vector<double> each(const std::vector<LeafFall>& falls, double LeafFall::*member) {
    std::vector<double> out;
    for (const LeafFall& f : falls) out.push_back(f.*member);
    return out;
}

// The paths from the side and from above.
std::vector<LinePlot> paths(const std::string& title, const std::vector<Track>& tracks, size_t count) {
    static constexpr const char* colors[] = {"#1f5fa8", "#2e7d43", "#b5402a", "#7a4a9c"};
    LinePlot side{title + ", from the side", "x (m)", "y (m)"}, above{title + ", from above", "x (m)", "z (m)"};
    side.equal_scale = above.equal_scale = true;
    for (size_t i = 0; i < std::min(count, tracks.size()); ++i) {
        Series a{"", colors[i % 4], {}};
        a.width = 1.2;
        Series b = a;
        for (const Sample& s : tracks[i].samples) {
            a.points.push_back({s.position.x(), s.position.y()});
            b.points.push_back({s.position.x(), s.position.z()});
        }
        side.series.push_back(a);
        above.series.push_back(b);
    }
    return {side, above};
}

void add_leaf_case(RowResult& result, const Asset& leaf, const LoadChoice& model, double angle, uint32_t falls,
                   std::vector<LinePlot>& plots) {
    Random random(21);
    std::vector<Start> starts(falls);
    for (Start& s : starts) // the long axis points down by the angle, within a degree
        s.orientation = flat() *
                        Eigen::AngleAxisd((angle + random.real(-1.0, 1.0)) * degree, Eigen::Vector3d::UnitY()) *
                        Eigen::AngleAxisd(random.real(-1.0, 1.0) * degree, Eigen::Vector3d::UnitX());
    Run run;
    run.loads.load_model = model.model;
    run.duration = 3.0;
    run.interval = 0.005;
    const std::vector<Track> tracks = record(leaf, run, starts);
    std::vector<LeafFall> measured;
    std::vector<bool> helical, side_to_side, rolling;
    for (const Track& t : tracks) {
        const LeafFall m = measure_leaf(t, 40);
        measured.push_back(m);
        helical.push_back(std::abs(m.heading) >= 1.0 && m.coherence >= 0.5);
        side_to_side.push_back(m.overturns >= 2.0 && m.reversals >= 2.0);
        rolling.push_back(m.rolls >= 2.0);
    }
    const std::string which = model.name + ", " + std::to_string(std::lround(angle)) + " degrees: ";
    if (angle > 45.0)
        result.add(which + "share with a helix (heading turns by 1 or more, mostly one way)", Rule::at_least,
                   share(helical), 0.5, 0.0);
    else
        result.add(which + "share with side-to-side tumbling (2 overturns, 2 reversals)", Rule::at_least,
                   share(side_to_side), 0.5, 0.0);
    result.add(which + "share that rotates about the long axis (2 turns)", Rule::at_least, share(rolling), 0.5, 0.0);
    std::vector<double> turns = each(measured, &LeafFall::heading);
    for (double& t : turns) t = std::abs(t);
    result.show(which + "mean net turn of the heading in 3 s", summarise(turns).mean, "turns");
    result.show(which + "mean overturns in 3 s", summarise(each(measured, &LeafFall::overturns)).mean);
    result.show(which + "mean reversals in 3 s", summarise(each(measured, &LeafFall::reversals)).mean);
    for (LinePlot& p : paths(model.name + ", " + std::to_string(std::lround(angle)) + " degrees", tracks, 4))
        plots.push_back(std::move(p));
}
} // namespace

RowResult run_leaf(const Context& context) {
    RowResult result;
    const Asset leaf = paper_leaf();
    std::vector<LinePlot> plots;
    for (const LoadChoice& model : models())
        for (double angle : {75.0, 30.0}) add_leaf_case(result, leaf, model, angle, context.quick ? 50 : 200, plots);
    result.pictures.push_back({"leaf.svg", draw(plots, 2), "The paper's leaf, four falls a release."});
    return result;
}

RowResult run_paper_plane(const Context& context) {
    RowResult result;
    const double side = 0.083, paper = 0.08; // m, kg/m^2
    const auto bake_dart = [&](double uneven) {
        Dart dart = folded_dart(side, uneven);
        langevin_rigid::BakeOptions options = sheet_options(1e-4, paper, Fluid{});
        options.mass = langevin_rigid::BakeMass{{}, std::move(dart.layers.positions), std::move(dart.layers.indices)};
        return load(dart.surface.bake(options));
    };
    const Asset even = bake_dart(0.0), uneven = bake_dart(degree); // a fold by hand has an error of a degree
    result.add("mass of the square", Rule::relative, info_of(even).mass, paper * side * side, 1e-3, "kg");
    struct Launch {
        std::string name;
        const Asset& plane;
        int32_t loads;
    };
    const std::vector<Launch> launches{{"LANGEVIN", even, LR_LOADS_LANGEVIN},
                                       {"AERODYNAMIC", even, LR_LOADS_AERODYNAMIC},
                                       {"AERODYNAMIC, a fold 1 degree off", uneven, LR_LOADS_AERODYNAMIC}};
    Random random(31);
    std::vector<Start> starts(context.quick ? 50 : 200);
    for (Start& s : starts) {
        s.orientation = Eigen::AngleAxisd(random.real(-1.0, 1.0) * degree, Eigen::Vector3d::UnitZ()) *
                        Eigen::AngleAxisd(random.real(-1.0, 1.0) * degree, Eigen::Vector3d::UnitX()) * flat();
        s.velocity = 0.2 * (s.orientation * Eigen::Vector3d::UnitX());
    }
    std::vector<LinePlot> plots;
    for (const Launch& launch : launches) {
        Run run;
        run.loads.load_model = launch.loads;
        run.duration = 3.0;
        run.interval = 0.005;
        const std::vector<Track> tracks = record(launch.plane, run, starts);
        std::vector<double> pitches, headings;
        std::vector<bool> front, sideways;
        for (const Track& t : tracks) {
            double pitch = 0.0, heading = 0.0, net = 0.0, before = 0.0;
            bool first = true;
            for (const Sample& s : t.samples) {
                const Eigen::Vector3d nose = s.orientation * Eigen::Vector3d::UnitX();
                pitch = std::max(pitch, std::abs(std::asin(std::clamp(nose.y(), -1.0, 1.0))) / degree);
                if (std::hypot(nose.x(), nose.z()) < 0.2) continue; // upright: no heading
                const double now = std::atan2(nose.z(), nose.x());
                if (!first) net += std::remainder(now - before, 2.0 * pi) / degree;
                first = false;
                before = now;
                heading = std::max(heading, std::abs(net));
            }
            pitches.push_back(pitch);
            headings.push_back(heading);
            front.push_back(pitch >= 45.0);
            sideways.push_back(heading >= 45.0);
        }
        result.add(launch.name + ": share that turns front (nose 45 degrees up or down)", Rule::at_least, share(front),
                   0.5, 0.0);
        result.add(launch.name + ": share that turns sideways (heading by 45 degrees)", Rule::at_least, share(sideways),
                   0.5, 0.0);
        result.show(launch.name + ": largest pitch, mean", summarise(pitches).mean, "deg");
        result.show(launch.name + ": largest turn of the heading, mean", summarise(headings).mean, "deg");
        for (LinePlot& p : paths(launch.name + ", paper plane", tracks, 4)) plots.push_back(std::move(p));
    }
    result.pictures.push_back({"paper_plane.svg", draw(plots, 3), "The paper's plane, four launches."});
    return result;
}

RowResult run_rubber_ellipsoid(const Context& context) {
    RowResult result;
    const Asset ellipsoid = rubber_ellipsoid();
    Random random(41);
    std::vector<Start> starts(context.quick ? 50 : 200);
    for (Start& s : starts) {
        const double azimuth = random.real(0.0, 2.0 * pi);
        s.orientation =
            Eigen::AngleAxisd(10.0 * degree, Eigen::Vector3d(std::cos(azimuth), 0.0, std::sin(azimuth))) * flat();
    }
    std::vector<LoadChoice> with{{"no loads", LR_LOADS_NONE}};
    for (const LoadChoice& m : models()) with.push_back(m);
    LinePlot plot{"Rubber ellipsoid in water", "time (s)", "tilt of the thin axis (degrees)"};
    static constexpr const char* colors[] = {"#1f5fa8", "#2e7d43", "#b5402a"};
    double bare = 0.0;
    for (size_t i = 0; i < with.size(); ++i) {
        Run run;
        run.loads.load_model = with[i].model;
        run.duration = 3.0;
        run.interval = 0.01;
        const std::vector<Track> tracks = record(ellipsoid, run, starts);
        std::vector<double> largest, ratio;
        Series line{with[i].name, colors[i], {}};
        for (size_t t = 0; t < tracks.size(); ++t) {
            double most = 0.0;
            Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
            for (size_t n = 0; n < tracks[t].samples.size(); ++n) {
                const Eigen::Vector3d normal = tracks[t].samples[n].orientation * Eigen::Vector3d::UnitZ();
                const double tilt = std::acos(std::min(1.0, std::abs(normal.y()))) / degree;
                most = std::max(most, tilt);
                const Eigen::Vector2d h(normal.x(), normal.z());
                spread += h * h.transpose();
                if (t == 0) line.points.push_back({0.01 * static_cast<double>(n), tilt});
            }
            const Eigen::Vector2d both = baker::eigensystem(spread).values;
            largest.push_back(most);
            ratio.push_back(std::sqrt(std::max(both[0], 0.0) / both[1]));
        }
        plot.series.push_back(std::move(line));
        const Statistic tilt = summarise(largest), across = summarise(ratio);
        result.show(with[i].name + ": largest tilt in 3 s, mean", tilt.mean, "deg");
        result.show(with[i].name + ": swing across over swing along, mean", across.mean);
        if (i == 0) {
            bare = tilt.mean;
            result.add("no loads: small flutter (largest tilt, released at 10)", Rule::at_most, tilt.mean, 20.0, 0.0,
                       "deg");
        } else {
            result.add(with[i].name + ": swings farther than without loads, ratio", Rule::at_least, tilt.mean / bare,
                       1.2, 0.0);
            result.add(with[i].name + ": swings in several directions, across over along", Rule::at_least, across.mean,
                       0.3, 0.0);
        }
    }
    result.pictures.push_back({"rubber_ellipsoid.svg", draw(plot), "The paper's rubber ellipsoid: tilt of one fall."});
    return result;
}
} // namespace lr::scorecard
