// The wind's API: handles, refusals, callbacks, memory, snapshots.
#include "support/counting_memory.h"
#include "support/random.h"
#include "support/seal.h"
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

lr_status try_add(const World& w, const lr_wind_source_desc& d) {
    lr_wind_source source = 99;
    const lr_status status = lr_world_add_wind(w.get(), &d, &source);
    CHECK((source != 0) == (status == LR_OK));
    if (source) CHECK(lr_world_remove_wind(w.get(), source) == LR_OK);
    return status;
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
    const lr_wind_source_desc d = source_desc(LR_WIND_SOURCE_LAMB_OSEEN);
    const lr_wind_source first = add_source(world, d), second = add_source(world, d);
    CHECK(first != second);
    CHECK(lr_world_update_wind(world.get(), first, &d) == LR_OK);
    CHECK(lr_world_remove_wind(world.get(), first) == LR_OK);
    CHECK(lr_world_remove_wind(world.get(), first) == LR_ERROR_STALE_WIND_SOURCE);
    CHECK(lr_world_update_wind(world.get(), first, &d) == LR_ERROR_STALE_WIND_SOURCE);
    const lr_wind_source third = add_source(world, d);
    CHECK(third != first);
    CHECK(lr_world_remove_wind(world.get(), first) == LR_ERROR_STALE_WIND_SOURCE);
    for (lr_wind_source stale : {0u, 1000u, 0xffffffffu, second + (1u << 20)})
        CHECK(lr_world_remove_wind(world.get(), stale) == LR_ERROR_STALE_WIND_SOURCE);
    CHECK(lr_world_remove_wind(world.get(), second) == LR_OK);
    CHECK(lr_world_remove_wind(world.get(), third) == LR_OK);
}

TEST_CASE("an updated source is the new one from its new place on") {
    const World world = make(world_desc());
    lr_wind_source_desc d = source_desc(LR_WIND_SOURCE_POINT_BLOWER);
    set(d.velocity, 1.0f, 0.0f, 0.0f);
    const lr_wind_source source = add_source(world, d);
    steps(world, 1, 1.0f, 1);
    CHECK(length(wind_at(world, {0.25, 0.0, 0.0})) < 0.5); // behind it
    REQUIRE(lr_world_update_wind(world.get(), source, &d) == LR_OK);
    CHECK(length(wind_at(world, {0.25, 0.0, 0.0})) > 0.9);
    lr_wind_source_desc other = source_desc(LR_WIND_SOURCE_TURBULENCE);
    other.octaves = 4;
    REQUIRE(lr_world_update_wind(world.get(), source, &other) == LR_OK);
    CHECK(length(wind_at(world, {500.5, 0.25, 3.0})) > 0.0);

    // A grid keeps its samples when none are given, unless they would not fit.
    const std::vector<float> samples(3 * 8, 2.0f);
    lr_wind_source_desc grid = source_desc(LR_WIND_SOURCE_GRID);
    for (uint32_t& n : grid.counts) n = 2;
    CHECK(lr_world_update_wind(world.get(), source, &grid) == LR_ERROR_NULL_ARGUMENT);
    grid.samples = samples.data();
    REQUIRE(lr_world_update_wind(world.get(), source, &grid) == LR_OK);
    grid.samples = nullptr;
    set(grid.position, 10.0f, 0.0f, 0.0f);
    REQUIRE(lr_world_update_wind(world.get(), source, &grid) == LR_OK);
    CHECK(wind_at(world, {10.5, 0.5, 0.5})[0] == 2.0);
    grid.counts[0] = 1;
    CHECK(lr_world_update_wind(world.get(), source, &grid) == LR_ERROR_NULL_ARGUMENT);
    CHECK(wind_at(world, {10.5, 0.5, 0.5})[0] == 2.0);
}

