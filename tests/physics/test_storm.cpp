// Long storms without calls: rules, emitters and snapshots together.
#include "support/lifecycle.h"

#include <cmath>
#include <cstdlib>
#include <utility>

using namespace test;

namespace {

// A column of leaves that fall for 4 m from a slab and respawn.
struct Storm {
    Asset asset = leaf();
    World world;
    lr_batch batch{};

    explicit Storm(uint32_t workers, uint32_t count, bool govern = true) {
        lr_world_desc wd = world_desc();
        wd.seed = 99;
        wd.worker_count = workers;
        world = make(wd);
        batch = add_batch(world, langevin(), asset, count + 500);
        if (!govern) return;
        lr_emitter_desc e = emitter_desc();
        e.shape = LR_EMIT_BOX;
        e.position[1] = 4.0f;
        e.size[0] = e.size[2] = 5.0f;
        e.size[1] = 0.1f;
        e.speed_max = 0.2f;
        e.spread = 3.0f;
        e.spin_max = 5.0f;
        e.scale_min = 0.5f;
        set_emitter(world, batch, e);
        lr_batch_rules r = rules_desc();
        r.action = LR_END_RESPAWN;
        r.max_age = 20.0f;
        r.volume_count = 2;
        r.volumes[0] = {LR_VOLUME_PLANE, LR_KILL_INSIDE, {0.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}};
        r.volumes[1] = {LR_VOLUME_BOX, LR_KILL_OUTSIDE, {0.0f, 2.0f, 0.0f}, {10.0f, 4.0f, 10.0f}};
        set_rules(world, batch, r);
        emit(world, batch, count);
    }
};

} // namespace

// LR_TEST_LONG_STORM in the environment: ten thousand bodies for a hundred thousand steps.
TEST_CASE("a storm keeps its count, stays finite, and its distribution does not wander") {
    const bool longer = std::getenv("LR_TEST_LONG_STORM") != nullptr;
    const uint32_t count = longer ? 10000 : 1500;
    const int rounds = longer ? 100 : 12, per_round = longer ? 1000 : 500;
    const Storm storm(0, count);
    steps(storm.world, 6000, 1.0f / 60.0f, 1); // until the start is forgotten
    const uint64_t before = counts_of(storm.world, storm.batch).total_respawned;
    std::vector<double> height, speed, respawned;
    uint64_t last = before;
    for (int round = 0; round < rounds; ++round) {
        steps(storm.world, per_round, 1.0f / 60.0f, 1);
        const lr_batch_view v = view_of(storm.world, storm.batch);
        const std::vector<Velocity> u = velocities_of(storm.world, storm.batch);
        REQUIRE(v.count == count);
        double y = 0.0, s = 0.0;
        for (uint32_t i = 0; i < v.count; ++i) {
            bool sound = v.age[i] <= 20.0f && v.scale[i] >= 0.5f && v.scale[i] <= 1.0f;
            double square = 0.0;
            for (size_t k = 0; k < 3; ++k) {
                sound = sound && std::abs(v.position[k][i]) <= 10.0f && std::isfinite(u[i].angular[k]);
                square += wide(u[i].linear[k]) * wide(u[i].linear[k]);
            }
            if (!sound || !std::isfinite(square)) FAIL("body ", i, " has left the storm");
            y += wide(v.position[1][i]) / count;
            s += std::sqrt(square) / count;
        }
        height.push_back(y);
        speed.push_back(s);
        const uint64_t total = counts_of(storm.world, storm.batch).total_respawned;
        respawned.push_back(static_cast<double>(total - last));
        last = total;
    }
    CHECK(counts_of(storm.world, storm.batch).by_divergence == 0);
    const auto half_means = [](const std::vector<double>& v) {
        const size_t half = v.size() / 2;
        double a = 0.0, b = 0.0;
        for (size_t i = 0; i < half; ++i) a += v[i], b += v[half + i];
        return std::pair(a / static_cast<double>(half), b / static_cast<double>(half));
    };
    for (const auto* series : {&height, &speed, &respawned}) {
        const auto [a, b] = half_means(*series);
        MESSAGE("first half ", a, ", second half ", b);
        CHECK(b == doctest::Approx(a).epsilon(longer ? 0.01 : 0.05));
    }
    CHECK(respawned.front() > 100.0);
}

