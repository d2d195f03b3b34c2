// Bodies and colliders of all kinds in random poses.
#pragma once

#include "collision/build_collider_geometry.h"
#include "collision/collider_narrow_phase.h"
#include "collision/convex_separation.h"
#include "collision/local_pair.h"
#include "collision/triangle_contact.h"
#include "support/box_corners.h"
#include "support/quick.h"
#include "support/random.h"
#include "support/vector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace test {

// Sanitizers slow everything down tenfold.
inline uint32_t rounds(uint32_t n) {
    return quick() ? n / 10 : n;
}

inline lr::AssetData asset_of(const std::vector<float>& vertices) {
    lr::AssetData asset;
    asset.mass = 1.0;
    asset.volume = 1.0;
    asset.inertia = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    asset.hull.vertices = vertices;
    return asset;
}

// A pointed oval of 2 x 48 corners, `size` long, thickness across.
inline lr::BodyShape leaf(float size, float thickness) {
    std::vector<float> v;
    for (int i = 0; i < 48; ++i) {
        const double t = 2.0 * std::numbers::pi * i / 48.0;
        const double wide = 0.3 * std::sin(t) * (1.0 + 0.3 * std::cos(t));
        for (const float side : {-0.5f, 0.5f}) {
            v.push_back(size * static_cast<float>(0.5 * std::cos(t)));
            v.push_back(side * thickness);
            v.push_back(size * static_cast<float>(wide));
        }
    }
    return lr::make_body_shape(asset_of(v));
}

