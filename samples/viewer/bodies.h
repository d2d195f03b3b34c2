/* Draws the bodies of batches by instances, directly from the library's transforms.    SPDX-License-Identifier: MIT */
#ifndef VIEWER_BODIES_H
#define VIEWER_BODIES_H

#include "pass.h"
#include "scene.h"

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
    body_batch batches[scene_kinds];
    int batch_count;
} bodies;

void bodies_create(bodies* b, const scene* s);
void bodies_free(bodies* b);

/* Updates the transforms; those of sleeping bodies are not written again. */
void bodies_update(bodies* b, const scene* s);

void bodies_draw_shadow(bodies* b, const scene* s, const pass* p);
void bodies_draw(bodies* b, const scene* s, const pass* p, int picture_height);

#endif
