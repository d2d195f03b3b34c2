// Weight, buoyancy and added mass against closed forms.
#include "support/scene.h"
#include "support/vector.h"

#include <cmath>
#include <numbers>

using namespace test;

namespace {

constexpr double g = 9.81;
constexpr int32_t integrators[] = {LR_INTEGRATOR_RK4, LR_INTEGRATOR_DEFAULT};

lr_batch_desc calm(int32_t loads, int32_t integrator) {
    lr_batch_desc d = batch_desc();
    d.load_model = loads;
    d.noise_gain = 0.0f;
    d.integrator = integrator;
    return d;
}

// A 4:2:1 ellipsoid as heavy as its water, its weight `offset` below its centre along body z: it neither falls nor
// rises.
lr_ellipsoid_desc float_with_keel(double offset) {
    lr_ellipsoid_desc d = in_water(ellipsoid(0.04, 0.02, 0.01, 1000.0));
    d.center_of_mass[2] = -offset;
    return d;
}

// The squared rate of small rocking about body x: torque rho V g offset sin(angle), against the inertia of the body and of the
// water that rocks with it. The momentum along y stays zero, and with it the centre of the moving mass: with m body and A water,
// the offset adds m A/(m + A) offset^2 to the inertia.
double rocking_rate_squared(double offset) {
    const double volume = 4.0 / 3.0 * std::numbers::pi * 8e-6, m = 1000.0 * volume;
    const double b2 = 4e-4, c2 = 1e-4;
    // docs/maintainers/physics.md section 5: A/V and, from the same integrals, D about x.
    const double a_y = 0.39817 * m;
    const double alpha_y = 2.0 * 0.39817 / 1.39817, alpha_z = 2.0 * 1.51806 / 2.51806;
    const double d_x =
        m / 5.0 * (b2 - c2) * (b2 - c2) * (alpha_z - alpha_y) / (2.0 * (b2 - c2) + (b2 + c2) * (alpha_y - alpha_z));
    const double inertia = m / 5.0 * (b2 + c2) + d_x + offset * offset * m * a_y / (m + a_y);
    return m * g * offset / inertia;
}

double tilt(const World& world, lr_body id) {
    const Quat q = quat(state_of(world, id).orientation);
    return 2.0 * std::atan2(q[0], q[3]);
}

lr_body add_tilted(const World& world, lr_batch batch, double angle) {
    // Body z is up: a quarter turn about x takes it to world y.
    lr_body_desc d = body_desc();
    d.orientation[0] = narrow(std::sin(0.5 * angle));
    d.orientation[3] = narrow(std::cos(0.5 * angle));
    return add_body(world, batch, d);
}

World up_is_z() {
    lr_world_desc d = world_desc();
    d.gravity[1] = 0.0f;
    d.gravity[2] = narrow(-g);
    return make(d);
}

} // namespace

TEST_CASE("buoyancy above the centre of mass is stable, and rocks at the rate of the linear theory") {
    const double offset = 0.004, rate = std::sqrt(rocking_rate_squared(offset));
    const Asset asset = make(float_with_keel(offset));
    for (int32_t integrator : integrators) {
        const World world = up_is_z();
        const lr_batch batch = add_batch(world, calm(LR_LOADS_NONE, integrator), asset, 1);
        const lr_body id = add_tilted(world, batch, 0.02);
        // Zero crossings over five periods, with linear interpolation between steps.
        const double period = 2.0 * std::numbers::pi / rate, dt = period / 200.0;
        double before = tilt(world, id), largest = 0.0, first = 0.0, last = 0.0;
        int crossings = 0;
        for (int i = 1; i <= 1100; ++i) {
            steps(world, 1, narrow(dt), 2);
            const double now = tilt(world, id);
            largest = std::max(largest, std::abs(now));
            if (before > 0.0 && now <= 0.0) {
                last = dt * (i - 1 + before / (before - now));
                if (crossings++ == 0) first = last;
            }
            before = now;
        }
        REQUIRE(crossings >= 5);
        // The amplitude lengthens the period by 1/16 of its square, a second-order scheme by (2 pi/400)^2/12.
        const double measured = 2.0 * std::numbers::pi * (crossings - 1) / (last - first);
        CHECK(measured == doctest::Approx(rate).epsilon(3e-4));
        CHECK(largest < 0.0201);
    }
}

