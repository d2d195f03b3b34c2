// Settings for contact with colliders through the public API: arguments, getters, snapshots.
#include "support/contact.h"
#include "support/reseal_snapshot.h"

#include <cmath>
#include <limits>

using namespace test;

namespace {

lr_batch_contact contact_of(const World& w, lr_batch batch) {
    lr_batch_contact c = initialised(lr_batch_contact_init);
    REQUIRE(lr_batch_get_contact(w.get(), batch, &c) == LR_OK);
    return c;
}
bool equal(const lr_batch_contact& a, const lr_batch_contact& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

} // namespace

TEST_CASE("a batch has the contact that it was given, initially what the header says") {
    const World world = make(world_desc());
    const Asset asset = leaf();
    const lr_batch batch = add_batch(world, asset, 4), other = add_batch(world, asset, 4);
    const lr_batch_contact first = initialised(lr_batch_contact_init);
    CHECK((first.layers == 0xffffffffu && first.friction == 0.5f && first.restitution == 0.1f));
    CHECK((first.rolling_resistance == 0.05f && first.flags == 0 && first.min_thickness == 0.0f));
    CHECK(equal(contact_of(world, batch), first));
    lr_batch_contact c = contact_desc(1.5f, 0.25f, 0.75f);
    c.layers = 6;
    c.min_thickness = 2e-3f;
    set_contact(world, batch, c);
    CHECK(equal(contact_of(world, batch), c));
    CHECK(equal(contact_of(world, other), first));
    REQUIRE(lr_batch_set_contact(world.get(), batch, nullptr) == LR_OK);
    CHECK(equal(contact_of(world, batch), first));
}

TEST_CASE("contact out of its range is refused and changes nothing") {
    const World world = make(world_desc());
    const Asset asset = leaf();
    const lr_batch batch = add_batch(world, asset, 4);
    const lr_batch_contact held = contact_desc(1.5f, 0.25f, 0.75f);
    set_contact(world, batch, held);
    const uint64_t hash = hash_of(world);
    const auto refused = [&](lr_status status, auto&& change) {
        lr_batch_contact c = initialised(lr_batch_contact_init);
        change(c);
        CHECK(lr_batch_set_contact(world.get(), batch, &c) == status);
        CHECK(equal(contact_of(world, batch), held));
    };
    using C = lr_batch_contact;
    for (float C::*value : {&C::friction, &C::restitution, &C::rolling_resistance}) {
        for (float bad : {std::nanf(""), std::numeric_limits<float>::infinity()})
            refused(LR_ERROR_NOT_FINITE, [&](C& c) { c.*value = bad; });
        for (float bad : {-0.01f, 10.01f, 1e30f}) refused(LR_ERROR_INVALID_ARGUMENT, [&](C& c) { c.*value = bad; });
    }
    refused(LR_ERROR_INVALID_ARGUMENT, [](C& c) { c.restitution = 1.01f; });
    for (float bad : {-1.01f, 10.01f}) refused(LR_ERROR_INVALID_ARGUMENT, [&](C& c) { c.min_thickness = bad; });
    refused(LR_ERROR_NOT_FINITE, [](C& c) { c.min_thickness = std::nanf(""); });
    for (uint32_t bit = 1; bit < 32; ++bit) refused(LR_ERROR_INVALID_ARGUMENT, [&](C& c) { c.flags = 1u << bit; });
    CHECK(hash_of(world) == hash);
    lr_batch_contact c = held;
    for (lr_batch stale : {lr_batch{0}, lr_batch{batch.id + 1}, lr_batch{~0u}}) {
        CHECK(lr_batch_set_contact(world.get(), stale, &c) == LR_ERROR_STALE_BATCH);
        CHECK(lr_batch_get_contact(world.get(), stale, &c) == LR_ERROR_STALE_BATCH);
    }
    for (C limit : {contact_desc(0.0f, 0.0f, 0.0f), contact_desc(10.0f, 1.0f, 10.0f)}) set_contact(world, batch, limit);
}

TEST_CASE("contact is part of the hash and of snapshots, and a damaged one is refused whole") {
    const Asset asset = leaf();
    const World a = make(world_desc()), b = make(world_desc());
    const lr_batch batch = add_batch(a, asset, 4);
    REQUIRE(add_batch(b, asset, 4) == batch);
    const uint64_t plain = hash_of(a);
    lr_batch_contact c = contact_desc(1.2345f, 0.25f, 0.75f);
    c.layers = 0x1234567u;
    set_contact(a, batch, c);
    CHECK(hash_of(a) != plain);
    const uint64_t as_thick = hash_of(a);
    c.min_thickness = 0.001f;
    set_contact(a, batch, c);
    CHECK(hash_of(a) != as_thick);
    const std::vector<unsigned char> good = snapshot_of(a);
    REQUIRE(lr_world_snapshot_restore(b.get(), good.data(), good.size()) == LR_OK);
    CHECK(equal(contact_of(b, batch), c));
    CHECK(hash_of(b) == hash_of(a));
    // Damages every word in every way: refused or accepted, the restored values are in range.
    uint32_t refused = 0;
    const float values[] = {std::nanf(""), -1.0f, 1e9f, std::numeric_limits<float>::infinity()};
    for (size_t at = 0; at + 4 <= good.size(); at += 4) {
        float word = 0.0f;
        std::memcpy(&word, good.data() + at, 4);
        const bool ours = word == 1.2345f || word == 0.25f || word == 0.75f;
        for (float value : values) {
            std::vector<unsigned char> bad = good;
            std::memcpy(bad.data() + at, &value, 4);
            seal(bad);
            const bool taken = lr_world_snapshot_restore(b.get(), bad.data(), bad.size()) == LR_OK;
            if (ours) CHECK(!taken);
            if (!taken) ++refused;
            const lr_batch_contact now = contact_of(b, batch);
            CHECK((now.friction >= 0.0f && now.friction <= 10.0f && now.restitution >= 0.0f));
            CHECK((now.restitution <= 1.0f && now.rolling_resistance >= 0.0f && now.rolling_resistance <= 10.0f));
        }
    }
    CHECK(refused >= 12);
}

TEST_CASE("layers: bodies fall through what they share none with") {
    const Asset asset = make(ellipsoid(0.02, 0.02, 0.02, 500.0));
    const std::vector<float> heights(9, 0.0f);
    for (int32_t kind : {LR_COLLIDER_PLANE, LR_COLLIDER_BOX, LR_COLLIDER_SPHERE, LR_COLLIDER_HEIGHTFIELD})
        for (uint32_t layers : {1u, 2u, 6u, 0u}) {
            CAPTURE(kind);
            CAPTURE(layers);
            const World world = make(world_desc());
            const lr_batch batch = add_batch(world, unloaded(), asset, 1);
            lr_batch_contact c = initialised(lr_batch_contact_init);
            c.layers = layers;
            set_contact(world, batch, c);
            lr_collider_desc d = kind == LR_COLLIDER_HEIGHTFIELD ? heightfield_collider(heights, 3, 1.0f)
                                 : kind == LR_COLLIDER_BOX       ? box_collider(1.0f, 0.1f, 1.0f)
                                 : kind == LR_COLLIDER_SPHERE    ? sphere_collider(1.0f)
                                                                 : collider_desc(kind);
            d.position[0] = d.position[2] = kind == LR_COLLIDER_HEIGHTFIELD ? -1.0f : 0.0f;
            d.layers = 4;
            add_collider(world, d);
            lr_body_desc body = body_desc();
            body.position[1] = 1.2f;
            const lr_body id = add_body(world, batch, body);
            steps(world, 90, 1.0f / 60.0f, 2);
            CHECK((state_of(world, id).position[1] > 0.0f) == ((layers & 4) != 0));
        }
}

TEST_CASE("another material of a collider wakes what sleeps on it, the same again does not") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 2);
    lr_collider_desc floor = box_collider(0.2f, 0.01f, 0.2f);
    const lr_collider here = add_collider(world, floor);
    floor.position[0] = 1.0f;
    add_collider(world, floor);
    lr_body_desc d = body_desc();
    d.position[1] = 0.0101f;
    const lr_body body = add_body(world, batch, d);
    d.position[0] = 1.0f;
    const lr_body other = add_body(world, batch, d);
    const auto asleep = [&](lr_body b) { return state_of(world, b).sleep_state == LR_SLEEP_ASLEEP; };
    const auto set = [&](float friction, uint32_t layers) {
        lr_material m = initialised(lr_material_init);
        m.friction = friction, m.layers = layers;
        REQUIRE(lr_collider_set_material(world.get(), &here, 1, &m) == LR_OK);
    };
    steps(world, 120, 1.0f / 60.0f);
    REQUIRE((asleep(body) && asleep(other)));
    set(0.5f, 1);
    CHECK(asleep(body));
    set(0.4f, 1);
    CHECK(!asleep(body));
    steps(world, 120, 1.0f / 60.0f);
    REQUIRE(asleep(body));
    set(0.4f, 0);
    CHECK(asleep(other));
    steps(world, 60, 1.0f / 60.0f);
    CHECK(state_of(world, body).position[1] < -0.1f); // not in the air where the floor was
}

