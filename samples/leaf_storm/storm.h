// The storm: assets, a world with a batch for each asset, spawns, steps, samples.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "asset_file.h"
#include "ground/park.h"
#include "langevin_rigid.h"
#include "options.h"
#include "statistics.h"
#include "storm_scene.h"

WorldPointer create_world(const Options& options, const float* wind);
lr_batch create_batch(lr_world* world, const lr_asset* asset, std::uint32_t capacity, const Options& options);

class Storm {
public:
    struct Kind {
        std::string path;
        AssetPointer asset;
        lr_asset_info info;
        std::uint32_t count;
        lr_batch batch;
    };

    explicit Storm(const Options& options);

    // One step of dt. Bodies that left the box re-enter; with --ground, bodies start above the ground and end beyond its edges.
    void step();
    Sample sample(Histogram* descents) const;
    std::uint64_t hash() const;

    lr_world* world() const { return world_.get(); }
    const std::vector<Kind>& kinds() const { return kinds_; }
    const storm::Box& box() const { return box_; }
    const Park* park() const { return park_.get(); }             // with --ground
    std::uint64_t blown_away() const { return blown_away_; }     // over the edges of the ground
    std::uint64_t fell_through() const { return fell_through_; } // through the ground: a defect
    double stepping_seconds() const { return stepping_; }        // wall time in lr_world_step
    std::uint64_t reentries() const;
    lr_world_info info() const;

private:
    void fill(Kind& kind, std::uint64_t first);
    void fill_from_above(Kind& kind);
    void set_body_contact();
    void end_births();
    void count_ended();

    const Options& options_;
    std::vector<Kind> kinds_;
    WorldPointer world_;
    storm::Box box_{};
    std::vector<storm::Reentry> reentries_; // one for each kind
    std::unique_ptr<Park> park_;
    bool births_ended_ = false;
    std::uint64_t blown_away_ = 0, fell_through_ = 0;
    double stepping_ = 0.0;
};
