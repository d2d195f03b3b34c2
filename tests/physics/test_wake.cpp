// Closed forms of a plate and its wake: the normal force, the drag while the wake is made, its memory, and vortex shedding.
#include "support/scene.h"
#include "support/vector.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

using namespace test;
using std::numbers::pi;

namespace {

struct Path {
    int32_t integrator;
    bool full;
};
constexpr Path paths[] = {{LR_INTEGRATOR_DEFAULT, false},
                          {LR_INTEGRATOR_DEFAULT, true},
                          {LR_INTEGRATOR_RK4, false},
                          {LR_INTEGRATOR_RK4, true}};

// A plate across the axis `normal` in a fluid of density 1. Its area is 1 m^2, so that coefficients are areas.
constexpr double mass = 100.0, inertia = 2.0;
lr_aerodynamics plate_across(size_t normal) {
    lr_aerodynamics a = initialised(lr_aerodynamics_init);
    a.broadside[normal] = 1.0;
    for (double& s : a.plate_stall) s = 0.25;
    return a;
}
Asset heavy(const lr_aerodynamics& loads, double viscosity = 1e-5) {
    lr_rigid_desc d = initialised(lr_rigid_desc_init);
    d.mass = mass, d.volume = 1e-2;
    for (size_t i = 0; i < 3; ++i) d.inertia[i * 4] = inertia, d.extents[i] = 1.0;
    d.fluid_density = 1.0, d.fluid_viscosity = viscosity;
    d.aerodynamics = &loads;
    return make(d);
}

// One body that moves at `velocity` without weight.
struct Flight {
    World world = weightless();
    lr_batch batch{};
    lr_body body{};

    Flight(const Asset& asset, Path path, Vec velocity, Vec spin = {}) {
        lr_batch_desc d = batch_desc();
        d.load_model = LR_LOADS_AERODYNAMIC;
        d.integrator = path.integrator;
        batch = add_batch(world, d, asset, 1, path.full);
        lr_body_desc b = body_desc();
        for (size_t k = 0; k < 3; ++k)
            b.linear_velocity[k] = narrow(velocity[k]), b.angular_velocity[k] = narrow(spin[k]);
        body = add_body(world, batch, b);
    }
    // The fluctuations of a second; then none.
    void begin_shedding(double h) const {
        steps(world, static_cast<int>(std::lround(1.0 / h)), narrow(h));
        lr_load_gains gains = initialised(lr_load_gains_init);
        gains.turbulence = 0.0f;
        REQUIRE(lr_batch_set_load_gains(world.get(), batch, &gains) == LR_OK);
    }
    Vec velocity() const { return vec(state_of(world, body).linear_velocity); }
    Vec spin() const { return vec(state_of(world, body).angular_velocity); }
};

} // namespace

// Plate and creeping flow: C_D = plate_drag/S + 64/(pi Re).
TEST_CASE("wake: a thin disc falls broadside at the speed of its drag coefficients") {
    const double radius = 0.05, thick = 1e-5, area = pi * radius * radius;
    for (const double viscosity : {1e-6, 1.5e-5, 1e-3, 0.05})
        for (const Path& path : paths) {
            lr_ellipsoid_desc shape = ellipsoid(radius, radius, 0.5 * thick, 2000.0);
            shape.fluid_viscosity = viscosity;
            const Asset asset = make(shape);
            const lr_asset_info info = info_of(asset);
            lr_world_desc wd = world_desc();
            wd.gravity[1] = 0.0f, wd.gravity[2] = -9.81f;
            const World world = make(wd);
            lr_batch_desc bd = batch_desc();
            bd.load_model = LR_LOADS_AERODYNAMIC, bd.integrator = path.integrator;
            const lr_batch batch = add_batch(world, bd, asset, 1, path.full);
            lr_aerodynamics a = initialised(lr_aerodynamics_init);
            REQUIRE(lr_batch_get_aerodynamics(world.get(), batch, &a) == LR_OK);
            a.shedding_moment = a.shedding_rate_moment = a.intensity = a.plate_separated_shedding = 0.0;
            REQUIRE(lr_batch_set_aerodynamics(world.get(), batch, &a) == LR_OK);
            const double weight = (info.mass - info.fluid_density * info.volume) * 9.81;
            double speed = 1.0;
            for (int i = 0; i < 200; ++i) {
                const double reynolds = speed * 2.0 * radius / viscosity;
                const double drag = a.plate_drag / area + 64.0 / (pi * reynolds);
                speed = std::sqrt(0.5 * (speed * speed + weight / (0.5 * info.fluid_density * area * drag)));
            }
            lr_body_desc desc = body_desc();
            desc.linear_velocity[2] = narrow(-0.9 * speed);
            const lr_body body = add_body(world, batch, desc);
            steps(world, 1200, 5e-3f); // not long enough for rounding to grow into flutter
            CAPTURE(viscosity);
            CAPTURE(path.integrator);
            CAPTURE(path.full);
            CHECK(-wide(state_of(world, body).linear_velocity[2]) == doctest::Approx(speed).epsilon(3e-3));
        }
}