TEST_CASE("a snapshot taken after a collider was placed wakes what lies there, as if it had not been taken") {
    const Asset asset = make(ellipsoid(0.02, 0.02, 0.02, 500.0));
    for (bool through : {false, true}) {
        const World first = make(world_desc()), second = make(world_desc());
        const lr_batch batch = add_batch(first, unloaded(), asset, 1);
        REQUIRE(add_batch(second, unloaded(), asset, 1) == batch);
        const lr_collider sphere = add_collider(first, sphere_collider(0.1f));
        const lr_body body = add_body(first, batch, body_desc());
        lr_collider_motion m = motion_of(sphere, LR_MOVE_PLACE);
        m.position[0] = 50.0f;
        REQUIRE(lr_collider_move(first.get(), &m, 1) == LR_OK);
        steps(first, 2, 0.01f);
        REQUIRE(lr_body_set_sleep(first.get(), &body, 1, LR_SLEEP_ASLEEP) == LR_OK);
        m.position[0] = 0.0f;
        m.position[1] = state_of(first, body).position[1] - 0.1f;
        REQUIRE(lr_collider_move(first.get(), &m, 1) == LR_OK);
        const std::vector<unsigned char> snapshot = snapshot_of(first);
        REQUIRE(lr_world_snapshot_restore(second.get(), snapshot.data(), snapshot.size()) == LR_OK);
        const World& world = through ? second : first;
        steps(world, 1, 0.01f);
        CHECK(state_of(world, body).sleep_state == LR_SLEEP_AWAKE);
    }
}
