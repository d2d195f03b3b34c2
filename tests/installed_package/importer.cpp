// A minimal importer of an editor: meshes in memory become assets on several threads, and the runtime loads their bytes.
#include <langevin_rigid.h>
#include <langevin_rigid_baker.hpp>

#include <cstdio>
#include <future>
#include <vector>

namespace lr = langevin_rigid;

int main() {
    const std::vector<float> positions = {0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3};
    const std::vector<std::uint32_t> indices = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    lr::BakeOptions options;
    options.unit = lr::Unit::centimetre;
    const auto bake = [&](double density) {
        lr::BakeOptions mine = options;
        mine.density = density;
        return lr::bake_triangles(positions.data(), 4, indices.data(), 4, mine);
    };
    std::future<lr::BakeResult> light = std::async(std::launch::async, bake, 400.0);
    const lr::BakeResult heavy = bake(800.0), other = light.get();
    if (!heavy || !other) return 1;
    const lr::BakeResult cancelled =
        lr::bake_triangles(positions.data(), 4, indices.data(), 4, options, [](const char*, double) { return false; });
    if (cancelled.status != lr::BakeStatus::cancelled) return 2;
    options.strict = true; // else the open part is a sheet
    const lr::BakeResult open = lr::bake_triangles(positions.data(), 4, indices.data(), 3, options);
    if (open || open.faults.empty() || open.faults.back().number != 206) return 3;

    double masses[2] = {0.0, 0.0};
    for (int i = 0; i < 2; ++i) {
        const lr::BakeResult& result = i == 0 ? heavy : other;
        lr_asset* asset = nullptr;
        lr_asset_info info;
        if (lr_asset_load_memory(result.asset.data(), result.asset.size(), &asset)) return 4;
        if (lr_asset_info_init(&info, sizeof info) || lr_asset_get_info(asset, &info)) return 5;
        masses[i] = info.mass;
        lr_asset_release(asset);
    }
    // A tetrahedron of 1 cm^3.
    if (!(masses[0] > 0.999e-6 * 800.0 && masses[0] < 1.001e-6 * 800.0 && masses[0] == 2.0 * masses[1])) return 6;
    std::printf("%s\n", lr::baker_version());
    return 0;
}
