// Piles: events that wake sleeping bodies, hits among them, and the cost of sleeping bodies.
#include "support/body_contact.h"
#include "support/contact_events.h"
#include "support/lifecycle.h"

#include <algorithm>
#include <ctime>

using namespace test;

namespace {

constexpr float frame = 1.0f / 60.0f;

lr_batch_contact resting_contact() {
    lr_batch_contact c = contact_desc(0.5f, 0.0f, 0.05f);
    c.flags = 0;
    return c;
}

// A box on a box on a plane, all asleep, and a distant box.
struct Tower {
    World world = make(world_desc());
    Asset box = make(rigid_box(0.1, 0.1, 0.1, 300.0));
    lr_batch low, high;
    lr_body below, above, far;

    Tower() {
        add_collider(world, collider_desc(LR_COLLIDER_PLANE));
        low = add_batch(world, unloaded(), box, 8);
        high = add_batch(world, unloaded(), box, 8);
        for (lr_batch b : {low, high}) set_contact(world, b, resting_contact());
        set_pair(world, low, high);
        set_pair(world, low, low);
        below = add_body(world, low, at_rest_at({0.0, 0.05, 0.0}));
        above = add_body(world, high, at_rest_at({0.01, 0.15, 0.0}));
        far = add_body(world, low, at_rest_at({3.0, 0.05, 0.0}));
        steps(world, 90, frame, 2);
        REQUIRE((rests(world, below) && rests(world, above) && rests(world, far)));
    }
    double height() const { return wide(state_of(world, above).position[1]); }
};

} // namespace

TEST_CASE("a body that lies on another falls when that goes, however it goes") {
    for (int how = 0; how < 6; ++how) {
        CAPTURE(how);
        Tower t;
        lr_world* const w = t.world.get();
        if (how == 0) {
            REQUIRE(lr_body_destroy(w, &t.below, 1) == LR_OK);
        } else if (how == 1) {
            lr_body_state s = state_of(t.world, t.below);
            s.position[0] = -2.0f;
            REQUIRE(lr_body_set_state(w, t.below, &s) == LR_OK);
        } else if (how == 2) {
            lr_batch_rules r = rules_desc();
            r.volume_count = 1;
            r.volumes[0] = {LR_VOLUME_BOX, LR_KILL_INSIDE, {0.0f, 0.05f, 0.0f}, {0.02f, 0.02f, 0.02f}};
            set_rules(t.world, t.low, r);
        } else if (how == 3) {
            lr_body_force f = initialised(lr_body_force_init);
            f.body = t.below;
            f.mode = LR_FORCE_MODE_VELOCITY;
            f.force[0] = -8.0f; // away from the distant box
            REQUIRE(lr_body_add_force(w, &f, 1) == LR_OK);
        } else if (how == 4) {
            REQUIRE(lr_batch_destroy(w, t.low) == LR_OK);
        } else {
            set_pair(t.world, t.low, t.high, false);
        }
        steps(t.world, 60, frame, 2);
        CHECK(t.height() < 0.06);
        CHECK(t.height() > 0.045);
        if (how != 4) CHECK(rests(t.world, t.far)); // of a batch without the call
        steps(t.world, 60, frame, 2);
        CHECK(rests(t.world, t.above));
    }
}

TEST_CASE("a body that lies on another goes with it when a force pulls that away slowly") {
    Tower t;
    for (int n = 0; n < 60; ++n) {
        lr_body_force f = initialised(lr_body_force_init);
        f.body = t.below;
        f.force[0] = narrow(info_of(t.box).mass * 14.0);
        REQUIRE(lr_body_add_force(t.world.get(), &f, 1) == LR_OK);
        steps(t.world, 1, frame, 2);
    }
    const double x = wide(state_of(t.world, t.below).position[0]);
    MESSAGE("moved " << x << ", the other " << state_of(t.world, t.above).position[0]);
    CHECK(x > 0.2);
    CHECK(wide(state_of(t.world, t.above).position[0]) > 0.1);
}

