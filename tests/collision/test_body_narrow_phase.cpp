#include "collision/body_narrow_phase.h"

#include "collision/convex_separation.h"
#include "found_pair.h"
#include "random_pairs.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

using namespace lr;

namespace {

BodyShape some_shape(uint32_t which, float size, test::Random& random) {
    switch (which) {
    case 0:
        return test::leaf(size, size * random.real(0.002, 0.02));
    case 1: // a card
        return make_body_shape(
            test::asset_of(test::box_corners(0.5f * size, size * random.real(0.2, 0.5), 0.004f * size)));
    case 2:
        return make_body_shape(test::asset_of(test::box_corners(0.5f * size, 0.3f * size, 0.2f * size)));
    case 3:
        return make_body_shape(test::asset_of(test::cloud(random, 20, 0.5f * size)));
    case 4:
        return test::ellipsoid(0.5f * size, size * random.real(0.1, 0.5), size * random.real(0.002, 0.01));
    default:
        return test::ellipsoid(0.5f * size, size * random.real(0.1, 0.5), size * random.real(0.1, 0.5));
    }
}
constexpr uint32_t shapes = 6;

// A few of each kind, about `size` large.
std::vector<PairHull> some_shapes(float size, test::Random& random) {
    std::vector<PairHull> pool;
    for (uint32_t i = 0; i < 10 * shapes; ++i) pool.push_back(make_pair_hull(some_shape(i % shapes, size, random)));
    return pool;
}

Vector world_of(const Pose& at, Vector arm) {
    return at.position + rotate(at.rotation, arm);
}

std::vector<Double3> placed_points(const BodyShape& shape, float scale, const Pose& at) {
    std::vector<Double3> points;
    const Rotation q = at.rotation;
    const Double3 axis = to_double(Vector{q.x, q.y, q.z});
    const auto w = static_cast<double>(q.w);
    for (uint32_t i = 0; i < shape.count; ++i) {
        const Double3 p = static_cast<double>(scale) * to_double(Vector{shape.x[i], shape.y[i], shape.z[i]});
        const Double3 t = 2.0 * cross(axis, p);
        points.push_back(to_double(at.position) + p + w * t + cross(axis, t));
    }
    return points;
}

double highest(const std::vector<Double3>& points, Double3 d) {
    double most = -1e300;
    for (const Double3& p : points) most = std::max(most, dot(p, d));
    return most;
}

struct Placed {
    PairHull shape;
    float scale;
    Pose at;
    std::vector<Double3> points;

    Placed(const PairHull& s, float size, const Pose& pose)
        : shape(s), scale(size), at(pose), points(placed_points(s.shape, size, pose)) {}
    double radius() const { return static_cast<double>(scale * shape.shape.radius); }
    double reach() const { return static_cast<double>(scale * shape.shape.reach); }
};

uint32_t find(const Placed& a, const Placed& b, float margin, PairContact (&out)[most_pair_contacts]) {
    return test::find_pair_contacts(a.shape, a.scale, a.at, b.shape, b.scale, b.at, margin, out);
}

// Distance of the cores, in double; 0 for overlap.
bool core_distance(const Placed& a, const Placed& b, double& distance, Double3* normal = nullptr) {
    std::vector<float> vertices;
    const Double3 origin = to_double(a.at.position);
    for (const Double3& p : b.points)
        for (const double c : {p.x - origin.x, p.y - origin.y, p.z - origin.z})
            vertices.push_back(static_cast<float>(c));
    const HullGeometry hull{static_cast<uint32_t>(b.points.size()), 0, vertices.data(), nullptr};
    Geometry geometry{};
    geometry.kind = ColliderKind::hull;
    geometry.hull = &hull;
    const Pose at{{0.0f, 0.0f, 0.0f}, a.at.rotation};
    const Nearest nearest =
        nearest_points(PlacedBody(a.shape.shape, a.scale, at), PlacedCollider(geometry, at.position), 1e300);
    distance = nearest.distance;
    if (normal) *normal = nearest.normal;
    return !nearest.overlap;
}

// Depth of overlapping cores: the least over all faces and pairs of edges.
double core_depth(const Placed& a, const Placed& b) {
    double best = -1e300;
    std::vector<Double3> edges[2];
    const auto offer = [&](Double3 n) {
        const double size = length(n);
        if (!(size > 1e-12)) return;
        n = 1.0 / size * n;
        best = std::max(
            {best, -highest(a.points, -n) - highest(b.points, n), -highest(a.points, n) - highest(b.points, -n)});
    };
    for (const Placed* body : {&a, &b}) {
        const BodyShape& s = body->shape.shape;
        for (uint32_t f = 0; f < s.face_count; ++f)
            for (uint32_t i = 0; i < s.faces[f].count; ++i) {
                const auto corner = [&](uint32_t k) {
                    return body->points[s.corners[s.faces[f].first + k % s.faces[f].count]];
                };
                const Double3 edge = corner(i + 1) - corner(i);
                edges[body == &a ? 0 : 1].push_back(edge);
                if (i == 0) offer(cross(edge, corner(2) - corner(0)));
            }
    }
    for (const Double3& e : edges[0])
        for (const Double3& f : edges[1]) offer(cross(e, f));
    return -best;
}

// Distance of a point outside a body; negative inside. Exact outside near faces, elsewhere a bound.
double outside(const Placed& body, Vector arm) {
    const Placed point(
        [] {
            PairHull s{};
            s.shape.count = 1;
            return s;
        }(),
        1.0f, {world_of(body.at, arm), {0.0f, 0.0f, 0.0f, 1.0f}});
    double distance = 0.0;
    if (core_distance(point, body, distance)) return distance - body.radius();
    double most = -1e300;
    for (uint32_t f = 0; f < body.shape.shape.face_count; ++f)
        most = std::max(most, static_cast<double>(dot(body.shape.shape.faces[f].normal, arm) -
                                                  body.scale * body.shape.shape.faces[f].offset));
    return most - body.radius();
}

} // namespace

