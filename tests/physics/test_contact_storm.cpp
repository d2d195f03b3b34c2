// Light bodies in strong wind and coarse steps: their path in a substep is many times their size. None gets below the ground or through a wall.
#include "support/contact.h"

#include <numbers>

using namespace test;

namespace {

constexpr uint32_t count = 100;
constexpr double half_turn = std::numbers::pi;

Asset confetti() {
    return make(rigid_box(0.005, 0.0001, 0.005, 500.0));
}
Asset dry_leaf() {
    return make(ellipsoid(0.03, 0.0005, 0.02, 400.0));
}
// At rest anywhere in a box, in any orientation.
std::vector<lr_body> strew(const World& world, lr_batch batch, Vec low, Vec high) {
    Random random(7);
    std::vector<lr_body> bodies;
    for (uint32_t i = 0; i < count; ++i) {
        Vec place;
        for (size_t k = 0; k < 3; ++k) place[k] = random.uniform(low[k], high[k]);
        bodies.push_back(add_body(world, batch, turned_anyhow(random, place)));
    }
    return bodies;
}
uint32_t below(const World& world, const std::vector<lr_body>& bodies, Vec normal, double offset) {
    uint32_t n = 0;
    for (const lr_body& b : bodies) n += dot(normal, vec(state_of(world, b).position)) < offset;
    return n;
}
// Pushes bodies as wind does, but also into walls, along which wind turns (m/s^2).
void push(const World& world, lr_batch batch, float x, float y, float z) {
    lr_batch_force f;
    REQUIRE(lr_batch_force_init(&f, sizeof f) == LR_OK);
    f.acceleration[0] = x, f.acceleration[1] = y, f.acceleration[2] = z;
    REQUIRE(lr_batch_set_force(world.get(), batch, &f) == LR_OK);
}
} // namespace

// A correction that would turn a body far is cut as a whole, and left up to 100 of 100 behind the planes, where they also fell asleep.
TEST_CASE("no body stays beyond the planes of a room in a storm that turns") {
    const Asset assets[] = {confetti(), dry_leaf()};
    for (const Asset& asset : assets)
        for (const float dt : {1.0f / 30.0f, 1.0f / 60.0f}) {
            const World world = make(world_desc());
            std::vector<Vec> inward;
            for (const Quat& q : {about({0, 0, 1}, 0.0), about({0, 0, 1}, 0.5 * half_turn), about({0, 0, 1}, half_turn),
                                  about({0, 0, 1}, -0.5 * half_turn), about({1, 0, 0}, 0.5 * half_turn),
                                  about({1, 0, 0}, -0.5 * half_turn)}) {
                lr_collider_desc d = collider_desc(LR_COLLIDER_PLANE);
                inward.push_back(to_world(q, {0, 1, 0}));
                put(d.position, -1.0 * inward.back());
                put(d.orientation, q);
                add_collider(world, d);
            }
            const lr_batch batch = add_batch(world, asset, count);
            const std::vector<lr_body> bodies = strew(world, batch, {-0.9, -0.9, -0.9}, {0.9, 0.9, 0.9});
            uint32_t beyond = 0;
            for (int turn = 0; turn < 4; ++turn) {
                const float x = narrow(20.0 * std::cos(1.1 * turn)), y = turn % 2 == 0 ? -5.0f : 12.0f,
                            z = narrow(20.0 * std::sin(1.1 * turn));
                set_wind(world, x, y, z);
                push(world, batch, 50.0f * x, 50.0f * y, 50.0f * z);
                for (int i = 0; i < 15; ++i) {
                    steps(world, 1, dt);
                    for (const Vec& n : inward) beyond += below(world, bodies, n, -1.001);
                }
            }
            CAPTURE(dt);
            CHECK(beyond == 0);
        }
}

