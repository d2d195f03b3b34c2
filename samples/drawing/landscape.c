/* SPDX-License-Identifier: MIT */
#include "landscape.h"

#include <stdlib.h>
#include <string.h>

#include "failure.h"
#include "shaders.h"
#include "solids.h"

static const float far_away = 400.0f; /* m: the ground ends in haze */

/* The samples, and a rim of four corners far away around them. */
static void create_ground(landscape* l, const ground_shape* shape) {
    const uint32_t ground_side = (uint32_t)shape->side, inner = ground_side * ground_side,
                   cells = (ground_side - 1) * (ground_side - 1);
    float(*vertices)[6] = allocate(inner + 4, sizeof *vertices);
    uint32_t* indices = allocate(6 * cells + 24, sizeof(uint32_t));
    const float half = 0.5f * shape->cell * (float)(ground_side - 1);
    for (uint32_t k = 0; k < ground_side; ++k) {
        for (uint32_t i = 0; i < ground_side; ++i) {
            const uint32_t left = i > 0 ? i - 1 : 0, right = i + 1 < ground_side ? i + 1 : i,
                           before = k > 0 ? k - 1 : 0, behind = k + 1 < ground_side ? k + 1 : k;
            const float* row = shape->heights + k * ground_side;
            float* v = vertices[k * ground_side + i];
            to_array(v3((float)i * shape->cell - half, row[i], (float)k * shape->cell - half), v);
            to_array(unit(v3(row[left] - row[right], 2.0f * shape->cell,
                             shape->heights[before * ground_side + i] - shape->heights[behind * ground_side + i])),
                     v + 3);
        }
    }
    GLsizei n = 0;
    for (uint32_t k = 0; k + 1 < ground_side; ++k) {
        for (uint32_t i = 0; i + 1 < ground_side; ++i) { /* split like the collider's cells */
            const uint32_t a = k * ground_side + i, b = a + 1, c = a + ground_side, d = c + 1;
            const uint32_t corners[6] = {a, d, b, a, c, d};
            memcpy(indices + n, corners, sizeof corners);
            n += 6;
        }
    }
    static const float sign[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const uint32_t corner[4] = {0, ground_side - 1, inner - 1, inner - ground_side};
    for (uint32_t c = 0; c < 4; ++c) {
        to_array(v3(sign[c][0] * far_away, shape->level, sign[c][1] * far_away), vertices[inner + c]);
        vertices[inner + c][4] = 1.0f;
        const uint32_t next = (c + 1) % 4;
        const uint32_t side[6] = {corner[c], inner + next, inner + c, corner[c], corner[next], inner + next};
        memcpy(indices + n, side, sizeof side);
        n += 6;
    }
    l->ground_count = n;
    glGenVertexArrays(1, &l->ground_array);
    glBindVertexArray(l->ground_array);
    glGenBuffers(1, &l->ground_vertices);
    glBindBuffer(GL_ARRAY_BUFFER, l->ground_vertices);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)((inner + 4) * sizeof *vertices), vertices, GL_STATIC_DRAW);
    gl_attribute(0, 3, sizeof *vertices, 0, 0);
    gl_attribute(1, 3, sizeof *vertices, 3 * sizeof(float), 0);
    glGenBuffers(1, &l->ground_indices);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, l->ground_indices);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)((size_t)n * sizeof(uint32_t)), indices, GL_STATIC_DRAW);
    glBindVertexArray(0);
    free(vertices);
    free(indices);
}

void landscape_place(landscape* l, const ground_solid* solids, int count) {
    solid_list list = {NULL, 0};
    for (int i = 0; i < count; ++i) solids_add(&list, &solids[i]);
    l->solid_count = (GLsizei)list.count;
    glBindVertexArray(l->solid_array);
    glBindBuffer(GL_ARRAY_BUFFER, l->solid_vertices);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(list.count * sizeof *list.vertices), list.vertices, GL_STREAM_DRAW);
    gl_attribute(0, 3, sizeof *list.vertices, offsetof(solid_vertex, position), 0);
    gl_attribute(1, 3, sizeof *list.vertices, offsetof(solid_vertex, normal), 0);
    gl_attribute(2, 3, sizeof *list.vertices, offsetof(solid_vertex, own), 0);
    gl_attribute(3, 1, sizeof *list.vertices, offsetof(solid_vertex, look), 0);
    glBindVertexArray(0);
    free(list.vertices);
}

