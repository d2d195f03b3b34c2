// The largest number of colliders in practice: time and memory.
#include "support/colliders.h"
#include "support/quick.h"

#include <ctime>

using namespace test;

TEST_CASE("a million colliders in one call, within seconds, and no cost afterwards" * doctest::test_suite("native")) {
    const uint32_t count = quick() ? 100000 : (1u << 20) + 7;
    const World world = make(world_desc());
    std::vector<lr_collider_desc> descs(count, box_collider(0.5f, 0.2f, 0.1f));
    for (uint32_t i = 0; i < count; ++i) {
        descs[i].position[0] = static_cast<float>(i % 1024);
        const uint32_t row = i / 1024;
        descs[i].position[2] = static_cast<float>(row);
    }
    std::vector<lr_collider> ids(count);
    const auto seconds = [](std::clock_t since) { return static_cast<double>(std::clock() - since) / CLOCKS_PER_SEC; };
    std::clock_t since = std::clock();
    REQUIRE(lr_collider_create(world.get(), descs.data(), count, ids.data()) == LR_OK);
    const double creating = seconds(since);
    since = std::clock();
    steps(world, 1, 0.01f);
    const double building = seconds(since);
    since = std::clock();
    steps(world, 100, 0.01f);
    const double stepping = seconds(since) / 100;
    since = std::clock();
    REQUIRE(lr_collider_destroy(world.get(), ids.data(), count) == LR_OK);
    const double destroying = seconds(since);
    MESSAGE("a million: created in ", creating, " s, first step ", building, " s, another ", 1e6 * stepping,
            " us, destroyed in ", destroying, " s, ", static_cast<double>(info_of(world).memory_bytes) / count,
            " bytes each");
    CHECK(creating < 10.0); // generous: machines are shared
    CHECK(building < 20.0);
    CHECK(stepping < 0.01 * building);
    CHECK(destroying < 10.0);
    CHECK(info_of(world).collider_count == 0);
}
