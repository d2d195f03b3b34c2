// The grid finds every body whose box overlaps another, of all sizes, and never a removed one.
#include "collision/sleeping_grid.h"

#include "support/random.h"

#include <doctest/doctest.h>

#include <limits>
#include <set>
#include <vector>

using namespace lr;

namespace {

struct Body {
    bool in = false;
    float position[3] = {}, scale = 1.0f;
};

bool overlaps(const Body& b, double reach, const Box& box) {
    const double r = reach * wide(b.scale);
    const float low[3] = {box.low.x, box.low.y, box.low.z}, high[3] = {box.high.x, box.high.y, box.high.z};
    bool yes = b.in;
    for (size_t k = 0; k < 3; ++k)
        yes = yes && wide(b.position[k]) + r >= wide(low[k]) && wide(b.position[k]) - r <= wide(high[k]);
    return yes;
}

} // namespace

TEST_CASE("the grid of bodies at rest misses none, and has only those that lie in it") {
    test::Random random(71);
    for (double reach : {0.0005, 0.04, 1.5}) {
        for (bool mixed : {false, true}) {
            Allocator allocator;
            SleepingGrid grid;
            constexpr uint32_t capacity = 700;
            REQUIRE(grid.create(allocator, capacity, reach));
            std::vector<Body> bodies(capacity);
            const double extent = 30.0 * reach;
            uint32_t inside = 0, looked_up = 0, found_in_all = 0;
            for (int round = 0; round < 4000; ++round) {
                const uint32_t slot = random.below(capacity);
                Body& b = bodies[slot];
                if (b.in) {
                    grid.remove(slot);
                    b.in = false, --inside;
                } else {
                    for (float& x : b.position) x = random.real(-extent, extent);
                    b.scale = mixed ? static_cast<float>(random.logarithmic(1e-3, 1e3)) : random.real(0.5, 2.0);
                    if (round % 50 == 0) b.position[round % 3] = 3e38f; // far beyond the last cell
                    grid.insert(slot, vector_of(b.position), b.scale);
                    b.in = true, ++inside;
                }
                if (round % 4 != 0) continue;
                float low[3], high[3];
                for (size_t k = 0; k < 3; ++k) {
                    low[k] = random.real(-extent, extent);
                    high[k] = low[k] + static_cast<float>(random.uniform(0.0, mixed ? 0.1 : 4.0) * reach);
                    // Sometimes exactly at the end of a body.
                    if (b.in && round % 8 == 0) low[k] = high[k] = b.position[k];
                }
                const Box box{vector_of(low), vector_of(high)};
                std::set<uint32_t> found;
                bool lost = false;
                if (!grid.visit(box, 1000000, [&](uint32_t s) {
                        lost = lost || !bodies[s].in;
                        found.insert(s);
                    }))
                    continue;
                ++looked_up;
                CHECK_FALSE(lost);
                found_in_all += static_cast<uint32_t>(found.size());
                for (uint32_t s = 0; s < capacity; ++s)
                    if (overlaps(bodies[s], reach, box)) CHECK(found.count(s) == 1);
            }
            CHECK(looked_up > (mixed ? 100u : 900u));
            CHECK(inside > 250);
            // Finding all bodies would make the grid useless: bodies of a single size.
            if (!mixed) CHECK(found_in_all < looked_up * inside / 8);
        }
    }
}

TEST_CASE(
    "a box of more cells than there are bodies is left to who asks, and a body may be taken out while it is visited") {
    Allocator allocator;
    SleepingGrid grid;
    REQUIRE(grid.create(allocator, 64, 0.01));
    for (uint32_t slot = 0; slot < 64; ++slot) {
        grid.insert(slot, {0.001f * static_cast<float>(slot), 0.0f, 0.0f}, 1.0f);
    }
    const Box everywhere{{-1e9f, -1e9f, -1e9f}, {1e9f, 1e9f, 1e9f}}, some{{-0.01f, 0.0f, 0.0f}, {0.08f, 0.0f, 0.0f}};
    CHECK_FALSE(grid.visit(everywhere, 64, [](uint32_t) { FAIL("asked"); }));
    uint32_t seen = 0;
    CHECK(grid.visit(some, 1000, [&](uint32_t slot) { ++seen, grid.remove(slot); }));
    CHECK(seen == 64);
    CHECK(grid.visit(some, 1000, [&](uint32_t) { FAIL("taken out"); }));
}
