// Scenes with everything that a world can do, written once, for tests of determinism and for the held hashes.
#pragma once

#include "support/random.h"
#include "support/scene.h"
#include "support/water.h"

#include <algorithm>
#include <string>

namespace test {

struct PlayedScene {
    const char* name;
    int32_t loads = LR_LOADS_LANGEVIN;
    int32_t clock = LR_CLOCK_SPEED;
    int32_t table_end = LR_TABLE_CLAMP;
    int32_t integrator = LR_INTEGRATOR_DEFAULT;
    int32_t tensor = LR_TENSOR_AUTO;
    bool windy = false;
    bool born_and_dying = false;
    bool forced = false;   // forces on bodies and on batches
    bool afloat = false;   // a sea, its surface amid the bodies
    bool governed = false; // rules that destroy in one batch and respawn in the other, and emitters
    uint32_t bodies = 300; // in each of two batches: one diagonal, one with its weight off centre
};

inline std::vector<PlayedScene> played_scenes() {
    std::vector<PlayedScene> all;
    const auto add = [&](const char* name) -> PlayedScene& {
        all.push_back({name});
        return all.back();
    };
    add("speed");
    add("speed_rk4").integrator = LR_INTEGRATOR_RK4;
    add("speed_full").tensor = LR_TENSOR_FULL;
    add("age").clock = LR_CLOCK_AGE;
    PlayedScene& loop = add("age_loop_rk4");
    loop.clock = LR_CLOCK_AGE, loop.table_end = LR_TABLE_LOOP, loop.integrator = LR_INTEGRATOR_RK4;
    add("kirchhoff").loads = LR_LOADS_NONE;
    PlayedScene& kirchhoff = add("kirchhoff_rk4");
    kirchhoff.loads = LR_LOADS_NONE, kirchhoff.integrator = LR_INTEGRATOR_RK4;
    add("aerodynamic").loads = LR_LOADS_AERODYNAMIC;
    PlayedScene& rk4 = add("aerodynamic_rk4");
    rk4.loads = LR_LOADS_AERODYNAMIC, rk4.integrator = LR_INTEGRATOR_RK4;
    PlayedScene& full = add("aerodynamic_full");
    full.loads = LR_LOADS_AERODYNAMIC, full.tensor = LR_TENSOR_FULL;
    PlayedScene& by_age = add("aerodynamic_age");
    by_age.loads = LR_LOADS_AERODYNAMIC, by_age.clock = LR_CLOCK_AGE;
    PlayedScene& leaves = add("aerodynamic_storm");
    leaves.loads = LR_LOADS_AERODYNAMIC, leaves.windy = leaves.born_and_dying = true, leaves.bodies = 2500;
    add("wind").windy = true;
    add("births_and_deaths").born_and_dying = true;
    PlayedScene& sea_of_leaves = add("sea");
    sea_of_leaves.loads = LR_LOADS_AERODYNAMIC, sea_of_leaves.afloat = true;
    PlayedScene& sea_full = add("sea_full");
    sea_full.afloat = true, sea_full.tensor = LR_TENSOR_FULL;
    PlayedScene& sea_rk4 = add("sea_rk4");
    sea_rk4.afloat = true, sea_rk4.integrator = LR_INTEGRATOR_RK4;
    PlayedScene& sea_storm = add("sea_storm");
    sea_storm.loads = LR_LOADS_AERODYNAMIC;
    sea_storm.afloat = sea_storm.windy = sea_storm.born_and_dying = sea_storm.forced = sea_storm.governed = true;
    sea_storm.bodies = 2500;
    add("forces").forced = true;
    PlayedScene& forces_rk4 = add("forces_rk4");
    forces_rk4.forced = true, forces_rk4.integrator = LR_INTEGRATOR_RK4;
    add("rules").governed = true;
    PlayedScene& governed = add("storm_with_rules");
    governed.forced = governed.governed = governed.windy = governed.born_and_dying = true;
    governed.bodies = 2500;
    PlayedScene& all_at_once = add("storm");
    all_at_once.windy = all_at_once.born_and_dying = true;
    all_at_once.bodies = 2500; // more than a chunk of work
    return all;
}

// What must not change the outcome.
struct Circumstances {
    int32_t simd = LR_SIMD_AUTO;
    uint32_t workers = 0;
    bool permuted = false;         // bodies lie in another order
    bool through_snapshot = false; // half-way into a new world
    lr_job_system jobs{};
};

class Play {
public:
    static constexpr int frames = 30;

