// Lanes that vectors step along with those of bodies that move.
#pragma once

#include "field/body_copies.h"
#include "world/batch.h"

#include <algorithm>

namespace lr {

// Calls move(), which steps lanes [begin, end): bodies at rest behind the last that moves stay as they are.
template <class Move> void move_awake(const Batch& batch, uint32_t begin, uint32_t end, const Move& move) {
    const uint32_t first = std::max(begin, batch.awake()), past = std::min(end, batch.count());
    if (first >= past) return move();
    const auto index = [first](uint32_t i) { return first + i; };
    BodyCopies<lane_block> kept;
    kept.take(batch.arrays(), past - first, index);
    move();
    kept.put_back(batch.arrays(), index);
}

} // namespace lr
