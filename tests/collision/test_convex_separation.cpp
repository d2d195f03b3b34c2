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

} // namespace

TEST_CASE("distances of cores are libccd's" * doctest::test_suite("long")) {
    test::Random random(1);
    uint32_t apart = 0, overlapping = 0, worse = 0, failed = 0;
    double error = 0.0, most_excess = 0.0, most_normal = 0.0;
    for (uint32_t i = 0; i < test::rounds(30000); ++i) {
        const auto size = static_cast<float>(random.logarithmic(1e-3, 1.0));
        const BodyShape shape = some_body(i, size, random);
        test::Solid solid;
        make_random(solid, kinds[random.below(5)], size * random.real(0.3, 3.0), random);
        const Pose at{random.real(0.0, 2.0) * size * test::any_direction(random), test::any_rotation(random)};
        const PlacedBody body(shape, 1.0f, at);
        const PlacedCollider collider = test::place(solid, at.position);
        const Separation found = separate(body, collider, 1e300);
        REQUIRE(std::abs(length(found.normal) - 1.0) < 1e-6);
        CHECK(separation_along(body, collider, found.normal) >=
              doctest::Approx(found.distance).epsilon(1e-6 * static_cast<double>(size)));
        const auto scale = static_cast<double>(size);
        double distance = 0.0;
        Double3 normal{};
        const double ball = found.has_points ? found.distance + 0.2 * scale : 0.0;
        if (!test::reference_distance(body, collider, ball, distance, normal)) {
            // The two disagree only on whether they touch.
            ++failed;
            if (!found.has_points) CHECK(found.distance > -1e-4 * scale);
            continue;
        }
        // Sometimes libccd's answer contradicts itself.
        if (!(std::abs(separation_along(body, collider, normal) - distance) <= 1e-4 * scale)) {
            ++failed;
            continue;
        }
        if (found.has_points) {
            ++apart;
            error = std::max(error, std::abs(found.distance - distance) / scale);
            if (found.distance > 1e-3 * scale) most_normal = std::max(most_normal, length(found.normal - normal));
            CHECK(std::abs(length(found.on_body - found.on_collider) - found.distance) < 1e-5 * scale);
        } else {
            ++overlapping;
            // libccd's depth is the minimum; along any direction it is no less.
            const double excess = (distance - found.distance) / scale;
            worse += excess > 0.01;
            most_excess = std::max(most_excess, excess);
        }
    }
    INFO(apart << " apart, error " << error << ", normal " << most_normal << "; " << overlapping << " overlapping, "
               << worse << " deeper by 1 % of the size, most " << most_excess << "; libccd failed on " << failed);
    CHECK(apart > test::rounds(10000));
    CHECK(overlapping > test::rounds(8000));
    CHECK(error < 1e-4);
    CHECK(most_normal < 0.05);       // libccd's own tolerance on edges
    CHECK(worse < overlapping / 80); // 0.9 %: local minima of the depth
    CHECK(most_excess < 0.25);
}

TEST_CASE("supports that never settle end libccd's search") {
    // Not the support function of a convex set: libccd's loops can run endlessly.
    test::Random random(2);
    const BodyShape shape = test::leaf(0.04f, 1e-4f);
    for (uint32_t i = 0; i < test::rounds(20000); ++i) {
        PlacedBody body(shape, 1.0f, {{0.0f, 0.0f, 0.0f}, test::any_rotation(random)});
        Geometry box{};
        box.kind = ColliderKind::box;
        for (float& h : box.size) h = random.below(3) == 0 ? 0.0f : random.real(0.0, 0.05);
        if (i % 2 == 0)
            for (uint32_t k = 0; k < body.count; ++k)
                if (random.below(4) == 0) body.x[k] = body.y[k] = body.z[k] = 0.0f;
        Double3 direction{0.0, 1.0, 0.0};
        ccd_direction(body, PlacedCollider(box, random.real(0.0, 0.05) * test::any_direction(random)), direction);
        CHECK(std::abs(length(direction) - 1.0) < 1e-6);
    }
}
