// Random changes of assets like fuzz_asset's, at the speed of a release: mutated_assets COUNT [SEED]. Assets that load are stepped;
// a non-finite number ends the program, which writes the asset to mutated_asset.lrb.
#include "asset/asset_file.h"
#include "fuzz/asset/falls.h"
#include "fuzz/asset/mutate.h"
#include "support/asset_bytes.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace {

std::vector<uint8_t> bytes;

void keep(int) {
    if (std::FILE* const file = std::fopen("mutated_asset.lrb", "wb")) {
        std::fwrite(bytes.data(), 1, bytes.size(), file);
        std::fclose(file);
    }
    std::_Exit(1);
}

// A leaf, a sphere in water, a needle without a hull, and a leaf with stations.
lr::AssetData start(uint32_t which) {
    if (which == 0) return test::leaf_data();
    if (which == 3) return test::winged_data();
    lr::shape::EllipsoidSpec spec;
    spec.semi_axes = which == 1 ? std::array{0.01, 0.01, 0.01} : std::array{0.1, 0.0005, 0.001};
    spec.density = 1100.0;
    if (which == 1) spec.fluid_density = 998.0, spec.fluid_viscosity = 1e-6;
    lr::AssetData data;
    lr::Faults faults;
    if (!lr::shape::ellipsoid_body(spec, data, faults)) std::abort();
    data.turbulence = lr::shape::decay_table(data, 1.0);
    if (which == 2) data.hull = {};
    return data;
}

} // namespace

int main(int count, char** arguments) {
    const int wanted = count > 1 ? std::atoi(arguments[1]) : 1000;
    const uint32_t seed = count > 2 ? static_cast<uint32_t>(std::atoi(arguments[2])) : 1;
    std::signal(SIGABRT, keep);
    int loaded = 0;
    for (int i = 0; i < wanted; ++i) {
        const uint32_t draw = (seed * 1000003u + static_cast<uint32_t>(i)) * 2654435761u;
        lr::AssetData data = start(draw >> 8 & 3u ? draw % 4 : 0);
        fuzz::mutate_asset(data, draw);
        bytes = lr::write_asset(data);
        lr_asset* asset = nullptr;
        const lr_status status = lr_asset_load_memory(bytes.data(), bytes.size(), &asset);
        if (status == LR_OK) {
            ++loaded;
            for (uint32_t variant = 0; variant < 4; ++variant) fuzz::fall(asset, (draw >> 2) + variant * 7919u);
        } else if (status != LR_ERROR_ASSET_INVALID) {
            std::fprintf(stderr, "a sealed file gives %d\n", status);
            std::abort();
        }
        lr_asset_release(asset);
    }
    std::printf("%d of %d assets loaded and fell\n", loaded, wanted);
    return loaded * 10 > wanted && loaded < wanted ? 0 : 1; // otherwise nothing was tested
}
