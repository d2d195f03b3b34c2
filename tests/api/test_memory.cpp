#include "support/colliders.h"
#include "support/counting_memory.h"
#include "support/water.h"

#include <functional>

using namespace test;

namespace {

// Makes nearly every call that can allocate, and stops at the first error.
struct Scenario {
    lr_world* world = nullptr;
    std::vector<unsigned char> snapshot; // taken in advance, so that only the library allocates

    lr_status run(const lr_world_desc& desc, const lr_asset* asset) {
        lr_status status = lr_world_create(&desc, &world);
        if (status != LR_OK) return status;
        lr_batch_desc bd = batch_desc();
        bd.asset = asset;
        bd.capacity = 100;
        lr_batch batch{};
        for (int i = 0; i < 12; ++i) // over the first size of the batch table
            if ((status = lr_batch_create(world, &bd, &batch)) != LR_OK) return status;
        std::vector<lr_body_desc> descs(30, body_desc());
        std::vector<lr_body> ids(30);
        if ((status = lr_body_create(world, batch, descs.data(), 30, ids.data())) != LR_OK) return status;
        const float samples[3] = {1.0f, 2.0f, 3.0f};
        lr_turbulence_table t = table_desc();
        t.count = 3;
        t.chi = t.epsilon = samples;
        t.dt = t.u0 = t.l = 1.0f;
        if ((status = lr_batch_set_turbulence_table(world, batch, &t)) != LR_OK) return status;
        lr_body_force f = initialised(lr_body_force_init);
        f.body = ids[3];
        f.force[1] = 1e-3f;
        if ((status = lr_body_add_force(world, &f, 1)) != LR_OK) return status;
        const lr_emitter_desc e = initialised(lr_emitter_desc_init);
        if ((status = lr_batch_set_emitter(world, batch, &e)) != LR_OK) return status;
        lr_batch_rules r = initialised(lr_batch_rules_init);
        r.max_age = 0.005f;
        r.action = LR_END_RESPAWN;
        if ((status = lr_batch_set_rules(world, batch, &r)) != LR_OK) return status;
        lr_collider_desc solid[3] = {sphere_collider(1.0f), sphere_collider(2.0f), collider_desc(LR_COLLIDER_PLANE)};
        lr_collider colliders[3] = {};
        if ((status = lr_collider_create(world, solid, 3, colliders)) != LR_OK) return status;
        const lr_collider_motion motion = motion_of(colliders[1], LR_MOVE_TO);
        if ((status = lr_collider_move(world, &motion, 1)) != LR_OK) return status;
        snapshot.resize(lr_world_snapshot_size(world));
        if ((status = lr_world_snapshot_save(world, snapshot.data(), snapshot.size(), nullptr)) != LR_OK) return status;
        if ((status = lr_batch_set_turbulence_table(world, batch, nullptr)) != LR_OK) return status;
        if ((status = lr_body_set_sleep(world, ids.data(), 20, LR_SLEEP_ASLEEP)) != LR_OK) return status;
        if ((status = lr_world_step(world, 0.01f, 2)) != LR_OK) return status;
        if ((status = lr_world_snapshot_restore(world, snapshot.data(), snapshot.size())) != LR_OK) return status;
        return lr_batch_destroy(world, batch);
    }
};

} // namespace

TEST_CASE("a world takes all its memory from its allocator and gives all of it back" * doctest::test_suite("native")) {
    CountingAllocator memory;
    lr_world_desc d = world_desc();
    d.allocator = memory.callbacks();
    const Asset asset = leaf();
    Scenario s;
    const uint64_t before = global_allocations;
    CHECK(s.run(d, asset.get()) == LR_OK);
    // The test's own: two vectors of descs and ids and the snapshot. The library makes none.
    if (counts_global) CHECK(global_allocations - before == 3);
    CHECK(memory.live() > 50);
    {
        const World world(s.world);
        CHECK(info_of(world).memory_bytes == memory.bytes);
    }
    CHECK(memory.live() == 0);
    CHECK(memory.bytes == 0);
    CHECK_FALSE(memory.mismatch);
}

