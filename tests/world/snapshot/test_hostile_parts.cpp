// Like test_hostile_snapshot.cpp, for optional parts of batches: forces, rules, emitters, lives, sleeping bodies. And non-finite
// bodies.
#include "support/lifecycle.h"
#include "support/quick.h"
#include "support/random.h"
#include "support/reseal_snapshot.h"
#include "world/snapshot/snapshot_format.h"

#include <cmath>
#include <limits>

using namespace test;

namespace {

struct Scene {
    Asset asset = leaf();
    World world = make(world_desc());
    lr_batch batch = add_batch(world, asset, 12);
    std::vector<lr_body> ids;

    explicit Scene(bool with_parts) {
        for (int i = 0; i < 7; ++i) ids.push_back(add_body(world, batch, body_desc()));
        if (!with_parts) return;
        lr_emitter_desc e = emitter_desc();
        e.rate = 40.0f;
        set_emitter(world, batch, e);
        lr_batch_rules r = rules_with({LR_VOLUME_BOX, LR_KILL_OUTSIDE, {0.0f, 0.0f, 0.0f}, {1.0f, 1.0f, 1.0f}});
        r.action = LR_END_RESPAWN;
        r.max_age = 0.03f;
        set_rules(world, batch, r);
        lr_batch_force all = initialised(lr_batch_force_init);
        all.acceleration[1] = 2.0f;
        REQUIRE(lr_batch_set_force(world.get(), batch, &all) == LR_OK);
        REQUIRE(lr_body_set_sleep(world.get(), ids.data() + 4, 2, LR_SLEEP_ASLEEP) == LR_OK);
        steps(world, 4, 0.01f);
        lr_body_force f = initialised(lr_body_force_init);
        f.body = ids[2];
        f.force[0] = 1e-3f;
        REQUIRE(lr_body_add_force(world.get(), &f, 1) == LR_OK);
    }
};

// The first batch's header begins with the content hash of its asset.
size_t batch_header(const std::vector<unsigned char>& bytes, const Asset& asset) {
    const uint64_t hash = info_of(asset).content_hash;
    for (size_t i = 0; i + 8 <= bytes.size(); i += 8)
        if (std::memcmp(bytes.data() + i, &hash, 8) == 0) return i;
    FAIL("no batch in the snapshot");
    return 0;
}
} // namespace

TEST_CASE("changed forces, rules and emitters in a snapshot are refused, or restore a world that works") {
    const Scene good_scene(true);
    const std::vector<unsigned char> good = snapshot_of(good_scene.world);
    const size_t header = batch_header(good, good_scene.asset), columns = header + sizeof(lr::SnapshotBatch);
    REQUIRE(good.size() > snapshot_of(Scene(false).world).size() + 400);
    Random random(16);
    const int rounds = quick() ? 1000 : 5000;
    int restored = 0, refused = 0;
    for (int round = 0; round < rounds; ++round) {
        std::vector<unsigned char> bytes = good;
        for (uint32_t n = 1 + random.below(3); n > 0; --n) {
            // Its header, or the columns, which come last; every tenth time anywhere.
            const bool in_header = round % 10 != 0 && round % 2 == 0;
            const size_t end = in_header ? columns : bytes.size();
            const size_t size = end - (in_header ? header : round % 10 == 0 ? 0 : columns);
            const size_t at = end - 4 * (1 + random.below(static_cast<uint32_t>(size / 4)));
            const uint32_t candidates[] = {0,           1,
                                           2,           7,
                                           8,           9,
                                           0xffffffffu, 0x80000000u,
                                           0x7fc00000u, 0x7f800000u,
                                           0x7f7fffffu, 0x4b800000u,
                                           0x3f800000u, static_cast<uint32_t>(random.bits())};
            const uint32_t word = candidates[random.below(14)];
            std::memcpy(bytes.data() + at, &word, 4);
        }
        seal(bytes);
        const Scene scene(round % 2 == 0);
        lr_world* const w = scene.world.get();
        const std::vector<unsigned char> before = snapshot_of(scene.world);
        const lr_status status = lr_world_snapshot_restore(w, bytes.data(), bytes.size());
        if (status == LR_OK) {
            ++restored;
        } else {
            ++refused;
            if (snapshot_of(scene.world) != before) FAIL("a refused snapshot changed the world");
            if (status != LR_ERROR_SNAPSHOT_FORMAT && status != LR_ERROR_SNAPSHOT_MISMATCH) FAIL("status ", status);
        }
        for (int i = 0; i < 3; ++i) lr_world_step(w, 0.01f, 2);
        lr_batch_spawn(w, scene.batch, 1, nullptr);
        lr_batch_counts e = initialised(lr_batch_counts_init);
        lr_batch_get_counts(w, scene.batch, &e);
        lr_body_destroy(w, scene.ids.data(), 3);
        lr_world_step(w, 0.01f, 2);
        const float low[3] = {-1.0f, -1.0f, -1.0f}, high[3] = {1.0f, 1.0f, 1.0f};
        lr_world_wake_box(w, low, high, nullptr);
        lr_body_set_sleep(w, scene.ids.data(), 7, LR_SLEEP_ASLEEP);
        lr_body_set_sleep(w, scene.ids.data() + 3, 2, round % 3 == 0 ? LR_SLEEP_ASLEEP : LR_SLEEP_AWAKE);
        for (int i = 0; i < 20; ++i) lr_world_step(w, 0.01f, 1);
        lr_batch_set_rules(w, scene.batch, nullptr);
        lr_batch_set_emitter(w, scene.batch, nullptr);
        lr_world_step(w, 0.01f, 2);
        if (snapshot_of(scene.world).empty()) FAIL("no snapshot");
    }
    CHECK(restored > 100);
    CHECK(refused > 100);
}

