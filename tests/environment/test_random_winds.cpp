// Statistics of gusts and turbulence.
#include "support/random.h"
#include "support/wind.h"

#include <algorithm>

using namespace test;

namespace {

constexpr double pi = 3.14159265358979323846;

// The gusts' velocity at count moments, dt apart.
std::vector<Vec> history(const World& world, int count, float dt) {
    std::vector<Vec> out;
    for (int i = 0; i < count; ++i) {
        out.push_back(wind_at(world, {0.0, 0.0, 0.0}));
        steps(world, 1, dt, 1);
    }
    return out;
}

// A world with gusts or turbulence of 1 m/s.
template <class D> World seeded(lr_status (*init)(D*, uint32_t), uint64_t world_seed, uint32_t seed) {
    lr_world_desc wd = world_desc();
    wd.seed = world_seed;
    World world = make(wd);
    D d = initialised(init);
    d.seed = seed;
    add_source(world, d);
    return world;
}

struct Moments {
    double mean = 0.0, square = 0.0, least = 1e9;
    void take(double v, double count) { mean += v / count, square += v * v / count, least = std::min(least, v); }
    double deviation() const { return std::sqrt(square - mean * mean); }
};

struct Turbulent {
    World world = make(world_desc());
    explicit Turbulent(uint32_t octaves, uint32_t seed = 0, float size = 2.0f) {
        lr_turbulence_desc d = initialised(lr_turbulence_desc_init);
        d.rms = 1.5f, d.integral_length = size, d.octaves = octaves, d.seed = seed;
        add_source(world, d);
    }
    std::vector<Vec> at(const std::vector<Vec>& points) const {
        std::vector<float> positions, velocities;
        for (const Vec& p : points)
            for (double x : p) positions.push_back(narrow(x));
        samples_of(world, positions, velocities);
        std::vector<Vec> out;
        for (size_t i = 0; i < velocities.size(); i += 3) out.push_back(vec(&velocities[i]));
        return out;
    }
};

std::vector<Vec> points_in(double side, size_t count, uint64_t seed) {
    Random random(seed);
    std::vector<Vec> out(count);
    for (Vec& p : out)
        for (double& x : p) x = random.uniform(-side, side);
    return out;
}

} // namespace

TEST_CASE("gusts have their variance, direction and spread") {
    for (float spread : {0.0f, 0.3f}) {
        const World world = make(world_desc());
        lr_gusts_desc d = initialised(lr_gusts_desc_init);
        set(d.direction, 3.0f, 0.0f, 4.0f);
        d.rms = 2.0f, d.integral_time = 1.0f, d.angle_rms = spread;
        add_source(world, d);
        const Vec along = {0.6, 0.0, 0.8};
        double all = 0.0, ahead = 0.0;
        Vec mean{};
        const std::vector<Vec> velocities = history(world, 40000, 0.111f);
        for (const Vec& v : velocities) {
            mean = mean + 1.0 / 40000.0 * v;
            all += dot(v, v) / 40000.0;
            ahead += dot(v, along) * dot(v, along) / 40000.0;
        }
        CAPTURE(spread);
        CHECK(std::sqrt(all) == doctest::Approx(2.0).epsilon(0.02));
        CHECK(length(mean) < 0.05);
        // A share of the energy, the mean square sine of the angles, lies across: spread^2 minus a fourth-order term.
        if (spread == 0.0f)
            CHECK(ahead == doctest::Approx(all).epsilon(1e-5));
        else
            CHECK(1.0 - ahead / all == doctest::Approx(0.09).epsilon(0.12));
    }
}

