// Statistics of the Langevin model, and the clocks' reading of the table.
#include "support/quick.h"
#include "support/random.h"
#include "support/scene.h"
#include "support/vector.h"

#include <cmath>

using namespace test;

namespace {

constexpr int32_t integrators[] = {LR_INTEGRATOR_RK4, LR_INTEGRATOR_DEFAULT};

const uint32_t crowd = quick() ? 1024 : 8192;
const int rounds = quick() ? 4 : 12;

std::vector<lr_body> add_crowd(const World& world, lr_batch batch, uint32_t count) {
    std::vector<lr_body_desc> descs(count, body_desc());
    std::vector<lr_body> ids(count);
    REQUIRE(lr_body_create(world.get(), batch, descs.data(), count, ids.data()) == LR_OK);
    return ids;
}

std::vector<Vec> velocities(const World& world, const std::vector<lr_body>& ids) {
    std::vector<Vec> out;
    lr_body_state s = body_state();
    for (lr_body id : ids) {
        REQUIRE(lr_body_get_state(world.get(), id, &s) == LR_OK);
        out.push_back(vec(s.linear_velocity));
    }
    return out;
}

} // namespace

// A neutrally buoyant sphere is moved by rho (V + A)(-alpha v + beta xi) on a mass of rho (V + A): Pope's equation
// itself.
TEST_CASE("stationary Langevin: variance of each axis, Gaussian tails, decay of the correlation") {
    const double chi = 4.0, epsilon = 0.6, c0 = 2.1, k = epsilon / chi;
    const double alpha = (0.5 + 0.75 * c0) * chi;
    const double expected = 2.0 * k / 3.0 * 1.5 * c0 / (1.0 + 1.5 * c0);
    const Asset sphere = make(in_water(ellipsoid(0.02, 0.02, 0.02, 1000.0)));
    for (int32_t integrator : integrators)
        for (bool full : {false, true}) {
            const World world = weightless(9);
            lr_batch_desc d = langevin();
            d.clock = LR_CLOCK_AGE;
            d.integrator = integrator;
            const lr_batch batch = add_batch(world, d, sphere, crowd, full);
            set_constant_table(world, batch, chi, epsilon, c0);
            const std::vector<lr_body> ids = add_crowd(world, batch, crowd);
            // Steps of 1/40 of the correlation time: held noise loses (alpha h)^2/12 = 5e-5 of the variance.
            const float h = narrow(1.0 / (40.0 * alpha));
            steps(world, 8, 20 * h, 20); // 4 correlation times from rest: exp(-8) = 3e-4 of the variance is missing
            double square[3] = {}, cross_xy = 0.0, fourth = 0.0, lag_half = 0.0, lag_one = 0.0;
            for (int round = 0; round < rounds; ++round) {
                const std::vector<Vec> now = velocities(world, ids);
                steps(world, 1, 20 * h, 20);
                const std::vector<Vec> half = velocities(world, ids);
                steps(world, 1, 20 * h, 20);
                const std::vector<Vec> one = velocities(world, ids);
                steps(world, 4, 20 * h, 20); // to the next round: exp(-6) of the correlation of squares remains
                for (size_t i = 0; i < now.size(); ++i) {
                    for (size_t a = 0; a < 3; ++a) {
                        square[a] += now[i][a] * now[i][a];
                        fourth += std::pow(now[i][a], 4.0);
                    }
                    cross_xy += now[i][0] * now[i][1];
                    lag_half += dot(now[i], half[i]);
                    lag_one += dot(now[i], one[i]);
                }
            }
            const double n = static_cast<double>(crowd) * rounds;
            const double all = square[0] + square[1] + square[2];
            // Standard errors: of a variance sqrt(2/n), of a correlation at most sqrt(1/n), of a kurtosis sqrt(96/n).
            // Five of them, plus the scheme's own bias.
            CAPTURE(integrator);
            for (double s : square)
                CHECK(s / n / expected == doctest::Approx(1.0).epsilon(5.0 * std::sqrt(2.0 / n) + 1e-3));
            CHECK(std::abs(cross_xy / n / expected) < 5.0 / std::sqrt(n));
            CHECK(std::abs(3.0 * n * fourth / (all * all) - 3.0) < 5.0 * std::sqrt(96.0 / (3.0 * n)));
            CHECK(std::abs(lag_half / all - std::exp(-0.5)) < 5.0 / std::sqrt(3.0 * n) + 1e-3);
            CHECK(std::abs(lag_one / all - std::exp(-1.0)) < 5.0 / std::sqrt(3.0 * n) + 1e-3);
        }
}

