#include "asset/asset_file.h"
#include "baker/asset_report.h"
#include "baker/bake.h"
#include "baker/json.h"
#include "baker/mesh/ellipsoid_mesh.h"
#include "baker/mesh/mass_properties.h"
#include "baker/mesh_shapes.h"
#include "baker/turbulence/k_epsilon.h"
#include "baker/turbulence/mean_flow.h"
#include "baker/turbulence/stream_body.h"
#include "baker/turbulence/turbulence.h"
#include "baker/turbulence/wake_history.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numeric>
#include <string>

using namespace lr;
using namespace lr::baker;

namespace {

TurbulenceOptions air(const MassProperties& p, const std::array<uint32_t, 3>& cells) {
    TurbulenceOptions o;
    o.cells = cells;
    o.u0 = 1.0;
    o.length_d = p.extents.maxCoeff();
    o.length_l = 0.2 * o.length_d;
    o.viscosity = o.length_d / 4e3;
    return o;
}

TurbulenceOptions in_stream(const Mesh& mesh, const std::array<uint32_t, 3>& cells) {
    const MassProperties p = compute_mass_properties(mesh);
    TurbulenceOptions o = air(p, cells);
    Faults faults;
    REQUIRE(put_in_stream(mesh, p.axes, p.projected_areas, o, faults));
    REQUIRE(faults.empty());
    return o;
}

TurbulenceTable make(const TurbulenceOptions& o) {
    TurbulenceTable table;
    Faults faults;
    REQUIRE(compute_turbulence_table(o, table, faults));
    REQUIRE(faults.empty());
    return table;
}

size_t count(const std::vector<uint8_t>& flags) {
    return std::accumulate(flags.begin(), flags.end(), size_t{0});
}

double relative(double a, double b) {
    return std::abs(a / b - 1.0);
}

// Measurements while the flow around a body develops, in units of U0 and l.
struct Flow {
    MeanFlow mean;
    KEpsilon turbulence;
    Flow(const TurbulenceOptions& o, int steps, double dt) : mean(make_mean(o)), turbulence(make_turbulence(o)) {
        std::vector<double> viscosity;
        turbulence.follow(mean.grid, dt);
        for (int n = 0; n < steps; ++n) {
            turbulence.eddy_viscosity(viscosity);
            REQUIRE(mean.step(dt, &viscosity));
            turbulence.follow(mean.grid, dt);
            turbulence.step(dt);
            turbulence.diffuse(dt, 1e-4);
        }
    }
    static MacGrid make_grid(const TurbulenceOptions& o) {
        const double d = o.length_d / o.length_l;
        MacGrid grid(o.cells, {o.domain_lengths[0] * d, o.domain_lengths[1] * d, o.domain_lengths[2] * d});
        for (double& u : grid.velocity[0].values) u = 1.0;
        grid.set_solid(o.solid, o.closed_faces);
        return grid;
    }
    static MeanFlow make_mean(const TurbulenceOptions& o) { return MeanFlow(make_grid(o), 1e-8); }
    static KEpsilon make_turbulence(const TurbulenceOptions& o) {
        return KEpsilon(make_grid(o), shape::inflow_state(1.0, o.intensity, 1.0));
    }
};

} // namespace

TEST_CASE("a body stands broadside in the stream, whatever the axes of its mesh") {
    const Mesh flat = test::leaf(20, 6, 0.01, 0.0);
    const TurbulenceOptions o = in_stream(flat, {32, 32, 16});
    // Long axis along y, the other across z: four times the extents each, in lengths of the leaf.
    CHECK(o.domain_lengths[1] == doctest::Approx(4.0));
    CHECK(o.domain_lengths[2] == doctest::Approx(4.0 * 0.35));
    const double height = o.body_box[1][2] - o.body_box[0][2];
    CHECK(height == doctest::Approx(0.7));
    // The closed faces across the stream cover its outline.
    const MassProperties p = compute_mass_properties(flat);
    const double face = o.domain_lengths[1] * o.domain_lengths[2] * o.length_d * o.length_d / (32.0 * 16.0);
    CHECK(static_cast<double>(count(o.closed_faces[0])) * face == doctest::Approx(p.max_projected_area).epsilon(0.1));
    Mesh turned = flat;
    test::apply(turned, test::some_rotation(), {0.3, -2.0, 5.0});
    const TurbulenceOptions again = in_stream(turned, {32, 32, 16});
    for (size_t a = 0; a < 3; ++a) CHECK(again.domain_lengths[a] == doctest::Approx(o.domain_lengths[a]).epsilon(1e-6));
    CHECK(count(again.closed_faces[0]) == count(o.closed_faces[0]));
}

