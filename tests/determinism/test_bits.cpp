// The same bits for all instruction sets, workers, orders in memory, snapshots, other batches and divisions of time.
#include "support/determinism_scenes.h"
#include "support/random.h"
#include "support/threads.h"

#include <algorithm>
#include <string>

using namespace test;

TEST_CASE("every scene ends in the same bits on every instruction set" * doctest::test_suite("exact")) {
    for (const PlayedScene& scene : played_scenes()) {
        CAPTURE(std::string(scene.name));
        const uint64_t expected = outcome(scene);
        for (int32_t target : simd_targets()) { // includes the present target
            CAPTURE(std::string(lr_simd_target_name(target)));
            CHECK(outcome(scene, {.simd = target}) == expected);
        }
    }
}

TEST_CASE("every instruction set is named") {
    std::string names;
    for (int32_t target : simd_targets()) {
        CHECK(std::string(lr_simd_target_name(target)) != "unknown");
        names += std::string(names.empty() ? "" : ", ") + lr_simd_target_name(target);
    }
    MESSAGE("instruction sets: " << names); // scripts/check_determinism.sh reports them
    CHECK(!names.empty());
}

static void check_workers(std::initializer_list<uint32_t> counts) {
    for (const PlayedScene& scene : played_scenes()) {
        CAPTURE(std::string(scene.name));
        const uint64_t expected = outcome(scene);
        for (uint32_t workers : counts) {
            CAPTURE(workers);
            CHECK(outcome(scene, {.workers = workers}) == expected);
        }
    }
}

TEST_CASE("every scene ends in the same bits with workers") {
    check_workers({3});
}

TEST_CASE("every scene ends in the same bits with any number of workers" * doctest::test_suite("long-exact")) {
    check_workers({1, 2, 8, 40});
}

static void check_orders(std::initializer_list<Circumstances> all) {
    for (const PlayedScene& scene : played_scenes()) {
        CAPTURE(std::string(scene.name));
        const uint64_t expected = outcome(scene);
        for (const Circumstances& circumstances : all) CHECK(outcome(scene, circumstances) == expected);
    }
}

TEST_CASE("every scene ends in the same bits in any order of bodies and through a snapshot" *
          doctest::test_suite("exact")) {
    check_orders({{.simd = simd_targets().back(),
                   .workers = LR_TEST_THREADS ? 2u : 0u,
                   .permuted = true,
                   .through_snapshot = true}});
}

TEST_CASE("every scene ends in the same bits in any order of bodies, and through a snapshot, each alone" *
          doctest::test_suite("long-exact")) {
    check_orders({{.permuted = true}, {.through_snapshot = true}});
}

TEST_CASE("the hash sees one bit of one field of one body, and each of its fields") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 50);
    std::vector<lr_body> ids;
    for (int i = 0; i < 40; ++i) {
        lr_body_desc d = body_desc();
        for (float& x : d.position) x = 1.0f;
        for (float& v : d.linear_velocity) v = 1.0f;
        for (float& w : d.angular_velocity) w = 1.0f;
        d.age = 1.0f;
        ids.push_back(add_body(world, batch, d));
    }
    const uint64_t before = hash_of(world);
    const lr_body_state good = state_of(world, ids[23]);
    std::vector<uint64_t> hashes = {before};
    const size_t floats[] = {offsetof(lr_body_state, position),
                             offsetof(lr_body_state, position) + 8,
                             offsetof(lr_body_state, linear_velocity),
                             offsetof(lr_body_state, linear_velocity) + 4,
                             offsetof(lr_body_state, angular_velocity),
                             offsetof(lr_body_state, angular_velocity) + 8,
                             offsetof(lr_body_state, scale),
                             offsetof(lr_body_state, age)};
    for (size_t at : floats) {
        lr_body_state s = good;
        uint32_t bits = 0;
        std::memcpy(&bits, reinterpret_cast<unsigned char*>(&s) + at, 4);
        ++bits;
        std::memcpy(reinterpret_cast<unsigned char*>(&s) + at, &bits, 4);
        REQUIRE(lr_body_set_state(world.get(), ids[23], &s) == LR_OK);
        hashes.push_back(hash_of(world));
    }
    lr_body_state turned = good;
    turned.orientation[0] = 1e-3f;
    REQUIRE(lr_body_set_state(world.get(), ids[23], &turned) == LR_OK);
    hashes.push_back(hash_of(world));
    REQUIRE(lr_body_set_state(world.get(), ids[23], &good) == LR_OK);
    CHECK(hash_of(world) == before);
    REQUIRE(lr_body_destroy(world.get(), &ids[5], 1) == LR_OK);
    hashes.push_back(hash_of(world));
    std::sort(hashes.begin(), hashes.end());
    CHECK(std::unique(hashes.begin(), hashes.end()) == hashes.end());
}

