#include "asset/asset_file.h"
#include "baker/mesh/convex_hull.h"
#include "baker/mesh/mass_properties.h"
#include "baker/mesh/mesh_check.h"
#include "base/convex_hull.h"
#include "mesh_shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace lr;
using namespace lr::baker;

namespace {

// Closed and outward, a subset of the points, and no point outside any face.
void check_hull(const std::vector<Eigen::Vector3d>& points, const ConvexHull& hull) {
    double size = 0.0;
    for (const Eigen::Vector3d& p : points) size = std::max(size, (p - points[0]).norm());
    CHECK(hull.slack <= 1e-6 * size);
    Mesh mesh{hull.vertices, hull.faces, "hull"};
    Faults faults;
    CHECK(check_and_repair(mesh, faults));
    CHECK(faults.empty());
    CHECK(mesh.faces == hull.faces); // nothing turned
    double worst = -size;
    for (const Face& f : hull.faces) {
        const Eigen::Vector3d& a = hull.vertices[f[0]];
        const Eigen::Vector3d u = hull.vertices[f[1]] - a, v = hull.vertices[f[2]] - a;
        const Eigen::Vector3d normal = u.cross(v);
        // the normal of a sliver between almost collinear points is uncertain in proportion to its small width
        const double width = normal.norm() / std::max({u.norm(), v.norm(), (u - v).norm()});
        if (width < 100.0 * hull.slack) continue;
        for (const Eigen::Vector3d& p : points)
            worst = std::max(worst, normal.normalized().dot(p - a) - hull.slack * size / width);
    }
    CHECK(worst <= hull.slack);
    std::size_t next = 0;
    for (const Eigen::Vector3d& v : hull.vertices) {
        while (next < points.size() && points[next] != v) ++next;
        CHECK(next < points.size());
    }
}

} // namespace

TEST_CASE("hull of a cut-up box has eight corners, turned or not") {
    for (const bool turned : {false, true})
        for (const double thickness : {1.0, 1e-3}) {
            Mesh mesh = test::box({2.0, 1.0, thickness}, {8, 6, 3}, 0.3);
            if (turned) test::apply(mesh, 0.05 * test::some_rotation(), {1, 2, 3});
            ConvexHull hull;
            Faults faults;
            REQUIRE(compute_convex_hull(mesh.vertices, hull, faults));
            CHECK(hull.vertices.size() == 8);
            CHECK(hull.faces.size() == 12);
            check_hull(mesh.vertices, hull);
            const MassProperties p = compute_mass_properties({hull.vertices, hull.faces, ""});
            CHECK(p.volume == doctest::Approx(2.0 * thickness * (turned ? 0.05 * 0.05 * 0.05 : 1.0)).epsilon(1e-6));
        }
}

TEST_CASE("hull of points on a sphere keeps them all, inner points go") {
    Mesh mesh = test::icosphere(3);
    std::vector<Eigen::Vector3d> points = mesh.vertices;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-0.5, 0.5);
    for (int i = 0; i < 500; ++i) points.emplace_back(uniform(random), uniform(random), uniform(random));
    ConvexHull hull;
    Faults faults;
    REQUIRE(compute_convex_hull(points, hull, faults));
    CHECK(hull.vertices == mesh.vertices);
    CHECK(hull.faces.size() == mesh.faces.size());
    check_hull(points, hull);
    CHECK(compute_mass_properties({hull.vertices, hull.faces, ""}).volume ==
          doctest::Approx(compute_mass_properties(mesh).volume));
}

