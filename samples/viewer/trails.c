/* SPDX-License-Identifier: MIT */
#include "trails.h"

#include <stdlib.h>
#include <string.h>

#include "drawing/failure.h"
#include "drawing/shaders.h"

static const double interval = 1.0 / 60.0; /* s of the world between samples */
static const float jump = 0.6f;            /* m: a body that moves farther between samples has respawned */

void trails_create(trails* t) {
    memset(t, 0, sizeof *t);
    t->program = pass_program(&light_day, "trails", shader_mark_vert, shader_mark_frag);
    glGenVertexArrays(1, &t->array);
    glBindVertexArray(t->array);
    glGenBuffers(1, &t->vertices);
    glBindBuffer(GL_ARRAY_BUFFER, t->vertices);
    const size_t stride = 10 * sizeof(float);
    gl_attribute(0, 3, stride, 0, 0);
    gl_attribute(1, 3, stride, 3 * sizeof(float), 0);
    gl_attribute(2, 4, stride, 6 * sizeof(float), 0);
    glBindVertexArray(0);
}

void trails_free(trails* t) {
    glDeleteProgram(t->program);
    glDeleteVertexArrays(1, &t->array);
    glDeleteBuffers(1, &t->vertices);
    memset(t, 0, sizeof *t);
}

void trails_clear(trails* t) {
    memset(t->list, 0, sizeof t->list);
    t->picked = 0;
    t->last = 0.0;
}

void trails_rename(trails* t, const scene* s) {
    for (int k = 0; k < trail_number; ++k)
        if (t->list[k].body.id) t->list[k].body = scene_renamed(s, t->list[k].body);
}

/* Half of the batch's extent along body y, times the body's scale. */
static float half_width_of(const scene* s, lr_body body, float scale) {
    for (int k = 0; k < s->batch_count; ++k) {
        lr_batch_view view;
        check(lr_batch_view_init(&view, sizeof view), "lr_batch_view_init", NULL);
        check(lr_batch_get_view(s->world, s->batches[k].batch, &view), "view", NULL);
        for (uint32_t i = 0; i < view.count; ++i) {
            if (view.ids[i].id != body.id) continue;
            float most = 0.0f;
            const body_mesh* m = &s->batches[k].mesh;
            for (uint32_t v = 0; v < m->vertex_count; ++v) most = fmaxf(most, fabsf(m->vertices[v].position[1]));
            return 0.8f * most * scale;
        }
    }
    return 0.01f;
}

/* Picks a body that is high and moves. It skips a number of bodies each time, so that trails come from everywhere. */
static lr_body pick(trails* t, const scene* s) {
    for (int tries = 0; tries < 24; ++tries) {
        const uint32_t turn = t->picked++;
        lr_batch_view view;
        check(lr_batch_view_init(&view, sizeof view), "lr_batch_view_init", NULL);
        check(lr_batch_get_view(s->world, s->batches[turn % (uint32_t)s->batch_count].batch, &view), "view", NULL);
        if (view.awake_count == 0) continue;
        const uint32_t i = (uint32_t)((uint64_t)(turn + 1) * 2654435761u % view.awake_count);
        const float height = view.position[1][i], from_middle = hypotf(view.position[0][i], view.position[2][i]);
        if (height < 0.35f * s->plan->kinds[0].at[1] || from_middle > 0.6f * s->plan->camera.distance) continue;
        int taken = 0;
        for (int k = 0; k < trail_number; ++k) taken |= t->list[k].body.id == view.ids[i].id;
        if (!taken) return view.ids[i];
    }
    return (lr_body){0};
}

static void extend(trail* t, const lr_body_state* state) {
    const vec3 at = from_array(state->position);
    const trail_point* last = t->count ? &t->points[(t->first + t->count - 1) % trail_points] : NULL;
    if (last && length(sub(at, last->at)) > jump) t->count = 0, last = NULL;
    trail_point p = {at, scaled(turned(state->orientation, v3(0.0f, 1.0f, 0.0f)), t->half_width)};
    if (t->count < trail_points)
        ++t->count;
    else
        t->first = (t->first + 1) % trail_points;
    t->points[(t->first + t->count - 1) % trail_points] = p;
}

static void follow(trail* t, const scene* s, lr_body body) {
    memset(t, 0, sizeof *t);
    lr_body_state state;
    check(lr_body_state_init(&state, sizeof state), "lr_body_state_init", NULL);
    if (!body.id) return;
    check(lr_body_get_state(s->world, body, &state), "state", NULL);
    t->body = body;
    t->half_width = half_width_of(s, body, state.scale);
}

void trails_sample(trails* t, const scene* s, lr_body followed) {
    if (t->list[0].body.id != followed.id) follow(&t->list[0], s, followed);
    const double time = scene_look(s, 0).time;
    if (time - t->last < interval * 0.999 && time > t->last) return;
    t->last = time;
    for (int k = 0; k < trail_number; ++k) {
        trail* one = &t->list[k];
        /* After two seconds of lying, another body is followed. */
        if (k > 0 && (!one->body.id || one->resting > 120)) follow(one, s, pick(t, s));
        lr_body_state state;
        check(lr_body_state_init(&state, sizeof state), "lr_body_state_init", NULL);
        if (!one->body.id) continue;
        check(lr_body_get_state(s->world, one->body, &state), "state", NULL);
        one->resting = state.sleep_state == LR_SLEEP_ASLEEP ? one->resting + 1 : 0;
        if (!one->resting) extend(one, &state);
    }
}

static void put(float* v, vec3 at, vec3 normal, vec3 colour, float alpha) {
    to_array(at, v);
    to_array(normal, v + 3);
    to_array(colour, v + 6);
    v[9] = alpha;
}

static vec3 colour_of(int k) {
    if (k == 0) return v3(1.0f, 0.78f, 0.10f);
    const float turn = 2.0f * PI * (0.52f + 0.31f * (float)(k % 4) / 3.0f);
    return v3(0.55f + 0.40f * cosf(turn), 0.60f + 0.30f * cosf(turn - 2.1f), 0.60f + 0.40f * cosf(turn - 4.2f));
}

void trails_draw(const trails* t, const pass* p, int all) {
    static float vertices[2 * trail_points][10];
    pass_use(p, t->program);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    glBindVertexArray(t->array);
    glBindBuffer(GL_ARRAY_BUFFER, t->vertices);
    for (int k = 0; k < (all ? trail_number : 1); ++k) {
        const trail* one = &t->list[k];
        if (one->count < 3) continue;
        for (uint32_t i = 0; i < one->count; ++i) {
            const trail_point* here = &one->points[(one->first + i) % trail_points];
            const trail_point* before = &one->points[(one->first + (i ? i - 1 : 0)) % trail_points];
            const trail_point* after = &one->points[(one->first + (i + 1 < one->count ? i + 1 : i)) % trail_points];
            const vec3 along = sub(after->at, before->at), sum = cross(along, here->across);
            const vec3 normal = length(sum) > 0.0f ? unit(sum) : v3(0.0f, 1.0f, 0.0f);
            const float youth = (float)(i + trail_points - one->count) / trail_points, alpha = 0.62f * youth;
            put(vertices[2 * i], add(here->at, here->across), normal, colour_of(k), alpha);
            put(vertices[2 * i + 1], sub(here->at, here->across), normal, colour_of(k), alpha);
        }
        glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(2 * one->count * sizeof *vertices), vertices, GL_STREAM_DRAW);
        glDrawArrays(GL_TRIANGLE_STRIP, 0, (GLsizei)(2 * one->count));
    }
    glBindVertexArray(0);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}