// Bodies that touch each other in the substep in which they reach the ground are solved together.
TEST_CASE("no confetti of a falling heap stays below the ground") {
    const std::vector<float> flat(400, 0.0f);
    for (const int32_t kind : {LR_COLLIDER_PLANE, LR_COLLIDER_HEIGHTFIELD}) {
        const World world = make(world_desc());
        lr_collider_desc d = kind == LR_COLLIDER_PLANE ? collider_desc(kind) : heightfield_collider(flat, 20, 0.5f);
        if (kind == LR_COLLIDER_HEIGHTFIELD) d.position[0] = d.position[2] = -5.0f;
        add_collider(world, d);
        const lr_batch batch = add_batch(world, confetti(), count);
        REQUIRE(lr_batch_set_body_contact(world.get(), batch, batch, 1) == LR_OK);
        const std::vector<lr_body> bodies = strew(world, batch, {-0.15, 0.05, -0.15}, {0.15, 0.6, 0.15});
        steps(world, 60, 1.0f / 30.0f);
        CHECK(below(world, bodies, {0, 1, 0}, 0.0) == 0);
    }
}

// Light bodies take on all of the wind within a step, also that of a blower: walls farther than they could fall are near.
TEST_CASE("a blower that starts drives no body through a wall") {
    const Triangles sheet{{1, -1, -4, 1, -1, 4, 1, 3, -4, 1, 3, 4}, {0, 1, 2, 1, 3, 2}};
    const Asset assets[] = {confetti(), dry_leaf()};
    for (const Asset& asset : assets)
        for (const int32_t kind : {LR_COLLIDER_BOX, LR_COLLIDER_MESH}) {
            const World world = make(world_desc());
            lr_collider_desc d = kind == LR_COLLIDER_BOX ? box_collider(0.01f, 2.0f, 4.0f) : mesh_collider(sheet);
            if (kind == LR_COLLIDER_BOX) d.position[0] = 1.0f;
            add_collider(world, d);
            const lr_batch batch = add_batch(world, asset, count);
            const std::vector<lr_body> bodies = strew(world, batch, {0.3, 0.0, -0.3}, {0.95, 0.6, 0.3});
            lr_blower_desc blower = initialised(lr_blower_desc_init);
            blower.position[0] = -0.5f, blower.position[1] = 0.3f;
            blower.speed = 40.0f, blower.nozzle_radius = 0.3f;
            REQUIRE(lr_world_add_blower(world.get(), &blower, nullptr) == LR_OK);
            steps(world, 2, 1.0f / 60.0f);
            CHECK(below(world, bodies, {-1, 0, 0}, -1.0) == 0);
        }
}

// The swept test took a body within 1e-7 of the ground's size for one that overlaps, and stopped it where it had been: it hung there for ever.
TEST_CASE("bodies that fall on a ground of a kilometre come to rest on it") {
    const Triangles sheet{{-1e3f, 0, -1e3f, 1e3f, 0, -1e3f, 1e3f, 0, 1e3f, -1e3f, 0, 1e3f}, {0, 2, 1, 0, 3, 2}};
    const Asset box = make(rigid_box(0.03, 0.02, 0.015, 300.0));
    for (const int32_t kind : {LR_COLLIDER_BOX, LR_COLLIDER_MESH}) {
        const World world = make(world_desc());
        lr_collider_desc d = kind == LR_COLLIDER_BOX ? box_collider(1e3f, 1.0f, 1e3f) : mesh_collider(sheet);
        if (kind == LR_COLLIDER_BOX) d.position[1] = -1.0f;
        add_collider(world, d);
        const lr_batch batch = add_batch(world, box, count);
        strew(world, batch, {-0.5, 0.1, -0.5}, {0.5, 1.0, 0.5});
        double fastest = 0.0;
        for (int i = 0; i < 180; ++i) {
            steps(world, 1, 1.0f / 60.0f);
            fastest = std::max(fastest, fastest_of(world, batch));
        }
        CHECK(fastest < 6.0); // a fall of 1 m ends at 4.4 m/s; bodies that hang go on gaining speed
        CHECK(info_of(world).awake_count == 0);
    }
}

