// langevin_rigid.hpp: ownership, exceptions, overloads.
#include <langevin_rigid.hpp>

#include "support/counting_memory.h"
#include "support/scene.h"

#include <cstring>
#include <span>
#include <string>
#include <utility>

namespace rigid = langevin_rigid;

namespace {

rigid::Asset leaf_asset() {
    return rigid::Asset::ellipsoid(test::ellipsoid(0.04, 0.01, 0.00005, 800.0));
}

lr_world_desc counted(test::CountingAllocator& memory) {
    lr_world_desc d = LR_WORLD_DESC_INIT;
    d.allocator = memory.callbacks();
    return d;
}

template <class F> lr_status status_of(F&& call) {
    try {
        call();
    } catch (const rigid::Error& e) {
        CHECK(std::strstr(e.what(), lr_last_error()) != nullptr);
        CHECK(*e.what() != 0);
        return e.status();
    }
    return LR_OK;
}

} // namespace

TEST_CASE("C++: worlds and assets are destroyed with their owners, and can be moved") {
    test::CountingAllocator memory, other;
    {
        rigid::World world(counted(memory));
        const lr_batch batch = world.add_batch(leaf_asset(), 8); // keeps the asset
        CHECK(memory.bytes > 0);
        lr_world* const at = world.get();
        rigid::World moved = std::move(world);
        CHECK(moved.get() == at);
        CHECK(!world);
        CHECK(status_of([&] { world.step(0.1f, 1); }) == LR_ERROR_NULL_ARGUMENT);
        moved.add(batch, LR_BODY_DESC_INIT);
        moved.step(0.1f, 4);
        CHECK(moved.info().body_count == 1);
        moved = rigid::World(counted(other)); // destroys the first
        CHECK(memory.bytes == 0);
        CHECK(other.bytes > 0);
        CHECK(status_of([&] { moved.view(batch); }) == LR_ERROR_STALE_BATCH);
    }
    CHECK(other.bytes == 0);
    rigid::Asset a = leaf_asset(), b = std::move(a);
    CHECK((!a && b && b.info().mass > 0.0));
}

