// Places, times and poses of spawned bodies.
#include "support/contact_events.h"
#include "support/lifecycle.h"
#include "support/random.h"
#include "support/vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <numbers>
#include <set>

using namespace test;

namespace {

struct Source {
    Asset asset = leaf();
    World world = make(world_desc());
    lr_batch batch;
    explicit Source(uint32_t capacity = 20000) : batch(add_batch(world, asset, capacity)) {}

    std::vector<lr_body_state> bodies(const lr_emitter_desc& d, uint32_t count) const {
        set_emitter(world, batch, d);
        std::vector<lr_body_state> out;
        for (lr_body id : emit(world, batch, count)) out.push_back(state_of(world, id));
        return out;
    }
};

constexpr uint32_t many = 20000;

// Mean and mean square of a uniform variable between low and high, to five standard errors.
void check_even(const std::vector<double>& values, double low, double high) {
    double sum = 0.0, square = 0.0;
    for (double v : values) {
        const double u = (v - low) / (high - low);
        sum += u, square += u * u;
    }
    const double n = static_cast<double>(values.size());
    CHECK(*std::min_element(values.begin(), values.end()) >= low - 1e-5 * (high - low));
    CHECK(*std::max_element(values.begin(), values.end()) <= high + 1e-5 * (high - low));
    CHECK(std::abs(sum / n - 0.5) < 5.0 * std::sqrt(1.0 / 12.0 / n));
    CHECK(std::abs(square / n - 1.0 / 3.0) < 5.0 * std::sqrt(4.0 / 45.0 / n));
}

template <class Value> std::vector<double> values_of(const std::vector<lr_body_state>& bodies, Value&& value) {
    std::vector<double> out;
    for (const lr_body_state& s : bodies) out.push_back(value(s));
    return out;
}

} // namespace

TEST_CASE("shapes are filled evenly, where they are and as they are turned") {
    lr_emitter_desc d = emitter_desc();
    const Vec centre{3.0, -2.0, 1.0};
    const Quat turn = about({1.0, 2.0, -0.5}, 0.8);
    for (size_t i = 0; i < 3; ++i) {
        d.position[i] = narrow(centre[i]);
        d.size[i] = 0.5f * static_cast<float>(i + 1);
    }
    for (size_t i = 0; i < 4; ++i) d.orientation[i] = narrow(3.0 * turn[i]); // normalised when taken
    const auto local = [&](const lr_body_state& s) {
        Vec p = to_body(turn, vec(s.position) - centre);
        for (size_t i = 0; i < 3; ++i) p[i] /= wide(d.size[i]);
        return p;
    };
    SUBCASE("point") {
        for (const lr_body_state& s : Source().bodies(d, 50)) CHECK(length(vec(s.position) - centre) < 1e-6);
    }
    SUBCASE("box") {
        d.shape = LR_EMIT_BOX;
        const auto bodies = Source().bodies(d, many);
        for (size_t i = 0; i < 3; ++i)
            check_even(values_of(bodies, [&](const lr_body_state& s) { return local(s)[i]; }), -1.0, 1.0);
    }
    SUBCASE("sphere") {
        d.shape = LR_EMIT_SPHERE;
        const auto bodies = Source().bodies(d, many);
        check_even(values_of(bodies, [&](const lr_body_state& s) { return std::pow(length(local(s)), 3.0); }), 0.0,
                   1.0);
        check_even(values_of(bodies,
                             [&](const lr_body_state& s) {
                                 const Vec p = local(s);
                                 return p[2] / length(p);
                             }),
                   -1.0, 1.0);
    }
    SUBCASE("disc") {
        d.shape = LR_EMIT_DISC;
        const auto bodies = Source().bodies(d, many);
        check_even(values_of(bodies,
                             [&](const lr_body_state& s) {
                                 const Vec p = local(s);
                                 return p[0] * p[0] + p[1] * p[1];
                             }),
                   0.0, 1.0);
        for (const lr_body_state& s : bodies)
            if (std::abs(local(s)[2]) > 1e-5) FAIL("out of the disc");
    }
    SUBCASE("surface of a sphere") {
        d.shape = LR_EMIT_SPHERE_SURFACE;
        for (float& s : d.size) s = 2.0f;
        const auto bodies = Source().bodies(d, many);
        for (size_t i = 0; i < 3; ++i)
            check_even(values_of(bodies, [&](const lr_body_state& s) { return local(s)[i]; }), -1.0, 1.0);
        for (const lr_body_state& s : bodies)
            if (std::abs(length(local(s)) - 1.0) > 1e-5) FAIL("off the sphere");
    }
    SUBCASE("surface of a box") {
        d.shape = LR_EMIT_BOX_SURFACE;
        const auto bodies = Source().bodies(d, many);
        double on[3] = {};
        for (const lr_body_state& s : bodies) {
            const Vec p = local(s);
            size_t face = 0;
            for (size_t i = 1; i < 3; ++i)
                if (std::abs(p[i]) > std::abs(p[face])) face = i;
            if (std::abs(std::abs(p[face]) - 1.0) > 1e-5) FAIL("off the box");
            on[face] += 1.0 / many;
        }
        // Half extents 1:2:3: areas 6:3:2.
        CHECK(std::abs(on[0] - 6.0 / 11.0) < 0.02);
        CHECK(std::abs(on[1] - 3.0 / 11.0) < 0.02);
        CHECK(std::abs(on[2] - 2.0 / 11.0) < 0.02);
    }
}

