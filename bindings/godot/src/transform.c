/*
 * SPDX-License-Identifier: MIT
 */
#include "transform.h"

#include <math.h>
#include <string.h>

void transform_identity(float* engine) {
    static const float identity[12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    memcpy(engine, identity, sizeof identity);
}

void transform_multiply(const float* a, const float* b, float* c) {
    float out[12];
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            out[3 * i + j] = a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
        out[9 + i] = a[3 * i] * b[9] + a[3 * i + 1] * b[10] + a[3 * i + 2] * b[11] + a[9 + i];
    }
    memcpy(c, out, sizeof out);
}

void transform_to_rows(const float* engine, float* rows) {
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) rows[4 * i + j] = engine[3 * i + j];
        rows[4 * i + 3] = engine[9 + i];
    }
}

void transform_from_rows(const float* rows, float* engine) {
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) engine[3 * i + j] = rows[4 * i + j];
        engine[9 + i] = rows[4 * i + 3];
    }
}

int transform_invert_to_rows(const float* m, float* rows) {
    const float a = m[4] * m[8] - m[5] * m[7], b = m[5] * m[6] - m[3] * m[8], c = m[3] * m[7] - m[4] * m[6];
    const float determinant = m[0] * a + m[1] * b + m[2] * c;
    if (!(fabsf(determinant) > 1e-30f)) return 0;
    const float r = 1.0f / determinant;
    const float inverse[9] = {a * r, (m[2] * m[7] - m[1] * m[8]) * r, (m[1] * m[5] - m[2] * m[4]) * r,
                              b * r, (m[0] * m[8] - m[2] * m[6]) * r, (m[2] * m[3] - m[0] * m[5]) * r,
                              c * r, (m[1] * m[6] - m[0] * m[7]) * r, (m[0] * m[4] - m[1] * m[3]) * r};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) rows[4 * i + j] = inverse[3 * i + j];
        rows[4 * i + 3] = -(inverse[3 * i] * m[9] + inverse[3 * i + 1] * m[10] + inverse[3 * i + 2] * m[11]);
    }
    return 1;
}

int transform_split(const float* m, float* position, float* q, float* scale) {
    float axis[3][3]; /* columns of the basis */
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) axis[j][i] = m[3 * i + j];
    for (int j = 0; j < 3; ++j) {
        for (int k = 0; k < j; ++k) {
            const float along = axis[j][0] * axis[k][0] + axis[j][1] * axis[k][1] + axis[j][2] * axis[k][2];
            for (int i = 0; i < 3; ++i) axis[j][i] -= along * axis[k][i];
        }
        const float length = sqrtf(axis[j][0] * axis[j][0] + axis[j][1] * axis[j][1] + axis[j][2] * axis[j][2]);
        if (!(length > 1e-9f) || !isfinite(length)) return 0;
        for (int i = 0; i < 3; ++i) axis[j][i] /= length;
        scale[j] = length;
    }
    const float turn = axis[0][0] * (axis[1][1] * axis[2][2] - axis[1][2] * axis[2][1]) +
                       axis[0][1] * (axis[1][2] * axis[2][0] - axis[1][0] * axis[2][2]) +
                       axis[0][2] * (axis[1][0] * axis[2][1] - axis[1][1] * axis[2][0]);
    if (turn < 0.0f) {
        scale[0] = -scale[0];
        for (int i = 0; i < 3; ++i) axis[0][i] = -axis[0][i];
    }
    /* r_ij = axis[j][i]. The largest component of the quaternion comes first, for accuracy. */
    const float xx = axis[0][0], yy = axis[1][1], zz = axis[2][2];
    const float parts[4] = {xx - yy - zz, yy - xx - zz, zz - xx - yy, xx + yy + zz};
    int largest = 3;
    for (int i = 0; i < 3; ++i)
        if (parts[i] > parts[largest]) largest = i;
    const float root = sqrtf(fmaxf(parts[largest] + 1.0f, 0.0f)), half = 0.5f / root;
    q[largest] = 0.5f * root;
    if (largest == 3) {
        q[0] = (axis[1][2] - axis[2][1]) * half;
        q[1] = (axis[2][0] - axis[0][2]) * half;
        q[2] = (axis[0][1] - axis[1][0]) * half;
    } else {
        const int j = (largest + 1) % 3, k = (largest + 2) % 3;
        q[j] = (axis[j][largest] + axis[largest][j]) * half;
        q[k] = (axis[k][largest] + axis[largest][k]) * half;
        q[3] = (axis[j][k] - axis[k][j]) * half;
    }
    memcpy(position, m + 9, 3 * sizeof(float));
    return 1;
}

void transform_join(const float* position, const float* q, float s, float* m) {
    const float x = q[0], y = q[1], z = q[2], w = q[3];
    m[0] = s * (1 - 2 * (y * y + z * z)), m[1] = s * 2 * (x * y - z * w), m[2] = s * 2 * (x * z + y * w);
    m[3] = s * 2 * (x * y + z * w), m[4] = s * (1 - 2 * (x * x + z * z)), m[5] = s * 2 * (y * z - x * w);
    m[6] = s * 2 * (x * z - y * w), m[7] = s * 2 * (y * z + x * w), m[8] = s * (1 - 2 * (x * x + y * y));
    memcpy(m + 9, position, 3 * sizeof(float));
}

void transform_apply(float* rows, uint32_t count, const float* b) {
    for (uint32_t body = 0; body < count; ++body)
        for (int i = 0; i < 3; ++i) {
            float* row = rows + 12u * body + 4 * i;
            const float x = row[0], y = row[1], z = row[2];
            for (int j = 0; j < 4; ++j) row[j] = x * b[j] + y * b[4 + j] + z * b[8 + j] + (j == 3 ? row[3] : 0.0f);
        }
}
