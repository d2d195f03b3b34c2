/* Draws the bodies of batches by instances, directly from the library's transforms.    SPDX-License-Identifier: MIT */
#ifndef DRAWING_BODIES_H
#define DRAWING_BODIES_H

#include "looks.h"
#include "mesh.h"
#include "pass.h"

/* A batch to draw. */
typedef struct drawn_batch {
    lr_batch batch;
    const body_mesh* mesh;
    enum look look;
} drawn_batch;

enum { body_levels = 3 }; /* levels of detail, the finest first */

typedef struct body_level {
    GLuint array, vertices, indices;
    GLsizei index_count;
} body_level;

/* The drawn state of a batch: its mesh, and its transforms on the graphics card. */
typedef struct body_batch {
    body_level levels[body_levels];
    float radius;
    GLuint transforms, texture;
    float (*rows)[12]; /* written by the library */
    uint32_t capacity;
    lr_batch batch;    /* the batch of the rows */
    uint64_t revision; /* the view's revision at that time */
    uint32_t moved, written;
} body_batch;

typedef struct bodies {
    GLuint program, shadow_program, picked;
    uint32_t (*list)[2]; /* index in the view and noise seed of drawn bodies */
    uint32_t room;
    body_batch* batches;
    int batch_count;
} bodies;

/* `drawn` has the same meshes in the same order in all later calls; its batches may be others. */
void bodies_create(bodies* b, const sunshine* l, const drawn_batch* drawn, int count);
void bodies_free(bodies* b);

/* Updates the transforms; those of sleeping bodies are not written again. */
void bodies_update(bodies* b, const lr_world* world, const drawn_batch* drawn);

void bodies_draw_shadow(bodies* b, const lr_world* world, const drawn_batch* drawn, const pass* p);
void bodies_draw(bodies* b, const lr_world* world, const drawn_batch* drawn, const pass* p, int picture_height);

#endif
