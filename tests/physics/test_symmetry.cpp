// Invariance: a moving frame, the direction of up, the unit of length.
#include "support/random.h"
#include "support/scene.h"
#include "support/vector.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

using namespace test;

namespace {

constexpr int32_t integrators[] = {LR_INTEGRATOR_RK4, LR_INTEGRATOR_DEFAULT};

struct Run {
    std::vector<lr_body_state> states;
};

// `count` random bodies, changed by `change` before their creation, for `frames` of dt.
Run run(const World& world, const lr_batch_desc& desc, const Asset& asset, int frames, float dt, uint32_t substeps,
        const std::function<void(lr_body_desc&)>& change = {},
        const std::function<void(const World&, lr_batch)>& prepare = {}, bool full = false) {
    const lr_batch batch = add_batch(world, desc, asset, 20, full);
    if (prepare) prepare(world, batch);
    Random random(31);
    std::vector<lr_body> ids;
    for (int i = 0; i < 20; ++i) {
        lr_body_desc d = turned_anyhow(random);
        // Of few bits, so that sums with a wind are exact.
        for (float& v : d.linear_velocity) v = static_cast<float>(static_cast<int>(random.below(64)) - 32) / 64.0f;
        for (float& w : d.angular_velocity) w = random.real(-5.0, 5.0);
        d.noise_seed = static_cast<uint32_t>(i) + 100;
        if (change) change(d);
        ids.push_back(add_body(world, batch, d));
    }
    steps(world, frames, dt, substeps);
    Run out;
    for (lr_body id : ids) out.states.push_back(state_of(world, id));
    return out;
}

Asset sheet() {
    return make(ellipsoid(0.04, 0.02, 0.001, 200.0));
}
Asset keel() {
    lr_ellipsoid_desc d = ellipsoid(0.03, 0.02, 0.004, 300.0);
    d.center_of_mass[0] = 0.004, d.center_of_mass[2] = -0.001;
    return make(d);
}

double apart(const float a[3], const float b[3], double unit) {
    return length(vec(a) - vec(b)) / unit;
}

} // namespace

// The two runs differ by the rounding of velocities of about 5 m/s, 3e-7 m/s per frame, and by its growth in turbulent tumbling
// over 0.4 s: a factor of some hundred, which quasi-steady lift reaches in 0.3 s.
TEST_CASE("a body in a uniform wind is the body in still air, carried along") {
    const Vec wind = {3.0, -1.0, 2.5};
    for (const Asset& asset : {sheet(), keel()})
        for (int32_t integrator : integrators)
            for (int32_t clock : {LR_CLOCK_SPEED, LR_CLOCK_AGE})
                for (int32_t loads : {LR_LOADS_LANGEVIN, LR_LOADS_AERODYNAMIC}) {
                    lr_world_desc wd = world_desc();
                    wd.seed = 4;
                    lr_batch_desc bd = batch_desc();
                    bd.load_model = loads;
                    bd.integrator = integrator;
                    bd.clock = clock;
                    const World still = make(wd), windy = make(wd);
                    set_wind(windy, narrow(wind[0]), narrow(wind[1]), narrow(wind[2]));
                    const int frames = loads == LR_LOADS_AERODYNAMIC ? 30 : 40;
                    const Run a = run(still, bd, asset, frames, 0.01f, 8);
                    const Run b = run(windy, bd, asset, frames, 0.01f, 8, [&](lr_body_desc& d) {
                        for (size_t i = 0; i < 3; ++i) d.linear_velocity[i] += narrow(wind[i]);
                    });
                    const double t = info_of(windy).time;
                    CAPTURE(integrator);
                    CAPTURE(clock);
                    double moved = 0.0, worst = 0.0;
                    for (size_t i = 0; i < a.states.size(); ++i) {
                        const Vec x = vec(b.states[i].position) - t * wind, v = vec(b.states[i].linear_velocity) - wind;
                        worst = std::max({worst, length(x - vec(a.states[i].position)) / 0.1,
                                          length(v - vec(a.states[i].linear_velocity)) / 1.0,
                                          apart(a.states[i].angular_velocity, b.states[i].angular_velocity, 30.0)});
                        moved = std::max(moved, length(vec(a.states[i].position)));
                    }
                    CHECK(moved > 0.1);
                    CHECK(worst < 5e-3);
                }
}

