// Two fluids with a surface between them, against closed forms: docs/reference/wind_and_water.md.
#include "support/body_contact.h"
#include "support/colliders.h"
#include "support/random.h"
#include "support/vector.h"
#include "support/water.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace test;

namespace {

constexpr double pi = std::numbers::pi, g = 9.81;

lr_batch_desc loads(int32_t model, int32_t integrator = LR_INTEGRATOR_DEFAULT) {
    lr_batch_desc d = batch_desc();
    d.load_model = model;
    d.integrator = integrator;
    return d;
}
lr_body_desc at_height(double y) {
    lr_body_desc d = body_desc();
    d.position[1] = narrow(y);
    return d;
}
void no_turbulence(const World& w, lr_batch batch) {
    lr_load_gains gains = initialised(lr_load_gains_init);
    gains.turbulence = 0.0f;
    REQUIRE(lr_batch_set_load_gains(w.get(), batch, &gains) == LR_OK);
}

// Height of a floating ellipsoid's centre over the water, in half heights: density = f water + (1 - f) air.
double draught(double density) {
    const double f = (density - air_density) / (water_density - air_density);
    double low = -1.0, high = 1.0;
    for (int i = 0; i < 60; ++i) {
        const double s = 0.5 * (low + high);
        ((2.0 + 3.0 * s - s * s * s) / 4.0 < f ? low : high) = s;
    }
    return low;
}

} // namespace

TEST_CASE("a floating body comes to rest at Archimedes' draught" * doctest::test_suite("exact")) {
    for (double density : {50.0, 250.0, 500.0, 900.0})
        for (bool full : {false, true}) {
            CAPTURE(density);
            CAPTURE(full);
            const Asset ball = make(ellipsoid(0.05, 0.05, 0.05, density));
            const World world = make(world_desc());
            set_water(world, water_desc());
            const lr_batch batch = add_batch(world, loads(LR_LOADS_AERODYNAMIC), ball, 1, full);
            const lr_body body = add_body(world, batch, at_height(0.08));
            no_turbulence(world, batch);
            steps(world, 14400, 1.0f / 60.0f, 2);
            const lr_body_state s = state_of(world, body);
            // Quadratic drag takes long to end the motion.
            CHECK(std::abs(wide(s.position[1]) + 0.05 * draught(density)) < 5e-4);
            CHECK(std::abs(s.linear_velocity[1]) < 0.006f);
        }
}

TEST_CASE("a floating body bobs with its closed form's frequency") {
    struct Shape {
        double a, c;
    };
    for (const Shape shape : {Shape{0.05, 0.05}, Shape{0.02, 0.1}}) // a sphere and an upright spar
        for (double density : {300.0, 500.0, 800.0})
            for (bool full : {false, true}) {
                CAPTURE(shape.c);
                CAPTURE(density);
                const Asset asset = make(ellipsoid(shape.a, shape.c, shape.a, density));
                const lr_asset_info info = info_of(asset);
                const World world = make(world_desc());
                set_water(world, water_desc());
                const lr_batch batch = add_batch(world, loads(LR_LOADS_NONE), asset, 1, full);
                const double s0 = draught(density), rest = -shape.c * s0;
                const lr_body body = add_body(world, batch, at_height(rest + 0.002 * shape.c));
                const double waterplane = pi * shape.a * shape.a * (1.0 - s0 * s0);
                const double added = info.added_mass[7] / air_density * density; // rho(f) is the body's
                const double omega = std::sqrt((water_density - air_density) * g * waterplane / (info.mass + added));
                const float dt = 1e-3f;
                double last = 1.0, first = 0.0, latest = 0.0;
                int crossings = 0;
                for (int i = 0; i < 6000 && crossings < 7; ++i) {
                    steps(world, 1, dt);
                    const double y = wide(state_of(world, body).position[1]) - rest;
                    if (last > 0.0 && y <= 0.0) {
                        latest = (i + last / (last - y)) * wide(dt);
                        if (crossings++ == 0) first = latest;
                    }
                    last = y;
                }
                REQUIRE(crossings == 7);
                CHECK(2.0 * pi * 6.0 / (latest - first) == doctest::Approx(omega).epsilon(0.01));
            }
}

namespace {

// A ball that bobs up and down without drag, by independent small steps in double precision: (M v)' = F on the way in,
// M v' = F on the way out.
struct BallInDouble {
    double radius, density, y, v;

