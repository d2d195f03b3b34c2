// Rows for steady drag and for mean speeds of fall: discs held broadside, leaves, small discs in turbulent air, solids in water.
#include "tools/falls/random.h"
#include "tools/falls/statistics.h"
#include "tools/lr_scorecard/fall_recording.h"
#include "tools/lr_scorecard/measured_bodies.h"
#include "tools/lr_scorecard/row.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace lr::scorecard {
namespace {

using std::numbers::pi;

void silence(lr_world* world, lr_batch batch) {
    lr_load_gains gains = initialised(lr_load_gains_init);
    gains.turbulence = 0.0f;
    require(lr_batch_set_load_gains(world, batch, &gains), "lr_batch_set_load_gains");
}

struct Coasting {
    double drag_coefficient = 0.0, reynolds = 0.0;
    double tilt = 0.0; // degrees, at the end
};

// A disc thousands of times denser than the air coasts broadside without gravity. Inertia keeps its orientation, and it loses so little speed that
// its wake is that of a steady stream: 1/v grows by 1/2 C_D rho S/(m + A) per second.
Coasting coast(double reynolds, int32_t load_model) {
    const double radius = 0.01, speed = 1.0, unit = 2.0 * radius / speed;
    const Fluid fluid{1.2, speed * 2.0 * radius / reynolds};
    const Asset disc = bake_disc(radius, 1e-4, 80.0, fluid);
    Run run;
    run.loads.load_model = load_model;
    run.loads.noise_gain = 0.0f;
    run.loads.configure = silence;
    run.gravity = 0.0;
    run.dt = static_cast<float>(0.05 * unit); // a shorter step would lose the deceleration in rounding
    run.duration = 200.0 * unit;
    run.interval = 100.0 * unit;
    Start start;
    start.orientation = Eigen::AngleAxisd(0.5 * pi, Eigen::Vector3d::UnitX());
    start.velocity.y() = -speed;
    const std::vector<Sample> samples = record(disc, run, {start})[0].samples;
    const Sample &middle = samples[1], &end = samples[2];
    const lr_asset_info info = info_of(disc);
    const double v1 = middle.velocity.norm(), v2 = end.velocity.norm();
    const double mass = info.mass + info.added_mass[14], area = pi * radius * radius;
    Coasting out;
    out.drag_coefficient = (1.0 / v2 - 1.0 / v1) * 2.0 * mass / (fluid.density * area * run.interval);
    out.reynolds = 0.5 * (v1 + v2) * 2.0 * radius / fluid.viscosity;
    const double cosine = std::abs((end.orientation * Eigen::Vector3d::UnitZ()).y());
    out.tilt = std::acos(std::min(1.0, cosine)) * 180.0 / pi;
    return out;
}

// Mean descent from `skip` metres below the release on.
Statistic descents(const std::vector<Track>& tracks, double skip) {
    std::vector<double> values;
    for (const Track& t : tracks) {
        const auto begin = t.samples.begin();
        const auto first = std::find_if(begin, t.samples.end() - 1,
                                        [&](const Sample& s) { return s.position.y() < begin->position.y() - skip; });
        const double frames = static_cast<double>(t.samples.end() - 1 - first);
        values.push_back((first->position - t.samples.back().position).y() / (t.interval * frames));
    }
    return summarise(std::move(values)); // a body that is too slow gives a number that is not finite
}

std::vector<Start> any_orientation(uint32_t falls) {
    Random random(51);
    std::vector<Start> starts(falls);
    for (Start& s : starts) {
        s.orientation = random.orientation();
        s.position = 2.0 * Eigen::Vector3d(random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0));
    }
    return starts;
}

