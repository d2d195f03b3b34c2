// The grid of bodies that move finds every two boxes that overlap, once, whatever their sizes.
#include "contact/meeting_grid.h"

#include "support/random.h"

#include <doctest/doctest.h>

#include <limits>
#include <set>
#include <vector>

using namespace lr;

namespace {

bool overlap(const MeetingBox& a, const MeetingBox& b) {
    for (size_t k = 0; k < 3; ++k)
        if (!(a.low[k] <= b.high[k] && b.low[k] <= a.high[k])) return false;
    return true;
}

MeetingBox any_box(test::Random& random, double extent, double least, double most, uint32_t body) {
    MeetingBox box{};
    for (size_t k = 0; k < 3; ++k) {
        const auto middle = random.real(-extent, extent);
        const auto half = static_cast<float>(random.logarithmic(least, most));
        box.low[k] = middle - half;
        box.high[k] = middle + half;
    }
    box.body = body;
    return box;
}

using Found = std::multiset<std::pair<uint32_t, uint32_t>>;

// Each pair by the one that finds it: of two of a level, both do.
Found found_by(const MeetingGrid& grid, uint32_t count) {
    Found found;
    for (uint32_t i = 0; i < count; ++i) {
        const MeetingBox& box = grid.box(i);
        grid.visit(box, [&](const MeetingBox& other) {
            if (other.body != box.body) found.insert({box.body, other.body});
        });
    }
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
                    MeetingGrid grid;
                    REQUIRE(grid.reserve(allocator, count));
                    const double extent = 6.0 * size * spread / std::sqrt(spread);
                    for (uint32_t i = 0; i < count; ++i) {
                        grid.boxes()[i] = any_box(random, extent, size, size * spread, i);
                        if (far) grid.boxes()[i].low[0] += 3e4f, grid.boxes()[i].high[0] += 3e4f;
                    }
                    grid.build(count);
                    Found expected;
                    for (uint32_t i = 0; i < count; ++i)
                        for (uint32_t j = 0; j < count; ++j)
                            if (i != j && overlap(grid.box(i), grid.box(j)) && grid.box(i).level <= grid.box(j).level)
                                expected.insert({i, j});
                    pairs += expected.size();
                    CHECK(found_by(grid, count) == expected);
                }
    CHECK(pairs > 10000);
}

TEST_CASE("onward each pair is found once, and by both in a cell of their own") {
    test::Random random(83);
    size_t pairs = 0, in_a_cell = 0;
    for (const double spread : {1.0, 30.0})
        for (int round = 0; round < 20; ++round) {
            constexpr uint32_t count = 300;
            Allocator allocator;
            MeetingGrid grid;
            REQUIRE(grid.reserve(allocator, count));
            for (uint32_t i = 0; i < count; ++i) grid.boxes()[i] = any_box(random, 0.3, 0.01, 0.01 * spread, i);
            grid.build(count);
            Found expected, found;
            for (const auto& [a, b] : found_by(grid, count))
                if (a < b || grid.box(a).level != grid.box(b).level) expected.insert({std::min(a, b), std::max(a, b)});
            uint32_t twice = 0;
            for (uint32_t i = 0; i < count; ++i)
                grid.visit_onward(grid.box(i), [&](const MeetingBox& other, bool mutual) {
                    if (other.body == i) return;
                    twice += mutual ? 1u : 0u;
                    if (!mutual || i < other.body) found.insert({std::min(i, other.body), std::max(i, other.body)});
                });
            CHECK(found == expected);
            CHECK(twice % 2 == 0);
            pairs += expected.size();
            in_a_cell += twice / 2;
        }
    CHECK(in_a_cell > 100);
    CHECK(pairs > 2 * in_a_cell);
}

TEST_CASE("what a grid finds does not depend on the order of its boxes, nor on what it held before") {
    test::Random random(82);
    constexpr uint32_t count = 300;
    std::vector<MeetingBox> boxes;
    for (uint32_t i = 0; i < count; ++i) boxes.push_back(any_box(random, 1.0, 0.01, 0.3, i));
    Allocator allocator;
    MeetingGrid grid;
    REQUIRE(grid.reserve(allocator, 2 * count));
    Found first;
    for (int round = 0; round < 5; ++round) {
        if (round % 2 == 1) { // others, and more of them
            for (uint32_t i = 0; i < 2 * count; ++i) grid.boxes()[i] = any_box(random, 1.0, 0.001, 1.0, i);
            grid.build(2 * count);
        }
        for (uint32_t i = 0; i < count; ++i) grid.boxes()[i] = boxes[i];
        grid.build(count);
        const Found found = found_by(grid, count);
        if (round == 0) first = found;
        CHECK(found == first);
        for (uint32_t i = count - 1; i > 0; --i) std::swap(boxes[i], boxes[random.below(i + 1)]);
    }
    CHECK(first.size() > count / 2);
}

TEST_CASE("boxes that are not finite, inside out or as large as a world meet nothing, and disturb no others") {
    Allocator allocator;
    MeetingGrid grid;
    REQUIRE(grid.reserve(allocator, 8));
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const float wrong[6][2] = {{nan, nan}, {0.0f, nan}, {-inf, inf}, {1.0f, -1.0f}, {-1e30f, 1e30f}, {inf, inf}};
    for (uint32_t i = 0; i < 6; ++i) {
        MeetingBox& box = grid.boxes()[i];
        for (size_t k = 0; k < 3; ++k) box.low[k] = wrong[i][0], box.high[k] = wrong[i][1];
        box.body = i;
    }
    for (uint32_t i = 6; i < 8; ++i) {
        MeetingBox& box = grid.boxes()[i];
        for (size_t k = 0; k < 3; ++k) box.low[k] = -1.0f, box.high[k] = 1.0f;
        box.body = i;
    }
    grid.build(8);
    CHECK(found_by(grid, 8) == Found{{6, 7}, {7, 6}});
}
