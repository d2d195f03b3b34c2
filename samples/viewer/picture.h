/* The framebuffer of a picture, and its pixels.    SPDX-License-Identifier: MIT */
#ifndef VIEWER_PICTURE_H
#define VIEWER_PICTURE_H

#include "gl.h"

typedef struct picture {
    int width, height;
    GLuint target[2]; /* of several samples a pixel; of one, where the panel is drawn and pixels are read */
    GLuint colour[2], depth;
} picture;

/* Of no size yet. */
void picture_create(picture* p);
void picture_free(picture* p);

/* Fails with a message when OpenGL cannot. */
void picture_resize(picture* p, int width, int height);

void picture_begin(const picture* p);

/* Averages the samples; what is drawn from now on goes on top. */
void picture_resolve(const picture* p);

/* RGB, 8 bits each, rows from the top: 3 * width * height bytes. */
void picture_read(const picture* p, unsigned char* rgb);

#endif
