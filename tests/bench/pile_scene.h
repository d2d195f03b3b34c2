// A batch of leaves that fall on level ground within a second and lie there some layers deep, a walker who crosses them, and a wind
// over the ground.
#pragma once

#include "bench/leaf_asset.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace bench {

constexpr float step_seconds = 1.0f / 60.0f;
constexpr uint32_t substeps = 2;

class PileScene {
public:
    PileScene() = default;
    PileScene(const PileScene&) = delete;
    PileScene& operator=(const PileScene&) = delete;
    ~PileScene() {
        lr_world_destroy(world_);
        lr_asset_release(asset_);
    }

    // file: assets/leaf.obj as baked; null: the ellipsoid of the other benchmarks. pairs: body contact between leaves.
    bool make(const char* file, uint32_t count, float layers, uint32_t workers, bool pairs) {
        if (file) {
            if (lr_asset_load_file(file, &asset_) != LR_OK) return false;
        } else {
            asset_ = leaf_asset();
        }
        lr_asset_info info;
        lr_asset_info_init(&info, sizeof info);
        if (!asset_ || lr_asset_get_info(asset_, &info) != LR_OK) return false;
        // The area of a leaf that lies flat, over the square of its length.
        const double covers = file ? 0.35 : 0.196;
        half_side_ = 0.5f * static_cast<float>(info.length_d * std::sqrt(covers * count / static_cast<double>(layers)));
        lr_world_desc wd;
        lr_world_desc_init(&wd, sizeof wd);
        wd.worker_count = workers;
        if (lr_world_create(&wd, &world_) != LR_OK) return false;
        lr_batch_desc bd;
        lr_batch_desc_init(&bd, sizeof bd);
        bd.asset = asset_;
        bd.capacity = count;
        bd.load_model = LR_LOADS_AERODYNAMIC;
        if (lr_batch_create(world_, &bd, &batch_) != LR_OK) return false;
        lr_collider_desc ground = collider(LR_COLLIDER_PLANE, 0.0f, 0.0f);
        lr_ground_wind_desc slow;
        lr_ground_wind_desc_init(&slow, sizeof slow);
        slow.position[1] = -0.05f;
        slow.roughness_length = 0.01f;
        return lr_collider_create(world_, &ground, 1, nullptr) == LR_OK &&
               lr_world_add_ground_wind(world_, &slow, nullptr) == LR_OK &&
               (!pairs || lr_batch_set_body_contact(world_, batch_, batch_, 1) == LR_OK) && emit(count);
    }

    void step() { lr_world_step(world_, step_seconds, substeps); }

    bool add_walker() {
        lr_collider_desc d = collider(LR_COLLIDER_CAPSULE, -walk_from(), walker_y);
        d.size[0] = 0.24f, d.size[1] = 0.62f;
        return lr_collider_create(world_, &d, 1, &walker_) == LR_OK;
    }
    // At 1.4 m/s, from one side of the leaves to the other.
    int walk_steps() const { return static_cast<int>(2.0f * walk_from() / (1.4f * step_seconds)); }
    void move_walker(int step) {
        lr_collider_motion m;
        lr_collider_motion_init(&m, sizeof m);
        m.collider = walker_;
        m.position[0] = -walk_from() + 1.4f * step_seconds * static_cast<float>(step + 1);
        m.position[1] = walker_y;
        lr_collider_move(world_, &m, 1);
    }
    // m/s, 10 m above the ground.
    void blow(float speed) { lr_world_set_uniform_wind(world_, speed, 0.0f, 0.0f); }

    struct Seen {
        uint32_t awake;
        double speed, height; // means over all bodies; m/s, m
    };
    Seen look() const {
        lr_batch_view v;
        lr_batch_view_init(&v, sizeof v);
        if (lr_batch_get_view(world_, batch_, &v) != LR_OK || v.count == 0) return {0, 0.0, 0.0};
        Seen seen{v.awake_count, 0.0, 0.0};
        std::vector<float> u(size_t{6} * v.count);
        lr_batch_write_velocities(world_, batch_, u.data(), 0, v.count, nullptr);
        for (size_t i = 0; i < v.count; ++i) {
            seen.speed += static_cast<double>(std::hypot(u[6 * i], u[6 * i + 1], u[6 * i + 2]));
            seen.height += static_cast<double>(v.position[1][i]);
        }
        seen.speed /= v.count, seen.height /= v.count;
        return seen;
    }
    uint64_t hash() const {
        uint64_t h = 0;
        lr_world_hash(world_, &h);
        return h;
    }
    float side() const { return 2.0f * half_side_; }

private:
    static constexpr float walker_y = 0.87f;
    float walk_from() const { return half_side_ + 0.5f; }

    bool emit(uint32_t count) {
        lr_emitter_desc e;
        lr_emitter_desc_init(&e, sizeof e);
        e.shape = LR_EMIT_BOX;
        e.position[1] = 0.7f;
        e.size[0] = e.size[2] = half_side_;
        e.size[1] = 0.5f;
        return lr_batch_set_emitter(world_, batch_, &e) == LR_OK &&
               lr_batch_spawn(world_, batch_, count, nullptr) == LR_OK;
    }
    static lr_collider_desc collider(int32_t kind, float x, float y) {
        lr_collider_desc d;
        lr_collider_desc_init(&d, sizeof d);
        d.kind = kind;
        d.position[0] = x, d.position[1] = y;
        return d;
    }

    lr_asset* asset_ = nullptr;
    lr_world* world_ = nullptr;
    lr_batch batch_{};
    lr_collider walker_{};
    float half_side_ = 0.0f;
};

} // namespace bench
