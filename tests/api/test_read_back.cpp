// Getters return what setters set: users of bodies, settings. Bounds, timings, and the last error's text.
#include "support/colliders.h"
#include "support/contact_events.h"
#include "support/lifecycle.h"
#include "support/random.h"

#include <cfloat>
#include <cmath>
#include <map>
#include <string>
#include <thread>

using namespace test;

namespace {

struct Bounds {
    float low[3], high[3];
    bool contains(const Bounds& other) const {
        bool all = true;
        for (size_t k = 0; k < 3; ++k) all = all && low[k] <= other.low[k] && high[k] >= other.high[k];
        return all;
    }
    bool operator==(const Bounds& o) const { return std::memcmp(this, &o, sizeof o) == 0; }
};
Bounds bounds_of(const World& world, lr_batch batch) {
    Bounds b{};
    REQUIRE(lr_batch_get_bounds(world.get(), batch, b.low, b.high) == LR_OK);
    return b;
}

// Bounds from the ends of each ellipsoid's axes.
Bounds drawn(const World& world, lr_batch batch, double x, double y, double z) {
    const uint32_t count = view_of(world, batch).count;
    std::vector<float> rows(size_t{12} * count);
    REQUIRE(lr_batch_write_transforms(world.get(), batch, LR_TRANSFORM_3X4_ROW_MAJOR, rows.data(), 0, count, nullptr) ==
            LR_OK);
    const double axes[3] = {x, y, z};
    Bounds b{{FLT_MAX, FLT_MAX, FLT_MAX}, {-FLT_MAX, -FLT_MAX, -FLT_MAX}};
    for (uint32_t i = 0; i < count; ++i)
        for (size_t end = 0; end < 6; ++end)
            for (size_t k = 0; k < 3; ++k) {
                const float* const row = rows.data() + 12 * i + 4 * k;
                const float at = row[3] + row[end / 2] * narrow((end % 2 ? 1.0 : -1.0) * axes[end / 2]);
                b.low[k] = std::min(b.low[k], at);
                b.high[k] = std::max(b.high[k], at);
            }
    return b;
}

std::string last() {
    return lr_last_error();
}

lr_body_desc with_user(uint64_t user, float height = 0.0f) {
    lr_body_desc d = body_desc();
    d.user = user;
    d.position[1] = height;
    return d;
}

} // namespace

