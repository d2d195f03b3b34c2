// Snapshots with one value beyond its setter's limits, resealed: each is refused, and changes nothing. And the state after a step
// from values at their limits can be restored again.
#include "support/colliders.h"
#include "support/lifecycle.h"
#include "support/reseal_snapshot.h"
#include "support/snapshot_layout.h"
#include "support/wind.h"
#include "world/snapshot/snapshot_format.h"

#include <cmath>
#include <limits>

using namespace test;

namespace {

// The pieces of a snapshot, as in support/snapshot_layout.h: of its head, and the columns of the first batch.
enum Piece : uint64_t { head = lr::head_header, sources = lr::head_wind, colliders = lr::head_colliders };
constexpr uint64_t batch = uint64_t{1} << 16, column = batch + 1;
size_t place_of(const std::vector<unsigned char>& bytes, uint64_t key) {
    lr::SnapshotLayout layout;
    REQUIRE(layout.begin(bytes.data(), bytes.size()));
    for (lr::SnapshotPiece piece{}; layout.next(piece);)
        if (piece.key == key) return static_cast<size_t>(4 * piece.begin);
    FAIL("no such piece");
    return 0;
}

struct Scene {
    Asset asset = leaf();
    World world = make(world_desc());
    lr_batch batch = add_batch(world, asset, 8);
    std::vector<lr_body> ids;

    Scene() {
        lr_world* const w = world.get();
        set_wind(world, 1.0f, 0.0f, 0.5f);
        add_source(world, initialised(lr_turbulence_desc_init));
        lr_wind_grid_desc grid = initialised(lr_wind_grid_desc_init);
        const float samples[6] = {};
        for (uint32_t& n : grid.counts) n = 1;
        grid.frames = 2, grid.samples = samples;
        add_source(world, grid);
        lr_water_desc water = initialised(lr_water_desc_init);
        water.position[1] = -50.0f;
        water.wave_count = 1;
        water.waves[0].direction[0] = 1.0f, water.waves[0].length = 10.0f, water.waves[0].amplitude = 0.1f;
        REQUIRE(lr_world_set_water(w, &water) == LR_OK);
        lr_collider_desc ball = sphere_collider(0.1f);
        ball.position[0] = 5.0f;
        ball.linear_velocity[0] = 1.0f;
        add_collider(world, ball);
        set_constant_table(world, batch, 3.0, 0.1, 2.0);
        set_emitter(world, batch, emitter_desc());
        lr_batch_rules r = rules_desc();
        r.max_age = 1000.0f;
        set_rules(world, batch, r);
        lr_batch_force all = initialised(lr_batch_force_init);
        all.acceleration[1] = 2.0f;
        REQUIRE(lr_batch_set_force(w, batch, &all) == LR_OK);
        lr_batch_contact contact = initialised(lr_batch_contact_init);
        contact.friction = 0.7f;
        REQUIRE(lr_batch_set_contact(w, batch, &contact) == LR_OK);
        REQUIRE(lr_batch_set_rate(w, batch, 4) == LR_OK);
        lr_body_desc d = body_desc();
        for (int i = 0; i < 4; ++i) {
            d.position[0] = static_cast<float>(i);
            d.age = 10.0f;
            ids.push_back(add_body(world, batch, d));
        }
        REQUIRE(lr_body_set_sleep(w, ids.data() + 3, 1, LR_SLEEP_ASLEEP) == LR_OK);
        steps(world, 3, 0.001f); // so that the batch is waiting at the end
    }
};

constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr double infinitely = std::numeric_limits<double>::infinity();

} // namespace

