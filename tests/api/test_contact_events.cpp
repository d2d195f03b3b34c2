// Hits, lifts, landings, wakes and ends of scripted falls: in order, bounded, the same with any number of threads.
#include "support/contact_events.h"
#include "support/counting_memory.h"
#include "support/quick.h"
#include "support/vector.h"

#include <cmath>

using namespace test;

namespace {

lr_body_desc at(float x, float y, float z) {
    lr_body_desc d = body_desc();
    d.position[0] = x, d.position[1] = y, d.position[2] = z;
    return d;
}

// A heavy ball of 1 cm, hardly affected by air.
Asset ball() {
    return make(ellipsoid(0.01, 0.01, 0.01, 5000.0));
}

} // namespace

TEST_CASE("a ball that falls on a plane begins to touch it once, lands, and is woken by a force") {
    const Asset asset = ball();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 4);
    const lr_collider plane = add_collider(world, collider_desc(LR_COLLIDER_PLANE));
    keep_events(world);
    lr_body_desc above = at(0.3f, 0.5f, -0.2f);
    above.user = 77;
    const lr_body body = add_body(world, batch, above);

    const std::vector<lr_event> fall = step_until(world, LR_EVENT_HIT, 100, 1.0f / 240.0f, 4);
    REQUIRE(fall.size() == 1);
    const lr_event& begin = fall[0];
    CHECK(begin.batch == batch);
    CHECK(begin.body == body);
    CHECK(begin.collider == plane);
    // v = sqrt(2 g h) except for drag and a substep; the impulse stops it, and restitution adds a little.
    const double speed = std::sqrt(2.0 * 9.81 * 0.49), mass = 5000.0 * 4.0 / 3.0 * 3.14159265 * 1e-6;
    CHECK(wide(begin.speed) == doctest::Approx(speed).epsilon(0.01));
    CHECK(wide(begin.impulse) > 0.99 * mass * wide(begin.speed));
    CHECK(wide(begin.impulse) < 1.25 * mass * wide(begin.speed));
    CHECK(wide(begin.position[0]) == doctest::Approx(0.3).epsilon(1e-3));
    CHECK(std::abs(begin.position[1]) < 1e-3f);
    CHECK((begin.normal[0] == 0.0f && begin.normal[1] == 1.0f && begin.normal[2] == 0.0f));
    CHECK(begin.user == 77);

    // Bounces are reported too. At the end it lies: one more contact has begun than ended.
    const std::vector<lr_event> rest = step_until(world, LR_EVENT_LANDED, 2000, 1.0f / 240.0f, 4);
    CHECK(count_of(rest, LR_EVENT_LANDED) == 1);
    CHECK(count_of(rest, LR_EVENT_HIT) == count_of(rest, LR_EVENT_LIFTED));
    CHECK(state_of(world, body).sleep_state == LR_SLEEP_ASLEEP);
    steps(world, 50, 1.0f / 240.0f, 4);
    CHECK(events_of(world).empty());

    lr_body_force push = initialised(lr_body_force_init);
    push.body = body;
    push.mode = LR_FORCE_MODE_VELOCITY;
    push.force[1] = 1.0f;
    REQUIRE(lr_body_add_force(world.get(), &push, 1) == LR_OK);
    CHECK(events_of(world).empty());
    steps(world, 1, 1.0f / 240.0f, 4);
    const std::vector<lr_event> woken = events_of(world);
    REQUIRE(woken.size() == 2);
    CHECK((woken[0].kind == LR_EVENT_LIFTED && woken[0].collider == plane && woken[0].body == body));
    CHECK((woken[1].kind == LR_EVENT_WOKE && woken[1].collider.id == 0 && woken[1].body == body));
}

