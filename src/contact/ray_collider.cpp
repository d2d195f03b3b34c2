#include "contact/ray.h"
#include "contact/terrain.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lr {
namespace {

bool inside(const Ray& ray, RayHit& hit) {
    hit = {0.0, -ray.direction};
    return true;
}

bool meets_plane(const Ray& ray, double most, RayHit& hit) {
    if (ray.origin.y <= 0.0) return inside(ray, hit);
    if (!(ray.direction.y < 0.0)) return false;
    hit = {-ray.origin.y / ray.direction.y, {0.0, 1.0, 0.0}};
    return hit.distance <= most;
}

bool meets_sphere(Double3 middle, double radius, const Ray& ray, double most, RayHit& hit) {
    const Double3 from = ray.origin - middle;
    if (dot(from, from) <= radius * radius) return inside(ray, hit);
    const Double3 across = cross(from, ray.direction);
    const double room = radius * radius - dot(across, across);
    if (!(room >= 0.0)) return false;
    const double t = -dot(from, ray.direction) - std::sqrt(room);
    if (!(t >= 0.0 && t <= most)) return false;
    const Double3 out = from + t * ray.direction;
    hit = {t, 1.0 / length(out) * out};
    return true;
}

// Its tube between the ends, and the ends' spheres.
bool meets_capsule(double radius, double half, const Ray& ray, double most, RayHit& hit) {
    const Double3 o = ray.origin, d = ray.direction;
    const double dd = d.x * d.x + d.z * d.z, across = o.x * d.z - o.z * d.x;
    const double room = dd * radius * radius - across * across;
    if (o.x * o.x + o.z * o.z <= radius * radius && std::abs(o.y) <= half) return inside(ray, hit);
    bool any = false;
    if (dd > 0.0 && room >= 0.0) {
        const double t = (-(o.x * d.x + o.z * d.z) - std::sqrt(room)) / dd, y = o.y + t * d.y;
        if (t >= 0.0 && t <= most && std::abs(y) <= half) {
            const Double3 out{o.x + t * d.x, 0.0, o.z + t * d.z};
            hit = {t, 1.0 / length(out) * out};
            any = true;
        }
    }
    for (const double end : {-half, half}) {
        RayHit other{};
        if (!meets_sphere({0.0, end, 0.0}, radius, ray, any ? hit.distance : most, other)) continue;
        hit = other;
        any = true;
    }
    return any;
}

bool meets_box(const float (&size)[3], const Ray& ray, double most, RayHit& hit) {
    const auto plane = [&](uint32_t i, Double3& outward, double& offset) {
        const double side = i % 2 == 0 ? -1.0 : 1.0;
        outward = {i / 2 == 0 ? side : 0.0, i / 2 == 1 ? side : 0.0, i / 2 == 2 ? side : 0.0};
        offset = wide(size[i / 2]);
    };
    return ray_meets_planes(6, plane, ray, most, hit);
}

bool meets_hull(const HullGeometry& hull, const Ray& ray, double most, RayHit& hit) {
    const auto plane = [&](uint32_t f, Double3& outward, double& offset) {
        outward = to_double(vector_of(hull.faces + size_t{4} * f));
        offset = wide(hull.faces[size_t{4} * f + 3]);
    };
    return ray_meets_planes(hull.face_count, plane, ray, most, hit);
}

// By the signs of three volumes (Plücker coordinates), so that no ray slips through an edge between two triangles.
bool meets_triangle(const Vector (&corners)[3], const Ray& ray, double most, bool two_sided, RayHit& hit) {
    const Double3 a = to_double(corners[0]) - ray.origin, b = to_double(corners[1]) - ray.origin,
                  c = to_double(corners[2]) - ray.origin;
    const double u = dot(ray.direction, cross(b, c)), v = dot(ray.direction, cross(c, a)),
                 w = dot(ray.direction, cross(a, b));
    const bool front = u <= 0.0 && v <= 0.0 && w <= 0.0, back = u >= 0.0 && v >= 0.0 && w >= 0.0;
    if (!front && !(back && two_sided)) return false;
    const Double3 normal = cross(b - a, c - a);
    const double rise = dot(normal, ray.direction), size = length(normal);
    if (rise == 0.0 || !(size > 0.0)) return false;
    const double t = dot(normal, a) / rise;
    if (!(t >= 0.0 && t <= most)) return false;
    hit = {t, (rise < 0.0 ? 1.0 : -1.0) / size * normal};
    return true;
}

bool reaches_box(const Box& box, const Ray& ray, double most) {
    double first = 0.0, last = most;
    const double low[3] = {wide(box.low.x), wide(box.low.y), wide(box.low.z)};
    const double high[3] = {wide(box.high.x), wide(box.high.y), wide(box.high.z)};
    const double from[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
    const double along[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
    for (uint32_t k = 0; k < 3; ++k) {
        if (along[k] == 0.0) {
            if (from[k] < low[k] || from[k] > high[k]) return false;
            continue;
        }
        const double a = (low[k] - from[k]) / along[k], b = (high[k] - from[k]) / along[k];
        // Flat boxes are entered and left at once: not by less than rounding.
        const double slack = 1e-12 * (std::abs(a) + std::abs(b));
        first = std::max(first, std::min(a, b) - slack);
        last = std::min(last, std::max(a, b) + slack);
    }
    return first <= last;
}

bool meets_mesh(const MeshGeometry& mesh, const SharedGeometry& shared, const Ray& ray, double most, RayHit& hit) {
    bool any = false;
    for (size_t p = 0; p < shared.parts.size(); ++p) {
        const MeshPart& part = shared.parts[p];
        if (!reaches_box(part.box, ray, most)) continue;
        for (uint32_t i = part.part.first; i < part.part.first + part.part.count; ++i) {
            RayHit other{};
            if (!meets_triangle(mesh_triangle(mesh, i).corners, ray, most, true, other)) continue;
            if (any && !(other.distance < hit.distance)) continue;
            hit = other;
            most = other.distance;
            any = true;
        }
    }
    return any;
}

// The ground under a place of the outline.
double ground(const HeightfieldGeometry& field, Double3 p) {
    const double most_x = wide(field.spacing[0]) * (field.counts[0] - 1.0),
                 most_z = wide(field.spacing[1]) * (field.counts[1] - 1.0);
    const auto x = static_cast<float>(std::clamp(p.x, 0.0, most_x)),
               z = static_cast<float>(std::clamp(p.z, 0.0, most_z));
    return wide(height_at(field, x, z).height);
}

// Cell by cell along the ray, above the outline and below the highest sample.
bool meets_heightfield(const HeightfieldGeometry& field, const Ray& ray, double most, RayHit& hit) {
    const double spacing[2] = {wide(field.spacing[0]), wide(field.spacing[1])};
    RayPart part;
    part.last = most;
    for (uint32_t k = 0; k < 2; ++k)
        for (const double side : {-1.0, 1.0}) {
            const Double3 out{k == 0 ? side : 0.0, 0.0, k == 1 ? side : 0.0};
            if (!part.clip(ray, out, side < 0.0 ? 0.0 : spacing[k] * (field.counts[k] - 1.0))) return false;
        }
    // Solid below: what comes in from the side, or begins there, has met it.
    const Double3 entry = ray.origin + part.first * ray.direction;
    if (entry.y <= ground(field, entry)) {
        hit = part.hit(ray);
        return true;
    }
    if (!part.clip(ray, {0.0, 1.0, 0.0}, wide(field.highest))) return false;
    const Double3 from = ray.origin + part.first * ray.direction;
    const double at[2] = {from.x, from.z}, along[2] = {ray.direction.x, ray.direction.z};
    const double infinite = std::numeric_limits<double>::infinity();
    int64_t cell[2], cells[2];
    double next[2], every[2]; // m along the ray: where it leaves the cell, and what a cell takes
    for (uint32_t k = 0; k < 2; ++k) {
        cells[k] = static_cast<int64_t>(field.counts[k]) - 1;
        cell[k] = std::clamp(static_cast<int64_t>(std::floor(at[k] / spacing[k])), int64_t{0}, cells[k] - 1);
        const double edge = spacing[k] * static_cast<double>(cell[k] + (along[k] > 0.0 ? 1 : 0));
        next[k] = along[k] == 0.0 ? infinite : part.first + (edge - at[k]) / along[k];
        every[k] = along[k] == 0.0 ? infinite : spacing[k] / std::abs(along[k]);
    }
    while (true) {
        bool any = false;
        for (const bool second : {false, true}) {
            const auto i = static_cast<uint32_t>(cell[0]), j = static_cast<uint32_t>(cell[1]);
            RayHit other{};
            if (!meets_triangle(field_triangle(field, i, j, second).corners, ray, any ? hit.distance : most, false,
                                other))
                continue;
            hit = other;
            any = true;
        }
        if (any) return true;
        const uint32_t k = next[0] <= next[1] ? 0 : 1;
        if (!(next[k] <= part.last)) return false;
        cell[k] += along[k] > 0.0 ? 1 : -1;
        if (cell[k] < 0 || cell[k] >= cells[k]) return false;
        next[k] += every[k];
    }
}

} // namespace

bool ray_meets_collider(const Geometry& g, const SharedGeometry* shared, const Ray& ray, double most, RayHit& hit) {
    switch (g.kind) {
    case ColliderKind::plane:
        return meets_plane(ray, most, hit);
    case ColliderKind::sphere:
        return meets_sphere({0.0, 0.0, 0.0}, wide(g.size[0]), ray, most, hit);
    case ColliderKind::capsule:
        return meets_capsule(wide(g.size[0]), wide(g.size[1]), ray, most, hit);
    case ColliderKind::box:
        return meets_box(g.size, ray, most, hit);
    case ColliderKind::hull:
        return meets_hull(*g.hull, ray, most, hit);
    case ColliderKind::heightfield:
        return meets_heightfield(*g.heightfield, ray, most, hit);
    case ColliderKind::mesh:
        return reaches_box(shared->box, ray, most) && meets_mesh(*g.mesh, *shared, ray, most, hit);
    }
    return false;
}

} // namespace lr
