/* A world with the bodies, ground and wind of a plan; the sliders act on it.    SPDX-License-Identifier: MIT */
#ifndef VIEWER_SCENE_H
#define VIEWER_SCENE_H

#include <langevin_rigid.h>

#include "drawing/mesh.h"
#include "scenes.h"

/* Sources of assets. */
typedef struct scene_source {
    const char* baked;                   /* folder of NAME.lrb */
    const char* meshes;                  /* folder of NAME.obj */
    const char* own_assets[scene_kinds]; /* from the command line, instead of the plan's; null: none */
    const char* own_meshes[scene_kinds];
    uint64_t seed;
    uint32_t threads;
} scene_source;

typedef struct scene_batch {
    const scene_kind* kind;
    lr_asset* asset;
    lr_asset_info info;
    body_mesh mesh;
    lr_batch batch;
    uint32_t capacity, count; /* largest and wanted number of bodies */
} scene_batch;

typedef struct scene {
    const scene_plan* plan;
    lr_world* world;
    scene_batch batches[scene_kinds];
    int batch_count;
    lr_wind_source gusts, turbulence;
    settings now;
    double stepping;       /* s on the clock, for the last step */
    lr_body (*renamed)[2]; /* old and new ids of the bodies kept by the last scene_apply */
    uint32_t renamed_count, renamed_room;
} scene;

/* Waves of the pond, for the library and for the shader. */
enum { pond_wave_count = 3 };
extern const lr_wave pond_waves[pond_wave_count];

/* Fails with a message. */
scene* scene_create(const scene_plan* plan, const scene_source* source, const settings* initially);
void scene_free(scene* s);

/* Applies `wanted` to the world: wind, numbers, loads. Keeps bodies if possible; returns 1 if their ids changed. */
int scene_apply(scene* s, const settings* wanted);

/* A body's new id after scene_apply returned 1; id 0 if it has ended. */
lr_body scene_renamed(const scene* s, lr_body old);

/* Steps by dt, s. */
void scene_step(scene* s, float dt);

typedef struct scene_report {
    uint64_t bodies, awake;
    double time; /* s */
    uint64_t hash;
    float lowest; /* m: smallest height of a centre of mass over the ground below it */
} scene_report;

/* Finds the hash and `lowest` only if `whole` is not 0. */
scene_report scene_look(const scene* s, int whole);

#endif
