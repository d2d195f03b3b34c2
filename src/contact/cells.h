// Lattices of cells without bounds, hashed: in which cells things are looked for. What lies in a cell of a level reaches no farther
// than half of its width.
#pragma once

#include "contact/pose.h"
#include "kernel/contact.h"

#include <cstdint>

namespace lr {

// floor(x inverse_cell), clamped. Rises with x, so that a box's cells lie between those of its corners. std::floor is a call where
// processors need not have SSE4.
inline int32_t cell_number(float x, float inverse_cell) {
    const float at = x * inverse_cell;
    if (!(at > -most_cells)) return static_cast<int32_t>(-most_cells); // also what is no number
    if (!(at < most_cells)) return static_cast<int32_t>(most_cells);
    const auto whole = static_cast<int32_t>(at);
    return whole - (static_cast<float>(whole) > at ? 1 : 0);
}

struct CellAt {
    int32_t x, y, z;
    bool operator==(const CellAt&) const = default;
};
inline CellAt cell_at(Vector p, float inverse_cell) {
    return {cell_number(p.x, inverse_cell), cell_number(p.y, inverse_cell), cell_number(p.z, inverse_cell)};
}
constexpr uint32_t cell_hash(CellAt at, uint32_t level) {
    return cell_hash(at.x, at.y, at.z) ^ level * 0x9e3779b9u;
}

// The cells of a level, this wide, in which there may be something that reaches into a box. Differences are rounded to nearest, which
// keeps their order with any number in single precision.
struct CellRange {
    CellAt first, last;

    CellRange(const Box& box, float width)
        : first(cell_at(grown(box, 0.500001f * width).low, 1.0f / width)),
          last(cell_at(grown(box, 0.500001f * width).high, 1.0f / width)) {}
    double count() const {
        const auto along = [](int32_t from, int32_t to) { return static_cast<double>(to) - from + 1.0; };
        return along(first.x, last.x) * along(first.y, last.y) * along(first.z, last.z);
    }
    template <class Function> void visit(const Function& function) const {
        for (int32_t x = first.x; x <= last.x; ++x)
            for (int32_t y = first.y; y <= last.y; ++y)
                for (int32_t z = first.z; z <= last.z; ++z) function(CellAt{x, y, z});
    }
};

} // namespace lr
