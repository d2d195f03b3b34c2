// Ids that are stale, invented or half right: a status, never a crash, never another body.
#include "support/colliders.h"
#include "support/random.h"
#include "support/scene.h"
#include "support/wind.h"

#include <algorithm>
#include <set>

using namespace test;

namespace {

// Every function that takes a body.
void check_stale(const World& world, lr_body body) {
    CHECK(lr_body_is_valid(world.get(), body) == 0);
    lr_body_state state = body_state();
    CHECK(lr_body_get_state(world.get(), body, &state) == LR_ERROR_STALE_BODY);
    CHECK(lr_body_set_state(world.get(), body, &state) == LR_ERROR_STALE_BODY);
    CHECK(lr_body_destroy(world.get(), &body, 1) == LR_ERROR_STALE_BODY);
}
void check_stale_batch(const World& world, lr_batch batch) {
    lr_body_desc desc = body_desc();
    lr_batch_view view = initialised(lr_batch_view_init);
    float transform[16];
    CHECK(lr_batch_is_valid(world.get(), batch) == 0);
    CHECK(lr_batch_destroy(world.get(), batch) == LR_ERROR_STALE_BATCH);
    CHECK(lr_batch_set_turbulence_table(world.get(), batch, nullptr) == LR_ERROR_STALE_BATCH);
    CHECK(lr_batch_get_view(world.get(), batch, &view) == LR_ERROR_STALE_BATCH);
    CHECK(lr_batch_write_transforms(world.get(), batch, 0, transform, 0, 1, nullptr) == LR_ERROR_STALE_BATCH);
    CHECK(lr_batch_write_velocities(world.get(), batch, transform, 0, 1, nullptr) == LR_ERROR_STALE_BATCH);
    CHECK(lr_body_create(world.get(), batch, &desc, 1, nullptr) == LR_ERROR_STALE_BATCH);
    CHECK(lr_body_create(world.get(), batch, nullptr, 0, nullptr) == LR_ERROR_STALE_BATCH);
}

std::vector<lr_body> add_row(const World& world, lr_batch batch, uint32_t count) {
    std::vector<lr_body_desc> descs(count, body_desc());
    for (uint32_t i = 0; i < count; ++i) descs[i].position[0] = static_cast<float>(i);
    std::vector<lr_body> ids(count);
    REQUIRE(lr_body_create(world.get(), batch, descs.data(), count, ids.data()) == LR_OK);
    return ids;
}

} // namespace

TEST_CASE("a destroyed body is stale, and its slot's next tenant is another body") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 1); // one slot, which is reused at once
    std::set<lr_body> seen;
    for (int life = 0; life < 1000; ++life) {
        const lr_body body = add_body(world, batch, body_desc());
        CHECK(body.id != 0);
        CHECK(seen.insert(body).second);
        CHECK(lr_body_destroy(world.get(), &body, 1) == LR_OK);
    }
    CHECK(lr_body_is_valid(world.get(), add_body(world, batch, body_desc())) == 1);
    for (lr_body body : seen) {
        lr_body_state state = body_state();
        if (lr_body_get_state(world.get(), body, &state) != LR_ERROR_STALE_BODY) FAIL("an old id found a body");
    }
}

TEST_CASE("destroying a batch ends its bodies, also when another takes its place") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    std::vector<lr_body> old;
    std::vector<lr_batch> old_batches;
    for (int life = 0; life < 20; ++life) {
        const lr_batch batch = add_batch(world, asset, 4);
        CHECK(batch.id != 0);
        for (lr_body body : add_row(world, batch, 4)) old.push_back(body);
        // The next batch must not reuse generations of slots of the destroyed one.
        CHECK(lr_body_destroy(world.get(), &old.back(), 1) == LR_OK);
        old.push_back(add_body(world, batch, body_desc()));
        old_batches.push_back(batch);
        CHECK(lr_batch_destroy(world.get(), batch) == LR_OK);
    }
    CHECK(std::set<lr_body>(old.begin(), old.end()).size() == old.size());
    CHECK(std::set<lr_batch>(old_batches.begin(), old_batches.end()).size() == old_batches.size());
    const lr_batch batch = add_batch(world, asset, 4);
    add_row(world, batch, 4);
    const uint64_t before = hash_of(world);
    for (lr_body body : old) check_stale(world, body);
    for (lr_batch stale : old_batches) check_stale_batch(world, stale);
    CHECK(hash_of(world) == before);
}

