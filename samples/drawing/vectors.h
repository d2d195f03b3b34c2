/* Vectors and matrices of single precision. Matrices are column-major, as in OpenGL.    SPDX-License-Identifier: MIT */
#ifndef DRAWING_VECTORS_H
#define DRAWING_VECTORS_H

#include <math.h>

typedef struct vec3 {
    float x, y, z;
} vec3;

typedef struct mat4 {
    float m[16];
} mat4;

#define PI 3.14159265f

static inline vec3 v3(float x, float y, float z) {
    vec3 v = {x, y, z};
    return v;
}
static inline vec3 from_array(const float* a) {
    return v3(a[0], a[1], a[2]);
}
static inline void to_array(vec3 v, float* a) {
    a[0] = v.x, a[1] = v.y, a[2] = v.z;
}
static inline vec3 add(vec3 a, vec3 b) {
    return v3(a.x + b.x, a.y + b.y, a.z + b.z);
}
static inline vec3 sub(vec3 a, vec3 b) {
    return v3(a.x - b.x, a.y - b.y, a.z - b.z);
}
static inline vec3 scaled(vec3 a, float s) {
    return v3(a.x * s, a.y * s, a.z * s);
}
static inline float dot(vec3 a, vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
static inline vec3 cross(vec3 a, vec3 b) {
    return v3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
static inline float length(vec3 a) {
    return sqrtf(dot(a, a));
}
static inline vec3 unit(vec3 a) {
    const float l = length(a);
    return l > 0.0f ? scaled(a, 1.0f / l) : a;
}
static inline vec3 mixed(vec3 a, vec3 b, float t) {
    return add(scaled(a, 1.0f - t), scaled(b, t));
}
static inline float clamped(float x, float low, float high) {
    return x < low ? low : x > high ? high : x;
}
static inline float smooth(float low, float high, float x) {
    const float t = clamped((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

/* v rotated by the unit quaternion x y z w. */
static inline vec3 turned(const float* q, vec3 v) {
    const vec3 axis = v3(q[0], q[1], q[2]);
    const vec3 t = scaled(cross(axis, v), 2.0f);
    return add(add(v, scaled(t, q[3])), cross(axis, t));
}

static inline mat4 product(const mat4* a, const mat4* b) {
    mat4 c;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            float sum = 0.0f;
            for (int k = 0; k < 4; ++k) sum += a->m[4 * k + row] * b->m[4 * column + k];
            c.m[4 * column + row] = sum;
        }
    }
    return c;
}

/* World to eye: `back` points from the target to the eye. */
static inline mat4 view_matrix(vec3 right, vec3 up, vec3 back, vec3 eye) {
    const mat4 m = {{right.x, up.x, back.x, 0.0f, right.y, up.y, back.y, 0.0f, right.z, up.z, back.z, 0.0f,
                     -dot(right, eye), -dot(up, eye), -dot(back, eye), 1.0f}};
    return m;
}

static inline mat4 perspective(float tan_half, float aspect, float near, float far) {
    const mat4 m = {{1.0f / (tan_half * aspect), 0.0f, 0.0f, 0.0f, 0.0f, 1.0f / tan_half, 0.0f, 0.0f, 0.0f, 0.0f,
                     (far + near) / (near - far), -1.0f, 0.0f, 0.0f, 2.0f * far * near / (near - far), 0.0f}};
    return m;
}

/* A box of half width `half`, and from -half_depth to half_depth along the view. */
static inline mat4 orthographic(float half, float half_depth) {
    const mat4 m = {{1.0f / half, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f / half, 0.0f, 0.0f, 0.0f, 0.0f, -1.0f / half_depth, 0.0f,
                     0.0f, 0.0f, 0.0f, 1.0f}};
    return m;
}

#endif
