// Bodies on bodies: stacks, plates, a heavy body on a light one, friction between them.
#include "support/body_contact.h"
#include "support/quick.h"

#include <numbers>

using namespace test;

namespace {

constexpr double gravity = 9.81, degree = std::numbers::pi / 180.0;
constexpr float frame = 1.0f / 60.0f;

struct Stack {
    World world = make(world_desc());
    std::vector<Asset> assets;
    std::vector<lr_batch> batches;
    std::vector<lr_body> bodies;
    float friction, restitution;

    explicit Stack(float mu = 0.5f, float e = 0.0f) : friction(mu), restitution(e) {
        add_collider(world, surface(collider_desc(LR_COLLIDER_PLANE), mu, e));
    }
    lr_batch add(Asset asset, const lr_batch_desc& desc = unloaded()) {
        assets.push_back(std::move(asset));
        const lr_batch batch = add_batch(world, desc, assets.back(), 64);
        lr_batch_contact c = contact_desc(friction, restitution, 0.05f);
        c.flags = 0;
        set_contact(world, batch, c);
        batches.push_back(batch);
        for (lr_batch other : batches) set_pair(world, batch, other);
        return batch;
    }
    lr_body put_at(lr_batch batch, const Vec& position, const Quat& turn = {0, 0, 0, 1}, double scale = 1.0) {
        lr_body_desc d = at_rest_at(position);
        put(d.orientation, turn);
        d.scale = narrow(scale);
        bodies.push_back(add_body(world, batch, d));
        return bodies.back();
    }
    Vec position(size_t i) const { return vec(state_of(world, bodies[i]).position); }
    uint64_t awake() const { return info_of(world).awake_count; }
};

} // namespace

TEST_CASE("stacks of boxes stay, and come to rest") {
    for (uint32_t high : {2u, 5u, 10u})
        for (double size : {0.01, 0.1, 1.0})
            for (uint32_t substeps : {1u, 2u, 4u}) {
                // g h^2 is a quarter of such a box: too few sweeps for the height in the first substep, and it leans.
                if (high > 5 && size < 0.05 && substeps < 2) continue;
                CAPTURE(high);
                CAPTURE(size);
                CAPTURE(substeps);
                Stack s;
                const lr_batch batch = s.add(make(rigid_box(size, size, size, 500.0)));
                for (uint32_t i = 0; i < high; ++i)
                    s.put_at(batch, {0.04 * size * (i % 2), (0.5 + i) * size, 0.03 * size * (i % 3)});
                std::vector<Vec> from;
                for (uint32_t i = 0; i < high; ++i) from.push_back(s.position(i));
                int rest = -1;
                for (int n = 0; n < 600; ++n) {
                    steps(s.world, 1, frame, substeps);
                    if (s.awake() == 0 && rest < 0) rest = n;
                }
                double moved = 0.0;
                for (uint32_t i = 0; i < high; ++i) moved = std::max(moved, length(s.position(i) - from[i]) / size);
                MESSAGE(high << " of " << size << " x" << substeps << ": moved " << moved << ", at rest after "
                             << rest);
                CHECK(moved < (size > 0.5 && substeps > 1 ? 0.01 : 0.1));
                CHECK(rest >= 0);
            }
}

TEST_CASE("a stack that may not rest still stays") {
    Stack s;
    const lr_batch batch = s.add(make(rigid_box(0.1, 0.1, 0.1, 500.0)));
    lr_batch_contact c = contact_desc(0.5f, 0.0f, 0.05f);
    set_contact(s.world, batch, c);
    for (uint32_t i = 0; i < 5; ++i) s.put_at(batch, {0.0, (0.5 + i) * 0.1, 0.0});
    steps(s.world, 60, frame, 2);
    std::vector<Vec> from;
    for (uint32_t i = 0; i < 5; ++i) from.push_back(s.position(i));
    steps(s.world, 1200, frame, 2);
    double moved = 0.0;
    for (uint32_t i = 0; i < 5; ++i) moved = std::max(moved, length(s.position(i) - from[i]) / 0.1);
    MESSAGE("moved " << moved);
    CHECK(moved < 0.01);
}

TEST_CASE("plates and leaves lie on each other, however they fall flat") {
    for (int kind : {0, 1, 2})
        for (uint32_t count : {2u, 6u}) {
            CAPTURE(kind);
            CAPTURE(count);
            Stack s;
            const lr_batch batch = kind == 0   ? s.add(make(rigid_box(0.09, 0.0004, 0.06, 700.0)))
                                   : kind == 1 ? s.add(make(ellipsoid(0.04, 0.02, 0.0002, 500.0)))
                                               : s.add(leaf());
            for (uint32_t i = 0; i < count; ++i) {
                const Quat flat = kind == 0 ? Quat{0, 0, 0, 1} : about({1, 0, 0}, 0.5 * std::numbers::pi);
                s.put_at(batch, {0.003 * i, 0.002 + 0.003 * i, 0.002 * (i % 2)},
                         product(about({0, 1, 0}, 0.6 * i), flat));
            }
            int rest = -1;
            for (int n = 0; n < 600 && rest < 0; ++n) {
                steps(s.world, 1, frame, 2);
                if (s.awake() == 0) rest = n;
            }
            double low = 1.0, high = 0.0;
            for (uint32_t i = 0; i < count; ++i) {
                low = std::min(low, s.position(i)[1]);
                high = std::max(high, s.position(i)[1]);
            }
            MESSAGE(kind << ", " << count << ": rest after " << rest << ", from " << low << " to " << high);
            CHECK(rest >= 0);
            CHECK(low > -1e-4 * 0.08);
            CHECK(high > low + 1e-4 * (count - 1) * 0.25);
        }
}

