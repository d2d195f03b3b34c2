/* Inputs of all shader programs of a picture.    SPDX-License-Identifier: MIT */
#ifndef VIEWER_PASS_H
#define VIEWER_PASS_H

#include "camera.h"
#include "gl.h"

/* Unit vector towards the sun. */
extern const float sun_direction[3];

typedef struct pass {
    camera_view view;
    mat4 to_light;
    float light_half, light_depth; /* m: half of the shadow map's box, across and along */
    float texel;                   /* m of the shadow map */
    GLuint depth_texture, depth_samplers[2];
} pass;

/* Makes a program from the parts and the common beginning of all scene shaders. */
GLuint pass_program(const char* name, const char* vertex, const char* fragment);

/* Uses a program for the picture, or for the shadow map. */
void pass_use(const pass* p, GLuint program);
void pass_use_for_shadow(const pass* p, GLuint program);

#endif
