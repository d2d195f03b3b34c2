#include "collision/collider_broad_phase.h"

#include "near_collider_marks.h"
#include "support/quick.h"
#include "support/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

using namespace test;
using lr::Box;
using lr::Vector;

namespace {

Vector random_vector(Random& random, double most) {
    return {random.real(-most, most), random.real(-most, most), random.real(-most, most)};
}

// Boxes about `center`, evenly over all sizes.
std::vector<Box> random_boxes(Random& random, uint32_t count, Vector center, double spread, double smallest,
                              double largest) {
    std::vector<Box> boxes(count);
    for (Box& box : boxes) {
        const Vector at = center + random_vector(random, spread);
        const auto half = [&] { return static_cast<float>(random.logarithmic(smallest, largest)); };
        const Vector h{half(), half(), half()};
        box = {at - h, at + h};
    }
    return boxes;
}

struct Grid {
    lr::Allocator allocator;
    lr::ColliderBroadPhase grid;
    lr::NearColliders near{};

    Grid(const std::vector<Box>& boxes, float dilation, uint32_t levels, bool fine = false) : grid(fine) {
        REQUIRE(grid.reserve(allocator, boxes.size()));
        for (uint32_t i = 0; i < boxes.size(); ++i) grid.add({boxes[i], i, {3 * i, 1}});
        grid.build(dilation, levels);
        REQUIRE(grid.level_count() <= levels);
        near.level_count = grid.level_count();
        for (uint32_t l = 0; l < grid.level_count(); ++l) near.levels[l] = grid.level(l);
    }
};

double beyond(float x, float low, float high) {
    return std::max(0.0, std::max(static_cast<double>(low) - static_cast<double>(x),
                                  static_cast<double>(x) - static_cast<double>(high)));
}
// Whether a cube of half side `reach` about `at` overlaps the box, in exact arithmetic: it contains the sphere.
bool meets(const Box& box, Vector at, float reach) {
    const auto r = static_cast<double>(reach);
    return beyond(at.x, box.low.x, box.high.x) <= r && beyond(at.y, box.low.y, box.high.y) <= r &&
           beyond(at.z, box.low.z, box.high.z) <= r;
}

const int bodies = quick() ? 10000 : 100000;

} // namespace

TEST_CASE("no body that can touch a box is missed by the bits, at any size and anywhere") {
    Random random(1);
    uint32_t touching = 0, far = 0;
    for (double center : {0.0, 10.0, 1e5})
        for (double largest : {0.02, 1.0, 30.0})
            for (uint32_t levels : {3u, 5u}) {
                const float dilation = random.real(0.001, 0.5);
                const Vector middle{static_cast<float>(center), static_cast<float>(-center), 0.0f};
                const std::vector<Box> boxes = random_boxes(random, 30, middle, 40.0, 0.001, largest);
                const Grid g(boxes, dilation, levels, largest > 0.5 && levels == 5);
                for (int i = 0; i < bodies; ++i) {
                    // Around a box, at its reach, or anywhere.
                    const Box& box = boxes[random.below(30)];
                    const float reach = random.real(0.0, 1.0) * dilation;
                    const Vector e = box.high - box.low;
                    const Vector at = i % 4 == 0
                                          ? middle + random_vector(random, 60.0)
                                          : Vector{box.low.x + random.real(-0.1, 1.1) * e.x, box.low.y, box.high.z} +
                                                random_vector(random, 2.0 * static_cast<double>(dilation));
                    const bool touches =
                        std::any_of(boxes.begin(), boxes.end(), [&](const Box& b) { return meets(b, at, reach); });
                    const bool near = marked(g.near, at, reach);
                    if (touches && !near) FAIL("missed a body at ", at.x, " ", at.y, " ", at.z);
                    touching += touches;
                    far += i % 4 == 0 && !near;
                }
            }
    CHECK(touching > static_cast<uint32_t>(bodies));       // otherwise the test would find nothing
    CHECK(far > 18u * static_cast<uint32_t>(bodies) / 10); // and the marks exclude something
}