TEST_CASE("buoyancy below the centre of mass is unstable, and falls over at the rate of the linear theory") {
    const double offset = 0.004, rate = std::sqrt(rocking_rate_squared(offset));
    const Asset asset = make(float_with_keel(-offset));
    for (int32_t integrator : integrators) {
        const World world = up_is_z();
        const lr_batch batch = add_batch(world, calm(LR_LOADS_NONE, integrator), asset, 1);
        const double start = 0.002;
        const lr_body id = add_tilted(world, batch, start);
        steps(world, 300, narrow(3.0 / rate / 300.0), 2);
        CHECK(tilt(world, id) == doctest::Approx(start * std::cosh(3.0)).epsilon(3e-3));
        // It turns over: upside down, at least three quarters of half a turn.
        double most = 0.0;
        for (int i = 0; i < 600; ++i) {
            steps(world, 1, narrow(0.01 / rate), 2);
            most = std::max(most, std::abs(tilt(world, id)));
        }
        CHECK(most > 0.75 * std::numbers::pi);
    }
}

TEST_CASE("with loads the keel comes to rest below") {
    const Asset asset = make(float_with_keel(0.004));
    for (int32_t integrator : integrators) {
        const World world = up_is_z();
        lr_batch_desc d = calm(LR_LOADS_LANGEVIN, integrator);
        d.clock = LR_CLOCK_AGE;
        const lr_batch batch = add_batch(world, d, asset, 1);
        set_constant_table(world, batch, 4.0, 0.0, 2.0);
        const lr_body id = add_tilted(world, batch, 2.5);
        steps(world, 2000, 0.005f, 4);
        CHECK(std::abs(tilt(world, id)) < 1e-3);
        CHECK(length(vec(state_of(world, id).angular_velocity)) < 1e-3);
    }
}

TEST_CASE("a sphere starts with the acceleration of its weight on its own and half the displaced mass") {
    // A bubble would start with 2 g up, a pebble with less than g down.
    for (double density : {1.0, 500.0, 1000.0, 2600.0}) {
        const Asset asset = make(in_water(ellipsoid(0.02, 0.02, 0.02, density)));
        const double a = -(density - 1000.0) * g / (density + 500.0); // upwards
        for (int32_t integrator : integrators)
            for (bool full : {false, true}) {
                const World world = make(world_desc());
                lr_batch_desc d = calm(LR_LOADS_NONE, integrator);
                const lr_batch batch = add_batch(world, d, asset, 1, full);
                const lr_body id = add_body(world, batch, body_desc());
                steps(world, 50, 0.01f, 2);
                const lr_body_state s = state_of(world, id);
                CHECK(std::abs(wide(s.linear_velocity[1]) - 0.5 * a) < 2e-5 * (1e-2 + std::abs(a)));
                CHECK(std::abs(wide(s.position[1]) - 0.125 * a) < 2e-5 * (1e-2 + std::abs(a)));
                CHECK(std::abs(s.position[0]) + std::abs(s.position[2]) < 1e-6f);
            }
    }
}

TEST_CASE("an ellipsoid falls broadside slower than edgewise, each by its own added mass") {
    const Asset asset = make(in_water(ellipsoid(0.04, 0.02, 0.01, 1100.0)));
    const double coefficient[3] = {0.12657, 0.39817, 1.51806};
    for (size_t axis = 0; axis < 3; ++axis) {
        lr_world_desc wd = world_desc();
        wd.gravity[1] = 0.0f;
        wd.gravity[axis] = narrow(-g);
        const World world = make(wd);
        const lr_batch batch = add_batch(world, calm(LR_LOADS_NONE, LR_INTEGRATOR_DEFAULT), asset, 1);
        const lr_body id = add_body(world, batch, body_desc());
        steps(world, 10, 0.01f, 2);
        const double expected = -100.0 * g / (1100.0 + 1000.0 * coefficient[axis]) * 0.1;
        CHECK(wide(state_of(world, id).linear_velocity[axis]) == doctest::Approx(expected).epsilon(5e-5));
    }
}

