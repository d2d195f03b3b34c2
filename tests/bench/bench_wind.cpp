// Bodies in wind, one thread: time a body and substep, without wind, in a uniform one, and with each kind of source.
#include "langevin_rigid.h"

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <vector>

namespace {

constexpr uint32_t bodies = 16384, substeps = 4;

void need(lr_status status) {
    if (status != LR_OK) std::abort();
}

struct Scene {
    lr_world* world = nullptr;

    Scene() {
        lr_world_desc wd;
        need(lr_world_desc_init(&wd, sizeof wd));
        wd.gravity[1] = 0.0f; // bodies stay where the wind is
        need(lr_world_create(&wd, &world));
        lr_ellipsoid_desc shape;
        need(lr_ellipsoid_desc_init(&shape, sizeof shape));
        shape.semi_axes[0] = 0.04, shape.semi_axes[1] = 0.01, shape.semi_axes[2] = 5e-5;
        shape.density = 800.0;
        lr_asset* asset = nullptr;
        need(lr_asset_create_ellipsoid(&shape, &asset));
        lr_batch_desc bd;
        need(lr_batch_desc_init(&bd, sizeof bd));
        bd.asset = asset;
        bd.capacity = bodies;
        lr_batch batch = 0;
        need(lr_batch_create(world, &bd, &batch));
        lr_asset_release(asset);
        std::vector<lr_body_desc> descs(bodies);
        uint32_t state = 1;
        for (lr_body_desc& d : descs) {
            need(lr_body_desc_init(&d, sizeof d));
            for (float& x : d.position) {
                state = state * 1664525u + 1013904223u;
                x = static_cast<float>(state >> 8) / 16777216.0f * 10.0f - 5.0f;
            }
        }
        need(lr_body_create(world, batch, descs.data(), bodies, nullptr));
    }
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;
    ~Scene() { lr_world_destroy(world); }

    void add(int32_t kind, float far, uint32_t octaves = 1) {
        std::vector<float> samples(3 * 16 * 16 * 16 * 2, 1.0f);
        lr_wind_source_desc d;
        need(lr_wind_source_desc_init(&d, sizeof d));
        d.kind = kind;
        d.position[0] = far;
        d.direction[1] = 1.0f;
        d.octaves = octaves;
        d.radius = d.half_length = 20.0f;
        d.range = 30.0f;
        if (kind == LR_WIND_SOURCE_GRID) {
            for (float& x : d.position) x -= 8.0f;
            for (uint32_t& n : d.counts) n = 16;
            d.frames = 2;
            d.samples = samples.data();
        }
        lr_wind_source source = 0;
        need(lr_world_add_wind(world, &d, &source));
    }
    void run(benchmark::State& state) {
        for (auto _ : state) need(lr_world_step(world, 1.0f / 120.0f, substeps));
        state.counters["per body and substep"] =
            benchmark::Counter(static_cast<double>(state.iterations()) * bodies * substeps,
                               benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    }
};

void still(benchmark::State& state) {
    Scene().run(state);
}
void uniform(benchmark::State& state) {
    Scene scene;
    lr_wind_desc d;
    need(lr_wind_desc_init(&d, sizeof d));
    float speed = 0.0f;
    for (auto _ : state) {
        d.velocity[0] = speed = 2.0f - speed; // another one each step
        need(lr_world_set_wind(scene.world, &d));
        need(lr_world_step(scene.world, 1.0f / 120.0f, substeps));
    }
    state.counters["per body and substep"] =
        benchmark::Counter(static_cast<double>(state.iterations()) * bodies * substeps,
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
void source(benchmark::State& state) {
    Scene scene;
    scene.add(static_cast<int32_t>(state.range(0)), 0.0f, static_cast<uint32_t>(state.range(1)));
    scene.run(state);
}
void far_sources(benchmark::State& state) {
    Scene scene;
    scene.add(LR_WIND_SOURCE_GUSTS, 0.0f);
    for (int i = 0; i < 60; ++i) scene.add(LR_WIND_SOURCE_LAMB_OSEEN + i % 3, 1e3f);
    scene.run(state);
}
void callback(benchmark::State& state) {
    Scene scene;
    const auto shear = [](void*, const lr_wind_query* q) {
        for (uint32_t i = 0; i < q->count; ++i) q->velocity[0][i] = 0.5f * q->position[1][i];
    };
    need(lr_world_set_wind_callback(scene.world, shear, nullptr));
    scene.run(state);
}

} // namespace

BENCHMARK(still);
BENCHMARK(uniform);
BENCHMARK(source)
    ->ArgNames({"kind", "octaves"})
    ->Args({LR_WIND_SOURCE_GUSTS, 1})
    ->Args({LR_WIND_SOURCE_RANKINE, 1})
    ->Args({LR_WIND_SOURCE_LAMB_OSEEN, 1})
    ->Args({LR_WIND_SOURCE_POINT_BLOWER, 1})
    ->Args({LR_WIND_SOURCE_LINE_BLOWER, 1})
    ->Args({LR_WIND_SOURCE_TURBULENCE, 1})
    ->Args({LR_WIND_SOURCE_TURBULENCE, 2})
    ->Args({LR_WIND_SOURCE_GRID, 1})
    ->Args({LR_WIND_SOURCE_GROUND, 1});
BENCHMARK(far_sources);
BENCHMARK(callback);
BENCHMARK_MAIN();
