/* The shape of the ground, for the world's collider and for the picture.    SPDX-License-Identifier: MIT */
#ifndef VIEWER_GROUND_H
#define VIEWER_GROUND_H

#include <langevin_rigid.h>

enum { ground_side = 129 };                                  /* samples along each side */
#define GROUND_CELL 0.1875f                                  /* m between them */
#define GROUND_HALF (0.5f * GROUND_CELL * (ground_side - 1)) /* 12 m: bodies end before its edge */

/* Height at a point, m. relief: height of the waves, m; they end before the edge. */
float ground_height(float relief, float level, float x, float z);

/* Height of the collider at a point: its triangles deviate a little from the curve between samples. */
float ground_surface(float relief, float level, float x, float z);

/* Samples in the order of a heightfield: x varies fastest. */
void ground_heights(float relief, float level, float heights[ground_side * ground_side]);

/* Creates the collider: a heightfield, or a plane without relief. */
lr_collider ground_create(lr_world* world, float relief, float level);

#endif
