/* The wind of a scene from its sliders.    SPDX-License-Identifier: MIT */
#include "scene_wind.h"

#include "drawing/failure.h"
#include "drawing/vectors.h"

static vec3 blowing(const settings* now) {
    const float turn = now->value[setting_direction] * PI / 180.0f;
    return v3(cosf(turn), 0.0f, -sinf(turn));
}

/* Sources of speed 0 stay in the world, so that a slider only updates them. */
static lr_gusts_desc gusts_of(const settings* now) {
    lr_gusts_desc desc;
    check(lr_gusts_desc_init(&desc, sizeof desc), "lr_gusts_desc_init", NULL);
    desc.rms = now->value[setting_gusts];
    desc.angle_rms = 0.35f;
    desc.integral_time = 2.5f;
    to_array(blowing(now), desc.direction);
    return desc;
}

static lr_turbulence_desc turbulence_of(const settings* now, float size) {
    lr_turbulence_desc desc;
    check(lr_turbulence_desc_init(&desc, sizeof desc), "lr_turbulence_desc_init", NULL);
    desc.rms = now->value[setting_turbulence];
    desc.integral_length = size;
    desc.octaves = 3;
    return desc;
}

static float eddies(const scene* s) {
    return 0.35f * s->plan->camera.distance;
}

void scene_wind_create(scene* s) {
    /* Air is slow near the ground: 0 at the ground, and the full wind at the height of the emitters. */
    lr_ground_wind_desc ground;
    check(lr_ground_wind_desc_init(&ground, sizeof ground), "lr_ground_wind_desc_init", NULL);
    ground.position[1] = s->plan->water ? 0.0f : s->plan->ground_level - 0.5f * s->plan->relief;
    ground.roughness_length = s->plan->ground == ground_lawn ? 0.01f : 0.001f;
    ground.reference_height = 3.0f;
    check(lr_world_add_ground_wind(s->world, &ground, NULL), "the wind over the ground", NULL);
    const lr_gusts_desc gusts = gusts_of(&s->now);
    const lr_turbulence_desc turbulence = turbulence_of(&s->now, eddies(s));
    check(lr_world_add_gusts(s->world, &gusts, &s->gusts), "the gusts", "try a smaller --gusts");
    check(lr_world_add_turbulence(s->world, &turbulence, &s->turbulence), "the turbulence",
          "try a smaller --turbulence");
    scene_wind_update(s);
}

void scene_wind_update(scene* s) {
    const vec3 air = scaled(blowing(&s->now), s->now.value[setting_wind]);
    check(lr_world_set_uniform_wind(s->world, air.x, air.y, air.z), "the wind", "try a smaller --wind");
    const lr_gusts_desc gusts = gusts_of(&s->now);
    const lr_turbulence_desc turbulence = turbulence_of(&s->now, eddies(s));
    check(lr_world_update_gusts(s->world, s->gusts, &gusts), "the gusts", "try a smaller --gusts");
    check(lr_world_update_turbulence(s->world, s->turbulence, &turbulence), "the turbulence",
          "try a smaller --turbulence");
}
