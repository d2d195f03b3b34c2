#include "support/lifecycle.h"
#include "support/quick.h"
#include "support/random.h"
#include "support/scene.h"

#include <algorithm>

using namespace test;

namespace {

// Two batches on both tensor paths, after spawns, ends and some time.
struct Lived {
    World world;
    lr_batch leaves{}, curled{};
    std::vector<lr_body> ids;

    explicit Lived(const Asset& leaf, const Asset& other, uint64_t seed = 5, bool live = true) {
        lr_world_desc d = world_desc();
        d.seed = seed;
        world = make(d);
        lr_batch_desc age = batch_desc();
        age.clock = LR_CLOCK_AGE;
        leaves = add_batch(world, leaf, 40);
        curled = add_batch(world, age, other, 25);
        if (!live) return;
        Random random(seed);
        for (int i = 0; i < 50; ++i) {
            ids.push_back(add_body(world, i < 30 ? leaves : curled, strewn(random, 1.0)));
        }
        steps(world, 10, 0.01f, 2);
        for (int i : {3, 17, 31, 45}) REQUIRE(lr_body_destroy(world.get(), &ids[static_cast<size_t>(i)], 1) == LR_OK);
        ids.push_back(add_body(world, leaves, body_desc()));
        set_wind(world, 1.0f, 0.5f, -0.25f);
        steps(world, 5, 0.01f, 2);
    }
};

void live_on(const World& world, lr_batch batch, std::vector<lr_body>& spawned) {
    for (int i = 0; i < 5; ++i) {
        spawned.push_back(add_body(world, batch, body_desc()));
        steps(world, 3, 0.01f, 2);
    }
}

} // namespace

TEST_CASE("a restored world has the same ids, the same hash and the same future") {
    const Asset a = leaf(), b = curled_leaf();
    Lived lived(a, b);
    const std::vector<unsigned char> snapshot = snapshot_of(lived.world);
    const uint64_t then = hash_of(lived.world);
    std::vector<lr_body_state> states;
    std::vector<lr_status> found;
    for (lr_body id : lived.ids) {
        lr_body_state s = body_state();
        found.push_back(lr_body_get_state(lived.world.get(), id, &s));
        states.push_back(s);
    }
    std::vector<lr_body> spawned;
    live_on(lived.world, lived.leaves, spawned);
    const uint64_t later = hash_of(lived.world);
    const lr_body doomed[] = {lived.ids[0], lived.ids[40], spawned[2]};
    REQUIRE(lr_body_destroy(lived.world.get(), doomed, 3) == LR_OK);
    REQUIRE(later != then);

    // Into itself, later; into a fresh world; at an odd address.
    Lived fresh(a, b, 77, false);
    for (const World* world : {&lived.world, &fresh.world, &lived.world}) {
        std::vector<unsigned char> moved(snapshot.size() + 1);
        std::copy(snapshot.begin(), snapshot.end(), moved.begin() + 1);
        REQUIRE(lr_world_snapshot_restore(world->get(), moved.data() + 1, snapshot.size()) == LR_OK);
        CHECK(hash_of(*world) == then);
        CHECK(info_of(*world).substep_count == 30);
        CHECK(info_of(*world).time == doctest::Approx(0.15));
        CHECK(snapshot_of(*world) == snapshot);
        for (size_t i = 0; i < lived.ids.size(); ++i) {
            lr_body_state s = body_state();
            CHECK(lr_body_get_state(world->get(), lived.ids[i], &s) == found[i]);
            CHECK(same_bits(s, states[i]));
        }
        std::vector<lr_body> again;
        live_on(*world, lived.leaves, again);
        CHECK(again == spawned); // the same spawns give the same ids
        CHECK(hash_of(*world) == later);
    }
}

// The shelter of bodies that have just woken is unknown until their next turn: in between, that mark is their only record of contact.
TEST_CASE("bodies that have just been woken, and touch nothing, come back with a snapshot") {
    const Asset asset = leaf();
    lr_batch batch{};
    const auto make_world = [&] {
        World world = make(world_desc());
        batch = add_batch(world, asset, 5);
        REQUIRE(lr_batch_set_body_contact(world.get(), batch, batch, 1) == LR_OK);
        return world;
    };
    const World world = make_world();
    std::vector<lr_body> bodies;
    for (int i = 0; i < 5; ++i) {
        lr_body_desc d = body_desc();
        d.position[0] = static_cast<float>(i);
        bodies.push_back(add_body(world, batch, d));
    }
    const auto set = [&](int32_t how) { REQUIRE(lr_body_set_sleep(world.get(), bodies.data(), 5, how) == LR_OK); };
    set(LR_SLEEP_ASLEEP);
    const uint64_t asleep = hash_of(world);
    set(LR_SLEEP_AWAKE);
    REQUIRE(hash_of(world) != asleep);
    const World other = make_world();
    const std::vector<unsigned char> snapshot = snapshot_of(world);
    REQUIRE(lr_world_snapshot_restore(other.get(), snapshot.data(), snapshot.size()) == LR_OK);
    CHECK(hash_of(other) == hash_of(world));
    steps(world, 3, 0.016f), steps(other, 3, 0.016f);
    CHECK(hash_of(other) == hash_of(world));
}

