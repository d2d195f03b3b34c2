// Structs: initial values, strides in arrays, and larger structs of later headers. All sizes of each: test_calls.cpp.
#include "support/colliders.h"
#include "support/wind.h"

using namespace test;

namespace {

// The struct at the front of a buffer of zeros, for the fields of a newer, larger struct.
template <class T> struct Grown {
    explicit Grown(const T& from) { std::memcpy(static_cast<void*>(&value), &from, sizeof(T)); }
    T value;
    unsigned char tail[64] = {};
};

} // namespace

TEST_CASE("initial values are those of the header") {
    const lr_world_desc w = world_desc();
    CHECK((w.gravity[0] == 0.0f && w.gravity[1] == -9.81f && w.gravity[2] == 0.0f));
    CHECK((w.worker_count == 0 && w.seed == 0 && w.fluid_density == 0.0f && w.simd_target == LR_SIMD_AUTO));
    CHECK((!w.allocator.allocate && !w.allocator.release && !w.log && !w.jobs.enqueue && !w.jobs.finish));
    const lr_batch_desc b = batch_desc();
    CHECK((b.load_model == LR_LOADS_DEFAULT && b.clock == LR_CLOCK_SPEED && b.table_end == LR_TABLE_CLAMP &&
           b.integrator == LR_INTEGRATOR_DEFAULT));
    CHECK((b.damping_gain == 1.0f && b.noise_gain == 1.0f && b.asset == nullptr));
    const lr_body_desc o = body_desc();
    CHECK((o.orientation[0] == 0.0f && o.orientation[3] == 1.0f && o.scale == 1.0f && o.age == 0.0f &&
           o.noise_seed == 0));
    const lr_ray ray = initialised(lr_ray_init);
    CHECK((ray.flags == (LR_RAY_BODIES | LR_RAY_COLLIDERS) && ray.direction[1] == -1.0f && ray.max_distance == 1e9f));
    CHECK((ray.collider_layers == 0xffffffffu && ray.batch.id == 0 && ray.origin[0] == 0.0f));
    const lr_overlap_desc overlap = initialised(lr_overlap_desc_init);
    CHECK((overlap.shape == LR_OVERLAP_SPHERE && overlap.orientation[3] == 1.0f && overlap.size[2] == 1.0f));
    CHECK(table_desc().c0 == 6.5f);
    const lr_aerodynamics a = initialised(lr_aerodynamics_init);
    for (size_t i = 0; i < 9; ++i) CHECK(a.axes[i] == (i % 4 == 0 ? 1.0 : 0.0));
    CHECK((a.drag[0] == 0.0 && a.spin_drag_stokes[2] == 0.0 && a.intensity == 0.0 && a.length == 1.0));
    const lr_load_gains g = initialised(lr_load_gains_init);
    CHECK((g.drag == 1.0f && g.lift == 1.0f && g.spin_drag == 1.0f && g.turbulence == 1.0f));
    const lr_gusts_desc gusts = initialised(lr_gusts_desc_init);
    CHECK((gusts.direction[0] == 1.0f && gusts.rms == 1.0f && gusts.angle_rms == 0.1f && gusts.integral_time == 0.0f));
    const lr_vortex_desc vortex = initialised(lr_vortex_desc_init);
    CHECK((vortex.core == LR_VORTEX_LAMB_OSEEN && vortex.axis[0] == 0.0f && vortex.axis[1] == 1.0f));
    CHECK((vortex.circulation == 1.0f && vortex.core_radius == 1.0f && vortex.outer_radius == 0.0f));
    const lr_blower_desc blower = initialised(lr_blower_desc_init);
    CHECK((blower.direction[0] == 1.0f && blower.side[2] == 1.0f && blower.speed == 1.0f && blower.spread == 0.1f));
    CHECK((blower.nozzle_radius == 1.0f && blower.half_length == 0.0f && blower.range == 10.0f));
    const lr_turbulence_desc turbulence = initialised(lr_turbulence_desc_init);
    CHECK((turbulence.octaves == 2 && turbulence.rms == 1.0f && turbulence.integral_length == 1.0f));
    const lr_wind_grid_desc grid = initialised(lr_wind_grid_desc_init);
    CHECK((grid.frames == 1 && grid.counts[0] == 0 && grid.spacing[1] == 1.0f && !grid.samples));
    const lr_ground_wind_desc ground = initialised(lr_ground_wind_desc_init);
    CHECK((ground.normal[0] == 0.0f && ground.normal[1] == 1.0f && ground.roughness_length == 0.03f));
    CHECK(ground.reference_height == 10.0f);
    const lr_ellipsoid_desc e = initialised(lr_ellipsoid_desc_init);
    const lr_emitter_desc m = initialised(lr_emitter_desc_init);
    CHECK((m.orientation[3] == 1.0f && m.body_orientation[3] == 1.0f && m.direction[1] == -1.0f && m.rate == 0.0f));
    CHECK((m.scale_min == 1.0f && m.scale_max == 1.0f && m.shape == LR_EMIT_POINT && m.pose == LR_POSE_RANDOM));
    const lr_batch_rules r = initialised(lr_batch_rules_init);
    CHECK((r.action == LR_END_DESTROY && r.max_age == 0.0f && r.volume_count == 0));
    const lr_body_force f = initialised(lr_body_force_init);
    CHECK((f.mode == LR_FORCE_MODE_FORCE && f.frame == LR_FRAME_WORLD && f.flags == 0));
    const lr_collider_desc c = initialised(lr_collider_desc_init);
    CHECK((c.kind == 0 && c.orientation[3] == 1.0f && c.size[0] == 0.0f && c.friction == 0.5f));
    CHECK((c.restitution == 0.2f && c.layers == 1 && c.flags == 0 && c.spacing[1] == 1.0f && !c.vertices));
    const lr_collider_motion v = initialised(lr_collider_motion_init);
    CHECK((v.mode == LR_MOVE_TO && v.collider.id == 0 && v.orientation[3] == 1.0f && v.linear_velocity[0] == 0.0f));
    const lr_material u = initialised(lr_material_init);
    CHECK((u.layers == 1 && u.friction == 0.5f && u.restitution == 0.2f));
    CHECK((e.fluid_density == 1.2 && e.fluid_viscosity == 1.5e-5 && e.intensity == 1.0));
}

