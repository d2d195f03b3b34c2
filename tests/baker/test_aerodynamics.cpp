// From a mesh to its surface measures and load coefficients.
#include "asset/asset_file.h"
#include "asset/closed_forms/ellipsoid_formulas.h"
#include "baker/aerodynamics/mesh_geometry.h"
#include "baker/aerodynamics/principal_axes.h"
#include "baker/aerodynamics/silhouette.h"
#include "baker/asset_report.h"
#include "baker/bake.h"
#include "baker/fault_text.h"
#include "baker/json.h"
#include "baker/mesh/mass_properties.h"
#include "sheet_shapes.h"
#include "support/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace lr;
using namespace lr::baker;
using doctest::Approx;
using std::numbers::pi;
using ::test::Random;
namespace shapes = lr::test;

namespace {

constexpr std::array<double, 9> identity{1, 0, 0, 0, 1, 0, 0, 0, 1};

std::array<double, 9> axes_of(const MassProperties& solid, const Mesh& mesh) {
    std::array<double, 9> inertia{};
    for (std::size_t i = 0; i < 9; ++i)
        inertia[i] = solid.inertia(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3));
    return shape::principal_axes(inertia, mesh.vertices);
}

// The same steps as in a bake.
shape::AerodynamicGeometry geometry_of(const Mesh& mesh) {
    const MassProperties solid = compute_mass_properties(mesh);
    shape::AerodynamicGeometry g = mesh_geometry(mesh, axes_of(solid, mesh), solid.centroid);
    g.volume = solid.volume;
    return g;
}

shape::AerodynamicGeometry geometry_of(const Mesh& mesh, double thickness) {
    const MassProperties solid = compute_sheet_mass_properties(mesh, thickness);
    shape::AerodynamicGeometry g = sheet_geometry(mesh, thickness, axes_of(solid, mesh), solid.centroid);
    g.volume = solid.volume;
    return g;
}

// `to`: for each axis of `a`, the axis of `b`; factor: of lengths.
void check_same(const shape::AerodynamicGeometry& a, const shape::AerodynamicGeometry& b, double digits,
                std::array<std::size_t, 3> to = {0, 1, 2}, double factor = 1.0) {
    const double f2 = factor * factor, f4 = f2 * f2, f5 = f4 * factor;
    CHECK(b.surface == Approx(f2 * a.surface).epsilon(digits));
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(b.extent[to[k]] == Approx(factor * a.extent[k]).epsilon(digits));
        CHECK(b.area[to[k]] == Approx(f2 * a.area[k]).epsilon(digits));
        CHECK(b.bluntness[to[k]] == Approx(a.bluntness[k]).epsilon(digits));
        CHECK(b.stroke2[to[k]] == Approx(f4 * a.stroke2[k]).epsilon(digits));
        CHECK(b.stroke3[to[k]] == Approx(f5 * a.stroke3[k]).epsilon(digits));
        CHECK(b.rub[to[k]] == Approx(f5 * a.rub[k]).epsilon(std::max(digits, 1e-5)));
    }
}

FlatTriangle flat(double ax, double ay, double bx, double by, double cx, double cy) {
    return {Eigen::Vector2d(ax, ay), Eigen::Vector2d(bx, by), Eigen::Vector2d(cx, cy)};
}

void add_square(std::vector<FlatTriangle>& to, double x, double y, double width, double height) {
    to.push_back(flat(x, y, x + width, y, x + width, y + height));
    to.push_back(flat(x, y, x, y + height, x + width, y + height));
}

bool inside(const FlatTriangle& t, const Eigen::Vector2d& p) {
    const auto side = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
    };
    const double u = side(t[0], t[1]), v = side(t[1], t[2]), w = side(t[2], t[0]);
    return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