TEST_CASE("a flat plate is one layer of faces on any grid, however thin") {
    for (const double thickness : {1e-2, 1e-7})
        for (const uint32_t nx : {30u, 32u, 33u, 50u}) {
            const TurbulenceOptions o = in_stream(test::box({thickness, 1.0, 0.5}, {1, 2, 2}), {nx, 32, 16});
            CHECK(count(o.closed_faces[0]) == 8 * 4);
            CHECK(count(o.closed_faces[1]) + count(o.closed_faces[2]) == 0);
        }
}

TEST_CASE("the wake of a plate: momentum is missing behind it, shear feeds k, and all of it is symmetric") {
    TurbulenceOptions o = in_stream(test::box({0.01, 1.0, 0.5}, {1, 2, 2}), {32, 16, 16});
    o.intensity = 0.3;
    const double d = 5.0; // in l
    const Flow flow(o, 60, 0.35);
    const MacGrid& g = flow.mean.grid;
    const double x = 0.5 * (o.body_box[0][0] + o.body_box[1][0]) / o.length_l;
    const double y = 2.0 * d, z = 1.0 * d;
    // Backflow right behind, less than U0 further down, more beside.
    CHECK(g.velocity_at({x + 0.2 * d, y, z})[0] < 0.3);
    CHECK(g.velocity_at({x + 1.0 * d, y, z})[0] < 0.8);
    CHECK(g.velocity_at({x + 0.2 * d, y + 1.2 * d, z})[0] > 1.0);
    // Inflow equals outflow.
    const GridField& u = g.velocity[0];
    double flux_in = 0.0, flux_out = 0.0;
    const auto i_out = static_cast<uint32_t>((x + 1.5 * d) * u.inverse_spacing[0]);
    for (uint32_t k = 0; k < 16; ++k)
        for (uint32_t j = 0; j < 16; ++j) {
            flux_in += u.values[u.index(0, j, k)];
            flux_out += u.values[u.index(i_out, j, k)];
        }
    CHECK(flux_out == doctest::Approx(flux_in).epsilon(1e-5));

    double worst = 0.0, most = 0.0, least = 1e300, produced = 0.0, through = 0.0;
    for (uint32_t k = 0; k < 16; ++k)
        for (uint32_t j = 0; j < 16; ++j)
            for (uint32_t i = 0; i < 32; ++i) {
                const shape::TurbulenceState s = flow.turbulence.in_cell(i, j, k);
                const shape::TurbulenceState m = flow.turbulence.in_cell(i, 15 - j, k);
                const shape::TurbulenceState n = flow.turbulence.in_cell(i, j, 15 - k);
                worst = std::max({worst, relative(m.k, s.k), relative(n.k, s.k), relative(m.epsilon, s.epsilon)});
                worst = std::max(worst, std::abs(u.values[u.index(i, j, k)] - u.values[u.index(i, 15 - j, 15 - k)]));
                most = std::max(most, s.k);
                least = std::min(least, s.epsilon);
                const double ratio = shape::eddy_viscosity(s) * flow.turbulence.strain_at(i, j, k) / s.epsilon;
                produced = std::max(produced, ratio);
                if (g.wall_before(0, i, j, k)) through = std::max(through, std::abs(u.values[u.index(i, j, k)]));
            }
    MESSAGE("asymmetry " << worst << ", largest k " << most << ", largest P/epsilon " << produced);
    CHECK(worst < 1e-9);
    CHECK(through == 0.0);
    CHECK(least > 0.0);
    CHECK(produced > 1.0);
    CHECK(produced < 1e3);
    // Far more k behind the edge than ahead of the plate.
    const auto at = [&](double px, double py, double pz) { return flow.turbulence.at({px, py, pz}).k; };
    CHECK(at(x + 0.5 * d, y, z + 0.25 * d) > 2.0 * at(x - 0.5 * d, y, z + 0.25 * d));
    CHECK(flow.mean.max_divergence() < 1e-6);
}

