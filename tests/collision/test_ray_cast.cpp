// Rays against bodies' shapes and colliders: closed forms, and sampling along the ray.
#include "collision/ray_cast.h"

#include "collision/build_collider_geometry.h"
#include "collision/triangle_contact.h"
#include "random_pairs.h"

#include <doctest/doctest.h>

#include <functional>

using namespace test;

namespace {

using lr::Double3;
using lr::to_double;
using Implicit = std::function<double(Double3)>; // m, positive outside

lr::Ray any_ray(Random& random, double size) {
    const auto point = [&](double s) {
        return Double3{random.uniform(-s, s), random.uniform(-s, s), random.uniform(-s, s)};
    };
    const Double3 from = point(3.0 * size), to = point(0.8 * size);
    return {from, 1.0 / length(to - from) * (to - from)};
}

// A hit must be on the surface, with no inside before it; without a hit the whole ray is outside.
void check_ray(const lr::Ray& ray, double most, bool meets, const lr::RayHit& hit, const Implicit& outside,
               double tolerance) {
    const double until = meets ? hit.distance : most;
    double least = 1e30;
    constexpr int samples = 400;
    for (int i = 0; i < samples; ++i)
        least =
            std::min(least, outside(ray.origin + until * i / (samples - 1.0 + (meets ? 1.0 : 0.0)) * ray.direction));
    if (meets && hit.distance == 0.0) {
        CHECK(outside(ray.origin) <= tolerance);
        CHECK(length(hit.normal + ray.direction) < 1e-6);
        return;
    }
    CHECK(least > -tolerance);
    if (!meets) return;
    const Double3 at = ray.origin + hit.distance * ray.direction;
    CHECK(std::abs(outside(at)) <= tolerance);
    CHECK(std::abs(length(hit.normal) - 1.0) < 1e-6);
    CHECK(dot(hit.normal, ray.direction) <= 1e-9);
    // The normal points outward: the distance grows along it at that rate.
    const double step = 100.0 * tolerance;
    CHECK(outside(at + step * hit.normal) > 0.5 * step);
}

Implicit turned_back(const lr::Pose& pose, Implicit own) {
    return [pose, own = std::move(own)](Double3 p) {
        return own(rotate(to_double(inverse(pose.rotation)), p - to_double(pose.position)));
    };
}

// A flat convex polygon in space, with a rounding radius.
double from_plate(const lr::BodyShape& shape, Double3 p) {
    const lr::ShapeFace& face = shape.faces[0];
    const auto corner = [&](uint32_t i) {
        const uint32_t c = shape.corners[face.first + i % face.count];
        return to_double(lr::Vector{shape.x[c], shape.y[c], shape.z[c]});
    };
    const Double3 n = to_double(face.normal);
    bool over = true;
    double rim = 1e30;
    for (uint32_t i = 0; i < face.count; ++i) {
        const Double3 a = corner(i), from = p - a;
        const Double3 edge = corner(i + 1) - a;
        over = over && dot(cross(n, edge), from) >= 0.0;
        const double t = std::clamp(dot(from, edge) / dot(edge, edge), 0.0, 1.0);
        rim = std::min(rim, length(from - t * edge));
    }
    const double distance = over ? std::abs(dot(n, p) - static_cast<double>(face.offset)) : rim;
    return distance - static_cast<double>(shape.radius);
}

} // namespace

TEST_CASE("rays meet ellipsoids where the quadric says") {
    Random random(1);
    int met = 0;
    for (int round = 0; round < 2000; ++round) {
        const float size = static_cast<float>(random.logarithmic(1e-3, 10.0));
        lr::BodyShape shape = ellipsoid(size, size * random.real(0.02, 1.0), size * random.real(0.02, 1.0));
        shape.center = {0.1f * size, 0.0f, -0.05f * size};
        shape.reach *= 1.2f;
        const lr::Pose pose{{size * random.real(-1, 1), size * random.real(-1, 1), size * random.real(-1, 1)},
                            any_rotation(random)};
        const lr::Ray ray = any_ray(random, static_cast<double>(size));
        lr::RayHit hit{};
        const bool meets = ray_hits_body(shape, 1.0f, pose, ray, 10.0 * static_cast<double>(size), hit);
        met += meets ? 1 : 0;
        // Not a distance, but of the right sign, and of first order at the surface.
        const auto own = [&](Double3 p) {
            const Double3 q = p - to_double(shape.center);
            const double x = q.x / static_cast<double>(shape.semi_axes.x),
                         y = q.y / static_cast<double>(shape.semi_axes.y),
                         z = q.z / static_cast<double>(shape.semi_axes.z);
            const double f = x * x + y * y + z * z - 1.0;
            const Double3 g{x / static_cast<double>(shape.semi_axes.x), y / static_cast<double>(shape.semi_axes.y),
                            z / static_cast<double>(shape.semi_axes.z)};
            return f / (2.0 * length(g));
        };
        check_ray(ray, 10.0 * static_cast<double>(size), meets, hit, turned_back(pose, own),
                  3e-6 * static_cast<double>(size));
    }
    CHECK(met > 500);
    CHECK(met < 1900);
}

