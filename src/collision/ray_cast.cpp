#include "collision/ray_cast.h"

#include "collision/convex_separation.h"
#include "collision/triangle_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lr {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr uint32_t most_advances = 100;
// Share of the reach: a ray this near has hit the body.
constexpr double met = 1e-6;

// The set outward . x <= offset.
struct Plane {
    Double3 outward;
    double offset; // m
};

// The part of a ray inside a convex set; at first all of it up to `last`.
struct RayPart {
    double first = 0.0, last = 0.0; // m
    Double3 normal = {};            // of the plane at `first`; 0: the ray begins inside

    // Keeps the part behind the plane. False if nothing is left.
    bool clip(const Ray& ray, const Plane& plane) {
        const double height = dot(plane.outward, ray.origin) - plane.offset, rise = dot(plane.outward, ray.direction);
        if (rise == 0.0) return height <= 0.0;
        const double at = -height / rise;
        if (rise > 0.0) {
            last = std::min(last, at);
        } else if (at > first) {
            first = at;
            normal = plane.outward;
        }
        return first <= last;
    }
    RayHit hit(const Ray& ray) const { return {first, first > 0.0 ? normal : -ray.direction}; }
};

// Whether a ray hits within `most` (m) the convex set behind `count` planes, plane(i).
template <class PlaneAt>
bool hits_planes(uint32_t count, const PlaneAt& plane, const Ray& ray, double most, RayHit& hit) {
    RayPart part;
    part.last = most;
    for (uint32_t i = 0; i < count; ++i)
        if (!part.clip(ray, plane(i))) return false;
    hit = part.hit(ray);
    return true;
}

bool begins_inside(const Ray& ray, RayHit& hit) {
    hit = {0.0, -ray.direction};
    return true;
}

// An ellipsoid with axes along the frame's.
bool hits_ellipsoid(Double3 middle, Double3 semi_axes, const Ray& ray, double most, RayHit& hit) {
    const auto in_units = [&](Double3 p) { return Double3{p.x / semi_axes.x, p.y / semi_axes.y, p.z / semi_axes.z}; };
    const Double3 a = in_units(ray.origin - middle), d = in_units(ray.direction);
    if (dot(a, a) <= 1.0) return begins_inside(ray, hit);
    // Distance from the middle by the cross product, since differences of squares lose precision far away.
    const Double3 across = cross(a, d);
    const double square = dot(d, d), room = square - dot(across, across);
    if (!(room >= 0.0)) return false;
    const double t = (-dot(a, d) - std::sqrt(room)) / square;
    if (!(t >= 0.0 && t <= most)) return false;
    const Double3 n = in_units(a + t * d);
    hit = {t, 1.0 / length(n) * n};
    return true;
}

// Advances from plane to plane, each through the body's point nearest to the ray's (van den Bergen 2004): few rounds, never past the surface.
bool hits_rounded(const BodyShape& shape, float scale, const Ray& ray, double most, RayHit& hit) {
    const PlacedBody body(shape, scale, {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f, 1.0f}});
    const double radius = wide(body.radius), near = met * wide(scale * shape.reach);
    Geometry point{};
    point.kind = ColliderKind::sphere;
    PlacedCollider at(point, {0.0f, 0.0f, 0.0f});
    double t = 0.0;
    for (uint32_t round = 0; round < most_advances; ++round) {
        at.points[0] = ray.origin + t * ray.direction;
        const Nearest nearest = nearest_points(body, at, infinite);
        if (nearest.overlap) {
            hit = {t, -ray.direction};
            return true;
        }
        const double gap = std::max(nearest.lower, 0.0) - radius, speed = dot(nearest.normal, ray.direction);
        if (t == 0.0 && gap <= 0.0) return begins_inside(ray, hit);
        if (!(speed > 0.0) && gap > near) return false;
        if (speed > 0.0) t += std::max(gap, 0.0) / speed;
        if (!(t <= most)) return false;
        if (gap > near) continue;
        hit = {t, -nearest.normal};
        return true;
    }
    return false;
}

