/*
 * Transforms between the engine's layout (three rows of the basis, then the origin), the multimesh's and the library's
 * (rows of 3x4), and the library's position and quaternion.
 *
 * SPDX-License-Identifier: MIT
 */
#ifndef LANGEVIN_TRANSFORM_H
#define LANGEVIN_TRANSFORM_H

#include <stdint.h>

void transform_identity(float* engine);

/* c = a b, all in the engine's layout; c may be a or b. */
void transform_multiply(const float* a, const float* b, float* c);

/* An engine's transform to rows of 3x4, and back. */
void transform_to_rows(const float* engine, float* rows);
void transform_from_rows(const float* rows, float* engine);

/* The inverse of an engine's transform as rows of 3x4; 0 if it has none. */
int transform_invert_to_rows(const float* engine, float* rows);

/* Position, unit quaternion x y z w, and scale along the local axes. A mirrored basis gets a negative scale along x. A
 * sheared basis is made orthogonal by Gram-Schmidt. Returns 0 if an axis is zero or not finite. */
int transform_split(const float* engine, float* position, float* quaternion, float* scale);

/* The inverse of transform_split, with a uniform scale. */
void transform_join(const float* position, const float* quaternion, float scale, float* engine);

/* rows[i] = rows[i] * local for `count` bodies of 12 floats; local in rows of 3x4. */
void transform_apply(float* rows, uint32_t count, const float* local);

#endif