TEST_CASE("a storm is the same rolled back, in another world, and with any number of workers") {
    const Storm storm(0, 2500);
    lr_batch_rules r = rules_desc();
    r.action = LR_END_RESPAWN;
    r.max_age = 0.5f;
    set_rules(storm.world, storm.batch, r);
    lr_emitter_desc e = emitter_desc();
    e.rate = 333.0f;
    e.burst_count = 7;
    e.burst_interval = 0.07f;
    e.shape = LR_EMIT_SPHERE_SURFACE;
    e.size[0] = e.size[1] = e.size[2] = 1.0f;
    set_emitter(storm.world, storm.batch, e);
    steps(storm.world, 45, 1.0f / 60.0f, 2);
    REQUIRE(counts_of(storm.world, storm.batch).total_respawned > 2000);
    const std::vector<unsigned char> snapshot = snapshot_of(storm.world);
    const uint64_t at = hash_of(storm.world);
    steps(storm.world, 40, 1.0f / 60.0f, 2);
    const uint64_t expected = hash_of(storm.world);
    const lr_batch_counts events = counts_of(storm.world, storm.batch);
    for (uint32_t workers : {0u, 1u, 3u}) {
        const Storm other(workers, 2500, workers == 1); // with its own rules, or none
        REQUIRE(lr_world_snapshot_restore(other.world.get(), snapshot.data(), snapshot.size()) == LR_OK);
        CHECK(hash_of(other.world) == at);
        CHECK(snapshot_of(other.world) == snapshot);
        CHECK(counts_of(other.world, other.batch).respawned == 0);
        steps(other.world, 40, 1.0f / 60.0f, 2);
        CHECK(hash_of(other.world) == expected);
        const lr_batch_counts got = counts_of(other.world, other.batch);
        CHECK(got.total_respawned == events.total_respawned);
        CHECK(got.total_spawned == events.total_spawned);
        CHECK(got.total_missed == events.total_missed);
        CHECK(got.respawned == events.respawned);
    }
    // A snapshot without rules removes them.
    const Storm bare(0, 2500, false);
    const std::vector<unsigned char> empty = snapshot_of(bare.world);
    REQUIRE(lr_world_snapshot_restore(storm.world.get(), empty.data(), empty.size()) == LR_OK);
    CHECK(snapshot_of(storm.world) == empty);
    steps(storm.world, 10, 0.1f);
    CHECK(info_of(storm.world).body_count == 0);
}

// The number of respawns determines a body's next place: it is part of the hash.
TEST_CASE("two bodies in one state but with other lives behind them hash differently") {
    uint64_t hashes[2];
    for (int lives : {1, 2}) {
        const Storm storm(0, 1);
        lr_batch_rules r = rules_desc();
        r.action = LR_END_RESPAWN;
        r.max_age = 0.01f;
        set_rules(storm.world, storm.batch, r);
        steps(storm.world, lives, 0.02f / narrow(lives));
        const lr_body id = view_of(storm.world, storm.batch).ids[0];
        const lr_body_state s = body_state();
        REQUIRE(lr_body_set_state(storm.world.get(), id, &s) == LR_OK);
        // The same number of substeps.
        if (lives == 1) {
            REQUIRE(lr_batch_set_rules(storm.world.get(), storm.batch, nullptr) == LR_OK);
            steps(storm.world, 1, 0.01f);
            REQUIRE(lr_body_set_state(storm.world.get(), id, &s) == LR_OK);
        }
        hashes[lives - 1] = hash_of(storm.world);
    }
    CHECK(hashes[0] != hashes[1]);
}
