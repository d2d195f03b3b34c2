// Shelter from wind: bodies under others lie still in winds that take uncovered ones.
#include "support/body_contact.h"

#include <algorithm>
#include <cstring>

using namespace test;

namespace {

constexpr float frame = 1.0f / 60.0f;
constexpr double length_x = 0.07, thick = 0.0004, length_z = 0.04, density = 1.8e-4 / (length_x * thick * length_z);

// Plates of 70 x 40 x 0.4 mm and 0.18 g on a plane.
struct Ground {
    World world;
    Asset plate = make(rigid_box(length_x, thick, length_z, density));
    lr_batch lying, over; // bodies of the second are there to cover those of the first

    explicit Ground(bool body_contact = true, uint32_t workers = 0) : world(make(desc_with(workers))) {
        lr_batch_desc bd = batch_desc();
        bd.load_model = LR_LOADS_AERODYNAMIC;
        lying = add_batch(world, bd, plate, 64);
        over = add_batch(world, bd, plate, 64);
        lr_batch_contact c = contact_desc(0.5f, 0.0f, 0.05f);
        c.flags = 0;
        set_contact(world, lying, c);
        set_contact(world, over, c);
        if (body_contact) {
            set_pair(world, lying, lying);
            set_pair(world, lying, over);
        }
        add_collider(world, collider_desc(LR_COLLIDER_PLANE));
    }
    static lr_world_desc desc_with(uint32_t workers) {
        lr_world_desc d = world_desc();
        d.worker_count = workers;
        return d;
    }
    // Asleep in the air until it is touched: it covers, and weighs on nothing.
    lr_body cover(double x, double y) {
        const lr_body body = add_body(world, over, at_rest_at({x, y, 0.0}));
        REQUIRE(lr_body_set_sleep(world.get(), &body, 1, LR_SLEEP_ASLEEP) == LR_OK);
        return body;
    }
    void step(int count) const { steps(world, count, frame, 2); }
    double x_of(lr_body body) const { return wide(state_of(world, body).position[0]); }
};

// m/s: the weakest wind of a row that moves a plate, with these covers over it.
struct Cover {
    double x, y; // of its middle, m
};
double lifting_wind(const std::vector<Cover>& covers, double raised = 0.0) {
    Ground g;
    if (raised > 0.0) {
        for (double side : {-1.0, 1.0}) {
            lr_collider_desc post = box_collider(0.002f, 0.5f * narrow(raised), 0.03f);
            post.position[0] = narrow(side * 0.033), post.position[1] = 0.5f * narrow(raised);
            add_collider(g.world, post);
        }
    }
    const lr_body plate = add_body(g.world, g.lying, at_rest_at({0.0, raised + 0.5 * thick, 0.0}));
    g.step(120);
    REQUIRE(rests(g.world, plate));
    for (const Cover& c : covers) g.cover(c.x, raised + c.y);
    for (double speed = 0.5; speed < 60.0; speed *= 1.04) {
        set_wind(g.world, narrow(speed), 0.0f, 0.0f);
        g.step(34); // two turns of each body
        if (!rests(g.world, plate)) return speed;
    }
    return 60.0;
}

} // namespace

TEST_CASE("a covered plate lies still in a wind that takes an open one, a half-covered one goes in between") {
    const double open = lifting_wind({}), half = lifting_wind({{0.5 * length_x, 0.002}}),
                 covered = lifting_wind({{0.0, 0.002}}), high = lifting_wind({{0.0, 0.03}}),
                 raised = lifting_wind({{0.0, 0.002}}, 0.02), raised_open = lifting_wind({}, 0.02);
    MESSAGE("m/s: open " << open << ", half covered " << half << ", covered " << covered << ", cover above a gap "
                         << high << "; raised: open " << raised_open << ", covered " << raised);
    CHECK(half / open == doctest::Approx(std::sqrt(2.0)).epsilon(0.06)); // loads by half
    CHECK(covered > 3.0 * open);
    CHECK(high == open);
    CHECK(raised < 1.1 * raised_open); // the wind comes from below
}

TEST_CASE("when its cover leaves, a plate that has withstood the wind is tried again") {
    for (int how = 0; how < 3; ++how) {
        CAPTURE(how);
        Ground g;
        const lr_body plate = add_body(g.world, g.lying, at_rest_at({0.0, 0.5 * thick, 0.0}));
        g.step(120);
        const lr_body cover = g.cover(0.0, 0.002);
        set_wind(g.world, 9.0f, 0.0f, 0.0f);
        g.step(100);
        REQUIRE(rests(g.world, plate));
        lr_world* const w = g.world.get();
        if (how == 0) { // away within a step, so that it touches nothing
            lr_body_force up = initialised(lr_body_force_init);
            up.body = cover;
            up.mode = LR_FORCE_MODE_VELOCITY;
            up.force[1] = 20.0f;
            REQUIRE(lr_body_add_force(w, &up, 1) == LR_OK);
        } else if (how == 1) {
            lr_body_state s = state_of(g.world, cover);
            s.position[1] = 2.0f;
            REQUIRE(lr_body_set_state(w, cover, &s) == LR_OK);
        } else {
            REQUIRE(lr_body_destroy(w, &cover, 1) == LR_OK);
        }
        g.step(34);
        CHECK(!rests(g.world, plate));
        g.step(60);
        CHECK(g.x_of(plate) > 0.1);
    }
}

