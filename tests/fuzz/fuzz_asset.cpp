// Any bytes: either refused with a status, or an asset that can be stepped.
#include "format/asset_file.h"
#include "langevin_rigid.h"
#include "support/asset_bytes.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace {

void step_asset(const lr_asset* asset) {
    lr_world_desc world_desc;
    lr_world_desc_init(&world_desc, sizeof world_desc);
    lr_world* world = nullptr;
    if (lr_world_create(&world_desc, &world) != LR_OK) std::abort();
    lr_batch_desc batch_desc;
    lr_batch_desc_init(&batch_desc, sizeof batch_desc);
    batch_desc.asset = asset;
    batch_desc.capacity = 4;
    lr_batch batch = 0;
    if (lr_batch_create(world, &batch_desc, &batch) == LR_OK) {
        lr_body_desc body;
        lr_body_desc_init(&body, sizeof body);
        if (lr_body_create(world, batch, &body, 1, nullptr) != LR_OK) std::abort();
        for (int i = 0; i < 20; ++i)
            if (lr_world_step(world, 1.0f / 60.0f, 4) != LR_OK) std::abort();
    }
    lr_world_destroy(world);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    lr_asset* asset = nullptr;
    if (lr_asset_load_memory(data, size, &asset) == LR_OK) {
        step_asset(asset);
        lr_asset_release(asset);
    } else if (asset) {
        std::abort();
    }
    // The checksum stops changed bytes early: mend it where only it is wrong, so that what lies behind is reached too.
    lr::AssetData unused;
    lr::Faults faults;
    if (lr::read_asset(data, size, unused, faults) || faults.back().id != lr::FaultId::asset_checksum) return 0;
    std::vector<uint8_t> mended(data, data + size);
    test::seal(mended);
    if (lr_asset_load_memory(mended.data(), mended.size(), &asset) == LR_OK) {
        step_asset(asset);
        lr_asset_release(asset);
    }
    return 0;
}