// Between the ground and a thing that moves the ground yields. If it held the bodies, they would be inside the crate, and rise with it.
TEST_CASE("a crate that presses a heap into the ground takes no brick up") {
    const World world = make(world_desc());
    add_collider(world, collider_desc(LR_COLLIDER_PLANE));
    const Triangles sides = closed_box(0.3f, 0.05f, 0.3f);
    lr_collider_desc d = mesh_collider(sides);
    d.position[1] = 1.0f;
    lr_collider_motion crate = motion_of(add_collider(world, d), LR_MOVE_TO);
    const lr_batch batch = add_batch(world, make(rigid_box(0.03, 0.02, 0.015, 300.0)), count);
    REQUIRE(lr_batch_set_body_contact(world.get(), batch, batch, 1) == LR_OK);
    const std::vector<lr_body> bodies = strew(world, batch, {-0.15, 0.05, -0.15}, {0.15, 0.6, 0.15});
    steps(world, 90, 1.0f / 30.0f);
    for (int i = 1; i <= 150; ++i) { // a second on the ground
        crate.position[1] = 0.05f + 0.95f * narrow(std::max(1.0 - i / 60.0, std::max(i / 60.0 - 1.5, 0.0)));
        REQUIRE(lr_collider_move(world.get(), &crate, 1) == LR_OK);
        steps(world, 1, 1.0f / 30.0f);
    }
    CHECK(below(world, bodies, {0, -1, 0}, -0.3) <= 2);
}

// Middles and half sizes of the floor and the walls of a tray, closed boxes.
constexpr std::array<std::array<float, 6>, 5> tray_walls{{{0, -0.005f, 0, 0.505f, 0.005f, 0.505f},
                                                          {-0.505f, 0.3f, 0, 0.005f, 0.3f, 0.505f},
                                                          {0.505f, 0.3f, 0, 0.005f, 0.3f, 0.505f},
                                                          {0, 0.3f, -0.505f, 0.5f, 0.3f, 0.005f},
                                                          {0, 0.3f, 0.505f, 0.5f, 0.3f, 0.005f}}};
Triangles joined_tray() {
    Triangles all;
    for (const auto& w : tray_walls) join(all, closed_box(w[3], w[4], w[5]), {w[0], w[1], w[2]});
    return all;
}

// A body that a wall and the floor left no room stopped where it was in the world, and the tray went on: up to 19 of 100 fell out through a side.
TEST_CASE("a tray that drives off or rises keeps what lies in it" * doctest::test_suite("long-exact")) {
    const Triangles joined = joined_tray();
    const Asset assets[] = {confetti(), dry_leaf(), make(rigid_box(0.04, 0.001, 0.015, 200.0))};
    for (const bool mesh : {false, true})
        for (const Asset& asset : assets)
            for (const bool rises : {false, true})
                for (const float dt : {1.0f / 30.0f, 1.0f / 60.0f}) {
                    const World world = make(world_desc());
                    std::vector<lr_collider> tray;
                    std::vector<Vec> at;
                    for (const auto& p : tray_walls) {
                        lr_collider_desc d = mesh ? mesh_collider(joined) : box_collider(p[3], p[4], p[5]);
                        at.push_back(mesh ? Vec{} : Vec{wide(p[0]), wide(p[1]), wide(p[2])});
                        put(d.position, at.back());
                        tray.push_back(add_collider(world, d));
                        if (mesh) break;
                    }
                    const lr_batch batch = add_batch(world, asset, count);
                    const std::vector<lr_body> bodies = strew(world, batch, {-0.4, 0.05, -0.4}, {0.4, 0.4, 0.4});
                    std::vector<bool> inside(count, true), lost(count, false);
                    for (int n = 1; n <= std::lround(5.0f / dt); ++n) {
                        const double t = n * wide(dt), from_rest = std::min(t, 2.0);
                        const Vec by = rises ? Vec{0.0, 2.0 * t, 0.0}
                                             : Vec{2.0 * from_rest * from_rest + 8.0 * (t - from_rest), 0.0, 0.0};
                        for (size_t k = 0; k < tray.size(); ++k) {
                            lr_collider_motion m = motion_of(tray[k], LR_MOVE_TO);
                            put(m.position, by + at[k]);
                            REQUIRE(lr_collider_move(world.get(), &m, 1) == LR_OK);
                        }
                        steps(world, 1, dt);
                        for (size_t i = 0; i < bodies.size(); ++i) { // over the walls they may leave
                            const Vec x = vec(state_of(world, bodies[i]).position) - by;
                            const bool in = std::max(std::abs(x[0]), std::abs(x[2])) < 0.51 && x[1] > -0.01;
                            if (inside[i] && !in && x[1] < 0.55) lost[i] = true;
                            inside[i] = in;
                        }
                    }
                    CAPTURE(mesh);
                    CAPTURE(&asset - assets);
                    CAPTURE(rises);
                    CAPTURE(dt);
                    CHECK(std::count(lost.begin(), lost.end(), true) <= 1);
                }
}

