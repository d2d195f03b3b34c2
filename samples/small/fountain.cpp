// Petals fall into a fountain's jet, 20 a second, fly up and float away: how high and how far, every 2.5 s.
#include <cstdio>
#include <langevin_rigid.hpp>
int main() {
    langevin_rigid::World world;
    lr_ellipsoid_desc petal = LR_ELLIPSOID_DESC_INIT; // 14 x 11 mm, 13 mg
    petal.semi_axes[0] = 0.007, petal.semi_axes[1] = 0.0055, petal.semi_axes[2] = 0.0001, petal.density = 800.0;
    const lr_batch petals = world.add_batch(langevin_rigid::Asset::ellipsoid(petal), 600);
    lr_water_desc pool = LR_WATER_DESC_INIT; // below y = 0
    pool.current[0] = 0.1f, world.set_water(pool);
    lr_blower_desc jet = LR_BLOWER_DESC_INIT; // the air that the water carries up with it
    jet.direction[0] = 0, jet.direction[1] = 1, jet.speed = 5, jet.nozzle_radius = 0.1f, world.add(jet);
    lr_emitter_desc birth = LR_EMITTER_DESC_INIT; // in the jet
    birth.position[1] = 0.1f, birth.rate = 20, world.set_emitter(petals, birth);
    for (int n = 1; n <= 1200; ++n) {
        float low[3], high[3];
        world.step(1.0f / 60, 4), lr_batch_get_bounds(world.get(), petals, low, high);
        if (n % 150 == 0) std::printf("%.1f s: %.2f m up, %.2f m away\n", n / 60.0, high[1], high[0]);
    }
}