TEST_CASE("a box ten times as heavy lies on a light one") {
    for (double ratio : {3.0, 10.0, 30.0}) {
        Stack s;
        const lr_batch light = s.add(make(rigid_box(0.1, 0.1, 0.1, 100.0)));
        const lr_batch heavy = s.add(make(rigid_box(0.1, 0.1, 0.1, 100.0 * ratio)));
        s.put_at(light, {0.0, 0.05, 0.0});
        s.put_at(heavy, {0.01, 0.15, 0.0});
        steps(s.world, 600, frame, 2);
        const double below = s.position(0)[1] - 0.05, above = s.position(1)[1] - 0.15;
        MESSAGE(ratio << ": " << below << ", " << above << ", awake " << s.awake());
        CHECK(s.awake() == 0);
        CHECK(std::abs(below) < 0.001);
        CHECK(std::abs(above) < 0.001);
        CHECK(std::abs(s.position(1)[0] - 0.01) < (ratio > 10.0 ? 0.02 : 0.002));
    }
}

// Gravity is tilted; the slab below stays on the ground by friction.
TEST_CASE("a box on another body sticks below the angle of friction and slides as it should above" *
          doctest::test_suite("exact")) {
    for (double mu : {0.2, 0.5, 0.9})
        for (double size : {0.01, 0.05, 1.0})
            for (double weight : {1.0, 10.0}) {
                if (weight > 1.0 && quick()) continue;
                const double cone = std::atan(mu);
                const lr_rigid_desc box = rigid_box(size, 0.3 * size, 0.6 * size, 300.0);
                const auto slid = [&](double angle, double& speed) {
                    lr_world_desc wd = world_desc();
                    put(wd.gravity, Vec{gravity * std::sin(angle), -gravity * std::cos(angle), 0.0});
                    const World world = make(wd);
                    add_collider(world, surface(collider_desc(LR_COLLIDER_PLANE), 10.0f));
                    const double big = 20.0 * size;
                    const Asset assets[2] = {make(box), make(rigid_box(big, size, big, 300.0 * weight))};
                    const lr_batch above = add_batch(world, unloaded(), assets[0], 1);
                    const lr_batch slab = add_batch(world, unloaded(), assets[1], 1);
                    for (lr_batch b : {above, slab}) set_contact(world, b, contact_desc(narrow(mu), 0.0f));
                    set_pair(world, above, slab);
                    const lr_body lies = add_body(world, slab, at_rest_at({0.0, 0.5 * size, 0.0}));
                    const lr_body body = add_body(world, above, at_rest_at({-8.0 * size, 1.15 * size, 0.13 * size}));
                    const int frames = size > 0.5 ? 60 : size > 0.02 ? 20 : 12;
                    steps(world, 6, frame, 4);
                    const float from = state_of(world, body).position[0];
                    steps(world, frames, frame, 4);
                    speed = wide(state_of(world, body).linear_velocity[0]) / (wide(frame) * (frames + 6));
                    CHECK(std::abs(state_of(world, lies).position[0]) < 1e-3 * size);
                    return wide(state_of(world, body).position[0] - from) / size;
                };
                CAPTURE(mu);
                CAPTURE(size);
                CAPTURE(weight);
                double speed = 0.0;
                CHECK(std::abs(slid(cone - degree, speed)) < 0.01);
                const double inertia = box.mass + box.added_mass[0], weighs = box.mass - 1.2 * box.volume;
                const double angle = cone + 5.0 * degree;
                CHECK(slid(cone + 2.0 * degree, speed) > 0.05);
                slid(angle, speed);
                const double a = weighs / inertia * gravity * (std::sin(angle) - mu * std::cos(angle));
                CHECK(speed == doctest::Approx(a).epsilon(mu > 0.8 && size > 0.5 ? 0.15 : 0.03));
            }
}

