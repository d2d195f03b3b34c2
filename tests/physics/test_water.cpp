// Bodies in two fluids, in currents, on waves and on the ground under water: docs/reference/wind_and_water.md.
#include "support/body_contact.h"
#include "support/colliders.h"
#include "support/random.h"
#include "support/water.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace test;

namespace {

constexpr double pi = std::numbers::pi, g = 9.81;

} // namespace

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
                        const lr_batch batch = add_batch(world, with_loads(model, scheme), asset, 1);
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
                    const lr_batch batch = add_batch(world, with_loads(model, integrator), asset, 1, full);
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
TEST_CASE("bodies that fall on the ground under water gain no energy from it or from each other" *
          doctest::test_suite("exact")) {
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
                const lr_batch batch = add_batch(world, with_loads(LR_LOADS_NONE), asset, 40);
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

TEST_CASE("a current carries what floats") {
    const Asset ball = make(ellipsoid(0.05, 0.05, 0.05, 600.0));
    const World world = make(world_desc());
    lr_water_desc d = water_desc();
    d.current[0] = 1.0f;
    set_water(world, d);
    const lr_batch batch = add_batch(world, with_loads(LR_LOADS_AERODYNAMIC), ball, 1);
    no_turbulence(world, batch);
    const lr_body body = add_body(world, batch, at_height(0.0));
    steps(world, 1800, 1.0f / 60.0f);
    const float speed = state_of(world, body).linear_velocity[0];
    CHECK(speed > 0.9f);
    CHECK(speed < 1.01f);
}

// Where both fluids drag alike on equal faces, which those of a sphere are not: rho_a (U - v)^2 = rho_w v^2. A float that is lighter is driven faster.
TEST_CASE("wind drives what floats" * doctest::test_suite("exact")) {
    for (const bool flat : {false, true})
        for (const double share : {0.3, 0.5, 0.8}) {
            CAPTURE(flat);
            CAPTURE(share);
            const World world = make(world_desc());
            set_water(world, water_desc());
            const Asset asset = make(ellipsoid(0.05, flat ? 0.001 : 0.05, 0.05, share * water_density));
            const lr_batch batch = add_batch(world, with_loads(LR_LOADS_AERODYNAMIC), asset, 1);
            const lr_body body = add_body(world, batch, at_rest_at({0.0, 0.0, 0.0}));
            set_wind(world, 4.0f, 0.0f, 0.0f);
            steps(world, 3000, 1.0f / 60.0f, 2);
            const double x = state_of(world, body).position[0];
            steps(world, 600, 1.0f / 60.0f, 2);
            const double drift = (double{state_of(world, body).position[0]} - x) / 10.0;
            const double ratio = std::sqrt(share * water_density / ((1.0 - share) * 1.2));
            CHECK(drift == doctest::Approx(4.0 / (1.0 + ratio)).epsilon(flat ? 0.01 : 0.12));
        }
}

TEST_CASE("small bodies ride on long waves") {
    const Asset ball = make(ellipsoid(0.02, 0.02, 0.02, 500.0));
    const World world = make(world_desc());
    lr_water_desc d = water_desc();
    d.wave_count = 1;
    d.waves[0] = {{0.0f, 3.0f, 2.0f}, 10.0f, 0.3f, 0.5f};
    set_water(world, d);
    const lr_batch batch = add_batch(world, with_loads(LR_LOADS_AERODYNAMIC), ball, 1);
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

namespace {

// On one wave, of the slope 0.16 and 2 m long or as given: means over the bodies' last two seconds of ten.
struct OnWave {
    double depth = 0.0, spin = 0.0; // of the centre below the surface, m; rad/s
};
OnWave on_wave(const Asset& asset, int32_t loads, double depth, double length = 2.0, double slope = 0.16) {
    const double k = 2.0 * pi / length, amplitude = slope / k, omega = std::sqrt(g * k);
    const World world = make(world_desc());
    lr_water_desc d = water_desc();
    d.wave_count = 1;
    d.waves[0] = {{1.0f, 0.0f, 0.0f}, narrow(length), narrow(amplitude), 0.0f};
    set_water(world, d);
    const lr_batch batch = add_batch(world, with_loads(loads), asset, 10);
    no_turbulence(world, batch);
    std::vector<lr_body> bodies;
    for (int i = 0; i < 10; ++i) {
        const double x = 0.37 * i, faded = amplitude * omega * std::exp(-k * depth);
        lr_body_desc b = at_height(amplitude * std::cos(k * x) - depth);
        b.position[0] = narrow(x);
        b.linear_velocity[0] = narrow(faded * std::cos(k * x)), b.linear_velocity[1] = narrow(faded * std::sin(k * x));
        bodies.push_back(add_body(world, batch, b));
    }
    OnWave mean;
    steps(world, 480, 1.0f / 60.0f);
    for (int i = 0; i < 120; ++i) {
        steps(world, 1, 1.0f / 60.0f);
        for (lr_body body : bodies) {
            const lr_body_state s = state_of(world, body);
            const double at = k * wide(s.position[0]) - omega * info_of(world).time;
            mean.depth += (amplitude * std::cos(at) - wide(s.position[1])) / 1200.0;
            mean.spin += wide(std::hypot(s.angular_velocity[0], s.angular_velocity[1], s.angular_velocity[2])) / 1200.0;
        }
    }
    return mean;
}

} // namespace

// Discs and petals were held 2 to 15 cm below the surface, and neutral balls sank by a metre or two in ten seconds.
TEST_CASE("on waves small bodies keep the depth that they have on still water") {
    for (const int32_t loads : {LR_LOADS_NONE, LR_LOADS_AERODYNAMIC}) {
        CAPTURE(loads);
        const OnWave ball = on_wave(make(ellipsoid(0.004, 0.004, 0.004, 800.0)), loads, 0.0);
        CHECK(ball.depth == doctest::Approx(0.004 * draught(800.0)).epsilon(0.1));
        CHECK(on_wave(make(ellipsoid(0.02, 0.02, 0.02, 998.0)), loads, 0.1, 10.0).depth < 0.4);
    }
    const Asset disc = make(ellipsoid(0.008, 0.0001, 0.008, 800.0));
    CHECK(std::abs(on_wave(disc, LR_LOADS_AERODYNAMIC, 0.0, 2.0, 0.31).depth) < 0.007);
}

// Buoyancy that was not along the surface's normal turned them: one of 4 mm without loads ever faster, at 75 rad/s after 40 s.
TEST_CASE("waves turn no balls") {
    for (const double density : {300.0, 800.0})
        CHECK(on_wave(make(ellipsoid(0.03, 0.03, 0.03, density)), LR_LOADS_NONE, 0.0).spin < 0.05);
}

// The wave at their centre moved them: a raft of half a metre in ripples of 30 cm and 8 mm bobbed by 8 mm, a log of a metre along them by 12 mm.
TEST_CASE("waves shorter than a body do not lift it, by its length along them") {
    const auto bobs = [](const Asset& asset, float across) {
        const World world = make(world_desc());
        lr_water_desc d = water_desc();
        d.wave_count = 1;
        d.waves[0] = {{1.0f - across, 0.0f, across}, 0.3f, 0.008f, 0.0f};
        set_water(world, d);
        const lr_batch batch = add_batch(world, with_loads(LR_LOADS_AERODYNAMIC), asset, 1);
        no_turbulence(world, batch);
        const lr_body body = add_body(world, batch, at_height(0.0));
        steps(world, 600, 1.0f / 60.0f, 2);
        double most = 0.0;
        for (int i = 0; i < 120; ++i) {
            steps(world, 1, 1.0f / 60.0f, 2);
            most = std::max(most, std::abs(wide(state_of(world, body).position[1])));
        }
        return most;
    };
    CHECK(bobs(make(ellipsoid(0.25, 0.05, 0.25, 500.0)), 0.0f) < 0.002);
    const Asset log = make(ellipsoid(0.5, 0.015, 0.015, 500.0)); // along x
    CHECK(bobs(log, 0.0f) < 0.001);
    CHECK(bobs(log, 1.0f) > 0.005);
}

// They take a wake of some centimetres a second with them into the water. Some kept it, and sailed across the pond.
TEST_CASE("leaves that fall into still water come to rest there") {
    const Asset leaf = make(ellipsoid(0.035, 0.02, 0.00015, 350.0));
    const World world = make(world_desc());
    set_water(world, water_desc());
    const lr_batch batch = add_batch(world, batch_desc(), leaf, 100);
    const float low[3] = {-2.0f, 1.0f, -2.0f}, high[3] = {2.0f, 1.0f, 2.0f};
    REQUIRE(lr_batch_spawn_box(world.get(), batch, low, high, 100, nullptr) == LR_OK);
    steps(world, 1800, 1.0f / 60.0f, 4);
    float velocities[100][6];
    REQUIRE(lr_batch_write_velocities(world.get(), batch, velocities, 0, 100, nullptr) == LR_OK);
    for (const auto& v : velocities) CHECK(std::hypot(v[0], v[1], v[2]) < 0.008f);
}

// Seen by someone who moves with water and air, waves on a current are those of still water: bodies ride on them alike.
TEST_CASE("a current carries waves along with what floats on them") {
    const Asset disc = make(ellipsoid(0.03, 0.003, 0.03, 200.0));
    lr_body_state state[2];
    for (const bool moving : {false, true}) {
        const World world = make(world_desc());
        const float along = moving ? 0.5f : 0.0f;
        lr_water_desc d = water_desc();
        d.wave_count = 1;
        d.waves[0] = {{1.0f, 0.0f, 0.0f}, 2.0f, 0.05f, 0.5f};
        d.current[0] = along;
        set_water(world, d);
        set_wind(world, along, 0.0f, 0.0f);
        const lr_batch batch = add_batch(world, with_loads(LR_LOADS_AERODYNAMIC), disc, 1);
        no_turbulence(world, batch);
        lr_body_desc b = at_height(0.045);
        b.linear_velocity[0] = along;
        const lr_body body = add_body(world, batch, b);
        steps(world, 300, 1.0f / 60.0f, 4);
        state[moving] = state_of(world, body);
        state[moving].position[0] -= 5.0f * along;
        state[moving].linear_velocity[0] -= along;
    }
    for (size_t k = 0; k < 3; ++k) {
        CHECK(std::abs(state[0].position[k] - state[1].position[k]) < 2e-4f);
        CHECK(std::abs(state[0].linear_velocity[k] - state[1].linear_velocity[k]) < 1e-3f);
    }
}

// If a new current counted for the past too, a change of 1 mm/s would move the crests by 3.6 m after an hour.
TEST_CASE("another current leaves the waves where they are") {
    const Asset ball = make(ellipsoid(0.05, 0.05, 0.05, 500.0));
    float height[2];
    for (const bool trembles : {false, true}) {
        const World world = make(world_desc());
        lr_water_desc d = water_desc();
        d.wave_count = 1;
        d.waves[0] = {{1.0f, 0.0f, 0.0f}, 2.0f, 0.05f, 0.5f};
        set_water(world, d);
        steps(world, 60, 60.0f, 6000);
        const lr_body body = add_body(world, add_batch(world, batch_desc(), ball, 1), at_height(0.0));
        for (int i = 0; i < 300; ++i) {
            d.current[0] = trembles && i % 2 == 0 ? 0.001f : 0.0f;
            set_water(world, d);
            steps(world, 1, 1.0f / 60.0f, 2);
        }
        height[trembles] = state_of(world, body).position[1];
    }
    CHECK(std::abs(height[0] - height[1]) < 1e-3f);
}

TEST_CASE("floats go with a plane that is moved, if the current has its speed") {
    const Asset leaf = make(ellipsoid(0.04, 0.02, 5e-4, 500.0));
    for (const float speed : {0.1f, -0.1f}) {
        const World world = make(world_desc());
        lr_water_desc d = water_desc();
        set_water(world, d);
        const lr_body body = add_body(world, add_batch(world, leaf, 1), at_height(0.001));
        steps(world, 120, 1.0f / 60.0f, 2);
        const float draught = state_of(world, body).position[1];
        d.current[1] = speed;
        for (int i = 0; i < 480; ++i) {
            d.position[1] = speed * static_cast<float>(i) / 60.0f;
            set_water(world, d);
            steps(world, 1, 1.0f / 60.0f, 2);
        }
        CHECK(std::abs(state_of(world, body).position[1] - 8.0f * speed - draught) < 2e-3f);
    }
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