TEST_CASE("the stationary variance does not depend on the step, in the default scheme at any step") {
    const double chi = 40.0, epsilon = 6.0, c0 = 2.1;
    const double alpha = (0.5 + 0.75 * c0) * chi;
    const double expected = 2.0 * epsilon / chi / 3.0 * 1.5 * c0 / (1.0 + 1.5 * c0);
    const Asset sphere = make(in_water(ellipsoid(0.02, 0.02, 0.02, 1000.0)));
    for (double x : {0.1, 0.5, 2.0, 10.0}) { // alpha h
        const World world = weightless(10);
        lr_batch_desc d = langevin();
        d.clock = LR_CLOCK_AGE;
        const lr_batch batch = add_batch(world, d, sphere, crowd);
        set_constant_table(world, batch, chi, epsilon, c0);
        const std::vector<lr_body> ids = add_crowd(world, batch, crowd);
        const auto substeps = static_cast<uint32_t>(std::ceil(5.0 / x));
        double square = 0.0;
        steps(world, 1, narrow(x * substeps / alpha), substeps);
        for (int round = 0; round < 4; ++round) {
            steps(world, 1, narrow(x * substeps / alpha), substeps);
            for (const Vec& v : velocities(world, ids)) square += dot(v, v) / 3.0;
        }
        const double n = 4.0 * crowd;
        CAPTURE(x);
        CHECK(square / n / expected == doctest::Approx(1.0).epsilon(5.0 * std::sqrt(2.0 / (3.0 * n)) + 2e-3));
    }
}

// From rest and before damping acts: a random walk of each velocity and spin about the body's own axes, driven by rho (V + A) beta
// and rho D beta/ell on body and added mass together, ell half the largest extent.
TEST_CASE("the noise kicks each axis by its own weights") {
    const double chi = 1.0, epsilon = 0.5, c0 = 2.0, beta = std::sqrt(c0 * epsilon), ell = 0.04;
    const Asset asset = make(in_water(ellipsoid(0.04, 0.02, 0.01, 1300.0)));
    const lr_asset_info info = info_of(asset);
    const double displaced = info.fluid_density * info.volume;
    for (int32_t integrator : integrators)
        for (bool full : {false, true}) {
            const World world = weightless(12);
            lr_batch_desc d = langevin();
            d.clock = LR_CLOCK_AGE;
            d.integrator = integrator;
            const lr_batch batch = add_batch(world, d, asset, crowd, full);
            set_constant_table(world, batch, chi, epsilon, c0);
            const std::vector<lr_body> ids = add_crowd(world, batch, crowd);
            const double time = 4e-4;
            steps(world, 1, narrow(time), 4);
            Vec v_squared{}, w_squared{};
            for (lr_body id : ids) {
                const lr_body_state s = state_of(world, id);
                for (size_t i = 0; i < 3; ++i) {
                    v_squared[i] += std::pow(wide(s.linear_velocity[i]), 2.0) / crowd;
                    w_squared[i] += std::pow(wide(s.angular_velocity[i]), 2.0) / crowd;
                }
            }
            const double floor =
                0.02 * (displaced + info.added_mass[14]) / info.mass; // docs/maintainers/physics.md, "Viscous floor"
            const double bound = 5.0 * std::sqrt(2.0 / crowd) + 2e-3;
            CAPTURE(integrator);
            for (size_t i = 0; i < 3; ++i) {
                const double a = info.added_mass[i * 7], b = info.added_mass[(i + 3) * 7], j = info.inertia[i * 4];
                const double v = (displaced + a) / (info.mass + a) * beta, w = (b + floor * j) / (j + b) * beta / ell;
                CHECK(v_squared[i] / (v * v * time) == doctest::Approx(1.0).epsilon(bound));
                CHECK(w_squared[i] / (w * w * time) == doctest::Approx(1.0).epsilon(bound));
            }
        }
}