    double fraction() const {
        const double s = std::clamp(-y / radius, -1.0, 1.0);
        return (2.0 + 3.0 * s - s * s * s) / 4.0;
    }
    // Over the volume.
    double mass() const { return density + 0.5 * (air_density + fraction() * (water_density - air_density)); }
    void step(double h) {
        const double before = mass();
        y += 0.5 * h * v;
        v *= std::min(1.0, before / mass());
        const double f = fraction(), middle = mass();
        v += h * g * (f * water_density + (1.0 - f) * air_density - density) / middle;
        y += 0.5 * h * v;
        v *= std::min(1.0, middle / mass());
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
        const lr_batch batch = add_batch(world, loads(LR_LOADS_NONE), asset, 1);
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
            const lr_batch batch = add_batch(world, loads(model), plank, 1);
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
            const lr_batch batch = add_batch(world, loads(LR_LOADS_NONE), plate, 1, full);
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

TEST_CASE("deep under the surface everything is as in a world of water, above it as in one of air") {
    for (bool wet : {true, false})
        for (int32_t model : {LR_LOADS_NONE, LR_LOADS_LANGEVIN, LR_LOADS_AERODYNAMIC})
            for (int32_t integrator : {LR_INTEGRATOR_DEFAULT, LR_INTEGRATOR_RK4})
                for (bool curled : {false, true}) {
                    CAPTURE(wet);
                    CAPTURE(model);
                    CAPTURE(integrator);
                    CAPTURE(curled);
                    lr_ellipsoid_desc shape = ellipsoid(0.03, 0.02, 0.006, 900.0);
                    if (curled) shape.center_of_mass[0] = 0.004, shape.center_of_mass[1] = -0.002;
                    const Asset asset = make(shape);
                    lr_body_state state[2];
                    for (int with_surface = 0; with_surface < 2; ++with_surface) {
                        lr_world_desc wd = world_desc();
                        if (wet && with_surface == 0)
                            wd.fluid_density = narrow(water_density), wd.fluid_viscosity = 1e-6f;
                        const World world = make(wd);
                        if (with_surface) {
                            lr_water_desc surface = water_desc();
                            // A dry body near the surface is stepped by the same code as a wet one: a callback's reach includes all
                            // bodies.
                            surface.position[1] = wet ? 100.0f : -5.0f;
                            surface.reach = 1000.0f;
                            set_water(world, surface);
                            REQUIRE(lr_world_set_water_callback(
                                        world.get(), [](void*, const lr_water_query*) {}, nullptr) == LR_OK);
                        }
                        // Near a surface RK4 is the splitting scheme.
                        const int32_t scheme = with_surface ? integrator : LR_INTEGRATOR_DEFAULT;
                        const lr_batch batch = add_batch(world, loads(model, scheme), asset, 1);
                        lr_body_desc d = body_desc();
                        d.noise_seed = 5;
                        d.orientation[0] = 0.3f, d.orientation[2] = -0.2f;
                        d.linear_velocity[0] = 0.3f, d.linear_velocity[1] = -0.5f;
                        d.angular_velocity[2] = 3.0f;
                        const lr_body body = add_body(world, batch, d);
                        steps(world, 40, 2e-3f);
                        state[with_surface] = state_of(world, body);
                    }
                    for (size_t k = 0; k < 3; ++k) {
                        CHECK(std::abs(state[0].position[k] - state[1].position[k]) < 2e-5f);
                        CHECK(std::abs(state[0].linear_velocity[k] - state[1].linear_velocity[k]) < 2e-3f);
                        CHECK(std::abs(state[0].angular_velocity[k] - state[1].angular_velocity[k]) < 0.05f);
                    }
                }
}

TEST_CASE("between the fluids the full path agrees with the diagonal one") {
    // The bodies are equal; the full path finds inverses and modes for each lane separately.
    for (int32_t model : {LR_LOADS_NONE, LR_LOADS_LANGEVIN, LR_LOADS_AERODYNAMIC})
        for (int32_t integrator : {LR_INTEGRATOR_DEFAULT, LR_INTEGRATOR_RK4})
            for (double height : {-0.005, 0.0, 0.008}) {
                CAPTURE(model);
                CAPTURE(integrator);
                CAPTURE(height);
                const Asset asset = make(ellipsoid(0.03, 0.02, 0.008, 600.0));
                lr_body_state state[2];
                for (bool full : {false, true}) {
                    const World world = make(world_desc());
                    set_water(world, water_desc());
                    const lr_batch batch = add_batch(world, loads(model, integrator), asset, 1, full);
                    lr_body_desc d = at_height(height);
                    d.noise_seed = 3;
                    d.orientation[0] = -0.5f, d.orientation[2] = 0.1f;
                    d.linear_velocity[0] = 0.3f, d.linear_velocity[1] = -0.2f;
                    d.angular_velocity[1] = 4.0f;
                    const lr_body body = add_body(world, batch, d);
                    steps(world, 30, 1.0f / 500.0f);
                    state[full] = state_of(world, body);
                }
                for (size_t k = 0; k < 3; ++k) {
                    CHECK(std::abs(state[0].position[k] - state[1].position[k]) < 2e-5f);
                    CHECK(std::abs(state[0].linear_velocity[k] - state[1].linear_velocity[k]) < 2e-3f);
                    CHECK(std::abs(state[0].angular_velocity[k] - state[1].angular_velocity[k]) < 0.1f);
                }
            }
}

TEST_CASE("a light ball released deep rises, leaves the water, and settles on it") {
    const Asset ball = make(ellipsoid(0.1, 0.1, 0.1, 60.0));
    const World world = make(world_desc());
    set_water(world, water_desc());
    const lr_batch batch = add_batch(world, loads(LR_LOADS_AERODYNAMIC), ball, 1);
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

TEST_CASE("a leaf comes to lie flat on the water") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    set_water(world, water_desc());
    const lr_batch batch = add_batch(world, loads(LR_LOADS_AERODYNAMIC), asset, 1);
    no_turbulence(world, batch);
    lr_body_desc d = at_height(0.05);
    d.orientation[0] = narrow(std::sin(-pi / 4.0 + 0.2)); // the leaf's normal is its z axis
    d.orientation[3] = narrow(std::cos(-pi / 4.0 + 0.2));
    const lr_body body = add_body(world, batch, d);
    steps(world, 1200, 1.0f / 60.0f, 4);
    const lr_body_state s = state_of(world, body);
    const float* const q = s.orientation;
    const double up = 2.0 * (wide(q[1]) * wide(q[2]) - wide(q[0]) * wide(q[3])); // of its normal
    CHECK(std::abs(up) > 0.99);
    CHECK(std::abs(s.position[1]) < 0.002f);
}

TEST_CASE("thin leaves on the ground under water rise, one alone and one on another, and heavy ones lie") {
    for (const double density : {400.0, 800.0, 1100.0}) {
        for (const uint32_t leaves : {1u, 2u}) {
            CAPTURE(density);
            CAPTURE(leaves);
            const Asset asset = make(ellipsoid(0.04, 0.02, 0.0001, density));
            const World world = make(world_desc());
            const lr_batch batch = add_batch(world, asset, 2);
            REQUIRE(lr_batch_set_body_contact(world.get(), batch, batch, 1) == LR_OK);
            add_collider(world, collider_desc(LR_COLLIDER_PLANE));
            lr_water_desc water = water_desc();
            water.position[1] = 1.0f;
            set_water(world, water);
            for (uint32_t i = 0; i < leaves; ++i) {
                lr_body_desc d = body_desc();
                d.orientation[0] = -1.0f, d.orientation[3] = 1.0f; // lies flat
                d.position[1] = 0.0001f + 0.0015f * static_cast<float>(i);
                add_body(world, batch, d);
            }
            steps(world, 360, 1.0f / 60.0f, 2);
            const lr_batch_view view = view_of(world, batch);
            for (uint32_t i = 0; i < leaves; ++i) CHECK((view.position[1][i] > 0.02f) == (density < water_density));
            if (density > water_density) CHECK(view.awake_count == 0);
        }
    }
}

// Contact has to know the added mass of the water: with that of air its impulses threw discs out of it.
TEST_CASE("bodies that fall on the ground under water gain no energy from it or from each other") {
    for (const bool curled : {false, true})
        for (const bool heap : {false, true})
            for (const bool field : {false, true}) {
                CAPTURE(curled);
                CAPTURE(heap);
                CAPTURE(field);
                lr_ellipsoid_desc shape = ellipsoid(0.035, 0.02, 0.0005, 1200.0);
                if (curled) shape.center_of_mass[0] = 0.01, shape.center_of_mass[2] = 0.0003;
                const Asset asset = make(shape);
                const World world = make(world_desc());
                const lr_batch batch = add_batch(world, loads(LR_LOADS_NONE), asset, 40);
                if (heap) set_pair(world, batch, batch);
                add_collider(world, collider_desc(LR_COLLIDER_PLANE));
                lr_water_desc water = water_desc();
                water.position[1] = 0.3f;
                set_water(world, water);
                const lr_vortex_desc vortex = initialised(lr_vortex_desc_init);
                if (field) REQUIRE(lr_world_add_vortex(world.get(), &vortex, nullptr) == LR_OK);
                Random random(5);
                const double apart = heap ? 0.04 : 0.12;
                for (int i = 0; i < 40; ++i)
                    add_body(world, batch,
                             turned_anyhow(random, {apart * (i % 5), 0.04 + 0.05 * (heap ? i / 20 : 0),
                                                    apart * (heap ? i / 5 % 4 : i / 5)}));
                float highest = 0.0f;
                for (int i = 0; i < 300; ++i) {
                    steps(world, 1, 1.0f / 60.0f, 4);
                    const lr_batch_view view = view_of(world, batch);
                    highest = std::max(highest, *std::max_element(view.position[1], view.position[1] + view.count));
                }
                CHECK(highest < 0.15f);
            }
}

// Under water they fall with some thousandths of gravity, which the static lock and the sleepers' trial have to know.
TEST_CASE("a stack of heavy leaves under water falls when its ground goes") {
    const Asset asset = make(ellipsoid(0.05, 0.03, 0.0003, 1100.0));
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, batch_desc(), asset, 12);
    set_pair(world, batch, batch);
    lr_collider_desc box = collider_desc(LR_COLLIDER_BOX);
    box.size[0] = box.size[2] = 0.5f, box.size[1] = 0.1f;
    box.position[1] = -0.1f;
    const lr_collider floor = add_collider(world, box);
    lr_water_desc water = water_desc();
    water.position[1] = 1.0f;
    set_water(world, water);
    for (int i = 0; i < 12; ++i) {
        lr_body_desc leaf = at_rest_at({0.0, 0.005 + 0.004 * i, 0.0});
        leaf.orientation[0] = leaf.orientation[3] = std::sqrt(0.5f);
        add_body(world, batch, leaf);
    }
    for (int i = 0; i < 600 && view_of(world, batch).awake_count != 0; ++i) steps(world, 1, 1.0f / 60.0f, 2);
    REQUIRE(view_of(world, batch).awake_count == 0);
    REQUIRE(lr_collider_destroy(world.get(), &floor, 1) == LR_OK);
    steps(world, 300, 1.0f / 60.0f, 2);
    const lr_batch_view view = view_of(world, batch);
    CHECK(*std::max_element(view.position[1], view.position[1] + view.count) < -0.01f);
}

TEST_CASE("floats of every kind come to rest at the step of a game") {
    const double shapes[][4] = {{0.005, 0.0025, 0.00005, 700.0}, {0.02, 0.01, 0.0001, 400.0},
                                {0.001, 0.001, 0.001, 500.0},    {0.01, 0.01, 0.01, 30.0},
                                {0.5, 0.2, 0.0005, 300.0},       {0.002, 0.05, 0.002, 600.0}};
    for (const auto& shape : shapes) {
        CAPTURE(shape[0]);
        CAPTURE(shape[3]);
        const Asset asset = make(ellipsoid(shape[0], shape[1], shape[2], shape[3]));
        const World world = make(world_desc());
        set_water(world, water_desc());
        const lr_batch batch = add_batch(world, loads(LR_LOADS_AERODYNAMIC), asset, 30);
        std::vector<lr_body> bodies;
        for (int i = 0; i < 30; ++i) {
            lr_body_desc d = at_height(0.05 + 0.02 * i);
            d.orientation[0] = narrow(std::sin(i));
            d.orientation[1] = narrow(std::cos(2.3 * i));
            bodies.push_back(add_body(world, batch, d));
        }
        steps(world, 2400, 1.0f / 60.0f);
        float fastest = 0.0f;
        for (lr_body body : bodies)
            for (float v : state_of(world, body).linear_velocity) fastest = std::max(fastest, std::abs(v));
        CHECK(fastest < 0.1f);
    }
}

TEST_CASE("heavy discs enter the water and sink through it slower than they fell") {
    const Asset disc = make(ellipsoid(0.02, 0.02, 0.0005, 2700.0));
    const World world = make(world_desc());
    set_water(world, water_desc());
    constexpr uint32_t count = 64;
    const lr_batch batch = add_batch(world, loads(LR_LOADS_AERODYNAMIC), disc, count);
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
    const lr_batch batch = add_batch(world, loads(LR_LOADS_AERODYNAMIC), disc, 1);
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

TEST_CASE("a current carries what floats") {
    const Asset ball = make(ellipsoid(0.05, 0.05, 0.05, 600.0));
    const World world = make(world_desc());
    lr_water_desc d = water_desc();
    d.current[0] = 1.0f;
    set_water(world, d);
    const lr_batch batch = add_batch(world, loads(LR_LOADS_AERODYNAMIC), ball, 1);
    no_turbulence(world, batch);
    const lr_body body = add_body(world, batch, at_height(0.0));
    steps(world, 1800, 1.0f / 60.0f);
    const float speed = state_of(world, body).linear_velocity[0];
    CHECK(speed > 0.9f);
    CHECK(speed < 1.01f);
}

TEST_CASE("small bodies ride on long waves") {
    const Asset ball = make(ellipsoid(0.02, 0.02, 0.02, 500.0));
    const World world = make(world_desc());
    lr_water_desc d = water_desc();
    d.wave_count = 1;
    d.waves[0] = {{0.0f, 3.0f, 2.0f}, 10.0f, 0.3f, 0.5f};
    set_water(world, d);
    const lr_batch batch = add_batch(world, loads(LR_LOADS_AERODYNAMIC), ball, 1);
    no_turbulence(world, batch);
    const lr_body body = add_body(world, batch, at_height(0.3 * std::cos(0.5)));
    const double k = 2.0 * pi / 10.0, omega = std::sqrt(g * k);
    double worst = 0.0, most = -1.0, least = 1.0, travelled = 0.0;
    for (int i = 0; i < 1200; ++i) {
        steps(world, 1, 1.0f / 60.0f, 2);
        const lr_body_state s = state_of(world, body);
        const double t = info_of(world).time, y = wide(s.position[1]), z = wide(s.position[2]);
        const double height = 0.3 * std::cos(k * z - omega * t + 0.5);
        if (t > 4.0)
            worst = std::max(worst, std::abs(y - height)), most = std::max(most, y), least = std::min(least, y);
        travelled = z;
    }
    CHECK(worst < 0.05);
    CHECK(most > 0.2);
    CHECK(least < -0.2);
    CHECK(std::abs(travelled) < 10.0); // Stokes drift, not the wave's own speed of 4 m/s
}

TEST_CASE("a callback's surface is as good as a plane there, and one that is none is refused") {
    const Asset ball = make(ellipsoid(0.05, 0.05, 0.05, 500.0));
    const auto run = [&](float plane, float raised, bool callback) {
        const World world = make(world_desc());
        lr_water_desc d = water_desc();
        d.position[1] = plane;
        d.reach = 1.0f;
        set_water(world, d);
        if (callback)
            REQUIRE(lr_world_set_water_callback(
                        world.get(),
                        [](void* user, const lr_water_query* q) {
                            for (uint32_t i = 0; i < q->count; ++i) q->height[i] = *static_cast<float*>(user);
                        },
                        &raised) == LR_OK);
        const lr_batch batch = add_batch(world, ball, 1);
        lr_body_desc b = at_height(0.3);
        b.noise_seed = 1;
        const lr_body body = add_body(world, batch, b);
        steps(world, 120, 1.0f / 60.0f, 2);
        return state_of(world, body);
    };
    const lr_body_state plane = run(0.25f, 0.0f, false), raised = run(-0.25f, 0.5f, true);
    CHECK(std::abs(plane.position[1] - raised.position[1]) < 1e-3f);
    CHECK(same_bits(run(0.25f, std::nanf(""), true), run(0.25f, 0.0f, true)));
    CHECK(same_bits(run(0.25f, 2.0f, true), run(0.25f, 0.0f, true))); // beyond its reach
}

TEST_CASE("bodies that wind or forces carry into the water enter it, however many substeps a step has") {
    for (const bool blown : {true, false}) {
        const Asset asset = blown ? leaf() : make(ellipsoid(0.05, 0.05, 0.05, 300.0));
        const auto depth = [&](int count) {
            const World world = make(world_desc());
            lr_batch_desc desc = loads(LR_LOADS_AERODYNAMIC);
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
        const lr_batch batch = add_batch(world, loads(models[i / 3 % 3]), asset, 1);
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
