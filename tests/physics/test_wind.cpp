// Bodies in wind that changes in time and along their path: the force of the fluid's acceleration, added mass, shear.
#include "support/quick.h"
#include "support/random.h"
#include "support/wind.h"

#include <algorithm>
#include <cmath>
#include <functional>

using namespace test;

namespace {

constexpr double pi = 3.14159265358979323846;

// A sphere, neutrally buoyant or of another density.
Asset sphere(double density) {
    return make(in_water(ellipsoid(0.1, 0.1, 0.1, density)));
}

struct Single {
    World world;
    lr_body body{};
    Single(const Asset& asset, const lr_body_desc& at, int32_t integrator = LR_INTEGRATOR_DEFAULT,
           int32_t loads = LR_LOADS_NONE, bool heavy = false) {
        world = heavy ? make(world_desc()) : weightless();
        lr_batch_desc d = langevin();
        d.integrator = integrator;
        d.load_model = loads;
        d.noise_gain = 0.0f;
        body = add_body(world, add_batch(world, d, asset, 1), at);
    }
    Vec velocity() const { return vec(state_of(world, body).linear_velocity); }
    Vec position() const { return vec(state_of(world, body).position); }
};

// Added mass of a sphere: half the displaced fluid. The response of a free body to the fluid's acceleration.
double share(double density) {
    return 1.5 * 1000.0 / (density + 500.0);
}

constexpr int32_t integrators[] = {LR_INTEGRATOR_RK4, LR_INTEGRATOR_SPLITTING};

} // namespace

TEST_CASE("a uniform wind that changes gives a body rho (V + A)/(m + rho A) of the change") {
    for (double density : {1000.0, 200.0, 8000.0})
        for (int32_t integrator : integrators)
            for (uint32_t substeps : {1u, 5u}) {
                Single s(sphere(density), body_desc(), integrator);
                steps(s.world, 1, 0.01f, substeps);
                Vec wind{};
                for (int frame = 0; frame < 20; ++frame) {
                    wind = {1.5 * std::sin(0.3 * frame), 0.1 * frame, -2.0};
                    set_wind(s.world, narrow(wind[0]), narrow(wind[1]), narrow(wind[2]));
                    steps(s.world, 1, 0.01f, substeps);
                }
                CAPTURE(density);
                CAPTURE(integrator);
                CHECK(length(s.velocity() - share(density) * wind) < 1e-5);
            }
}

TEST_CASE("a body is carried along during the step in which the wind changes") {
    Single s(sphere(1000.0), body_desc());
    steps(s.world, 1, 0.5f, 4);
    set_wind(s.world, 2.0f, 0.0f, 0.0f);
    steps(s.world, 1, 0.5f, 4);
    CHECK(s.position()[0] == doctest::Approx(0.5)); // mean of a ramp from 0 to 2, for half a second
    steps(s.world, 1, 0.5f, 4);
    CHECK(s.position()[0] == doctest::Approx(1.5));
}