// A rectangle a by b folded along its middle, x = 0, both halves raised by `angle` from the plane.
Mesh folded(double a, double b, double angle) {
    return shapes::patch(8, 4, [=](double u, double v) {
        const double x = a * (u - 0.5);
        return Eigen::Vector3d(x * std::cos(angle), b * (v - 0.5), std::abs(x) * std::sin(angle));
    });
}

AssetData bake_mesh(const Mesh& mesh, BakeOptions options) {
    std::vector<double> positions;
    std::vector<uint32_t> indices;
    for (const Eigen::Vector3d& v : mesh.vertices) positions.insert(positions.end(), v.begin(), v.end());
    for (const Face& f : mesh.faces) indices.insert(indices.end(), f.begin(), f.end());
    options.mesh_path = "body";
    options.mesh_arrays = MeshArrays{positions, indices};
    AssetData asset;
    Faults faults;
    const bool good = bake(options, asset, faults);
    for (const Fault& f : faults) INFO(to_string(f));
    REQUIRE(good);
    return asset;
}

} // namespace

TEST_CASE("aerodynamics: the area of a union is that of what is covered, however often") {
    std::vector<FlatTriangle> t;
    CHECK(union_area(t) == 0.0);
    CHECK(union_silhouette(t).centroid == Eigen::Vector2d(0.0, 0.0));
    t.push_back(flat(1, 1, 2, 2, 3, 3));
    CHECK(union_area(t) == 0.0);
    t = {flat(0, 0, 4, 0, 0, 3)};
    CHECK(union_area(t) == Approx(6.0).epsilon(1e-12));
    t.push_back(flat(0, 0, 0, 3, 4, 0)); // the same square, wound the other way
    CHECK(union_area(t) == Approx(6.0).epsilon(1e-12));
    t.clear();
    add_square(t, 0, 0, 2, 1);
    add_square(t, 0.5, -1, 0.25, 3); // a cross
    CHECK(union_area(t) == Approx(2.0 + 0.75 - 0.25).epsilon(1e-12));
    add_square(t, 10, 5, 1, 1); // separate
    CHECK(union_area(t) == Approx(3.5).epsilon(1e-12));
    t.clear(); // a frame: the hole stays open
    add_square(t, 0, 0, 3, 1);
    add_square(t, 0, 2, 3, 1);
    add_square(t, 0, 1, 1, 1);
    add_square(t, 2, 1, 1, 1);
    CHECK(union_area(t) == Approx(8.0).epsilon(1e-12));
    // A sliver edge on, in any orientation.
    t = {flat(0, 0, 1, 0, 1, 1e-9), flat(0, 0, 1, 1e-9, 0, 1e-9)};
    CHECK(union_area(t) == Approx(1e-9).epsilon(1e-9));
    t = {flat(0, 0, 0, 1, 1e-9, 1), flat(0, 0, 1e-9, 1, 1e-9, 0)};
    CHECK(union_area(t) == Approx(1e-9).epsilon(1e-9));
    // A star of two triangles: edges cross.
    const double h = std::sqrt(3.0);
    t = {flat(-1, 0, 1, 0, 0, h), flat(-1, 2 * h / 3, 1, 2 * h / 3, 0, -h / 3)};
    CHECK(union_area(t) == Approx(h * 4.0 / 3.0).epsilon(1e-6));
}

