// The wind's API: handles, refusals, callbacks, memory, snapshots.
#include "support/counting_memory.h"
#include "support/quick.h"
#include "support/random.h"
#include "support/reseal_snapshot.h"
#include "support/wind.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <mutex>
#include <string>

using namespace test;

namespace {

template <class D> lr_status try_add(const World& w, const D& d) {
    lr_wind_source source{99};
    const lr_status status = add_wind(w.get(), &d, &source);
    CHECK((source.id != 0) == (status == LR_OK));
    if (source.id) CHECK(lr_world_remove_wind(w.get(), source) == LR_OK);
    return status;
}

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN(),
                infinity = std::numeric_limits<float>::infinity();

// A valid source of a kind; each wrong value is tried in a new source and in an update.
template <class D> struct Spoilt {
    const World& world;
    const D& good;
    lr_wind_source kept = add_source(world, good);

    void refused(lr_status why, const std::function<void(D&)>& spoil) const {
        D wrong = good;
        spoil(wrong);
        CHECK(try_add(world, wrong) == why);
        CHECK(update_wind(world.get(), kept, &wrong) == why);
        D held = good;
        CHECK(get_wind(world.get(), kept, &held) == LR_OK);
        if constexpr (requires { held.samples; }) held.samples = good.samples;
        CHECK(std::memcmp(&held, &good, sizeof good) == 0);
    }
    // A float or three floats.
    template <class M> void numbers(M D::*member, std::initializer_list<float> wrong) const {
        for (size_t i = 0; i < sizeof(M) / sizeof(float); ++i) {
            const auto set = [&](D& d, float value) { (&reinterpret_cast<float&>(d.*member))[i] = value; };
            for (float value : {not_a_number, infinity, -infinity})
                refused(LR_ERROR_NOT_FINITE, [&](D& d) { set(d, value); });
            for (float value : wrong) refused(LR_ERROR_INVALID_ARGUMENT, [&](D& d) { set(d, value); });
        }
    }
    void placed() const {
        numbers(&D::position, {1.1e9f, -1e30f});
        numbers(&D::velocity, {1001.0f, -1e30f});
    }
    void directed(float (D::*member)[3]) const {
        numbers(member, {1e19f});
        refused(LR_ERROR_INVALID_ARGUMENT, [&](D& d) { set(d.*member, 0.0f, 0.0f, 0.0f); });
    }
    template <class T> void integers(T D::*member, std::initializer_list<T> wrong) const {
        for (T value : wrong) refused(LR_ERROR_INVALID_ARGUMENT, [&](D& d) { d.*member = value; });
    }
};

void spoil(const Spoilt<lr_gusts_desc>& s) {
    s.directed(&lr_gusts_desc::direction);
    s.numbers(&lr_gusts_desc::rms, {-0.1f, 1001.0f});
    s.numbers(&lr_gusts_desc::angle_rms, {-0.1f, 1.1f});
    s.numbers(&lr_gusts_desc::integral_time, {-1.0f, 1.1e6f});
}
void spoil(const Spoilt<lr_vortex_desc>& s) {
    s.placed();
    s.directed(&lr_vortex_desc::axis);
    s.numbers(&lr_vortex_desc::circulation, {1.1e6f, -1.1e6f, 2401.0f}); // the last is faster than 1000 m/s
    s.numbers(&lr_vortex_desc::core_radius, {0.0f, -1.0f, 1e-5f, 1.1e6f});
    s.numbers(&lr_vortex_desc::outer_radius, {-0.1f, 1.1e6f});
    s.numbers(&lr_vortex_desc::half_length, {-0.1f, 1.1e6f});
    s.integers(&lr_vortex_desc::core, {-1, 2, 1 << 30});
}
void spoil(const Spoilt<lr_blower_desc>& s) {
    s.placed();
    s.directed(&lr_blower_desc::direction);
    s.numbers(&lr_blower_desc::side, {});
    s.numbers(&lr_blower_desc::speed, {-0.1f, 1001.0f});
    s.numbers(&lr_blower_desc::nozzle_radius, {0.0f, -1.0f, 1e-5f, 6.1f});
    s.numbers(&lr_blower_desc::half_length, {-0.1f, 1.1e6f});
    s.numbers(&lr_blower_desc::range, {0.0f, -1.0f, 0.29f, 1.1e6f});
    s.numbers(&lr_blower_desc::spread, {-0.1f, 1.1f});
    const auto no_side = [](lr_blower_desc& d) { set(d.side, 0.0f, 0.0f, 0.0f); };
    const auto along = [](lr_blower_desc& d) { std::copy(d.direction, d.direction + 3, d.side); };
    if (s.good.half_length > 0.0f) {
        s.refused(LR_ERROR_INVALID_ARGUMENT, no_side);
        s.refused(LR_ERROR_INVALID_ARGUMENT, along);
    } else {
        lr_blower_desc round = s.good; // a round nozzle does not use it
        no_side(round);
        CHECK(try_add(s.world, round) == LR_OK);
    }
}
void spoil(const Spoilt<lr_turbulence_desc>& s) {
    s.numbers(&lr_turbulence_desc::velocity, {1001.0f, -1e30f});
    s.numbers(&lr_turbulence_desc::rms, {-0.1f, 1001.0f});
    s.numbers(&lr_turbulence_desc::integral_length, {0.0f, -1.0f, 1e-5f, 1.1e6f});
    s.numbers(&lr_turbulence_desc::eddy_life, {-1.0f, 1.1e6f});
    s.integers(&lr_turbulence_desc::octaves, {0u, 5u, 0xffffffffu});
}
void spoil(const Spoilt<lr_wind_grid_desc>& s) {
    using D = lr_wind_grid_desc;
    s.placed();
    s.numbers(&D::spacing, {0.0f, -1.0f, 1.1e6f});
    s.numbers(&D::frame_time, {-1.0f, 1.1e6f});
    s.integers(&D::outside, {-1, 3});
    s.integers(&D::frames, {0u, 0xffffffffu});
    for (uint32_t n : {0u, 0xffffffffu, 1u << 26}) s.refused(LR_ERROR_INVALID_ARGUMENT, [&](D& d) { d.counts[1] = n; });
    D wrong = s.good;
    wrong.samples = nullptr;
    CHECK(try_add(s.world, wrong) == LR_ERROR_NULL_ARGUMENT);
    for (float value : {not_a_number, infinity, 1001.0f}) {
        std::vector<float> spoilt = grid_samples();
        spoilt[100] = value;
        s.refused(value == 1001.0f ? LR_ERROR_INVALID_ARGUMENT : LR_ERROR_NOT_FINITE,
                  [&](D& d) { d.samples = spoilt.data(); });
    }
}
void spoil(const Spoilt<lr_ground_wind_desc>& s) {
    s.placed();
    s.directed(&lr_ground_wind_desc::normal);
    s.numbers(&lr_ground_wind_desc::roughness_length, {0.0f, -1.0f, 1e-5f, 10.1f});
    s.numbers(&lr_ground_wind_desc::reference_height, {0.0f, -1.0f, 0.01f, 1.1e6f});
}

struct Asked {
    std::mutex mutex;
    std::vector<double> times;
    uint64_t bodies = 0;
    bool finite = true, whole = true;
    float give = 0.0f;
    std::vector<lr_batch> batches;
};
void remember(void* user, const lr_wind_query* q) {
    Asked& asked = *static_cast<Asked*>(user);
    const std::lock_guard<std::mutex> lock(asked.mutex);
    asked.times.push_back(q->time);
    asked.batches.push_back(q->batch);
    asked.bodies += q->count;
    asked.whole = asked.whole && q->struct_size == sizeof *q && q->count >= 1 && q->count <= 256 && q->reserved == 0;
    for (uint32_t i = 0; i < q->count; ++i)
        for (size_t k = 0; k < 3; ++k) {
            asked.finite = asked.finite && std::isfinite(q->position[k][i]) && q->velocity[k][i] == 0.0f &&
                           q->rate[k][i] == 0.0f && q->gradient[3 * k + 1][i] == 0.0f;
            q->velocity[k][i] = asked.give;
        }
}

struct Log {
    int warnings = 0;
    std::string last;
    static void take(void* user, int32_t level, const char* message) {
        Log& log = *static_cast<Log*>(user);
        if (level == LR_LOG_WARNING) ++log.warnings;
        log.last = message;
    }
};

} // namespace

