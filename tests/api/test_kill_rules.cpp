// Which bodies rules end, at which time, and with which events.
#include "support/contact_events.h"
#include "support/counting_memory.h"
#include "support/lifecycle.h"
#include "support/random.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

using namespace test;

namespace {

// Bodies fill a cube of 4 m without gravity, at rest: they stay in place.
struct Cloud {
    Asset asset = leaf();
    World world;
    lr_batch batch{};
    std::vector<lr_body> ids;
    std::vector<std::array<float, 3>> places;

    explicit Cloud(int count = 3000, uint32_t workers = 0) {
        lr_world_desc d = world_desc();
        d.gravity[1] = 0.0f;
        d.worker_count = workers;
        world = make(d);
        lr_batch_desc bd = batch_desc();
        bd.load_model = LR_LOADS_NONE;
        batch = add_batch(world, bd, asset, static_cast<uint32_t>(count));
        Random random(11);
        for (int i = 0; i < count; ++i) {
            lr_body_desc b = body_desc();
            for (float& x : b.position) x = random.real(-2.0, 2.0);
            places.push_back({b.position[0], b.position[1], b.position[2]});
            ids.push_back(add_body(world, batch, b));
        }
    }
};

using Inside = std::function<bool(double, double, double)>;

void check_volume(lr_kill_volume volume, const Inside& inside) {
    for (int32_t side : {LR_KILL_INSIDE, LR_KILL_OUTSIDE})
        for (uint32_t workers : {0u, 2u}) {
            volume.side = side;
            const Cloud c(3000, workers);
            keep_events(c.world, 3000);
            set_rules(c.world, c.batch, rules_with(volume));
            steps(c.world, 1, 0.01f);
            std::set<lr_body> expected;
            for (size_t i = 0; i < c.ids.size(); ++i)
                if (inside(wide(c.places[i][0]), wide(c.places[i][1]), wide(c.places[i][2])) ==
                    (side == LR_KILL_INSIDE))
                    expected.insert(c.ids[i]);
            REQUIRE(expected.size() > 50);
            REQUIRE(expected.size() < 2950);
            const lr_batch_counts e = counts_of(c.world, c.batch);
            CHECK(e.destroyed == expected.size());
            CHECK(e.by_volume[0] == expected.size());
            CHECK((e.respawned == 0 && e.by_age == 0 && e.by_divergence == 0 && e.by_volume[1] == 0 && e.spawned == 0));
            std::set<lr_body> killed;
            for (const lr_event& event : events_of(c.world))
                if (event.kind == LR_EVENT_KILLED) killed.insert(event.body);
            CHECK(killed == expected);
            CHECK(info_of(c.world).body_count == c.ids.size() - expected.size());
            bool right = true;
            lr_body_state s = body_state();
            for (size_t i = 0; i < c.ids.size(); ++i) {
                const lr_status status = lr_body_get_state(c.world.get(), c.ids[i], &s);
                right = right && status == (expected.count(c.ids[i]) ? LR_ERROR_STALE_BODY : LR_OK);
                if (status == LR_OK) right = right && std::equal(s.position, s.position + 3, c.places[i].begin());
            }
            CHECK(right);
            steps(c.world, 1, 0.01f);
            CHECK(counts_of(c.world, c.batch).destroyed == 0);
            CHECK(counts_of(c.world, c.batch).total_destroyed == expected.size());
        }
}

} // namespace