TEST_CASE("the noise gain multiplies the noise's amplitude, and a seed or a noise seed changes it") {
    const Asset sphere = make(in_water(ellipsoid(0.02, 0.02, 0.02, 1000.0)));
    const auto end = [&](float gain, uint64_t seed, uint32_t noise_seed) {
        const World world = weightless(seed);
        lr_batch_desc d = langevin();
        d.clock = LR_CLOCK_AGE;
        d.noise_gain = gain;
        const lr_batch batch = add_batch(world, d, sphere, 1);
        set_constant_table(world, batch, 4.0, 0.6, 2.1);
        lr_body_desc b = body_desc();
        b.noise_seed = noise_seed;
        const lr_body id = add_body(world, batch, b);
        steps(world, 10, 0.01f, 2);
        return vec(state_of(world, id).linear_velocity);
    };
    const Vec one = end(1.0f, 1, 7);
    CHECK(length(one) > 0.01);
    CHECK(length(end(0.0f, 1, 7)) == 0.0);
    // The sphere also rotates, by a twentieth of a turn at most: the size is linear in the noise.
    CHECK(length(end(2.0f, 1, 7)) / length(one) == doctest::Approx(2.0).epsilon(0.05));
    CHECK(length(end(1.0f, 2, 7) - one) > 0.01);
    CHECK(length(end(1.0f, 1, 8) - one) > 0.01);
    CHECK(length(end(1.0f, 1, 7) - one) == 0.0);
    CHECK(length(end(1.0f, 1ull << 40, 7) - end(1.0f, 0, 7)) > 0.01); // the high half of the seed counts too
}

// alpha is linear between samples: ln v falls by its integral, a sum of trapezoids.
TEST_CASE("the AGE clock reads the table at the body's age, holds its end or begins again") {
    const float chis[4] = {1.0f, 4.0f, 2.0f, 0.0f}, epsilons[4] = {0.0f, 0.0f, 0.0f, 0.0f};
    const double sample_dt = 0.25, c0 = 2.0, unit = 0.5 + 0.75 * c0;
    const auto chi_at = [&](double age, bool loop) {
        double at = age / sample_dt;
        at = loop ? std::fmod(at, 3.0) : std::min(at, 3.0);
        const auto below = static_cast<size_t>(std::min(at, 2.0));
        return wide(chis[below]) + (at - static_cast<double>(below)) * (wide(chis[below + 1]) - wide(chis[below]));
    };
    const Asset sphere = make(in_water(ellipsoid(0.02, 0.02, 0.02, 1000.0)));
    for (int32_t integrator : integrators)
        for (int32_t end : {LR_TABLE_CLAMP, LR_TABLE_LOOP})
            for (double spawned : {0.0, 0.375, 0.75, 2.0}) {
                const World world = weightless();
                lr_batch_desc d = langevin();
                d.clock = LR_CLOCK_AGE;
                d.table_end = end;
                d.noise_gain = 0.0f;
                d.integrator = integrator;
                const lr_batch batch = add_batch(world, d, sphere, 1);
                lr_turbulence_table t = table_desc();
                t.count = 4;
                t.chi = chis;
                t.epsilon = epsilons;
                t.dt = narrow(sample_dt);
                t.u0 = t.l = 1.0f;
                t.c0 = narrow(c0);
                REQUIRE(lr_batch_set_turbulence_table(world.get(), batch, &t) == LR_OK);
                lr_body_desc b = body_desc();
                b.linear_velocity[2] = 2.0f;
                b.age = narrow(spawned);
                const lr_body id = add_body(world, batch, b);
                double log_v = std::log(2.0), age = spawned;
                for (int quarter = 0; quarter < 7; ++quarter) {
                    // A step never crosses a sample: the value in its middle is its mean.
                    steps(world, 32, 1.0f / 256.0f, 2);
                    for (int i = 0; i < 64; ++i)
                        log_v -= unit * chi_at(age + (i + 0.5) / 512.0, end == LR_TABLE_LOOP) / 512.0;
                    age += 0.125;
                    CAPTURE(end);
                    CAPTURE(age);
                    CHECK(wide(state_of(world, id).linear_velocity[2]) ==
                          doctest::Approx(std::exp(log_v)).epsilon(5e-5));
                }
            }
}

