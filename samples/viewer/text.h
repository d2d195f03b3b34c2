/* Text and boxes over the picture, from the samples' stroke letters.    SPDX-License-Identifier: MIT */
#ifndef VIEWER_TEXT_H
#define VIEWER_TEXT_H

#include "gl.h"

typedef struct text_vertex {
    float position[2], place[2], shade[4];
} text_vertex;

typedef struct text {
    GLuint program, atlas, array, buffer;
    float height; /* px, of a digit */
    int atlas_width, atlas_height;
    text_vertex* vertices;
    size_t count, room;
} text;

typedef struct shade {
    float r, g, b, a;
} shade;

void text_create(text* t);
void text_free(text* t);

/* Sets the height of the next letters, px. */
void text_set_height(text* t, float height);

/* px from the top left of the picture. */
void text_box(text* t, float x, float y, float width, float height, shade colour);

/* baseline: y of the letters' feet. Returns the width; text_width gives it without drawing. */
float text_write(text* t, float x, float baseline, shade colour, const char* string);
float text_width(const text* t, const char* string);

/* Draws everything since the last call into a picture of this size. */
void text_draw(text* t, int width, int height);

#endif