TEST_CASE("aerodynamics: unions of random triangles agree with a raster, and do not depend on the view") {
    Random random(81);
    for (int round = 0; round < 10; ++round) {
        std::vector<FlatTriangle> t;
        for (int i = 0; i < 20; ++i) {
            FlatTriangle one;
            const Eigen::Vector2d at(random.uniform(0, 1), random.uniform(0, 1));
            for (Eigen::Vector2d& p : one) p = at + 0.3 * Eigen::Vector2d(random.uniform(-1, 1), random.uniform(-1, 1));
            t.push_back(one);
        }
        constexpr int n = 400;
        int hit = 0;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const Eigen::Vector2d p(1.6 * (i + 0.5) / n - 0.3, 1.6 * (j + 0.5) / n - 0.3);
                hit += std::any_of(t.begin(), t.end(), [&](const FlatTriangle& one) { return inside(one, p); });
            }
        const double area = union_area(t);
        CHECK(area == Approx(1.6 * 1.6 * hit / (n * n)).epsilon(5e-3));
        const double c = std::cos(0.7), s = std::sin(0.7);
        for (FlatTriangle& one : t)
            for (Eigen::Vector2d& p : one) p = Eigen::Vector2d(c * p.x() - s * p.y() + 9.0, s * p.x() + c * p.y());
        std::reverse(t.begin(), t.end());
        CHECK(union_area(t) == Approx(area).epsilon(5e-5));
    }
    // Enough corners for evenly spaced lines.
    std::vector<FlatTriangle> fan;
    constexpr int many = 20000;
    for (int i = 0; i < many; ++i) {
        const double a = 2.0 * pi * i / many, b = 2.0 * pi * (i + 1) / many;
        fan.push_back(flat(0, 0, std::cos(a), std::sin(a), std::cos(b), std::sin(b)));
        fan.push_back(flat(0.1, 0, 0.2, 0.1, std::cos(b), std::sin(b)));
    }
    CHECK(union_area(fan) == Approx(pi).epsilon(3e-5));
}

TEST_CASE("aerodynamics: meshes of ellipsoids have the measures of the closed forms") {
    for (const std::array<double, 3> a :
         {std::array{1.0, 1.0, 1.0}, {4.0, 2.0, 1.0}, {1.0, 0.3, 1.0}, {0.2, 0.2, 1.0}}) {
        const shape::AerodynamicGeometry exact = shape::ellipsoid_geometry(a);
        const shape::AerodynamicGeometry g = geometry_of(shapes::ellipsoid(a[0], a[1], a[2], 5));
        CHECK(g.axes == identity);
        CHECK(g.surface == Approx(exact.surface).epsilon(2e-3));
        CHECK(g.volume == Approx(exact.volume).epsilon(3e-3));
        for (std::size_t k = 0; k < 3; ++k) {
            CHECK(g.extent[k] == Approx(exact.extent[k]).epsilon(2e-3));
            CHECK(g.area[k] == Approx(exact.area[k]).epsilon(2e-3));
            CHECK(g.bluntness[k] == Approx(exact.bluntness[k]).epsilon(2e-3));
            const double d = 2.0 * std::max({a[0], a[1], a[2]});
            CHECK(std::abs(g.stroke2[k] - exact.stroke2[k]) < 5e-3 * exact.stroke2[k] + 3e-5 * std::pow(d, 4));
            CHECK(std::abs(g.stroke3[k] - exact.stroke3[k]) < 8e-3 * exact.stroke3[k] + 1e-5 * std::pow(d, 5));
            CHECK(g.rub[k] == Approx(exact.rub[k]).epsilon(8e-3));
        }
    }
}

TEST_CASE("aerodynamics: how much of the rim that a stream sees is a sharp edge") {
    const Mesh box = shapes::box({1.0, 2.0, 3.0}, {2, 3, 4}), ball = shapes::icosphere(3);
    const shape::AerodynamicGeometry of_box = geometry_of(box), of_ball = geometry_of(ball);
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(of_box.edges[k] == Approx(1.0).epsilon(1e-12));
        CHECK(of_ball.edges[k] < 1e-12);
    }
    // Of a cylinder seen across only the ends are; along it all.
    const shape::AerodynamicGeometry rod = geometry_of(shapes::wheel({{0.25, -1.5}, {0.25, 1.5}}, 48));
    CHECK(rod.edges[2] == Approx(1.0).epsilon(1e-12));
    CHECK(rod.edges[0] == Approx(0.5 / (0.5 + 3.0)).epsilon(0.01));
    // A tetrahedron has 1.2 of its silhouette's area (Pettyjohn and Christiansen 1948), not a sphere's 0.43 or less.
    Mesh tetrahedron;
    for (const Eigen::Vector3d& v :
         {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(1, -1, -1), Eigen::Vector3d(-1, 1, -1), Eigen::Vector3d(-1, -1, 1)})
        tetrahedron.vertices.push_back(0.01 * v);
    tetrahedron.faces = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
    const AerodynamicData loads = shape::default_aerodynamics(geometry_of(tetrahedron));
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(loads.drag[k] > 0.8 * 4e-4);
        CHECK(loads.drag_blunt[k] == 0.0);
    }
}