TEST_CASE("an anisotropic and a ballasted body answer a change of the wind as theory does") {
    // Momentum through the fluid: P = (m + rho A) v_r; the change of wind acts on it as (rho V - m). In still fluid without loads a
    // short step is the initial value problem.
    lr_ellipsoid_desc d = in_water(ellipsoid(0.08, 0.04, 0.02, 2500.0));
    const Asset asset = make(d);
    const lr_asset_info info = info_of(asset);
    for (size_t axis = 0; axis < 3; ++axis) {
        Single s(asset, body_desc());
        steps(s.world, 1, 1e-4f, 1);
        float wind[3] = {};
        wind[axis] = 0.5f;
        set_wind(s.world, wind[0], wind[1], wind[2]);
        steps(s.world, 1, 1e-4f, 2);
        const double displaced = 1000.0 * info.volume, added = info.added_mass[axis * 7];
        CHECK(s.velocity()[axis] == doctest::Approx(0.5 * (displaced + added) / (info.mass + added)).epsilon(1e-5));
    }
    // Centre of buoyancy above the centre of mass: the fluid's pressure rotates the body.
    d.center_of_mass[1] = -0.01;
    const Asset ballasted = make(d);
    const lr_asset_info b = info_of(ballasted);
    Single s(ballasted, body_desc());
    steps(s.world, 1, 1e-4f, 1);
    set_wind(s.world, 0.5f, 0.0f, 0.0f);
    steps(s.world, 1, 1e-4f, 2);
    // 6x6 with coupling only between vx and wz among the moving components.
    const double m11 = b.mass + b.added_mass[0], m16 = b.added_mass[5], m66 = b.inertia[8] + b.added_mass[35];
    const double displaced = 1000.0 * b.volume, force = (displaced - b.mass) * 0.5;
    const double torque = -displaced * b.center_of_buoyancy[1] * 0.5; // r_b x rho V a
    const double det = m11 * m66 - m16 * m16;
    const double v = (m66 * force - m16 * torque) / det, w = (m11 * torque - m16 * force) / det;
    CHECK(s.velocity()[0] == doctest::Approx(0.5 + v).epsilon(1e-4));
    CHECK(wide(state_of(s.world, s.body).angular_velocity[2]) == doctest::Approx(w).epsilon(1e-4));
}

TEST_CASE("the same wind again, the first wind, and setting a state kick nothing") {
    const Asset asset = sphere(1000.0);
    lr_body_desc at = body_desc();
    Single first(asset, at);
    set_wind(first.world, 3.0f, 0.0f, 0.0f); // before any step: accelerates nothing
    steps(first.world, 2, 0.01f, 2);
    CHECK(length(first.velocity()) == 0.0);
    set_wind(first.world, 3.0f, 0.0f, 0.0f);
    lr_body_state state = state_of(first.world, first.body);
    set(state.linear_velocity, 1.0f, 2.0f, 3.0f);
    REQUIRE(lr_body_set_state(first.world.get(), first.body, &state) == LR_OK);
    steps(first.world, 2, 0.01f, 2);
    CHECK(length(first.velocity() - Vec{1.0, 2.0, 3.0}) < 1e-6);

    // Bit for bit, also with loads and noise.
    const Asset paper = curled_leaf();
    uint64_t hashes[2];
    for (int again = 0; again < 2; ++again) {
        const World world = make(world_desc());
        set_wind(world, 1.0f, 0.0f, -2.0f);
        add_body(world, add_batch(world, paper, 1), body_desc());
        for (int frame = 0; frame < 10; ++frame) {
            if (again) set_wind(world, 1.0f, 0.0f, -2.0f);
            steps(world, 1, 1.0f / 60.0f, 3);
        }
        hashes[again] = hash_of(world);
    }
    CHECK(hashes[0] == hashes[1]);
}

TEST_CASE("a change of wind split over two worlds' substeps, and through a snapshot, is the same") {
    const Asset asset = curled_leaf();
    const World one = make(world_desc()), two = make(world_desc());
    for (const World* w : {&one, &two}) add_batch(*w, asset, 4);
    const lr_batch batch = add_batch(one, asset, 4);
    add_batch(two, asset, 4);
    add_body(one, batch, body_desc());
    steps(one, 5, 0.01f, 2);
    set_wind(one, 4.0f, 1.0f, 0.0f);
    const std::vector<unsigned char> snapshot = snapshot_of(one); // with the pending change
    REQUIRE(lr_world_snapshot_restore(two.get(), snapshot.data(), snapshot.size()) == LR_OK);
    for (const World* w : {&one, &two}) steps(*w, 2, 0.01f, 2);
    CHECK(hash_of(one) == hash_of(two));
}

TEST_CASE("gusts carry a neutrally buoyant sphere along exactly, a heavy one by its share") {
    for (double density : {1000.0, 5000.0})
        for (int32_t integrator : integrators)
            for (float dt : {0.02f, 0.05f}) {
                Single s(sphere(density), body_desc(), integrator);
                lr_gusts_desc d = initialised(lr_gusts_desc_init);
                d.integral_time = 0.5f, d.angle_rms = 0.5f;
                add_source(s.world, d);
                const Vec before = wind_at(s.world, {0.0, 0.0, 0.0});
                steps(s.world, 100, dt, 3);
                const Vec change = wind_at(s.world, {0.0, 0.0, 0.0}) - before;
                CAPTURE(density);
                CHECK(length(change) > 0.1);
                CHECK(length(s.velocity() - share(density) * change) < 2e-5);
            }
}