TEST_CASE("the fluid of the world replaces that of the bake") {
    const Asset asset = make(ellipsoid(0.02, 0.02, 0.02, 500.0)); // for air
    lr_world_desc wd = world_desc();
    wd.fluid_density = 1000.0f;
    const World world = make(wd);
    const lr_batch batch = add_batch(world, calm(LR_LOADS_NONE, LR_INTEGRATOR_DEFAULT), asset, 1);
    const lr_body id = add_body(world, batch, body_desc());
    steps(world, 10, 0.01f, 2);
    CHECK(wide(state_of(world, id).linear_velocity[1]) == doctest::Approx(500.0 * g / 1000.0 * 0.1).epsilon(2e-5));
}

// rho (V + A) alpha(s) s against (m - rho V) g, A = V/2, and the way there from rest.
TEST_CASE("a falling sphere reaches the terminal velocity of its turbulent drag, by the closed form of its clock") {
    const double rho = 1000.0, density = 1500.0, chi = 2.0, c0 = 2.0, u0 = 0.5;
    const double alpha = (0.5 + 0.75 * c0) * chi;
    const Asset asset = make(in_water(ellipsoid(0.02, 0.02, 0.02, density)));
    const double start = (density - rho) * g / (density + 0.5 * rho); // acceleration from rest
    for (int32_t integrator : integrators)
        for (int32_t clock : {LR_CLOCK_AGE, LR_CLOCK_SPEED}) {
            const World world = make(world_desc());
            lr_batch_desc d = calm(LR_LOADS_LANGEVIN, integrator);
            d.clock = clock;
            const lr_batch batch = add_batch(world, d, asset, 1);
            set_constant_table(world, batch, chi, 0.3, c0, u0, 0.05);
            const lr_body id = add_body(world, batch, body_desc());
            double terminal = (density - rho) * g / (1.5 * rho * alpha);
            if (clock == LR_CLOCK_SPEED) terminal = std::sqrt(terminal * u0); // alpha grows as s/u0
            const double tau = terminal / start;
            for (double t : {0.5, 1.0, 2.0, 8.0}) {
                const double now = info_of(world).time / tau;
                steps(world, 100, narrow((t - now) * tau / 100.0), 2);
                const double reached = info_of(world).time / tau;
                const double expected =
                    terminal * (clock == LR_CLOCK_SPEED ? std::tanh(reached) : 1.0 - std::exp(-reached));
                CHECK(-wide(state_of(world, id).linear_velocity[1]) == doctest::Approx(expected).epsilon(3e-4));
            }
            CHECK(-wide(state_of(world, id).linear_velocity[1]) == doctest::Approx(terminal).epsilon(6e-4));
        }
}

TEST_CASE("the damping gain multiplies the damping") {
    const Asset asset = make(in_water(ellipsoid(0.02, 0.02, 0.02, 1000.0)));
    for (float gain : {0.0f, 0.5f, 1.0f, 3.0f}) {
        const World world = weightless();
        lr_batch_desc d = calm(LR_LOADS_LANGEVIN, LR_INTEGRATOR_RK4);
        d.clock = LR_CLOCK_AGE;
        d.damping_gain = gain;
        const lr_batch batch = add_batch(world, d, asset, 1);
        set_constant_table(world, batch, 1.0, 0.3, 2.0);
        lr_body_desc b = body_desc();
        b.linear_velocity[0] = 1.0f;
        const lr_body id = add_body(world, batch, b);
        steps(world, 50, 0.01f, 2);
        // A neutrally buoyant sphere: v' = -alpha v.
        CHECK(wide(state_of(world, id).linear_velocity[0]) ==
              doctest::Approx(std::exp(-wide(gain) * 2.0 * 0.5)).epsilon(1e-5));
    }
}
