#include "baker/added_mass/conjugate_gradients.h"

#include "baker/eigensystem.h"

#include <algorithm>
#include <cmath>

namespace lr::baker {
namespace {

using Modes = std::array<double, mode_lanes>;

Modes dot(const ModeVectors& a, const ModeVectors& b) {
    Modes sum{};
    for (std::size_t i = 0; i < a.size(); i += mode_lanes)
        for (std::size_t m = 0; m < mode_lanes; ++m) sum[m] += a[i + m] * b[i + m];
    return sum;
}

// a += factor * b
void add(ModeVectors& a, const Modes& factor, const ModeVectors& b) {
    for (std::size_t i = 0; i < a.size(); i += mode_lanes)
        for (std::size_t m = 0; m < mode_lanes; ++m) a[i + m] += factor[m] * b[i + m];
}

// Condition of the Lanczos matrix from steps alpha and ratios beta (Golub and Van Loan, Matrix Computations, 10.2).
double condition_of(const std::vector<double>& alpha, const std::vector<double>& beta) {
    const auto n = static_cast<Eigen::Index>(alpha.size());
    if (n == 0) return 1.0;
    Eigen::VectorXd diagonal(n), beside(std::max<Eigen::Index>(n - 1, 0));
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto k = static_cast<std::size_t>(i);
        diagonal[i] = 1.0 / alpha[k] + (k > 0 ? beta[k - 1] / alpha[k - 1] : 0.0);
        if (i + 1 < n) beside[i] = std::sqrt(beta[k]) / alpha[k];
    }
    const Eigen::VectorXd values = tridiagonal_eigenvalues(diagonal, beside);
    return values[n - 1] / std::max(values[0], 1e-300);
}
} // namespace

bool solve_modes(const ModeOperator& matrix, const ModeOperator& preconditioner, const ModeVectors& right,
                 double tolerance, std::size_t max_iterations, const std::function<void(double)>& progress,
                 ModeSolution& out) {
    ModeVectors r = right, z, p, q;
    out.value.assign(right.size(), 0.0);
    preconditioner(r, z);
    p = z;
    Modes rz = dot(r, z);
    const Modes start = rz;
    const double largest = *std::max_element(start.begin(), start.end());
    std::array<std::vector<double>, mode_lanes> steps, ratios;
    const auto goal = [&](std::size_t m) { return tolerance * tolerance * std::max(start[m], 1e-6 * largest); };
    const auto progress_made = [&] { // the slowest mode, on a logarithmic scale
        double made = 1.0;
        for (std::size_t m = 0; m < mode_lanes; ++m)
            if (rz[m] > goal(m)) made = std::min(made, std::log(start[m] / rz[m]) / std::log(start[m] / goal(m)));
        return std::clamp(made, 0.0, 1.0);
    };
    double shown = 0.0;
    for (out.iterations = 0;; ++out.iterations) {
        bool done = true;
        for (std::size_t m = 0; m < mode_lanes; ++m) {
            if (!std::isfinite(rz[m])) return false;
            done = done && !(rz[m] > goal(m));
        }
        shown = std::max(shown, progress_made());
        progress(shown);
        if (done) break;
        if (out.iterations == max_iterations) return false;
        matrix(p, q);
        const Modes pq = dot(p, q);
        Modes alpha{}, back{};
        for (std::size_t m = 0; m < mode_lanes; ++m) {
            if (!(rz[m] > goal(m))) continue; // converged
            if (!(pq[m] > 0.0)) return false;
            alpha[m] = rz[m] / pq[m];
            back[m] = -alpha[m];
        }
        add(out.value, alpha, p);
        add(r, back, q);
        preconditioner(r, z);
        const Modes next = dot(r, z);
        Modes beta{};
        for (std::size_t m = 0; m < mode_lanes; ++m) {
            if (alpha[m] == 0.0) continue;
            beta[m] = next[m] / rz[m];
            steps[m].push_back(alpha[m]);
            ratios[m].push_back(beta[m]);
            rz[m] = next[m];
        }
        for (std::size_t i = 0; i < p.size(); i += mode_lanes)
            for (std::size_t m = 0; m < mode_lanes; ++m) p[i + m] = z[i + m] + beta[m] * p[i + m];
    }
    const Modes rests = dot(r, r), wholes = dot(right, right);
    double rest = 0.0, whole = 0.0;
    for (std::size_t m = 0; m < mode_lanes; ++m) {
        rest += rests[m];
        whole += wholes[m];
        out.condition = std::max(out.condition, condition_of(steps[m], ratios[m]));
    }
    out.residual = whole > 0.0 ? std::sqrt(rest / whole) : 0.0;
    return true;
}
} // namespace lr::baker
