// Rates of batches and budgets of worlds: which batches step, over which time, and what the reports say.
#include "support/colliders.h"
#include "support/lifecycle.h"
#include "support/random.h"
#include "support/water.h"
#include "support/wind.h"

#include <algorithm>
#include <cmath>

using namespace test;

namespace {

constexpr float frame = 1.0f / 1024.0f; // s: sums of it are exact, and the longest substep is many of it

void set_rate(const World& w, lr_batch batch, uint32_t divisor) {
    REQUIRE(lr_batch_set_rate(w.get(), batch, divisor) == LR_OK);
}
lr_batch_pace pace_of(const World& w, lr_batch batch) {
    lr_batch_pace p = initialised(lr_batch_pace_init);
    REQUIRE(lr_batch_get_pace(w.get(), batch, &p) == LR_OK);
    return p;
}
lr_step_report report_of(const World& w) {
    lr_step_report r = initialised(lr_step_report_init);
    REQUIRE(lr_world_get_step_report(w.get(), &r) == LR_OK);
    return r;
}
void set_budget(const World& w, uint64_t body_substeps) {
    REQUIRE(lr_world_set_budget(w.get(), body_substeps) == LR_OK);
}

lr_body_desc body_at(double x, double y) {
    lr_body_desc d = body_desc();
    d.position[0] = narrow(x), d.position[1] = narrow(y);
    return d;
}
std::vector<lr_body> populate(const World& w, lr_batch batch, uint32_t count) {
    std::vector<lr_body> ids;
    Random random(count);
    for (uint32_t i = 0; i < count; ++i) {
        lr_body_desc d = strewn(random, 1.0);
        for (float& v : d.linear_velocity) v = random.real(-1.0, 1.0);
        for (float& v : d.angular_velocity) v = random.real(-10.0, 10.0);
        ids.push_back(add_body(w, batch, d));
    }
    return ids;
}

// A world with batches of these sizes.
struct Crowd {
    Asset asset = leaf();
    World world;
    std::vector<lr_batch> batches;
    explicit Crowd(const std::vector<uint32_t>& counts, uint32_t workers = 0) {
        lr_world_desc d = world_desc();
        d.worker_count = workers;
        world = make(d);
        for (uint32_t count : counts) {
            batches.push_back(add_batch(world, asset, count));
            populate(world, batches.back(), count);
        }
    }
    void step(uint32_t substeps = 4) const { steps(world, 1, frame, substeps); }
};

bool same_motion(const World& a, lr_batch in_a, const World& b, lr_batch in_b) {
    const lr_batch_view va = view_of(a, in_a), vb = view_of(b, in_b);
    bool same = va.count == vb.count;
    const auto compare = [&](const float* x, const float* y) {
        same = same && std::memcmp(x, y, va.count * sizeof(float)) == 0;
    };
    for (size_t k = 0; k < 3; ++k) compare(va.position[k], vb.position[k]);
    for (size_t k = 0; k < 4; ++k) compare(va.orientation[k], vb.orientation[k]);
    compare(va.age, vb.age);
    const std::vector<Velocity> ua = velocities_of(a, in_a), ub = velocities_of(b, in_b);
    return same && std::memcmp(ua.data(), ub.data(), ua.size() * sizeof(Velocity)) == 0;
}

} // namespace

