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

// Of triangles with legs of `cell` m whose corners are up to `bump` before or behind x = 1; 3 m high, along z from -3 m on.
Triangles rough_wall(float cell, double bump, float length) {
    Random random(11);
    const auto up = static_cast<uint32_t>(3.0f / cell), along = static_cast<uint32_t>(length / cell);
    Triangles t;
    for (uint32_t k = 0; k <= along; ++k)
        for (uint32_t i = 0; i <= up; ++i)
            t.vertices.insert(t.vertices.end(), {1.0f + random.real(-bump, bump), cell * static_cast<float>(i),
                                                 cell * static_cast<float>(k) - 3.0f});
    for (uint32_t k = 0; k < along; ++k)
        for (uint32_t i = 0; i < up; ++i) {
            const uint32_t a = i + (up + 1) * k, b = a + up + 1;
            t.indices.insert(t.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
        }
    return t;
}

constexpr int32_t no_wall = 0, rough = 100; // no kinds of colliders

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
    } else if (kind == rough) {
        add_collider(world, mesh_collider(rough_wall(0.05f, 0.01, 15.0f)));
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
        if (kind != no_wall) add_wall(world, kind);
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
    void strew(uint64_t seed = 3) {
        Random random(seed);
        for (uint32_t i = 0; i < count; ++i)
            bodies.push_back(
                add_body(world, batch,
                         turned_anyhow(random, {random.uniform(-1.0, 0.5), random.uniform(0.2, 1.2), 0.06 * i - 2.0})));
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
    for (const int32_t kind : {int32_t{LR_COLLIDER_PLANE}, int32_t{LR_COLLIDER_BOX}, int32_t{LR_COLLIDER_HULL},
                               int32_t{LR_COLLIDER_MESH}, rough})
        for (const Way way : ways) {
            if (kind == rough && way != alone && way != with_others) continue;
            CAPTURE(kind);
            CAPTURE(way);
            // On stones 1 to 2 of 60 lie awake, and in one of twenty heaps more than 3.
            const int heaps = kind == rough ? 4 : 1;
            std::ptrdiff_t awake = 0;
            for (int seed = 3; seed < 3 + heaps; ++seed) {
                Drift d(kind);
                d.blow(way);
                d.strew(static_cast<uint64_t>(seed));
                steps(d.world, 480, frame);
                if (kind != rough) CHECK(d.highest() < 0.08); // others lie on its stones
                CHECK(d.beyond() < (kind == rough ? 1.01 : 1.0));
                awake += d.awake();
            }
            CHECK(awake <= (kind == rough ? 8 : 3));
        }
}

// The supports of a body lift it before it is swept. Where a stone of the wall leans over the ground that put it on the wall's other side: of 60 leaves
// up to 9 went through.
TEST_CASE("a rough wall lets no body through, also where it leans over the ground" * doctest::test_suite("exact")) {
    constexpr double bump = 0.024;
    for (const double size : {0.3, 1.0}) // of the leaf
        for (const float dt : {1.0f / 30.0f, 1.0f / 60.0f}) {
            Drift d(no_wall, make(ellipsoid(0.03 * size, 0.0005 * size, 0.02 * size, 200.0)));
            const Triangles wall = rough_wall(0.06f, bump, 6.0f);
            add_collider(d.world, mesh_collider(wall));
            set_wind(d.world, 10.0f, 0.0f, 0.0f);
            d.strew();
            std::vector<double> height(count, 0.0); // where it was last before the wall
            uint32_t through = 0;
            for (int i = 0; i < std::lround(4.0f / dt); ++i) {
                steps(d.world, 1, dt);
                for (uint32_t k = 0; k < count; ++k) {
                    const lr_body_state s = state_of(d.world, d.bodies[k]);
                    if (wide(s.position[0]) < 1.0 + bump)
                        height[k] = wide(s.position[1]);
                    else
                        through += std::exchange(height[k], 3.0) < 2.7; // the others were blown over it
                }
            }
            CAPTURE(size);
            CAPTURE(dt);
            CHECK(through == 0);
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