// Octahedron with edges of sqrt(2) size, tetrahedron with edges of sqrt(8) size; m.
Triangles octahedron(double size) {
    Triangles mesh;
    for (size_t i = 0; i < 18; ++i) mesh.positions.push_back(i % 3 != i / 6 ? 0.0 : i / 3 % 2 == 0 ? size : -size);
    mesh.indices = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    return mesh;
}
Triangles tetrahedron(double size) {
    Triangles mesh;
    for (const double x : {1.0, 1.0, 1.0, 1.0, -1.0, -1.0, -1.0, 1.0, -1.0, -1.0, -1.0, 1.0})
        mesh.positions.push_back(size * x);
    mesh.indices = {0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2};
    return mesh;
}
// Prism along z: 4 sides of length diameter/sqrt(2), or many.
Triangles prism(uint32_t sides, double diameter, double length) {
    Triangles mesh;
    for (uint32_t i = 0; i < sides; ++i)
        for (const double end : {-0.5, 0.5}) {
            const double angle = 2.0 * pi * i / sides;
            const std::array<double, 3> at{0.5 * diameter * std::cos(angle), 0.5 * diameter * std::sin(angle),
                                           end * length};
            mesh.positions.insert(mesh.positions.end(), at.begin(), at.end());
        }
    for (uint32_t i = 0; i < sides; ++i) {
        const uint32_t a = 2 * i, b = 2 * ((i + 1) % sides);
        mesh.indices.insert(mesh.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
        if (i > 0 && i + 1 < sides) mesh.indices.insert(mesh.indices.end(), {0, b, a, 1, a + 1, b + 1});
    }
    return mesh;
}

// Drag coefficient over the section of the sphere of equal volume. Sphericity: that sphere's surface over the body's.
double drag_by_sphericity(double phi, double reynolds) {
    const double a = std::exp(2.3288 - 6.4581 * phi + 2.4486 * phi * phi), b = 0.0964 + 0.5565 * phi;
    const double c = std::exp(4.905 - 13.8944 * phi + 18.4222 * phi * phi - 10.2599 * phi * phi * phi);
    const double d = std::exp(1.4681 + 12.2584 * phi - 20.7322 * phi * phi + 15.8855 * phi * phi * phi);
    return 24.0 / reynolds * (1.0 + a * std::pow(reynolds, b)) + c / (1.0 + d / reynolds);
}

// Settling speed, m/s, of a body of this sphericity in water.
double settling_speed(double volume, double density, double phi) {
    const double d = std::cbrt(6.0 * volume / pi), weight = 9.81 * (density / water.density - 1.0) * volume;
    double speed = 0.1;
    for (int i = 0; i < 200; ++i)
        speed = 0.5 *
                (speed + std::sqrt(8.0 * weight / (pi * d * d * drag_by_sphericity(phi, speed * d / water.viscosity))));
    return speed;
}
} // namespace

RowResult run_steady_drag(const Context& context) {
    RowResult result;
    static constexpr std::array<std::array<double, 2>, 2> measured{{{2800.0, 1.17}, {80.0, 1.4}}}; // Re, C_D
    std::array<Coasting, measured.size()> at;
    context.parallel(at.size(), [&](size_t i) { at[i] = coast(measured[i][0], context.loads.model); });
    for (size_t i = 0; i < at.size(); ++i) {
        const std::string of = ", Re " + std::to_string(std::lround(at[i].reynolds));
        result.add("C_D broadside" + of, Rule::relative, at[i].drag_coefficient, measured[i][1], 0.10);
        result.add("tilt at the end of the measurement" + of, Rule::at_most, at[i].tilt, 1.0, 0.0, "deg");
    }
    return result;
}

RowResult run_leaves(const Context& context) {
    RowResult result;
    Run run;
    run.loads.load_model = context.loads.model;
    run.duration = 6.0;
    const std::vector<Start> starts = any_orientation(context.quick ? 100 : 400);
    static constexpr std::array<const char*, 2> leaves{"leaf.obj", "leaf_maple.obj"};
    std::array<Statistic, leaves.size()> descent;
    context.parallel(leaves.size(), [&](size_t i) {
        const Triangles page = upper_page(std::string(LR_SCORECARD_ASSETS "/") + leaves[i]);
        descent[i] = descents(record(load(page.bake(sheet_options(3e-4, 0.08, Fluid{}))), run, starts), 2.0);
    });
    for (size_t i = 0; i < leaves.size(); ++i) {
        result.add(std::string("mean descent after 2 m, ") + leaves[i], Rule::absolute, descent[i].mean, 1.1, 0.2,
                   "m/s");
        result.show(std::string("standard deviation of single falls, ") + leaves[i], descent[i].deviation, "m/s");
    }
    return result;
}