TEST_CASE("forged ids are stale") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 100), second = add_batch(world, asset, 10);
    std::vector<lr_body> ids = add_row(world, batch, 70);
    const std::vector<lr_body> more = add_row(world, second, 3);
    ids.insert(ids.end(), more.begin(), more.end());
    const std::set<lr_body> alive(ids.begin(), ids.end());
    const uint64_t before = hash_of(world);

    check_stale(world, {});
    check_stale(world, lr_body{~uint64_t{0}});
    for (lr_body body : {ids[0], ids[69], more[2]})
        for (int bit = 0; bit < 64; ++bit) {
            const lr_body forged{body.id ^ uint64_t{1} << bit};
            if (alive.count(forged) == 0) check_stale(world, forged);
        }
    Random random(1);
    lr_body_state state = body_state();
    uint32_t found = 0;
    for (int i = 0; i < 100000; ++i) {
        // Random in all bits, or only in those of slots and small generations, which hit more often.
        lr_body forged{random.bits()};
        if (i % 2) forged.id &= 0x00040000040000ffull;
        if (alive.count(forged) != 0) {
            ++found;
            continue;
        }
        if (lr_body_get_state(world.get(), forged, &state) != LR_ERROR_STALE_BODY) FAIL("a forged id found a body");
        if (lr_body_set_state(world.get(), forged, &state) != LR_ERROR_STALE_BODY) FAIL("a forged id found a body");
        if (lr_body_destroy(world.get(), &forged, 1) != LR_ERROR_STALE_BODY) FAIL("a forged id found a body");
    }
    CHECK(found > 100); // otherwise the second kind misses too much

    check_stale_batch(world, {});
    check_stale_batch(world, lr_batch{~0u});
    for (int bit = 0; bit < 32; ++bit) {
        const lr_batch forged{batch.id ^ 1u << bit};
        if (forged != second) check_stale_batch(world, forged);
    }
    for (int i = 0; i < 1000; ++i) {
        const lr_batch forged{static_cast<uint32_t>(random.bits())};
        if (forged != batch && forged != second) check_stale_batch(world, forged);
    }
    CHECK(hash_of(world) == before);
    // Ids of another world are unknown here, or name one of our bodies; nothing worse.
    const World other = make(world_desc());
    check_stale(other, ids[0]);
    check_stale_batch(other, batch);
}

TEST_CASE("a handle is valid as long as its object exists, and in no other world") {
    const Asset asset = leaf();
    const World world = make(world_desc()), other = make(world_desc());
    lr_world* const w = world.get();
    const lr_batch batch = add_batch(world, asset, 4);
    const lr_body body = add_body(world, batch, body_desc());
    const lr_collider collider = add_collider(world, collider_desc(LR_COLLIDER_PLANE));
    const lr_wind_source source = add_source(world, initialised(lr_gusts_desc_init));
    const uint64_t before = hash_of(world);
    const auto valid = [&](const lr_world* in) {
        return lr_batch_is_valid(in, batch) + 10 * lr_body_is_valid(in, body) +
               100 * lr_collider_is_valid(in, collider) + 1000 * lr_wind_source_is_valid(in, source);
    };
    CHECK(valid(w) == 1111);
    CHECK(valid(other.get()) == 0);
    CHECK(valid(nullptr) == 0);
    CHECK(hash_of(world) == before);
    REQUIRE(lr_world_remove_wind(w, source) == LR_OK);
    CHECK(valid(w) == 111);
    REQUIRE(lr_collider_destroy(w, &collider, 1) == LR_OK);
    CHECK(valid(w) == 11);
    REQUIRE(lr_batch_destroy(w, batch) == LR_OK);
    CHECK(valid(w) == 0);
    add_body(world, add_batch(world, asset, 4), body_desc());
    add_collider(world, collider_desc(LR_COLLIDER_PLANE));
    add_source(world, initialised(lr_gusts_desc_init));
    CHECK(valid(w) == 0); // the same slots
    for (uint32_t id : {0u, ~0u}) {
        CHECK(lr_collider_is_valid(w, {id}) == 0);
        CHECK(lr_wind_source_is_valid(w, {id}) == 0);
    }
}