// v' = g' - c (v^2 + k |v - u| (v - u)), u' = s (v - u)/(lag length): the drag of a wake that is being made.
TEST_CASE("wake: from rest a plate falls as its starting drag and the wake's memory say" *
          doctest::test_suite("exact")) {
    const double k = 3.0, lag = 10.0, length = 0.5, drag = 10.0;
    lr_aerodynamics a = plate_across(2);
    a.plate_drag = drag, a.start_drag = k, a.wake_lag = lag, a.wake_length = length;
    a.wake_share = 0.5;                           // of the attached flow, which there is none of
    for (const double critical : {0.0, 5e4, 1e9}) // Reynolds number; below it the wake is closed
        for (const double scale : {1.0, 0.5})
            for (const Path& path : paths)
                for (const double h : {1e-3, 1e-2}) {
                    a.shedding_reynolds = critical;
                    const Asset asset = heavy(a);
                    lr_world_desc wd = world_desc();
                    wd.gravity[1] = 0.0f, wd.gravity[2] = -9.81f;
                    const World world = make(wd);
                    lr_batch_desc d = batch_desc();
                    d.load_model = LR_LOADS_AERODYNAMIC, d.integrator = path.integrator;
                    const lr_batch batch = add_batch(world, d, asset, 1, path.full);
                    lr_body_desc b = body_desc();
                    b.scale = narrow(scale);
                    const lr_body body = add_body(world, batch, b);
                    const double weight = 9.81 * (1.0 - 1e-2 / mass), per_mass = 0.5 * drag / (mass * scale);
                    double v = 0.0, u = 0.0, x = 0.0, plain = 0.0, apart = 0.0, worst = 0.0;
                    const auto rates = [&](double at, double wake, double& acceleration, double& follows) {
                        acceleration = weight - per_mass * (at * at + k * std::abs(at - wake) * (at - wake));
                        const double onset = critical * 1e-5 / (std::max(at, 1e-10) * length * scale);
                        const double open = 1.0 - 0.6 * std::min(onset * onset, 1.0);
                        follows = open * at * (at - wake) / (lag * length * scale);
                    };
                    for (int frame = 0; frame < 40; ++frame) { // 4 s: thrice the time to the terminal speed
                        constexpr int fine = 2000;
                        const double dt = 0.1 / fine;
                        for (int i = 0; i < fine; ++i) {
                            double a1 = 0.0, u1 = 0.0, a2 = 0.0, u2 = 0.0;
                            rates(v, u, a1, u1);
                            rates(v + 0.5 * dt * a1, u + 0.5 * dt * u1, a2, u2);
                            x += dt * (v + 0.5 * dt * a1);
                            v += dt * a2, u += dt * u2;
                            plain += dt * (weight - per_mass * plain * plain);
                        }
                        steps(world, static_cast<int>(std::lround(0.1 / h)), narrow(h));
                        const lr_body_state s = state_of(world, body);
                        worst = std::max({worst, std::abs(wide(s.linear_velocity[2]) / v + 1.0),
                                          std::abs(wide(s.position[2]) / x + 1.0)});
                        apart = std::max(apart, 1.0 - v / plain);
                    }
                    CAPTURE(scale);
                    CAPTURE(path.integrator);
                    CAPTURE(path.full);
                    CAPTURE(h);
                    CHECK(worst < 40.0 * h * h + 3e-5);
                    CHECK(apart > 0.02); // the starting drag matters
                }
}