TEST_CASE("a turbulence table reads back as it was set, also from a snapshot, and is the asset's by default") {
    const Asset asset = leaf();
    const lr_asset_info info = info_of(asset);
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 4);
    struct Read {
        lr_turbulence_table table;
        std::vector<float> chi, epsilon;
        bool operator==(const Read& o) const {
            return std::memcmp(&table, &o.table, sizeof table) == 0 && chi == o.chi && epsilon == o.epsilon;
        }
    };
    const auto read = [&] {
        Read r{table_desc(), {}, {}};
        REQUIRE(lr_batch_get_turbulence_table(world.get(), batch, &r.table, nullptr, nullptr, 0) == LR_OK);
        r.chi.resize(r.table.count), r.epsilon.resize(r.table.count);
        REQUIRE(lr_batch_get_turbulence_table(world.get(), batch, &r.table, r.chi.data(), nullptr, r.table.count) ==
                LR_OK);
        REQUIRE(lr_batch_get_turbulence_table(world.get(), batch, &r.table, nullptr, r.epsilon.data(), r.table.count) ==
                LR_OK);
        CHECK((!r.table.chi && !r.table.epsilon && r.table.reserved == 0));
        return r;
    };
    const Read own = read();
    CHECK(own.table.count == info.turbulence_count);
    CHECK((own.table.u0 == narrow(info.u0) && own.table.l == narrow(info.length_l) && own.table.c0 == narrow(info.c0)));
    CHECK(own.table.dt == narrow(info.turbulence_dt));
    CHECK(std::all_of(own.chi.begin(), own.chi.end(), [](float x) { return x > 0.0f; }));
    const std::vector<unsigned char> before = snapshot_of(world);

    const float chi[3] = {0.1f, 3e8f, 0.0f}, epsilon[3] = {7.3f, 1e-30f, 9e11f}, other[3] = {0.1f, 3e8f, 1.0f};
    lr_turbulence_table t = table_desc();
    t.count = 3, t.stationary = 2;
    t.chi = chi, t.epsilon = epsilon;
    t.dt = 0.3f, t.u0 = 1.7f, t.l = 0.013f, t.c0 = 2.1f;
    REQUIRE(lr_batch_set_turbulence_table(world.get(), batch, &t) == LR_OK);
    const Read set = read();
    t.chi = t.epsilon = nullptr;
    CHECK(set == Read{t, {chi, chi + 3}, {epsilon, epsilon + 3}});
    const std::vector<unsigned char> after = snapshot_of(world);
    // Another table of the same length, the asset's, and the same one lie before the restores.
    t.chi = other, t.epsilon = epsilon;
    REQUIRE(lr_batch_set_turbulence_table(world.get(), batch, &t) == LR_OK);
    CHECK_FALSE(read() == set);
    for (int i = 0; i < 3; ++i) {
        if (i == 1) REQUIRE(lr_batch_set_turbulence_table(world.get(), batch, nullptr) == LR_OK);
        REQUIRE(lr_world_snapshot_restore(world.get(), after.data(), after.size()) == LR_OK);
        CHECK(read() == set);
        CHECK(snapshot_of(world) == after);
    }
    REQUIRE(lr_batch_set_turbulence_table(world.get(), batch, nullptr) == LR_OK);
    CHECK(read() == own);
    REQUIRE(lr_world_snapshot_restore(world.get(), after.data(), after.size()) == LR_OK);
    REQUIRE(lr_world_snapshot_restore(world.get(), before.data(), before.size()) == LR_OK);
    CHECK(read() == own);
    CHECK(snapshot_of(world) == before);
}

TEST_CASE("a turbulence table is not read into too little room") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 4);
    const uint32_t count = info_of(asset).turbulence_count;
    REQUIRE(count > 1);
    std::vector<float> samples(count, -7.0f);
    const auto get = [&](lr_batch from, lr_turbulence_table* t, float* chi, float* epsilon, uint32_t capacity) {
        return lr_batch_get_turbulence_table(world.get(), from, t, chi, epsilon, capacity);
    };
    lr_turbulence_table t = table_desc();
    CHECK(get(batch, &t, samples.data(), nullptr, count - 1) == LR_ERROR_BUFFER_TOO_SMALL);
    CHECK(t.count == count);
    CHECK(get(batch, &t, nullptr, samples.data(), 0) == LR_ERROR_BUFFER_TOO_SMALL);
    CHECK(std::count(samples.begin(), samples.end(), -7.0f) == count);
    CHECK(get({}, &t, nullptr, nullptr, 0) == LR_ERROR_STALE_BATCH);
    CHECK(get(batch, nullptr, nullptr, nullptr, 0) == LR_ERROR_NULL_ARGUMENT);
    t.struct_size = 8;
    CHECK(get(batch, &t, nullptr, nullptr, 0) == LR_ERROR_STRUCT_SIZE);
    CHECK(t.struct_size == 8);
}