TEST_CASE("where the stream stagnates no k is made, at walls it is") {
    // Kato and Launder: plane stagnation flow has strain and no rotation. A wall switches their form on.
    MacGrid grid({16, 16, 16}, {16.0, 16.0, 16.0});
    ClosedFaces far;
    far[0].assign(4096, 0);
    far[0][grid.cell(15, 15, 15)] = 1;
    grid.set_solid({}, far);
    KEpsilon turbulence(grid, {1.0, 0.1});
    GridField &u = grid.velocity[0], &v = grid.velocity[1];
    for (uint32_t k = 0; k < 16; ++k)
        for (uint32_t j = 0; j <= 16; ++j)
            for (uint32_t i = 0; i <= 16; ++i) {
                if (j < 16) u.values[u.index(i, j, k)] = 8.0 - i;
                v.values[v.index(i, j, k)] = j - 8.0;
            }
    turbulence.follow(grid, 0.01);
    CHECK(turbulence.strain_at(7, 7, 7) < 1e-12);
    for (uint32_t k = 0; k < 16; ++k)
        for (uint32_t j = 0; j < 16; ++j)
            for (uint32_t i = 0; i <= 16; ++i) u.values[u.index(i, j, k)] = 0.5 * j;
    for (double& x : v.values) x = 0.0;
    turbulence.follow(grid, 0.01);
    CHECK(turbulence.strain_at(7, 7, 7) == doctest::Approx(0.25)); // shear is unchanged
}

TEST_CASE("tables with a wake hardly depend on the grid" * doctest::test_suite("long-exact") *
          doctest::skip(lr::test::sanitized)) {
    const auto compare = [](const Mesh& mesh, const char* name, const std::array<uint32_t, 3>& coarse,
                            const std::array<uint32_t, 3>& fine) {
        const TurbulenceTable a = make(in_stream(mesh, coarse)), b = make(in_stream(mesh, fine));
        double along = 0.0;
        for (size_t n = 8; n < a.t.size(); ++n)
            along = std::max({along, relative(a.chi[n], b.chi[n]), relative(a.epsilon[n], b.epsilon[n])});
        MESSAGE(std::string(name) << ": chi* " << a.stationary_chi_star << " and " << b.stationary_chi_star
                                  << ", epsilon* " << a.stationary_epsilon_star << " and " << b.stationary_epsilon_star
                                  << ", table within " << along);
        CHECK(a.settled);
        CHECK(b.settled);
        CHECK(relative(a.stationary_chi_star, b.stationary_chi_star) < 0.1);
        CHECK(relative(a.stationary_epsilon_star, b.stationary_epsilon_star) < 0.1);
        CHECK(a.t == b.t);
    };
    compare(test::cube(2), "cube", {16, 16, 16}, {32, 32, 32});
    compare(test::ellipsoid(0.5, 0.5, 0.5, 4), "sphere", {32, 32, 16}, {48, 48, 24});
    compare(test::leaf(20, 6, 0.01, 0.15), "leaf", {32, 32, 16}, {48, 48, 24});
}

