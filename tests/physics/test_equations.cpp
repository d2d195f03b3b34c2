// The kernel against an independent integration of the equations, and its order of convergence.
#include "support/random.h"
#include "support/reference_body.h"
#include "support/scene.h"

#include <algorithm>
#include <string>

using namespace test;

namespace {

struct Case {
    const char* name;
    lr_ellipsoid_desc shape;
    double scale;
    Vec wind;
    int32_t loads, clock;
    bool full;
    double speed, spin; // sizes of the initial velocities, m/s and rad/s
};

lr_ellipsoid_desc ballasted() {
    lr_ellipsoid_desc d = in_water(ellipsoid(0.04, 0.02, 0.01, 1200.0));
    d.center_of_mass[0] = 0.01, d.center_of_mass[1] = -0.005, d.center_of_mass[2] = 0.002;
    return d;
}

// A sheet across x, its own mirror image.
lr_ellipsoid_desc lopsided_sheet() {
    lr_ellipsoid_desc d = ellipsoid(0.001, 0.04, 0.02, 200.0);
    d.center_of_mass[1] = 0.01, d.center_of_mass[2] = -0.005;
    return d;
}

std::vector<Case> cases() {
    const lr_ellipsoid_desc solid = in_water(ellipsoid(0.04, 0.02, 0.01, 1200.0));
    const lr_ellipsoid_desc paper = ellipsoid(0.04, 0.02, 0.001, 200.0);
    const Vec still{}, breeze{0.3, -0.1, 0.2};
    return {
        {"none, diagonal", solid, 1.0, still, LR_LOADS_NONE, 0, false, 0.3, 4.0},
        {"none, full", ballasted(), 1.0, still, LR_LOADS_NONE, 0, false, 0.3, 4.0},
        {"speed, diagonal", solid, 1.0, still, LR_LOADS_LANGEVIN, LR_CLOCK_SPEED, false, 0.3, 4.0},
        {"speed, full path of a diagonal body", solid, 1.0, still, LR_LOADS_LANGEVIN, LR_CLOCK_SPEED, true, 0.3, 4.0},
        {"speed, full", ballasted(), 1.0, still, LR_LOADS_LANGEVIN, LR_CLOCK_SPEED, false, 0.3, 4.0},
        {"speed, full, large, in wind", ballasted(), 2.5, breeze, LR_LOADS_LANGEVIN, LR_CLOCK_SPEED, false, 0.5, 3.0},
        {"age, full, small, in wind", ballasted(), 0.4, breeze, LR_LOADS_LANGEVIN, LR_CLOCK_AGE, false, 0.2, 6.0},
        {"aerodynamic, diagonal", solid, 1.0, still, LR_LOADS_AERODYNAMIC, 0, false, 0.3, 4.0},
        {"aerodynamic, full path of a diagonal body", solid, 1.0, still, LR_LOADS_AERODYNAMIC, 0, true, 0.3, 4.0},
        {"aerodynamic, full, turned axes", ballasted(), 1.0, still, LR_LOADS_AERODYNAMIC, 0, false, 0.3, 4.0},
        {"aerodynamic, full, small, in wind", ballasted(), 0.4, breeze, LR_LOADS_AERODYNAMIC, 0, false, 0.2, 6.0},
        {"aerodynamic, lopsided sheet", lopsided_sheet(), 1.0, still, LR_LOADS_AERODYNAMIC, 0, false, 0.5, 5.0},
        {"aerodynamic, lopsided sheet, large, in wind", lopsided_sheet(), 2.5, breeze, LR_LOADS_AERODYNAMIC, 0, false,
         0.5, 3.0},
        {"aerodynamic, sheet in air", paper, 1.0, still, LR_LOADS_AERODYNAMIC, 0, false, 0.5, 5.0},
        {"speed, sheet in air", paper, 1.0, still, LR_LOADS_LANGEVIN, LR_CLOCK_SPEED, false, 0.5, 5.0}};
}

// All load coefficients, scaled to the body; without its wake. A ballasted body gets other axes, and on the full path a
// centre; a sheet both, within its plane.
lr_aerodynamics lively(const Case& c, const Asset& asset) {
    lr_aerodynamics a = initialised(lr_aerodynamics_init);
    REQUIRE(lr_asset_get_aerodynamics(asset.get(), &a) == LR_OK);
    const double d = info_of(asset).length_d;
    for (size_t k = 0; k < 3; ++k) {
        const double part = 0.01 * static_cast<double>(k + 1);
        a.drag_blunt[k] += part * d * d;
        a.drag_layer[k] += part * d * std::sqrt(d);
        a.spin_drag_stream[k] = 0.1 * part * d * d * d * d;
        a.broadside[k] = 0.3 * static_cast<double>(k + 1);
        a.plate_lift[k] = 5.0 * part * d * d;
        a.plate_vortex[k] = 8.0 * part * d * d;
        a.plate_stall[k] = 0.25 + 5.0 * part;
    }
    a.plate_separated_shedding = 0.05;
    a.shedding_reynolds = 0.6 * a.wake_length / c.shape.fluid_viscosity; // about that of these motions
    a.plate_drag = 0.2 * d * d;
    // The wake advances between substeps, which RK4's order does not survive: test_wake.cpp.
    a.intensity = a.start_drag = a.wake_share = a.shedding_moment = a.shedding_rate_moment = 0.0;
    if (c.shape.center_of_mass[0] == 0.0 && c.shape.center_of_mass[1] != 0.0) {
        // The sheet's normal last, the others turned.
        const double cosine = std::cos(0.4), sine = std::sin(0.4);
        const double axes[9] = {0.0, cosine, sine, 0.0, -sine, cosine, 1.0, 0.0, 0.0};
        std::copy(axes, axes + 9, a.axes);
        a.center[1] = -0.06 * d, a.center[2] = 0.1 * d;
    }
    if (c.shape.center_of_mass[0] != 0.0) {
        // A third of a turn about (1, 1, 1), then a tenth of a radian about the new z.
        const double cosine = std::cos(0.1), sine = std::sin(0.1);
        const double axes[9] = {0.0, cosine, sine, 0.0, -sine, cosine, 1.0, 0.0, 0.0};
        std::copy(axes, axes + 9, a.axes);
    }
    if (c.shape.center_of_mass[0] != 0.0 || c.full) {
        const double center[3] = {-0.06 * d, 0.1 * d, 0.04 * d};
        std::copy(center, center + 3, a.center);
    }
    return a;
}

constexpr double chi = 1.5, c0 = 2.0, u0 = 0.5; // of the table: alpha = (1/2 + 3/4 C0) chi = 3/s at u0

struct Error {
    double position, angle, velocity, spin; // relative to the motion's size, largest over bodies
    double mean_square;                     // of all of these
    double worst() const { return std::max({position, angle, velocity, spin}); }
};

Error compare(const Case& c, int32_t integrator, double time, int count, uint32_t substeps = 1) {
    const Asset asset = make(c.shape);
    lr_world_desc wd = world_desc();
    wd.gravity[0] = 2.0f, wd.gravity[1] = -9.0f, wd.gravity[2] = 1.0f;
    const World world = make(wd);
    set_wind(world, narrow(c.wind[0]), narrow(c.wind[1]), narrow(c.wind[2]));
    lr_batch_desc bd = batch_desc();
    bd.load_model = c.loads;
    bd.clock = c.clock;
    bd.integrator = integrator;
    bd.noise_gain = 0.0f;
    const lr_batch batch = add_batch(world, bd, asset, 16, c.full);
    if (c.loads == LR_LOADS_LANGEVIN) set_constant_table(world, batch, chi, 0.1, c0, u0, 0.03);

    ReferenceBody reference(info_of(asset), c.scale);
    reference.gravity = vec(wd.gravity);
    const float wind[3] = {narrow(c.wind[0]), narrow(c.wind[1]), narrow(c.wind[2])};
    reference.wind = vec(wind);
    const double alpha = (0.5 + 0.75 * c0) * chi;
    if (c.loads == LR_LOADS_LANGEVIN && c.clock == LR_CLOCK_AGE)
        reference.alpha = [=](double, double) { return alpha; };
    else if (c.loads == LR_LOADS_LANGEVIN) // chi = chi* s/l with l growing with the body
        reference.alpha = [=](double speed, double) { return alpha * speed / (u0 * c.scale); };

    if (c.loads == LR_LOADS_AERODYNAMIC) {
        const lr_asset_info info = info_of(asset);
        reference.aerodynamic = true;
        reference.loads = {lively(c, asset),     c.scale,       info.fluid_density,
                           info.fluid_viscosity, info.length_d, reference.buoyancy_arm};
        reference.loads.light = fluid_inertia(info, reference.loads.at.axes, reference.loads.normal());
        for (size_t i = 0; i < 3; ++i) reference.loads.arm[i] += c.scale * reference.loads.at.center[i];
        REQUIRE(lr_batch_set_aerodynamics(world.get(), batch, &reference.loads.at) == LR_OK);
    }

    Random random(4);
    std::vector<lr_body> ids;
    std::vector<ReferenceBody::State> expected;
    for (int i = 0; i < 16; ++i) {
        lr_body_desc d = turned_anyhow(random);
        d.scale = narrow(c.scale);
        for (float& v : d.linear_velocity) v = random.real(-c.speed, c.speed);
        for (float& w : d.angular_velocity) w = random.real(-c.spin, c.spin);
        ids.push_back(add_body(world, batch, d));
        expected.push_back(reference.run(reference.begin(d), time, 4000));
    }
    steps(world, count, narrow(time / count), substeps);
    Error error{};
    for (size_t i = 0; i < ids.size(); ++i) {
        const lr_body_state s = state_of(world, ids[i]);
        const Vec v = reference.velocity(expected[i]), w = reference.spin(expected[i]);
        const Quat q = quat(s.orientation);
        // The rotation between them, by its sine: in single precision a cosine cannot resolve 5e-4.
        const Quat e = expected[i].q, apart = product(q, {-e[0], -e[1], -e[2], e[3]});
        const double speed = c.speed + length(v), spin = c.spin + length(w);
        const auto most = [&](double& to, double from) {
            to = std::max(to, from);
            error.mean_square += from * from / (4.0 * static_cast<double>(ids.size()));
        };
        most(error.position, length(vec(s.position) - expected[i].x) / (speed * time));
        most(error.angle, 2.0 * length({apart[0], apart[1], apart[2]}));
        most(error.velocity, length(vec(s.linear_velocity) - v) / speed);
        most(error.spin, length(vec(s.angular_velocity) - w) / spin);
    }
    return error;
}

} // namespace

