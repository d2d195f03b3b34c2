// Owners of the runtime's C handles; failed statuses become exceptions.
#pragma once

#include "langevin_rigid_baker.hpp"
#include "langevin_rigid_research.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace lr::falls {}
namespace lr::scorecard {
using namespace falls; // measures, statistics and random numbers

struct ReleaseAsset {
    void operator()(lr_asset* asset) const { lr_asset_release(asset); }
};
struct DestroyWorld {
    void operator()(lr_world* world) const { lr_world_destroy(world); }
};
using Asset = std::unique_ptr<lr_asset, ReleaseAsset>;
using World = std::unique_ptr<lr_world, DestroyWorld>;

// Throws std::runtime_error with the name of the failed call.
void require(lr_status status, const char* call);

template <class T> T initialised(lr_status (*init)(T*, uint32_t)) {
    T desc;
    require(init(&desc, sizeof(T)), "an _init function");
    return desc;
}

// Throws std::runtime_error with the first error of a failed bake.
Asset load(const langevin_rigid::BakeResult& result);

lr_asset_info info_of(const Asset& asset);
World make_world(const lr_world_desc& desc);

// The loads on the bodies of a measurement.
struct Loads {
    int32_t load_model = LR_LOADS_DEFAULT;
    int32_t integrator = LR_INTEGRATOR_DEFAULT;
    int32_t clock = LR_CLOCK_SPEED;
    float noise_gain = 1.0f;
    // Called for a new batch without bodies; can override coefficients; can be empty. Concurrent measurements call it, each with its own world.
    std::function<void(lr_world*, lr_batch)> configure;
};

// A batch of `capacity` bodies with these loads.
lr_batch add_batch(const World& world, const Asset& asset, const Loads& loads, uint32_t capacity);
} // namespace lr::scorecard
