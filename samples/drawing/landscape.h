/* Draws ground, solids, water and sky.    SPDX-License-Identifier: MIT */
#ifndef DRAWING_LANDSCAPE_H
#define DRAWING_LANDSCAPE_H

#include <langevin_rigid.h>

#include "looks.h"
#include "pass.h"
#include "solids.h"

/* A square of samples about the origin, x fastest, and level ground around it. */
typedef struct ground_shape {
    int side;    /* samples along an edge; 0: no ground */
    float cell;  /* m between them */
    float level; /* m, of the ground around */
    const float* heights;
} ground_shape;

typedef struct landscape {
    GLuint ground_program, solid_program, solid_shadow_program, water_program, sky_program;
    GLuint ground_array, ground_vertices, ground_indices; /* the water uses the same points */
    GLuint solid_array, solid_vertices;
    GLsizei ground_count, solid_count;
} landscape;

void landscape_create(landscape* l, const sunshine* day, const ground_shape* shape);
void landscape_free(landscape* l);

/* The objects from now on. */
void landscape_place(landscape* l, const ground_solid* solids, int count);

void landscape_draw_shadow(const landscape* l, const pass* p);
void landscape_draw(const landscape* l, enum ground_look look, const pass* p);

/* Draw after everything opaque. */
enum { water_waves = 3 };
void landscape_draw_water(const landscape* l, const lr_wave drawn[water_waves], const pass* p, double time);

#endif
