/* SPDX-License-Identifier: MIT */
#include "bodies.h"

#include <stdlib.h>
#include <string.h>

#include "failure.h"
#include "shaders.h"
#include "shadow.h"

/* Sizes in pixels, or texels of the shadow map, below which the next coarser mesh is drawn. */
static const float level_below[body_levels - 1] = {40.0f, 10.0f};
static const float level_cell[body_levels] = {0.0f, 0.16f, 0.5f}; /* of the coarser meshes, relative to the radius */

static void create_level(body_level* level, const body_mesh* m, GLuint picked) {
    level->index_count = (GLsizei)m->index_count;
    glGenVertexArrays(1, &level->array);
    glBindVertexArray(level->array);
    glGenBuffers(1, &level->vertices);
    glBindBuffer(GL_ARRAY_BUFFER, level->vertices);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(m->vertex_count * sizeof(mesh_vertex)), m->vertices, GL_STATIC_DRAW);
    gl_attribute(0, 3, sizeof(mesh_vertex), offsetof(mesh_vertex, position), 0);
    gl_attribute(1, 3, sizeof(mesh_vertex), offsetof(mesh_vertex, normal), 0);
    gl_attribute(2, 2, sizeof(mesh_vertex), offsetof(mesh_vertex, uv), 0);
    glBindBuffer(GL_ARRAY_BUFFER, picked);
    glEnableVertexAttribArray(3);
    glVertexAttribIPointer(3, 2, GL_UNSIGNED_INT, 2 * sizeof(uint32_t), NULL);
    glVertexAttribDivisor(3, 1);
    glGenBuffers(1, &level->indices);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, level->indices);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(m->index_count * sizeof(uint32_t)), m->indices, GL_STATIC_DRAW);
    glBindVertexArray(0);
}

static void create_batch(body_batch* d, const body_mesh* fine, GLuint picked) {
    d->radius = mesh_radius(fine);
    if (!(d->radius > 0.0f)) fail("give another --mesh", "a mesh to draw has no size");
    for (int k = 0; k < body_levels; ++k) {
        body_mesh coarse = {0};
        if (k > 0) coarse = mesh_coarser(fine, level_cell[k] * d->radius);
        create_level(&d->levels[k], coarse.index_count ? &coarse : fine, picked);
        mesh_free(&coarse);
    }
    glGenBuffers(1, &d->transforms);
    glGenTextures(1, &d->texture);
}

void bodies_create(bodies* b, const sunshine* l, const drawn_batch* drawn, int count) {
    memset(b, 0, sizeof *b);
    b->program = pass_program(l, "body", shader_body_vert, shader_body_frag);
    b->shadow_program = pass_program(l, "body's shadow", shader_body_vert, shader_nothing_frag);
    glGenBuffers(1, &b->picked);
    b->batches = allocate((size_t)count, sizeof *b->batches);
    b->batch_count = count;
    for (int k = 0; k < count; ++k) create_batch(&b->batches[k], drawn[k].mesh, b->picked);
}

void bodies_free(bodies* b) {
    for (int k = 0; k < b->batch_count; ++k) {
        body_batch* d = &b->batches[k];
        for (int i = 0; i < body_levels; ++i) {
            glDeleteVertexArrays(1, &d->levels[i].array);
            glDeleteBuffers(1, &d->levels[i].vertices);
            glDeleteBuffers(1, &d->levels[i].indices);
        }
        glDeleteBuffers(1, &d->transforms);
        glDeleteTextures(1, &d->texture);
        free(d->rows);
    }
    glDeleteBuffers(1, &b->picked);
    glDeleteProgram(b->program);
    glDeleteProgram(b->shadow_program);
    free(b->list);
    free(b->batches);
    memset(b, 0, sizeof *b);
}

static lr_batch_view view_of(const lr_world* world, lr_batch batch) {
    lr_batch_view view;
    check(lr_batch_view_init(&view, sizeof view), "lr_batch_view_init", NULL);
    check(lr_batch_get_view(world, batch, &view), "view", NULL);
    return view;
}