TEST_CASE("velocities fill a cone, spins have any axis, scales and speeds lie evenly between their limits") {
    lr_emitter_desc d = emitter_desc();
    d.direction[0] = 2.0f, d.direction[1] = -1.0f, d.direction[2] = 0.5f;
    d.speed_min = 1.0f, d.speed_max = 3.0f;
    d.spin_min = 2.0f, d.spin_max = 5.0f;
    d.scale_min = 0.5f, d.scale_max = 2.0f;
    const Vec axis = 1.0 / length(vec(d.direction)) * vec(d.direction);
    for (double spread : {0.0, 0.4, 0.5 * std::numbers::pi, std::numbers::pi}) {
        d.spread = narrow(spread);
        const auto bodies = Source().bodies(d, many);
        const auto speed = [](const lr_body_state& s) { return length(vec(s.linear_velocity)); };
        const auto along = [&](const lr_body_state& s) { return dot(axis, vec(s.linear_velocity)) / speed(s); };
        check_even(values_of(bodies, speed), 1.0, 3.0);
        if (spread > 0.0)
            check_even(values_of(bodies, along), std::cos(spread), 1.0);
        else
            for (const lr_body_state& s : bodies)
                if (along(s) < 1.0 - 1e-6) FAIL("aside");
        Vec mean{};
        for (const lr_body_state& s : bodies) mean = mean + 1.0 / (many * speed(s)) * vec(s.linear_velocity);
        CHECK(length(mean - dot(mean, axis) * axis) < 5.0 / std::sqrt(many));
        const auto spin = [](const lr_body_state& s) { return length(vec(s.angular_velocity)); };
        check_even(values_of(bodies, spin), 2.0, 5.0);
        for (size_t i = 0; i < 3; ++i)
            check_even(values_of(bodies, [&](const lr_body_state& s) { return wide(s.angular_velocity[i]) / spin(s); }),
                       -1.0, 1.0);
        check_even(values_of(bodies, [](const lr_body_state& s) { return wide(s.scale); }), 0.5, 2.0);
    }
}

