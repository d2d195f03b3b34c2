// Surfaces without thickness: unknowns, refinement, added mass.
#include "baker/added_mass/added_mass.h"
#include "baker/added_mass/rim_refinement.h"
#include "baker/added_mass/surface_basis.h"
#include "baker/eigensystem.h"
#include "baker/mesh/mass_properties.h"
#include "baker/mesh/mesh_check.h"
#include "sheet_shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <set>

using namespace lr;
using namespace lr::baker;
using test::joined;
using test::patch;
using test::rectangle;

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vec = Eigen::Vector3d;

AddedMass solve(const Mesh& mesh, const Refinement& refinement = {}, const Vec& centre = Vec::Zero()) {
    AddedMass result;
    Faults faults;
    AddedMassOptions once;
    once.as_given = true;
    REQUIRE(compute_sheet_added_mass(mesh, centre, refinement, result, faults, {}, once));
    CHECK(faults.empty());
    CHECK(result.residual < 1e-9);
    const Eigensystem<Matrix6> eigen = eigensystem(result.value);
    CHECK(eigen.values[0] >= -1e-15 * eigen.values[5]);
    return result;
}

Refinement coarse() {
    Refinement r;
    r.panels = 500;
    r.strips = 3;
    return r;
}

// Half plates at a right angle above the middle of a plate: no flow crosses its plane of symmetry.
Mesh fin(int cells, double from, double to) {
    return patch(cells, cells, [&](double u, double v) { return Vec(u - 0.5, 0.0, from + v * (to - from)); });
}

// A sheet folded along x by an angle on either side.
Mesh folded(double angle, int cells) {
    return patch(cells, cells, [&](double u, double v) {
        const double y = v - 0.5;
        return Vec(u - 0.5, y * std::cos(angle), std::abs(y) * std::sin(angle));
    });
}

double area(const Mesh& mesh) {
    double sum = 0.0;
    for (const Face& f : mesh.faces)
        sum +=
            0.5 * (mesh.vertices[f[1]] - mesh.vertices[f[0]]).cross(mesh.vertices[f[2]] - mesh.vertices[f[0]]).norm();
    return sum;
}

double rim_length(const Mesh& mesh) {
    std::map<std::pair<uint32_t, uint32_t>, int> edges;
    for (const Face& f : mesh.faces)
        for (std::size_t k = 0; k < 3; ++k) ++edges[std::minmax(f[k], f[(k + 1) % 3])];
    double length = 0.0;
    for (const auto& [edge, count] : edges)
        if (count == 1) length += (mesh.vertices[edge.first] - mesh.vertices[edge.second]).norm();
    return length;
}

Matrix6 turned(const Matrix6& m, const Eigen::Matrix3d& rotation) {
    Matrix6 both = Matrix6::Zero();
    both.topLeftCorner<3, 3>() = rotation;
    both.bottomRightCorner<3, 3>() = rotation;
    return both * m * both.transpose();
}

// The velocity at the new centre of a body that moves as (v, w) does about the old one: v + w x shift.
Matrix6 about(const Matrix6& m, const Vec& shift) {
    Eigen::Matrix3d cross;
    cross << 0, -shift[2], shift[1], shift[2], 0, -shift[0], -shift[1], shift[0], 0;
    Matrix6 back = Matrix6::Identity(); // old v = new v - w x shift = new v + shift x w
    back.topRightCorner<3, 3>() = cross;
    return back.transpose() * m * back;
}

} // namespace

TEST_CASE("sheet unknowns: one for each vertex inside, none at the rim") {
    const Mesh mesh = rectangle(1, 1, 4, 3);
    const SurfaceBasis basis = sheet_basis(mesh);
    CHECK(basis.sheet);
    CHECK(basis.unknowns == 3 * 2);
    CHECK(basis.constants.empty());
    std::set<uint32_t> inside;
    for (std::size_t t = 0; t < mesh.faces.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const CornerUnknowns c = basis.corners[t][k];
            CHECK((c.plus < 0 || c.minus < 0));
            if (c.plus >= 0 || c.minus >= 0) inside.insert(mesh.faces[t][k]);
            const Vec& p = mesh.vertices[mesh.faces[t][k]];
            const bool rim = std::abs(p[0]) > 0.499 || std::abs(p[1]) > 0.499;
            CHECK(rim == (c.plus < 0 && c.minus < 0));
        }
    CHECK(inside.size() == 6);
}

