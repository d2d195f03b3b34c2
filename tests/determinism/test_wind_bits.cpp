// Wind of every kind at once: the same bits on every instruction set, with any workers, order and snapshots.
#include "support/random.h"
#include "support/wind.h"

#include <algorithm>

using namespace test;

namespace {

struct How {
    int32_t simd = LR_SIMD_AUTO;
    uint32_t workers = 0;
    bool reversed = false, through_snapshot = false, callback = true;
};

// A wind callback with gradient and rate: u = (z sin t, x, 0).
void shear(void*, const lr_wind_query* q) {
    for (uint32_t i = 0; i < q->count; ++i) {
        q->velocity[0][i] = q->position[2][i] * static_cast<float>(q->time);
        q->velocity[1][i] = q->position[0][i] * 0.5f;
        q->rate[0][i] = q->position[2][i];
        q->gradient[2][i] = static_cast<float>(q->time);
        q->gradient[3][i] = 0.5f;
    }
}

World windy(const How& how, const std::vector<float>& samples, lr_batch (&batches)[2], bool add) {
    lr_world_desc wd = world_desc();
    wd.simd_target = how.simd;
    wd.worker_count = how.workers;
    wd.seed = 77;
    World world = make(wd);
    const Asset assets[] = {leaf(), curled_leaf()};
    for (size_t b = 0; b < 2; ++b) {
        lr_batch_desc bd = batch_desc();
        bd.integrator = b ? LR_INTEGRATOR_RK4 : LR_INTEGRATOR_DEFAULT;
        batches[b] = add_batch(world, bd, assets[b], 1500);
    }
    for (const AnySource& d : one_of_each(samples))
        if (add || std::holds_alternative<lr_wind_grid_desc>(d)) add_source(world, d);
    if (how.callback) REQUIRE(lr_world_set_wind_callback(world.get(), shear, nullptr) == LR_OK);
    return world;
}

uint64_t outcome(const How& how) {
    const std::vector<float> samples = grid_samples();
    lr_batch batches[2];
    World world = windy(how, samples, batches, true);
    for (size_t b = 0; b < 2; ++b) {
        std::vector<lr_body_desc> bodies;
        for (uint32_t i = 0; i < 1500; ++i) {
            Random random(i + 10000 * b);
            lr_body_desc d = strewn(random, 3.0);
            d.noise_seed = i + 1;
            bodies.push_back(d);
        }
        if (how.reversed) std::reverse(bodies.begin(), bodies.end());
        REQUIRE(lr_body_create(world.get(), batches[b], bodies.data(), 1500, nullptr) == LR_OK);
    }
    for (int frame = 0; frame < 12; ++frame) {
        if (frame == 6 && how.through_snapshot) {
            const std::vector<unsigned char> snapshot = snapshot_of(world);
            world = windy(how, samples, batches, false); // with the grid in another place
            REQUIRE(lr_world_snapshot_restore(world.get(), snapshot.data(), snapshot.size()) == LR_OK);
        }
        if (frame % 3 == 2) set_wind(world, 0.5f * static_cast<float>(frame), 0.0f, -1.0f);
        steps(world, 1, 1.0f / 60.0f, 3);
        if (frame == 8) steps(world, 1, 0.05f, 19); // more substeps than are prepared at a time
    }
    return hash_of(world);
}

} // namespace

TEST_CASE("wind of every kind gives the same bits everywhere") {
    const uint64_t expected = outcome({});
    for (int32_t target : simd_targets()) {
        CAPTURE(target);
        CHECK(outcome({.simd = target}) == expected);
    }
    for (uint32_t workers : {1u, 3u}) CHECK(outcome({.workers = workers}) == expected);
    CHECK(outcome({.reversed = true}) == expected);
    CHECK(outcome({.through_snapshot = true}) == expected);
    CHECK(outcome({.simd = simd_targets().back(), .workers = 2, .reversed = true, .through_snapshot = true}) ==
          expected);
    CHECK(outcome({.callback = false}) != expected);
}

TEST_CASE("a body that has left the finite numbers changes nothing for the others") {
    const std::vector<float> samples = grid_samples();
    const Asset asset = leaf();
    const auto run = [&](bool sick) {
        const World world = make(world_desc());
        const lr_batch batch = add_batch(world, asset, 40);
        for (const AnySource& d : one_of_each(samples)) add_source(world, d);
        lr_body healthy{};
        for (int i = 0; i < 40; ++i) {
            lr_body_desc d = body_desc();
            d.noise_seed = static_cast<uint32_t>(i + 1);
            // A body that will overflow: as far and as fast as possible, in a step of a second.
            if (sick && i == 19) {
                set(d.position, 1e9f, -1e9f, 1e9f);
                set(d.linear_velocity, 1e6f, 1e6f, -1e6f);
                set(d.angular_velocity, 1e6f, 1e6f, -1e6f);
            }
            const lr_body id = add_body(world, batch, d);
            if (i == 20) healthy = id;
        }
        for (int i = 0; i < 10; ++i) lr_world_step(world.get(), 0.05f, 2);
        return state_of(world, healthy);
    };
    CHECK(same_bits(run(false), run(true)));
}

TEST_CASE("the hash sees every part of the wind") {
    const std::vector<float> samples = grid_samples();
    std::vector<uint64_t> hashes;
    const auto hash_with = [&](const std::vector<AnySource>& sources, float wind, double time) {
        const World world = make(world_desc());
        set_wind(world, wind, 0.0f, 0.0f);
        for (const AnySource& d : sources) add_source(world, d);
        if (time > 0.0) steps(world, 1, narrow(time), 1);
        hashes.push_back(hash_of(world));
    };
    const std::vector<AnySource> all = one_of_each(samples);
    hash_with({}, 0.0f, 0.0);
    hash_with(all, 0.0f, 0.0);
    hash_with(all, 1.0f, 0.0);
    hash_with(all, 0.0f, 0.01);
    hash_with(all, 0.0f, 0.02);
    for (size_t i = 0; i < all.size(); ++i) {
        std::vector<AnySource> changed = all;
        std::visit(
            [](auto& d) {
                if constexpr (requires { d.rms; })
                    d.rms += 0.125f;
                else
                    d.velocity[1] += 0.125f;
            },
            changed[i]);
        hash_with(changed, 0.0f, 0.0);
        changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(i));
        hash_with(changed, 0.0f, 0.0);
    }
    std::vector<float> other = samples;
    other[17] += 0.5f;
    std::vector<AnySource> changed = all;
    std::get<lr_wind_grid_desc>(changed[static_cast<size_t>(Source::grid)]).samples = other.data();
    hash_with(changed, 0.0f, 0.0);
    std::sort(hashes.begin(), hashes.end());
    CHECK(std::unique(hashes.begin(), hashes.end()) == hashes.end());
}