TEST_CASE("a tower goes down with its ground, however fast that goes and whatever its bodies are") {
    const Asset assets[] = {make(rigid_box(0.1, 0.1, 0.1, 300.0)), make(ellipsoid(0.05, 0.05, 0.05, 300.0))};
    for (const Asset& upper : assets)
        for (const float way : {0.001f, 0.03f, 0.3f}) // m, in a frame
            for (const uint32_t substeps : {1u, 2u, 4u}) {
                CAPTURE(way);
                CAPTURE(substeps);
                const World world = make(world_desc());
                lr_collider_desc table = box_collider(1.0f, 0.1f, 1.0f);
                table.position[1] = -0.1f;
                const lr_collider under = add_collider(world, table);
                const lr_batch low = add_batch(world, unloaded(), assets[0], 4);
                const lr_batch high = add_batch(world, unloaded(), upper, 1);
                for (lr_batch b : {low, high}) set_contact(world, b, resting_contact());
                set_pair(world, low, low), set_pair(world, low, high);
                std::vector<lr_body> bodies;
                for (int i = 0; i < 4; ++i)
                    bodies.push_back(add_body(world, i < 3 ? low : high, at_rest_at({0.0, 0.05 + 0.1 * i, 0.0})));
                steps(world, 120, frame, substeps);
                for (const lr_body b : bodies) REQUIRE(rests(world, b));
                lr_collider_motion m = initialised(lr_collider_motion_init);
                m.collider = under;
                m.position[1] = table.position[1] - way;
                REQUIRE(lr_collider_move(world.get(), &m, 1) == LR_OK);
                steps(world, 60, frame, substeps);
                for (size_t i = 0; i < bodies.size(); ++i) {
                    CAPTURE(i);
                    const double level = 0.05 + 0.1 * static_cast<double>(i) - wide(way);
                    CHECK(std::abs(wide(state_of(world, bodies[i]).position[1]) - level) < 1.1e-3);
                }
            }
}

TEST_CASE("a box lies on one of a hundredth of its mass") { // on one of two hundredths it sinks through
    for (const uint32_t substeps : {1u, 2u, 4u}) {
        const World world = make(world_desc());
        lr_collider_desc table = box_collider(1.0f, 0.1f, 1.0f);
        table.position[1] = -0.1f;
        add_collider(world, table);
        lr_batch batch[2];
        for (size_t i = 0; i < 2; ++i) {
            batch[i] = add_batch(world, unloaded(), make(rigid_box(0.1, 0.1, 0.1, i ? 30000.0 : 300.0)), 1);
            set_contact(world, batch[i], resting_contact());
        }
        set_pair(world, batch[0], batch[1]);
        add_body(world, batch[0], at_rest_at({0.0, 0.05, 0.0}));
        const lr_body heavy = add_body(world, batch[1], at_rest_at({0.0, 0.15, 0.0}));
        for (int i = 0; i < 240; ++i) {
            steps(world, 1, frame, substeps);
            REQUIRE(std::abs(wide(state_of(world, heavy).position[1]) - 0.15) < 2e-3);
        }
        CHECK(rests(world, heavy));
        CHECK(std::abs(wide(state_of(world, heavy).position[1]) - 0.15) < 2e-5);
    }
}

TEST_CASE("a hit wakes what is hit, and not what is far") {
    Tower t;
    lr_body_desc d = at_rest_at({-0.5, 0.22, 0.0});
    d.linear_velocity[0] = 4.0f;
    const lr_body shot = add_body(t.world, t.low, d);
    int woken = -1;
    for (int n = 0; n < 30; ++n) {
        steps(t.world, 1, frame, 2);
        if (woken < 0 && !rests(t.world, t.above)) woken = n;
        CHECK(rests(t.world, t.far));
    }
    CHECK(woken > 3);
    CHECK(woken < 12);
    CHECK(state_of(t.world, shot).position[0] < state_of(t.world, t.above).position[0]);
}