TEST_CASE("contacts of random pairs: distances, normals, points of the surfaces, none missed") {
    test::Random random(11);
    uint32_t touching = 0, apart = 0, several = 0;
    double worst_gap = 0.0, worst_normal = 0.0, worst_surface = 0.0, worst_arm = 0.0, worst_beyond = 0.0;
    const float sizes[] = {1e-3f, 0.03f, 1.0f};
    const std::vector<PairHull> pools[] = {some_shapes(sizes[0], random), some_shapes(sizes[1], random),
                                           some_shapes(sizes[2], random)};
    for (uint32_t i = 0; i < test::rounds(60000); ++i) {
        const uint32_t pool = random.below(3);
        const auto scale = static_cast<float>(random.logarithmic(0.05, 20.0));
        const auto ratio = static_cast<float>(random.logarithmic(0.3, 3.0));
        const PairHull& shape_a = pools[pool][random.below(60)];
        const PairHull& shape_b = pools[pool][random.below(60)];
        const float reach = scale * sizes[pool];
        const Vector somewhere = 3.0f * reach * test::any_direction(random);
        const Placed a(shape_a, scale, {somewhere, test::any_rotation(random)});
        Placed b(shape_b, scale * ratio,
                 {somewhere + random.real(0.0, 0.6) * (1.0f + ratio) * reach * test::any_direction(random),
                  test::any_rotation(random)});
        const float margin = random.real(0.0, 0.05) * reach;
        double distance = 0.0;
        Double3 towards{};
        if (!core_distance(a, b, distance, &towards)) continue;
        // Most of them about the margin apart.
        const double wanted = random.uniform(0.0, 1.3) * (static_cast<double>(margin) + a.radius() + b.radius());
        if (random.below(4) > 0)
            b = Placed(shape_b, b.scale, {b.at.position + to_float((distance - wanted) * towards), b.at.rotation});
        PairContact out[most_pair_contacts];
        const uint32_t count = find(a, b, margin, out);
        if (!core_distance(a, b, distance) || distance < 2e-4 * static_cast<double>(reach)) continue;
        const double least = std::min(a.reach(), b.reach()), gap = distance - a.radius() - b.radius();
        const double rounding = 1e-5 * std::max(a.reach(), b.reach());
        if (gap < static_cast<double>(margin) - rounding) {
            INFO("round " << i << ": gap " << gap << ", margin " << margin);
            REQUIRE(count > 0);
        }
        if (count == 0) {
            ++apart;
            continue;
        }
        ++touching;
        several += count > 1;
        worst_beyond = std::max(worst_beyond, (gap - static_cast<double>(margin)) / least);
        double deepest = 1e300;
        for (uint32_t k = 0; k < count; ++k) {
            const PairContact& c = out[k];
            REQUIRE(std::abs(length(c.normal) - 1.0f) < 1e-5f);
            const auto here = static_cast<double>(c.gap);
            deepest = std::min(deepest, here);
            const Vector between = world_of(a.at, c.arm_a) - world_of(b.at, c.arm_b);
            worst_arm =
                std::max(worst_arm, static_cast<double>(length(between - c.gap * c.normal)) / (a.reach() + b.reach()));
            worst_surface = std::max({worst_surface, outside(a, c.arm_a) / least, outside(b, c.arm_b) / least});
        }
        const Double3 n = to_double(out[0].normal);
        // Along the normal their separation equals their distance.
        const double along = -highest(a.points, -n) - highest(b.points, n) - a.radius() - b.radius();
        worst_normal = std::max(worst_normal, std::abs(along - gap) / least);
        worst_gap = std::max(worst_gap, std::abs(deepest - gap) / least);
    }
    INFO(touching << " touch, " << several << " with several, " << apart << " apart; errors: gap " << worst_gap
                  << ", normal " << worst_normal << ", arms " << worst_arm << ", surface " << worst_surface
                  << ", beyond " << worst_beyond);
    CHECK(touching > test::rounds(10000));
    CHECK(several > test::rounds(2000));
    CHECK(apart > test::rounds(10000));
    CHECK(worst_gap < 0.01);
    CHECK(worst_normal < 0.01);
    CHECK(worst_arm < 2e-6);
    CHECK(worst_surface < 2e-3);
    CHECK(worst_beyond < 2e-3);
}