TEST_CASE("sheet unknowns: where panels meet, one less than the spaces between them") {
    // Three and four sheets at an edge of 4 cells, whose ends lie on the rim.
    const Mesh t_shape = joined(rectangle(1, 1, 4, 4), fin(4, 0, 0.5));
    CHECK(sheet_basis(t_shape).unknowns == 6 + 2 * 3 + 9);
    const Mesh cross = joined(t_shape, fin(4, 0, -0.5));
    CHECK(sheet_basis(cross).unknowns == 6 + 3 * 3 + 9 + 9);
    // A closed surface: inside and outside, with a constant between them; with a wall, two chambers.
    const Mesh box = test::cube(4);
    const SurfaceBasis shell = sheet_basis(box);
    CHECK(shell.unknowns == box.vertices.size());
    REQUIRE(shell.constants.size() == 1);
    CHECK(shell.constants[0].unknowns.size() == box.vertices.size());
    const Mesh chambers = joined(box, rectangle(1, 1, 4, 4));
    CHECK(sheet_basis(chambers).constants.size() == 2);
    CHECK(sheet_basis(chambers).unknowns == box.vertices.size() + 16 + 9);
    // Two sheets with a common vertex are independent.
    Mesh corner = rectangle(1, 1, 2, 2);
    Mesh other = corner;
    for (Vec& v : other.vertices) v += Vec(1, 1, 0);
    CHECK(sheet_basis(joined(corner, other)).unknowns == 2);
    // The closed surface itself
    CHECK(closed_basis(joined(box, test::box({0.1, 0.1, 0.1}, {1, 1, 1}))).constants.size() == 2);
}

TEST_CASE("refinement keeps the surface and its rim, and leaves no gap") {
    for (const Mesh& mesh :
         {rectangle(2, 1, 1, 1), test::disc(4), folded(0.6, 5), joined(rectangle(1, 1, 4, 4), fin(4, 0, 1))})
        for (const std::size_t strips : {1U, 2U, 5U}) {
            Refinement how;
            how.panels = 300;
            how.strips = strips;
            const Mesh fine = refine_sheet(mesh, how);
            CHECK(fine.faces.size() >= how.panels);
            CHECK(area(fine) == doctest::Approx(area(mesh)).epsilon(1e-12));
            CHECK(rim_length(fine) == doctest::Approx(rim_length(mesh)).epsilon(1e-12));
            // the same winding as the original panel: the vector area stays
            Vec vector_area = Vec::Zero();
            for (const auto& [part, sign] : {std::pair{&fine, 1.0}, std::pair{&mesh, -1.0}})
                for (const Face& f : part->faces)
                    vector_area += sign * (part->vertices[f[1]] - part->vertices[f[0]])
                                              .cross(part->vertices[f[2]] - part->vertices[f[0]]);
            CHECK(vector_area.norm() < 1e-12);
            Mesh copy = fine;
            Faults faults;
            CHECK(check_sheet(copy, faults));
            CHECK(faults.empty());
        }
}

TEST_CASE("rectangles and discs without thickness: published values at 2,000 triangles" *
          doctest::test_suite("exact")) {
    struct Case {
        double aspect, mass, along, across; // Meyerhoff 1970 and later panel solutions, four digits
    };
    for (const Case& c : {Case{1, .5790, .0201, .0201}, Case{2, .7569, .0223, .0162}, Case{5, .8967, .0236, .0096}}) {
        const int n = static_cast<int>(std::lround(std::sqrt(1000.0 / c.aspect)));
        const AddedMass m = solve(rectangle(c.aspect, 1, static_cast<int>(c.aspect) * n, n));
        CAPTURE(c.aspect);
        CHECK(m.value(2, 2) == doctest::Approx(c.mass * std::numbers::pi / 4 * c.aspect).epsilon(0.004));
        CHECK(m.value(3, 3) == doctest::Approx(c.along * c.aspect).epsilon(0.006));
        CHECK(m.value(4, 4) == doctest::Approx(c.across * std::pow(c.aspect, 4)).epsilon(0.006));
        CHECK(m.error(2, 2) > std::abs(m.value(2, 2) - c.mass * std::numbers::pi / 4 * c.aspect));
        CHECK(m.error(2, 2) < 0.01 * m.value(2, 2));
        CHECK(m.value.topLeftCorner<2, 6>().norm() < 1e-12);
        CHECK(m.value.bottomRows<1>().norm() < 1e-12);
    }
    const AddedMass m = solve(test::disc(18));
    CHECK(m.value(2, 2) == doctest::Approx(8.0 / 3.0).epsilon(0.003));
    CHECK(m.value(3, 3) == doctest::Approx(16.0 / 45.0).epsilon(0.005));
    CHECK(m.value(4, 4) == doctest::Approx(16.0 / 45.0).epsilon(0.005));
    CHECK(m.error(2, 2) > std::abs(m.value(2, 2) - 8.0 / 3.0));
    CHECK(m.error(3, 3) > std::abs(m.value(3, 3) - 16.0 / 45.0));
}