// A tilted plate's box is mostly empty.
TEST_CASE("a fast body that passes within a sleeping one's box does not wake it") {
    const World world = make(world_desc());
    const lr_batch plates = add_batch(world, unloaded(), make(rigid_box(0.2, 0.002, 0.2, 300.0)), 1),
                   balls = add_batch(world, unloaded(), make(rigid_box(0.01, 0.01, 0.01, 300.0)), 1);
    for (const lr_batch b : {plates, balls}) set_contact(world, b, resting_contact());
    set_pair(world, plates, balls);
    for (const bool hits : {false, true}) {
        CAPTURE(hits);
        lr_body_desc d = at_rest_at({0.0, 0.0, 0.0});
        d.orientation[0] = std::sin(0.3926991f), d.orientation[3] = std::cos(0.3926991f); // 45 degrees about x
        const lr_body plate = add_body(world, plates, d);
        REQUIRE(lr_body_set_sleep(world.get(), &plate, 1, LR_SLEEP_ASLEEP) == LR_OK);
        // Along x, 7 cm off the plate's plane in a corner of its box, or through it.
        d = at_rest_at({-0.3, hits ? 0.05 : -0.05, -0.05});
        d.linear_velocity[0] = 3.0f;
        const lr_body ball = add_body(world, balls, d);
        bool woke = false;
        for (int n = 0; n < 8; ++n) {
            steps(world, 1, frame, 2);
            woke = woke || !rests(world, plate);
        }
        CHECK(woke == hits);
        const lr_body both[] = {plate, ball};
        REQUIRE(lr_body_destroy(world.get(), both, 2) == LR_OK);
    }
}

TEST_CASE("a body at rest takes the momentum of what hits it") {
    const World world = make(world_desc());
    const Asset box = make(vacuum_box(0.1, 0.1, 0.1, 300.0));
    const lr_batch batch = add_batch(world, unloaded(), box, 4);
    set_contact(world, batch, contact_desc(0.0f, 0.0f));
    set_pair(world, batch, batch);
    lr_collider_desc plane = collider_desc(LR_COLLIDER_PLANE);
    plane.friction = plane.restitution = 0.0f;
    add_collider(world, plane);
    const lr_body hit = add_body(world, batch, at_rest_at({0.0, 0.05, 0.0}));
    REQUIRE(lr_body_set_sleep(world.get(), &hit, 1, LR_SLEEP_ASLEEP) == LR_OK);
    lr_body_desc d = at_rest_at({-0.5, 0.05, 0.0});
    d.linear_velocity[0] = 2.0f;
    const lr_body shot = add_body(world, batch, d);
    steps(world, 30, frame, 2);
    const double after[2] = {wide(state_of(world, shot).linear_velocity[0]),
                             wide(state_of(world, hit).linear_velocity[0])};
    CHECK(after[0] + after[1] == doctest::Approx(2.0).epsilon(0.01));
    CHECK(after[1] == doctest::Approx(1.0).epsilon(0.02));
}

TEST_CASE("wind below lift-off leaves a pile at rest, and a stronger one takes it apart" *
          doctest::test_suite("native")) {
    for (uint64_t seed = 0; seed < 10; ++seed) {
        CAPTURE(seed);
        lr_world_desc wd = world_desc();
        wd.seed = seed;
        const World world = make(wd);
        const Asset card = make(rigid_box(0.06, 0.0005, 0.04, 500.0));
        add_collider(world, collider_desc(LR_COLLIDER_PLANE));
        lr_batch_desc bd = batch_desc();
        bd.load_model = LR_LOADS_AERODYNAMIC;
        const lr_batch batch = add_batch(world, bd, card, 32);
        set_contact(world, batch, resting_contact());
        set_pair(world, batch, batch);
        std::vector<lr_body> bodies;
        for (int i = 0; i < 20; ++i) {
            const int tower = i / 4;
            bodies.push_back(add_body(world, batch, at_rest_at({0.1 * tower, 0.0003 + 0.0006 * (i % 4), 0.0})));
        }
        steps(world, 180, frame, 2);
        REQUIRE(view_of(world, batch).awake_count == 0);
        set_wind(world, 0.4f, 0.0f, 0.0f);
        steps(world, 120, frame, 2);
        CHECK(view_of(world, batch).awake_count == 0);
        set_wind(world, 25.0f, 0.0f, 0.0f);
        steps(world, 600, frame, 2);
        // A card can stay that leans on the next one with its upper face to the wind, and that one: it is pressed down by many times its weight
        // (docs/maintainers/contact.md, 14). None hangs where others held it up.
        float leans = 1.0f;
        std::vector<lr_body> stayed;
        for (lr_body b : bodies) {
            const lr_body_state state = state_of(world, b);
            if (state.position[0] > 1.0f) continue;
            stayed.push_back(b);
            leans = std::min(leans, narrow(to_world(quat(state.orientation), {0.0, 1.0, 0.0})[0]));
        }
        CHECK((stayed.empty() || (stayed.size() <= 4 && leans < -0.02f)));
        set_wind(world, 0.0f, 0.0f, 0.0f);
        for (lr_body b : stayed) {
            const float y = state_of(world, b).position[1];
            REQUIRE(lr_body_set_sleep(world.get(), &b, 1, LR_SLEEP_AWAKE) == LR_OK);
            steps(world, 60, frame, 2);
            CHECK(std::abs(state_of(world, b).position[1] - y) < 1e-3f);
        }
    }
}