TEST_CASE("hulls of random, clustered, gridded and thin points") {
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    for (int round = 0; round < 60; ++round) {
        std::vector<Eigen::Vector3d> points;
        const int kind = round % 6;
        for (int i = 0; i < 200; ++i) {
            Eigen::Vector3d p(normal(random), normal(random), normal(random));
            if (kind == 1) p = (p * 2.0).array().round() / 2.0; // many coplanar, collinear and equal
            if (kind == 2) p.z() *= 1e-4;                       // paper
            if (kind == 3) p.z() = 1e-9 * p.z() + 0.1 * p.x();  // flat up to rounding
            if (kind == 4) p = p.normalized() + 1e-7 * p;       // cospherical
            if (kind == 5) p = p.normalized().array().pow(5);   // spikes
            points.emplace_back(1e-3 * (test::some_rotation() * p));
        }
        ConvexHull hull;
        Faults faults;
        CAPTURE(round);
        REQUIRE(compute_convex_hull(points, hull, faults));
        if (kind != 3) check_hull(points, hull);
        ConvexHull again;
        REQUIRE(compute_convex_hull(points, again, faults));
        CHECK(again.vertices == hull.vertices);
        CHECK(again.faces == hull.faces);
    }
}

TEST_CASE("a leaf blade's hull") {
    Mesh mesh = test::leaf(30, 8, 0.0075, 0.1);
    test::apply(mesh, 0.04 * test::some_rotation());
    ConvexHull hull;
    Faults faults;
    REQUIRE(compute_convex_hull(mesh.vertices, hull, faults));
    check_hull(mesh.vertices, hull);
    CHECK(hull.vertices.size() < mesh.vertices.size());
    CHECK(compute_mass_properties({hull.vertices, hull.faces, ""}).volume > compute_mass_properties(mesh).volume);
}

TEST_CASE("flat points give a two-sided polygon") {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i <= 4; ++i)
        for (int j = 0; j <= 4; ++j) points.emplace_back(test::some_rotation() * Eigen::Vector3d(i, 2 * j, 0));
    ConvexHull hull;
    Faults faults;
    REQUIRE(compute_convex_hull(points, hull, faults));
    CHECK(hull.vertices.size() == 4);
    CHECK(hull.faces.size() == 4);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double area = 0.0;
    for (const Face& f : hull.faces) {
        const Eigen::Vector3d twice =
            (hull.vertices[f[1]] - hull.vertices[f[0]]).cross(hull.vertices[f[2]] - hull.vertices[f[0]]);
        sum += twice;
        area += 0.5 * twice.norm();
    }
    CHECK(sum.norm() < 1e-9);
    CHECK(area == doctest::Approx(2.0 * 32.0));
}

TEST_CASE("points without a hull are refused by number") {
    const auto refused = [](const std::vector<Eigen::Vector3d>& points) {
        ConvexHull hull;
        Faults faults;
        CHECK_FALSE(compute_convex_hull(points, hull, faults));
        REQUIRE(faults.size() == 1);
        return faults[0].id;
    };
    CHECK(refused({}) == FaultId::mesh_empty);
    CHECK(refused({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}) == FaultId::mesh_zero_volume);
    CHECK(refused({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}) == FaultId::mesh_zero_volume);
    CHECK(refused({{0, 0, 0}, {1, 0, 0}, {0, std::numeric_limits<double>::quiet_NaN(), 0}}) ==
          FaultId::mesh_not_finite);
}