TEST_CASE("the spectrum of gusts falls with the power -5/3 and is flat at long times") {
    // Energy of harmonics f to 2 f, averaged over seeds: f S(f) follows f^(-2/3) at high, f at low frequencies.
    constexpr int count = 4096;
    constexpr float dt = 0.02f;
    const double bands[5] = {0.01, 0.02, 0.5, 1.0, 4.0}; // 1/s, with a period of 1 s
    double energy[5] = {};
    for (uint32_t seed = 0; seed < 12; ++seed) {
        const World world = make(world_desc());
        lr_gusts_desc d = initialised(lr_gusts_desc_init);
        d.integral_time = 1.0f, d.angle_rms = 0.0f, d.seed = seed;
        add_source(world, d);
        const std::vector<Vec> u = history(world, count, dt);
        for (size_t b = 0; b < 5; ++b) {
            const int first = static_cast<int>(std::lround(bands[b] * count * wide(dt)));
            for (int n = std::max(first, 1); n < std::max(2 * first, 2); ++n) {
                double re = 0.0, im = 0.0;
                for (int i = 0; i < count; ++i) {
                    // Hann's window, because the harmonics do not fit into the record.
                    const double w = 1.0 - std::cos(2.0 * pi * i / count), at = 2.0 * pi * n * i / count;
                    re += w * u[static_cast<size_t>(i)][0] * std::cos(at);
                    im += w * u[static_cast<size_t>(i)][0] * std::sin(at);
                }
                energy[b] += re * re + im * im;
            }
        }
    }
    CHECK(std::log2(energy[3] / energy[2]) == doctest::Approx(-2.0 / 3.0).epsilon(0.5));
    CHECK(std::log2(energy[4] / energy[2]) / 3.0 == doctest::Approx(-2.0 / 3.0).epsilon(0.25));
    CHECK(energy[1] > 1.2 * energy[0]);
}

TEST_CASE("gusts are a function of time: jumps, long times and other seeds") {
    const auto at = [](float time, uint64_t world_seed, uint32_t seed) {
        const World world = seeded(lr_gusts_desc_init, world_seed, seed);
        for (int i = 0; i < 8; ++i) steps(world, 1, time / 8.0f, static_cast<uint32_t>(time) + 1);
        return wind_at(world, {1.0, 2.0, 3.0});
    };
    const World walked = make(world_desc());
    add_source(walked, initialised(lr_gusts_desc_init));
    steps(walked, 1024, 0.125f, 2);
    CHECK(length(wind_at(walked, {5.0, 0.0, 0.0}) - at(128.0f, 0, 0)) == 0.0);
    CHECK(length(at(64.0f, 0, 0) - at(64.0f, 0, 1)) > 0.01);
    CHECK(length(at(64.0f, 0, 0) - at(64.0f, 1, 0)) > 0.01);
    CHECK(length(at(8192.0f, 0, 0)) > 0.0);
}

// The wind must blow in its direction from the first second: with every seed, not just on average.
TEST_CASE("the first seconds of gusts and turbulence are centred on the wind that was set" *
          doctest::test_suite("exact")) {
    constexpr int seeds = 1000, seconds = 10, each = 4;
    for (bool gusts : {true, false})
        for (bool of_world : {false, true}) {
            Moments first, all;
            double before = 0.0, neighbours = 0.0;
            for (uint32_t seed = 0; seed < seeds; ++seed) {
                const uint64_t world_seed = of_world ? seed : 0;
                const uint32_t its_own = of_world ? 0 : seed;
                const World world = gusts ? seeded(lr_gusts_desc_init, world_seed, its_own)
                                          : seeded(lr_turbulence_desc_init, world_seed, its_own);
                set_wind(world, 2.0f, 0.0f, 0.0f);
                if (gusts) REQUIRE(length(wind_at(world, {}) - Vec{2.0, 0.0, 0.0}) == 0.0);
                double sum = 0.0;
                for (int i = 0; i < seconds * each; ++i) {
                    steps(world, 1, 0.5f / each, 1);
                    sum += wind_at(world, {})[0] - 2.0;
                    steps(world, 1, 0.5f / each, 1);
                    if (i + 1 == each) first.take(sum / each, seeds);
                }
                const double mean = sum / (seconds * each);
                all.take(mean, seeds);
                neighbours += before * mean / seeds;
                before = mean;
            }
            CAPTURE(gusts);
            CAPTURE(of_world);
            CHECK(std::abs(first.mean) < 3.0 * first.deviation() / std::sqrt(seeds));
            CHECK(std::abs(all.mean) < 3.0 * all.deviation() / std::sqrt(seeds));
            CHECK(all.least > -1.0); // at least half the wind, if gusts have half its speed
            CHECK(std::abs(neighbours) < 3.0 * all.square / std::sqrt(seeds));
        }
}

