// Compiled with and without exceptions, in C++17 and 20; run without: each failed call returns its status or nothing.
#include <langevin_rigid.hpp>
#include <langevin_rigid_research.h>

#include <type_traits>

using namespace langevin_rigid;

static_assert(!std::is_copy_constructible_v<World> && std::is_nothrow_move_assignable_v<World>);
static_assert(!std::is_copy_constructible_v<Asset> && std::is_nothrow_move_assignable_v<Asset>);

int main() {
    lr_ellipsoid_desc shape = LR_ELLIPSOID_DESC_INIT;
    if (Asset::ellipsoid(shape) || Asset::load("no such file") || Asset::load(&shape, 8)) return 1;
    for (double& axis : shape.semi_axes) axis = 0.01;
    shape.density = 800.0;
    const Asset asset = Asset::ellipsoid(shape);
    lr_world_desc wrong = LR_WORLD_DESC_INIT;
    wrong.worker_count = 1000;
    World world(wrong);
    if (world || world.step(0.1f, 1) != LR_ERROR_NULL_ARGUMENT) return 2;
    world = World();
    const lr_batch batch = world.add_batch(asset, 2);
    const lr_body_desc descs[2] = {LR_BODY_DESC_INIT, LR_BODY_DESC_INIT};
    if (world.add(batch, descs, 2).size() != 2 || !world.add(batch, descs, 2).empty()) return 3;
    if (world.add(batch, descs[0]).id != 0 || world.step(0.0f, 1) != LR_ERROR_TIMESTEP_ZERO) return 4;
#if __cplusplus >= 202002L
    if (!world.add(batch, descs).empty() || world.restore(std::span<const unsigned char>()) == LR_OK) return 5;
#endif
    lr_aerodynamics loads = LR_AERODYNAMICS_INIT;
    if (check(lr_asset_get_aerodynamics(asset.get(), &loads)) != LR_OK) return 6;
    return world.restore(world.save()) == LR_OK ? 0 : 7;
}
