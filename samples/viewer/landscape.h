/* Draws ground, solids, water and sky.    SPDX-License-Identifier: MIT */
#ifndef VIEWER_LANDSCAPE_H
#define VIEWER_LANDSCAPE_H

#include "pass.h"
#include "scene.h"

typedef struct landscape {
    GLuint ground_program, solid_program, solid_shadow_program, water_program, sky_program;
    GLuint ground_array, ground_vertices, ground_indices; /* the water uses the same points */
    GLuint solid_array, solid_vertices;
    GLsizei ground_count, solid_count;
} landscape;

void landscape_create(landscape* l, const scene* s);
void landscape_free(landscape* l);

void landscape_draw_shadow(const landscape* l, const pass* p);
void landscape_draw(const landscape* l, const scene* s, const pass* p);

/* Draw after everything opaque. */
void landscape_draw_water(const landscape* l, const scene* s, const pass* p, double time);

#endif