TEST_CASE("wind sources are handles: removed ones are recognised, also when their place is taken again") {
    const World world = make(world_desc());
    const lr_vortex_desc d = vortex_desc();
    const lr_wind_source first = add_source(world, d), second = add_source(world, d);
    CHECK(first != second);
    CHECK(lr_world_update_vortex(world.get(), first, &d) == LR_OK);
    CHECK(lr_world_remove_wind(world.get(), first) == LR_OK);
    CHECK(lr_world_remove_wind(world.get(), first) == LR_ERROR_STALE_WIND_SOURCE);
    CHECK(lr_world_update_vortex(world.get(), first, &d) == LR_ERROR_STALE_WIND_SOURCE);
    const lr_wind_source third = add_source(world, d);
    CHECK(third != first);
    CHECK(lr_world_remove_wind(world.get(), first) == LR_ERROR_STALE_WIND_SOURCE);
    for (uint32_t stale : {0u, 1000u, 0xffffffffu, second.id + (1u << 20)})
        CHECK(lr_world_remove_wind(world.get(), {stale}) == LR_ERROR_STALE_WIND_SOURCE);
    CHECK(lr_world_remove_wind(world.get(), second) == LR_OK);
    CHECK(lr_world_remove_wind(world.get(), third) == LR_OK);
}