// With twice the body's moment of inertia in the fluid, y = 1/(1 + (3/2 2/3)^4) = 1/2: half of the starting drag, and of the lift of rotation about axes
// in the plate.
TEST_CASE("wake: the wake of a light plate bears less") {
    const auto fall = [](const Path& path, double fluid, double share, Vec spin) {
        lr_aerodynamics a = plate_across(2);
        a.plate_drag = 10.0, a.start_drag = 3.0 * share, a.wake_lag = 10.0, a.wake_length = 0.5;
        for (size_t i = 0; i < 2; ++i) a.spin_lift[i] = 40.0 * share;
        a.spin_lift[2] = 40.0;
        lr_rigid_desc d = initialised(lr_rigid_desc_init);
        d.mass = mass, d.volume = 1e-2;
        for (size_t i = 0; i < 3; ++i) {
            d.inertia[i * 4] = inertia / (1.0 + fluid), d.extents[i] = 1.0;
            d.added_mass[(i + 3) * 7] = inertia - d.inertia[i * 4];
        }
        d.fluid_density = 1.0, d.aerodynamics = &a;
        const Flight flight(make(d), path, {0.3, -0.2, -2.0}, spin);
        steps(flight.world, 100, 1e-2f);
        return flight.velocity();
    };
    for (const Path& path : paths)
        for (const Vec spin : {Vec{}, Vec{0.3, -0.2, 0.0}, Vec{0.0, 0.0, 0.5}}) {
            const Vec found = fall(path, 2.0, 1.0, spin);
            CAPTURE(path.integrator);
            CAPTURE(path.full);
            CHECK(length(found - fall(path, 0.0, 0.5, spin)) < 1e-5);
            if (length(spin) == 0.0) CHECK(length(found - fall(path, 0.0, 1.0, spin)) > 1e-3);
        }
}

// The oscillator turns by 2 pi f t, f = strouhal s/length. Half the square of (q, r) tends to v_n/s - (Re_c/Re)^2. Its couple is
// rho v_n^2 n x (moment q + rate_moment r).
TEST_CASE("wake: shedding turns a plate to and fro at its frequency and amplitude" * doctest::test_suite("exact")) {
    const double length = 0.2, strouhal = 0.2, growth = 0.8, critical = 100.0, reynolds = 400.0, aside = 0.02;
    const double moment = 3e-3, rate_moment = -2e-3;
    const double omega = 2.0 * pi * strouhal / length;
    const double limit = std::sqrt(1.0 - aside * aside) - std::pow(critical / reynolds, 2.0);
    const double couple = (1.0 - aside * aside) / inertia;
    for (size_t normal = 0; normal < 3; ++normal)
        for (const Path& path : paths) {
            const size_t first = (normal + 1) % 3, second = (normal + 2) % 3;
            lr_aerodynamics a = plate_across(normal);
            a.wake_length = length, a.strouhal = strouhal, a.shedding_growth = growth;
            a.shedding_reynolds = critical, a.intensity = 1e-2, a.shedding_noise = 10.0;
            a.shedding_moment = moment, a.shedding_rate_moment = rate_moment;
            const Asset asset = heavy(a, length / reynolds);
            Vec velocity{};
            velocity[normal] = std::sqrt(1.0 - aside * aside), velocity[first] = aside;
            CAPTURE(normal);
            CAPTURE(path.integrator);
            CAPTURE(path.full);

            // The limit cycle, at any step: its angle turns by 2 atan(omega h/2) in a step.
            for (const double h : {1e-3, 5e-3, 0.02, 0.05}) {
                const Flight flight(asset, path, velocity);
                flight.begin_shedding(h);
                steps(flight.world, static_cast<int>(std::lround(20.0 / h)), narrow(h));
                // Amplitude and phase in two windows of ten periods: sums against sine and cosine, without the mean. Noise divides the
                // oscillation between the two axes in the plate.
                double amplitude[2] = {}, phase[2] = {};
                const double period = 2.0 * pi / omega;
                const int window = static_cast<int>(std::lround(10.0 * period / h));
                for (int part = 0; part < 2; ++part) {
                    std::vector<Vec> w(static_cast<size_t>(window));
                    Vec mean{};
                    for (Vec& x : w) {
                        steps(flight.world, 1, narrow(h));
                        x = flight.spin(), mean = mean + 1.0 / window * x;
                    }
                    for (const size_t axis : {first, second}) {
                        double c = 0.0, s = 0.0;
                        for (int i = 0; i < window; ++i) {
                            const double t = omega * h * (i + part * window);
                            c += 2.0 / window * (w[static_cast<size_t>(i)][axis] - mean[axis]) * std::cos(t);
                            s += 2.0 / window * (w[static_cast<size_t>(i)][axis] - mean[axis]) * std::sin(t);
                        }
                        amplitude[part] = std::hypot(amplitude[part], std::hypot(c, s)), phase[part] = std::atan2(s, c);
                    }
                }
                const double expected = couple * std::sqrt(2.0 * limit) * std::hypot(moment, rate_moment) / omega;
                const double slow = std::remainder(phase[1] - phase[0], 2.0 * pi) / (omega * h * window);
                CAPTURE(h);
                const double error = std::pow(omega * h, 2.0) / 12.0;
                CHECK(std::abs(slow) < 1.2 * error + 5e-4);
                CHECK(amplitude[1] == doctest::Approx(expected).epsilon(error + 5e-3));
            }
        }
}

