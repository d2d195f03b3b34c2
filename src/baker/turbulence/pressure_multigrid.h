// Multigrid cycle for the pressure Laplacian around bodies and sheets: preconditions conjugate gradients.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lr::baker {

// Coarse unknowns are the connected parts of blocks of two cells along each axis, so that a sheet without thickness separates the pressures of its
// sides even where a coarse cell is far larger than the body. Axes with long cells are coarsened later. Prolongation is constant over a part,
// restriction its transpose. Links across a block are halved, because constant prolongation makes them twice too stiff (Braess 1995). Single
// precision suffices: the outer iteration corrects it.
class PressureMultigrid {
public:
    // For each cell, x fastest: the sum of all links (0: solid) and the link to the next cell along each axis, all positive.
    PressureMultigrid(const std::array<uint32_t, 3>& cells, const std::array<double, 3>& spacing,
                      const double* diagonal, const std::array<const double*, 3>& links);

    // solution = an approximation of A^-1 right, by one symmetric W-cycle.
    void cycle(const double* right, double* solution);

private:
    struct Level {
        std::vector<uint32_t> begin, column, parent; // rows of links; parent: index on the next level
        std::vector<std::array<uint16_t, 3>> block;
        std::vector<float> link, diagonal, inverse;
        std::vector<float> x, right, residual, direction, saved;
        size_t size() const { return diagonal.size(); }
    };

    static Level coarsen(Level& fine, const std::array<bool, 3>& halved);
    void factorise_coarsest();
    void solve_coarsest(Level& level) const;
    static void find_residual(Level& level);
    static void smooth(Level& level, bool from_zero);
    void descend(size_t depth);

    std::vector<uint32_t> node_of_cell_; // on the finest level; none: solid
    std::vector<Level> levels_;
    std::vector<double> factor_; // dense Cholesky factor of the coarsest level, by rows
};
} // namespace lr::baker
