// Very old worlds: counters past 32 bits, and times beyond a float's precision. A snapshot with a replaced number sets them.
// docs/maintainers/testing.md
#include "support/lifecycle.h"
#include "support/reseal_snapshot.h"
#include "support/water.h"
#include "support/wind.h"

#include <algorithm>
#include <cmath>
#include <functional>

using namespace test;

namespace {

// Replaces `from`, which must occur once in a snapshot.
template <class T> void replace(std::vector<unsigned char>& bytes, T from, T to) {
    size_t found = 0;
    std::vector<size_t> places;
    for (size_t at = 0; at + sizeof(T) <= bytes.size(); at += sizeof(T)) {
        T value;
        std::memcpy(&value, bytes.data() + at, sizeof(T));
        if (std::memcmp(&value, &from, sizeof(T)) == 0) places.push_back(at), ++found;
    }
    REQUIRE_MESSAGE(found == 1, "places: ", found);
    std::memcpy(bytes.data() + places[0], &to, sizeof(T));
    seal(bytes);
}
void restore(const World& w, const std::vector<unsigned char>& bytes) {
    REQUIRE(lr_world_snapshot_restore(w.get(), bytes.data(), bytes.size()) == LR_OK);
}

constexpr uint32_t many = 4096;
constexpr uint64_t wrap = uint64_t{1} << 32;

// Velocities from noise alone over a number of substeps, from substep `begin` on.
std::vector<double> noise_from(uint64_t begin, uint32_t substeps, int32_t loads) {
    const World w = weightless(3);
    const Asset asset = leaf();
    lr_batch_desc d = batch_desc();
    d.load_model = loads;
    const lr_batch batch = add_batch(w, d, asset, many);
    constexpr uint32_t before = 9973; // a number that occurs nowhere else
    steps(w, 1, 0.5f, before);
    std::vector<unsigned char> bytes = snapshot_of(w);
    replace<uint64_t>(bytes, before, begin);
    restore(w, bytes);
    set_wind(w, 1.0f, 0.0f, 0.0f); // turbulence grows with speed
    const std::vector<lr_body_desc> bodies(many, body_desc());
    REQUIRE(lr_body_create(w.get(), batch, bodies.data(), many, nullptr) == LR_OK);
    steps(w, 1, 0.01f * static_cast<float>(substeps), substeps);
    CHECK(info_of(w).substep_count == begin + substeps);
    const std::vector<Velocity> all = velocities_of(w, batch);
    std::vector<double> out;
    for (size_t k = 0; k < 3; ++k)
        for (const Velocity& v : all) out.push_back(wide(v.angular[k]));
    return out;
}

double mean_of(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum / static_cast<double>(a.size());
}

// A second of samples at 60 Hz: the largest step, and the largest change from one step to the next.
struct Smoothness {
    double step = 0.0, bend = 0.0;
    int still = 0; // steps without motion
};
Smoothness smoothness(const std::function<double()>& next) {
    Smoothness s;
    double before = next(), last = next();
    for (int i = 0; i < 1200; ++i) {
        const double now = next();
        s.step = std::max(s.step, std::abs(now - last));
        s.bend = std::max(s.bend, std::abs(now - 2.0 * last + before));
        s.still += now == last;
        before = last;
        last = now;
    }
    return s;
}

// A world at this time, with the sources that `add` created at its beginning.
World at_time(double time, const std::function<void(const World&)>& add) {
    World w = make(world_desc());
    add(w);
    steps(w, 1, 0.3f, 1);
    std::vector<unsigned char> bytes = snapshot_of(w);
    if (time > 0.0) replace(bytes, static_cast<double>(0.3f), time);
    restore(w, bytes);
    return w;
}

} // namespace

