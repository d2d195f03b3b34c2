#include "support/allocating_scenario.h"

#include "support/lifecycle.h"
#include "support/water.h"

#include <algorithm>

namespace test {
namespace {

constexpr uint32_t leaf_count = 12, brick_count = 12, sphere_count = 20;

Asset hull_asset() {
    lr_asset* asset = nullptr;
    REQUIRE(lr_asset_load_file(LR_FIXTURES "/leaf.lrb", &asset) == LR_OK);
    return Asset(asset);
}

} // namespace

WholeScenario::Kit::Kit()
    : leaf(test::leaf()), curled(curled_leaf()), brick(test::brick()), loaded(hull_asset()), samples(grid_samples()),
      other_samples(samples), hull(tetrahedron(0.5f)), heights(36), table{1.0f, 2.0f, 3.0f, 2.0f},
      sheet(bumpy_sheet(6, 3)), bodies(leaf_count, body_desc()), heap(brick_count, body_desc()),
      spheres(sphere_count, sphere_collider(0.2f)) {
    other_samples[3] += 1.0f;
    for (size_t i = 0; i < heights.size(); ++i) heights[i] = narrow(0.05 * static_cast<double>(i * 7 % 5));
    for (size_t i = 0; i < bodies.size(); ++i) {
        bodies[i].position[0] = 0.11f * static_cast<float>(i % 7);
        bodies[i].position[1] = 0.6f + 0.05f * static_cast<float>(i);
        bodies[i].angular_velocity[i % 3] = 3.0f;
    }
    for (size_t i = 0; i < heap.size(); ++i) { // close enough to touch as they fall
        heap[i].position[0] = 4.0f + 0.062f * static_cast<float>(i % 3);
        heap[i].position[1] = 0.02f + 0.043f * static_cast<float>(i / 9);
        heap[i].position[2] = 0.033f * static_cast<float>(i / 3 % 3);
    }
    solids = {collider_desc(LR_COLLIDER_PLANE),
              sphere_collider(0.3f),
              box_collider(0.2f, 0.1f, 0.2f),
              hull_collider(hull),
              heightfield_collider(heights, 6, 0.3f),
              mesh_collider(sheet),
              mesh_collider(sheet),
              collider_desc(LR_COLLIDER_CAPSULE)};
    solids[7].size[0] = 0.1f, solids[7].size[1] = 0.3f;
    for (size_t i = 1; i < solids.size(); ++i) solids[i].position[2] = -1.5f * static_cast<float>(i);
    for (size_t i = 0; i < spheres.size(); ++i) spheres[i].position[0] = -1.0f - 0.5f * static_cast<float>(i);
    winds = one_of_each(samples);
}

WholeScenario::WholeScenario(const Kit& kit, const lr_allocator& allocator)
    : kit_(kit), allocator_(allocator), leaves_(leaf_count), bricks_(brick_count), solids_(kit.solids.size()),
      spheres_(kit.spheres.size()), rays_(8, initialised(lr_ray_init)), hits_(8), snapshot_(1u << 18) {
    add_worlds();
    add_batches(0);
    add_settings();
    add_winds();
    add_step(0, 1, 2);
    add_colliders(0);
    add_heap();
    add_rest();
    add_queries();
    add_snapshots();
    add_ends();
}

WholeScenario::~WholeScenario() {
    for (lr_world* world : world_) lr_world_destroy(world);
}

void WholeScenario::log(void* user, int32_t level, const char*) {
    if (level == LR_LOG_WARNING) ++static_cast<WholeScenario*>(user)->warnings_;
}

void WholeScenario::add_step(uint32_t which, int count, uint32_t substeps) {
    for (int i = 0; i < count; ++i) {
        add("lr_world_step", [=, this] { return lr_world_step(world_[which], 0.01f, substeps); });
        calls_.back().steps = true;
    }
}

void WholeScenario::add_worlds() {
    for (uint32_t which : {0u, 1u}) {
        add("lr_world_create", [=, this] {
            lr_world_desc d = world_desc();
            d.allocator = allocator_;
            d.seed = 5;
            d.log = &log;
            d.log_user = this;
            return lr_world_create(&d, &world_[which]);
        });
        calls_.back().creates = true;
    }
}

// More batches than the world's first table holds.
void WholeScenario::add_batches(uint32_t which) {
    for (size_t i = 0; i < batches; ++i)
        add("lr_batch_create", [=, this] {
            const Asset* const assets[] = {&kit_.leaf, &kit_.curled, &kit_.brick, &kit_.loaded, &kit_.leaf};
            lr_batch_desc d = batch_desc();
            d.asset = assets[std::min<size_t>(i, 4)]->get();
            d.capacity = i < 4 ? 32 : 5;
            d.load_model = i == 1 ? LR_LOADS_LANGEVIN : LR_LOADS_DEFAULT;
            return lr_batch_create(world_[which], &d, &batch_[which][i]);
        });
}

void WholeScenario::add_settings() {
    add("lr_body_create",
        [this] { return lr_body_create(world_[0], batch_[0][0], kit_.bodies.data(), leaf_count, leaves_.data()); });
    for (size_t b : {1u, 3u})
        add("lr_body_create",
            [=, this] { return lr_body_create(world_[0], batch_[0][b], kit_.bodies.data(), leaf_count, nullptr); });
    add("lr_batch_set_turbulence_table", [this] {
        lr_turbulence_table t = table_desc();
        t.count = 4;
        t.chi = t.epsilon = kit_.table.data();
        t.dt = t.u0 = t.l = 1.0f;
        return lr_batch_set_turbulence_table(world_[0], batch_[0][1], &t);
    });
    add("lr_body_add_force", [this] {
        lr_body_force f = initialised(lr_body_force_init);
        f.body = leaves_[3];
        f.force[1] = 1e-3f;
        return lr_body_add_force(world_[0], &f, 1);
    });
    add("lr_batch_add_forces", [this] {
        lr_force_arrays a = initialised(lr_force_arrays_init);
        a.count = 4;
        a.mode = LR_FORCE_MODE_ACCELERATION;
        for (const float*& force : a.force) force = kit_.table.data();
        return lr_batch_add_forces(world_[0], batch_[0][1], &a);
    });
    for (size_t b : {0u, 4u})
        add("lr_batch_set_emitter", [=, this] {
            lr_emitter_desc e = emitter_desc();
            e.position[1] = 2.0f;
            e.rate = 50.0f;
            return lr_batch_set_emitter(world_[0], batch_[0][b], &e);
        });
    for (size_t b : {0u, 3u})
        add("lr_batch_set_rules", [=, this] {
            lr_batch_rules r = rules_desc();
            r.max_age = b == 0 ? 0.3f : 10.0f;
            r.action = b == 0 ? LR_END_RESPAWN : LR_END_DESTROY;
            return lr_batch_set_rules(world_[0], batch_[0][b], &r);
        });
    add("lr_batch_spawn", [this] { return lr_batch_spawn(world_[0], batch_[0][4], 3, nullptr); });
    add("lr_batch_spawn_box", [this] {
        const float low[3] = {-1.0f, 1.0f, -1.0f}, high[3] = {1.0f, 2.0f, 1.0f};
        return lr_batch_spawn_box(world_[0], batch_[0][1], low, high, 2, nullptr);
    });
    add("lr_batch_set_rate", [this] { return lr_batch_set_rate(world_[0], batch_[0][3], 3); });
    add("lr_world_set_budget", [this] { return lr_world_set_budget(world_[0], 1000); });
    add("lr_batch_set_force", [this] {
        lr_batch_force f = initialised(lr_batch_force_init);
        f.acceleration[0] = 0.5f;
        return lr_batch_set_force(world_[0], batch_[0][1], &f);
    });
    add("lr_world_set_water", [this] {
        lr_water_desc s = sea();
        s.position[1] = -0.5f;
        return lr_world_set_water(world_[0], &s);
    });
}

void WholeScenario::add_winds() {
    add("lr_world_set_uniform_wind", [this] { return lr_world_set_uniform_wind(world_[0], 1.0f, 0.0f, 0.0f); });
    for (size_t i = 0; i < kit_.winds.size(); ++i)
        add("lr_world_add_...", [=, this] { return add_wind(world_[0], &kit_.winds[i], &wind_[0][i]); });
    for (int way = 0; way < 3; ++way)
        add("lr_world_update_wind_grid", [=, this] {
            auto d = std::get<lr_wind_grid_desc>(kit_.winds[6]);
            if (way < 2) d.samples = way == 0 ? kit_.other_samples.data() : nullptr;
            return lr_world_update_wind_grid(world_[0], wind_[0][6], &d);
        });
    add("lr_world_update_turbulence", [this] {
        auto d = std::get<lr_turbulence_desc>(kit_.winds[5]);
        d.octaves = 4;
        return lr_world_update_turbulence(world_[0], wind_[0][5], &d);
    });
    add("lr_world_remove_wind", [this] { return lr_world_remove_wind(world_[0], wind_[0][4]); });
    add("lr_world_sample_wind", [this] {
        float at[3] = {}, velocity[3];
        return lr_world_sample_wind(world_[0], at, 1, velocity);
    });
}

void WholeScenario::add_colliders(uint32_t which) {
    add("lr_world_set_events", [=, this] { return lr_world_set_events(world_[which], 64, LR_EVENTS_ALL); });
    add("lr_collider_create, of each kind", [=, this] {
        return lr_collider_create(world_[which], kit_.solids.data(), static_cast<uint32_t>(kit_.solids.size()),
                                  solids_.data());
    });
    add("lr_batch_create, with colliders and events", [=, this] {
        lr_batch_desc d = batch_desc();
        d.asset = kit_.loaded.get();
        d.capacity = 9;
        lr_batch batch{};
        const lr_status status = lr_batch_create(world_[which], &d, &batch);
        return status == LR_OK ? lr_batch_destroy(world_[which], batch) : status;
    });
    if (which != 0) return;
    add_step(0, 1, 1);
    add("lr_collider_create, many",
        [this] { return lr_collider_create(world_[0], kit_.spheres.data(), sphere_count, spheres_.data()); });
    add("lr_collider_move", [this] {
        motions_.clear();
        for (lr_collider c : spheres_) {
            motions_.push_back(motion_of(c, LR_MOVE_VELOCITY));
            motions_.back().linear_velocity[0] = 0.1f;
        }
        motions_.push_back(motion_of(solids_[5], LR_MOVE_TO));
        motions_.back().position[2] = -7.0f;
        return lr_collider_move(world_[0], motions_.data(), static_cast<uint32_t>(motions_.size()));
    });
    motions_.reserve(spheres_.size() + 1);
    add_step(0, 2, 1);
    add("lr_collider_destroy", [this] { return lr_collider_destroy(world_[0], spheres_.data(), 9); });
    add("lr_collider_create, again", [this] {
        lr_collider_desc d = kit_.solids[3];
        d.position[1] = 3.0f;
        return lr_collider_create(world_[0], &d, 1, spheres_.data());
    });
    add("lr_world_set_events, more", [this] { return lr_world_set_events(world_[0], 256, LR_EVENTS_ALL); });
}

void WholeScenario::add_heap() {
    for (size_t b : {2u, 0u})
        add("lr_batch_set_body_contact",
            [=, this] { return lr_batch_set_body_contact(world_[0], batch_[0][2], batch_[0][b], 1); });
    add("lr_body_create, a heap",
        [this] { return lr_body_create(world_[0], batch_[0][2], kit_.heap.data(), brick_count, bricks_.data()); });
    add_step(0, 3, 2);
    add("lr_body_destroy, of those that meet", [this] { return lr_body_destroy(world_[0], bricks_.data(), 8); });
    add("lr_body_create, more",
        [this] { return lr_body_create(world_[0], batch_[0][2], kit_.heap.data(), 8, nullptr); });
    add_step(0, 2, 1);
}

void WholeScenario::add_rest() {
    add("lr_body_set_sleep", [this] { return lr_body_set_sleep(world_[0], leaves_.data(), 10, LR_SLEEP_ASLEEP); });
    add("lr_body_destroy, one at rest", [this] { return lr_body_destroy(world_[0], leaves_.data(), 2); });
    add_step(0, 3, 2);
    add("lr_world_wake_box", [this] {
        const float low[3] = {-1.0f, -1.0f, -1.0f}, high[3] = {0.3f, 5.0f, 1.0f};
        return lr_world_wake_box(world_[0], low, high, nullptr);
    });
}

void WholeScenario::add_queries() {
    add("lr_world_ray_cast", [this] {
        for (size_t i = 0; i < rays_.size(); ++i) rays_[i].origin[0] = static_cast<float>(i), rays_[i].origin[1] = 9.0f;
        return lr_world_ray_cast(world_[0], rays_.data(), static_cast<uint32_t>(rays_.size()), hits_.data());
    });
    add("lr_world_overlap", [this] {
        const lr_overlap_desc d = initialised(lr_overlap_desc_init);
        lr_body bodies[256];
        uint32_t count = 0;
        return lr_world_overlap(world_[0], &d, bodies, 256, &count);
    });
    add("lr_batch_write_transforms", [this] {
        float to[32 * 12];
        return lr_batch_write_transforms(world_[0], batch_[0][0], LR_TRANSFORM_3X4_ROW_MAJOR, to, 0, 32, nullptr);
    });
}

void WholeScenario::add_snapshots() {
    add("lr_world_snapshot_save",
        [this] { return lr_world_snapshot_save(world_[0], snapshot_.data(), snapshot_.size(), &saved_); });
    add("lr_batch_set_turbulence_table, the asset's",
        [this] { return lr_batch_set_turbulence_table(world_[0], batch_[0][1], nullptr); });
    add_step(0, 1, 1);
    add("lr_world_snapshot_restore", [this] { return lr_world_snapshot_restore(world_[0], snapshot_.data(), saved_); });
    add_step(0, 1, 1);
    // Another world, without reserved memory except for its hash.
    add_batches(1);
    add("lr_world_add_wind_grid", [this] { return add_wind(world_[1], &kit_.winds[6], &wind_[1][0]); });
    add_colliders(1);
    add("lr_world_snapshot_restore, another world's",
        [this] { return lr_world_snapshot_restore(world_[1], snapshot_.data(), saved_); });
    add_step(1, 2, 1);
}

void WholeScenario::add_ends() {
    add("lr_batch_destroy", [this] { return lr_batch_destroy(world_[0], batch_[0][2]); });
    add("lr_batch_create, in its place", [this] {
        lr_batch_desc d = batch_desc();
        d.asset = kit_.brick.get();
        d.capacity = 30;
        return lr_batch_create(world_[0], &d, &batch_[0][2]);
    });
    add_step(0, 1, 1);
}

} // namespace test