TEST_CASE("the n-th allocation fails, for every n: out of memory, nothing leaks, nothing changes" *
          doctest::test_suite("native")) {
    const Asset asset = leaf();
    uint64_t total = 0;
    {
        CountingAllocator memory;
        lr_world_desc d = world_desc();
        d.allocator = memory.callbacks();
        Scenario s;
        REQUIRE(s.run(d, asset.get()) == LR_OK);
        total = memory.calls;
        lr_world_destroy(s.world);
    }
    REQUIRE(total > 50);
    for (bool after : {false, true})
        for (uint64_t n = 0; n < total; ++n) {
            CAPTURE(n);
            CountingAllocator memory;
            memory.fail_at = n;
            memory.fail_after = after;
            lr_world_desc d = world_desc();
            d.allocator = memory.callbacks();
            Scenario s;
            CHECK(s.run(d, asset.get()) == LR_ERROR_OUT_OF_MEMORY);
            if (s.world) {
                // Still usable: queries, steps and, with memory again, creation work.
                memory.fail_at = CountingAllocator::never;
                CHECK(lr_world_step(s.world, 0.01f, 1) == LR_OK);
                lr_batch_desc bd = batch_desc();
                bd.asset = asset.get();
                bd.capacity = 3;
                lr_batch batch{};
                CHECK(lr_batch_create(s.world, &bd, &batch) == LR_OK);
                lr_world_destroy(s.world);
            }
            CHECK(memory.live() == 0);
            CHECK_FALSE(memory.mismatch);
        }
}

TEST_CASE("running out of memory leaves tables and snapshots as they were") {
    CountingAllocator memory;
    lr_world_desc d = world_desc();
    d.allocator = memory.callbacks();
    const Asset asset = leaf();
    const World world = make(d);
    const lr_batch batch = add_batch(world, asset, 10);
    add_body(world, batch, body_desc());
    const std::vector<unsigned char> before = snapshot_of(world);
    const float samples[2] = {1.0f, 2.0f};
    lr_turbulence_table t = table_desc();
    t.count = 2;
    t.chi = t.epsilon = samples;
    t.dt = t.u0 = t.l = 1.0f;
    memory.fail_at = 0;
    memory.fail_after = true;
    CHECK(lr_batch_set_turbulence_table(world.get(), batch, &t) == LR_ERROR_OUT_OF_MEMORY);
    CHECK(lr_batch_set_turbulence_table(world.get(), batch, nullptr) == LR_ERROR_OUT_OF_MEMORY);
    CHECK(snapshot_of(world) == before);
    memory.fail_at = CountingAllocator::never;
    REQUIRE(lr_batch_set_turbulence_table(world.get(), batch, &t) == LR_OK);
    const std::vector<unsigned char> with_table = snapshot_of(world);
    memory.fail_at = 0;
    CHECK(lr_world_snapshot_restore(world.get(), before.data(), before.size()) == LR_ERROR_OUT_OF_MEMORY);
    CHECK(snapshot_of(world) == with_table);
}

TEST_CASE("a step, a hash, a view and transforms allocate nothing, with and without workers") {
    for (uint32_t workers : {0u, 2u}) {
        CountingAllocator memory;
        lr_world_desc d = world_desc();
        d.allocator = memory.callbacks();
        d.worker_count = workers;
        const Asset asset = leaf(), other = curled_leaf();
        const World world = make(d);
        const lr_batch batch = add_batch(world, asset, 5000), full = add_batch(world, other, 3000);
        const std::vector<lr_body_desc> descs(5000, body_desc());
        std::vector<lr_body> ids(5000);
        std::vector<float> transforms(5000 * 16);
        lr_batch_view view = initialised(lr_batch_view_init);
        lr_body_state state = body_state();
        uint64_t hash = 0;
        std::vector<unsigned char> snapshot(4 << 20);
        const lr_water_desc water = sea();
        for (const lr_water_desc* first :
             {&water, static_cast<const lr_water_desc*>(nullptr)}) // scratch for steps in water
            REQUIRE(lr_world_set_water(world.get(), first) == LR_OK);
        const uint64_t own = memory.calls, global = global_allocations;
        bool ok = lr_body_create(world.get(), batch, descs.data(), 5000, ids.data()) == LR_OK;
        ok = ok && lr_body_create(world.get(), full, descs.data(), 3000, nullptr) == LR_OK;
        for (int i = 0; i < 5; ++i) {
            if (i == 2) ok = ok && lr_world_set_water(world.get(), &water) == LR_OK;
            ok = ok && lr_world_step(world.get(), 0.01f, 4) == LR_OK;
            ok = ok && lr_world_hash(world.get(), &hash) == LR_OK;
            ok = ok && lr_batch_get_view(world.get(), batch, &view) == LR_OK;
            ok = ok &&
                 lr_batch_write_transforms(world.get(), batch, i % 6, transforms.data(), 0, 5000, nullptr) == LR_OK;
            ok = ok && lr_batch_write_velocities(world.get(), batch, transforms.data(), 0, 5000, nullptr) == LR_OK;
            ok = ok && lr_body_get_state(world.get(), ids[7], &state) == LR_OK;
            ok = ok && lr_body_set_state(world.get(), ids[7], &state) == LR_OK;
            ok = ok && lr_world_snapshot_save(world.get(), snapshot.data(), snapshot.size(), nullptr) == LR_OK;
        }
        ok = ok && lr_body_destroy(world.get(), ids.data(), 5000) == LR_OK;
        CHECK(memory.calls == own);
        CHECK(global_allocations == global);
        CHECK(ok);
    }
}