TEST_CASE("a tracer follows the fluid of a vortex with second order") {
    // Without damping: only the pressure of the curved flow keeps it on its circle.
    const double radius = 0.8, core = 0.5, circulation = 3.0;
    const double speed = circulation / (2.0 * pi * radius) * (1.0 - std::exp(-radius * radius / core / core));
    double errors[3];
    for (size_t n = 0; n < 3; ++n) {
        lr_body_desc at = body_desc();
        at.position[0] = narrow(radius);
        at.linear_velocity[1] = narrow(speed);
        Single s(sphere(1000.0), at);
        lr_vortex_desc d = vortex_desc();
        set(d.axis, 0.0f, 0.0f, 1.0f);
        d.circulation = narrow(circulation), d.core_radius = narrow(core);
        add_source(s.world, d);
        const int count = 25 << n;
        steps(s.world, count, 1.0f / static_cast<float>(count), 1);
        const double angle = speed / radius;
        errors[n] = length(s.position() - radius * Vec{std::cos(angle), std::sin(angle), 0.0});
    }
    CHECK(errors[0] < 2e-3);
    CHECK(errors[0] / errors[1] == doctest::Approx(4.0).epsilon(0.15));
    CHECK(errors[1] / errors[2] == doctest::Approx(4.0).epsilon(0.2));
}

// A wind callback: a fluid in solid rotation, ever faster.
TEST_CASE("a callback's gradient and rate carry a tracer along as a source's do") {
    const auto turning = [](void*, const lr_wind_query* q) {
        const auto spin = static_cast<float>(1.0 + q->time);
        for (uint32_t i = 0; i < q->count; ++i) {
            const float x = q->position[0][i], y = q->position[1][i];
            q->velocity[0][i] = -spin * y, q->velocity[1][i] = spin * x;
            q->rate[0][i] = -y, q->rate[1][i] = x;
            q->gradient[1][i] = -spin, q->gradient[3][i] = spin;
        }
    };
    double errors[2];
    for (size_t n = 0; n < 2; ++n) {
        lr_body_desc at = body_desc();
        at.position[0] = at.linear_velocity[1] = 0.5f;
        Single s(sphere(1000.0), at);
        REQUIRE(lr_world_set_wind_callback(s.world.get(), turning, nullptr) == LR_OK);
        const int count = 50 << n;
        steps(s.world, count, 1.0f / static_cast<float>(count), 1);
        errors[n] = length(s.position() - 0.5 * Vec{std::cos(1.5), std::sin(1.5), 0.0});
    }
    CHECK(errors[0] < 1e-3);
    CHECK(errors[0] / errors[1] > 3.0);
}

TEST_CASE("a sphere in a vortex is thrown out when heavy and drawn in when light") {
    for (double density : {300.0, 4000.0}) {
        lr_body_desc at = body_desc();
        at.position[0] = 0.5f, at.linear_velocity[1] = 0.5f;
        Single s(sphere(density), at, LR_INTEGRATOR_DEFAULT, LR_LOADS_LANGEVIN);
        lr_vortex_desc d = vortex_desc(LR_VORTEX_RANKINE);
        set(d.axis, 0.0f, 0.0f, 1.0f);
        d.circulation = narrow(2.0 * pi), d.core_radius = 1.0f; // a turn of 1 rad/s
        add_source(s.world, d);
        steps(s.world, 80, 0.01f, 2);
        const double r = length(s.position());
        if (density < 1000.0)
            CHECK(r < 0.49);
        else
            CHECK(r > 0.51);
    }
}