TEST_CASE("a contact that begins and ends within a step is reported in it") {
    const Asset asset = ball();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 4);
    lr_collider_desc d = collider_desc(LR_COLLIDER_PLANE);
    d.restitution = 1.0f;
    const lr_collider plane = add_collider(world, d);
    keep_events(world);
    lr_body_desc body = at(0.0f, 0.05f, 0.0f);
    body.linear_velocity[1] = -5.0f;
    add_body(world, batch, body);
    steps(world, 1, 0.05f, 32);
    const std::vector<lr_event> events = events_of(world);
    REQUIRE(events.size() == 2);
    CHECK((events[0].kind == LR_EVENT_HIT && events[0].collider == plane));
    CHECK(wide(events[0].speed) == doctest::Approx(5.0).epsilon(0.03));
    CHECK((events[1].kind == LR_EVENT_LIFTED && events[1].collider == plane));
}

TEST_CASE("a ball that slides over more planks in a step than it can touch at once hits each with a normal") {
    const Asset asset = ball();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 1);
    lr_collider_desc plank = box_collider(0.001f, 0.01f, 1.0f);
    plank.position[1] = -0.01f;
    for (int i = 0; i < 400; ++i) {
        plank.position[0] = 0.002f * static_cast<float>(i);
        add_collider(world, plank);
    }
    keep_events(world);
    lr_body_desc d = at(0.02f, 0.01f, 0.0f);
    d.linear_velocity[0] = 1.5f;
    add_body(world, batch, d);
    size_t most = 0;
    for (int i = 0; i < 20; ++i) {
        steps(world, 1, 1.0f / 60.0f, 32);
        const std::vector<lr_event> all = events_of(world);
        most = std::max(most, count_of(all, LR_EVENT_HIT));
        for (const lr_event& e : all) {
            if (e.kind != LR_EVENT_HIT) continue;
            CHECK(length(vec(e.normal)) == doctest::Approx(1.0));
            CHECK(std::abs(e.position[1]) < 2e-5f);
        }
    }
    CHECK(most >= 4);
}

TEST_CASE("a collider that comes wakes what lies there, and one that goes ends its contacts under its own id") {
    const Asset asset = ball();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 4);
    const lr_collider plane = add_collider(world, collider_desc(LR_COLLIDER_PLANE));
    keep_events(world);
    const lr_body body = add_body(world, batch, at(0.0f, 0.011f, 0.0f));
    const std::vector<lr_event> rest = step_until(world, LR_EVENT_LANDED, 2000);
    REQUIRE(count_of(rest, LR_EVENT_LANDED) == 1);

    lr_collider_desc ball_beside = sphere_collider(0.02f);
    ball_beside.position[0] = 0.0295f; // its box reaches the body's, but the ball does not touch it
    ball_beside.position[1] = 0.035f;
    add_collider(world, ball_beside);
    steps(world, 1, 1.0f / 60.0f, 4);
    CHECK(count_of(events_of(world), LR_EVENT_WOKE) == 1);
    step_until(world, LR_EVENT_LANDED, 2000);

    SUBCASE("and nothing else is there") {
        REQUIRE(lr_collider_destroy(world.get(), &plane, 1) == LR_OK);
        steps(world, 1, 1.0f / 60.0f, 4);
        const std::vector<lr_event> events = events_of(world);
        REQUIRE(count_of(events, LR_EVENT_LIFTED) == 1);
        CHECK(count_of(events, LR_EVENT_HIT) == 0);
        const auto end =
            std::find_if(events.begin(), events.end(), [](const lr_event& e) { return e.kind == LR_EVENT_LIFTED; });
        CHECK((end->collider == plane && end->body == body));
    }
    SUBCASE("and another takes its slot") {
        REQUIRE(lr_collider_destroy(world.get(), &plane, 1) == LR_OK);
        const lr_collider next = add_collider(world, collider_desc(LR_COLLIDER_PLANE));
        REQUIRE(static_cast<uint32_t>(next.id) == static_cast<uint32_t>(plane.id)); // the same slot
        REQUIRE(next != plane);
        steps(world, 1, 1.0f / 60.0f, 4);
        const std::vector<lr_event> events = events_of(world);
        REQUIRE(count_of(events, LR_EVENT_LIFTED) == 1);
        REQUIRE(count_of(events, LR_EVENT_HIT) == 1);
        CHECK((events[0].kind == LR_EVENT_HIT && events[0].collider == next && events[0].normal[1] == 1.0f));
        CHECK((events[1].kind == LR_EVENT_LIFTED && events[1].collider == plane));
    }
    steps(world, 1, 1.0f / 60.0f, 4);
    CHECK(count_of(events_of(world), LR_EVENT_LIFTED) == 0);
}