TEST_CASE("wind that changes acts from the next step, and bodies keep their world velocity") {
    const Asset asset = sheet();
    const World world = weightless();
    lr_batch_desc d = batch_desc();
    d.noise_gain = 0.0f;
    const lr_batch batch = add_batch(world, d, asset, 1);
    const lr_body id = add_body(world, batch, body_desc());
    steps(world, 10, 0.01f);
    CHECK(length(vec(state_of(world, id).linear_velocity)) == 0.0);
    set_wind(world, 2.0f, 0.0f, 0.0f);
    CHECK(length(vec(state_of(world, id).linear_velocity)) == 0.0);
    steps(world, 3000, 0.01f, 2);
    // A free body in a wind ends up with the wind's velocity: drag is relative to the fluid. Edge on it takes long.
    CHECK(wide(state_of(world, id).linear_velocity[0]) == doctest::Approx(2.0).epsilon(0.2));
    const float before = state_of(world, id).linear_velocity[0];
    set_wind(world, 0.0f, 0.0f, 0.0f);
    CHECK(state_of(world, id).linear_velocity[0] == before);
    steps(world, 3000, 0.01f, 2);
    CHECK(std::abs(state_of(world, id).linear_velocity[0]) < 0.4f);
}

// Lengths, speeds and gravity by L at the same time step: all dimensionless numbers are the same, and for L a power of two
// so is every rounding.
TEST_CASE("twice as large in twice the gravity is twice the motion, to the last bit") {
    for (const Asset& asset : {sheet(), keel()})
        for (int32_t integrator : integrators)
            for (int32_t loads : {LR_LOADS_LANGEVIN, LR_LOADS_NONE, LR_LOADS_AERODYNAMIC}) {
                lr_world_desc wd = world_desc();
                wd.seed = 8;
                lr_batch_desc bd = batch_desc();
                bd.integrator = integrator;
                bd.load_model = loads;
                wd.fluid_viscosity = 1.5e-5f;
                const World small = make(wd);
                // Also of the viscosity, which scales with length times speed.
                for (float& g : wd.gravity) g *= 4.0f;
                wd.fluid_viscosity *= 16.0f;
                const World large = make(wd);
                set_wind(small, 1.0f, 0.0f, -0.5f);
                set_wind(large, 4.0f, 0.0f, -2.0f);
                const Run a = run(small, bd, asset, 60, 0.01f, 4);
                const Run b = run(large, bd, asset, 60, 0.01f, 4, [](lr_body_desc& d) {
                    d.scale = 4.0f;
                    for (float& v : d.linear_velocity) v *= 4.0f;
                });
                CAPTURE(integrator);
                CAPTURE(loads);
                for (size_t i = 0; i < a.states.size(); ++i)
                    for (size_t k = 0; k < 3; ++k) {
                        CHECK(b.states[i].position[k] == 4.0f * a.states[i].position[k]);
                        // Stored in the body frame: the world's value has one more rounding, of the same bits.
                        CHECK(b.states[i].linear_velocity[k] == 4.0f * a.states[i].linear_velocity[k]);
                        CHECK(b.states[i].angular_velocity[k] == a.states[i].angular_velocity[k]);
                        CHECK(b.states[i].orientation[k] == a.states[i].orientation[k]);
                    }
            }
}

