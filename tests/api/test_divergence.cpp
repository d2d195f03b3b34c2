// Diverged bodies: docs/reference/bodies.md.
#include "support/contact_events.h"
#include "support/counting_memory.h"
#include "support/lifecycle.h"
#include "support/reseal_snapshot.h"
#include "support/water.h"
#include "support/wind.h"

#include <cmath>
#include <limits>
#include <string>

using namespace test;

namespace {

constexpr float step_time = 1.0f / 60.0f;

lr_batch_desc free_fall() {
    lr_batch_desc d = batch_desc();
    d.load_model = LR_LOADS_NONE; // no drag
    return d;
}
std::vector<lr_body> some_bodies(const World& world, lr_batch batch, uint32_t count, float apart = 1.0f) {
    std::vector<lr_body> ids;
    for (uint32_t i = 0; i < count; ++i) {
        Random random(i);
        ids.push_back(
            add_body(world, batch, turned_anyhow(random, {wide(apart) * (i % 100), 2.0, wide(apart) * (i / 100)})));
    }
    return ids;
}
// 1e30 m/s over a step of 1/60 s, minus drag; a single force is limited to less.
void carry_off(const World& world, lr_body body) {
    lr_body_force f = initialised(lr_body_force_init);
    f.body = body;
    f.mode = LR_FORCE_MODE_ACCELERATION;
    f.force[0] = 1e9f, f.torque[1] = 1e9f;
    const std::vector<lr_body_force> all(200, f);
    REQUIRE(lr_body_add_force(world.get(), all.data(), 200) == LR_OK);
}
struct Log {
    std::vector<std::string> lines;
    static void write(void* user, int32_t level, const char* text) {
        if (level == LR_LOG_WARNING) static_cast<Log*>(user)->lines.emplace_back(text);
    }
};
bool same_place(const lr_body_state& a, const lr_body_state& b) {
    return std::memcmp(a.position, b.position, sizeof a.position) == 0 &&
           std::memcmp(a.orientation, b.orientation, sizeof a.orientation) == 0;
}
bool still(const lr_body_state& s) {
    float sum = 0.0f;
    for (size_t k = 0; k < 3; ++k) sum += std::abs(s.linear_velocity[k]) + std::abs(s.angular_velocity[k]);
    return sum == 0.0f;
}

} // namespace

