// Refused arguments of the force functions.
#include "support/counting_memory.h"
#include "support/scene.h"

#include <cmath>
#include <functional>
#include <limits>

using namespace test;

namespace {

struct Scene {
    Asset asset = leaf();
    World world = make(world_desc());
    lr_batch batch = add_batch(world, asset, 10);
    lr_body id = add_body(world, batch, body_desc());

    lr_body_force good() const {
        lr_body_force f = initialised(lr_body_force_init);
        f.body = id;
        f.force[0] = 1e-3f;
        return f;
    }
};

const float not_finite[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()};

} // namespace

TEST_CASE("forces on bodies are taken all or none") {
    const Scene s;
    lr_world* const w = s.world.get();
    const std::vector<unsigned char> before = snapshot_of(s.world);
    const auto refused = [&](const std::function<void(lr_body_force&)>& spoil, lr_status expected) {
        lr_body_force two[2] = {s.good(), s.good()};
        spoil(two[1]);
        CHECK(lr_body_add_force(w, two, 2) == expected);
        two[0] = s.good();
        two[0].mode = LR_FORCE_MODE_IMPULSE;
        CHECK(lr_body_add_force(w, two, 2) == expected);
        CHECK(snapshot_of(s.world) == before);
    };
    for (float bad : not_finite)
        for (size_t i = 0; i < 3; ++i) {
            refused([&](lr_body_force& f) { f.force[i] = bad; }, LR_ERROR_NOT_FINITE);
            refused([&](lr_body_force& f) { f.torque[i] = bad; }, LR_ERROR_NOT_FINITE);
            refused([&](lr_body_force& f) { f.point[i] = bad; }, LR_ERROR_NOT_FINITE);
        }
    constexpr lr_status invalid = LR_ERROR_INVALID_ARGUMENT;
    refused([](lr_body_force& f) { f.mode = 4; }, invalid);
    refused([](lr_body_force& f) { f.mode = -1; }, invalid);
    refused([](lr_body_force& f) { f.frame = 2; }, invalid);
    refused([](lr_body_force& f) { f.frame = -1; }, invalid);
    refused([](lr_body_force& f) { f.flags = 2; }, invalid);
    refused([](lr_body_force& f) { f.reserved = 1; }, invalid);
    for (int32_t mode :
         {LR_FORCE_MODE_FORCE, LR_FORCE_MODE_ACCELERATION, LR_FORCE_MODE_IMPULSE, LR_FORCE_MODE_VELOCITY}) {
        refused([&](lr_body_force& f) { f.mode = mode, f.force[1] = 1e30f; }, invalid);
        refused([&](lr_body_force& f) { f.mode = mode, f.torque[1] = -1e30f; }, invalid);
    }
    for (int32_t mode : {LR_FORCE_MODE_ACCELERATION, LR_FORCE_MODE_VELOCITY})
        refused([&](lr_body_force& f) { f.mode = mode, f.flags = LR_FORCE_AT_POINT; }, invalid);
    refused([](lr_body_force& f) { f.flags = LR_FORCE_AT_POINT, f.point[1] = 1e30f; }, invalid);
    refused([](lr_body_force& f) { f.body = {}; }, LR_ERROR_STALE_BODY);
    refused([](lr_body_force& f) { ++f.body.id; }, LR_ERROR_STALE_BODY);
    refused([](lr_body_force& f) { f.struct_size += 8; }, LR_ERROR_STRUCT_SIZE);
    const lr_body_force f = s.good();
    CHECK(lr_body_add_force(w, &f, 1) == LR_OK);
    CHECK(snapshot_of(s.world) != before);
}

TEST_CASE("arrays of forces are taken all or none") {
    const Scene s;
    lr_world* const w = s.world.get();
    for (int i = 0; i < 3; ++i) add_body(s.world, s.batch, body_desc());
    const std::vector<unsigned char> before = snapshot_of(s.world);
    float values[5] = {1e-3f, 1e-3f, 1e-3f, 1e-3f, 0.0f};
    const auto with = [&](const std::function<void(lr_force_arrays&)>& spoil) {
        lr_force_arrays a = initialised(lr_force_arrays_init);
        a.count = 4;
        for (const float*& p : a.force) p = values;
        for (const float*& p : a.torque) p = values;
        spoil(a);
        return lr_batch_add_forces(w, s.batch, &a);
    };
    constexpr lr_status invalid = LR_ERROR_INVALID_ARGUMENT;
    CHECK(with([](lr_force_arrays& a) { a.mode = 4; }) == invalid);
    CHECK(with([](lr_force_arrays& a) { a.frame = -1; }) == invalid);
    CHECK(with([](lr_force_arrays& a) { a.stride = 6; }) == invalid);
    CHECK(with([](lr_force_arrays& a) { a.count = 5; }) == invalid);
    CHECK(with([](lr_force_arrays& a) { a.first = 1; }) == invalid);
    CHECK(with([](lr_force_arrays& a) { a.first = 0xffffffffu; }) == invalid);
    CHECK(with([](lr_force_arrays& a) { a.count = 0xffffffffu, a.first = 1; }) == invalid);
    CHECK(with([&](lr_force_arrays& a) {
              a.force[1] = reinterpret_cast<const float*>(reinterpret_cast<const char*>(values) + 1);
              a.count = 1;
          }) == invalid);
    for (int32_t mode : {LR_FORCE_MODE_FORCE, LR_FORCE_MODE_VELOCITY}) {
        for (float bad : not_finite) {
            values[3] = bad;
            CHECK(with([&](lr_force_arrays& a) { a.mode = mode; }) == LR_ERROR_NOT_FINITE);
        }
        values[3] = 1e30f;
        CHECK(with([&](lr_force_arrays& a) { a.mode = mode; }) == invalid);
        values[3] = 1e-3f;
    }
    CHECK(lr_batch_add_forces(w, {}, nullptr) == LR_ERROR_STALE_BATCH);
    CHECK(snapshot_of(s.world) == before);
    CHECK(with([](lr_force_arrays&) {}) == LR_OK);
    CHECK(snapshot_of(s.world) != before);
}