TEST_CASE("a snapshot with parts that this library does not know is refused") {
    const Scene scene(false);
    std::vector<unsigned char> bytes = snapshot_of(scene.world);
    bytes[batch_header(bytes, scene.asset) + offsetof(lr::SnapshotBatch, parts)] |= 1u << lr::column_parts;
    seal(bytes);
    CHECK(lr_world_snapshot_restore(scene.world.get(), bytes.data(), bytes.size()) == LR_ERROR_SNAPSHOT_FORMAT);
}

TEST_CASE("a body that has left physics ends under any rules, or begins anew, what is not finite is not restored") {
    constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN(),
                    infinite = std::numeric_limits<float>::infinity();
    for (int32_t action : {LR_END_DESTROY, LR_END_RESPAWN})
        for (float lost : {not_a_number, -infinite, 1e30f})
            for (size_t field : {size_t{0}, size_t{2}, size_t{5}, size_t{8}}) { // x, z, an orientation, a velocity
                const Scene scene(false);
                set_emitter(scene.world, scene.batch, emitter_desc());
                lr_batch_rules r = rules_desc();
                r.action = action;
                std::vector<unsigned char> bytes = snapshot_of(scene.world);
                // Behind the header: fields of 7 bodies, padded to 8.
                std::memcpy(bytes.data() + batch_header(bytes, scene.asset) + sizeof(lr::SnapshotBatch) +
                                4 * (8 * field + 3),
                            &lost, 4);
                seal(bytes);
                const bool sane = std::isfinite(lost) && field == 8; // the step judges velocities
                REQUIRE(lr_world_snapshot_restore(scene.world.get(), bytes.data(), bytes.size()) ==
                        (sane ? LR_OK : LR_ERROR_SNAPSHOT_FORMAT));
                if (!sane) continue;
                set_rules(scene.world, scene.batch, r);
                steps(scene.world, 2, 0.01f, 2);
                const lr_batch_view v = view_of(scene.world, scene.batch);
                CHECK(v.count == (action == LR_END_DESTROY ? 6 : 7));
                const lr_batch_counts e = counts_of(scene.world, scene.batch);
                CHECK(e.total_destroyed + e.total_respawned == 1);
                const std::vector<Velocity> u = velocities_of(scene.world, scene.batch);
                bool finite = true;
                for (uint32_t i = 0; i < v.count; ++i)
                    for (size_t k = 0; k < 3; ++k)
                        finite = finite && std::isfinite(v.position[k][i]) && std::isfinite(u[i].linear[k]) &&
                                 std::isfinite(v.orientation[k][i]);
                CHECK(finite);
            }
}
