#include "asset/closed_forms/ellipsoid_asset.h"
#include "baker/fault_text.h"

#include "asset/asset_file.h"
#include "asset/closed_forms/turbulence_closure.h"
#include "support/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

using namespace lr;
using namespace lr::shape;

namespace {

EllipsoidSpec leaf() {
    EllipsoidSpec s;
    s.semi_axes = {0.04, 0.01, 0.00005};
    s.density = 800.0;
    return s;
}

AssetData body(const EllipsoidSpec& spec) {
    AssetData data;
    Faults faults;
    REQUIRE(ellipsoid_body(spec, data, faults));
    REQUIRE(faults.empty());
    return data;
}

} // namespace

TEST_CASE("every ellipsoid that is accepted passes the file's own checks") {
    test::Random random(8);
    for (int round = 0; round < 500; ++round) {
        EllipsoidSpec s;
        const double size = random.logarithmic(1e-3, 100.0);
        for (double& a : s.semi_axes) a = size * random.logarithmic(1e-3, 1.0);
        s.density = random.logarithmic(0.1, 2e4);
        s.fluid_density = random.logarithmic(0.1, 2e3);
        s.fluid_viscosity = random.logarithmic(1e-7, 1e-2);
        s.intensity = random.uniform(0.0, 10.0);
        for (size_t i = 0; i < 3; ++i) s.center_of_mass[i] = random.uniform(-0.55, 0.55) * s.semi_axes[i];
        AssetData d = body(s);
        d.turbulence = decay_table(d, s.intensity);
        Faults faults;
        CHECK(check_asset(d, faults));
        for (const Fault& f : faults) MESSAGE(to_string(f));
    }
}

TEST_CASE("an offset centre of mass moves added mass and buoyancy, and no energy appears") {
    EllipsoidSpec s = leaf();
    s.semi_axes = {0.04, 0.02, 0.01};
    const AssetData centred = body(s);
    s.center_of_mass = {0.01, -0.005, 0.002};
    const AssetData offset = body(s);
    test::Random random(9);
    for (size_t i = 0; i < 3; ++i) CHECK(offset.center_of_buoyancy[i] == -s.center_of_mass[i]);
    const auto energy = [](const AssetData& d, const std::array<double, 6>& t) {
        double e = 0.0;
        for (size_t i = 0; i < 6; ++i)
            for (size_t j = 0; j < 6; ++j) e += 0.5 * d.added_mass[i * 6 + j] * t[i] * t[j];
        return e;
    };
    for (int round = 0; round < 50; ++round) {
        std::array<double, 6> t{};
        for (double& x : t) x = random.uniform(-1.0, 1.0);
        // The same motion seen from the new point: v there = v at the centre + w x c.
        std::array<double, 6> moved = t;
        const auto& c = s.center_of_mass;
        moved[0] += t[4] * c[2] - t[5] * c[1];
        moved[1] += t[5] * c[0] - t[3] * c[2];
        moved[2] += t[3] * c[1] - t[4] * c[0];
        CHECK(energy(offset, moved) == doctest::Approx(energy(centred, t)).epsilon(1e-12));
    }
    CHECK(std::abs(offset.added_mass[5]) > 0.0);
}

TEST_CASE("the hull is closed, outward and inside its ellipsoid") {
    EllipsoidSpec s = leaf();
    s.semi_axes = {0.4, 0.2, 0.1};
    s.center_of_mass = {0.05, 0.0, -0.02};
    const AssetData d = body(s);
    REQUIRE(d.hull.vertices.size() == 3 * 42);
    REQUIRE(d.hull.triangles.size() == 3 * 80);
    const auto point = [&](uint32_t i) {
        std::array<double, 3> p{};
        for (size_t k = 0; k < 3; ++k) p[k] = static_cast<double>(d.hull.vertices[3 * i + k]) + s.center_of_mass[k];
        return p;
    };
    for (uint32_t i = 0; i < 42; ++i) {
        const auto p = point(i);
        double r = 0.0;
        for (size_t k = 0; k < 3; ++k) r += std::pow(p[k] / s.semi_axes[k], 2.0);
        CHECK(r == doctest::Approx(1.0).epsilon(1e-5));
    }
    std::map<std::pair<uint32_t, uint32_t>, int> edges;
    double volume = 0.0;
    for (size_t t = 0; t < d.hull.triangles.size(); t += 3) {
        const uint32_t* v = &d.hull.triangles[t];
        for (size_t k = 0; k < 3; ++k) ++edges[{v[k], v[(k + 1) % 3]}];
        const auto a = point(v[0]), b = point(v[1]), c = point(v[2]);
        const double six = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                           a[2] * (b[0] * c[1] - b[1] * c[0]);
        CHECK(six > 0.0);
        volume += six / 6.0;
    }
    for (const auto& [edge, count] : edges) {
        CHECK(count == 1);
        CHECK(edges.count({edge.second, edge.first}) == 1);
    }
    CHECK((volume > 0.8 * d.volume && volume < d.volume));
}