TEST_CASE("orientations are all alike, or the one that is given") {
    lr_emitter_desc d = emitter_desc();
    const auto bodies = Source().bodies(d, many);
    // Each column of a random rotation is a random direction.
    for (size_t row = 0; row < 3; ++row)
        for (size_t column = 0; column < 3; ++column)
            check_even(
                values_of(bodies, [&](const lr_body_state& s) { return rotation(quat(s.orientation))[row][column]; }),
                -1.0, 1.0);
    d.pose = LR_POSE_FIXED;
    d.body_orientation[0] = 4.0f, d.body_orientation[3] = 3.0f;
    for (const lr_body_state& s : Source().bodies(d, 20)) {
        CHECK(wide(s.orientation[0]) == doctest::Approx(0.8));
        CHECK(s.orientation[1] == 0.0f);
        CHECK(wide(s.orientation[3]) == doctest::Approx(0.6));
    }
}

TEST_CASE("a spawn depends on seed and noise seed, not on earlier spawns") {
    lr_emitter_desc d = emitter_desc();
    d.shape = LR_EMIT_SPHERE;
    d.size[0] = d.size[1] = d.size[2] = 1.0f;
    const Source one, other;
    const auto a = one.bodies(d, 100);
    add_body(other.world, other.batch, body_desc()); // takes the first noise seed
    const auto b = other.bodies(d, 99);
    std::set<float> places;
    for (size_t i = 0; i < 99; ++i) {
        CHECK(same_bits(a[i + 1], b[i]));
        places.insert(b[i].position[0]);
    }
    CHECK(places.size() > 95);
    lr_world_desc wd = world_desc();
    wd.seed = 1;
    Source seeded;
    seeded.world = make(wd);
    seeded.batch = add_batch(seeded.world, seeded.asset, 100);
    CHECK_FALSE(same_bits(seeded.bodies(d, 100)[0], a[0]));
}

TEST_CASE("bodies are spawned at their rate and in bursts, up to the capacity") {
    const Source s(1000);
    lr_emitter_desc d = emitter_desc();
    d.rate = 100.0f;
    set_emitter(s.world, s.batch, d);
    keep_events(s.world);
    uint64_t spawned = 0;
    for (int i = 1; i <= 200; ++i) {
        steps(s.world, 1, 0.015625f, 2);
        const lr_batch_counts e = counts_of(s.world, s.batch);
        spawned += e.spawned;
        CHECK(spawned == static_cast<uint64_t>(100.0 * 0.015625 * i));
        CHECK(info_of(s.world).body_count == spawned);
        const std::vector<lr_event> told = events_of(s.world);
        REQUIRE(told.size() == e.spawned);
        for (const lr_event& event : told)
            CHECK((event.kind == LR_EVENT_SPAWNED && state_of(s.world, event.body).age == 0.0f));
        // Another emitter continues with the half body that is due.
        if (i % 2 == 0) set_emitter(s.world, s.batch, d);
    }
    d.rate = 0.0f;
    d.burst_count = 300;
    d.burst_interval = 0.25f;
    set_emitter(s.world, s.batch, d);
    steps(s.world, 15, 0.015625f); // 0.234 s
    CHECK(info_of(s.world).body_count == spawned);
    steps(s.world, 1, 0.015625f);
    CHECK(info_of(s.world).body_count == spawned + 300);
    steps(s.world, 1, 0.5f, 8); // two bursts, without room
    const lr_batch_counts e = counts_of(s.world, s.batch);
    CHECK(e.spawned == 1000 - spawned - 300);
    CHECK(e.missed == 600 - e.spawned);
    CHECK(info_of(s.world).body_count == 1000);
    CHECK(e.total_spawned == 1000);
    CHECK(e.total_missed == e.missed);
    REQUIRE(lr_batch_set_emitter(s.world.get(), s.batch, nullptr) == LR_OK);
    steps(s.world, 5, 0.5f, 8);
    CHECK(counts_of(s.world, s.batch).missed == 0);
}