TEST_CASE("one of 10,000 bodies leaves physics: it is held, told of once, and the others have the bits that they had") {
    const Asset asset = leaf();
    Log log;
    lr_world_desc wd = world_desc();
    wd.log = Log::write, wd.log_user = &log;
    const World worlds[] = {make(wd), make(world_desc())}; // the second has no faults
    std::vector<lr_body> ids[2];
    lr_batch batches[2];
    for (size_t w = 0; w < 2; ++w) {
        batches[w] = add_batch(worlds[w], free_fall(), asset, 10000);
        ids[w] = some_bodies(worlds[w], batches[w], 10000);
        keep_events(worlds[w]);
        steps(worlds[w], 3, step_time, 2);
    }
    constexpr size_t mad = 4711;
    const lr_body_state before = state_of(worlds[0], ids[0][mad]);
    carry_off(worlds[0], ids[0][mad]);
    for (int frame = 0; frame < 5; ++frame) {
        for (const World& world : worlds) steps(world, 1, step_time, 2);
        const std::vector<lr_event> told = events_of(worlds[0]);
        const lr_batch_counts counts = counts_of(worlds[0], batches[0]);
        CHECK(told.size() == (frame == 0 ? 1 : 0));
        CHECK(counts.diverged == (frame == 0 ? 1 : 0));
        CHECK(counts.total_diverged == 1);
        if (frame == 0) {
            CHECK((told[0].kind == LR_EVENT_DIVERGED && told[0].body == ids[0][mad] && told[0].batch == batches[0]));
            CHECK(std::memcmp(told[0].position, before.position, sizeof before.position) == 0);
            CHECK((counts.destroyed == 0 && counts.by_divergence == 0));
        }
        const lr_body_state held = state_of(worlds[0], ids[0][mad]);
        CHECK(held.sleep_state == LR_SLEEP_HELD);
        CHECK((same_place(held, before) && still(held)));
        CHECK(wide(held.age) ==
              doctest::Approx(wide(before.age + step_time * static_cast<float>(frame + 1))).epsilon(1e-5));
        bool same = true;
        for (size_t i = 0; i < 10000; ++i)
            same = same && (i == mad || same_bits(state_of(worlds[0], ids[0][i]), state_of(worlds[1], ids[1][i])));
        CHECK(same);
    }
    REQUIRE(log.lines.size() == 1);
    CHECK(log.lines[0] ==
          "lr_world_step: 1 body diverged; the first has noise seed 4712 in batch " + std::to_string(batches[0].id));
    CHECK(counts_of(worlds[1], batches[1]).total_diverged == 0);

    // Forces and changes of velocity have no effect on it; lr_body_set_state frees it.
    carry_off(worlds[0], ids[0][mad]);
    lr_body_force kick = initialised(lr_body_force_init);
    kick.body = ids[0][mad], kick.mode = LR_FORCE_MODE_VELOCITY, kick.force[1] = 1.0f;
    REQUIRE(lr_body_add_force(worlds[0].get(), &kick, 1) == LR_OK);
    steps(worlds[0], 1, step_time, 2);
    lr_body_state s = state_of(worlds[0], ids[0][mad]);
    CHECK((s.sleep_state == LR_SLEEP_HELD && same_place(s, before) && still(s)));
    REQUIRE(lr_body_set_state(worlds[0].get(), ids[0][mad], &s) == LR_OK);
    CHECK(state_of(worlds[0], ids[0][mad]).sleep_state == LR_SLEEP_AWAKE);
    steps(worlds[0], 2, step_time, 2);
    CHECK(state_of(worlds[0], ids[0][mad]).position[1] < before.position[1]);
    CHECK(counts_of(worlds[0], batches[0]).total_diverged == 1);
    CHECK(log.lines.size() == 1);
}

TEST_CASE("the batch's policy decides about diverged bodies") {
    const Asset asset = leaf();
    struct Case {
        int32_t policy;
        int rules;        // 0: none, 1: destroy, 2: respawn
        int32_t expected; // 0: held, 1: destroyed, 2: respawned
    };
    for (const Case& c :
         {Case{LR_DIVERGENCE_AUTO, 0, 0}, Case{LR_DIVERGENCE_AUTO, 1, 1}, Case{LR_DIVERGENCE_AUTO, 2, 2},
          Case{LR_DIVERGENCE_FREEZE, 0, 0}, Case{LR_DIVERGENCE_FREEZE, 1, 0}, Case{LR_DIVERGENCE_FREEZE, 2, 0},
          Case{LR_DIVERGENCE_REMOVE, 0, 1}, Case{LR_DIVERGENCE_REMOVE, 1, 1}, Case{LR_DIVERGENCE_REMOVE, 2, 2}}) {
        CAPTURE(c.policy);
        CAPTURE(c.rules);
        for (uint32_t count : {1u, 600u}) {
            const World world = make(world_desc());
            const lr_batch batch = add_batch(world, free_fall(), asset, 600);
            const std::vector<lr_body> ids = some_bodies(world, batch, count);
            keep_events(world);
            if (c.rules == 2) set_emitter(world, batch, emitter_desc());
            if (c.rules != 0) {
                lr_batch_rules r = rules_desc();
                r.action = c.rules == 2 ? LR_END_RESPAWN : LR_END_DESTROY;
                r.max_age = 1e6f;
                set_rules(world, batch, r);
            }
            if (c.policy != LR_DIVERGENCE_AUTO)
                REQUIRE(lr_batch_set_divergence_policy(world.get(), batch, c.policy) == LR_OK);
            const uint32_t mad = count / 2;
            for (int round = 0; round < 2 && mad + static_cast<uint32_t>(round) < count; ++round) {
                const lr_body body = ids[mad + static_cast<uint32_t>(round)];
                carry_off(world, body);
                steps(world, 1, step_time);
                const std::vector<lr_event> told = events_of(world);
                const lr_batch_counts e = counts_of(world, batch);
                CHECK(count_of(told, LR_EVENT_DIVERGED) == 1);
                CHECK(count_of(told, LR_EVENT_KILLED) == (c.expected == 1 ? 1 : 0));
                CHECK(count_of(told, LR_EVENT_RESPAWNED) == (c.expected == 2 ? 1 : 0));
                CHECK(told.size() == (c.expected == 0 ? 1 : 2));
                CHECK((told.back().kind == LR_EVENT_DIVERGED && told.back().body == body));
                CHECK(e.diverged == 1);
                CHECK(e.by_divergence == (c.expected == 0 ? 0 : 1));
                CHECK(e.destroyed == (c.expected == 1 ? 1 : 0));
                CHECK(e.respawned == (c.expected == 2 ? 1 : 0));
                CHECK(told.front().body == body);
                lr_body_state s = body_state();
                const lr_status there = lr_body_get_state(world.get(), body, &s);
                CHECK(there == (c.expected == 1 ? LR_ERROR_STALE_BODY : LR_OK));
                if (c.expected != 1) CHECK(s.sleep_state == (c.expected == 0 ? LR_SLEEP_HELD : LR_SLEEP_AWAKE));
                if (c.expected == 2) CHECK((s.age == 0.0f && s.position[1] == 0.0f));
            }
            steps(world, 1, step_time);
            CHECK(events_of(world).empty());
            CHECK(counts_of(world, batch).diverged == 0);
        }
    }
}