TEST_CASE("a body's user goes with it, wherever it moves in memory, and does not move it") {
    const Asset asset = leaf();
    const World world = make(world_desc()), other = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 300), plain = add_batch(other, asset, 300);
    Random random(3);
    std::map<uint64_t, uint64_t> users;
    std::vector<lr_body> ids;
    for (uint32_t i = 0; i < 200; ++i) {
        const uint64_t user = random.bits();
        ids.push_back(add_body(world, batch, with_user(user, 0.1f * narrow(i))));
        users[ids.back().id] = user;
        add_body(other, plain, with_user(0, 0.1f * narrow(i)));
    }
    const auto check = [&](const World& w) {
        const lr_batch_view view = view_of(w, batch);
        REQUIRE(view.count == users.size());
        bool same = true;
        for (uint32_t i = 0; i < view.count; ++i)
            same = same && view.user[i] == users[view.ids[i].id] && state_of(w, view.ids[i]).user == view.user[i];
        CHECK(same);
    };
    check(world);
    CHECK(view_of(other, plain).user == nullptr);
    CHECK(hash_of(world) == hash_of(other));
    steps(world, 3, 0.01f), steps(other, 3, 0.01f);
    CHECK(hash_of(world) == hash_of(other));
    // Asleep, awake, destroyed, set, forced.
    REQUIRE(lr_body_set_sleep(world.get(), ids.data() + 40, 60, LR_SLEEP_ASLEEP) == LR_OK);
    check(world);
    REQUIRE(lr_body_destroy(world.get(), ids.data() + 30, 30) == LR_OK);
    for (size_t i = 30; i < 60; ++i) users.erase(ids[i].id);
    check(world);
    REQUIRE(lr_body_set_sleep(world.get(), ids.data() + 70, 5, LR_SLEEP_AWAKE) == LR_OK);
    lr_body_state s = state_of(world, ids[80]);
    s.user = users[ids[80].id] = ~uint64_t{0};
    REQUIRE(lr_body_set_state(world.get(), ids[80], &s) == LR_OK);
    lr_body_force push = initialised(lr_body_force_init);
    push.body = ids[90];
    push.mode = LR_FORCE_MODE_VELOCITY;
    push.force[0] = 1.0f;
    REQUIRE(lr_body_add_force(world.get(), &push, 1) == LR_OK);
    check(world);
    // Snapshots hold it.
    const std::vector<unsigned char> saved = snapshot_of(world);
    s.user = 1;
    REQUIRE(lr_body_set_state(world.get(), ids[80], &s) == LR_OK);
    REQUIRE(lr_world_snapshot_restore(world.get(), saved.data(), saved.size()) == LR_OK);
    check(world);
    const std::vector<unsigned char> without = snapshot_of(other);
    REQUIRE(lr_world_snapshot_restore(other.get(), saved.data(), saved.size()) == LR_OK);
    check(other);
    REQUIRE(lr_world_snapshot_restore(other.get(), without.data(), without.size()) == LR_OK);
    CHECK(state_of(other, view_of(other, plain).ids[0]).user == 0);
    // A new body in an old place has none.
    const lr_body fresh = add_body(world, batch, body_desc());
    users[fresh.id] = 0;
    check(world);
}

