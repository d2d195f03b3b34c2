// The cost of a step with threads and without: scaling, many small batches, a single body, sleeping workers. Items are
// body-substeps; `hash` must be the same for any number of workers. Two runs of a world are comparable only after equally many
// steps:
//     bench_threads --benchmark_counters_tabular=true
#include "bench/leaf_asset.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <thread>
#include <vector>

#if defined(__linux__)
#include <sched.h>
#endif

namespace {

// Binds the caller to one core, and threads that it starts meanwhile to the others: on a busy machine, threads that are
// woken for microseconds could share a core for a whole run.
void pin(bool caller) {
#if defined(__linux__)
    static const cpu_set_t all = [] {
        cpu_set_t set;
        CPU_ZERO(&set);
        sched_getaffinity(0, sizeof set, &set);
        return set;
    }();
    if (CPU_COUNT(&all) < 2) return;
    size_t first = 0;
    while (!CPU_ISSET(first, &all)) ++first;
    cpu_set_t set = all;
    CPU_CLR(first, &set);
    if (caller) {
        CPU_ZERO(&set);
        CPU_SET(first, &set);
    }
    sched_setaffinity(0, sizeof set, &set);
#else
    static_cast<void>(caller);
#endif
}

struct Scene {
    lr_asset* asset = nullptr;
    lr_world* world = nullptr;

    bool make(uint32_t batches, uint32_t bodies, uint32_t workers, int32_t loads) {
        lr_world_desc wd;
        lr_world_desc_init(&wd, sizeof wd);
        wd.worker_count = workers;
        pin(false);
        asset = bench::leaf_asset();
        const bool made = asset && lr_world_create(&wd, &world) == LR_OK;
        pin(true);
        if (!made) return false;
        lr_batch_desc bd;
        lr_batch_desc_init(&bd, sizeof bd);
        bd.asset = asset;
        bd.capacity = bodies;
        bd.load_model = loads;
        lr_body_desc b;
        lr_body_desc_init(&b, sizeof b);
        b.linear_velocity[0] = 0.3f;
        b.angular_velocity[1] = 2.0f;
        const std::vector<lr_body_desc> spawned(bodies, b);
        for (uint32_t i = 0; i < batches; ++i) {
            lr_batch batch{};
            if (lr_batch_create(world, &bd, &batch) != LR_OK ||
                lr_body_create(world, batch, spawned.data(), bodies, nullptr) != LR_OK)
                return false;
        }
        return true;
    }
    void count(benchmark::State& state, uint64_t body_substeps) const {
        uint64_t hash = 0;
        lr_world_hash(world, &hash);
        state.counters["hash"] = static_cast<double>(hash >> 32);
        state.counters["steps"] = static_cast<double>(state.iterations());
        state.SetItemsProcessed(static_cast<int64_t>(body_substeps * static_cast<uint64_t>(state.iterations())));
    }
    ~Scene() {
        lr_world_destroy(world);
        lr_asset_release(asset);
    }
};

// bodies, workers, substeps
void scaling(benchmark::State& state) {
    const auto bodies = static_cast<uint32_t>(state.range(0)), substeps = static_cast<uint32_t>(state.range(2));
    Scene s;
    if (!s.make(1, bodies, static_cast<uint32_t>(state.range(1)), LR_LOADS_LANGEVIN))
        return state.SkipWithError("scene");
    for (auto _ : state)
        if (lr_world_step(s.world, 1.0f / 60.0f, substeps) != LR_OK) return state.SkipWithError("step");
    s.count(state, uint64_t{bodies} * substeps);
}
BENCHMARK(scaling)
    ->ArgsProduct({{1000, 2000, 4000, 10000, 100000, 1000000}, {0, 1}, {1, 4}})
    ->ArgNames({"bodies", "workers", "substeps"})
    ->UseRealTime();

// batches of this many bodies, workers
void batches(benchmark::State& state) {
    const auto number = static_cast<uint32_t>(state.range(0)), bodies = static_cast<uint32_t>(state.range(1));
    Scene s;
    if (!s.make(number, bodies, static_cast<uint32_t>(state.range(2)), LR_LOADS_LANGEVIN))
        return state.SkipWithError("scene");
    for (auto _ : state)
        if (lr_world_step(s.world, 1.0f / 60.0f, 4) != LR_OK) return state.SkipWithError("step");
    s.count(state, uint64_t{number} * bodies * 4);
}
BENCHMARK(batches)
    ->Args({1, 16000, 0})
    ->Args({100, 160, 0})
    ->Args({1000, 16, 0})
    ->Args({1, 16000, 1})
    ->Args({100, 160, 1})
    ->Args({1000, 16, 1})
    ->ArgNames({"batches", "bodies", "workers"})
    ->UseRealTime();

// A world with a single body: the thread's own time, because the step is as short as an interrupt.
void one_body(benchmark::State& state) {
    Scene s;
    if (!s.make(1, 1, static_cast<uint32_t>(state.range(1)), static_cast<int32_t>(state.range(0))))
        return state.SkipWithError("scene");
    for (auto _ : state)
        if (lr_world_step(s.world, 1.0f / 240.0f, 1) != LR_OK) return state.SkipWithError("step");
    s.count(state, 1);
}
BENCHMARK(one_body)
    ->ArgsProduct({{LR_LOADS_NONE, LR_LOADS_LANGEVIN, LR_LOADS_AERODYNAMIC}, {0, 1}})
    ->ArgNames({"loads", "workers"});

// One step per frame, as in games: workers have been idle for milliseconds.
void frames(benchmark::State& state) {
    const auto bodies = static_cast<uint32_t>(state.range(0));
    Scene s;
    if (!s.make(1, bodies, static_cast<uint32_t>(state.range(1)), LR_LOADS_LANGEVIN))
        return state.SkipWithError("scene");
    std::vector<double> seconds;
    const std::clock_t cpu = std::clock();
    for (auto _ : state) {
        std::this_thread::sleep_for(std::chrono::milliseconds(3));
        const auto begin = std::chrono::steady_clock::now();
        if (lr_world_step(s.world, 1.0f / 60.0f, 4) != LR_OK) return state.SkipWithError("step");
        seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
        state.SetIterationTime(seconds.back());
    }
    std::nth_element(seconds.begin(), seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2), seconds.end());
    state.counters["median_us"] = 1e6 * seconds[seconds.size() / 2];
    state.counters["cpu_us"] =
        1e6 * static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC / static_cast<double>(state.iterations());
}
BENCHMARK(frames)
    ->ArgsProduct({{1000, 4000, 10000, 100000}, {0, 1}})
    ->ArgNames({"bodies", "workers"})
    ->Iterations(300)
    ->UseManualTime();

} // namespace

BENCHMARK_MAIN();