TEST_CASE("cores that overlap are led out by about the least way, the same for both orders") {
    test::Random random(12);
    uint32_t overlapping = 0, worse = 0;
    double excess = 0.0, contradiction = 0.0;
    const std::vector<PairHull> pool = some_shapes(0.05f, random);
    for (uint32_t i = 0; i < test::rounds(6000); ++i) {
        const PairHull &shape_a = pool[random.below(60)], &shape_b = pool[random.below(60)];
        const Placed a(shape_a, 1.0f, {{0.0f, 0.0f, 0.0f}, test::any_rotation(random)});
        const Placed b(shape_b, 1.0f,
                       {random.real(0.0, 0.04) * test::any_direction(random), test::any_rotation(random)});
        double distance = 0.0;
        if (core_distance(a, b, distance)) continue;
        ++overlapping;
        PairContact out[most_pair_contacts], back[most_pair_contacts];
        const uint32_t count = find(a, b, 1e-3f, out);
        REQUIRE(count > 0);
        REQUIRE(find(b, a, 1e-3f, back) == count);
        for (uint32_t k = 0; k < count; ++k) {
            CHECK(out[k].gap == back[k].gap);
            CHECK(length(out[k].normal + back[k].normal) == 0.0f);
            CHECK(length(out[k].arm_a - back[k].arm_b) == 0.0f);
        }
        const double depth = core_depth(a, b), least = std::min(a.reach(), b.reach());
        float gap = out[0].gap;
        for (uint32_t k = 1; k < count; ++k) gap = std::min(gap, out[k].gap);
        const double found = -static_cast<double>(gap) - a.radius() - b.radius();
        CHECK(found > depth - 0.01 * least);
        const Double3 n = to_double(out[0].normal);
        const double along = highest(a.points, -n) + highest(b.points, n);
        contradiction = std::max(contradiction, std::abs(along - found) / least);
        worse += along > 1.1 * depth + 0.01 * least;
        excess = std::max(excess, (along - depth) / least);
    }
    INFO(overlapping << " overlap, " << worse << " deeper than the least by a tenth, most " << excess
                     << " of the reach; contradiction " << contradiction);
    CHECK(overlapping > test::rounds(2000));
    CHECK(contradiction < 0.01);
    CHECK(worse * 20 < overlapping);
    CHECK(excess < 0.3);
}

namespace {

// Contacts seen from above, and whether a point lies between them.
bool between(const Placed& a, const PairContact* out, uint32_t count, double x, double y) {
    // Outside if a line through two of them has all others on one side and the point on the other.
    for (uint32_t i = 0; i < count; ++i)
        for (uint32_t j = 0; j < count; ++j) {
            if (i == j) continue;
            const Double3 p = to_double(world_of(a.at, out[i].arm_a)), q = to_double(world_of(a.at, out[j].arm_a));
            const auto side = [&](double u, double v) { return (q.x - p.x) * (v - p.y) - (q.y - p.y) * (u - p.x); };
            bool all_left = true;
            for (uint32_t k = 0; k < count; ++k) {
                const Double3 r = to_double(world_of(a.at, out[k].arm_a));
                all_left = all_left && (k == i || k == j || side(r.x, r.y) >= 0.0);
            }
            if (all_left && side(x, y) < 0.0) return false;
        }
    return count >= 3;
}

PairHull card(float x, float y) {
    return make_pair_hull(make_body_shape(test::asset_of(test::box_corners(x, y, 2e-3f * x))));
}

Rotation about(Vector axis, double angle) {
    const auto s = static_cast<float>(std::sin(0.5 * angle));
    return {s * axis.x, s * axis.y, s * axis.z, static_cast<float>(std::cos(0.5 * angle))};
}

} // namespace