TEST_CASE("a snapshot of an empty world, and of one with a hole where a batch was") {
    const World empty = make(world_desc());
    const std::vector<unsigned char> nothing = snapshot_of(empty);
    steps(empty, 3, 0.01f);
    CHECK(lr_world_snapshot_restore(empty.get(), nothing.data(), nothing.size()) == LR_OK);
    CHECK(info_of(empty).substep_count == 0);

    const Asset a = leaf();
    const World world = make(world_desc());
    const lr_batch first = add_batch(world, a, 4), second = add_batch(world, a, 4);
    const lr_body body = add_body(world, second, body_desc());
    CHECK(lr_batch_destroy(world.get(), first) == LR_OK);
    const std::vector<unsigned char> snapshot = snapshot_of(world);
    steps(world, 3, 0.01f);
    CHECK(lr_world_snapshot_restore(world.get(), snapshot.data(), snapshot.size()) == LR_OK);
    CHECK(state_of(world, body).position[1] == 0.0f);
}

TEST_CASE("tables, gravity, wind and seed come back with a snapshot") {
    const Asset a = leaf();
    const World one = make(world_desc());
    const lr_batch batch = add_batch(one, a, 4);
    set_constant_table(one, batch, 20.0, 1.0, 2.1);
    const lr_body body = add_body(one, batch, body_desc());
    const float gravity[3] = {1.0f, -2.0f, 3.0f};
    REQUIRE(lr_world_set_gravity(one.get(), gravity) == LR_OK);
    set_wind(one, 0.5f, 0.0f, 2.0f);
    const std::vector<unsigned char> snapshot = snapshot_of(one);
    lr_world_desc d = world_desc();
    d.seed = 99;
    const World two = make(d);
    add_batch(two, a, 4);
    REQUIRE(lr_world_snapshot_restore(two.get(), snapshot.data(), snapshot.size()) == LR_OK);
    steps(one, 20, 0.01f);
    steps(two, 20, 0.01f);
    CHECK(same_bits(state_of(one, body), state_of(two, body)));
}

TEST_CASE("totals of a batch whose emitter is gone come back with a snapshot, whatever they count") {
    const Asset a = leaf();
    const World one = make(world_desc()), two = make(world_desc());
    const lr_batch batch = add_batch(one, a, 1);
    add_batch(two, a, 1);
    add_body(one, batch, body_desc());
    lr_emitter_desc e = emitter_desc();
    e.rate = 1000.0f;
    set_emitter(one, batch, e);
    steps(one, 3, 0.01f); // there is no room
    const uint64_t missed = counts_of(one, batch).total_missed;
    REQUIRE(missed > 0);
    REQUIRE(lr_batch_set_emitter(one.get(), batch, nullptr) == LR_OK);
    const std::vector<unsigned char> snapshot = snapshot_of(one);
    REQUIRE(lr_world_snapshot_restore(two.get(), snapshot.data(), snapshot.size()) == LR_OK);
    CHECK(counts_of(two, batch).total_missed == missed);
    CHECK(snapshot_of(two) == snapshot);
}

TEST_CASE("a buffer too small is refused and not touched, a larger one is filled in part") {
    const Asset a = leaf(), b = curled_leaf();
    const Lived lived(a, b);
    const uint64_t size = lr_world_snapshot_size(lived.world.get());
    std::vector<unsigned char> memory(size + 100, 0x5a);
    uint64_t written = 1;
    for (uint64_t less : {uint64_t{0}, uint64_t{1}, size / 2, size - 1}) {
        CHECK(lr_world_snapshot_save(lived.world.get(), memory.data(), less, &written) == LR_ERROR_BUFFER_TOO_SMALL);
        CHECK(written == 0);
    }
    CHECK(std::count(memory.begin(), memory.end(), 0x5a) == static_cast<std::ptrdiff_t>(memory.size()));
    CHECK(lr_world_snapshot_save(lived.world.get(), memory.data(), memory.size(), &written) == LR_OK);
    CHECK(written == size);
    CHECK(std::count(memory.end() - 100, memory.end(), 0x5a) == 100);
    const uint64_t hash = hash_of(lived.world);
    steps(lived.world, 1, 0.01f);
    CHECK(lr_world_snapshot_restore(lived.world.get(), memory.data(), memory.size()) == LR_OK);
    CHECK(hash_of(lived.world) == hash);
}

