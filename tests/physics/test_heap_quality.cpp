// The measures of a heap, on overlaps known from closed forms.
#include "support/heap_quality.h"

#include <doctest/doctest.h>

#include <numbers>

using namespace test;

namespace {

constexpr Vec half = {0.035, 0.02, 0.0002};
constexpr Quat level = {0.0, 0.0, 0.0, 1.0};
constexpr double close = 1e-12;
constexpr double quarter = 0.5 * std::numbers::pi;

bool near(double a, double b) {
    return std::abs(a - b) < close;
}

} // namespace

TEST_CASE("overlap of boxes: face on face") {
    const Pose a{{0.1, -0.2, 0.3}, level};
    for (const double depth : {3e-4, 1e-6, -1e-6, -0.01}) {
        CHECK(near(overlap_depth(half, a, {a.position + Vec{0.01, 0.005, 4e-4 - depth}, level}), depth));
        CHECK(near(overlap_depth(half, a, {a.position + Vec{0.01, 0.005, depth - 4e-4}, level}), depth));
    }
    // Turned about the common normal, and both turned about any axis.
    const Quat spun = about({0.0, 0.0, 1.0}, 0.7), any = about({1.0, -2.0, 0.5}, 2.1);
    CHECK(near(overlap_depth(half, a, {a.position + Vec{0.0, 0.0, 3e-4}, spun}), 1e-4));
    CHECK(
        near(overlap_depth(half, {a.position, any}, {a.position + to_world(any, {0.0, 0.0, 3e-4}), product(any, spun)}),
             1e-4));
    CHECK(near(overlap_depth(half, a, {a.position + Vec{0.0699, 0.0, 0.0}, level}), 1e-4)); // rim on rim
    CHECK(near(overlap_depth(half, a, a), 4e-4));
}

TEST_CASE("overlap of boxes: a corner, an edge and a rim in a face") {
    const Pose a{{0.0, 0.0, 0.0}, level};
    // Upright on its short rim.
    const Quat upright = about({0.0, 1.0, 0.0}, quarter);
    CHECK(near(overlap_depth(half, a, {{0.0, 0.0, 0.035 + 2e-4 - 5e-5}, upright}), 5e-5));
    CHECK(near(overlap_depth(half, a, {{0.0, 0.0, 0.035 + 2e-4 + 5e-5}, upright}), -5e-5));
    // Stuck through the middle: out at a rim is further than along its own thickness.
    CHECK(near(overlap_depth(half, a, {{0.0, 0.0, 0.0}, upright}), 0.035 + 2e-4));
    // On a corner.
    const Quat tilted = product(about({0.0, 1.0, 0.0}, 0.6), about({1.0, 0.0, 0.0}, 0.4));
    double reach = 0.0;
    for (size_t k = 0; k < 3; ++k) reach += half[k] * std::abs(rotation(tilted)[2][k]);
    CHECK(near(overlap_depth(half, a, {{0.0, 0.0, 2e-4 + reach - 1e-4}, tilted}), 1e-4));
}

TEST_CASE("overlap of boxes: edge on edge") {
    // Cubes that stand on edges across each other: those edges' common normal separates them.
    const Vec cube = {0.01, 0.01, 0.01};
    const Quat along_x = about({1.0, 0.0, 0.0}, 0.5 * quarter), along_y = about({0.0, 1.0, 0.0}, 0.5 * quarter);
    const double reach = 0.01 * std::numbers::sqrt2;
    for (const double depth : {1e-3, 1e-5, -1e-5})
        CHECK(near(overlap_depth(cube, {{0.0, 0.0, 0.0}, along_x}, {{0.002, 0.001, 2.0 * reach - depth}, along_y}),
                   depth));
}

TEST_CASE("a heap's measures count pairs, depths, deep bodies and heights") {
    std::vector<Pose> poses;
    // Pairs far from each other, one above the other.
    const double depths[] = {-1e-3, 5e-6, 5e-5, 1.5e-4, 2e-4};
    for (size_t i = 0; i < 5; ++i) {
        const double x = 0.2 * static_cast<double>(i);
        poses.push_back({{x, 0.0, 0.0}, about({1.0, 0.0, 0.0}, quarter)});
        poses.push_back({{x, 4e-4 - depths[i], 0.0}, about({1.0, 0.0, 0.0}, quarter)});
    }
    HeapQuality q = heap_quality(half, poses);
    CHECK(q.overlaps == doctest::Approx(0.2));
    CHECK(q.depth_median == doctest::Approx(1.5e-4));
    CHECK(q.depth_99 == doctest::Approx(2e-4));
    CHECK(q.share_deep == 0.0);
    CHECK(q.height_mean == doctest::Approx((5.0 * 4e-4 + 1e-3 - 5e-6 - 5e-5 - 1.5e-4 - 2e-4) / 10.0));
    CHECK(q.height_95 == doctest::Approx(1.4e-3));
    // Two plates through each other.
    poses.push_back({{-1.0, 0.0, 0.0}, level});
    poses.push_back({{-1.0, 0.0, 0.0}, about({0.0, 1.0, 0.0}, quarter)});
    q = heap_quality(half, poses);
    CHECK(q.overlaps == doctest::Approx(3.0 / 12.0));
    CHECK(q.share_deep == doctest::Approx(2.0 / 12.0));
    CHECK(heap_quality(half, {}).overlaps == 0.0);
}

TEST_CASE("the largest movement is that of a corner") {
    const std::vector<Pose> before = {{{0.0, 0.0, 0.0}, level}, {{1.0, 0.0, 0.0}, level}};
    std::vector<Pose> after = before;
    CHECK(largest_movement(half, before, after) == 0.0);
    after[1].turn = about({0.0, 0.0, 1.0}, 0.1);
    CHECK(largest_movement(half, before, after) == doctest::Approx(2.0 * std::sin(0.05) * std::hypot(0.035, 0.02)));
    after[0].position[1] = 0.1;
    CHECK(largest_movement(half, before, after) == doctest::Approx(0.1));
}