TEST_CASE("a card of two triangles is a rectangle") {
    const AddedMass card = solve(rectangle(2, 1, 1, 1));
    CHECK(card.value(2, 2) == doctest::Approx(.7569 * std::numbers::pi / 2).epsilon(0.004));
    CHECK(card.value(4, 4) == doctest::Approx(.0162 * 16).epsilon(0.006));
}

TEST_CASE("strips along the rim bring the values up to the limit, from below") {
    const double exact = 8.0 / 3.0;
    double last = 0.0;
    for (const std::size_t strips : {1U, 2U, 4U, 8U}) {
        Refinement how;
        how.panels = 0;
        how.strips = strips;
        const double value = solve(test::disc(12), how).value(2, 2);
        CHECK(value > last);
        CHECK(value < exact);
        last = value;
    }
    CHECK(last == doctest::Approx(exact).epsilon(0.004));
}

// A shaft with narrow strips that join it on both sides, as barbs do, one or two quads along each.
Mesh comb(int barbs, double width, double length) {
    Mesh mesh;
    const auto add = [&](double x, double y, double z) {
        mesh.vertices.emplace_back(x, y, z);
        return static_cast<uint32_t>(mesh.vertices.size() - 1);
    };
    const auto quad = [&](uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
        mesh.faces.push_back({a, b, c});
        mesh.faces.push_back({a, c, d});
    };
    std::array<uint32_t, 2> last{add(0, -0.01, 0), add(0, 0.01, 0)};
    for (int i = 0; i < barbs; ++i)
        for (const double end : {0.5 - 0.5 * width, 0.5 + 0.5 * width}) {
            const double x = (i + end) / barbs;
            const std::array<uint32_t, 2> next{add(x, -0.01, 0), add(x, 0.01, 0)};
            quad(last[0], next[0], next[1], last[1]);
            for (std::size_t side = 0; side < 2 && end > 0.5; ++side) {
                std::array<uint32_t, 2> root{last[side], next[side]};
                for (const double part : {0.5, 1.0}) {
                    const double y = (side == 0 ? -1.0 : 1.0) * (0.01 + part * length);
                    const std::array<uint32_t, 2> tip{
                        add((i + 0.5 - 0.5 * width) / barbs, y, 0.1 * part * part * length),
                        add(x, y, 0.1 * part * part * length)};
                    quad(root[0], root[1], tip[1], tip[0]);
                    root = tip;
                }
            }
            last = next;
        }
    return mesh;
}

TEST_CASE("narrow strips that join a shaft, and pleats: what is stated covers finer panels, and is small" *
          doctest::test_suite("long")) {
    const Mesh pleats =
        patch(60, 2, [](double u, double v) { return Vec(u, 0.5 * v, std::lround(60.0 * u) % 2 == 0 ? 0.0 : 0.03); });
    for (const Mesh& mesh : {comb(16, 0.8, 0.5), pleats}) {
        AddedMass m;
        Faults faults;
        AddedMassOptions hasty;
        hasty.patient = false;
        REQUIRE(compute_sheet_added_mass(mesh, {0, 0, 0}, {}, m, faults, {}, hasty));
        Refinement fine;
        fine.panels = 12000;
        AddedMass reference;
        AddedMassOptions once;
        once.as_given = true;
        REQUIRE(compute_sheet_added_mass(mesh, {0, 0, 0}, fine, reference, faults, {}, once));
        CHECK(m.largest_share() < 0.1);
        for (Eigen::Index i = 0; i < 6; ++i)
            for (Eigen::Index j = 0; j <= i; ++j) {
                CAPTURE(i);
                CAPTURE(j);
                const double own = std::sqrt(reference.value(i, i) * reference.value(j, j));
                CHECK(std::abs(m.value(i, j) - reference.value(i, j)) < m.error(i, j) + 0.02 * own + 1e-9);
            }
    }
}