TEST_CASE("a plate that lies on another is held around what both cover") {
    test::Random random(13);
    const PairHull lower = card(0.1f, 0.06f);
    const PairHull uppers[] = {card(0.1f, 0.06f), card(0.2f, 0.02f), make_pair_hull(test::leaf(0.1f, 3e-4f)),
                               make_pair_hull(test::ellipsoid(0.05f, 0.03f, 2e-4f))};
    uint32_t beside = 0;
    for (uint32_t i = 0; i < test::rounds(4000); ++i) {
        const PairHull& upper = uppers[i % 4];
        const float gap = random.real(1e-5, 2e-4);
        const Placed b(lower, 1.0f, {{1.0f, 2.0f, 3.0f}, about({0, 0, 1}, random.uniform(-3.0, 3.0))});
        const float height = gap + lower.shape.radius + upper.shape.radius;
        // Rotated so that it lies in z = const.
        const Rotation flat = about({0, 0, 1}, random.uniform(-3.0, 3.0)) * inverse(upper.frame);
        const Placed a(upper, 1.0f,
                       {{1.0f + random.real(-0.02, 0.02), 2.0f + random.real(-0.02, 0.02), 3.0f + height}, flat});
        PairContact out[most_pair_contacts];
        const uint32_t count = find(a, b, 1e-3f, out);
        REQUIRE(count >= 3);
        // The middle of the common area, and the middle of the way from there to its end.
        const auto covered = [&](double x, double y) {
            for (const Placed* body : {&a, &b}) {
                const Vector p = rotate(inverse(body->at.rotation * body->shape.frame),
                                        Vector{static_cast<float>(x), static_cast<float>(y), 3.0f} - body->at.position -
                                            rotate(body->at.rotation, body->shape.origin));
                const BodyShape& shape = body->shape.shape;
                const ShapeFace& face = shape.faces[0];
                const auto corner = [&](uint32_t k) {
                    return rotate(inverse(body->shape.frame), shape.corner(face, k % face.count) - body->shape.origin);
                };
                const float sense = rotate(inverse(body->shape.frame), face.normal).z;
                for (uint32_t k = 0; k < face.count; ++k)
                    if (sense * cross(corner(k + 1) - corner(k), p - corner(k)).z < 0.0f) return false;
            }
            return true;
        };
        double middle[2] = {}, area = 0.0;
        for (int u = -60; u <= 60; ++u)
            for (int v = -60; v <= 60; ++v) {
                const double x = 1.0 + u * 2e-3, y = 2.0 + v * 2e-3;
                if (!covered(x, y)) continue;
                middle[0] += x;
                middle[1] += y;
                area += 1.0;
            }
        beside += !between(a, out, count, middle[0] / area, middle[1] / area);
        for (uint32_t k = 0; k < count; ++k) {
            CHECK(out[k].gap == doctest::Approx(static_cast<double>(gap)).epsilon(0.02));
            CHECK(out[k].normal.z > 0.9999f);
        }
    }
    // Four of eight corners miss the middle if the eight are unevenly spaced.
    INFO(beside << " of them do not hold the middle");
    CHECK(beside * 200 < test::rounds(4000));
}