TEST_CASE("thin sheets lie on each other as far apart as min_thickness says, thick ones touch") {
    const auto pitch = [](double thickness, float given) {
        Stack s;
        const lr_batch batch = s.add(make(rigid_box(0.06, thickness, 0.04, 700.0)));
        lr_batch_contact c = contact_desc(0.5f, 0.0f, 0.05f);
        c.flags = 0;
        c.min_thickness = given;
        set_contact(s.world, batch, c);
        for (uint32_t i = 0; i < 4; ++i) s.put_at(batch, {0.0, 0.003 + 0.005 * i, 0.0});
        for (int n = 0; n < 300 && s.awake() != 0; ++n) steps(s.world, 1, frame, 2);
        CHECK(s.awake() == 0);
        CHECK(s.position(0)[1] == doctest::Approx(0.5 * thickness).epsilon(0.2)); // on the ground, as thick as it is
        return (s.position(3)[1] - s.position(0)[1]) / 3.0;
    };
    const double reach = 0.5 * std::hypot(0.06, 0.04), slack = 3e-4; // they land within g h^2 of each other
    CHECK(std::abs(pitch(2e-4, 0.0f) - reach / 32.0) < slack);
    CHECK(std::abs(pitch(2e-4, 2e-3f) - 2e-3) < slack);
    CHECK(std::abs(pitch(2e-4, 1.0f) - 0.1 * reach) < slack); // at most a tenth of the reach
    CHECK(std::abs(pitch(4e-4, -1.0f) - 4e-4) < slack);
    CHECK(std::abs(pitch(3e-3, 0.0f) - 3e-3) < slack);
}

TEST_CASE("bodies that touch are met at once as a new scale or min_thickness makes them") {
    // Sheets that fly side by side: their pair is kept from substep to substep, and no static lock holds them.
    const auto pitch = [](const auto& change) {
        const World world = weightless();
        const lr_batch batch = add_batch(world, unloaded(), make(vacuum_box(0.06, 2e-3, 0.04, 700.0)), 2);
        lr_batch_contact c = contact_desc(0.5f, 0.0f, 0.0f);
        c.min_thickness = -1.0f;
        set_contact(world, batch, c);
        set_pair(world, batch, batch);
        lr_body bodies[2];
        for (uint32_t i = 0; i < 2; ++i) {
            lr_body_desc d = at_rest_at({0.0, 2e-3 * i, 0.0});
            d.linear_velocity[0] = 1.0f;
            bodies[i] = add_body(world, batch, d);
        }
        steps(world, 10, frame, 2);
        change(world, batch, bodies[1]);
        steps(world, 30, frame, 2);
        return wide(state_of(world, bodies[1]).position[1] - state_of(world, bodies[0]).position[1]);
    };
    const auto thicken = [](const World& world, lr_batch batch, lr_body) {
        lr_batch_contact c = contact_desc(0.5f, 0.0f, 0.0f);
        c.min_thickness = 3e-3f;
        set_contact(world, batch, c);
    };
    const auto grow = [](const World& world, lr_batch, lr_body body) {
        lr_body_state s = state_of(world, body);
        s.scale = 1.5f;
        REQUIRE(lr_body_set_state(world.get(), body, &s) == LR_OK);
    };
    const double slack = 1e-4;
    CHECK(std::abs(pitch([](const World&, lr_batch, lr_body) {}) - 2e-3) < slack);
    CHECK(std::abs(pitch(thicken) - 3e-3) < slack);
    CHECK(std::abs(pitch(grow) - 2.5e-3) < slack);
}

TEST_CASE("solids that fall one above the other do not enter each other where the ground stops the lowest") {
    for (const bool ball : {false, true})
        for (const uint32_t substeps : {1u, 2u}) {
            Stack s;
            const double half = 0.01;
            const lr_batch batch =
                s.add(ball ? make(ellipsoid(half, half, half, 900.0)) : make(vacuum_box(0.02, 0.02, 0.02, 900.0)));
            for (int i = 0; i < 3; ++i) s.put_at(batch, {0.0, 0.05 + 0.03 * i, 0.0});
            double deepest = 0.0;
            for (int n = 0; n < 60; ++n) {
                steps(s.world, 1, frame, substeps);
                for (size_t i = 0; i < 2; ++i)
                    deepest = std::max(deepest, 2.0 - length(s.position(i + 1) - s.position(i)) / half);
            }
            CAPTURE(ball);
            CAPTURE(substeps);
            CHECK(deepest < 0.06);
        }
}

TEST_CASE("bodies created inside each other part before they fall asleep") {
    for (const double radius : {0.001, 0.01, 0.1})
        for (const uint32_t rate : {30u, 60u, 240u}) {
            Stack s;
            const lr_batch batch = s.add(make(ellipsoid(radius, radius, radius, 900.0)));
            for (int i = 0; i < 2; ++i) s.put_at(batch, {0.2 * radius * i, radius, 0.0});
            for (uint32_t n = 0; n < 5 * rate && s.awake() != 0; ++n)
                steps(s.world, 1, 1.0f / static_cast<float>(rate), 1);
            CAPTURE(radius);
            CAPTURE(rate);
            CHECK(s.awake() == 0);
            CHECK(length(s.position(1) - s.position(0)) > 1.85 * radius);
        }
}
