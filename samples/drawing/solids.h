/* Triangles of objects on the ground.    SPDX-License-Identifier: MIT */
#ifndef DRAWING_SOLIDS_H
#define DRAWING_SOLIDS_H

#include <langevin_rigid.h>
#include <stddef.h>

#include "looks.h"

/* An object on the ground. */
typedef struct ground_solid {
    int32_t kind;               /* LR_COLLIDER_BOX, SPHERE, CAPSULE (along y) or HULL; 0: none */
    int look;                   /* SOLID_... */
    float at[3], size[3], turn; /* as in lr_collider_desc; turn: rad about y */
    const float* points;        /* of a hull: x, y, z each */
    uint32_t point_count;
} ground_solid;

typedef struct solid_vertex {
    float position[3], normal[3]; /* world */
    float own[3];                 /* position in the solid's frame */
    float look;                   /* enum solid_look */
} solid_vertex;

typedef struct solid_list {
    solid_vertex* vertices; /* three per triangle */
    size_t count;
} solid_list;

void solids_add(solid_list* list, const ground_solid* s);

#endif
