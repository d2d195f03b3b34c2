#include "support/scene.h"

using namespace test;

TEST_CASE("every pointer that must be given is asked for") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    lr_world* const w = world.get();
    const lr_batch batch = add_batch(world, asset, 8);
    const lr_body body = add_body(world, batch, body_desc());
    const uint64_t before = hash_of(world);
    constexpr lr_status null = LR_ERROR_NULL_ARGUMENT;
    // What *out holds after an error is null, so that a caller who ignores the status does not follow rubbish.
    lr_asset* const old_asset = asset.get();

    uint32_t count = 0;
    int32_t target = 0;
    CHECK(lr_simd_targets(nullptr, 0, nullptr) == null);
    CHECK(lr_simd_targets(&target, 1, nullptr) == null);
    CHECK(lr_simd_targets(nullptr, 1, &count) == null);

    lr_asset* out = old_asset;
    const unsigned char bytes[4] = {1, 2, 3, 4};
    CHECK(lr_asset_load_file(nullptr, &out) == null);
    CHECK(out == nullptr);
    CHECK(lr_asset_load_file("x", nullptr) == null);
    out = old_asset;
    CHECK(lr_asset_load_memory(nullptr, 4, &out) == null);
    CHECK(out == nullptr);
    CHECK(lr_asset_load_memory(nullptr, 0, &out) == null);
    CHECK(lr_asset_load_memory(bytes, 4, nullptr) == null);
    CHECK(lr_asset_check_memory(nullptr, 4, nullptr, nullptr) == null);
    out = old_asset;
    CHECK(lr_asset_create_ellipsoid(nullptr, &out) == null);
    CHECK(out == nullptr);
    const lr_ellipsoid_desc shape = ellipsoid(1.0, 1.0, 1.0, 1.0);
    CHECK(lr_asset_create_ellipsoid(&shape, nullptr) == null);
    out = old_asset;
    CHECK(lr_asset_create_rigid(nullptr, &out) == null);
    CHECK(out == nullptr);
    const lr_rigid_desc plate = rigid_plate();
    CHECK(lr_asset_create_rigid(&plate, nullptr) == null);
    CHECK(lr_asset_retain(nullptr) == null);
    lr_asset_release(nullptr);
    lr_asset_info info = initialised(lr_asset_info_init);
    CHECK(lr_asset_get_info(nullptr, &info) == null);
    CHECK(lr_asset_get_info(asset.get(), nullptr) == null);
    lr_aerodynamics loads = initialised(lr_aerodynamics_init);
    CHECK(lr_asset_get_aerodynamics(nullptr, &loads) == null);
    CHECK(lr_asset_get_aerodynamics(asset.get(), nullptr) == null);

    const lr_world_desc wd = world_desc();
    lr_world* new_world = w;
    CHECK(lr_world_create(nullptr, &new_world) == null);
    CHECK(new_world == nullptr);
    CHECK(lr_world_create(&wd, nullptr) == null);
    lr_world_destroy(nullptr);
    lr_world_info wi = initialised(lr_world_info_init);
    CHECK(lr_world_get_info(nullptr, &wi) == null);
    CHECK(lr_world_get_info(w, nullptr) == null);
    const float gravity[3] = {0.0f, 0.0f, 0.0f};
    CHECK(lr_world_set_gravity(nullptr, gravity) == null);
    CHECK(lr_world_set_gravity(w, nullptr) == null);
    CHECK(lr_world_set_simd_target(nullptr, LR_SIMD_AUTO) == null);
    const lr_wind_desc wind = wind_desc();
    CHECK(lr_world_set_wind(nullptr, &wind) == null);
    CHECK(lr_world_set_wind(nullptr, nullptr) == null);
    CHECK(lr_world_set_wind(w, nullptr) == LR_OK);
    lr_wind_source_desc gusts = initialised(lr_wind_source_desc_init);
    gusts.kind = LR_WIND_SOURCE_GUSTS;
    lr_wind_source source = 9;
    CHECK(lr_world_add_wind(nullptr, &gusts, &source) == null);
    CHECK(source == 0);
    CHECK(lr_world_add_wind(w, nullptr, &source) == null);
    CHECK(lr_world_add_wind(w, &gusts, nullptr) == null);
    CHECK(lr_world_add_wind(w, &gusts, &source) == LR_OK);
    CHECK(lr_world_update_wind(nullptr, source, &gusts) == null);
    CHECK(lr_world_update_wind(w, source, nullptr) == null);
    CHECK(lr_world_remove_wind(nullptr, source) == null);
    CHECK(lr_world_remove_wind(w, source) == LR_OK);
    const lr_surface_desc surface = initialised(lr_surface_desc_init);
    CHECK(lr_world_set_surface(nullptr, &surface) == null);
    CHECK(lr_world_set_surface(nullptr, nullptr) == null);
    CHECK(lr_world_set_surface(w, nullptr) == LR_OK);
    CHECK(lr_world_set_surface_callback(nullptr, nullptr, nullptr) == null);
    CHECK(lr_world_set_surface_callback(w, nullptr, nullptr) == LR_OK);
    CHECK(lr_world_set_wind_callback(nullptr, nullptr, nullptr) == null);
    CHECK(lr_world_set_wind_callback(w, nullptr, nullptr) == LR_OK);
    float velocity[3] = {};
    CHECK(lr_world_sample_wind(nullptr, gravity, 1, velocity) == null);
    CHECK(lr_world_sample_wind(w, nullptr, 1, velocity) == null);
    CHECK(lr_world_sample_wind(w, gravity, 1, nullptr) == null);
    CHECK(lr_world_step(nullptr, 0.01f, 1) == null);
    uint64_t hash = 0;
    CHECK(lr_world_hash(nullptr, &hash) == null);
    CHECK(lr_world_hash(w, nullptr) == null);
    CHECK(lr_world_snapshot_size(nullptr) == 0);
    std::vector<unsigned char> memory(lr_world_snapshot_size(w));
    uint64_t written = 7;
    CHECK(lr_world_snapshot_save(nullptr, memory.data(), memory.size(), &written) == null);
    CHECK(lr_world_snapshot_save(w, nullptr, memory.size(), &written) == null);
    CHECK(lr_world_snapshot_save(w, memory.data(), memory.size(), nullptr) == LR_OK);
    CHECK(lr_world_snapshot_restore(nullptr, memory.data(), memory.size()) == null);
    CHECK(lr_world_snapshot_restore(w, nullptr, memory.size()) == null);

    lr_batch_desc bd = batch_desc();
    bd.capacity = 1;
    lr_batch new_batch = batch;
    CHECK(lr_batch_create(w, &bd, &new_batch) == null); // no asset
    CHECK(new_batch == 0);
    bd.asset = asset.get();
    CHECK(lr_batch_create(nullptr, &bd, &new_batch) == null);
    CHECK(lr_batch_create(w, nullptr, &new_batch) == null);
    CHECK(lr_batch_create(w, &bd, nullptr) == null);
    CHECK(lr_batch_destroy(nullptr, batch) == null);
    lr_turbulence_table t = table_desc();
    t.count = 1;
    t.dt = t.u0 = t.l = 1.0f;
    CHECK(lr_batch_set_turbulence_table(nullptr, batch, &t) == null);
    CHECK(lr_batch_set_turbulence_table(w, batch, &t) == null); // no arrays
    t.chi = gravity;
    CHECK(lr_batch_set_turbulence_table(w, batch, &t) == null);
    CHECK(lr_batch_set_turbulence_table(w, batch, nullptr) == LR_OK);
    CHECK(lr_batch_set_aerodynamics(nullptr, batch, &loads) == null);
    CHECK(lr_batch_set_aerodynamics(w, batch, nullptr) == LR_OK);
    CHECK(lr_batch_get_aerodynamics(nullptr, batch, &loads) == null);
    CHECK(lr_batch_get_aerodynamics(w, batch, nullptr) == null);
    CHECK(lr_batch_set_load_gains(nullptr, batch, nullptr) == null);
    CHECK(lr_batch_set_load_gains(w, batch, nullptr) == LR_OK);
    lr_batch_view view = initialised(lr_batch_view_init);
    CHECK(lr_batch_get_view(nullptr, batch, &view) == null);
    CHECK(lr_batch_get_view(w, batch, nullptr) == null);
    float transforms[16];
    CHECK(lr_batch_write_transforms(nullptr, batch, 0, transforms, 0, 1, nullptr) == null);
    CHECK(lr_batch_write_transforms(w, batch, 0, nullptr, 0, 1, nullptr) == null);

    const lr_body_desc desc = body_desc();
    lr_body id = 0;
    CHECK(lr_body_create(nullptr, batch, &desc, 1, &id) == null);
    CHECK(lr_body_create(w, batch, nullptr, 1, &id) == null);
    CHECK(lr_body_create(w, batch, nullptr, 0, nullptr) == LR_OK);
    CHECK(lr_body_destroy(nullptr, &body, 1) == null);
    CHECK(lr_body_destroy(w, nullptr, 1) == null);
    CHECK(lr_body_destroy(w, nullptr, 0) == LR_OK);
    lr_body_state state = body_state();
    CHECK(lr_body_get_state(nullptr, body, &state) == null);
    CHECK(lr_body_get_state(w, body, nullptr) == null);
    CHECK(lr_body_set_state(nullptr, body, &state) == null);
    CHECK(lr_body_set_state(w, body, nullptr) == null);

    lr_body_force force = initialised(lr_body_force_init);
    force.body = body;
    CHECK(lr_body_add_force(nullptr, &force, 1) == null);
    CHECK(lr_body_add_force(w, nullptr, 1) == null);
    CHECK(lr_body_add_force(w, nullptr, 0) == LR_OK);
    lr_force_arrays arrays = initialised(lr_force_arrays_init);
    CHECK(lr_batch_add_forces(nullptr, batch, &arrays) == null);
    CHECK(lr_batch_add_forces(w, batch, nullptr) == null);
    CHECK(lr_batch_add_forces(w, batch, &arrays) == LR_OK); // no bodies, no arrays
    arrays.count = 1;
    CHECK(lr_batch_add_forces(w, batch, &arrays) == LR_OK);
    arrays.force[0] = arrays.force[2] = gravity;
    CHECK(lr_batch_add_forces(w, batch, &arrays) == null);
    arrays.force[1] = gravity;
    arrays.torque[1] = gravity;
    CHECK(lr_batch_add_forces(w, batch, &arrays) == null);
    const lr_batch_force on_all = initialised(lr_batch_force_init);
    CHECK(lr_batch_set_force(nullptr, batch, &on_all) == null);
    CHECK(lr_batch_set_force(w, batch, nullptr) == LR_OK);
    const lr_batch_rules rules = initialised(lr_batch_rules_init);
    CHECK(lr_batch_set_rules(nullptr, batch, &rules) == null);
    CHECK(lr_batch_set_rules(w, batch, nullptr) == LR_OK);
    const lr_emitter_desc emitter = initialised(lr_emitter_desc_init);
    CHECK(lr_batch_set_emitter(nullptr, batch, &emitter) == null);
    CHECK(lr_batch_set_emitter(w, batch, nullptr) == LR_OK);
    CHECK(lr_batch_emit(nullptr, batch, 1, &id) == null);
    lr_batch_events events = initialised(lr_batch_events_init);
    CHECK(lr_batch_get_events(nullptr, batch, &events) == null);
    CHECK(lr_batch_get_events(w, batch, nullptr) == null);

    CHECK(hash_of(world) == before);
    steps(world, 1, 0.01f);
}

TEST_CASE("an empty batch writes no transforms and needs no buffer") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 8);
    uint32_t written = 9;
    CHECK(lr_batch_write_transforms(world.get(), batch, 0, nullptr, 0, 0, &written) == LR_OK);
    CHECK(written == 0);
}