// Upper bodies once hung in the air: those of turned towers at any speed, the others at less than 4 cm/s.
TEST_CASE("a tower leaves with its ground, however it is turned and however slowly that goes" *
          doctest::test_suite("exact")) {
    const double half_turn = std::sqrt(0.5);
    const std::pair<Vec, Quat> stones[] = {{{0.1, 0.1, 0.1}, {0.0, 0.0, 0.0, 1.0}},
                                           {{0.1, 0.1, 0.1}, {1.0, 0.0, 0.0, 0.0}},
                                           {{0.1, 0.1, 0.1}, {0.0, 0.0, half_turn, half_turn}},
                                           {{0.1, 0.1, 0.1}, {half_turn, 0.0, 0.0, half_turn}}};
    for (const auto& [size, turn] : stones)
        for (const float sinking : {0.001f, 0.005f, 0.03f, 5.0f}) {
            CAPTURE(&turn);
            CAPTURE(sinking);
            const World world = make(world_desc());
            const lr_collider table = add_collider(world, box_collider(0.5f, 0.05f, 0.5f));
            const lr_batch batch = add_batch(world, unloaded(), make(rigid_box(size[0], size[1], size[2], 300.0)), 8);
            set_contact(world, batch, resting_contact());
            set_pair(world, batch, batch);
            std::vector<lr_body> tower;
            for (int i = 0; i < 4; ++i) {
                lr_body_desc d = at_rest_at({0.0, 0.1 + 0.1 * i, 0.0});
                for (size_t k = 0; k < 4; ++k) d.orientation[k] = narrow(turn[k]);
                tower.push_back(add_body(world, batch, d));
            }
            steps(world, 180, frame, 2);
            REQUIRE(view_of(world, batch).awake_count == 0);
            lr_collider_motion moves = motion_of(table, LR_MOVE_VELOCITY);
            moves.linear_velocity[1] = -sinking;
            REQUIRE(lr_collider_move(world.get(), &moves, 1) == LR_OK);
            steps(world, 240, frame, 2);
            for (int i = 0; i < 4; ++i) {
                CAPTURE(i);
                const float y = state_of(world, tower[static_cast<size_t>(i)]).position[1];
                CHECK(std::abs(wide(y) - 0.1 - 0.1 * i + 4.0 * wide(sinking)) < 0.002);
            }
        }
}

TEST_CASE("however a batch that sleeps as a whole wakes, its bodies' age is the time that has passed") {
    for (uint32_t divisor : {1u, 3u})
        for (int how = 0; how < 3; ++how) {
            CAPTURE(divisor);
            CAPTURE(how);
            const World world = make(world_desc());
            const Asset card = make(rigid_box(0.06, 0.0005, 0.04, 500.0));
            add_collider(world, collider_desc(LR_COLLIDER_PLANE));
            lr_collider_desc ball = sphere_collider(0.05f);
            ball.position[1] = 0.2f;
            const lr_collider collider = add_collider(world, ball);
            lr_batch_desc bd = batch_desc();
            bd.load_model = LR_LOADS_AERODYNAMIC;
            const lr_batch batch = add_batch(world, bd, card, 16), other = add_batch(world, bd, card, 1);
            for (lr_batch b : {batch, other}) set_contact(world, b, resting_contact());
            set_pair(world, batch, other);
            REQUIRE(lr_batch_set_rate(world.get(), batch, divisor) == LR_OK);
            std::vector<lr_body> bodies;
            for (int i = 0; i < 16; ++i) bodies.push_back(add_body(world, batch, at_rest_at({0.1 * i, 0.0003, 0.0})));
            uint32_t woken = 0;
            double wrong = 0.0, time = 0.0;
            const auto run = [&](int count) {
                for (int n = 0; n < count; ++n) {
                    const bool still = view_of(world, batch).awake_count == 0;
                    steps(world, 1, frame, 2);
                    time += wide(frame);
                    woken += still && view_of(world, batch).awake_count != 0;
                    lr_batch_pace pace = initialised(lr_batch_pace_init);
                    REQUIRE(lr_batch_get_pace(world.get(), batch, &pace) == LR_OK);
                    for (lr_body b : bodies)
                        wrong = std::max(wrong, std::abs(wide(state_of(world, b).age) + pace.behind - time));
                }
            };
            run(180);
            REQUIRE(view_of(world, batch).awake_count == 0);
            if (how == 0) { // falls onto one of them
                lr_collider_motion down = motion_of(collider, LR_MOVE_TO);
                down.position[0] = 0.31f, down.position[1] = 0.055f;
                REQUIRE(lr_collider_move(world.get(), &down, 1) == LR_OK);
            } else if (how == 1) {
                set_wind(world, 25.0f, 0.0f, 0.0f);
            } else {
                lr_body_desc d = at_rest_at({0.3, 0.1, 0.0});
                d.linear_velocity[1] = -8.0f;
                add_body(world, other, d);
            }
            run(60);
            CHECK(woken > 0);
            CHECK(wrong < 1e-5);
        }
}