// Time by 4: speeds and spins by 1/4, gravity by 1/16. sqrt(h) of the noise is exact too.
TEST_CASE("four times slower in a sixteenth of the gravity is the same path, to the last bit") {
    const Asset asset = keel();
    for (int32_t integrator : integrators) {
        lr_world_desc wd = world_desc();
        wd.seed = 8;
        // Viscosity has its own time scale: AERODYNAMIC loads do not scale this way.
        lr_batch_desc bd = langevin();
        bd.integrator = integrator;
        const World quick = make(wd);
        for (float& g : wd.gravity) g /= 16.0f;
        const World slow = make(wd);
        const Run a = run(quick, bd, asset, 60, 1.0f / 128.0f, 4);
        const Run b = run(slow, bd, asset, 60, 4.0f / 128.0f, 4, [](lr_body_desc& d) {
            for (float& v : d.linear_velocity) v /= 4.0f;
            for (float& w : d.angular_velocity) w /= 4.0f;
        });
        CAPTURE(integrator);
        for (size_t i = 0; i < a.states.size(); ++i)
            for (size_t k = 0; k < 3; ++k) {
                CHECK(b.states[i].position[k] == a.states[i].position[k]);
                CHECK(4.0f * b.states[i].linear_velocity[k] == a.states[i].linear_velocity[k]);
                CHECK(b.states[i].orientation[k] == a.states[i].orientation[k]);
            }
    }
}

TEST_CASE("a body of scale s moves as the asset with axes s times as long") {
    for (double s : {2.0, 1.5, 0.3})
        for (int32_t integrator : integrators)
            for (double offset : {0.0, 0.004}) {
                lr_ellipsoid_desc shape = ellipsoid(0.03, 0.02, 0.004, 300.0);
                shape.center_of_mass[0] = offset;
                const Asset small = make(shape);
                for (double& a : shape.semi_axes) a *= s;
                for (double& c : shape.center_of_mass) c *= s;
                const Asset large = make(shape);
                lr_world_desc wd = world_desc();
                wd.seed = 3;
                const World one = make(wd), other = make(wd);
                lr_batch_desc bd = batch_desc();
                bd.integrator = integrator;
                // The same chi* and epsilon* for both: the length of the table grows with the body.
                const Run a = run(
                    one, bd, small, 25, 0.01f, 8, [&](lr_body_desc& d) { d.scale = narrow(s); },
                    [&](const World& w, lr_batch b) { set_constant_table(w, b, 3.0, 0.2, 2.0, 1.0, 0.02); });
                const Run b = run(other, bd, large, 25, 0.01f, 8, {}, [&](const World& w, lr_batch batch) {
                    set_constant_table(w, batch, 3.0 / s, 0.2 / s, 2.0, 1.0, 0.02 * s);
                });
                CAPTURE(s);
                CAPTURE(integrator);
                for (size_t i = 0; i < a.states.size(); ++i) {
                    // Powers of two change no bit; other factors round constants once, and tumbling amplifies this.
                    const double bound = s == 2.0 ? 0.0 : 5e-3;
                    CHECK(apart(a.states[i].position, b.states[i].position, 0.1) <= bound);
                    CHECK(apart(a.states[i].linear_velocity, b.states[i].linear_velocity, 1.0) <= bound);
                    CHECK(apart(a.states[i].angular_velocity, b.states[i].angular_velocity, 30.0) <= bound);
                }
            }
}