TEST_CASE("planes, boxes and spheres end exactly the bodies in them, or out of them") {
    check_volume({LR_VOLUME_PLANE, 0, {0.0f, 0.5f, 0.0f}, {0.0f, 2.0f, 0.0f}},
                 [](double, double y, double) { return y < 0.5; });
    check_volume({LR_VOLUME_PLANE, 0, {0.25f, 0.0f, 0.0f}, {-1.0f, 0.5f, 0.25f}},
                 [](double x, double y, double z) { return -(x - 0.25) + 0.5 * y + 0.25 * z < 0.0; });
    check_volume({LR_VOLUME_BOX, 0, {0.5f, 0.0f, -0.5f}, {1.0f, 1.5f, 0.75f}}, [](double x, double y, double z) {
        return std::abs(x - 0.5) <= 1.0 && std::abs(y) <= 1.5 && std::abs(z + 0.5) <= 0.75;
    });
    check_volume({LR_VOLUME_SPHERE, 0, {0.5f, -0.25f, 0.0f}, {1.5f, 0.0f, 0.0f}}, [](double x, double y, double z) {
        return (x - 0.5) * (x - 0.5) + (y + 0.25) * (y + 0.25) + z * z <= 2.25;
    });
}

TEST_CASE("the first cause that holds is the one that is told") {
    const Cloud c;
    lr_batch_rules r = rules_desc();
    r.max_age = 0.015f;
    r.volume_count = 8;
    for (uint32_t k = 0; k < 8; ++k) // growing spheres: each ends the bodies that the one before left
        r.volumes[k] = {LR_VOLUME_SPHERE, LR_KILL_INSIDE, {0.0f, 0.0f, 0.0f}, {0.4f * narrow(k + 1.0), 0.0f, 0.0f}};
    set_rules(c.world, c.batch, r);
    uint32_t shell[8] = {};
    for (const auto& p : c.places) {
        const double radius = std::sqrt(wide(p[0]) * wide(p[0]) + wide(p[1]) * wide(p[1]) + wide(p[2]) * wide(p[2]));
        const auto k = static_cast<size_t>(std::ceil(radius / 0.4) - 1.0);
        if (k < 8) ++shell[k];
    }
    steps(c.world, 1, 0.01f);
    const lr_batch_counts e = counts_of(c.world, c.batch);
    for (size_t k = 0; k < 8; ++k) {
        CHECK(e.by_volume[k] == shell[k]);
        CHECK(shell[k] > 0);
    }
    steps(c.world, 1, 0.01f); // 0.02 s: the others are too old
    CHECK(counts_of(c.world, c.batch).by_age == c.ids.size() - e.destroyed);
    CHECK(info_of(c.world).body_count == 0);
}

TEST_CASE("bodies end at their age, each at its own") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 40);
    for (int i = 0; i < 40; ++i) {
        lr_body_desc d = body_desc();
        d.age = 0.125f * narrow(i);
        add_body(world, batch, d);
    }
    lr_batch_rules r = rules_desc();
    r.max_age = 5.0f;
    set_rules(world, batch, r);
    for (uint64_t i = 1; i <= 40; ++i) {
        steps(world, 1, 0.125f, 2);
        CHECK(info_of(world).body_count == 40 - i);
        CHECK(counts_of(world, batch).by_age == 1);
    }
}

TEST_CASE("no rules, no ends, null rules end them") {
    const Cloud c(100);
    set_rules(c.world, c.batch, rules_desc());
    steps(c.world, 5, 0.01f);
    CHECK(info_of(c.world).body_count == 100);
    lr_batch_rules r = rules_desc();
    r.max_age = 0.01f;
    set_rules(c.world, c.batch, r);
    REQUIRE(lr_batch_set_rules(c.world.get(), c.batch, nullptr) == LR_OK);
    steps(c.world, 5, 0.01f);
    CHECK(info_of(c.world).body_count == 100);
    const lr_batch bare = add_batch(c.world, c.asset, 3);
    const lr_batch_counts e = counts_of(c.world, bare);
    CHECK((e.total_destroyed == 0 && e.total_spawned == 0));
    lr_batch_counts stale = initialised(lr_batch_counts_init);
    REQUIRE(lr_batch_destroy(c.world.get(), bare) == LR_OK);
    CHECK(lr_batch_get_counts(c.world.get(), bare, &stale) == LR_ERROR_STALE_BATCH);
}