static void reserve(body_batch* d, uint32_t capacity) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    if (capacity > (uint32_t)most / 3)
        fail("try a smaller --count", "OpenGL (%s) can draw %d bodies of one asset at most", gl_name(), most / 3);
    d->rows = grow(d->rows, capacity, sizeof *d->rows);
    d->capacity = capacity;
    glBindBuffer(GL_TEXTURE_BUFFER, d->transforms);
    glBufferData(GL_TEXTURE_BUFFER, (GLsizeiptr)(capacity * sizeof *d->rows), NULL, GL_STREAM_DRAW);
    glBindTexture(GL_TEXTURE_BUFFER, d->texture);
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, d->transforms);
}

void bodies_update(bodies* b, const lr_world* world, const drawn_batch* drawn) {
    for (int k = 0; k < b->batch_count; ++k) {
        body_batch* d = &b->batches[k];
        const lr_batch batch = drawn[k].batch;
        const lr_batch_view view = view_of(world, batch);
        uint32_t count = view.count; /* docs/reference/bodies.md: bodies still asleep keep their places */
        if (d->batch.id == batch.id && d->revision == view.revision && d->written == view.count)
            count = d->moved > view.awake_count ? d->moved : view.awake_count;
        if (view.count > d->capacity || !d->rows) reserve(d, view.capacity), count = view.count;
        check(lr_batch_write_transforms(world, batch, LR_TRANSFORM_3X4_ROW_MAJOR, d->rows, 0, count, NULL),
              "transforms", NULL);
        glBindBuffer(GL_TEXTURE_BUFFER, d->transforms);
        glBufferSubData(GL_TEXTURE_BUFFER, 0, (GLsizeiptr)(count * sizeof *d->rows), d->rows);
        d->batch = batch, d->revision = view.revision, d->moved = view.awake_count, d->written = view.count;
    }
}

static void draw_list(const bodies* b, const body_level* level, uint32_t count) {
    if (count == 0) return;
    glBindVertexArray(level->array);
    glBindBuffer(GL_ARRAY_BUFFER, b->picked);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(count * sizeof *b->list), b->list, GL_STREAM_DRAW);
    glDrawElementsInstanced(GL_TRIANGLES, level->index_count, GL_UNSIGNED_INT, NULL, (GLsizei)count);
}

static int level_of(float pixels) {
    int level = 0;
    while (level + 1 < body_levels && pixels < level_below[level]) ++level;
    return level;
}

/* pixels_a_metre: at distance 1 for the picture; negative for the shadow map, where it holds at any distance. */
static void draw_batches(bodies* b, const lr_world* world, const drawn_batch* drawn, const pass* p,
                         float pixels_a_metre, GLuint program) {
    for (int k = 0; k < b->batch_count; ++k) {
        const body_batch* d = &b->batches[k];
        const lr_batch_view view = view_of(world, d->batch);
        if (view.count > b->room) b->list = grow(b->list, b->room = view.capacity, sizeof *b->list);
        glUniform1i(uniform(program, "look"), (GLint)drawn[k].look);
        glActiveTexture(GL_TEXTURE2);
        glBindTexture(GL_TEXTURE_BUFFER, d->texture);
        for (int level = 0; level < body_levels; ++level) {
            uint32_t count = 0;
            for (uint32_t i = 0; i < view.count; ++i) {
                const vec3 at = v3(view.position[0][i], view.position[1][i], view.position[2][i]);
                const float radius = d->radius * view.scale[i];
                float pixels;
                if (pixels_a_metre < 0.0f) {
                    if (!shadow_holds(p, at, radius)) continue;
                    pixels = -2.0f * radius * pixels_a_metre;
                } else {
                    const float depth = camera_depth(&p->view, at, radius);
                    if (depth < 0.0f) continue;
                    pixels = 2.0f * radius * pixels_a_metre / depth;
                }
                if (level_of(pixels) != level) continue;
                b->list[count][0] = i;
                b->list[count++][1] = view.noise_seed[i];
            }
            draw_list(b, &d->levels[level], count);
        }
    }
    glBindVertexArray(0);
}

void bodies_draw_shadow(bodies* b, const lr_world* world, const drawn_batch* drawn, const pass* p) {
    pass_use_for_shadow(p, b->shadow_program);
    draw_batches(b, world, drawn, p, -1.0f / p->texel, b->shadow_program);
}

void bodies_draw(bodies* b, const lr_world* world, const drawn_batch* drawn, const pass* p, int picture_height) {
    pass_use(p, b->program);
    draw_batches(b, world, drawn, p, (float)picture_height / (2.0f * p->view.tan_half), b->program);
}
