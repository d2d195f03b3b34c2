// The savings of rates and budgets: a million leaves in 16 batches, 60 Hz x 4, one thread. `ns` is per body and step of the world,
// averaged over 48 steps, so that it includes waiting batches; `done` is the share of taken body-substeps.
//     bench_rates --benchmark_counters_tabular=true
#include "bench/leaf_asset.h"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <vector>

namespace {

constexpr uint32_t batches = 16, bodies = 65536, substeps = 4, round = 48;

struct Forest {
    lr_asset* asset = nullptr;
    lr_world* world = nullptr;
    std::vector<lr_batch> trees;

    bool make(uint32_t divisor, uint64_t budget) {
        lr_world_desc wd;
        lr_world_desc_init(&wd, sizeof wd);
        asset = bench::leaf_asset();
        if (!asset || lr_world_create(&wd, &world) != LR_OK) return false;
        for (uint32_t i = 0; i < batches; ++i) {
            lr_batch_desc bd;
            lr_batch_desc_init(&bd, sizeof bd);
            bd.asset = asset;
            bd.capacity = bodies;
            lr_batch batch{};
            lr_emitter_desc e;
            lr_emitter_desc_init(&e, sizeof e);
            e.shape = LR_EMIT_BOX;
            for (float& s : e.size) s = 20.0f;
            if (lr_batch_create(world, &bd, &batch) != LR_OK || lr_batch_set_emitter(world, batch, &e) != LR_OK ||
                lr_batch_spawn(world, batch, bodies, nullptr) != LR_OK ||
                lr_batch_set_rate(world, batch, divisor) != LR_OK)
                return false;
            trees.push_back(batch);
        }
        return lr_world_set_budget(world, budget) == LR_OK;
    }
    uint64_t taken() const {
        uint64_t sum = 0;
        for (lr_batch b : trees) {
            lr_batch_pace p;
            lr_batch_pace_init(&p, sizeof p);
            lr_batch_get_pace(world, b, &p);
            sum += p.body_substeps;
        }
        return sum;
    }
    ~Forest() {
        lr_world_destroy(world);
        lr_asset_release(asset);
    }
};

// share: the budget's share of all body-substeps; 0: no budget.
void run(benchmark::State& state, uint32_t divisor, double share) {
    Forest forest;
    if (!forest.make(divisor, static_cast<uint64_t>(share * batches * bodies * substeps)))
        return state.SkipWithError("no world");
    for (uint32_t i = 0; i < round; ++i) lr_world_step(forest.world, 1.0f / 60.0f, substeps);
    const uint64_t before = forest.taken();
    uint64_t steps = 0;
    for (auto _ : state)
        for (uint32_t i = 0; i < round; ++i, ++steps) lr_world_step(forest.world, 1.0f / 60.0f, substeps);
    const double all = static_cast<double>(steps) * batches * bodies;
    state.counters["done"] = static_cast<double>(forest.taken() - before) / (all * substeps);
    state.counters["ns"] = benchmark::Counter(all * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.counters["ms/step"] = benchmark::Counter(static_cast<double>(steps) * 1e-3,
                                                   benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

} // namespace

BENCHMARK_CAPTURE(run, own_rate, 1, 0.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(run, divisor_2, 2, 0.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(run, divisor_4, 4, 0.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(run, budget_of_half, 1, 0.5)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(run, budget_of_a_fourth, 1, 0.25)->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
