/* SPDX-License-Identifier: MIT */
#include "solids.h"

#include "failure.h"
#include "vectors.h"

static void put(solid_list* list, const scene_solid* solid, vec3 own, vec3 normal) {
    const float q[4] = {0.0f, sinf(0.5f * solid->turn), 0.0f, cosf(0.5f * solid->turn)};
    solid_vertex* v = &list->vertices[list->count++];
    to_array(add(from_array(solid->at), turned(q, own)), v->position);
    to_array(turned(q, normal), v->normal);
    to_array(own, v->own);
    v->wood = solid->wood ? 1.0f : 0.0f;
}

static void add_box(solid_list* list, const scene_solid* solid) {
    list->vertices = grow(list->vertices, list->count + 36, sizeof *list->vertices);
    static const int corners[6][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};
    for (int axis = 0; axis < 3; ++axis) {
        for (int sign = -1; sign <= 1; sign += 2) {
            for (int c = 0; c < 6; ++c) {
                float at[3] = {0}, normal[3] = {0};
                normal[axis] = (float)sign;
                at[axis] = (float)sign * solid->size[axis];
                const int u = (axis + 1) % 3, v = (axis + 2) % 3;
                at[u] = (float)corners[c][0] * solid->size[u];
                at[v] = (float)corners[c][1] * solid->size[v];
                put(list, solid, from_array(at), from_array(normal));
            }
        }
    }
}

static void add_sphere(solid_list* list, const scene_solid* solid) {
    enum { around = 48, rings = 24 };
    list->vertices = grow(list->vertices, list->count + around * rings * 6, sizeof *list->vertices);
    static const int corners[6][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
    for (int ring = 0; ring < rings; ++ring) {
        for (int i = 0; i < around; ++i) {
            for (int c = 0; c < 6; ++c) {
                const float polar = PI * (float)(ring + corners[c][1]) / rings;
                const float turn = 2.0f * PI * (float)(i + corners[c][0]) / around;
                const vec3 normal = v3(sinf(polar) * cosf(turn), cosf(polar), sinf(polar) * sinf(turn));
                put(list, solid, scaled(normal, solid->size[0]), normal);
            }
        }
    }
}

void solids_add(solid_list* list, const scene_solid* solid) {
    if (solid->kind == LR_COLLIDER_BOX)
        add_box(list, solid);
    else
        add_sphere(list, solid);
}