// The table of docs/maintainers/physics.md: takes minutes, so only on request.
TEST_CASE("wake table: stationary points on three grids" * doctest::skip()) {
    const auto print = [](const char* name, const Mesh& mesh, double l) {
        for (const double intensity : {1.0, 0.1})
            for (const uint32_t depth : {2u, 1u})
                for (const uint32_t n : {32u, 64u, 96u}) {
                    if ((n == 96 || depth == 1) && intensity < 1.0) continue;
                    if (n == 96 && depth == 1) continue;
                    TurbulenceOptions o = in_stream(mesh, {n, n, n / depth});
                    o.intensity = intensity;
                    o.length_l = l * o.length_d;
                    const TurbulenceTable t = make(o);
                    std::string line = name;
                    line += " I " + std::to_string(intensity) + ", " + std::to_string(n) + "x" + std::to_string(n) +
                            "x" + std::to_string(n / depth) + ": chi* " + std::to_string(t.stationary_chi_star) +
                            ", epsilon* " + std::to_string(t.stationary_epsilon_star);
                    MESSAGE(line);
                }
    };
    // l/d from the bakes of these bodies (docs/maintainers/physics.md, "Scales").
    print("cube", test::cube(2), 0.32);
    print("sphere", test::ellipsoid(0.5, 0.5, 0.5, 4), 1.0 / 6.0);
    print("plate", test::box({0.01, 1.0, 0.5}, {1, 2, 2}), 0.15);
    print("leaf", test::leaf(40, 10, 0.01, 0.15), 0.11);
}

TEST_CASE("the wake keeps k alive, and the second run has the same bits") {
    TurbulenceOptions o = in_stream(test::leaf(20, 6, 0.01, 0.15), {32, 16, 16});
    o.intensity = 0.2;
    const TurbulenceTable wake = make(o), again = make(o);
    CHECK(wake.chi == again.chi);
    CHECK(wake.epsilon == again.epsilon);
    CHECK(wake.wake);
    CHECK(wake.settled);
    CHECK(wake.max_divergence < 1e-6);
    TurbulenceOptions empty = o;
    for (std::vector<uint8_t>& faces : empty.closed_faces) faces.clear();
    empty.duration_star = wake.t_star(wake.t.size() - 1);
    const TurbulenceTable alone = make(empty);
    CHECK_FALSE(alone.wake);
    CHECK(wake.k.back() > 1.5 * alone.k.back());
    // The runtime reads the mean of the steady part, and the table stays there.
    CHECK(wake.stationary_index > 0);
    for (size_t n = wake.stationary_index; n < wake.t.size(); ++n) {
        CHECK(relative(wake.chi_star(n), wake.stationary_chi_star) < 1e-12);
        CHECK(relative(wake.epsilon_star(n), wake.stationary_epsilon_star) < 1e-12);
    }
    CHECK(std::isfinite(wake.c0));
}

TEST_CASE("the wake makes its own turbulence: little of the inflow's intensity is left in it, and no burst" *
          doctest::test_suite("exact")) {
    TurbulenceOptions o = in_stream(test::leaf(20, 6, 0.01, 0.15), {32, 16, 16});
    std::vector<double> chi, k;
    for (const double intensity : {0.1, 0.01, 1e-6}) {
        o.intensity = intensity;
        const TurbulenceTable t = make(o);
        CHECK(t.settled);
        CHECK(*std::max_element(t.k.begin(), t.k.end()) <= 1.5);
        CHECK(*std::max_element(t.chi.begin(), t.chi.end()) * o.length_l <= 0.25);
        chi.push_back(t.stationary_chi_star);
        k.push_back(t.k.back());
    }
    MESSAGE("chi* " << chi[0] << ", " << chi[1] << ", " << chi[2] << "; k " << k[0] << ", " << k[1] << ", " << k[2]);
    CHECK(relative(chi[1], chi[0]) < 0.1);
    CHECK(relative(chi[2], chi[1]) < 0.1);
    CHECK(k[2] > 0.02);
}

