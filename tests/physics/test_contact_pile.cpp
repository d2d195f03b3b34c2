// Thousands of boxes that land on a plane, without loads: energy, depth, rest.
#include "support/contact.h"
#include "support/quick.h"

#include <algorithm>
#include <cmath>

using namespace test;

namespace {

constexpr double gravity = 9.81;

// Kinetic energy including the fluid's, and potential energy of weight minus buoyancy, per body.
std::vector<double> energies(const World& world, lr_batch batch, const lr_asset_info& info) {
    const lr_batch_view v = view_of(world, batch);
    const std::vector<Velocity> u = velocities_of(world, batch);
    std::vector<std::pair<uint32_t, double>> found;
    for (uint32_t i = 0; i < v.count; ++i) {
        double sum = gravity * (info.mass - info.fluid_density * info.volume) * wide(v.position[1][i]);
        const Quat q{wide(v.orientation[0][i]), wide(v.orientation[1][i]), wide(v.orientation[2][i]),
                     wide(v.orientation[3][i])};
        const Vec speed = to_body(q, vec(u[i].linear)), spin = to_body(q, vec(u[i].angular));
        for (size_t k = 0; k < 3; ++k) {
            sum += 0.5 * (info.mass + info.added_mass[7 * k]) * speed[k] * speed[k];
            sum += 0.5 * (info.inertia[4 * k] + info.added_mass[7 * (k + 3)]) * spin[k] * spin[k];
        }
        found.emplace_back(v.noise_seed[i], sum);
    }
    std::sort(found.begin(), found.end());
    std::vector<double> out;
    for (const auto& [noise_seed, energy] : found) out.push_back(energy);
    return out;
}

} // namespace

TEST_CASE("boxes that land on the ground end with less energy, come to rest, and lie on the ground") {
    const uint32_t count = quick() ? 100 : 1000, seeds = quick() ? 1 : 3;
    const Asset assets[] = {make(rigid_box(0.05, 0.004, 0.04, 300.0)), make(rigid_box(0.03, 0.03, 0.02, 300.0))};
    for (uint32_t seed = 0; seed < seeds; ++seed)
        for (const Asset& asset : assets) {
            Random random(seed);
            const World world = make(world_desc());
            const lr_batch batch = add_batch(world, unloaded(), asset, count);
            lr_batch_contact c = contact_desc(0.5f, 0.3f, 0.05f);
            c.flags = 0;
            set_contact(world, batch, c);
            add_collider(world, collider_desc(LR_COLLIDER_PLANE));
            for (uint32_t i = 0; i < count; ++i) {
                const double x = random.uniform(-1.2, 1.2), z = random.uniform(-1.2, 1.2);
                add_body(world, batch, turned_anyhow(random, {x, random.uniform(0.3, 1.0), z}));
            }
            const lr_asset_info info = info_of(asset);
            const double scale = gravity * (info.mass - info.fluid_density * info.volume) * info.length_d;
            const std::vector<double> first = energies(world, batch, info);
            double over = 0.0, fastest = 0.0;
            for (int frame = 0; frame < 600; ++frame) {
                steps(world, 1, 1.0f / 60.0f, 4);
                const std::vector<double> now = energies(world, batch, info);
                for (size_t i = 0; i < now.size(); ++i) over = std::max(over, (now[i] - first[i]) / scale);
                fastest = std::max(fastest, fastest_of(world, batch));
            }
            const lr_batch_view v = view_of(world, batch);
            double lowest = 1.0;
            for (uint32_t i = 0; i < v.count; ++i) lowest = std::min(lowest, wide(v.position[1][i]));
            CHECK(over < 1e-3);
            CHECK(fastest <= std::sqrt(2.0 * gravity * 1.05) + 0.01);
            CHECK(v.awake_count == 0);
            CHECK(lowest > -0.01 * info.length_d);
        }
}
