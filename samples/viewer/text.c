/* SPDX-License-Identifier: MIT */
#include "text.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "failure.h"
#include "image/glyphs.h"
#include "shaders.h"

/* A cell of the atlas holds a letter's grid with a margin, in eighths of a digit's height. */
enum { columns = 16, rows = 6, first_letter = 32, cell_units_x = 12, cell_units_y = 14 };
static const float margin = 1.5f, gap = 2.4f, space = 4.4f; /* units */

static float digit(char c) {
    return (float)(c <= '9' ? c - '0' : c - 'a' + 10);
}

static float advance(char c) {
    const char* at = glyph((char)tolower((unsigned char)c));
    if (!*at) return space;
    float right = 0.0f;
    for (; *at; ++at) {
        if (*at == '~' || *at == ' ' || *at == ',') continue;
        right = fmaxf(right, digit(*at));
        ++at;
    }
    return right + gap;
}

static float catmull_rom(float a, float b, float c, float d, float t) {
    return 0.5f * (2.0f * b + t * (c - a + t * (2.0f * a - 5.0f * b + 4.0f * c - d + t * (3.0f * (b - c) + d - a))));
}

typedef struct cell {
    unsigned char* pixels;
    int width, height, stride;
    float unit, half; /* px: of the grid, and half of a stroke */
} cell;

/* Draws a stroke from a to b, in units, with round ends. */
static void draw_segment(const cell* c, const float* a, const float* b) {
    const float ax = (a[0] + margin) * c->unit, ay = (a[1] + margin) * c->unit;
    const float dx = (b[0] - a[0]) * c->unit, dy = (b[1] - a[1]) * c->unit, squared = dx * dx + dy * dy;
    for (int y = 0; y < c->height; ++y) {
        for (int x = 0; x < c->width; ++x) {
            const float px = (float)x + 0.5f - ax, py = (float)y + 0.5f - ay;
            const float along = squared > 0.0f ? fminf(fmaxf((px * dx + py * dy) / squared, 0.0f), 1.0f) : 0.0f;
            const float reach = hypotf(px - along * dx, py - along * dy);
            const float cover = fminf(fmaxf(c->half - reach + 0.5f, 0.0f), 1.0f);
            unsigned char* p = &c->pixels[y * c->stride + x];
            const int value = (int)(255.0f * cover + 0.5f);
            if (value > *p) *p = (unsigned char)value;
        }
    }
}

static void draw_glyph(const cell* c, char letter) {
    for (const char* at = glyph(letter); *at;) {
        const int curved = *at == '~';
        if (curved) ++at;
        float points[32][2];
        int n = 0;
        for (; *at && *at != ',' && n < 32; at += *at == ' ' ? 1 : 0, ++n) {
            points[n][0] = digit(at[0]), points[n][1] = digit(at[1]);
            at += 2;
        }
        if (*at) ++at;
        const cell dot_of = {c->pixels, c->width, c->height, c->stride, c->unit, 1.5f * c->half};
        if (n == 1) draw_segment(&dot_of, points[0], points[0]);
        const int closed = n > 2 && memcmp(points[0], points[n - 1], sizeof points[0]) == 0;
        for (int i = 0; i + 1 < n; ++i) {
            const float *before = points[i        ? i - 1
                                         : closed ? n - 2
                                                  : 0],
                        *after = points[i + 2 < n ? i + 2
                                        : closed  ? 1
                                                  : n - 1];
            float from[2] = {points[i][0], points[i][1]};
            const int parts = curved ? 6 : 1;
            for (int k = 1; k <= parts; ++k) {
                float to[2] = {points[i + 1][0], points[i + 1][1]};
                for (int d = 0; curved && d < 2; ++d)
                    to[d] = catmull_rom(before[d], points[i][d], points[i + 1][d], after[d], (float)k / (float)parts);
                draw_segment(c, from, to);
                memcpy(from, to, sizeof from);
            }
        }
    }
}

void text_create(text* t) {
    memset(t, 0, sizeof *t);
    static const char version[] = "#version 330 core\n";
    const char *const vertex[2] = {version, shader_panel_vert}, *const fragment[2] = {version, shader_panel_frag};
    t->program = make_program("panel", vertex, fragment);
    glGenTextures(1, &t->atlas);
    glGenVertexArrays(1, &t->array);
    glBindVertexArray(t->array);
    glGenBuffers(1, &t->buffer);
    glBindBuffer(GL_ARRAY_BUFFER, t->buffer);
    gl_attribute(0, 2, sizeof(text_vertex), offsetof(text_vertex, position), 0);
    gl_attribute(1, 2, sizeof(text_vertex), offsetof(text_vertex, place), 0);
    gl_attribute(2, 4, sizeof(text_vertex), offsetof(text_vertex, shade), 0);
    glBindVertexArray(0);
}

