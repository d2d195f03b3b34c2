/* The drawn mesh of a body: triangles with normals, in the body frame.    SPDX-License-Identifier: MIT */
#ifndef DRAWING_MESH_H
#define DRAWING_MESH_H

#include <langevin_rigid.h>

typedef struct mesh_vertex {
    float position[3]; /* m, from the centre of mass, body axes */
    float normal[3];
    float uv[2]; /* u along the long axis, v across it, 0.5 in the middle; equal scale */
} mesh_vertex;

typedef struct body_mesh {
    mesh_vertex* vertices;
    uint32_t* indices;
    uint32_t vertex_count, index_count;
} body_mesh;

/* Reads a Wavefront OBJ in metres and moves its origin to the asset's centre of mass. Fails with a message. */
body_mesh mesh_load_obj(const char* path, const lr_asset_info* info);

/* The ellipsoid with the asset's moments of inertia, for an asset without a mesh. */
body_mesh mesh_ellipsoid(const lr_asset_info* info);

/* Merges the vertices in each cell of a grid and drops the triangles that collapse. cell: m. */
body_mesh mesh_coarser(const body_mesh* from, float cell);

/* Largest distance of a vertex from the centre of mass, m. */
float mesh_radius(const body_mesh* m);

void mesh_free(body_mesh* m);

#endif