TEST_CASE("each parameter out of range is fault 301") {
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    const auto refused = [](const EllipsoidSpec& s) {
        AssetData d;
        Faults faults;
        CHECK_FALSE(ellipsoid_body(s, d, faults));
        REQUIRE(!faults.empty());
        CHECK(faults[0].id == FaultId::parameter_out_of_range);
        CHECK((!faults[0].where.empty() && !faults[0].what.empty() && !faults[0].remedy.empty()));
    };
    for (double bad : {nan, inf, -inf, 0.0, -1.0})
        for (size_t field = 0; field < 6; ++field) {
            EllipsoidSpec s = leaf();
            double* const fields[] = {&s.semi_axes[0], &s.semi_axes[1],  &s.semi_axes[2],
                                      &s.density,      &s.fluid_density, &s.fluid_viscosity};
            *fields[field] = bad;
            refused(s);
        }
    for (double bad : {nan, inf, -0.5, 10.5}) {
        EllipsoidSpec s = leaf();
        s.intensity = bad;
        refused(s);
    }
    for (double bad : {nan, inf, 1.0, -0.041}) {
        EllipsoidSpec s = leaf();
        s.center_of_mass[0] = bad;
        refused(s);
    }
    EllipsoidSpec thin = leaf();
    thin.semi_axes = {100.0, 100.0, 1e-3};
    refused(thin);
}

TEST_CASE("the table of an ellipsoid is the closed decay, in the asset's units") {
    AssetData d = body(leaf());
    for (double intensity : {0.1, 1.0}) {
        const TurbulenceData t = decay_table(d, intensity);
        REQUIRE(t.chi.size() == t.epsilon.size());
        const double k0 = 1.5 * std::pow(intensity * d.u0, 2.0);
        const double epsilon0 = std::pow(0.09, 0.75) * std::pow(k0, 1.5) / d.length_l;
        const double chi0 = epsilon0 / k0;
        for (size_t i = 0; i < t.chi.size(); i += 15) {
            const double time = static_cast<double>(i) * t.dt * d.length_l / d.u0;
            const double q = 1.0 + 0.92 * chi0 * time, k = k0 * std::pow(q, -1.0 / 0.92);
            CHECK(t.chi[i] * d.u0 / d.length_l == doctest::Approx(chi0 / q).epsilon(1e-10));
            CHECK(t.epsilon[i] * std::pow(d.u0, 3.0) / d.length_l == doctest::Approx(k * chi0 / q).epsilon(1e-10));
        }
        CHECK(t.stationary == 0);
    }
    const TurbulenceData still = decay_table(d, 0.0);
    for (double chi : still.chi) CHECK(chi == 0.0);
}

TEST_CASE("scales: lengths of the body, and a speed that never vanishes") {
    const BodyScales s = body_scales(0.08, 0.0001, 1e-7, 1e-3, 2e-6, 800.0, 1.2);
    CHECK(s.d == 0.08);
    CHECK(s.b == doctest::Approx(0.0001)); // the extent, less than 3/2 of the mean thickness
    CHECK(s.l == doctest::Approx(1e-3));
    CHECK(s.u0 == doctest::Approx(std::sqrt((800.0 / 1.2 - 1.0) * 9.80665 * 0.0001)));
    // A curled sheet's thickness follows from its volume, not from the depth of the curl.
    CHECK(body_scales(0.08, 0.02, 1e-7, 1e-3, 2e-6, 800.0, 1.2).b == doctest::Approx(1.5e-4));
    CHECK(body_scales(0.08, 0.02, 1e-7, 1e-3, 2e-6, 1.2, 1.2).u0 == 1e-6);
    // A bubble rises as fast as its density ratio says.
    CHECK(body_scales(1.0, 1.0, 1.0, 1.0, 1.0, 500.0, 1000.0).u0 == doctest::Approx(std::sqrt(0.5 * 9.80665)));
}
