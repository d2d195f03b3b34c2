// Contents, cost and end of a recording.
#include "support/colliders.h"
#include "support/counting_memory.h"
#include "support/every_call.h"
#include "support/wind.h"
#include "tools/lr_replay/recording.h"

#include <functional>
#include <sstream>

using namespace test;
using lr::recording::Kind;
using lr::replay::Reader;
using lr::replay::Record;

namespace {

struct Held {
    std::vector<std::string> calls, refused;
    size_t answers = 0, blobs = 0, assets = 0;
};
Held held_in(const std::vector<unsigned char>& bytes) {
    Held held;
    Reader reader(bytes.data(), bytes.size());
    Record r;
    std::string last;
    while (reader.next(r)) {
        uint16_t op = 0;
        if (r.kind == Kind::call) {
            std::memcpy(&op, r.data, 2);
            last = lr::replay::name_of(op);
            held.calls.push_back(last);
        }
        if (r.kind == Kind::result) {
            lr::recording::ResultRecord result;
            std::memcpy(&result, r.data, sizeof result);
            if (result.status != LR_OK) held.refused.push_back(last);
        }
        held.answers += r.kind == Kind::wind || r.kind == Kind::surface;
        held.blobs += r.kind == Kind::blob;
        held.assets += r.kind == Kind::asset;
    }
    return held;
}
bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

template <class T> void twice(lr_status (*function)(lr_world*, lr_batch, const T*), lr_world* w, lr_batch b, T desc) {
    REQUIRE(function(w, b, &desc) == LR_OK);
    CHECK(function(w, {999}, &desc) == LR_ERROR_STALE_BATCH);
    desc.struct_size = 3;
    CHECK(function(w, b, &desc) == LR_ERROR_STRUCT_SIZE); // unreadable
}

// Calls every function that changes a world, correctly and wrongly.
void do_everything(const World& world, const Asset& flat, const Asset& plate, Recording* from_here) {
    lr_world* const w = world.get();
    if (from_here) from_here->start(world);
    lr_batch_desc bd = langevin();
    bd.damping_gain = 0.5f;
    const lr_batch a = add_batch(world, bd, flat, 50), gone = add_batch(world, flat, 5),
                   b = add_batch(world, plate, 30);
    bd.asset = flat.get();
    bd.capacity = 0;
    lr_batch refused{};
    CHECK(lr_batch_create(w, &bd, &refused) == LR_ERROR_INVALID_ARGUMENT);
    bd.asset = nullptr;
    CHECK(lr_batch_create(w, &bd, &refused) == LR_ERROR_NULL_ARGUMENT);
    CHECK(lr_batch_create(w, nullptr, &refused) == LR_ERROR_NULL_ARGUMENT);
    REQUIRE(lr_batch_destroy(w, gone) == LR_OK);
    CHECK(lr_batch_destroy(w, gone) == LR_ERROR_STALE_BATCH);

    std::vector<lr_body_desc> descs(20, body_desc());
    for (size_t i = 0; i < descs.size(); ++i) descs[i].position[0] = 0.2f * static_cast<float>(i);
    std::vector<lr_body> ids(20), plates(10);
    REQUIRE(lr_body_create(w, a, descs.data(), 20, ids.data()) == LR_OK);
    REQUIRE(lr_body_create(w, b, descs.data(), 10, plates.data()) == LR_OK);
    REQUIRE(lr_body_create(w, a, descs.data(), 2, nullptr) == LR_OK);
    CHECK(lr_body_create(w, a, descs.data(), 4000000000u, nullptr) == LR_ERROR_CAPACITY); // reads nothing
    descs[1].scale = -1.0f;
    CHECK(lr_body_create(w, a, descs.data(), 2, nullptr) == LR_ERROR_INVALID_ARGUMENT);
    descs[1].struct_size = 5;
    CHECK(lr_body_create(w, a, descs.data(), 2, nullptr) == LR_ERROR_STRUCT_SIZE);
    CHECK(lr_body_create(w, a, nullptr, 2, nullptr) == LR_ERROR_NULL_ARGUMENT);
    REQUIRE(lr_body_destroy(w, ids.data() + 15, 5) == LR_OK);
    CHECK(lr_body_destroy(w, ids.data() + 15, 5) == LR_ERROR_STALE_BODY);
    lr_body_state s = state_of(world, ids[0]);
    s.linear_velocity[1] = 2.0f;
    REQUIRE(lr_body_set_state(w, ids[0], &s) == LR_OK);
    CHECK(lr_body_set_state(w, ids[16], &s) == LR_ERROR_STALE_BODY);

    const float gravity[3] = {0.1f, -9.0f, 0.0f}, up[3] = {0.0f, INFINITY, 0.0f};
    REQUIRE(lr_world_set_gravity(w, gravity) == LR_OK);
    CHECK(lr_world_set_gravity(w, up) == LR_ERROR_NOT_FINITE);
    CHECK(lr_world_set_gravity(w, nullptr) == LR_ERROR_NULL_ARGUMENT);
    REQUIRE(lr_world_set_simd_target(w, simd_targets().back()) == LR_OK);
    set_wind(world, 1.0f, 0.0f, 0.2f);

    std::vector<float> samples(3 * 4 * 4 * 4);
    for (size_t i = 0; i < samples.size(); ++i) samples[i] = 0.01f * static_cast<float>(i);
    lr_wind_grid_desc grid = initialised(lr_wind_grid_desc_init);
    grid.counts[0] = grid.counts[1] = grid.counts[2] = 4;
    grid.samples = samples.data();
    const lr_wind_source first = add_source(world, grid), second = add_source(world, grid);
    grid.samples = nullptr;
    grid.position[1] = -1.0f;
    REQUIRE(lr_world_update_wind_grid(w, first, &grid) == LR_OK);
    CHECK(lr_world_add_wind_grid(w, &grid, nullptr) == LR_ERROR_NULL_ARGUMENT);
    REQUIRE(lr_world_remove_wind(w, second) == LR_OK);
    CHECK(lr_world_remove_wind(w, second) == LR_ERROR_STALE_WIND_SOURCE);
    add_source(world, initialised(lr_gusts_desc_init));
    const lr_turbulence_desc turbulence = initialised(lr_turbulence_desc_init);
    REQUIRE(lr_world_add_turbulence(w, &turbulence, nullptr) == LR_OK);
    REQUIRE(lr_world_set_wind_callback(
                w,
                [](void*, const lr_wind_query* q) {
                    for (uint32_t i = 0; i < q->count; ++i) q->velocity[1][i] = 0.3f * q->position[0][i];
                },
                nullptr) == LR_OK);
    lr_water_desc water = initialised(lr_water_desc_init);
    water.position[1] = -2.0f;
    water.reach = 1.0f;
    REQUIRE(lr_world_set_water(w, &water) == LR_OK);
    REQUIRE(lr_world_set_water_callback(
                w,
                [](void*, const lr_water_query* q) {
                    for (uint32_t i = 0; i < q->count; ++i) q->height[i] += 0.01f * q->position[2][i];
                },
                nullptr) == LR_OK);
    REQUIRE(lr_world_set_budget(w, 1000000) == LR_OK);
    REQUIRE(lr_world_set_events(w, 100, LR_EVENTS_ALL) == LR_OK);

    set_constant_table(world, a, 2.0, 0.5, 6.5);
    REQUIRE(lr_batch_set_turbulence_table(w, a, nullptr) == LR_OK);
    std::vector<float> many(300, 0.5f);
    lr_turbulence_table table = table_desc();
    table.count = 300, table.chi = table.epsilon = many.data();
    table.dt = table.u0 = table.l = 1.0f;
    twice(&lr_batch_set_turbulence_table, w, a, table);
    lr_aerodynamics loads = initialised(lr_aerodynamics_init);
    loads.drag[0] = loads.drag[1] = loads.drag[2] = 0.01;
    twice(&lr_batch_set_aerodynamics, w, b, loads);
    lr_load_gains gains = initialised(lr_load_gains_init);
    gains.drag = 0.7f;
    twice(&lr_batch_set_load_gains, w, b, gains);
    REQUIRE(lr_batch_set_rate(w, b, 2) == LR_OK);
    lr_batch_force force = initialised(lr_batch_force_init);
    force.acceleration[2] = 0.5f;
    twice(&lr_batch_set_force, w, a, force);
    lr_batch_contact contact = initialised(lr_batch_contact_init);
    contact.friction = 0.8f;
    twice(&lr_batch_set_contact, w, b, contact);
    REQUIRE(lr_batch_set_divergence_policy(w, b, LR_DIVERGENCE_FREEZE) == LR_OK);
    CHECK(lr_batch_set_divergence_policy(w, b, 99) == LR_ERROR_INVALID_ARGUMENT);
    REQUIRE(lr_batch_set_body_contact(w, b, b, 1) == LR_OK);
    CHECK(lr_batch_set_body_contact(w, b, b, 7) == LR_ERROR_INVALID_ARGUMENT);
    lr_emitter_desc emitter = initialised(lr_emitter_desc_init);
    emitter.rate = 100.0f;
    emitter.speed_max = 1.0f;
    twice(&lr_batch_set_emitter, w, a, emitter);
    lr_batch_rules rules = initialised(lr_batch_rules_init);
    rules.max_age = 0.2f;
    rules.action = LR_END_RESPAWN;
    twice(&lr_batch_set_rules, w, a, rules);
    lr_body spawned[3];
    REQUIRE(lr_batch_spawn(w, a, 3, spawned) == LR_OK);
    REQUIRE(lr_batch_spawn(w, a, 1, nullptr) == LR_OK);
    CHECK(lr_batch_spawn(w, a, 4000000000u, nullptr) == LR_ERROR_CAPACITY);
    const float corner[3] = {-1.0f, 0.5f, 0.0f}, opposite[3] = {1.0f, 1.0f, 0.0f};
    REQUIRE(lr_batch_spawn_box(w, b, corner, opposite, 2, spawned) == LR_OK);
    REQUIRE(lr_batch_spawn_box(w, b, corner, opposite, 1, nullptr) == LR_OK);
    CHECK(lr_batch_spawn_box(w, b, opposite, corner, 1, spawned) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(lr_batch_spawn_box(w, b, corner, opposite, 4000000000u, nullptr) == LR_ERROR_CAPACITY);

    const Triangles sheet = bumpy_sheet(6, 3);
    const std::vector<float> heights(25, -1.5f);
    std::vector<float> points = tetrahedron(0.3f);
    points.insert(points.end(), {0.05f, 0.05f, 0.05f}); // inside: not a corner of the hull
    lr_collider_desc solids[4] = {mesh_collider(sheet), heightfield_collider(heights, 5, 1.0f), hull_collider(points),
                                  collider_desc(LR_COLLIDER_SPHERE)};
    solids[3].size[0] = 0.4f;
    solids[3].position[1] = -0.5f;
    lr_collider colliders[4];
    REQUIRE(lr_collider_create(w, solids, 4, colliders) == LR_OK);
    solids[2].vertex_count = 1000000000; // not read
    CHECK(lr_collider_create(w, solids, 4, nullptr) == LR_ERROR_INVALID_ARGUMENT);
    lr_collider_motion motion = initialised(lr_collider_motion_init);
    motion.collider = colliders[3];
    motion.position[1] = -0.4f;
    REQUIRE(lr_collider_move(w, &motion, 1) == LR_OK);
    const lr_material rough = initialised(lr_material_init);
    REQUIRE(lr_collider_set_material(w, colliders, 3, &rough) == LR_OK);

    for (int i = 0; i < 12; ++i) {
        lr_body_force push = initialised(lr_body_force_init);
        push.body = plates[static_cast<size_t>(i) % 10];
        push.force[1] = 0.001f;
        REQUIRE(lr_body_add_force(w, &push, 1) == LR_OK);
        lr_batch_view view = view_of(world, b);
        std::vector<float> strided(2 * view.count, 1e-4f);
        lr_force_arrays arrays = initialised(lr_force_arrays_init);
        arrays.count = view.count;
        arrays.stride = 8;
        arrays.force[0] = arrays.force[1] = arrays.force[2] = strided.data();
        REQUIRE(lr_batch_add_forces(w, b, &arrays) == LR_OK);
        arrays.count = 4000000000u;
        CHECK(lr_batch_add_forces(w, b, &arrays) == LR_ERROR_INVALID_ARGUMENT);
        steps(world, 1, 1.0f / 60.0f, 2);
        CHECK(lr_world_step(w, -1.0f, 2) == LR_ERROR_TIMESTEP_NEGATIVE);
        if (i == 4) REQUIRE(lr_body_set_sleep(w, plates.data(), 4, LR_SLEEP_ASLEEP) == LR_OK);
        if (i == 6) {
            const float low[3] = {-9.0f, -9.0f, -9.0f}, high[3] = {0.3f, 9.0f, 9.0f};
            REQUIRE(lr_world_wake_box(w, low, high, nullptr) == LR_OK);
        }
        if (i == 8) {
            const std::vector<unsigned char> snapshot = snapshot_of(world);
            steps(world, 2, 1.0f / 60.0f, 2);
            REQUIRE(lr_world_snapshot_restore(w, snapshot.data(), snapshot.size()) == LR_OK);
            CHECK(lr_world_snapshot_restore(w, snapshot.data(), 100) == LR_ERROR_SNAPSHOT_FORMAT);
        }
        if (i == 9) {
            REQUIRE(lr_collider_destroy(w, colliders, 1) == LR_OK);
            CHECK(lr_collider_destroy(w, colliders, 1) == LR_ERROR_STALE_COLLIDER);
        }
    }
}

lr_world_desc seeded() {
    lr_world_desc d = world_desc();
    d.seed = 99;
    d.fluid_viscosity = 1.6e-5f;
    return d;
}

} // namespace

TEST_CASE("calls that change a world are recorded, rightly made or not, and played to the same hash") {
    const Asset flat = leaf(), plate = make(rigid_plate());
    const World plain = make(seeded()), world = make(seeded());
    do_everything(plain, flat, plate, nullptr);
    Recording recording;
    do_everything(world, flat, plate, &recording);
    const uint64_t expected = hash_of(world);
    CHECK(hash_of(plain) == expected); // recording does not change the motion
    const Held held = held_in(recording.bytes);
    CHECK(held.refused.size() >= 25);
    CHECK(held.answers >= 12);
    CHECK(held.blobs >= 4); // samples, the table once for both arrays, mesh, ...
    CHECK(held.assets == 2);
    for (int32_t simd : simd_targets())
        for (uint32_t workers : {0u, 3u}) {
            std::ostringstream text;
            lr::replay::Options options;
            options.simd = simd;
            options.workers = workers;
            options.print = &text;
            const lr::replay::Outcome played = recording.play(options);
            CHECK(wrong_in(played) == "");
            CHECK(played.hash == expected);
            CHECK(played.steps == 14);
            CHECK(played.unread >= 8);
            CHECK(played.calls == held.calls.size());
        }
    // From the middle: with a hole among the batches, pending forces, events, callbacks, and all data that snapshots only refer to.
    Recording second;
    REQUIRE(lr_world_record_stop(world.get()) == LR_OK);
    second.start(world);
    steps(plain, 5, 0.02f, 3);
    steps(world, 5, 0.02f, 3);
    CHECK(hash_of(plain) == hash_of(world));
    const lr::replay::Outcome played = second.play();
    CHECK(wrong_in(played) == "");
    CHECK(played.hash == hash_of(world));
    CHECK(played.first_step == 14 - 2);
}

namespace {

void record_and_play(const char* name, const std::function<void(Stage&)>& call_once) {
    // These calls change nothing in a recording.
    for (const char* not_recorded : {"lr_world_record_start", "lr_world_record_stop"})
        if (std::strcmp(name, not_recorded) == 0) return;
    Stage stage;
    Recording recording;
    recording.start(stage.place);
    call_once(stage);
    steps(stage.place, 2, 0.02f);
    const Held held = held_in(recording.bytes);
    CHECK(has(held.calls, name));
    std::ostringstream text;
    lr::replay::Options options;
    options.print = &text;
    const lr::replay::Outcome played = recording.play(options);
    CHECK(wrong_in(played) == "");
    CHECK(played.hash == hash_of(stage.place));
    CHECK(text.str().find(std::string(" ") + name + "(") != std::string::npos);
}
template <class... P, class... A>
void record_and_play(const char* name, lr_status (*function)(lr_world*, P...), std::tuple<A...> (*arguments)(Stage&)) {
    record_and_play(name, [=](Stage& stage) { call(function, arguments(stage)); });
}
template <class Function, class Arguments> void record_and_play(const char*, Function, Arguments) {} // a query

} // namespace

TEST_CASE("every function that changes a world is recorded and played alone"){
#define LR_CALL(name, ...)                                                                                             \
    SUBCASE(#name) {                                                                                                   \
        record_and_play(                                                                                               \
            #name, &(name), +[](Stage& s) { return std::tuple(__VA_ARGS__); });                                        \
    }
#define LR_PLAIN_CALL LR_CALL
#include "api/calls.inc"
#undef LR_PLAIN_CALL
#undef LR_CALL
}

TEST_CASE("a difference is found at its step: a body's place, a status, an id") {
    const Asset flat = leaf();
    const World world = make(seeded());
    Recording recording;
    recording.start(world);
    const lr_batch batch = add_batch(world, flat, 4);
    const lr_body body = add_body(world, batch, body_desc());
    steps(world, 3, 0.01f);
    // Impossible through the API: a recording whose third step differs.
    const std::vector<unsigned char> good = recording.bytes;
    const auto resealed = [&](uint64_t which_step, size_t at, unsigned char change) {
        std::vector<unsigned char> bytes = good;
        size_t place = sizeof(lr::recording::FileHeader);
        uint64_t steps_seen = 0;
        for (uint64_t frame = 0; place < bytes.size(); ++frame) {
            lr::recording::FrameHeader h;
            std::memcpy(&h, bytes.data() + place, sizeof h);
            unsigned char* const payload = bytes.data() + place + sizeof h;
            uint16_t op = 0;
            std::memcpy(&op, payload, 2);
            if (h.kind == static_cast<uint16_t>(Kind::result) && op == lr::recording::op_of("lr_world_step") &&
                ++steps_seen == which_step)
                payload[at] ^= change;
            h.checksum = lr::recording::frame_checksum(h, frame, payload);
            std::memcpy(bytes.data() + place, &h, sizeof h);
            place += sizeof h + h.size;
        }
        lr::replay::Options options;
        return lr::replay::play(bytes.data(), bytes.size(), options);
    };
    CHECK_FALSE(resealed(2, 0, 0).difference);
    const lr::replay::Outcome other_hash = resealed(2, offsetof(lr::recording::ResultRecord, hash), 1);
    REQUIRE(other_hash.difference);
    CHECK(other_hash.difference->step == 2);
    CHECK(other_hash.difference->call == 4); // batch, body, step, step
    CHECK(other_hash.difference->what.find("hash") != std::string::npos);
    const lr::replay::Outcome other_status = resealed(3, offsetof(lr::recording::ResultRecord, status), 0x80);
    REQUIRE(other_status.difference);
    CHECK(other_status.difference->step == 3);
    CHECK(other_status.difference->what.find("returned") != std::string::npos);
    std::ostringstream csv;
    lr::replay::Options options;
    options.csv = &csv;
    options.body = body;
    options.until = 2;
    const lr::replay::Outcome two = lr::replay::play(good.data(), good.size(), options);
    CHECK(two.steps == 2);
    const std::string text = csv.str();
    CHECK(std::count(text.begin(), text.end(), '\n') == 3);
}

TEST_CASE("a writer that refuses ends the recording at any call, and not the world") {
    const Asset flat = leaf();
    Recording whole;
    const auto play = [&](Recording& recording, std::vector<std::string>& told, lr_status& stopped) {
        lr_world_desc d = seeded();
        d.log_user = &told;
        d.log = [](void* user, int32_t, const char* text) {
            static_cast<std::vector<std::string>*>(user)->emplace_back(text);
        };
        const World world = make(d);
        const lr_recording_desc rd = recording.desc();
        const lr_status started = lr_world_record_start(world.get(), &rd);
        const lr_batch batch = add_batch(world, flat, 4);
        for (int i = 0; i < 3; ++i) add_body(world, batch, body_desc());
        steps(world, 4, 0.01f);
        stopped = lr_world_record_stop(world.get());
        if (started != LR_OK) CHECK(stopped == LR_ERROR_INVALID_ARGUMENT);
        return hash_of(world);
    };
    std::vector<std::string> told;
    lr_status stopped = 0;
    const uint64_t expected = play(whole, told, stopped);
    CHECK(stopped == LR_OK);
    CHECK(told.empty());
    for (uint64_t at = 0; at < whole.calls; ++at) {
        CAPTURE(at);
        Recording broken;
        broken.refuse_at = at;
        told.clear();
        CHECK(play(broken, told, stopped) == expected);
        CHECK(broken.calls == at + 1); // it is not called again
        CHECK(stopped == LR_ERROR_INVALID_ARGUMENT);
        CHECK(told.size() == 2);
        CHECK(std::equal(broken.bytes.begin(), broken.bytes.end(), whole.bytes.begin()));
    }
}

TEST_CASE("a recording cut by a crash is played up to its last whole record") {
    const Asset flat = leaf();
    const World world = make(seeded());
    Recording recording;
    recording.start(world);
    const size_t begun = recording.bytes.size();
    const lr_batch batch = add_batch(world, flat, 4);
    add_body(world, batch, body_desc());
    steps(world, 3, 0.01f);
    uint64_t most = 0;
    for (size_t size = begun; size < recording.bytes.size(); ++size) {
        const lr::replay::Outcome played = lr::replay::play(recording.bytes.data(), size, {});
        CHECK(wrong_in(played) == "");
        CHECK(played.calls >= most);
        most = std::max(most, played.calls);
    }
    CHECK(most == 5);
    const lr::replay::Outcome within = lr::replay::play(recording.bytes.data(), recording.bytes.size() - 20, {});
    CHECK(within.within == "lr_world_step");
    for (size_t size = 0; size < begun; size += 7) {
        const std::vector<unsigned char> part(recording.bytes.begin(),
                                              recording.bytes.begin() + static_cast<std::ptrdiff_t>(size));
        CHECK(fault_of(part) != 0);
    }
}

TEST_CASE("callbacks that are not recorded are said to be missing where they are asked") {
    const Asset flat = leaf();
    const World world = make(seeded());
    const lr_batch batch = add_batch(world, flat, 4);
    add_body(world, batch, body_desc());
    Recording recording;
    lr_recording_desc d = recording.desc();
    d.flags = 0;
    REQUIRE(lr_world_record_start(world.get(), &d) == LR_OK);
    steps(world, 2, 0.01f);
    const auto wind = [](void*, const lr_wind_query* q) { q->velocity[0][0] = 1.0f; };
    REQUIRE(lr_world_set_wind_callback(world.get(), wind, nullptr) == LR_OK);
    CHECK(fault_of(recording.bytes) == 0);
    steps(world, 1, 0.01f);
    CHECK(fault_of(recording.bytes) == static_cast<int>(lr::replay::FaultId::callback));
    CHECK(fault_of(recording.bytes, 2) == 0);
}

TEST_CASE("wrong ways to begin and end are refused") {
    const World world = make(world_desc());
    Recording recording;
    lr_recording_desc d = recording.desc();
    CHECK(lr_world_record_start(world.get(), nullptr) == LR_ERROR_NULL_ARGUMENT);
    CHECK(lr_world_record_start(nullptr, &d) == LR_ERROR_NULL_ARGUMENT);
    CHECK(lr_world_record_stop(nullptr) == LR_ERROR_NULL_ARGUMENT);
    CHECK(lr_world_record_stop(world.get()) == LR_ERROR_INVALID_ARGUMENT);
    d.flags = 2;
    CHECK(lr_world_record_start(world.get(), &d) == LR_ERROR_INVALID_ARGUMENT);
    d = recording.desc();
    d.reserved = 1;
    CHECK(lr_world_record_start(world.get(), &d) == LR_ERROR_INVALID_ARGUMENT);
    d = recording.desc();
    d.write = nullptr;
    CHECK(lr_world_record_start(world.get(), &d) == LR_ERROR_NULL_ARGUMENT);
    d = recording.desc();
    d.struct_size = 8;
    CHECK(lr_world_record_start(world.get(), &d) == LR_ERROR_STRUCT_SIZE);
    CHECK(recording.bytes.empty());
    d = recording.desc();
    CHECK(lr_world_record_start(world.get(), &d) == LR_OK);
    CHECK(lr_world_record_start(world.get(), &d) == LR_ERROR_INVALID_ARGUMENT);
    CHECK(lr_world_record_stop(world.get()) == LR_OK);
    CHECK(lr_world_record_stop(world.get()) == LR_ERROR_INVALID_ARGUMENT);
}

TEST_CASE("memory for a recording that is not there is a status, and all is given back") {
    const Asset flat = leaf();
    CountingAllocator memory;
    {
        lr_world_desc d = seeded();
        d.allocator = memory.callbacks();
        const World world = make(d);
        add_body(world, add_batch(world, flat, 4), body_desc());
        const uint64_t before = hash_of(world);
        const size_t blocks = memory.live();
        Recording recording;
        const lr_recording_desc rd = recording.desc();
        uint64_t failed = 0;
        for (lr_status status = LR_ERROR_OUT_OF_MEMORY; status != LR_OK; ++failed) {
            REQUIRE(failed < 20);
            recording.bytes.clear();
            memory.fail_at = memory.calls + failed;
            status = lr_world_record_start(world.get(), &rd);
            if (status != LR_OK) {
                CHECK(status == LR_ERROR_OUT_OF_MEMORY);
                CHECK(memory.live() == blocks);
            }
        }
        memory.fail_at = CountingAllocator::never;
        CHECK(failed >= 5);
        const uint64_t calls = memory.calls;
        steps(world, 3, 0.01f);
        CHECK(memory.calls == calls); // recording a step allocates nothing
        CHECK(hash_of(world) != before);
        CHECK(wrong_in(recording.play()) == "");
    }
    CHECK(memory.live() == 0);
    CHECK_FALSE(memory.mismatch);
}

TEST_CASE("calls that are refused for want of memory while they are recorded change nothing, and are not played") {
    CountingAllocator memory;
    uint64_t refused = 0;
    for (bool refuse : {false, true}) {
        lr_world_desc d = seeded();
        d.allocator = memory.callbacks();
        const World world = make(d);
        lr_world* const w = world.get();
        Recording recording;
        recording.start(world);
        // Repeatedly, each time with memory for one more piece.
        const auto insist = [&](auto&& call) {
            lr_status status = LR_ERROR_OUT_OF_MEMORY;
            for (uint64_t pieces = 0; status == LR_ERROR_OUT_OF_MEMORY; ++pieces) {
                const uint64_t before = hash_of(world);
                memory.fail_at = refuse ? memory.calls + pieces : CountingAllocator::never;
                status = call();
                memory.fail_at = CountingAllocator::never;
                if (status == LR_OK) break;
                CHECK(hash_of(world) == before);
                ++refused;
            }
            CHECK(status == LR_OK);
        };
        std::vector<lr_batch> batches(20);
        for (size_t i = 0; i < batches.size(); ++i) {
            const Asset asset = make(ellipsoid(0.1 + 0.01 * static_cast<double>(i), 0.1, 0.1, 300.0));
            lr_batch_desc b = batch_desc();
            b.asset = asset.get();
            b.capacity = 4;
            insist([&] {
                const lr_status status = lr_batch_create(w, &b, &batches[i]);
                CHECK((batches[i].id != 0) == (status == LR_OK));
                return status;
            });
        }
        for (float y : {0.0f, 0.05f}) {
            lr_body_desc body = body_desc();
            body.position[1] = y;
            insist([&] { return lr_body_create(w, batches[0], &body, 1, nullptr); });
        }
        insist([&] { return lr_batch_set_body_contact(w, batches[0], batches[0], 1); });
        const lr_collider_desc plane = collider_desc(LR_COLLIDER_PLANE);
        insist([&] { return lr_collider_create(w, &plane, 1, nullptr); });
        const std::vector<unsigned char> saved = snapshot_of(world);
        steps(world, 3, 0.01f);
        insist([&] { return lr_world_snapshot_restore(w, saved.data(), saved.size()); });
        steps(world, 2, 0.01f);
        CHECK(wrong_in(recording.play()) == "");
        if (!refuse) continue;
        // A step that continued without memory cannot be replayed: lr_replay says why.
        lr_body_desc body = body_desc();
        insist([&] { return lr_body_create(w, batches[1], &body, 1, nullptr); });
        insist([&] { return lr_batch_set_body_contact(w, batches[0], batches[1], 1); });
        memory.fail_at = memory.calls;
        memory.fail_after = true;
        REQUIRE(lr_world_step(w, 0.01f, 1) == LR_ERROR_OUT_OF_MEMORY);
        memory.fail_at = CountingAllocator::never;
        memory.fail_after = false;
        CHECK(
            wrong_in(recording.play()).find("lr_world_step returned -5 (out of memory: the allocator returned null)") !=
            std::string::npos);
    }
    CHECK(refused > 30);
    CHECK(memory.live() == 0);
}
