#include "tools/lr_scorecard/fall_recording.h"
#include "tools/lr_scorecard/measured_bodies.h"
#include "tools/lr_scorecard/row.h"

#include <algorithm>
#include <chrono>

namespace lr::scorecard {
namespace {

double seconds_of(const std::function<void()>& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// The mean time of a step of one batch of `bodies`.
double step_time(const Asset& asset, uint32_t bodies, float dt, int steps, uint32_t threads) {
    lr_world_desc wd = initialised(lr_world_desc_init);
    wd.worker_count = threads - 1;
    const World world = make_world(wd);
    const lr_batch batch = add_batch(world, asset, Loads{}, bodies);
    const std::vector<lr_body_desc> descs(bodies, initialised(lr_body_desc_init));
    require(lr_body_create(world.get(), batch, descs.data(), bodies, nullptr), "lr_body_create");
    require(lr_world_step(world.get(), dt, 1), "lr_world_step");
    return seconds_of([&] {
               for (int i = 0; i < steps; ++i) require(lr_world_step(world.get(), dt, 1), "lr_world_step");
           }) /
           steps;
}
} // namespace

RowResult run_cost(const Context& context) {
    RowResult result;
    const Asset ellipsoid = rubber_ellipsoid();
    const Asset paper = bake_disc(0.0344, 1e-4, 0.07, Fluid{});
    // The paper's times for one body, ms.
    result.add("ellipsoid, step of 1 ms", Rule::at_most, 1e3 * step_time(ellipsoid, 1, 1e-3f, 2000, 1), 1.59, 0.0,
               "ms");
    result.add("ellipsoid, step of 5 ms", Rule::at_most, 1e3 * step_time(ellipsoid, 1, 5e-3f, 2000, 1), 1.63, 0.0,
               "ms");
    result.add("ellipsoid, step of 10 ms", Rule::at_most, 1e3 * step_time(ellipsoid, 1, 1e-2f, 2000, 1), 1.65, 0.0,
               "ms");
    result.add("piece of paper, step of 5 ms", Rule::at_most, 1e3 * step_time(paper, 1, 5e-3f, 2000, 1), 1.73, 0.0,
               "ms");
    const uint32_t crowd = context.quick ? 10000 : 100000;
    result.show("a body in a crowd of " + std::to_string(crowd) + ", step of 5 ms",
                1e9 * step_time(paper, crowd, 5e-3f, 20, context.threads) / crowd, "ns");
    result.show("bake of a disc of 1536 triangles, 32x32x16 cells",
                1e3 * seconds_of([] { bake_disc(0.0344, 1e-4, 0.07, Fluid{}); }), "ms");
    result.remarks.push_back(
        "Times are of the machine that ran this. The paper's: Core i7, 3.2 GHz; 53 ms and 182 ms for the "
        "added mass of 1280 triangles and the turbulence on 32x32x8 cells.");
    return result;
}
} // namespace lr::scorecard
