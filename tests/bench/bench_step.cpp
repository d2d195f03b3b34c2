// The cost of forces, rules and emitters in a step of a million bodies on one core: milliseconds are ns per body.
//     bench_step --benchmark_repetitions=3
#include "langevin_rigid.h"

#include <benchmark/benchmark.h>

#include <vector>

namespace {

constexpr uint32_t bodies = 1000000;

enum Extra : int64_t { plain, batch_force, body_forces, one_volume, eight_volumes, respawning };

struct Scene {
    lr_asset* asset = nullptr;
    lr_world* world = nullptr;
    lr_batch batch{};
    std::vector<float> lift = std::vector<float>(bodies, 1e-5f);

    bool make(int64_t extra) {
        lr_ellipsoid_desc shape;
        lr_ellipsoid_desc_init(&shape, sizeof shape);
        shape.semi_axes[0] = 0.04, shape.semi_axes[1] = 0.01, shape.semi_axes[2] = 0.00005;
        shape.density = 800.0;
        lr_world_desc wd;
        lr_world_desc_init(&wd, sizeof wd);
        lr_batch_desc bd;
        lr_batch_desc_init(&bd, sizeof bd);
        if (lr_asset_create_ellipsoid(&shape, &asset) != LR_OK || lr_world_create(&wd, &world) != LR_OK) return false;
        bd.asset = asset;
        bd.capacity = bodies;
        if (lr_batch_create(world, &bd, &batch) != LR_OK) return false;
        lr_emitter_desc e;
        lr_emitter_desc_init(&e, sizeof e);
        e.shape = LR_EMIT_BOX;
        e.size[0] = e.size[1] = e.size[2] = 50.0f;
        if (lr_batch_set_emitter(world, batch, &e) != LR_OK || lr_batch_spawn(world, batch, bodies, nullptr) != LR_OK)
            return false;
        lr_batch_force f;
        lr_batch_force_init(&f, sizeof f);
        f.force[1] = 1e-5f;
        if (extra == batch_force && lr_batch_set_force(world, batch, &f) != LR_OK) return false;
        if (extra < one_volume) return true;
        lr_batch_rules r;
        lr_batch_rules_init(&r, sizeof r);
        r.volume_count = extra == eight_volumes ? 8 : 1;
        for (lr_kill_volume& v : r.volumes) v = {LR_VOLUME_SPHERE, LR_KILL_OUTSIDE, {0, 0, 0}, {1e4f, 0, 0}};
        r.action = LR_END_RESPAWN;
        // Respawning: a hundredth of the bodies at each step, through the bottom of the box.
        if (extra == respawning) r.volumes[0] = {LR_VOLUME_BOX, LR_KILL_OUTSIDE, {0, 0, 0}, {50.0f, 49.0f, 50.0f}};
        return lr_batch_set_rules(world, batch, &r) == LR_OK;
    }
    ~Scene() {
        lr_world_destroy(world);
        lr_asset_release(asset);
    }
};

void step(benchmark::State& state) {
    Scene s;
    if (!s.make(state.range(0))) return state.SkipWithError("scene");
    lr_force_arrays a;
    lr_force_arrays_init(&a, sizeof a);
    a.count = bodies;
    for (const float*& p : a.force) p = s.lift.data();
    for (auto _ : state) {
        if (state.range(0) == body_forces && lr_batch_add_forces(s.world, s.batch, &a) != LR_OK)
            return state.SkipWithError("forces");
        if (lr_world_step(s.world, 1.0f / 60.0f, 1) != LR_OK) return state.SkipWithError("step");
    }
    lr_batch_counts e;
    lr_batch_counts_init(&e, sizeof e);
    lr_batch_get_counts(s.world, s.batch, &e);
    state.counters["respawned"] = static_cast<double>(e.respawned);
}
BENCHMARK(step)->DenseRange(plain, respawning)->Unit(benchmark::kMillisecond)->MinTime(1.0);

} // namespace

BENCHMARK_MAIN();
