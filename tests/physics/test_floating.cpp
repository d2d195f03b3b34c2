// Bodies that float, against closed forms: docs/reference/wind_and_water.md.
#include "support/colliders.h"
#include "support/water.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace test;

namespace {

constexpr double pi = std::numbers::pi, g = 9.81;

} // namespace

TEST_CASE("a floating body comes to rest at Archimedes' draught" * doctest::test_suite("exact")) {
    for (double density : {50.0, 250.0, 500.0, 900.0})
        for (bool full : {false, true}) {
            CAPTURE(density);
            CAPTURE(full);
            const Asset ball = make(ellipsoid(0.05, 0.05, 0.05, density));
            const World world = make(world_desc());
            set_water(world, water_desc());
            const lr_batch batch = add_batch(world, with_loads(LR_LOADS_AERODYNAMIC), ball, 1, full);
            const lr_body body = add_body(world, batch, at_height(0.08));
            no_turbulence(world, batch);
            steps(world, 14400, 1.0f / 60.0f, 2);
            const lr_body_state s = state_of(world, body);
            // Quadratic drag takes long to end the motion.
            CHECK(std::abs(wide(s.position[1]) + 0.05 * draught(density)) < 5e-4);
            CHECK(std::abs(s.linear_velocity[1]) < 0.006f);
        }
}

TEST_CASE("a floating body bobs with its closed form's frequency" * doctest::test_suite("exact")) {
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
                const lr_batch batch = add_batch(world, with_loads(LR_LOADS_NONE), asset, 1, full);
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
                CHECK(2.0 * pi * 6.0 / (latest - first) == doctest::Approx(omega).epsilon(0.012));
            }
}

namespace {

// Without drag: damping over critical damping of a small heave, from successive turning points, and its period.
struct Decay {
    double damping, period;
};
Decay decay_of(const lr_ellipsoid_desc& shape, float dt, bool full = false, double amplitude = 0.002,
               double scale = 1.0) {
    const Asset asset = make(shape);
    const World world = make(world_desc());
    set_water(world, water_desc());
    const lr_batch batch = add_batch(world, with_loads(LR_LOADS_NONE), asset, 1, full);
    const double half = scale * shape.semi_axes[1], rest = -half * draught(shape.density);
    lr_body_desc d = at_height(rest + amplitude * half);
    d.scale = narrow(scale);
    const lr_body body = add_body(world, batch, d);
    double highest[4] = {}, times[4] = {}, y[2] = {};
    int found = 0;
    for (int i = 0; i < 100000 && found < 4; ++i) {
        steps(world, 1, dt);
        const double now = wide(state_of(world, body).position[1]) - rest;
        if (i > 1 && std::abs(y[1]) > std::abs(y[0]) && std::abs(y[1]) >= std::abs(now) && std::abs(y[1]) > 1e-7) {
            // The turning point of a parabola.
            const double slope = 0.5 * (now - y[0]), bend = now - 2.0 * y[1] + y[0];
            highest[found] = y[1] - 0.5 * slope * slope / bend;
            times[found++] = (i - slope / bend) * wide(dt);
        }
        y[0] = y[1], y[1] = now;
    }
    REQUIRE(found == 4);
    const double rate = std::log(std::abs(highest[1] / highest[3])) / (2.0 * pi); // of one cycle
    return {rate / std::sqrt(1.0 + rate * rate), times[3] - times[1]};
}

} // namespace

TEST_CASE("bobbing decays by the waves that the body makes" * doctest::test_suite("exact")) {
    struct Shape {
        double a, c, b;
    };
    // A ball, a cork, a spar, a thick disc and a log.
    for (const Shape s :
         {Shape{0.15, 0.15, 0.15}, {0.01, 0.012, 0.01}, {0.02, 0.08, 0.02}, {0.1, 0.03, 0.1}, {0.2, 0.02, 0.03}})
        for (double density : {300.0, 500.0, 800.0})
            for (bool full : {false, true}) {
                CAPTURE(s.a);
                CAPTURE(s.c);
                CAPTURE(density);
                CAPTURE(full);
                const lr_ellipsoid_desc shape = ellipsoid(s.a, s.c, s.b, density);
                const lr_asset_info info = info_of(make(shape));
                const double s0 = draught(density), part = 1.0 - s0 * s0;
                const double moved = info.mass + info.added_mass[7] / air_density * density;
                const double damping = heave_damping(pi * s.a * s.b * part, info.volume * density / water_density,
                                                     info.mass, moved, std::sqrt(part) * (s.a - s.b));
                const double omega = std::sqrt(water_density * g * pi * s.a * s.b * part / moved);
                const double expected = damping / (2.0 * moved * omega);
                CHECK(decay_of(shape, narrow(0.01 / omega), full).damping == doctest::Approx(expected).epsilon(0.05));
            }
}

