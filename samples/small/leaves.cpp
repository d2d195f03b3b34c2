// A thousand leaves fall into a hollow in gusts of wind: hits and landings so far, every 5 s.
#include <cstdio>
#include <langevin_rigid.hpp>
int main() {
    langevin_rigid::World world;
    lr_ellipsoid_desc leaf = LR_ELLIPSOID_DESC_INIT; // 7 x 4 cm, 0.2 g
    leaf.semi_axes[0] = 0.035, leaf.semi_axes[1] = 0.02, leaf.semi_axes[2] = 0.00015, leaf.density = 350.0;
    const lr_batch leaves = world.add_batch(langevin_rigid::Asset::ellipsoid(leaf), 1000);
    const float heights[9] = {0, 0, 0, 0, -1, 0, 0, 0, 0}; // m: 3 x 3 samples, 30 m apart
    lr_collider_desc land = LR_COLLIDER_DESC_INIT;
    land.kind = LR_COLLIDER_HEIGHTFIELD, land.heights = heights, land.counts[0] = land.counts[1] = 3;
    land.spacing[0] = land.spacing[1] = 30, world.add(land), world.set_uniform_wind(1, 0, 0);
    world.add(lr_gusts_desc LR_GUSTS_DESC_INIT), world.add(lr_ground_wind_desc LR_GROUND_WIND_DESC_INIT);
    world.spawn_box(leaves, {16, 6, 26}, {24, 10, 34}, 1000), world.set_events(4096, LR_EVENTS_HIT | LR_EVENTS_LANDED);
    for (int frame = 1, hits = 0, landings = 0; frame <= 1800; ++frame) {
        world.step(1.0f / 60, 2);
        for (const lr_event& e : world.events()) ++(e.kind == LR_EVENT_HIT ? hits : landings);
        if (frame % 300 == 0) std::printf("%2d s: %d hits, %d landings\n", frame / 60, hits, landings);
    }
}