TEST_CASE("an updated source is the new one from its new place on") {
    const World world = make(world_desc());
    lr_blower_desc d = initialised(lr_blower_desc_init);
    set(d.velocity, 1.0f, 0.0f, 0.0f);
    const lr_wind_source source = add_source(world, d);
    steps(world, 1, 1.0f, 1);
    CHECK(length(wind_at(world, {0.25, 0.0, 0.0})) < 0.5); // behind it
    REQUIRE(lr_world_update_blower(world.get(), source, &d) == LR_OK);
    CHECK(length(wind_at(world, {0.25, 0.0, 0.0})) > 0.9);

    // An update without samples keeps a grid's samples, unless they would not fit.
    const std::vector<float> samples(3 * 8, 2.0f);
    lr_wind_grid_desc grid = initialised(lr_wind_grid_desc_init);
    for (uint32_t& n : grid.counts) n = 2;
    grid.samples = samples.data();
    const lr_wind_source lattice = add_source(world, grid);
    grid.samples = nullptr;
    set(grid.position, 10.0f, 0.0f, 0.0f);
    REQUIRE(lr_world_update_wind_grid(world.get(), lattice, &grid) == LR_OK);
    CHECK(wind_at(world, {10.5, 0.5, 0.5})[0] == 2.0);
    grid.counts[0] = 1;
    CHECK(lr_world_update_wind_grid(world.get(), lattice, &grid) == LR_ERROR_NULL_ARGUMENT);
    CHECK(wind_at(world, {10.5, 0.5, 0.5})[0] == 2.0);
}

TEST_CASE("a source is read back as it was set, and is of its kind for good") {
    const World world = make(world_desc());
    set_wind(world, 1.0f, -2.0f, 3.0f);
    float uniform[3] = {};
    REQUIRE(lr_world_get_uniform_wind(world.get(), uniform) == LR_OK);
    CHECK((uniform[0] == 1.0f && uniform[1] == -2.0f && uniform[2] == 3.0f));
    const std::vector<float> samples = grid_samples();
    const std::vector<AnySource> all = one_of_each(samples);
    std::vector<lr_wind_source> ids;
    for (const AnySource& d : all) ids.push_back(add_source(world, d));
    steps(world, 3, 0.1f, 1);
    for (size_t i = 0; i < all.size(); ++i)
        std::visit(
            [&](auto given) {
                auto got = given;
                std::memset(&got.struct_size + 1, 0x5a, sizeof got - sizeof got.struct_size);
                if constexpr (requires { given.samples; }) given.samples = nullptr;
                CHECK(get_wind(world.get(), ids[i], &got) == LR_OK);
                if constexpr (requires {
                                  given.position;
                                  given.velocity;
                              }) // where it is now
                    for (size_t k = 0; k < 3; ++k) {
                        const float moved = given.position[k] + 0.3f * given.velocity[k];
                        CHECK(got.position[k] == doctest::Approx(moved));
                        given.position[k] = got.position[k];
                    }
                CHECK(std::memcmp(&got, &given, sizeof got) == 0);
                const Vec before_update = wind_at(world, {0.4, -0.3, 0.2});
                CHECK(update_wind(world.get(), ids[i], &got) == LR_OK);
                CHECK(length(wind_at(world, {0.4, -0.3, 0.2}) - before_update) < 1e-5);
                const uint64_t hash = hash_of(world);
                for (size_t k = 0; k < all.size(); ++k) {
                    const bool same = all[k].index() == all[i].index();
                    const auto before = got;
                    CHECK(get_wind(world.get(), ids[k], &got) == (same ? LR_OK : LR_ERROR_INVALID_ARGUMENT));
                    if (same) continue;
                    CHECK(std::memcmp(&got, &before, sizeof got) == 0);
                    CHECK(update_wind(world.get(), ids[k], &all[i]) == LR_ERROR_INVALID_ARGUMENT);
                }
                CHECK(hash_of(world) == hash);
                CHECK(get_wind(world.get(), {}, &got) == LR_ERROR_STALE_WIND_SOURCE);
            },
            all[i]);
    // A vortex can change its core, a blower its nozzle.
    CHECK(update_wind(world.get(), ids[1], &all[2]) == LR_OK);
    CHECK(update_wind(world.get(), ids[3], &all[4]) == LR_OK);
}