TEST_CASE("aerodynamics: a card and a disc, with their rims") {
    const double a = 0.1, b = 0.05, t = 1e-4;
    const shape::AerodynamicGeometry card = geometry_of(shapes::rectangle(a, b, 6, 3), t);
    CHECK(card.axes == identity);
    CHECK(card.area[2] == Approx(a * b).epsilon(1e-12));
    CHECK(card.area[0] == Approx(b * t).epsilon(1e-9));
    CHECK(card.area[1] == Approx(a * t).epsilon(1e-9));
    CHECK(card.extent[2] == Approx(t).epsilon(1e-12));
    CHECK(card.surface == Approx(2.0 * a * b + 2.0 * (a + b) * t).epsilon(1e-12));
    for (double beta : card.bluntness) CHECK(beta == Approx(1.0).epsilon(1e-12));
    CHECK(card.stroke2[0] == Approx(a * b * b * b / 12.0).epsilon(1e-5));
    CHECK(card.stroke2[1] == Approx(b * a * a * a / 12.0).epsilon(1e-5));
    CHECK(card.stroke3[0] == Approx(a * std::pow(b, 4) / 32.0).epsilon(1e-5));
    CHECK(card.stroke3[1] == Approx(b * std::pow(a, 4) / 32.0).epsilon(1e-5));
    // Only the rim resists a spin in the plane.
    CHECK(card.stroke3[2] == Approx(t * (std::pow(a, 4) + std::pow(b, 4)) / 32.0).epsilon(1e-9));

    Mesh round = shapes::disc(40);
    shapes::apply(round, 0.03 * Eigen::Matrix3d::Identity());
    const shape::AerodynamicGeometry disc = geometry_of(round, 1e-5);
    CHECK(disc.axes == identity);
    for (std::size_t k = 0; k < 2; ++k) CHECK(disc.stroke3[k] == Approx(8.0 / 15.0 * std::pow(0.03, 5)).epsilon(2e-3));
    CHECK(disc.area[2] == Approx(pi * 9e-4).epsilon(1e-3));
    CHECK(disc.area[0] == Approx(0.06 * 1e-5).epsilon(1e-3));
}

TEST_CASE("aerodynamics: a sheet has the measures of the thin box that it stands for") {
    const double a = 0.1, b = 0.07;
    for (double t : {0.01, 0.001}) {
        const shape::AerodynamicGeometry sheet = geometry_of(shapes::rectangle(a, b, 4, 3), t),
                                         box = geometry_of(shapes::box({a, b, t}, {4, 3, 1}));
        for (std::size_t k = 0; k < 3; ++k) {
            CHECK(sheet.area[k] == Approx(box.area[k]).epsilon(1e-9));
            CHECK(sheet.extent[k] == Approx(box.extent[k]).epsilon(1e-9));
            CHECK(sheet.stroke3[k] == Approx(box.stroke3[k]).epsilon(3.0 * t / b));
            CHECK(sheet.rub[k] == Approx(box.rub[k]).epsilon(3.0 * t / b));
        }
        CHECK(sheet.volume == Approx(box.volume).epsilon(1e-12));
        CHECK(sheet.surface == Approx(box.surface).epsilon(1e-12));
    }
}