TEST_CASE("aligned cards share four corners, a leaning one two, a corner one") {
    const PairHull plate = card(0.1f, 0.06f), small = card(0.03f, 0.02f);
    const Placed b(plate, 1.0f, {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f, 1.0f}});
    const float radii = plate.shape.radius + small.shape.radius;
    PairContact out[most_pair_contacts];
    const auto span = [&](uint32_t count) {
        float most = 0.0f;
        for (uint32_t i = 0; i < count; ++i)
            for (uint32_t j = 0; j < i; ++j) most = std::max(most, length(out[i].arm_a - out[j].arm_a));
        return most;
    };
    const Placed flat(small, 1.0f, {{0.01f, -0.02f, radii + 1e-5f}, {0.0f, 0.0f, 0.0f, 1.0f}});
    REQUIRE(find(flat, b, 1e-4f, out) == 4);
    const float half_diagonal = length(Vector{small.core_half.x, small.core_half.y, 0.0f});
    for (const PairContact& c : out)
        CHECK(length(Vector{c.arm_a.x, c.arm_a.y, 0.0f}) ==
              doctest::Approx(static_cast<double>(half_diagonal)).epsilon(1e-3));
    CHECK(span(4) == doctest::Approx(2.0 * static_cast<double>(half_diagonal)).epsilon(1e-3));

    const auto lowest = [&](Rotation q) {
        float z = 0.0f;
        for (uint32_t i = 0; i < small.shape.count; ++i)
            z = std::min(z, rotate(q, {small.shape.x[i], small.shape.y[i], small.shape.z[i]}).z);
        return z;
    };
    for (const double angle : {0.1, 0.7, 1.3, 1.5}) { // about its longer side
        const Rotation tilted = about({1, 0, 0}, angle);
        const Placed leaning(small, 1.0f, {{0.01f, -0.02f, radii + 1e-5f - lowest(tilted)}, tilted});
        REQUIRE(find(leaning, b, 1e-4f, out) == 2);
        CHECK(span(2) ==
              doctest::Approx(2.0 * static_cast<double>(std::max(small.core_half.x, small.core_half.y))).epsilon(1e-3));
        CHECK(out[0].gap == doctest::Approx(1e-5).epsilon(0.01));
        CHECK(out[1].gap == doctest::Approx(1e-5).epsilon(0.01));
    }
    const Rotation tipped = about({0, 1, 0}, 0.6) * about({1, 0, 0}, 0.6);
    const Placed corner(small, 1.0f, {{0.0f, 0.0f, radii + 1e-5f - lowest(tipped)}, tipped});
    REQUIRE(find(corner, b, 1e-4f, out) == 1);
    CHECK(out[0].normal.z > 0.9999f);
    CHECK(out[0].gap == doctest::Approx(1e-5).epsilon(0.01));
}

TEST_CASE("degenerate pairs give finite contacts, what is not finite none") {
    test::Random random(14);
    const std::vector<PairHull> pool = some_shapes(0.05f, random);
    const float bad = std::numeric_limits<float>::quiet_NaN(), endless = std::numeric_limits<float>::infinity();
    const auto all_finite = [&](const PairContact* out, uint32_t count) {
        for (uint32_t i = 0; i < count; ++i) {
            CHECK(std::abs(length(out[i].normal) - 1.0f) < 1e-5f);
            CHECK(std::isfinite(length(out[i].arm_a) + length(out[i].arm_b) + out[i].gap));
        }
    };
    PairContact out[most_pair_contacts];
    for (uint32_t i = 0; i < test::rounds(6000); ++i) {
        const PairHull &a = pool[random.below(60)], &b = pool[random.below(60)];
        const Pose at{{1.0f, 2.0f, 3.0f}, test::any_rotation(random)};
        // In the same place, with the same rotation or another, of the same size or hundreds of times as large.
        const Pose other{at.position, i % 2 == 0 ? at.rotation : test::any_rotation(random)};
        const float ratio = i % 3 == 0 ? 1.0f : i % 3 == 1 ? 400.0f : 0.0025f;
        const float margin = i % 5 == 0 ? 0.0f : 1e-3f;
        const uint32_t count = test::find_pair_contacts(a, 1.0f, at, i % 4 == 0 ? a : b, ratio, other, margin, out);
        REQUIRE(count > 0);
        all_finite(out, count);
        CHECK(out[0].gap < 0.0f);
        // Near the surface of a large body.
        const Pose far{at.position + ratio * b.shape.reach * random.real(0.0, 1.0) * test::any_direction(random),
                       other.rotation};
        all_finite(out, test::find_pair_contacts(a, 1.0f, at, b, ratio, far, margin, out));
        Pose wrong = at;
        float* const numbers[] = {&wrong.position.x, &wrong.position.z, &wrong.rotation.x, &wrong.rotation.w};
        *numbers[i % 4] = i % 8 < 4 ? bad : endless;
        CHECK(test::find_pair_contacts(a, 1.0f, wrong, b, 1.0f, other, margin, out) == 0);
        CHECK(test::find_pair_contacts(a, 1.0f, other, b, 1.0f, wrong, margin, out) == 0);
        CHECK(test::find_pair_contacts(a, bad, at, b, 1.0f, other, margin, out) == 0);
        CHECK(test::find_pair_contacts(a, 1.0f, at, b, 1.0f, other, bad, out) == 0);
    }
}