TEST_CASE("impossible wind sources are refused, and the world is as it was") {
    const World world = make(world_desc());
    add_body(world, add_batch(world, leaf(), 1), body_desc());
    std::vector<float> samples = grid_samples();
    const std::vector<AnySource> good = one_of_each(samples);
    for (const AnySource& d : good) add_source(world, d);
    const std::vector<unsigned char> before = snapshot_of(world);
    for (const AnySource& any : good)
        std::visit(
            [&](const auto& d) {
                CAPTURE(any.index());
                const Spoilt<std::remove_cvref_t<decltype(d)>> spoilt{world, d};
                spoil(spoilt);
                CHECK(try_add(world, d) == LR_OK);
                CHECK(lr_world_remove_wind(world.get(), spoilt.kept) == LR_OK);
            },
            any);
    // Adding and removing changed only the handles' generations.
    CHECK(snapshot_of(world).size() == before.size());
    float positions[6] = {0.0f, 1.0f, 2.0f, 3.0f, not_a_number, 4.0f},
          velocities[6] = {7.0f, 7.0f, 7.0f, 7.0f, 7.0f, 7.0f};
    CHECK(lr_world_sample_wind(world.get(), positions, 2, velocities) == LR_ERROR_NOT_FINITE);
    positions[4] = 1.1e9f;
    CHECK(lr_world_sample_wind(world.get(), positions, 2, velocities) == LR_ERROR_INVALID_ARGUMENT);
    for (float v : velocities) CHECK(v == 7.0f);
    CHECK(lr_world_sample_wind(world.get(), nullptr, 0, nullptr) == LR_OK);
}

TEST_CASE("a callback is asked once for each body and substep, and gives wind") {
    for (uint32_t workers : {0u, 3u}) {
        lr_world_desc wd = world_desc();
        wd.worker_count = workers;
        wd.gravity[1] = 0.0f;
        const World world = make(wd);
        const Asset asset = leaf();
        const lr_batch one = add_batch(world, asset, 3000), two = add_batch(world, asset, 5);
        std::vector<lr_body_desc> bodies(2500, body_desc());
        std::vector<lr_body> ids(2500);
        REQUIRE(lr_body_create(world.get(), one, bodies.data(), 2500, ids.data()) == LR_OK);
        REQUIRE(lr_body_create(world.get(), two, bodies.data(), 3, nullptr) == LR_OK);
        Asked asked;
        asked.give = 2.0f;
        REQUIRE(lr_world_set_wind_callback(world.get(), remember, &asked) == LR_OK);
        steps(world, 2, 0.1f, 10);
        CHECK(asked.bodies == 20u * 2503u);
        CHECK(asked.whole);
        CHECK(asked.finite);
        CHECK(std::count(asked.batches.begin(), asked.batches.end(), two) == 20);
        const int most = quick() ? 64 : 256; // slow libraries are built with shorter chunks
        const auto pieces = std::count(asked.batches.begin(), asked.batches.end(), one);
        CHECK((pieces >= 20 * 10 && pieces <= 20 * ((2500 + most - 1) / most)));
        std::sort(asked.times.begin(), asked.times.end());
        CHECK(asked.times.front() == doctest::Approx(0.005));
        CHECK(asked.times.back() == doctest::Approx(0.195));
        CHECK(state_of(world, ids[7]).linear_velocity[0] > 0.0f); // blown along
        asked.batches.clear();
        CHECK(wind_at(world, {1.0, 2.0, 3.0})[1] == 2.0);
        CHECK((asked.batches.size() == 1 && asked.batches[0].id == 0));
        const uint64_t so_far = asked.bodies;
        REQUIRE(lr_world_set_wind_callback(world.get(), nullptr, nullptr) == LR_OK);
        steps(world, 1, 0.1f, 1);
        CHECK(asked.bodies == so_far);
    }
}

