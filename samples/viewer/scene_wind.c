/* The wind of a scene from its sliders.    SPDX-License-Identifier: MIT */
#include "scene_wind.h"

#include <stdlib.h>

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

enum { whirl_across = 25, whirl_up = 13, whirl_frames = 8 };
static const float whirl_half = 0.9f, whirl_height = 0.9f, whirl_core = 0.22f, whirl_way = 0.15f; /* m */

/* A dust devil of fastest wind 1 about an axis at the origin: air turns, comes in along the ground and goes up in the core. Free of divergence: the
 * rest is the curl of a stream function r^2 exp(-(r/core)^2) g(y), and all of it ends at the sides and at the top. */
static vec3 whirl_at(float x, float y, float z) {
    const float r2 = (x * x + z * z) / (whirl_core * whirl_core), up = y / whirl_height, core = expf(-r2);
    const float around = 1.65f * expf(-0.5f * r2) * (1.0f - up * up) / whirl_core;
    const float g = 6.75f * up * (1.0f - up) * (1.0f - up),
                slope = 6.75f * (1.0f - up) * (1.0f - 3.0f * up) / whirl_height;
    const float in = -0.3f * slope * core, lift = 0.6f * (1.0f - r2) * g * core;
    return v3(around * z + in * x, lift, -around * x + in * z);
}

/* The whirl as artists have wind from other programs: a grid of samples in frames, which are played in a loop. Its axis goes round a small circle. */
static void add_whirl(const scene* s) {
    const size_t count = (size_t)whirl_across * whirl_up * whirl_across * whirl_frames;
    float(*samples)[3] = allocate(count, sizeof *samples);
    lr_wind_grid_desc grid;
    check(lr_wind_grid_desc_init(&grid, sizeof grid), "lr_wind_grid_desc_init", NULL);
    const vec3 middle = s->plan->camera.target;
    to_array(v3(middle.x - whirl_half, s->plan->ground_level, middle.z - whirl_half), grid.position);
    const uint32_t counts[3] = {whirl_across, whirl_up, whirl_across};
    for (int k = 0; k < 3; ++k) {
        grid.counts[k] = counts[k];
        grid.spacing[k] = (k == 1 ? whirl_height : 2.0f * whirl_half) / (float)(counts[k] - 1);
    }
    grid.frames = whirl_frames;
    grid.frame_time = 0.6f;
    size_t n = 0;
    for (int f = 0; f < whirl_frames; ++f) {
        const float turn = 2.0f * PI * (float)f / whirl_frames;
        for (int k = 0; k < whirl_across; ++k)
            for (int j = 0; j < whirl_up; ++j)
                for (int i = 0; i < whirl_across; ++i) {
                    const float x = (float)i * grid.spacing[0] - whirl_half - whirl_way * cosf(turn);
                    const float z = (float)k * grid.spacing[2] - whirl_half - whirl_way * sinf(turn);
                    to_array(scaled(whirl_at(x, (float)j * grid.spacing[1], z), s->plan->whirl), samples[n++]);
                }
    }
    grid.samples = samples[0];
    check(lr_world_add_wind_grid(s->world, &grid, NULL), "the whirl", NULL);
    free(samples);
}

void scene_wind_create(scene* s) {
    if (s->plan->whirl > 0.0f) add_whirl(s);
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