// At 0.5 ms rates of 30/s give 0.015 per step: RK4's error is negligible, a second-order scheme's about 1e-4 of the state.
// Rounding is 1000 substeps of 1e-7. Half a second of tumbling amplifies either up to a hundredfold.
TEST_CASE("the motion is that of the equations" * doctest::test_suite("exact")) {
    for (const Case& c : cases())
        for (int32_t integrator : {LR_INTEGRATOR_RK4, LR_INTEGRATOR_DEFAULT}) {
            const Error error = compare(c, integrator, 0.5, 50, 20);
            CAPTURE(std::string(c.name));
            CAPTURE(integrator);
            MESSAGE(std::string(c.name), ", integrator ", integrator, ": position ", error.position, ", angle ",
                    error.angle, ", velocity ", error.velocity, ", spin ", error.spin);
            CHECK(error.worst() < (integrator == LR_INTEGRATOR_RK4 ? 1e-3 : 5e-2));
        }
}

TEST_CASE("RK4 converges at fourth order, the default at second order" * doctest::test_suite("long-exact")) {
    for (const Case& c : cases())
        for (int32_t integrator : {LR_INTEGRATOR_RK4, LR_INTEGRATOR_DEFAULT}) {
            // Small bodies move faster.
            std::vector<double> errors;
            for (int count = 16; count <= 512; count *= 2)
                errors.push_back(std::sqrt(compare(c, integrator, 0.25 * std::min(1.0, c.scale), count).mean_square));
            const Convergence found = convergence(errors);
            CAPTURE(std::string(c.name));
            CAPTURE(integrator);
            MESSAGE(std::string(c.name), ", integrator ", integrator, ": order ", found.order, " from ", found.coarse,
                    " to ", found.fine, " in ", 8 << (found.halvings + 1), " steps");
            CHECK(found.coarse < 0.05);
            CHECK(found.order > (integrator == LR_INTEGRATOR_RK4 ? 3.7 : 1.8));
        }
}