// Whether a ray comes within `radius` of the origin, and where first.
bool reaches_sphere(Double3 from, Double3 direction, double radius, double most, double& first) {
    const Double3 across = cross(from, direction);
    const double room = radius * radius - dot(across, across);
    if (!(room >= 0.0)) return false;
    const double middle = -dot(from, direction), half = std::sqrt(room);
    first = std::max(middle - half, 0.0);
    return middle + half >= 0.0 && middle - half <= most;
}
} // namespace

Ray ray_in(const Pose& frame, const Ray& ray) {
    const Quaternion<double> back = inverse(to_double(frame.rotation));
    const Double3 direction = rotate(back, ray.direction);
    return {rotate(back, ray.origin - to_double(frame.position)), 1.0 / length(direction) * direction};
}

bool ray_hits_body(const BodyShape& shape, float scale, const Pose& at, const Ray& ray, double most, RayHit& hit) {
    Ray own = ray_in(at, ray);
    const double size = wide(scale);
    // Starts at the sphere around the body, so that precision is relative to the body's size.
    double start = 0.0;
    if (!reaches_sphere(own.origin, own.direction, 1.001 * size * wide(shape.reach), most, start)) return false;
    own.origin = own.origin + start * own.direction;
    bool meets = false;
    if (shape.count == 0)
        meets =
            hits_ellipsoid(size * to_double(shape.center), size * to_double(shape.semi_axes), own, most - start, hit);
    else if (shape.radius > 0.0f || shape.face_count < 4)
        meets = hits_rounded(shape, scale, own, most - start, hit);
    else
        meets = hits_planes(
            shape.face_count,
            [&](uint32_t f) {
                return Plane{to_double(shape.faces[f].normal), size * wide(shape.faces[f].offset)};
            },
            own, most - start, hit);
    if (!meets) return false;
    hit.distance += start;
    hit.normal = rotate(to_double(at.rotation), hit.normal);
    return true;
}

namespace {

// The tube, then the spheres at its ends.
bool hits_capsule(double radius, double half, const Ray& ray, double most, RayHit& hit) {
    const Double3 o = ray.origin, d = ray.direction;
    const double dd = d.x * d.x + d.z * d.z, across = o.x * d.z - o.z * d.x;
    const double room = dd * radius * radius - across * across;
    if (o.x * o.x + o.z * o.z <= radius * radius && std::abs(o.y) <= half) return begins_inside(ray, hit);
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
        const double before = any ? hit.distance : most;
        any = hits_ellipsoid({0.0, end, 0.0}, {radius, radius, radius}, ray, before, hit) || any;
    }
    return any;
}

// The signs of three volumes (Pluecker coordinates) decide, so that no ray slips through the edge between two triangles.
bool hits_triangle(const Vector (&corners)[3], const Ray& ray, double most, bool two_sided, RayHit& hit) {
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
    for (uint32_t k = 0; k < 3; ++k) {
        const double low = wide(box.low[k]), high = wide(box.high[k]), from = ray.origin[k], along = ray.direction[k];
        if (along == 0.0) {
            if (from < low || from > high) return false;
            continue;
        }
        const double a = (low - from) / along, b = (high - from) / along;
        // A flat box is entered and left at the same place: the slack covers rounding.
        const double slack = 1e-12 * (std::abs(a) + std::abs(b));
        first = std::max(first, std::min(a, b) - slack);
        last = std::min(last, std::max(a, b) + slack);
    }
    return first <= last;
}

// The first hit among things [begin, end), the first thing if equal. hits(i, hit) tests within `most`, which shrinks to the nearest hit so far.
template <class Hits> bool hits_first(size_t begin, size_t end, double& most, RayHit& hit, const Hits& hits) {
    bool any = false;
    for (size_t i = begin; i < end; ++i) {
        RayHit other{};
        if (!hits(i, other) || (any && !(other.distance < hit.distance))) continue;
        hit = other;
        most = other.distance;
        any = true;
    }
    return any;
}

