#include "baker/turbulence/wake_probe.h"

#include <algorithm>

namespace lr::baker {

WakeProbe::WakeProbe(const MacGrid& grid, std::array<GridPoint, 2> box, double behind) {
    const auto for_cells = [&](auto&& visit) {
        for (uint32_t k = 0; k < grid.cells[2]; ++k)
            for (uint32_t j = 0; j < grid.cells[1]; ++j)
                for (uint32_t i = 0; i < grid.cells[0]; ++i) visit(i, j, k);
    };
    if (box[0] == box[1]) {
        box = {GridPoint{1e300, 1e300, 1e300}, GridPoint{-1e300, -1e300, -1e300}};
        for_cells([&](uint32_t i, uint32_t j, uint32_t k) {
            if (grid.solid[grid.cell(i, j, k)] == 0) return;
            const GridPoint p = grid.cell_centre(i, j, k);
            for (size_t a = 0; a < 3; ++a) {
                box[0][a] = std::min(box[0][a], p[a] - 0.5 * grid.spacing[a]);
                box[1][a] = std::max(box[1][a], p[a] + 0.5 * grid.spacing[a]);
            }
        });
    }
    box[1][0] += std::max(behind, grid.spacing[0]);
    // A body narrower than a cell has the wake of one as wide as the cell.
    for (size_t a = 1; a < 3; ++a) {
        const double missing = grid.spacing[a] - (box[1][a] - box[0][a]);
        if (missing > 0.0) box[0][a] -= 0.5 * missing, box[1][a] += 0.5 * missing;
    }
    for_cells([&](uint32_t i, uint32_t j, uint32_t k) {
        if (grid.solid[grid.cell(i, j, k)] != 0) return;
        const GridPoint p = grid.cell_centre(i, j, k);
        double share = 1.0;
        for (size_t a = 0; a < 3; ++a) {
            const double half = 0.5 * grid.spacing[a];
            const double covered = std::min(p[a] + half, box[1][a]) - std::max(p[a] - half, box[0][a]);
            share *= std::clamp(covered / grid.spacing[a], 0.0, 1.0);
        }
        if (share > 0.0) {
            cells_.push_back({i, j, k, share});
            volume_ += share;
        }
    });
}

shape::TurbulenceState WakeProbe::mean(const KEpsilon& turbulence) const {
    shape::TurbulenceState sum{0.0, 0.0};
    for (const Cell& c : cells_) {
        const shape::TurbulenceState s = turbulence.in_cell(c.i, c.j, c.k);
        sum.k += c.share * s.k;
        sum.epsilon += c.share * s.epsilon;
    }
    return {sum.k / volume_, sum.epsilon / volume_};
}
} // namespace lr::baker