TEST_CASE("impossible wind sources are refused, and the world is as it was") {
    const World world = make(world_desc());
    add_body(world, add_batch(world, leaf(), 1), body_desc());
    std::vector<float> samples = grid_samples();
    const std::vector<lr_wind_source_desc> good = one_of_each(samples);
    const lr_wind_source kept = add_source(world, good[1]);
    const std::vector<unsigned char> before = snapshot_of(world);
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    const size_t first = offsetof(lr_wind_source_desc, position), last = offsetof(lr_wind_source_desc, octaves);
    for (const lr_wind_source_desc& d : good) {
        CAPTURE(d.kind);
        for (size_t at = first; at < last; at += 4)
            for (float value : {nan, infinity, -infinity}) {
                lr_wind_source_desc wrong = d;
                std::memcpy(reinterpret_cast<unsigned char*>(&wrong) + at, &value, 4);
                CHECK(try_add(world, wrong) == LR_ERROR_NOT_FINITE);
                CHECK(lr_world_update_wind(world.get(), kept, &wrong) == LR_ERROR_NOT_FINITE);
            }
        const auto refused = [&](const std::function<void(lr_wind_source_desc&)>& spoil) {
            lr_wind_source_desc wrong = d;
            spoil(wrong);
            CHECK(try_add(world, wrong) == LR_ERROR_INVALID_ARGUMENT);
            CHECK(lr_world_update_wind(world.get(), kept, &wrong) == LR_ERROR_INVALID_ARGUMENT);
        };
        using D = lr_wind_source_desc;
        for (int32_t kind : {0, -1, 9, 1 << 30}) refused([&](D& w) { w.kind = kind; });
        refused([](D& w) { w.reserved = 1; });
        for (float far : {1.1e9f, -1e30f}) refused([&](D& w) { w.position[1] = far; });
        for (float fast : {1001.0f, -1e30f}) refused([&](D& w) { w.velocity[2] = fast; });
        for (float speed : {-0.1f, 1001.0f}) refused([&](D& w) { w.speed = speed; });
        for (float size : {0.0f, -1.0f, 1e-5f, 1.1e6f}) refused([&](D& w) { w.size = size; });
        for (float period : {-1.0f, 1.1e6f}) refused([&](D& w) { w.period = period; });
        for (float spread : {-0.1f, 1.1f}) refused([&](D& w) { w.spread = spread; });
        for (float half : {-0.1f, 1.1e6f}) refused([&](D& w) { w.half_length = half; });
        if (d.kind != LR_WIND_SOURCE_TURBULENCE && d.kind != LR_WIND_SOURCE_GRID)
            refused([](D& w) { set(w.direction, 0.0f, 0.0f, 0.0f); });
        if (d.kind == LR_WIND_SOURCE_LINE_BLOWER) {
            refused([](D& w) { set(w.side, 0.0f, 0.0f, 0.0f); });
            refused([](D& w) { std::copy(w.direction, w.direction + 3, w.side); });
        }
        if (d.kind == LR_WIND_SOURCE_RANKINE || d.kind == LR_WIND_SOURCE_LAMB_OSEEN) {
            refused([](D& w) { w.circulation = 1.1e6f; });
            refused([](D& w) { w.circulation = 10.0f, w.size = 1e-3f; });
            refused([](D& w) { w.radius = -1.0f; });
        }
        if (d.kind == LR_WIND_SOURCE_POINT_BLOWER || d.kind == LR_WIND_SOURCE_LINE_BLOWER)
            for (float range : {0.0f, -1.0f, 1.1e6f}) refused([&](D& w) { w.range = range; });
        if (d.kind == LR_WIND_SOURCE_TURBULENCE)
            for (uint32_t octaves : {0u, 5u, 0xffffffffu}) refused([&](D& w) { w.octaves = octaves; });
        if (d.kind == LR_WIND_SOURCE_GROUND)
            for (float height : {0.0f, -1.0f, 0.01f}) refused([&](D& w) { w.reference_height = height; });
        if (d.kind == LR_WIND_SOURCE_GRID) {
            for (uint32_t n : {0u, 0xffffffffu, 1u << 26}) refused([&](D& w) { w.counts[1] = n; });
            for (uint32_t n : {0u, 0xffffffffu}) refused([&](D& w) { w.frames = n; });
            for (float spacing : {0.0f, -1.0f, 1.1e6f}) refused([&](D& w) { w.spacing[0] = spacing; });
            for (int32_t outside : {-1, 3}) refused([&](D& w) { w.outside = outside; });
            for (float spacing : {nan, infinity}) {
                lr_wind_source_desc wrong = d;
                wrong.spacing[2] = spacing;
                CHECK(try_add(world, wrong) == LR_ERROR_NOT_FINITE);
            }
            lr_wind_source_desc wrong = d;
            wrong.samples = nullptr;
            CHECK(try_add(world, wrong) == LR_ERROR_NULL_ARGUMENT);
            for (float value : {nan, infinity, 1001.0f}) {
                std::vector<float> spoilt = samples;
                spoilt[100] = value;
                wrong.samples = spoilt.data();
                CHECK(try_add(world, wrong) == (value == 1001.0f ? LR_ERROR_INVALID_ARGUMENT : LR_ERROR_NOT_FINITE));
            }
        }
        CHECK(try_add(world, d) == LR_OK);
    }
    // Adding and removing has worn the handles of places, and nothing else.
    CHECK(snapshot_of(world).size() == before.size());
    float positions[6] = {0.0f, 1.0f, 2.0f, 3.0f, nan, 4.0f}, velocities[6] = {7.0f, 7.0f, 7.0f, 7.0f, 7.0f, 7.0f};
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
#ifdef LR_CHUNK_BODIES
        constexpr int most = LR_CHUNK_BODIES < 256 ? LR_CHUNK_BODIES : 256;
#else
        constexpr int most = 256;
#endif
        const auto pieces = std::count(asked.batches.begin(), asked.batches.end(), one);
        CHECK((pieces >= 20 * 10 && pieces <= 20 * ((2500 + most - 1) / most)));
        std::sort(asked.times.begin(), asked.times.end());
        CHECK(asked.times.front() == doctest::Approx(0.005));
        CHECK(asked.times.back() == doctest::Approx(0.195));
        CHECK(state_of(world, ids[7]).linear_velocity[0] > 0.0f); // blown along
        asked.batches.clear();
        CHECK(wind_at(world, {1.0, 2.0, 3.0})[1] == 2.0);
        CHECK((asked.batches.size() == 1 && asked.batches[0] == 0));
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
    const std::vector<lr_wind_source_desc> sources = one_of_each(samples);
    CountingAllocator memory;
    lr_world_desc d = world_desc();
    d.allocator = memory.callbacks();
    const Asset asset = leaf();
    {
        const World world = make(d);
        add_body(world, add_batch(world, asset, 600), body_desc());
        const size_t empty = memory.live();
        std::vector<lr_wind_source> ids;
        for (const lr_wind_source_desc& s : sources) ids.push_back(add_source(world, s));
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
        CHECK(memory.live() <= empty + 1); // what is prepared in a step stays
    }
    CHECK(memory.live() == 0);
    CHECK_FALSE(memory.mismatch);
    // Every allocation fails once: nothing is added, nothing leaks.
    for (const lr_wind_source_desc& s : sources)
        for (uint64_t n = 0; n < 6; ++n) {
            {
                const World world = make(d);
                const lr_wind_source kept = add_source(world, sources[1]);
                const uint64_t hash = hash_of(world);
                memory.fail_at = memory.calls + n;
                lr_wind_source out = 5;
                const lr_status added = lr_world_add_wind(world.get(), &s, &out);
                memory.fail_at = CountingAllocator::never;
                CHECK((added == LR_OK || added == LR_ERROR_OUT_OF_MEMORY));
                CHECK((out != 0) == (added == LR_OK));
                if (added != LR_OK) CHECK(hash_of(world) == hash);
                const uint64_t now = hash_of(world);
                memory.fail_at = memory.calls + n;
                const lr_status updated = lr_world_update_wind(world.get(), kept, &s);
                memory.fail_at = CountingAllocator::never;
                if (updated != LR_OK) CHECK(hash_of(world) == now);
                steps(world, 1, 0.01f, 2);
            }
            CHECK(memory.live() == 0);
            CHECK_FALSE(memory.mismatch);
        }
}

