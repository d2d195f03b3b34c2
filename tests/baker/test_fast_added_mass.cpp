#include "baker/added_mass/added_mass.h"
#include "baker/added_mass/conjugate_gradients.h"
#include "baker/added_mass/fast_system.h"
#include "baker/added_mass/mixed_added_mass.h"
#include "sheet_shapes.h"

#include <doctest/doctest.h>

#include <hwy/targets.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

using namespace lr;
using namespace lr::baker;
using Vec = Eigen::Vector3d;

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

AddedMassOptions all_fast(unsigned threads = 2) {
    return {0, threads};
}

AddedMass solve(const Mesh& mesh, const AddedMassOptions& options, bool sheet = false) {
    AddedMass result;
    Faults faults;
    Refinement as_it_is;
    as_it_is.panels = 0;
    as_it_is.strips = 1;
    AddedMassOptions once = options;
    once.as_given = true;
    const bool good = sheet ? compute_sheet_added_mass(mesh, {0, 0, 0}, as_it_is, result, faults, {}, once)
                            : compute_added_mass(mesh, {0, 0, 0}, result, faults, {}, options);
    REQUIRE(good);
    CHECK(faults.empty());
    return result;
}

// Entries over the largest of the diagonal of their block.
Matrix6 relative(const Matrix6& value, const Matrix6& to) {
    Eigen::Matrix<double, 6, 1> scale;
    scale.head<3>().setConstant(std::sqrt(to.diagonal().head<3>().maxCoeff()));
    scale.tail<3>().setConstant(std::sqrt(std::max(to.diagonal().tail<3>().maxCoeff(), 0.01 * scale[0] * scale[0])));
    return value.cwiseQuotient(scale * scale.transpose());
}

Mesh two_ellipsoids() {
    Mesh mesh = test::ellipsoid(1, 0.5, 0.4, 3), other = test::ellipsoid(0.3, 0.7, 0.2, 3);
    test::apply(other, test::some_rotation(), {0.5, 0.9, 0.8});
    const auto base = static_cast<uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const Face& f : other.faces) mesh.faces.push_back({base + f[0], base + f[1], base + f[2]});
    return mesh;
}

// Three wings at one edge: unknowns on either side of a panel.
Mesh tripod(int n) {
    const auto wing = [&](double angle) {
        return test::patch(n, n,
                           [=](double u, double v) { return Vec(u * std::cos(angle), u * std::sin(angle), v - 0.5); });
    };
    return test::joined(test::joined(wing(0.3), wing(2.0)), wing(4.4));
}

} // namespace

TEST_CASE("fast added mass is that of the dense matrix" * doctest::test_suite("long") *
          doctest::skip(lr::test::sanitized)) {
    struct Case {
        const char* name;
        Mesh mesh;
        bool sheet = false;
    };
    const Case cases[] = {
        {"ellipsoid", test::ellipsoid(4, 2, 1, 4)},
        {"cube", test::cube(18)},
        {"graded box", test::box({1.0, 0.7, 0.3}, {26, 20, 10}, 1.0)},
        {"needles", test::box({1.0, 1.0, 0.5}, {5, 80, 4})},
        {"leaf", test::leaf(32, 10, 0.0075, 0.3)},
        {"two parts", two_ellipsoids()},
        {"square", test::rectangle(1, 1, 36, 36), true},
        {"curled",
         test::patch(40, 30, [](double u, double v) { return Vec(u, 0.3 * std::cos(3 * v), 0.3 * std::sin(3 * v)); }),
         true},
        {"tripod", tripod(20), true},
        {"closed sheet", test::cube(12), true}};
    for (const Case& c : cases) {
        CAPTURE(c.name);
        const AddedMass dense = solve(c.mesh, {}, c.sheet), fast = solve(c.mesh, all_fast(), c.sheet);
        CHECK(dense.iterations == 0);
        CHECK(fast.iterations > 0);
        CHECK(fast.iterations < 40);
        CHECK(fast.residual < 1e-5);
        CHECK(fast.condition_estimate >= 1.0);
        CHECK(fast.asymmetry < dense.asymmetry + 1e-5);
        CHECK(relative(fast.value - dense.value, dense.value).cwiseAbs().maxCoeff() < 1e-5);
        // and the estimate, except for the expansions' effect on the check of the right side
        CHECK(relative(fast.error - dense.error, dense.value).cwiseAbs().maxCoeff() < 1e-4);
    }
}