TEST_CASE("bodies that leave no room, or no number, are refused, closed pockets are not") {
    const MassProperties p = compute_mass_properties(test::cube(1));
    TurbulenceTable table;
    Faults faults;
    TurbulenceOptions o = in_stream(test::cube(1), {16, 16, 16});
    for (size_t c = 0; c < 4096; c += 16) o.closed_faces[0][c + 5] = 1; // a wall across
    CHECK_FALSE(compute_turbulence_table(o, table, faults));
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].where == "turbulence.solid");

    faults.clear();
    o = in_stream(test::cube(1), {16, 16, 16});
    for (size_t a = 0; a < 3; ++a) { // a closed box around one cell far from the body
        const size_t c = (13 * 16 + 13) * 16 + 13, stride[3] = {1, 16, 256};
        o.closed_faces[a][c] = o.closed_faces[a][c + stride[a]] = 1;
    }
    CHECK(compute_turbulence_table(o, table, faults));

    faults.clear();
    o.closed_faces[1].resize(17);
    CHECK_FALSE(compute_turbulence_table(o, table, faults));
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].where == "turbulence.solid");

    const double nan = std::numeric_limits<double>::quiet_NaN();
    faults.clear();
    o = in_stream(test::cube(1), {16, 16, 16});
    o.body_box[0][1] = nan;
    CHECK_FALSE(compute_turbulence_table(o, table, faults));
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].where == "turbulence.body_box");

    // A domain that is entirely solid.
    faults.clear();
    o = in_stream(test::cube(1), {16, 16, 16});
    o.body_box = {GridPoint{-9.0, -9.0, -9.0}, GridPoint{-8.0, -8.0, -8.0}};
    CHECK_FALSE(compute_turbulence_table(o, table, faults));
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].where == "turbulence.body_box");

    Mesh broken = test::cube(1);
    broken.vertices[3][1] = nan;
    faults.clear();
    CHECK_FALSE(put_in_stream(broken, p.axes, p.projected_areas, o, faults));
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].id == FaultId::mesh_not_finite);

    // Needles and splinters fit.
    for (const Eigen::Vector3d& size : {Eigen::Vector3d(1e-7, 1.0, 1e-3), Eigen::Vector3d(1e-3, 1e-3, 1.0)}) {
        faults.clear();
        const TurbulenceTable thin = make(in_stream(test::box(size, {1, 1, 1}), {16, 16, 8}));
        CHECK(thin.chi.back() > 0.0);
        CHECK(std::isfinite(thin.epsilon.back()));
    }
}

TEST_CASE("a period is found in what repeats, and nowhere else") {
    const auto history = [](auto&& chi) {
        std::vector<shape::TurbulenceState> h;
        for (int n = 0; n < 400; ++n) h.push_back({1.0, chi(n)});
        return h;
    };
    for (const double period : {9.0, 20.0, 33.3, 90.0}) {
        const auto swing = history([&](int n) { return 1.0 + 0.2 * std::sin(6.283185307179586 * n / period); });
        CHECK(static_cast<double>(find_period(swing)) == doctest::Approx(period).epsilon(0.06));
        const WakeSummary s = summarise_wake(swing, 20);
        CHECK(s.end == WakeEnd::loop);
        CHECK(s.begin + s.count == 400);
        CHECK(s.mean.epsilon == doctest::Approx(1.0).epsilon(0.02));
        // With harmonics, and during growth.
        const auto rich = history([&](int n) {
            const double a = 6.283185307179586 * n / period;
            return 1.0 + 0.1 * (0.5 + n / 800.0) * (std::sin(a) + 0.4 * std::cos(2.0 * a));
        });
        CHECK(static_cast<double>(find_period(rich)) == doctest::Approx(period).epsilon(0.06));
    }
    CHECK(find_period(history([](int) { return 1.0; })) == 0);
    CHECK(find_period(history([](int n) { return 1.0 + 0.01 * n; })) == 0);
    CHECK(find_period(history([](int n) { return 1.0 + std::exp(-0.01 * n); })) == 0);
    uint64_t state = 5;
    CHECK(find_period(history([&](int) {
              state = state * 6364136223846793005u + 1442695040888963407u;
              return 1.0 + 1e-3 * static_cast<double>(state >> 40);
          })) == 0);
    CHECK(find_period({}) == 0);
    CHECK(find_period({{1.0, 1.0}}) == 0);

    const WakeSummary steady = summarise_wake(history([](int n) { return 2.0 + std::exp(-0.1 * n); }), 20);
    CHECK(steady.end == WakeEnd::stationary);
    CHECK(steady.mean.epsilon == doctest::Approx(2.0));
    const WakeSummary drifting = summarise_wake(history([](int n) { return 1.0 + 0.01 * n; }), 20);
    CHECK(drifting.end == WakeEnd::unsettled);
    CHECK(drifting.begin == 200);
}

