/*
 * Transforms between the engine's layout and the library's, with calculated numbers.
 *
 * SPDX-License-Identifier: MIT
 */
#include "../src/transform.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static int passed, failed;

static void check(int ok, const char* what) {
    if (ok)
        ++passed;
    else
        ++failed, printf("FAILED: %s\n", what);
}

static int near(const float* a, const float* b, int count) {
    for (int i = 0; i < count; ++i)
        if (!(fabsf(a[i] - b[i]) < 1e-5f)) return 0;
    return 1;
}

int main(void) {
    /* A quarter turn about y, twice the size, at 1 2 3: x goes to -z, z to x. */
    const float quarter[12] = {0, 0, 2, 0, 2, 0, -2, 0, 0, 1, 2, 3};
    const float half = 0.70710678f;
    float position[3], q[4], scale[3], joined[12], rows[12], back[12], product[12];
    check(transform_split(quarter, position, q, scale), "split");
    check(near(position, (const float[]){1, 2, 3}, 3), "position");
    check(near(q, (const float[]){0, half, 0, half}, 4), "quarter turn about y");
    check(near(scale, (const float[]){2, 2, 2}, 3), "scale");
    transform_join(position, q, 2.0f, joined);
    check(near(joined, quarter, 12), "join is the inverse of split");

    transform_to_rows(quarter, rows);
    check(near(rows, (const float[]){0, 0, 2, 1, 0, 2, 0, 2, -2, 0, 0, 3}, 12), "rows of 3x4");
    transform_from_rows(rows, back);
    check(near(back, quarter, 12), "and back");

    transform_multiply(quarter, quarter, product);
    check(near(product, (const float[]){-4, 0, 0, 0, 4, 0, 0, 0, -4, 7, 6, 1}, 12), "product");

    float inverse_rows[12], inverse[12];
    check(transform_invert_to_rows(quarter, inverse_rows), "invert");
    transform_from_rows(inverse_rows, inverse);
    transform_multiply(quarter, inverse, product);
    float identity[12];
    transform_identity(identity);
    check(near(product, identity, 12), "times its inverse");

    /* Half turns, for which the quaternion's w vanishes. */
    static const float turns[3][3] = {{1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    for (int axis = 0; axis < 3; ++axis) {
        float turn[12] = {turns[axis][0], 0, 0, 0, turns[axis][1], 0, 0, 0, turns[axis][2], 0, 0, 0};
        float want[4] = {0, 0, 0, 0};
        want[axis] = 1;
        check(transform_split(turn, position, q, scale) && near(q, want, 4), "half turn");
        transform_join(position, q, 1.0f, joined);
        check(near(joined, turn, 12), "half turn, joined");
    }

    const float mirrored[12] = {-3, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0};
    check(transform_split(mirrored, position, q, scale) && near(scale, (const float[]){-3, 1, 2}, 3), "mirrored");
    check(near(q, (const float[]){0, 0, 0, 1}, 4), "mirrored, not turned");
    const float flat[12] = {1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0};
    check(!transform_split(flat, position, q, scale), "flat");
    check(!transform_invert_to_rows(flat, rows), "flat, inverted");
    const float wrong[12] = {1, 0, 0, 0, NAN, 0, 0, 0, 1, 0, 0, 0};
    check(!transform_split(wrong, position, q, scale), "not a number");

    /* A mesh with its centre of mass at 5 0 0: the body at 1 2 3, after a quarter turn, draws that point at 1 2 3. */
    float two[24], local[12], shift[12];
    transform_to_rows(quarter, two);
    transform_to_rows(quarter, two + 12);
    transform_identity(shift);
    shift[9] = -5;
    transform_to_rows(shift, local);
    transform_apply(two, 2, local);
    for (int body = 0; body < 2; ++body) {
        const float* r = two + 12 * body;
        const float at[3] = {r[0] * 5 + r[3], r[4] * 5 + r[7], r[8] * 5 + r[11]};
        check(near(at, (const float[]){1, 2, 3}, 3), "the mesh's centre of mass is at the body");
        check(near(r, (const float[]){0, 0, 2}, 3), "the basis is the body's");
    }
    printf("transform: %d passed, %d failed\n", passed, failed);
    return failed != 0;
}