TEST_CASE("a body in the middle of a fluid that turns as a solid ends up turning with it") {
    for (int32_t integrator : integrators)
        for (bool full : {false, true}) {
            const World world = weightless();
            lr_batch_desc bd = langevin();
            bd.integrator = integrator;
            bd.clock = LR_CLOCK_AGE;
            const Asset asset = make(in_water(ellipsoid(0.03, 0.02, 0.01, 1000.0)));
            const lr_batch batch = add_batch(world, bd, asset, 1, full);
            set_constant_table(world, batch, 20.0, 0.0, 2.0); // damping that does not depend on speed, no noise
            lr_body_desc at = body_desc();
            set(at.angular_velocity, 0.0f, 0.0f, 1.0f);
            const lr_body body = add_body(world, batch, at);
            lr_vortex_desc d = vortex_desc(LR_VORTEX_RANKINE);
            set(d.axis, 0.0f, 0.0f, 1.0f);
            d.circulation = narrow(2.0 * pi * 3.0), d.core_radius = 1.0f;
            add_source(world, d);
            // The rate of its approach is alpha rho D'/(J0 + rho D): docs/maintainers/physics.md section 4.
            const lr_asset_info info = info_of(asset);
            const double alpha = (0.5 + 0.75 * 2.0) * 20.0, added = info.added_mass[35];
            const double floor = 0.02 * (1000.0 * info.volume + info.added_mass[14]) * info.inertia[8] / info.mass;
            const double rate = alpha * (added + floor) / (info.inertia[8] + added);
            double time = 0.0;
            for (int i = 0; i < 3; ++i) {
                steps(world, 20, 0.005f, 1);
                time += 0.1;
                const double spin = wide(state_of(world, body).angular_velocity[2]);
                CHECK(spin == doctest::Approx(3.0 - 2.0 * std::exp(-rate * time)).epsilon(2e-4));
            }
            CHECK(rate * time > 0.5);
        }
}

TEST_CASE("a uniform wind as sources, as itself and none, moved along, are one motion to 1e-5") {
    const Asset assets[] = {leaf(), curled_leaf()};
    for (const Asset& asset : assets) {
        const auto run = [&](int how) {
            const World world = make(world_desc());
            lr_batch_desc bd = langevin();
            bd.noise_gain = 0.0f;
            const lr_batch batch = add_batch(world, bd, asset, 20);
            std::vector<lr_body> ids;
            std::vector<float> samples = {2.0f, -0.5f, 1.0f};
            for (uint32_t i = 0; i < 20; ++i) {
                Random random(i);
                lr_body_desc d = turned_anyhow(random);
                if (how > 0)
                    for (size_t k = 0; k < 3; ++k) d.linear_velocity[k] = samples[k];
                ids.push_back(add_body(world, batch, d));
            }
            if (how == 1) set_wind(world, 2.0f, -0.5f, 1.0f);
            if (how == 2) {
                lr_wind_grid_desc d = initialised(lr_wind_grid_desc_init);
                for (uint32_t& n : d.counts) n = 1;
                d.outside = LR_WIND_OUTSIDE_CLAMP;
                d.samples = samples.data();
                add_source(world, d);
            }
            steps(world, 20, 0.01f, 4);
            std::vector<Vec> out;
            for (lr_body id : ids) {
                const lr_body_state s = state_of(world, id);
                const double t = how > 0 ? 0.2 : 0.0;
                out.push_back(vec(s.position) - t * Vec{2.0, -0.5, 1.0});
                out.push_back(0.1 * (vec(s.linear_velocity) - t / 0.2 * Vec{2.0, -0.5, 1.0}));
            }
            return out;
        };
        const std::vector<Vec> still = run(0), uniform = run(1), grid = run(2);
        double worst = 0.0;
        for (size_t i = 0; i < still.size(); ++i)
            worst = std::max({worst, length(uniform[i] - still[i]), length(grid[i] - still[i])});
        CHECK(worst < 1e-5);
    }
}

