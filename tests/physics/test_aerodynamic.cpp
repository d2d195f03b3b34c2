// Closed forms of the AERODYNAMIC loads: terminal speeds, a fall with quadratic drag, the fluid's own velocity, gains.
#include "support/random.h"
#include "support/scene.h"
#include "support/vector.h"

#include <cmath>
#include <numbers>

using namespace test;
using std::numbers::pi;

namespace {

lr_batch_desc aerodynamic(int32_t integrator = LR_INTEGRATOR_DEFAULT) {
    lr_batch_desc d = batch_desc();
    d.load_model = LR_LOADS_AERODYNAMIC;
    d.integrator = integrator;
    return d;
}

Asset rigid(const lr_rigid_desc& d) {
    lr_asset* raw = nullptr;
    REQUIRE(lr_asset_create_rigid(&d, &raw) == LR_OK);
    return Asset(raw);
}

// Clift and Gauvin 1970.
double sphere_drag(double re) {
    return 24.0 / re * (1.0 + 0.15 * std::pow(re, 0.687)) + 0.42 / (1.0 + 42500.0 * std::pow(re, -1.16));
}

// A plate with drag along z only.
constexpr double drag_area = 0.04;
lr_rigid_desc braked(const lr_aerodynamics& loads) {
    lr_rigid_desc d = rigid_plate();
    d.aerodynamics = &loads;
    return d;
}

} // namespace

TEST_CASE("spheres settle at the speed of the standard drag curve") {
    struct Ball {
        double radius, density;
        bool water;
    };
    for (const Ball& b : {Ball{2e-4, 1100.0, true}, Ball{1e-3, 1200.0, true}, Ball{5e-3, 1300.0, true},
                          Ball{2e-3, 20.0, false}, Ball{0.01, 50.0, false}, Ball{0.04, 100.0, false}}) {
        lr_ellipsoid_desc shape = ellipsoid(b.radius, b.radius, b.radius, b.density);
        if (b.water) shape = in_water(shape);
        const Asset asset = make(shape);
        const double nu = shape.fluid_viscosity, d = 2.0 * b.radius;
        // Weight in the fluid against 1/2 rho C_D pi r^2 v^2.
        const double square = 8.0 / 3.0 * (b.density / shape.fluid_density - 1.0) * 9.81 * b.radius;
        double speed = std::sqrt(square);
        for (int i = 0; i < 200; ++i) speed = std::sqrt(0.5 * (speed * speed + square / sphere_drag(speed * d / nu)));
        const World world = make(world_desc());
        lr_batch_desc bd = aerodynamic();
        bd.noise_gain = 0.0f;
        const lr_batch batch = add_batch(world, bd, asset, 1);
        const lr_body body = add_body(world, batch, body_desc());
        steps(world, 1200, 1.0f / 120.0f);
        CAPTURE(b.radius);
        MESSAGE("Re ", speed * d / nu, ": ", speed, " m/s, here ", -state_of(world, body).linear_velocity[1]);
        // The loads follow the curve within 8 %, and the speed depends on its root at most.
        CHECK(-wide(state_of(world, body).linear_velocity[1]) == doctest::Approx(speed).epsilon(0.08));
    }
}

// As plates of 2:1 to 10:1 do (Wang, Hu, Xu and Wu 2013).
TEST_CASE("paper six times as long as wide turns about its length and drifts down a slope") {
    const Asset asset = make(ellipsoid(0.06, 0.01, 5e-5, 800.0));
    const World world = make(world_desc());
    constexpr int count = 50, frames = 120;
    const lr_batch batch = add_batch(world, aerodynamic(), asset, count);
    Random random(7);
    std::vector<lr_body> bodies;
    for (int i = 0; i < count; ++i)
        bodies.push_back(add_body(world, batch, turned_anyhow(random, {double(i), 0.0, 0.0})));
    steps(world, 240, 1.0f / 60.0f, 4);
    std::vector<Vec> from;
    std::vector<double> turned(count), square(count);
    for (const lr_body b : bodies) from.push_back(vec(state_of(world, b).position));
    for (int frame = 0; frame < frames; ++frame) {
        steps(world, 1, 1.0f / 60.0f, 4);
        for (size_t i = 0; i < count; ++i) {
            const lr_body_state s = state_of(world, bodies[i]);
            const double about = to_body(quat(s.orientation), vec(s.angular_velocity))[0];
            turned[i] += about / frames, square[i] += about * about / frames;
        }
    }
    int turn = 0;
    double down = 0.0, sideways = 0.0;
    for (size_t i = 0; i < count; ++i) {
        if (std::abs(turned[i]) < 0.7 * std::sqrt(square[i])) continue;
        const Vec way = vec(state_of(world, bodies[i]).position) - from[i];
        ++turn, down -= way[1], sideways += std::hypot(way[0], way[2]);
    }
    CHECK(turn > 0.75 * count);
    CHECK(sideways > 0.7 * down);
    CHECK(down < 2.0 * 0.7 * turn); // in two seconds; broadside 0.9 m/s
}

