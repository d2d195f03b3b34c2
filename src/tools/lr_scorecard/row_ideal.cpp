// Rows without turbulence: Kirchhoff's equations, symmetry, buoyancy.
#include "tools/falls/random.h"
#include "tools/falls/statistics.h"
#include "tools/lr_scorecard/fall_recording.h"
#include "tools/lr_scorecard/measured_bodies.h"
#include "tools/lr_scorecard/row.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lr::scorecard {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr std::array<LoadChoice, 2> integrators() {
    return {{{"RK4", LR_INTEGRATOR_RK4}, {"splitting", LR_INTEGRATOR_SPLITTING}}};
}

// Mass of the body plus added mass, order vx vy vz wx wy wz.
Matrix6 mass_matrix(const lr_asset_info& info) {
    Matrix6 m = Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(info.added_mass);
    m.topLeftCorner<3, 3>() += info.mass * Eigen::Matrix3d::Identity();
    m.bottomRightCorner<3, 3>() += Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(info.inertia);
    return m;
}

struct Invariants {
    double energy, p, p_dot_l, p_times_l;
};

Invariants invariants(const Matrix6& mass, const Sample& s) {
    Vector6 twist;
    twist << s.orientation.conjugate() * s.velocity, s.orientation.conjugate() * s.spin;
    const Vector6 momentum = mass * twist;
    const Eigen::Vector3d p = momentum.head<3>(), l = momentum.tail<3>();
    return {0.5 * twist.dot(momentum), p.norm(), p.dot(l), p.norm() * l.norm()};
}

struct Drift {
    double energy = 0.0, p = 0.0, p_dot_l = 0.0; // relative
    std::vector<Sample> end;
};

std::vector<int32_t> simd_targets() {
    uint32_t count = 0;
    require(lr_simd_targets(nullptr, 0, &count), "lr_simd_targets");
    std::vector<int32_t> targets(count);
    require(lr_simd_targets(targets.data(), count, &count), "lr_simd_targets");
    return targets;
}

Drift drift(const Asset& asset, const Run& run) {
    const Matrix6 mass = mass_matrix(info_of(asset));
    Random random(12);
    std::vector<Start> starts(16);
    for (Start& s : starts) {
        s.orientation = random.orientation();
        for (int i = 0; i < 3; ++i) {
            s.velocity[i] = random.real(-0.2, 0.2);
            s.spin[i] = random.real(-5.0, 5.0);
        }
    }
    Drift worst;
    for (const Track& t : record(asset, run, starts)) {
        const Invariants a = invariants(mass, t.samples.front());
        for (const Sample& s : t.samples) {
            const Invariants b = invariants(mass, s);
            worst.energy = std::max(worst.energy, std::abs(b.energy / a.energy - 1.0));
            worst.p = std::max(worst.p, std::abs(b.p / a.p - 1.0));
            worst.p_dot_l = std::max(worst.p_dot_l, std::abs(b.p_dot_l - a.p_dot_l) / a.p_times_l);
        }
        worst.end.push_back(t.samples.back());
    }
    return worst;
}

// Whether all bits are equal.
bool same(const std::vector<Sample>& a, const std::vector<Sample>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Sample& x, const Sample& y) {
        return x.position == y.position && x.velocity == y.velocity && x.spin == y.spin &&
               x.orientation.coeffs() == y.orientation.coeffs();
    });
}

Run calm(double duration, double interval) {
    Run run;
    run.loads.load_model = LR_LOADS_NONE;
    run.gravity = 0.0;
    run.dt = 1.0f / 32.0f; // a power of two: its sums are exact, so samples coincide with steps
    run.duration = duration;
    run.interval = interval;
    return run;
}
} // namespace

