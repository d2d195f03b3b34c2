// Sheets come to rest in stable poses.
#include "support/contact.h"
#include "support/quick.h"

#include <algorithm>
#include <cmath>

using namespace test;

namespace {

const uint32_t count = quick() ? 200 : 600;

void drop(const World& world, lr_batch batch) {
    Random random(1);
    for (uint32_t i = 0; i < count; ++i) {
        add_body(world, batch,
                 turned_anyhow(random, {random.uniform(-3, 3), random.uniform(1, 2), random.uniform(-3, 3)}));
    }
}
lr_batch_desc in_air() {
    lr_batch_desc d = batch_desc();
    d.load_model = LR_LOADS_AERODYNAMIC;
    return d;
}

} // namespace

// The rim of a plate holds it upright within the angle thickness/width, 0.9 degrees here, and the static lock for another half degree; none must lean
// by more.
TEST_CASE("no sheet rests leaning") {
    const Asset assets[] = {make(rigid_box(0.06, 0.0006, 0.04, 400.0)), make(ellipsoid(0.04, 0.02, 0.0005, 400.0))};
    const size_t across[] = {1, 2};
    for (size_t a = 0; a < 2; ++a) {
        CAPTURE(a);
        const World world = make(world_desc());
        const lr_batch batch = add_batch(world, in_air(), assets[a], count);
        add_collider(world, collider_desc(LR_COLLIDER_PLANE));
        drop(world, batch);
        steps(world, 600, 1.0f / 60.0f, 2);
        const lr_batch_view v = view_of(world, batch);
        CHECK(v.awake_count == 0);
        uint32_t leaning = 0, upright = 0;
        for (uint32_t i = 0; i < v.count; ++i) {
            const Quat q{wide(v.orientation[0][i]), wide(v.orientation[1][i]), wide(v.orientation[2][i]),
                         wide(v.orientation[3][i])};
            Vec n{0, 0, 0};
            n[across[a]] = 1.0;
            const double up = std::abs(to_world(q, n)[1]);
            if (up < 0.025)
                ++upright;
            else if (up < 0.99)
                ++leaning;
        }
        CHECK(leaning == 0);
        CHECK(upright <= count / 40);
    }
}

// Leaves that fall on balls slide off, but must not keep jittering on the way.
TEST_CASE("leaves come to rest on logs, and between logs and balls") {
    const Asset asset = make(ellipsoid(0.04, 0.02, 0.0005, 400.0));
    for (int32_t kind : {LR_COLLIDER_CAPSULE, LR_COLLIDER_SPHERE}) {
        CAPTURE(kind);
        const World world = make(world_desc());
        const lr_batch batch = add_batch(world, in_air(), asset, count);
        add_collider(world, collider_desc(LR_COLLIDER_PLANE));
        for (int i = 0; i < 25; ++i) {
            lr_collider_desc d = collider_desc(kind);
            d.size[0] = 0.3f, d.size[1] = 0.25f;
            d.position[0] = 1.2f * static_cast<float>(i % 5) - 2.4f,
            d.position[2] = 1.2f * static_cast<float>(i / 5) - 2.4f;
            put(d.orientation, about({1, 0, 0}, 1.5707963));
            add_collider(world, d);
        }
        drop(world, batch);
        steps(world, 720, 1.0f / 60.0f, 2);
        const lr_batch_view v = view_of(world, batch);
        CHECK(v.awake_count <= count / 100);
        const auto above = [&](uint32_t i) { return v.position[1][i] > 0.05f; };
        uint32_t high = 0;
        for (uint32_t i = v.awake_count; i < v.count; ++i) high += above(i) ? 1u : 0u;
        if (kind == LR_COLLIDER_CAPSULE) CHECK(high > count / 100); // otherwise the test shows nothing
    }
}