void landscape_create(landscape* l, const sunshine* day, const ground_shape* shape) {
    memset(l, 0, sizeof *l);
    l->ground_program = pass_program(day, "ground", shader_ground_vert, shader_ground_frag);
    l->solid_program = pass_program(day, "solids", shader_solid_vert, shader_solid_frag);
    l->solid_shadow_program = pass_program(day, "solids' shadow", shader_solid_vert, shader_nothing_frag);
    l->water_program = pass_program(day, "water", shader_water_vert, shader_water_frag);
    l->sky_program = pass_program(day, "sky", shader_sky_vert, day->sky);
    glGenVertexArrays(1, &l->solid_array);
    glGenBuffers(1, &l->solid_vertices);
    if (shape->side > 0) create_ground(l, shape);
}

void landscape_free(landscape* l) {
    const GLuint programs[5] = {l->ground_program, l->solid_program, l->solid_shadow_program, l->water_program,
                                l->sky_program};
    for (int i = 0; i < 5; ++i) glDeleteProgram(programs[i]);
    const GLuint buffers[3] = {l->ground_vertices, l->ground_indices, l->solid_vertices};
    glDeleteBuffers(3, buffers);
    glDeleteVertexArrays(1, &l->ground_array);
    glDeleteVertexArrays(1, &l->solid_array);
    memset(l, 0, sizeof *l);
}

void landscape_draw_shadow(const landscape* l, const pass* p) {
    pass_use_for_shadow(p, l->solid_shadow_program);
    glBindVertexArray(l->solid_array);
    glDrawArrays(GL_TRIANGLES, 0, l->solid_count);
    glBindVertexArray(0);
}

static void draw_sky(const landscape* l, const pass* p) {
    pass_use(p, l->sky_program);
    const vec3 right = scaled(p->view.right, p->view.tan_half * p->view.aspect),
               up = scaled(p->view.up, p->view.tan_half);
    const float corners[9] = {right.x, right.y,         right.z,         up.x,           up.y,
                              up.z,    -p->view.back.x, -p->view.back.y, -p->view.back.z};
    glUniformMatrix3fv(uniform(l->sky_program, "corners"), 1, GL_FALSE, corners);
    glDepthFunc(GL_LEQUAL);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void landscape_draw(const landscape* l, enum ground_look look, const pass* p) {
    pass_use(p, l->ground_program);
    glUniform1i(uniform(l->ground_program, "surface"), (GLint)look);
    glBindVertexArray(l->ground_array);
    if (l->ground_count > 0) glDrawElements(GL_TRIANGLES, l->ground_count, GL_UNSIGNED_INT, NULL);
    pass_use(p, l->solid_program);
    glBindVertexArray(l->solid_array);
    glDrawArrays(GL_TRIANGLES, 0, l->solid_count);
    draw_sky(l, p);
    glBindVertexArray(0);
}

void landscape_draw_water(const landscape* l, const lr_wave drawn[water_waves], const pass* p, double time) {
    pass_use(p, l->water_program);
    float waves[water_waves][4]; /* in the form of docs/reference/wind_and_water.md */
    for (int i = 0; i < water_waves; ++i) {
        const lr_wave* w = &drawn[i];
        const double number = 2.0 * 3.14159265358979 / (double)w->length, frequency = sqrt(9.81 * number);
        const double flat = hypot((double)w->direction[0], (double)w->direction[2]);
        waves[i][0] = (float)(number * (double)w->direction[0] / flat);
        waves[i][1] = (float)(number * (double)w->direction[2] / flat);
        waves[i][2] = (float)fmod((double)w->phase - frequency * time, 2.0 * 3.14159265358979);
        waves[i][3] = w->amplitude;
    }
    glUniform4fv(uniform(l->water_program, "waves"), water_waves, waves[0]);
    glUniform1f(uniform(l->water_program, "time"), (float)fmod(time, 1000.0));
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glBindVertexArray(l->ground_array);
    glDrawElements(GL_TRIANGLES, l->ground_count, GL_UNSIGNED_INT, NULL);
    glBindVertexArray(0);
    glDisable(GL_BLEND);
}
