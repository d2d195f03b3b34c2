// Bodies and colliders of all kinds in random poses, and libccd's expanding polytope as the reference.
#pragma once

#include "collision/build_collider_geometry.h"
#include "collision/collider_narrow_phase.h"
#include "collision/local_pair.h"
#include "support/box_corners.h"
#include "support/random.h"
#include "support/vector.h"

#include <ccd/ccd.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace test {

// Sanitizers slow everything down tenfold.
#ifdef LR_TEST_QUICK
constexpr uint32_t rounds(uint32_t n) {
    return n / 10;
}
#else
constexpr uint32_t rounds(uint32_t n) {
    return n;
}
#endif

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

// The distance between the cores by libccd's expanding polytope, of the pair with a ball around one of them.
struct Reference {
    const lr::PlacedBody* body;
    const lr::PlacedCollider* collider;
    double ball, inverse_size;

    static void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* out) {
        const auto& r = *static_cast<const Reference*>(object);
        const lr::Double3 d{ccdVec3X(direction), ccdVec3Y(direction), ccdVec3Z(direction)};
        lr::Double3 p = r.body ? r.body->support(d) : r.collider->support(d);
        const double size = lr::length(d);
        if (r.ball > 0.0 && size > 0.0) p = p + r.ball / size * d;
        ccdVec3Set(out, r.inverse_size * p.x, r.inverse_size * p.y, r.inverse_size * p.z);
    }
};
// False if they do not overlap with the ball around one of them, or if libccd fails.
inline bool reference_distance(const lr::PlacedBody& body, const lr::PlacedCollider& collider, double ball,
                               double& distance, lr::Double3& normal) {
    const double size = static_cast<double>(body.reach);
    const Reference one{nullptr, &collider, 0.0, 1.0 / size}, other{&body, nullptr, ball, 1.0 / size};
    ccd_t ccd;
    CCD_INIT(&ccd);
    ccd.support1 = ccd.support2 = Reference::support;
    ccd.max_iterations = 300;
    ccd.epa_tolerance = 1e-7;
    ccd_real_t depth = 0.0;
    ccd_vec3_t out, at;
    if (ccdGJKPenetration(&one, &other, &ccd, &depth, &out, &at) != 0) return false;
    distance = ball - size * depth;
    normal = {ccdVec3X(&out), ccdVec3Y(&out), ccdVec3Z(&out)};
    return true;
}

} // namespace test
