// Fast cards against others: none passes through without contact.
#include "support/body_contact.h"
#include "support/quick.h"

#include <numbers>

using namespace test;

namespace {

const uint32_t volleys = quick() ? 2 : 20;
constexpr uint32_t shots = 500;

} // namespace

// Targets are far apart in the air, one for each shot; only contacts between a shot and its target count.
TEST_CASE("cards at 10 to 20 m/s do not pass through cards at rest or in the air without touching") {
    const Asset card = make(vacuum_box(0.06, 0.0004, 0.04, 600.0)), wall = make(vacuum_box(0.2, 0.0004, 0.2, 6000.0));
    Random random(9);
    uint32_t through = 0, fired = 0;
    std::string which;
    uint32_t controls = 0, unseen = 0;
    for (uint32_t volley = 0; volley < volleys; ++volley) {
        const World world = weightless();
        const lr_batch shot = add_batch(world, unloaded(), card, shots),
                       target = add_batch(world, unloaded(), wall, shots);
        for (lr_batch b : {shot, target}) set_contact(world, b, contact_desc(0.3f, 0.2f));
        const bool control = volley == volleys - 1; // without contact, to show that the count can fail
        set_pair(world, shot, target, !control);
        std::vector<lr_body> flying, standing;
        std::vector<Vec> velocity;
        for (uint32_t i = 0; i < shots; ++i) {
            const uint32_t row = i / 25;
            const Vec place{2.0 * (i % 25), 2.0 * row, 0.0};
            const Quat turn = any_turn(random);
            const Vec n = to_world(turn, {0, 1, 0});
            lr_body_desc d = at_rest_at(place);
            put(d.orientation, turn);
            standing.push_back(add_body(world, target, d));
            // Towards a point well inside the card, not along it.
            const Vec aim = place + to_world(turn, {random.uniform(-0.05, 0.05), 0.0, random.uniform(-0.05, 0.05)});
            Vec way{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
            way = 1.0 / length(way) * way;
            if (std::abs(dot(way, n)) < 0.5) way = way + (dot(way, n) < 0.0 ? -1.0 : 1.0) * n;
            way = 1.0 / length(way) * way;
            d = at_rest_at(aim - random.uniform(0.1, 0.5) * way);
            put(d.orientation, any_turn(random));
            put(d.linear_velocity, random.uniform(10.0, 20.0) * way);
            put(d.angular_velocity, random.uniform(0.0, 40.0) * to_world(any_turn(random), {1, 0, 0}));
            velocity.push_back(vec(d.linear_velocity));
            flying.push_back(add_body(world, shot, d));
        }
        if (volley % 2 == 0) REQUIRE(lr_body_set_sleep(world.get(), standing.data(), shots, LR_SLEEP_ASLEEP) == LR_OK);
        steps(world, 5, 1.0f / 60.0f, volley % 4 < 2 ? 1 : 2);
        for (uint32_t i = 0; i < shots; ++i) {
            ++fired;
            // Untouched shots keep their velocity; without a fluid their path is straight.
            const Vec now = vec(state_of(world, flying[i]).linear_velocity);
            const bool touched = length(now - velocity[i]) > 0.01 * length(velocity[i]);
            if (control)
                ++controls, unseen += touched;
            else if (!touched)
                ++through, which += " " + std::to_string(volley) + ":" + std::to_string(i);
        }
    }
    MESSAGE(through << " of " << fired << " went through: " << which.substr(0, 200));
    CHECK(fired == shots * volleys);
    CHECK(through == 0);
    CHECK(controls == shots);
    CHECK(unseen == 0);
}
