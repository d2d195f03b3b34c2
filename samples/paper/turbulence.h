// Reads lr_bake's report of an asset: the turbulence table and the times.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

struct BakeReport {
    double reynolds, u0, c0;
    double table_dt;                               // s
    std::vector<double> chi, epsilon;              // 1/s, m^2/s^3
    std::size_t stationary;                        // sample
    std::size_t faces;                             // triangles of the mesh
    double added_mass_seconds, turbulence_seconds; // of the bake, on its machine
};

BakeReport read_report(const std::string& path); // throws Failure

// k in a uniform stream at time t relative to its first value: Eqs. 16 and 17 with G = 0.
double closed_form_decay(double chi0, double t);