TEST_CASE("a snapshot with a value beyond the limit of its setter is refused, and changes nothing") {
    const Scene scene;
    const std::vector<unsigned char> good = snapshot_of(scene.world);
    size_t forgeries = 0;
    const auto refused = [&](uint64_t piece, size_t offset, auto value) {
        CAPTURE(piece);
        CAPTURE(offset);
        CAPTURE(value);
        ++forgeries;
        std::vector<unsigned char> bytes = good;
        std::memcpy(bytes.data() + place_of(good, piece) + offset, &value, sizeof value);
        seal(bytes);
        CHECK(lr_world_snapshot_restore(scene.world.get(), bytes.data(), bytes.size()) == LR_ERROR_SNAPSHOT_FORMAT);
        CHECK(snapshot_of(scene.world) == good);
    };
    using Head = lr::SnapshotHeader;
    for (float g : {1.0001e4f, -1e13f, infinite}) refused(head, offsetof(Head, gravity) + 4, g);
    for (float v : {1000.1f, -3e38f}) refused(head, offsetof(Head, wind), v);
    for (double t : {-1.0, 1e23, infinitely}) refused(head, offsetof(Head, time), t);
    using Wind = lr::WindSnapshot::Head;
    refused(head, offsetof(Head, wind_field) + offsetof(Wind, before), -1000.1f);
    refused(head, offsetof(Head, wind_field) + offsetof(Wind, drift), 1e26);
    for (double since : {-1.1e22, 0.0301}) refused(sources, 8, since); // behind the slot
    for (size_t k = 0; k < 3; ++k)
        for (double shift : {-1.1e25, infinitely}) refused(sources, 16 + 8 * k, shift);
    const size_t grid = 16 + sizeof(lr::SourcePhase) + lr::source_bytes; // after the turbulence
    for (double frames : {-0.1, 2.1}) refused(sources, grid + 16, frames);
    for (double other : {-0.1, 0.1}) refused(sources, grid + 24, other);
    const size_t frequencies = offsetof(Head, surface) + offsetof(lr::Water::Record, frequency);
    for (double frequency : {-1.0, 110.0}) refused(head, frequencies, frequency);
    refused(head, frequencies + 8, 1.0); // of no wave
    refused(head, offsetof(Head, surface) + offsetof(lr::Water::Record, drift), 1e26);
    // One slot, then the collider.
    using Ball = lr::ColliderRecord;
    const size_t ball = 8;
    for (float size : {0.0f, 1.1e6f}) refused(colliders, ball + offsetof(Ball, size), size);
    refused(colliders, ball + offsetof(Ball, size) + 4, 1.0f);
    refused(colliders, ball + offsetof(Ball, friction), 10.1f);
    refused(colliders, ball + offsetof(Ball, restitution), 1.1f);
    for (float x : {1.1e10f, 1e29f}) refused(colliders, ball + offsetof(Ball, begin), x);
    for (size_t k = 0; k < 6; ++k) refused(colliders, ball + offsetof(Ball, linear) + 4 * k, 1.1e6f);
    for (float rest : {0.001f, 1e20f}) refused(colliders, ball + offsetof(Ball, remainder), rest);

    using Batch = lr::SnapshotBatch;
    using Table = lr::TableHead;
    for (double dt : {0.0, 1e-10, 1.1e9}) refused(batch, offsetof(Batch, table) + offsetof(Table, dt), dt);
    refused(batch, offsetof(Batch, table) + offsetof(Table, stationary), 65536u);
    for (size_t k = 0; k < 6; ++k) refused(batch, offsetof(Batch, gains) + 8 * k, 100.1);
    for (size_t at : {offsetof(Table, u0), offsetof(Table, l), offsetof(Table, c0)})
        for (double value : {0.0, 1.1e6}) refused(batch, offsetof(Batch, table) + at, value);
    refused(batch, offsetof(Batch, aerodynamics) + offsetof(lr::AerodynamicData, drag), -1.0);
    refused(batch, offsetof(Batch, aerodynamics) + offsetof(lr::AerodynamicData, center),
            100.0); // more than two lengths away
    for (float chi : {-1.0f, 1.1e9f}) refused(column + lr::piece_chi, 0, chi);
    for (float epsilon : {-1.0f, 1.1e12f}) refused(column + lr::piece_epsilon, 0, epsilon);
    using Pace = lr::BatchClock::Record;
    const size_t pace = offsetof(Batch, pace);
    refused(batch, pace + offsetof(Pace, divisor), 1025u);
    refused(batch, pace + offsetof(Pace, wind), 1000.1f);
    refused(batch, pace + offsetof(Pace, drift), 1e26);
    for (double lost : {-1.0, 1e23}) refused(batch, pace + offsetof(Pace, lost), lost);
    refused(batch, pace + offsetof(Pace, begin), -0.5);

    refused(column + lr::field_x, 0, 1.1e10f);
    for (float scale : {0.0f, 0.0009f, 1001.0f}) refused(column + lr::field_scale, 0, scale);
    for (float age : {-1.0f, 1.1e9f}) refused(column + lr::field_age, 0, age);
    for (float rest : {0.001f, 1e20f, -1e20f, -1.5e30f}) refused(column + lr::field_age_remainder, 0, rest);
    refused(batch, offsetof(Batch, force), 1.1e9f);
    using Rules = lr::Lifecycle::State;
    const size_t rules = offsetof(Batch, lifecycle), resting = offsetof(Batch, sleep);
    refused(batch, rules + offsetof(Rules, rules) + offsetof(lr_batch_rules, max_age), 1.1e9f);
    refused(batch, rules + offsetof(Rules, emitter) + offsetof(lr_emitter_desc, scale_max), 1001.0f);
    refused(batch, rules + offsetof(Rules, emitter) + offsetof(lr_emitter_desc, speed_max), 1.1e6f);
    for (double due : {-0.1, 1.0}) refused(batch, rules + offsetof(Rules, due), due);
    using Rest = lr::SleepingBodies::State;
    for (double clock : {-1.0, 1e23}) refused(batch, resting + offsetof(Rest, clock), clock);
    refused(batch, resting + offsetof(Rest, wind), 1000.1f);
    for (double birth : {-1.1e9, 1000.0}) refused(column + lr::column_birth, 8 * 3, birth);
    refused(batch, offsetof(Batch, contact) + offsetof(lr_batch_contact, friction), 10.1f);
    CHECK(forgeries == 91);
    std::vector<unsigned char> same = good;
    seal(same);
    CHECK(lr_world_snapshot_restore(scene.world.get(), same.data(), same.size()) == LR_OK);
}

