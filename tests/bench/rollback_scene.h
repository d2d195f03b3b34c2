// Worlds as rollback netcode saves and restores them: leaves in wind over a plane, some asleep, with rules and an emitter; and a plain
// world. Uses only + - x /, so that hashes are the same everywhere.
#pragma once

#include "bench/leaf_asset.h"

#include <cstdint>
#include <vector>

namespace bench {

struct RollbackKind {
    const char* name;
    bool everything;     // wind sources, plane, rules, emitter
    uint32_t rest_of_10; // tenths of the bodies put to sleep before the measurement
};
constexpr RollbackKind rollback_kinds[] = {
    {"plain", false, 0}, {"falling", true, 0}, {"storm", true, 3}, {"rest", true, 9}};

class RollbackScene {
public:
    static constexpr float dt = 0.016f;
    static constexpr uint32_t substeps = 2;

    RollbackScene() = default;
    RollbackScene(const RollbackScene&) = delete;
    RollbackScene& operator=(const RollbackScene&) = delete;
    ~RollbackScene() {
        lr_world_destroy(world_);
        lr_asset_release(asset_);
    }

    bool make(const RollbackKind& kind, uint32_t bodies) {
        lr_world_desc wd;
        lr_world_desc_init(&wd, sizeof wd);
        lr_batch_desc bd;
        lr_batch_desc_init(&bd, sizeof bd);
        asset_ = leaf_asset();
        bd.asset = asset_, bd.capacity = bodies;
        lr_emitter_desc e;
        lr_emitter_desc_init(&e, sizeof e);
        e.shape = LR_EMIT_BOX;
        e.position[1] = 8.0f;
        e.size[0] = e.size[2] = 15.0f, e.size[1] = 7.0f;
        std::vector<lr_body> ids(bodies);
        if (!asset_ || lr_world_create(&wd, &world_) != LR_OK || lr_batch_create(world_, &bd, &batch_) != LR_OK ||
            lr_batch_set_emitter(world_, batch_, &e) != LR_OK ||
            lr_batch_spawn(world_, batch_, bodies, ids.data()) != LR_OK)
            return false;
        if (lr_world_set_uniform_wind(world_, 1.0f, 0.0f, 0.0f) != LR_OK) return false;
        if (!kind.everything) return lr_batch_set_emitter(world_, batch_, nullptr) == LR_OK && step(60);
        e.rate = 60.0f;
        lr_batch_rules r;
        lr_batch_rules_init(&r, sizeof r);
        r.max_age = 60.0f;
        r.action = LR_END_RESPAWN;
        lr_collider_desc ground;
        lr_collider_desc_init(&ground, sizeof ground);
        ground.kind = LR_COLLIDER_PLANE;
        if (lr_batch_set_emitter(world_, batch_, &e) != LR_OK || lr_batch_set_rules(world_, batch_, &r) != LR_OK ||
            lr_collider_create(world_, &ground, 1, nullptr) != LR_OK || !add_wind() || !step(60))
            return false;
        const uint32_t rest = bodies / 10 * kind.rest_of_10;
        return lr_body_set_sleep(world_, ids.data(), rest, LR_SLEEP_ASLEEP) == LR_OK && step(20);
    }
    bool step(int count = 1) {
        bool good = true;
        for (int i = 0; i < count; ++i) good = good && lr_world_step(world_, dt, substeps) == LR_OK;
        return good;
    }
    uint64_t hash() const {
        uint64_t h = 0;
        lr_world_hash(world_, &h);
        return h;
    }
    uint32_t awake() const {
        lr_world_info info;
        lr_world_info_init(&info, sizeof info);
        return lr_world_get_info(world_, &info) == LR_OK ? static_cast<uint32_t>(info.awake_count) : 0;
    }
    lr_world* world() const { return world_; }

private:
    bool add_wind() {
        lr_gusts_desc gusts;
        lr_gusts_desc_init(&gusts, sizeof gusts);
        gusts.rms = 0.5f, gusts.integral_time = 3.0f, gusts.angle_rms = 0.5f;
        lr_turbulence_desc turbulence;
        lr_turbulence_desc_init(&turbulence, sizeof turbulence);
        turbulence.rms = 0.5f, turbulence.integral_length = 4.0f, turbulence.eddy_life = 3.0f;
        return lr_world_add_gusts(world_, &gusts, nullptr) == LR_OK &&
               lr_world_add_turbulence(world_, &turbulence, nullptr) == LR_OK;
    }

    lr_asset* asset_ = nullptr;
    lr_world* world_ = nullptr;
    lr_batch batch_{};
};

} // namespace bench
