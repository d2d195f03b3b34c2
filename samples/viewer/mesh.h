/* The drawn mesh of a body: triangles with normals, in the body frame.    SPDX-License-Identifier: MIT */
#ifndef VIEWER_MESH_H
#define VIEWER_MESH_H

#include <langevin_rigid.h>

typedef struct vertex {
    float position[3]; /* m, from the centre of mass, body axes */
    float normal[3];
    float uv[2]; /* u along the long axis, v across it, 0.5 in the middle; equal scale */
} vertex;

typedef struct mesh {
    vertex* vertices;
    uint32_t* indices;
    uint32_t vertex_count, index_count;
} mesh;

/* Reads a Wavefront OBJ in metres and moves its origin to the asset's centre of mass. Fails with a message. */
mesh mesh_load_obj(const char* path, const lr_asset_info* info);

/* The ellipsoid with the asset's moments of inertia, for an asset without a mesh. */
mesh mesh_ellipsoid(const lr_asset_info* info);

/* Merges the vertices in each cell of a grid and drops the triangles that collapse. cell: m. */
mesh mesh_coarser(const mesh* from, float cell);

/* Largest distance of a vertex from the centre of mass, m. */
float mesh_radius(const mesh* m);

void mesh_free(mesh* m);

#endif
