// Crossing faces, and their exact predicates.
#include "baker/fault_text.h"
#include "baker/mesh/exact_predicates.h"
#include "baker/mesh/mesh_check.h"
#include "baker/mesh/self_intersection.h"
#include "mesh_shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace lr;
using namespace lr::baker;

namespace {

__extension__ using Wide = __int128;

int sign(Wide x) {
    return (x > 0) - (x < 0);
}

Mesh two_faces(const std::vector<Eigen::Vector3d>& vertices, const Face& a, const Face& b) {
    Mesh mesh;
    mesh.vertices = vertices;
    mesh.faces = {a, b};
    return mesh;
}

// Checks a pair in many places, sizes, orders and windings.
void check_pair(const std::vector<Eigen::Vector3d>& vertices, const Face& a, const Face& b, bool meet) {
    std::mt19937 random(9);
    for (int i = 0; i < 50; ++i) {
        Face f = a, g = b;
        std::shuffle(f.begin(), f.end(), random);
        std::shuffle(g.begin(), g.end(), random);
        Mesh mesh = i % 2 ? two_faces(vertices, f, g) : two_faces(vertices, g, f);
        // Quarter turns, shifts and powers of two: exact, so that touching faces still touch.
        const double scale = std::ldexp(1.0, i - 25);
        for (Eigen::Vector3d& v : mesh.vertices) v = scale * Eigen::Vector3d(v.y() + i, -v.x() - 3.0, v.z() + 0.5 * i);
        CHECK(find_self_intersections(mesh, 10).pairs.size() == (meet ? 1U : 0U));
    }
}

Mesh joined(const Mesh& a, const Mesh& b) {
    Mesh mesh = a;
    const auto base = static_cast<uint32_t>(a.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const Face& f : b.faces) mesh.faces.push_back({base + f[0], base + f[1], base + f[2]});
    return mesh;
}

Mesh shifted(Mesh mesh, const Eigen::Vector3d& by) {
    test::apply(mesh, Eigen::Matrix3d::Identity(), by);
    return mesh;
}

} // namespace

TEST_CASE("exact predicates: signs of determinants of integers, where doubles round") {
    std::mt19937 random(4);
    for (int i = 0; i < 20000; ++i) {
        // Nearly on a line, in coordinates of 50 bits; and of 40 in space.
        std::uniform_int_distribution<int64_t> wide(-(int64_t{1} << 49), int64_t{1} << 49);
        std::uniform_int_distribution<int64_t> small(-2, 2);
        const int64_t ax = wide(random), ay = wide(random), dx = wide(random) >> 20, dy = wide(random) >> 20;
        const int64_t n = wide(random) >> 42, bx = ax + dx + small(random), by = ay + dy + small(random);
        const int64_t cx = ax + n * dx + small(random), cy = ay + n * dy + small(random);
        const Wide exact = Wide{bx - ax} * (cy - ay) - Wide{by - ay} * (cx - ax);
        const auto at = [](int64_t x, int64_t y) {
            return Eigen::Vector2d(static_cast<double>(x), static_cast<double>(y));
        };
        REQUIRE(orientation(at(ax, ay), at(bx, by), at(cx, cy)) == sign(exact));
    }
    std::size_t zeros = 0;
    for (int i = 0; i < 20000; ++i) {
        std::uniform_int_distribution<int64_t> wide(-(int64_t{1} << 38), int64_t{1} << 38);
        std::uniform_int_distribution<int64_t> small(-1, 1), few(-30, 30);
        int64_t p[4][3];
        for (int k = 0; k < 3; ++k) {
            p[0][k] = wide(random);
            p[1][k] = p[0][k] + (wide(random) >> 8);
            p[2][k] = p[0][k] + (wide(random) >> 8);
        }
        const int64_t m = few(random), n = few(random);
        for (int k = 0; k < 3; ++k)
            p[3][k] = p[0][k] + m * (p[1][k] - p[0][k]) + n * (p[2][k] - p[0][k]) + (i % 2 ? small(random) : 0);
        Wide d[3][3];
        for (int r = 0; r < 3; ++r)
            for (int k = 0; k < 3; ++k) d[r][k] = p[r + 1][k] - p[0][k];
        const Wide exact = d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
                           d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
                           d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
        Eigen::Vector3d v[4];
        for (int r = 0; r < 4; ++r)
            for (int k = 0; k < 3; ++k) v[r][k] = static_cast<double>(p[r][k]);
        REQUIRE(orientation(v[0], v[1], v[2], v[3]) == sign(exact));
        zeros += exact == 0;
    }
    CHECK(zeros >= 10000);
}