TEST_CASE("the SPEED clock reads the stationary sample and scales it by the speed") {
    const Asset sphere = make(in_water(ellipsoid(0.02, 0.02, 0.02, 1000.0)));
    const float chis[3] = {9.0f, 2.0f, 7.0f}, epsilons[3] = {9.0f, 0.0f, 7.0f};
    for (float u0 : {0.25f, 1.0f}) {
        const World world = weightless();
        lr_batch_desc d = langevin();
        d.noise_gain = 0.0f;
        const lr_batch batch = add_batch(world, d, sphere, 2);
        lr_turbulence_table t = table_desc();
        t.count = 3;
        t.chi = chis;
        t.epsilon = epsilons;
        t.dt = 0.1f;
        t.u0 = u0;
        t.l = 0.3f;
        t.c0 = 2.0f;
        t.stationary = 1;
        REQUIRE(lr_batch_set_turbulence_table(world.get(), batch, &t) == LR_OK);
        lr_body_desc b = body_desc();
        b.linear_velocity[0] = 0.5f;
        const lr_body young = add_body(world, batch, b);
        b.age = 50.0f;
        const lr_body old = add_body(world, batch, b);
        steps(world, 100, 0.01f, 4);
        // v' = -K v^2, K = (1/2 + 3/4 C0) chi/u0, whatever the age.
        const double rate = 2.0 * 2.0 / wide(u0);
        const double expected = 0.5 / (1.0 + rate * 0.5 * 1.0);
        CHECK(wide(state_of(world, young).linear_velocity[0]) == doctest::Approx(expected).epsilon(1e-4));
        CHECK(state_of(world, old).linear_velocity[0] == state_of(world, young).linear_velocity[0]);
    }
}

TEST_CASE("at rest in still fluid the SPEED clock makes no noise, and nothing moves") {
    const Asset asset = make(in_water(ellipsoid(0.04, 0.02, 0.01, 1000.0)));
    for (int32_t integrator : integrators) {
        const World world = weightless(3);
        lr_batch_desc d = langevin();
        d.integrator = integrator;
        const lr_batch batch = add_batch(world, d, asset, 1);
        const lr_body id = add_body(world, batch, body_desc());
        steps(world, 100, 0.01f, 4);
        const lr_body_state s = state_of(world, id);
        CHECK(length(vec(s.position)) == 0.0);
        CHECK(length(vec(s.linear_velocity)) == 0.0);
        CHECK(s.orientation[3] == 1.0f);
    }
}

// A coarse guard, not a fit: paper falls at 0.7 to 0.8 m/s (docs/maintainers/physics.md section 5), a leaf without noise somewhat
// faster.
TEST_CASE("the paper's leaf falls about as fast as paper does") {
    const Asset asset = make(ellipsoid(0.04, 0.01, 0.00005, 800.0));
    for (float noise : {0.0f, 1.0f}) {
        const World world = make(world_desc());
        lr_batch_desc d = langevin();
        d.noise_gain = noise;
        const lr_batch batch = add_batch(world, d, asset, 200);
        Random random(21);
        std::vector<lr_body> ids;
        for (int i = 0; i < 200; ++i) {
            ids.push_back(add_body(world, batch, turned_anyhow(random)));
        }
        steps(world, 120, 1.0f / 60.0f, 4);
        double start = 0.0, end = 0.0, most = 0.0;
        for (lr_body id : ids) start += wide(state_of(world, id).position[1]) / 200.0;
        steps(world, 180, 1.0f / 60.0f, 4);
        for (lr_body id : ids) {
            const lr_body_state s = state_of(world, id);
            end += wide(s.position[1]) / 200.0;
            most = std::max(most, length(vec(s.linear_velocity)));
        }
        const double fall = (start - end) / 3.0;
        MESSAGE("noise ", noise, ": ", fall, " m/s, fastest ", most);
        CHECK(most < 6.0);
        CHECK(fall > 0.5);
        CHECK(fall < (noise == 0.0f ? 1.3 : 1.0));
    }
}