bool hits_mesh(const MeshGeometry& mesh, const SharedGeometry& shared, const Ray& ray, double most, RayHit& hit) {
    return hits_first(0, shared.parts.size(), most, hit, [&](size_t p, RayHit& other) {
        const MeshPart& part = shared.parts[p];
        return reaches_box(part.box, ray, most) && ray_hits_part(mesh, part.part, ray, most, other);
    });
}

// Height of the ground under a place of the outline.
double ground(const HeightfieldGeometry& field, Double3 p) {
    const double most_x = wide(field.spacing[0]) * (field.counts[0] - 1.0),
                 most_z = wide(field.spacing[1]) * (field.counts[1] - 1.0);
    const auto x = static_cast<float>(std::clamp(p.x, 0.0, most_x)),
               z = static_cast<float>(std::clamp(p.z, 0.0, most_z));
    return wide(height_at(field, x, z).height);
}

// Visits the cells along the ray, within the outline and below the highest sample.
bool hits_heightfield(const HeightfieldGeometry& field, const Ray& ray, double most, RayHit& hit) {
    const double spacing[2] = {wide(field.spacing[0]), wide(field.spacing[1])};
    RayPart part;
    part.last = most;
    for (uint32_t k = 0; k < 2; ++k)
        for (const double side : {-1.0, 1.0})
            if (!part.clip(ray, {along_axis(2 * k, side), side < 0.0 ? 0.0 : spacing[k] * (field.counts[k] - 1.0)}))
                return false;
    // Solid below: a ray that enters from the side, or begins inside, has hit it.
    const Double3 entry = ray.origin + part.first * ray.direction;
    if (entry.y <= ground(field, entry)) {
        hit = part.hit(ray);
        return true;
    }
    if (!part.clip(ray, {{0.0, 1.0, 0.0}, wide(field.highest)})) return false;
    const Double3 from = ray.origin + part.first * ray.direction;
    const double at[2] = {from.x, from.z}, along[2] = {ray.direction.x, ray.direction.z};
    int64_t cell[2], cells[2];
    double next[2], every[2]; // m along the ray: to the end of the cell, and per cell
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
            const Triangle triangle = field_triangle(field, i, j, second);
            any = hits_triangle(triangle.corners, ray, any ? hit.distance : most, false, hit) || any;
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

bool ray_hits_part(const MeshGeometry& mesh, const ColliderPart& part, const Ray& ray, double most, RayHit& hit) {
    return hits_first(part.first, size_t{part.first} + part.count, most, hit, [&](size_t i, RayHit& other) {
        return hits_triangle(mesh_triangle(mesh, static_cast<uint32_t>(i)).corners, ray, most, true, other);
    });
}

bool ray_hits_collider(const Geometry& g, const SharedGeometry* shared, const Ray& ray, double most, RayHit& hit) {
    const auto side = [&](uint32_t i) {
        return Plane{along_axis(i / 2, i % 2 == 0 ? -1.0 : 1.0), wide(g.size[i / 2])};
    };
    const auto face = [&](uint32_t f) { return Plane{to_double(g.hull->normal(f)), wide(g.hull->offset(f))}; };
    const auto ground = [](uint32_t) { return Plane{{0.0, 1.0, 0.0}, 0.0}; };
    switch (g.kind) {
    case ColliderKind::plane:
        return hits_planes(1, ground, ray, most, hit);
    case ColliderKind::sphere:
        return hits_ellipsoid({}, wide(g.size[0]) * Double3{1.0, 1.0, 1.0}, ray, most, hit);
    case ColliderKind::capsule:
        return hits_capsule(wide(g.size[0]), wide(g.size[1]), ray, most, hit);
    case ColliderKind::box:
        return hits_planes(6, side, ray, most, hit);
    case ColliderKind::hull:
        return hits_planes(g.hull->face_count, face, ray, most, hit);
    case ColliderKind::heightfield:
        return hits_heightfield(*g.heightfield, ray, most, hit);
    case ColliderKind::mesh:
        return reaches_box(shared->box, ray, most) && hits_mesh(*g.mesh, *shared, ray, most, hit);
    }
    return false;
}
} // namespace lr