TEST_CASE("respawned bodies keep id and noise seed, begin at age 0 where the emitter says, and elsewhere each time") {
    for (uint32_t workers : {0u, 2u}) {
        const Cloud c(2000, workers);
        lr_emitter_desc d = emitter_desc();
        d.shape = LR_EMIT_BOX;
        d.position[0] = 100.0f;
        for (float& s : d.size) s = 1.0f;
        d.speed_min = d.speed_max = 1.0f;
        set_emitter(c.world, c.batch, d);
        lr_batch_rules r = rules_with({LR_VOLUME_PLANE, LR_KILL_INSIDE, {0.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}});
        r.max_age = 0.1f;
        r.action = LR_END_RESPAWN;
        set_rules(c.world, c.batch, r);
        const uint32_t noise_seed = state_of(c.world, c.ids[5]).noise_seed;
        keep_events(c.world, 3000);
        steps(c.world, 1, 0.01f);
        const std::vector<lr_event> respawned = events_of(c.world);
        lr_batch_counts e = counts_of(c.world, c.batch);
        CHECK(e.destroyed == 0);
        CHECK(e.respawned == static_cast<uint32_t>(std::count_if(c.places.begin(), c.places.end(),
                                                                 [](const auto& p) { return p[1] < 0.0f; })));
        CHECK(info_of(c.world).body_count == 2000);
        REQUIRE(respawned.size() == e.respawned);
        for (uint32_t i = 0; i < e.respawned; i += 97) {
            CHECK(respawned[i].kind == LR_EVENT_RESPAWNED);
            const lr_body_state s = state_of(c.world, respawned[i].body);
            CHECK(s.age == 0.0f);
            CHECK(std::abs(s.position[0] - 100.0f) <= 1.0f);
            CHECK(wide(s.linear_velocity[1]) == doctest::Approx(-1.0).epsilon(1e-6));
        }
        std::set<float> heights;
        for (int round = 0; round < 10; ++round) {
            steps(c.world, 10, 0.01f);
            heights.insert(state_of(c.world, c.ids[5]).position[1]);
        }
        CHECK(heights.size() == 10);
        CHECK(state_of(c.world, c.ids[5]).noise_seed == noise_seed);
        CHECK(info_of(c.world).body_count == 2000);
    }
}