TEST_CASE("the last collider of a world goes: contacts end although nothing is held against anything") {
    const Asset asset = ball();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 4);
    const lr_collider plane = add_collider(world, collider_desc(LR_COLLIDER_PLANE));
    keep_events(world);
    add_body(world, batch, at(0.0f, 0.0101f, 0.0f));
    step_until(world, LR_EVENT_HIT, 20);
    steps(world, 1, 1.0f / 60.0f, 4); // before it falls asleep
    REQUIRE(lr_collider_destroy(world.get(), &plane, 1) == LR_OK);
    steps(world, 1, 1.0f / 60.0f, 4);
    const std::vector<lr_event> events = events_of(world);
    REQUIRE(events.size() == 1);
    CHECK((events[0].kind == LR_EVENT_LIFTED && events[0].collider == plane));
    steps(world, 1, 1.0f / 60.0f, 4);
    CHECK(events_of(world).empty());
}

TEST_CASE("a batch that meets nothing any more ends its contacts, and begins them again when it does") {
    const Asset asset = ball();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 4);
    const lr_collider plane = add_collider(world, collider_desc(LR_COLLIDER_PLANE));
    keep_events(world);
    add_body(world, batch, at(0.0f, 0.0101f, 0.0f));
    steps(world, 10, 1.0f / 60.0f, 4);
    lr_batch_contact contact = initialised(lr_batch_contact_init);
    const uint32_t layers = contact.layers;
    contact.layers = 0;
    REQUIRE(lr_batch_set_contact(world.get(), batch, &contact) == LR_OK);
    steps(world, 1, 0.001f, 1);
    std::vector<lr_event> events = events_of(world);
    CHECK(count_of(events, LR_EVENT_LIFTED) == 1);
    CHECK(count_of(events, LR_EVENT_HIT) == 0);
    contact.layers = layers;
    REQUIRE(lr_batch_set_contact(world.get(), batch, &contact) == LR_OK);
    steps(world, 1, 0.001f, 1);
    events = events_of(world);
    REQUIRE(count_of(events, LR_EVENT_HIT) == 1);
    CHECK((events[0].collider == plane && events[0].normal[1] == 1.0f));
}

TEST_CASE("bodies that rules end are told as killed, once, and nothing of those destroyed by the caller") {
    for (const bool respawns : {false, true}) {
        CAPTURE(respawns);
        const Asset asset = ball();
        const World world = make(world_desc());
        const lr_batch batch = add_batch(world, asset, 8);
        add_collider(world, collider_desc(LR_COLLIDER_PLANE));
        if (respawns) {
            lr_emitter_desc e = initialised(lr_emitter_desc_init);
            e.position[1] = 5.0f;
            REQUIRE(lr_batch_set_emitter(world.get(), batch, &e) == LR_OK);
        }
        lr_batch_rules r = initialised(lr_batch_rules_init);
        r.max_age = 0.4f;
        r.action = respawns ? LR_END_RESPAWN : LR_END_DESTROY;
        REQUIRE(lr_batch_set_rules(world.get(), batch, &r) == LR_OK);
        keep_events(world);
        lr_body_desc d = at(0.0f, 0.011f, 0.0f);
        d.user = 5;
        const lr_body dies = add_body(world, batch, d);
        d.position[0] = 1.0f;
        const lr_body destroyed = add_body(world, batch, d);
        steps(world, 20, 1.0f / 60.0f, 4);
        REQUIRE(lr_body_destroy(world.get(), &destroyed, 1) == LR_OK);
        const int32_t ended = respawns ? LR_EVENT_RESPAWNED : LR_EVENT_KILLED;
        const std::vector<lr_event> all = step_until(world, ended, 20);
        for (const lr_event& e : all) CHECK((e.body == dies && e.user == 5));
        CHECK(count_of(all, ended) == 1);
        CHECK(all.back().kind == ended);
        CHECK(wide(all.back().position[1]) == doctest::Approx(0.01).epsilon(0.1));
        CHECK(count_of(all, LR_EVENT_LIFTED) == 0);
        lr_body_state s = body_state();
        CHECK(lr_body_get_state(world.get(), dies, &s) == (respawns ? LR_OK : LR_ERROR_STALE_BODY));
        steps(world, 1, 1.0f / 60.0f, 4);
        CHECK(events_of(world).empty());
    }
}