TEST_CASE("twisted strips of few quads: what is stated covers the couplings that their diagonals make") {
    // test::patch changes the diagonals' way from quad to quad.
    const auto strip = [](int along, int across) {
        Mesh mesh = patch(along, across, [](double u, double v) {
            const double turn = 1.5 * (u - 0.5), y = 0.25 * (v - 0.5);
            return Vec(u - 0.5, y * std::cos(turn), y * std::sin(turn));
        });
        const auto at = [&](int i, int j) { return static_cast<uint32_t>(i * (across + 1) + j); };
        mesh.faces.clear();
        for (int i = 0; i < along; ++i)
            for (int j = 0; j < across; ++j) {
                mesh.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
                mesh.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
            }
        return mesh;
    };
    const AddedMass reference = solve(strip(48, 12));
    for (const auto& [along, across] : {std::pair(5, 1), {10, 1}, {10, 2}, {20, 4}}) {
        CAPTURE(along);
        CAPTURE(across);
        AddedMass m;
        Faults faults;
        REQUIRE(compute_sheet_added_mass(strip(along, across), {0, 0, 0}, {}, m, faults));
        for (const auto& [i, j] : {std::pair(0, 1), {1, 3}, {0, 4}, {3, 4}, {2, 5}})
            CHECK(std::abs(m.value(i, j) - reference.value(i, j)) < m.error(i, j) + reference.error(i, j));
    }
}

TEST_CASE("winding, place, unit and axes do not matter") {
    const Mesh mesh = folded(0.6, 8);
    const AddedMass m = solve(mesh, coarse());
    Mesh flipped = mesh;
    for (std::size_t i = 0; i < flipped.faces.size(); i += 3) std::swap(flipped.faces[i][1], flipped.faces[i][2]);
    // The order of panels decides which pairs get more points of the outer rule than necessary.
    CHECK((solve(flipped, coarse()).value - m.value).norm() < 5e-5 * m.value.norm());
    const Eigen::Matrix3d rotation = test::some_rotation();
    Mesh moved = mesh;
    test::apply(moved, rotation, {0.3, -1, 2});
    const Matrix6 back = turned(solve(moved, coarse(), {0.3, -1, 2}).value, rotation.transpose());
    CHECK((back - m.value).norm() < 1e-3 * m.value.norm());
    Mesh small = mesh;
    test::apply(small, 1e-3 * Eigen::Matrix3d::Identity());
    const Matrix6 millimetres = solve(small, coarse()).value;
    CHECK(1e9 * millimetres(2, 2) == doctest::Approx(m.value(2, 2)).epsilon(1e-7));
    CHECK(std::abs(1e12 * millimetres(2, 4) - m.value(2, 4)) < 1e-9 * m.value(2, 2));
    CHECK(1e15 * millimetres(4, 4) == doctest::Approx(m.value(4, 4)).epsilon(1e-7));
}

TEST_CASE("folded sheets couple translation and turning, as thin solids of that shape do") {
    const Vec centre(0.1, 0.05, -0.2);
    const AddedMass at_origin = solve(folded(0.6, 20)), off = solve(folded(0.6, 20), {}, centre);
    CHECK((about(at_origin.value, centre) - off.value).norm() < 1e-3 * off.value.norm());
    // along y and about x: the mirror planes of the fold leave this coupling and v_x with w_y
    CHECK(std::abs(at_origin.value(1, 3)) > 0.05 * std::sqrt(at_origin.value(1, 1) * at_origin.value(3, 3)));
    CHECK(std::abs(at_origin.value(2, 3)) < 1e-3 * std::sqrt(at_origin.value(2, 2) * at_origin.value(3, 3)));

    Mesh solid = test::box({1, 1, 0.01}, {20, 20, 1});
    for (Vec& v : solid.vertices) {
        const double y = v[1];
        v = Vec(v[0], y * std::cos(0.6), std::abs(y) * std::sin(0.6) + v[2]);
    }
    AddedMass thin;
    Faults faults;
    REQUIRE(compute_added_mass(solid, Vec::Zero(), thin, faults));
    for (const auto& [i, j] : {std::pair{1, 1}, {2, 2}, {3, 3}, {4, 4}, {1, 3}})
        CHECK(thin.value(i, j) == doctest::Approx(at_origin.value(i, j)).epsilon(0.05));
}

