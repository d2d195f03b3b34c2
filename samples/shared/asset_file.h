// Owners of assets and worlds, and a loader for assets.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "langevin_rigid.h"

struct AssetRelease {
    void operator()(lr_asset* asset) const { lr_asset_release(asset); }
};
struct WorldDestroy {
    void operator()(lr_world* world) const { lr_world_destroy(world); }
};
using AssetPointer = std::unique_ptr<lr_asset, AssetRelease>;
using WorldPointer = std::unique_ptr<lr_world, WorldDestroy>;

// Prints every fault of a damaged asset on stderr, then throws Failure.
AssetPointer load_asset(const std::string& path);