TEST_CASE("a callback that gives what is no velocity counts as still, and is reported once") {
    for (float value : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1001.0f}) {
        Log log;
        lr_world_desc wd = world_desc();
        wd.log = Log::take;
        wd.log_user = &log;
        wd.worker_count = 2;
        const World good = make(wd), bad = make(wd);
        const Asset asset = leaf();
        Asked asked, nothing;
        asked.give = value;
        for (const World* w : {&good, &bad}) {
            const lr_batch batch = add_batch(*w, asset, 2000);
            const std::vector<lr_body_desc> bodies(2000, body_desc());
            REQUIRE(lr_body_create(w->get(), batch, bodies.data(), 2000, nullptr) == LR_OK);
        }
        REQUIRE(lr_world_set_wind_callback(good.get(), remember, &nothing) == LR_OK);
        REQUIRE(lr_world_set_wind_callback(bad.get(), remember, &asked) == LR_OK);
        steps(good, 5, 0.01f, 2);
        CHECK(log.warnings == 0);
        steps(bad, 5, 0.01f, 2);
        CHECK(log.warnings == 1);
        CHECK(hash_of(good) == hash_of(bad));
        CHECK(length(wind_at(bad, {0.0, 0.0, 0.0})) == 0.0);
    }
}

TEST_CASE("wind takes memory when it is added, none in a step, and gives all of it back") {
    const std::vector<float> samples = grid_samples();
    const std::vector<AnySource> sources = one_of_each(samples);
    CountingAllocator memory;
    lr_world_desc d = world_desc();
    d.allocator = memory.callbacks();
    const Asset asset = leaf();
    {
        const World world = make(d);
        add_body(world, add_batch(world, asset, 600), body_desc());
        const size_t empty = memory.live();
        std::vector<lr_wind_source> ids;
        for (const AnySource& s : sources) ids.push_back(add_source(world, s));
        const uint64_t calls = memory.calls, global = global_allocations;
        float at[3] = {1.0f, 2.0f, 3.0f};
        uint64_t hash = 0;
        bool ok = true;
        for (int i = 0; i < 5; ++i) ok = ok && lr_world_step(world.get(), 0.01f, 20) == LR_OK;
        ok = ok && lr_world_sample_wind(world.get(), at, 1, at) == LR_OK && lr_world_hash(world.get(), &hash) == LR_OK;
        for (lr_wind_source id : ids) ok = ok && lr_world_remove_wind(world.get(), id) == LR_OK;
        CHECK(ok);
        CHECK(memory.calls == calls);
        CHECK(global_allocations == global);
        CHECK(memory.live() <= empty + 1); // memory allocated in a step is kept
    }
    CHECK(memory.live() == 0);
    CHECK_FALSE(memory.mismatch);
    // Every allocation fails once: no source is added, no memory leaks.
    for (const AnySource& s : sources)
        for (uint64_t n = 0; n < 6; ++n) {
            {
                const World world = make(d);
                const lr_wind_source kept = add_source(world, s);
                const uint64_t hash = hash_of(world);
                memory.fail_at = memory.calls + n;
                lr_wind_source out{5};
                const lr_status added = add_wind(world.get(), &s, &out);
                memory.fail_at = CountingAllocator::never;
                CHECK((added == LR_OK || added == LR_ERROR_OUT_OF_MEMORY));
                CHECK((out.id != 0) == (added == LR_OK));
                if (added != LR_OK) CHECK(hash_of(world) == hash);
                const uint64_t now = hash_of(world);
                memory.fail_at = memory.calls + n;
                const lr_status updated = update_wind(world.get(), kept, &s);
                memory.fail_at = CountingAllocator::never;
                if (updated != LR_OK) CHECK(hash_of(world) == now);
                steps(world, 1, 0.01f, 2);
            }
            CHECK(memory.live() == 0);
            CHECK_FALSE(memory.mismatch);
        }
}