// Their spin had hardly any friction, and its Magnus force drove them sideways at half of their speed and more.
TEST_CASE("balloons that are not quite round rise, and do not spin off sideways") {
    for (const double height : {0.13, 0.155, 0.17}) {
        CAPTURE(height);
        const World world = make(world_desc());
        lr_batch_desc d = aerodynamic();
        d.variation = 0.0f;
        const lr_batch batch = add_batch(world, d, make(ellipsoid(0.15, 0.15, height, 0.383)), 50);
        Random random(7);
        for (int i = 0; i < 50; ++i) {
            lr_body_desc b = body_desc();
            for (float& q : b.orientation) q = random.real(-1.0, 1.0);
            add_body(world, batch, b);
        }
        double up = 0.0, sideways = 0.0;
        for (int step = 0; step < 900; ++step) {
            steps(world, 1, 1.0f / 60.0f, 2);
            if (step < 300) continue;
            for (const Velocity& v : velocities_of(world, batch)) {
                up += static_cast<double>(v.linear[1]);
                sideways += static_cast<double>(std::hypot(v.linear[0], v.linear[2]));
            }
        }
        CHECK(sideways < 0.5 * up);
    }
}

TEST_CASE("a fall against quadratic drag is the hyperbolic tangent, at any step") {
    lr_aerodynamics loads = initialised(lr_aerodynamics_init);
    loads.drag[2] = drag_area;
    const Asset asset = rigid(braked(loads));
    const lr_asset_info info = info_of(asset);
    const double weight = (info.mass - info.fluid_density * info.volume) * 9.81;
    const double mass = info.mass + info.added_mass[14],
                 terminal = std::sqrt(2.0 * weight / (info.fluid_density * drag_area));
    for (bool full : {false, true})
        for (float gain : {1.0f, 4.0f})
            for (int steps_in_all : {12, 60, 600}) {
                lr_world_desc wd = world_desc();
                wd.gravity[1] = 0.0f, wd.gravity[2] = -9.81f;
                const World world = make(wd);
                lr_batch_desc bd = aerodynamic();
                const lr_batch batch = add_batch(world, bd, asset, 1, full);
                lr_load_gains gains = initialised(lr_load_gains_init);
                gains.drag = gain;
                REQUIRE(lr_batch_set_load_gains(world.get(), batch, &gains) == LR_OK);
                const lr_body body = add_body(world, batch, body_desc());
                const double speed = terminal / std::sqrt(wide(gain)), rate = weight / (mass * speed), time = 0.2;
                CAPTURE(gain);
                CAPTURE(steps_in_all);
                steps(world, steps_in_all, narrow(time / steps_in_all));
                const lr_body_state s = state_of(world, body);
                const double tolerance = steps_in_all == 12 ? 1e-2 : steps_in_all == 60 ? 1e-3 : 1e-4;
                CHECK(-wide(s.linear_velocity[2]) ==
                      doctest::Approx(speed * std::tanh(rate * time)).epsilon(tolerance));
                CHECK(-wide(s.position[2]) ==
                      doctest::Approx(speed / rate * std::log(std::cosh(rate * time))).epsilon(tolerance));
                // Then it has its terminal speed, however long the step.
                steps(world, 100, 0.1f);
                CHECK(-wide(state_of(world, body).linear_velocity[2]) == doctest::Approx(speed).epsilon(1e-3));
            }
}

