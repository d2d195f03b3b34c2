// Things that move along the ground and end exactly at it sweep thin bodies along: none slips under them.
#include "support/contact.h"

using namespace test;

namespace {

constexpr uint32_t count = 60;

lr_collider_desc ground(int32_t kind, const Triangles& sheet) {
    if (kind == LR_COLLIDER_MESH) return mesh_collider(sheet);
    if (kind == LR_COLLIDER_PLANE) return collider_desc(kind);
    lr_collider_desc d = box_collider(20.0f, 1.0f, 20.0f);
    d.position[1] = -1.0f;
    return d;
}

// Bodies that lie on the ground, turned about the vertical.
std::vector<lr_body> strew(const World& world, const Asset& asset, Vec low, Vec high) {
    const lr_batch batch = add_batch(world, asset, count);
    Random random(3);
    std::vector<lr_body> bodies;
    for (uint32_t i = 0; i < count; ++i) {
        lr_body_desc b = body_desc();
        put(b.position, Vec{random.uniform(low[0], high[0]), 0.002, random.uniform(low[2], high[2])});
        put(b.orientation, about({0, 1, 0}, random.uniform(0.0, 6.28)));
        bodies.push_back(add_body(world, batch, b));
    }
    return bodies;
}

// Bodies that are behind the broom's front after it has been pushed 2 m through them.
uint32_t left_behind(const Asset& asset, int32_t floor, int32_t kind, float speed, float dt, uint32_t substeps) {
    const World world = make(world_desc());
    const Triangles sheet = fine_sheet(40, 0.25f, [](float, float) { return 0.0f; });
    add_collider(world, ground(floor, sheet));
    const Triangles sides = closed_box(0.02f, 0.5f, 3.0f);
    lr_collider_desc d = kind == LR_COLLIDER_BOX    ? box_collider(0.02f, 0.5f, 3.0f)
                         : kind == LR_COLLIDER_HULL ? hull_collider(sides.vertices)
                                                    : mesh_collider(sides);
    d.position[0] = -1.0f, d.position[1] = 0.5f;
    lr_collider_motion broom = motion_of(add_collider(world, d), LR_MOVE_TO);
    std::copy_n(d.position, 3, broom.position);
    const std::vector<lr_body> bodies = strew(world, asset, {-0.8, 0.0, -2.0}, {0.0, 0.0, 2.0});
    steps(world, static_cast<int>(0.5f / dt), dt, substeps);
    while (broom.position[0] < 1.0f) {
        broom.position[0] += speed * dt;
        REQUIRE(lr_collider_move(world.get(), &broom, 1) == LR_OK);
        steps(world, 1, dt, substeps);
    }
    uint32_t behind = 0;
    for (const lr_body& body : bodies) behind += state_of(world, body).position[0] < broom.position[0] + 0.02f;
    return behind;
}
} // namespace

// A resting body's free motion ends below the ground by g h^2: by several thicknesses in these steps, and so below the broom.
TEST_CASE("no leaf slips under a broom that ends at the ground" * doctest::test_suite("exact")) {
    const Asset leaf = make(ellipsoid(0.03, 0.0005, 0.02, 400.0)), card = make(rigid_box(0.06, 0.0004, 0.04, 400.0));
    for (const Asset* asset : {&leaf, &card})
        for (const int32_t floor : {LR_COLLIDER_PLANE, LR_COLLIDER_BOX, LR_COLLIDER_MESH})
            for (const int32_t kind : {LR_COLLIDER_BOX, LR_COLLIDER_HULL, LR_COLLIDER_MESH}) {
                CAPTURE(asset == &card);
                CAPTURE(floor);
                CAPTURE(kind);
                CHECK(left_behind(*asset, floor, kind, 1.0f, 1.0f / 60.0f, 1) == 0);
                CHECK(left_behind(*asset, floor, kind, 3.0f, 1.0f / 60.0f, 1) <= 1);
                CHECK(left_behind(*asset, floor, kind, 3.0f, 1.0f / 60.0f, 4) == 0);
                CHECK(left_behind(*asset, floor, kind, 10.0f, 1.0f / 240.0f, 1) == 0);
            }
}

// The shortest way out of a crate leads into the ground on which the leaves lie, and does not count.
TEST_CASE("leaves do not stay in a crate that is put over them") {
    const Asset leaf = make(ellipsoid(0.03, 0.0005, 0.02, 400.0)), card = make(rigid_box(0.06, 0.0004, 0.04, 400.0));
    const Triangles sides = closed_box(0.2f, 0.5f, 0.2f),
                    sheet = fine_sheet(40, 0.25f, [](float, float) { return 0.0f; });
    for (const Asset* asset : {&leaf, &card})
        for (const int32_t floor : {LR_COLLIDER_PLANE, LR_COLLIDER_BOX, LR_COLLIDER_MESH})
            for (const bool hull : {false, true}) {
                CAPTURE(asset == &card);
                CAPTURE(floor);
                CAPTURE(hull);
                const World world = make(world_desc());
                add_collider(world, ground(floor, sheet));
                lr_collider_desc d = hull ? hull_collider(sides.vertices) : box_collider(0.2f, 0.5f, 0.2f);
                d.position[0] = 9.0f, d.position[1] = 0.5f;
                lr_collider_motion crate = motion_of(add_collider(world, d), LR_MOVE_PLACE);
                crate.position[1] = 0.5f;
                const std::vector<lr_body> bodies = strew(world, *asset, {-0.2, 0.0, -0.2}, {0.2, 0.0, 0.2});
                steps(world, 30, 1.0f / 60.0f, 1);
                REQUIRE(lr_collider_move(world.get(), &crate, 1) == LR_OK);
                steps(world, 120, 1.0f / 60.0f, 1);
                uint32_t inside = 0, awake = 0;
                for (const lr_body& body : bodies) {
                    const lr_body_state s = state_of(world, body);
                    inside += std::abs(s.position[0]) < 0.2f && std::abs(s.position[2]) < 0.2f;
                    awake += s.sleep_state == LR_SLEEP_AWAKE;
                    CHECK(s.position[1] < 0.1f);
                }
                CHECK(inside == 0);
                CHECK(awake == 0);
            }
}
