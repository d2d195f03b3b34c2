// Body contact between batches through the public API: arguments, getters, ends of batches, snapshots.
#include "support/contact.h"
#include "support/counting_memory.h"
#include "support/random.h"
#include "support/reseal_snapshot.h"

#include <algorithm>
#include <set>
#include <utility>

using namespace test;

namespace {

bool meet(const World& w, lr_batch a, lr_batch b) {
    int32_t enabled = -1;
    REQUIRE(lr_batch_get_body_contact(w.get(), a, b, &enabled) == LR_OK);
    REQUIRE((enabled == 0 || enabled == 1));
    return enabled == 1;
}
void set_meet(const World& w, lr_batch a, lr_batch b, bool on = true) {
    REQUIRE(lr_batch_set_body_contact(w.get(), a, b, on ? 1 : 0) == LR_OK);
}
bool rests(const World& w, lr_body body) {
    return state_of(w, body).sleep_state == LR_SLEEP_ASLEEP;
}
void put_to_rest(const World& w, lr_body body) {
    REQUIRE(lr_body_set_sleep(w.get(), &body, 1, LR_SLEEP_ASLEEP) == LR_OK);
}
lr_status restore(const World& w, const std::vector<unsigned char>& bytes) {
    return lr_world_snapshot_restore(w.get(), bytes.data(), bytes.size());
}

// Four batches; the second has been destroyed.
struct Scene {
    Asset asset = leaf();
    World world = make(world_desc());
    lr_batch batch[4];

    explicit Scene(bool gap = true) {
        for (lr_batch& b : batch) b = add_batch(world, asset, 4);
        if (gap) REQUIRE(lr_batch_destroy(world.get(), batch[1]) == LR_OK);
    }
};

} // namespace

TEST_CASE("bodies meet where it was switched on, in either order, and initially nowhere") {
    const Scene scene(false);
    const World& w = scene.world;
    using Model = std::set<std::pair<uint32_t, uint32_t>>;
    Model model;
    std::vector<std::pair<Model, uint64_t>> seen;
    Random random(61);
    bool equal = true, hashes = true;
    for (int i = 0; i < 300; ++i) {
        for (uint32_t a = 0; a < 4; ++a)
            for (uint32_t b = 0; b < 4; ++b)
                equal = equal &&
                        meet(w, scene.batch[a], scene.batch[b]) == (model.count({std::min(a, b), std::max(a, b)}) != 0);
        // Equal if and only if the pairs are equal, in any order of calls.
        const uint64_t hash = hash_of(w);
        for (const auto& [pairs, before] : seen) hashes = hashes && (pairs == model) == (before == hash);
        seen.emplace_back(model, hash);
        const uint32_t a = random.below(4), b = random.below(4);
        const bool on = random.below(2) == 0;
        set_meet(w, scene.batch[a], scene.batch[b], on);
        if (on)
            model.insert({std::min(a, b), std::max(a, b)});
        else
            model.erase({std::min(a, b), std::max(a, b)});
    }
    CHECK(equal);
    CHECK(hashes);
}

TEST_CASE("wrong arguments of a pair are refused and change nothing") {
    const Scene scene;
    lr_world* const w = scene.world.get();
    const lr_batch a = scene.batch[0], b = scene.batch[2];
    set_meet(scene.world, a, b);
    const uint64_t hash = hash_of(scene.world);
    for (int32_t enabled : {-1, 2, 256, INT32_MAX, INT32_MIN})
        CHECK(lr_batch_set_body_contact(w, a, a, enabled) == LR_ERROR_INVALID_ARGUMENT);
    for (lr_batch stale : {lr_batch{0}, scene.batch[1], lr_batch{a.id + (1u << 14)}, lr_batch{~0u}})
        for (lr_batch good : {a, stale}) {
            int32_t enabled = 7;
            for (int32_t to : {0, 1}) {
                CHECK(lr_batch_set_body_contact(w, stale, good, to) == LR_ERROR_STALE_BATCH);
                CHECK(lr_batch_set_body_contact(w, good, stale, to) == LR_ERROR_STALE_BATCH);
            }
            CHECK(lr_batch_get_body_contact(w, stale, good, &enabled) == LR_ERROR_STALE_BATCH);
            CHECK(lr_batch_get_body_contact(w, good, stale, &enabled) == LR_ERROR_STALE_BATCH);
            CHECK(enabled == 7);
        }
    CHECK(hash_of(scene.world) == hash);
    CHECK((meet(scene.world, a, b) && !meet(scene.world, a, a) && !meet(scene.world, b, b)));
}