TEST_CASE("emitting by hand is all or none") {
    const Source s(10);
    CHECK(lr_batch_spawn(s.world.get(), s.batch, 1, nullptr) == LR_ERROR_INVALID_ARGUMENT);
    set_emitter(s.world, s.batch, emitter_desc());
    CHECK(lr_batch_spawn(s.world.get(), s.batch, 11, nullptr) == LR_ERROR_CAPACITY);
    CHECK(lr_batch_spawn(s.world.get(), s.batch, 0, nullptr) == LR_OK);
    CHECK(info_of(s.world).body_count == 0);
    CHECK(lr_batch_spawn(s.world.get(), s.batch, 7, nullptr) == LR_OK);
    CHECK(lr_batch_spawn(s.world.get(), s.batch, 0xffffffffu, nullptr) == LR_ERROR_CAPACITY);
    CHECK(emit(s.world, s.batch, 3).back().id != 0);
    CHECK(lr_batch_spawn(s.world.get(), s.batch, 1, nullptr) == LR_ERROR_CAPACITY);
    CHECK(lr_batch_spawn(s.world.get(), {}, 1, nullptr) == LR_ERROR_STALE_BATCH);
    CHECK(info_of(s.world).body_count == 10);
}

TEST_CASE("a box is filled without an emitter, as an emitter would") {
    const float low[3] = {-1.5f, 0.1f, 2.0f}, high[3] = {2.5f, 0.3f, 2.0f};
    const Source box, source;
    keep_events(box.world, 2 * many);
    const uint64_t bytes = info_of(box.world).memory_bytes;
    std::vector<lr_body> ids(many);
    REQUIRE(lr_batch_spawn_box(box.world.get(), box.batch, low, high, many, ids.data()) == LR_OK);
    CHECK(info_of(box.world).memory_bytes == bytes);
    CHECK(counts_of(box.world, box.batch).total_spawned == 0);
    std::vector<lr_body_state> bodies;
    for (lr_body id : ids) bodies.push_back(state_of(box.world, id));
    for (size_t i = 0; i < 2; ++i)
        check_even(values_of(bodies, [&](const lr_body_state& s) { return wide(s.position[i]); }), wide(low[i]),
                   wide(high[i]));
    lr_emitter_desc d = emitter_desc();
    d.shape = LR_EMIT_BOX;
    for (size_t i = 0; i < 3; ++i) d.position[i] = 0.5f * (low[i] + high[i]), d.size[i] = 0.5f * (high[i] - low[i]);
    const std::vector<lr_body_state> emitted = source.bodies(d, many);
    CHECK(std::memcmp(bodies.data(), emitted.data(), many * sizeof(lr_body_state)) == 0);
    steps(box.world, 1, 0.01f);
    CHECK(count_of(events_of(box.world), LR_EVENT_SPAWNED) == many);
}