TEST_CASE("no axis of the world is special") {
    const Asset asset = keel();
    // The rotation of x to y, y to z, z to x, and a rotation that maps no axis to another. The wake's own velocity is drawn in the
    // world's frame: it is off.
    lr_load_gains calm = initialised(lr_load_gains_init);
    calm.turbulence = 0.0f;
    const auto without_wake = [&](const World& w, lr_batch b) {
        REQUIRE(lr_batch_set_load_gains(w.get(), b, &calm) == LR_OK);
    };
    for (const Quat& turn : {Quat{0.5, 0.5, 0.5, 0.5}, normalised(Quat{0.3, -0.4, 0.6, 0.5})})
        for (int32_t loads : {LR_LOADS_LANGEVIN, LR_LOADS_AERODYNAMIC})
            for (int32_t integrator : integrators) {
                lr_world_desc wd = world_desc();
                wd.seed = 5;
                lr_batch_desc bd = batch_desc();
                bd.integrator = integrator;
                bd.load_model = loads;
                const World upright = make(wd);
                const Vec gravity = to_world(turn, vec(wd.gravity)), wind = to_world(turn, {0.5, 0.25, -1.0});
                for (size_t i = 0; i < 3; ++i) wd.gravity[i] = narrow(gravity[i]);
                const World turned = make(wd);
                set_wind(upright, 0.5f, 0.25f, -1.0f);
                set_wind(turned, narrow(wind[0]), narrow(wind[1]), narrow(wind[2]));
                const Run a = run(upright, bd, asset, 25, 0.01f, 8, {}, without_wake);
                const Run b = run(
                    turned, bd, asset, 25, 0.01f, 8,
                    [&](lr_body_desc& d) {
                        const Quat q = product(turn, quat(d.orientation));
                        const Vec v = to_world(turn, vec(d.linear_velocity)),
                                  w = to_world(turn, vec(d.angular_velocity));
                        for (size_t i = 0; i < 4; ++i) d.orientation[i] = narrow(q[i]);
                        for (size_t i = 0; i < 3; ++i)
                            d.linear_velocity[i] = narrow(v[i]), d.angular_velocity[i] = narrow(w[i]);
                    },
                    without_wake);
                for (size_t i = 0; i < a.states.size(); ++i) {
                    const Vec x = to_world(turn, vec(a.states[i].position)),
                              v = to_world(turn, vec(a.states[i].linear_velocity));
                    CHECK(length(x - vec(b.states[i].position)) < 2e-4);
                    CHECK(length(v - vec(b.states[i].linear_velocity)) < 2e-3);
                }
            }
}

TEST_CASE("the full path of a diagonal body is its diagonal path") {
    const Asset asset = sheet();
    for (int32_t integrator : integrators) {
        lr_batch_desc bd = batch_desc();
        bd.integrator = integrator;
        const World one = make(world_desc()), other = make(world_desc());
        const Run a = run(one, bd, asset, 20, 0.01f, 8);
        const Run b = run(other, bd, asset, 20, 0.01f, 8, {}, {}, true);
        for (size_t i = 0; i < a.states.size(); ++i) {
            CHECK(apart(a.states[i].position, b.states[i].position, 0.1) < 2e-3);
            CHECK(apart(a.states[i].linear_velocity, b.states[i].linear_velocity, 1.0) < 2e-3);
            CHECK(apart(a.states[i].angular_velocity, b.states[i].angular_velocity, 30.0) < 5e-3);
        }
    }
}

// Noise of the shedding that went with that of the gusts, drawn along the world's axes, made these discs tumble 10 % more about x one way.
TEST_CASE("small discs tumble either way alike") {
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, make(ellipsoid(0.005, 0.005, 0.0001, 800.0)), 8000);
    Random random(31);
    std::vector<lr_body> ids;
    for (int i = 0; i < 8000; ++i) ids.push_back(add_body(world, batch, turned_anyhow(random)));
    std::vector<Vec> sums(ids.size());
    for (int sample = 0; sample < 20; ++sample) {
        steps(world, sample == 0 ? 300 : 16, 1.0f / 240.0f);
        for (size_t i = 0; i < ids.size(); ++i) {
            const lr_body_state s = state_of(world, ids[i]);
            sums[i] = sums[i] + to_body(quat(s.orientation), vec(s.angular_velocity));
        }
    }
    for (size_t k = 0; k < 2; ++k) {
        double mean = 0.0, square = 0.0;
        for (const Vec& sum : sums) mean += sum[k], square += sum[k] * sum[k];
        CHECK(std::abs(mean) < 4.0 * std::sqrt(square));
    }
}