TEST_CASE("bodies stay finite in any wind at any step, and no faster than the wind and their fall give") {
    const std::vector<float> samples = grid_samples();
    Random random(12);
    const int rounds = quick() ? 4 : 60;
    for (int round = 0; round < rounds; ++round) {
        const World world = make(world_desc());
        lr_batch_desc bd = langevin();
        bd.load_model = LR_LOADS_LANGEVIN;
        const Asset asset = round % 3 == 0 ? make(ellipsoid(0.002, 0.001, 5e-5, 700.0))
                                           : (round % 3 == 1 ? curled_leaf() : sphere(1000.1));
        const lr_batch batch = add_batch(world, bd, asset, 64);
        double fastest = 60.0;
        for (AnySource any : one_of_each(samples)) {
            const float factor = narrow(random.logarithmic(0.1, 30.0)), part = narrow(random.logarithmic(0.01, 1.0));
            const auto shrink = [&](float& size) { size = std::max(size * part, 1e-3f); };
            std::visit(
                [&](auto& d) {
                    fastest += 5.0;
                    if constexpr (requires { d.rms; }) fastest += 5.0 * wide(d.rms *= factor);
                    if constexpr (requires { d.integral_length; }) shrink(d.integral_length);
                    if constexpr (requires { d.roughness_length; }) shrink(d.roughness_length);
                    if constexpr (requires { d.nozzle_radius; }) {
                        shrink(d.nozzle_radius);
                        fastest += 5.0 * wide(d.speed *= factor);
                    }
                    if constexpr (requires { d.circulation; }) {
                        shrink(d.core_radius);
                        d.circulation *= factor;
                        if (std::abs(d.circulation) > 1000.0f * d.core_radius) d.circulation = 1000.0f * d.core_radius;
                        fastest += std::abs(wide(d.circulation) / (2.0 * pi * wide(d.core_radius)));
                    }
                },
                any);
            add_source(world, any);
        }
        std::vector<lr_body> ids;
        for (int i = 0; i < 64; ++i) {
            ids.push_back(add_body(world, batch, strewn(random, 2.0)));
        }
        const float dt = narrow(random.logarithmic(0.002, 0.1));
        CAPTURE(round);
        for (int frame = 0; frame < 60; ++frame) {
            set_wind(world, random.real(-20.0, 20.0), random.real(-20.0, 20.0), 0.0f);
            steps(world, 1, dt, 1 + random.below(3));
        }
        steps(world, 1, 1e-40f, 1); // 1/h overflows
        steps(world, 1, dt, 1);
        double worst = 0.0;
        bool finite = true;
        for (lr_body id : ids) {
            const lr_body_state s = state_of(world, id);
            for (size_t k = 0; k < 3; ++k) finite = finite && std::isfinite(s.position[k] + s.angular_velocity[k]);
            worst = std::max(worst, length(vec(s.linear_velocity)));
        }
        CHECK(finite);
        CHECK(worst < 4.0 * fastest);
    }
}

TEST_CASE("eddies much smaller than a leaf do not drive it faster than themselves") {
    for (int32_t loads : {LR_LOADS_LANGEVIN, LR_LOADS_AERODYNAMIC}) {
        const World world = make(world_desc());
        lr_batch_desc bd = langevin();
        bd.load_model = loads;
        const lr_batch batch = add_batch(world, bd, leaf(), 64);
        lr_turbulence_desc d = initialised(lr_turbulence_desc_init);
        d.rms = 1.0f, d.integral_length = 1e-4f;
        add_source(world, d);
        const float low[3] = {-1.0f, -1.0f, -1.0f}, high[3] = {1.0f, 1.0f, 1.0f};
        std::vector<lr_body> ids(64);
        REQUIRE(lr_batch_spawn_box(world.get(), batch, low, high, 64, ids.data()) == LR_OK);
        double squares = 0.0;
        for (int frame = 0; frame < 60; ++frame) {
            steps(world, 1, 1.0f / 60.0f, 2);
            for (lr_body id : ids) squares += std::pow(length(vec(state_of(world, id).linear_velocity)), 2.0);
        }
        CAPTURE(loads);
        CHECK(std::sqrt(squares / (60.0 * 64.0)) < 3.0); // it falls at 1 m/s
    }
}