    Play(const PlayedScene& scene, const Circumstances& how) : scene_(scene), how_(how) {
        assets_[0] = leaf();
        assets_[1] = curled_leaf();
        build();
        if (scene_.afloat) set_water(world, sea()); // not anew after a snapshot: that brings it back
        for (size_t b = 0; b < 2; ++b) {
            populate(b);
            if (scene_.forced) push_batch(b);
            if (scene_.governed) govern(b);
        }
    }

    uint64_t run() {
        for (int frame = 0; frame < frames; ++frame) {
            if (scene_.forced && frame % 3 != 1) push();
            if (frame == frames / 2 && how_.through_snapshot) {
                const std::vector<unsigned char> snapshot = snapshot_of(world);
                build();
                REQUIRE(lr_world_snapshot_restore(world.get(), snapshot.data(), snapshot.size()) == LR_OK);
            }
            if (scene_.windy && frame % 10 == 5) set_wind(world, 0.1f * static_cast<float>(frame), 0.0f, 1.0f);
            if (scene_.born_and_dying) turn_over();
            // Neither a power of two nor an even division: every rounding is there.
            steps(world, 1, 1.0f / 60.0f, 3);
        }
        return hash_of(world);
    }

    World world;
    lr_batch batches[2] = {};

private:
    void build() {
        lr_world_desc wd = world_desc();
        wd.seed = 0x1234567890abcdefull;
        wd.simd_target = how_.simd;
        wd.worker_count = how_.workers;
        wd.jobs = how_.jobs;
        world = make(wd);
        for (size_t b = 0; b < 2; ++b) {
            lr_batch_desc bd = batch_desc();
            bd.load_model = scene_.loads;
            bd.clock = scene_.clock;
            bd.table_end = scene_.table_end;
            bd.integrator = scene_.integrator;
            bd.tensor = scene_.tensor;
            batches[b] = add_batch(world, bd, assets_[b], scene_.bodies + 40);
        }
    }

    // The same body for the same key, wherever and whenever it is made.
    static lr_body_desc body(uint32_t key) {
        Random random(key);
        lr_body_desc d = body_desc();
        d.key = key;
        for (float& x : d.position) x = random.real(-5.0, 5.0);
        for (float& q : d.orientation) q = random.real(-1.0, 1.0);
        for (float& v : d.linear_velocity) v = random.real(-0.5, 0.5);
        for (float& w : d.angular_velocity) w = random.real(-5.0, 5.0);
        d.scale = random.real(0.5, 2.0);
        d.age = random.real(0.0, 0.5);
        return d;
    }

    void populate(size_t b) {
        std::vector<lr_body_desc> descs;
        const uint32_t first = b == 0 ? 1 : 100001;
        for (uint32_t i = 0; i < scene_.bodies; ++i) descs.push_back(body(first + i));
        if (how_.permuted) {
            // Others live and die first, so that slots and generations are no longer in order either.
            std::vector<lr_body> ghosts(30);
            const std::vector<lr_body_desc> ghost(30, body(999));
            REQUIRE(lr_body_create(world.get(), batches[b], ghost.data(), 30, ghosts.data()) == LR_OK);
            std::reverse(descs.begin(), descs.end());
            for (size_t i = 0; i + 7 < descs.size(); i += 5) std::swap(descs[i], descs[i + 7]);
            const size_t half = descs.size() / 2;
            REQUIRE(lr_body_create(world.get(), batches[b], descs.data(), static_cast<uint32_t>(half), nullptr) ==
                    LR_OK);
            REQUIRE(lr_body_destroy(world.get(), ghosts.data(), 30) == LR_OK);
            REQUIRE(lr_body_create(world.get(), batches[b], descs.data() + half,
                                   static_cast<uint32_t>(descs.size() - half), nullptr) == LR_OK);
        } else {
            REQUIRE(lr_body_create(world.get(), batches[b], descs.data(), static_cast<uint32_t>(descs.size()),
                                   nullptr) == LR_OK);
        }
        next_key_[b] = first + scene_.bodies;
    }

