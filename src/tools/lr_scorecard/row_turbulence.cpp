// Rows for turbulence: the baker's tables and the runtime's Langevin velocity.
#include "tools/lr_scorecard/fall_recording.h"
#include "tools/lr_scorecard/line_plot.h"
#include "tools/lr_scorecard/measured_bodies.h"
#include "tools/lr_scorecard/row.h"

#include "baker/turbulence/turbulence.h" // homogeneous shear is not part of a bake

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <stdexcept>

namespace lr::scorecard {
namespace {

constexpr double c_mu = 0.09, c2 = 1.92, c1 = 1.44;

struct Table {
    double dt, u0, l;                 // s, m/s, m
    std::vector<double> chi, epsilon; // 1/s, m^2/s^3
    double max_divergence;
};

Table table_of(const langevin_rigid::BakeResult& result) {
    const lr_asset_info info = info_of(load(result));
    const nlohmann::json turbulence = nlohmann::json::parse(result.report).at("turbulence");
    return {info.turbulence_dt,
            info.u0,
            info.length_l,
            turbulence.at("chi"),
            turbulence.at("epsilon"),
            turbulence.at("max_divergence")};
}

langevin_rigid::BakeResult bake_leaf(std::array<uint32_t, 3> grid, bool wake) {
    langevin_rigid::BakeOptions options = sheet_options(1e-4, 0.07, Fluid{});
    options.grid = grid;
    options.wake = wake;
    return disc_mesh(0.04, 10).bake(options);
}

void check_shear(RowResult& result) {
    baker::TurbulenceOptions o;
    o.u0 = 0.74;
    o.length_l = 0.02;
    o.length_d = 0.08;
    o.viscosity = 1.5e-5;
    o.cells = {120, 8, 8};
    o.domain_lengths = {60.0, 2.0, 2.0};
    o.intensity = 0.1;
    o.diffusion = false; // the slip walls would diffuse the shear away
    const double shear = 0.8 * o.u0 / o.length_d;
    o.initial_velocity = [&](const std::array<double, 3>& p) {
        return std::array<double, 3>{o.u0 + shear * (p[1] - o.length_d), 0.0, 0.0};
    };
    o.duration_star = 43.0 * o.length_d / o.length_l; // just before the parcel leaves the domain
    baker::TurbulenceTable table;
    Faults faults;
    if (!baker::compute_turbulence_table(o, table, faults)) throw std::runtime_error("the shear table failed");
    result.add("homogeneous shear: P/epsilon in the end", Rule::relative,
               c_mu * shear * shear / std::pow(table.chi.back(), 2.0), (c2 - 1.0) / (c1 - 1.0), 0.01);
    result.add("homogeneous shear: divergence d/U0", Rule::at_most, table.max_divergence, 1e-9, 0.0);
}
} // namespace

RowResult run_k_epsilon(const Context& context) {
    RowResult result;
    const Table t = table_of(bake_leaf({32, 32, 16}, false));
    double gap_k = 0.0, gap_chi = 0.0;
    for (size_t i = 0; i < t.chi.size(); ++i) {
        const double growth = 1.0 + (c2 - 1.0) * t.chi[0] * t.dt * static_cast<double>(i);
        const double k0 = t.epsilon[0] / t.chi[0], k = t.epsilon[i] / t.chi[i];
        gap_k = std::max(gap_k, std::abs(k / (k0 * std::pow(growth, -1.0 / (c2 - 1.0))) - 1.0));
        gap_chi = std::max(gap_chi, std::abs(t.chi[i] * growth / t.chi[0] - 1.0));
    }
    result.add("uniform inflow: k off its closed form", Rule::at_most, gap_k, 1e-3, 0.0);
    result.add("uniform inflow: chi off its closed form", Rule::at_most, gap_chi, 1e-3, 0.0);
    // Eq. 18 with l, a length of the body: chi0 = C_mu^(3/4) sqrt(3/2) U0/l.
    result.add("chi0 l/U0", Rule::relative, t.chi[0] * t.l / t.u0, std::pow(c_mu, 0.75) * std::sqrt(1.5), 1e-3);
    if (context.progress) context.progress(0.1);
    const Table finer = table_of(bake_leaf({64, 64, 32}, false));
    result.add("cell halved: chi0 over chi0", Rule::relative, finer.chi[0] / t.chi[0], 1.0, 1e-6);
    check_shear(result);
    if (context.progress) context.progress(0.5);
    const Table wake = table_of(bake_leaf({32, 32, 16}, true));
    result.add("body in the stream: divergence d/U0", Rule::at_most, wake.max_divergence, 1e-6, 0.0);
    return result;
}

namespace {

// A neutrally buoyant body follows Pope's equation for the velocity of the fluid.
struct LangevinFall {
    double chi = 4.0, epsilon = 0.6, c0 = 2.1;
    double alpha() const { return (0.5 + 0.75 * c0) * chi; }
    double variance() const { return 2.0 / 3.0 * epsilon / chi * 1.5 * c0 / (1.0 + 1.5 * c0); }

