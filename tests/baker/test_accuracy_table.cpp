// Prints and checks the tables of docs/maintainers/physics.md sections 2.1 and 2.2.
#include "asset/closed_forms/ellipsoid_formulas.h"
#include "baker/added_mass/added_mass.h"
#include "sheet_shapes.h"
#include "support/quick.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace {

// Largest relative error of the diagonal entries that are not zero.
double worst_error(const std::array<double, 3>& axes, int level) {
    lr::baker::AddedMass got;
    lr::Faults faults;
    REQUIRE(
        lr::baker::compute_added_mass(lr::test::ellipsoid(axes[0], axes[1], axes[2], level), {0, 0, 0}, got, faults));
    const lr::shape::EllipsoidAddedMass exact = lr::shape::lamb_added_mass(axes);
    double worst = 0.0;
    for (int i = 0; i < 3; ++i) {
        worst = std::max(worst, std::abs(got.value(i, i) / exact.translation[static_cast<size_t>(i)] - 1.0));
        const double rotation = exact.rotation[static_cast<size_t>(i)];
        if (rotation > 0.0) worst = std::max(worst, std::abs(got.value(i + 3, i + 3) / rotation - 1.0));
    }
    return worst;
}

} // namespace

TEST_CASE("accuracy table: ellipsoids of 320, 1280 and 5120 triangles against Lamb" * doctest::test_suite("long") *
          doctest::skip(lr::test::sanitized)) {
    struct Row {
        std::array<double, 3> axes;
        std::array<double, 3> limits; // a fifth above the measured errors, at most the promised 1.5 % at 1280
    };
    for (const Row& row : {Row{{4, 2, 1}, {0.007, 0.0013, 0.0005}}, Row{{1, 1, 1}, {0.001, 0.001, 0.0005}},
                           Row{{1, 1, 0.1}, {0.027, 0.004, 0.0015}}, Row{{1, 0.5, 0.05}, {0.04, 0.0085, 0.0025}},
                           Row{{1, 1, 0.01}, {0.07, 0.024, 0.012}}}) {
        std::array<double, 3> error{};
        const int levels = quick() ? 2 : 3;
        for (int level = 0; level < levels; ++level) {
            error[static_cast<size_t>(level)] = worst_error(row.axes, level + 2);
            CHECK(error[static_cast<size_t>(level)] < row.limits[static_cast<size_t>(level)]);
        }
        MESSAGE("semi-axes ", row.axes[0], ":", row.axes[1], ":", row.axes[2], ", worst entry in %: ", 100 * error[0],
                " ", 100 * error[1], " ", 100 * error[2]);
    }
}

TEST_CASE("accuracy table: sheets of 2000 triangles against closed forms and published values" *
          doctest::skip(lr::test::sanitized)) {
    using lr::test::disc;
    using lr::test::rectangle;
    struct Row {
        std::string name;
        lr::baker::Mesh mesh;
        std::array<double, 3> exact; // across the sheet, about x, about y
    };
    const auto ellipse = [](double b) {
        const lr::shape::EllipsoidAddedMass limit = lr::shape::lamb_added_mass({1.0, b, 1e-7});
        lr::baker::Mesh mesh = disc(18);
        lr::test::apply(mesh, Eigen::Vector3d(1.0, b, 0.0).asDiagonal());
        return Row{
            "ellipse 1:" + std::to_string(b), mesh, {limit.translation[2], limit.rotation[0], limit.rotation[1]}};
    };
    constexpr double quarter_pi = 0.785398163397448;
    for (const Row& row : {ellipse(1.0), ellipse(0.5), ellipse(0.2),
                           Row{"1:1", rectangle(1, 1, 32, 32), {.5790 * quarter_pi, .0201, .0201}},
                           Row{"2:1", rectangle(2, 1, 44, 22), {.7569 * quarter_pi * 2, .0223 * 2, .0162 * 16}},
                           Row{"5:1", rectangle(5, 1, 70, 14), {.8967 * quarter_pi * 5, .0236 * 5, .0096 * 625}}}) {
        lr::baker::AddedMass got;
        lr::Faults faults;
        REQUIRE(lr::baker::compute_sheet_added_mass(row.mesh, {0, 0, 0}, {}, got, faults));
        std::array<double, 3> error{}, estimate{};
        for (int i = 0; i < 3; ++i) {
            const double exact = row.exact[static_cast<size_t>(i)];
            error[static_cast<size_t>(i)] = 100.0 * (got.value(i + 2, i + 2) / exact - 1.0);
            estimate[static_cast<size_t>(i)] = 100.0 * got.error(i + 2, i + 2) / exact;
            CHECK(std::abs(error[static_cast<size_t>(i)]) < 0.6);
        }
        MESSAGE(row.name, ", ", row.mesh.faces.size(), " triangles, error and estimate in %: A ", error[0], " (",
                estimate[0], "), Dx ", error[1], " (", estimate[1], "), Dy ", error[2], " (", estimate[2], ")");
    }
}
