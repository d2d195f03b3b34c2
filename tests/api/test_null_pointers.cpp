#include "support/colliders.h"
#include "support/wind.h"

using namespace test;

TEST_CASE("a refused call returns no handle") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    lr_world* const w = world.get();
    lr_asset* out = nullptr;
    const auto null_after = [&](lr_status status) {
        const bool null = status == LR_ERROR_NULL_ARGUMENT && out == nullptr;
        out = asset.get();
        return null;
    };
    out = asset.get();
    CHECK(null_after(lr_asset_load_file(nullptr, &out)));
    CHECK(null_after(lr_asset_load_memory(nullptr, 4, &out)));
    CHECK(null_after(lr_asset_load_memory(nullptr, 0, &out)));
    CHECK(null_after(lr_asset_create_ellipsoid(nullptr, &out)));
    CHECK(null_after(lr_asset_create_rigid(nullptr, &out)));
    lr_world* new_world = w;
    CHECK(lr_world_create(nullptr, &new_world) == LR_ERROR_NULL_ARGUMENT);
    CHECK(new_world == nullptr);
    lr_wind_source source{9};
    CHECK(lr_world_add_gusts(w, nullptr, &source) == LR_ERROR_NULL_ARGUMENT);
    CHECK(source.id == 0);
    lr_batch batch{9};
    CHECK(lr_batch_create(w, nullptr, &batch) == LR_ERROR_NULL_ARGUMENT);
    CHECK(batch.id == 0);
    uint32_t woken = 7;
    const float corner[3] = {};
    CHECK(lr_world_wake_box(w, nullptr, corner, &woken) == LR_ERROR_NULL_ARGUMENT);
    CHECK(woken == 0);
    const lr_batch box = add_batch(world, asset, 1);
    CHECK(lr_batch_spawn_box(w, box, nullptr, corner, 0, nullptr) == LR_ERROR_NULL_ARGUMENT);
    CHECK(lr_batch_spawn_box(w, box, corner, nullptr, 0, nullptr) == LR_ERROR_NULL_ARGUMENT);
    int32_t policy = 9;
    CHECK(lr_batch_get_divergence_policy(nullptr, {1}, &policy) == LR_ERROR_NULL_ARGUMENT);
    CHECK(policy == 9);
    CHECK(lr_world_snapshot_size(nullptr) == 0);
    lr_asset_release(nullptr);
    lr_world_destroy(nullptr);
}

TEST_CASE("arrays that a struct must have are asked for") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    lr_world* const w = world.get();
    const lr_batch batch = add_batch(world, asset, 8);
    add_body(world, batch, body_desc());
    constexpr lr_status null = LR_ERROR_NULL_ARGUMENT;
    const float three[3] = {};

    lr_batch_desc bd = batch_desc();
    bd.capacity = 1;
    lr_batch new_batch = batch;
    CHECK(lr_batch_create(w, &bd, &new_batch) == null); // no asset
    lr_turbulence_table t = table_desc();
    t.count = 1;
    t.dt = t.u0 = t.l = 1.0f;
    CHECK(lr_batch_set_turbulence_table(w, batch, &t) == null);
    t.chi = three;
    CHECK(lr_batch_set_turbulence_table(w, batch, &t) == null);
    lr_force_arrays arrays = initialised(lr_force_arrays_init);
    arrays.count = 1;
    CHECK(lr_batch_add_forces(w, batch, &arrays) == LR_OK); // no arrays
    arrays.force[0] = arrays.force[2] = three;
    CHECK(lr_batch_add_forces(w, batch, &arrays) == null);
    arrays.force[1] = three;
    arrays.torque[1] = three;
    CHECK(lr_batch_add_forces(w, batch, &arrays) == null);
    lr_collider collider{9};
    const uint32_t triangle[3] = {0, 0, 0};
    for (int32_t kind : {LR_COLLIDER_HULL, LR_COLLIDER_MESH, LR_COLLIDER_HEIGHTFIELD}) {
        lr_collider_desc missing = collider_desc(kind);
        missing.vertex_count = 4;
        missing.triangle_count = 1;
        missing.counts[0] = missing.counts[1] = 2;
        CHECK(lr_collider_create(w, &missing, 1, &collider) == null);
        missing.indices = triangle;
        CHECK(lr_collider_create(w, &missing, 1, &collider) == null);
    }
    CHECK(collider.id == 9);
}