TEST_CASE("rules end a body that is held, and it ends only once where both are true in one step") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, free_fall(), asset, 10);
    const std::vector<lr_body> ids = some_bodies(world, batch, 3);
    keep_events(world);
    REQUIRE(lr_batch_set_divergence_policy(world.get(), batch, LR_DIVERGENCE_FREEZE) == LR_OK);
    lr_batch_rules r = rules_desc();
    r.max_age = 0.11f;
    set_rules(world, batch, r);
    carry_off(world, ids[0]);
    steps(world, 1, 0.05f);
    CHECK(state_of(world, ids[0]).sleep_state == LR_SLEEP_HELD);
    steps(world, 1, 0.05f);
    carry_off(world, ids[1]);
    steps(world, 1, 0.05f);
    CHECK(view_of(world, batch).count == 0);
    CHECK(count_of(events_of(world), LR_EVENT_KILLED) == 3);
    CHECK(count_of(events_of(world), LR_EVENT_DIVERGED) == 1);
    const lr_batch_counts e = counts_of(world, batch);
    CHECK((e.by_age == 2 && e.by_divergence == 1 && e.destroyed == 3 && e.total_diverged == 2));
}

TEST_CASE("in wind, in water, over colliders, beside others and at other rates as in the open") {
    const Asset asset = brick();
    struct Place {
        const char* name;
        bool wind, water, ground, pairs;
        uint32_t divisor;
    };
    for (const Place& place :
         {Place{"open", false, false, false, false, 1}, Place{"field", true, false, false, false, 1},
          Place{"water", false, true, false, false, 1}, Place{"wet field", true, true, false, false, 1},
          Place{"ground", false, false, true, false, 1}, Place{"windy ground", true, false, true, false, 1},
          Place{"wet ground", false, true, true, false, 1}, Place{"pairs", false, false, false, true, 1},
          Place{"everything", true, true, true, true, 1}, Place{"waiting", false, false, false, false, 4}})
        for (bool full : {false, true}) {
            CAPTURE(std::string(place.name));
            CAPTURE(full);
            World worlds[2];
            std::vector<lr_body> ids[2];
            lr_batch batch{};
            for (size_t w = 0; w < 2; ++w) {
                worlds[w] = make(world_desc());
                lr_batch_desc d = free_fall();
                batch = add_batch(worlds[w], d, asset, 70, full);
                ids[w] = some_bodies(worlds[w], batch, 70, 0.5f);
                if (place.wind) {
                    lr_turbulence_desc s = initialised(lr_turbulence_desc_init);
                    add_source(worlds[w], s);
                }
                if (place.water) {
                    lr_water_desc s = initialised(lr_water_desc_init);
                    s.position[1] = 2.0f;
                    REQUIRE(lr_world_set_water(worlds[w].get(), &s) == LR_OK);
                }
                if (place.ground) {
                    lr_collider_desc s = collider_desc(LR_COLLIDER_PLANE);
                    s.position[1] = 1.97f;
                    add_collider(worlds[w], s);
                }
                if (place.pairs) REQUIRE(lr_batch_set_body_contact(worlds[w].get(), batch, batch, 1) == LR_OK);
                REQUIRE(lr_batch_set_rate(worlds[w].get(), batch, place.divisor) == LR_OK);
                keep_events(worlds[w], 4000);
                steps(worlds[w], 5, step_time, 2);
            }
            const lr_body_state before = state_of(worlds[0], ids[0][33]);
            carry_off(worlds[0], ids[0][33]);
            if (place.divisor != 1) { // the force ends its batch's wait
                lr_body_force nudge = initialised(lr_body_force_init);
                nudge.body = ids[1][2], nudge.force[0] = 1e-30f;
                REQUIRE(lr_body_add_force(worlds[1].get(), &nudge, 1) == LR_OK);
            }
            size_t told = 0;
            for (int frame = 0; frame < 8; ++frame) {
                for (const World& world : worlds) steps(world, 1, step_time, 2);
                told += count_of(events_of(worlds[0]), LR_EVENT_DIVERGED);
                CHECK(counts_of(worlds[0], batch).diverged == (frame == 0 ? 1 : 0));
            }
            CHECK(told == 1);
            const lr_body_state held = state_of(worlds[0], ids[0][33]);
            CHECK((held.sleep_state == LR_SLEEP_HELD && still(held)));
            CHECK(same_place(held, before));
            bool same = true;
            for (size_t i = 0; i < 70; ++i)
                same = same && (i == 33 || same_bits(state_of(worlds[0], ids[0][i]), state_of(worlds[1], ids[1][i])));
            CHECK(same);
        }
}

