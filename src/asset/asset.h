// The immutable, reference-counted asset behind lr_asset.
#pragma once

#include "format/asset_data.h"

#include <array>
#include <atomic>
#include <cstdint>

struct lr_asset {
    lr_asset(lr::AssetData&& from, uint32_t version, const std::array<double, 3>& extents = {});

    const lr::AssetData data;
    const uint64_t content_hash;
    const bool diagonal;                 // inertia and added mass diagonal, B = 0, buoyancy centred
    const uint32_t format_version;       // of the file; 0 without one
    const std::array<double, 3> extents; // m, along the body axes, of a rigid without a hull; else zero
    mutable std::atomic<uint32_t> references{1};
};

namespace lr {

void retain(const lr_asset& asset);
void release(const lr_asset* asset); // null is fine

} // namespace lr