TEST_CASE("bodies at the very edge of a box's reach are found") {
    Random random(2);
    for (int round = 0; round < 20000; ++round) {
        const double center = random.logarithmic(0.01, 1e6);
        const float dilation = static_cast<float>(random.logarithmic(0.001, 2.0));
        const std::vector<Box> boxes =
            random_boxes(random, 1, {static_cast<float>(center), 0.0f, 0.0f}, 1.0, 0.001, 3.0);
        const Grid g(boxes, dilation, 5, round % 2 == 0);
        float x = boxes[0].low.x;
        // The last position in single precision from which `dilation` reaches the box.
        x -= dilation;
        while (static_cast<double>(x) + static_cast<double>(dilation) < static_cast<double>(boxes[0].low.x))
            x = std::nextafter(x, boxes[0].low.x);
        const Vector at{x, 0.5f * (boxes[0].low.y + boxes[0].high.y), boxes[0].high.z};
        if (!meets(boxes[0], at, dilation)) FAIL("not at the edge");
        if (!marked(g.near, at, dilation)) FAIL("missed at ", center);
    }
}

TEST_CASE("a body that reaches farther than boxes were dilated may always be near") {
    const Grid g({{{0.0f, 0.0f, 0.0f}, {1.0f, 1.0f, 1.0f}}}, 0.25f, 5);
    CHECK_FALSE(marked(g.near, {500.0f, 0.0f, 0.0f}, 0.25f));
    CHECK(marked(g.near, {500.0f, 0.0f, 0.0f}, 0.26f));
    CHECK_FALSE(marked(lr::NearColliders{}, {0.0f, 0.0f, 0.0f}, 1e9f)); // without colliders
}

TEST_CASE("a query finds what going through all boxes finds, each once") {
    Random random(3);
    for (int scene = 0; scene < 60; ++scene) {
        const double center = scene % 3 == 0 ? 1e5 : 0.0;
        const double largest = random.logarithmic(0.01, 100.0);
        const uint32_t count = 1 + random.below(400);
        const Vector middle{static_cast<float>(center), 0.0f, static_cast<float>(center)};
        const std::vector<Box> boxes = random_boxes(random, count, middle, 10.0, 0.001, largest);
        const Grid g(boxes, 0.25f, 1 + random.below(8), scene % 2 == 0);
        for (int i = 0; i < 200; ++i) {
            const Box query = random_boxes(random, 1, middle, 12.0, 0.001, i % 10 == 0 ? 100.0 : 0.3)[0];
            std::vector<uint32_t> expected, found;
            for (uint32_t k = 0; k < count; ++k)
                if (lr::overlap(boxes[k], query)) expected.push_back(k);
            g.grid.query(query, [&](const lr::Proxy& p) {
                found.push_back(p.slot);
                if (p.part.first != 3 * p.slot) FAIL("another's part");
                return true;
            });
            CHECK(g.grid.query(query, [](const lr::Proxy&) { return false; }) == found.empty());
            std::sort(found.begin(), found.end());
            if (found != expected) FAIL("found ", found.size(), " of ", expected.size());
        }
    }
}

TEST_CASE("hostile boxes and queries end") {
    const float huge = 3e38f, nan = std::nanf("");
    const Grid g({{{-1e9f, -1e9f, -1e9f}, {1e9f, 1e9f, 1e9f}}, {{5.0f, 5.0f, 5.0f}, {5.0f, 5.0f, 5.0f}}}, 0.25f, 3);
    uint32_t found = 0;
    const auto count = [&](const lr::Proxy&) { return ++found, true; };
    g.grid.query({{-huge, -huge, -huge}, {huge, huge, huge}}, count);
    CHECK(found == 2);
    found = 0;
    g.grid.query({{nan, nan, nan}, {nan, nan, nan}}, count);
    CHECK(found == 0);
    g.grid.query({{1.0f, 1.0f, 1.0f}, {-1.0f, -1.0f, -1.0f}}, count); // inverted: any result, but at once
    CHECK(marked(g.near, {0.0f, 0.0f, 0.0f}, 0.1f));
    CHECK(marked(g.near, {0.0f, 0.0f, 0.0f}, nan));
    (void)marked(g.near, {nan, huge, -huge}, 0.1f);
}
