/* Paths of some bodies: ribbons of the bodies' width, which show their rotation.    SPDX-License-Identifier: MIT */
#ifndef VIEWER_TRAILS_H
#define VIEWER_TRAILS_H

#include "drawing/pass.h"
#include "scene.h"

enum { trail_number = 12, trail_points = 300 };

typedef struct trail_point {
    vec3 at, across; /* the centre of mass; half the body's width to one side */
} trail_point;

typedef struct trail {
    lr_body body; /* id 0: none */
    float half_width;
    uint32_t resting; /* number of samples without motion */
    uint32_t count, first;
    trail_point points[trail_points];
} trail;

typedef struct trails {
    GLuint program, array, vertices;
    trail list[trail_number]; /* the first is that of the followed body, if any */
    uint32_t picked;          /* number of picked bodies */
    double last;              /* s of the world, time of the last sample */
} trails;

void trails_create(trails* t);
void trails_free(trails* t);

/* Removes all trails. */
void trails_clear(trails* t);

/* After scene_apply: bodies have new ids, or have ended. */
void trails_rename(trails* t, const scene* s);

/* Adds the bodies' present positions. followed: id 0 for none. */
void trails_sample(trails* t, const scene* s, lr_body followed);

/* all: also the trails of bodies that the user does not follow. */
void trails_draw(const trails* t, const pass* p, int all);

#endif
