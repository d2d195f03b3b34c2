// A mesh does not say whether its faces are facets or stand for a curved surface. The estimate of the error includes both.
#include "baker/added_mass/added_mass.h"
#include "baker/added_mass/surface_correction.h"
#include "baker/mesh/convex_hull.h"
#include "mesh_shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

using namespace lr;
using namespace lr::baker;
using test::subdivided, test::wheel;

namespace {

using Vec = Eigen::Vector3d;

AddedMass solve(const Mesh& mesh) {
    AddedMass result;
    Faults faults;
    REQUIRE(compute_added_mass(mesh, Vec::Zero(), result, faults));
    return result;
}

// Six squares, twelve chamfers at 45 degrees, eight corners: 44 triangles.
Mesh brick(const Vec& size, double chamfer) {
    std::vector<Vec> points;
    for (int axis = 0; axis < 3; ++axis)
        for (int corner = 0; corner < 8; ++corner) {
            Vec p;
            for (int k = 0; k < 3; ++k)
                p[k] = (0.5 * size[k] - (k == axis ? 0.0 : chamfer)) * ((corner >> k & 1) != 0 ? 1.0 : -1.0);
            points.push_back(p);
        }
    ConvexHull hull;
    Faults faults;
    REQUIRE(compute_convex_hull(points, hull, faults));
    return {hull.vertices, hull.faces, {}};
}

Mesh oval(Mesh mesh) {
    test::apply(mesh, Vec(1.0, 0.4, 1.0).asDiagonal());
    return mesh;
}

const Mesh& chamfered_wheel() {
    static const Mesh mesh = wheel({{0.8, -0.2}, {1.0, -0.1}, {1.0, 0.1}, {0.8, 0.2}}, 18);
    return mesh;
}

double largest_gap(const Mesh& mesh) {
    const CurvedSurface surface = restore_curved_volume(mesh);
    double largest = 0.0;
    for (const double gap : surface.gap) largest = std::max(largest, std::abs(gap));
    return largest;
}
} // namespace

TEST_CASE("a coarse solid moves by no more than it states when its faces are subdivided" *
          doctest::skip(test::sanitized) * doctest::test_suite("long")) {
    struct Case {
        const char* name;
        Mesh mesh;
        std::size_t faces;
        double least, most; // of what it states for translations, over the largest
    };
    for (const Case& c :
         {Case{"cube with chamfers of a quarter", brick({1, 1, 1}, 0.25), 44, 0.0, 0.25},
          Case{"brick 2:1:0.6 with chamfers of 0.1", brick({2, 1, 0.6}, 0.1), 44, 0.0, 0.15},
          Case{"wheel of 18 sides with chamfers", chamfered_wheel(), 144, 0.0, 0.15},
          Case{"sphere by latitude and longitude", test::latitude_longitude({1, 1, 1}, 12, 12), 264, 0.0, 0.1},
          Case{"prism of 8 sides", wheel({{1.0, -0.5}, {1.0, 0.5}}, 8), 32, 0.0, 0.005},
          Case{"prism of 12 sides", wheel({{1.0, -0.5}, {1.0, 0.5}}, 12), 48, 0.0, 0.07},
          Case{"prism of 20 sides", wheel({{1.0, -0.5}, {1.0, 0.5}}, 20), 80, 0.0, 0.03},
          Case{"oval prism of 12 sides", oval(wheel({{1.0, -0.3}, {1.0, 0.3}}, 12)), 48, 0.0, 0.06},
          Case{"coin of 12 sides", wheel({{1.0, -0.05}, {1.0, 0.05}}, 12), 48, 0.0, 0.15},
          Case{"barrel of 8 sides", wheel({{0.7, -1.0}, {0.95, -0.4}, {1.0, 0.0}, {0.95, 0.4}, {0.7, 1.0}}, 8), 80, 0.0,
               0.2},
          Case{"flat spheroid of 8 sides", test::latitude_longitude({1, 1, 0.2}, 8, 6), 80, 0.0, 0.2},
          Case{"sphere", test::icosphere(2), 320, 0.025, 0.05}, Case{"sphere", test::icosphere(3), 1280, 0.006, 0.01},
          Case{"ellipsoid 10:1:1", test::ellipsoid(10, 1, 1, 3), 1280, 0.006, 0.01}}) {
        CAPTURE(std::string(c.name));
        REQUIRE(c.mesh.faces.size() == c.faces);
        const AddedMass whole = solve(c.mesh), fine = solve(subdivided(c.mesh));
        const double mass = whole.value.diagonal().head<3>().maxCoeff();
        double square = 0.0;
        for (const Vec& v : c.mesh.vertices) square = std::max(square, v.squaredNorm());
        for (int i = 0; i < 6; ++i) {
            CAPTURE(i);
            const double little = mass * (i < 3 ? 2e-4 : 2e-4 * square);
            CHECK(std::abs(fine.value(i, i) - whole.value(i, i)) < whole.error(i, i) + little);
        }
        const double stated = whole.error.diagonal().head<3>().maxCoeff() / mass;
        const double moved = (fine.value - whole.value).diagonal().head<3>().cwiseAbs().maxCoeff() / mass;
        MESSAGE(std::string(c.name), ", ", c.faces, " faces: moves by ", 100.0 * moved, " %, states ", 100.0 * stated,
                " %");
        CHECK(stated > c.least);
        CHECK(stated < c.most);
    }
}

TEST_CASE("facets at 45 degrees and more stay flat, and so do the caps of a wheel") {
    for (const int sides : {4, 6, 8}) CHECK(largest_gap(wheel({{1.0, -0.5}, {1.0, 0.5}}, sides)) < 1e-12);
    CHECK(largest_gap(wheel({{1.0, -0.5}, {1.0, 0.5}}, 16)) > 1e-3);
    const CurvedSurface surface = restore_curved_volume(chamfered_wheel());
    for (std::size_t t = 0; t < surface.gap.size(); ++t) {
        const Face& f = chamfered_wheel().faces[t];
        const Vec& a = chamfered_wheel().vertices[f[0]];
        const bool cap = a.head<2>().norm() < 1e-12;
        if (cap) CHECK(std::abs(surface.gap[t]) < 1e-12);
    }
}

TEST_CASE("the finer a prism, the rounder it is read") {
    double last = -1e-9;
    for (const int sides : {8, 10, 12, 14, 16, 24}) {
        CAPTURE(sides);
        // The mean height of an arc above its chord.
        const double arc = 2.0 / 3.0 * (1.0 - std::cos(std::numbers::pi / sides));
        const double share = largest_gap(wheel({{1.0, -0.5}, {1.0, 0.5}}, sides)) / arc;
        CHECK(share >= last);
        CHECK(share < last + 0.45);
        last = share - 1e-3;
    }
    CHECK(last == doctest::Approx(1.0).epsilon(0.02));
}