RowResult run_turbulence_fall(const Context& context) {
    RowResult result;
    struct Case {
        double intensity;         // u' over the speed in still air
        double slower, tolerance; // %
    };
    static constexpr std::array<Case, 3> cases{{{0.2, 2.5, 5.0}, {0.45, 10.0, 7.0}, {0.9, 35.0, 10.0}}};
    const Asset disc = disc_sinking_at(360.0, 3e-3);
    const std::vector<Start> starts = any_orientation(context.quick ? 200 : 1000);
    const auto speed = [&](double rms) {
        Run run;
        run.loads.load_model = context.loads.model;
        run.dt = 2.5e-4f;
        run.duration = 4.0;
        run.prepare = [rms](lr_world* world) {
            if (rms <= 0.0) return;
            lr_turbulence_desc d = initialised(lr_turbulence_desc_init);
            d.rms = static_cast<float>(rms);
            d.integral_length = 0.1f; // m, about that of the experiment's box
            d.octaves = 4;
            require(lr_world_add_turbulence(world, &d, nullptr), "lr_world_add_turbulence");
        };
        return descents(record(disc, run, starts), 1.0);
    };
    const Statistic still = speed(0.0);
    std::array<Statistic, cases.size()> turbulent;
    context.parallel(cases.size(), [&](size_t i) { turbulent[i] = speed(cases[i].intensity * still.mean); });
    for (size_t i = 0; i < cases.size(); ++i) {
        char what[64];
        std::snprintf(what, sizeof what, "slower than in still air, u'/U %.2f", cases[i].intensity);
        result.add(what, Rule::absolute, 100.0 * (1.0 - turbulent[i].mean / still.mean), cases[i].slower,
                   cases[i].tolerance, "%");
        result.show(std::string(what) + ", standard error", 100.0 * turbulent[i].standard_error / still.mean, "%");
    }
    result.show("speed in still air", still.mean, "m/s");
    return result;
}

RowResult run_solids(const Context& context) {
    RowResult result;
    constexpr double density = 1500.0;
    const auto solid = [&](const Triangles& mesh) {
        langevin_rigid::BakeOptions options;
        options.density = density;
        options.fluid_density = water.density;
        options.fluid_viscosity = water.viscosity;
        return load(mesh.bake(options));
    };
    struct Case {
        const char* name;
        Asset body;
        double sphericity; // of bodies with a known speed
        double tilt = 0.0; // of the axis z off the vertical (rods: 90), degrees
        Statistic descent = {};
    };
    std::array<Case, 7> cases{{{"cube", solid(prism(4, 0.0141, 0.01)), 0.806},
                               {"octahedron", solid(octahedron(0.007)), 0.846},
                               {"tetrahedron", solid(tetrahedron(0.0035)), 0.671},
                               {"cylinder as long as wide", solid(prism(24, 0.01, 0.01)), 0.874},
                               {"spheroid 2:1:1", make_ellipsoid({0.005, 0.005, 0.01}, density, water), 0.929},
                               {"rod 10:1", solid(prism(24, 0.004, 0.04)), 0.0},
                               {"spheroid 2:2:1", make_ellipsoid({0.01, 0.01, 0.005}, density, water), 0.0}}};
    Run run;
    run.loads.load_model = context.loads.model;
    run.dt = 1.0f / 240.0f;
    run.duration = 10.0;
    const std::vector<Start> starts = any_orientation(context.quick ? 100 : 300);
    context.parallel(cases.size(), [&](size_t i) {
        const std::vector<Track> tracks = record(cases[i].body, run, starts);
        cases[i].descent = descents(tracks, 1.0);
        std::vector<double> tilts;
        for (const Track& t : tracks)
            for (size_t n = t.samples.size() / 2; n < t.samples.size(); n += 20)
                tilts.push_back(
                    std::acos(std::min(1.0, std::abs((t.samples[n].orientation * Eigen::Vector3d::UnitZ()).y()))) *
                    180.0 / pi);
        cases[i].tilt = summarise(std::move(tilts)).p50;
    });
    for (const Case& c : cases) {
        const double volume = info_of(c.body).volume;
        if (c.sphericity > 0.0)
            result.add(std::string("speed, ") + c.name, Rule::relative, c.descent.mean,
                       settling_speed(volume, density, c.sphericity), 0.2, "m/s");
        else
            result.show(std::string("speed, ") + c.name, c.descent.mean, "m/s");
    }
    // They fall broadside: long axis level, short axis upright.
    result.add("rod 10:1: tilt of its axis, median", Rule::at_least, cases[5].tilt, 70.0, 0.0, "deg");
    result.add("spheroid 2:1:1: tilt of its axis, median", Rule::at_least, cases[4].tilt, 60.0, 0.0, "deg");
    result.add("spheroid 2:2:1: tilt of its axis, median", Rule::at_most, cases[6].tilt, 30.0, 0.0, "deg");
    return result;
}
} // namespace lr::scorecard
