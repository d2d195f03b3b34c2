// Owners of assets and worlds, and how a sample reads an asset.
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

// Says every fault of a bad one on stderr before it throws Failure.
AssetPointer load_asset(const std::string& path);