    void configure(lr_world* world, lr_batch batch) const {
        const float chis[1] = {static_cast<float>(chi)}, epsilons[1] = {static_cast<float>(epsilon)};
        lr_turbulence_table t = initialised(lr_turbulence_table_init);
        t.count = 1;
        t.chi = chis;
        t.epsilon = epsilons;
        t.dt = 1.0f;
        t.u0 = 1.0f;
        t.l = 0.01f;
        t.c0 = static_cast<float>(c0);
        require(lr_batch_set_turbulence_table(world, batch, &t), "lr_batch_set_turbulence_table");
    }
};
} // namespace

RowResult run_langevin(const Context& context) {
    RowResult result;
    const LangevinFall fall;
    const Asset sphere = make_ellipsoid({0.02, 0.02, 0.02}, water.density, water);

    const double t_correlation = 1.0 / fall.alpha();
    const int lags = 4; // up to two correlation times, in steps of half a time
    const int rounds = context.quick ? 30 : 120;
    Run run;
    run.loads.load_model = LR_LOADS_LANGEVIN;
    run.loads.clock = LR_CLOCK_AGE;
    run.loads.configure = [&](lr_world* w, lr_batch b) { fall.configure(w, b); };
    run.gravity = 0.0;
    run.dt = static_cast<float>(0.5 * t_correlation);
    run.substeps = 20;
    run.interval = static_cast<double>(run.dt);
    // From 4 times after the start at rest, when exp(-8) of the variance is missing.
    run.duration = (8 + rounds) * 0.5 * t_correlation;
    run.threads = context.threads;
    const std::vector<Track> tracks = record(sphere, run, std::vector<Start>(4096));

    std::array<double, 3> square{};
    std::vector<double> lagged(lags + 1, 0.0), points(lags + 1, 0.0);
    double n = 0.0;
    for (const Track& t : tracks)
        for (size_t i = 8; i < t.samples.size(); ++i) {
            n += 1.0;
            for (int a = 0; a < 3; ++a) square[static_cast<size_t>(a)] += std::pow(t.samples[i].velocity[a], 2.0);
            for (size_t lag = 0; lag <= lags && i + lag < t.samples.size(); ++lag) {
                lagged[lag] += t.samples[i].velocity.dot(t.samples[i + lag].velocity) / 3.0;
                points[lag] += 1.0;
            }
        }
    static constexpr const char* names[] = {"x", "y", "z"};
    for (size_t a = 0; a < 3; ++a)
        result.add(std::string("variance of v_") + names[a], Rule::relative, square[a] / n, fall.variance(), 0.02,
                   "m2/s2");
    const double all = lagged[0] / points[0];
    for (size_t lag = 1; lag <= lags; ++lag)
        result.add("autocorrelation after " + std::to_string(lag) + "/2 of 1/alpha", Rule::absolute,
                   lagged[lag] / points[lag] / all, std::exp(-0.5 * static_cast<double>(lag)), 0.01);
    return result;
}

RowResult run_tables(const Context&) {
    RowResult result;
    // The paper's leaf, 4 x 1 x 0.01 cm in air, gives its Re of 3.8e3 in its own units (docs/maintainers/physics.md, errata).
    langevin_rigid::BakeOptions options;
    options.unit = langevin_rigid::Unit::metre;
    options.density = 800.0;
    options.fluid_viscosity = 1.5e-5;
    options.grid = {32, 32, 16};
    lr_asset_info info = info_of(load(langevin_rigid::bake_ellipsoid({0.04, 0.01, 5e-5}, options)));
    options.fluid_viscosity *= info.reynolds / 3.8e3;
    const langevin_rigid::BakeResult bake = langevin_rigid::bake_ellipsoid({0.04, 0.01, 5e-5}, options);
    info = info_of(load(bake));
    const Table t = table_of(bake);
    result.add("Reynolds number", Rule::relative, info.reynolds, 3.8e3, 1e-3);
    const size_t half = t.chi.size() / 2;
    result.add("epsilon falls: end over begin", Rule::at_most, t.epsilon.back() / t.epsilon[0], 0.5, 0.0);
    result.add("chi falls: middle over begin", Rule::at_most, t.chi[half] / t.chi[0], 1.0, 0.0);
    result.show("chi at first", t.chi[0], "1/s");
    result.show("epsilon at first", t.epsilon[0], "m2/s3");
    LinePlot plot{"Turbulence table, Re 3.8e3, 32x32x16", "time (s)", "relative to the first sample"};
    Series chi{"chi", "#2e7d43", {}}, epsilon{"epsilon", "#b5402a", {}};
    for (size_t i = 0; i < t.chi.size(); ++i) {
        const double time = t.dt * static_cast<double>(i);
        chi.points.push_back({time, t.chi[i] / t.chi[0]});
        epsilon.points.push_back({time, t.epsilon[i] / t.epsilon[0]});
    }
    plot.series = {chi, epsilon};
    result.pictures.push_back({"tables.svg", draw(plot), "The paper's Fig. 2: decay along the falling leaf."});
    return result;
}
} // namespace lr::scorecard
