#include "collision/convex_separation.h"
#include "random_pairs.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace lr;

namespace {

constexpr ColliderKind kinds[] = {ColliderKind::sphere, ColliderKind::capsule, ColliderKind::box, ColliderKind::hull,
                                  ColliderKind::mesh};

BodyShape some_body(uint32_t which, float size, test::Random& random) {
    switch (which % 3) {
    case 0:
        return test::leaf(size, 0.01f * size);
    case 1:
        return make_body_shape(test::asset_of(test::box_corners(0.5f * size, 0.3f * size, 0.2f * size)));
    default:
        return make_body_shape(test::asset_of(test::cloud(random, 20, 0.5f * size)));
    }
}

// Whether no direction tells the point from the core.
template <class Core> bool within(const Core& core, Double3 point, double tolerance, test::Random& random) {
    for (uint32_t i = 0; i < 50; ++i) {
        const Double3 d = to_double(test::any_direction(random));
        if (dot(d, point - core.support(d)) > tolerance) return false;
    }
    return true;
}

} // namespace

// Points on both cores are no nearer than these are, and along the normal they are no farther apart: together that is the distance.
TEST_CASE("distances and depths of cores" * doctest::test_suite("long")) {
    test::Random random(1);
    uint32_t apart = 0, overlapping = 0, worse = 0;
    double most_excess = 0.0;
    for (uint32_t i = 0; i < test::rounds(12000); ++i) {
        const auto size = static_cast<float>(random.logarithmic(1e-3, 1.0));
        const BodyShape shape = some_body(i, size, random);
        test::Solid solid;
        make_random(solid, kinds[random.below(5)], size * random.real(0.3, 3.0), random);
        const Pose at{random.real(0.0, 2.0) * size * test::any_direction(random), test::any_rotation(random)};
        const PlacedBody body(shape, 1.0f, at);
        const PlacedCollider collider = test::place(solid, at.position);
        const Separation found = separate(body, collider, 1e300);
        const auto scale = static_cast<double>(size);
        REQUIRE(std::abs(length(found.normal) - 1.0) < 1e-6);
        CHECK(std::abs(separation_along(body, collider, found.normal) - found.distance) < 1e-6 * scale);
        if (found.has_points) {
            ++apart;
            CHECK(std::abs(length(found.on_body - found.on_collider) - found.distance) < 1e-5 * scale);
            CHECK(within(body, found.on_body, 1e-5 * scale, random));
            CHECK(within(collider, found.on_collider, 1e-5 * scale, random));
        } else {
            ++overlapping;
            const double least = test::sampled_separation(body, collider, random);
            CHECK(least < 1e-5 * scale);
            const double excess = (least - found.distance) / scale;
            worse += excess > 0.01;
            most_excess = std::max(most_excess, excess);
        }
    }
    INFO(apart << " apart; " << overlapping << " overlapping, " << worse << " deeper by 1 % of the size, most "
               << most_excess);
    CHECK(apart > test::rounds(6000));
    CHECK(overlapping > test::rounds(4000));
    // Local minima of the depth: one in a hundred, and three standard deviations of a sample of this size.
    const double expected = overlapping / 100.0;
    CHECK(worse < expected + 3.0 * std::sqrt(expected));
    CHECK(most_excess < 0.25);
}
