// Air and water do not flow into walls: bodies that they carry to one sink along it.
#include "collision/near_walls.h"
#include "support/body_contact.h"
#include "support/box_corners.h"

#include <algorithm>
#include <numbers>

using namespace test;

namespace {

constexpr uint32_t count = 60;
constexpr float frame = 1.0f / 60.0f;

Asset leaf() {
    return make(ellipsoid(0.03, 0.0005, 0.02, 200.0));
}

// A wall of 3 m whose side faces -x at x = 1.
void add_wall(const World& world, int32_t kind) {
    if (kind == LR_COLLIDER_PLANE) {
        lr_collider_desc d = collider_desc(kind);
        d.position[0] = 1.0f;
        put(d.orientation, about({0, 0, 1}, 0.5 * std::numbers::pi));
        add_collider(world, d);
    } else if (kind == LR_COLLIDER_HULL) {
        const std::vector<float> corners = box_corners(0.1f, 1.5f, 20.0f);
        lr_collider_desc d = hull_collider(corners);
        d.position[0] = 1.1f, d.position[1] = 1.5f;
        add_collider(world, d);
    } else if (kind == LR_COLLIDER_MESH) {
        add_collider(world, mesh_collider({{1, 0, -20, 1, 0, 20, 1, 3, -20, 1, 3, 20}, {0, 1, 2, 1, 3, 2}}));
    } else {
        lr_collider_desc d = box_collider(0.1f, 1.5f, 20.0f);
        d.position[0] = 1.1f, d.position[1] = 1.5f;
        add_collider(world, d);
    }
}

enum Way { alone, in_gusts, in_turbulence, with_others };
constexpr Way ways[] = {alone, in_gusts, in_turbulence, with_others};

struct Drift {
    World world = make(world_desc());
    Asset asset;
    lr_batch batch{};
    std::vector<lr_body> bodies;

    explicit Drift(int32_t kind, Asset body = leaf()) : asset(std::move(body)) {
        add_collider(world, collider_desc(LR_COLLIDER_PLANE));
        add_wall(world, kind);
        lr_batch_desc d = batch_desc();
        d.load_model = LR_LOADS_AERODYNAMIC;
        batch = add_batch(world, d, asset, count + 1);
        lr_batch_contact c = contact_desc(0.5f, 0.0f, 0.05f);
        c.flags = 0;
        set_contact(world, batch, c);
    }
    void blow(Way way) {
        set_wind(world, 10.0f, 0.0f, 1.0f);
        lr_gusts_desc g = initialised(lr_gusts_desc_init);
        lr_turbulence_desc t = initialised(lr_turbulence_desc_init);
        g.rms = t.rms = 0.001f;
        if (way == in_gusts) REQUIRE(lr_world_add_gusts(world.get(), &g, nullptr) == LR_OK);
        if (way == in_turbulence) REQUIRE(lr_world_add_turbulence(world.get(), &t, nullptr) == LR_OK);
        if (way == with_others) REQUIRE(lr_batch_set_body_contact(world.get(), batch, batch, 1) == LR_OK);
    }
    void strew() {
        Random random(3);
        for (uint32_t i = 0; i < count; ++i)
            bodies.push_back(
                add_body(world, batch,
                         turned_anyhow(random, {random.uniform(-1.0, 0.5), random.uniform(0.2, 1.2), 0.2 * i - 6.0})));
    }
    double highest() const {
        double most = 0.0;
        for (const lr_body& b : bodies) most = std::max(most, wide(state_of(world, b).position[1]));
        return most;
    }
    double beyond() const {
        double most = -10.0;
        for (const lr_body& b : bodies) most = std::max(most, wide(state_of(world, b).position[0]));
        return most;
    }
    auto awake() const {
        return std::count_if(bodies.begin(), bodies.end(), [&](const lr_body& b) { return !rests(world, b); });
    }
};
} // namespace

// A uniform wind blew through walls: after 8 s leaves hung on them at half a metre to 3 m, none asleep, and some had climbed over.
TEST_CASE("leaves that a wind blows to a wall sink to its foot and lie still") {
    for (const int32_t kind : {LR_COLLIDER_PLANE, LR_COLLIDER_BOX, LR_COLLIDER_HULL, LR_COLLIDER_MESH})
        for (const Way way : ways) {
            Drift d(kind);
            d.blow(way);
            d.strew();
            steps(d.world, 480, frame);
            CAPTURE(kind);
            CAPTURE(way);
            CHECK(d.highest() < 0.08);
            CHECK(d.beyond() < 1.0);
            CHECK(d.awake() <= 3);
        }
}

// In a stream they hung below the water's edge and trembled, and got up to six times as fast as the stream.
TEST_CASE("bodies that a stream carries to a wall sink along it") {
    Drift d(LR_COLLIDER_BOX, make(rigid_box(0.05, 0.004, 0.05, 1300.0)));
    lr_water_desc w = initialised(lr_water_desc_init);
    w.position[1] = 1.5f, w.current[0] = 2.0f;
    REQUIRE(lr_world_set_water(d.world.get(), &w) == LR_OK);
    d.strew();
    steps(d.world, 480, frame);
    CHECK(d.highest() < 0.08);
    CHECK(d.beyond() < 1.0);
}

TEST_CASE("a wall takes the flow into it, not that along it or away from it") {
    const lr::NearWalls corner{2, {{{-1, 0, 0}, 1.0f, 0.0f}, {{0, 0, 1}, 0.5f, 0.0f}}};
    const auto turned = [&](const lr::NearWalls& walls, lr::Vector flow) {
        walls.turn(flow, [](const auto&) {});
        return Vec{wide(flow.x), wide(flow.y), wide(flow.z)};
    };
    CHECK(turned(corner, {4, 1, -2}) == Vec{0, 1, -1});
    CHECK(turned(corner, {-4, 1, 2}) == Vec{-4, 1, 2});
    // A wall that retreats at half the wind's speed takes half of it, an advancing wall all and no more, one faster than the wind nothing.
    const auto moving = [&](float speed) { return turned({1, {{{-1, 0, 0}, 1.0f, speed}, {}, {}}}, {4, 0, 0})[0]; };
    CHECK(moving(-2.0f) == 2.0);
    CHECK(moving(3.0f) == 0.0);
    CHECK(moving(-6.0f) == 4.0);
}

// A gust that a wall turns must not turn others' wind, nor the ground's: a leaf far from walls keeps its bits, and one that lies on the ground is
// blown along it.
TEST_CASE("walls turn the wind of bodies beside them alone") {
    for (const Way way : ways) {
        const auto far_leaf = [&](bool others) {
            Drift d(LR_COLLIDER_BOX);
            d.blow(way);
            const lr_body far = add_body(d.world, d.batch, at_rest_at({-60.0, 0.3, 0.0}));
            if (others) d.strew();
            steps(d.world, 120, frame);
            return vec(state_of(d.world, far).position);
        };
        CAPTURE(way);
        const Vec with = far_leaf(true);
        CHECK(with == far_leaf(false));
        CHECK(with[0] > -50.0);
    }
}