TEST_CASE("a body that wakes because what it lay on was killed is told to wake in the step that shows it awake") {
    const Asset asset = ball();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 2);
    REQUIRE(lr_batch_set_body_contact(world.get(), batch, batch, 1) == LR_OK);
    lr_batch_rules r = initialised(lr_batch_rules_init);
    r.max_age = 1.0f;
    REQUIRE(lr_batch_set_rules(world.get(), batch, &r) == LR_OK);
    keep_events(world);
    lr_body_desc d = at(0.0f, 0.01f, 0.0f);
    d.age = 0.9f;
    const lr_body below = add_body(world, batch, d);
    d = at(0.0f, 0.03f, 0.0f);
    const lr_body above = add_body(world, batch, d);
    const lr_body both[2] = {below, above};
    REQUIRE(lr_body_set_sleep(world.get(), both, 2, LR_SLEEP_ASLEEP) == LR_OK);
    const std::vector<lr_event> all = step_until(world, LR_EVENT_KILLED, 60, 1.0f / 60.0f, 1);
    REQUIRE(count_of(all, LR_EVENT_KILLED) == 1);
    REQUIRE(view_of(world, batch).awake_count == 1);
    REQUIRE(count_of(all, LR_EVENT_WOKE) == 1);
    CHECK(all.back().body == above);
    steps(world, 1, 1.0f / 60.0f, 1);
    CHECK(count_of(events_of(world), LR_EVENT_WOKE) == 0);
}

namespace {

// Many bodies land, are shaken, and end; `order` changes the bodies' slots.
struct Crowd {
    uint32_t workers = 0;
    int32_t simd = LR_SIMD_AUTO;
    bool reversed = false;
    uint32_t capacity = 100000;
    bool windy = false;
};

std::vector<lr_event> play(const Crowd& crowd, uint64_t* hash = nullptr, uint64_t* lost = nullptr) {
    const Asset asset = leaf();
    lr_world_desc wd = world_desc();
    wd.worker_count = crowd.workers;
    wd.simd_target = crowd.simd;
    const World world = make(wd);
    const lr_batch batches[2] = {add_batch(world, asset, 1500), add_batch(world, asset, 1500)};
    add_collider(world, collider_desc(LR_COLLIDER_PLANE));
    lr_collider_desc box = box_collider(0.3f, 0.1f, 0.3f);
    const lr_collider moving = add_collider(world, box);
    if (crowd.windy) {
        lr_gusts_desc gusts = initialised(lr_gusts_desc_init);
        lr_wind_source source{};
        REQUIRE(lr_world_add_gusts(world.get(), &gusts, &source) == LR_OK);
    }
    if (crowd.capacity != 0) keep_events(world, crowd.capacity);
    lr_batch_rules r = initialised(lr_batch_rules_init);
    r.max_age = 1.2f;
    REQUIRE(lr_batch_set_rules(world.get(), batches[1], &r) == LR_OK);
    for (const lr_batch batch : batches) {
        Random random(batch.id);
        std::vector<lr_body_desc> bodies;
        for (uint32_t i = 0; i < 1200; ++i) {
            bodies.push_back(at(random.real(-2, 2), random.real(0.02, 0.8), random.real(-2, 2)));
            bodies.back().noise_seed = 1000 * batch.id + i + 1;
            bodies.back().age = random.real(0, 0.5);
        }
        if (crowd.reversed) std::reverse(bodies.begin(), bodies.end());
        REQUIRE(lr_body_create(world.get(), batch, bodies.data(), 1200, nullptr) == LR_OK);
    }
    std::vector<lr_event> all;
    for (int i = 0; i < 75; ++i) {
        if (i == 60) {
            lr_collider_motion m = initialised(lr_collider_motion_init);
            m.collider = moving;
            m.position[1] = 0.1f, m.position[0] = 0.5f;
            REQUIRE(lr_collider_move(world.get(), &m, 1) == LR_OK);
        }
        steps(world, 1, 1.0f / 60.0f, 3);
        const std::vector<lr_event> now = events_of(world);
        all.insert(all.end(), now.begin(), now.end());
    }
    if (hash) *hash = hash_of(world);
    if (lost) *lost = event_list(world).total_lost;
    // Slots depend on the order of creation: compare noise seeds.
    for (lr_event& e : all) {
        lr_body_state s = body_state();
        if (crowd.reversed && lr_body_get_state(world.get(), e.body, &s) == LR_OK) e.body = {s.noise_seed};
    }
    return all;
}

bool same(const std::vector<lr_event>& a, const std::vector<lr_event>& b, bool bodies = true) {
    if (a.size() != b.size()) return false;
    for (size_t i = 0; i < a.size(); ++i) {
        lr_event x = a[i], y = b[i];
        if (!bodies) x.body = y.body = {};
        if (std::memcmp(&x, &y, sizeof x) != 0) return false;
    }
    return true;
}

} // namespace

