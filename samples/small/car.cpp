// A car passes 400 leaves on a road at 50 km/h, a roller of air behind it: how many fly, and how high, every 0.5 s.
#include <cstdio>
#include <langevin_rigid.hpp>
int main() {
    langevin_rigid::World world;
    lr_ellipsoid_desc leaf = LR_ELLIPSOID_DESC_INIT; // 7 x 4 cm, 0.2 g
    leaf.semi_axes[0] = 0.035, leaf.semi_axes[1] = 0.02, leaf.semi_axes[2] = 0.00015, leaf.density = 350.0;
    const lr_batch leaves = world.add_batch(langevin_rigid::Asset::ellipsoid(leaf), 400);
    lr_collider_desc road = LR_COLLIDER_DESC_INIT;
    road.kind = LR_COLLIDER_PLANE, world.add(road), world.spawn_box(leaves, {-6, 0.1f, -2}, {6, 0.3f, 2}, 400);
    lr_vortex_desc roller = LR_VORTEX_DESC_INIT; // about z; the air below it goes along with the car
    roller.axis[1] = 0, roller.axis[2] = 1, roller.position[0] = -48, roller.position[1] = 0.7f;
    roller.velocity[0] = 13.9f, roller.half_length = 1, roller.core_radius = 0.6f, roller.outer_radius = 3;
    roller.circulation = 50, world.add(roller); // m^2/s: 8 m/s at 0.6 m
    for (int n = 1; n <= 360; ++n) {
        float low[3], high[3];
        world.step(1.0f / 60, 2), lr_batch_get_bounds(world.get(), leaves, low, high);
        if (n % 30 == 0) std::printf("%.1f s: %d fly to %.2f m\n", n / 60.0, int(world.info().awake_count), high[1]);
    }
}
