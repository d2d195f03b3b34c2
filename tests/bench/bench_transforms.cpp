// lr_batch_write_transforms against memcpy of as many bytes as it writes. `of_memcpy`: ratio of their speeds, the median of
// turns that alternate, so that other load on the machine affects both. With 64-byte elements 32 bytes per body are read and
// 64 written, whereas memcpy reads 64.
//     bench_transforms --benchmark_min_time=0.001 --benchmark_counters_tabular=true
#include "bench/leaf_asset.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <memory>
#include <vector>

namespace {

// ns of this thread's own time
double now() {
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
}

double median(std::vector<double>& of) {
    const auto middle = of.begin() + static_cast<std::ptrdiff_t>(of.size() / 2);
    std::nth_element(of.begin(), middle, of.end());
    return *middle;
}

// bodies, format, gaps between elements in bytes, misalignment in bytes
void transforms(benchmark::State& state) {
    constexpr uint64_t sizes[] = {28, 32, 48, 48, 64, 64};
    const auto bodies = static_cast<uint32_t>(state.range(0));
    const auto format = static_cast<int32_t>(state.range(1));
    const uint64_t size = sizes[format], stride = size + static_cast<uint64_t>(state.range(2));
    lr_world_desc wd;
    lr_world_desc_init(&wd, sizeof wd);
    lr_batch_desc bd;
    lr_batch_desc_init(&bd, sizeof bd);
    lr_asset* const asset = bench::leaf_asset();
    lr_world* world = nullptr;
    lr_batch batch{};
    if (!asset || lr_world_create(&wd, &world) != LR_OK) return state.SkipWithError("world");
    bd.asset = asset;
    bd.capacity = bodies;
    lr_emitter_desc e;
    lr_emitter_desc_init(&e, sizeof e);
    e.shape = LR_EMIT_BOX;
    e.size[0] = e.size[1] = e.size[2] = 50.0f;
    if (lr_batch_create(world, &bd, &batch) != LR_OK || lr_batch_set_emitter(world, batch, &e) != LR_OK ||
        lr_batch_spawn(world, batch, bodies, nullptr) != LR_OK)
        return state.SkipWithError("batch");

    const uint64_t bytes = stride * bodies;
    const auto buffer = [&] {
        auto* const memory = static_cast<unsigned char*>(std::aligned_alloc(4096, (bytes + 64 + 4095) / 4096 * 4096));
        std::memset(memory, 1, bytes + 64);
        return std::unique_ptr<unsigned char, decltype(&std::free)>(memory, &std::free);
    };
    const auto from = buffer(), copy = buffer(), out = buffer();
    unsigned char* const to = out.get() + state.range(3);
    const uint64_t turns = std::max<uint64_t>(15, (uint64_t{1} << 28) / bytes);
    std::vector<double> ours, theirs;
    for (auto _ : state)
        for (uint64_t i = 0; i < turns; ++i) {
            const double begin = now();
            if (lr_batch_write_transforms(world, batch, format, to, stride, bodies, nullptr) != LR_OK)
                return state.SkipWithError("transforms");
            const double middle = now();
            std::memcpy(copy.get() + state.range(3), from.get(), size * bodies);
            benchmark::ClobberMemory();
            theirs.push_back(now() - middle);
            ours.push_back(middle - begin);
        }
    const double mine = median(ours), memcpy_time = median(theirs);
    state.counters["ns_body"] = mine / bodies;
    state.counters["GB_s"] = static_cast<double>(size) * bodies / mine;
    state.counters["memcpy_GB_s"] = static_cast<double>(size) * bodies / memcpy_time;
    state.counters["of_memcpy"] = memcpy_time / mine;
    lr_world_destroy(world);
    lr_asset_release(asset);
}
BENCHMARK(transforms)
    ->ArgsProduct({{1000, 10000, 100000, 1000000}, {0, 1, 2, 3, 4, 5}, {0}, {0}})
    ->ArgNames({"bodies", "format", "gap", "shift"});
BENCHMARK(transforms)
    ->ArgsProduct({{100000, 1000000}, {2, 5}, {0}, {4}})
    ->ArgsProduct({{100000, 1000000}, {1, 2}, {16}, {0}})
    ->ArgNames({"bodies", "format", "gap", "shift"});

} // namespace

BENCHMARK_MAIN();