TEST_CASE("the same events in the same order with any workers, instruction sets and orders of bodies" *
          doctest::test_suite("long")) {
    for (const bool windy : {false, true}) {
        CAPTURE(windy);
        uint64_t hash = 0, other = 0;
        const std::vector<lr_event> expected = play({.windy = windy}, &hash);
        for (int32_t kind = LR_EVENT_HIT; kind <= LR_EVENT_KILLED; ++kind) {
            CAPTURE(kind);
            // Gusts keep all bodies awake.
            if (!windy || (kind != LR_EVENT_LANDED && kind != LR_EVENT_WOKE)) CHECK(count_of(expected, kind) > 5);
        }
        CHECK(same(play({.workers = 4, .windy = windy}), expected));
        if (!quick()) {
            for (const uint32_t workers : {1u, 2u}) CHECK(same(play({.workers = workers, .windy = windy}), expected));
            CHECK(same(play({.simd = simd_targets().back(), .windy = windy}), expected));
            CHECK(same(play({.reversed = true, .windy = windy}), expected, false));
        }
        CHECK(same(play({.workers = 3, .simd = simd_targets().back(), .reversed = true, .windy = windy}), expected,
                   false));
        // Keeping events changes no motion.
        play({.capacity = 0, .windy = windy}, &other);
        CHECK(other == hash);
    }
}

TEST_CASE("events without room are counted, and it is the last ones that are lost" * doctest::test_suite("native")) {
    uint64_t lost = 0;
    const std::vector<lr_event> all = play({}), some = play({.capacity = 7}, nullptr, &lost);
    CHECK(some.size() + lost == all.size());
    CHECK(lost > 100);
    const std::vector<lr_event> again = play({.workers = 4, .capacity = 7});
    CHECK(same(some, again));
    size_t at = 0; // each event of the short list is in the full list, in the same order
    for (const lr_event& e : some) {
        while (at < all.size() && std::memcmp(&all[at], &e, sizeof e) != 0) ++at;
        ++at;
    }
    CHECK(at <= all.size());
}

