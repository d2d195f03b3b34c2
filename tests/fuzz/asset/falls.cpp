#include "fuzz/asset/falls.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace fuzz {
namespace {

void must(lr_status status, const char* what) {
    if (status == LR_OK) return;
    std::fprintf(stderr, "DEFECT: %s gives %d\n", what, status);
    std::abort();
}

void blow(lr_world* world, uint32_t variant) {
    must(lr_world_set_uniform_wind(world, variant % 2 ? 8.0f : 0.5f, 0.0f, 0.0f), "lr_world_set_uniform_wind");
    lr_turbulence_desc source;
    must(lr_turbulence_desc_init(&source, sizeof source), "init");
    must(lr_world_add_turbulence(world, &source, nullptr), "lr_world_add_turbulence");
}

void flood(lr_world* world) {
    lr_water_desc surface;
    must(lr_water_desc_init(&surface, sizeof surface), "init");
    surface.wave_count = 1;
    surface.waves[0].direction[0] = 1.0f, surface.waves[0].length = 3.0f, surface.waves[0].amplitude = 0.1f;
    must(lr_world_set_water(world, &surface), "lr_world_set_water");
}

void lay_ground(lr_world* world, float height) {
    lr_collider_desc plane;
    must(lr_collider_desc_init(&plane, sizeof plane), "init");
    plane.kind = LR_COLLIDER_PLANE;
    plane.position[1] = height;
    must(lr_collider_create(world, &plane, 1, nullptr), "lr_collider_create");
}

} // namespace

void fall(const lr_asset* asset, uint32_t variant) {
    const auto take = [&](uint32_t n) {
        const uint32_t out = variant % n;
        variant /= n;
        return out;
    };
    lr_world_desc wd;
    must(lr_world_desc_init(&wd, sizeof wd), "init");
    lr_world* world = nullptr;
    must(lr_world_create(&wd, &world), "lr_world_create");
    lr_batch_desc bd;
    must(lr_batch_desc_init(&bd, sizeof bd), "init");
    bd.asset = asset, bd.capacity = 2;
    bd.load_model = static_cast<int32_t>(1 + take(3));
    bd.clock = static_cast<int32_t>(take(2));
    bd.table_end = static_cast<int32_t>(take(2));
    static constexpr float scales[] = {1.0f, 1.0f, 1.0f, 0.1f, 10.0f, 0.001f, 1000.0f};
    const float scale = scales[take(7)];
    lr_asset_info info;
    must(lr_asset_info_init(&info, sizeof info), "init");
    must(lr_asset_get_info(asset, &info), "lr_asset_get_info");
    const uint32_t around = take(16) & (take(16) == 0 ? 15u : 7u); // pairs take most of the time
    if (around & 1u) blow(world, take(2));
    if (around & 2u) flood(world);
    const float size = static_cast<float>(info.length_d) * scale;
    if (around & 4u) lay_ground(world, -std::min(0.7f * size, 1e8f));
    lr_batch batch{};
    must(lr_batch_create(world, &bd, &batch), "lr_batch_create of an asset that loads");
    if (around & 8u) must(lr_batch_set_body_contact(world, batch, batch, 1), "lr_batch_set_body_contact");
    lr_body_desc body;
    must(lr_body_desc_init(&body, sizeof body), "init");
    body.scale = scale;
    body.orientation[0] = 0.4f, body.orientation[2] = 0.2f;
    lr_body ids[2] = {};
    for (lr_body& id : ids) {
        must(lr_body_create(world, batch, &body, 1, &id), "lr_body_create");
        body.position[1] = std::min(0.6f * size, 1e8f);
    }
    const bool slow = take(4) == 0;
    for (int i = 0; i < 100; ++i) must(lr_world_step(world, slow ? 0.5f : 1.0f / 60.0f, 1), "lr_world_step");
    lr_batch_counts events;
    must(lr_batch_counts_init(&events, sizeof events), "init");
    must(lr_batch_get_counts(world, batch, &events), "lr_batch_get_counts");
    // Small bodies, or bodies in steps of half a second, can spin faster than the limit of physics (docs/reference/bodies.md) by the
    // fluid's inertia alone.
    if (events.total_diverged != 0 && size >= 1e-4f && !slow) {
        std::fprintf(stderr, "DEFECT: left physics: model %d clock %d scale %g around %u %s\n", bd.load_model, bd.clock,
                     static_cast<double>(scale), around, slow ? "slow" : "");
        std::abort();
    }
    for (lr_body id : ids) {
        lr_body_state s;
        must(lr_body_state_init(&s, sizeof s), "init");
        must(lr_body_get_state(world, id, &s), "lr_body_get_state");
        bool finite = true;
        for (float v : s.orientation) finite = finite && std::isfinite(v);
        for (const auto* values : {&s.position, &s.linear_velocity, &s.angular_velocity})
            for (float v : *values) finite = finite && std::isfinite(v);
        if (!finite) {
            std::fprintf(stderr, "DEFECT: not finite: model %d clock %d scale %g around %u %s\n", bd.load_model,
                         bd.clock, static_cast<double>(scale), around, slow ? "slow" : "");
            std::abort();
        }
    }
    lr_world_destroy(world);
}

} // namespace fuzz