TEST_CASE("noise goes on past 2^32 substeps: as strong as before, and another") {
    for (int32_t loads : {LR_LOADS_LANGEVIN, LR_LOADS_AERODYNAMIC}) {
        CAPTURE(loads);
        constexpr uint32_t n = 24;
        const uint64_t begin = 5003;
        const std::vector<double> early = noise_from(begin, n, loads);
        const double variance = mean_of(early, early);
        REQUIRE(variance > 0.0);
        CHECK(noise_from(begin, n, loads) == early);
        const double least = 5.0 / std::sqrt(static_cast<double>(early.size()));
        for (uint64_t late : {begin + wrap, begin + 2 * wrap, wrap - n / 2, (begin << 32) + 1, UINT64_MAX / 2}) {
            CAPTURE(late);
            const std::vector<double> other = noise_from(late, n, loads);
            const double other_variance = mean_of(other, other);
            CHECK(other_variance == doctest::Approx(variance).epsilon(0.1));
            CHECK(std::abs(mean_of(early, other)) < least * std::sqrt(variance * other_variance));
        }
    }
}

TEST_CASE("a world goes through its 2^32nd substep within a step, on every instruction set alike" *
          doctest::test_suite("native")) {
    const Asset asset = leaf();
    std::vector<uint64_t> hashes;
    for (int32_t target : simd_targets()) {
        lr_world_desc wd = world_desc();
        wd.simd_target = target;
        const World w = make(wd);
        const lr_batch batch = add_batch(w, langevin(), asset, 100);
        steps(w, 1, 0.5f, 9973);
        std::vector<unsigned char> bytes = snapshot_of(w);
        replace<uint64_t>(bytes, 9973, wrap - 20);
        restore(w, bytes);
        const std::vector<lr_body_desc> bodies(100, body_desc());
        REQUIRE(lr_body_create(w.get(), batch, bodies.data(), 100, nullptr) == LR_OK);
        steps(w, 5, 0.0625f, 8);
        CHECK(info_of(w).substep_count == wrap + 20);
        hashes.push_back(hash_of(w));
    }
    for (uint64_t hash : hashes) CHECK(hash == hashes[0]);
}

TEST_CASE("totals of spawns and ends go past 2^32") {
    const World w = make(world_desc());
    const Asset asset = leaf();
    const lr_batch batch = add_batch(w, asset, 8);
    set_emitter(w, batch, emitter_desc());
    lr_batch_rules r = rules_desc();
    r.max_age = 0.015f;
    r.action = LR_END_RESPAWN;
    set_rules(w, batch, r);
    emit(w, batch, 7);
    steps(w, 202, 0.01f); // 7 in every second step
    const uint64_t respawned = counts_of(w, batch).total_respawned;
    REQUIRE(respawned == 707);
    std::vector<unsigned char> bytes = snapshot_of(w);
    replace<uint64_t>(bytes, respawned, wrap - 3);
    restore(w, bytes);
    steps(w, 2, 0.01f);
    CHECK(counts_of(w, batch).total_respawned == wrap + 4);
    CHECK(counts_of(w, batch).respawned + 0u == (counts_of(w, batch).respawned == 0 ? 0u : 7u));
    restore(w, snapshot_of(w));
    CHECK(counts_of(w, batch).total_respawned == wrap + 4);
}

TEST_CASE("after 2^32 bodies noise seeds begin again, without the 0 that no body has") {
    const World w = make(world_desc());
    const Asset asset = leaf();
    const lr_batch batch = add_batch(w, asset, 1000);
    set_emitter(w, batch, emitter_desc());
    const std::vector<lr_body> first = emit(w, batch, 775);
    REQUIRE(lr_body_destroy(w.get(), first.data(), 775) == LR_OK);
    std::vector<unsigned char> bytes = snapshot_of(w);
    // The slots' queue has each slot's number with its highest bit set; the header has the next noise seed without.
    replace<uint32_t>(bytes, 776, UINT32_MAX - 1);
    restore(w, bytes);
    std::vector<uint32_t> noise_seeds;
    for (lr_body body : emit(w, batch, 5)) noise_seeds.push_back(state_of(w, body).noise_seed);
    CHECK(noise_seeds == std::vector<uint32_t>{UINT32_MAX - 1, UINT32_MAX, 1, 2, 3});
    steps(w, 10, 0.01f);
    for (uint32_t i = 0; i < 5; ++i) CHECK(std::isfinite(view_of(w, batch).position[1][i]));
}

