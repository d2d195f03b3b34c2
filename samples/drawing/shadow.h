/* The shadow map: depths from the sun around the camera's target.    SPDX-License-Identifier: MIT */
#ifndef DRAWING_SHADOW_H
#define DRAWING_SHADOW_H

#include "pass.h"

typedef struct shadow {
    GLuint target, texture, samplers[2]; /* of depths, of comparisons */
} shadow;

void shadow_create(shadow* s);
void shadow_free(shadow* s);

/* Sets the light's box of a pass, and begins to draw into the map. */
void shadow_begin(const shadow* s, const camera* c, pass* p);

/* Whether a sphere can cast a shadow into the map. */
int shadow_holds(const pass* p, vec3 middle, float radius);

#endif