TEST_CASE("without body contact nothing is sheltered, and an open body keeps its bits beside a stack") {
    for (const bool body_contact : {false, true}) {
        CAPTURE(body_contact);
        lr_body_state states[2];
        for (int crowded = 0; crowded < 2; ++crowded) {
            Ground g(body_contact);
            const lr_body plate = add_body(g.world, g.lying, at_rest_at({0.0, 0.5 * thick, 0.0}));
            for (int i = 0; i < 3 && crowded == 1; ++i)
                add_body(g.world, g.lying, at_rest_at({0.0, 0.5 * thick + 1.05 * thick * i, 0.5}));
            g.step(120);
            if (crowded == 1 && !body_contact) g.cover(0.0, 0.002);
            set_wind(g.world, 9.0f, 0.0f, 0.0f);
            g.step(40);
            states[crowded] = state_of(g.world, plate);
        }
        CHECK(std::memcmp(states[0].position, states[1].position, sizeof states[0].position) == 0);
        CHECK(std::memcmp(states[0].orientation, states[1].orientation, sizeof states[0].orientation) == 0);
        CHECK(states[0].position[0] > 0.05f);
    }
}

namespace {

// The steps after which plates have gone, from the lowest to the highest. wind: uniform, or a field.
std::vector<int> take_away(bool field) {
    Ground g;
    std::vector<lr_body> stack;
    for (int i = 0; i < 5; ++i)
        stack.push_back(add_body(g.world, g.lying, at_rest_at({0.002 * i, 0.5 * thick + 1.05 * thick * i, 0.001 * i})));
    g.step(240);
    for (lr_body b : stack) REQUIRE(rests(g.world, b));
    if (field) {
        lr_ground_wind_desc slow = initialised(lr_ground_wind_desc_init);
        slow.position[1] = -100.0f;
        slow.roughness_length = 1e-3f;
        REQUIRE(lr_world_add_ground_wind(g.world.get(), &slow, nullptr) == LR_OK);
    }
    set_wind(g.world, 7.0f, 0.0f, 0.0f);
    std::vector<int> gone(stack.size(), 0);
    for (int n = 1; n <= 300; ++n) {
        g.step(1);
        for (size_t i = 0; i < stack.size(); ++i)
            if (gone[i] == 0 && g.x_of(stack[i]) > 0.1) gone[i] = n;
    }
    return gone;
}

// A heap of plates in a wind that takes some of them.
struct Heap : Ground {
    explicit Heap(uint32_t workers, bool backwards = false) : Ground(true, workers) {
        for (uint32_t i = 0; i < 60; ++i) {
            const uint32_t n = backwards ? 59 - i : i;
            lr_body_desc d = at_rest_at({0.012 * (n % 5), 0.001 + 0.0012 * n, 0.009 * (n % 7)});
            d.noise_seed = 100 + n;
            add_body(world, n % 3 == 0 ? over : lying, d);
        }
        step(150);
        set_wind(world, 8.0f, 0.0f, 1.0f);
    }
};

} // namespace

TEST_CASE("a wind takes a stack of plates from the top") {
    for (bool field : {false, true}) {
        const std::vector<int> gone = take_away(field);
        CAPTURE(field);
        MESSAGE("gone after steps, from the lowest: " << gone[0] << " " << gone[1] << " " << gone[2] << " " << gone[3]
                                                      << " " << gone[4]);
        for (size_t i = 0; i < 5; ++i) CHECK(gone[i] > 0);
        for (size_t i = 1; i < 5; ++i) CHECK(gone[i] + 5 < gone[i - 1]);
    }
}

TEST_CASE("a heap in wind has the same bits with workers, in another order of slots, and from a snapshot") {
    const Heap one(0), two(2), turned(0, true), later(0);
    for (const Heap* h : {&one, &two, &turned}) h->step(30);
    const std::vector<unsigned char> half = snapshot_of(one.world);
    REQUIRE(lr_world_snapshot_restore(later.world.get(), half.data(), half.size()) == LR_OK);
    CHECK(hash_of(later.world) == hash_of(one.world));
    for (const Heap* h : {&one, &two, &turned, &later}) h->step(60);
    const uint32_t left = view_of(one.world, one.lying).count;
    REQUIRE(left == 40);
    CHECK(view_of(one.world, one.lying).awake_count > 0);
    CHECK(hash_of(two.world) == hash_of(one.world));
    CHECK(hash_of(turned.world) == hash_of(one.world));
    CHECK(hash_of(later.world) == hash_of(one.world));
}
