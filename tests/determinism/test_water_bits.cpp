// A water surface under a wind field, with a callback: the same bits everywhere, and no change far from water.
#include "support/random.h"
#include "support/water.h"
#include "support/wind.h"

#include <algorithm>

using namespace test;

namespace {

struct How {
    int32_t simd = LR_SIMD_AUTO;
    uint32_t workers = 0;
    bool reversed = false, through_snapshot = false, callback = true, water = true, windy = true;
    float height = 3.0f; // of the bodies' centre
};

void swell(void*, const lr_water_query* q) {
    for (uint32_t i = 0; i < q->count; ++i) {
        q->height[i] += 0.1f * static_cast<float>(q->time);
        q->velocity[1][i] += 0.1f;
    }
}

World build(const How& how, lr_batch (&batches)[2]) {
    lr_world_desc wd = world_desc();
    wd.simd_target = how.simd;
    wd.worker_count = how.workers;
    World world = make(wd);
    const Asset assets[] = {leaf(), curled_leaf()};
    for (size_t b = 0; b < 2; ++b) batches[b] = add_batch(world, assets[b], 1200);
    if (how.callback) REQUIRE(lr_world_set_water_callback(world.get(), swell, nullptr) == LR_OK);
    return world;
}

uint64_t positions(const World& world, const lr_batch (&batches)[2]) {
    uint64_t sum = 0;
    for (lr_batch batch : batches) {
        const lr_batch_view v = view_of(world, batch);
        for (uint32_t i = 0; i < v.count; ++i)
            for (const float* x : v.position) {
                uint32_t bits = 0;
                std::memcpy(&bits, x + i, 4);
                sum += (bits ^ v.noise_seed[i]) * 0x9e3779b97f4a7c15ull;
            }
    }
    return sum;
}

uint64_t outcome(const How& how) {
    lr_batch batches[2];
    World world = build(how, batches);
    if (how.water) {
        lr_water_desc d = sea();
        d.position[1] = 3.0f;
        d.reach = 0.5f;
        set_water(world, d);
    }
    if (how.windy) {
        lr_vortex_desc vortex = vortex_desc(LR_VORTEX_RANKINE);
        set(vortex.axis, 1.0f, 0.0f, 0.0f);
        add_source(world, vortex);
    }
    for (size_t b = 0; b < 2; ++b) {
        std::vector<lr_body_desc> bodies;
        for (uint32_t i = 0; i < 1200; ++i) {
            Random random(i + 10000 * b);
            lr_body_desc d = strewn(random, 2.0);
            d.noise_seed = i + 1;
            d.position[1] += how.height;
            for (float& v : d.linear_velocity) v = random.real(-2.0, 2.0);
            bodies.push_back(d);
        }
        if (how.reversed) std::reverse(bodies.begin(), bodies.end());
        REQUIRE(lr_body_create(world.get(), batches[b], bodies.data(), 1200, nullptr) == LR_OK);
    }
    for (int frame = 0; frame < 12; ++frame) {
        if (frame == 6 && how.through_snapshot) {
            const std::vector<unsigned char> snapshot = snapshot_of(world);
            world = build(how, batches);
            REQUIRE(lr_world_snapshot_restore(world.get(), snapshot.data(), snapshot.size()) == LR_OK);
        }
        if (frame % 3 == 2) set_wind(world, 0.5f * static_cast<float>(frame), 0.0f, -1.0f);
        steps(world, 1, 1.0f / 60.0f, 3);
    }
    return positions(world, batches);
}

} // namespace

TEST_CASE("water gives the same bits everywhere") {
    for (bool windy : {false, true}) {
        const uint64_t expected = outcome({.windy = windy});
        for (int32_t target : simd_targets()) {
            CAPTURE(target);
            CHECK(outcome({.simd = target, .windy = windy}) == expected);
        }
        for (uint32_t workers : {1u, 3u}) CHECK(outcome({.workers = workers, .windy = windy}) == expected);
        CHECK(outcome({.reversed = true, .windy = windy}) == expected);
        CHECK(outcome({.through_snapshot = true, .windy = windy}) == expected);
        CHECK(outcome({.callback = false, .windy = windy}) != expected);
        CHECK(outcome({.water = false, .windy = windy}) != expected);
    }
}

TEST_CASE("water that is far away changes nothing") {
    for (bool windy : {false, true})
        CHECK(outcome({.windy = windy, .height = 60.0f}) == outcome({.water = false, .windy = windy, .height = 60.0f}));
}