    // Not made anew with the world after a snapshot: that must bring them back.
    void push_batch(size_t b) {
        lr_batch_force f = initialised(lr_batch_force_init);
        f.force[0] = f.body_torque[1] = 1e-6f;
        f.acceleration[2] = f.body_acceleration[0] = b == 0 ? 0.5f : -0.25f;
        f.angular_acceleration[1] = 1.0f;
        REQUIRE(lr_batch_set_force(world.get(), batches[b], &f) == LR_OK);
    }
    void govern(size_t b) {
        lr_emitter_desc e = initialised(lr_emitter_desc_init);
        e.shape = b == 0 ? LR_EMIT_SPHERE : LR_EMIT_BOX_SURFACE;
        for (float& s : e.size) s = 4.0f;
        e.spread = 1.0f;
        e.speed_max = 2.0f;
        e.spin_max = 10.0f;
        e.scale_min = 0.5f;
        e.rate = 37.0f;
        e.burst_count = 5;
        e.burst_interval = 0.13f;
        REQUIRE(lr_batch_set_emitter(world.get(), batches[b], &e) == LR_OK);
        lr_batch_rules r = initialised(lr_batch_rules_init);
        r.action = b == 0 ? LR_END_DESTROY : LR_END_RESPAWN;
        r.max_age = 0.8f;
        r.volume_count = 2;
        r.volumes[0] = {LR_VOLUME_BOX, LR_KILL_OUTSIDE, {0.0f, 0.0f, 0.0f}, {4.9f, 4.9f, 4.9f}};
        r.volumes[1] = {LR_VOLUME_SPHERE, LR_KILL_INSIDE, {1.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}};
        REQUIRE(lr_batch_set_rules(world.get(), batches[b], &r) == LR_OK);
    }

    // What pushes a body depends on its key and place, not on its index.
    void push() {
        for (size_t b = 0; b < 2; ++b) {
            const lr_batch_view v = view_of(world, batches[b]);
            std::vector<float> lift(v.count), still(v.count, 0.0f);
            std::vector<lr_body_force> single;
            for (uint32_t i = 0; i < v.count; ++i) {
                lift[i] = 1e-6f * static_cast<float>(v.key[i] % 10);
                if (v.key[i] % 7 != 0) continue;
                lr_body_force f = initialised(lr_body_force_init);
                f.body = v.ids[i];
                f.mode = v.key[i] % 2 == 0 ? LR_FORCE_MODE_FORCE : LR_FORCE_MODE_IMPULSE;
                f.frame = v.key[i] % 3 == 0 ? LR_FRAME_BODY : LR_FRAME_WORLD;
                f.flags = LR_FORCE_AT_POINT;
                for (size_t k = 0; k < 3; ++k)
                    f.point[k] = (f.frame == LR_FRAME_WORLD ? v.position[k][i] : 0.0f) + 0.01f;
                f.force[1] = 1e-6f;
                single.push_back(f);
            }
            lr_force_arrays a = initialised(lr_force_arrays_init);
            a.count = v.count;
            a.frame = LR_FRAME_BODY;
            a.force[0] = a.force[2] = still.data();
            a.force[1] = lift.data();
            REQUIRE(lr_batch_add_forces(world.get(), batches[b], &a) == LR_OK);
            REQUIRE(lr_body_add_force(world.get(), single.data(), static_cast<uint32_t>(single.size())) == LR_OK);
        }
    }

    // Bodies with certain keys die, new ones are born: by key, not by place.
    void turn_over() {
        for (size_t b = 0; b < 2; ++b) {
            const lr_batch_view v = view_of(world, batches[b]);
            std::vector<std::pair<uint32_t, lr_body>> living;
            for (uint32_t i = 0; i < v.count; ++i) living.emplace_back(v.key[i], v.ids[i]);
            std::sort(living.begin(), living.end());
            std::vector<lr_body> dying;
            for (size_t i = 3; i < living.size() && dying.size() < 10; i += 17) dying.push_back(living[i].second);
            REQUIRE(lr_body_destroy(world.get(), dying.data(), static_cast<uint32_t>(dying.size())) == LR_OK);
            for (size_t i = 0; i < dying.size(); ++i) add_body(world, batches[b], body(next_key_[b]++));
        }
    }

    PlayedScene scene_;
    Circumstances how_;
    Asset assets_[2];
    uint32_t next_key_[2] = {};
};

inline uint64_t outcome(const PlayedScene& scene, const Circumstances& how = {}) {
    return Play(scene, how).run();
}

} // namespace test
