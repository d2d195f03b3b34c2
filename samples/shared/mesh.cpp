// SPDX-License-Identifier: MIT
#include "mesh.h"

#include "drawing/failure.h"
#include "failure.h"

namespace {

Mesh copied(body_mesh from) {
    Mesh to{{from.vertices, from.vertices + from.vertex_count}, {from.indices, from.indices + from.index_count}};
    mesh_free(&from);
    return to;
}

} // namespace

body_mesh Mesh::view() const {
    return {const_cast<Vertex*>(vertices.data()), const_cast<std::uint32_t*>(indices.data()),
            static_cast<std::uint32_t>(vertices.size()), static_cast<std::uint32_t>(indices.size())};
}

float Mesh::radius() const {
    const body_mesh all = view();
    return mesh_radius(&all);
}

void throw_failures() {
    fail_hook = [](const char* remedy, const char* what) { throw Failure(what, remedy ? remedy : ""); };
}

Mesh load_mesh(const std::string& path, const lr_asset_info& info) {
    throw_failures();
    return copied(path.empty() ? mesh_ellipsoid(&info) : mesh_load_obj(path.c_str(), &info));
}
