// A small importer: bakes a mesh file in this process and drops the result at once.
//   import_mesh leaf.glb leaf.lrb [thickness of a sheet, m]
//
// SPDX-License-Identifier: MIT
#include <langevin_rigid.h>
#include <langevin_rigid_baker.hpp>

#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace baker = langevin_rigid;

namespace {

// The height lost in two seconds by a body of this asset, m; negative if the runtime refuses it.
double fall(const std::vector<std::uint8_t>& bytes) {
    lr_asset* asset = nullptr;
    lr_world* world = nullptr;
    lr_batch batch{};
    lr_body body{};
    lr_world_desc world_desc;
    lr_batch_desc batch_desc;
    lr_body_desc body_desc;
    lr_body_state state;
    lr_world_desc_init(&world_desc, sizeof world_desc);
    lr_batch_desc_init(&batch_desc, sizeof batch_desc);
    lr_body_desc_init(&body_desc, sizeof body_desc);
    lr_body_state_init(&state, sizeof state);
    double fallen = -1.0;
    if (lr_asset_load_memory(bytes.data(), bytes.size(), &asset) == LR_OK &&
        lr_world_create(&world_desc, &world) == LR_OK) {
        batch_desc.asset = asset;
        batch_desc.capacity = 1;
        bool good = lr_batch_create(world, &batch_desc, &batch) == LR_OK &&
                    lr_body_create(world, batch, &body_desc, 1, &body) == LR_OK;
        for (int frame = 0; good && frame < 120; ++frame) good = lr_world_step(world, 1.0F / 60.0F, 2) == LR_OK;
        if (good && lr_body_get_state(world, body, &state) == LR_OK) fallen = -static_cast<double>(state.position[1]);
    }
    lr_world_destroy(world);
    lr_asset_release(asset);
    return fallen;
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 3 || argc > 4) {
        std::fprintf(stderr, "usage: import_mesh MESH ASSET.lrb [SHEET_THICKNESS_M]\n");
        return 1;
    }
    baker::BakeOptions options;
    options.density = 350.0; // kg/m^3, a leaf
    if (argc == 4) options.sheet = baker::BakeSheet{std::atof(argv[3]), {}};
    const baker::BakeResult result = baker::bake_file(argv[1], options, [](const char* phase, double fraction) {
        std::fprintf(stderr, "\r\033[K%3.0f %% %s", 100.0 * fraction, phase);
        return true; // an editor would check its Cancel button here
    });
    std::fputs("\r\033[K", stderr);
    for (const baker::BakeFault& fault : result.faults)
        std::fprintf(stderr, "%s: %s\n", argv[1], to_string(fault).c_str());
    if (!result) return 2;
    std::ofstream file(argv[2], std::ios::binary);
    file.write(reinterpret_cast<const char*>(result.asset.data()), static_cast<std::streamsize>(result.asset.size()));
    file.close();
    if (!file) {
        std::fprintf(stderr, "%s: cannot be written\n", argv[2]);
        return 2;
    }
    std::printf("%s: %zu bytes; falls %.2f m in 2 s\n", argv[2], result.asset.size(), fall(result.asset));
    return 0;
}
