// Bodies that cross the surface, against closed forms: docs/reference/wind_and_water.md.
#include "support/random.h"
#include "support/vector.h"
#include "support/water.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace test;

namespace {

constexpr double pi = std::numbers::pi, g = 9.81;

} // namespace

namespace {

// A ball that bobs up and down without drag, by independent small steps in double precision: (M v)' = F - B v on the way in,
// M v' = F - B v on the way out.
struct BallInDouble {
    double radius, density, y, v;

    double depth() const { return std::clamp(-y / radius, -1.0, 1.0); }
    double fraction() const {
        const double s = depth();
        return (2.0 + 3.0 * s - s * s * s) / 4.0;
    }
    // Over the volume.
    double mass() const { return density + 0.5 * (air_density + fraction() * (water_density - air_density)); }
    // Half of a step of the waves that it makes.
    void radiate(double h) {
        const double area = pi * radius * radius * (1.0 - depth() * depth());
        const double volume = 4.0 / 3.0 * pi * radius * radius * radius;
        v *= std::exp(-0.5 * h * heave_damping(area, volume * fraction(), volume * density, volume * mass()) /
                      (volume * mass()));
    }
    void step(double h) {
        radiate(h);
        const double before = mass();
        y += 0.5 * h * v;
        v *= std::min(1.0, before / mass());
        const double f = fraction(), middle = mass();
        v += h * g * (f * water_density + (1.0 - f) * air_density - density) / middle;
        y += 0.5 * h * v;
        v *= std::min(1.0, middle / mass());
        radiate(h);
    }
};

} // namespace

TEST_CASE("a ball dropped into the water converges to a reference in double precision") {
    const Asset asset = make(ellipsoid(0.1, 0.1, 0.1, 400.0));
    BallInDouble reference{0.1, 400.0, 0.3, 0.0};
    for (int i = 0; i < 1000000; ++i) reference.step(1e-6);
    double last = 1.0;
    for (int n : {60, 120, 240, 480, 960}) {
        CAPTURE(n);
        const World world = make(world_desc());
        set_water(world, water_desc());
        const lr_batch batch = add_batch(world, with_loads(LR_LOADS_NONE), asset, 1);
        const lr_body body = add_body(world, batch, at_height(0.3));
        steps(world, n, 1.0f / static_cast<float>(n));
        const lr_body_state s = state_of(world, body);
        const double error =
            std::abs(wide(s.position[1]) - reference.y) + 0.1 * std::abs(wide(s.linear_velocity[1]) - reference.v);
        CHECK(error < 0.4 * last); // second order: a quarter
        last = error;
    }
    CHECK(last < 1e-5);
}

TEST_CASE("a plank that rolls off balance through the surface converges with second order") {
    lr_ellipsoid_desc shape = ellipsoid(0.1, 0.02, 0.05, 500.0);
    shape.center_of_mass[0] = 0.01, shape.center_of_mass[1] = -0.004;
    const Asset plank = make(shape);
    for (int32_t model : {LR_LOADS_NONE, LR_LOADS_AERODYNAMIC}) {
        CAPTURE(model);
        const auto after_a_second = [&](int n) {
            const World world = make(world_desc());
            set_water(world, water_desc());
            const lr_batch batch = add_batch(world, with_loads(model), plank, 1);
            no_turbulence(world, batch);
            lr_body_desc d = at_height(0.02);
            d.orientation[0] = 0.1f, d.orientation[2] = 0.2f;
            d.angular_velocity[1] = 2.0f;
            const lr_body body = add_body(world, batch, d);
            steps(world, n, 1.0f / static_cast<float>(n));
            return state_of(world, body);
        };
        const lr_body_state reference = after_a_second(3840);
        const auto error = [&](int n) {
            const lr_body_state s = after_a_second(n);
            return length(vec(s.position) - vec(reference.position));
        };
        CHECK(error(120) > 10.0 * error(480)); // 16 in the limit
        CHECK(error(480) < 1e-4);
    }
}