// The way along the velocity in the middle of the step would be 11 % too short for the coin at 60 rad/s.
TEST_CASE("a spinning body in still air without loads goes as far as its velocity says, at any step") {
    for (const double turn : {0.2, 1.0, 3.0, 10.0})
        for (const bool coin : {false, true})
            for (size_t axis = 0; axis < 3; ++axis) {
                CAPTURE(turn);
                CAPTURE(coin);
                CAPTURE(axis);
                lr_world_desc weightless = world_desc();
                std::fill(std::begin(weightless.gravity), std::end(weightless.gravity), 0.0f);
                const World world = make(weightless);
                lr_batch_desc loads = batch_desc();
                loads.load_model = LR_LOADS_NONE;
                const lr_batch batch =
                    add_batch(world, loads, make(ellipsoid(0.01, coin ? 0.001 : 0.01, 0.01, 8000.0)), 1);
                lr_body_desc d = body_desc();
                d.linear_velocity[0] = 2.0f;
                d.angular_velocity[axis] = narrow(60.0 * turn);
                const lr_body body = add_body(world, batch, d);
                steps(world, 60, 1.0f / 60.0f, 1);
                const lr_body_state s = state_of(world, body);
                // Air's added mass, 1e-4 of the coin's, turns its velocity a little.
                CHECK(length(vec(s.linear_velocity) - Vec{2.0, 0.0, 0.0}) < 2e-3);
                CHECK(length(Vec{s.position[0], s.position[1], s.position[2]} - Vec{2.0, 0.0, 0.0}) < 2e-3);
            }
}