TEST_CASE("rays and events name the user of a body, respawned bodies keep it, spawned ones have none") {
    const Asset asset = make(ellipsoid(0.1, 0.1, 0.1, 500.0));
    const World world = weightless();
    const lr_batch batch = add_batch(world, asset, 8);
    add_collider(world, collider_desc(LR_COLLIDER_PLANE));
    const lr_body body = add_body(world, batch, with_user(1ull << 40, 2.0f));
    lr_ray ray = initialised(lr_ray_init);
    ray.origin[1] = 5.0f;
    lr_ray_hit hits[2];
    const lr_ray rays[2] = {ray, [&] {
                                lr_ray aside = ray;
                                aside.origin[0] = 3.0f;
                                return aside;
                            }()};
    REQUIRE(lr_world_ray_cast(world.get(), rays, 2, hits) == LR_OK);
    CHECK((hits[0].body == body && hits[0].user == 1ull << 40 && hits[0].collider.id == 0));
    CHECK((hits[1].body.id == 0 && hits[1].user == 0 && hits[1].collider.id != 0));

    keep_events(world);
    lr_emitter_desc emitter = emitter_desc();
    emitter.position[1] = 2.0f;
    emitter.burst_count = 2;
    emitter.burst_interval = 0.05f;
    set_emitter(world, batch, emitter);
    lr_batch_rules rules = rules_desc();
    rules.action = LR_END_RESPAWN;
    rules.max_age = 0.02f;
    set_rules(world, batch, rules);
    const std::vector<lr_body> asked = emit(world, batch, 1);
    CHECK(events_of(world).empty());
    steps(world, 1, 0.05f);
    // It spawned and ended within a step; the burst comes after the rules.
    const std::vector<lr_event> told = events_of(world);
    REQUIRE(told.size() == 5);
    CHECK((told[0].kind == LR_EVENT_RESPAWNED && told[0].body == body && told[0].user == 1ull << 40));
    CHECK((told[1].kind == LR_EVENT_SPAWNED && told[1].body == asked[0] && told[1].user == 0));
    CHECK((told[2].kind == LR_EVENT_RESPAWNED && told[2].body == asked[0]));
    CHECK((told[3].kind == LR_EVENT_SPAWNED && told[4].kind == LR_EVENT_SPAWNED));
    CHECK((told[3].body != asked[0] && told[4].body != told[3].body && told[3].position[1] == 2.0f));
    CHECK(state_of(world, body).user == 1ull << 40);
    const lr_event_list list = event_list(world);
    CHECK((list.capacity == 1000 && list.kinds == LR_EVENTS_ALL));
    const lr_batch_counts counts = counts_of(world, batch);
    CHECK((counts.spawned == 2 && counts.respawned == 2 && counts.total_spawned == 3 && counts.destroyed == 0));
    // Unselected kinds are not listed, nor are bodies created or destroyed by calls.
    keep_events(world, 10, LR_EVENTS_SPAWNED);
    add_body(world, batch, body_desc());
    const lr_body gone = emit(world, batch, 1)[0];
    REQUIRE(lr_body_destroy(world.get(), &gone, 1) == LR_OK);
    steps(world, 1, 0.01f);
    CHECK(events_of(world).empty());
    CHECK((event_list(world).capacity == 10 && event_list(world).kinds == LR_EVENTS_SPAWNED));
}

TEST_CASE("bounds contain the corners of a box of given extents") {
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, make(rigid_box(0.06, 0.03, 0.05, 300.0)), 1);
    add_body(world, batch, body_desc());
    const double corner = 0.5 * std::sqrt(0.06 * 0.06 + 0.03 * 0.03 + 0.05 * 0.05);
    const Bounds box = bounds_of(world, batch);
    for (size_t k = 0; k < 3; ++k) {
        CHECK(wide(box.low[k]) <= -corner);
        CHECK(wide(box.high[k]) >= corner);
        CHECK(wide(box.high[k]) < 1.01 * corner);
    }
}