// A weightless body that creeping flow carries along at once moves with the fluid's own velocity, which is Pope's process.
TEST_CASE("the fluid's own velocity has Pope's variance and correlation, at any step" * doctest::test_suite("exact")) {
    lr_aerodynamics loads = initialised(lr_aerodynamics_init);
    for (double& k : loads.drag_stokes) k = 1e5;
    lr_rigid_desc d = rigid_plate();
    d.mass = 1e-5; // within a hundredth of the shortest step it follows the fluid
    d.volume = d.mass / d.fluid_density;
    for (double& extent : d.extents) extent = 0.25;
    for (size_t i = 0; i < 3; ++i) d.inertia[i * 4] = 1e-6, d.added_mass[i * 7] = 1e-5;
    d.added_mass[21] = d.added_mass[28] = 0.0;
    d.aerodynamics = &loads;
    const Asset asset = rigid(d);
    const double chi = 2.0, c0 = 2.0, epsilon = 0.3;
    const double alpha = (0.5 + 0.75 * c0) * chi, variance = c0 * epsilon / (2.0 * alpha);
    constexpr uint32_t count = 4000;
    for (float h : {0.02f, 0.1f, 0.5f})
        for (float gain : {1.0f, 2.0f}) {
            const World world = weightless(6);
            lr_batch_desc bd = aerodynamic();
            bd.clock = LR_CLOCK_AGE;
            const lr_batch batch = add_batch(world, bd, asset, count);
            set_constant_table(world, batch, chi, epsilon, c0, 1.0, 0.1);
            lr_load_gains gains = initialised(lr_load_gains_init);
            gains.turbulence = gain;
            REQUIRE(lr_batch_set_load_gains(world.get(), batch, &gains) == LR_OK);
            std::vector<lr_body> ids;
            for (uint32_t i = 0; i < count; ++i) ids.push_back(add_body(world, batch, body_desc()));
            steps(world, static_cast<int>(3.0f / h) + 2, h);
            std::vector<Vec> before;
            for (lr_body id : ids) before.push_back(vec(state_of(world, id).linear_velocity));
            steps(world, 1, h);
            Vec square{}, product{};
            for (uint32_t i = 0; i < count; ++i) {
                const Vec now = vec(state_of(world, ids[i]).linear_velocity);
                for (size_t k = 0; k < 3; ++k)
                    square[k] += before[i][k] * before[i][k] / count, product[k] += before[i][k] * now[k] / count;
            }
            CAPTURE(h);
            CAPTURE(gain);
            const double expected = variance * wide(gain) * wide(gain);
            for (size_t k = 0; k < 3; ++k) {
                CHECK(square[k] == doctest::Approx(expected).epsilon(4.0 * std::sqrt(2.0 / count)));
                CHECK(std::abs(product[k] / expected - std::exp(-alpha * wide(h))) < 4.0 * std::sqrt(2.0 / count));
            }
        }
}

TEST_CASE("without its wake a fall is the same for any seed, with it it is not") {
    const auto end = [](float noise, float turbulence, uint64_t seed) {
        lr_world_desc wd = world_desc();
        wd.seed = seed;
        const World world = make(wd);
        lr_batch_desc bd = aerodynamic();
        bd.noise_gain = noise;
        const lr_batch batch = add_batch(world, bd, leaf(), 1);
        lr_load_gains gains = initialised(lr_load_gains_init);
        gains.turbulence = turbulence;
        REQUIRE(lr_batch_set_load_gains(world.get(), batch, &gains) == LR_OK);
        lr_body_desc b = body_desc();
        b.orientation[0] = 0.3f;
        const lr_body id = add_body(world, batch, b);
        steps(world, 60, 1.0f / 60.0f);
        return vec(state_of(world, id).position);
    };
    CHECK(length(end(0.0f, 1.0f, 1) - end(0.0f, 1.0f, 2)) == 0.0);
    CHECK(length(end(1.0f, 0.0f, 1) - end(1.0f, 0.0f, 2)) == 0.0);
    CHECK(length(end(1.0f, 1.0f, 1) - end(1.0f, 1.0f, 2)) > 1e-3);
}

