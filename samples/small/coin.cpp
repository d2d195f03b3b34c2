// A coin of 23 mm and 5 g falls into a pool and sinks to its bottom, 2 m deep: how deep it is, every 0.5 s.
#include <cstdio>
#include <langevin_rigid.hpp>
int main() {
    langevin_rigid::World world;
    lr_ellipsoid_desc metal = LR_ELLIPSOID_DESC_INIT;
    metal.semi_axes[0] = metal.semi_axes[1] = 0.0116, metal.semi_axes[2] = 0.0012, metal.density = 7800.0;
    const lr_batch coins = world.add_batch(langevin_rigid::Asset::ellipsoid(metal), 1);
    world.set_water(lr_water_desc LR_WATER_DESC_INIT); // below y = 0
    lr_collider_desc bottom = LR_COLLIDER_DESC_INIT;
    bottom.kind = LR_COLLIDER_PLANE, bottom.position[1] = -2.0f, world.add(bottom);
    lr_body_desc drop = LR_BODY_DESC_INIT;
    drop.position[1] = 0.3f, drop.orientation[0] = -0.64f, drop.orientation[3] = 0.768f; // nearly flat
    const lr_body coin = world.add(coins, drop);
    int frame = 0;
    for (; world.state(coin).sleep_state == LR_SLEEP_AWAKE; world.step(1.0f / 60, 4), ++frame)
        if (frame % 30 == 0) std::printf("%.1f s: %.2f m deep\n", frame / 60.0, -world.state(coin).position[1]);
    std::printf("at rest after %.1f s, %.3f m deep\n", frame / 60.0, -world.state(coin).position[1]);
}
