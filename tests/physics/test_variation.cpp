// lr_batch_desc.variation: each body has its own factors of drag and lift, with the stated spread.
#include "support/scene.h"
#include "support/vector.h"

#include <cmath>
#include <vector>

using namespace test;

namespace {

constexpr uint32_t count = 4000;

struct Setup {
    float variation = 0.15f;
    uint64_t seed = 0;
    int32_t integrator = LR_INTEGRATOR_SPLITTING;
    bool full = false;
};

// Speeds of bodies that nothing but drag slows, after some seconds, and the angles by which nothing but lift turned others.
std::vector<double> measured(const Setup& setup, bool lift) {
    lr_aerodynamics loads = LR_AERODYNAMICS_INIT;
    for (double& k : lift ? loads.spin_lift : loads.drag) k = lift ? 1e-4 : 1e-3;
    lr_rigid_desc d = LR_RIGID_DESC_INIT;
    d.mass = 1e-3, d.volume = 1e-9;
    for (size_t i = 0; i < 3; ++i) d.inertia[i * 4] = 1e-7, d.extents[i] = 0.02;
    d.aerodynamics = &loads;
    const Asset asset = make(d);
    const World world = weightless(setup.seed);
    lr_batch_desc bd = LR_BATCH_DESC_INIT;
    bd.variation = setup.variation;
    bd.integrator = setup.integrator;
    const lr_batch batch = add_batch(world, bd, asset, count, setup.full);
    lr_body_desc b = LR_BODY_DESC_INIT;
    b.linear_velocity[0] = 4.0f;
    b.angular_velocity[2] = lift ? 2.0f : 0.0f;
    const std::vector<lr_body_desc> bodies(count, b);
    std::vector<lr_body> ids(count);
    REQUIRE(lr_body_create(world.get(), batch, bodies.data(), count, ids.data()) == LR_OK);
    steps(world, 100, 0.01f, 1);
    std::vector<double> out;
    for (lr_body id : ids) {
        const lr_body_state s = state_of(world, id);
        out.push_back(lift ? std::atan2(wide(s.linear_velocity[1]), wide(s.linear_velocity[0]))
                           : wide(s.linear_velocity[0]));
    }
    return out;
}

struct Moments {
    double mean = 0.0, deviation = 0.0;
    explicit Moments(const std::vector<double>& values) {
        for (double v : values) mean += v / count;
        for (double v : values) deviation += (v - mean) * (v - mean) / count;
        deviation = std::sqrt(deviation);
    }
};

// 1/v - 1/v0 = rho C t/(2 m), and the angle is rho G w t/m: both are proportional to the factors.
std::vector<double> drag_factors(const Setup& setup) {
    std::vector<double> out = measured(setup, false);
    for (double& v : out) v = (1.0 / v - 0.25) * 2.0 * 1e-3 / (1.2 * 1e-3);
    return out;
}
std::vector<double> lift_factors(const Setup& setup) {
    std::vector<double> out = measured(setup, true);
    for (double& angle : out) angle *= 1e-3 / (1.2 * 1e-4 * 2.0);
    return out;
}

} // namespace

TEST_CASE("variation: factors of drag and lift have mean 1, the stated deviation, and are independent" *
          doctest::test_suite("exact")) {
    for (const Setup& setup : {Setup{}, Setup{.variation = 0.5f}, Setup{.variation = 0.05f, .seed = 77},
                               Setup{.integrator = LR_INTEGRATOR_RK4}, Setup{.full = true}}) {
        CAPTURE(setup.variation);
        CAPTURE(setup.integrator);
        CAPTURE(setup.full);
        const double spread = wide(setup.variation), error = spread / std::sqrt(count);
        const std::vector<double> drag = drag_factors(setup), lift = lift_factors(setup);
        std::vector<double> curl;
        for (size_t i = 0; i < count; ++i) curl.push_back(lift[i] / drag[i]);
        const Moments d(drag), c(curl);
        CHECK(std::abs(d.mean - 1.0) < 4.0 * error + 1e-3);
        CHECK(std::abs(c.mean - 1.0) < 4.0 * error + 1e-3);
        CHECK(d.deviation == doctest::Approx(spread).epsilon(0.04));
        CHECK(c.deviation == doctest::Approx(spread).epsilon(0.04));
        double product = 0.0;
        for (size_t i = 0; i < count; ++i) product += (drag[i] - d.mean) * (curl[i] - c.mean) / count;
        CHECK(std::abs(product / (d.deviation * c.deviation)) < 4.0 / std::sqrt(count));
    }
}

TEST_CASE("variation: 0 makes bodies alike, and factors belong to noise seeds and the world's seed") {
    CHECK(Moments(drag_factors({.variation = 0.0f})).deviation < 1e-9);
    CHECK(drag_factors({}) == drag_factors({}));
    CHECK(drag_factors({}) != drag_factors({.seed = 1}));
}

TEST_CASE("variation: what is not 0 to 0.5 is refused") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    for (const float variation : {-0.01f, 0.51f, NAN}) {
        lr_batch_desc d = LR_BATCH_DESC_INIT;
        d.asset = asset.get(), d.capacity = 1, d.variation = variation;
        lr_batch batch{};
        CHECK(lr_batch_create(world.get(), &d, &batch) ==
              (std::isnan(variation) ? LR_ERROR_NOT_FINITE : LR_ERROR_INVALID_ARGUMENT));
    }
}
