/* Plans of scenes: bodies, emitters, ground, wind, camera.    SPDX-License-Identifier: MIT */
#ifndef VIEWER_SCENES_H
#define VIEWER_SCENES_H

#include <langevin_rigid.h>

#include "drawing/camera.h"
#include "drawing/solids.h"
#include "settings.h"

enum { scene_kinds = 4, scene_solids = 6 };

/* Bodies of one asset from one emitter. */
typedef struct scene_kind {
    const char* asset; /* NAME.lrb of the baked assets and NAME.obj of the meshes; null: no more kinds */
    enum look look;
    float share;          /* of the scene's bodies */
    float at[3], half[3]; /* m: middle and half sides of the spawn box */
    float direction[3], spread, speed_min, speed_max, spin;
    float scale_min, scale_max;
    int thrown;  /* flat, nose along the direction; otherwise in any pose */
    float burst; /* s between bursts; 0: a steady stream */
} scene_kind;

typedef struct scene_plan {
    const char* name;
    const char* title;
    scene_kind kinds[scene_kinds];
    ground_solid solids[scene_solids];
    enum ground_look ground;
    float relief;       /* m: height of the ground's waves; 0: a plane */
    float ground_level; /* m */
    int water;          /* at y = 0 */
    float life;         /* s from spawn to respawn */
    float ready;        /* elapsed part of a life of bodies in the air at the start; 0: an empty sky */
    float ground_effect;
    float whirl; /* m/s: fastest wind of a whirl about the camera's target, given as a grid; 0: none */
    settings initially;
    struct camera camera;
} scene_plan;

enum { scene_plan_count = 7 };
extern const scene_plan scene_plans[scene_plan_count];

/* Finds a plan by name; null if there is none. */
const scene_plan* scene_find(const char* name);

#endif
