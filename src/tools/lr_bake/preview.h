// A picture of a baked body, to check what the baker made of the mesh.
#pragma once

#include "asset/asset_data.h"
#include "baker/mesh/mesh.h"

#include <cstdint>
#include <string>
#include <vector>

namespace lr::baker {

// body: in the body frame, as BakeHooks gives it. Returns the bytes of a PNG file: the body from three sides with its principal
// axes, their lengths, the thin direction, stations, centre of mass and hull, and how it falls.
std::vector<uint8_t> draw_preview(const AssetData& asset, const Mesh& body, const std::string& fall);
} // namespace lr::baker