TEST_CASE("rates and budgets that make no sense are refused and change nothing") {
    const Crowd c({10});
    lr_world* const w = c.world.get();
    const lr_batch batch = c.batches[0];
    const uint64_t before = hash_of(c.world);
    for (uint32_t divisor : {0u, 1025u}) CHECK(lr_batch_set_rate(w, batch, divisor) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(lr_batch_set_rate(w, {batch.id + 1}, 2) == LR_ERROR_STALE_BATCH);
    lr_batch_pace pace = initialised(lr_batch_pace_init);
    CHECK(lr_batch_get_pace(w, {}, &pace) == LR_ERROR_STALE_BATCH);

    CHECK(lr_world_set_budget(w, (uint64_t{1} << 48) + 1) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(hash_of(c.world) == before);
    CHECK(pace_of(c.world, batch).divisor == 1);
    c.step();
    CHECK(report_of(c.world).body_substeps == 40);
}

TEST_CASE("a divisor takes fewer substeps, and waits for some steps where that is not enough") {
    const Crowd c({10});
    const struct {
        uint32_t divisor, substeps, period, taken;
    } cases[] = {{1, 4, 1, 4}, {2, 4, 1, 2}, {4, 4, 1, 1}, {8, 4, 2, 1},
                 {3, 4, 1, 2}, {6, 4, 1, 1}, {5, 1, 5, 1}, {12, 4, 3, 1}};
    for (const auto& k : cases) {
        CAPTURE(k.divisor);
        set_rate(c.world, c.batches[0], k.divisor);
        // Steps until the next step of the batch itself.
        do c.step(k.substeps);
        while (pace_of(c.world, c.batches[0]).substeps == 0);
        const uint64_t before = pace_of(c.world, c.batches[0]).body_substeps;
        for (uint32_t round = 0; round < 3; ++round)
            for (uint32_t i = 1; i <= k.period; ++i) {
                c.step(k.substeps);
                const lr_batch_pace p = pace_of(c.world, c.batches[0]);
                const bool last = i == k.period;
                CHECK(p.substeps == (last ? k.taken : 0));
                CHECK(p.waited == (last ? 0 : i));
                CHECK(p.behind == (last ? 0.0 : static_cast<double>(frame) * i));
                const lr_step_report r = report_of(c.world);
                CHECK(r.batches_stepped == (last ? 1 : 0));
                CHECK(r.batches_waiting == (last ? 0 : 1));
                CHECK(r.behind == p.behind);
                CHECK((r.batches_passed_over == 0 && r.lost == 0.0));
                CHECK(r.body_substeps == (last ? 10 * k.taken : 0));
            }
        CHECK(pace_of(c.world, c.batches[0]).body_substeps - before == 30ull * k.taken);
    }
}

TEST_CASE("batches of the same divisor take different steps") {
    const Crowd c({10, 10, 10, 10, 10, 10, 10, 10});
    for (lr_batch b : c.batches) set_rate(c.world, b, 16);
    steps(c.world, 8, frame, 4);
    for (int i = 0; i < 8; ++i) {
        c.step();
        CHECK(report_of(c.world).batches_stepped == 2);
    }
}

// Without noise a batch with a divisor equals a world with longer steps, to the last bit: in uniform wind, in a field, at a water surface.
TEST_CASE("a batch that waited takes one longer step") {
    for (int setting = 0; setting < 4; ++setting)
        for (int32_t loads : {LR_LOADS_NONE, LR_LOADS_AERODYNAMIC}) {
            CAPTURE(setting);
            const Asset asset = curled_leaf();
            World worlds[2];
            lr_batch batches[2];
            for (size_t i = 0; i < 2; ++i) {
                worlds[i] = make(world_desc());
                lr_batch_desc d = batch_desc();
                d.load_model = loads;
                batches[i] = add_batch(worlds[i], d, asset, 40);
                populate(worlds[i], batches[i], 40);
                lr_load_gains gains = initialised(lr_load_gains_init);
                gains.turbulence = 0.0f;
                REQUIRE(lr_batch_set_load_gains(worlds[i].get(), batches[i], &gains) == LR_OK);
                if (setting == 1) set_wind(worlds[i], 2.0f, 0.5f, -1.0f);
                if (setting == 2) {
                    lr_vortex_desc vortex = vortex_desc(LR_VORTEX_RANKINE);
                    set(vortex.axis, 1.0f, 0.0f, 0.0f);
                    add_source(worlds[i], initialised(lr_gusts_desc_init));
                    add_source(worlds[i], initialised(lr_turbulence_desc_init));
                    add_source(worlds[i], vortex);
                }
                if (setting == 3) set_water(worlds[i], sea());
                lr_batch_force pull = initialised(lr_batch_force_init);
                pull.force[0] = 1e-4f;
                REQUIRE(lr_batch_set_force(worlds[i].get(), batches[i], &pull) == LR_OK);
            }
            set_rate(worlds[1], batches[1], 12); // with 4 substeps: one of three steps takes one
            // Its phase follows the world's steps: the first step is a separate one.
            steps(worlds[0], 1, frame, 1);
            steps(worlds[0], 4, 3.0f * frame, 1);
            steps(worlds[1], 13, frame, 4);
            CHECK(pace_of(worlds[1], batches[1]).waited == 0);
            CHECK(same_motion(worlds[0], batches[0], worlds[1], batches[1]));
            CHECK(info_of(worlds[0]).time == info_of(worlds[1]).time);
        }
}

TEST_CASE("a divisor has no effect beyond the longest substep") {
    const Asset leaves = leaf(), confetti = make(ellipsoid(0.006, 0.003, 0.00005, 700.0));
    const World world = make(world_desc());
    const lr_batch large = add_batch(world, leaves, 10), small = add_batch(world, confetti, 10);
    for (lr_batch b : {large, small}) {
        populate(world, b, 10);
        set_rate(world, b, 64);
    }
    for (int i = 0; i < 8; ++i) {
        steps(world, 1, 1.0f / 60.0f, 8);
        CHECK(pace_of(world, large).substeps == 1);
        CHECK(pace_of(world, small).substeps == 4); // 2.9 of 8 fit into its longest
        CHECK(report_of(world).lost == 0.0);
    }
    // A world with longer substeps than that steps as usual.
    const uint64_t before = pace_of(world, large).body_substeps;
    steps(world, 5, 0.1f, 2);
    CHECK(pace_of(world, large).body_substeps - before >= 100);
    CHECK(pace_of(world, large).lost == 0.0);
}

TEST_CASE("transforms of a batch that waits are moved on with its bodies") {
    lr_world_desc d = world_desc();
    d.gravity[1] = 0.0f;
    const World world = make(d);
    const Asset asset = make(ellipsoid(0.05, 0.05, 0.05, 1000.0)); // a ball: nothing changes its spin's direction
    lr_batch_desc bd = batch_desc();
    bd.load_model = LR_LOADS_NONE;
    const lr_batch batch = add_batch(world, bd, asset, 300);
    const std::vector<lr_body> ids = populate(world, batch, 300);
    std::vector<lr_body_state> start;
    for (lr_body id : ids) start.push_back(state_of(world, id));
    set_rate(world, batch, 1024);
    steps(world, 1, frame, 1); // its first step
    if (pace_of(world, batch).waited == 0) steps(world, 7, frame, 1);
    const double behind = pace_of(world, batch).behind;
    REQUIRE(behind > 0.0);
    for (int32_t simd : simd_targets()) {
        REQUIRE(lr_world_set_simd_target(world.get(), simd) == LR_OK);
        std::vector<float> out(8 * 300);
        uint32_t written = 0;
        REQUIRE(lr_batch_write_transforms(world.get(), batch, LR_TRANSFORM_POSITION_QUATERNION_SCALE, out.data(), 0,
                                          300, &written) == LR_OK);
        REQUIRE(written == 300);
        double worst = 0.0, worst_turn = 0.0;
        for (size_t i = 0; i < 300; ++i) {
            const lr_body_state now = state_of(world, ids[i]);
            double dot = 0.0, spin = 0.0, w[3];
            for (size_t k = 0; k < 3; ++k) {
                const double expected = wide(now.position[k]) + behind * wide(now.linear_velocity[k]);
                worst = std::max(worst, std::abs(wide(out[8 * i + k]) - expected));
                w[k] = wide(now.angular_velocity[k]);
                spin += w[k] * w[k];
            }
            spin = std::sqrt(spin);
            // exp(w t/2) q, the spin in the world's frame.
            const double half = 0.5 * spin * behind, s = std::sin(half) / spin, c = std::cos(half);
            const float* const q = now.orientation;
            const double r[3] = {s * w[0], s * w[1], s * w[2]}, v[3] = {wide(q[0]), wide(q[1]), wide(q[2])},
                         q3 = wide(q[3]);
            const double turned[4] = {
                c * v[0] + q3 * r[0] + r[1] * v[2] - r[2] * v[1], c * v[1] + q3 * r[1] + r[2] * v[0] - r[0] * v[2],
                c * v[2] + q3 * r[2] + r[0] * v[1] - r[1] * v[0], c * q3 - r[0] * v[0] - r[1] * v[1] - r[2] * v[2]};
            for (size_t k = 0; k < 4; ++k) dot += turned[k] * wide(out[8 * i + 3 + k]);
            worst_turn = std::max(worst_turn,
                                  2.0 * std::acos(std::min(std::abs(dot), 1.0)) - std::pow(spin * behind, 3.0) / 48.0);
            CHECK(out[8 * i + 7] == 1.0f);
        }
        CHECK(worst < 1e-6);
        CHECK(worst_turn < 2e-3); // 4 atan(x/4) for x, and the roundings of an arc cosine
    }
}

TEST_CASE("a force ends the waiting, and acts with the impulse of one step") {
    lr_world_desc d = world_desc();
    d.gravity[1] = 0.0f;
    const World world = make(d);
    const Asset asset = leaf();
    lr_batch_desc bd = batch_desc();
    bd.load_model = LR_LOADS_NONE;
    const lr_batch batch = add_batch(world, bd, asset, 10);
    const lr_body body = add_body(world, batch, body_desc());
    set_rate(world, batch, 64);
    do steps(world, 1, frame, 1);
    while (pace_of(world, batch).waited != 5);
    lr_body_force f = initialised(lr_body_force_init);
    f.body = body;
    f.mode = LR_FORCE_MODE_ACCELERATION;
    f.force[1] = 6.0f;
    REQUIRE(lr_body_add_force(world.get(), &f, 1) == LR_OK);
    steps(world, 1, frame, 1);
    CHECK(pace_of(world, batch).waited == 0);
    CHECK(pace_of(world, batch).substeps == 1);
    CHECK(wide(state_of(world, body).linear_velocity[1]) == doctest::Approx(6.0 * wide(frame)));
    steps(world, 1, frame, 1);
    CHECK(pace_of(world, batch).waited == 1);
    CHECK(wide(state_of(world, body).linear_velocity[1]) == doctest::Approx(6.0 * wide(frame)));
}

TEST_CASE("a collider that moves among bodies ends their waiting, so that it passes through none") {
    for (const int32_t mode : {LR_MOVE_TO, LR_MOVE_VELOCITY}) {
        CAPTURE(mode);
        const World world = make(world_desc());
        lr_collider_desc ground = initialised(lr_collider_desc_init);
        ground.kind = LR_COLLIDER_PLANE;
        add_collider(world, ground);
        lr_collider_desc broom = ground;
        broom.kind = LR_COLLIDER_BOX;
        broom.position[0] = -2.0f, broom.size[0] = 0.02f, broom.size[1] = 0.5f, broom.size[2] = 2.0f;
        lr_collider_motion m = motion_of(add_collider(world, broom), mode);
        m.position[0] = broom.position[0], m.linear_velocity[0] = 3.0f;
        const Asset asset = make(ellipsoid(0.03, 0.0005, 0.03, 400.0));
        const lr_batch batch = add_batch(world, asset, 20), far = add_batch(world, asset, 1);
        std::vector<lr_body> bodies;
        for (int i = 0; i < 20; ++i) bodies.push_back(add_body(world, batch, body_at(0.05 * i - 0.5, 0.002)));
        add_body(world, far, body_at(50.0, 30.0));
        for (const lr_batch b : {batch, far}) set_rate(world, b, 4);
        steps(world, 240, 1.0f / 240.0f, 1);
        uint32_t waited = 0;
        for (int i = 0; i < 240; ++i) {
            m.position[0] += 3.0f / 240.0f;
            if (mode == LR_MOVE_TO || i == 0) REQUIRE(lr_collider_move(world.get(), &m, 1) == LR_OK);
            steps(world, 1, 1.0f / 240.0f, 1);
            waited += pace_of(world, far).waited != 0;
        }
        CHECK(waited == 180);
        for (const lr_body& body : bodies) CHECK(state_of(world, body).position[0] > 1.0f);
    }
}

TEST_CASE("rules, emitter and events wait with their batch, and nothing of them is lost") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 4000);
    lr_emitter_desc e = emitter_desc();
    e.rate = 640.0f;
    set_emitter(world, batch, e);
    lr_batch_rules r = rules_desc();
    r.max_age = 1.0f;
    set_rules(world, batch, r);
    set_rate(world, batch, 16);
    uint64_t spawned = 0, destroyed = 0;
    bool quiet = true;
    for (int i = 0; i < 4096; ++i) {
        steps(world, 1, frame, 4);
        const lr_batch_counts now = counts_of(world, batch);
        spawned += now.spawned;
        destroyed += now.destroyed;
        quiet = quiet && (pace_of(world, batch).waited == 0 || now.spawned + now.destroyed == 0);
    }
    CHECK(quiet);
    CHECK(spawned == doctest::Approx(2560.0).epsilon(0.02));
    CHECK(spawned - destroyed == doctest::Approx(640.0).epsilon(0.1));
    CHECK(info_of(world).body_count == spawned - destroyed);
}