// Every restored world must give a valid snapshot, however long it continues.
TEST_CASE("ages, clocks and places at their limits stay there, and the world's own snapshot is taken back") {
    Scene scene;
    lr_world* const w = scene.world.get();
    std::vector<unsigned char> bytes = snapshot_of(scene.world);
    const auto forge = [&](uint64_t piece, size_t offset, auto value) {
        std::memcpy(bytes.data() + place_of(bytes, piece) + offset, &value, sizeof value);
    };
    forge(head, offsetof(lr::SnapshotHeader, substep_count), uint64_t{0} - 2);
    forge(batch, offsetof(lr::SnapshotBatch, pace) + offsetof(lr::BatchClock::Record, first_substep),
          uint64_t{0} - 2 - 2); // it waits since two steps of one substep each
    forge(head, offsetof(lr::SnapshotHeader, wind_field) + offsetof(lr::WindSnapshot::Head, drift), -1e25);
    forge(colliders, 8 + offsetof(lr::ColliderRecord, begin), 1e10f);
    forge(batch, offsetof(lr::SnapshotBatch, pace) + offsetof(lr::BatchClock::Record, lost), 1e22);
    forge(column + lr::field_age, 0, 1e9f);
    forge(column + lr::field_age_remainder, 0, -119.0f);
    forge(column + lr::field_age, 4, std::nextafter(1e9f, 0.0f));
    forge(column + lr::field_age_remainder, 4, -32.0f);
    forge(batch,
          offsetof(lr::SnapshotBatch, lifecycle) + offsetof(lr::Lifecycle::State, rules) +
              offsetof(lr_batch_rules, max_age),
          0.0f);
    forge(batch, offsetof(lr::SnapshotBatch, sleep) + offsetof(lr::SleepingBodies::State, clock), 1e22);
    seal(bytes);
    REQUIRE(lr_world_snapshot_restore(w, bytes.data(), bytes.size()) == LR_OK);
    for (int round = 0; round < 8; ++round) {
        CAPTURE(round);
        bytes = snapshot_of(scene.world);
        REQUIRE(lr_world_snapshot_restore(w, bytes.data(), bytes.size()) == LR_OK);
        CHECK(snapshot_of(scene.world) == bytes);
        if (round == 3) REQUIRE(lr_body_set_sleep(w, scene.ids.data(), 4, LR_SLEEP_ASLEEP) == LR_OK);
        if (round == 5) REQUIRE(lr_body_set_sleep(w, scene.ids.data(), 4, LR_SLEEP_AWAKE) == LR_OK);
        steps(scene.world, 4, 100.0f, 200);
    }
    for (lr_body id : scene.ids) CHECK(state_of(scene.world, id).age <= 1e9f);
    CHECK(state_of(scene.world, scene.ids[0]).age == 1e9f);
}

TEST_CASE("an age is taken up to 1e9 s, and is not passed") {
    const Asset asset = leaf();
    const World world = weightless();
    const lr_batch batch = add_batch(world, asset, 2);
    lr_body_desc d = body_desc();
    for (float age : {-1e-6f, 1.1e9f, 1e10f}) {
        d.age = age;
        CHECK(lr_body_create(world.get(), batch, &d, 1, nullptr) == LR_ERROR_INVALID_ARGUMENT);
    }
    d.age = 1e9f;
    const lr_body old = add_body(world, batch, d);
    d.age = 5.0f;
    const lr_body young = add_body(world, batch, d);
    steps(world, 3, 1000.0f, 1000);
    lr_body_state s = state_of(world, old);
    CHECK(s.age == 1e9f);
    CHECK(lr_body_set_state(world.get(), old, &s) == LR_OK);
    CHECK(state_of(world, young).age == doctest::Approx(3005.0));
    const std::vector<unsigned char> own = snapshot_of(world);
    CHECK(lr_world_snapshot_restore(world.get(), own.data(), own.size()) == LR_OK);
}