TEST_CASE("aerodynamics: what a body hides of itself counts once in its silhouette") {
    const double a = 0.08, b = 0.05, t = 1e-6;
    // Halves 60 degrees up: seen along x one hides the other; the sum would be twice the silhouette.
    const double angle = pi / 3.0;
    const shape::AerodynamicGeometry v = geometry_of(folded(a, b, angle), t);
    CHECK(v.axes == identity);
    CHECK(v.area[0] == Approx(b * 0.5 * a * std::sin(angle)).epsilon(1e-4));
    CHECK(v.area[2] == Approx(b * a * std::cos(angle)).epsilon(1e-4));
    CHECK(v.area[1] == Approx(a * t).epsilon(0.01)); // edge on: two thin strips
    CHECK(v.surface == Approx(2.0 * a * b).epsilon(1e-3));
    // A closed U of three walls: the open side shows all, from across two walls coincide.
    Mesh u = shapes::box({0.06, 0.01, 0.04}, {3, 1, 2});
    for (double side : {-1.0, 1.0}) {
        Mesh wall = shapes::box({0.01, 0.05, 0.04}, {1, 2, 2});
        shapes::apply(wall, Eigen::Matrix3d::Identity(), {side * 0.025, 0.03 + 1e-5, 0.0});
        const auto shift = static_cast<uint32_t>(u.vertices.size());
        u.vertices.insert(u.vertices.end(), wall.vertices.begin(), wall.vertices.end());
        for (const Face& f : wall.faces) u.faces.push_back({f[0] + shift, f[1] + shift, f[2] + shift});
    }
    const shape::AerodynamicGeometry g = mesh_geometry(u, identity, Eigen::Vector3d::Zero());
    CHECK(g.area[0] == Approx(0.06 * 0.04).epsilon(1e-3));
    CHECK(g.area[1] == Approx(0.06 * 0.04).epsilon(1e-3));
    CHECK(g.area[2] == Approx(0.06 * 0.01 + 2.0 * 0.05 * 0.01).epsilon(1e-3));
}

