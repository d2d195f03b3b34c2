// Drops of ellipsoids, for answers that no model of the loads changes.
#include "tools/falls/how_it_falls.h"

#include <doctest/doctest.h>

#include <memory>

using namespace lr::falls;
using Eigen::Vector3d;

namespace {

using Asset = std::unique_ptr<lr_asset, decltype(&lr_asset_release)>;

Asset ellipsoid(double a, double b, double c, double density, double fluid_density = 1.2) {
    lr_ellipsoid_desc desc = LR_ELLIPSOID_DESC_INIT;
    desc.semi_axes[0] = a, desc.semi_axes[1] = b, desc.semi_axes[2] = c;
    desc.density = density;
    desc.fluid_density = fluid_density;
    if (fluid_density > 100.0) desc.fluid_viscosity = 1e-6;
    lr_asset* made = nullptr;
    REQUIRE(lr_asset_create_ellipsoid(&desc, &made) == LR_OK);
    return {made, lr_asset_release};
}

Asset leaf() {
    return ellipsoid(0.04, 0.02, 0.0002, 400.0);
}

bool same(const Track& a, const Track& b) {
    if (a.samples.size() != b.samples.size() || a.time != b.time || a.end != b.end) return false;
    for (size_t i = 0; i < a.samples.size(); ++i)
        if (a.samples[i].position != b.samples[i].position || a.samples[i].spin != b.samples[i].spin ||
            a.samples[i].orientation.coeffs() != b.samples[i].orientation.coeffs())
            return false;
    return true;
}
} // namespace

TEST_CASE("drop: a heavy sphere falls as in a vacuum, and ends at the floor") {
    const Asset sphere = ellipsoid(0.05, 0.05, 0.05, 8000.0);
    Drop options;
    options.height = 0.7;
    for (const Track& t : drop(sphere.get(), options, 0, 3)) {
        CHECK(t.arrived);
        CHECK(t.time == doctest::Approx(std::sqrt(2.0 * 0.7 / 9.81)).epsilon(0.01));
        CHECK(t.end.y() == doctest::Approx(-0.7).epsilon(1e-6));
        CHECK(t.samples.front().position == Vector3d::Zero());
        CHECK(-t.samples.back().position.y() < 0.7);
        CHECK(static_cast<double>(t.samples.size() - 1) * t.interval < t.time);
    }
}

TEST_CASE("drop: the shape and the attitudes of release") {
    const Asset asset = leaf();
    Drop options;
    const Shape shape = shape_of(asset.get(), options);
    CHECK(shape.normal.isApprox(Vector3d::UnitZ(), 1e-9));
    CHECK(shape.length == doctest::Approx(0.08));
    CHECK(shape.ellipsoid.isApprox(Vector3d(1.6e-3, 4e-4, 4e-8).asDiagonal().toDenseMatrix(), 1e-6));
    options.height = 0.05;
    const auto cosines = [&](Release release) {
        options.release = release;
        std::vector<double> found;
        for (const Track& t : drop(asset.get(), options, 0, 60))
            found.push_back((t.samples[0].orientation * shape.normal).dot(up()));
        return found;
    };
    for (const double c : cosines(Release::flat)) CHECK(c == doctest::Approx(1.0));
    for (const double c : cosines(Release::edge)) CHECK(std::abs(c) < 1e-6);
    double mean = 0.0, squares = 0.0;
    for (const double c : cosines(Release::random)) mean += c / 60.0, squares += c * c / 60.0;
    CHECK(std::abs(mean) < 0.25);
    CHECK(squares == doctest::Approx(1.0 / 3.0).epsilon(0.4));
}

TEST_CASE("drop: a body falls alike in any group, and otherwise with another seed") {
    const Asset asset = leaf();
    Drop options;
    options.count = 40;
    for (const double turbulence : {0.0, 0.5}) {
        options.turbulence = turbulence;
        const std::vector<Track> all = drop(asset.get(), options, 0, 40), rest = drop(asset.get(), options, 25, 15);
        for (size_t i = 0; i < 15; ++i) CHECK(same(all[25 + i], rest[i]));
        CHECK_FALSE(same(all[0], all[1]));
    }
    options.seed = 1;
    const Track other = drop(asset.get(), options, 0, 1)[0];
    options.seed = 0;
    CHECK_FALSE(same(other, drop(asset.get(), options, 0, 1)[0]));
    std::vector<Fall> falls;
    std::vector<Track> kept;
    options.count = 300;
    CHECK(drop_and_measure(asset.get(), options, falls, 5, &kept).count == 300);
    CHECK(falls.size() == 300);
    CHECK(kept.size() == 5);
}

TEST_CASE("drop: wind carries a light body, and drift follows it") {
    const Asset asset = leaf();
    Drop options;
    options.height = 3.0;
    options.count = 60;
    options.wind = {1.0, 0.0, -2.0};
    std::vector<Fall> falls;
    const Falls s = drop_and_measure(asset.get(), options, falls);
    CHECK(s.arrived == 60);
    CHECK(s.drift.normalized().dot(options.wind.normalized()) > 0.98);
    CHECK(s.drift.norm() > 0.5 * options.wind.norm() * s.time.mean);
    CHECK(s.drift.norm() < 1.1 * options.wind.norm() * s.time.mean);
}

TEST_CASE("drop: sentences are true in water too") {
    CHECK(how_it_falls(leaf().get()).starts_with("falls at about "));
    CHECK(how_it_falls(ellipsoid(0.03, 0.03, 0.004, 1100.0, 998.0).get()).starts_with("sinks "));
    CHECK(how_it_falls(ellipsoid(0.03, 0.03, 0.004, 800.0, 998.0).get()).starts_with("rises "));
    CHECK(how_it_falls(ellipsoid(0.03, 0.03, 0.004, 998.0, 998.0).get()) == "floats");
    CHECK(how_it_falls(ellipsoid(0.1, 0.1, 0.1, 8000.0).get()).find("(not settled yet)") != std::string::npos);
    Drop options;
    options.count = 10;
    options.fluid_density = 998.0, options.fluid_viscosity = 1e-6; // instead of the air of the bake
    std::vector<Fall> falls;
    const Falls wet = drop_and_measure(leaf().get(), options, falls);
    CHECK(sentence(wet, shape_of(leaf().get(), options)).starts_with("rises at "));
    CHECK(wet.arrived == 10);
    for (const Fall& f : falls) CHECK(f.end.y() == doctest::Approx(1.0).epsilon(1e-6));
}

TEST_CASE("drop: a body that does not arrive is given up, and its track stays short") {
    const Asset asset = ellipsoid(0.03, 0.03, 0.004, 998.0, 998.0);
    Drop options;
    options.step = 0.01;
    options.longest = 200.0;
    for (const Track& t : drop(asset.get(), options, 0, 2)) {
        CHECK_FALSE(t.arrived);
        CHECK(t.time == doctest::Approx(200.0));
        CHECK(t.interval == doctest::Approx(0.02));
        CHECK(t.samples.size() == 10001);
    }
}

TEST_CASE("drop: the step shrinks for small fast bodies") {
    Drop options;
    CHECK(default_step(shape_of(leaf().get(), options)) == 1.0 / 120.0);
    CHECK(default_step(shape_of(ellipsoid(0.005, 0.005, 0.0001, 800.0).get(), options)) < 1.0 / 120.0);
    CHECK(default_step(shape_of(ellipsoid(0.001, 0.001, 0.001, 8000.0).get(), options)) >= 1.0 / 960.0);
}
