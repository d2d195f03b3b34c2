/* The wind of a scene from its sliders.    SPDX-License-Identifier: MIT */
#include "scene_wind.h"

#include "failure.h"
#include "vectors.h"

static lr_wind_source_desc source_of(int32_t kind) {
    lr_wind_source_desc desc;
    check(lr_wind_source_desc_init(&desc, sizeof desc), "lr_wind_source_desc_init", NULL);
    desc.kind = kind;
    return desc;
}

static vec3 blowing(const settings* now) {
    const float turn = now->value[setting_direction] * PI / 180.0f;
    return v3(cosf(turn), 0.0f, -sinf(turn));
}

/* Sources of no speed stay in the world, so that a slider only updates them. */
static lr_wind_source_desc gusts_of(const settings* now) {
    lr_wind_source_desc desc = source_of(LR_WIND_SOURCE_GUSTS);
    desc.speed = now->value[setting_gusts];
    desc.spread = 0.35f;
    desc.period = 2.5f;
    to_array(blowing(now), desc.direction);
    return desc;
}

static lr_wind_source_desc turbulence_of(const settings* now, float size) {
    lr_wind_source_desc desc = source_of(LR_WIND_SOURCE_TURBULENCE);
    desc.speed = now->value[setting_turbulence];
    desc.size = size;
    desc.octaves = 3;
    return desc;
}

static float eddies(const scene* s) {
    return 0.35f * s->plan->camera.distance;
}

void scene_wind_create(scene* s) {
    /* Air is slow near the ground: nought at it, and all of the wind at the height of the births. */
    lr_wind_source_desc ground = source_of(LR_WIND_SOURCE_GROUND);
    ground.position[1] = s->plan->water ? 0.0f : s->plan->ground_level - 0.5f * s->plan->relief;
    to_array(v3(0.0f, 1.0f, 0.0f), ground.direction);
    ground.size = s->plan->ground == ground_lawn ? 0.01f : 0.001f;
    ground.reference_height = 3.0f;
    lr_wind_source ignored;
    check(lr_world_add_wind(s->world, &ground, &ignored), "the wind over the ground", NULL);
    const lr_wind_source_desc gusts = gusts_of(&s->now), turbulence = turbulence_of(&s->now, eddies(s));
    check(lr_world_add_wind(s->world, &gusts, &s->gusts), "the gusts", "try a smaller --gusts");
    check(lr_world_add_wind(s->world, &turbulence, &s->turbulence), "the turbulence", "try a smaller --turbulence");
    scene_wind_update(s);
}

void scene_wind_update(scene* s) {
    lr_wind_desc air;
    check(lr_wind_desc_init(&air, sizeof air), "lr_wind_desc_init", NULL);
    to_array(scaled(blowing(&s->now), s->now.value[setting_wind]), air.velocity);
    check(lr_world_set_wind(s->world, &air), "the wind", "try a smaller --wind");
    const lr_wind_source_desc gusts = gusts_of(&s->now), turbulence = turbulence_of(&s->now, eddies(s));
    check(lr_world_update_wind(s->world, s->gusts, &gusts), "the gusts", "try a smaller --gusts");
    check(lr_world_update_wind(s->world, s->turbulence, &turbulence), "the turbulence", "try a smaller --turbulence");
}