TEST_CASE("aerodynamics: turning, moving, scaling, winding and cutting a mesh change nothing that they should not") {
    const Mesh leaf = shapes::leaf(12, 4, 0.01, 0.2);
    const shape::AerodynamicGeometry g = geometry_of(leaf);
    const Mesh sheet = folded(0.08, 0.05, 0.4);
    const shape::AerodynamicGeometry s = geometry_of(sheet, 1e-4);

    Mesh moved = leaf;
    shapes::apply(moved, Eigen::Matrix3d::Identity(), {5.0, -3.0, 1.0});
    check_same(g, geometry_of(moved), 1e-7);
    for (double factor : {1e-3, 1e3}) {
        Mesh scaled = leaf, scaled_sheet = sheet;
        shapes::apply(scaled, factor * Eigen::Matrix3d::Identity());
        shapes::apply(scaled_sheet, factor * Eigen::Matrix3d::Identity());
        check_same(g, geometry_of(scaled), 1e-9, {0, 1, 2}, factor);
        check_same(s, geometry_of(scaled_sheet, factor * 1e-4), 1e-9, {0, 1, 2}, factor);
    }
    Random random(82);
    Mesh rewound = sheet;
    for (Face& f : rewound.faces)
        if (random.below(2)) std::swap(f[0], f[1]);
    check_same(s, geometry_of(rewound, 1e-4), 1e-9);

    const Mesh coarse = shapes::box({0.3, 0.2, 0.1}, {1, 1, 1}), fine = shapes::box({0.3, 0.2, 0.1}, {7, 5, 3}, 0.8);
    check_same(geometry_of(coarse), geometry_of(fine), 1e-9);
    const Mesh card = shapes::rectangle(0.2, 0.1, 1, 1), cut = shapes::rectangle(0.2, 0.1, 9, 7);
    check_same(geometry_of(card, 1e-3), geometry_of(cut, 1e-3), 1e-9);

    // After a small turn the axes keep their numbers, after a quarter turn they change.
    for (const Mesh* mesh : {&leaf, &sheet}) {
        const bool is_sheet = mesh == &sheet;
        Mesh tilted = *mesh, turned = *mesh;
        const Eigen::Matrix3d tilt =
            Eigen::AngleAxisd(0.3, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
        Eigen::Matrix3d quarter;
        quarter << 0, 0, 1, 1, 0, 0, 0, 1, 0; // x to y to z to x
        shapes::apply(tilted, tilt);
        shapes::apply(turned, quarter);
        const shape::AerodynamicGeometry& here = is_sheet ? s : g;
        const shape::AerodynamicGeometry there = is_sheet ? geometry_of(tilted, 1e-4) : geometry_of(tilted);
        check_same(here, there, 2e-5);
        for (Eigen::Index k = 0; k < 3; ++k) {
            const Eigen::Vector3d from(here.axes[static_cast<std::size_t>(3 * k)],
                                       here.axes[static_cast<std::size_t>(3 * k + 1)],
                                       here.axes[static_cast<std::size_t>(3 * k + 2)]);
            for (Eigen::Index i = 0; i < 3; ++i)
                CHECK(std::abs(there.axes[static_cast<std::size_t>(3 * k + i)] - (tilt * from)[i]) < 1e-9);
        }
        check_same(here, is_sheet ? geometry_of(turned, 1e-4) : geometry_of(turned), 1e-9, {1, 2, 0});
        const AerodynamicData c = shape::default_aerodynamics(here), d = shape::default_aerodynamics(there);
        for (std::size_t k = 0; k < 3; ++k) {
            CHECK(d.drag[k] == Approx(c.drag[k]).epsilon(1e-4));
            CHECK(d.lift[k] == Approx(c.lift[k]).epsilon(1e-4));
            CHECK(d.spin_drag[k] == Approx(c.spin_drag[k]).epsilon(1e-4));
        }
    }
}

TEST_CASE("aerodynamics: noise on the vertices moves the coefficients no more than the shape") {
    Random random(83);
    for (const Mesh& clean : {shapes::disc(8), shapes::rectangle(1.0, 1.0, 8, 8), shapes::rectangle(1.0, 0.3, 12, 4)}) {
        const AerodynamicData c = shape::default_aerodynamics(geometry_of(clean, 1e-3));
        CHECK(c.axes == identity);
        for (int round = 0; round < 5; ++round) {
            Mesh noisy = clean;
            for (Eigen::Vector3d& v : noisy.vertices)
                v += 1e-4 * Eigen::Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
            const AerodynamicData n = shape::default_aerodynamics(geometry_of(noisy, 1e-3));
            for (std::size_t i = 0; i < 9; ++i) CHECK(std::abs(n.axes[i] - identity[i]) < 2e-3);
            CHECK(n.plate_drag == Approx(c.plate_drag).epsilon(5e-3));
            for (std::size_t k = 0; k < 3; ++k) {
                CHECK(std::abs(n.drag[k] - c.drag[k]) < 5e-3 * c.plate_drag);
                CHECK(std::abs(n.lift[k] - c.lift[k]) < 5e-3 * c.plate_drag);
                CHECK(std::abs(n.plate_lift[k] - c.plate_lift[k]) < 5e-3 * c.plate_drag);
                CHECK(std::abs(n.spin_drag[k] - c.spin_drag[k]) < 5e-3 * c.spin_drag[1]);
            }
        }
    }
}

TEST_CASE("aerodynamics: a bake puts them into the asset, the report and the file") {
    Mesh card = shapes::rectangle(0.08, 0.04, 4, 2);
    shapes::apply(card, Eigen::Matrix3d::Identity(), {0.5, 0.0, 0.2});
    BakeOptions as_sheet;
    as_sheet.sheet = SheetOptions{1e-4, {}};
    const AssetData asset = bake_mesh(card, as_sheet);
    const AerodynamicData& a = asset.aerodynamics;
    const AerodynamicData expected =
        shape::default_aerodynamics(geometry_of(shapes::rectangle(0.08, 0.04, 4, 2), 1e-4));
    CHECK(a.axes == identity);
    CHECK(a.length == Approx(expected.length));
    CHECK(a.plate_drag == Approx(expected.plate_drag).epsilon(1e-6));
    CHECK(a.wake_length == Approx(expected.wake_length).epsilon(1e-6));
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(a.drag[k] == Approx(expected.drag[k]).epsilon(1e-6));
        CHECK(a.lift[k] == Approx(expected.lift[k]).epsilon(1e-6));
        CHECK(a.plate_lift[k] == Approx(expected.plate_lift[k]).epsilon(1e-6));
        CHECK(a.spin_drag[k] == Approx(expected.spin_drag[k]).epsilon(1e-6));
    }
    const lr::test::Json j = lr::test::Json::parse(report_json(asset))["aerodynamics"];
    CHECK(j["axes"] == a.axes);
#define LR_REPORTED(name, ...) CHECK(j[#name] == a.name);
    LR_AERODYNAMIC_VECTORS(LR_REPORTED)
    LR_AERODYNAMIC_NUMBERS(LR_REPORTED)
#undef LR_REPORTED
    CHECK(j["center"] == std::array<double, 3>{});
}

