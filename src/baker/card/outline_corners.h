// Corners of an outline that its pixels have rounded.
#pragma once

#include "baker/card/outline.h"

#include <cstddef>
#include <set>
#include <utility>

namespace lr::baker {

// Marching squares cut a corner between two straight runs off along a diagonal. Extends the runs until they meet, where no
// other outline is near.
class CornerRestorer {
public:
    CornerRestorer(const AlphaMask& mask, double level) : mask_(mask), level_(level) {}
    void restore(Loop& loop); // as traced from the mask at the level

private:
    using Cell = std::pair<std::ptrdiff_t, std::ptrdiff_t>; // between four pixel centres

    bool is_free(const Loop& loop, std::size_t i, std::size_t j, const Eigen::Vector2d& corner);
    int crossings(const Cell& cell) const;

    const AlphaMask& mask_;
    const double level_;
    std::set<Cell> taken_; // cells without an outline that corners were put into
};

} // namespace lr::baker