TEST_CASE("gusts have their speed and integral time four periods after they began" * doctest::test_suite("exact")) {
    constexpr int seeds = 800, each = 4, young = 4 * each, lags = 6 * each, count = young + 40 * each;
    Moments spread;
    double product[lags] = {};
    for (uint32_t seed = 0; seed < seeds; ++seed) {
        const World world = seeded(lr_gusts_desc_init, 7, seed);
        const std::vector<Vec> all = history(world, count, 4.0f / each); // the period for 0
        const Vec* const u = all.data();
        for (int i = young; i < count; ++i) {
            spread.take(dot(u[i], u[i]), 1.0 * seeds * (count - young));
            for (int n = 0; n < lags && i + n < count; ++n)
                product[n] += u[i][0] * u[i + n][0] / (1.0 * seeds * (count - young - n));
        }
    }
    CHECK(std::sqrt(spread.mean) == doctest::Approx(1.0).epsilon(0.02));
    double time = -0.5 * product[0]; // by trapezia
    for (double p : product) time += p;
    // 8,000 seeds: 3.68, as the slowest 2 % of the spectrum are missing.
    CHECK(4.0 / each * time / product[0] == doctest::Approx(3.68).epsilon(0.05));
}

TEST_CASE("gusts begin when they are added, and go on through updates and restored snapshots") {
    const World world = make(world_desc());
    set_wind(world, 3.0f, 0.0f, 1.0f);
    steps(world, 8, 0.5f, 2);
    lr_gusts_desc d = initialised(lr_gusts_desc_init);
    d.integral_time = 1.0f;
    const lr_wind_source source = add_source(world, d);
    const Vec set = {3.0, 0.0, 1.0};
    CHECK(length(wind_at(world, {}) - set) == 0.0);
    const World updated = make(world_desc());
    steps(updated, 8, 0.5f, 2);
    const lr_wind_source other = add_source(updated, d);
    std::vector<unsigned char> saved;
    Vec later{};
    for (int i = 0; i < 30; ++i) {
        steps(world, 1, 0.25f, 1);
        if (i == 5) saved = snapshot_of(world);
        if (i == 15) later = wind_at(world, {});
        d.rms = i % 2 ? 1.0f : 0.5f;
        REQUIRE(lr_world_update_gusts(updated.get(), other, &d) == LR_OK);
        steps(updated, 1, 0.25f, 1);
        const Vec gust = wind_at(world, {}) - set, half = wind_at(updated, {});
        CHECK(length(gust) > 0.0);
        CHECK(length(wide(d.rms) * gust - half) < 1e-6);
    }
    REQUIRE(lr_world_remove_wind(world.get(), source) == LR_OK);
    REQUIRE(lr_world_snapshot_restore(world.get(), saved.data(), saved.size()) == LR_OK);
    steps(world, 10, 0.25f, 1);
    CHECK(length(wind_at(world, {}) - later) == 0.0);
    const World fresh = make(world_desc());
    REQUIRE(lr_world_snapshot_restore(fresh.get(), saved.data(), saved.size()) == LR_OK);
    steps(fresh, 10, 0.25f, 1);
    CHECK(length(wind_at(fresh, {}) - later) == 0.0);
    // New sources in their slots start again.
    REQUIRE(lr_world_remove_wind(fresh.get(), source) == LR_OK);
    add_source(fresh, d);
    CHECK(length(wind_at(fresh, {}) - set) == 0.0);
}

TEST_CASE("turbulence has its root mean square in each direction, and no mean" * doctest::test_suite("exact")) {
    for (uint32_t octaves : {1u, 2u, 4u}) {
        const Turbulent field(octaves);
        Vec mean{}, square{}, mixed{};
        const size_t count = 200000;
        for (const Vec& v : field.at(points_in(500.0, count, 1)))
            for (size_t i = 0; i < 3; ++i) {
                mean[i] += v[i] / static_cast<double>(count);
                square[i] += v[i] * v[i] / static_cast<double>(count);
                mixed[i] += v[i] * v[(i + 1) % 3] / static_cast<double>(count);
            }
        CAPTURE(octaves);
        for (size_t i = 0; i < 3; ++i) {
            CHECK(std::sqrt(square[i]) == doctest::Approx(1.5).epsilon(0.02));
            CHECK(std::abs(mean[i]) < 0.02);
            CHECK(std::abs(mixed[i]) < 0.03);
        }
    }
}