TEST_CASE("a body moves the same in any company") {
    const Asset assets[] = {leaf(), curled_leaf()};
    const auto states = [&](uint32_t count, uint32_t workers) {
        lr_world_desc wd = world_desc();
        wd.worker_count = workers;
        const World world = make(wd);
        std::vector<lr_body_state> out;
        for (const Asset& asset : assets) {
            const lr_batch batch = add_batch(world, asset, count);
            std::vector<lr_body_desc> descs;
            for (uint32_t i = 0; i < count; ++i) {
                Random random(i);
                lr_body_desc d = turned_anyhow(random);
                d.noise_seed = i + 1;
                descs.push_back(d);
            }
            std::vector<lr_body> ids(count);
            REQUIRE(lr_body_create(world.get(), batch, descs.data(), count, ids.data()) == LR_OK);
            steps(world, 3, 1.0f / 60.0f, 4);
            for (uint32_t i : {0u, 14u, 15u, 16u, 999u})
                if (i < count) out.push_back(state_of(world, ids[i]));
            // The second batch begins later: its noise must be that of the world's time, so end the first.
            REQUIRE(lr_batch_destroy(world.get(), batch) == LR_OK);
        }
        return out;
    };
    const std::vector<lr_body_state> reference = states(5000, 0);
    REQUIRE(reference.size() == 10);
    for (uint32_t count : {1u, 15u, 16u, 17u, 1000u, 1024u, 1025u, 5000u})
        for (uint32_t workers : {0u, 2u}) {
            const std::vector<lr_body_state> got = states(count, workers);
            const size_t each = got.size() / 2;
            for (size_t i = 0; i < each; ++i) {
                CAPTURE(count);
                CHECK(same_bits(got[i], reference[i]));
                CHECK(same_bits(got[each + i], reference[5 + i]));
            }
        }
}

// Without rounding between steps: still fluid, and a length that is a power of two, which scales spins.
TEST_CASE("steps of several substeps are as many steps of one") {
    lr_ellipsoid_desc shape = ellipsoid(0.03125, 0.0125, 0.0002, 700.0);
    for (double offset : {0.0, 0.005})
        for (int32_t integrator : {LR_INTEGRATOR_RK4, LR_INTEGRATOR_DEFAULT})
            for (int32_t clock : {LR_CLOCK_SPEED, LR_CLOCK_AGE}) {
                shape.center_of_mass[0] = offset;
                const Asset asset = make(shape);
                const auto run = [&](int count, uint32_t substeps) {
                    const World world = make(world_desc());
                    lr_batch_desc bd = batch_desc();
                    bd.integrator = integrator;
                    bd.clock = clock;
                    const lr_batch batch = add_batch(world, bd, asset, 20);
                    for (uint32_t i = 0; i < 20; ++i) {
                        Random random(i);
                        lr_body_desc d = turned_anyhow(random);
                        for (float& v : d.linear_velocity) v = random.real(-1.0, 1.0);
                        add_body(world, batch, d);
                    }
                    steps(world, count, static_cast<float>(substeps) / 256.0f, substeps);
                    return hash_of(world);
                };
                CAPTURE(integrator);
                CAPTURE(clock);
                const uint64_t expected = run(64, 1);
                CHECK(run(16, 4) == expected);
                CHECK(run(4, 16) == expected);
                CHECK(run(1, 64) == expected);
            }
}

TEST_CASE("changing the instruction set between steps changes nothing") {
    const std::vector<int32_t> targets = simd_targets();
    const PlayedScene scene = played_scenes()[0];
    Play steady(scene, {}), changing(scene, {});
    for (size_t frame = 0; frame < 20; ++frame) {
        REQUIRE(lr_world_set_simd_target(changing.world.get(), targets[frame % targets.size()]) == LR_OK);
        steps(steady.world, 1, 1.0f / 60.0f, 3);
        steps(changing.world, 1, 1.0f / 60.0f, 3);
    }
    CHECK(hash_of(steady.world) == hash_of(changing.world));
}

#if LR_TEST_THREADS
TEST_CASE("worlds that step at the same time on threads of their own do not disturb each other") {
    const PlayedScene scene = played_scenes()[0];
    const uint64_t expected = outcome(scene);
    constexpr size_t count = 4;
    std::vector<std::unique_ptr<Play>> plays;
    for (size_t i = 0; i < count; ++i)
        plays.push_back(std::make_unique<Play>(scene, Circumstances{.workers = i % 2 ? 1u : 0u}));
    uint64_t hashes[count] = {};
    {
        std::vector<std::jthread> threads;
        for (size_t i = 0; i < count; ++i) threads.emplace_back([&, i] { hashes[i] = plays[i]->run(); });
    }
    for (uint64_t hash : hashes) CHECK(hash == expected);
}
#endif
