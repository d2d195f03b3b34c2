// Roll damping of the AERODYNAMIC loads: closed form, unaffected motions, and the tumbling that it keeps straight.
#include "support/scene.h"
#include "support/vector.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace test;
using std::numbers::pi;

namespace {

constexpr double density = 1000.0, volume = 1e-6, inertia = 2e-8, damping = 4e-9;

// Weightless, without added mass or any other load, moving along (1, 2, -2)/3 at 0.5 m/s with the given spin.
lr_body_state driven(int32_t integrator, bool full, const float spin[3], double seconds) {
    lr_aerodynamics loads = initialised(lr_aerodynamics_init);
    for (double& r : loads.roll_damping) r = damping;
    lr_rigid_desc d = initialised(lr_rigid_desc_init);
    d.mass = 1e-3, d.volume = volume;
    for (size_t i = 0; i < 3; ++i) d.inertia[i * 4] = inertia, d.extents[i] = 0.01;
    d.fluid_density = density, d.fluid_viscosity = 1e-6;
    d.aerodynamics = &loads;
    lr_asset* raw = nullptr;
    REQUIRE(lr_asset_create_rigid(&d, &raw) == LR_OK);
    const Asset asset(raw);
    lr_world_desc wd = world_desc();
    for (float& g : wd.gravity) g = 0.0f;
    const World world = make(wd);
    lr_batch_desc bd = batch_desc();
    bd.integrator = integrator;
    const lr_batch batch = add_batch(world, bd, asset, 1, full);
    lr_body_desc b = body_desc();
    const float direction[3] = {1.0f / 6.0f, 1.0f / 3.0f, -1.0f / 3.0f};
    for (size_t i = 0; i < 3; ++i) b.linear_velocity[i] = direction[i], b.angular_velocity[i] = spin[i];
    const lr_body body = add_body(world, batch, b);
    const int count = 100;
    steps(world, count, narrow(seconds / count), 1);
    return state_of(world, body);
}

struct Scheme {
    int32_t integrator;
    bool full;
};
constexpr Scheme schemes[] = {{LR_INTEGRATOR_SPLITTING, false},
                              {LR_INTEGRATOR_SPLITTING, true},
                              {LR_INTEGRATOR_RK4, false},
                              {LR_INTEGRATOR_RK4, true}};

} // namespace

TEST_CASE("roll damping: spin about the stream decays exponentially, spin across it not at all") {
    // w' = -rho r s w/I
    const double rate = density * damping * 0.5 / inertia, seconds = 0.02;
    const float along[3] = {3.0f, 6.0f, -6.0f}, across[3] = {6.0f, 0.0f, 3.0f};
    for (const Scheme& scheme : schemes) {
        CAPTURE(scheme.integrator);
        CAPTURE(scheme.full);
        const lr_body_state rolling = driven(scheme.integrator, scheme.full, along, seconds);
        for (size_t i = 0; i < 3; ++i)
            CHECK(wide(rolling.angular_velocity[i]) ==
                  doctest::Approx(wide(along[i]) * std::exp(-rate * seconds)).epsilon(1e-4));
        const lr_body_state pitching = driven(scheme.integrator, scheme.full, across, seconds);
        for (size_t i = 0; i < 3; ++i)
            CHECK(wide(pitching.angular_velocity[i]) == doctest::Approx(wide(across[i])).epsilon(1e-4));
    }
}

TEST_CASE("roll damping: holds a tumbling disc in its plane, which it leaves without") {
    // I* = pi rho_s t/(64 rho_f d) = 0.09 in a liquid, Re of some thousands, noise off.
    const double radius = 0.01, thick = 2e-4, star = 0.09;
    lr_ellipsoid_desc e = initialised(lr_ellipsoid_desc_init);
    e.semi_axes[0] = e.semi_axes[1] = radius, e.semi_axes[2] = 0.5 * thick;
    e.fluid_density = density, e.fluid_viscosity = 1e-5;
    e.density = star * 64.0 * density * 2.0 * radius / (pi * thick) * 1.5; // its mean thickness is 2/3 of the largest
    lr_asset* raw = nullptr;
    REQUIRE(lr_asset_create_ellipsoid(&e, &raw) == LR_OK);
    const Asset asset(raw);
    const double second_moment = pi / 4.0 * std::pow(radius, 4);
    const auto off_plane = [&](double coefficient) {
        const World world = make(world_desc());
        const lr_batch batch = add_batch(world, batch_desc(), asset, 1);
        lr_aerodynamics a = initialised(lr_aerodynamics_init);
        REQUIRE(lr_batch_get_aerodynamics(world.get(), batch, &a) == LR_OK);
        a.roll_damping[0] = a.roll_damping[1] = coefficient * second_moment;
        a.intensity = 0.0;
        REQUIRE(lr_batch_set_aerodynamics(world.get(), batch, &a) == LR_OK);
        lr_body_desc b = body_desc();
        // On edge, spinning about the horizontal x, its normal a hundredth off the plane of the fall.
        b.orientation[1] = 0.005f, b.orientation[3] = 1.0f;
        b.linear_velocity[1] = -1.0f;
        b.angular_velocity[0] = 100.0f;
        const lr_body body = add_body(world, batch, b);
        double most = 0.0, turns = 0.0;
        for (int i = 0; i < 2000; ++i) {
            steps(world, 1, 1e-3f, 1);
            const lr_body_state s = state_of(world, body);
            turns += wide(s.angular_velocity[0]) * 1e-3 / (2.0 * pi);
            const double x = wide(s.orientation[0]), y = wide(s.orientation[1]), z = wide(s.orientation[2]),
                         w = wide(s.orientation[3]);
            if (i > 1000) most = std::max(most, std::abs(2.0 * (x * z + w * y))); // x of the normal
        }
        CHECK(std::abs(turns) > 2.0);
        return most;
    };
    CHECK(off_plane(1.5) < 0.1);
    CHECK(off_plane(0.0) > 0.5);
}