TEST_CASE("a box is filled all or none") {
    const Source s(10);
    const auto fill = [&](std::array<float, 3> low, std::array<float, 3> high, uint32_t count) {
        return lr_batch_spawn_box(s.world.get(), s.batch, low.data(), high.data(), count, nullptr);
    };
    CHECK(fill({}, {}, 11) == LR_ERROR_CAPACITY);
    CHECK(fill({}, {}, 0xffffffffu) == LR_ERROR_CAPACITY);
    CHECK(fill({0.0f, 0.1f, 0.0f}, {}, 1) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(fill({-1.1e9f, 0.0f, 0.0f}, {}, 1) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(fill({}, {0.0f, 0.0f, 1.1e9f}, 1) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(fill({std::numeric_limits<float>::quiet_NaN(), 0.0f, 0.0f}, {}, 0) == LR_ERROR_NOT_FINITE);
    CHECK(fill({}, {0.0f, std::numeric_limits<float>::infinity(), 0.0f}, 1) == LR_ERROR_NOT_FINITE);
    CHECK(fill({}, {}, 0) == LR_OK);
    CHECK(info_of(s.world).body_count == 0);
    const float corner[3] = {};
    CHECK(lr_batch_spawn_box(s.world.get(), {}, corner, corner, 1, nullptr) == LR_ERROR_STALE_BATCH);
    CHECK(fill({-1e9f, -1e9f, -1e9f}, {1e9f, 1e9f, 1e9f}, 7) == LR_OK);
    set_emitter(s.world, s.batch, emitter_desc());
    CHECK(fill({}, {}, 3) == LR_OK);
    CHECK(counts_of(s.world, s.batch).total_spawned == 3); // with an emitter they count
    CHECK(fill({}, {}, 1) == LR_ERROR_CAPACITY);
}

TEST_CASE("impossible emitters are refused and change nothing") {
    const Source s(10);
    lr_emitter_desc good = emitter_desc();
    good.rate = 10.0f;
    set_emitter(s.world, s.batch, good);
    const std::vector<unsigned char> before = snapshot_of(s.world);
    const auto refused = [&](const std::function<void(lr_emitter_desc&)>& spoil) {
        lr_emitter_desc d = good;
        spoil(d);
        const lr_status status = lr_batch_set_emitter(s.world.get(), s.batch, &d);
        CHECK(snapshot_of(s.world) == before);
        return status;
    };
    constexpr lr_status invalid = LR_ERROR_INVALID_ARGUMENT;
    // Every float: from `position` up to `pose`, from behind it up to `burst_count`.
    for (size_t at = offsetof(lr_emitter_desc, position); at < offsetof(lr_emitter_desc, burst_count); at += 4)
        if (at != offsetof(lr_emitter_desc, pose))
            for (float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e30f})
                CHECK(refused([&](lr_emitter_desc& d) { std::memcpy(reinterpret_cast<char*>(&d) + at, &bad, 4); }) ==
                      (std::isfinite(bad) ? invalid : LR_ERROR_NOT_FINITE));
    CHECK(refused([](lr_emitter_desc& d) { d.shape = -1; }) == invalid);
    CHECK(refused([](lr_emitter_desc& d) { d.shape = 6; }) == invalid);
    CHECK(refused([](lr_emitter_desc& d) { d.pose = 2; }) == invalid);
    CHECK(refused([](lr_emitter_desc& d) { d.size[1] = -1.0f; }) == invalid);
    CHECK(refused([](lr_emitter_desc& d) { d.orientation[3] = 0.0f; }) == invalid);
    CHECK(refused([](lr_emitter_desc& d) { d.body_orientation[3] = 0.0f; }) == invalid);
    CHECK(refused([](lr_emitter_desc& d) { d.direction[1] = 0.0f; }) == invalid);
    CHECK(refused([](lr_emitter_desc& d) { d.spread = -0.1f; }) == invalid);
    CHECK(refused([](lr_emitter_desc& d) { d.spread = 3.2f; }) == invalid);
    CHECK(refused([](lr_emitter_desc& d) { d.speed_min = 1.0f; }) == invalid);
    CHECK(refused([](lr_emitter_desc& d) { d.spin_min = 1.0f; }) == invalid);
    CHECK(refused([](lr_emitter_desc& d) { d.scale_min = 0.0f; }) == invalid);
    CHECK(refused([](lr_emitter_desc& d) { d.scale_max = 0.5f; }) == invalid);
    CHECK(refused([](lr_emitter_desc& d) { d.rate = -1.0f; }) == invalid);
    CHECK(refused([](lr_emitter_desc& d) { d.burst_interval = -1.0f; }) == invalid);
    CHECK(refused([](lr_emitter_desc& d) { d.burst_count = 1; }) == invalid); // without an interval
    CHECK(refused([](lr_emitter_desc& d) { d.burst_count = 0xffffffffu, d.burst_interval = 1.0f; }) == invalid);
    CHECK(refused([](lr_emitter_desc& d) { d.reserved = 1; }) == invalid);
    CHECK(lr_batch_set_emitter(s.world.get(), {}, &good) == LR_ERROR_STALE_BATCH);
}
