// Files of earlier stages of the format, as they were written then, keep loading.
#include "support/scene.h"

#include <cmath>

using namespace test;

TEST_CASE("assets of each earlier stage load, say what they are, and fall") {
    for (const char* path : {LR_GOLDEN_ASSETS "/before_loads.lrb", LR_GOLDEN_ASSETS "/before_stall.lrb"}) {
        CAPTURE(std::string(path));
        lr_asset* raw = nullptr;
        REQUIRE(lr_asset_load_file(path, &raw) == LR_OK);
        const Asset asset(raw);
        const lr_asset_info info = info_of(asset);
        CHECK(info.format_version == 1);
        CHECK(info.mass == doctest::Approx(info.density * info.volume));
        CHECK((info.length_d > 0.0 && info.turbulence_count > 1 && info.hull_vertex_count > 3));
        lr_aerodynamics a = initialised(lr_aerodynamics_init);
        REQUIRE(lr_asset_get_aerodynamics(asset.get(), &a) == LR_OK);
        CHECK((a.drag[0] > 0.0 && a.drag[1] > 0.0 && a.drag[2] > 0.0));
        if (std::string(path).find("stall") != std::string::npos)
            for (double v : a.broadside) CHECK(v == 0.0);
        const World world = make(world_desc());
        const lr_body body = add_body(world, add_batch(world, asset, 1), body_desc());
        steps(world, 100, 1.0f / 60.0f, 2);
        const lr_body_state s = state_of(world, body);
        CHECK((std::isfinite(s.position[0]) && s.position[1] < -0.1f));
    }
}
