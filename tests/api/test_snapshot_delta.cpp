#include "support/colliders.h"
#include "support/counting_memory.h"
#include "support/random.h"
#include "support/scene.h"

#include <algorithm>

using namespace test;

namespace {

using Bytes = std::vector<unsigned char>;

// Two batches that live through all that moves columns about in a snapshot.
struct Storm {
    Asset assets[2] = {leaf(), curled_leaf()};
    World world;
    lr_batch batches[2] = {};
    std::vector<lr_body> ids;
    Random random{8};

    explicit Storm(uint32_t bodies = 150) {
        world = make(world_desc());
        lr_batch_desc other = langevin();
        other.clock = LR_CLOCK_AGE;
        batches[0] = add_batch(world, assets[0], bodies);
        batches[1] = add_batch(world, other, assets[1], 90);
        const lr_collider_desc ground = collider_desc(LR_COLLIDER_PLANE);
        REQUIRE(lr_collider_create(world.get(), &ground, 1, nullptr) == LR_OK);
        set_wind(world, 1.0f, 0.0f, 0.5f);
        for (uint32_t i = 0; i < bodies; ++i) bear(0);
        for (int i = 0; i < 40; ++i) bear(1);
        steps(world, 5, 0.016f, 2);
    }
    void bear(size_t batch) {
        lr_body_desc d = body_desc();
        for (float& x : d.position) x = random.real(0.5, 3.0);
        for (float& q : d.orientation) q = random.real(-1.0, 1.0);
        lr_body id = 0;
        if (lr_body_create(world.get(), batches[batch], &d, 1, &id) == LR_OK) ids.push_back(id);
    }
    void rest(uint32_t count) { REQUIRE(lr_body_set_rest(world.get(), ids.data(), count, LR_REST_RESTING) == LR_OK); }
    void end(uint32_t count) {
        REQUIRE(lr_body_destroy(world.get(), ids.data(), count) == LR_OK);
        ids.erase(ids.begin(), ids.begin() + count);
    }
};

Bytes delta_of(const Bytes& base, const Bytes& snapshot) {
    Bytes delta(lr_snapshot_delta_bound(snapshot.size()));
    uint64_t written = 0;
    REQUIRE(lr_snapshot_delta_encode(base.data(), base.size(), snapshot.data(), snapshot.size(), delta.data(),
                                     delta.size(), &written) == LR_OK);
    delta.resize(written);
    return delta;
}

lr_status apply(const Bytes& base, const Bytes& delta, Bytes& made) {
    uint64_t written = 0;
    const lr_status asked =
        lr_snapshot_delta_apply(base.data(), base.size(), delta.data(), delta.size(), nullptr, 0, &written);
    if (asked != LR_ERROR_BUFFER_TOO_SMALL) return asked;
    made.assign(written, 0xa5);
    return lr_snapshot_delta_apply(base.data(), base.size(), delta.data(), delta.size(), made.data(), made.size(),
                                   &written);
}

void there_and_back(const Bytes& base, const Bytes& snapshot) {
    Bytes made;
    CHECK(apply(base, delta_of(base, snapshot), made) == LR_OK);
    CHECK(made == snapshot);
}

} // namespace

TEST_CASE("a delta gives back the very bytes: steps, births, ends, rest, forces, rules, other batches") {
    Storm storm;
    std::vector<Bytes> states = {snapshot_of(storm.world)};
    const auto then = [&](auto&& change) {
        change();
        states.push_back(snapshot_of(storm.world));
    };
    then([] {});
    then([&] { steps(storm.world, 1, 0.016f, 2); });
    then([&] { storm.rest(60); });
    then([&] { steps(storm.world, 40, 0.016f, 2); });
    then([&] { storm.end(21); });
    then([&] { storm.bear(0), storm.bear(1), storm.bear(1); });
    then([&] {
        lr_body_force f = initialised(lr_body_force_init);
        f.body = storm.ids.back(), f.force[0] = 1e-4f;
        REQUIRE(lr_body_add_force(storm.world.get(), &f, 1) == LR_OK);
    });
    then([&] { set_constant_table(storm.world, storm.batches[1], 3.0, 0.1, 2.0); });
    then([&] {
        const lr_emitter_desc e = initialised(lr_emitter_desc_init);
        REQUIRE(lr_batch_set_emitter(storm.world.get(), storm.batches[0], &e) == LR_OK);
        const lr_collider_desc ball = sphere_collider(0.5f);
        REQUIRE(lr_collider_create(storm.world.get(), &ball, 1, nullptr) == LR_OK);
        steps(storm.world, 1, 0.016f, 2);
    });
    then([&] { storm.end(static_cast<uint32_t>(storm.ids.size())); });
    then([&] { REQUIRE(lr_batch_destroy(storm.world.get(), storm.batches[0]) == LR_OK); });
    then([&] { add_batch(storm.world, storm.assets[1], 500), add_batch(storm.world, storm.assets[0], 10); });
    for (const Bytes& base : states)
        for (const Bytes& snapshot : states) there_and_back(base, snapshot);
    there_and_back(states[0], snapshot_of(make(world_desc())));
    there_and_back(snapshot_of(make(world_desc())), states[0]);
}

