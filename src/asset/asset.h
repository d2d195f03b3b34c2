// The immutable, reference-counted asset behind lr_asset.
#pragma once

#include "asset/asset_data.h"
#include "collision/body_narrow_phase.h"
#include "langevin_rigid_research.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

struct lr_asset {
    lr_asset(lr::AssetData&& from, uint32_t version, const std::array<double, 3>& extents = {});

    const lr::AssetData data;
    const uint64_t content_hash;
    const bool diagonal;                 // inertia and added mass diagonal, B = 0, buoyancy centred
    const uint32_t format_version;       // of the file; 0 without one
    const std::array<double, 3> extents; // m, along the body axes, of a rigid without a hull; else zero
    const lr::BodyShape shape;           // contact shape against colliders
    const lr::PairHull pair_hull;        // and against other bodies
    mutable std::atomic<uint32_t> references{1};
};

namespace lr {

void retain(const lr_asset& asset);
void release(const lr_asset* asset); // null is fine

// Reads an asset file, the only file that the runtime ever opens: a regular file, whole. Does not wait for pipes or read devices, and child processes
// do not inherit it. LR_OK, LR_ERROR_FILE_NOT_FOUND, LR_ERROR_FILE_READ, LR_ERROR_ASSET_CORRUPT (over 1 GiB), LR_ERROR_OUT_OF_MEMORY; throws
// std::bad_alloc.
lr_status read_asset_bytes(const char* path_utf8, std::vector<unsigned char>& out);
} // namespace lr
