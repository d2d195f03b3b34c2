// Rays and overlaps among 10^5 awake bodies, and the cost of events for a step.
#include "langevin_rigid.h"

#include <benchmark/benchmark.h>

#include <random>
#include <vector>

namespace {

struct Storm {
    lr_asset* asset = nullptr;
    lr_world* world = nullptr;

    explicit Storm(uint32_t bodies, float height) {
        lr_ellipsoid_desc e;
        lr_ellipsoid_desc_init(&e, sizeof e);
        e.semi_axes[0] = 0.04, e.semi_axes[1] = 0.01, e.semi_axes[2] = 0.00005;
        e.density = 800.0;
        lr_asset_create_ellipsoid(&e, &asset);
        lr_world_desc w;
        lr_world_desc_init(&w, sizeof w);
        lr_world_create(&w, &world);
        lr_batch_desc b;
        lr_batch_desc_init(&b, sizeof b);
        b.asset = asset;
        b.capacity = bodies;
        lr_batch batch{};
        lr_batch_create(world, &b, &batch);
        lr_collider_desc plane;
        lr_collider_desc_init(&plane, sizeof plane);
        plane.kind = LR_COLLIDER_PLANE;
        lr_collider_create(world, &plane, 1, nullptr);
        std::mt19937 random(1);
        std::uniform_real_distribution<float> wide(-20.0f, 20.0f), high(0.02f, height);
        std::vector<lr_body_desc> descs(bodies);
        for (lr_body_desc& d : descs) {
            lr_body_desc_init(&d, sizeof d);
            d.position[0] = wide(random), d.position[1] = high(random), d.position[2] = wide(random);
        }
        lr_body_create(world, batch, descs.data(), bodies, nullptr);
    }
    Storm(const Storm&) = delete;
    Storm& operator=(const Storm&) = delete;
    ~Storm() {
        lr_world_destroy(world);
        lr_asset_release(asset);
    }
};

void ray(benchmark::State& state) {
    const Storm storm(static_cast<uint32_t>(state.range(0)), 10.0f);
    std::mt19937 random(2);
    std::uniform_real_distribution<float> any(-1.0f, 1.0f);
    std::vector<lr_ray> rays(256);
    for (lr_ray& r : rays) {
        lr_ray_init(&r, sizeof r);
        r.origin[0] = 20.0f * any(random), r.origin[1] = 12.0f, r.origin[2] = 20.0f * any(random);
        r.direction[0] = any(random), r.direction[2] = any(random);
    }
    std::vector<lr_ray_hit> hits(256);
    for (auto _ : state) lr_world_ray_cast(storm.world, rays.data(), 256, hits.data());
    state.counters["time/ray"] = benchmark::Counter(256.0 * static_cast<double>(state.iterations()),
                                                    benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void overlap(benchmark::State& state) {
    const Storm storm(static_cast<uint32_t>(state.range(0)), 10.0f);
    lr_overlap_desc d;
    lr_overlap_desc_init(&d, sizeof d);
    d.position[1] = 5.0f;
    std::vector<lr_body> ids(100000);
    uint32_t count = 0;
    for (auto _ : state) lr_world_overlap(storm.world, &d, ids.data(), 100000, &count);
    state.counters["found"] = count;
}

// 10^5 leaves, of which ever more lie on the ground or touch it.
void step(benchmark::State& state) {
    const Storm storm(100000, 0.5f);
    if (state.range(0) != 0) lr_world_set_events(storm.world, 65536, LR_EVENTS_ALL);
    for (int i = 0; i < 10; ++i) lr_world_step(storm.world, 1.0f / 60.0f, 2);
    double events = 0.0;
    for (auto _ : state) {
        lr_world_step(storm.world, 1.0f / 60.0f, 2);
        lr_event_list list;
        lr_event_list_init(&list, sizeof list);
        lr_world_get_events(storm.world, &list);
        events += list.count;
    }
    state.counters["events/step"] = events / static_cast<double>(state.iterations());
}

} // namespace

BENCHMARK(ray)->Arg(1000)->Arg(100000)->Unit(benchmark::kMicrosecond);
BENCHMARK(overlap)->Arg(100000)->Unit(benchmark::kMicrosecond);
BENCHMARK(step)->Arg(0)->Arg(1)->Iterations(20)->Repetitions(3)->Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();
