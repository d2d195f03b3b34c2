#include "body_contact/contact_tiles.h"

#include "base/bit_cast.h"

#include <algorithm>
#include <bit>
#include <span>
#include <tuple>

namespace lr {
namespace {

// Least bodies of a tile. With fewer most pairs would lie between tiles; with more the second core would have no work in small heaps.
constexpr uint32_t least_bodies = 192, most_levels = 10;

// Integers in the order of the numbers. Sorting needs a total order, also with NaN and both zeros.
uint32_t ordered(float x) {
    const auto bits = bit_cast<uint32_t>(x);
    return bits >> 31 != 0 ? ~bits : bits | 1u << 31;
}

uint32_t widest_axis(std::span<const TiledBody> bodies) {
    uint32_t best = 0;
    float most = -1.0f;
    for (uint32_t axis = 0; axis < 3; ++axis) {
        float low = bodies[0].x[axis], high = low;
        for (const TiledBody& body : bodies) low = std::min(low, body.x[axis]), high = std::max(high, body.x[axis]);
        if (high - low > most) most = high - low, best = axis;
    }
    return best;
}
} // namespace

uint32_t tile_levels(uint32_t bodies) {
    const auto levels = static_cast<uint32_t>(std::bit_width(bodies / least_bodies));
    return levels == 0 ? 0 : std::min(levels - 1, most_levels);
}

void cut_into_tiles(TiledBody* bodies, uint32_t count, uint32_t levels) {
    const auto bound = [&](uint32_t of, uint32_t parts) { return static_cast<uint32_t>(uint64_t{of} * count / parts); };
    for (uint32_t level = 0; level < levels; ++level) {
        const uint32_t parts = 1u << level;
        for (uint32_t part = 0; part < parts; ++part) {
            TiledBody *const begin = bodies + bound(part, parts),
                             *const middle = bodies + bound(2 * part + 1, 2 * parts),
                             *const end = bodies + bound(part + 1, parts);
            const uint32_t axis = widest_axis({begin, end});
            const auto place = [axis](const TiledBody& b) {
                return std::tuple(ordered(b.x[axis]), b.member, b.noise_seed, b.body);
            };
            std::nth_element(begin, middle, end,
                             [&](const TiledBody& a, const TiledBody& b) { return place(a) < place(b); });
        }
    }
    for (uint32_t tile = 0; tile < 1u << levels; ++tile)
        for (uint32_t i = bound(tile, 1u << levels); i < bound(tile + 1, 1u << levels); ++i) bodies[i].tile = tile;
    const auto order = [](const TiledBody& b) { return std::tuple(b.member, b.tile, b.noise_seed, b.body); };
    std::sort(bodies, bodies + count, [&](const TiledBody& a, const TiledBody& b) { return order(a) < order(b); });
}
} // namespace lr