TEST_CASE("rays meet thin sheets within their thickness, rims included") {
    Random random(2);
    int met = 0;
    for (int round = 0; round < 300; ++round) {
        const float size = static_cast<float>(random.logarithmic(1e-3, 3.0));
        const lr::BodyShape shape = leaf(size, size * random.real(0.001, 0.02));
        REQUIRE(shape.face_count == 2);
        const float scale = random.real(0.5, 2.0);
        const lr::Pose pose{{size * random.real(-1, 1), size * random.real(-1, 1), size * random.real(-1, 1)},
                            any_rotation(random)};
        const auto own = [&](Double3 p) {
            const double s = static_cast<double>(scale);
            return s * from_plate(shape, 1.0 / s * p);
        };
        const double wide_size = static_cast<double>(size);
        for (int k = 0; k < 5; ++k) {
            lr::Ray ray = any_ray(random, wide_size);
            lr::RayHit hit{};
            const bool meets = ray_hits_body(shape, scale, pose, ray, 12.0 * wide_size, hit);
            met += meets ? 1 : 0;
            check_ray(ray, 12.0 * wide_size, meets, hit, turned_back(pose, own), 1e-5 * wide_size);
        }
    }
    CHECK(met > 100);
    CHECK(met < 1400);
}

TEST_CASE("rays meet hulls at their faces") {
    Random random(3);
    int met = 0;
    for (int round = 0; round < 300; ++round) {
        const float size = static_cast<float>(random.logarithmic(1e-3, 3.0));
        const lr::BodyShape shape = lr::make_body_shape(asset_of(cloud(random, 20, size)));
        REQUIRE(shape.face_count > 3);
        const lr::Pose pose{{size * random.real(-1, 1), size * random.real(-1, 1), size * random.real(-1, 1)},
                            any_rotation(random)};
        const auto own = [&](Double3 p) {
            double most = -1e30;
            for (uint32_t f = 0; f < shape.face_count; ++f)
                most = std::max(most, dot(to_double(shape.faces[f].normal), p) -
                                          static_cast<double>(shape.faces[f].offset + shape.radius));
            return most;
        };
        for (int k = 0; k < 5; ++k) {
            const lr::Ray ray = any_ray(random, static_cast<double>(size));
            lr::RayHit hit{};
            const bool meets = ray_hits_body(shape, 1.0f, pose, ray, 12.0 * static_cast<double>(size), hit);
            met += meets ? 1 : 0;
            check_ray(ray, 12.0 * static_cast<double>(size), meets, hit, turned_back(pose, own),
                      1e-5 * static_cast<double>(size));
        }
    }
    CHECK(met > 300);
    CHECK(met < 1500);
}

TEST_CASE("rays meet spheres, capsules, boxes and hulls where these begin") {
    Random random(4);
    for (int round = 0; round < 1000; ++round) {
        lr::Geometry g{};
        lr::BuiltHull data;
        lr::HullGeometry hull{};
        const int kind = round % 4;
        g.kind = kind == 0   ? lr::ColliderKind::sphere
                 : kind == 1 ? lr::ColliderKind::capsule
                 : kind == 2 ? lr::ColliderKind::box
                             : lr::ColliderKind::hull;
        for (float& s : g.size) s = random.real(0.2, 1.0);
        if (kind == 3) {
            const std::vector<float> points = cloud(random, 12, 1.0f);
            REQUIRE(lr::build_hull(points.data(), 12, data));
            hull = data.geometry();
            g.hull = &hull;
        }
        const auto outside = [&](Double3 p) {
            const double s[3] = {static_cast<double>(g.size[0]), static_cast<double>(g.size[1]),
                                 static_cast<double>(g.size[2])};
            if (kind == 0) return length(p) - s[0];
            if (kind == 1) return length(Double3{p.x, std::max(std::abs(p.y) - s[1], 0.0), p.z}) - s[0];
            if (kind == 2) return std::max({std::abs(p.x) - s[0], std::abs(p.y) - s[1], std::abs(p.z) - s[2]});
            double most = -1e30;
            for (uint32_t f = 0; f < hull.face_count; ++f) {
                const float* n = hull.faces + size_t{4} * f;
                most = std::max(most, dot(to_double(lr::Vector{n[0], n[1], n[2]}), p) - static_cast<double>(n[3]));
            }
            return most;
        };
        const lr::Ray ray = any_ray(random, 1.0);
        lr::RayHit hit{};
        const double most = random.uniform(0.5, 8.0);
        const lr::SharedGeometry* const none = nullptr;
        const bool meets = ray_hits_collider(g, none, ray, most, hit);
        CAPTURE(kind);
        check_ray(ray, most, meets, hit, outside, 1e-9);
        if (meets) CHECK(hit.distance <= most);
    }
}

