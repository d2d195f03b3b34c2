// The cost of sleeping bodies: a million leaves in one batch, all asleep or all but a few; steps at 60 Hz x 4 on one thread.
// And the cost of putting bodies to sleep and waking them, singly and by boxes.
//     bench_rest
#include "bench/leaf_asset.h"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <vector>

namespace {

constexpr uint32_t bodies = 1000000;

struct Floor {
    lr_asset* asset = nullptr;
    lr_world* world = nullptr;
    lr_batch batch{};
    std::vector<lr_body> ids;

    bool make(bool rules) {
        lr_world_desc wd;
        lr_world_desc_init(&wd, sizeof wd);
        asset = bench::leaf_asset();
        if (!asset || lr_world_create(&wd, &world) != LR_OK) return false;
        lr_batch_desc bd;
        lr_batch_desc_init(&bd, sizeof bd);
        bd.asset = asset;
        bd.capacity = bodies;
        lr_emitter_desc e;
        lr_emitter_desc_init(&e, sizeof e);
        e.shape = LR_EMIT_BOX;
        e.size[0] = e.size[2] = 50.0f;
        lr_batch_rules r;
        lr_batch_rules_init(&r, sizeof r);
        r.max_age = 1e6f;
        ids.resize(bodies);
        return lr_batch_create(world, &bd, &batch) == LR_OK && lr_batch_set_emitter(world, batch, &e) == LR_OK &&
               lr_batch_spawn(world, batch, bodies, ids.data()) == LR_OK &&
               lr_batch_set_rules(world, batch, rules ? &r : nullptr) == LR_OK;
    }
    bool rest(uint32_t count) { return lr_body_set_sleep(world, ids.data(), count, LR_SLEEP_ASLEEP) == LR_OK; }
    ~Floor() {
        lr_world_destroy(world);
        lr_asset_release(asset);
    }
};

void step(benchmark::State& state, bool rules) {
    Floor floor;
    if (!floor.make(rules) || !floor.rest(static_cast<uint32_t>(state.range(0))))
        return state.SkipWithError("no world");
    for (int i = 0; i < 20; ++i) lr_world_step(floor.world, 1.0f / 60.0f, 4); // at least one check of the rules
    for (auto _ : state) lr_world_step(floor.world, 1.0f / 60.0f, 4);
}

void rest_and_wake(benchmark::State& state) {
    Floor floor;
    if (!floor.make(false)) return state.SkipWithError("no world");
    for (auto _ : state) {
        floor.rest(bodies);
        lr_body_set_sleep(floor.world, floor.ids.data(), bodies, LR_SLEEP_AWAKE);
    }
    state.counters["ns/body"] = benchmark::Counter(static_cast<double>(state.iterations()) * bodies * 1e-9,
                                                   benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

// A footstep of 30 cm: about 36 leaves.
void wake_box(benchmark::State& state) {
    Floor floor;
    if (!floor.make(false) || !floor.rest(bodies)) return state.SkipWithError("no world");
    uint32_t at = 0;
    uint64_t woken = 0;
    for (auto _ : state) {
        at = at * 1664525u + 1013904223u;
        const float x = static_cast<float>(at >> 24) * 0.38f - 48.0f,
                    z = static_cast<float>(at >> 16 & 255u) * 0.38f - 48.0f;
        const float low[3] = {x, -0.1f, z}, high[3] = {x + 0.3f, 0.1f, z + 0.3f};
        uint32_t here = 0;
        lr_world_wake_box(floor.world, low, high, &here);
        woken += here;
    }
    state.counters["bodies"] = static_cast<double>(woken) / static_cast<double>(state.iterations());
}

} // namespace

BENCHMARK_CAPTURE(step, plain, false)->Arg(0)->Arg(bodies - 1000)->Arg(bodies)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(step, rules, true)->Arg(bodies)->Unit(benchmark::kMicrosecond);
BENCHMARK(rest_and_wake)->Unit(benchmark::kMillisecond);
BENCHMARK(wake_box)->Unit(benchmark::kMicrosecond)->Iterations(5000);

BENCHMARK_MAIN();