TEST_CASE("wake: below its critical Reynolds number shedding dies" * doctest::test_suite("exact")) {
    const double length = 0.2;
    lr_aerodynamics a = plate_across(2);
    a.wake_length = length, a.strouhal = 0.2, a.shedding_growth = 0.8, a.shedding_reynolds = 100.0;
    a.intensity = 1e-2, a.shedding_noise = 10.0, a.shedding_moment = 3e-3;
    const Asset asset = heavy(a, length / 400.0);
    for (const Path& path : paths) {
        const Flight flight(asset, path, {0.02, 0.0, 1.0});
        const auto swing = [&](int count) {
            double least = 1e9, most = -1e9;
            for (int i = 0; i < count; ++i) {
                steps(flight.world, 1, 0.01f);
                least = std::min(least, flight.spin()[1]), most = std::max(most, flight.spin()[1]);
            }
            return most - least;
        };
        flight.begin_shedding(0.01);
        steps(flight.world, 2000, 0.01f);
        const double cycle = swing(200);
        CHECK(cycle > 1e-4);
        set_wind(flight.world, 0.016f, 0.0f, 0.8f); // Re = 80
        steps(flight.world, 10000, 0.01f);
        CHECK(swing(100) < 0.05 * cycle);
        set_wind(flight.world, 0.0f, 0.0f, 0.0f);
        steps(flight.world, 2, 0.01f);
        CHECK(swing(100) < 0.05 * cycle);
        steps(flight.world, 2000, 0.01f);
        CHECK(swing(200) == doctest::Approx(cycle).epsilon(0.02)); // it grows again
    }
}

// Coefficients that differ with the direction of the stream in the plate, for each axis as the normal.
TEST_CASE("wake: a plate's normal force is attached, separated, and half of each at the stall angle") {
    const double lift[2] = {30.0, 18.0}, vortex[2] = {24.0, 9.0}, stall[2] = {0.25, 0.36}, drag = 12.0, density = 1.0;
    for (size_t normal = 0; normal < 3; ++normal)
        for (const Path& path : paths) {
            lr_aerodynamics a = plate_across(normal);
            const size_t along[2] = {(normal + 1) % 3, (normal + 2) % 3};
            for (size_t i = 0; i < 2; ++i)
                a.plate_lift[along[i]] = lift[i], a.plate_vortex[along[i]] = vortex[i],
                a.plate_stall[along[i]] = stall[i];
            a.plate_lift[normal] = a.plate_vortex[normal] = 1e3; // no stream in the plate has this direction
            a.plate_drag = drag;
            const Asset asset = heavy(a);
            // Twice the force over rho s^2.
            const auto force = [&](double sine, double azimuth, double speed = 1.0) {
                const double cosine = std::sqrt(1.0 - sine * sine), h = 0.01;
                Vec v{};
                v[normal] = sine;
                v[along[0]] = cosine * std::cos(azimuth), v[along[1]] = cosine * std::sin(azimuth);
                Flight flight(asset, path, speed * v);
                const Vec before = flight.velocity();
                steps(flight.world, 1, narrow(h));
                const Vec change = flight.velocity() - before;
                for (size_t i = 0; i < 2; ++i) CHECK(std::abs(change[along[i]]) < 2e-7); // along the normal
                CHECK(length(flight.spin()) < 1e-7);
                return -change[normal] * mass / h / (0.5 * density * speed * speed);
            };
            CAPTURE(normal);
            CAPTURE(path.integrator);
            CAPTURE(path.full);
            const auto separated = [&](double sine) { return drag * sine * (1.0 + 0.8 * (1.0 - sine * sine)); };
            for (size_t i = 0; i < 2; ++i) {
                const double azimuth = i == 0 ? 0.0 : 0.5 * pi;
                const auto attached = [&](double sine) {
                    return sine * (lift[i] * std::sqrt(1.0 - sine * sine) + vortex[i] * std::abs(sine));
                };
                for (const double sine : {0.02, -0.02, 0.1})
                    CHECK(force(sine, azimuth) == doctest::Approx(attached(sine)).epsilon(5e-3));
                const double stalled = std::sqrt(stall[i]), steep = std::sin(70.0 / 180.0 * pi);
                CHECK(force(stalled, azimuth) ==
                      doctest::Approx(0.5 * (attached(stalled) + separated(stalled))).epsilon(5e-3));
                CHECK(force(-steep, azimuth) == doctest::Approx(-separated(steep)).epsilon(0.02));
            }
            // Between the axes: the means of slopes, by the squares of the directions.
            CHECK(force(0.02, 0.25 * pi) ==
                  doctest::Approx(0.02 * (0.5 * (lift[0] + lift[1]) + 0.02 * 0.5 * (vortex[0] + vortex[1])))
                      .epsilon(5e-3));
            // Broadside, and so near to it that the square of the stream in the plate is lost beside that of the speed.
            for (const double cosine : {0.0, 1e-7, 1e-5, 1e-4, 1e-3, 1e-2})
                for (const double speed : {0.713, 0.877, 1.0, 1.19}) {
                    CAPTURE(cosine);
                    CAPTURE(speed);
                    CHECK(force(std::sqrt(1.0 - cosine * cosine), 0.3, speed) == doctest::Approx(drag).epsilon(2e-3));
                }
        }
}

