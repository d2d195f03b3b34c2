// A blast of air fires 500 pieces of paper, 12 x 6 mm, upwards: how high and wide they fly, every 0.25 s.
#include <cstdio>
#include <langevin_rigid.hpp>
int main() {
    langevin_rigid::World world;
    lr_ellipsoid_desc paper = LR_ELLIPSOID_DESC_INIT;
    paper.semi_axes[0] = 0.006, paper.semi_axes[1] = 0.003, paper.semi_axes[2] = 0.00005, paper.density = 800.0;
    const lr_batch confetti = world.add_batch(langevin_rigid::Asset::ellipsoid(paper), 500);
    world.spawn_box(confetti, {-0.02f, 0, -0.02f}, {0.02f, 0.1f, 0.02f}, 500); // in the muzzle
    lr_blower_desc blast = LR_BLOWER_DESC_INIT;
    blast.direction[0] = 0, blast.direction[1] = 1, blast.speed = 30, blast.nozzle_radius = 0.05f;
    const lr_wind_source air = world.add(blast);
    for (int frame = 1; frame <= 240; ++frame) {
        float low[3], high[3];
        if (frame == 20) world.remove(air);
        world.step(1.0f / 60, 4), lr_batch_get_bounds(world.get(), confetti, low, high);
        if (frame % 15 == 0) std::printf("%.2f s: %.2f m high, %.2f m wide\n", frame / 60.0, high[1], high[0] - low[0]);
    }
}