TEST_CASE("a struct that another points to is checked too") {
    lr_aerodynamics a = initialised(lr_aerodynamics_init);
    lr_rigid_desc d = rigid_plate();
    d.aerodynamics = &a;
    for (const lr_status expected : {LR_OK, LR_ERROR_STRUCT_SIZE}) {
        lr_asset* out = nullptr;
        CHECK(lr_asset_create_rigid(&d, &out) == expected);
        CHECK((out != nullptr) == (expected == LR_OK));
        lr_asset_release(out);
        a.struct_size = 8;
    }
}

TEST_CASE("the struct_size of an array of body descs is its stride") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 8);
    std::vector<Grown<lr_body_desc>> descs;
    for (int i = 0; i < 3; ++i) {
        descs.emplace_back(body_desc());
        descs.back().value.struct_size = sizeof(Grown<lr_body_desc>);
        descs.back().value.position[1] = static_cast<float>(i);
    }
    lr_body ids[3];
    REQUIRE(lr_body_create(world.get(), batch, &descs[0].value, 3, ids) == LR_OK);
    for (int i = 0; i < 3; ++i) CHECK(state_of(world, ids[i]).position[1] == static_cast<float>(i));
    // An element of another size than the first, or with a tail: none is made.
    descs[2].value.struct_size = sizeof(lr_body_desc);
    CHECK(lr_body_create(world.get(), batch, &descs[0].value, 3, ids) == LR_ERROR_STRUCT_SIZE);
    descs[2].value.struct_size = sizeof(Grown<lr_body_desc>);
    descs[2].tail[5] = 1;
    CHECK(lr_body_create(world.get(), batch, &descs[0].value, 3, ids) == LR_ERROR_STRUCT_SIZE);
    CHECK(info_of(world).body_count == 3);
}

TEST_CASE("snapshots hold what a later header's structs set as this header has it") {
    const Asset asset = leaf();
    std::vector<unsigned char> saved[2];
    for (bool later : {false, true}) {
        const auto give = [&](const auto& desc, auto&& to) {
            Grown grown(desc);
            if (later) grown.value.struct_size = sizeof grown;
            REQUIRE(to(&grown.value) == LR_OK);
        };
        const std::vector<float> wind_samples = grid_samples();
        lr_world* w = nullptr;
        give(world_desc(), [&](const lr_world_desc* d) { return lr_world_create(d, &w); });
        const World world(w);
        lr_batch_desc b = batch_desc();
        b.asset = asset.get();
        b.capacity = 8;
        lr_batch batch{};
        give(b, [&](const lr_batch_desc* d) { return lr_batch_create(w, d, &batch); });
        give(body_desc(), [&](const lr_body_desc* d) { return lr_body_create(w, batch, d, 1, nullptr); });
        for (const AnySource& any : one_of_each(wind_samples))
            std::visit(
                [&](const auto& desc) {
                    using D = std::remove_cvref_t<decltype(desc)>;
                    lr_wind_source source{};
                    give(desc, [&](const D* d) { return add_wind(w, d, &source); });
                    give(desc, [&](const D* d) { return update_wind(w, source, d); });
                },
                any);
        give(initialised(lr_water_desc_init), [&](const lr_water_desc* d) { return lr_world_set_water(w, d); });
        const float sample = 1.0f;
        lr_turbulence_table t = table_desc();
        t.count = 1;
        t.chi = t.epsilon = &sample;
        t.dt = t.u0 = t.l = 1.0f;
        give(t, [&](const lr_turbulence_table* d) { return lr_batch_set_turbulence_table(w, batch, d); });
        give(initialised(lr_aerodynamics_init),
             [&](const lr_aerodynamics* d) { return lr_batch_set_aerodynamics(w, batch, d); });
        give(initialised(lr_load_gains_init),
             [&](const lr_load_gains* d) { return lr_batch_set_load_gains(w, batch, d); });
        give(initialised(lr_batch_force_init),
             [&](const lr_batch_force* d) { return lr_batch_set_force(w, batch, d); });
        give(initialised(lr_batch_rules_init),
             [&](const lr_batch_rules* d) { return lr_batch_set_rules(w, batch, d); });
        give(initialised(lr_emitter_desc_init),
             [&](const lr_emitter_desc* d) { return lr_batch_set_emitter(w, batch, d); });
        give(initialised(lr_batch_contact_init),
             [&](const lr_batch_contact* d) { return lr_batch_set_contact(w, batch, d); });
        lr_collider collider{};
        give(collider_desc(LR_COLLIDER_PLANE),
             [&](const lr_collider_desc* d) { return lr_collider_create(w, d, 1, &collider); });
        lr_collider_motion motion = initialised(lr_collider_motion_init);
        motion.collider = collider;
        give(motion, [&](const lr_collider_motion* d) { return lr_collider_move(w, d, 1); });
        give(initialised(lr_material_init),
             [&](const lr_material* d) { return lr_collider_set_material(w, &collider, 1, d); });
        steps(world, 1, 0.01f);
        saved[later] = snapshot_of(world);
    }
    CHECK(saved[0] == saved[1]);
}