TEST_CASE("bounds contain all that is drawn, asleep, large, far away or behind, and little more") {
    const Asset asset = make(ellipsoid(0.05, 0.02, 0.01, 700.0));
    for (const uint32_t count : {1u, 15u, 16u, 17u, 500u}) {
        CAPTURE(count);
        const World world = make(world_desc());
        const lr_batch batch = add_batch(world, asset, 600);
        Bounds none = bounds_of(world, batch);
        for (size_t k = 0; k < 3; ++k) CHECK((none.low[k] == FLT_MAX && none.high[k] == -FLT_MAX));
        Random random(count);
        std::vector<lr_body> ids;
        for (uint32_t i = 0; i < count; ++i) {
            lr_body_desc d = strewn(random, 5);
            for (float& x : d.linear_velocity) x = random.real(-9, 9);
            d.scale = random.real(0.5, 2);
            if (i == 7) d.position[2] = -1e9f, d.scale = 1000.0f;
            ids.push_back(add_body(world, batch, d));
        }
        const auto check = [&](double slack) {
            const Bounds box = bounds_of(world, batch), tight = drawn(world, batch, 0.0, 0.0, 0.0);
            CHECK(box.contains(drawn(world, batch, 0.05, 0.02, 0.01)));
            for (size_t k = 0; k < 3; ++k) {
                const double most = slack + 0.11 + (count > 7 ? 60.0 : 0.0) + 1e-5 * std::abs(wide(tight.low[k]));
                CHECK(wide(tight.low[k]) - wide(box.low[k]) < most);
                CHECK(wide(box.high[k]) - wide(tight.high[k]) < most);
            }
        };
        check(0.0);
        steps(world, 2, 0.01f);
        REQUIRE(lr_body_set_sleep(world.get(), ids.data(), count / 2, LR_SLEEP_ASLEEP) == LR_OK);
        check(0.0);
        // One step behind, bodies are drawn at their extrapolated places.
        REQUIRE(lr_batch_set_rate(world.get(), batch, 2) == LR_OK);
        bool waited = false;
        for (int i = 0; i < 2; ++i) {
            steps(world, 1, 0.005f);
            lr_batch_pace pace = initialised(lr_batch_pace_init);
            REQUIRE(lr_batch_get_pace(world.get(), batch, &pace) == LR_OK);
            waited = waited || pace.behind > 0.0;
            check(pace.behind * 30.0);
        }
        CHECK((waited || count == 1));
        // The same again in any order of bodies.
        CHECK(bounds_of(world, batch) == bounds_of(world, batch));
        const std::vector<unsigned char> saved = snapshot_of(world);
        const Bounds before = bounds_of(world, batch);
        REQUIRE(lr_world_snapshot_restore(world.get(), saved.data(), saved.size()) == LR_OK);
        CHECK(bounds_of(world, batch) == before);
        REQUIRE(lr_batch_destroy(world.get(), batch) == LR_OK);
        none = before;
        CHECK(lr_batch_get_bounds(world.get(), batch, none.low, none.high) == LR_ERROR_STALE_BATCH);
        CHECK(none == before);
    }
}

TEST_CASE("timings: each phase that there is takes time, and all together no more than the step") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    const auto read = [&] {
        lr_timings t = initialised(lr_timings_init);
        REQUIRE(lr_world_get_timings(world.get(), &t) == LR_OK);
        const double parts = t.colliders + t.wind + t.motion + t.body_contact + t.wake + t.emit_and_rules + t.events;
        CHECK(parts <= t.total);
        for (double v : {t.colliders, t.wind, t.motion, t.body_contact, t.wake, t.emit_and_rules, t.events})
            CHECK((v >= 0.0 && v < 10.0));
        return t;
    };
    CHECK(read().total == 0.0);
    const lr_batch batch = add_batch(world, asset, 2000), crowd = add_batch(world, asset, 100);
    for (uint32_t i = 0; i < 1000; ++i) add_body(world, batch, with_user(i, 0.01f * narrow(i)));
    steps(world, 1, 0.01f);
    lr_timings t = read();
    CHECK((t.total > 0.0 && t.motion > 0.0 && t.wind == 0.0 && t.body_contact == 0.0 && t.events == 0.0));
    REQUIRE(lr_batch_set_body_contact(world.get(), crowd, crowd, 1) == LR_OK);
    for (uint32_t i = 0; i < 100; ++i) add_body(world, crowd, with_user(i, 0.001f * narrow(i)));
    add_collider(world, collider_desc(LR_COLLIDER_PLANE));
    const lr_gusts_desc gusts = initialised(lr_gusts_desc_init);
    REQUIRE(lr_world_add_gusts(world.get(), &gusts, nullptr) == LR_OK);
    keep_events(world, 10000);
    steps(world, 1, 0.01f);
    t = read();
    CHECK((t.motion > 0.0 && t.wind > 0.0 && t.body_contact > 0.0 && t.events > 0.0 && t.colliders > 0.0));
    CHECK(t.emit_and_rules > 0.0);
}