TEST_CASE("the C library's memory when no allocator is given, and all of it back" * doctest::test_suite("native")) {
    const Asset asset = leaf();
    const uint64_t before = global_live;
    {
        Scenario s;
        CHECK(s.run(world_desc(), asset.get()) == LR_OK);
        if (counts_global) CHECK(global_live > before);
        lr_world_destroy(s.world);
    }
    if (counts_global) CHECK(global_live == before);
}

TEST_CASE("operator new fails anywhere inside the library: a status, and nothing leaks" *
          doctest::test_suite("native") * doctest::skip(!counts_global)) {
    const uint64_t before = global_live;
    const lr_ellipsoid_desc shape = ellipsoid(0.04, 0.01, 0.0001, 800.0);
    lr_world_desc with_workers = world_desc();
    with_workers.worker_count = 2;
    const std::function<lr_status()> calls[] = {
        [&] {
            lr_asset* asset = nullptr;
            const lr_status status = lr_asset_create_ellipsoid(&shape, &asset);
            lr_asset_release(asset);
            return status;
        },
        [&] {
            lr_asset* asset = nullptr;
            const lr_status status = lr_asset_load_file(LR_FIXTURES "/leaf.lrb", &asset);
            lr_asset_release(asset);
            return status;
        },
        [&] {
            lr_world* world = nullptr;
            const lr_status status = lr_world_create(&with_workers, &world);
            lr_world_destroy(world);
            return status;
        },
    };
    for (const auto& call : calls) {
        uint32_t failures = 0;
        for (uint64_t n = 1; n < 10000; ++n) {
            global_fail_in = n;
            const lr_status status = call();
            const bool failed = global_fail_in == 0;
            global_fail_in = 0;
            if (!failed) {
                CHECK(status == LR_OK);
                break;
            }
            ++failures;
            CHECK((status == LR_ERROR_OUT_OF_MEMORY || status == LR_ERROR_THREADS));
            CHECK(global_live == before);
        }
        CHECK(failures > 0);
    }
}

TEST_CASE("a body takes 84 bytes with LANGEVIN loads, 64 of them its state, and 124 with AERODYNAMIC ones") {
    const Asset asset = leaf();
    const auto bytes_a_body = [&](int32_t loads) {
        constexpr uint32_t small = 16000, large = 160000;
        uint64_t bytes[2] = {};
        for (uint32_t capacity : {small, large}) {
            const World world = make(world_desc());
            lr_batch_desc d = batch_desc();
            d.load_model = loads;
            const lr_batch batch = add_batch(world, d, asset, capacity);
            bytes[capacity == large] = info_of(world).memory_bytes;
            // A full and stepped batch allocates no more either.
            const std::vector<lr_body_desc> bodies(capacity, body_desc());
            REQUIRE(lr_body_create(world.get(), batch, bodies.data(), capacity, nullptr) == LR_OK);
            steps(world, 1, 0.01f);
            CHECK(info_of(world).memory_bytes == bytes[capacity == large]);
        }
        REQUIRE((bytes[1] - bytes[0]) % (large - small) == 0);
        return (bytes[1] - bytes[0]) / (large - small);
    };
    CHECK(bytes_a_body(LR_LOADS_NONE) == 84);
    CHECK(bytes_a_body(LR_LOADS_LANGEVIN) == 84);
    CHECK(bytes_a_body(LR_LOADS_AERODYNAMIC) == 124);
}
