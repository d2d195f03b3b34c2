#include "collision/convex_separation.h"
#include "random_pairs.h"

#include <doctest/doctest.h>

#include <chrono>

using namespace lr;

namespace {

const uint32_t shots = test::rounds(100000);

Pose between(const Pose& a, Pose b, float t) {
    Rotation &q = b.rotation, p = a.rotation;
    if (q.x * p.x + q.y * p.y + q.z * p.z + q.w * p.w < 0.0f) q = {-q.x, -q.y, -q.z, -q.w};
    const float s = 1.0f - t;
    return {a.position + t * (b.position - a.position),
            normalised({s * p.x + t * q.x, s * p.y + t * q.y, s * p.z + t * q.z, s * p.w + t * q.w})};
}

Rotation turned(Rotation from, Vector axis, float half_angle) {
    const float s = std::sin(half_angle);
    return normalised(Rotation{s * axis.x, s * axis.y, s * axis.z, std::cos(half_angle)} * from);
}

// Walls across z, 2 m wide.
void make_wall(test::Solid& solid, bool is_mesh) {
    if (is_mesh)
        solid.make_mesh({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, {0, 1, 2, 0, 2, 3});
    else
        solid.make(ColliderKind::box, 1.0f, 1.0f, 5e-5f);
}

float lowest_z(const BodyShape& shape, const Pose& at) {
    return static_cast<float>(PlacedBody(shape, 1.0f, at).support({0.0, 0.0, -1.0}).z) + at.position.z;
}

} // namespace

TEST_CASE("no shot goes through a thin wall") {
    for (const bool is_mesh : {false, true}) {
        test::Random random(is_mesh ? 3 : 4);
        test::Solid wall;
        make_wall(wall, is_mesh);
        uint32_t through = 0, hits = 0, stopped_early = 0;
        for (uint32_t i = 0; i < shots; ++i) {
            const auto size = static_cast<float>(random.logarithmic(5e-3, 0.1));
            static const BodyShape shape = test::leaf(1.0f, 0.005f);
            const Vector to_wall{random.real(-0.2, 0.2), random.real(-0.2, 0.2), -0.3333f * random.real(0.2, 1.0)};
            Pose from{{random.real(-0.3, 0.3), random.real(-0.3, 0.3), size * random.real(0.6, 3.0)},
                      test::any_rotation(random)};
            const Pose to{from.position + to_wall,
                          turned(from.rotation, test::any_direction(random), random.real(0.0, 0.7))};
            const float fraction = free_fraction(shape, size, from, to, wall);
            REQUIRE(fraction >= 0.0f);
            REQUIRE(fraction <= 1.0f);
            const Pose at = between(from, to, fraction);
            const PlacedBody body(shape, size, at);
            const double lowest = body.support({0.0, 0.0, -1.0}).z + static_cast<double>(at.position.z);
            through += lowest <= 0.0;
            if (fraction < 1.0f) {
                ++hits;
                stopped_early += lowest > 0.05 * static_cast<double>(size);
            } else {
                // All of it stayed in front: the last pose proves this for a motion along z without rotation, samples for others.
                for (const float t : {0.25f, 0.5f, 0.75f}) {
                    const Pose there = between(from, to, t);
                    const PlacedBody placed(shape, size, there);
                    through += placed.support({0.0, 0.0, -1.0}).z + static_cast<double>(there.position.z) <= 0.0;
                }
            }
        }
        INFO("mesh: " << is_mesh << ", hits " << hits << ", through " << through << ", early " << stopped_early);
        CHECK(through == 0);
        CHECK(hits > shots / 2);
        CHECK(stopped_early < hits / 100);
    }
}

// A gale turns a leaf beside a wall by radians in a substep. Its ends may meet the wall, but nothing else holds it.
TEST_CASE("a body that leaves a wall and turns fast is stopped at the wall or nowhere") {
    for (const bool is_mesh : {false, true}) {
        test::Random random(is_mesh ? 13 : 14);
        test::Solid wall;
        make_wall(wall, is_mesh);
        const BodyShape shape = test::leaf(1.0f, 0.005f);
        uint32_t free = 0, held = 0;
        for (uint32_t i = 0; i < shots / 4; ++i) {
            const auto size = static_cast<float>(random.logarithmic(5e-3, 0.1));
            const Pose from{{random.real(-0.3, 0.3), random.real(-0.3, 0.3), size * random.real(0.3, 0.6)},
                            test::any_rotation(random)};
            const Vector way{random.real(-0.2, 0.2), random.real(-0.2, 0.2), random.real(0.0, 0.2)};
            const Pose to{from.position + way,
                          turned(from.rotation, test::any_direction(random), random.real(0.4, 1.5))};
            const auto gap = [&](const Pose& at) {
                const PlacedBody body(shape, size, at);
                return body.support({0.0, 0.0, -1.0}).z + static_cast<double>(at.position.z);
            };
            if (gap(from) < 0.02 * static_cast<double>(size)) continue;
            const float fraction = free_fraction(shape, size, from, to, wall);
            free += fraction == 1.0f;
            held += fraction < 1.0f && gap(between(from, to, fraction)) > 0.05 * static_cast<double>(size);
        }
        INFO("mesh: " << is_mesh << ", free " << free << ", held " << held);
        CHECK(free > shots / 10);
        CHECK(held < shots / 1000);
    }
}

TEST_CASE("nothing is pushed through by trying again and again") {
    test::Random random(5);
    for (const bool is_mesh : {false, true}) {
        test::Solid wall;
        make_wall(wall, is_mesh);
        for (uint32_t i = 0; i < 300; ++i) {
            const float size = static_cast<float>(random.logarithmic(1e-3, 0.1));
            const BodyShape shape = i % 3 == 0   ? make_body_shape(test::asset_of(test::cloud(random, 16, 0.5f * size)))
                                    : i % 3 == 1 ? test::leaf(size, 0.005f * size)
                                                 : test::ellipsoid(0.5f * size, 0.1f * size, 0.3f * size);
            Pose at{{0.0f, 0.0f, size}, test::any_rotation(random)};
            for (uint32_t step = 0; step < 40; ++step) {
                // Contacts handle motions that are short relative to the thickness.
                const Pose to{at.position + Vector{0.0f, 0.0f, -size * random.real(0.5, 5.0)},
                              turned(at.rotation, test::any_direction(random), random.real(0.0, 0.1))};
                at = between(at, to, free_fraction(shape, 1.0f, at, to, wall));
            }
            CHECK(at.position.z > 0.0f);
        }
    }
}

// Others can press most of a body into a wall. Its centre of mass still tells where it belongs, and the middle of its points can be far from that.
TEST_CASE("a body that lies in a wall but for its centre of mass does not go through it") {
    test::Random random(8);
    std::vector<float> points = test::cloud(random, 16, 0.03f);
    for (size_t k = 2; k < points.size(); k += 3) points[k] -= 0.025f;
    points.insert(points.end(), {0.0f, 0.0f, 0.01f});
    const BodyShape shape = make_body_shape(test::asset_of(points));
    test::Solid wall;
    wall.make(ColliderKind::box, 1.0f, 1.0f, 0.05f);
    for (uint32_t i = 0; i < test::rounds(2000); ++i) {
        const float size = random.real(0.5, 2.0);
        const Pose from{
            {random.real(-0.5, 0.5), random.real(-0.5, 0.5), 0.05f + 0.005f * size * random.real(0.01, 1.0)},
            turned({0.0f, 0.0f, 0.0f, 1.0f}, test::any_direction(random), random.real(0.0, 0.2))};
        const Pose to{from.position + Vector{random.real(-0.1, 0.1), random.real(-0.1, 0.1), -random.real(0.2, 2.0)},
                      turned(from.rotation, test::any_direction(random), random.real(0.0, 0.7))};
        CHECK(between(from, to, free_fraction(shape, size, from, to, wall)).position.z > 0.05f);
    }
}

TEST_CASE("a free way is whole, and one along a wall") {
    const BodyShape shape = test::leaf(0.04f, 2e-4f);
    test::Solid wall;
    make_wall(wall, false);
    const Rotation flat{0.70710678f, 0.0f, 0.0f, 0.70710678f};
    // 20 micrometres above the surface: never nearer than that, and at most a tenth of the leaf's size away.
    const float over = 5e-5f + 1e-4f + 2e-5f;
    REQUIRE(std::abs(lowest_z(shape, {{0.0f, 0.0f, 0.0f}, flat})) < 1e-8);
    const Pose from{{0.0f, 0.0f, over}, flat}, to{{0.3f, 0.1f, over}, flat};
    CHECK(free_fraction(shape, 1.0f, from, to, wall) == 1.0f);
    const Pose away{{0.3f, 0.1f, 0.3f}, flat};
    CHECK(free_fraction(shape, 1.0f, from, away, wall) == 1.0f);
    CHECK(free_fraction(shape, 1.0f, away, {{0.9f, 0.1f, 0.2f}, flat}, wall) == 1.0f);
    // Straight down: it stops within a tenth of its thickness.
    const Pose high{{0.0f, 0.0f, 0.1f}, flat}, under{{0.0f, 0.0f, -0.2f}, flat};
    const float t = free_fraction(shape, 1.0f, high, under, wall);
    const float gap = 0.1f - 0.3f * t - 5e-5f - shape.radius;
    CHECK(gap > -1e-7f);
    CHECK(gap < 0.11f * shape.thickness);
}

TEST_CASE("until the end of the free way there is no overlap" * doctest::test_suite("long")) {
    test::Random random(6);
    uint32_t stopped = 0, checked = 0;
    constexpr ColliderKind kinds[] = {ColliderKind::sphere, ColliderKind::capsule, ColliderKind::box,
                                      ColliderKind::hull, ColliderKind::mesh};
    uint32_t early = 0;
    double deepest = 0.0;
    for (uint32_t i = 0; i < shots / 10; ++i) {
        const auto size = static_cast<float>(random.logarithmic(1e-3, 1.0));
        const BodyShape shape = i % 2 == 0 ? test::leaf(size, 0.01f * size)
                                           : make_body_shape(test::asset_of(test::cloud(random, 12, 0.5f * size)));
        test::Solid solid;
        make_random(solid, kinds[i % 5], size * random.real(0.2, 3.0), random);
        const Pose from{random.real(1.0, 4.0) * size * test::any_direction(random), test::any_rotation(random)};
        const Pose to{random.real(0.0, 4.0) * size * test::any_direction(random),
                      turned(from.rotation, test::any_direction(random), random.real(0.0, 0.5))};
        const auto gap = [&](const Pose& at) {
            const PlacedBody body(shape, 1.0f, at);
            const PlacedCollider collider = test::place(solid, at.position);
            const Nearest nearest = nearest_points(body, collider, 1e300);
            return (nearest.overlap ? 0.0 : nearest.lower) - static_cast<double>(body.radius) - collider.radius;
        };
        if (gap(from) <= 0.0) continue;
        ++checked;
        const float fraction = free_fraction(shape, 1.0f, from, to, solid);
        for (uint32_t k = 1; k <= 20; ++k) {
            const double there = gap(between(from, to, fraction * static_cast<float>(k) / 20.0f));
            deepest = std::min(deepest, there / static_cast<double>(shape.thickness));
        }
        if (fraction < 1.0f) {
            ++stopped;
            early += gap(between(from, to, fraction)) > 0.05 * static_cast<double>(size);
        }
    }
    INFO("checked " << checked << ", stopped " << stopped << ", deepest " << deepest << ", early " << early);
    CHECK(stopped > checked / 10);
    CHECK(deepest > -0.11);
    CHECK(early < stopped / 50);
}

TEST_CASE("peaks of a heightfield are not jumped") {
    test::Random random(7);
    test::Solid hill;
    std::vector<float> heights(size_t{21} * 21, 0.0f);
    for (uint32_t k = 0; k < 21; ++k) heights[k * 21 + 10] = 0.3f; // a ridge 0.3 m high and 2 cm wide
    REQUIRE(hill.make_field(21, 21, 0.01f, heights));
    const BodyShape shape = test::leaf(0.01f, 1e-4f);
    for (uint32_t i = 0; i < 2000; ++i) {
        const Pose from{{0.01f, random.real(0.05, 0.25), random.real(0.02, 0.18)}, test::any_rotation(random)};
        const Pose to{{0.3f, from.position.y, from.position.z}, test::any_rotation(random)};
        const Pose at = between(from, to, free_fraction(shape, 1.0f, from, to, hill));
        CHECK(at.position.x < 0.1f);
        CHECK(at.position.x > 0.06f);
        const Pose above{{0.01f, 0.32f, from.position.z}, from.rotation}, over{{0.19f, 0.32f, 0.1f}, from.rotation};
        CHECK(free_fraction(shape, 1.0f, above, over, hill) == 1.0f);
    }
}

TEST_CASE("a long way over a heightfield looks at the cells about it alone, and jumps no peak") {
    test::Random random(8);
    test::Solid field;
    constexpr uint32_t side = 1500;
    std::vector<float> heights(size_t{side} * side, 0.0f);
    for (uint32_t i = 0; i < side * side / 2000; ++i) heights[random.below(side * side)] = 3.0f; // needles
    REQUIRE(field.make_field(side, side, 0.01f, heights));
    const BodyShape shape = test::leaf(0.05f, 1e-3f);
    const auto place = [&] { return random.real(-1.0, 0.01 * side + 1.0); };
    const auto free = [&](const Pose& a, const Pose& b) { return free_fraction(shape, 1.0f, a, b, field); };
    uint32_t met = 0, missed = 0;
    using Clock = std::chrono::steady_clock;
    Clock::duration at_once{}, in_pieces{};
    for (uint32_t i = 0; i < 200; ++i) {
        const float height = random.real(0.2, 3.5);
        const Pose from{{place(), height, place()}, test::any_rotation(random)};
        Pose to{{place(), random.real(0.2, 3.5), place()}, test::any_rotation(random)};
        if (i % 10 == 0) to.position.x = from.position.x;
        if (i % 10 == 1) to.position.z = from.position.z;
        const Clock::time_point since = Clock::now();
        const float fraction = free(from, to);
        const Clock::time_point then = Clock::now();
        at_once += then - since;
        met += fraction < 1.0f;
        // Piece by piece, each over few cells; no piece hits earlier.
        constexpr uint32_t pieces = 100;
        for (uint32_t k = 0; k < pieces; ++k) {
            const float begin = static_cast<float>(k) / pieces, end = static_cast<float>(k + 1) / pieces;
            if (end > fraction) break;
            missed += free(between(from, to, begin), between(from, to, end)) < 1.0f;
        }
        in_pieces += Clock::now() - then;
    }
    CHECK(met > 20);
    CHECK(met < 180);
    CHECK(missed == 0);
    CHECK(at_once.count() < 25 * in_pieces.count());
}