TEST_CASE("settings are read back as they were set, and as initial values where there are none") {
    const Asset asset = leaf();
    lr_world_desc wd = world_desc();
    wd.gravity[0] = 1.0f;
    const World world = make(wd);
    lr_world* const w = world.get();
    const lr_batch batch = add_batch(world, asset, 4);
    CHECK((info_of(world).gravity[0] == 1.0f && info_of(world).gravity[1] == -9.81f && info_of(world).budget == 0));
    const float up[3] = {0.0f, 3.0f, -0.5f};
    REQUIRE(lr_world_set_gravity(w, up) == LR_OK);
    REQUIRE(lr_world_set_budget(w, 12345) == LR_OK);
    CHECK((std::memcmp(info_of(world).gravity, up, sizeof up) == 0 && info_of(world).budget == 12345));

    int32_t present = -1;
    const auto same = [](const auto& a, const auto& b) { return std::memcmp(&a, &b, sizeof a) == 0; };
    // get(struct) and set(struct or null), between initial values and others.
    const auto check = [&](auto initial, auto other, const auto& get, const auto& set) {
        decltype(initial) got = initial;
        std::memset(static_cast<void*>(&got), 0x5a, sizeof got);
        got.struct_size = sizeof got;
        REQUIRE(get(&got) == LR_OK);
        CHECK((present != 1 && same(got, initial)));
        REQUIRE(set(&other) == LR_OK);
        REQUIRE(get(&got) == LR_OK);
        CHECK((present != 0 && same(got, other)));
        REQUIRE(set(nullptr) == LR_OK);
        REQUIRE(get(&got) == LR_OK);
        CHECK((present != 1 && same(got, initial)));
    };
    lr_water_desc water = initialised(lr_water_desc_init);
    water.density = 1025.0f, water.normal[1] = 2.0f, water.wave_count = 1;
    water.waves[0] = {{1.0f, 0.0f, 0.0f}, 3.0f, 0.1f, 0.5f};
    check(
        initialised(lr_water_desc_init), water, [&](lr_water_desc* d) { return lr_world_get_water(w, d, &present); },
        [&](const lr_water_desc* d) { return lr_world_set_water(w, d); });
    lr_emitter_desc emitter = emitter_desc();
    emitter.rate = 3.5f, emitter.shape = LR_EMIT_SPHERE, emitter.size[2] = 0.25f;
    check(
        emitter_desc(), emitter, [&](lr_emitter_desc* d) { return lr_batch_get_emitter(w, batch, d, &present); },
        [&](const lr_emitter_desc* d) { return lr_batch_set_emitter(w, batch, d); });
    lr_batch_rules rules = rules_with({LR_VOLUME_SPHERE, LR_KILL_OUTSIDE, {1.0f, 2.0f, 3.0f}, {4.0f, 0.0f, 0.0f}});
    rules.max_age = 7.0f;
    check(
        rules_desc(), rules, [&](lr_batch_rules* d) { return lr_batch_get_rules(w, batch, d, &present); },
        [&](const lr_batch_rules* d) { return lr_batch_set_rules(w, batch, d); });
    // These always exist.
    present = -1;
    lr_load_gains gains = initialised(lr_load_gains_init);
    gains.drag = 0.1f, gains.lift = 2.0f, gains.spin_drag = 0.0f, gains.turbulence = 33.3f;
    check(
        initialised(lr_load_gains_init), gains, [&](lr_load_gains* g) { return lr_batch_get_load_gains(w, batch, g); },
        [&](const lr_load_gains* g) { return lr_batch_set_load_gains(w, batch, g); });
    lr_batch_force force = initialised(lr_batch_force_init);
    float* const components = force.force;
    for (size_t i = 0; i < 24; ++i) components[i] = 1e-6f * static_cast<float>(i + 1);
    check(
        initialised(lr_batch_force_init), force, [&](lr_batch_force* f) { return lr_batch_get_force(w, batch, f); },
        [&](const lr_batch_force* f) { return lr_batch_set_force(w, batch, f); });
    // Stale batches.
    REQUIRE(lr_batch_destroy(w, batch) == LR_OK);
    CHECK(lr_batch_get_emitter(w, batch, &emitter, &present) == LR_ERROR_STALE_BATCH);
    CHECK(lr_batch_get_rules(w, batch, &rules, &present) == LR_ERROR_STALE_BATCH);
    CHECK(lr_batch_get_load_gains(w, batch, &gains) == LR_ERROR_STALE_BATCH);
    CHECK(lr_batch_get_force(w, batch, &force) == LR_ERROR_STALE_BATCH);
    CHECK((present == -1 && gains.drag == 0.1f && emitter.rate == 3.5f));
}