TEST_CASE("on entry momentum is kept, whatever the step, on the way out velocity") {
    for (bool full : {false, true})
        for (float dt : {0.001f, 0.01f, 0.05f}) {
            CAPTURE(full);
            CAPTURE(dt);
            const Asset plate = make(ellipsoid(0.05, 0.01, 0.03, 700.0));
            const lr_asset_info info = info_of(plate);
            const World world = weightless();
            set_water(world, water_desc());
            const lr_batch batch = add_batch(world, with_loads(LR_LOADS_NONE), plate, 1, full);
            lr_body_desc d = at_height(0.5);
            d.linear_velocity[1] = -2.0f;
            const lr_body body = add_body(world, batch, d);
            steps(world, static_cast<int>(2.0f / dt), dt);
            lr_body_state s = state_of(world, body);
            REQUIRE(s.position[1] < -0.1f);
            const double added = info.added_mass[7] / air_density;
            const double expected = -2.0 * (info.mass + air_density * added) / (info.mass + water_density * added);
            CHECK(wide(s.linear_velocity[1]) == doctest::Approx(expected).epsilon(1e-4));
            const float under = s.linear_velocity[1];
            s.linear_velocity[1] = 1.0f;
            REQUIRE(lr_body_set_state(world.get(), body, &s) == LR_OK);
            steps(world, static_cast<int>(2.0f / dt), dt);
            s = state_of(world, body);
            CHECK(under < 0.0f);
            REQUIRE(s.position[1] > 0.1f);
            CHECK(wide(s.linear_velocity[1]) == doctest::Approx(1.0).epsilon(1e-4));
        }
}

TEST_CASE("a light ball released deep rises, leaves the water, and settles on it") {
    const Asset ball = make(ellipsoid(0.1, 0.1, 0.1, 60.0));
    const World world = make(world_desc());
    set_water(world, water_desc());
    const lr_batch batch = add_batch(world, with_loads(LR_LOADS_AERODYNAMIC), ball, 1);
    no_turbulence(world, batch);
    const lr_body body = add_body(world, batch, at_height(-3.0));
    double highest = -10.0;
    for (int i = 0; i < 1200; ++i) {
        steps(world, 1, 1.0f / 60.0f, 2);
        highest = std::max(highest, wide(state_of(world, body).position[1]));
    }
    CHECK(highest > 0.1);
    CHECK(highest < 3.0); // no more than it had in the water
    const lr_body_state s = state_of(world, body);
    CHECK(std::abs(wide(s.position[1]) + 0.1 * draught(60.0)) < 0.002);
}

TEST_CASE("heavy discs enter the water and sink through it slower than they fell") {
    const Asset disc = make(ellipsoid(0.02, 0.02, 0.0005, 2700.0));
    const World world = make(world_desc());
    set_water(world, water_desc());
    constexpr uint32_t count = 64;
    const lr_batch batch = add_batch(world, with_loads(LR_LOADS_AERODYNAMIC), disc, count);
    std::vector<lr_body> bodies;
    for (uint32_t i = 0; i < count; ++i) {
        lr_body_desc d = at_height(1.0);
        d.orientation[0] = 0.1f + 0.01f * static_cast<float>(i);
        bodies.push_back(add_body(world, batch, d));
    }
    const auto heights = [&] {
        std::vector<double> y;
        for (lr_body body : bodies) y.push_back(wide(state_of(world, body).position[1]));
        return y;
    };
    steps(world, 180, 1.0f / 60.0f, 4);
    std::vector<double> sank = heights();
    CHECK(*std::max_element(sank.begin(), sank.end()) < 0.0);
    steps(world, 240, 1.0f / 60.0f, 4);
    const std::vector<double> later = heights();
    for (uint32_t i = 0; i < count; ++i) sank[i] = (sank[i] - later[i]) / 4.0;
    std::sort(sank.begin(), sank.end());
    CHECK(sank.front() > 0.03);
    // A few dive on edge for a while.
    CHECK(sank[count / 2] < 0.2);
    CHECK(sank[count * 4 / 5] < 0.6);
}