TEST_CASE("snapshots bring sources and their handles back, grids must be there") {
    const std::vector<float> samples = grid_samples();
    const Asset asset = leaf();
    const auto begin = [&] {
        World world = make(world_desc());
        add_batch(world, asset, 4);
        return world;
    };
    const World one = begin();
    std::vector<lr_wind_source> ids;
    for (const AnySource& d : one_of_each(samples)) ids.push_back(add_source(one, d));
    REQUIRE(lr_world_remove_wind(one.get(), ids[2]) == LR_OK);
    set_wind(one, 1.0f, 2.0f, 3.0f);
    steps(one, 3, 0.1f, 2);
    set_wind(one, 3.0f, 2.0f, 3.0f);
    const std::vector<unsigned char> snapshot = snapshot_of(one);
    const uint64_t hash = hash_of(one);
    const World two = begin();
    CHECK(lr_world_snapshot_restore(two.get(), snapshot.data(), snapshot.size()) == LR_ERROR_SNAPSHOT_MISMATCH);
    CHECK(length(wind_at(two, {0.1, 0.2, 0.3})) == 0.0);
    lr_wind_grid_desc grid = initialised(lr_wind_grid_desc_init);
    std::vector<float> other = samples;
    other[3] += 1.0f;
    grid.counts[0] = 4, grid.counts[1] = 3, grid.counts[2] = 5, grid.frames = 3;
    grid.samples = other.data();
    const lr_wind_source wrong = add_source(two, grid);
    CHECK(lr_world_snapshot_restore(two.get(), snapshot.data(), snapshot.size()) == LR_ERROR_SNAPSHOT_MISMATCH);
    grid.samples = samples.data();
    REQUIRE(lr_world_update_wind_grid(two.get(), wrong, &grid) == LR_OK);
    REQUIRE(lr_world_snapshot_restore(two.get(), snapshot.data(), snapshot.size()) == LR_OK);
    CHECK(hash_of(two) == hash);
    CHECK(snapshot_of(two) == snapshot);
    steps(one, 2, 0.1f, 3);
    steps(two, 2, 0.1f, 3);
    CHECK(hash_of(one) == hash_of(two));
    CHECK(length(wind_at(one, {0.5, 0.5, 0.5}) - wind_at(two, {0.5, 0.5, 0.5})) == 0.0);
    CHECK(lr_world_remove_wind(two.get(), ids[2]) == LR_ERROR_STALE_WIND_SOURCE);
    CHECK(lr_world_remove_wind(two.get(), ids[6]) == LR_OK);
}

TEST_CASE("a snapshot whose wind was changed and sealed again is refused, or restores a world that works" *
          doctest::test_suite("native")) {
    const std::vector<float> samples = grid_samples();
    const Asset asset = leaf();
    const World world = make(world_desc());
    add_body(world, add_batch(world, asset, 4), body_desc());
    for (const AnySource& d : one_of_each(samples)) add_source(world, d);
    const std::vector<unsigned char> good = snapshot_of(world);
    Random random(4);
    int refused = 0, taken = 0;
    for (uint32_t n = 0; n < 4000; ++n) {
        std::vector<unsigned char> bad = good;
        for (uint32_t k = 0; k <= n % 3; ++k) bad[104 + random.below(1700)] = static_cast<unsigned char>(random.bits());
        seal(bad);
        if (lr_world_snapshot_restore(world.get(), bad.data(), bad.size()) == LR_OK) {
            ++taken;
            CHECK(lr_world_step(world.get(), 0.01f, 2) == LR_OK);
            wind_at(world, {0.1, 0.2, 0.3});
            REQUIRE(lr_world_snapshot_restore(world.get(), good.data(), good.size()) == LR_OK);
        } else {
            ++refused;
        }
    }
    CHECK(refused > 400);
    CHECK(taken > 400);
}
