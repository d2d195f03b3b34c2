// Sleeping bodies: they stay, cost nothing, age, end by rules, and wake when a call acts on them.
#include "support/body_contact.h"
#include "support/lifecycle.h"
#include "support/random.h"
#include "support/water.h"
#include "support/wind.h"

#include <algorithm>
#include <cmath>
#include <set>

using namespace test;

namespace {

lr_body_desc placed(uint32_t noise_seed, double extent = 2.0) {
    Random random(noise_seed);
    lr_body_desc d = strewn(random, extent);
    d.noise_seed = noise_seed;
    for (float& v : d.linear_velocity) v = random.real(-1.0, 1.0);
    d.scale = random.real(0.5, 2.0);
    return d;
}

struct Crowd {
    Asset asset = leaf();
    World world = make(world_desc());
    lr_batch batch{};
    std::vector<lr_body> ids;

    explicit Crowd(uint32_t count, lr_batch_desc bd = batch_desc()) {
        batch = add_batch(world, bd, asset, std::max(count, 1u));
        for (uint32_t i = 0; i < count; ++i) ids.push_back(add_body(world, batch, placed(i + 1)));
    }
    void set(const std::vector<lr_body>& bodies, int32_t rest) const {
        REQUIRE(lr_body_set_sleep(world.get(), bodies.data(), static_cast<uint32_t>(bodies.size()), rest) == LR_OK);
    }
    bool resting(lr_body id) const { return state_of(world, id).sleep_state == LR_SLEEP_ASLEEP; }
    uint32_t awake() const { return view_of(world, batch).awake_count; }
};

bool same_place(const lr_body_state& a, const lr_body_state& b) {
    return std::equal(a.position, a.position + 3, b.position) &&
           std::equal(a.orientation, a.orientation + 4, b.orientation) && a.scale == b.scale &&
           a.noise_seed == b.noise_seed;
}

} // namespace

TEST_CASE("bodies at rest stay where they are, on every instruction set, and the others do not notice" *
          doctest::test_suite("native")) {
    for (int32_t target : simd_targets())
        for (const int kind : {0, 1, 2, 3})
            for (uint32_t count : {1u, 5u, 32u, 70u}) {
                CAPTURE(target);
                CAPTURE(kind);
                CAPTURE(count);
                lr_batch_desc bd = batch_desc();
                if (kind == 3) bd.load_model = LR_LOADS_LANGEVIN, bd.integrator = LR_INTEGRATOR_RK4;
                const Crowd crowd(count, bd), alone(count, bd);
                std::vector<lr_body> lying, standing;
                for (uint32_t i = 0; i < count; ++i) (i % 3 == 0 ? lying : standing).push_back(crowd.ids[i]);
                for (const Crowd* c : {&crowd, &alone}) {
                    REQUIRE(lr_world_set_simd_target(c->world.get(), target) == LR_OK);
                    set_wind(c->world, 3.0f, 1.0f, 0.0f);
                    if (kind == 1) {
                        lr_gusts_desc gusts = initialised(lr_gusts_desc_init);
                        lr_wind_source source{};
                        REQUIRE(lr_world_add_gusts(c->world.get(), &gusts, &source) == LR_OK);
                    }
                    if (kind == 2) set_water(c->world, sea());
                }
                // The other world never had the sleeping bodies.
                for (uint32_t i = 0; i < count; i += 3)
                    REQUIRE(lr_body_destroy(alone.world.get(), &alone.ids[i], 1) == LR_OK);
                crowd.set(lying, LR_SLEEP_ASLEEP);
                std::vector<lr_body_state> before;
                before.reserve(lying.size());
                for (lr_body id : lying) before.push_back(state_of(crowd.world, id));
                for (const Crowd* c : {&crowd, &alone}) steps(c->world, 5, 0.005f, 3);
                for (size_t i = 0; i < lying.size(); ++i) {
                    const lr_body_state s = state_of(crowd.world, lying[i]);
                    CHECK(same_place(s, before[i]));
                    for (size_t k = 0; k < 3; ++k)
                        CHECK((s.linear_velocity[k] == 0.0f && s.angular_velocity[k] == 0.0f));
                    CHECK(s.sleep_state == LR_SLEEP_ASLEEP);
                }
                for (uint32_t i = 0; i < count; ++i)
                    if (i % 3 != 0)
                        CHECK(same_bits(state_of(crowd.world, crowd.ids[i]), state_of(alone.world, alone.ids[i])));
                const lr_batch_view v = view_of(crowd.world, crowd.batch);
                CHECK(v.awake_count == standing.size());
                for (uint32_t i = 0; i < v.count; ++i) CHECK(crowd.resting(v.ids[i]) == (i >= v.awake_count));
                CHECK(info_of(crowd.world).awake_count == standing.size());
                CHECK(info_of(crowd.world).body_count == count);
            }
}