TEST_CASE("a half immersed ball and a thin disc bob as linear wave theory has it") {
    // Hulme (1982), table 1: added mass and damping over omega of a heaving hemisphere, over 2/3 pi rho a^3, at k a.
    const double hulme[][3] = {{0.9, 0.4464, 0.2691}, {1.0, 0.4284, 0.2484}, {1.2, 0.4047, 0.2096}};
    // It bobs where k a = 1.5/(1 + A).
    const double ka = 1.048, part = (ka - hulme[1][0]) / (hulme[2][0] - hulme[1][0]);
    const double added = hulme[1][1] + part * (hulme[2][1] - hulme[1][1]);
    const double damping = hulme[1][2] + part * (hulme[2][2] - hulme[1][2]);
    REQUIRE(1.5 / (1.0 + added) == doctest::Approx(ka).epsilon(0.01));
    for (double radius : {0.01, 0.15, 1.0}) {
        CAPTURE(radius);
        const Decay ball = decay_of(ellipsoid(0.1, 0.1, 0.1, 0.5 * (water_density + air_density)),
                                    narrow(0.002 * std::sqrt(radius)), false, 0.002, 10.0 * radius);
        CHECK(ball.damping == doctest::Approx(0.5 * damping / (1.0 + added)).epsilon(0.1));
        CHECK(ball.period == doctest::Approx(2.0 * pi * std::sqrt(radius / (g * ka))).epsilon(0.05));
    }
    // A disc without draught, by the integral equation of its pressure: k a = 2.2, B/(omega A) = 0.55.
    const Decay disc = decay_of(ellipsoid(0.1, 0.002, 0.1, 499.6), 0.0002f, false, 0.05);
    CHECK(disc.damping == doctest::Approx(0.5 * 0.55).epsilon(0.12));
    CHECK(disc.period == doctest::Approx(2.0 * pi * std::sqrt(0.1 / (g * 2.2))).epsilon(0.1));
}

TEST_CASE("bobbing decays at any step, and by the same waves at short ones") {
    const lr_ellipsoid_desc shape =
        ellipsoid(0.1, 0.1, 0.1, 0.5 * (water_density + air_density)); // at rest half under, however long the step
    const double exact = decay_of(shape, 2e-4f).damping;
    const auto error = [&](double dt) { return std::abs(decay_of(shape, narrow(dt)).damping - exact); };
    CHECK(error(1.0 / 60.0) < 0.03 * exact);
    const Asset asset = make(shape);
    for (float dt : {0.1f, 0.3f, 1.0f}) {
        CAPTURE(dt);
        const World world = make(world_desc());
        set_water(world, water_desc());
        const lr_batch batch = add_batch(world, with_loads(LR_LOADS_NONE), asset, 1);
        const lr_body body = add_body(world, batch, at_height(0.05));
        steps(world, 600, dt);
        const lr_body_state s = state_of(world, body);
        CHECK(std::abs(s.position[1]) < 1e-3f);
        CHECK(std::abs(s.linear_velocity[1]) < 1e-3f);
    }
}

TEST_CASE("a leaf comes to lie flat on the water") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    set_water(world, water_desc());
    const lr_batch batch = add_batch(world, with_loads(LR_LOADS_AERODYNAMIC), asset, 1);
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