TEST_CASE("C++: a failed call throws its status and reason") {
    CHECK(status_of([] { rigid::Asset::load("no such file"); }) == LR_ERROR_FILE_NOT_FOUND);
    CHECK(status_of([] { rigid::Asset::load("x", 1); }) == LR_ERROR_ASSET_FORMAT);
    lr_world_desc d = LR_WORLD_DESC_INIT;
    d.worker_count = 1000;
    CHECK(status_of([&] { rigid::World world(d); }) == LR_ERROR_INVALID_ARGUMENT);
    rigid::World world;
    const lr_batch batch = world.add_batch(leaf_asset(), 2);
    CHECK(status_of([&] { world.spawn(batch, 1); }) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(status_of([&] { world.spawn_box(batch, {}, {}, 3); }) == LR_ERROR_CAPACITY);
    CHECK(status_of([&] { world.add(lr_collider_desc LR_COLLIDER_DESC_INIT); }) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(status_of([&] { world.remove(lr_body{7}); }) == LR_ERROR_STALE_BODY);
    CHECK(status_of([&] { world.restore(std::vector<unsigned char>(9)); }) == LR_ERROR_SNAPSHOT_FORMAT);
    CHECK(world.info().body_count == 0);
}

TEST_CASE("C++: every desc has its overload, and handles theirs") {
    rigid::World world;
    const lr_batch batch = world.add_batch(leaf_asset(), 100);
    const lr_wind_source winds[] = {
        world.add(lr_gusts_desc LR_GUSTS_DESC_INIT), world.add(lr_vortex_desc LR_VORTEX_DESC_INIT),
        world.add(lr_blower_desc LR_BLOWER_DESC_INIT), world.add(lr_turbulence_desc LR_TURBULENCE_DESC_INIT),
        world.add(lr_ground_wind_desc LR_GROUND_WIND_DESC_INIT)};
    lr_gusts_desc gusts = LR_GUSTS_DESC_INIT;
    CHECK(lr_world_get_gusts(world.get(), winds[0], &gusts) == LR_OK);
    lr_vortex_desc vortex = LR_VORTEX_DESC_INIT;
    CHECK(lr_world_get_vortex(world.get(), winds[1], &vortex) == LR_OK);
    for (lr_wind_source w : winds) world.remove(w);
    CHECK(lr_wind_source_is_valid(world.get(), winds[4]) == 0);
    world.set_uniform_wind(1.0f, 0.0f, 0.0f);
    world.set_water(LR_WATER_DESC_INIT);
    world.set_emitter(batch, LR_EMITTER_DESC_INIT);
    world.set_rules(batch, LR_BATCH_RULES_INIT);
    world.set_contact(batch, LR_BATCH_CONTACT_INIT);

    std::vector<lr_body_desc> descs(3, LR_BODY_DESC_INIT);
    for (size_t i = 0; i < 3; ++i) descs[i].position[1] = 5.0f, descs[i].user = i;
    CHECK(world.add(batch, std::span<const lr_body_desc>(descs)).size() == 3);
    const std::vector<lr_body> bodies = world.add(batch, descs.data(), 3);
    CHECK(world.state(bodies[2]).user == 2);
    lr_body_state state = world.state(bodies[0]);
    state.position[0] = 9.0f;
    world.set_state(bodies[0], state);
    CHECK(world.state(bodies[0]).position[0] == 9.0f);
    CHECK(world.spawn(batch, 4).size() == 4);
    CHECK(world.spawn_box(batch, {-1.0f, 2.0f, -1.0f}, {1.0f, 3.0f, 1.0f}, 5).back().id != 0);
    CHECK(world.view(batch).count == 15);
    float transforms[20][8] = {};
    CHECK(world.write_transforms(batch, LR_TRANSFORM_POSITION_QUATERNION_SCALE, transforms, 20) == 15);
    CHECK(transforms[14][7] == 1.0f);
    world.remove(bodies[0]);
    world.remove(batch);
    CHECK(world.info().body_count == 0);
}

TEST_CASE("C++: events are a range, a ray may hit, a snapshot is a vector") {
    rigid::World world;
    const lr_batch batch = world.add_batch(leaf_asset(), 10);
    CHECK(world.events().empty());
    lr_collider_desc floor = LR_COLLIDER_DESC_INIT;
    floor.kind = LR_COLLIDER_PLANE;
    const lr_collider plane = world.add(floor);
    world.set_events(100, LR_EVENTS_SPAWNED | LR_EVENTS_HIT);
    world.spawn_box(batch, {0.0f, 0.2f, 0.0f}, {9.0f, 0.2f, 0.0f}, 10);
    const std::vector<unsigned char> before = world.save();
    const uint64_t hash = world.hash();
    uint32_t spawned = 0, hits = 0;
    for (int i = 0; i < 60; ++i) {
        world.step(1.0f / 60.0f, 2);
        for (const lr_event& e : world.events()) {
            spawned += e.kind == LR_EVENT_SPAWNED;
            hits += e.kind == LR_EVENT_HIT && e.collider == plane;
        }
    }
    CHECK(spawned == 10);
    CHECK(hits >= 10);
    lr_ray ray = LR_RAY_INIT;
    ray.origin[0] = -5.0f, ray.origin[1] = 2.0f;
    const std::optional<lr_ray_hit> hit = world.ray_cast(ray);
    REQUIRE(hit);
    CHECK((hit->collider == plane && hit->distance == doctest::Approx(2.0)));
    world.remove(plane);
    CHECK(!world.ray_cast(ray));
    world.add(floor);
    CHECK(world.hash() != hash);
    world.restore(before);
    CHECK(world.hash() == hash);
}