// At a constant speed s the wake's stream is v (1 - e^(-kt)), k = s/(lag length), and the attached force that of v (1 - share e^(-kt)).
TEST_CASE("wake: the attached force grows as the wake remembers the stream") {
    const double share = 0.6, lag = 3.0, length = 0.4, sine = 0.05, k = 1.0 / (lag * length);
    lr_aerodynamics a = plate_across(2);
    for (double& l : a.plate_lift) l = 0.5;
    a.wake_share = share, a.wake_lag = lag, a.wake_length = length;
    const Asset asset = heavy(a);
    const double cosine = std::sqrt(1.0 - sine * sine), rate = 0.5 * 0.5 * cosine * sine / mass;
    for (const Path& path : paths)
        for (const double h : {2e-3, 2e-2}) {
            const Flight flight(asset, path, {0.6 * cosine, 0.8 * cosine, sine});
            for (int frame = 1; frame <= 6; ++frame) {
                steps(flight.world, static_cast<int>(std::lround(0.5 / h)), narrow(h));
                const double t = 0.5 * frame, e = std::exp(-k * t);
                const double impulse = t - 2.0 * share * (1.0 - e) / k + share * share * (1.0 - e * e) / (2.0 * k);
                CAPTURE(path.integrator);
                CAPTURE(path.full);
                CAPTURE(h);
                CAPTURE(frame);
                // The wake is as old as the end of a step from the first step on.
                CHECK(std::abs(sine - flight.velocity()[2] - rate * impulse) < rate * (h + 0.005 * t));
            }
        }
}

// The wake stays where it is in the fluid: a disc that spins about its normal flies as one that does not.
TEST_CASE("wake: a disc's spin about its normal does not turn its wake" * doctest::test_suite("exact")) {
    const auto fly = [](double spin, double share, Path path) {
        lr_aerodynamics a = plate_across(2);
        for (double& l : a.plate_lift) l = 300.0;
        a.plate_drag = 100.0, a.start_drag = 1.0, a.wake_share = share, a.wake_lag = 2.0, a.wake_length = 0.5;
        a.plate_separated_shedding = 0.0;
        Flight flight(heavy(a), path, {1.0, 0.0, -0.1}, {0.0, 0.0, spin});
        const float fall[3] = {0.3f, 0.2f, -2.0f};
        REQUIRE(lr_world_set_gravity(flight.world.get(), fall) == LR_OK);
        std::vector<Vec> track;
        for (int i = 0; i < 30; ++i) {
            steps(flight.world, 50, 2e-3f);
            track.push_back(vec(state_of(flight.world, flight.body).position));
        }
        return track;
    };
    const auto apart = [](const std::vector<Vec>& a, const std::vector<Vec>& b) {
        double most = 0.0;
        for (size_t i = 0; i < a.size(); ++i) most = std::max(most, length(a[i] - b[i]) / (1.0 + length(a[i])));
        return most;
    };
    for (const Path& path : paths)
        for (const double spin : {-20.0, 40.0}) {
            CAPTURE(path.integrator);
            CAPTURE(path.full);
            CHECK(apart(fly(0.0, 0.8, path), fly(spin, 0.8, path)) < 2e-4);
            CHECK(apart(fly(0.0, 0.8, path), fly(0.0, 0.0, path)) > 5e-3); // its memory matters
        }
}
