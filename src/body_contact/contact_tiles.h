// Tiles in space: touching bodies that lie together are solved on one core, from its own cache. docs/maintainers/contact.md
#pragma once

#include <cstdint>

namespace lr {

// A body to be put into a tile.
struct TiledBody {
    float x[3];                        // m
    uint32_t member, noise_seed, body; // member: twice the number of its batch, and one if it carries water along
    uint32_t tile;
};

// Tiles are numbered by their cuts, the first cut in the highest bit: bodies of tiles i and j are divided by the cut of level
// bit_width(i ^ j), and those divided by different cuts of a level share no tile.
uint32_t tile_levels(uint32_t bodies);
// Sets `tile`, below 2^levels. Sorts the bodies by member, tile and noise seed; the order that they had does not matter.
void cut_into_tiles(TiledBody* bodies, uint32_t count, uint32_t levels);
} // namespace lr