// The upper edge of a wall counted as a floor, along the mean normal of its faces, also for fast bodies. With each of these forces, which take leaves
// slowly up the wall, 1 of 100 went through below it.
TEST_CASE("a force like a gale presses leaves to the walls of a mesh, not through them" *
          doctest::test_suite("exact")) {
    const Asset assets[] = {confetti(), dry_leaf(), make(rigid_box(0.04, 0.001, 0.015, 200.0))};
    const Triangles joined = joined_tray();
    for (const Asset& asset : assets)
        for (const float up : {9.0f, 12.0f, 30.0f}) {
            const World world = make(world_desc());
            add_collider(world, mesh_collider(joined));
            const lr_batch batch = add_batch(world, asset, count);
            push(world, batch, -300.0f, up, 0.0f);
            const std::vector<lr_body> bodies = strew(world, batch, {-0.4, 0.05, -0.4}, {0.4, 0.5, 0.4});
            std::vector<bool> below(count, true), lost(count, false); // below: inside, and below the upper edge
            for (int n = 0; n < 480; ++n) {
                steps(world, 1, 1.0f / 60.0f);
                for (size_t i = 0; i < bodies.size(); ++i) {
                    const Vec x = vec(state_of(world, bodies[i]).position);
                    const bool in = std::max(std::abs(x[0]), std::abs(x[2])) < 0.51 && x[1] > -0.01;
                    lost[i] = lost[i] || (below[i] && !in && x[1] < 0.59);
                    below[i] = in && x[1] < 0.59;
                }
            }
            CAPTURE(&asset - assets);
            CAPTURE(up);
            CHECK(std::count(lost.begin(), lost.end(), true) == 0);
        }
}

// Where a body met a heightfield from beside it had no contact, stayed in place and gained speed.
TEST_CASE("a force like a gale shoots nothing out of the corner of a pit" * doctest::test_suite("exact")) {
    constexpr uint32_t samples = 101;
    constexpr float spacing = 0.02f, from = -0.5f * spacing * (samples - 1);
    std::vector<float> heights;
    for (uint32_t k = 0; k < samples; ++k)
        for (uint32_t i = 0; i < samples; ++i) {
            const float x = from + spacing * static_cast<float>(i), z = from + spacing * static_cast<float>(k);
            heights.push_back(std::max(std::abs(x), std::abs(z)) < 0.7f ? 0.0f : 0.4f);
        }
    lr_collider_desc pit = heightfield_collider(heights, samples, spacing);
    pit.position[0] = pit.position[2] = from;
    for (const uint32_t substeps : {1u, 2u}) {
        const World world = make(world_desc());
        add_collider(world, pit);
        const lr_batch batch = add_batch(world, confetti(), count);
        push(world, batch, -400.0f, -400.0f, 150.0f);
        strew(world, batch, {-0.6, 0.1, -0.6}, {0.6, 0.35, 0.6});
        double fastest = 0.0;
        for (int n = 0; n < 360; ++n) {
            steps(world, 1, 1.0f / 60.0f, substeps);
            fastest = std::max(fastest, fastest_of(world, batch));
        }
        CAPTURE(substeps);
        CHECK(fastest < 24.0); // twice as fast as the force drives it in the open
    }
}