TEST_CASE("aerodynamics: a ballasted body keeps its own, for they are about its centre of buoyancy") {
    const Mesh body = shapes::ellipsoid(0.03, 0.02, 0.01, 3);
    BakeOptions offset;
    offset.center_of_mass = {0.01, 0.005, 0.0};
    const AssetData plain = bake_mesh(body, {}), ballasted = bake_mesh(body, offset);
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(ballasted.aerodynamics.drag[k] == Approx(plain.aerodynamics.drag[k]).epsilon(1e-9));
        CHECK(ballasted.aerodynamics.spin_drag[k] == Approx(plain.aerodynamics.spin_drag[k]).epsilon(1e-6));
    }
}

TEST_CASE("aerodynamics: the centroid of a union is that of what is covered, however often and seen from wherever") {
    std::vector<FlatTriangle> t;
    add_square(t, 0, 0, 4, 1);
    add_square(t, 0, 0, 1, 3); // an L, its corner twice
    const Eigen::Vector2d at((4 * 2.0 + 2 * 0.5) / 6.0, (4 * 0.5 + 2 * 2.0) / 6.0);
    const Silhouette seen = union_silhouette(t);
    CHECK(seen.area == Approx(6.0).epsilon(1e-12));
    CHECK((seen.centroid - at).norm() < 1e-6);
    Random random(85);
    for (int round = 0; round < 20; ++round) {
        const double angle = random.uniform(0.0, 2.0 * pi);
        const Eigen::Rotation2Dd turn(angle);
        const Eigen::Vector2d shift(random.uniform(-5, 5), random.uniform(-5, 5));
        std::vector<FlatTriangle> moved = t;
        for (FlatTriangle& one : moved)
            for (Eigen::Vector2d& p : one) p = turn * p + shift;
        const Silhouette again = union_silhouette(moved);
        CHECK(again.area == Approx(6.0).epsilon(1e-5));
        CHECK((again.centroid - (turn * at + shift)).norm() < 1e-5);
    }
}

