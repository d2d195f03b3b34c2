/* Triangles of objects on the ground.    SPDX-License-Identifier: MIT */
#ifndef VIEWER_SOLIDS_H
#define VIEWER_SOLIDS_H

#include <stddef.h>

#include "scenes.h"

typedef struct solid_vertex {
    float position[3], normal[3]; /* world */
    float own[3];                 /* position in the solid's frame */
    float wood;                   /* 1 or 0 */
} solid_vertex;

typedef struct solid_list {
    solid_vertex* vertices; /* three per triangle */
    size_t count;
} solid_list;

void solids_add(solid_list* list, const scene_solid* solid);

#endif
