#include "tools/falls/regime.h"
#include "tools/lr_scorecard/card_asset.h"
#include "tools/lr_scorecard/fall_recording.h"
#include "tools/lr_scorecard/falling_card.h"
#include "tools/lr_scorecard/line_plot.h"
#include "tools/lr_scorecard/row.h"

#include <array>
#include <cmath>

namespace lr::scorecard {
namespace {

constexpr double interval = 0.05;

struct Case {
    double inertia;
    Regime regime;
};
constexpr std::array<Case, 3> cases{{{1.1, Regime::periodic}, {1.4, Regime::tumbling}, {2.2, Regime::chaotic}}};

CardState released() {
    CardState s;
    s.angle = 0.3;
    return s;
}

Regime regime_of(const std::vector<CardState>& states) {
    const std::vector<Eigen::Vector3d> all = normals(states);
    return classify(std::span(all).subspan(all.size() / 2), up());
}

std::string name_of(Regime r) {
    return regime_names[static_cast<size_t>(r)];
}

// The same fall in the library, in the model's units.
std::vector<CardState> fall_in_library(const CardModel& model, double duration) {
    const CardBody card = make_card(model);
    const double second = card.length / card.speed; // the model's unit of time
    Run run;
    run.loads.load_model = LR_LOADS_AERODYNAMIC;
    run.loads.noise_gain = 0.0f;
    run.gravity = card.gravity;
    run.dt = static_cast<float>(interval * second);
    run.substeps = 8;
    run.interval = interval * second;
    run.duration = duration * second;
    Start start;
    start.orientation = Eigen::AngleAxisd(released().angle, Eigen::Vector3d::UnitZ());
    std::vector<CardState> states;
    double angle = released().angle;
    const std::vector<Track> tracks = record(card.asset, run, {start});
    for (const Sample& s : tracks[0].samples) {
        const Eigen::Vector3d chord = s.orientation * Eigen::Vector3d::UnitX();
        angle += std::remainder(std::atan2(chord.y(), chord.x()) - angle, 2.0 * std::numbers::pi);
        const Eigen::Vector3d v = s.orientation.conjugate() * s.velocity / card.speed;
        states.push_back(
            {v.x(), v.y(), s.spin.z() * second, angle, s.position.x() / card.length, s.position.y() / card.length});
    }
    return states;
}

void compare_means(RowResult& result, const std::string& who, const CardMeans& m) {
    // The release decides the direction of tumbling; V_x and w change sign together.
    const double side = m.w < 0.0 ? -1.0 : 1.0;
    result.add(who + ", I* = 1.4: mean V_x", Rule::relative, side * m.vx, 0.756, 0.01);
    result.add(who + ", I* = 1.4: mean V_y", Rule::relative, m.vy, -0.327, 0.01);
    result.add(who + ", I* = 1.4: mean spin", Rule::relative, side * m.w, 0.489, 0.01);
}

Series path(const std::string& name, const std::string& color, const std::vector<CardState>& states, double duration) {
    Series s{name, color, {}};
    for (size_t i = 0; i < std::min(states.size(), static_cast<size_t>(duration / interval)); ++i)
        s.points.push_back({states[i].x, states[i].y});
    return s;
}
} // namespace

RowResult run_card(const Context& context) {
    RowResult result;
    const double duration = context.quick ? 400.0 : 1600.0;
    std::vector<LinePlot> plots;
    for (const Case& c : cases) {
        CardModel model;
        model.inertia = c.inertia;
        const std::string which = ", I* = " + std::to_string(c.inertia).substr(0, 3);
        const std::vector<CardState> states = fall(model, released(), duration, interval, 0.005);
        const Regime regime = regime_of(states);
        result.add("model integrated here" + which + ": is " + name_of(c.regime) + " (found " + name_of(regime) + ")",
                   Rule::at_least, regime == c.regime, 1.0, 0.0);
        if (c.regime == Regime::tumbling) compare_means(result, "model integrated here", means(states, interval));
        LinePlot plot{"Falling card" + which, "x/a", "y/a"};
        plot.equal_scale = true;
        plot.series.push_back(path("model", "#1f5fa8", states, 60.0));
        const std::vector<CardState> ours = fall_in_library(model, duration);
        const Regime found = regime_of(ours);
        result.add("library" + which + ": is " + name_of(c.regime) + " (found " + name_of(found) + ")", Rule::at_least,
                   found == c.regime, 1.0, 0.0);
        if (c.regime == Regime::tumbling) compare_means(result, "library", means(ours, interval));
        // The first few swings, before instability separates library and model.
        const auto early = static_cast<size_t>(10.0 / interval);
        result.add("library" + which + ": off the model after 10 a/V, in a", Rule::at_most,
                   std::hypot(ours[early].x - states[early].x, ours[early].y - states[early].y), 0.05, 0.0);
        plot.series.push_back(path("library", "#b5402a", ours, 60.0));
        plot.series.back().dashed = true;
        plots.push_back(std::move(plot));
        if (context.progress) context.progress(static_cast<double>(plots.size()) / cases.size());
    }
    result.pictures.push_back({"card.svg", draw(plots, 3), "Falling cards in two dimensions, in semi-chords."});
    return result;
}
} // namespace lr::scorecard
