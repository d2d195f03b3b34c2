// Each kind of wind source against its formula, through lr_world_sample_wind.
#include "support/random.h"
#include "support/wind.h"

#include <algorithm>

using namespace test;

namespace {

constexpr double pi = 3.14159265358979323846;

void check_near(Vec got, Vec expected, double tolerance) {
    CAPTURE(got[0]);
    CAPTURE(got[1]);
    CAPTURE(got[2]);
    CAPTURE(expected[0]);
    CAPTURE(expected[1]);
    CAPTURE(expected[2]);
    CHECK(length(got - expected) <= tolerance);
}

} // namespace

TEST_CASE("a Lamb-Oseen vortex is the closed form, from the core to afar, and moves") {
    const World world = make(world_desc());
    lr_vortex_desc d = vortex_desc();
    set(d.position, 1.0f, 2.0f, -1.0f);
    set(d.axis, 1.0f, 2.0f, 2.0f);
    set(d.velocity, 0.5f, -0.25f, 1.0f);
    d.circulation = 3.0f;
    d.core_radius = 0.2f;
    add_source(world, d);
    const Vec axis = 1.0 / 3.0 * Vec{1.0, 2.0, 2.0};
    Random random(3);
    for (double time : {0.0, 2.0}) {
        if (time > 0.0) steps(world, 2, 1.0f, 1);
        const Vec centre = Vec{1.0, 2.0, -1.0} + time * Vec{0.5, -0.25, 1.0};
        for (int i = 0; i < 300; ++i) {
            Vec out;
            for (double& x : out) x = random.uniform(-1.0, 1.0);
            out = out - dot(out, axis) * axis;
            const double r = random.logarithmic(1e-3, 50.0);
            out = r / length(out) * out;
            const Vec x = centre + out + random.uniform(-20.0, 20.0) * axis;
            const double speed = 3.0 / (2.0 * pi * r) * (1.0 - std::exp(-r * r / 0.04));
            // The position is rounded: 4e-6 m in a shear of up to 12 per s.
            check_near(wind_at(world, x), speed / r * cross(axis, out), 6e-5);
        }
    }
}

TEST_CASE("a Rankine vortex turns as a solid inside, has no vorticity outside, and no jump between") {
    const World world = make(world_desc());
    lr_vortex_desc d = vortex_desc(LR_VORTEX_RANKINE);
    set(d.axis, 0.0f, 0.0f, 1.0f);
    d.circulation = 4.0f;
    d.core_radius = 0.5f;
    add_source(world, d);
    const double turn = 4.0 / (2.0 * pi * 0.25);
    check_near(wind_at(world, {0.25, 0.0, 3.0}), {0.0, 0.25 * turn, 0.0}, 1e-6);
    check_near(wind_at(world, {0.0, 2.0, 0.0}), {-4.0 / (4.0 * pi), 0.0, 0.0}, 1e-6);
    const Vec inside = wind_at(world, {0.49999, 0.0, 0.0}), outside = wind_at(world, {0.50001, 0.0, 0.0});
    check_near(inside, outside, 1e-4);
}

TEST_CASE("a vortex with limits is unchanged to half of them and nothing beyond") {
    const World bounded = make(world_desc()), endless = make(world_desc());
    lr_vortex_desc d = vortex_desc();
    set(d.axis, 0.0f, 1.0f, 0.0f);
    add_source(endless, d);
    d.outer_radius = 4.0f, d.half_length = 2.0f;
    add_source(bounded, d);
    Random random(2);
    int outside = 0, inside = 0;
    for (int i = 0; i < 3000; ++i) {
        const Vec x = {random.uniform(-6.0, 6.0), random.uniform(-3.0, 3.0), random.uniform(-6.0, 6.0)};
        const double r = std::sqrt(x[0] * x[0] + x[2] * x[2]), z = std::abs(x[1]);
        const Vec got = wind_at(bounded, x), all = wind_at(endless, x);
        if (r >= 4.0 || z >= 2.0) {
            ++outside;
            CHECK(length(got) == 0.0);
        } else if (r < 2.0 && z < 1.0) {
            ++inside;
            CHECK(length(got - all) <= 1e-6);
        } else {
            CHECK(length(got) <= length(all) + 1e-6);
        }
    }
    CHECK(outside > 500);
    CHECK(inside > 50);
}