TEST_CASE("a fin in a plane of symmetry is not felt") {
    const Mesh plate = rectangle(1, 1, 12, 12);
    const double alone = solve(plate, coarse()).value(2, 2);
    for (const Mesh& with :
         {joined(plate, fin(12, 0, 0.5)), joined(joined(plate, fin(12, 0, 0.5)), fin(12, -0.5, 0))}) {
        const AddedMass m = solve(with, coarse());
        CHECK(m.value(2, 2) == doctest::Approx(alone).epsilon(0.004));
        CHECK(m.value(1, 1) > 0.1); // the fin alone
    }
}

TEST_CASE("a shell carries the fluid that it encloses") {
    const Mesh sphere = test::icosphere(3);
    Refinement as_it_is;
    as_it_is.panels = 0;
    const AddedMass shell = solve(sphere, as_it_is);
    const double inside = compute_mass_properties(sphere).volume;
    for (int k = 0; k < 3; ++k) {
        CHECK(shell.value(k, k) == doctest::Approx(1.5 * inside).epsilon(0.01));
        CHECK(shell.value(k + 3, k + 3) < 1e-3);
    }
    AddedMass outside;
    Faults faults;
    REQUIRE(compute_added_mass(test::cube(6), Vec::Zero(), outside, faults));
    // a wall across prevents the fluid from turning in place, not from being carried along
    const AddedMass open_cube = solve(test::cube(6), as_it_is);
    const AddedMass walled = solve(joined(test::cube(6), rectangle(1, 1, 6, 6)), as_it_is);
    CHECK(open_cube.value(0, 0) == doctest::Approx(outside.value(0, 0) + 1.0).epsilon(0.01));
    CHECK(walled.value(0, 0) == doctest::Approx(open_cube.value(0, 0)).epsilon(1e-3));
    CHECK(walled.value(2, 2) == doctest::Approx(open_cube.value(2, 2)).epsilon(1e-3));
    CHECK(walled.value(3, 3) > 1.05 * open_cube.value(3, 3));
}

TEST_CASE("mass properties of a sheet: a plate, to the last digits") {
    const double t = 0.02;
    Mesh plate = rectangle(3, 2, 4, 5);
    const Eigen::Matrix3d rotation = test::some_rotation();
    test::apply(plate, rotation, {5, 6, -7});
    const MassProperties p = compute_sheet_mass_properties(plate, t);
    CHECK(p.area == doctest::Approx(6.0).epsilon(1e-12));
    CHECK(p.volume == doctest::Approx(6.0 * t).epsilon(1e-12));
    CHECK((p.centroid - Vec(5, 6, -7)).norm() < 1e-12);
    const Vec moments = 6.0 * t / 12.0 * Vec(4 + t * t, 9 + t * t, 13);
    const Eigen::Matrix3d inertia = rotation * moments.asDiagonal() * rotation.transpose();
    CHECK((p.inertia - inertia).norm() < 1e-12 * inertia.norm());
    CHECK(p.max_projected_area == doctest::Approx(6.0).epsilon(1e-9));
    CHECK(p.extents[2] < 1e-12);
    CHECK(p.extents[0] == doctest::Approx(3.0).epsilon(1e-9));
}

TEST_CASE("checking a sheet: both sides drawn, loose parts, no area") {
    Mesh mesh = rectangle(1, 1, 2, 2);
    const std::size_t single = mesh.faces.size();
    for (std::size_t i = 0; i < single; ++i) {
        const Face f = mesh.faces[i];
        mesh.faces.push_back({f[0], f[2], f[1]});
    }
    Faults faults;
    Mesh closed = mesh;
    CHECK(!check_and_repair(closed, faults));
    faults.clear();
    CHECK(check_sheet(mesh, faults));
    CHECK(mesh.faces.size() == single);
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].id == FaultId::mesh_duplicate_face);
    CHECK(faults[0].severity == Severity::warning);

    faults.clear();
    Mesh far = rectangle(1, 1, 1, 1);
    for (Vec& v : far.vertices) v[2] += 1.0;
    Mesh two = joined(mesh, far);
    CHECK(check_sheet(two, faults));
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].id == FaultId::mesh_several_components);

    faults.clear();
    Mesh flat;
    flat.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    flat.faces = {{0, 1, 2}};
    CHECK(!check_sheet(flat, faults));
    CHECK(faults.back().id == FaultId::mesh_degenerate_face);
}