TEST_CASE("bodies that the wind wakes after others of them have ended at rest live on") {
    for (const bool one_moves : {false, true}) {
        CAPTURE(one_moves);
        const World world = make(world_desc());
        const Asset card = make(rigid_box(0.06, 0.0005, 0.04, 500.0));
        add_collider(world, collider_desc(LR_COLLIDER_PLANE));
        lr_batch_desc bd = batch_desc();
        bd.load_model = LR_LOADS_AERODYNAMIC;
        const lr_batch batch = add_batch(world, bd, card, 200);
        set_contact(world, batch, resting_contact());
        std::vector<lr_body> bodies;
        for (int i = 0; i < 200; ++i) {
            bodies.push_back(add_body(world, batch, at_rest_at({0.1 * i, 0.0003, 0.0})));
            lr_body_state s = state_of(world, bodies.back());
            if (i % 5 == 0) s.age = 90.0f;
            REQUIRE(lr_body_set_state(world.get(), bodies.back(), &s) == LR_OK);
        }
        lr_batch_rules r = rules_desc();
        r.max_age = 100.0f;
        set_rules(world, batch, r);
        const auto run = [&](int count) {
            for (int n = 0; n < count; ++n) {
                if (one_moves) REQUIRE(lr_body_set_sleep(world.get(), &bodies[1], 1, LR_SLEEP_AWAKE) == LR_OK);
                steps(world, 1, frame, 2);
            }
        };
        run(590);
        REQUIRE(view_of(world, batch).awake_count == (one_moves ? 1 : 0));
        REQUIRE(view_of(world, batch).count == 200);
        while (counts_of(world, batch).total_destroyed == 0) run(1);
        set_wind(world, 25.0f, 0.0f, 0.0f);
        run(30);
        CHECK(view_of(world, batch).awake_count == 160);
        CHECK(counts_of(world, batch).total_destroyed == 40);
    }
}

TEST_CASE("a wind callback is told whose bodies at rest it is asked about, and lifts those of one batch off") {
    struct Field {
        lr_batch blown{};
        float speed = 0.0f;
        std::vector<lr_batch> asked;
        static void blow(void* user, const lr_wind_query* q) {
            Field& field = *static_cast<Field*>(user);
            field.asked.push_back(q->batch);
            for (uint32_t i = 0; i < q->count; ++i) q->velocity[0][i] = q->batch == field.blown ? field.speed : 0.0f;
        }
    };
    const World world = make(world_desc());
    const Asset card = make(rigid_box(0.06, 0.0005, 0.04, 500.0));
    add_collider(world, collider_desc(LR_COLLIDER_PLANE));
    lr_batch_desc bd = batch_desc();
    bd.load_model = LR_LOADS_AERODYNAMIC;
    lr_batch batch[2];
    lr_body body[2];
    for (int k = 0; k < 2; ++k) {
        batch[k] = add_batch(world, bd, card, 1);
        set_contact(world, batch[k], resting_contact());
        body[k] = add_body(world, batch[k], at_rest_at({0.0, 0.0003, 1.0 * k}));
    }
    Field field;
    field.blown = batch[1];
    REQUIRE(lr_world_set_wind_callback(world.get(), Field::blow, &field) == LR_OK);
    steps(world, 180, frame, 2);
    for (lr_batch b : batch) REQUIRE(view_of(world, b).awake_count == 0);
    field.asked.clear();
    steps(world, 32, frame, 2);
    for (lr_batch b : batch) CHECK(std::count(field.asked.begin(), field.asked.end(), b) > 0);
    CHECK(std::count(field.asked.begin(), field.asked.end(), lr_batch{}) == 0);
    field.speed = 25.0f;
    steps(world, 60, frame, 2);
    CHECK(state_of(world, body[0]).sleep_state == LR_SLEEP_ASLEEP);
    CHECK(state_of(world, body[1]).position[0] > 1.0f);
}

