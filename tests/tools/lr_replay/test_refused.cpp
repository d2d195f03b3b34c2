// Refused calls can have arbitrary values in unchecked arguments: a recording does not read them either.
#include "support/colliders.h"
#include "support/wind.h"
#include "tools/lr_replay/recording.h"

using namespace test;

namespace {

// Not mapped in this program: reading there ends it.
template <class T> const T* nowhere() {
    return reinterpret_cast<const T*>(uintptr_t{256});
}

template <class T> void stale(lr_status (*function)(lr_world*, lr_batch, const T*), lr_world* w) {
    CHECK(function(w, {999}, nowhere<T>()) == LR_ERROR_STALE_BATCH);
}

} // namespace

TEST_CASE("no recorder reads what a call has not accepted") {
    const Asset flat = leaf();
    const World world = make(world_desc());
    lr_world* const w = world.get();
    Recording recording;
    recording.start(world);
    const lr_batch batch = add_batch(world, flat, 100000);
    const lr_body body = add_body(world, batch, body_desc());
    const lr_collider ball = add_collider(world, sphere_collider(0.1f));

    // Each array has only its beginning.
    const std::vector<float> few(12, 0.0f);
    const std::vector<uint32_t> indices(12, 0u);
    lr_collider_desc solid = collider_desc(LR_COLLIDER_HEIGHTFIELD);
    solid.heights = few.data();
    solid.counts[0] = LR_MAX_COLLIDER_VERTICES, solid.counts[1] = 1;
    CHECK(lr_collider_create(w, &solid, 1, nullptr) == LR_ERROR_INVALID_ARGUMENT);
    solid.counts[0] = solid.counts[1] = 8192;
    solid.spacing[1] = 0.0f;
    CHECK(lr_collider_create(w, &solid, 1, nullptr) == LR_ERROR_INVALID_ARGUMENT);
    solid = collider_desc(LR_COLLIDER_MESH);
    solid.vertices = nowhere<float>(), solid.indices = nowhere<uint32_t>();
    solid.vertex_count = LR_MAX_COLLIDER_VERTICES, solid.triangle_count = 0;
    CHECK(lr_collider_create(w, &solid, 1, nullptr) == LR_ERROR_INVALID_ARGUMENT);
    solid.vertices = few.data(), solid.indices = nullptr, solid.triangle_count = 4;
    CHECK(lr_collider_create(w, &solid, 1, nullptr) == LR_ERROR_NULL_ARGUMENT);
    solid = collider_desc(LR_COLLIDER_HULL);
    solid.vertices = nowhere<float>(), solid.vertex_count = 4, solid.friction = -1.0f;
    CHECK(lr_collider_create(w, &solid, 1, nullptr) == LR_ERROR_INVALID_ARGUMENT);
    solid.friction = INFINITY;
    CHECK(lr_collider_create(w, &solid, 4000000000u, nullptr) == LR_ERROR_NOT_FINITE); // refused by the first

    lr_wind_grid_desc grid = initialised(lr_wind_grid_desc_init);
    grid.counts[0] = 400, grid.counts[1] = grid.counts[2] = 300;
    grid.samples = few.data();
    grid.frame_time = -1.0f;
    lr_wind_source source{};
    CHECK(lr_world_add_wind_grid(w, &grid, &source) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(lr_world_update_wind_grid(w, {999}, nowhere<lr_wind_grid_desc>()) == LR_ERROR_STALE_WIND_SOURCE);

    lr_turbulence_table table = table_desc();
    table.count = 65536, table.dt = table.u0 = table.l = 1.0f, table.c0 = -1.0f;
    table.chi = table.epsilon = nowhere<float>();
    CHECK(lr_batch_set_turbulence_table(w, batch, &table) == LR_ERROR_INVALID_ARGUMENT);

    lr_batch_desc unmade = batch_desc();
    unmade.asset = reinterpret_cast<const lr_asset*>(uintptr_t{256});
    lr_batch none{};
    CHECK(lr_batch_create(w, &unmade, &none) == LR_ERROR_INVALID_ARGUMENT); // refused for its capacity of 0

    lr_body_desc spawned = body_desc();
    spawned.position[0] = INFINITY;
    CHECK(lr_body_create(w, batch, &spawned, 90000, nullptr) == LR_ERROR_NOT_FINITE);
    CHECK(lr_body_create(w, {999}, nowhere<lr_body_desc>(), 90000, nullptr) == LR_ERROR_STALE_BATCH);
    const lr_body gone{12345678901u};
    const lr_collider lost{12345678901u};
    constexpr uint32_t many = 2000000000;
    CHECK(lr_body_destroy(w, &gone, many) == LR_ERROR_STALE_BODY);
    CHECK(lr_body_set_sleep(w, &gone, many, LR_SLEEP_ASLEEP) == LR_ERROR_STALE_BODY);
    CHECK(lr_body_set_sleep(w, nowhere<lr_body>(), many, 99) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(lr_collider_destroy(w, nowhere<lr_collider>(), 0) == LR_OK);
    const lr_material rough = initialised(lr_material_init);
    CHECK(lr_collider_set_material(w, &lost, many, &rough) == LR_ERROR_STALE_COLLIDER);
    CHECK(lr_body_set_state(w, gone, nowhere<lr_body_state>()) == LR_ERROR_STALE_BODY);
    lr_body_force push = initialised(lr_body_force_init);
    push.body = gone;
    CHECK(lr_body_add_force(w, &push, many) == LR_ERROR_STALE_BODY);
    lr_collider_motion motion = initialised(lr_collider_motion_init);
    motion.collider = lost;
    CHECK(lr_collider_move(w, &motion, many) == LR_ERROR_STALE_COLLIDER);
    lr_force_arrays arrays = initialised(lr_force_arrays_init);
    arrays.count = 1, arrays.mode = 99;
    arrays.force[0] = arrays.force[1] = arrays.force[2] = nowhere<float>();
    CHECK(lr_batch_add_forces(w, batch, &arrays) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(lr_world_wake_box(w, nowhere<float>(), nullptr, nullptr) == LR_ERROR_NULL_ARGUMENT);
    const std::vector<unsigned char> noise(200, 7);
    CHECK(lr_world_snapshot_restore(w, noise.data(), uint64_t{1} << 33) == LR_ERROR_SNAPSHOT_FORMAT);

    stale(&lr_batch_set_turbulence_table, w);
    stale(&lr_batch_set_aerodynamics, w);
    stale(&lr_batch_set_load_gains, w);
    CHECK(lr_batch_set_rate(w, {999}, 2) == LR_ERROR_STALE_BATCH);
    stale(&lr_batch_add_forces, w);
    stale(&lr_batch_set_force, w);
    stale(&lr_batch_set_contact, w);
    stale(&lr_batch_set_rules, w);
    stale(&lr_batch_set_emitter, w);

    // Accepted calls are still recorded, among them a snapshot in larger memory.
    std::vector<unsigned char> snapshot = snapshot_of(world);
    REQUIRE(lr_world_snapshot_restore(w, snapshot.data(), snapshot.size()) == LR_OK);
    motion.collider = ball;
    motion.position[0] = 1.0f;
    REQUIRE(lr_collider_move(w, &motion, 1) == LR_OK);
    push.body = body, push.force[1] = 1e-3f;
    REQUIRE(lr_body_add_force(w, &push, 1) == LR_OK);
    REQUIRE(lr_body_destroy(w, &body, 0) == LR_OK);
    steps(world, 3, 0.01f);
    CHECK(lr_batch_destroy(w, {999}) == LR_ERROR_STALE_BATCH); // has no pointers: replayed, and refused there too
    REQUIRE(lr_body_destroy(w, &body, 1) == LR_OK);
    const lr::replay::Outcome played = recording.play();
    CHECK(wrong_in(played) == "");
    CHECK(played.hash == hash_of(world));
    CHECK(played.unread >= 30);
    CHECK(played.calls - played.unread == 14);
}