TEST_CASE("a batch's force must be finite and in range") {
    const Scene s;
    lr_world* const w = s.world.get();
    const std::vector<unsigned char> before = snapshot_of(s.world);
    for (size_t i = 0; i < 24; ++i) {
        lr_batch_force f = initialised(lr_batch_force_init);
        auto* const component =
            reinterpret_cast<float*>(reinterpret_cast<unsigned char*>(&f) + offsetof(lr_batch_force, force) + 4 * i);
        for (float bad : not_finite) {
            *component = bad;
            CHECK(lr_batch_set_force(w, s.batch, &f) == LR_ERROR_NOT_FINITE);
        }
        *component = -1.1e9f;
        CHECK(lr_batch_set_force(w, s.batch, &f) == LR_ERROR_INVALID_ARGUMENT);
        CHECK(snapshot_of(s.world) == before);
        *component = 1e-3f;
        CHECK(lr_batch_set_force(w, s.batch, &f) == LR_OK);
        CHECK(snapshot_of(s.world) != before);
        CHECK(lr_batch_set_force(w, s.batch, nullptr) == LR_OK);
        CHECK(snapshot_of(s.world) == before);
    }
    lr_batch_force f = initialised(lr_batch_force_init);
    f.reserved = 1;
    CHECK(lr_batch_set_force(w, s.batch, &f) == LR_ERROR_INVALID_ARGUMENT);
    f.reserved = 0;
    CHECK(lr_batch_set_force(w, {}, &f) == LR_ERROR_STALE_BATCH);
}

TEST_CASE("the first force takes memory, none left is a status, and steps take none") {
    CountingAllocator memory;
    lr_world_desc d = world_desc();
    d.allocator = memory.callbacks();
    const Asset asset = leaf();
    const World world = make(d);
    const lr_batch batch = add_batch(world, asset, 100);
    lr_body_force f = initialised(lr_body_force_init);
    f.body = add_body(world, batch, body_desc());
    const std::vector<unsigned char> before = snapshot_of(world);
    const float zeros[1] = {0.0f};
    lr_force_arrays a = initialised(lr_force_arrays_init);
    a.count = 1;
    for (const float*& p : a.force) p = zeros;
    memory.fail_at = 0;
    memory.fail_after = true;
    CHECK(lr_body_add_force(world.get(), &f, 1) == LR_ERROR_OUT_OF_MEMORY);
    CHECK(lr_batch_add_forces(world.get(), batch, &a) == LR_ERROR_OUT_OF_MEMORY);
    CHECK(snapshot_of(world) == before);
    // These calls have no lasting effect.
    f.mode = LR_FORCE_MODE_IMPULSE;
    CHECK(lr_body_add_force(world.get(), &f, 1) == LR_OK);
    memory.fail_at = CountingAllocator::never;
    f.mode = LR_FORCE_MODE_FORCE;
    CHECK(lr_body_add_force(world.get(), &f, 1) == LR_OK);
    const uint64_t calls = memory.calls;
    for (int i = 0; i < 3; ++i) {
        CHECK(lr_body_add_force(world.get(), &f, 1) == LR_OK);
        CHECK(lr_batch_add_forces(world.get(), batch, &a) == LR_OK);
        steps(world, 1, 0.01f, 2);
    }
    CHECK(memory.calls == calls);
}

TEST_CASE("restoring forces and rules into a world without them takes memory, none left changes nothing") {
    const Asset asset = leaf();
    const auto scene = [&](CountingAllocator& memory, lr_batch& batch) {
        lr_world_desc d = world_desc();
        d.allocator = memory.callbacks();
        World world = make(d);
        batch = add_batch(world, asset, 100);
        return world;
    };
    CountingAllocator memory, other;
    lr_batch batch{}, other_batch{};
    const World from = scene(memory, batch), to = scene(other, other_batch);
    lr_body_force f = initialised(lr_body_force_init);
    f.body = add_body(from, batch, body_desc());
    f.force[0] = 1e-3f;
    REQUIRE(lr_body_add_force(from.get(), &f, 1) == LR_OK);
    const lr_emitter_desc e = initialised(lr_emitter_desc_init);
    REQUIRE(lr_batch_set_emitter(from.get(), batch, &e) == LR_OK);
    const std::vector<unsigned char> snapshot = snapshot_of(from), before = snapshot_of(to);
    uint64_t n = 0;
    for (;; ++n) {
        other.fail_at = other.calls + n;
        const lr_status status = lr_world_snapshot_restore(to.get(), snapshot.data(), snapshot.size());
        if (status == LR_OK) break;
        CHECK(status == LR_ERROR_OUT_OF_MEMORY);
        CHECK(snapshot_of(to) == before);
    }
    CHECK(n > 2);
    CHECK(snapshot_of(to) == snapshot);
}
