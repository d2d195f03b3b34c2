/* Inputs of all shader programs of a picture.    SPDX-License-Identifier: MIT */
#ifndef DRAWING_PASS_H
#define DRAWING_PASS_H

#include "camera.h"
#include "gl.h"

/* The time of day: the sun, and the text of its shaders. */
typedef struct sunshine {
    float sun[3]; /* unit vector towards it */
    const char *air, *sky;
} sunshine;
extern const sunshine light_day, light_evening;

typedef struct pass {
    const sunshine* light;
    float haze; /* m: where the air hides most */
    camera_view view;
    mat4 to_light;
    float light_half, light_depth; /* m: half of the shadow map's box, across and along */
    float texel;                   /* m of the shadow map */
    GLuint depth_texture, depth_samplers[2];
} pass;

/* Makes a program from the parts and the common beginning of all scene shaders. */
GLuint pass_program(const sunshine* l, const char* name, const char* vertex, const char* fragment);

/* Uses a program for the picture, or for the shadow map. */
void pass_use(const pass* p, GLuint program);
void pass_use_for_shadow(const pass* p, GLuint program);

#endif