TEST_CASE("a budget is kept in each step, and shared alike") {
    const Crowd c({100, 100, 100, 100});
    set_budget(c.world, 700); // of 1600
    const uint64_t frames = 400;
    bool kept = true, summed = true;
    uint64_t total = 0;
    for (uint64_t i = 0; i < frames; ++i) {
        c.step();
        const lr_step_report r = report_of(c.world);
        kept = kept && r.body_substeps <= 700 && r.body_substeps_wanted == 1600;
        summed = summed && r.batches_stepped == 4 && r.lost == 0.0 && r.behind == 0.0;
        total += r.body_substeps;
    }
    CHECK(kept);
    CHECK(summed);
    CHECK(total == 700 * frames);
    for (lr_batch b : c.batches) CHECK(pace_of(c.world, b).body_substeps == 175 * frames);
    // The series ends.
    set_budget(c.world, 0);
    c.step();
    CHECK(report_of(c.world).body_substeps == 1600);
}

TEST_CASE("batches that a budget does not reach take turns") {
    const Crowd c({100, 100, 100, 100, 100, 100});
    set_budget(c.world, 200);
    const uint64_t frames = 300;
    double furthest = 0.0;
    for (uint64_t i = 0; i < frames; ++i) {
        c.step();
        const lr_step_report r = report_of(c.world);
        CHECK((r.batches_stepped == 2 && r.batches_passed_over == 4));
        furthest = std::max(furthest, r.behind);
    }
    CHECK(furthest == 2.0 * wide(frame));
    for (lr_batch b : c.batches) CHECK(pace_of(c.world, b).body_substeps == 100 * frames / 3);
}