TEST_CASE("a disc that has gone in flutters down") {
    const Asset disc = make(ellipsoid(0.1, 0.004, 0.1, 2000.0));
    const World world = make(world_desc());
    set_water(world, water_desc());
    const lr_batch batch = add_batch(world, with_loads(LR_LOADS_AERODYNAMIC), disc, 1);
    lr_body_desc d = at_height(0.25);
    d.orientation[2] = narrow(std::sin(0.17));
    d.orientation[3] = narrow(std::cos(0.17));
    const lr_body body = add_body(world, batch, d);
    int turns = 0;
    double last = 0.0, steepest = 0.0, deepest = 0.0;
    for (int i = 0; i < 3600; ++i) {
        steps(world, 1, 1.0f / 120.0f, 2);
        const lr_body_state s = state_of(world, body);
        if (s.position[1] > -0.05f) continue;
        const double along = wide(s.linear_velocity[0]);
        turns += along * last < 0.0;
        last = along;
        const float* const q = s.orientation;
        steepest = std::max(steepest, std::abs(2.0 * (wide(q[0]) * wide(q[1]) + wide(q[2]) * wide(q[3]))));
        deepest = std::min(deepest, wide(s.position[1]));
    }
    CHECK(turns >= 4);
    CHECK(steepest > 0.3);
    CHECK(deepest < -0.4);
}

TEST_CASE("bodies that wind or forces carry into the water enter it, however many substeps a step has") {
    for (const bool blown : {true, false}) {
        const Asset asset = blown ? leaf() : make(ellipsoid(0.05, 0.05, 0.05, 300.0));
        const auto depth = [&](int count) {
            const World world = make(world_desc());
            lr_batch_desc desc = with_loads(LR_LOADS_AERODYNAMIC);
            const lr_batch batch = add_batch(world, desc, asset, 1);
            lr_load_gains gains = initialised(lr_load_gains_init);
            gains.turbulence = 0.0f;
            REQUIRE(lr_batch_set_load_gains(world.get(), batch, &gains) == LR_OK);
            lr_batch_force force = initialised(lr_batch_force_init);
            force.acceleration[1] = blown ? 0.0f : -200.0f;
            REQUIRE(lr_batch_set_force(world.get(), batch, &force) == LR_OK);
            if (blown) REQUIRE(lr_world_set_uniform_wind(world.get(), 0.0f, -20.0f, 0.0f) == LR_OK);
            set_water(world, water_desc());
            const lr_body body = add_body(world, batch, at_height(2.0));
            steps(world, count, 0.3f / static_cast<float>(count), 24 / static_cast<uint32_t>(count));
            return state_of(world, body).position[1];
        };
        CAPTURE(blown);
        CHECK(depth(24) < 0.0f);
        CHECK(std::abs(depth(1) - depth(24)) < 0.05f);
    }
}

// Bound on gains: test_water_energy.cpp.
TEST_CASE("bodies that cross the surface stay finite, with noise and among waves") {
    for (uint32_t i = 0; i < 600; ++i) {
        CAPTURE(i);
        Random random(i);
        lr_ellipsoid_desc e = ellipsoid(random.logarithmic(1e-3, 1.0), random.logarithmic(1e-3, 1.0),
                                        random.logarithmic(1e-4, 1.0), random.logarithmic(2.0, 2e4));
        if (i % 3 == 0) e.center_of_mass[0] = 0.3 * e.semi_axes[0];
        const Asset asset = make(e);
        const World world = make(world_desc());
        lr_water_desc d = water_desc();
        d.wave_count = i % 2;
        d.waves[0] = {{1.0f, 0.0f, 0.0f}, 2.0f, 0.1f, 0.0f};
        set_water(world, d);
        const int32_t models[] = {LR_LOADS_NONE, LR_LOADS_LANGEVIN, LR_LOADS_AERODYNAMIC};
        const lr_batch batch = add_batch(world, with_loads(models[i / 3 % 3]), asset, 1);
        lr_body_desc b = at_height(random.uniform(-0.5, 0.5));
        for (float& q : b.orientation) q = random.real(-1.0, 1.0);
        for (float& v : b.linear_velocity) v = random.real(-5.0, 5.0);
        for (float& w : b.angular_velocity) w = random.real(-50.0, 50.0);
        const lr_body body = add_body(world, batch, b);
        const float dt = narrow(random.logarithmic(1.0 / 240.0, 0.1));
        double fastest = 0.0;
        for (int frame = 0; frame < 120; ++frame) {
            steps(world, 1, dt);
            const lr_body_state s = state_of(world, body);
            for (float w : s.angular_velocity) REQUIRE(std::isfinite(w));
            double square = 0.0;
            for (float v : s.linear_velocity) square += wide(v) * wide(v);
            fastest = std::max(fastest, std::isfinite(square) ? square : 1e300);
        }
        CHECK(fastest < 1e8);
    }
}