TEST_CASE("a collider or another body that throws one out of the world makes a fault of it alone") {
    const Asset asset = brick();
    for (bool pairs : {false, true}) {
        CAPTURE(pairs);
        const World world = make(world_desc());
        const lr_batch batch = add_batch(world, free_fall(), asset, 10);
        lr_batch_contact c = initialised(lr_batch_contact_init);
        c.restitution = 1.0f, c.friction = 0.0f;
        REQUIRE(lr_batch_set_contact(world.get(), batch, &c) == LR_OK);
        lr_body_desc d = body_desc();
        d.scale = 0.1f;
        const lr_body hit = add_body(world, batch, d);
        d.position[0] = 50.0f, d.scale = 1.0f;
        const lr_body other = add_body(world, batch, d);
        keep_events(world);
        if (pairs) {
            REQUIRE(lr_batch_set_body_contact(world.get(), batch, batch, 1) == LR_OK);
            d.position[0] = -0.06f, d.scale = 1.5f;
            d.linear_velocity[0] = 1e6f;
            add_body(world, batch, d);
            lr_body_state s = state_of(world, hit);
            s.linear_velocity[0] = -1e6f;
            REQUIRE(lr_body_set_state(world.get(), hit, &s) == LR_OK);
        } else {
            lr_collider_desc wall = box_collider(1.0f, 10.0f, 10.0f);
            wall.position[0] = -1.05f;
            wall.linear_velocity[0] = 1e6f;
            wall.restitution = 1.0f, wall.friction = 0.0f;
            add_collider(world, wall);
            lr_body_state s = state_of(world, hit);
            s.linear_velocity[0] = -1e6f;
            REQUIRE(lr_body_set_state(world.get(), hit, &s) == LR_OK);
        }
        steps(world, 1, 1e-7f);
        const lr_body_state s = state_of(world, hit);
        CHECK(s.sleep_state == LR_SLEEP_HELD);
        CHECK(still(s));
        CHECK(s.position[0] == 0.0f);
        CHECK(count_of(events_of(world), LR_EVENT_DIVERGED) == 1);
        CHECK(state_of(world, other).sleep_state == LR_SLEEP_AWAKE);
    }
}

