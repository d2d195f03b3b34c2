/* SPDX-License-Identifier: MIT */
#include "camera.h"

static const float half_angle = 0.36f; /* rad: a lens of about 32 mm */
static const float lowest_eye = 0.06f; /* m above the ground */

camera_view camera_look(const camera* c, float aspect) {
    camera_view v;
    const float ce = cosf(c->elevation), se = sinf(c->elevation), ca = cosf(c->azimuth), sa = sinf(c->azimuth);
    v.back = v3(ce * sa, se, ce * ca);
    v.right = v3(ca, 0.0f, -sa);
    v.up = cross(v.back, v.right);
    v.eye = add(c->target, scaled(v.back, c->distance));
    if (v.eye.y < lowest_eye) v.eye.y = lowest_eye;
    v.tan_half = tanf(half_angle);
    v.aspect = aspect;
    v.near = clamped(0.02f * c->distance, 0.01f, 0.5f);
    v.far = 500.0f;
    const mat4 view = view_matrix(v.right, v.up, v.back, v.eye);
    const mat4 lens = perspective(v.tan_half, aspect, v.near, v.far);
    v.to_clip = product(&lens, &view);
    return v;
}

void camera_orbit(camera* c, float dx, float dy) {
    c->azimuth -= 3.5f * dx;
    c->elevation = clamped(c->elevation + 3.5f * dy, -0.10f, 1.5f);
}

void camera_pan(camera* c, float dx, float dy) {
    const camera_view v = camera_look(c, 1.0f);
    const float metres = 2.0f * v.tan_half * c->distance;
    c->target = add(c->target, scaled(v.right, -dx * metres));
    c->target = add(c->target, scaled(v.up, dy * metres));
    c->target.y = clamped(c->target.y, 0.0f, 8.0f);
    c->target.x = clamped(c->target.x, -10.0f, 10.0f);
    c->target.z = clamped(c->target.z, -10.0f, 10.0f);
}

void camera_zoom(camera* c, float notches) {
    c->distance = clamped(c->distance * powf(0.88f, notches), 0.15f, 25.0f);
}

vec3 camera_ray(const camera_view* v, float x, float y) {
    const vec3 across = scaled(v->right, x * v->tan_half * v->aspect), upward = scaled(v->up, y * v->tan_half);
    return unit(sub(add(across, upward), v->back));
}

int camera_project(const camera_view* v, vec3 point, float* x, float* y) {
    const vec3 d = sub(point, v->eye);
    const float depth = -dot(d, v->back);
    if (depth < v->near) return 0;
    *x = dot(d, v->right) / (depth * v->tan_half * v->aspect);
    *y = dot(d, v->up) / (depth * v->tan_half);
    return 1;
}

float camera_depth(const camera_view* v, vec3 middle, float radius) {
    const vec3 d = sub(middle, v->eye);
    const float depth = -dot(d, v->back);
    if (depth < v->near - radius) return -1.0f;
    const float reach = v->tan_half * depth;
    /* The sides of the picture lean outward, so a sphere is visible from slightly farther than its radius. */
    if (fabsf(dot(d, v->up)) > reach + 1.1f * radius) return -1.0f;
    if (fabsf(dot(d, v->right)) > reach * v->aspect + 1.4f * radius) return -1.0f;
    return depth > v->near ? depth : v->near;
}
