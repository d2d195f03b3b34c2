// Records falls of a body from several releases.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "asset_file.h"
#include "langevin_rigid.h"
#include "vectors.h"

struct Pose {
    double time;     // s
    Vector position; // m, of the centre of mass
    Quaternion turn; // body to world
    Vector velocity; // m/s, world frame
    Vector spin;     // rad/s, world frame
};
using Track = std::vector<Pose>;

struct Release {
    Quaternion turn{0.0, 0.0, 0.0, 1.0};
    Vector velocity{};
};

struct Run {
    std::int32_t loads = LR_LOADS_DEFAULT;
    std::uint64_t seed = 1;
    double seconds = 3.0;
    double interval = 0.005; // s between poses
    std::uint32_t substeps = 5;
};

// Gravity along -y, no worker threads.
WorldPointer make_world(std::uint64_t seed);
lr_batch make_batch(lr_world* world, const lr_asset* asset, std::int32_t loads, std::size_t capacity);

// y is up. Returns a track for each release, with poses at interval * k from 0 on.
std::vector<Track> record(const lr_asset* asset, const Run& run, const std::vector<Release>& releases);