TEST_CASE("a body at rest that a force throws out of the world is held, and what lay on a collider lets go of it") {
    const Asset asset = brick();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, free_fall(), asset, 10);
    add_collider(world, collider_desc(LR_COLLIDER_PLANE));
    lr_body_desc d = body_desc();
    d.position[1] = 0.016f;
    const lr_body body = add_body(world, batch, d);
    keep_events(world);
    const std::vector<lr_event> landed = step_until(world, LR_EVENT_LANDED, 600, step_time, 2);
    REQUIRE(count_of(landed, LR_EVENT_LANDED) == 1);
    const lr_body_state before = state_of(world, body);
    REQUIRE(before.sleep_state == LR_SLEEP_ASLEEP);
    carry_off(world, body);
    steps(world, 1, step_time, 2);
    std::vector<lr_event> told = events_of(world);
    CHECK(count_of(told, LR_EVENT_LIFTED) == 1);
    CHECK(count_of(told, LR_EVENT_WOKE) == 1);
    CHECK(count_of(told, LR_EVENT_DIVERGED) == 1);
    CHECK(told.back().kind == LR_EVENT_DIVERGED);
    CHECK(state_of(world, body).sleep_state == LR_SLEEP_HELD);
    CHECK(same_place(state_of(world, body), before));
    steps(world, 90, step_time, 2); // it neither lands nor falls
    CHECK(state_of(world, body).sleep_state == LR_SLEEP_HELD);
    REQUIRE(lr_body_set_sleep(world.get(), &body, 1, LR_SLEEP_ASLEEP) == LR_OK);
    CHECK(state_of(world, body).sleep_state == LR_SLEEP_ASLEEP);
    CHECK(wide(state_of(world, body).age) > 1.5);
    REQUIRE(lr_body_set_sleep(world.get(), &body, 1, LR_SLEEP_AWAKE) == LR_OK);
    CHECK(state_of(world, body).sleep_state == LR_SLEEP_AWAKE);
}

