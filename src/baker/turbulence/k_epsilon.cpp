#include "baker/turbulence/k_epsilon.h"

#include <algorithm>
#include <cmath>

namespace lr::baker {

using shape::TurbulenceState;

KEpsilon::KEpsilon(const MacGrid& grid, TurbulenceState inflow, double most_k)
    : cells_(grid.cells), solid_(grid.solid), inflow_(inflow), most_k_(most_k > 0.0 ? most_k : 1e60 * inflow.k),
      k_(grid.make_centred_field()), epsilon_(k_) {
    std::fill(k_.values.begin(), k_.values.end(), inflow.k);
    std::fill(epsilon_.values.begin(), epsilon_.values.end(), inflow.epsilon);
    next_k_ = k_.values;
    next_epsilon_ = epsilon_.values;
    prescribed_.assign(next_k_.size(), 1);
    diffusivity_.assign(next_k_.size(), 0.0);
    eddy_viscosity_.assign(next_k_.size(), 0.0);
    const size_t n = grid.cell_count();
    origin_.resize(n);
    age_.assign(n, 1.0);
    strain_.assign(n, 0.0);
    for (std::vector<double>& c : centred_) c.assign(n, 0.0);
    walls_ = find_wall_shares(grid, 3);
    if (!walls_[0].empty()) wall_sides_.assign(n, 0);

    for (uint32_t k = 0; k < cells_[2]; ++k)
        for (uint32_t j = 0; j < cells_[1]; ++j)
            for (uint32_t i = 0; i < cells_[0]; ++i) {
                const uint32_t at[3] = {i, j, k};
                for (size_t a = 0; a < 3 && !wall_sides_.empty(); ++a) {
                    const bool before = grid.wall_before(a, i, j, k);
                    const bool after =
                        at[a] + 1 < cells_[a] && grid.wall_before(a, i + (a == 0), j + (a == 1), k + (a == 2));
                    wall_sides_[grid.cell(i, j, k)] |=
                        static_cast<uint8_t>((before << (2 * a)) | (after << (2 * a + 1)));
                }
                if (solid_[grid.cell(i, j, k)] == 0) {
                    prescribed_[k_.index(i + 1, j, k)] = 0;
                    continue;
                }
                SolidCell entry{static_cast<uint32_t>(k_.index(i + 1, j, k)), 0, {}};
                const auto add = [&](uint32_t x, uint32_t y, uint32_t z) {
                    if (x >= cells_[0] || y >= cells_[1] || z >= cells_[2] || solid_[grid.cell(x, y, z)] != 0) return;
                    entry.neighbours[entry.count++] = static_cast<uint32_t>(k_.index(x + 1, y, z));
                };
                add(i - 1, j, k); // an index below zero wraps to a huge one, which is also outside
                add(i + 1, j, k);
                add(i, j - 1, k);
                add(i, j + 1, k);
                add(i, j, k - 1);
                add(i, j, k + 1);
                if (entry.count > 0) solid_cells_.push_back(entry);
            }
}

void KEpsilon::follow(const MacGrid& grid, double dt) {
    find_strain(grid);
    find_origins(grid, dt);
}

// Velocities are averaged to cell centres and differenced over two cells, one-sided at the domain's edges. On a wall, half a cell from the centre,
// they are zero (no slip); this shear contributes to G.
void KEpsilon::find_strain(const MacGrid& grid) {
    const auto [nx, ny, nz] = cells_;
    const GridField &u = grid.velocity[0], &v = grid.velocity[1], &w = grid.velocity[2];
    for (uint32_t k = 0; k < nz; ++k)
        for (uint32_t j = 0; j < ny; ++j)
            for (uint32_t i = 0; i < nx; ++i) {
                const size_t c = grid.cell(i, j, k);
                centred_[0][c] = 0.5 * (u.values[u.index(i, j, k)] + u.values[u.index(i + 1, j, k)]);
                centred_[1][c] = 0.5 * (v.values[v.index(i + 1, j, k)] + v.values[v.index(i + 1, j + 1, k)]);
                centred_[2][c] = 0.5 * (w.values[w.index(i + 1, j, k)] + w.values[w.index(i + 1, j, k + 1)]);
            }
    const size_t stride[3] = {1, nx, static_cast<size_t>(nx) * ny};
    const auto slope = [&](size_t component, size_t axis, uint32_t at, size_t c) {
        const double* const value = centred_[component].data();
        const unsigned sides = wall_sides_.empty() ? 0u : static_cast<unsigned>(wall_sides_[c]) >> (2 * axis);
        const bool wall_low = (sides & 1u) != 0, wall_high = (sides & 2u) != 0;
        const double here = value[c];
        const double low = wall_low ? 0.0 : at > 0 ? value[c - stride[axis]] : here;
        const double high = wall_high ? 0.0 : at + 1 < cells_[axis] ? value[c + stride[axis]] : here;
        if (!wall_low && !wall_high) {
            const double width = (at > 0 ? 1.0 : 0.0) + (at + 1 < cells_[axis] ? 1.0 : 0.0);
            return (high - low) / (width * grid.spacing[axis]);
        }
        // Derivative of the parabola through the three values.
        const double below = wall_low ? 0.5 : 1.0, above = wall_high ? 0.5 : 1.0;
        const double slope_below = (here - low) / below, slope_above = (high - here) / above;
        return (slope_below * above + slope_above * below) / ((below + above) * grid.spacing[axis]);
    };
    largest_strain_ = 0.0;
    for (uint32_t k = 0; k < nz; ++k)
        for (uint32_t j = 0; j < ny; ++j)
            for (uint32_t i = 0; i < nx; ++i) {
                const size_t c = grid.cell(i, j, k);
                if (solid_[c] != 0) continue;
                const double ux = (u.values[u.index(i + 1, j, k)] - u.values[u.index(i, j, k)]) * u.inverse_spacing[0];
                const double vy =
                    (v.values[v.index(i + 1, j + 1, k)] - v.values[v.index(i + 1, j, k)]) * v.inverse_spacing[1];
                const double wz =
                    (w.values[w.index(i + 1, j, k + 1)] - w.values[w.index(i + 1, j, k)]) * w.inverse_spacing[2];
                const double uy = slope(0, 1, j, c), vx = slope(1, 0, i, c);
                const double uz = slope(0, 2, k, c), wx = slope(2, 0, i, c);
                const double vz = slope(1, 2, k, c), wy = slope(2, 1, j, c);
                const double xy = uy + vx, xz = uz + wx, yz = vz + wy;
                // Eq. 15: 2 S_ij S_ij with S_xy = xy/2 and so on.
                strain_[c] = 2.0 * (ux * ux + vy * vy + wz * wz) + xy * xy + xz * xz + yz * yz;
                if (!wall_sides_.empty()) {
                    const double spin = (uy - vx) * (uy - vx) + (uz - wx) * (uz - wx) + (vz - wy) * (vz - wy);
                    strain_[c] = std::sqrt(strain_[c] * spin);
                }
                largest_strain_ = std::max(largest_strain_, strain_[c]);
            }
}

void KEpsilon::find_origins(const MacGrid& grid, double dt) {
    for (uint32_t k = 0; k < cells_[2]; ++k)
        for (uint32_t j = 0; j < cells_[1]; ++j)
            for (uint32_t i = 0; i < cells_[0]; ++i) {
                const size_t c = grid.cell(i, j, k);
                if (solid_[c] != 0) continue;
                const GridPoint p = grid.cell_centre(i, j, k);
                const GridPoint q = grid.trace_back(p, dt);
                origin_[c] = k_.locate(q);
                age_[c] = q[0] < 0.0 ? p[0] / (p[0] - q[0]) : 1.0;
            }
}

void KEpsilon::step(double dt) {
    // Interpolated k and epsilon are positive; the lower limits only prevent underflow after very long decay.
    const double least_k = 1e-60 * inflow_.k, least_chi = 1e-30 * shape::turbulent_frequency(inflow_);
    const double most_epsilon = inflow_.epsilon / (inflow_.k * std::sqrt(inflow_.k));
    size_t c = 0;
    for (uint32_t k = 0; k < cells_[2]; ++k)
        for (uint32_t j = 0; j < cells_[1]; ++j) {
            const size_t row = k_.index(1, j, k);
            for (uint32_t i = 0; i < cells_[0]; ++i, ++c) {
                if (solid_[c] != 0) continue;
                TurbulenceState s{k_.interpolate_cubic(origin_[c]), epsilon_.interpolate_cubic(origin_[c])};
                s = shape::evolve(s, strain_[c], age_[c] * dt);
                if (!(s.k > least_k) || !(s.k <= most_k_) || !(s.epsilon > least_chi * s.k)) {
                    const double chi = std::max(shape::turbulent_frequency(s), least_chi);
                    s.k = std::clamp(s.k, least_k, most_k_);
                    s.epsilon = chi * s.k;
                }
                if (!wall_sides_.empty()) s.epsilon = std::min(s.epsilon, most_epsilon * s.k * std::sqrt(s.k));
                next_k_[row + i] = s.k;
                next_epsilon_[row + i] = s.epsilon;
            }
        }
    k_.values.swap(next_k_);
    epsilon_.values.swap(next_epsilon_);
    fill_solids();
}

void KEpsilon::diffuse(double dt, double viscosity) {
    const auto spread = [&](GridField& field, double prandtl) {
        for (uint32_t k = 0; k < cells_[2]; ++k)
            for (uint32_t j = 0; j < cells_[1]; ++j) {
                const size_t row = k_.index(0, j, k);
                for (uint32_t i = 0; i < cells_[0]; ++i)
                    if (prescribed_[row + i + 1] == 0)
                        diffusivity_[row + i + 1] = viscosity + eddy_viscosity_[row + i + 1] / prandtl;
                diffusivity_[row] = diffusivity_[row + 1];
            }
        diffusion_.apply(field, prescribed_, diffusivity_, EddyDiffusion::Wall::no_flux, dt, walls_);
    };
    for (size_t s = 0; s < eddy_viscosity_.size(); ++s)
        eddy_viscosity_[s] = shape::eddy_viscosity({k_.values[s], epsilon_.values[s]});
    spread(k_, shape::sigma_k);
    spread(epsilon_, shape::sigma_epsilon);
    fill_solids();
}

void KEpsilon::fill_solids() {
    for (const SolidCell& s : solid_cells_) {
        double k = 0.0, epsilon = 0.0;
        for (uint32_t m = 0; m < s.count; ++m) {
            k += k_.values[s.neighbours[m]];
            epsilon += epsilon_.values[s.neighbours[m]];
        }
        k_.values[s.sample] = k / s.count;
        epsilon_.values[s.sample] = epsilon / s.count;
    }
}

TurbulenceState KEpsilon::at(const GridPoint& p) const {
    const GridStencil s = k_.locate(p);
    return {k_.interpolate(s), epsilon_.interpolate(s)};
}

TurbulenceState KEpsilon::in_cell(uint32_t i, uint32_t j, uint32_t k) const {
    const size_t s = k_.index(i + 1, j, k);
    return {k_.values[s], epsilon_.values[s]};
}

double KEpsilon::strain_at(uint32_t i, uint32_t j, uint32_t k) const {
    return strain_[(static_cast<size_t>(k) * cells_[1] + j) * cells_[0] + i];
}

void KEpsilon::eddy_viscosity(std::vector<double>& out) const {
    out.resize(strain_.size());
    size_t c = 0;
    for (uint32_t k = 0; k < cells_[2]; ++k)
        for (uint32_t j = 0; j < cells_[1]; ++j)
            for (uint32_t i = 0; i < cells_[0]; ++i, ++c)
                out[c] = solid_[c] != 0 ? 0.0 : shape::eddy_viscosity(in_cell(i, j, k));
}
} // namespace lr::baker