TEST_CASE("respawning needs an emitter, and keeps it") {
    const Cloud c(10);
    lr_world* const w = c.world.get();
    lr_batch_rules r = rules_desc();
    r.action = LR_END_RESPAWN;
    CHECK(lr_batch_set_rules(w, c.batch, &r) == LR_ERROR_INVALID_ARGUMENT);
    set_emitter(c.world, c.batch, emitter_desc());
    CHECK(lr_batch_set_rules(w, c.batch, &r) == LR_OK);
    CHECK(lr_batch_set_emitter(w, c.batch, nullptr) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(lr_batch_set_rules(w, c.batch, nullptr) == LR_OK);
    CHECK(lr_batch_set_emitter(w, c.batch, nullptr) == LR_OK);
    CHECK(lr_batch_set_rules(w, c.batch, &r) == LR_ERROR_INVALID_ARGUMENT);
}

TEST_CASE("impossible rules are refused and change nothing") {
    const Cloud c(10);
    lr_batch_rules good = rules_with({LR_VOLUME_PLANE, LR_KILL_INSIDE, {0.0f, -9.0f, 0.0f}, {0.0f, 1.0f, 0.0f}});
    good.volume_count = 2;
    good.volumes[1] = {LR_VOLUME_BOX, LR_KILL_OUTSIDE, {0.0f, 0.0f, 0.0f}, {9.0f, 9.0f, 9.0f}};
    set_rules(c.world, c.batch, good);
    const std::vector<unsigned char> before = snapshot_of(c.world);
    const auto refused = [&](const std::function<void(lr_batch_rules&)>& spoil) {
        lr_batch_rules r = good;
        spoil(r);
        const lr_status status = lr_batch_set_rules(c.world.get(), c.batch, &r);
        CHECK(snapshot_of(c.world) == before);
        return status;
    };
    constexpr lr_status invalid = LR_ERROR_INVALID_ARGUMENT;
    CHECK(refused([](lr_batch_rules& r) { r.action = 2; }) == invalid);
    CHECK(refused([](lr_batch_rules& r) { r.action = -1; }) == invalid);
    CHECK(refused([](lr_batch_rules& r) { r.max_age = -1.0f; }) == invalid);
    CHECK(refused([](lr_batch_rules& r) { r.volume_count = 9; }) == invalid);
    CHECK(refused([](lr_batch_rules& r) { r.volume_count = 0xffffffffu; }) == invalid);
    CHECK(refused([](lr_batch_rules& r) { r.volumes[1].shape = 3; }) == invalid);
    CHECK(refused([](lr_batch_rules& r) { r.volumes[1].shape = -1; }) == invalid);
    CHECK(refused([](lr_batch_rules& r) { r.volumes[1].side = 2; }) == invalid);
    CHECK(refused([](lr_batch_rules& r) { r.volumes[1].size[2] = -1.0f; }) == invalid);
    CHECK(refused([](lr_batch_rules& r) { r.volumes[1].center[0] = 2e9f; }) == invalid);
    CHECK(refused([](lr_batch_rules& r) { r.volumes[0].size[1] = 0.0f; }) == invalid);
    for (float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        CHECK(refused([&](lr_batch_rules& r) { r.max_age = bad; }) == LR_ERROR_NOT_FINITE);
        CHECK(refused([&](lr_batch_rules& r) { r.volumes[1].size[1] = bad; }) == LR_ERROR_NOT_FINITE);
        CHECK(refused([&](lr_batch_rules& r) { r.volumes[0].center[2] = bad; }) == LR_ERROR_NOT_FINITE);
    }
    CHECK(lr_batch_set_rules(c.world.get(), {}, &good) == LR_ERROR_STALE_BATCH);
    // Values behind the used volumes do not matter.
    good.volumes[5].shape = 77;
    set_rules(c.world, c.batch, good);
    CHECK(snapshot_of(c.world) == before);
}

TEST_CASE("the first rules take memory, none left is a status, and neither steps nor later rules take any") {
    CountingAllocator memory;
    lr_world_desc d = world_desc();
    d.allocator = memory.callbacks();
    const Asset asset = leaf();
    const World world = make(d);
    const lr_batch batch = add_batch(world, asset, 100);
    for (int i = 0; i < 50; ++i) add_body(world, batch, body_desc());
    lr_batch_rules r = rules_desc();
    r.max_age = 0.05f;
    const lr_emitter_desc e = emitter_desc();
    const std::vector<unsigned char> before = snapshot_of(world);
    for (uint64_t n = 0; n < 5; ++n) {
        memory.fail_at = n;
        memory.fail_after = true;
        CAPTURE(n);
        CHECK(lr_batch_set_rules(world.get(), batch, &r) == LR_ERROR_OUT_OF_MEMORY);
        CHECK(lr_batch_set_emitter(world.get(), batch, &e) == LR_ERROR_OUT_OF_MEMORY);
        CHECK(snapshot_of(world) == before);
    }
    memory.fail_at = CountingAllocator::never;
    set_emitter(world, batch, e);
    const uint64_t calls = memory.calls, global = global_allocations;
    lr_emitter_desc many = e;
    many.rate = 1000.0f;
    bool ok = true;
    for (int32_t action : {LR_END_DESTROY, LR_END_RESPAWN}) {
        r.action = action;
        for (int i = 0; i < 20; ++i) {
            ok = ok && lr_batch_set_rules(world.get(), batch, &r) == LR_OK;
            ok = ok && lr_batch_set_emitter(world.get(), batch, &many) == LR_OK;
            ok = ok && lr_world_step(world.get(), 0.01f, 2) == LR_OK;
        }
    }
    CHECK(memory.calls == calls);
    CHECK(global_allocations == global);
    CHECK(ok);
    CHECK(counts_of(world, batch).total_destroyed > 0);
    CHECK(counts_of(world, batch).total_respawned > 0);
}