TEST_CASE("aerodynamics: even bodies have their loads at the centre of buoyancy, to the bit") {
    const auto center = [](const shape::AerodynamicGeometry& g) { return g.center; };
    constexpr std::array<double, 3> none{};
    CHECK(center(geometry_of(shapes::ellipsoid(4, 2, 1, 4))) == none);
    CHECK(center(geometry_of(shapes::box({0.3, 0.2, 0.1}, {7, 5, 3}, 0.8))) == none);
    CHECK(center(geometry_of(shapes::disc(12), 1e-3)) == none);
    CHECK(center(geometry_of(shapes::rectangle(0.1, 0.03, 3, 2), 1e-4)) == none);
    // A triangle has no symmetry, but constant thickness.
    Mesh triangle;
    triangle.vertices = {{0.0, 0.0, 0.2}, {0.3, 0.0, 0.2}, {0.05, 0.2, 0.2}};
    triangle.faces = {{0, 1, 2}};
    CHECK(center(geometry_of(triangle, 1e-4)) == none);
    // Noise of vertices must not make a body uneven, which would select the kernel's slower path.
    Random random(86);
    Mesh noisy = shapes::disc(8);
    for (Eigen::Vector3d& v : noisy.vertices)
        v += 1e-4 * Eigen::Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    CHECK(center(geometry_of(noisy, 1e-3)) == none);
    CHECK(shape::ellipsoid_geometry({3, 2, 1}).center == none);
}

TEST_CASE("aerodynamics: the loads of an uneven body act at the middle of what a stream sees") {
    // A wedge: thick at x = 0, an edge at x = 1. Its volume is centred at 1/3, its silhouette along z at 1/2.
    const double thick = 0.1;
    Mesh wedge = shapes::box({1.0, 0.6, thick}, {1, 1, 1});
    for (Eigen::Vector3d& v : wedge.vertices) {
        v.x() += 0.5;
        if (v.x() > 0.5) v.z() *= 0.001;
    }
    const MassProperties solid = compute_mass_properties(wedge);
    const shape::AerodynamicGeometry g = mesh_geometry(wedge, identity, solid.centroid);
    CHECK(g.center[0] == Approx(0.5 - solid.centroid.x()).epsilon(1e-9));
    CHECK(g.center[0] == Approx(1.0 / 6.0).epsilon(0.01));
    CHECK((g.center[1] == 0.0 && g.center[2] == 0.0));
    // Strokes are about it: about y they are those of the plate seen.
    CHECK(g.stroke2[1] == Approx(0.6 / 12.0).epsilon(0.01));
    // The coefficients include the centre, and rotate with the mesh.
    CHECK(shape::default_aerodynamics(g).center == g.center);
    Mesh turned = wedge;
    const Eigen::Matrix3d tilt =
        Eigen::AngleAxisd(0.3, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
    shapes::apply(turned, tilt, {3.0, 1.0, -2.0});
    const shape::AerodynamicGeometry h = geometry_of(turned), upright = geometry_of(wedge);
    const Eigen::Vector3d expected = tilt * Eigen::Vector3d(upright.center[0], upright.center[1], upright.center[2]);
    for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(h.center[i] - expected[static_cast<Eigen::Index>(i)]) < 1e-7);
    // The third coordinate is that of the next largest silhouette: a keel lowers it. Wings 0.4 by 0.3, keel 0.4 by 0.1.
    const Mesh winged = shapes::joined(
        shapes::patch(4, 6, [](double u, double v) { return Eigen::Vector3d(0.4 * (u - 0.5), 0.3 * (v - 0.5), 0.0); }),
        shapes::patch(4, 2, [](double u, double v) { return Eigen::Vector3d(0.4 * (u - 0.5), 0.0, -0.1 * v); }));
    const shape::AerodynamicGeometry plane = geometry_of(winged, 1e-5);
    CHECK(plane.axes == identity);
    // Volume: the keel has a quarter, at -0.05. The silhouette from the side is the keel alone.
    CHECK(plane.center[2] == Approx(-0.05 + 0.25 * 0.05).epsilon(1e-3));
    CHECK((plane.center[0] == 0.0 && plane.center[1] == 0.0));
}

TEST_CASE("aerodynamics: a body whose loads act elsewhere is not a diagonal one") {
    AssetData even = bake_mesh(shapes::box({0.3, 0.2, 0.1}, {3, 2, 1}), {});
    REQUIRE(is_diagonal(even));
    even.aerodynamics.center[0] = 1e-3;
    CHECK_FALSE(is_diagonal(even));
}