TEST_CASE("bodies beyond the capacity: all or none") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 10);
    std::vector<lr_body> ids = add_row(world, batch, 7);
    const uint64_t before = hash_of(world);
    const std::vector<lr_body_desc> descs(10, body_desc());
    lr_body out[10] = {};
    for (uint32_t count : {4u, 10u}) {
        CHECK(lr_body_create(world.get(), batch, descs.data(), count, out) == LR_ERROR_CAPACITY);
        CHECK(out[0].id == 0);
    }
    // Without room, no desc is read: a count beyond all memory is refused like any other.
    CHECK(lr_body_create(world.get(), batch, descs.data(), UINT32_MAX, out) == LR_ERROR_CAPACITY);
    CHECK(hash_of(world) == before);
    CHECK(lr_body_create(world.get(), batch, descs.data(), 3, out) == LR_OK);
    CHECK(lr_body_create(world.get(), batch, descs.data(), 1, out) == LR_ERROR_CAPACITY);
    CHECK(lr_body_destroy(world.get(), &ids[3], 1) == LR_OK);
    CHECK(lr_body_create(world.get(), batch, descs.data(), 1, out) == LR_OK);
    CHECK(info_of(world).body_count == 10);
}

TEST_CASE("destroying many: all or none, over several batches, and none twice") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    const lr_batch a = add_batch(world, asset, 20), b = add_batch(world, asset, 20);
    const std::vector<lr_body> in_a = add_row(world, a, 20), in_b = add_row(world, b, 20);
    lr_body gone = in_b[19];
    REQUIRE(lr_body_destroy(world.get(), &gone, 1) == LR_OK);
    const uint64_t before = hash_of(world);

    for (size_t at : {size_t{0}, size_t{3}, size_t{6}}) {
        std::vector<lr_body> list = {in_a[0], in_b[0], in_a[19], in_b[7], in_a[5], in_b[18], in_a[2]};
        list[at] = gone;
        CHECK(lr_body_destroy(world.get(), list.data(), 7) == LR_ERROR_STALE_BODY);
        list = {in_a[0], in_b[0], in_a[19], in_b[7], in_a[5], in_b[18], in_a[2]};
        list[(at + 4) % 7] = list[at];
        CHECK(lr_body_destroy(world.get(), list.data(), 7) == LR_ERROR_STALE_BODY);
    }
    CHECK(hash_of(world) == before);
    CHECK(info_of(world).body_count == 39);
    // All still work after the refusals.
    for (uint32_t i = 0; i < 20; ++i) CHECK(state_of(world, in_a[i]).position[0] == static_cast<float>(i));

    const std::vector<lr_body> list = {in_a[0], in_b[0], in_a[19], in_b[7], in_a[5]};
    CHECK(lr_body_destroy(world.get(), list.data(), 5) == LR_OK);
    CHECK(info_of(world).body_count == 34);
    for (lr_body body : list) check_stale(world, body);
    CHECK(state_of(world, in_a[18]).position[0] == 18.0f);
    CHECK(state_of(world, in_b[18]).position[0] == 18.0f);
}

