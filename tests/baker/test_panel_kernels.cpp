#include "baker/added_mass/added_mass.h"
#include "baker/added_mass/panel_kernels.h"
#include "mesh_shapes.h"

#include <doctest/doctest.h>

#include <hwy/targets.h>

using namespace lr;
using namespace lr::baker;

TEST_CASE("near integrals lane by lane are those of panel_potential, also in the plane and on corners") {
    const Panel outer = make_panel({0, 0, 0}, {1, 0.1, 0}, {0.2, 0.8, 0});
    // coplanar with a common edge, folded, above, below, far, a sliver
    const std::array<Panel, near_batch> panels = {make_panel({1, 0.1, 0}, {0, 0, 0}, {0.5, -0.7, 0}),
                                                  make_panel({1, 0.1, 0}, {0, 0, 0}, {0.5, -0.2, 0.6}),
                                                  make_panel({0, 0, 0.01}, {1, 0.1, 0.01}, {0.2, 1, 0.01}),
                                                  make_panel({0, 0, -0.3}, {0.2, 1, -0.3}, {1, 0, -0.2}),
                                                  make_panel({9, 5, 2}, {9, 6, 2}, {8, 5, 1}),
                                                  make_panel({0, 2, 0}, {1, 2, 0}, {0.5, 2.001, 0}),
                                                  make_panel({0, 0, 0}, {1, 0.1, 0}, {0.2, 0.8, 0}),
                                                  make_panel({-1, 0, 1}, {1, 0, 1}, {0, 0, 1.2})};
    std::array<double, NearFields::count * near_batch> sources;
    for (std::size_t lane = 0; lane < near_batch; ++lane) {
        const auto fields = near_fields(panels[lane]);
        for (std::size_t f = 0; f < fields.size(); ++f) sources[f * near_batch + lane] = fields[f];
    }
    const std::array<double, 9> middles{};
    const std::array<double, 3> weights = {0.5, 0.25, 0.125};
    for (const Eigen::Vector3d& x :
         {outer.centroid, outer.corner[0], Eigen::Vector3d(0.5 * (outer.corner[0] + outer.corner[1])),
          Eigen::Vector3d(0.3, 0.2, 0.005), Eigen::Vector3d(-0.4, 0.1, 1.1)}) {
        std::array<double, NearResult::count * near_batch> results;
        integrate_near_panels({x.data(), weights.data(), 1, middles.data()}, sources.data(), results.data());
        for (std::size_t lane = 0; lane < near_batch; ++lane) {
            CAPTURE(lane);
            const Panel& panel = panels[lane];
            const PanelPotential exact = panel_potential(panel, x);
            const double single_layer = results[NearResult::single_layer * near_batch + lane];
            CHECK(std::abs(single_layer - 0.875 * exact.single_layer) < 1e-13); // of panels of size 1
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t edge = (k + 1) % 3;
                const double slope = panel.edge_length[edge] / (2.0 * panel.area);
                for (std::size_t a = 0; a < 3; ++a) {
                    const double got = slope * results[(NearResult::double_layer + 3 * edge + a) * near_batch + lane];
                    CHECK(std::abs(got - weights[a] * exact.double_layer[k]) < 1e-10);
                }
            }
        }
    }
}

TEST_CASE("added mass: the same bits on every instruction set") {
    const Mesh mesh = test::sanitized ? test::icosphere(2) : test::ellipsoid(4, 2, 1, 3);
    AddedMass reference, other;
    Faults faults;
    REQUIRE(compute_added_mass(mesh, {0, 0, 0}, reference, faults));
    const auto supported = hwy::SupportedTargets();
    int sets = 0;
    for (auto left = supported; left != 0; left &= left - 1) {
        hwy::SetSupportedTargetsForTest(left & -left);
        REQUIRE(compute_added_mass(mesh, {0, 0, 0}, other, faults));
        CHECK(other.value == reference.value);
        CHECK(other.error == reference.error);
        CHECK(other.condition_estimate == reference.condition_estimate);
        ++sets;
    }
    hwy::SetSupportedTargetsForTest(0);
    MESSAGE(sets, " instruction sets");
}
