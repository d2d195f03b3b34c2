// The cost of a body at a water surface compared to air: 20,000 of each on one core, ns per body and substep.
//     bench_water --benchmark_repetitions=5
#include "bench/full_mass_matrix.h"
#include "langevin_rigid.h"

#include <benchmark/benchmark.h>

#include <cmath>

namespace {

constexpr uint32_t bodies = 20000, substeps = 4;

struct Scene {
    lr_asset* asset = nullptr;
    lr_world* world = nullptr;

    // Light plates on the water, or ten metres above it.
    bool make(int32_t loads, bool full, bool afloat) {
        lr_ellipsoid_desc shape;
        lr_ellipsoid_desc_init(&shape, sizeof shape);
        shape.semi_axes[0] = 0.04, shape.semi_axes[1] = 0.004, shape.semi_axes[2] = 0.03;
        shape.density = 500.0;
        lr_world_desc wd;
        lr_world_desc_init(&wd, sizeof wd);
        lr_water_desc surface;
        lr_water_desc_init(&surface, sizeof surface);
        surface.position[1] = afloat ? 0.0f : -1e4f;
        lr_batch_desc bd;
        lr_batch_desc_init(&bd, sizeof bd);
        bd.capacity = bodies;
        bd.load_model = loads;
        lr_batch batch{};
        if (lr_asset_create_ellipsoid(&shape, &asset) != LR_OK || lr_world_create(&wd, &world) != LR_OK) return false;
        bd.asset = asset;
        if (lr_world_set_water(world, &surface) != LR_OK || lr_batch_create(world, &bd, &batch) != LR_OK) return false;
        if (full && !take_full_path(world, batch)) return false;
        for (uint32_t i = 0; i < bodies; ++i) {
            lr_body_desc d;
            lr_body_desc_init(&d, sizeof d);
            d.position[0] = static_cast<float>(i);
            d.orientation[0] = 0.1f * std::sin(static_cast<float>(i));
            if (lr_body_create(world, batch, &d, 1, nullptr) != LR_OK) return false;
        }
        return true;
    }
    ~Scene() {
        lr_world_destroy(world);
        lr_asset_release(asset);
    }
};

void step(benchmark::State& state) {
    Scene s;
    if (!s.make(static_cast<int32_t>(state.range(0)), state.range(1) != 0, state.range(2) != 0))
        return state.SkipWithError("scene");
    for (auto _ : state)
        if (lr_world_step(s.world, 1.0f / 60.0f, substeps) != LR_OK) return state.SkipWithError("step");
    // Displayed as seconds with the unit n: the inverse of a rate.
    state.counters["body"] =
        benchmark::Counter(static_cast<double>(bodies) * substeps,
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(step)
    ->ArgNames({"loads", "full", "afloat"})
    ->ArgsProduct({{LR_LOADS_NONE, LR_LOADS_LANGEVIN, LR_LOADS_AERODYNAMIC}, {0, 1}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->MinTime(0.3);

} // namespace

BENCHMARK_MAIN();
