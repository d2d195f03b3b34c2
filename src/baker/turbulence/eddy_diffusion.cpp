#include "baker/turbulence/eddy_diffusion.h"

#include <algorithm>
#include <cmath>

namespace lr::baker {

WallShares find_wall_shares(const MacGrid& grid, size_t axis) {
    const std::array<uint32_t, 3>& n = grid.cells;
    const GridField field = axis < 3 ? grid.velocity[axis] : grid.make_centred_field();
    const uint32_t shift = field.inflow_column ? 1 : 0;
    WallShares shares;
    bool any = false;
    for (size_t along = 0; along < 3; ++along) {
        if (along == axis) continue; // no wall between two faces of one cell
        shares[along].assign(field.values.size(), 0);
        for (uint32_t k = 0; k < field.count[2]; ++k)
            for (uint32_t j = 0; j < field.count[1]; ++j)
                for (uint32_t i = shift; i < field.count[0]; ++i) {
                    // A face is between two cells; each can have a wall before it.
                    uint32_t after[3] = {i - shift, j, k};
                    uint32_t before[3] = {after[0], after[1], after[2]};
                    if (axis < 3) {
                        before[axis] = after[axis] > 0 ? after[axis] - 1 : 0;
                        after[axis] = std::min(after[axis], n[axis] - 1);
                    }
                    const int walls = static_cast<int>(grid.wall_before(along, after[0], after[1], after[2])) +
                                      static_cast<int>(grid.wall_before(along, before[0], before[1], before[2]));
                    shares[along][field.index(i, j, k)] = static_cast<uint8_t>(walls);
                    any = any || walls > 0;
                }
    }
    return any ? shares : WallShares{};
}

void EddyDiffusion::apply(GridField& field, const std::vector<uint8_t>& prescribed,
                          const std::vector<double>& viscosity, Wall wall, double dt, const WallShares& walls) {
    const size_t nx = field.count[0];
    const size_t stride[3] = {1, nx, nx * field.count[1]};
    double* const value = field.values.data();
    upper_.resize(nx * std::max({size_t{1}, size_t{field.count[1]}, size_t{field.count[2]}}));
    link_.resize(2 * nx);
    for (size_t axis = 0; axis < 3; ++axis) {
        const double rate = dt * field.inverse_spacing[axis] * field.inverse_spacing[axis];
        const size_t n = field.count[axis], step = stride[axis];
        const uint8_t* const shares = walls[axis].empty() ? nullptr : walls[axis].data();
        // The link of each sample to the one before it, and its loss to the walls between them.
        struct Link {
            double through, to_wall_before, to_wall_after;
        };
        const auto link = [&](size_t s) {
            const double x = viscosity[s - step], y = viscosity[s];
            const double share = shares != nullptr ? 0.5 * shares[s] : 0.0;
            const double mean = x > 0.0 && y > 0.0 ? 0.5 * (x + y) : (wall == Wall::no_slip ? std::max(x, y) : 0.0);
            const double grip = wall == Wall::no_slip ? 2.0 * rate * share : 0.0;
            return Link{rate * mean * (1.0 - share), grip * x, grip * y};
        };
        // Thomas algorithm; the row of a prescribed sample is the identity.
        if (axis == 0) {
            for (size_t start = 0; start < field.values.size(); start += nx) {
                double upper = 0.0, right = 0.0;
                Link below{0.0, 0.0, 0.0};
                for (size_t m = 0; m < n; ++m) {
                    const size_t s = start + m;
                    Link above{0.0, 0.0, 0.0};
                    if (m + 1 < n) {
                        above = link(s + 1);
                        // The inflow column is only half a cell before the next sample.
                        if (m == 0 && field.inflow_column) above.through *= 2.0;
                    }
                    const double free = prescribed[s] == 0 ? 1.0 : 0.0;
                    const double lower = free * below.through, higher = free * above.through;
                    const double grip = free * (below.to_wall_after + above.to_wall_before);
                    const double pivot = 1.0 + higher + grip + lower * (1.0 - upper);
                    right = (value[s] + lower * right) / pivot;
                    upper = higher / pivot;
                    value[s] = right;
                    upper_[m] = upper;
                    below = above;
                }
                for (size_t m = n - 1; m-- > 0;) value[start + m] += upper_[m] * value[start + m + 1];
            }
            continue;
        }
        // The same along y or z, for a row of lines along x at once.
        const size_t other = 3 - axis;
        for (size_t r = 0; r < field.count[other]; ++r) {
            double* const link_below = link_.data();
            double* const grip_below = link_below + nx;
            std::fill(link_.begin(), link_.end(), 0.0);
            for (size_t m = 0; m < n; ++m)
                for (size_t i = 0; i < nx; ++i) {
                    const size_t s = r * stride[other] + m * step + i;
                    const Link above = m + 1 < n ? link(s + step) : Link{0.0, 0.0, 0.0};
                    const double free = prescribed[s] == 0 ? 1.0 : 0.0;
                    const double lower = free * link_below[i], higher = free * above.through;
                    const double grip = free * (grip_below[i] + above.to_wall_before);
                    const double before = m > 0 ? upper_[(m - 1) * nx + i] : 0.0;
                    const double pivot = 1.0 + higher + grip + lower * (1.0 - before);
                    value[s] = (value[s] + lower * (m > 0 ? value[s - step] : 0.0)) / pivot;
                    upper_[m * nx + i] = higher / pivot;
                    link_below[i] = above.through;
                    grip_below[i] = above.to_wall_after;
                }
            for (size_t m = n - 1; m-- > 0;)
                for (size_t i = 0; i < nx; ++i) {
                    const size_t s = r * stride[other] + m * step + i;
                    value[s] += upper_[m * nx + i] * value[s + step];
                }
        }
    }
}

void EddyDiffusion::multiply(const std::vector<double>& x, std::vector<double>& y) const {
    const size_t sx = stride_[0], sy = stride_[1], sz = stride_[2];
    const double *lx = links_[0].data(), *ly = links_[1].data(), *lz = links_[2].data();
    for (size_t s = first_; s < last_; ++s)
        y[s] = free_[s] * (diagonal_[s] * x[s] - lx[s] * x[s - sx] - lx[s + sx] * x[s + sx] - ly[s] * x[s - sy] -
                           ly[s + sy] * x[s + sy] - lz[s] * x[s - sz] - lz[s + sz] * x[s + sz]);
}

void EddyDiffusion::apply_unsplit(GridField& field, const std::vector<double>& guess,
                                  const std::vector<uint8_t>& prescribed, const std::vector<double>& viscosity,
                                  Wall wall, double dt, const WallShares& walls, double tolerance) {
    constexpr int most_iterations = 200;
    const size_t size = field.values.size();
    stride_[0] = 1;
    stride_[1] = field.count[0];
    stride_[2] = stride_[1] * field.count[1];
    first_ = stride_[2];
    last_ = first_ + size;
    for (std::vector<double>* v :
         {&links_[0], &links_[1], &links_[2], &diagonal_, &free_, &solution_, &residual_, &direction_, &image_})
        v->assign(size + 2 * first_, 0.0);
    for (size_t s = 0; s < size; ++s) {
        diagonal_[first_ + s] = 1.0;
        free_[first_ + s] = prescribed[s] == 0 ? 1.0 : 0.0;
        solution_[first_ + s] = guess[s];
    }
    for (size_t axis = 0; axis < 3; ++axis) {
        const double rate = dt * field.inverse_spacing[axis] * field.inverse_spacing[axis];
        const size_t step = stride_[axis], n = field.count[axis];
        size_t at = 0, run = 0;
        for (size_t s = 0; s < size; ++s) {
            if (at > 0) {
                const double x = viscosity[s - step], y = viscosity[s];
                const double share = walls[axis].empty() ? 0.0 : 0.5 * walls[axis][s];
                const double mean = x > 0.0 && y > 0.0 ? 0.5 * (x + y) : (wall == Wall::no_slip ? std::max(x, y) : 0.0);
                double link = rate * mean * (1.0 - share);
                if (axis == 0 && at == 1 && field.inflow_column) link *= 2.0;
                const double grip = wall == Wall::no_slip ? 2.0 * rate * share : 0.0;
                links_[axis][first_ + s] = link;
                diagonal_[first_ + s - step] += link + grip * x;
                diagonal_[first_ + s] += link + grip * y;
            }
            if (++run == step) {
                run = 0;
                at = at + 1 == n ? 0 : at + 1;
            }
        }
    }

    multiply(solution_, image_);
    double left = 0.0;
    for (size_t s = 0; s < size; ++s) {
        const size_t p = first_ + s;
        residual_[p] = free_[p] * field.values[s] - image_[p];
        left = std::max(left, std::abs(residual_[p]));
    }
    double rho = 0.0;
    for (int iteration = 0; iteration < most_iterations && left > tolerance; ++iteration) {
        double next = 0.0;
        for (size_t p = first_; p < last_; ++p) next += residual_[p] * residual_[p] / diagonal_[p];
        const double beta = iteration == 0 ? 0.0 : next / rho;
        rho = next;
        for (size_t p = first_; p < last_; ++p) direction_[p] = residual_[p] / diagonal_[p] + beta * direction_[p];
        multiply(direction_, image_);
        double energy = 0.0;
        for (size_t p = first_; p < last_; ++p) energy += direction_[p] * image_[p];
        const double alpha = rho / energy;
        left = 0.0;
        for (size_t p = first_; p < last_; ++p) {
            solution_[p] += alpha * direction_[p];
            residual_[p] -= alpha * image_[p];
            left = std::max(left, std::abs(residual_[p]));
        }
    }
    std::copy(solution_.begin() + static_cast<std::ptrdiff_t>(first_),
              solution_.begin() + static_cast<std::ptrdiff_t>(last_), field.values.begin());
}
} // namespace lr::baker