TEST_CASE("self-intersection: two faces") {
    const std::vector<Eigen::Vector3d> v = {{0, 0, 0},  {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {2, 1, 1},
                                            {1, 1, 0},  {4, 4, 0}, {3, 3, 0}, {2, 2, 0},  {1, 0, 0}, {3, 0, 0},
                                            {2, -3, 0}, {9, 9, 5}, {2, 0, 3}, {0, 0, 3},  {1, 2, 0}, {-4, 0, 0}};
    check_pair(v, {0, 1, 2}, {3, 4, 5}, true);    // crossing
    check_pair(v, {0, 1, 2}, {6, 4, 5}, true);    // a corner on the face
    check_pair(v, {0, 1, 2}, {9, 7, 4}, true);    // a corner on an edge
    check_pair(v, {0, 1, 2}, {8, 7, 4}, false);   // a corner beside an edge
    check_pair(v, {0, 1, 2}, {4, 5, 13}, false);  // above
    check_pair(v, {0, 1, 2}, {10, 11, 12}, true); // along a part of an edge
    check_pair(v, {0, 1, 2}, {6, 10, 16}, true);  // within, in the plane
    check_pair(v, {0, 1, 2}, {8, 7, 13}, false);  // beside, from the plane up
    check_pair(v, {0, 1, 2}, {0, 4, 5}, false);   // one corner shared
    check_pair(v, {0, 1, 2}, {0, 17, 12}, false); // likewise, in one plane
    check_pair(v, {0, 1, 2}, {0, 7, 13}, true);   // one corner shared, and through the face
    check_pair(v, {0, 1, 2}, {0, 3, 4}, true);    // likewise, through its middle
    check_pair(v, {0, 1, 2}, {1, 2, 7}, false);   // a square
    check_pair(v, {0, 1, 2}, {1, 2, 6}, true);    // folded flat
    check_pair(v, {0, 1, 2}, {1, 2, 4}, false);   // folded sharply
    check_pair(v, {0, 1, 2}, {0, 1, 14}, false);  // at a right angle
    check_pair(v, {0, 1, 2}, {1, 0, 2}, true);    // the same
}

TEST_CASE("self-intersection: sound surfaces have none, wherever they lie") {
    for (const double scale : {1e-9, 1e-3, 1.0, 1e9})
        for (Mesh mesh :
             {test::icosphere(3), test::cube(6), test::leaf(20, 5, 1e-4, 0.1), test::box({1, 1, 1e-3}, {8, 8, 1})}) {
            CHECK(find_self_intersections(mesh, 10).pairs.empty());
            test::apply(mesh, scale * test::some_rotation(), scale * Eigen::Vector3d(3, -4, 5));
            CHECK(find_self_intersections(mesh, 10).pairs.empty());
        }
    // Cubes that touch in one corner, with a vertex each.
    const Mesh cube = test::cube(2);
    CHECK(find_self_intersections(joined(cube, shifted(cube, {1, 1, 1})), 10).pairs.empty());
    CHECK_FALSE(find_self_intersections(joined(cube, shifted(cube, {1, 0.25, 0.25})), 10).pairs.empty());
}

TEST_CASE("self-intersection: each pair that crosses is found, as by looking at all") {
    std::mt19937 random(21);
    std::uniform_real_distribution<double> place(0.0, 1.0), side(-0.15, 0.15);
    Mesh soup;
    for (uint32_t i = 0; i < 300; ++i) {
        const Eigen::Vector3d middle(place(random), place(random), place(random));
        for (int k = 0; k < 3; ++k)
            soup.vertices.push_back(middle + Eigen::Vector3d(side(random), side(random), side(random)));
        soup.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    std::vector<std::pair<uint32_t, uint32_t>> all;
    for (uint32_t i = 0; i < 300; ++i)
        for (uint32_t k = i + 1; k < 300; ++k) {
            // In general position an edge of one face passes through the other; by Moeller and Trumbore's solution.
            const auto passes = [&](uint32_t f, uint32_t g) {
                const Eigen::Vector3d &a = soup.vertices[3 * g], &b = soup.vertices[3 * g + 1],
                                      &c = soup.vertices[3 * g + 2];
                for (uint32_t e = 0; e < 3; ++e) {
                    const Eigen::Vector3d &s = soup.vertices[3 * f + e], &t = soup.vertices[3 * f + (e + 1) % 3];
                    Eigen::Matrix3d m;
                    m << s - t, b - a, c - a;
                    const Eigen::Vector3d x = m.inverse() * (s - a);
                    if (x[0] >= 0 && x[0] <= 1 && x[1] >= 0 && x[2] >= 0 && x[1] + x[2] <= 1) return true;
                }
                return false;
            };
            if (passes(i, k) || passes(k, i)) all.emplace_back(i, k);
        }
    REQUIRE(all.size() > 100);
    const SelfIntersections found = find_self_intersections(soup, 1000000);
    CHECK(found.complete);
    CHECK(found.pairs == all);
    const SelfIntersections some = find_self_intersections(soup, 7);
    CHECK(some.pairs.size() == 7);
    CHECK_FALSE(some.complete);
}

TEST_CASE("self-intersection: a bake is told, and goes on") {
    const auto warnings = [](const Faults& faults) {
        return std::count_if(faults.begin(), faults.end(),
                             [](const Fault& f) { return f.id == FaultId::mesh_self_intersection; });
    };
    SUBCASE("a corner pulled through the far side") {
        Mesh mesh = test::icosphere(2);
        mesh.vertices[0] *= -1.3;
        Faults faults;
        CHECK(check_and_repair(mesh, faults));
        CHECK_FALSE(has_error(faults));
        REQUIRE(warnings(faults) == 1);
        CHECK(faults.back().where.starts_with("face 0 and "));
    }
    SUBCASE("crossed cards") {
        Mesh mesh;
        mesh.vertices = {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1},
                         {0, -1, -1}, {0, 1, -1}, {0, 1, 1}, {0, -1, 1}};
        mesh.faces = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
        Faults faults;
        CHECK(check_sheet(mesh, faults));
        CHECK(warnings(faults) == 1);
    }
    SUBCASE("parts of a solid that cross are refused, in whatever order") {
        const Mesh sphere = test::icosphere(2);
        for (const double distance : {-1.9, 1.9})
            for (const bool first : {false, true}) {
                const Mesh other = shifted(sphere, {distance, 0, 0});
                Mesh mesh = first ? joined(sphere, other) : joined(other, sphere);
                Faults faults;
                CHECK_FALSE(check_and_repair(mesh, faults));
                CHECK(faults.back().id == FaultId::mesh_several_components);
                CHECK(faults.back().severity == Severity::error);
            }
        Mesh apart = joined(sphere, shifted(sphere, {2.01, 0, 0}));
        Faults faults;
        CHECK(check_and_repair(apart, faults));
    }
}