TEST_CASE("a batch that takes the place of another meets none of those that this met") {
    const Scene scene(false);
    const World& w = scene.world;
    const lr_batch *const batch = scene.batch, gone = batch[2];
    for (lr_batch b : scene.batch) set_meet(w, gone, b);
    set_meet(w, batch[0], batch[3]);
    REQUIRE(lr_batch_destroy(w.get(), gone) == LR_OK);
    CHECK(lr_batch_set_body_contact(w.get(), gone, batch[0], 1) == LR_ERROR_STALE_BATCH);
    const lr_batch next = add_batch(w, scene.asset, 4);
    REQUIRE((next.id & 0x3fffu) == (gone.id & 0x3fffu));
    for (lr_batch b : {batch[0], batch[1], next, batch[3]}) CHECK(!meet(w, next, b));
    CHECK(meet(w, batch[0], batch[3]));
}

TEST_CASE("a change wakes the bodies of both batches and no others, and so does the end of one") {
    for (int end : {0, 1}) {
        const Scene scene(false);
        const World& w = scene.world;
        const lr_batch* const batch = scene.batch;
        lr_body body[4];
        const auto lay_down = [&] {
            for (lr_body one : body) put_to_rest(w, one);
        };
        const auto resting = [&](bool first, bool second, bool third, bool fourth) {
            CHECK((rests(w, body[0]) == first && rests(w, body[1]) == second));
            CHECK((rests(w, body[2]) == third && rests(w, body[3]) == fourth));
        };
        for (int i = 0; i < 4; ++i) body[i] = add_body(w, batch[i], body_desc());
        lay_down();
        set_meet(w, batch[2], batch[0], false); // no change
        resting(true, true, true, true);
        set_meet(w, batch[2], batch[0]);
        resting(false, true, false, true);
        lay_down();
        set_meet(w, batch[0], batch[2]); // no change
        resting(true, true, true, true);
        set_meet(w, batch[1], batch[1]);
        resting(true, false, true, true);
        lay_down();
        if (end == 0)
            set_meet(w, batch[0], batch[2], false);
        else
            REQUIRE(lr_batch_destroy(w.get(), batch[2]) == LR_OK);
        CHECK(!rests(w, body[0]));
        CHECK((rests(w, body[1]) && rests(w, body[3])));
    }
}

TEST_CASE("pairs go through snapshots") {
    Scene first, second;
    const lr_batch* const batch = first.batch;
    const uint64_t plain = hash_of(first.world);
    const std::vector<unsigned char> without = snapshot_of(first.world);
    set_meet(first.world, batch[3], batch[0]);
    set_meet(first.world, batch[2], batch[2]);
    set_meet(first.world, batch[0], batch[2]);
    const std::vector<unsigned char> with = snapshot_of(first.world);
    CHECK(with.size() == without.size() + 24);
    set_meet(second.world, batch[2], batch[3]);
    set_meet(second.world, batch[0], batch[2]);
    REQUIRE(restore(second.world, with) == LR_OK);
    CHECK(hash_of(second.world) == hash_of(first.world));
    CHECK(snapshot_of(second.world) == with);
    for (lr_batch a : {batch[0], batch[2], batch[3]})
        for (lr_batch b : {batch[0], batch[2], batch[3]}) CHECK(meet(second.world, a, b) == meet(first.world, a, b));
    // The same pairs in another order of calls give the same bytes.
    const Scene third;
    set_meet(third.world, batch[2], batch[0]);
    set_meet(third.world, batch[0], batch[3]);
    set_meet(third.world, batch[2], batch[2]);
    CHECK(snapshot_of(third.world) == with);
    REQUIRE(restore(second.world, without) == LR_OK);
    CHECK(hash_of(second.world) == plain);
    for (lr_batch a : {batch[0], batch[2], batch[3]}) CHECK(!meet(second.world, a, batch[0]));
    // From a world with other batches.
    const Scene whole(false);
    CHECK(restore(whole.world, with) == LR_ERROR_SNAPSHOT_MISMATCH);
    CHECK(restore(second.world, snapshot_of(whole.world)) == LR_ERROR_SNAPSHOT_MISMATCH);
}

