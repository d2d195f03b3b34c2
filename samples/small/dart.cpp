// A paper dart is thrown level, 1.6 m above the floor at 3 m/s: dart viewer_assets/paper_plane.lrb
#include <cstdio>
#include <langevin_rigid.hpp>
int main(int argc, char** argv) {
    if (argc != 2) return std::puts("dart ASSET"), 2;
    langevin_rigid::World world;
    const auto plane = langevin_rigid::Asset::load(argv[1]);
    lr_batch_desc desc = LR_BATCH_DESC_INIT;
    desc.asset = plane.get(), desc.capacity = 1, desc.variation = 0; // folded with care
    const lr_batch darts = world.add(desc);
    lr_body_desc launch = LR_BODY_DESC_INIT;
    launch.position[1] = 1.6f, launch.linear_velocity[0] = 3.0f;             // along its nose
    launch.orientation[0] = -0.7071068f, launch.orientation[3] = 0.7071068f; // the mesh's z up
    const lr_body dart = world.add(darts, launch);
    lr_body_state s = world.state(dart);
    for (int frame = 1; s.position[1] > 0; world.step(1.0f / 60, 2), s = world.state(dart), ++frame)
        if (frame % 6 == 0) std::printf("%.1f s: %.2f m far, %.2f m up\n", frame / 60.0, s.position[0], s.position[1]);
}
