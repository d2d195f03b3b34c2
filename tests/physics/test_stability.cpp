// No accepted value makes the default scheme diverge.
#include "support/lost_bodies.h"
#include "support/quick.h"
#include "support/random.h"
#include "support/scene.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace test;

// Bodies of all sizes, shapes and speeds, at the steps of engines: no state grows without bound in the default scheme.
TEST_CASE("the default integrator keeps every body finite at every step") {
    Random random(77);
    const World world = make(world_desc());
    set_wind(world, 5.0f, 0.0f, 0.0f);
    std::vector<lr_batch> batches;
    for (int i = 0; i < 24; ++i) {
        const double size = random.logarithmic(1e-4, 2.0);
        lr_ellipsoid_desc shape = ellipsoid(size, size * random.logarithmic(0.05, 1.0),
                                            size * random.logarithmic(2e-3, 1.0), random.logarithmic(2.0, 3000.0));
        if (i % 2)
            for (size_t k = 0; k < 3; ++k) shape.center_of_mass[k] = random.uniform(-0.4, 0.4) * shape.semi_axes[k];
        lr_batch_desc d = batch_desc();
        if (i % 3 == 0) d.clock = LR_CLOCK_AGE;
        d.load_model = std::array{LR_LOADS_NONE, LR_LOADS_LANGEVIN,
                                  LR_LOADS_AERODYNAMIC}[static_cast<size_t>(i % 8 == 7 ? 0 : 1 + i / 2 % 2)];
        batches.push_back(add_batch(world, d, make(shape), 40));
        for (int k = 0; k < 40; ++k) {
            lr_body_desc b = turned_anyhow(random);
            for (float& v : b.linear_velocity) v = random.real(-20.0, 20.0);
            for (float& w : b.angular_velocity) w = random.real(-200.0, 200.0);
            b.scale = static_cast<float>(random.logarithmic(0.1, 10.0));
            add_body(world, batches.back(), b);
        }
    }
    for (float dt : {1.0f / 240.0f, 1.0f / 60.0f, 0.1f, 1.0f, 1e-4f}) {
        steps(world, 60, dt, 1);
        Extremes all;
        for (lr_batch batch : batches) all.add(world, batch);
        CAPTURE(dt);
        MESSAGE("dt ", dt, ": fastest ", all.fastest, " m/s");
        CHECK(all.lost == 0);
        // Free fall for 67 s without loads reaches 660 m/s; loads add nothing.
        CHECK(all.fastest < 2000.0);
    }
}

// Sizes from a micrometre to a kilometre, scales, speeds and spins up to the limits of lr_body_create, steps up to 1 s.
TEST_CASE("the default integrator keeps every body finite at the limits of the API") {
    const uint64_t worlds = quick() ? 4 : 40;
    for (uint64_t seed = 0; seed < worlds; ++seed) {
        Random random(1000 + seed);
        const double speed = random.logarithmic(1.0, 1e6), spin = random.logarithmic(1.0, 1e6);
        const float dt = static_cast<float>(random.logarithmic(1e-4, 1.0));
        const World world = make(world_desc());
        std::vector<lr_batch> batches;
        for (int i = 0; i < 24; ++i) {
            const double size = random.logarithmic(1.001e-6, 999.0);
            lr_ellipsoid_desc shape = ellipsoid(size, size, size, random.logarithmic(1.0, 2e4));
            for (double& a : shape.semi_axes) a = std::max(1e-6, a * random.logarithmic(1e-3, 1.0));
            if (i % 2)
                for (size_t k = 0; k < 3; ++k)
                    shape.center_of_mass[k] = random.uniform(-0.55, 0.55) * shape.semi_axes[k];
            lr_batch_desc d = batch_desc();
            if (i % 3 == 0) d.clock = LR_CLOCK_AGE;
            d.load_model = std::array{LR_LOADS_NONE, LR_LOADS_LANGEVIN,
                                      LR_LOADS_AERODYNAMIC}[static_cast<size_t>(i % 8 == 7 ? 0 : 1 + i / 2 % 2)];
            if (i % 5 == 4) d.damping_gain = d.noise_gain = 100.0f;
            batches.push_back(add_batch(world, d, make(shape), 16));
            for (int k = 0; k < 16; ++k) {
                lr_body_desc b = turned_anyhow(random);
                for (float& v : b.linear_velocity) v = random.real(-speed, speed);
                for (float& w : b.angular_velocity) w = random.real(-spin, spin);
                b.scale = static_cast<float>(random.logarithmic(1.001e-3, 999.0));
                add_body(world, batches.back(), b);
            }
        }
        steps(world, 200, dt, 1);
        Extremes all;
        for (lr_batch batch : batches) all.add(world, batch);
        CAPTURE(seed);
        CHECK(all.lost == 0);
    }
}