TEST_CASE("coefficients that 0.3 ignores change no bit of a fall, whatever they are") {
    const auto end = [](double value) {
        const World world = make(world_desc());
        const lr_batch batch = add_batch(world, aerodynamic(), curled_leaf(), 1);
        lr_aerodynamics a = initialised(lr_aerodynamics_init);
        REQUIRE(lr_batch_get_aerodynamics(world.get(), batch, &a) == LR_OK);
        a.lift_stall = value;
        for (size_t k = 0; k < 3; ++k) a.lift_moment[k] = a.lift_moment_stalled[k] = a.roll_damping[k] = value;
        REQUIRE(lr_batch_set_aerodynamics(world.get(), batch, &a) == LR_OK);
        lr_body_desc b = body_desc();
        b.orientation[0] = 0.3f;
        add_body(world, batch, b);
        steps(world, 60, 1.0f / 60.0f);
        return hash_of(world);
    };
    for (const double value : {1.0, -1e9, std::nan("")}) CHECK(end(value) == end(0.0));
}

TEST_CASE("loads act at their centre: a vane turns as force times arm says") {
    lr_aerodynamics loads = initialised(lr_aerodynamics_init);
    loads.drag[2] = drag_area;
    const lr_rigid_desc even = braked(loads);
    CHECK((info_of(rigid(even)).flags & LR_ASSET_DIAGONAL) != 0);
    for (const double arm : {-0.02, 0.0, 0.03})
        for (const int32_t integrator : {LR_INTEGRATOR_DEFAULT, LR_INTEGRATOR_RK4}) {
            loads.center[0] = arm;
            const Asset asset = rigid(even);
            CHECK(((info_of(asset).flags & LR_ASSET_DIAGONAL) != 0) == (arm == 0.0)); // takes the full path by itself
            const World world = weightless(1);
            set_wind(world, 0.0f, 0.0f, 2.0f);
            const lr_batch batch = add_batch(world, aerodynamic(integrator), asset, 1);
            const lr_body body = add_body(world, batch, body_desc());
            constexpr double dt = 1e-4;
            steps(world, 1, narrow(dt));
            const double force = 0.5 * even.fluid_density * drag_area * 4.0;
            const lr_body_state s = state_of(world, body);
            CHECK(wide(s.linear_velocity[2]) ==
                  doctest::Approx(force * dt / (even.mass + even.added_mass[14])).epsilon(1e-2));
            const double spin = -arm * force * dt / (even.inertia[4] + even.added_mass[28]);
            CHECK(std::abs(wide(s.angular_velocity[1]) - spin) <= 1e-2 * std::abs(spin));
            CHECK((s.angular_velocity[0] == 0.0f && s.angular_velocity[2] == 0.0f));
        }
}

TEST_CASE("a batch takes a centre of the loads as far as two lengths away, and other axes") {
    const Asset asset = rigid(rigid_plate());
    const double length = info_of(asset).length_d;
    const World world = weightless(1);
    const lr_batch batch = add_batch(world, aerodynamic(), asset, 1);
    lr_aerodynamics loads = initialised(lr_aerodynamics_init);
    REQUIRE(lr_batch_get_aerodynamics(world.get(), batch, &loads) == LR_OK);
    for (const double part : {-2.0, 0.1, 2.0}) {
        loads.center[1] = part * length;
        CHECK(lr_batch_set_aerodynamics(world.get(), batch, &loads) == LR_OK);
    }
    loads.center[1] = 2.1 * length;
    CHECK(lr_batch_set_aerodynamics(world.get(), batch, &loads) == LR_ERROR_INVALID_ARGUMENT);
    loads.center[1] = std::nan("");
    CHECK(lr_batch_set_aerodynamics(world.get(), batch, &loads) == LR_ERROR_NOT_FINITE);
    lr_aerodynamics now = initialised(lr_aerodynamics_init);
    REQUIRE(lr_batch_get_aerodynamics(world.get(), batch, &now) == LR_OK);
    CHECK(now.center[1] == 2.0 * length);
    // A quarter turn about z exchanges x and y. Then back to the axes of the body.
    const double turned[9] = {0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0};
    loads = now;
    loads.center[1] = 0.0;
    std::copy(turned, turned + 9, loads.axes);
    std::swap(loads.drag[0], loads.drag[1]);
    CHECK(lr_batch_set_aerodynamics(world.get(), batch, &loads) == LR_OK);
    CHECK(lr_batch_set_aerodynamics(world.get(), batch, nullptr) == LR_OK);
}