TEST_CASE("bodies at rest that meet each other cost next to nothing") {
    const auto seconds_of = [](uint32_t resting) {
        const World world = make(world_desc());
        const Asset box = make(rigid_box(0.05, 0.05, 0.05, 300.0));
        const lr_batch batch = add_batch(world, unloaded(), box, 40000);
        set_contact(world, batch, resting_contact());
        set_pair(world, batch, batch);
        std::vector<lr_body> ids;
        for (uint32_t i = 0; i < resting + 10; ++i) {
            const uint32_t row = i / 200;
            ids.push_back(add_body(world, batch, at_rest_at({0.1 * (i % 200), 0.0, 0.1 * row})));
        }
        REQUIRE(lr_body_set_sleep(world.get(), ids.data(), resting, LR_SLEEP_ASLEEP) == LR_OK);
        double best = 1e9;
        for (int n = 0; n < 20; ++n) {
            const std::clock_t since = std::clock();
            REQUIRE(lr_world_step(world.get(), 1e-4f, 2) == LR_OK);
            best = std::min(best, static_cast<double>(std::clock() - since) / CLOCKS_PER_SEC);
        }
        REQUIRE(view_of(world, batch).awake_count == 10);
        return best;
    };
    const double few = seconds_of(100), many = seconds_of(30000);
    MESSAGE("ten move: among 100 at rest " << few * 1e6 << " us, among 30000 " << many * 1e6 << " us");
    CHECK(many < 3.0 * few + 1e-4);
}

namespace {
// A box of 4 m whose top is at the height 0.
lr_collider add_raft(const World& world) {
    lr_collider_desc d = box_collider(2.0f, 0.1f, 2.0f);
    d.position[1] = -0.1f;
    return add_collider(world, d);
}

void drive(const World& world, lr_collider raft, float speed) {
    lr_collider_motion m = motion_of(raft, LR_MOVE_VELOCITY);
    m.linear_velocity[0] = speed;
    REQUIRE(lr_collider_move(world.get(), &m, 1) == LR_OK);
}
} // namespace

// Those on top fell asleep, or never woke, and stayed where they were: the raft took its lowest layer alone.
TEST_CASE("a stack goes along with a slow raft") {
    const Asset asset = brick();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 4);
    set_pair(world, batch, batch);
    const lr_collider raft = add_raft(world);
    std::vector<lr_body> bodies;
    for (int i = 0; i < 4; ++i) bodies.push_back(add_body(world, batch, at_rest_at({0.0, 0.021 + 0.041 * i, 0.0})));
    steps(world, 240, 1.0f / 60.0f, 4);
    for (const lr_body body : bodies) REQUIRE(rests(world, body));
    drive(world, raft, 0.02f);
    steps(world, 600, 1.0f / 60.0f, 4);
    for (const lr_body body : bodies) CHECK(state_of(world, body).position[0] > 0.17f); // of 0.2
}

// It fell asleep on the belt, and the belt woke it: LR_EVENT_LANDED every two seconds.
TEST_CASE("on a slow belt a body does not land over and over") {
    const Asset asset = brick();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 1);
    const lr_collider belt = add_raft(world);
    drive(world, belt, 0.01f);
    const lr_body body = add_body(world, batch, at_rest_at({0.0, 0.021, 0.0}));
    keep_events(world, 100, LR_EVENTS_LANDED | LR_EVENTS_WOKE);
    size_t told = 0;
    for (int i = 0; i < 600; ++i) {
        steps(world, 1, 1.0f / 60.0f, 4);
        told += events_of(world).size();
    }
    CHECK(told == 0);
    CHECK(state_of(world, body).position[0] == doctest::Approx(0.1).epsilon(0.05));
    drive(world, belt, 0.0f);
    steps(world, 120, 1.0f / 60.0f, 4);
    CHECK(rests(world, body));
}