TEST_CASE("a restored delta is the world that was saved") {
    Storm storm;
    const Bytes base = snapshot_of(storm.world);
    steps(storm.world, 3, 0.016f, 2);
    const Bytes delta = delta_of(base, snapshot_of(storm.world));
    const uint64_t hash = hash_of(storm.world);
    steps(storm.world, 7, 0.016f, 2);
    Bytes made;
    REQUIRE(apply(base, delta, made) == LR_OK);
    REQUIRE(lr_world_snapshot_restore(storm.world.get(), made.data(), made.size()) == LR_OK);
    CHECK(hash_of(storm.world) == hash);
}

TEST_CASE("what has not changed takes next to nothing, what rests little") {
    Storm storm(2000);
    storm.rest(1900);
    const Bytes base = snapshot_of(storm.world);
    steps(storm.world, 1, 0.016f, 2);
    const Bytes next = snapshot_of(storm.world);
    CHECK(delta_of(base, base).size() < base.size() / 1000 + 100);
    const size_t awake = 140; // the second batch among them
    CHECK(delta_of(base, next).size() < awake * 80 + 2000);
    CHECK(delta_of(base, next).size() < next.size() / 15);
    CHECK(delta_of(base, next).size() > awake * 20); // or they would not move
}

TEST_CASE("no delta is longer than the bound, however unlike the snapshots; any alignment; more bytes behind") {
    Random random(4);
    for (uint32_t bodies : {1u, 31u, 63u, 64u, 65u, 400u}) {
        Storm storm(bodies), other(bodies);
        steps(other.world, 100, 0.05f, 2);
        const Bytes a = snapshot_of(storm.world), b = snapshot_of(other.world);
        const uint64_t bound = lr_snapshot_delta_bound(b.size());
        CHECK(bound < b.size() + b.size() / 4 + 400);
        for (size_t shift : {size_t{0}, size_t{1}, size_t{7}}) {
            Bytes base(a.size() + shift + 100), next(b.size() + shift + 3), delta(bound + 64, 0x5a),
                made(b.size() + 64, 0x5a);
            std::copy(a.begin(), a.end(), base.begin() + static_cast<std::ptrdiff_t>(shift));
            std::copy(b.begin(), b.end(), next.begin() + static_cast<std::ptrdiff_t>(shift));
            uint64_t written = 0, back = 0;
            CHECK(lr_snapshot_delta_encode(base.data() + shift, a.size() + 100, next.data() + shift, b.size() + 3,
                                           delta.data() + shift, bound, &written) == LR_OK);
            CHECK(written <= bound);
            CHECK(std::count(delta.begin() + static_cast<std::ptrdiff_t>(shift + bound), delta.end(), 0x5a) ==
                  static_cast<std::ptrdiff_t>(64 - shift));
            CHECK(lr_snapshot_delta_apply(base.data() + shift, a.size() + 100, delta.data() + shift, bound,
                                          made.data() + shift, b.size(), &back) == LR_OK);
            CHECK(back == b.size());
            CHECK(std::equal(b.begin(), b.end(), made.begin() + static_cast<std::ptrdiff_t>(shift)));
            CHECK(std::count(made.begin() + static_cast<std::ptrdiff_t>(shift + back), made.end(), 0x5a) ==
                  static_cast<std::ptrdiff_t>(64 - shift));
        }
    }
    CHECK(lr_snapshot_delta_bound(0) > 0);
    CHECK(lr_snapshot_delta_bound(UINT64_MAX) == UINT64_MAX);
}

