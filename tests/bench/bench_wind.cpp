// Bodies in wind, one thread: time per body and substep, without wind, in a uniform wind, and with each kind of source.
#include "langevin_rigid.h"

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <vector>

namespace {

constexpr uint32_t bodies = 100000, substeps = 4;

void need(lr_status status) {
    if (status != LR_OK) std::abort();
}

template <class D> D initialised(lr_status (*init)(D*, uint32_t)) {
    D d;
    need(init(&d, sizeof d));
    return d;
}

enum Source : int64_t { gusts = 1, rankine, lamb_oseen, round_blower, slot_blower, turbulence, grid, ground };

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
        lr_batch batch{};
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

    void add(int64_t kind, float far, uint32_t octaves = 1) {
        const std::vector<float> samples(3 * 16 * 16 * 16 * 2, 1.0f);
        if (kind == gusts) {
            const auto d = initialised(lr_gusts_desc_init);
            need(lr_world_add_gusts(world, &d, nullptr));
        } else if (kind == rankine || kind == lamb_oseen) {
            auto d = initialised(lr_vortex_desc_init);
            d.core = kind == rankine ? LR_VORTEX_RANKINE : LR_VORTEX_LAMB_OSEEN;
            d.position[0] = far;
            d.outer_radius = d.half_length = 20.0f;
            need(lr_world_add_vortex(world, &d, nullptr));
        } else if (kind == round_blower || kind == slot_blower) {
            auto d = initialised(lr_blower_desc_init);
            d.position[0] = far;
            d.direction[1] = 1.0f;
            d.half_length = kind == slot_blower ? 20.0f : 0.0f;
            d.range = 30.0f;
            need(lr_world_add_blower(world, &d, nullptr));
        } else if (kind == turbulence) {
            auto d = initialised(lr_turbulence_desc_init);
            d.octaves = octaves;
            need(lr_world_add_turbulence(world, &d, nullptr));
        } else if (kind == grid) {
            auto d = initialised(lr_wind_grid_desc_init);
            for (float& x : d.position) x = -8.0f;
            for (uint32_t& n : d.counts) n = 16;
            d.frames = 2;
            d.samples = samples.data();
            need(lr_world_add_wind_grid(world, &d, nullptr));
        } else {
            const auto d = initialised(lr_ground_wind_desc_init);
            need(lr_world_add_ground_wind(world, &d, nullptr));
        }
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
    float speed = 0.0f;
    for (auto _ : state) {
        speed = 2.0f - speed; // a change in each step
        need(lr_world_set_uniform_wind(scene.world, speed, 0.0f, 0.0f));
        need(lr_world_step(scene.world, 1.0f / 120.0f, substeps));
    }
    state.counters["per body and substep"] =
        benchmark::Counter(static_cast<double>(state.iterations()) * bodies * substeps,
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
void source(benchmark::State& state) {
    Scene scene;
    scene.add(state.range(0), 0.0f, static_cast<uint32_t>(state.range(1)));
    scene.run(state);
}
void far_sources(benchmark::State& state) {
    Scene scene;
    scene.add(gusts, 0.0f);
    for (int i = 0; i < 60; ++i) scene.add(lamb_oseen + i % 3, 1e3f);
    scene.run(state);
}
// Gusts, turbulence of two octaves, the ground, and four vortices of people's size.
void park(benchmark::State& state) {
    Scene scene;
    scene.add(gusts, 0.0f);
    scene.add(ground, 0.0f);
    if (state.range(0) >= 1) scene.add(turbulence, 0.0f, 2);
    for (int i = 0; i < 4 && state.range(0) >= 2; ++i) {
        auto d = initialised(lr_vortex_desc_init);
        d.position[0] = 2.0f * static_cast<float>(i) - 3.0f;
        d.outer_radius = d.half_length = 2.0f;
        need(lr_world_add_vortex(scene.world, &d, nullptr));
    }
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
    ->Args({gusts, 1})
    ->Args({rankine, 1})
    ->Args({lamb_oseen, 1})
    ->Args({round_blower, 1})
    ->Args({slot_blower, 1})
    ->Args({turbulence, 1})
    ->Args({turbulence, 2})
    ->Args({grid, 1})
    ->Args({ground, 1});
BENCHMARK(far_sources);
BENCHMARK(park)->ArgName("sources")->DenseRange(0, 2); // gusts and ground; and turbulence; and vortices
BENCHMARK(callback);
BENCHMARK_MAIN();