TEST_CASE("arrays without elements may be null") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    lr_world* const w = world.get();
    const lr_batch batch = add_batch(world, asset, 8);
    const lr_material rough = initialised(lr_material_init);
    uint32_t count = 0;
    CHECK(lr_simd_targets(nullptr, 0, &count) == LR_OK);
    CHECK(lr_world_sample_wind(w, nullptr, 0, nullptr) == LR_OK);
    CHECK(lr_body_create(w, batch, nullptr, 0, nullptr) == LR_OK);
    CHECK(lr_body_destroy(w, nullptr, 0) == LR_OK);
    CHECK(lr_body_set_sleep(w, nullptr, 0, LR_SLEEP_AWAKE) == LR_OK);
    CHECK(lr_body_add_force(w, nullptr, 0) == LR_OK);
    CHECK(lr_collider_create(w, nullptr, 0, nullptr) == LR_OK);
    CHECK(lr_collider_destroy(w, nullptr, 0) == LR_OK);
    CHECK(lr_collider_move(w, nullptr, 0) == LR_OK);
    CHECK(lr_collider_set_material(w, nullptr, 0, &rough) == LR_OK);
}

TEST_CASE("bodies, colliders and wind sources may be made without asking for their handles") {
    const Asset asset = leaf();
    uint64_t hashes[2];
    for (int ask = 0; ask < 2; ++ask) {
        const World world = make(world_desc());
        lr_world* const w = world.get();
        const lr_batch batch = add_batch(world, asset, 8);
        lr_body bodies[2] = {};
        lr_collider collider{};
        lr_wind_source source{};
        const lr_body_desc body = body_desc();
        const lr_collider_desc plane = collider_desc(LR_COLLIDER_PLANE);
        lr_blower_desc blower = initialised(lr_blower_desc_init);
        CHECK(lr_body_create(w, batch, &body, 1, ask ? bodies : nullptr) == LR_OK);
        const lr_emitter_desc emitter = initialised(lr_emitter_desc_init);
        CHECK(lr_batch_set_emitter(w, batch, &emitter) == LR_OK);
        CHECK(lr_batch_spawn(w, batch, 1, ask ? bodies + 1 : nullptr) == LR_OK);
        CHECK(lr_collider_create(w, &plane, 1, ask ? &collider : nullptr) == LR_OK);
        CHECK(lr_world_add_blower(w, &blower, ask ? &source : nullptr) == LR_OK);
        if (ask) CHECK((bodies[0].id != 0 && bodies[1].id != 0 && collider.id != 0 && source.id != 0));
        steps(world, 4, 0.01f);
        hashes[ask] = hash_of(world);
        // A refusal stays a refusal, with and without the optional pointer.
        blower.nozzle_radius = -1.0f;
        CHECK(lr_world_add_blower(w, &blower, ask ? &source : nullptr) == LR_ERROR_INVALID_ARGUMENT);
        CHECK(source.id == 0);
    }
    CHECK(hashes[0] == hashes[1]);
}

TEST_CASE("an empty batch writes neither transforms nor velocities and needs no buffer") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 8);
    uint32_t written = 9;
    CHECK(lr_batch_write_transforms(world.get(), batch, 0, nullptr, 0, 0, &written) == LR_OK);
    CHECK(written == 0);
    written = 9;
    CHECK(lr_batch_write_velocities(world.get(), batch, nullptr, 0, 3, &written) == LR_OK);
    CHECK(written == 0);
}