TEST_CASE("bodies at rest are no work: not in reports, paces or budgets") {
    const Crowd crowd(100);
    const lr_world* const w = crowd.world.get();
    const auto done = [&] {
        lr_step_report r = initialised(lr_step_report_init);
        REQUIRE(lr_world_get_step_report(w, &r) == LR_OK);
        return r;
    };
    steps(crowd.world, 1, 0.01f, 4);
    CHECK(done().body_substeps == 400);
    crowd.set({crowd.ids.begin(), crowd.ids.begin() + 70}, LR_SLEEP_ASLEEP);
    steps(crowd.world, 1, 0.01f, 4);
    CHECK(done().body_substeps == 120);
    crowd.set(crowd.ids, LR_SLEEP_ASLEEP);
    steps(crowd.world, 3, 0.01f, 4);
    CHECK((done().body_substeps == 0 && done().batches_stepped == 0 && done().batches_waiting == 0));
    lr_batch_pace pace = initialised(lr_batch_pace_init);
    REQUIRE(lr_batch_get_pace(w, crowd.batch, &pace) == LR_OK);
    CHECK((pace.body_substeps == 520 && pace.behind == 0.0));
}

TEST_CASE("they are put to rest and woken all or none") {
    const Crowd crowd(10);
    lr_world* const w = crowd.world.get();
    std::vector<lr_body> some = {crowd.ids[3], crowd.ids[5], crowd.ids[3]};
    crowd.set(some, LR_SLEEP_ASLEEP);
    crowd.set(some, LR_SLEEP_ASLEEP);
    CHECK(crowd.awake() == 8);
    const uint64_t before = hash_of(crowd.world);
    some = {crowd.ids[1], crowd.ids[3], {12345}};
    for (int32_t rest : {LR_SLEEP_AWAKE, LR_SLEEP_ASLEEP})
        CHECK(lr_body_set_sleep(w, some.data(), 3, rest) == LR_ERROR_STALE_BODY);
    CHECK(lr_body_set_sleep(w, some.data(), 2, 2) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(lr_body_set_sleep(w, some.data(), 2, -1) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(hash_of(crowd.world) == before);
    crowd.set({crowd.ids[3], crowd.ids[5]}, LR_SLEEP_AWAKE);
    CHECK(crowd.awake() == 10);
}

TEST_CASE("a body wakes when something is done to it, and others sleep on") {
    const Crowd crowd(40);
    lr_world* const w = crowd.world.get();
    const lr_body body = crowd.ids[17];
    const auto wakes = [&](auto&& act) {
        crowd.set(crowd.ids, LR_SLEEP_ASLEEP);
        REQUIRE(crowd.awake() == 0);
        act();
        const bool woken = !crowd.resting(body);
        CHECK(crowd.awake() == (woken ? 1 : 0));
        return woken;
    };
    CHECK(wakes([&] { crowd.set({body}, LR_SLEEP_AWAKE); }));
    CHECK(wakes([&] {
        const lr_body_state s = state_of(crowd.world, body);
        REQUIRE(lr_body_set_state(w, body, &s) == LR_OK);
    }));
    for (int32_t mode :
         {LR_FORCE_MODE_FORCE, LR_FORCE_MODE_ACCELERATION, LR_FORCE_MODE_IMPULSE, LR_FORCE_MODE_VELOCITY})
        for (const bool zero : {false, true}) {
            lr_body_force f = initialised(lr_body_force_init);
            f.body = body, f.mode = mode;
            f.torque[1] = zero ? 0.0f : 1e-9f;
            CHECK(wakes([&] { REQUIRE(lr_body_add_force(w, &f, 1) == LR_OK); }) == !zero);
        }
    // A force wakes at once, and acts as on an awake body.
    crowd.set(crowd.ids, LR_SLEEP_ASLEEP);
    lr_body_force f = initialised(lr_body_force_init);
    f.body = body, f.mode = LR_FORCE_MODE_VELOCITY, f.force[0] = 2.0f;
    REQUIRE(lr_body_add_force(w, &f, 1) == LR_OK);
    CHECK(state_of(crowd.world, body).linear_velocity[0] == doctest::Approx(2.0));
    steps(crowd.world, 1, 0.01f);
    CHECK(state_of(crowd.world, body).position[0] != placed(18).position[0]);
}

TEST_CASE("forces on many bodies reach those whose place in the view they had, also when some of them wake by it") {
    Random random(5);
    for (int round = 0; round < 30; ++round) {
        const Crowd crowd(60);
        std::vector<lr_body> lying;
        for (lr_body id : crowd.ids)
            if (random.below(3) != 0) lying.push_back(id);
        crowd.set(lying, LR_SLEEP_ASLEEP);
        const lr_batch_view v = view_of(crowd.world, crowd.batch);
        lr_force_arrays a = initialised(lr_force_arrays_init);
        a.mode = LR_FORCE_MODE_VELOCITY;
        a.first = random.below(60);
        a.count = random.below(61 - a.first);
        std::vector<float> push(a.count), none(a.count, 0.0f);
        std::vector<std::pair<lr_body, float>> expected;
        for (uint32_t i = 0; i < a.count; ++i) {
            push[i] = random.below(2) ? random.real(1.0, 9.0) : 0.0f;
            expected.emplace_back(v.ids[a.first + i], push[i]);
        }
        std::vector<lr_body_state> before;
        before.reserve(expected.size());
        for (const auto& [id, value] : expected) before.push_back(state_of(crowd.world, id));
        a.force[0] = push.data(), a.force[1] = a.force[2] = none.data();
        REQUIRE(lr_batch_add_forces(crowd.world.get(), crowd.batch, &a) == LR_OK);
        for (size_t i = 0; i < expected.size(); ++i) {
            const auto [id, value] = expected[i];
            const lr_body_state s = state_of(crowd.world, id);
            CHECK(s.linear_velocity[0] == doctest::Approx(wide(before[i].linear_velocity[0] + value)).epsilon(1e-5));
            CHECK((s.sleep_state == LR_SLEEP_ASLEEP) == (before[i].sleep_state == LR_SLEEP_ASLEEP && value == 0.0f));
        }
    }
}

TEST_CASE("a change of what acts on all of them wakes them, the same again does not") {
    const Crowd crowd(20);
    lr_world* const w = crowd.world.get();
    const lr_batch other = add_batch(crowd.world, crowd.asset, 4);
    const lr_body far = add_body(crowd.world, other, body_desc());
    std::vector<lr_body> all = crowd.ids;
    all.push_back(far);
    const auto lie = [&] { crowd.set(all, LR_SLEEP_ASLEEP); };
    const auto awake = [&] { return info_of(crowd.world).awake_count; };
    lie();
    const float old[3] = {0.0f, -9.81f, 0.0f}, other_gravity[3] = {0.0f, -9.8f, 0.0f};
    REQUIRE(lr_world_set_gravity(w, old) == LR_OK);
    CHECK(awake() == 0);
    REQUIRE(lr_world_set_gravity(w, other_gravity) == LR_OK);
    CHECK(awake() == 21);
    lr_batch_force f = initialised(lr_batch_force_init);
    lie();
    REQUIRE(lr_batch_set_force(w, crowd.batch, &f) == LR_OK);
    REQUIRE(lr_batch_set_force(w, crowd.batch, nullptr) == LR_OK);
    CHECK(awake() == 0);
    f.body_torque[2] = 1e-9f;
    REQUIRE(lr_batch_set_force(w, crowd.batch, &f) == LR_OK);
    CHECK(awake() == 20);
    lie();
    REQUIRE(lr_batch_set_force(w, crowd.batch, &f) == LR_OK);
    CHECK(awake() == 0);
    REQUIRE(lr_batch_set_force(w, crowd.batch, nullptr) == LR_OK);
    CHECK(awake() == 20);
}

TEST_CASE("a change of the water wakes the bodies at rest that feel it, and no others") {
    const Asset asset = make(ellipsoid(0.1, 0.1, 0.1, 500.0));
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 4);
    // In the air, at the first surface, at the second, under both.
    const float heights[4] = {2.0f, 1.0f, 0.5f, -1.0f};
    lr_body ids[4];
    for (size_t i = 0; i < 4; ++i) {
        lr_body_desc d = body_desc();
        d.position[1] = heights[i];
        ids[i] = add_body(world, batch, d);
    }
    lr_water_desc first = water_desc(), second = water_desc(), stream = water_desc();
    first.position[1] = stream.position[1] = 1.0f, second.position[1] = 0.5f;
    stream.current[0] = 1.0f;
    struct Change {
        const lr_water_desc *from, *to;
        const char* wakes; // 1: that body
    };
    const Change changes[] = {{nullptr, nullptr, "0000"}, {&first, &first, "0000"},  {nullptr, &first, "0111"},
                              {&first, nullptr, "0111"},  {&first, &second, "0110"}, {&second, &first, "0110"},
                              {&first, &stream, "0111"}};
    for (const Change& c : changes) {
        REQUIRE(lr_world_set_water(world.get(), c.from) == LR_OK);
        REQUIRE(lr_body_set_sleep(world.get(), ids, 4, LR_SLEEP_ASLEEP) == LR_OK);
        REQUIRE(lr_world_set_water(world.get(), c.to) == LR_OK);
        for (size_t i = 0; i < 4; ++i) {
            CAPTURE(i);
            CHECK((state_of(world, ids[i]).sleep_state == LR_SLEEP_AWAKE) == (c.wakes[i] == '1'));
        }
    }
    // Waves beyond wave_count are no part of the water.
    stream.waves[3].length = 5.0f;
    const uint64_t hash = hash_of(world);
    set_water(world, stream);
    CHECK(hash_of(world) == hash);
}

// A body at rest is apart from what carries it by up to a thousandth of its reach, and a ball or a corner reaches no deeper.
TEST_CASE("a ball, and a box on its corner, wake when what they lie on goes") {
    const Triangles sheet{{-1.0f, 0.0f, -1.0f, 1.0f, 0.0f, -1.0f, 0.0f, 0.0f, 1.0f}, {0, 1, 2}};
    lr_collider_desc table = box_collider(1.0f, 0.1f, 1.0f);
    table.position[1] = -0.1f;
    const Asset assets[] = {make(ellipsoid(0.03, 0.03, 0.03, 300.0)), make(rigid_box(0.06, 0.03, 0.05, 300.0))};
    const double corner = 0.5 * std::sqrt(0.06 * 0.06 + 0.03 * 0.03 + 0.05 * 0.05);
    for (const lr_collider_desc& ground : {table, mesh_collider(sheet)})
        for (size_t a = 0; a < 2; ++a)
            for (const double gap : {0.0, 0.9e-3})
                for (const double x : {0.0, 3e4})
                    for (int how = 0; how < 5; ++how) {
                        CAPTURE(a);
                        CAPTURE(gap);
                        CAPTURE(x);
                        CAPTURE(how);
                        const World world = make(world_desc());
                        lr_collider_desc below = ground;
                        below.position[0] = narrow(x);
                        const lr_collider under = add_collider(world, below);
                        steps(world, 1, 1.0f / 60.0f); // in which a new collider wakes bodies
                        const lr_batch batch = add_batch(world, assets[a], 2);
                        const double reach = a == 0 ? 0.03 : corner, height = reach * (1.0 + gap) + 1e-6 * x;
                        const lr_body near = add_body(world, batch, at_rest_at({x, height, 0.0}));
                        const lr_body far = add_body(world, batch, at_rest_at({x, 0.2, 0.0}));
                        const lr_body both[] = {near, far};
                        REQUIRE(lr_body_set_sleep(world.get(), both, 2, LR_SLEEP_ASLEEP) == LR_OK);
                        steps(world, 1, 1.0f / 60.0f, 2);
                        REQUIRE(state_of(world, near).sleep_state == LR_SLEEP_ASLEEP);
                        lr_collider_motion m = initialised(lr_collider_motion_init);
                        m.collider = under;
                        std::copy_n(below.position, 3, m.position);
                        lr_material other = initialised(lr_material_init);
                        other.layers = 2;
                        m.linear_velocity[1] = -0.01f;
                        m.position[1] -= 0.01f;
                        m.mode = how == 1 ? LR_MOVE_TO : how == 2 ? LR_MOVE_PLACE : LR_MOVE_VELOCITY;
                        if (how == 0)
                            REQUIRE(lr_collider_destroy(world.get(), &under, 1) == LR_OK);
                        else if (how == 4)
                            REQUIRE(lr_collider_set_material(world.get(), &under, 1, &other) == LR_OK);
                        else
                            REQUIRE(lr_collider_move(world.get(), &m, 1) == LR_OK);
                        steps(world, 1, 1.0f / 60.0f, 2);
                        CHECK(state_of(world, near).sleep_state == LR_SLEEP_AWAKE);
                        CHECK(state_of(world, far).sleep_state == LR_SLEEP_ASLEEP);
                    }
}

// Engines often pass on all poses in every frame, also those that have not changed.
TEST_CASE("bodies sleep on a collider that is moved to where it already is") {
    const World world = make(world_desc());
    lr_collider_desc table = box_collider(1.0f, 0.1f, 1.0f);
    table.position[1] = -7.3f;
    lr_collider_motion m = initialised(lr_collider_motion_init);
    m.mode = LR_MOVE_TO, m.collider = add_collider(world, table);
    m.position[1] = -7.2f, m.orientation[1] = -0.6f, m.orientation[3] = -1.7f; // it turns about the vertical
    const Asset ball = make(ellipsoid(0.03, 0.03, 0.03, 300.0));
    const lr_body body = add_body(world, add_batch(world, ball, 1), at_rest_at({0.0, -7.07, 0.0}));
    bool asleep = false;
    uint32_t woken = 0;
    for (int step = 0; step < 400; ++step) {
        if (step == 300) // the same pose
            for (float& v : m.orientation) v = -v;
        REQUIRE(lr_collider_move(world.get(), &m, 1) == LR_OK);
        steps(world, 1, 1.0f / 60.0f, 2);
        const bool was_asleep = asleep;
        asleep = state_of(world, body).sleep_state == LR_SLEEP_ASLEEP;
        woken += was_asleep && !asleep;
    }
    CHECK(asleep);
    CHECK(woken == 0);
}

TEST_CASE("a force on a body that is put to rest is gone, and its velocities are") {
    const Crowd crowd(3);
    lr_body_force f = initialised(lr_body_force_init);
    f.body = crowd.ids[1], f.force[1] = 1.0f;
    REQUIRE(lr_body_add_force(crowd.world.get(), &f, 1) == LR_OK);
    crowd.set({f.body}, LR_SLEEP_ASLEEP);
    steps(crowd.world, 2, 0.01f);
    crowd.set({f.body}, LR_SLEEP_AWAKE);
    const float none[3] = {0.0f, 0.0f, 0.0f};
    REQUIRE(lr_world_set_gravity(crowd.world.get(), none) == LR_OK);
    const lr_body_state before = state_of(crowd.world, f.body);
    for (float v : before.linear_velocity) CHECK(v == 0.0f);
    f.body = crowd.ids[0]; // forces are pending again, among them those on others
    REQUIRE(lr_body_add_force(crowd.world.get(), &f, 1) == LR_OK);
    steps(crowd.world, 1, 0.01f);
    CHECK(std::abs(state_of(crowd.world, crowd.ids[1]).linear_velocity[1]) < 0.1f); // 1 N would give a thousand
}

TEST_CASE("ages go on at rest as they do in motion, at any rate of the batch") {
    for (uint32_t divisor : {1u, 8u, 24u}) {
        const Crowd crowd(50);
        REQUIRE(lr_batch_set_rate(crowd.world.get(), crowd.batch, divisor) == LR_OK);
        Random random(divisor);
        std::set<lr_body> lying;
        for (int step = 0; step < 400; ++step) {
            // The first body always moves, the last sleeps as soon as it can; at times all the others sleep.
            const lr_body id = crowd.ids[1 + random.below(49)];
            crowd.set({id}, random.below(2) ? LR_SLEEP_ASLEEP : LR_SLEEP_AWAKE);
            if (step == 150) crowd.set(crowd.ids, LR_SLEEP_ASLEEP);
            if (step == 170) crowd.set({crowd.ids.begin(), crowd.ids.begin() + 3}, LR_SLEEP_AWAKE);
            steps(crowd.world, 1, 0.01f, 2);
            const float reference = state_of(crowd.world, crowd.ids[0]).age;
            bool alike = true;
            for (lr_body other : crowd.ids)
                alike = alike && std::abs(state_of(crowd.world, other).age - reference) <= 1e-5f;
            CHECK(alike);
            lr_batch_pace pace = initialised(lr_batch_pace_init);
            REQUIRE(lr_batch_get_pace(crowd.world.get(), crowd.batch, &pace) == LR_OK);
            CHECK(wide(reference) + pace.behind == doctest::Approx(0.01 * (step + 1)).epsilon(1e-5));
        }
    }
}

TEST_CASE("rules end bodies at rest at most 16 steps late, and never early") {
    for (const bool respawning : {false, true})
        for (const bool some_move : {false, true}) {
            const Crowd crowd(90);
            if (respawning) set_emitter(crowd.world, crowd.batch, emitter_desc());
            lr_batch_rules r = rules_desc();
            r.action = respawning ? LR_END_RESPAWN : LR_END_DESTROY;
            r.max_age = 1.0f;
            set_rules(crowd.world, crowd.batch, r);
            for (uint32_t i = 0; i < 90; ++i) {
                lr_body_state s = state_of(crowd.world, crowd.ids[i]);
                s.age = 0.01f * static_cast<float>(i % 60);
                REQUIRE(lr_body_set_state(crowd.world.get(), crowd.ids[i], &s) == LR_OK);
            }
            std::vector<lr_body> lying;
            for (uint32_t i = 0; i < 90; ++i)
                if (!some_move || i % 4 != 0) lying.push_back(crowd.ids[i]);
            crowd.set(lying, LR_SLEEP_ASLEEP);
            uint64_t ended = 0;
            for (int step = 1; step <= 125; ++step) {
                steps(crowd.world, 1, 0.01f);
                const lr_batch_counts e = counts_of(crowd.world, crowd.batch);
                ended = e.total_destroyed + e.total_respawned;
                CHECK(e.by_age == e.destroyed + e.respawned);
                for (uint32_t i = 0; i < 90; ++i) {
                    const bool rests = !some_move || i % 4 != 0;
                    const float should = 0.01f * static_cast<float>(i % 60 + static_cast<uint32_t>(step));
                    lr_body_state s = body_state();
                    const bool alive = lr_body_get_state(crowd.world.get(), crowd.ids[i], &s) == LR_OK;
                    const bool first_life = alive && s.age > should - 0.005f;
                    if (should < 0.995f) CHECK(first_life);
                    if (should > (rests ? 1.165f : 1.005f)) CHECK_FALSE(first_life);
                    if (alive && !first_life) CHECK(s.sleep_state == LR_SLEEP_AWAKE);
                }
            }
            CHECK(ended == 90);
        }
}

TEST_CASE("volumes end bodies at rest: new rules, and bodies that were put there") {
    const Crowd crowd(40);
    set_rules(crowd.world, crowd.batch, rules_with({LR_VOLUME_SPHERE, LR_KILL_OUTSIDE, {}, {9.0f, 0.0f, 0.0f}}));
    crowd.set(crowd.ids, LR_SLEEP_ASLEEP);
    steps(crowd.world, 40, 0.01f);
    CHECK(counts_of(crowd.world, crowd.batch).total_destroyed == 0);
    set_rules(crowd.world, crowd.batch, rules_with({LR_VOLUME_PLANE, LR_KILL_INSIDE, {}, {1.0f, 0.0f, 0.0f}}));
    uint32_t behind = 0;
    for (uint32_t i = 1; i <= 40; ++i) behind += placed(i).position[0] < 0.0f ? 1u : 0u;
    REQUIRE((behind > 5 && behind < 35));
    steps(crowd.world, 16, 0.01f);
    CHECK(counts_of(crowd.world, crowd.batch).total_destroyed == behind);
    lr_body_desc d = body_desc();
    d.position[0] = -1.0f;
    const lr_body late = add_body(crowd.world, crowd.batch, d);
    crowd.set({late}, LR_SLEEP_ASLEEP);
    steps(crowd.world, 16, 0.01f);
    lr_body_state s = body_state();
    CHECK(lr_body_get_state(crowd.world.get(), late, &s) == LR_ERROR_STALE_BODY);
}

TEST_CASE("an instance buffer in which only what the revision asks for is written is whole") {
    Random random(12);
    const Crowd crowd(300);
    lr_world* const w = crowd.world.get();
    std::vector<lr_body> living = crowd.ids;
    std::vector<float> kept(2400), whole(2400);
    uint64_t revision = UINT64_MAX;
    uint32_t moved = 0, saved = 0;
    for (int frame = 0; frame < 600; ++frame) {
        const uint32_t what = random.below(12);
        const lr_body id = living[random.below(static_cast<uint32_t>(living.size()))];
        if (what < 5) crowd.set({id}, LR_SLEEP_ASLEEP);
        if (what == 5) crowd.set({id}, LR_SLEEP_AWAKE);
        if (what == 6 && living.size() > 200) {
            REQUIRE(lr_body_destroy(w, &id, 1) == LR_OK);
            living.erase(std::find(living.begin(), living.end(), id));
        }
        if (what == 7 && living.size() < 300)
            living.push_back(add_body(crowd.world, crowd.batch, placed(1000 + static_cast<uint32_t>(frame))));
        if (frame % 97 == 0) {
            const std::vector<unsigned char> snapshot = snapshot_of(crowd.world);
            REQUIRE(lr_world_snapshot_restore(w, snapshot.data(), snapshot.size()) == LR_OK);
        }
        steps(crowd.world, 1, 0.001f);
        const lr_batch_view v = view_of(crowd.world, crowd.batch);
        const uint32_t count = v.revision == revision ? std::max(moved, v.awake_count) : v.count;
        uint32_t written = 0;
        REQUIRE(lr_batch_write_transforms(w, crowd.batch, LR_TRANSFORM_POSITION_QUATERNION_SCALE, kept.data(), 0, count,
                                          &written) == LR_OK);
        CHECK(written == std::min(count, v.count));
        saved += v.count - written;
        revision = v.revision, moved = v.awake_count;
        REQUIRE(lr_batch_write_transforms(w, crowd.batch, LR_TRANSFORM_POSITION_QUATERNION_SCALE, whole.data(), 0, 300,
                                          &written) == LR_OK);
        CHECK(written == v.count);
        CHECK(std::equal(whole.data(), whole.data() + size_t{8} * written, kept.data()));
    }
    CHECK(saved > 20000);
}

TEST_CASE("a box wakes the bodies at rest that reach into it, of every size, and no others") {
    Random random(3);
    const Crowd crowd(800);
    std::vector<lr_body> small;
    const lr_batch other = add_batch(crowd.world, crowd.asset, 300);
    for (uint32_t i = 0; i < 300; ++i) {
        lr_body_desc d = placed(5000 + i);
        d.scale = static_cast<float>(random.logarithmic(1e-3, 50.0));
        small.push_back(add_body(crowd.world, other, d));
    }
    std::vector<lr_body> all = crowd.ids;
    all.insert(all.end(), small.begin(), small.end());
    uint32_t in_all = 0;
    for (int round = 0; round < 60; ++round) {
        crowd.set(all, LR_SLEEP_ASLEEP);
        float low[3], high[3];
        for (size_t k = 0; k < 3; ++k) {
            low[k] = random.real(-2.0, 1.8);
            high[k] = low[k] + random.real(0.0, round % 3 == 0 ? 3.0 : 0.2);
        }
        uint32_t woken = 0;
        REQUIRE(lr_world_wake_box(crowd.world.get(), low, high, &woken) == LR_OK);
        uint32_t found = 0;
        for (lr_body id : all) {
            const lr_body_state s = state_of(crowd.world, id);
            const double reach = 0.04 * wide(s.scale);
            bool in = true, near = false;
            for (size_t k = 0; k < 3; ++k) {
                const double over =
                    std::min(wide(s.position[k]) + reach - wide(low[k]), wide(high[k]) - wide(s.position[k]) + reach);
                in = in && over >= 0.0;
                near = near || std::abs(over) < 1e-6 * reach;
            }
            if (!near) CHECK((s.sleep_state == LR_SLEEP_AWAKE) == in);
            found += s.sleep_state == LR_SLEEP_AWAKE ? 1u : 0u;
        }
        CHECK(woken == found);
        in_all += found;
    }
    CHECK(in_all > 1000);
    const float low[3] = {0.0f, 0.0f, 0.0f}, high[3] = {1.0f, -1.0f, 1.0f}, nan[3] = {std::nanf(""), 0.0f, 0.0f};
    CHECK(lr_world_wake_box(crowd.world.get(), low, high, nullptr) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(lr_world_wake_box(crowd.world.get(), nan, high, nullptr) == LR_ERROR_NOT_FINITE);
    CHECK(lr_world_wake_box(crowd.world.get(), low, nan, nullptr) == LR_ERROR_NOT_FINITE);
}

TEST_CASE("the hash knows who rests, and for how long, whatever the way there") {
    const auto scene = [](bool reversed, int rest_step) {
        const Crowd crowd(20);
        std::vector<lr_body> lying(crowd.ids.begin() + 3, crowd.ids.begin() + 9);
        if (reversed) std::reverse(lying.begin(), lying.end());
        for (int step = 0; step < 20; ++step) {
            if (step == rest_step)
                for (lr_body id : lying) crowd.set({id}, LR_SLEEP_ASLEEP);
            steps(crowd.world, 1, 0.01f);
        }
        return hash_of(crowd.world);
    };
    CHECK(scene(false, 5) == scene(true, 5));
    CHECK(scene(false, 5) != scene(false, 6));
    const Crowd still(1);
    lr_body_state s = state_of(still.world, still.ids[0]);
    for (float& v : s.linear_velocity) v = 0.0f;
    REQUIRE(lr_body_set_state(still.world.get(), still.ids[0], &s) == LR_OK);
    const uint64_t awake = hash_of(still.world);
    still.set(still.ids, LR_SLEEP_ASLEEP);
    const uint64_t resting = hash_of(still.world);
    CHECK(resting != awake);
    s.age = 1e-3f;
    std::fill_n(s.linear_velocity, 3, 0.0f);
    REQUIRE(lr_body_set_state(still.world.get(), still.ids[0], &s) == LR_OK);
    still.set(still.ids, LR_SLEEP_ASLEEP);
    CHECK(hash_of(still.world) != resting);
    s.age = 0.0f;
    REQUIRE(lr_body_set_state(still.world.get(), still.ids[0], &s) == LR_OK);
    still.set(still.ids, LR_SLEEP_ASLEEP);
    CHECK(hash_of(still.world) == resting);
    still.set(still.ids, LR_SLEEP_AWAKE);
    CHECK(hash_of(still.world) == awake);
}
