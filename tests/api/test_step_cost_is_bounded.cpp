// The longest steps: their cost depends on bodies, substeps and neighbours only, however far bodies move.
#include "support/colliders.h"

#include <ctime>

using namespace test;

namespace {

double seconds_of(const World& world, float dt, uint32_t substeps) {
    const std::clock_t since = std::clock();
    REQUIRE(lr_world_step(world.get(), dt, substeps) == LR_OK);
    return static_cast<double>(std::clock() - since) / CLOCKS_PER_SEC;
}

struct Scene {
    Asset asset = leaf();
    World world;
    lr_batch batch;
    explicit Scene(float gravity) {
        lr_world_desc d = world_desc();
        d.gravity[1] = -gravity;
        world = make(d);
        batch = add_batch(world, asset, 1);
        lr_body_desc body = body_desc();
        body.position[1] = 10.0f;
        add_body(world, batch, body);
    }
};

} // namespace

TEST_CASE("a collider does not make the longest steps endless" * doctest::test_suite("exact")) {
    struct Case {
        float gravity, dt;
        uint32_t substeps;
        float speed; // of the collider
    };
    for (const Case& c : {Case{9.81f, 65536.0f, 65536, 0.0f}, Case{9000.0f, 1000.0f, 1000, 0.0f},
                          Case{9.81f, 65536.0f, 65536, 1e6f}, Case{1e4f, 65536.0f, 65536, 1e6f}}) {
        CAPTURE(c.gravity);
        CAPTURE(c.speed);
        const Scene plain(c.gravity), solid(c.gravity);
        lr_collider_desc ball = sphere_collider(0.5f);
        ball.linear_velocity[0] = c.speed;
        add_collider(solid.world, ball);
        const double alone = seconds_of(plain.world, c.dt, c.substeps);
        CHECK(seconds_of(solid.world, c.dt, c.substeps) < 50.0 * alone + 2.0);
    }
}

TEST_CASE("a body that flies far among very many colliders meets each of them once, not each with all others") {
    const Scene scene(0.0f);
    constexpr uint32_t rows = 500, columns = 600;
    std::vector<lr_collider_desc> balls(rows * columns, sphere_collider(0.4f));
    for (uint32_t i = 0; i < rows * columns; ++i) {
        const uint32_t x = i % columns, z = i / columns, aside = x > z ? x - z : z - x;
        balls[i].position[0] = static_cast<float>(x);
        balls[i].position[1] = aside < 10 ? -100.0f : 0.0f; // out of its way
        balls[i].position[2] = static_cast<float>(z);
    }
    REQUIRE(lr_collider_create(scene.world.get(), balls.data(), rows * columns, nullptr) == LR_OK);
    lr_body_desc fast = body_desc();
    fast.position[1] = 30.0f;
    fast.linear_velocity[0] = fast.linear_velocity[2] = 3e4f;
    fast.linear_velocity[1] = -3000.0f;
    lr_batch_desc free = batch_desc();
    free.load_model = LR_LOADS_NONE; // drag would stop it
    const lr_body body = add_body(scene.world, add_batch(scene.world, free, scene.asset, 1), fast);
    seconds_of(scene.world, 1e-4f, 1); // builds the grid
    CHECK(seconds_of(scene.world, 0.02f, 1) < 5.0);
    CHECK(state_of(scene.world, body).position[0] > 300.0f);
}