TEST_CASE("any order of creation and destruction keeps each id with its body") {
    const Asset asset = leaf();
    lr_world_desc wd = world_desc();
    wd.gravity[1] = 0.0f;
    const World world = make(wd);
    const lr_batch batch = add_batch(world, asset, 300);
    Random random(7);
    std::vector<std::pair<lr_body, float>> model; // id and mark from its creation
    std::vector<lr_body> dead;
    float mark = 0.0f;
    for (int round = 0; round < 400; ++round) {
        const uint32_t births = std::min(random.below(20), 300u - static_cast<uint32_t>(model.size()));
        std::vector<lr_body_desc> descs(births, body_desc());
        std::vector<lr_body> ids(births);
        for (lr_body_desc& d : descs) d.position[2] = mark += 1.0f;
        REQUIRE(lr_body_create(world.get(), batch, descs.data(), births, ids.data()) == LR_OK);
        for (uint32_t i = 0; i < births; ++i) model.emplace_back(ids[i], descs[i].position[2]);
        std::vector<lr_body> deaths;
        for (uint32_t i = random.below(20); i > 0 && !model.empty(); --i) {
            const uint32_t at = random.below(static_cast<uint32_t>(model.size()));
            deaths.push_back(model[at].first);
            model[at] = model.back();
            model.pop_back();
        }
        REQUIRE(lr_body_destroy(world.get(), deaths.data(), static_cast<uint32_t>(deaths.size())) == LR_OK);
        dead.insert(dead.end(), deaths.begin(), deaths.end());
    }
    REQUIRE(info_of(world).body_count == model.size());
    for (const auto& [id, spawned] : model) CHECK(state_of(world, id).position[2] == spawned);
    lr_body_state state = body_state();
    for (lr_body id : dead)
        if (lr_body_get_state(world.get(), id, &state) != LR_ERROR_STALE_BODY) FAIL("a dead id found a body");
    // The view has no gaps and lists the same bodies.
    const lr_batch_view view = view_of(world, batch);
    REQUIRE(view.count == model.size());
    const std::set<lr_body> listed(view.ids, view.ids + view.count);
    CHECK(listed.size() == model.size());
    for (const auto& [id, spawned] : model) CHECK(listed.count(id) == 1);
}

TEST_CASE("bodies of one call and of many calls get the same noise seeds") {
    const Asset asset = leaf();
    const World one = make(world_desc()), many = make(world_desc());
    const lr_batch a = add_batch(one, asset, 50), b = add_batch(many, asset, 50);
    add_row(one, a, 50);
    for (uint32_t i = 0; i < 50; ++i) {
        lr_body_desc d = body_desc();
        d.position[0] = static_cast<float>(i);
        add_body(many, b, d);
    }
    CHECK(hash_of(one) == hash_of(many));
    steps(one, 5, 0.01f, 2);
    steps(many, 5, 0.01f, 2);
    CHECK(hash_of(one) == hash_of(many));
    const lr_batch_view view = view_of(one, a);
    CHECK(std::set<uint32_t>(view.noise_seed, view.noise_seed + 50).size() == 50);
    // A refused call uses no noise seeds.
    lr_body_desc bad[2] = {body_desc(), body_desc()};
    bad[1].scale = -1.0f;
    const lr_batch more = add_batch(one, asset, 3);
    CHECK(lr_body_create(one.get(), more, bad, 2, nullptr) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(state_of(one, add_body(one, more, body_desc())).noise_seed == 51);
}

TEST_CASE("more batches than the first table holds") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    std::vector<lr_batch> batches;
    std::vector<lr_body> bodies;
    for (uint32_t i = 0; i < 200; ++i) {
        batches.push_back(add_batch(world, asset, 2));
        lr_body_desc d = body_desc();
        d.position[1] = static_cast<float>(i);
        bodies.push_back(add_body(world, batches.back(), d));
    }
    CHECK(std::set<lr_batch>(batches.begin(), batches.end()).size() == 200);
    for (uint32_t i = 0; i < 200; i += 3) CHECK(lr_batch_destroy(world.get(), batches[i]) == LR_OK);
    steps(world, 1, 0.001f);
    for (uint32_t i = 0; i < 200; ++i) {
        if (i % 3 == 0)
            check_stale(world, bodies[i]);
        else
            CHECK(state_of(world, bodies[i]).position[1] == doctest::Approx(i).epsilon(1e-3));
    }
    CHECK(info_of(world).batch_count == 133);
}