TEST_CASE("snapshots of other worlds do not fit") {
    const Asset a = leaf(), b = curled_leaf();
    const Lived lived(a, b);
    const std::vector<unsigned char> snapshot = snapshot_of(lived.world);
    const auto refused = [&](const World& world, lr_status expected) {
        const std::vector<unsigned char> before = snapshot_of(world);
        CHECK(lr_world_snapshot_restore(world.get(), snapshot.data(), snapshot.size()) == expected);
        CHECK(snapshot_of(world) == before);
        steps(world, 1, 0.01f);
    };
    const World empty = make(world_desc());
    refused(empty, LR_ERROR_SNAPSHOT_MISMATCH);
    const World fewer = make(world_desc());
    add_batch(fewer, a, 40);
    refused(fewer, LR_ERROR_SNAPSHOT_MISMATCH);
    const World other_assets = make(world_desc());
    add_batch(other_assets, b, 40), add_batch(other_assets, a, 25);
    refused(other_assets, LR_ERROR_SNAPSHOT_MISMATCH);
    const World other_capacity = make(world_desc());
    add_batch(other_capacity, a, 40), add_batch(other_capacity, b, 26);
    refused(other_capacity, LR_ERROR_SNAPSHOT_MISMATCH);
    const World more = make(world_desc());
    add_batch(more, a, 40), add_batch(more, b, 25), add_batch(more, b, 1);
    refused(more, LR_ERROR_SNAPSHOT_MISMATCH);
    const World hole = make(world_desc());
    const lr_batch first = add_batch(hole, a, 40);
    add_batch(hole, b, 25);
    REQUIRE(lr_batch_destroy(hole.get(), first) == LR_OK);
    refused(hole, LR_ERROR_SNAPSHOT_MISMATCH);
}

TEST_CASE("a damaged snapshot is refused whole: every truncation, every changed byte" * doctest::test_suite("native")) {
    const Asset a = leaf(), b = curled_leaf();
    const Lived lived(a, b);
    std::vector<unsigned char> snapshot = snapshot_of(lived.world);
    steps(lived.world, 2, 0.01f);
    const std::vector<unsigned char> before = snapshot_of(lived.world);
    const uint64_t hash = hash_of(lived.world);
    lr_world* const w = lived.world.get();
    const size_t stride = quick() ? 13 : 1;
    uint32_t accepted = 0;
    for (size_t size = 0; size < snapshot.size(); size += stride) {
        const std::vector<unsigned char> cut(snapshot.begin(), snapshot.begin() + static_cast<std::ptrdiff_t>(size));
        unsigned char none = 0;
        accepted += lr_world_snapshot_restore(w, size ? cut.data() : &none, size) != LR_ERROR_SNAPSHOT_FORMAT;
    }
    CHECK(accepted == 0);
    for (size_t at = 0; at < snapshot.size(); at += stride)
        for (unsigned char change : {static_cast<unsigned char>(1u << (at % 8)), static_cast<unsigned char>(0xff)}) {
            snapshot[at] ^= change;
            accepted += lr_world_snapshot_restore(w, snapshot.data(), snapshot.size()) != LR_ERROR_SNAPSHOT_FORMAT;
            if (at % 64 == 0) accepted += hash_of(lived.world) != hash;
            snapshot[at] ^= change;
        }
    CHECK(accepted == 0);
    CHECK(snapshot_of(lived.world) == before);
    CHECK(lr_world_snapshot_restore(w, snapshot.data(), snapshot.size()) == LR_OK);
}

TEST_CASE("bytes that are no snapshot") {
    const World world = make(world_desc());
    Random random(2);
    std::vector<unsigned char> noise(4096);
    for (int round = 0; round < 100; ++round) {
        for (unsigned char& byte : noise) byte = static_cast<unsigned char>(random.bits());
        CHECK(lr_world_snapshot_restore(world.get(), noise.data(), noise.size()) == LR_ERROR_SNAPSHOT_FORMAT);
    }
}
