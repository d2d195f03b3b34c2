#include "baker/turbulence/pressure_projection.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lr::baker {

PressureProjection::PressureProjection(const MacGrid& grid)
    : cells_(grid.cells), spacing_(grid.spacing), nx_(grid.cells[0]), layer_(nx_ * grid.cells[1]), first_(layer_),
      last_(layer_ + grid.cell_count()) {
    const size_t size = last_ + layer_;
    for (std::vector<double>* v : {&diagonal_, &link_[0], &link_[1], &link_[2], &potential_, &change_, &residual_,
                                   &old_residual_, &direction_, &image_, &preconditioned_})
        v->assign(size, 0.0);

    const size_t stride[3] = {1, nx_, layer_};
    const std::array<uint32_t, 3>& n = grid.cells;
    for (uint32_t k = 0; k < n[2]; ++k)
        for (uint32_t j = 0; j < n[1]; ++j)
            for (uint32_t i = 0; i < n[0]; ++i) {
                const size_t c = grid.cell(i, j, k);
                if (grid.solid[c] != 0) continue;
                const uint32_t at[3] = {i, j, k};
                for (size_t a = 0; a < 3; ++a) {
                    const double weight = 1.0 / (grid.spacing[a] * grid.spacing[a]);
                    if (at[a] + 1 == n[a]) {
                        // Outflow: zero pressure on the face, half a cell from the centre.
                        if (a == 0) diagonal_[first_ + c] += 2.0 * weight;
                        continue;
                    }
                    if (grid.wall_before(a, i + (a == 0), j + (a == 1), k + (a == 2))) continue;
                    link_[a][first_ + c] = weight;
                    diagonal_[first_ + c] += weight;
                    diagonal_[first_ + c + stride[a]] += weight;
                }
            }
}

void PressureProjection::multiply(const std::vector<double>& x, std::vector<double>& y) const {
    for (size_t c = first_; c < last_; ++c)
        y[c] = diagonal_[c] * x[c] - link_[0][c] * x[c + 1] - link_[0][c - 1] * x[c - 1] - link_[1][c] * x[c + nx_] -
               link_[1][c - nx_] * x[c - nx_] - link_[2][c] * x[c + layer_] - link_[2][c - layer_] * x[c - layer_];
}

void PressureProjection::precorrect(MacGrid& grid) {
    subtract_gradient(grid, potential_);
    precorrected_ = true;
}

void PressureProjection::subtract_gradient(MacGrid& grid, const std::vector<double>& potential) const {
    const size_t stride[3] = {1, nx_, layer_};
    const std::array<uint32_t, 3>& n = grid.cells;
    for (size_t a = 0; a < 3; ++a) {
        GridField& field = grid.velocity[a];
        const double inverse = field.inverse_spacing[a];
        const uint32_t shift = field.inflow_column ? 1 : 0;
        for (uint32_t k = 0; k < n[2]; ++k)
            for (uint32_t j = 0; j < n[1]; ++j)
                for (uint32_t i = 0; i < n[0]; ++i) {
                    const size_t f = field.index(i + shift, j, k); // the face before the cell
                    if (grid.prescribed[a][f] != 0) continue;
                    const size_t c = first_ + grid.cell(i, j, k);
                    field.values[f] -= (potential[c] - potential[c - stride[a]]) * inverse;
                }
    }
    GridField& u = grid.velocity[0];
    for (uint32_t k = 0; k < n[2]; ++k)
        for (uint32_t j = 0; j < n[1]; ++j) {
            const size_t f = u.index(n[0], j, k);
            if (grid.prescribed[0][f] == 0)
                u.values[f] += 2.0 * potential[first_ + grid.cell(n[0] - 1, j, k)] * u.inverse_spacing[0];
        }
}

ProjectionResult PressureProjection::project(MacGrid& grid, double tolerance, double enough) {
    constexpr int max_iterations = 5000;
    const std::array<uint32_t, 3>& n = grid.cells;
    double largest_speed = 0.0;
    for (const GridField& field : grid.velocity)
        for (double value : field.values) largest_speed = std::max(largest_speed, std::abs(value));
    const double cell = std::min({grid.spacing[0], grid.spacing[1], grid.spacing[2]});

    double source = 0.0;
    for (uint32_t k = 0; k < n[2]; ++k)
        for (uint32_t j = 0; j < n[1]; ++j)
            for (uint32_t i = 0; i < n[0]; ++i) {
                const size_t c = grid.cell(i, j, k);
                const double b = grid.solid[c] != 0 ? 0.0 : -grid.divergence(i, j, k);
                residual_[first_ + c] = b;
                source = std::max(source, std::abs(b));
            }
    const double target = std::max({tolerance * source, enough, 1e-14 * largest_speed / cell});
    const bool precorrected = std::exchange(precorrected_, false);
    if (source <= target) return {true, 0, source};

    const auto dot = [this](const std::vector<double>& x, const std::vector<double>& y) {
        double sum = 0.0;
        for (size_t c = first_; c < last_; ++c) sum += x[c] * y[c];
        return sum;
    };
    if (precorrected)
        std::fill(change_.begin(), change_.end(), 0.0);
    else
        change_ = potential_;
    multiply(change_, image_);
    double left = 0.0;
    for (size_t c = first_; c < last_; ++c) {
        residual_[c] -= image_[c];
        left = std::max(left, std::abs(residual_[c]));
    }
    int iterations = 0;
    if (left > target) {
        if (!multigrid_)
            multigrid_.emplace(cells_, spacing_, &diagonal_[first_],
                               std::array<const double*, 3>{&link_[0][first_], &link_[1][first_], &link_[2][first_]});
        const auto precondition = [this] { multigrid_->cycle(&residual_[first_], &preconditioned_[first_]); };
        precondition();
        direction_ = preconditioned_;
        double rho = dot(residual_, preconditioned_);
        while (left > target && iterations < max_iterations) {
            ++iterations;
            multiply(direction_, image_);
            const double alpha = rho / dot(direction_, image_);
            left = 0.0;
            old_residual_ = residual_;
            for (size_t c = first_; c < last_; ++c) {
                change_[c] += alpha * direction_[c];
                residual_[c] -= alpha * image_[c];
                left = std::max(left, std::abs(residual_[c]));
            }
            if (left <= target) break;
            precondition();
            // Polak-Ribiere formula, because the cycle's rounding makes the preconditioner slightly variable.
            const double rho_next = dot(residual_, preconditioned_);
            const double beta = (rho_next - dot(old_residual_, preconditioned_)) / rho;
            rho = rho_next;
            for (size_t c = first_; c < last_; ++c) direction_[c] = preconditioned_[c] + beta * direction_[c];
        }
    }
    subtract_gradient(grid, change_);
    if (precorrected)
        for (size_t c = first_; c < last_; ++c) potential_[c] += change_[c];
    else
        potential_.swap(change_);
    return {left <= target, iterations, grid.max_divergence()};
}
} // namespace lr::baker
