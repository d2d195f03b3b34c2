// Files of earlier stages of the format, as they were written then, keep loading.
#include "support/scene.h"

#include <cmath>
#include <string>

using namespace test;

namespace {

// What a file of each stage does not have: what came with the next ones.
struct Stage {
    const char* name;
    bool roll, center; // damping of roll; a centre of the loads apart from that of buoyancy
};
constexpr Stage stages[] = {
    {"before_loads", false, false},             // the first
    {"before_loads_with_domain", false, false}, // the turbulence's grid, wake and loop
    {"before_stall", false, false},             // coefficients of the loads
    {"before_roll", false, false},              // stall
    {"before_center", true, false},
    {"with_center", true, true},
};

bool any(const double (&values)[3]) {
    return values[0] != 0.0 || values[1] != 0.0 || values[2] != 0.0;
}

} // namespace

TEST_CASE("assets of each earlier stage load, say what they are, and fall") {
    for (const Stage& stage : stages) {
        const std::string name = stage.name, path = LR_GOLDEN_ASSETS "/" + name + ".lrb";
        CAPTURE(name);
        lr_asset* raw = nullptr;
        REQUIRE(lr_asset_load_file(path.c_str(), &raw) == LR_OK);
        const Asset asset(raw);
        const lr_asset_info info = info_of(asset);
        CHECK(info.format_version == 1);
        CHECK(info.mass == doctest::Approx(info.density * info.volume));
        CHECK((info.length_d > 0.0 && info.turbulence_count >= 1 && info.hull_vertex_count > 3));
        lr_aerodynamics a = initialised(lr_aerodynamics_init);
        REQUIRE(lr_asset_get_aerodynamics(asset.get(), &a) == LR_OK);
        CHECK((a.drag[0] > 0.0 && a.drag[1] > 0.0 && a.drag[2] > 0.0));
        if (name == "before_stall") CHECK(!any(a.broadside));
        if (name != "before_loads" &&
            name != "before_loads_with_domain") { // else they are made from the hull, by today's rules
            CHECK(any(a.roll_damping) == stage.roll);
            CHECK(any(a.center) == stage.center);
        }
        for (int32_t loads : {LR_LOADS_AERODYNAMIC, LR_LOADS_LANGEVIN}) {
            const World world = make(world_desc());
            lr_batch_desc d = batch_desc();
            d.load_model = loads;
            const lr_body body = add_body(world, add_batch(world, d, asset, 1), body_desc());
            steps(world, 100, 1.0f / 60.0f, 2);
            const lr_body_state s = state_of(world, body);
            CHECK((std::isfinite(s.position[0]) && s.position[1] < -0.1f));
        }
    }
}