RowResult run_kirchhoff(const Context& context) {
    RowResult result;
    const std::array<double, 3> axes{0.04, 0.02, 0.01};
    struct Body {
        const char* name;
        Asset asset;
    };
    const std::array<Body, 2> bodies{{{"diagonal", make_ellipsoid(axes, 1200.0, water)},
                                      {"full 6x6", make_ellipsoid(axes, 1200.0, water, {0.012, -0.006, 0.003})}}};
    const std::vector<int32_t> targets = simd_targets();
    std::vector<Drift> drifts(integrators().size() * bodies.size() * targets.size());
    context.parallel(drifts.size(), [&](size_t job) {
        Run run = calm(context.quick ? 2.0 : 12.0, 1.0);
        run.substeps = 64;
        run.simd_target = targets[job % targets.size()];
        run.loads.integrator = integrators()[job / targets.size() % 2].model;
        drifts[job] = drift(bodies[job / targets.size() / 2].asset, run);
    });
    // All targets give the same bits, as checked here, so only one is measured. The bound is the rounding of about 25,000 substeps;
    // docs/maintainers/numerics.md.
    int different = 0;
    for (size_t first = 0; first < drifts.size(); first += targets.size()) {
        for (size_t i = 1; i < targets.size(); ++i) different += !same(drifts[first + i].end, drifts[first].end);
        const Drift& d = drifts[first];
        const std::string which = std::string(bodies[first / targets.size() / 2].name) + ", " +
                                  integrators()[first / targets.size() % 2].name;
        result.add("drift of energy: " + which, Rule::at_most, d.energy, 1e-4, 0.0);
        result.add("drift of |p|: " + which, Rule::at_most, d.p, 1e-4, 0.0);
        result.add("drift of p.l: " + which, Rule::at_most, d.p_dot_l, 1e-4, 0.0);
    }
    std::string names;
    for (int32_t t : targets) names += (names.empty() ? "" : ", ") + std::string(lr_simd_target_name(t));
    result.add("runs whose end is another one on another instruction set", Rule::at_most, different, 0.0, 0.0);
    result.remarks.push_back("Instruction sets: " + names + ".");
    return result;
}

RowResult run_sphere(const Context&) {
    RowResult result;
    const Asset sphere = make_ellipsoid({0.05, 0.05, 0.05}, 700.0, water);
    Start start;
    start.velocity = {1.0, -0.5, 0.25};
    start.spin = {10.0, 15.0, -5.0};
    for (const LoadChoice& integrator : integrators()) {
        Run run = calm(3.0, 3.0);
        run.substeps = 32;
        run.loads.integrator = integrator.model;
        const std::vector<Track> tracks = record(sphere, run, {start});
        const Sample& end = tracks[0].samples.back();
        const double distance = (3.0 * start.velocity).norm();
        result.add("off the straight line, of the way, " + integrator.name, Rule::at_most,
                   (end.position - 3.0 * start.velocity).norm() / distance, 1e-4, 0.0);
        result.add("change of spin, relative, " + integrator.name, Rule::at_most,
                   (end.spin - start.spin).norm() / start.spin.norm(), 1e-4, 0.0);
    }
    return result;
}

RowResult run_galilean(const Context& context) {
    RowResult result;
    const Asset leaf = paper_leaf();
    Random random(3);
    std::vector<Start> still(1024); // of 64 four decide the quantile, and three can be on the edge between two motions
    for (Start& s : still) {
        s.orientation = random.orientation();
        for (int i = 0; i < 3; ++i) s.spin[i] = random.real(-5.0, 5.0);
    }
    for (const LoadChoice& integrator : integrators()) {
        Run run;
        run.loads.load_model = context.loads.model;
        run.loads.integrator = integrator.model;
        run.dt = 1.0f / 256.0f;
        run.substeps = 4;
        run.duration = run.interval = 0.5;
        const std::vector<Track> calm_air = record(leaf, run, still);
        run.wind = {3.0, 0.5, -2.0};
        std::vector<Start> carried = still;
        for (Start& s : carried) s.velocity += run.wind;
        const std::vector<Track> windy = record(leaf, run, carried);
        std::vector<double> off;
        double moved = 0.0;
        for (size_t i = 0; i < still.size(); ++i) {
            const Eigen::Vector3d a = calm_air[i].samples.back().position;
            const Eigen::Vector3d b = windy[i].samples.back().position - run.duration * run.wind;
            off.push_back((a - b).norm() / (run.duration * run.wind).norm());
            moved = std::max(moved, a.norm());
        }
        // Near the boundary of two motions a body amplifies rounding a thousandfold, in still air and in wind.
        std::sort(off.begin(), off.end());
        result.add("difference after 0.5 s, of the way of the wind, of 95 % of the bodies, " + integrator.name,
                   Rule::at_most, quantile(off, 0.95), 1e-5, 0.0);
        result.show("the same, largest, " + integrator.name, off.back());
        result.show("largest way through the air, " + integrator.name, moved, "m");
    }
    return result;
}

