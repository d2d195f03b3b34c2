// Descs of colliders.
#pragma once

#include "support/box_corners.h"
#include "support/random.h"
#include "support/scene.h"

#include <vector>

namespace test {

inline lr_collider_desc collider_desc(int32_t kind) {
    lr_collider_desc d = initialised(lr_collider_desc_init);
    d.kind = kind;
    return d;
}
inline lr_collider_desc sphere_collider(float radius) {
    lr_collider_desc d = collider_desc(LR_COLLIDER_SPHERE);
    d.size[0] = radius;
    return d;
}
inline lr_collider_desc box_collider(float x, float y, float z) {
    lr_collider_desc d = collider_desc(LR_COLLIDER_BOX);
    d.size[0] = x, d.size[1] = y, d.size[2] = z;
    return d;
}

inline lr_collider add_collider(const World& w, const lr_collider_desc& d) {
    lr_collider collider{};
    REQUIRE(lr_collider_create(w.get(), &d, 1, &collider) == LR_OK);
    return collider;
}
inline lr_collider_state state_of_collider(const World& w, lr_collider collider) {
    lr_collider_state s = initialised(lr_collider_state_init);
    REQUIRE(lr_collider_get_state(w.get(), collider, &s) == LR_OK);
    return s;
}
inline lr_collider_motion motion_of(lr_collider collider, int32_t mode) {
    lr_collider_motion m = initialised(lr_collider_motion_init);
    m.collider = collider;
    m.mode = mode;
    return m;
}

inline bool same_bits(const lr_collider_state& a, const lr_collider_state& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

// Arrays that a desc points to.
struct Triangles {
    std::vector<float> vertices;
    std::vector<uint32_t> indices;
};

// A bumpy sheet of 2 n^2 triangles, side 1 m, and a much larger triangle.
inline Triangles bumpy_sheet(uint32_t n, uint64_t seed) {
    Random random(seed);
    Triangles t;
    for (uint32_t k = 0; k <= n; ++k)
        for (uint32_t i = 0; i <= n; ++i)
            t.vertices.insert(t.vertices.end(), {static_cast<float>(i) / static_cast<float>(n), random.real(-0.1, 0.1),
                                                 static_cast<float>(k) / static_cast<float>(n)});
    for (uint32_t k = 0; k < n; ++k)
        for (uint32_t i = 0; i < n; ++i) {
            const uint32_t a = i + (n + 1) * k, b = a + n + 1;
            t.indices.insert(t.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
        }
    const auto first = static_cast<uint32_t>(t.vertices.size() / 3);
    t.vertices.insert(t.vertices.end(), {-9.0f, 1.0f, 0.0f, 9.0f, 1.0f, 0.5f, 0.0f, 2.0f, 9.0f});
    t.indices.insert(t.indices.end(), {first, first + 1, first + 2});
    return t;
}
// The closed surface of a box, given by half its extents.
inline Triangles closed_box(float a, float b, float c) {
    Triangles t;
    for (const float x : {-a, a})
        for (const float y : {-b, b})
            for (const float z : {-c, c}) t.vertices.insert(t.vertices.end(), {x, y, z});
    t.indices = {0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1,
                 2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3};
    return t;
}
// Adds a surface, moved by `by`, to another.
inline void join(Triangles& to, const Triangles& part, const std::array<float, 3>& by = {}) {
    const auto first = static_cast<uint32_t>(to.vertices.size() / 3);
    for (size_t k = 0; k < part.vertices.size(); ++k) to.vertices.push_back(part.vertices[k] + by[k % 3]);
    for (const uint32_t index : part.indices) to.indices.push_back(first + index);
}
inline lr_collider_desc mesh_collider(const Triangles& t) {
    lr_collider_desc d = collider_desc(LR_COLLIDER_MESH);
    d.vertices = t.vertices.data();
    d.vertex_count = static_cast<uint32_t>(t.vertices.size() / 3);
    d.indices = t.indices.data();
    d.triangle_count = static_cast<uint32_t>(t.indices.size() / 3);
    return d;
}
inline lr_collider_desc hull_collider(const std::vector<float>& vertices) {
    lr_collider_desc d = collider_desc(LR_COLLIDER_HULL);
    d.vertices = vertices.data();
    d.vertex_count = static_cast<uint32_t>(vertices.size() / 3);
    return d;
}
inline lr_collider_desc heightfield_collider(const std::vector<float>& heights, uint32_t across, float spacing) {
    lr_collider_desc d = collider_desc(LR_COLLIDER_HEIGHTFIELD);
    d.heights = heights.data();
    d.counts[0] = across;
    d.counts[1] = static_cast<uint32_t>(heights.size() / across);
    d.spacing[0] = d.spacing[1] = spacing;
    return d;
}
inline std::vector<float> tetrahedron(float size) {
    return {0.0f, 0.0f, 0.0f, size, 0.0f, 0.0f, 0.0f, size, 0.0f, 0.0f, 0.0f, size};
}

} // namespace test
