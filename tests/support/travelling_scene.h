// A small world with all parts of a snapshot, for snapshots between processes, processors and releases. Uses only the C API, + - x / and square
// roots, so that it is the same everywhere.
#pragma once

#include "langevin_rigid_research.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace test {

class TravellingScene {
public:
    static constexpr float dt = 1.0f / 60.0f;
    static constexpr uint32_t leaves = 70, discs = 33; // capacities

    // An empty world with equal batches, as restoring needs it. lived: the world to save.
    explicit TravellingScene(int32_t simd = LR_SIMD_AUTO, bool lived = true) {
        lr_world_desc wd;
        good_ = lr_world_desc_init(&wd, sizeof wd) == LR_OK;
        wd.seed = 20, wd.simd_target = simd;
        good_ = good_ && lr_world_create(&wd, &world_) == LR_OK;
        add_batch(0, leaves, LR_LOADS_AERODYNAMIC, LR_CLOCK_SPEED);
        add_batch(1, discs, LR_LOADS_LANGEVIN, LR_CLOCK_AGE);
        if (lived && good_) live();
    }
    TravellingScene(const TravellingScene&) = delete;
    TravellingScene& operator=(const TravellingScene&) = delete;
    ~TravellingScene() {
        lr_world_destroy(world_);
        for (lr_asset* asset : assets_) lr_asset_release(asset);
    }

    bool good() const { return good_; }
    lr_world* world() const { return world_; }
    lr_batch batch(size_t i) const { return batches_[i]; }
    uint64_t hash() const {
        uint64_t h = 0;
        lr_world_hash(world_, &h);
        return h;
    }
    bool step(int count) {
        for (int i = 0; i < count; ++i) need(lr_world_step(world_, dt, 2));
        return good_;
    }
    // Continues after the snapshot with inputs of all kinds, the same after each restore. Returns the hash.
    uint64_t go_on() {
        for (int i = 0; i < 40 && good_; ++i) {
            if (i % 8 == 0) {
                const float low[3] = {-0.5f, -1.0f, -0.5f}, high[3] = {0.5f, 1.0f, 0.5f};
                need(lr_world_wake_box(world_, low, high, nullptr));
            }
            if (i == 10) set_wind(2.0f, -1.0f);
            step(1);
        }
        return hash();
    }
    std::vector<unsigned char> save() {
        std::vector<unsigned char> bytes(static_cast<size_t>(lr_world_snapshot_size(world_)));
        need(lr_world_snapshot_save(world_, bytes.data(), bytes.size(), nullptr));
        return bytes;
    }

private:
    void need(lr_status status) { good_ = good_ && status == LR_OK; }

    void add_batch(size_t i, uint32_t capacity, int32_t loads, int32_t clock) {
        lr_ellipsoid_desc shape;
        need(lr_ellipsoid_desc_init(&shape, sizeof shape));
        shape.semi_axes[0] = 0.04, shape.semi_axes[1] = i == 0 ? 0.02 : 0.04, shape.semi_axes[2] = 0.0005;
        shape.density = 300.0;
        if (i == 1) shape.center_of_mass[0] = 0.003;
        if (good_) need(lr_asset_create_ellipsoid(&shape, &assets_[i]));
        lr_batch_desc bd;
        need(lr_batch_desc_init(&bd, sizeof bd));
        bd.asset = assets_[i], bd.capacity = capacity, bd.load_model = loads, bd.clock = clock;
        if (good_) need(lr_batch_create(world_, &bd, &batches_[i]));
    }
    void set_wind(float x, float z) { need(lr_world_set_uniform_wind(world_, x, 0.0f, z)); }
    void add_sources() {
        lr_gusts_desc gusts;
        need(lr_gusts_desc_init(&gusts, sizeof gusts));
        gusts.rms = 0.4f, gusts.integral_time = 2.0f, gusts.seed = 3;
        need(lr_world_add_gusts(world_, &gusts, nullptr));
        lr_vortex_desc vortex;
        need(lr_vortex_desc_init(&vortex, sizeof vortex));
        vortex.axis[0] = 1.0f, vortex.axis[1] = 0.0f;
        vortex.core_radius = 1.5f;
        need(lr_world_add_vortex(world_, &vortex, nullptr));
        lr_turbulence_desc turbulence;
        need(lr_turbulence_desc_init(&turbulence, sizeof turbulence));
        turbulence.rms = 0.4f, turbulence.integral_length = 1.5f, turbulence.eddy_life = 2.0f, turbulence.seed = 3;
        need(lr_world_add_turbulence(world_, &turbulence, nullptr));
    }
    void live() {
        set_wind(0.5f, 0.25f);
        add_sources();
        lr_collider_desc ground;
        need(lr_collider_desc_init(&ground, sizeof ground));
        ground.kind = LR_COLLIDER_PLANE;
        need(lr_collider_create(world_, &ground, 1, nullptr));
        lr_emitter_desc e;
        need(lr_emitter_desc_init(&e, sizeof e));
        e.shape = LR_EMIT_BOX, e.position[1] = 1.0f, e.size[0] = e.size[2] = 1.0f, e.size[1] = 0.9f;
        e.rate = 10.0f, e.spin_max = 6.0f, e.speed_max = 1.0f, e.scale_min = 0.5f, e.scale_max = 1.5f;
        lr_batch_rules r;
        need(lr_batch_rules_init(&r, sizeof r));
        r.max_age = 3.0f, r.action = LR_END_RESPAWN;
        for (lr_batch batch : batches_) {
            need(lr_batch_set_emitter(world_, batch, &e));
            need(lr_batch_set_rules(world_, batch, &r));
            r.max_age = 1.0f, r.action = LR_END_DESTROY;
        }
        lr_body ids[40] = {};
        need(lr_batch_spawn(world_, batches_[0], 40, ids));
        need(lr_batch_spawn(world_, batches_[1], 20, nullptr));
        const float chi[3] = {1.0f, 2.0f, 3.0f}, epsilon[3] = {0.01f, 0.03f, 0.02f};
        lr_turbulence_table t;
        need(lr_turbulence_table_init(&t, sizeof t));
        t.count = 3, t.chi = chi, t.epsilon = epsilon, t.dt = 0.2f, t.u0 = 1.0f, t.l = 0.05f;
        need(lr_batch_set_turbulence_table(world_, batches_[1], &t));
        step(90);
        // Sleeping bodies, holes among the ids, pending forces.
        lr_body_force f;
        need(lr_body_force_init(&f, sizeof f));
        need(lr_body_destroy(world_, ids + 3, 5));
        need(lr_body_set_sleep(world_, ids + 20, 12, LR_SLEEP_ASLEEP));
        step(3);
        f.body = ids[10], f.force[0] = 1e-4f;
        need(lr_body_add_force(world_, &f, 1));
    }

    bool good_ = false;
    lr_world* world_ = nullptr;
    lr_asset* assets_[2] = {};
    lr_batch batches_[2] = {};
};

} // namespace test
