// Tiles in space: one core solves the touching bodies of a tile from its own cache. docs/maintainers/contact.md
#pragma once

#include <cstdint>

namespace lr {

// A body to be put into a tile.
struct TiledBody {
    float x[3]; // m
    // member: twice the number of its batch, plus one if it has the added mass of water.
    uint32_t member, noise_seed, body;
    uint32_t tile;
};

// Tiles are numbered by their cuts, the first cut in the highest bit. Tiles i and j are divided by a cut of level bit_width(i ^ j). Pairs
// across different cuts of one level share no tile.
uint32_t tile_levels(uint32_t bodies);
// Sets `tile`, below 2^levels. Sorts the bodies by member, tile and noise seed; their former order does not matter.
void cut_into_tiles(TiledBody* bodies, uint32_t count, uint32_t levels);
} // namespace lr
