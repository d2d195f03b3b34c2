/* SPDX-License-Identifier: MIT */
#include "arrows.h"

#include <string.h>

#include "drawing/failure.h"
#include "drawing/shaders.h"
#include "ground.h"

enum { sides = 8, across = 9, layers = 3, lattice = across * across * layers };

static int put(float (*vertices)[6], int n, float radius, float z, int side, float normal_radial, float normal_z) {
    const float turn = 2.0f * PI * (float)side / sides;
    const vec3 out = v3(cosf(turn), sinf(turn), 0.0f);
    to_array(add(scaled(out, radius), v3(0.0f, 0.0f, z)), vertices[n]);
    to_array(add(scaled(out, normal_radial), v3(0.0f, 0.0f, normal_z)), vertices[n] + 3);
    return n + 1;
}

/* A band of a body of revolution from (r0, z0) to (r1, z1), with its normal. */
static int band(float (*vertices)[6], int n, float r0, float z0, float r1, float z1, float normal_r, float normal_z) {
    for (int i = 0; i < sides; ++i) {
        n = put(vertices, n, r0, z0, i, normal_r, normal_z);
        n = put(vertices, n, r0, z0, i + 1, normal_r, normal_z);
        n = put(vertices, n, r1, z1, i + 1, normal_r, normal_z);
        n = put(vertices, n, r0, z0, i, normal_r, normal_z);
        n = put(vertices, n, r1, z1, i + 1, normal_r, normal_z);
        n = put(vertices, n, r1, z1, i, normal_r, normal_z);
    }
    return n;
}

void arrows_create(arrows* a) {
    a->program = pass_program(&light_day, "arrows", shader_arrow_vert, shader_mark_frag);
    float vertices[sides * 6 * 4][6];
    int n = band(vertices, 0, 0.0f, 0.0f, 0.4f, 0.0f, 0.0f, -1.0f);
    n = band(vertices, n, 0.4f, 0.0f, 0.4f, 0.62f, 1.0f, 0.0f);
    n = band(vertices, n, 0.4f, 0.62f, 1.0f, 0.62f, 0.0f, -1.0f);
    n = band(vertices, n, 1.0f, 0.62f, 0.0f, 1.0f, 0.93f, 0.36f);
    a->vertex_count = n;
    glGenVertexArrays(1, &a->array);
    glBindVertexArray(a->array);
    glGenBuffers(1, &a->vertices);
    glBindBuffer(GL_ARRAY_BUFFER, a->vertices);
    glBufferData(GL_ARRAY_BUFFER, sizeof vertices, vertices, GL_STATIC_DRAW);
    gl_attribute(0, 3, sizeof *vertices, 0, 0);
    gl_attribute(1, 3, sizeof *vertices, 3 * sizeof(float), 0);
    glGenBuffers(1, &a->instances);
    glBindBuffer(GL_ARRAY_BUFFER, a->instances);
    gl_attribute(2, 3, 6 * sizeof(float), 0, 1);
    gl_attribute(3, 3, 6 * sizeof(float), 3 * sizeof(float), 1);
    glBindVertexArray(0);
}

void arrows_free(arrows* a) {
    glDeleteProgram(a->program);
    glDeleteVertexArrays(1, &a->array);
    glDeleteBuffers(1, &a->vertices);
    glDeleteBuffers(1, &a->instances);
    memset(a, 0, sizeof *a);
}

void arrows_draw(const arrows* a, const scene* s, const pass* p, const camera* c) {
    /* The spacing is 1, 2 or 5 times a power of ten, and the lattice does not move with the camera. */
    const float wanted = c->distance / 6.0f, power = powf(10.0f, floorf(log10f(wanted))), part = wanted / power;
    const float spacing = power * (part < 2.0f ? 1.0f : part < 5.0f ? 2.0f : 5.0f);
    static float feet[lattice][3], winds[lattice][3], instances[lattice][6];
    const float x0 = (roundf(c->target.x / spacing) - across / 2) * spacing;
    const float z0 = (roundf(c->target.z / spacing) - across / 2) * spacing;
    int n = 0;
    for (int y = 0; y < layers; ++y)
        for (int k = 0; k < across; ++k)
            for (int i = 0; i < across; ++i, ++n) {
                const float x = x0 + (float)i * spacing, z = z0 + (float)k * spacing;
                const float floor = s->plan->water ? 0.0f : ground_height(s->plan->relief, s->plan->ground_level, x, z);
                to_array(v3(x, floor + ((float)y + 0.35f) * spacing, z), feet[n]);
            }
    check(lr_world_sample_wind(s->world, feet[0], lattice, winds[0]), "lr_world_sample_wind", NULL);
    for (int i = 0; i < lattice; ++i) {
        memcpy(instances[i], feet[i], sizeof feet[i]);
        memcpy(instances[i] + 3, winds[i], sizeof winds[i]);
    }
    pass_use(p, a->program);
    glUniform2f(uniform(a->program, "size"), 0.9f * spacing, 0.026f * spacing);
    glBindVertexArray(a->array);
    glBindBuffer(GL_ARRAY_BUFFER, a->instances);
    glBufferData(GL_ARRAY_BUFFER, sizeof instances, instances, GL_STREAM_DRAW);
    glDrawArraysInstanced(GL_TRIANGLES, 0, a->vertex_count, lattice);
    glBindVertexArray(0);
}
