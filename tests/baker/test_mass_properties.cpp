#include "baker/mesh/mass_properties.h"
#include "mesh_shapes.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace lr;
using namespace lr::baker;

TEST_CASE("box: exact, whatever the triangulation, place and unit") {
    const Eigen::Vector3d size(3.0, 2.0, 0.01);
    for (const double scale : {1e-4, 1.0, 1e4})
        for (const double far : {0.0, 1e3}) {
            Mesh mesh = test::box(size, {5, 3, 2}, 0.5);
            const Eigen::Matrix3d turn = test::some_rotation();
            const Eigen::Vector3d shift = scale * far * Eigen::Vector3d(1.0, -2.0, 0.5);
            test::apply(mesh, scale * turn, shift);
            const MassProperties p = compute_mass_properties(mesh);
            const double volume = size.prod() * std::pow(scale, 3);
            // a vertex far away is itself rounded: size 0.01 at 2000 keeps 11 digits
            const double accuracy = far == 0.0 ? 1e-12 : 1e-8;
            CHECK(p.volume == doctest::Approx(volume).epsilon(accuracy));
            CHECK((p.centroid - shift).norm() < accuracy * scale);
            const Eigen::Vector3d square = scale * scale * size.cwiseAbs2();
            const Eigen::Vector3d moments = volume / 12.0 * (square.sum() - square.array()).matrix();
            const Eigen::Matrix3d inertia = turn * moments.asDiagonal() * turn.transpose();
            CHECK((p.inertia - inertia).norm() < accuracy * inertia.norm());
            CHECK((p.inertia - p.inertia.transpose()).norm() == 0.0);
            CHECK((p.principal - moments).norm() < accuracy * moments.norm());
            // the least moment is about the longest side
            CHECK((p.extents - scale * size).norm() < 1e-8 * scale);
            const double s2 = scale * scale;
            const Eigen::Vector3d areas(s2 * size[1] * size[2], s2 * size[0] * size[2], s2 * size[0] * size[1]);
            CHECK((p.projected_areas - areas).norm() < 1e-8 * areas.norm());
            CHECK(p.max_projected_area == doctest::Approx(6.0 * s2));
            CHECK(p.area == doctest::Approx(2.0 * areas.sum()));
            CHECK((p.axes.transpose() * p.axes - Eigen::Matrix3d::Identity()).norm() < 1e-12);
            CHECK(p.axes.determinant() == doctest::Approx(1.0));
        }
}

TEST_CASE("tetrahedron: known integrals") {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    const MassProperties p = compute_mass_properties(mesh);
    CHECK(p.volume == doctest::Approx(1.0 / 6.0));
    CHECK((p.centroid - Eigen::Vector3d::Constant(0.25)).norm() < 1e-15);
    // integral x^2 = 1/60, x y = 1/120 about the corner; moved to the centroid
    CHECK(p.inertia(0, 0) == doctest::Approx(2.0 * (1.0 / 60.0 - 1.0 / 96.0)));
    CHECK(p.inertia(0, 1) == doctest::Approx(-(1.0 / 120.0 - 1.0 / 96.0)));
}

TEST_CASE("ellipsoid meshes tend to the closed form with second order") {
    const Eigen::Vector3d a(4.0, 2.0, 1.0);
    const double volume = 4.0 / 3.0 * 3.14159265358979323846 * a.prod();
    double last = 0.0;
    for (const int level : {2, 3, 4}) {
        const MassProperties p = compute_mass_properties(test::ellipsoid(a[0], a[1], a[2], level));
        const double defect = 1.0 - p.volume / volume;
        CHECK(defect > 0.0);
        if (last > 0.0) CHECK(last / defect == doctest::Approx(4.0).epsilon(0.05));
        last = defect;
        const Eigen::Vector3d square = a.cwiseAbs2();
        const Eigen::Vector3d moments = volume / 5.0 * (square.sum() - square.array()).matrix();
        CHECK((p.principal - moments).norm() < 2.0 * defect * moments.norm());
        CHECK((p.extents - 2.0 * a).norm() < 0.1 * std::pow(0.25, level - 2) * a.norm());
    }
}

TEST_CASE("equal moments take the axes of the mesh") {
    const MassProperties cube = compute_mass_properties(test::cube(4));
    CHECK(cube.axes == Eigen::Matrix3d::Identity());
    CHECK((cube.extents - Eigen::Vector3d::Ones()).norm() < 1e-12);
    const MassProperties plate = compute_mass_properties(test::box({2, 2, 0.1}, {3, 3, 1}));
    CHECK((plate.extents - Eigen::Vector3d(2, 2, 0.1)).norm() < 1e-9);
    CHECK(plate.axes.determinant() == doctest::Approx(1.0));
    const MassProperties rod = compute_mass_properties(test::box({0.1, 2, 0.1}, {1, 3, 1}));
    CHECK((rod.extents - Eigen::Vector3d(2, 0.1, 0.1)).norm() < 1e-9);
    CHECK(rod.axes.determinant() == doctest::Approx(1.0));
}