void text_free(text* t) {
    glDeleteProgram(t->program);
    glDeleteTextures(1, &t->atlas);
    glDeleteVertexArrays(1, &t->array);
    glDeleteBuffers(1, &t->buffer);
    free(t->vertices);
    memset(t, 0, sizeof *t);
}

void text_set_height(text* t, float height) {
    if (t->height == height) return;
    t->height = height;
    const float unit = height / 8.0f;
    const int width = (int)ceilf(cell_units_x * unit), tall = (int)ceilf(cell_units_y * unit);
    t->atlas_width = columns * width, t->atlas_height = rows * tall;
    unsigned char* pixels = allocate((size_t)(t->atlas_width * t->atlas_height), 1);
    for (int i = 0; i < columns * rows; ++i) {
        const cell c = {pixels + (i / columns) * tall * t->atlas_width + (i % columns) * width,
                        width,
                        tall,
                        t->atlas_width,
                        unit,
                        0.5f * fmaxf(1.15f, 0.95f * unit)};
        draw_glyph(&c, (char)(first_letter + i));
    }
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, t->atlas);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, t->atlas_width, t->atlas_height, 0, GL_RED, GL_UNSIGNED_BYTE, pixels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    free(pixels);
}

static void put_quad(text* t, const float at[4], const float place[4], shade c) {
    if (t->count + 6 > t->room) {
        t->room = t->room ? 2 * t->room : 1536;
        t->vertices = grow(t->vertices, t->room, sizeof *t->vertices);
    }
    static const int corners[6][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
    for (int i = 0; i < 6; ++i) {
        const int right = corners[i][0], low = corners[i][1];
        const text_vertex v = {{at[0] + (right ? at[2] : 0.0f), at[1] + (low ? at[3] : 0.0f)},
                               {place[0] + (right ? place[2] : 0.0f), place[1] + (low ? place[3] : 0.0f)},
                               {c.r, c.g, c.b, c.a}};
        t->vertices[t->count++] = v;
    }
}

void text_box(text* t, float x, float y, float width, float height, shade colour) {
    const float at[4] = {x, y, width, height}, nowhere[4] = {-1e6f, -1e6f, 0.0f, 0.0f};
    put_quad(t, at, nowhere, colour);
}

float text_write(text* t, float x, float baseline, shade colour, const char* string) {
    const float unit = t->height / 8.0f, start = x;
    const int width = t->atlas_width / columns, tall = t->atlas_height / rows;
    for (; *string; ++string) {
        const char letter = (char)tolower((unsigned char)*string);
        const int i = letter - first_letter;
        if (*glyph(letter) && i >= 0 && i < columns * rows) {
            /* Whole pixels keep the letters sharp. */
            const float at[4] = {roundf(x - margin * unit), roundf(baseline - (8.0f + margin) * unit), (float)width,
                                 (float)tall};
            const float place[4] = {(float)(i % columns * width), (float)(i / columns * tall), (float)width,
                                    (float)tall};
            put_quad(t, at, place, colour);
        }
        x += advance(letter) * unit;
    }
    return x - start;
}

float text_width(const text* t, const char* string) {
    float units = 0.0f;
    for (; *string; ++string) units += advance(*string);
    return units * t->height / 8.0f;
}

void text_draw(text* t, int width, int height) {
    glUseProgram(t->program);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, t->atlas);
    glBindSampler(0, 0);
    glUniform1i(uniform(t->program, "atlas"), 0);
    glUniform2f(uniform(t->program, "picture"), (float)width, (float)height);
    glUniform2f(uniform(t->program, "atlas_size"), (float)t->atlas_width, (float)t->atlas_height);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glBindVertexArray(t->array);
    glBindBuffer(GL_ARRAY_BUFFER, t->buffer);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(t->count * sizeof *t->vertices), t->vertices, GL_STREAM_DRAW);
    glDrawArrays(GL_TRIANGLES, 0, (GLsizei)t->count);
    glBindVertexArray(0);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    t->count = 0;
}