inline std::vector<float> cloud(Random& random, uint32_t count, float size) {
    std::vector<float> v;
    for (uint32_t i = 0; i < count; ++i) {
        Vec p{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        const double s = static_cast<double>(size) / length(p);
        for (const double c : p) v.push_back(static_cast<float>(s * c));
    }
    return v;
}

inline lr::BodyShape ellipsoid(float a, float b, float c) {
    lr::BodyShape shape{};
    shape.semi_axes = {a, b, c};
    shape.reach = std::max({a, b, c});
    shape.thickness = 2.0f * std::min({a, b, c});
    return shape;
}

inline lr::Rotation any_rotation(Random& random) {
    while (true) {
        const lr::Rotation q{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
        const float square = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
        if (square > 0.01f && square <= 1.0f) return lr::normalised(q);
    }
}
inline lr::Vector any_direction(Random& random) {
    while (true) {
        const lr::Vector a{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
        const float size = lr::length(a);
        if (size > 0.1f && size <= 1.0f) return 1.0f / size * a;
    }
}

// Owns the data of a Geometry.
struct Solid {
    lr::Geometry geometry{};
    lr::HullGeometry hull{};
    lr::BuiltHull hull_data;
    lr::MeshGeometry mesh{};
    lr::HeightfieldGeometry field{};
    std::vector<float> vertices, normals, heights, coarse;
    std::vector<uint32_t> indices;
    std::vector<uint8_t> hidden;
    lr::ColliderPart part{0, 0};

    Solid() = default;
    Solid(const Solid&) = delete;
    Solid& operator=(const Solid&) = delete;

    void make(lr::ColliderKind kind, float a = 0, float b = 0, float c = 0) {
        geometry.kind = kind;
        geometry.size[0] = a;
        geometry.size[1] = b;
        geometry.size[2] = c;
    }
    bool make_hull(const std::vector<float>& points) {
        geometry.kind = lr::ColliderKind::hull;
        if (!lr::build_hull(points.data(), static_cast<uint32_t>(points.size() / 3), hull_data)) return false;
        hull = hull_data.geometry();
        geometry.hull = &hull;
        return true;
    }
    bool make_mesh(const std::vector<float>& points, const std::vector<uint32_t>& corners) {
        geometry.kind = lr::ColliderKind::mesh;
        vertices = points;
        indices = corners;
        mesh = {static_cast<uint32_t>(points.size() / 3),
                static_cast<uint32_t>(corners.size() / 3),
                vertices.data(),
                indices.data(),
                nullptr,
                nullptr};
        if (!lr::build_mesh(mesh.vertices, mesh.vertex_count, mesh.indices, mesh.triangle_count, normals, hidden))
            return false;
        mesh.normals = normals.data();
        mesh.hidden_edges = hidden.data();
        part = {0, mesh.triangle_count};
        geometry.mesh = &mesh;
        return true;
    }
    bool make_field(uint32_t columns, uint32_t rows, float spacing, const std::vector<float>& samples) {
        geometry.kind = lr::ColliderKind::heightfield;
        heights = samples;
        field.counts[0] = columns;
        field.counts[1] = rows;
        field.spacing[0] = field.spacing[1] = spacing;
        field.heights = heights.data();
        lr::build_coarse(field.counts, field.heights, coarse, field.coarse_counts, field.lowest, field.highest);
        field.coarse = coarse.data();
        geometry.heightfield = &field;
        return true;
    }
};

// Of a solid of any kind, meshes included.
inline uint32_t find_contacts(const lr::BodyShape& shape, float scale, const lr::Pose& at, const Solid& solid,
                              float margin, lr::Contact* out) {
    if (!solid.geometry.mesh) return lr::find_contacts(shape, scale, at, solid.geometry, margin, out);
    lr::ContactPoints set(shape, scale, at, margin);
    lr::add_mesh(set, solid.mesh, solid.part);
    return set.keep(out, true);
}
inline float free_fraction(const lr::BodyShape& shape, float scale, const lr::Pose& from, const lr::Pose& to,
                           const Solid& solid) {
    if (!solid.geometry.mesh) return lr::free_fraction(shape, scale, from, to, solid.geometry);
    const auto none = [](const void*, const lr::Triangle&, uint32_t) { return false; };
    return lr::first_triangle(shape, scale, from, to, solid.mesh, solid.part, none, nullptr).free;
}

// Solids of finite size, about `size` large. kind: sphere to hull, or a mesh of one triangle.
inline void make_random(Solid& solid, lr::ColliderKind kind, float size, Random& random) {
    const auto some = [&] { return size * random.real(0.2, 1.0); };
    if (kind == lr::ColliderKind::hull) {
        while (!solid.make_hull(cloud(random, 4 + random.below(20), size))) {
        }
    } else if (kind == lr::ColliderKind::mesh) {
        while (!solid.make_mesh(cloud(random, 3, size), {0, 1, 2})) {
        }
    } else {
        const float a = some(), b = some(), c = some();
        solid.make(kind, a, b, c);
    }
}

inline lr::PlacedCollider place(const Solid& solid, lr::Vector at) {
    if (solid.geometry.kind != lr::ColliderKind::mesh) return {solid.geometry, at};
    lr::Vector corners[3];
    for (uint32_t i = 0; i < 3; ++i) {
        const float* v = solid.mesh.vertices + 3 * solid.mesh.indices[i];
        corners[i] = {v[0], v[1], v[2]};
    }
    return {corners, at};
}

// The largest separation of the cores along any direction, negative where they overlap: the best of directions all around, and of steps
// from the four best that lead to a better one. No more than the true value.
inline double sampled_separation(const lr::PlacedBody& body, const lr::PlacedCollider& collider, Random& random) {
    constexpr uint32_t count = 1000, starts = 4, tries = 12;
    std::vector<std::pair<double, lr::Double3>> found;
    found.reserve(count);
    for (uint32_t i = 0; i < count; ++i) { // a spiral of equal areas
        const double z = 1.0 - (2.0 * i + 1.0) / count, r = std::sqrt(1.0 - z * z);
        const double angle = std::numbers::pi * (3.0 - std::sqrt(5.0)) * i;
        const lr::Double3 n{r * std::cos(angle), r * std::sin(angle), z};
        found.emplace_back(separation_along(body, collider, n), n);
    }
    const auto greater = [](const auto& a, const auto& b) { return a.first > b.first; };
    std::partial_sort(found.begin(), found.begin() + starts, found.end(), greater);
    double best = found[0].first;
    for (uint32_t k = 0; k < starts; ++k) {
        auto [here, n] = found[k];
        for (double step = 0.1; step > 1e-4; step *= 0.5)
            for (uint32_t i = 0; i < tries; ++i) {
                const lr::Double3 near = n + step * lr::to_double(any_direction(random));
                const lr::Double3 to = 1.0 / lr::length(near) * near;
                const double there = separation_along(body, collider, to);
                if (there > here) here = there, n = to;
            }
        best = std::max(best, here);
    }
    return best;
}

} // namespace test
