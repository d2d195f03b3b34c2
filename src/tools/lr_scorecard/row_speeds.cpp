// Rows for steady drag and for mean speeds of fall: discs held broadside, leaves, small discs in turbulent air.
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

// A disc thousands of times heavier than the air around it coasts broadside, without gravity. It keeps its orientation by its
// inertia, and loses so little speed that its wake is that of a steady stream: 1/v grows by 1/2 C_D rho S/(m + A) a second.
Coasting coast(double reynolds, int32_t load_model) {
    const double radius = 0.01, speed = 1.0, unit = 2.0 * radius / speed;
    const Fluid fluid{1.2, speed * 2.0 * radius / reynolds};
    const Asset disc = bake_disc(radius, 1e-4, 80.0, fluid);
    Run run;
    run.loads.load_model = load_model;
    run.loads.noise_gain = 0.0f;
    run.loads.configure = silence;
    run.gravity = 0.0;
    run.dt = static_cast<float>(0.05 * unit); // shorter ones would lose the deceleration in rounding
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
} // namespace lr::scorecard