TEST_CASE("wind is as smooth after a day, after months and after decades as at first") {
    const std::vector<float> samples = grid_samples();
    lr_gusts_desc gusts = initialised(lr_gusts_desc_init);
    gusts.rms = 2.0f, gusts.integral_time = 3.0f, gusts.angle_rms = 0.4f;
    lr_turbulence_desc turbulence = initialised(lr_turbulence_desc_init);
    turbulence.rms = 2.0f, turbulence.integral_length = 0.7f, turbulence.eddy_life = 3.0f;
    lr_wind_grid_desc grid = initialised(lr_wind_grid_desc_init);
    grid.counts[0] = 4, grid.counts[1] = 3, grid.counts[2] = 5, grid.frames = 3, grid.frame_time = 3.0f;
    grid.samples = samples.data();
    grid.outside = LR_WIND_OUTSIDE_REPEAT;
    for (const AnySource& source : std::vector<AnySource>{gusts, turbulence, grid}) {
        const auto run = [&](double time) {
            const World w = at_time(time, [&](const World& world) {
                add_source(world, source);
                set_wind(world, std::holds_alternative<lr_turbulence_desc>(source) ? 1.25f : 0.0f, 0.0f, 0.0f);
            });
            return smoothness([&] {
                steps(w, 1, 1.0f / 60.0f);
                return wind_at(w, {0.3, 0.4, 0.5})[0];
            });
        };
        const Smoothness first = run(0.0);
        REQUIRE(first.step > 1e-3);
        CHECK(first.still < 12);
        for (double time : {86400.0, 1e7, 1e8, 1e9}) {
            CAPTURE(source.index());
            CAPTURE(time);
            const Smoothness late = run(time);
            // Other parts of the same random function; a grid's corners between its frames are the same.
            CHECK(late.bend < 2.0 * first.bend);
            CHECK(late.step < 2.5 * first.step);
            CHECK(late.step > 0.3 * first.step);
            CHECK(late.still < 12);
        }
    }
}

namespace {

// The height of the waves at a point, as a water callback receives it.
struct Told {
    double height = 0.0;
    static void tell(void* user, const lr_water_query* query) {
        static_cast<Told*>(user)->height = wide(query->height[0]);
    }
};

} // namespace

TEST_CASE("waves are as smooth after a day, after months and after decades as at first") {
    const Asset asset = leaf();
    const auto run = [&](double time) {
        const World w = at_time(time, [&](const World& world) { set_water(world, sea()); });
        const lr_batch batch = add_batch(w, asset, 1);
        Told told;
        REQUIRE(lr_world_set_water_callback(w.get(), &Told::tell, &told) == LR_OK);
        const lr_body body = add_body(w, batch, body_desc());
        const lr_body_state here = state_of(w, body);
        return smoothness([&] {
            REQUIRE(lr_body_set_state(w.get(), body, &here) == LR_OK);
            steps(w, 1, 1.0f / 60.0f);
            return told.height;
        });
    };
    const Smoothness first = run(0.0);
    REQUIRE(first.step > 1e-3);
    for (double time : {86400.0, 1e7, 1e8, 1e9}) {
        CAPTURE(time);
        const Smoothness late = run(time);
        CHECK(late.bend < 2.0 * first.bend);
        CHECK(late.step < 2.0 * first.step);
        CHECK(late.step > 0.5 * first.step);
        CHECK(late.still < 12);
    }
}

TEST_CASE("time is the sum of all dt in double, also late") {
    const World w = at_time(1e7, [](const World&) {});
    steps(w, 6000, 1.0f / 60.0f);
    CHECK(info_of(w).time == doctest::Approx(1e7 + 6000.0 * static_cast<double>(1.0f / 60.0f)).epsilon(1e-13));
}