TEST_CASE("a point blower is a round jet that keeps its momentum") {
    const World world = make(world_desc());
    lr_blower_desc d = initialised(lr_blower_desc_init);
    set(d.position, 0.0f, 1.0f, 0.0f);
    set(d.direction, 0.0f, 0.0f, -2.0f);
    d.speed = 10.0f, d.nozzle_radius = 0.1f, d.range = 100.0f, d.spread = 0.11f;
    add_source(world, d);
    for (double z : {0.0, 0.5, 3.0, 20.0, 49.0})
        for (double r : {0.0, 0.05, 0.4, 2.0}) {
            const double b = 0.1 + 0.11 * z;
            const double speed = r < 4.0 * b ? 10.0 * 0.1 / b * std::exp(-r * r / (b * b)) : 0.0;
            check_near(wind_at(world, {0.6 * r, 1.0 + 0.8 * r, -z}), {0.0, 0.0, -speed}, 2e-5);
        }
    CHECK(length(wind_at(world, {0.0, 1.0, 0.2})) == 0.0);    // behind
    CHECK(length(wind_at(world, {0.0, 1.0, -100.1})) == 0.0); // beyond its range
    const double part = length(wind_at(world, {0.0, 1.0, -75.0})) / (10.0 * 0.1 / (0.1 + 0.11 * 75.0));
    CHECK(part == doctest::Approx(0.5).epsilon(1e-4));
}

TEST_CASE("a line blower is a plane jet along its slot") {
    const World world = make(world_desc());
    lr_blower_desc d = initialised(lr_blower_desc_init);
    set(d.direction, 1.0f, 0.0f, 0.0f);
    set(d.side, 0.3f, 0.0f, 1.0f); // projected perpendicular to z
    d.speed = 8.0f, d.nozzle_radius = 0.05f, d.range = 40.0f, d.spread = 0.1f, d.half_length = 2.0f;
    add_source(world, d);
    for (double x : {0.01, 1.0, 10.0})
        for (double y : {0.0, 0.03, 0.5})
            for (double z : {-1.9, 0.0, 1.5}) {
                const double b = 0.05 + 0.1 * x;
                const double speed = y < 4.0 * b ? 8.0 * std::sqrt(0.05 / b) * std::exp(-y * y / (b * b)) : 0.0;
                check_near(wind_at(world, {x, y, z}), {speed, 0.0, 0.0}, 2e-5);
            }
    CHECK(length(wind_at(world, {1.0, 0.0, 2.06})) == 0.0);
    CHECK(length(wind_at(world, {1.0, 0.0, -2.06})) == 0.0);
    CHECK(wind_at(world, {1.0, 0.0, 2.025})[0] ==
          doctest::Approx(0.5 * wind_at(world, {1.0, 0.0, 0.0})[0]).epsilon(1e-3));
}

TEST_CASE("the ground multiplies the uniform wind by a logarithm, and nothing else") {
    const World world = make(world_desc());
    set_wind(world, 6.0f, 0.0f, -2.0f);
    lr_ground_wind_desc d = initialised(lr_ground_wind_desc_init);
    set(d.position, 5.0f, -2.0f, 0.0f);
    set(d.normal, 0.0f, 3.0f, 0.0f);
    d.roughness_length = 0.03f, d.reference_height = 10.0f;
    add_source(world, d);
    for (double z : {0.0, 0.001, 0.03, 0.5, 2.0, 10.0, 80.0}) {
        const double factor = std::log(1.0 + z / 0.03) / std::log(1.0 + 10.0 / 0.03);
        check_near(wind_at(world, {3.0, z - 2.0, 1.0}), factor * Vec{6.0, 0.0, -2.0}, 2e-5);
    }
    CHECK(length(wind_at(world, {0.0, -2.5, 0.0})) == 0.0);
    lr_vortex_desc vortex = vortex_desc(LR_VORTEX_RANKINE);
    set(vortex.axis, 0.0f, 1.0f, 0.0f);
    add_source(world, vortex);
    CHECK(length(wind_at(world, {1.0, -2.5, 0.0})) == doctest::Approx(1.0 / (2.0 * pi)));
}