TEST_CASE("damaged pairs in a snapshot are refused, and nothing changes") {
    const Scene scene;
    set_meet(scene.world, scene.batch[0], scene.batch[2]);
    set_meet(scene.world, scene.batch[2], scene.batch[3]);
    const std::vector<unsigned char> good = snapshot_of(scene.world);
    // The world's 120 bytes, in which four at 108 count links; 296 of the wind, 344 of the water, 16 for no colliders.
    constexpr size_t count_at = 108, links_at = 776;
    const auto word = [&](size_t at) {
        uint32_t w = 0;
        std::memcpy(&w, good.data() + at, 4);
        return w;
    };
    const auto link = [](uint32_t slot, uint32_t partner) { return slot << 14 | partner; };
    const uint32_t links[4] = {link(0, 2), link(2, 0), link(2, 3), link(3, 2)};
    REQUIRE(word(count_at) == 4);
    for (size_t i = 0; i < 4; ++i) REQUIRE(word(links_at + 4 * i) == links[i]);
    const Scene other;
    set_meet(other.world, other.batch[3], other.batch[3]);
    const std::vector<unsigned char> before = snapshot_of(other.world);
    const auto changed = [&](const std::vector<std::pair<size_t, uint32_t>>& words) {
        std::vector<unsigned char> bytes = good;
        for (const auto& [at, value] : words) std::memcpy(bytes.data() + at, &value, 4);
        seal(bytes);
        return bytes;
    };
    const std::vector<std::vector<std::pair<size_t, uint32_t>>> damages = {
        {{links_at + 8, links[1]}},                                // twice
        {{links_at, links[1]}, {links_at + 4, links[0]}},          // out of order
        {{links_at, link(0, 1)}},                                  // a slot without a batch, in one direction only
        {{links_at, link(0, 1)}, {links_at + 4, link(1, 0)}},      // both directions
        {{links_at + 12, link(3, 3)}},                             // one direction only
        {{links_at + 8, link(2, 4)}, {links_at + 12, link(4, 2)}}, // no slot
        {{links_at + 12, 0xffffffffu}},
        {{links_at + 12, links[3] | 1u << 28}}, // bits above a slot's are checked
        {{count_at, 1}},
        {{count_at, 3}},
        {{count_at, 5}},
        {{count_at, 0}},
        {{count_at, 0x40000000u}}, // times 4 is 0 in 32 bits
        {{count_at, 0xffffffffu}},
        {{8, 6}}, // of another version
    };
    for (size_t i = 0; i < damages.size(); ++i) {
        CAPTURE(i);
        CHECK(restore(other.world, changed(damages[i])) == LR_ERROR_SNAPSHOT_FORMAT);
        CHECK(snapshot_of(other.world) == before);
    }
    CHECK(restore(other.world, changed({{links_at + 8, link(2, 2)}, {count_at, 3}})) ==
          LR_OK); // contact within the third
    CHECK((meet(other.world, other.batch[2], other.batch[2]) && !meet(other.world, other.batch[2], other.batch[3])));
    CHECK(!meet(other.world, other.batch[3], other.batch[3]));
}

TEST_CASE("a pair or a snapshot for which there is no memory changes nothing") {
    CountingAllocator memory;
    lr_world_desc d = world_desc();
    d.allocator = memory.callbacks();
    uint32_t refused[2] = {0, 0};
    for (bool by_snapshot : {false, true}) {
        const Asset asset = leaf();
        const World source = make(world_desc());
        for (int i = 0; i < 2; ++i) add_batch(source, asset, 8);
        for (uint64_t k = 0;; ++k) {
            const World world = make(d);
            const lr_batch a = add_batch(world, asset, 8), b = add_batch(world, asset, 8);
            if (k == 0) set_meet(source, a, b);
            const lr_body body = add_body(world, b, body_desc());
            put_to_rest(world, body);
            const std::vector<unsigned char> before = snapshot_of(world), pair = snapshot_of(source);
            memory.fail_at = memory.calls + k;
            memory.fail_after = true;
            const lr_status status =
                by_snapshot ? restore(world, pair) : lr_batch_set_body_contact(world.get(), b, a, 1);
            memory.fail_at = CountingAllocator::never;
            memory.fail_after = false;
            if (status == LR_OK) {
                CHECK(meet(world, a, b));
                break;
            }
            ++refused[by_snapshot ? 1 : 0];
            CHECK(status == LR_ERROR_OUT_OF_MEMORY);
            CHECK(snapshot_of(world) == before);
            CHECK((rests(world, body) && !meet(world, a, b)));
        }
    }
    // Both batches have arrays for notes on their bodies.
    CHECK(refused[0] > 8);
    CHECK(refused[1] > 8);
    CHECK(memory.live() == 0);
    CHECK(!memory.mismatch);
}

TEST_CASE("bodies come to rest after a snapshot with the first colliders of a world as they do without") {
    const Asset asset = make(ellipsoid(0.02, 0.02, 0.02, 500.0));
    const World first = make(world_desc()), second = make(world_desc());
    const lr_batch batch = add_batch(first, unloaded(), asset, 1);
    REQUIRE(add_batch(second, unloaded(), asset, 1) == batch);
    add_collider(first, collider_desc(LR_COLLIDER_PLANE));
    lr_body_desc d = body_desc();
    d.position[1] = 0.1f;
    const lr_body body = add_body(first, batch, d);
    REQUIRE(restore(second, snapshot_of(first)) == LR_OK);
    for (const World* w : {&first, &second}) steps(*w, 240, 1.0f / 60.0f, 2);
    CHECK(rests(first, body));
    CHECK(rests(second, body));
    CHECK(hash_of(first) == hash_of(second));
}
