// The table of docs/physics.md section 2.1, printed and held.
#include "baker/added_mass.h"
#include "mesh_shapes.h"
#include "shape/lamb.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

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

TEST_CASE("accuracy table: ellipsoids of 320, 1280 and 5120 triangles against Lamb") {
    struct Row {
        std::array<double, 3> axes;
        std::array<double, 3> limits; // a fifth above what was measured, never over the promised 1.5 % at 1280
    };
    for (const Row& row : {Row{{4, 2, 1}, {0.015, 0.0013, 0.0005}}, Row{{1, 1, 1}, {0.001, 0.001, 0.0005}},
                           Row{{1, 1, 0.1}, {0.045, 0.006, 0.0015}}, Row{{1, 0.5, 0.05}, {0.06, 0.01, 0.0025}},
                           Row{{1, 1, 0.01}, {0.08, 0.025, 0.012}}}) {
        std::array<double, 3> error{};
#ifdef LR_TEST_QUICK
        const int levels = 2;
#else
        const int levels = 3;
#endif
        for (int level = 0; level < levels; ++level) {
            error[static_cast<size_t>(level)] = worst_error(row.axes, level + 2);
            CHECK(error[static_cast<size_t>(level)] < row.limits[static_cast<size_t>(level)]);
        }
        MESSAGE("semi-axes ", row.axes[0], ":", row.axes[1], ":", row.axes[2], ", worst entry in %: ", 100 * error[0],
                " ", 100 * error[1], " ", 100 * error[2]);
    }
}
