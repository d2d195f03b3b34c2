#include "contact/ray.h"

#include "contact/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lr {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr uint32_t most_advances = 100;
// Of a body's reach: where a ray has come so near it has met it.
constexpr double met = 1e-6;

// Where |a + t d|^2 = 1 first. With d and a in units of the semi-axes.
bool enters_unit_sphere(Double3 a, Double3 d, double& t) {
    const double dd = dot(d, d), ad = dot(a, d);
    // The least distance from the middle by the cross product: differences of squares lose what is far away.
    const Double3 across = cross(a, d);
    const double room = dd - dot(across, across);
    if (!(room >= 0.0)) return false;
    t = (-ad - std::sqrt(room)) / dd;
    return true;
}

bool meets_ellipsoid(const BodyShape& shape, double scale, const Ray& ray, double most, RayHit& hit) {
    const double s[3] = {scale * wide(shape.semi_axes.x), scale * wide(shape.semi_axes.y),
                         scale * wide(shape.semi_axes.z)};
    const Double3 from = ray.origin - scale * to_double(shape.center);
    const Double3 a{from.x / s[0], from.y / s[1], from.z / s[2]};
    const Double3 d{ray.direction.x / s[0], ray.direction.y / s[1], ray.direction.z / s[2]};
    if (dot(a, a) <= 1.0) {
        hit = {0.0, -ray.direction};
        return true;
    }
    double t = 0.0;
    if (!enters_unit_sphere(a, d, t) || t < 0.0 || t > most) return false;
    const Double3 p = a + t * d, n{p.x / s[0], p.y / s[1], p.z / s[2]};
    hit = {t, 1.0 / length(n) * n};
    return true;
}

// Steps along the ray up to planes that the body is behind, each through where it is nearest to the ray's point (van den
// Bergen 2004): a polytope's rounding, and so any ray, in a few rounds. Never past the surface.
bool meets_rounded(const BodyShape& shape, float scale, const Ray& ray, double most, RayHit& hit) {
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
        if (t == 0.0 && gap <= 0.0) {
            hit = {0.0, -ray.direction};
            return true;
        }
        if (!(speed > 0.0) && gap > near) return false;
        if (speed > 0.0) t += std::max(gap, 0.0) / speed;
        if (!(t <= most)) return false;
        if (gap > near) continue;
        hit = {t, -nearest.normal};
        return true;
    }
    return false;
}

bool meets_hull(const BodyShape& shape, double scale, const Ray& ray, double most, RayHit& hit) {
    const auto plane = [&](uint32_t f, Double3& outward, double& offset) {
        outward = to_double(shape.faces[f].normal);
        offset = scale * wide(shape.faces[f].offset);
    };
    return ray_meets_planes(shape.face_count, plane, ray, most, hit);
}

// The part of a ray within so far of the origin.
bool reaches_sphere(Double3 from, Double3 direction, double radius, double most, double& first) {
    const Double3 across = cross(from, direction);
    const double room = radius * radius - dot(across, across);
    if (!(room >= 0.0)) return false;
    const double middle = -dot(from, direction), half = std::sqrt(room);
    first = std::max(middle - half, 0.0);
    return middle + half >= 0.0 && middle - half <= most;
}

} // namespace

Double3 turned(const Rotation& q, Double3 a) {
    const Double3 axis{wide(q.x), wide(q.y), wide(q.z)}, t = 2.0 * cross(axis, a);
    return a + wide(q.w) * t + cross(axis, t);
}

Ray ray_in(const Pose& frame, const Ray& ray) {
    const Rotation back = inverse(frame.rotation);
    const Double3 direction = turned(back, ray.direction);
    return {turned(back, ray.origin - to_double(frame.position)), 1.0 / length(direction) * direction};
}

bool RayPart::clip(const Ray& ray, Double3 outward, double offset) {
    const double height = dot(outward, ray.origin) - offset, rise = dot(outward, ray.direction);
    if (rise == 0.0) return height <= 0.0;
    const double at = -height / rise;
    if (rise > 0.0) {
        last = std::min(last, at);
    } else if (at > first) {
        first = at;
        normal = outward;
    }
    return first <= last;
}

bool ray_meets_body(const BodyShape& shape, float scale, const Pose& at, const Ray& ray, double most, RayHit& hit) {
    Ray own = ray_in(at, ray);
    const double size = wide(scale);
    // From where it enters the sphere about the body: what comes is as precise as the body is small.
    double start = 0.0;
    if (!reaches_sphere(own.origin, own.direction, 1.001 * size * wide(shape.reach), most, start)) return false;
    own.origin = own.origin + start * own.direction;
    bool meets = false;
    if (shape.count == 0)
        meets = meets_ellipsoid(shape, size, own, most - start, hit);
    else if (shape.radius > 0.0f || shape.face_count < 4)
        meets = meets_rounded(shape, scale, own, most - start, hit);
    else
        meets = meets_hull(shape, size, own, most - start, hit);
    if (!meets) return false;
    hit.distance += start;
    hit.normal = turned(at.rotation, hit.normal);
    return true;
}

} // namespace lr