TEST_CASE("fast added mass: ellipsoid of 20,480 triangles against Lamb" * doctest::test_suite("long-exact")) {
    // closed forms of test_added_mass.cpp at 4:2:1, over the volume
    const AddedMass m = solve(test::ellipsoid(4, 2, 1, 5), all_fast());
    const double volume = 4.0 / 3.0 * 3.14159265358979323846 * 8.0;
    const double exact[] = {0.12657, 0.39817, 1.51806};
    for (int i = 0; i < 3; ++i) {
        CHECK(m.value(i, i) / volume == doctest::Approx(exact[i]).epsilon(3e-4));
        CHECK(std::abs(m.value(i, i) / volume - exact[i]) < m.error(i, i) / volume + 5e-6);
        CHECK(m.error(i, i) < 2e-3 * m.value(i, i));
    }
    CHECK(m.iterations < 25);
}

TEST_CASE("fast added mass: same bits for any number of threads and instruction set" * doctest::test_suite("exact")) {
    const Mesh sheet = test::patch(24, 16, [](double u, double v) { return Vec(u, v, 0.3 * u * v); });
    const Mesh closed = test::icosphere(3);
    for (const bool open : {true, false}) {
        const Mesh& mesh = open ? sheet : closed;
        const AddedMass one = solve(mesh, all_fast(1), open);
        const auto compare = [&](const AddedMass& m) {
            CHECK(m.value == one.value);
            CHECK(m.error == one.error);
            CHECK(m.residual == one.residual);
        };
        for (const unsigned threads : {2U, 5U}) compare(solve(mesh, all_fast(threads), open));
        const auto supported = hwy::SupportedTargets();
        for (auto left = supported; left != 0; left &= left - 1) {
            hwy::SetSupportedTargetsForTest(left & -left);
            compare(solve(mesh, all_fast(1), open));
        }
        hwy::SetSupportedTargetsForTest(0);
    }
}

TEST_CASE("fast added mass turns with the body" * doctest::skip(lr::test::sanitized)) {
    const Mesh mesh = test::leaf(32, 10, 0.02, 0.2);
    Mesh turned = mesh;
    const Eigen::Matrix3d rotation = test::some_rotation();
    test::apply(turned, rotation);
    Matrix6 both = Matrix6::Zero();
    both.topLeftCorner<3, 3>() = rotation;
    both.bottomRightCorner<3, 3>() = rotation;
    const AddedMass a = solve(mesh, all_fast()), b = solve(turned, all_fast());
    CHECK(relative(both.transpose() * b.value * both - a.value, a.value).cwiseAbs().maxCoeff() < 1e-5);
}

TEST_CASE("memory of the fast matrix grows with the number of panels") {
    double last = 0.0;
    for (const int level : {4, 5, 6}) {
        const Mesh mesh = test::ellipsoid(4, 2, 1, level);
        BoundaryOperators op;
        for (const Face& f : mesh.faces)
            op.panels.push_back(make_panel(mesh.vertices[f[0]], mesh.vertices[f[1]], mesh.vertices[f[2]]));
        const NearSingleLayer near;
        const double stored = static_cast<double>(FastSystem(op, near, closed_basis(mesh), 1).stored_entries());
        if (last > 0.0) CHECK(stored / last < 4.2); // for four times the panels
        last = stored;
    }
}

TEST_CASE("fast matrix: products, symmetry, and nothing from a constant") {
    const Mesh mesh = test::ellipsoid(2, 1, 0.5, 4);
    const SurfaceBasis basis = closed_basis(mesh);
    BoundaryOperators op;
    NearSingleLayer near;
    REQUIRE(assemble_without_matrix(
        mesh, basis, 2, [](double) {}, op, near));
    FastSystem system(op, near, basis, 2);
    system.assemble([](double) {});
    const BoundaryOperators dense = assemble_boundary_operators(mesh, basis, [](double) {});
    CHECK((op.right_side - dense.right_side).norm() < 1e-5 * dense.right_side.norm());
    CHECK((op.moments - dense.moments).norm() < 1e-13 * dense.moments.norm());
    const auto n = static_cast<Eigen::Index>(basis.unknowns);
    Eigen::MatrixXd x(n, 3);
    for (Eigen::Index i = 0; i < n; ++i)
        x.row(i) << mesh.vertices[static_cast<std::size_t>(i)][0], 1.0,
            static_cast<double>((i * 7919) % 1000) / 500 - 1;
    const Eigen::MatrixXd y = system.multiply(x), exact = dense.hypersingular.selfadjointView<Eigen::Lower>() * x;
    CHECK((y.col(0) - exact.col(0)).norm() < 3e-5 * exact.col(0).norm());
    CHECK((y.col(2) - exact.col(2)).norm() < 1e-6 * exact.col(2).norm());
    CHECK(y.col(1).norm() < 3e-5 * y.col(0).norm());
    CHECK(x.col(0).dot(y.col(2)) == doctest::Approx(x.col(2).dot(y.col(0))).epsilon(1e-6));
}

