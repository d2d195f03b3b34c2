// The far part of sums over 1/r for all rigid modes at once, by the fast multipole method.
#pragma once

#include "baker/added_mass/cluster_tree.h"
#include "baker/added_mass/multipole_kernels.h"

#include <complex>
#include <vector>

namespace lr::baker {

// One expansion for each cluster: cluster * expansion_size.
using Expansions = std::vector<double>;

// Computes, from the multipoles of the leaves, those of all clusters and the local expansions of the leaves: the potential 1/r of
// all clusters far from a leaf or its parents, with degrees up to `order`. The same bits for any number of threads.
void evaluate_far(const ClusterTree& tree, unsigned threads, std::size_t order, Expansions& multipoles,
                  Expansions& locals);

using Harmonics = std::array<std::complex<double>, expansion_terms>;

// R_l^m at a position relative to the centre (multipole_kernels.h).
Harmonics regular_harmonics(const Eigen::Vector3d& place);

// n . grad R_l^m from R_l^m.
Harmonics normal_derivatives(const Harmonics& harmonics, const Eigen::Vector3d& normal);

// Multiplies the terms of degree l by ratio^l.
void scale_degrees(double ratio, double* expansion);
} // namespace lr::baker
