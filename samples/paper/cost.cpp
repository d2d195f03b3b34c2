// Table 2: the cost of a step.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cstdio>

#include "failure.h"
#include "figures.h"
#include "panel.h"
#include "recorded_falls.h"
#include "turbulence.h"

namespace {

// Nanoseconds per body and step of one thread, for `count` bodies during `seconds` of wall time.
double step_cost(const lr_asset* asset, std::int32_t loads, std::uint32_t count, float dt, double seconds,
                 std::uint64_t seed) {
    const WorldPointer world = make_world(seed);
    const lr_batch batch = make_batch(world.get(), asset, loads, count);
    lr_emitter_desc emitter; // random poses
    check(lr_emitter_desc_init(&emitter, sizeof emitter), "lr_emitter_desc_init");
    check(lr_batch_set_emitter(world.get(), batch, &emitter), "emitter");
    check(lr_batch_spawn(world.get(), batch, count, nullptr), "cannot create bodies");
    using Clock = std::chrono::steady_clock;
    for (int i = 0; i < 10; ++i) check(lr_world_step(world.get(), dt, 1), "step");
    double best = 1e300; // of several parts: other load on the machine only adds time
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    const std::uint32_t steps = count > 100 ? 1 : 1000;
    do {
        const auto start = Clock::now();
        for (std::uint32_t i = 0; i < steps; ++i) check(lr_world_step(world.get(), dt, 1), "step");
        const double taken = std::chrono::duration<double, std::nano>(Clock::now() - start).count();
        best = std::min(best, taken / steps / count);
    } while (Clock::now() < end);
    return best;
}

} // namespace

void table_2(const Options& options, Numbers& numbers) {
    struct Line {
        const char *name, *body;
        float dt;
        const char* paper;
    };
    const Line lines[] = {{"ellipsoid 1", "rubber_coarse", 0.001f, "1.59 ms a step"},
                          {"ellipsoid 1", "rubber_coarse", 0.005f, "1.63 ms a step"},
                          {"ellipsoid 1", "rubber_coarse", 0.010f, "1.65 ms a step"},
                          {"ellipsoid 2", "rubber", 0.005f, "1.71 ms a step"},
                          {"piece of paper", "leaf", 0.005f, "1.73 ms a step"},
                          {"paper airplane", "plane", 0.005f, "1.86 ms a step"}};
    for (const Line& line : lines) {
        const AssetPointer asset = load_asset(options.baked + "/" + line.body + ".lrb");
        const BakeReport report = read_report(options.baked + "/" + line.body + ".json");
        for (const LoadModel& model : both_models) {
            char of[96];
            std::snprintf(of, sizeof of, "%s, %zu triangles, dt %.0f ms, %s", line.name, report.faces,
                          1e3 * static_cast<double>(line.dt), model.name);
            const double alone = step_cost(asset.get(), model.loads, 1, line.dt, options.cost_seconds, options.seed);
            const double many = step_cost(asset.get(), model.loads, 10000, line.dt, options.cost_seconds, options.seed);
            numbers.judge("table2", of, "a step of one body alone", alone, "ns", line.paper, alone < 1.59e6);
            numbers.show("table2", of, "a step, for each of 10000 bodies", many, "ns");
        }
    }
    const BakeReport leaf = read_report(options.baked + "/rubber.json");
    numbers.show("table2", "bake, 1280 triangles", "added mass", 1e3 * leaf.added_mass_seconds, "ms", "53 ms");
    const BakeReport grid = read_report(options.baked + "/table_paper_grid.json");
    numbers.show("table2", "bake, 32x32x8 cells", "turbulence, empty stream", 1e3 * grid.turbulence_seconds, "ms",
                 "182 ms");
    const BakeReport wake = read_report(options.baked + "/table_wake.json");
    numbers.show("table2", "bake, 32x32x16 cells", "turbulence with the body's wake", 1e3 * wake.turbulence_seconds,
                 "ms");
}
