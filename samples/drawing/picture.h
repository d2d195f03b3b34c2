/* The framebuffer of a picture, and its pixels.    SPDX-License-Identifier: MIT */
#ifndef DRAWING_PICTURE_H
#define DRAWING_PICTURE_H

#include "gl.h"

typedef struct picture {
    int width, height;
    GLuint target[2]; /* multisampled; and with one sample per pixel, for the panel and for reading */
    GLuint colour[2], depth;
} picture;

/* Creates a picture without a size. */
void picture_create(picture* p);
void picture_free(picture* p);

/* Fails with a message if OpenGL cannot. */
void picture_resize(picture* p, int width, int height);

void picture_begin(const picture* p);

/* Averages the samples; further drawing goes on top. */
void picture_resolve(const picture* p);

/* RGB, 8 bits each, rows from the top: 3 * width * height bytes. */
void picture_read(const picture* p, unsigned char* rgb);

#endif