TEST_CASE("a budget that is enough changes nothing") {
    const Crowd a({100, 30}), b({100, 30});
    set_budget(b.world, 520);
    for (int i = 0; i < 20; ++i) {
        a.step();
        b.step();
        const lr_step_report r = report_of(b.world);
        CHECK((r.body_substeps == 520 && r.body_substeps_wanted == 520));
    }
    for (size_t k = 0; k < 2; ++k) CHECK(same_motion(a.world, a.batches[k], b.world, b.batches[k]));
}

TEST_CASE(
    "a batch larger than the budget is stepped when enough has been saved, and others are not kept from their turns") {
    const Crowd c({1000, 50, 50});
    set_budget(c.world, 400);
    uint64_t total = 0;
    for (int i = 0; i < 300; ++i) {
        c.step();
        total += report_of(c.world).body_substeps;
    }
    CHECK(total <= 300 * 400);
    CHECK(total > 250 * 400);
    for (size_t i = 0; i < 3; ++i) {
        CAPTURE(i);
        const lr_batch_pace p = pace_of(c.world, c.batches[i]);
        CHECK(p.body_substeps / view_of(c.world, c.batches[i]).count > 70);
        CHECK(p.lost == 0.0);
    }
}

TEST_CASE("bodies go in slow motion rather than wrong where a budget does not reach for their longest substeps") {
    const Crowd c({1000});
    const float slow = 1.0f / 120.0f; // s: a half of the longest substep
    set_budget(c.world, 250);         // a substep in four steps, which covers two of them
    double lost = 0.0;
    for (int i = 0; i < 100; ++i) {
        steps(c.world, 1, slow, 4);
        lost += report_of(c.world).lost;
    }
    const lr_batch_pace p = pace_of(c.world, c.batches[0]);
    CHECK(p.lost == lost);
    CHECK(lost == doctest::Approx(50.0 * wide(slow)).epsilon(0.05));
    const double lived = wide(view_of(c.world, c.batches[0]).age[0]);
    CHECK(lived + lost + p.behind == doctest::Approx(100.0 * wide(slow)));
}