TEST_CASE("only the kinds that are asked for are kept, and none after they are turned off") {
    const Asset asset = ball();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 4);
    add_collider(world, collider_desc(LR_COLLIDER_PLANE));
    keep_events(world, 10, LR_EVENTS_LANDED);
    add_body(world, batch, at(0.0f, 0.011f, 0.0f));
    const std::vector<lr_event> all = step_until(world, LR_EVENT_LANDED, 1000);
    REQUIRE(all.size() == 1);
    CHECK(event_list(world).total_lost == 0);
    keep_events(world, 0, 0);
    const lr_event_list off = event_list(world);
    CHECK((off.count == 0 && off.events == nullptr));
    keep_events(world, 10);
    CHECK(events_of(world).empty());
    steps(world, 3, 0.01f, 2);
    CHECK(events_of(world).empty()); // it already touched
}

TEST_CASE("after a restore there are no events, and contacts that were there do not begin again") {
    const Asset asset = ball();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 4);
    add_collider(world, collider_desc(LR_COLLIDER_PLANE));
    keep_events(world);
    add_body(world, batch, at(0.0f, 0.0101f, 0.0f));
    steps(world, 10, 1.0f / 60.0f, 4);
    std::vector<unsigned char> bytes(lr_world_snapshot_size(world.get()));
    REQUIRE(lr_world_snapshot_save(world.get(), bytes.data(), bytes.size(), nullptr) == LR_OK);
    lr_body_state away = state_of(world, view_of(world, batch).ids[0]);
    away.position[1] = 3.0f;
    REQUIRE(lr_body_set_state(world.get(), view_of(world, batch).ids[0], &away) == LR_OK);
    steps(world, 1, 1.0f / 60.0f, 4);
    CHECK(count_of(events_of(world), LR_EVENT_LIFTED) == 1);
    REQUIRE(lr_world_snapshot_restore(world.get(), bytes.data(), bytes.size()) == LR_OK);
    CHECK(events_of(world).empty());
    steps(world, 1, 1.0f / 60.0f, 4);
    CHECK(events_of(world).empty());
}

TEST_CASE("memory for events is taken when they are asked for, by later batches, and never in a step") {
    CountingAllocator memory;
    lr_world_desc d = world_desc();
    d.allocator = memory.callbacks();
    const Asset asset = leaf();
    {
        const World world = make(d);
        add_batch(world, asset, 100);
        add_collider(world, collider_desc(LR_COLLIDER_PLANE));
        const uint64_t before = memory.bytes;
        keep_events(world, 50);
        CHECK(memory.bytes >= before + 100 * 233 + 50 * 64);
        CHECK(memory.bytes <= before + 100 * 233 + 50 * 64 + 200);
        keep_events(world, 0, 0);
        CHECK(memory.bytes == before);
        // Each allocation fails in turn: nothing changes.
        for (uint64_t n = 0; n < 7; ++n) {
            CAPTURE(n);
            memory.fail_at = memory.calls + n;
            CHECK(lr_world_set_events(world.get(), 50, LR_EVENTS_ALL) == LR_ERROR_OUT_OF_MEMORY);
            memory.fail_at = CountingAllocator::never;
            CHECK(memory.bytes == before);
        }
        keep_events(world, 50);
        const lr_batch later = add_batch(world, asset, 100);
        for (int i = 0; i < 100; ++i) add_body(world, later, at(0.1f * static_cast<float>(i), 0.02f, 0.0f));
        const uint64_t calls = memory.calls;
        size_t told = 0;
        for (int i = 0; i < 60; ++i) {
            steps(world, 1, 1.0f / 60.0f, 2);
            told += event_list(world).count;
        }
        CHECK(told >= 100);
        CHECK(memory.calls == calls);
    }
    CHECK(memory.bytes == 0);
}

TEST_CASE("wrong arguments for events are refused") {
    const World world = make(world_desc());
    CHECK(lr_world_set_events(world.get(), 10, LR_EVENTS_ALL + 1) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(lr_world_set_events(world.get(), 10, 0) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(lr_world_set_events(world.get(), 0, 0) == LR_OK);
    CHECK(lr_world_set_events(nullptr, 10, 1) == LR_ERROR_NULL_ARGUMENT);
}