TEST_CASE("refused deltas: null, overlapping, too small, another base") {
    Storm storm;
    Bytes base = snapshot_of(storm.world);
    steps(storm.world, 1, 0.016f, 2);
    Bytes next = snapshot_of(storm.world);
    Bytes delta(lr_snapshot_delta_bound(next.size())), made(next.size());
    uint64_t written = 1;
    const auto encode = [&](const void* b, const void* n, void* m, uint64_t capacity) {
        return lr_snapshot_delta_encode(b, base.size(), n, next.size(), m, capacity, &written);
    };
    CHECK(encode(nullptr, next.data(), delta.data(), delta.size()) == LR_ERROR_NULL_ARGUMENT);
    CHECK(written == 0);
    CHECK(encode(base.data(), nullptr, delta.data(), delta.size()) == LR_ERROR_NULL_ARGUMENT);
    CHECK(encode(base.data(), next.data(), nullptr, delta.size()) == LR_ERROR_NULL_ARGUMENT);
    CHECK(encode(base.data(), next.data(), base.data() + 8, 64) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(encode(base.data(), next.data(), next.data(), next.size()) == LR_ERROR_INVALID_ARGUMENT);
    REQUIRE(encode(base.data(), next.data(), delta.data(), delta.size()) == LR_OK);
    const uint64_t size = written;
    delta.resize(size);
    const Bytes good = delta;
    for (uint64_t less = 0; less < size; less += 1 + less / 40) {
        Bytes small(std::max<uint64_t>(less, 1));
        CHECK(encode(base.data(), next.data(), small.data(), less) == LR_ERROR_BUFFER_TOO_SMALL);
        CHECK(written == 0);
    }
    Bytes exact(size);
    CHECK(encode(base.data(), next.data(), exact.data(), size) == LR_OK);
    CHECK(exact == good);

    const auto put = [&](const void* b, const void* d, void* m, uint64_t capacity) {
        return lr_snapshot_delta_apply(b, base.size(), d, size, m, capacity, &written);
    };
    CHECK(put(nullptr, delta.data(), made.data(), made.size()) == LR_ERROR_NULL_ARGUMENT);
    CHECK(put(base.data(), nullptr, made.data(), made.size()) == LR_ERROR_NULL_ARGUMENT);
    CHECK(put(base.data(), delta.data(), nullptr, made.size()) == LR_ERROR_NULL_ARGUMENT);
    CHECK(put(base.data(), delta.data(), base.data(), base.size()) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(put(base.data(), delta.data(), delta.data(), delta.size()) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(put(base.data(), delta.data(), nullptr, 0) == LR_ERROR_BUFFER_TOO_SMALL);
    CHECK(written == next.size());
    std::fill(made.begin(), made.end(), static_cast<unsigned char>(0x5a));
    CHECK(put(base.data(), delta.data(), made.data(), made.size() - 1) == LR_ERROR_BUFFER_TOO_SMALL);
    CHECK(std::count(made.begin(), made.end(), 0x5a) == static_cast<std::ptrdiff_t>(made.size()));
    REQUIRE(next.size() == base.size());
    CHECK(put(next.data(), delta.data(), made.data(), made.size()) == LR_ERROR_SNAPSHOT_MISMATCH);
    CHECK(written == 0);
    // A delta is no snapshot, and a snapshot no delta.
    CHECK(lr_world_snapshot_restore(storm.world.get(), delta.data(), delta.size()) == LR_ERROR_SNAPSHOT_FORMAT);
    CHECK(put(delta.data(), delta.data(), made.data(), made.size()) == LR_ERROR_SNAPSHOT_FORMAT);
    CHECK(put(base.data(), next.data(), made.data(), made.size()) == LR_ERROR_SNAPSHOT_FORMAT);
}

TEST_CASE("a damaged delta or base is refused: every truncation, every changed byte" * doctest::test_suite("native")) {
    Storm storm(20);
    Bytes base = snapshot_of(storm.world);
    steps(storm.world, 1, 0.016f, 2);
    const Bytes next = snapshot_of(storm.world);
    Bytes delta = delta_of(base, next), made(next.size());
    const auto put = [&](uint64_t size) {
        return lr_snapshot_delta_apply(base.data(), base.size(), delta.data(), size, made.data(), made.size(), nullptr);
    };
    uint32_t accepted = 0;
    for (uint64_t size = 0; size < delta.size(); ++size) accepted += put(size) != LR_ERROR_SNAPSHOT_FORMAT;
    for (unsigned char& byte : delta)
        for (uint32_t change : {0x1u, 0x80u, 0xffu}) {
            byte = static_cast<unsigned char>(byte ^ change);
            accepted += put(delta.size()) != LR_ERROR_SNAPSHOT_FORMAT;
            byte = static_cast<unsigned char>(byte ^ change);
        }
    for (unsigned char& byte : base) {
        byte ^= 0x10;
        const lr_status status = put(delta.size());
        accepted += status != LR_ERROR_SNAPSHOT_FORMAT && status != LR_ERROR_SNAPSHOT_MISMATCH;
        accepted += lr_snapshot_delta_encode(base.data(), base.size(), next.data(), next.size(), made.data(),
                                             made.size(), nullptr) != LR_ERROR_SNAPSHOT_FORMAT;
        byte ^= 0x10;
    }
    CHECK(accepted == 0);
    CHECK(put(delta.size()) == LR_OK);
    CHECK(made == next);
}

TEST_CASE("a rollback allocates nothing: saves, restores and deltas of a world that has held as much before" *
          doctest::test_suite("exact")) {
    CountingAllocator memory;
    lr_world_desc d = world_desc();
    d.allocator = memory.callbacks();
    const Asset asset = leaf();
    const World world = make(d);
    const lr_batch batch = add_batch(world, asset, 300);
    set_constant_table(world, batch, 3.0, 0.1, 2.0);
    const lr_collider_desc solid[2] = {collider_desc(LR_COLLIDER_PLANE), sphere_collider(0.5f)};
    lr_collider colliders[2] = {};
    REQUIRE(lr_collider_create(world.get(), solid, 2, colliders) == LR_OK);
    lr_wind_source_desc gusts = initialised(lr_wind_source_desc_init);
    gusts.kind = LR_WIND_SOURCE_GUSTS;
    lr_wind_source source = 0;
    REQUIRE(lr_world_add_wind(world.get(), &gusts, &source) == LR_OK);
    lr_emitter_desc e = initialised(lr_emitter_desc_init);
    e.rate = 100.0f, e.position[1] = 1.0f;
    e.shape = LR_EMIT_BOX;
    for (float& side : e.size) side = 0.4f; // all of them at a point would be 20,000 pairs that overlap
    REQUIRE(lr_batch_set_emitter(world.get(), batch, &e) == LR_OK);
    lr_batch_rules r = initialised(lr_batch_rules_init);
    r.max_age = 1.0f, r.action = LR_END_RESPAWN;
    REQUIRE(lr_batch_set_rules(world.get(), batch, &r) == LR_OK);
    std::vector<lr_body> ids(200);
    REQUIRE(lr_batch_emit(world.get(), batch, 200, ids.data()) == LR_OK);
    REQUIRE(lr_body_set_rest(world.get(), ids.data(), 120, LR_REST_RESTING) == LR_OK);
    REQUIRE(lr_batch_set_pair_contact(world.get(), batch, batch, 1) == LR_OK);
    steps(world, 2, 0.016f, 2);

    Bytes ring[2], delta;
    for (Bytes& bytes : ring) bytes.resize(2 * lr_world_snapshot_size(world.get()));
    delta.resize(lr_snapshot_delta_bound(ring[0].size()));
    lr_body_force f = initialised(lr_body_force_init);
    f.force[1] = 1e-4f;
    lr_collider_motion motion = initialised(lr_collider_motion_init);
    motion.collider = colliders[1], motion.mode = LR_MOVE_TO;
    bool ok = true;
    const auto round = [&](float input) {
        uint64_t size = 0, later = 0, bytes = 0;
        ok = ok && lr_world_snapshot_save(world.get(), ring[0].data(), ring[0].size(), &size) == LR_OK;
        gusts.speed = input;
        f.body = ids[150], motion.position[0] = input;
        ok = ok && lr_world_update_wind(world.get(), source, &gusts) == LR_OK;
        ok = ok && lr_body_add_force(world.get(), &f, 1) == LR_OK;
        ok = ok && lr_collider_move(world.get(), &motion, 1) == LR_OK;
        ok = ok && lr_body_set_rest(world.get(), ids.data() + 60, 20, LR_REST_AWAKE) == LR_OK;
        ok = ok && lr_world_step(world.get(), 0.016f, 2) == LR_OK;
        ok = ok && lr_world_snapshot_save(world.get(), ring[1].data(), ring[1].size(), &later) == LR_OK;
        ok = ok && lr_snapshot_delta_encode(ring[0].data(), size, ring[1].data(), later, delta.data(), delta.size(),
                                            &bytes) == LR_OK;
        ok = ok && lr_world_snapshot_restore(world.get(), ring[0].data(), size) == LR_OK;
        ok = ok && lr_snapshot_delta_apply(ring[0].data(), size, delta.data(), bytes, ring[1].data(), ring[1].size(),
                                           nullptr) == LR_OK;
    };
    round(0.5f), round(0.6f);
    const uint64_t own = memory.calls, global = global_allocations;
    for (int i = 0; i < 10; ++i) round(0.1f * static_cast<float>(i));
    CHECK(memory.calls == own);
    CHECK(global_allocations == global);
    CHECK(ok);
}