namespace {

// A neutrally buoyant body in still water, ballasted by `offset` along -y, released at a tilt of 0.02 about x.
Track rock(const std::array<double, 3>& axes, double offset, double duration, double interval, int32_t integrator) {
    const Asset body = make_ellipsoid(axes, water.density, water, {0.0, -offset, 0.0});
    Run run = calm(duration, interval);
    run.gravity = 9.81;
    run.dt = static_cast<float>(interval);
    run.substeps = 4;
    run.loads.integrator = integrator;
    Start start;
    start.orientation = Eigen::AngleAxisd(0.02, Eigen::Vector3d::UnitX());
    return record(body, run, {start})[0];
}

double tilt(const Sample& s) {
    return 2.0 * std::atan2(s.orientation.x(), s.orientation.w());
}
} // namespace

RowResult run_buoyancy(const Context&) {
    RowResult result;
    const std::array<double, 3> axes{0.04, 0.01, 0.02};
    const double offset = 0.004;
    // Small rocking about x: torque rho V g offset sin(angle) on the inertia of body and water about the centre of mass. Momentum along z stays zero;
    // eliminating the velocity along z gives the Schur complement.
    const lr_asset_info info = info_of(make_ellipsoid(axes, water.density, water, {0.0, -offset, 0.0}));
    const Matrix6 m = mass_matrix(info);
    const double inertia = m(3, 3) - m(3, 2) * m(2, 3) / m(2, 2);
    const double rate = std::sqrt(info.fluid_density * info.volume * 9.81 * offset / inertia);
    const double period = 2.0 * std::numbers::pi / rate;
    for (const LoadChoice& integrator : integrators()) {
        const Track stable = rock(axes, offset, 10.2 * period, period / 200.0, integrator.model);
        double first = 0.0, last = 0.0, largest = 0.0;
        int crossings = 0;
        for (size_t i = 1; i < stable.samples.size(); ++i) {
            const double a = tilt(stable.samples[i - 1]), b = tilt(stable.samples[i]);
            largest = std::max(largest, std::abs(b));
            if (a > 0.0 && b <= 0.0) {
                last = stable.interval * (static_cast<double>(i - 1) + a / (a - b));
                if (crossings++ == 0) first = last;
            }
        }
        result.add("period of rocking, buoyancy above, " + integrator.name, Rule::relative,
                   crossings > 1 ? (last - first) / (crossings - 1) : 0.0, period, 0.01, "s");
        result.add("largest tilt, of the first, " + integrator.name, Rule::at_most, largest / 0.02, 1.02, 0.0);
        const Track unstable = rock(axes, -offset, 6.0 / rate, 0.01 / rate, integrator.model);
        double most = 0.0;
        for (const Sample& s : unstable.samples) most = std::max(most, std::abs(tilt(s)));
        result.add("largest tilt, buoyancy below, " + integrator.name, Rule::at_least, most / 0.02, 50.0, 0.0);
    }
    return result;
}
} // namespace lr::scorecard