TEST_CASE("frames of a grid go on from where they are at another frame time, however old the world is") {
    const World world = make(world_desc());
    lr_wind_grid_desc d = initialised(lr_wind_grid_desc_init);
    const float values[5] = {0.0f, 10.0f, 40.0f, 20.0f, -30.0f};
    std::vector<float> samples;
    for (float v : values) samples.insert(samples.end(), {v, 0.0f, 0.0f});
    for (uint32_t& n : d.counts) n = 1;
    d.frames = 5, d.frame_time = 0.5f, d.outside = LR_WIND_OUTSIDE_CLAMP;
    d.samples = samples.data();
    const lr_wind_source source = add_source(world, d);
    d.samples = nullptr;
    steps(world, 3600, 1.0f, 1);
    steps(world, 1, 0.25f, 1); // frame 7200.5
    double frame = 0.5;
    const auto check = [&](const World& w) {
        const double whole = std::floor(frame), part = frame - whole;
        const auto at = [&](double i) { return wide(values[static_cast<size_t>(i) % 5]); };
        CHECK(std::abs(wind_at(w, {})[0] - (1.0 - part) * at(whole) - part * at(whole + 1.0)) < 2e-4);
    };
    check(world);
    for (int i = 0; i < 100; ++i) {
        d.frame_time = i % 9 == 0 ? 1e-3f : 0.2f + 0.01f * static_cast<float>(i);
        REQUIRE(lr_world_update_wind_grid(world.get(), source, &d) == LR_OK);
        check(world);
        steps(world, 1, 0.125f, 1);
        frame += 0.125 / wide(d.frame_time);
        check(world);
    }
    // It is state: of hash and snapshot.
    const std::vector<unsigned char> saved = snapshot_of(world);
    const uint64_t hash = hash_of(world);
    d.frame_time = 2.0f;
    REQUIRE(lr_world_update_wind_grid(world.get(), source, &d) == LR_OK);
    steps(world, 1, 0.125f, 1);
    REQUIRE(lr_world_snapshot_restore(world.get(), saved.data(), saved.size()) == LR_OK);
    CHECK(hash_of(world) == hash);
    check(world);
    // Another number of frames is another loop.
    d.frames = 4, d.samples = samples.data();
    REQUIRE(lr_world_update_wind_grid(world.get(), source, &d) == LR_OK);
    frame = 3612.75 / 2.0 - 1804.0; // 3612.75 s by now
    check(world);
}

TEST_CASE("a grid is exact for what is linear in each direction and in time") {
    const World world = make(world_desc());
    const auto linear = [](double i, double j, double k, double frame) {
        return Vec{1.0 + 0.5 * i - 0.25 * j + 2.0 * frame, i * j * 0.1 + k, 3.0 - k * i * 0.05 + frame * j};
    };
    lr_wind_grid_desc d = initialised(lr_wind_grid_desc_init);
    d.counts[0] = 5, d.counts[1] = 3, d.counts[2] = 4, d.frames = 2;
    std::vector<float> samples;
    for (int f = 0; f < 2; ++f)
        for (int k = 0; k < 4; ++k)
            for (int j = 0; j < 3; ++j)
                for (int i = 0; i < 5; ++i)
                    for (double v : linear(i, j, k, f)) samples.push_back(narrow(v));
    d.samples = samples.data();
    set(d.position, -1.0f, 0.5f, 2.0f);
    set(d.velocity, 0.25f, 0.0f, -0.5f);
    set(d.spacing, 0.5f, 1.0f, 2.0f);
    d.frame_time = 4.0f;
    add_source(world, d);
    std::fill(samples.begin(), samples.end(), 0.0f); // the library has copied them
    steps(world, 1, 1.0f, 1);                        // a quarter of the first frame
    Random random(8);
    for (int n = 0; n < 300; ++n) {
        const Vec at = {random.uniform(0.0, 4.0), random.uniform(0.0, 2.0), random.uniform(0.0, 3.0)};
        const Vec x = {-0.75 + 0.5 * at[0], 0.5 + at[1], 1.5 + 2.0 * at[2]};
        check_near(wind_at(world, x), linear(at[0], at[1], at[2], 0.25), 1e-5);
    }
    CHECK(length(wind_at(world, {-0.76, 1.0, 3.0})) == 0.0);
    CHECK(length(wind_at(world, {0.0, 2.6, 3.0})) == 0.0);
    // From the second frame to the first, then again.
    steps(world, 5, 1.0f, 1);
    check_near(wind_at(world, {-1.0 + 1.5 + 0.5, 1.5, 2.0 - 3.0 + 2.0}), linear(1.0, 1.0, 1.0, 0.5), 1e-5);
    const Vec before = wind_at(world, {0.6, 1.7, 1.2});
    steps(world, 8, 1.0f, 1);
    check_near(wind_at(world, {0.6 + 2.0, 1.7, 1.2 - 4.0}), before, 1e-5);
}