TEST_CASE("bounds hold the body and no more, ellipsoids keep their volume") {
    test::Random random(15);
    const std::vector<PairHull> pool = some_shapes(0.05f, random);
    for (uint32_t i = 0; i < test::rounds(3000); ++i) {
        const Placed body(pool[random.below(60)], random.real(0.1, 5.0),
                          {10.0f * test::any_direction(random), test::any_rotation(random)});
        const Box box = bounds(body.shape, body.scale, body.at);
        const double slack = 1e-5 * (10.0 + body.reach());
        const float low[3] = {box.low.x, box.low.y, box.low.z}, high[3] = {box.high.x, box.high.y, box.high.z};
        for (uint32_t k = 0; k < 3; ++k) {
            const Double3 axis{k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0};
            const double top = highest(body.points, axis) + body.radius(),
                         bottom = -highest(body.points, -axis) - body.radius();
            CHECK(static_cast<double>(high[k]) >= top - 1e-7 * body.reach() - 1e-6);
            CHECK(static_cast<double>(high[k]) <= top + slack);
            CHECK(static_cast<double>(low[k]) <= bottom + 1e-7 * body.reach() + 1e-6);
            CHECK(static_cast<double>(low[k]) >= bottom - slack);
        }
    }
    const float axes[][3] = {{1, 1, 1}, {2, 1, 1}, {1, 0.5f, 0.5f}, {4, 2, 1}, {5, 1, 1}, {2, 1, 0.1f}, {4, 1, 0.01f}};
    for (const auto& semi : axes) {
        const Placed body(make_pair_hull(test::ellipsoid(semi[0], semi[1], semi[2])), 1.0f,
                          {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f, 1.0f}});
        const Vector h = bounds(body.shape, body.scale, body.at).high;
        // On a grid: random points would have an error of 0.7 %, beside the 3 % by which the hulls are too large.
        const uint32_t side = 32;
        uint32_t inside = 0;
        const auto at = [](uint32_t k, float half) { return ((static_cast<float>(k) + 0.5f) / 16.0f - 1.0f) * half; };
        for (uint32_t i = 0; i < side; ++i)
            for (uint32_t j = 0; j < side; ++j)
                for (uint32_t k = 0; k < side; ++k)
                    inside += outside(body, {at(i, h.x), at(j, h.y), at(k, h.z)}) <= 0.0;
        const double volume = 8.0 * static_cast<double>(h.x * h.y * h.z) * inside / (side * side * side);
        const double wanted = 4.0 / 3.0 * std::numbers::pi * static_cast<double>(semi[0] * semi[1] * semi[2]);
        INFO(semi[0] << " " << semi[1] << " " << semi[2]);
        CHECK(volume == doctest::Approx(wanted).epsilon(0.04));
    }
}

TEST_CASE("of a body deep in one that is far larger, contacts lie on both") {
    test::Random random(13);
    const std::vector<PairHull> pool = some_shapes(0.05f, random);
    double worst = 0.0;
    uint32_t found = 0;
    for (uint32_t i = 0; i < test::rounds(6000); ++i) {
        const PairHull &small = pool[random.below(60)], &large = pool[random.below(60)];
        const auto ratio = static_cast<float>(random.logarithmic(1.0, 1e5));
        const Vector somewhere = 0.5f * ratio * large.shape.reach * random.real(0.0, 1.0) * test::any_direction(random);
        const Pose at_a{somewhere, test::any_rotation(random)};
        const Pose at_b{{0.0f, 0.0f, 0.0f}, test::any_rotation(random)};
        PairContact out[most_pair_contacts];
        const uint32_t count = test::find_pair_contacts(small, 1.0f, at_a, large, ratio, at_b, 1e-3f, out);
        for (uint32_t k = 0; k < count; ++k) {
            ++found;
            worst = std::max({worst, static_cast<double>(length(out[k].arm_a) / small.shape.reach),
                              static_cast<double>(length(out[k].arm_b) / (ratio * large.shape.reach))});
        }
    }
    INFO(found << " contacts, farthest " << worst << " of the reach");
    CHECK(found > test::rounds(3000));
    CHECK(worst < 1.1);
}