TEST_CASE("the last failed call of a thread says what and why, with a world and without") {
    std::string fresh = "?";
    std::thread([&] { fresh = last(); }).join();
    CHECK(fresh.empty());

    std::string logged;
    lr_world_desc wd = world_desc();
    wd.log = [](void* to, int32_t, const char* message) { *static_cast<std::string*>(to) = message; };
    wd.log_user = &logged;
    const World world = make(wd);
    CHECK(lr_world_step(world.get(), -1.0f, 1) == LR_ERROR_TIMESTEP_NEGATIVE);
    CHECK(last() == "lr_world_step: dt is negative");
    CHECK(last() == logged);
    // Success does not change it, and other threads have their own.
    CHECK(lr_world_step(world.get(), 0.01f, 1) == LR_OK);
    std::thread([&] {
        CHECK(last().empty());
        CHECK(lr_batch_destroy(world.get(), {12}) == LR_ERROR_STALE_BATCH);
        CHECK(last() == "lr_batch_destroy: the batch was destroyed, or never existed");
    }).join();
    CHECK(last() == "lr_world_step: dt is negative");

    CHECK(lr_world_step(nullptr, 0.01f, 1) == LR_ERROR_NULL_ARGUMENT);
    CHECK(last() == "lr_world_step: world is null");
    CHECK(lr_world_get_info(nullptr, nullptr) == LR_ERROR_NULL_ARGUMENT);
    CHECK(last() == "lr_world_get_info: world is null");
    CHECK(lr_world_snapshot_size(nullptr) == 0);
    CHECK(last() == "lr_world_snapshot_size: world is null");
    lr_world* none = nullptr;
    wd.worker_count = 65;
    CHECK(lr_world_create(&wd, &none) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(last() == "lr_world_create: worker_count is over 64");
    CHECK(lr_world_create(nullptr, &none) == LR_ERROR_NULL_ARGUMENT);
    CHECK(last().find("lr_world_create: ") == 0);
    CHECK(lr_timings_init(nullptr, 8) == LR_ERROR_NULL_ARGUMENT);
    CHECK(last().find("lr_timings_init: ") == 0);
    lr_asset* asset = nullptr;
    CHECK(lr_asset_load_file("/nowhere/leaf.lrb", &asset) == LR_ERROR_FILE_NOT_FOUND);
    CHECK(last() == "lr_asset_load_file: no file at that path");
    CHECK(lr_asset_load_memory("x", 1, &asset) == LR_ERROR_ASSET_FORMAT);
    CHECK(last().find("lr_asset_load_memory: ") == 0);
    CHECK(last().size() > 25);
    const lr_ellipsoid_desc flat = ellipsoid(0.0, 1.0, 1.0, 500.0);
    CHECK(lr_asset_create_ellipsoid(&flat, &asset) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(last().find("lr_asset_create_ellipsoid: ") == 0);
    CHECK(lr_asset_retain(nullptr) == LR_ERROR_NULL_ARGUMENT);
    CHECK(last().find("lr_asset_retain: ") == 0);
    CHECK(lr_asset_get_info(nullptr, nullptr) == LR_ERROR_NULL_ARGUMENT);
    CHECK(last().find("lr_asset_get_info: ") == 0);
    CHECK(lr_asset_check_memory(nullptr, 0, nullptr, nullptr) == LR_ERROR_NULL_ARGUMENT);
    CHECK(last().find("lr_asset_check_memory: ") == 0);
    CHECK(lr_simd_targets(nullptr, 0, nullptr) == LR_ERROR_NULL_ARGUMENT);
    CHECK(last().find("lr_simd_targets: ") == 0);
}
