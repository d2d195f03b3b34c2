// The grid of awake bodies finds every pair of overlapping boxes once, of all sizes.
#include "collision/body_broad_phase.h"

#include "support/random.h"

#include <doctest/doctest.h>

#include <limits>
#include <set>
#include <vector>

using namespace lr;

namespace {

BodyBox any_box(test::Random& random, double extent, double least, double most) {
    const auto any = [&](auto&& number) {
        const float x = number(), y = number(), z = number();
        return Vector{x, y, z};
    };
    const Vector middle = any([&] { return random.real(-extent, extent); });
    const Vector half = any([&] { return static_cast<float>(random.logarithmic(least, most)); });
    return {{middle - half, middle + half}, 0, 0};
}

using Found = std::multiset<std::pair<uint32_t, uint32_t>>;

// Each pair once, the smaller name first; names: of the boxes, by default their numbers. twice: receives the number of pairs that both found.
Found found_by(const BodyBroadPhase& grid, uint32_t count, uint32_t* twice = nullptr,
               const std::vector<uint32_t>& names = {}) {
    const auto name_of = [&](uint32_t i) { return names.empty() ? i : names[i]; };
    Found found;
    uint32_t mutually = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t body = name_of(i);
        grid.visit(grid.box(i), [&](uint32_t found_box, bool mutual) {
            const uint32_t other = name_of(found_box);
            if (other == body) return;
            mutually += mutual ? 1u : 0u;
            if (!mutual || body < other) found.insert({std::min(body, other), std::max(body, other)});
        });
    }
    if (twice) *twice = mutually;
    return found;
}

} // namespace

TEST_CASE("boxes that overlap find each other once, and no others") {
    test::Random random(81);
    size_t pairs = 0;
    for (const double size : {1e-3, 0.05, 30.0})
        for (const double spread : {1.0, 30.0, 1e3})
            for (uint32_t count : {1u, 2u, 60u, 400u})
                for (bool far : {false, true}) {
                    CAPTURE(size);
                    CAPTURE(spread);
                    CAPTURE(count);
                    Allocator allocator;
                    BodyBroadPhase grid;
                    REQUIRE(grid.reserve(allocator, count));
                    const double extent = 6.0 * size * spread / std::sqrt(spread);
                    for (uint32_t i = 0; i < count; ++i) {
                        grid.boxes()[i] = any_box(random, extent, size, size * spread);
                        if (far) grid.boxes()[i].box.low.x += 3e4f, grid.boxes()[i].box.high.x += 3e4f;
                    }
                    grid.build(count);
                    Found expected;
                    for (uint32_t i = 0; i < count; ++i)
                        for (uint32_t j = i + 1; j < count; ++j)
                            if (overlap(grid.box(i).box, grid.box(j).box)) expected.insert({i, j});
                    pairs += expected.size();
                    CHECK(found_by(grid, count) == expected);
                }
    CHECK(pairs > 5000);
}

TEST_CASE("pairs in a cell of their own are found by both, and others by one") {
    test::Random random(83);
    size_t pairs = 0, in_a_cell = 0;
    for (const double spread : {1.0, 30.0})
        for (int round = 0; round < 20; ++round) {
            constexpr uint32_t count = 300;
            Allocator allocator;
            BodyBroadPhase grid;
            REQUIRE(grid.reserve(allocator, count));
            for (uint32_t i = 0; i < count; ++i) grid.boxes()[i] = any_box(random, 0.3, 0.01, 0.01 * spread);
            grid.build(count);
            uint32_t twice = 0;
            pairs += found_by(grid, count, &twice).size();
            CHECK(twice % 2 == 0);
            in_a_cell += twice / 2;
        }
    CHECK(in_a_cell > 100);
    CHECK(pairs > 2 * in_a_cell);
}

TEST_CASE("a grid's results depend neither on the order of its boxes nor on its former contents") {
    test::Random random(82);
    constexpr uint32_t count = 300;
    std::vector<BodyBox> boxes;
    std::vector<uint32_t> names;
    for (uint32_t i = 0; i < count; ++i) {
        boxes.push_back(any_box(random, 1.0, 0.01, 0.3));
        names.push_back(i);
    }
    Allocator allocator;
    BodyBroadPhase grid;
    REQUIRE(grid.reserve(allocator, 2 * count));
    Found first;
    for (int round = 0; round < 5; ++round) {
        if (round % 2 == 1) { // other bodies, and more of them
            for (uint32_t i = 0; i < 2 * count; ++i) grid.boxes()[i] = any_box(random, 1.0, 0.001, 1.0);
            grid.build(2 * count);
        }
        for (uint32_t i = 0; i < count; ++i) grid.boxes()[i] = boxes[i];
        grid.build(count);
        const Found found = found_by(grid, count, nullptr, names);
        if (round == 0) first = found;
        CHECK(found == first);
        for (uint32_t i = count - 1; i > 0; --i) {
            const uint32_t to = random.below(i + 1);
            std::swap(boxes[i], boxes[to]);
            std::swap(names[i], names[to]);
        }
    }
    CHECK(first.size() > count / 2);
}

TEST_CASE("boxes that are not finite, inside out or as large as a world meet nothing, and disturb no others") {
    Allocator allocator;
    BodyBroadPhase grid;
    REQUIRE(grid.reserve(allocator, 8));
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const float wrong[6][2] = {{nan, nan}, {0.0f, nan}, {-inf, inf}, {1.0f, -1.0f}, {-1e30f, 1e30f}, {inf, inf}};
    for (uint32_t i = 0; i < 6; ++i) {
        const float low = wrong[i][0], high = wrong[i][1];
        grid.boxes()[i] = {{{low, low, low}, {high, high, high}}, 0, 0};
    }
    for (uint32_t i = 6; i < 8; ++i) grid.boxes()[i] = {{{-1.0f, -1.0f, -1.0f}, {1.0f, 1.0f, 1.0f}}, 0, 0};
    grid.build(8);
    CHECK(found_by(grid, 8) == Found{{6, 7}});
}