TEST_CASE("policy, totals and bodies that are held go through snapshots and are in the hash, a step takes no memory "
          "for them") {
    const Asset asset = leaf();
    lr_batch real{}; // the same handle in all of them
    const auto fresh = [&] {
        World made = make(world_desc());
        real = add_batch(made, free_fall(), asset, 100);
        return made;
    };
    const World world = fresh();
    const std::vector<lr_body> ids = some_bodies(world, real, 100);
    const uint64_t plain = hash_of(world);
    REQUIRE(lr_batch_set_divergence_policy(world.get(), real, LR_DIVERGENCE_REMOVE) == LR_OK);
    CHECK(hash_of(world) != plain);
    REQUIRE(lr_batch_set_divergence_policy(world.get(), real, LR_DIVERGENCE_FREEZE) == LR_OK);
    carry_off(world, ids[7]), carry_off(world, ids[50]);
    const uint64_t memory = info_of(world).memory_bytes;
    steps(world, 1, step_time, 2);
    CHECK(info_of(world).memory_bytes == memory);
    REQUIRE(lr_batch_set_divergence_policy(world.get(), real, LR_DIVERGENCE_REMOVE) == LR_OK);
    std::vector<unsigned char> bytes = snapshot_of(world);

    const World other = fresh();
    REQUIRE(lr_world_snapshot_restore(other.get(), bytes.data(), bytes.size()) == LR_OK);
    int32_t policy = -1;
    REQUIRE(lr_batch_get_divergence_policy(other.get(), real, &policy) == LR_OK);
    CHECK(policy == LR_DIVERGENCE_REMOVE);
    CHECK(counts_of(other, real).total_diverged == 2);
    CHECK(counts_of(other, real).diverged == 0);
    CHECK(state_of(other, ids[7]).sleep_state == LR_SLEEP_HELD);
    for (const World* w : {&world, &other}) {
        carry_off(*w, ids[8]);
        steps(*w, 3, step_time, 2);
        CHECK(view_of(*w, real).count == 99);
        CHECK(counts_of(*w, real).total_diverged == 3);
    }
    CHECK(hash_of(world) == hash_of(other));
    // A world without diverged bodies restores to none.
    const std::vector<unsigned char> empty = snapshot_of(fresh());
    REQUIRE(lr_world_snapshot_restore(other.get(), empty.data(), empty.size()) == LR_OK);
    REQUIRE(lr_batch_get_divergence_policy(other.get(), real, &policy) == LR_OK);
    CHECK(policy == LR_DIVERGENCE_AUTO);
    CHECK(counts_of(other, real).total_diverged == 0);

    // Damages a float of a snapshot outside the bodies: restoring refuses it, or the next step survives it.
    const lr_body_state first = state_of(world, ids[0]);
    bytes = snapshot_of(world);
    size_t found = 0;
    for (size_t at = 0; at + 4 <= bytes.size(); at += 4) {
        float value;
        std::memcpy(&value, bytes.data() + at, 4);
        if (std::memcmp(&value, &first.position[1], 4) != 0) continue;
        ++found;
        for (float bad : {std::nanf(""), std::numeric_limits<float>::infinity(), 1.1e10f, -3e38f}) {
            std::vector<unsigned char> damaged = bytes;
            std::memcpy(damaged.data() + at, &bad, 4);
            seal(damaged);
            CHECK(lr_world_snapshot_restore(other.get(), damaged.data(), damaged.size()) == LR_ERROR_SNAPSHOT_FORMAT);
        }
    }
    CHECK(found > 0);
}

TEST_CASE("impulses that add up to more than any body has are a fault at once, told of by the next step, also through "
          "a snapshot") {
    const Asset asset = leaf();
    lr_batch batch{};
    const auto fresh = [&] {
        World made = make(world_desc());
        batch = add_batch(made, free_fall(), asset, 10);
        keep_events(made);
        return made;
    };
    const World world = fresh(), other = fresh();
    const std::vector<lr_body> ids = some_bodies(world, batch, 3);
    const lr_body_state before = state_of(world, ids[1]);
    lr_body_force kick = initialised(lr_body_force_init);
    kick.body = ids[1], kick.mode = LR_FORCE_MODE_VELOCITY, kick.force[2] = 0.9e6f;
    for (int n = 0; n < 5; ++n) {
        REQUIRE(lr_body_add_force(world.get(), &kick, 1) == LR_OK);
        const lr_body_state s = state_of(world, ids[1]);
        CHECK(s.sleep_state == (n < 2 ? LR_SLEEP_AWAKE : LR_SLEEP_HELD));
        CHECK((n < 2 ? s.linear_velocity[2] > 0.8e6f : still(s)));
        CHECK(same_place(s, before));
    }
    const std::vector<unsigned char> bytes = snapshot_of(world);
    REQUIRE(lr_world_snapshot_restore(other.get(), bytes.data(), bytes.size()) == LR_OK);
    for (const World* w : {&world, &other}) {
        CHECK(events_of(*w).empty());
        for (int frame = 0; frame < 2; ++frame) {
            steps(*w, 1, step_time);
            CHECK(count_of(events_of(*w), LR_EVENT_DIVERGED) == (frame == 0 ? 1 : 0));
        }
        CHECK(same_place(state_of(*w, ids[1]), before));
        CHECK(counts_of(*w, batch).total_diverged == 1);
    }
    CHECK(hash_of(world) == hash_of(other));
}