TEST_CASE("the integral length of turbulence is the size that was asked for, alike in all directions" *
          doctest::test_suite("exact")) {
    const Vec ways[4] = {{1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {0.6, 0.8, 0.0}, {1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0}};
    for (uint32_t octaves : {1u, 3u}) {
        const Turbulent field(octaves);
        const std::vector<Vec> points = points_in(400.0, 30000, 2);
        const std::vector<Vec> here = field.at(points);
        double sum = 0.0;
        for (const Vec& way : ways) {
            double total = 0.0;
            const double dr = 0.25;
            for (int n = 0; n < 60; ++n) {
                std::vector<Vec> moved = points;
                for (Vec& p : moved) p = p + dr * n * way;
                const std::vector<Vec> there = field.at(moved);
                double product = 0.0, square = 0.0;
                for (size_t i = 0; i < here.size(); ++i) {
                    product += dot(here[i], way) * dot(there[i], way);
                    square += dot(here[i], way) * dot(here[i], way);
                }
                total += product / square * dr * (n == 0 ? 0.5 : 1.0);
            }
            CAPTURE(octaves);
            CHECK(total == doctest::Approx(2.0).epsilon(0.12));
            sum += total / 4.0;
        }
        CHECK(sum == doctest::Approx(2.0).epsilon(0.07));
    }
}

TEST_CASE("turbulence has no divergence" * doctest::test_suite("exact")) {
    const Turbulent field(2);
    double divergence = 0.0, gradient = 0.0;
    const double e = 0.015625;
    const std::vector<Vec> points = points_in(8.0, 5000, 4);
    std::vector<Vec> around;
    for (const Vec& p : points)
        for (size_t j = 0; j < 3; ++j)
            for (double side : {-2.0, -1.0, 1.0, 2.0}) {
                Vec x = p;
                for (double& v : x) v = std::round(v * 1024.0) / 1024.0; // so that differences are exact
                x[j] += side * e;
                around.push_back(x);
            }
    const std::vector<Vec> u = field.at(around);
    for (size_t n = 0; n < points.size(); ++n) {
        double trace = 0.0;
        for (size_t j = 0; j < 3; ++j) {
            const Vec* const v = &u[n * 12 + j * 4];
            const Vec slope = 1.0 / (12.0 * e) * (v[0] - v[3] + 8.0 * (v[2] - v[1])); // fourth order
            trace += slope[j];
            gradient += dot(slope, slope);
        }
        divergence += trace * trace;
    }
    CHECK(std::sqrt(divergence) < 1e-3 * std::sqrt(gradient));
    CHECK(std::sqrt(gradient / 5000.0) > 1.0);
}

TEST_CASE("random winds that are set anew in each frame go on as smoothly as others, however old they are") {
    const World world = make(world_desc());
    lr_turbulence_desc eddies = initialised(lr_turbulence_desc_init);
    lr_gusts_desc gusts = initialised(lr_gusts_desc_init);
    eddies.velocity[0] = 1.0f;
    const lr_wind_source sources[] = {add_source(world, eddies), add_source(world, gusts)};
    steps(world, 1000, 1.0f, 1);
    const auto roughness = [&](float factor) { // root mean square change of a step of 1/60 s
        double squares = 0.0;
        Vec before = wind_at(world, {});
        for (int i = 0; i < 120; ++i) {
            eddies.rms *= factor;
            gusts.integral_time = 4.0f * factor;
            REQUIRE(lr_world_update_turbulence(world.get(), sources[0], &eddies) == LR_OK);
            REQUIRE(lr_world_update_gusts(world.get(), sources[1], &gusts) == LR_OK);
            CHECK(length(wind_at(world, {}) - before) < 0.05); // the update by itself
            steps(world, 1, 1.0f / 60.0f, 1);
            const Vec now = wind_at(world, {});
            squares += dot(now - before, now - before);
            before = now;
        }
        return std::sqrt(squares / 120.0);
    };
    CHECK(roughness(1.0f) < 0.5);
    CHECK(roughness(0.999f) < 0.5);
    CHECK(roughness(1.001f) < 0.5);
    const std::vector<unsigned char> saved = snapshot_of(world);
    const World fresh = make(world_desc());
    REQUIRE(lr_world_snapshot_restore(fresh.get(), saved.data(), saved.size()) == LR_OK);
    CHECK(length(wind_at(fresh, {}) - wind_at(world, {})) == 0.0);
}

TEST_CASE("another velocity moves turbulence on from where it is, however old the world is") {
    const World world = make(world_desc());
    lr_turbulence_desc d = initialised(lr_turbulence_desc_init);
    d.eddy_life = 1e6f; // as good as frozen
    d.velocity[0] = 3.0f;
    const lr_wind_source source = add_source(world, d);
    steps(world, 3600, 1.0f, 1);
    const uint64_t before_updates = hash_of(world);
    REQUIRE(lr_world_update_turbulence(world.get(), source, &d) == LR_OK);
    CHECK(hash_of(world) == before_updates);
    // The pattern's way is the integral of all velocities.
    const Vec x = {0.3, 0.4, 0.5}, first = wind_at(world, x);
    Vec way{};
    for (int i = 0; i < 60; ++i) {
        set(d.velocity, narrow(std::cos(0.1 * i)), 0.01f * static_cast<float>(i), -0.25f);
        const Vec before = wind_at(world, x);
        REQUIRE(lr_world_update_turbulence(world.get(), source, &d) == LR_OK);
        CHECK(length(wind_at(world, x) - before) < 1e-5);
        steps(world, 1, 0.125f, 1);
        way = way + 0.125 * vec(d.velocity);
        CHECK(length(wind_at(world, x + way) - first) < 1e-4);
    }
    // It is state: of hash and snapshot.
    const std::vector<unsigned char> saved = snapshot_of(world);
    const World fresh = make(world_desc());
    REQUIRE(lr_world_snapshot_restore(fresh.get(), saved.data(), saved.size()) == LR_OK);
    CHECK(hash_of(fresh) == hash_of(world));
    CHECK(length(wind_at(fresh, x) - wind_at(world, x)) == 0.0);
    REQUIRE(lr_world_update_turbulence(fresh.get(), source, &d) == LR_OK);
    CHECK(hash_of(fresh) == hash_of(world));
    d.velocity[0] += 1.0f; // and back: the same desc, another way
    REQUIRE(lr_world_update_turbulence(fresh.get(), source, &d) == LR_OK);
    steps(fresh, 1, 0.0625f, 1);
    steps(world, 1, 0.0625f, 1);
    d.velocity[0] -= 1.0f;
    REQUIRE(lr_world_update_turbulence(fresh.get(), source, &d) == LR_OK);
    REQUIRE(lr_world_update_turbulence(world.get(), source, &d) == LR_OK);
    CHECK(hash_of(fresh) != hash_of(world));
    REQUIRE(lr_world_snapshot_restore(fresh.get(), saved.data(), saved.size()) == LR_OK);
    CHECK(snapshot_of(fresh) == saved);
}

TEST_CASE("turbulence goes along with the uniform wind, and changes on the way") {
    lr_turbulence_desc d = initialised(lr_turbulence_desc_init);
    d.integral_length = 1.0f, d.eddy_life = 1e6f; // as good as frozen
    const World world = make(world_desc());
    set_wind(world, 4.0f, 0.0f, 1.0f);
    add_source(world, d);
    const Vec mean = {4.0, 0.0, 1.0}, x = {0.3, 0.4, 0.5};
    const Vec before = wind_at(world, x) - mean;
    steps(world, 10, 0.1f, 1);
    CHECK(length(wind_at(world, x) - mean - before) > 0.05);
    CHECK(length(wind_at(world, x + mean) - mean - before) < 1e-4);
    // With a changing wind: its path is the sum of its velocities.
    set_wind(world, 0.0f, 0.0f, 0.0f);
    steps(world, 1, 0.5f, 4); // (1, 0, 0.25) more on average of the ramp
    CHECK(length(wind_at(world, x + mean + Vec{1.0, 0.0, 0.25}) - before) < 1e-4);

    // In still air eddies last for the period: correlated at once, uncorrelated after three periods.
    d.eddy_life = 1.0f, d.octaves = 1;
    const World still = make(world_desc());
    add_source(still, d);
    std::vector<float> positions, first, later;
    for (const Vec& p : points_in(100.0, 20000, 9))
        for (double c : p) positions.push_back(narrow(c));
    samples_of(still, positions, first);
    const auto correlation = [&] {
        samples_of(still, positions, later);
        double product = 0.0, a = 0.0, b = 0.0;
        for (size_t i = 0; i < first.size(); ++i) {
            product += wide(first[i]) * wide(later[i]);
            a += wide(first[i]) * wide(first[i]);
            b += wide(later[i]) * wide(later[i]);
        }
        return product / std::sqrt(a * b);
    };
    steps(still, 1, 0.02f, 1);
    CHECK(correlation() > 0.98);
    steps(still, 3, 1.0f, 1);
    CHECK(std::abs(correlation()) < 0.15);
}
