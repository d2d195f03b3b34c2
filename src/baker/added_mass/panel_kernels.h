// The inner loops of the boundary element matrices, for every instruction set. No multiply-add is fused and no sum crosses
// lanes, so that each set gives the same bits.
#pragma once

#include "baker/added_mass/panel_integrals.h"

#include <cstddef>
#include <vector>

namespace lr::baker {

constexpr std::size_t near_batch = 8;

// The quantities of a panel for the near integrals.
struct NearFields {
    enum Field : std::size_t {
        corner = 0,       // 3 x 3
        normal = 9,       // 3
        edge_normal = 12, // 3 x 3
        edge_length = 21, // 3
        edge_cosine = 24, // between edge normals 0 and 1, 1 and 2, 2 and 0
        twice_area = 27,
        in_plane = 28, // smaller heights count as zero
        count = 29
    };
};
std::array<double, NearFields::count> near_fields(const Panel& panel);

// Results for up to near_batch source panels and one outer panel, one lane each.
struct NearResult {
    enum Field : std::size_t {
        single_layer = 0, // rule over the outer panel of integral 1/r, without the outer area
        // [e][a]: rule of lambda_a times the integral of lambda_k d/dn (1/r) without its factor l_e / (2 area); k is the
        // corner opposite edge e
        double_layer = 1,
        // [b][a]: sum over the midpoints of the outer edges of lambda_a d/dn (1/r) from the midpoint of edge b
        middles = 10,
        count = 19
    };
};
struct OuterRule {
    const double* points;  // x y z of each
    const double* weights; // lambda_0, lambda_1, lambda_2 times the weight of each
    std::size_t size;
    const double* middles; // x y z of the midpoint of each edge
};
// sources[field * near_batch + lane], results likewise.
void integrate_near_panels(const OuterRule& outer, const double* sources, double* results);

// Sums of d/dn (1/r) between all points: sum[c][s] = sum over e of moment[c][e] n_s . (x_e - x_s) / r^3. All arrays have a
// multiple of near_batch values; point e = s adds nothing.
struct DoubletArrays {
    std::array<std::vector<double>, 3> position, normal;
    std::array<std::vector<double>, 6> moment, sum;
};
void sum_doublets(DoubletArrays& arrays, std::size_t begin, std::size_t end);

// A panel's record for far integrals: centroid 3, second moments xx yy zz xy yz zx, area / (4 pi).
constexpr std::size_t far_fields = 10;
// values[s * near_batch + lane] = double integral of G between panel s and panel targets[lane].
void far_single_layer(const double* panels, std::size_t count, const std::array<std::size_t, near_batch>& targets,
                      double* values);

// The panels around each unknown.
struct PanelFans {
    std::vector<std::size_t> start;
    std::vector<uint32_t> panel;
    std::vector<double> curl; // x y z of each
};
// columns[k * near_batch + lane][v] += curl[k of the target of lane] . sum over the fan of v of value * curl.
void add_currents(const PanelFans& fans, const double* values, const double* curls,
                  const std::array<double*, 3 * near_batch>& columns, std::size_t lanes);
} // namespace lr::baker