// Thinner than their fall in a step they count as that thick. They lay at the draught of a body so thick, up to 11 mm below the surface.
TEST_CASE("thin floats lie at their own draught at the steps of games") {
    for (const double density : {50.0, 500.0, 700.0, 900.0})
        for (const float dt : {1.0f / 30.0f, 1.0f / 60.0f}) {
            CAPTURE(density);
            CAPTURE(dt);
            const World world = make(world_desc());
            set_water(world, water_desc());
            const Asset card = make(ellipsoid(0.04, 0.0002, 0.03, density));
            const lr_batch batch = add_batch(world, with_loads(LR_LOADS_AERODYNAMIC), card, 1);
            const lr_body body = add_body(world, batch, at_height(0.002));
            steps(world, 1200, dt);
            CHECK(std::abs(wide(state_of(world, body).position[1]) + 0.0002 * draught(density)) < 3e-4);
        }
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
        const lr_batch batch = add_batch(world, with_loads(LR_LOADS_AERODYNAMIC), asset, 30);
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

namespace {

// Corks over still water that is three metres deep.
struct Corks {
    Asset asset = make(ellipsoid(0.011, 0.02, 0.011, 200.0));
    World world = make(world_desc());
    lr_batch batch{};

    explicit Corks(const lr_water_desc& water = water_desc()) {
        set_water(world, water);
        lr_collider_desc ground = collider_desc(LR_COLLIDER_PLANE);
        ground.position[1] = -3.0f;
        add_collider(world, ground);
        batch = add_batch(world, with_loads(LR_LOADS_AERODYNAMIC), asset, 8);
        for (int i = 0; i < 8; ++i) {
            lr_body_desc d = at_height(0.002 * i);
            d.position[0] = 0.1f * static_cast<float>(i);
            add_body(world, batch, d);
        }
    }
    uint64_t awake() const { return view_of(world, batch).awake_count; }
    void rest() const {
        for (int i = 0; i < 7200 && awake() != 0; ++i) steps(world, 1, 1.0f / 60.0f, 2);
        REQUIRE(awake() == 0);
    }
};

} // namespace

TEST_CASE("floats fall asleep on still water, keep their places, and wake when wind, water or a force moves them") {
    for (const int cause : {0, 1, 2, 3}) {
        CAPTURE(cause);
        const Corks corks;
        corks.rest();
        const lr_batch_view at = view_of(corks.world, corks.batch);
        std::vector<float> heights(at.position[1], at.position[1] + at.count);
        set_wind(corks.world, 0.05f, 0.0f, 0.0f); // too weak
        steps(corks.world, 100, 1.0f / 60.0f, 2);
        REQUIRE(corks.awake() == 0);
        const lr_batch_view later = view_of(corks.world, corks.batch);
        for (uint32_t i = 0; i < later.count; ++i) CHECK(later.position[1][i] == heights[i]);
        for (float y : heights) CHECK(std::abs(wide(y) + 0.02 * draught(200.0)) < 0.012); // upright or lying
        if (cause == 0) set_wind(corks.world, 1.0f, 0.0f, 0.0f);
        if (cause == 1) {
            lr_water_desc swell = water_desc();
            swell.wave_count = 1;
            swell.waves[0] = {{1.0f, 0.0f, 0.0f}, 2.0f, 0.05f, 0.0f};
            set_water(corks.world, swell);
        }
        if (cause == 2) REQUIRE(lr_world_set_water(corks.world.get(), nullptr) == LR_OK);
        if (cause == 3)
            REQUIRE(lr_world_set_water_callback(
                        corks.world.get(), [](void*, const lr_water_query*) {}, nullptr) == LR_OK);
        steps(corks.world, 17, 1.0f / 60.0f, 2);
        CHECK(corks.awake() == 8);
    }
}

TEST_CASE("floats do not sleep on waves") {
    lr_water_desc swell = water_desc();
    swell.wave_count = 1;
    swell.waves[0] = {{1.0f, 0.0f, 0.0f}, 5.0f, 0.001f, 0.0f};
    const Corks corks(swell);
    steps(corks.world, 3600, 1.0f / 60.0f, 2);
    CHECK(corks.awake() == 8);
}

TEST_CASE("floats fall asleep in the same step from a snapshot") {
    const Corks corks, again;
    steps(corks.world, 300, 1.0f / 60.0f, 2);
    const std::vector<unsigned char> bytes = snapshot_of(corks.world);
    REQUIRE(lr_world_snapshot_restore(again.world.get(), bytes.data(), bytes.size()) == LR_OK);
    for (int i = 0; i < 7200 && corks.awake() != 0; ++i) {
        steps(corks.world, 1, 1.0f / 60.0f, 2);
        steps(again.world, 1, 1.0f / 60.0f, 2);
        REQUIRE(corks.awake() == again.awake());
    }
    CHECK(corks.awake() == 0);
    CHECK(hash_of(corks.world) == hash_of(again.world));
}
