// Colliders alone: creation, a step in which they move, and the broad phase. `each` is a collider; of `candidates` a call.
// `near` is the share of bodies in free places that the near-collider marks do not exclude.
//     bench_colliders --benchmark_counters_tabular=true
#include "collision/colliders.h"
#include "collision/near_collider_marks.h"
#include "support/random.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

namespace {

// Boxes of a decimetre to a metre, one in 8 m^3, as in a wood.
std::vector<lr_collider_desc> boxes(uint32_t count) {
    test::Random random(1);
    const double side = std::cbrt(8.0 * count);
    std::vector<lr_collider_desc> descs(count);
    for (lr_collider_desc& d : descs) {
        d = {};
        d.struct_size = sizeof d;
        d.kind = LR_COLLIDER_BOX;
        for (float& x : d.position) x = random.real(0, side);
        for (float& q : d.orientation) q = random.real(-1, 1);
        d.orientation[3] += 2.0f;
        for (float& s : d.size) s = static_cast<float>(random.logarithmic(0.05, 0.5));
        d.layers = 1;
    }
    return descs;
}

bool create(lr::Colliders& colliders, const std::vector<lr_collider_desc>& descs, std::vector<lr_collider>& ids) {
    bool ok = colliders.begin_create(static_cast<uint32_t>(descs.size())) == LR_OK;
    for (const lr_collider_desc& d : descs) ok = ok && colliders.create(d) == LR_OK;
    ids.resize(descs.size());
    return ok && colliders.finish_create(ids.data()) == LR_OK;
}

void rate(benchmark::State& state, const char* name, double things) {
    state.counters[name] = benchmark::Counter(things * static_cast<double>(state.iterations()),
                                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void making(benchmark::State& state) {
    const auto count = static_cast<uint32_t>(state.range(0));
    const std::vector<lr_collider_desc> descs = boxes(count);
    std::vector<lr_collider> ids;
    for (auto _ : state) {
        lr::Allocator allocator;
        lr::Colliders colliders(allocator);
        if (!create(colliders, descs, ids)) state.SkipWithError("create");
        colliders.begin_step(1.0 / 60.0, 0.25f);
        colliders.end_step();
    }
    rate(state, "each", count);
}

void stepping(benchmark::State& state) {
    const auto count = static_cast<uint32_t>(state.range(0));
    std::vector<lr_collider_desc> descs = boxes(count);
    for (lr_collider_desc& d : descs) d.linear_velocity[0] = d.angular_velocity[1] = 0.01f;
    std::vector<lr_collider> ids;
    lr::Allocator allocator;
    lr::Colliders colliders(allocator);
    if (!create(colliders, descs, ids)) state.SkipWithError("create");
    for (auto _ : state) {
        colliders.begin_step(1.0 / 60.0, 0.25f);
        colliders.end_step();
    }
    rate(state, "each", count);
}

void asking(benchmark::State& state) {
    const auto count = static_cast<uint32_t>(state.range(0));
    const double side = std::cbrt(8.0 * count);
    std::vector<lr_collider> ids;
    lr::Allocator allocator;
    lr::Colliders colliders(allocator);
    if (!create(colliders, boxes(count), ids)) state.SkipWithError("create");
    colliders.begin_step(1.0 / 60.0, 0.25f);
    test::Random random(2);
    std::vector<lr::Vector> places(65536);
    for (lr::Vector& p : places) p = {random.real(0, side), random.real(0, side), random.real(0, side)};
    uint64_t found = 0, asked = 0, near = 0;
    lr::Candidate out[lr::most_candidates];
    for (auto _ : state)
        for (const lr::Vector& p : places) {
            const lr::Vector e{0.1f, 0.1f, 0.1f};
            bool more = false;
            found += colliders.candidates({p - e, p + e}, 1, nullptr, out, more);
            ++asked;
        }
    for (const lr::Vector& p : places) near += test::marked(colliders.near(), p, 0.2f);
    rate(state, "candidates", 65536.0);
    state.counters["found"] = static_cast<double>(found) / static_cast<double>(asked);
    state.counters["near"] = static_cast<double>(near) / 65536.0;
    // The same among empty places: the cost of false marks.
    near = 0;
    for (const lr::Vector& p : places)
        near += test::marked(colliders.near(), p + lr::Vector{static_cast<float>(2.0 * side), 0.0f, 0.0f}, 0.2f);
    state.counters["near, away"] = static_cast<double>(near) / 65536.0;
}

BENCHMARK(making)->Arg(1000)->Arg(10000)->Arg(1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(stepping)->Arg(100)->Arg(10000)->Unit(benchmark::kMillisecond);
BENCHMARK(asking)->Arg(100)->Arg(10000)->Arg(1000000)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