TEST_CASE("stored hulls are convex by the asset's rules: slivers, thin sheets, clusters, far from the origin, large "
          "and small") {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const auto any = [&] { return Eigen::Vector3d(uniform(random), uniform(random), uniform(random)); };
    std::size_t rounded = 0; // hulls whose floats need the exact one
    for (int trial = 0; trial < 300; ++trial) {
        std::vector<Eigen::Vector3d> points;
        const double size = std::pow(10.0, 4.0 * uniform(random)),
                     spread = std::pow(10.0, -2.0 + 2.0 * uniform(random));
        const double near = std::pow(10.0, -5.0 + uniform(random));
        const Eigen::Vector3d offset = (trial % 4 == 0 ? 3.0 : 0.0) * size * any();
        for (int i = 0; i < 80; ++i) {
            Eigen::Vector3d p = any();
            if (trial % 3 == 0) p.normalize();
            if (trial % 3 == 1) p = {p[0], p[1], spread * p[2]};
            if (trial % 3 == 2) p = {p[0], spread * p[1], spread * spread * p[2]};
            for (int twin = 0; twin < 4; ++twin)
                points.push_back(size * (test::some_rotation() * (p + near * any())) + offset);
        }
        ConvexHull hull;
        Faults faults;
        REQUIRE(compute_convex_hull(points, hull, faults));
        double length = 0.0;
        for (const Eigen::Vector3d& p : points)
            for (const Eigen::Vector3d& q : points) length = std::max(length, (p - q).norm());
        const HullData stored = store_hull(hull, length);
        CHECK(!find_hull_flaw(stored, length));
        HullData plain;
        for (const Eigen::Vector3d& p : hull.vertices)
            for (const double x : p) plain.vertices.push_back(static_cast<float>(x));
        for (const Face& f : hull.faces) plain.triangles.insert(plain.triangles.end(), f.begin(), f.end());
        rounded += find_hull_flaw(plain, length).has_value();
        // no point is farther outside than the slack and the rounding of a corner
        for (std::size_t t = 0; t < stored.triangles.size(); t += 3) {
            std::array<Eigen::Vector3d, 3> c;
            for (std::size_t k = 0; k < 3; ++k)
                for (Eigen::Index x = 0; x < 3; ++x)
                    c[k][x] =
                        static_cast<double>(stored.vertices[3 * stored.triangles[t + k] + static_cast<std::size_t>(x)]);
            const Eigen::Vector3d normal = (c[1] - c[0]).cross(c[2] - c[0]);
            if (normal.norm() < 0.01 * length * length) continue;
            double highest = 0.0;
            for (const Eigen::Vector3d& p : points) highest = std::max(highest, normal.normalized().dot(p - c[0]));
            CHECK(highest < 1e-4 * length);
        }
    }
    MESSAGE(rounded, " of 300 hulls need the exact one");
    CHECK(rounded > 0);
}

TEST_CASE("hull of a can with thousands of sides: in time, of fewer corners, with the slack told") {
    constexpr int sides = 6000;
    std::vector<Eigen::Vector3d> points;
    std::vector<shape::HullPoint> same;
    for (int i = 0; i < 2 * sides; ++i) {
        const double angle = 2.0 * 3.14159265358979 * i / sides;
        points.emplace_back(std::cos(angle), std::sin(angle), i < sides ? -1.0 : 1.0);
        same.push_back({points.back()[0], points.back()[1], points.back()[2]});
    }
    shape::ConvexHull whole;
    CHECK(shape::convex_hull(same, whole, 10000) == shape::HullOutcome::too_costly);
    ConvexHull hull;
    Faults faults;
    REQUIRE(compute_convex_hull(points, hull, faults));
    CHECK(hull.vertices.size() <= 4000);
    CHECK(hull.slack < 1e-5);
    for (const Face& f : hull.faces) {
        const Eigen::Vector3d& a = hull.vertices[f[0]];
        const Eigen::Vector3d n = (hull.vertices[f[1]] - a).cross(hull.vertices[f[2]] - a).normalized();
        for (int i = 0; i < 2 * sides; i += 97) CHECK(n.dot(points[static_cast<std::size_t>(i)] - a) <= hull.slack);
    }
}

TEST_CASE("hull of a smooth body has few corners, for loading takes the square of their number, with the slack told") {
    Mesh mesh = test::icosphere(5);
    for (Eigen::Vector3d& v : mesh.vertices) v = v.cwiseProduct(Eigen::Vector3d(1.0, 0.8, 0.6 + 0.1 * v.z()));
    ConvexHull hull;
    Faults faults;
    REQUIRE(compute_convex_hull(mesh.vertices, hull, faults));
    CHECK(hull.vertices.size() <= 4000);
    CHECK(hull.vertices.size() > 2000);
    CHECK(hull.slack < 2e-3);
    double outside = 0.0;
    for (const Face& f : hull.faces) {
        const Eigen::Vector3d& a = hull.vertices[f[0]];
        const Eigen::Vector3d n = (hull.vertices[f[1]] - a).cross(hull.vertices[f[2]] - a).normalized();
        for (std::size_t i = 0; i < mesh.vertices.size(); i += 7)
            outside = std::max(outside, n.dot(mesh.vertices[i] - a));
    }
    CHECK(outside <= hull.slack);
    CHECK(outside > 0.0);
}
