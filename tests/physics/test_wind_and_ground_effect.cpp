// Effects of air at colliders: wind that lifts sleeping bodies, and the cushion under a sheet.
#include "support/contact.h"

#include <cmath>
#include <numbers>

using namespace test;

namespace {

void blow(const World& world, float speed) {
    set_wind(world, speed, 0.0f, 0.0f);
}
uint32_t awake(const World& world, lr_batch batch) {
    return view_of(world, batch).awake_count;
}
double farthest(const World& world, lr_batch batch) {
    const lr_batch_view v = view_of(world, batch);
    double most = 0.0;
    for (uint32_t i = 0; i < v.count; ++i) most = std::max(most, static_cast<double>(v.position[0][i]));
    return most;
}

} // namespace

// Wind at v presses on a plate that lies edge on to it with about 1/2 rho v^2 times a part of its area: much less than the
// friction of steel, more than that of paper.
TEST_CASE("wind wakes and moves what its loads can move, and nothing else") {
    const World world = make(world_desc());
    const Asset paper = make(rigid_box(0.06, 0.0004, 0.04, 200.0)), steel = make(rigid_box(0.06, 0.004, 0.04, 7800.0));
    const lr_batch light = add_batch(world, batch_desc(), paper, 200),
                   heavy = add_batch(world, batch_desc(), steel, 200);
    add_collider(world, collider_desc(LR_COLLIDER_PLANE));
    for (uint32_t i = 0; i < 200; ++i) {
        lr_body_desc d = body_desc();
        put(d.orientation, about({0, 1, 0}, 0.1 * i));
        d.position[2] = static_cast<float>(i);
        d.position[1] = 0.001f;
        add_body(world, light, d);
        d.position[0] = -1.0f, d.position[1] = 0.003f;
        add_body(world, heavy, d);
    }
    steps(world, 120, 1.0f / 60.0f, 2);
    REQUIRE(awake(world, light) == 0);
    REQUIRE(awake(world, heavy) == 0);
    blow(world, 0.2f);
    steps(world, 60, 1.0f / 60.0f, 2);
    CHECK(awake(world, light) == 0);
    CHECK(awake(world, heavy) == 0);
    const double lay = farthest(world, light);
    blow(world, 10.0f);
    steps(world, 17, 1.0f / 60.0f, 2); // each body has been checked
    CHECK(awake(world, light) == 200);
    CHECK(awake(world, heavy) == 0);
    steps(world, 60, 1.0f / 60.0f, 2);
    CHECK(farthest(world, light) > lay + 1.0);
    blow(world, 0.0f);
    steps(world, 600, 1.0f / 60.0f, 2);
    CHECK(awake(world, light) == 0);
}

// Put to sleep in mid-air by a call: it has no support, and stays there in any wind.
TEST_CASE("wind does not wake what was put to rest in the air") {
    const World world = make(world_desc());
    const Asset asset = make(rigid_box(0.06, 0.0004, 0.04, 200.0));
    const lr_batch batch = add_batch(world, batch_desc(), asset, 1);
    add_collider(world, collider_desc(LR_COLLIDER_PLANE));
    lr_body_desc d = body_desc();
    d.position[1] = 3.0f;
    const lr_body body = add_body(world, batch, d);
    steps(world, 1, 1e-6f, 1); // a new collider wakes bodies near it
    REQUIRE(lr_body_set_sleep(world.get(), &body, 1, LR_SLEEP_ASLEEP) == LR_OK);
    blow(world, 20.0f);
    steps(world, 40, 1.0f / 60.0f, 2);
    CHECK(awake(world, batch) == 0);
    CHECK(state_of(world, body).position[1] == doctest::Approx(3.0).epsilon(1e-6));
}

// Below the height a, the disc's radius: (1 + l/z) v^2 = (1 + l/a) v_a^2 + 2 g' (a - z), l = pi rho a^4/(8 (m + A)).
TEST_CASE("a sheet that comes down flat shares its motion with the air that it presses away") {
    constexpr double side = 0.2, thick = 0.0004, air = 1.2, gravity = 9.81;
    const lr_rigid_desc box = rigid_box(side, thick, side, 200.0);
    const double inertia = box.mass + box.added_mass[7], pull = (box.mass - air * box.volume) / inertia * gravity;
    const double a = std::sqrt(side * side / std::numbers::pi);
    for (float effect : {0.0f, 0.5f, 1.0f}) {
        const double l = static_cast<double>(effect) * std::numbers::pi * air * a * a * a * a / (8.0 * inertia);
        const World world = make(world_desc());
        const lr_batch batch = add_batch(world, unloaded(), make(box), 1);
        add_collider(world, collider_desc(LR_COLLIDER_PLANE));
        lr_batch_contact contact = contact_desc(0.5f, 0.0f);
        contact.ground_effect = effect;
        contact.flags = LR_CONTACT_NEVER_SLEEP;
        REQUIRE(lr_batch_set_contact(world.get(), batch, &contact) == LR_OK);
        lr_body_desc d = body_desc();
        d.position[1] = static_cast<float>(a);
        d.linear_velocity[1] = -0.5f;
        const lr_body body = add_body(world, batch, d);
        double z = a, v = 0.5;
        while (z > 0.02) {
            steps(world, 1, 1.0f / 240.0f, 4);
            const lr_body_state s = state_of(world, body);
            z = static_cast<double>(s.position[1]);
            v = -static_cast<double>(s.linear_velocity[1]);
            REQUIRE(v > 0.0);
        }
        const double expected = std::sqrt(((1.0 + l / a) * 0.25 + 2.0 * pull * (a - z)) / (1.0 + l / z));
        CAPTURE(effect);
        CHECK(v == doctest::Approx(expected).epsilon(0.02));
    }
}