TEST_CASE("bodies that meet others go through one that is held") {
    const Asset asset = brick();
    lr_body_state states[2];
    for (size_t w = 0; w < 2; ++w) {
        const World world = make(world_desc());
        const lr_batch batch = add_batch(world, free_fall(), asset, 10);
        REQUIRE(lr_batch_set_body_contact(world.get(), batch, batch, 1) == LR_OK);
        lr_body_desc d = body_desc();
        d.noise_seed = 7, d.position[1] = 0.2f;
        const lr_body falling = add_body(world, batch, d);
        if (w == 1) {
            d.noise_seed = 8, d.position[1] = 0.0f;
            const lr_body held = add_body(world, batch, d);
            carry_off(world, held);
            steps(world, 1, step_time, 2);
            REQUIRE(state_of(world, held).sleep_state == LR_SLEEP_HELD);
        } else {
            steps(world, 1, step_time, 2);
        }
        steps(world, 30, step_time, 2);
        states[w] = state_of(world, falling);
    }
    CHECK(states[0].position[1] < -0.2f);
    CHECK(same_bits(states[0], states[1]));
}

TEST_CASE("policies: what is refused") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 10);
    int32_t policy = -1;
    REQUIRE(lr_batch_get_divergence_policy(world.get(), batch, &policy) == LR_OK);
    CHECK(policy == LR_DIVERGENCE_AUTO);
    CHECK(lr_batch_set_divergence_policy(nullptr, batch, 0) == LR_ERROR_NULL_ARGUMENT);
    CHECK(lr_batch_get_divergence_policy(nullptr, batch, &policy) == LR_ERROR_NULL_ARGUMENT);
    CHECK(lr_batch_get_divergence_policy(world.get(), batch, nullptr) == LR_ERROR_NULL_ARGUMENT);
    for (lr_batch stale : {lr_batch{0}, lr_batch{batch.id + 1}, lr_batch{~0u}}) {
        CHECK(lr_batch_set_divergence_policy(world.get(), stale, 0) == LR_ERROR_STALE_BATCH);
        CHECK(lr_batch_get_divergence_policy(world.get(), stale, &policy) == LR_ERROR_STALE_BATCH);
    }
    for (int32_t bad : {-1, 3, 1 << 30}) {
        CHECK(lr_batch_set_divergence_policy(world.get(), batch, bad) == LR_ERROR_INVALID_ARGUMENT);
        REQUIRE(lr_batch_get_divergence_policy(world.get(), batch, &policy) == LR_OK);
        CHECK(policy == LR_DIVERGENCE_AUTO);
    }
    CHECK(lr_world_set_events(world.get(), 10, 256u) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(lr_world_set_events(world.get(), 10, LR_EVENTS_DIVERGED) == LR_OK);
    CHECK(LR_EVENTS_ALL == 255u);
}

TEST_CASE("a scheme that blows up by itself leaves every body where the header says") {
    const Asset asset = leaf();
    for (int32_t loads : {LR_LOADS_NONE, LR_LOADS_LANGEVIN, LR_LOADS_AERODYNAMIC})
        for (bool full : {false, true}) {
            const World world = make(world_desc());
            lr_batch_desc d = batch_desc();
            d.load_model = loads, d.integrator = LR_INTEGRATOR_RK4;
            const lr_batch batch = add_batch(world, d, asset, 200, full);
            some_bodies(world, batch, 200);
            set_wind(world, 500.0f, 0.0f, 0.0f);
            uint64_t faults = 0;
            for (int frame = 0; frame < 40; ++frame) {
                steps(world, 1, 1.0f);
                faults += counts_of(world, batch).diverged;
            }
            CAPTURE(loads);
            CHECK(counts_of(world, batch).total_diverged == faults);
            const lr_batch_view v = view_of(world, batch);
            const std::vector<Velocity> u = velocities_of(world, batch);
            REQUIRE(v.count == 200);
            bool sane = true;
            for (uint32_t i = 0; i < v.count; ++i)
                for (size_t k = 0; k < 3; ++k)
                    sane = sane && std::abs(v.position[k][i]) <= 1e10f && std::abs(u[i].linear[k]) <= 2e6f &&
                           std::abs(u[i].angular[k]) <= 1e9f;
            CHECK(sane);
            if (loads != LR_LOADS_NONE) CHECK(faults > 0);
        }
}
