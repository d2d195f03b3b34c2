#include "collision/convex_separation.h"
#include "collision/triangle_contact.h"
#include "random_pairs.h"

#include <doctest/doctest.h>

using namespace lr;

namespace {

constexpr Rotation level{0.0f, 0.0f, 0.0f, 1.0f};

struct Found {
    Contact contacts[most_contacts];
    uint32_t count;
    Found(const BodyShape& shape, float scale, const Pose& at, const test::Solid& solid, float margin) : contacts{} {
        count = find_contacts(shape, scale, at, solid, margin, contacts);
        REQUIRE(count <= most_contacts);
        if (count != 0) REQUIRE(least() < margin);
        // Other rims of flat ellipsoids.
        const float wide =
            shape.count == 0 ? 0.1f * scale * shape.reach + 2.0f * std::max(-least(), 0.0f) + 1e-6f : 0.0f;
        for (uint32_t i = 0; i < count; ++i) {
            const Contact& c = contacts[i];
            REQUIRE(std::abs(length(c.normal) - 1.0f) < 1e-5f);
            REQUIRE(std::isfinite(c.gap));
            REQUIRE(c.gap < margin + wide);
            REQUIRE(length(c.arm) <= scale * shape.reach * 1.01f);
        }
    }
    float least() const {
        float gap = std::numeric_limits<float>::infinity();
        for (uint32_t i = 0; i < count; ++i) gap = std::min(gap, contacts[i].gap);
        return gap;
    }
    // Whether the contacts support forces along -y through the centre of mass: seen from above, it lies within them.
    bool holds(const Pose& at) const {
        for (int k = 0; k < 64; ++k) {
            const double t = 2.0 * std::numbers::pi * k / 64.0;
            const auto u = static_cast<float>(std::cos(t)), v = static_cast<float>(std::sin(t));
            float most = -1.0f;
            for (uint32_t i = 0; i < count; ++i) {
                const Vector arm = rotate(at.rotation, contacts[i].arm);
                most = std::max(most, u * arm.x + v * arm.z);
            }
            if (!(most > 0.0f)) return false;
        }
        return true;
    }
};

void make_floor(test::Solid& solid, int which, float size, test::Random& random) {
    switch (which) {
    case 0:
        return solid.make(ColliderKind::plane);
    case 1:
        return solid.make(ColliderKind::box, size, 0.1f * size, size);
    case 2: {
        std::vector<float> heights(size_t{9} * 9, 0.0f);
        REQUIRE(solid.make_field(9, 9, 0.25f * size, heights));
        return;
    }
    default: {
        // A flat floor of triangles with arbitrary corners.
        std::vector<float> v;
        std::vector<uint32_t> t;
        for (uint32_t k = 0; k < 9; ++k)
            for (uint32_t i = 0; i < 9; ++i)
                for (const float c : {(static_cast<float>(i) + random.real(-0.3, 0.3)) * 0.25f * size, 0.0f,
                                      (static_cast<float>(k) + random.real(-0.3, 0.3)) * 0.25f * size})
                    v.push_back(c);
        for (uint32_t k = 0; k < 8; ++k)
            for (uint32_t i = 0; i < 8; ++i) {
                const uint32_t a = k * 9 + i;
                for (const uint32_t c : {a, a + 9, a + 10, a, a + 10, a + 1}) t.push_back(c);
            }
        REQUIRE(solid.make_mesh(v, t));
    }
    }
}

} // namespace

TEST_CASE("a leaf that lies on a floor is held, with vertical normals") {
    test::Random random(11);
    for (uint32_t i = 0; i < test::rounds(4000); ++i) {
        const auto size = static_cast<float>(random.logarithmic(1e-3, 1.0));
        const BodyShape shape = test::leaf(size, 0.01f * size);
        test::Solid floor;
        const int which = static_cast<int>(i % 4);
        make_floor(floor, which, size, random);
        const float top = which == 1 ? 0.1f * size : 0.0f;
        const Vector middle = which >= 2 ? Vector{size, 0.0f, size} : Vector{0.0f, 0.0f, 0.0f};
        const float half = random.real(0.0, 3.0);
        const Rotation about_y{0.0f, std::sin(half), 0.0f, std::cos(half)};
        const Rotation tilt = normalised({random.real(-2e-3, 2e-3), 0.0f, random.real(-2e-3, 2e-3), 1.0f});
        // A mesh has no inside: the middle of the leaf stays above it.
        const float gap = size * random.real(which == 3 ? -0.002 : -0.02, 0.004);
        const Pose at{middle + Vector{0.2f * size * random.real(-1, 1), top + shape.radius + gap,
                                      0.2f * size * random.real(-1, 1)},
                      tilt * about_y};
        const Found found(shape, 1.0f, at, floor, 0.01f * size);
        CAPTURE(which);
        CAPTURE(i);
        CHECK(found.holds(at));
        for (uint32_t k = 0; k < found.count; ++k) {
            CHECK(found.contacts[k].normal.y > 0.999f);
            // The gap is the point's distance from the floor.
            const Vector p = to_outer(at, found.contacts[k].arm);
            CHECK(std::abs(p.y - top - found.contacts[k].gap) < 1e-6f * size);
        }
    }
}

