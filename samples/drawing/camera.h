/* A camera that orbits its target.    SPDX-License-Identifier: MIT */
#ifndef DRAWING_CAMERA_H
#define DRAWING_CAMERA_H

#include "vectors.h"

typedef struct camera {
    vec3 target;
    float distance;  /* m, from the target */
    float azimuth;   /* rad, about y; 0 looks along -z */
    float elevation; /* rad, above the horizontal */
} camera;

/* The camera's vectors and angles for a picture of this shape. */
typedef struct camera_view {
    vec3 eye, right, up, back;
    float tan_half; /* of half the vertical field of view */
    float aspect, near, far;
    mat4 to_clip;
} camera_view;

camera_view camera_look(const camera* c, float aspect);

/* Mouse motion relative to the picture's height, x to the right, y down. */
void camera_orbit(camera* c, float dx, float dy);
void camera_pan(camera* c, float dx, float dy);
void camera_zoom(camera* c, float notches);

/* Unit vector from the eye through a point of the picture: x, y from -1 to 1, y up. */
vec3 camera_ray(const camera_view* v, float x, float y);

/* Projects a point into the picture: x, y from -1 to 1, y up. 0 if it is behind the eye. */
int camera_project(const camera_view* v, vec3 point, float* x, float* y);

/* Distance ahead of a sphere; negative if it cannot be in the picture. */
float camera_depth(const camera_view* v, vec3 middle, float radius);

#endif