TEST_CASE("outside its samples a grid is nothing, its border, or itself again") {
    const World worlds[3] = {make(world_desc()), make(world_desc()), make(world_desc())};
    std::vector<float> samples;
    for (int i = 0; i < 4; ++i) samples.insert(samples.end(), {static_cast<float>(i + 1), 0.0f, 0.0f});
    for (int32_t outside = 0; outside < 3; ++outside) {
        lr_wind_grid_desc d = initialised(lr_wind_grid_desc_init);
        d.counts[0] = 4, d.counts[1] = d.counts[2] = 1;
        d.outside = outside;
        d.samples = samples.data();
        add_source(worlds[outside], d);
    }
    const auto along = [&](int32_t outside, double x) { return wind_at(worlds[outside], {x, 0.0, 0.0})[0]; };
    CHECK(along(LR_WIND_OUTSIDE_ZERO, 3.0) == 4.0);
    CHECK(along(LR_WIND_OUTSIDE_ZERO, 3.01) == 0.0);
    CHECK(along(LR_WIND_OUTSIDE_ZERO, -0.01) == 0.0);
    CHECK(along(LR_WIND_OUTSIDE_CLAMP, 300.0) == 4.0);
    CHECK(along(LR_WIND_OUTSIDE_CLAMP, -300.0) == 1.0);
    for (double x : {-8.0, -4.0, 0.0, 4.0, 40.0}) {
        CHECK(along(LR_WIND_OUTSIDE_REPEAT, x + 1.5) == doctest::Approx(2.5));
        CHECK(along(LR_WIND_OUTSIDE_REPEAT, x + 3.5) == doctest::Approx(2.5)); // from the last to the first
    }
    CHECK(wind_at(worlds[1], {1.0, 50.0, -7.0})[0] == 2.0); // one sample thick
    CHECK(wind_at(worlds[2], {1.0, 50.25, -7.5})[0] == 2.0);
}

TEST_CASE("sources add up, however many and wherever they are") {
    const World world = make(world_desc());
    set_wind(world, 1.0f, 2.0f, 3.0f);
    Random random(6);
    const Vec x = {0.3, 0.2, 0.1};
    Vec sum = wind_at(world, x);
    std::vector<lr_wind_source> sources;
    for (uint32_t i = 0; i < LR_MAX_WIND_SOURCES; ++i) {
        lr_vortex_desc vortex = vortex_desc();
        lr_blower_desc blower = initialised(lr_blower_desc_init);
        for (float& p : vortex.position) p = random.real(-3.0, 3.0);
        for (float& a : vortex.axis) a = random.real(-1.0, 1.0);
        std::copy(vortex.position, vortex.position + 3, blower.position);
        std::copy(vortex.axis, vortex.axis + 3, blower.direction);
        if (i % 3 == 0) vortex.outer_radius = vortex.half_length = 2.0f, blower.range = 3.0f;
        const AnySource d = i % 2 ? AnySource(vortex) : AnySource(blower);
        const World alone = make(world_desc());
        add_source(alone, d);
        sum = sum + wind_at(alone, x);
        sources.push_back(add_source(world, d));
    }
    check_near(wind_at(world, x), sum, 1e-5);
    lr_wind_source one_more{7};
    const lr_vortex_desc d = vortex_desc(LR_VORTEX_RANKINE);
    CHECK(lr_world_add_vortex(world.get(), &d, &one_more) == LR_ERROR_CAPACITY);
    CHECK(one_more.id == 0);
    for (lr_wind_source s : sources) CHECK(lr_world_remove_wind(world.get(), s) == LR_OK);
    check_near(wind_at(world, x), {1.0, 2.0, 3.0}, 0.0);
}

