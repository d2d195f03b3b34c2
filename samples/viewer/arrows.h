/* Arrows of the wind on a lattice around the camera's target.    SPDX-License-Identifier: MIT */
#ifndef VIEWER_ARROWS_H
#define VIEWER_ARROWS_H

#include "drawing/pass.h"
#include "scene.h"

typedef struct arrows {
    GLuint program, array, vertices, instances;
    GLsizei vertex_count;
} arrows;

void arrows_create(arrows* a);
void arrows_free(arrows* a);

/* Each arrow shows the result of lr_world_sample_wind at its foot. */
void arrows_draw(const arrows* a, const scene* s, const pass* p, const camera* c);

#endif