TEST_CASE("rays meet the ground of a heightfield and its sides, wherever they come from") {
    Random random(5);
    int met = 0;
    for (int round = 0; round < 400; ++round) {
        lr::HeightfieldGeometry field{};
        field.counts[0] = 3 + random.below(9), field.counts[1] = 2 + random.below(9);
        field.spacing[0] = random.real(0.2, 0.6), field.spacing[1] = random.real(0.2, 0.6);
        std::vector<float> heights(field.counts[0] * field.counts[1]);
        for (float& h : heights) h = random.real(-0.3, 0.3);
        field.heights = heights.data();
        field.lowest = *std::min_element(heights.begin(), heights.end());
        field.highest = *std::max_element(heights.begin(), heights.end());
        lr::Geometry g{};
        g.kind = lr::ColliderKind::heightfield;
        g.heightfield = &field;
        const double wide_x = static_cast<double>(field.spacing[0]) * (field.counts[0] - 1.0),
                     wide_z = static_cast<double>(field.spacing[1]) * (field.counts[1] - 1.0);
        lr::Ray ray = any_ray(random, 1.5);
        ray.origin = ray.origin + Double3{0.5 * wide_x, 0.0, 0.5 * wide_z};
        if (round % 7 == 0) ray.direction = {0.0, -1.0, 0.0};
        if (round % 11 == 0) ray.direction = {1.0, 0.0, 0.0};
        lr::RayHit hit{};
        const bool meets = ray_hits_collider(g, nullptr, ray, 20.0, hit);
        met += meets ? 1 : 0;
        const auto inside = [&](Double3 p) {
            if (p.x < 0.0 || p.z < 0.0 || p.x > wide_x || p.z > wide_z) return false;
            return p.y <
                   static_cast<double>(height_at(field, static_cast<float>(p.x), static_cast<float>(p.z)).height) -
                       1e-5;
        };
        const double until = meets ? hit.distance : 20.0;
        bool before = false;
        for (int i = 0; i < 4000; ++i) before = before || inside(ray.origin + until * i / 4000.0 * ray.direction);
        CHECK((!before || (meets && hit.distance == 0.0)));
        if (meets && hit.distance > 0.0 && dot(hit.normal, ray.direction) < -0.02)
            CHECK(inside(ray.origin + (hit.distance + 2e-3) * ray.direction - 1e-3 * hit.normal));
    }
    CHECK(met > 150);
    CHECK(met < 395);
}

TEST_CASE("rays meet the nearest triangle of a mesh, as every triangle by itself says") {
    Random random(6);
    std::vector<float> vertices;
    std::vector<uint32_t> indices;
    for (uint32_t i = 0; i < 300; ++i) {
        const Double3 at{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        for (uint32_t k = 0; k < 3; ++k) {
            for (const double c : {at.x, at.y, at.z})
                vertices.push_back(static_cast<float>(c + random.uniform(-0.15, 0.15)));
            indices.push_back(3 * i + k);
        }
    }
    std::vector<lr::MeshPart> parts;
    std::vector<float> normals;
    std::vector<uint8_t> hidden;
    lr::make_mesh_parts(vertices.data(), indices.data(), 300, parts);
    REQUIRE(lr::build_mesh(vertices.data(), 900, indices.data(), 300, normals, hidden));
    lr::Geometry g{};
    const lr::MeshGeometry mesh{900, 300, vertices.data(), indices.data(), normals.data(), hidden.data()};
    g.kind = lr::ColliderKind::mesh;
    g.mesh = &mesh;
    lr::Allocator allocator;
    lr::SharedGeometry shared{};
    REQUIRE(shared.parts.allocate(allocator, parts.size()));
    std::copy(parts.begin(), parts.end(), shared.parts.data());
    shared.box = {{-1.2f, -1.2f, -1.2f}, {1.2f, 1.2f, 1.2f}};
    int met = 0;
    for (int round = 0; round < 1000; ++round) {
        const lr::Ray ray = any_ray(random, 1.0);
        lr::RayHit hit{};
        const bool meets = ray_hits_collider(g, &shared, ray, 10.0, hit);
        // Moeller and Trumbore 1997.
        double least = 10.0;
        for (uint32_t i = 0; i < 300; ++i) {
            const lr::Triangle t = lr::mesh_triangle(mesh, i);
            const Double3 a = to_double(t.corners[0]), e = to_double(t.corners[1]) - a, f = to_double(t.corners[2]) - a;
            const Double3 p = cross(ray.direction, f), s = ray.origin - a, q = cross(s, e);
            const double det = dot(e, p), u = dot(s, p) / det, v = dot(ray.direction, q) / det, d = dot(f, q) / det;
            if (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && d >= 0.0) least = std::min(least, d);
        }
        REQUIRE(meets == (least < 10.0));
        if (!meets) continue;
        ++met;
        CHECK(hit.distance == doctest::Approx(least).epsilon(1e-9));
        CHECK(dot(hit.normal, ray.direction) < 0.0);
    }
    CHECK(met > 300);
}