TEST_CASE("fast added mass: progress runs from start to one, what cannot be solved is refused") {
    std::vector<double> seen;
    AddedMass m;
    Faults faults;
    REQUIRE(compute_added_mass(
        test::icosphere(4), {0, 0, 0}, m, faults, [&](double f) { seen.push_back(f); }, all_fast()));
    CHECK(seen.size() > 25);
    for (std::size_t i = 1; i < seen.size(); ++i) CHECK(seen[i] - seen[i - 1] < 0.25);
    CHECK(std::is_sorted(seen.begin(), seen.end()));
    CHECK(seen.back() == 1.0);
    CHECK(faults.empty());
    // a plate a millionth as thick as wide: motion with both sides has no correct digit
    CHECK_FALSE(compute_added_mass(test::box({1, 1, 1e-7}, {20, 20, 1}), {0, 0, 0}, m, faults, {}, all_fast()));
    CHECK(faults.back().id == FaultId::mesh_ill_conditioned);
}

TEST_CASE("near integrals: their points are bounded before any is computed") {
    const Mesh mesh = test::icosphere(3);
    NearLimits few;
    few.points = 1000.0;
    const auto none = [](double) {};
    CHECK(assemble_boundary_operators(mesh, closed_basis(mesh), none, few).hypersingular.size() == 0);
    few.points = 1e7;
    CHECK(assemble_boundary_operators(mesh, closed_basis(mesh), none, few).hypersingular.size() > 0);
}

TEST_CASE("a fan of needles: without patience it is refused, and its coarser surface has few faces" *
          doctest::test_suite("long")) {
    constexpr uint32_t sides = 9000;
    BodyParts parts;
    Mesh& fan = parts.mesh;
    fan.vertices.emplace_back(0, 0, 0);
    for (uint32_t i = 0; i < sides; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / sides;
        fan.vertices.emplace_back(std::cos(angle), std::sin(angle), 0.0);
        fan.faces.push_back({0, 1 + i, 1 + (i + 1) % sides});
    }
    AddedMassOptions hasty;
    hasty.patient = false;
    AddedMass m;
    Faults faults;
    CHECK_FALSE(compute_sheet_added_mass(fan, {0, 0, 0}, {}, m, faults, {}, hasty));
    REQUIRE(!faults.empty());
    CHECK(faults.back().id == FaultId::mesh_too_many_faces);
    faults.clear();
    REQUIRE(compute_mixed_added_mass(parts, {0, 0, 0}, m, faults, {}, hasty));
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].severity == Severity::warning);
    std::size_t faces = 0;
    const std::string before = "coarser surface of ";
    const std::size_t at = faults[0].what.find(before);
    REQUIRE(at != std::string::npos);
    faces = std::stoul(faults[0].what.substr(at + before.size()));
    CHECK(faces > 100);
    CHECK(faces <= 5000);
    CHECK(std::abs(m.value(2, 2) - 8.0 / 3.0) < m.error(2, 2));
    CHECK(std::abs(m.value(3, 3) - 16.0 / 45.0) < m.error(3, 3));
    CHECK(m.error(2, 2) < 0.15 * m.value(2, 2));
}

TEST_CASE("conjugate gradients: a known solution, zero modes, and matrices that are not positive") {
    constexpr std::size_t n = 200;
    const auto diagonal = [](double low) {
        return [low](const ModeVectors& x, ModeVectors& y) {
            y.resize(x.size());
            for (std::size_t i = 0; i < x.size(); ++i) y[i] = (low + static_cast<double>(i / mode_lanes % 17)) * x[i];
        };
    };
    const ModeOperator identity = [](const ModeVectors& r, ModeVectors& z) { z = r; };
    ModeVectors exact(n * mode_lanes, 0.0), right;
    for (std::size_t i = 0; i < exact.size(); ++i)
        if (i % mode_lanes < 5) exact[i] = std::sin(static_cast<double>(i));
    diagonal(1.0)(exact, right);
    ModeSolution solution;
    REQUIRE(solve_modes(
        diagonal(1.0), identity, right, 1e-10, 100, [](double) {}, solution));
    CHECK(solution.iterations <= 17); // as many as there are eigenvalues
    CHECK(solution.condition == doctest::Approx(17.0).epsilon(1e-6));
    CHECK(solution.residual < 1e-9);
    for (std::size_t i = 0; i < exact.size(); ++i) CHECK(std::abs(solution.value[i] - exact[i]) < 1e-8);
    CHECK_FALSE(solve_modes(
        diagonal(1.0), identity, right, 1e-10, 5, [](double) {}, solution));
    CHECK_FALSE(solve_modes(
        diagonal(-4.0), identity, right, 1e-10, 100, [](double) {}, solution));
    REQUIRE(solve_modes(
        diagonal(1.0), identity, ModeVectors(n * mode_lanes, 0.0), 1e-10, 5, [](double) {}, solution));
    CHECK(solution.iterations == 0);
    CHECK(std::all_of(solution.value.begin(), solution.value.end(), [](double v) { return v == 0.0; }));
}
