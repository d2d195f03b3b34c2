/* SPDX-License-Identifier: MIT */
#include "solids.h"

#include "failure.h"
#include "vectors.h"

static void put(solid_list* list, const ground_solid* s, vec3 own, vec3 normal) {
    const float q[4] = {0.0f, sinf(0.5f * s->turn), 0.0f, cosf(0.5f * s->turn)};
    solid_vertex* v = &list->vertices[list->count++];
    to_array(add(from_array(s->at), turned(q, own)), v->position);
    to_array(turned(q, normal), v->normal);
    to_array(own, v->own);
    v->look = (float)s->look;
}

static void add_box(solid_list* list, const ground_solid* s) {
    list->vertices = grow(list->vertices, list->count + 36, sizeof *list->vertices);
    static const int corners[6][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};
    for (int axis = 0; axis < 3; ++axis) {
        for (int sign = -1; sign <= 1; sign += 2) {
            for (int c = 0; c < 6; ++c) {
                float at[3] = {0}, normal[3] = {0};
                normal[axis] = (float)sign;
                at[axis] = (float)sign * s->size[axis];
                const int u = (axis + 1) % 3, v = (axis + 2) % 3;
                at[u] = (float)corners[c][0] * s->size[u];
                at[v] = (float)corners[c][1] * s->size[v];
                put(list, s, from_array(at), from_array(normal));
            }
        }
    }
}

/* A sphere, or a capsule: rings of its upper half are moved up, those of its lower half down. */
static void add_round(solid_list* list, const ground_solid* s) {
    enum { around = 48, rings = 24 };
    list->vertices = grow(list->vertices, list->count + around * rings * 6, sizeof *list->vertices);
    static const int corners[6][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
    for (int ring = 0; ring < rings; ++ring) {
        for (int i = 0; i < around; ++i) {
            for (int c = 0; c < 6; ++c) {
                const float polar = PI * (float)(ring + corners[c][1]) / rings;
                const float turn = 2.0f * PI * (float)(i + corners[c][0]) / around;
                const vec3 normal = v3(sinf(polar) * cosf(turn), cosf(polar), sinf(polar) * sinf(turn));
                vec3 own = scaled(normal, s->size[0]);
                if (s->kind == LR_COLLIDER_CAPSULE) own.y += ring < rings / 2 ? s->size[1] : -s->size[1];
                put(list, s, own, normal);
            }
        }
    }
}

/* The side of a capsule, between its halves. */
static void add_side(solid_list* list, const ground_solid* s) {
    enum { around = 48 };
    list->vertices = grow(list->vertices, list->count + around * 6, sizeof *list->vertices);
    static const int corners[6][2] = {{0, 1}, {1, 1}, {1, -1}, {0, 1}, {1, -1}, {0, -1}};
    for (int i = 0; i < around; ++i) {
        for (int c = 0; c < 6; ++c) {
            const float turn = 2.0f * PI * (float)(i + corners[c][0]) / around;
            const vec3 normal = v3(cosf(turn), 0.0f, sinf(turn));
            put(list, s, add(scaled(normal, s->size[0]), v3(0.0f, (float)corners[c][1] * s->size[1], 0.0f)), normal);
        }
    }
}

/* A face of the hull has all other points on one side. */
static void add_hull(solid_list* list, const ground_solid* s) {
    for (uint32_t i = 0; i < s->point_count; ++i) {
        for (uint32_t j = 0; j < s->point_count; ++j) {
            for (uint32_t k = i + 1; k < s->point_count; ++k) {
                if (j <= i || j == k) continue;
                const vec3 a = from_array(s->points + 3 * i), b = from_array(s->points + 3 * j),
                           c = from_array(s->points + 3 * k), n = unit(cross(sub(b, a), sub(c, a)));
                uint32_t p = 0;
                while (p < s->point_count && dot(n, sub(from_array(s->points + 3 * p), a)) < 1e-5f) ++p;
                if (p < s->point_count) continue;
                list->vertices = grow(list->vertices, list->count + 3, sizeof *list->vertices);
                put(list, s, a, n), put(list, s, b, n), put(list, s, c, n);
            }
        }
    }
}

void solids_add(solid_list* list, const ground_solid* s) {
    if (s->kind == LR_COLLIDER_BOX) add_box(list, s);
    if (s->kind == LR_COLLIDER_HULL) add_hull(list, s);
    if (s->kind == LR_COLLIDER_SPHERE || s->kind == LR_COLLIDER_CAPSULE) add_round(list, s);
    if (s->kind == LR_COLLIDER_CAPSULE) add_side(list, s);
}