TEST_CASE("contacts are those of the pair: none missed, as deep as it is" * doctest::test_suite("long")) {
    test::Random random(12);
    constexpr ColliderKind kinds[] = {ColliderKind::sphere, ColliderKind::capsule, ColliderKind::box,
                                      ColliderKind::hull, ColliderKind::mesh};
    uint32_t touching = 0;
    for (uint32_t i = 0; i < test::rounds(15000); ++i) {
        const auto size = static_cast<float>(random.logarithmic(1e-3, 1.0));
        const BodyShape shape = i % 4 == 0   ? test::ellipsoid(0.5f * size, 0.1f * size, 0.3f * size)
                                : i % 4 == 1 ? make_body_shape(test::asset_of(test::cloud(random, 20, 0.5f * size)))
                                             : test::leaf(size, 0.01f * size);
        test::Solid solid;
        make_random(solid, kinds[random.below(5)], size * random.real(0.3, 3.0), random);
        const Pose at{random.real(0.0, 1.5) * size * test::any_direction(random), test::any_rotation(random)};
        const float scale = random.real(0.5, 1.0), margin = 0.02f * size;
        const Found found(shape, scale, at, solid, margin);
        const PlacedBody body(shape, scale, at);
        const PlacedCollider collider = test::place(solid, at.position);
        const Separation along = separate(body, collider, 1e300);
        const double gap = along.distance - static_cast<double>(body.radius) - collider.radius;
        CAPTURE(i);
        CAPTURE(static_cast<int>(solid.geometry.kind));
        CAPTURE(gap / static_cast<double>(size));
        if (gap < 0.9 * static_cast<double>(margin)) {
            ++touching;
            REQUIRE(found.count > 0);
            // Depths along a collider's own side are at most a little larger if the sides are at an angle.
            CHECK(static_cast<double>(found.least()) <
                  gap + 0.05 * static_cast<double>(margin) + 1e-4 * static_cast<double>(size));
        } else if (gap > 1.1 * static_cast<double>(margin)) {
            CHECK(found.count == 0);
        }
    }
    CHECK(touching > test::rounds(5000));
}

