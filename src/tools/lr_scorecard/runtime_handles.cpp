#include "tools/lr_scorecard/runtime_handles.h"

#include <stdexcept>
#include <string>

namespace lr::scorecard {

void require(lr_status status, const char* call) {
    if (status != LR_OK) throw std::runtime_error(std::string(call) + ": " + lr_status_string(status));
}

Asset load(const langevin_rigid::BakeResult& result) {
    if (!result) {
        for (const langevin_rigid::BakeFault& f : result.faults)
            if (f.is_error) throw std::runtime_error("bake: " + to_string(f));
        throw std::runtime_error("bake: failed without a fault");
    }
    lr_asset* asset = nullptr;
    require(lr_asset_load_memory(result.asset.data(), result.asset.size(), &asset), "lr_asset_load_memory");
    return Asset(asset);
}

lr_asset_info info_of(const Asset& asset) {
    lr_asset_info info = initialised(lr_asset_info_init);
    require(lr_asset_get_info(asset.get(), &info), "lr_asset_get_info");
    return info;
}

World make_world(const lr_world_desc& desc) {
    lr_world* world = nullptr;
    require(lr_world_create(&desc, &world), "lr_world_create");
    return World(world);
}

lr_batch add_batch(const World& world, const Asset& asset, const Loads& loads, uint32_t capacity) {
    lr_batch_desc d = initialised(lr_batch_desc_init);
    d.asset = asset.get();
    d.capacity = capacity;
    d.load_model = loads.load_model;
    d.integrator = loads.integrator;
    d.clock = loads.clock;
    d.noise_gain = loads.noise_gain;
    d.variation = 0.0f; // rows compare single bodies with measurements
    lr_batch batch{};
    require(lr_batch_create(world.get(), &d, &batch), "lr_batch_create");
    if (loads.configure) loads.configure(world.get(), batch);
    return batch;
}
} // namespace lr::scorecard