TEST_CASE("a wake that sheds vortices becomes a loop, and its mean the sample that the runtime reads" *
          doctest::test_suite("long-exact")) {
    Mesh mesh;
    Faults faults;
    REQUIRE(read_mesh(LR_ASSET_SOURCES "/leaf.obj", 1.0, mesh, faults));
    TurbulenceOptions o = in_stream(mesh, {32, 32, 16});
    o.length_l = 0.05 * o.length_d;
    o.intensity = 0.05;
    const TurbulenceTable t = make(o);
    REQUIRE(t.loop_end > t.loop_begin + 2);
    CHECK(t.settled);
    CHECK(t.loop_end == t.t.size() - 1);
    CHECK(t.stationary_index == t.t.size() - 1);
    CHECK(relative(t.chi_star(t.stationary_index), t.stationary_chi_star) < 1e-12);
    // After a full turn the table is the same, after half a turn it is not.
    double low = 1e300, high = 0.0, mean = 0.0;
    const uint32_t period = t.loop_end - t.loop_begin;
    for (uint32_t n = t.loop_begin; n < t.loop_end; ++n) {
        low = std::min(low, t.chi[n]);
        high = std::max(high, t.chi[n]);
        mean += t.chi[n] / period;
    }
    CHECK(high > 1.01 * low);
    CHECK(t.chi[t.stationary_index] > low);
    CHECK(t.chi[t.stationary_index] < high);
    CHECK(relative(mean, t.chi[t.stationary_index]) < 0.05);
    MESSAGE("chi* " << low * o.length_l << " to " << high * o.length_l << " over " << period << " samples");
}

TEST_CASE("bake with a wake: in the options, the asset and the report") {
    BakeOptions o;
    o.semi_axes = {0.04, 0.02, 0.001};
    o.cells = {16, 16, 8};
    AssetData plain, wake;
    Faults faults;
    REQUIRE(bake(o, plain, faults));
    o.wake = true;
    REQUIRE(bake(o, wake, faults));
    REQUIRE(faults.empty());
    CHECK(canonical_options(o).find(" --wake") != std::string::npos);
    CHECK(wake.provenance.input_hash != plain.provenance.input_hash);
    CHECK_FALSE(plain.turbulence.wake);
    CHECK(wake.turbulence.wake);
    CHECK(wake.added_mass == plain.added_mass);
    AssetData again;
    REQUIRE(bake(o, again, faults));
    CHECK(write_asset(wake) == write_asset(again));

    const auto j = test::Json::parse(report_json(wake))["turbulence"];
    CHECK(j["wake"] == true);
    CHECK(j["settled"] == true);
    CHECK(j["loop"].is_null());
    CHECK(j["domain"][1].number() == doctest::Approx(4.0 * 0.08));
    CHECK(j["domain"][2].number() == doctest::Approx(4.0 * 0.04));
    CHECK(j["max_divergence"].number() < 1e-6);
    CHECK(j["stationary"].number() > 0);
    const auto k = test::Json::parse(report_json(plain))["turbulence"];
    CHECK(k["wake"] == false);
    CHECK(k["settled"] == true);
    CHECK(k["stationary"] == 0);
    // The same body as a mesh.
    const Mesh mesh = ellipsoid_mesh({0.04, 0.02, 0.001}, {}, 5);
    CHECK(compute_mass_properties(mesh).volume == doctest::Approx(wake.volume).epsilon(0.003));
}