// Depths of steep sides differ by their slope times the slack of patches, 1e-5 of the leaf's reach.
TEST_CASE("a peak, a ridge, a corner and an edge under the middle of a leaf") {
    const BodyShape shape = test::leaf(0.04f, 4e-4f);
    const float r = shape.radius;
    test::Random random(13);
    for (uint32_t i = 0; i < 500; ++i) {
        const float x = random.real(-0.004, 0.004), z = random.real(-0.004, 0.004), gap = random.real(-1e-4, 2e-4);
        const Rotation tilt = normalised({random.real(-0.1, 0.1), 0.0f, random.real(-0.1, 0.1), 1.0f});
        const Vector up = rotate(tilt, {0.0f, 1.0f, 0.0f});
        const auto over = [&](Vector tip) { return Pose{tip + (gap + r) * up + rotate(tilt, {x, 0.0f, z}), tilt}; };
        {
            test::Solid field;
            std::vector<float> heights(size_t{5} * 5, 0.0f);
            heights[12] = 0.05f;
            REQUIRE(field.make_field(5, 5, 0.02f, heights));
            const Found found(shape, 1.0f, over({0.04f, 0.05f, 0.04f}), field, 1e-3f);
            REQUIRE(found.count > 0);
            CHECK(std::abs(found.least() - gap) < 4e-6f);
            CHECK(dot(found.contacts[0].normal, up) > 0.999f);
        }
        {
            test::Solid field; // a ridge along z under the whole leaf
            std::vector<float> heights(size_t{5} * 5, 0.0f);
            for (uint32_t k = 0; k < 5; ++k) heights[k * 5 + 2] = 0.05f;
            REQUIRE(field.make_field(5, 5, 0.02f, heights));
            Pose at{{0.04f + x, 0.05f + gap + r, 0.04f}, level};
            const Found found(shape, 1.0f, at, field, 1e-3f);
            REQUIRE(found.count >= 2);
            CHECK(std::abs(found.least() - gap) < 4e-6f);
            float low = 1.0f, high = -1.0f;
            for (uint32_t k = 0; k < found.count; ++k) {
                low = std::min(low, found.contacts[k].arm.z);
                high = std::max(high, found.contacts[k].arm.z);
            }
            CHECK(high - low > 0.015f); // from rim to rim
        }
        {
            test::Solid cone;
            REQUIRE(cone.make_hull({0, 0, 0, -0.02f, -0.05f, -0.02f, 0.02f, -0.05f, -0.02f, 0, -0.05f, 0.02f}));
            const Found found(shape, 1.0f, over({0, 0, 0}), cone, 1e-3f);
            REQUIRE(found.count > 0);
            CHECK(std::abs(found.least() - gap) < 4e-6f);
            CHECK(dot(found.contacts[0].normal, up) > 0.999f);
        }
        {
            test::Solid edge; // a box turned by 45 degrees about z has its edge along z
            edge.make(ColliderKind::box, 0.1f, 0.1f, 0.5f);
            const float h = 0.38268343f, c = 0.92387953f;
            const Pose box{{0, 0, 0}, {0, 0, h, c}}, leaf_at{{x, 0.14142136f + gap + r, 0.0f}, level};
            const Found found(shape, 1.0f, relative(box, leaf_at), edge, 1e-3f);
            REQUIRE(found.count >= 2);
            CHECK(std::abs(found.least() - gap) < 4e-6f);
            CHECK(rotate(box.rotation, found.contacts[0].normal).y > 0.999f);
        }
        {
            test::Solid ball;
            ball.make(ColliderKind::sphere, 0.01f);
            const Found found(shape, 1.0f, over(0.01f * up), ball, 1e-3f);
            REQUIRE(found.count == 1);
            CHECK(std::abs(found.contacts[0].gap - gap) < 2e-8f);
        }
        {
            test::Solid post; // lying along z
            post.make(ColliderKind::capsule, 0.005f, 0.5f);
            const Pose lying{{0, 0, 0}, {0.70710678f, 0, 0, 0.70710678f}}, leaf_at{{x, 0.005f + gap + r, 0}, level};
            const Found found(shape, 1.0f, relative(lying, leaf_at), post, 1e-3f);
            REQUIRE(found.count == 2);
            for (uint32_t k = 0; k < 2; ++k) CHECK(std::abs(found.contacts[k].gap - gap) < 2e-8f);
            CHECK(std::abs(found.contacts[0].arm.z - found.contacts[1].arm.z) > 0.015f);
        }
    }
}

TEST_CASE("an ellipsoid touches a plane and a slope in one point, in closed form") {
    test::Random random(16);
    for (uint32_t i = 0; i < test::rounds(2000); ++i) {
        const auto size = static_cast<float>(random.logarithmic(1e-3, 1.0));
        const float semi[3] = {size, size * random.real(0.1, 1.0), size * random.real(0.1, 1.0)};
        const BodyShape shape = test::ellipsoid(semi[0], semi[1], semi[2]);
        const Rotation q = test::any_rotation(random);
        const float slope = i % 2 == 0 ? 0.0f : random.real(-1, 1);
        const Vector up = 1.0f / std::sqrt(1.0f + slope * slope) * Vector{-slope, 1.0f, 0.0f};
        const Vector n = rotate(inverse(q), up);
        const float tall =
            std::sqrt(semi[0] * semi[0] * n.x * n.x + semi[1] * semi[1] * n.y * n.y + semi[2] * semi[2] * n.z * n.z);
        test::Solid floor;
        std::vector<float> heights;
        for (uint32_t k = 0; k < 81; ++k) heights.push_back(size * slope * static_cast<float>(k % 9));
        if (i % 2 == 0)
            floor.make(ColliderKind::plane);
        else
            REQUIRE(floor.make_field(9, 9, size, heights));
        const float gap = size * random.real(-0.05, 0.05);
        const Pose at{size * Vector{4.0f, 4.0f * slope, 4.0f} + (gap + tall) * up, q};
        const Found found(shape, 1.0f, at, floor, 0.1f * size);
        REQUIRE(found.count >= 1);
        CHECK(std::abs(found.least() - gap) < 3e-6f * size);
        CHECK(dot(found.contacts[0].normal, up) > 0.9999f);
    }
}