TEST_CASE("sources with lengths, times and grounds at the ends of their ranges give finite wind and lose no body") {
    const auto check_sound = [](const char* what, const AnySource& any, int count = 1, float height = 0.0f) {
        CAPTURE(what);
        const World world = make(world_desc());
        const lr_batch batch = add_batch(world, leaf(), 2);
        set_wind(world, 2.0f, 0.0f, 0.0f);
        for (int i = 0; i < count; ++i) add_source(world, any);
        lr_body_desc d = body_desc();
        for (float x : {0.0f, 1.0f}) {
            set(d.position, x, height, 0.0f);
            add_body(world, batch, d);
        }
        steps(world, 3, 1.0f / 60.0f, 2);
        CHECK(length(wind_at(world, {0.0, wide(height), 0.0})) < 1e9);
        lr_batch_counts counts = initialised(lr_batch_counts_init);
        REQUIRE(lr_batch_get_counts(world.get(), batch, &counts) == LR_OK);
        CHECK(counts.total_diverged == 0);
    };
    for (float least : {1e-45f, 1e-38f, 1e-20f}) {
        lr_vortex_desc vortex = vortex_desc();
        vortex.outer_radius = least;
        check_sound("outer radius", vortex);
        vortex.outer_radius = 0.0f, vortex.half_length = least;
        check_sound("half length", vortex);
        lr_turbulence_desc turbulence = initialised(lr_turbulence_desc_init);
        turbulence.eddy_life = least;
        check_sound("eddy life", turbulence);
        lr_gusts_desc gusts = initialised(lr_gusts_desc_init);
        gusts.integral_time = least;
        check_sound("integral time", gusts);
        const std::vector<float> samples(9, 1.0f);
        lr_wind_grid_desc grid = initialised(lr_wind_grid_desc_init);
        grid.counts[0] = grid.counts[1] = grid.counts[2] = 1, grid.frames = 3;
        grid.samples = samples.data();
        grid.outside = LR_WIND_OUTSIDE_CLAMP;
        grid.frame_time = least;
        check_sound("frame time", grid);
    }
    lr_ground_wind_desc ground = initialised(lr_ground_wind_desc_init);
    ground.roughness_length = ground.reference_height = 1e-4f;
    check_sound("many grounds", ground, LR_MAX_WIND_SOURCES, 1e9f);
}

TEST_CASE("samples are the same bits on every instruction set, in any number and order") {
    const std::vector<float> samples = grid_samples();
    const World world = make(world_desc());
    set_wind(world, 2.0f, 0.0f, -1.0f);
    for (const AnySource& d : one_of_each(samples)) add_source(world, d);
    steps(world, 3, 0.37f, 1);
    Random random(1);
    std::vector<float> positions, expected, got;
    for (int i = 0; i < 3000; ++i) positions.push_back(random.real(-6.0, 6.0));
    for (float far : {1e9f, -1e9f, 1e5f}) positions.insert(positions.end(), {far, 0.5f, -far});
    samples_of(world, positions, expected);
    for (float v : expected) CHECK(std::isfinite(v));
    for (int32_t target : simd_targets()) {
        REQUIRE(lr_world_set_simd_target(world.get(), target) == LR_OK);
        samples_of(world, positions, got);
        CHECK(got == expected);
    }
    std::vector<float> one(3);
    size_t wrong = 0;
    for (size_t i = 0; i < positions.size(); i += 3) {
        samples_of(world, {positions[i], positions[i + 1], positions[i + 2]}, one);
        wrong += !std::equal(one.begin(), one.end(), expected.begin() + static_cast<std::ptrdiff_t>(i));
    }
    CHECK(wrong == 0);
    got = positions; // in place
    REQUIRE(lr_world_sample_wind(world.get(), got.data(), static_cast<uint32_t>(got.size() / 3), got.data()) == LR_OK);
    CHECK(got == expected);
}
