// Restores corners of an outline that the pixels have rounded.
#pragma once

#include "baker/card/outline.h"

#include <cstddef>
#include <set>
#include <utility>

namespace lr::baker {

// Marching squares replace a corner between two straight runs by a diagonal. Extends the runs until they meet, if no other
// outline is near.
class CornerRestorer {
public:
    CornerRestorer(const AlphaMask& mask, double level) : mask_(mask), level_(level) {}
    void restore(Loop& loop); // loop: as traced from the mask

private:
    using Cell = std::pair<std::ptrdiff_t, std::ptrdiff_t>; // between four pixel centres

    bool is_free(const Loop& loop, std::size_t i, std::size_t j, const Eigen::Vector2d& corner);
    int crossings(const Cell& cell) const;

    const AlphaMask& mask_;
    const double level_;
    std::set<Cell> taken_; // cells that restored corners have occupied
};
} // namespace lr::baker