TEST_CASE("snapshots bring sources and their handles back; grids must be there") {
    const std::vector<float> samples = grid_samples();
    const Asset asset = leaf();
    const auto begin = [&] {
        World world = make(world_desc());
        add_batch(world, asset, 4);
        return world;
    };
    const World one = begin();
    std::vector<lr_wind_source> ids;
    for (const lr_wind_source_desc& d : one_of_each(samples)) ids.push_back(add_source(one, d));
    REQUIRE(lr_world_remove_wind(one.get(), ids[2]) == LR_OK);
    set_wind(one, 1.0f, 2.0f, 3.0f);
    steps(one, 3, 0.1f, 2);
    set_wind(one, 3.0f, 2.0f, 3.0f);
    const std::vector<unsigned char> snapshot = snapshot_of(one);
    const uint64_t hash = hash_of(one);
    const World two = begin();
    CHECK(lr_world_snapshot_restore(two.get(), snapshot.data(), snapshot.size()) == LR_ERROR_SNAPSHOT_MISMATCH);
    CHECK(length(wind_at(two, {0.1, 0.2, 0.3})) == 0.0);
    lr_wind_source_desc grid = source_desc(LR_WIND_SOURCE_GRID);
    std::vector<float> other = samples;
    other[3] += 1.0f;
    grid.counts[0] = 4, grid.counts[1] = 3, grid.counts[2] = 5, grid.frames = 3;
    grid.samples = other.data();
    const lr_wind_source wrong = add_source(two, grid);
    CHECK(lr_world_snapshot_restore(two.get(), snapshot.data(), snapshot.size()) == LR_ERROR_SNAPSHOT_MISMATCH);
    grid.samples = samples.data();
    REQUIRE(lr_world_update_wind(two.get(), wrong, &grid) == LR_OK);
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
    for (const lr_wind_source_desc& d : one_of_each(samples)) add_source(world, d);
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