TEST_CASE("a leaf in a thin wall is pushed to the side where most of it is") {
    test::Random random(14);
    const BodyShape shape = test::leaf(0.04f, 4e-4f);
    for (const bool is_mesh : {false, true}) {
        test::Solid wall;
        if (is_mesh)
            REQUIRE(wall.make_mesh({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, {0, 1, 2, 0, 2, 3}));
        else
            wall.make(ColliderKind::box, 1.0f, 1.0f, 5e-4f);
        for (uint32_t i = 0; i < test::rounds(5000); ++i) {
            const Rotation q = test::any_rotation(random);
            const PlacedBody turned(shape, 1.0f, {{0, 0, 0}, q});
            const double low = turned.support({0, 0, -1}).z, high = turned.support({0, 0, 1}).z;
            const float z = random.real(-0.02, 0.02);
            const double front = high + static_cast<double>(z), back = -(low + static_cast<double>(z));
            if (front < 1e-3 || back < 1e-3 || std::abs(front - back) < 2e-3) continue;
            const Found found(shape, 1.0f, {{0.3f, 0.05f, z}, q}, wall, 1e-3f);
            REQUIRE(found.count > 0);
            // Some lie so flat in it that another direction is shorter.
            for (uint32_t k = 0; k < found.count; ++k) CHECK((found.contacts[k].normal.z > 0.0f) == (front > back));
        }
    }
}

// On the corners of the nearest face alone it would rock from face to face.
TEST_CASE("a domed leaf near the edge of a box or of a mesh is held by the corners of several faces") {
    test::Random random(23);
    std::vector<float> v{0.0f, -0.001f, 0.0f};
    for (int k = 0; k < 8; ++k) {
        const double t = std::numbers::pi * k / 4.0;
        const auto x = static_cast<float>(std::cos(t)), z = static_cast<float>(std::sin(t));
        v.insert(v.end(), {0.03f * x, 0.0f, 0.03f * z, 0.06f * x, 0.02f, 0.06f * z});
    }
    const BodyShape shape = make_body_shape(test::asset_of(v));
    REQUIRE(shape.count == 17);
    test::Solid box, mesh;
    box.make(ColliderKind::box, 1.0f, 0.1f, 1.0f);
    REQUIRE(mesh.make_mesh({-1, 0.1f, -1, -1, 0.1f, 1, 1, 0.1f, -1, 1, 0.1f, 1, 1, -1, -1, 1, -1, 1},
                           {0, 1, 2, 1, 3, 2, 2, 3, 5, 2, 5, 4}));
    for (uint32_t i = 0; i < test::rounds(2000); ++i) {
        const float half = random.real(0.0, 3.0);
        const Rotation about_y{0.0f, std::sin(half), 0.0f, std::cos(half)};
        const Rotation tilt = normalised({random.real(-5e-3, 5e-3), 0.0f, random.real(-5e-3, 5e-3), 1.0f});
        const Pose at{{random.real(0.95, 0.965), 0.101f + random.real(-1e-3, 1e-3), random.real(-0.9, 0.9)},
                      tilt * about_y};
        for (const test::Solid* solid : {&box, &mesh}) {
            const Found found(shape, 1.0f, at, *solid, 0.003f);
            CHECK(found.count >= 5);
            CHECK(found.holds(at));
        }
    }
}

TEST_CASE("a leaf in the air over the edge of a closed mesh whose side is known touches nothing") {
    test::Random random(17);
    const BodyShape shape = test::ellipsoid(0.03f, 5e-4f, 0.02f);
    test::Solid box;
    REQUIRE(box.make_mesh(
        {-1, -1, -1, -1, -1, 1, -1, 0, -1, -1, 0, 1, 1, -1, -1, 1, -1, 1, 1, 0, -1, 1, 0, 1},
        {0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1, 2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3}));
    uint32_t touching = 0;
    for (uint32_t i = 0; i < test::rounds(2000); ++i) {
        const Rotation q = test::any_rotation(random);
        const auto tall = static_cast<float>(PlacedBody(shape, 1.0f, {{0, 0, 0}, q}).support({0, 1, 0}).y);
        const Pose at{{1.0f - random.real(-0.02, 0.03), tall + 0.005f, 1.0f - random.real(-0.02, 0.1)}, q};
        ContactPoints set(shape, 1.0f, at, 1e-3f, nullptr, 1);
        add_mesh(set, box.mesh, box.part);
        touching += set.count() > 0 ? 1u : 0u;
    }
    CHECK(touching == 0);
}

// Pushed out of a wall's outer face, winged seeds left through the joint of wall and floor.
TEST_CASE("a body that is pressed into a closed mesh is not pushed out of faces that its centre of mass was behind") {
    test::Random random(29);
    const BodyShape shape = test::leaf(0.04f, 1e-3f);
    test::Solid wall;
    const float low = -1.0f, thick = 0.02f;
    REQUIRE(wall.make_mesh(
        {low, 0, -thick, low, 0, 0, low, 2, -thick, low, 2, 0, 1, 0, -thick, 1, 0, 0, 1, 2, -thick, 1, 2, 0},
        {0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1, 2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3}));
    uint32_t touching = 0;
    for (uint32_t i = 0; i < test::rounds(2000); ++i) {
        const Rotation q = test::any_rotation(random);
        const Pose before{{0.0f, random.real(1e-4, 0.02), random.real(1e-4, 5e-3)}, q};
        const Pose at{before.position - random.real(0.0, 0.01) * Vector{0.0f, 0.3f, 1.0f}, q};
        ContactPoints set(shape, 1.0f, at, 1e-3f, &before, 1);
        add_mesh(set, wall.mesh, wall.part);
        Contact contacts[most_contacts];
        const uint32_t count = set.keep(contacts);
        touching += count > 0 ? 1u : 0u;
        for (uint32_t k = 0; k < count; ++k) CHECK(contacts[k].normal.z > -0.06f); // 3 degrees
    }
    CHECK(touching > test::rounds(1000));
}

TEST_CASE("hostile pairs give finite contacts or none") {
    test::Random random(15);
    const float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    std::vector<BodyShape> shapes{test::leaf(0.04f, 0.0f), test::leaf(1.0f, 1e-6f), test::ellipsoid(0.1f, 1e-6f, 0.1f),
                                  make_body_shape(test::asset_of(test::box_corners(0.1f, 0.1f, 0.1f))),
                                  make_body_shape(AssetData{})};
    for (uint32_t i = 0; i < test::rounds(20000); ++i) {
        test::Solid solid;
        const uint32_t which = random.below(7);
        const auto some = [&] {
            return random.below(4) == 0 ? 0.0f : static_cast<float>(random.logarithmic(1e-6, 1e3));
        };
        if (which == 5) {
            std::vector<float> heights(64);
            for (float& h : heights) h = random.below(8) == 0 ? 1e6f : random.real(-0.1, 0.1);
            REQUIRE(solid.make_field(8, 8, 0.05f, heights));
        } else if (which == 6) {
            std::vector<float> v(30);
            std::vector<uint32_t> t(60);
            for (float& c : v) c = 0.1f * std::floor(random.real(-2, 2));
            for (uint32_t& c : t) c = random.below(10);
            if (!solid.make_mesh(v, t)) continue;
        } else if (which == 4) {
            if (!solid.make_hull(test::cloud(random, 4 + random.below(8), 0.1f))) continue;
        } else {
            const float a = some(), b = some(), c = some();
            solid.make(static_cast<ColliderKind>(which + 1), a, b, c);
        }
        Vector p = random.real(0.0, 0.2) * test::any_direction(random);
        if (i % 5 == 0) p = {0.0f, 0.0f, 0.0f};
        if (i % 11 == 0) p.x = i % 2 == 0 ? nan : infinity;
        if (i % 13 == 0) p.y = 1e30f;
        Rotation q = i % 7 == 0 ? level : test::any_rotation(random);
        if (i % 17 == 0) q.w = nan;
        const BodyShape& shape = shapes[random.below(5)];
        Contact out[most_contacts];
        const uint32_t count = find_contacts(shape, 1.0f, {p, q}, solid, 1e-3f, out);
        REQUIRE(count <= most_contacts);
        for (uint32_t k = 0; k < count; ++k) {
            CHECK(std::abs(length(out[k].normal) - 1.0f) < 1e-4f);
            CHECK(std::isfinite(out[k].gap));
            CHECK(std::isfinite(length(out[k].arm)));
        }
        const Pose to{p + random.real(0.0, 0.3) * test::any_direction(random), test::any_rotation(random)};
        const float fraction = free_fraction(shape, 1.0f, {p, q}, to, solid);
        CHECK(fraction >= 0.0f);
        CHECK(fraction <= 1.0f);
    }
}
