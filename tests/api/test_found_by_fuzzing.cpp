// Regression tests for the fuzzers' finds (docs/maintainers/testing.md).
#include "support/colliders.h"
#include "support/contact.h"
#include "support/lifecycle.h"
#include "support/wind.h"

#include <limits>
#include <random>
#include <utility>
#include <vector>

using namespace test;

TEST_CASE("destroying colliders wakes nobody when it is refused") {
    const World world = make(world_desc());
    const lr_collider plane = add_collider(world, collider_desc(LR_COLLIDER_PLANE));
    const lr_collider gone = add_collider(world, sphere_collider(0.1f));
    REQUIRE(lr_collider_destroy(world.get(), &gone, 1) == LR_OK);
    const Asset asset = brick();
    const lr_body body = add_body(world, add_batch(world, unloaded(), asset, 4), body_desc());
    REQUIRE(lr_body_set_sleep(world.get(), &body, 1, LR_SLEEP_ASLEEP) == LR_OK);
    uint64_t before = 0, after = 0;
    REQUIRE(lr_world_hash(world.get(), &before) == LR_OK);
    const lr_collider lists[2][2] = {{plane, gone}, {plane, plane}};
    for (const auto& list : lists) {
        CHECK(lr_collider_destroy(world.get(), list, 2) == LR_ERROR_STALE_COLLIDER);
        CHECK(state_of(world, body).sleep_state == LR_SLEEP_ASLEEP);
        REQUIRE(lr_world_hash(world.get(), &after) == LR_OK);
        CHECK(after == before);
    }
    CHECK(lr_collider_destroy(world.get(), &plane, 1) == LR_OK);
    CHECK(state_of(world, body).sleep_state == LR_SLEEP_AWAKE);
}

TEST_CASE("the least lengths and times that the header names are taken in single precision too") {
    const World world = make(world_desc());
    lr_turbulence_desc turbulence = initialised(lr_turbulence_desc_init);
    turbulence.integral_length = 1e-4f;
    add_source(world, turbulence);
    turbulence.integral_length = 0.99e-4f;
    CHECK(lr_world_add_turbulence(world.get(), &turbulence, nullptr) == LR_ERROR_INVALID_ARGUMENT);
    const std::vector<float> samples(3 * 8, 1.0f);
    lr_wind_grid_desc d = initialised(lr_wind_grid_desc_init);
    d.samples = samples.data();
    for (size_t k = 0; k < 3; ++k) d.counts[k] = 2, d.spacing[k] = 1e-4f;
    add_source(world, d);
    d.spacing[2] = 0.99e-4f;
    CHECK(lr_world_add_wind_grid(world.get(), &d, nullptr) == LR_ERROR_INVALID_ARGUMENT);

    const Asset asset = brick();
    const lr_batch batch = add_batch(world, unloaded(), asset, 4);
    lr_emitter_desc e = emitter_desc();
    e.burst_count = 1;
    e.burst_interval = 1e-4f;
    set_emitter(world, batch, e);
    e.burst_interval = 0.99e-4f;
    CHECK(lr_batch_set_emitter(world.get(), batch, &e) == LR_ERROR_INVALID_ARGUMENT);
}

TEST_CASE("a step under the least float notes nothing of contacts that a snapshot would leave out") {
    const Asset asset = brick();
    const auto filled = [&] {
        World world = make(world_desc());
        add_collider(world, collider_desc(LR_COLLIDER_PLANE));
        return std::make_pair(std::move(world), add_batch(world, unloaded(), asset, 1));
    };
    const auto [other, same] = filled();
    std::mt19937 random(5);
    std::normal_distribution<float> normal;
    std::uniform_real_distribution<float> above(0.02f, 0.08f); // above the plane, mostly near it
    for (int i = 0; i < 400; ++i) {
        const auto [world, batch] = filled();
        lr_body_desc d = body_desc();
        d.position[1] = above(random);
        for (float& q : d.orientation) q = normal(random);
        add_body(world, batch, d);
        for (uint32_t substeps : {1u, 2u, 3u}) {
            REQUIRE(lr_world_step(world.get(), std::numeric_limits<float>::denorm_min(), substeps) == LR_OK);
            const std::vector<unsigned char> bytes = snapshot_of(world);
            REQUIRE(lr_world_snapshot_restore(other.get(), bytes.data(), bytes.size()) == LR_OK);
            CHECK_MESSAGE(hash_of(other) == hash_of(world), "body ", i, ", substeps ", substeps);
        }
    }
}
