/* Wavefront OBJ: v, vt, f. Computes normals, smooth over edges of less than 60 degrees.    SPDX-License-Identifier: MIT */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "failure.h"
#include "mesh.h"
#include "vectors.h"

typedef struct obj {
    vec3* points;
    float (*uvs)[2];
    uint32_t (*corners)[2]; /* of points, of uvs + 1 */
    uint32_t point_count, uv_count, corner_count;
    uint32_t point_room, uv_room, corner_room;
} obj;

static const char* const obj_remedy = "give a Wavefront OBJ in metres";

static void* room(void* memory, uint32_t count, uint32_t* capacity, size_t size) {
    if (count < *capacity) return memory;
    *capacity = *capacity ? 2 * *capacity : 1024;
    return grow(memory, *capacity, size);
}

static uint32_t resolve(long index, uint32_t count, const char* path, unsigned line) {
    if (index < 0) index += (long)count + 1;
    if (index < 1 || index > (long)count) fail(obj_remedy, "mesh %s, line %u: index out of range", path, line);
    return (uint32_t)index - 1;
}

static void add_corner(obj* o, const uint32_t corner[2]) {
    o->corners = room(o->corners, o->corner_count, &o->corner_room, sizeof *o->corners);
    memcpy(o->corners[o->corner_count++], corner, sizeof *o->corners);
}

static void read_face(obj* o, char* text, const char* path, unsigned line) {
    uint32_t polygon[3][2] = {{0}};
    int n = 0;
    for (char* word = strtok(text, " \t\r\n"); word; word = strtok(NULL, " \t\r\n")) {
        char* end = NULL;
        uint32_t corner[2] = {resolve(strtol(word, &end, 10), o->point_count, path, line), 0};
        if (*end == '/' && end[1] != '/') {
            const char* begin = end + 1;
            const long uv = strtol(begin, &end, 10);
            if (end != begin) corner[1] = resolve(uv, o->uv_count, path, line) + 1;
        }
        memcpy(polygon[n < 2 ? n : 2], corner, sizeof corner);
        if (++n < 3) continue;
        for (int k = 0; k < 3; ++k) add_corner(o, polygon[k]); /* a fan */
        memcpy(polygon[1], polygon[2], sizeof corner);
    }
    if (n < 3) fail(obj_remedy, "mesh %s, line %u: a face of %d corners", path, line, n);
}

static void read_numbers(const char* text, float* numbers, int count, const char* path, unsigned line) {
    for (int k = 0; k < count; ++k) {
        char* end = NULL;
        numbers[k] = strtof(text, &end);
        if (end == text || !isfinite(numbers[k])) fail(obj_remedy, "mesh %s, line %u: not a number", path, line);
        text = end;
    }
}

static obj read_obj(const char* path) {
    FILE* file = fopen(path, "r");
    if (!file) fail("check the path; the meshes of the samples are in assets/", "mesh %s: %s", path, strerror(errno));
    obj o = {0};
    char text[4096];
    unsigned line = 0;
    while (fgets(text, sizeof text, file)) {
        ++line;
        if (strncmp(text, "v ", 2) == 0) {
            float p[3];
            read_numbers(text + 2, p, 3, path, line);
            o.points = room(o.points, o.point_count, &o.point_room, sizeof *o.points);
            o.points[o.point_count++] = from_array(p);
        } else if (strncmp(text, "vt ", 3) == 0) {
            o.uvs = room(o.uvs, o.uv_count, &o.uv_room, sizeof *o.uvs);
            read_numbers(text + 3, o.uvs[o.uv_count++], 2, path, line);
        } else if (strncmp(text, "f ", 2) == 0) {
            read_face(&o, text + 2, path, line);
        }
    }
    const int broken = ferror(file);
    fclose(file);
    if (broken) fail(NULL, "mesh %s: cannot read all of it", path);
    if (o.corner_count == 0) fail(obj_remedy, "mesh %s has no faces", path);
    return o;
}

/* Faces around each point: a corner's normal is the mean of those that point in nearly the same direction. */
typedef struct around {
    uint32_t* first; /* index in `faces`, by point */
    uint32_t* faces;
} around;

static around faces_around(const obj* o) {
    around a = {allocate(o->point_count + 2, sizeof(uint32_t)), allocate(o->corner_count, sizeof(uint32_t))};
    for (uint32_t c = 0; c < o->corner_count; ++c) ++a.first[o->corners[c][0] + 2];
    for (uint32_t p = 2; p < o->point_count + 2; ++p) a.first[p] += a.first[p - 1];
    for (uint32_t c = 0; c < o->corner_count; ++c) a.faces[a.first[o->corners[c][0] + 1]++] = c / 3;
    return a;
}

body_mesh mesh_load_obj(const char* path, const lr_asset_info* info) {
    obj o = read_obj(path);
    const float centre[3] = {(float)info->center_of_mass[0], (float)info->center_of_mass[1],
                             (float)info->center_of_mass[2]};
    vec3* normals = allocate(o.corner_count / 3, sizeof(vec3)); /* of faces; their length is twice the area */
    for (uint32_t f = 0; f < o.corner_count / 3; ++f) {
        const vec3 a = o.points[o.corners[3 * f][0]], b = o.points[o.corners[3 * f + 1][0]],
                   c = o.points[o.corners[3 * f + 2][0]];
        normals[f] = cross(sub(b, a), sub(c, a));
    }
    around neighbours = faces_around(&o);
    /* A corner shares its vertex with earlier corners at the same point with the same normal and texture coordinates. */
    body_mesh m = {allocate(o.corner_count, sizeof(mesh_vertex)), allocate(o.corner_count, sizeof(uint32_t)), 0, 0};
    uint32_t* first = allocate(o.point_count, sizeof(uint32_t)); /* of a point: vertex + 1; `others` links the rest */
    uint32_t* others = allocate(o.corner_count, sizeof(uint32_t));
    for (uint32_t c = 0; c < o.corner_count; ++c) {
        const uint32_t p = o.corners[c][0];
        const vec3 own = unit(normals[c / 3]);
        vec3 sum = v3(0.0f, 0.0f, 0.0f);
        for (uint32_t k = neighbours.first[p]; k < neighbours.first[p + 1]; ++k) {
            const vec3 n = normals[neighbours.faces[k]];
            if (dot(unit(n), own) > 0.5f) sum = add(sum, n);
        }
        mesh_vertex v;
        to_array(sub(o.points[p], from_array(centre)), v.position);
        to_array(unit(sum), v.normal);
        v.uv[0] = o.corners[c][1] ? o.uvs[o.corners[c][1] - 1][0] : 0.5f;
        v.uv[1] = o.corners[c][1] ? o.uvs[o.corners[c][1] - 1][1] : 0.5f;
        uint32_t found = first[p];
        while (found && (dot(from_array(m.vertices[found - 1].normal), from_array(v.normal)) < 0.9999f ||
                         memcmp(m.vertices[found - 1].uv, v.uv, sizeof v.uv) != 0))
            found = others[found - 1];
        if (!found) {
            m.vertices[m.vertex_count++] = v;
            found = m.vertex_count;
            others[found - 1] = first[p];
            first[p] = found;
        }
        m.indices[m.index_count++] = found - 1;
    }
    free(o.points);
    free(o.uvs);
    free(o.corners);
    free(normals);
    free(neighbours.first);
    free(neighbours.faces);
    free(first);
    free(others);
    return m;
}