TEST_CASE("forces act at once, whatever the budget") {
    const Crowd c({100, 100});
    set_budget(c.world, 100);
    for (int i = 0; i < 20; ++i) {
        lr_body_force f = initialised(lr_body_force_init);
        f.body = view_of(c.world, c.batches[1]).ids[3];
        f.force[0] = 1e-3f;
        REQUIRE(lr_body_add_force(c.world.get(), &f, 1) == LR_OK);
        c.step();
        CHECK(pace_of(c.world, c.batches[1]).substeps != 0);
    }
    CHECK(pace_of(c.world, c.batches[0]).waited < 20);
}

TEST_CASE("waiting is part of hashes and snapshots") {
    const Crowd c({30, 30});
    set_rate(c.world, c.batches[0], 32);
    set_budget(c.world, 90);
    steps(c.world, 10, frame, 4);
    const std::vector<unsigned char> saved = snapshot_of(c.world);
    const uint64_t before = hash_of(c.world);
    const Crowd other({30, 30});
    REQUIRE(lr_world_snapshot_restore(other.world.get(), saved.data(), saved.size()) == LR_OK);
    CHECK(hash_of(other.world) == before);
    CHECK(pace_of(other.world, other.batches[0]).divisor == 32);
    steps(c.world, 37, frame, 4);
    steps(other.world, 37, frame, 4);
    CHECK(hash_of(other.world) == hash_of(c.world));
    // Each setting is reported separately.
    std::vector<uint64_t> hashes = {hash_of(c.world)};
    set_rate(c.world, c.batches[1], 2);
    hashes.push_back(hash_of(c.world));
    set_budget(c.world, 91);
    hashes.push_back(hash_of(c.world));
    std::sort(hashes.begin(), hashes.end());
    CHECK(std::unique(hashes.begin(), hashes.end()) == hashes.end());
}

TEST_CASE("a batch that has lost all its bodies waits for nothing") {
    const Crowd c({10});
    set_rate(c.world, c.batches[0], 32);
    do c.step();
    while (pace_of(c.world, c.batches[0]).waited != 3);
    const lr_batch_view v = view_of(c.world, c.batches[0]);
    const std::vector<lr_body> ids(v.ids, v.ids + v.count);
    REQUIRE(lr_body_destroy(c.world.get(), ids.data(), 10) == LR_OK);
    c.step();
    const lr_batch_pace p = pace_of(c.world, c.batches[0]);
    CHECK((p.waited == 0 && p.behind == 0.0 && p.substeps == 0));
    CHECK(report_of(c.world).batches_waiting == 0);
}
