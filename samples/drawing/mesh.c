/* SPDX-License-Identifier: MIT */
#include "mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "failure.h"
#include "vectors.h"

static const uint32_t no_index = UINT32_MAX;

float mesh_radius(const body_mesh* m) {
    float most = 0.0f;
    for (uint32_t i = 0; i < m->vertex_count; ++i) most = fmaxf(most, length(from_array(m->vertices[i].position)));
    return most;
}

void mesh_free(body_mesh* m) {
    free(m->vertices);
    free(m->indices);
    memset(m, 0, sizeof *m);
}

body_mesh mesh_ellipsoid(const lr_asset_info* info) {
    /* Semi-axes from the moments: I_x = m (b^2 + c^2) / 5, and cyclically. */
    const double half_trace = 0.5 * (info->inertia[0] + info->inertia[4] + info->inertia[8]);
    float axes[3];
    for (int k = 0; k < 3; ++k) {
        const double squared = 5.0 * (half_trace - info->inertia[4 * k]) / info->mass;
        axes[k] = squared > 0.0 ? (float)sqrt(squared) : 0.0f;
    }
    const float thick = 0.002f * fmaxf(axes[0], fmaxf(axes[1], axes[2]));
    for (int k = 0; k < 3; ++k) axes[k] = fmaxf(axes[k], thick); /* normals need some thickness */
    const int thin = axes[0] < axes[1] && axes[0] < axes[2] ? 0 : axes[1] < axes[2] ? 1 : 2;
    const int u = axes[(thin + 1) % 3] >= axes[(thin + 2) % 3] ? (thin + 1) % 3 : (thin + 2) % 3, v = 3 - thin - u;
    enum { around = 32, rings = 16 };
    body_mesh m = {allocate((around + 1) * (rings + 1), sizeof(mesh_vertex)),
                   allocate(around * rings * 6, sizeof(uint32_t)), 0, 0};
    for (int ring = 0; ring <= rings; ++ring) {
        for (int i = 0; i <= around; ++i) {
            const float polar = PI * (float)ring / rings, turn = 2.0f * PI * (float)i / around;
            const float unit_at[3] = {sinf(polar) * cosf(turn), sinf(polar) * sinf(turn), cosf(polar)};
            mesh_vertex* p = &m.vertices[m.vertex_count++];
            const int axis_of[3] = {u, v, thin};
            for (int k = 0; k < 3; ++k) {
                p->position[axis_of[k]] = unit_at[k] * axes[axis_of[k]];
                p->normal[axis_of[k]] = unit_at[k] / axes[axis_of[k]];
            }
            to_array(unit(from_array(p->normal)), p->normal);
            p->uv[0] = 0.5f + 0.5f * unit_at[0];
            p->uv[1] = 0.5f + 0.5f * unit_at[1] * axes[v] / axes[u];
            if (ring == rings || i == around) continue;
            const uint32_t a = m.vertex_count - 1, b = a + 1, c = a + around + 1, d = c + 1;
            const uint32_t corners[6] = {a, c, b, b, c, d};
            memcpy(m.indices + m.index_count, corners, sizeof corners);
            m.index_count += 6;
        }
    }
    return m;
}

/* An open-addressing hash table from cells to vertices. */
typedef struct cell_table {
    uint32_t* slots;
    uint32_t mask;
} cell_table;

static uint32_t* find_cell(const cell_table* table, const long (*keys)[3], const long key[3]) {
    const uint64_t mixed_key = (uint64_t)key[0] * 0x9e3779b97f4a7c15u ^ (uint64_t)key[1] * 0xc2b2ae3d27d4eb4fu ^
                               (uint64_t)key[2] * 0x165667b19e3779f9u;
    uint32_t place = (uint32_t)(mixed_key >> 20) & table->mask;
    while (table->slots[place] != no_index && memcmp(keys[table->slots[place]], key, sizeof(long[3])) != 0)
        place = (place + 1) & table->mask;
    return &table->slots[place];
}

static int same_triangle_before(const uint32_t* indices, const uint32_t* first_use, const uint32_t* next,
                                const uint32_t face[3]) {

    for (uint32_t t = first_use[face[0]]; t != no_index; t = next[t]) {
        int shared = 0;
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k) shared += indices[3 * (t / 3) + (uint32_t)i] == face[k];
        if (shared == 3) return 1;
    }
    return 0;
}

body_mesh mesh_coarser(const body_mesh* from, float cell) {
    cell_table table = {NULL, 1};
    while (table.mask < 2 * from->vertex_count) table.mask *= 2;
    table.slots = allocate(table.mask, sizeof(uint32_t));
    memset(table.slots, 0xff, table.mask * sizeof(uint32_t));
    table.mask -= 1;
    long(*keys)[3] = allocate(from->vertex_count, sizeof *keys);
    uint32_t* moved = allocate(from->vertex_count, sizeof(uint32_t));
    body_mesh m = {allocate(from->vertex_count, sizeof(mesh_vertex)), allocate(from->index_count, sizeof(uint32_t)), 0,
                   0};
    for (uint32_t i = 0; i < from->vertex_count; ++i) {
        const mesh_vertex* v = &from->vertices[i];
        const long key[3] = {lroundf(v->position[0] / cell), lroundf(v->position[1] / cell),
                             lroundf(v->position[2] / cell)};
        uint32_t* slot = find_cell(&table, (const long(*)[3])keys, key);
        if (*slot == no_index) {
            *slot = m.vertex_count;
            memcpy(keys[m.vertex_count], key, sizeof key);
            m.vertices[m.vertex_count++] = *v;
        } else if (length(from_array(v->position)) > length(from_array(m.vertices[*slot].position))) {
            m.vertices[*slot] = *v; /* the farthest vertex: a mean would shrink the outline */
        }
        moved[i] = *slot;
    }
    /* Top and bottom of a sheet coincide: keep one. */
    uint32_t* first_use = allocate(m.vertex_count, sizeof(uint32_t));
    uint32_t* next = allocate(from->index_count, sizeof(uint32_t));
    memset(first_use, 0xff, m.vertex_count * sizeof(uint32_t));
    for (uint32_t i = 0; i + 2 < from->index_count; i += 3) {
        const uint32_t face[3] = {moved[from->indices[i]], moved[from->indices[i + 1]], moved[from->indices[i + 2]]};
        if (face[0] == face[1] || face[1] == face[2] || face[0] == face[2]) continue;
        if (same_triangle_before(m.indices, first_use, next, face)) continue;
        for (int k = 0; k < 3; ++k) {
            const uint32_t corner = m.index_count++;
            m.indices[corner] = face[k];
            next[corner] = first_use[face[k]];
            first_use[face[k]] = corner;
        }
    }
    free(table.slots);
    free(keys);
    free(moved);
    free(first_use);
    free(next);
    return m;
}
