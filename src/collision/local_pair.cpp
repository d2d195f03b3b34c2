#include "collision/local_pair.h"

#include <algorithm>

namespace lr {

PlacedBody::PlacedBody(const BodyShape& body, float body_scale, const Pose& pose, float size)
    : shape(&body), at(pose), scale(body_scale), count(body.count), radius(body_scale * body.radius),
      reach(body_scale * body.reach - radius), axes{} {
    const Rotation q = pose.rotation;
    // Columns of the rotation matrix: nine products per point.
    const Vector e[3] = {rotate(q, {body_scale, 0.0f, 0.0f}), rotate(q, {0.0f, body_scale, 0.0f}),
                         rotate(q, {0.0f, 0.0f, body_scale})};
    const auto turn = [&](Vector a) { return a.x * e[0] + a.y * e[1] + a.z * e[2]; };
    center = size * turn(body.center);
    for (uint32_t i = 0; i < 3 && count == 0; ++i) axes[i] = size * body.semi_axes[i] * e[i];
    for (uint32_t i = 0; i < count; ++i) {
        const Vector p = size * turn(body.point(i));
        x[i] = p.x;
        y[i] = p.y;
        z[i] = p.z;
    }
}

Double3 PlacedBody::support(Double3 direction) const {
    if (count == 0) {
        Double3 sum = to_double(center);
        double along[3], square = 0.0;
        for (uint32_t i = 0; i < 3; ++i) {
            along[i] = dot(to_double(axes[i]), direction);
            square += along[i] * along[i];
        }
        if (!(square > 0.0)) return sum;
        const double s = 1.0 / std::sqrt(square);
        for (uint32_t i = 0; i < 3; ++i) sum = sum + s * along[i] * to_double(axes[i]);
        return sum;
    }
    return to_double(point(farthest_point(x, y, z, count, to_float(direction))));
}

uint32_t PlacedBody::face_towards(Vector direction) const {
    const Vector own = rotate(inverse(at.rotation), direction);
    const ShapeFace* const faces = shape->faces;
    const auto lower = [&](const ShapeFace& a, const ShapeFace& b) { return dot(a.normal, own) < dot(b.normal, own); };
    return static_cast<uint32_t>(std::max_element(faces, faces + shape->face_count, lower) - faces);
}

PlacedCollider::PlacedCollider(const Geometry& geometry, Vector body_position) : origin(-to_double(body_position)) {
    const auto size = [&](uint32_t i) { return static_cast<double>(geometry.size[i]); };
    switch (geometry.kind) {
    case ColliderKind::sphere:
        count = 1;
        points[0] = origin;
        radius = size(0);
        break;
    case ColliderKind::capsule:
        count = 2;
        points[0] = origin + Double3{0.0, -size(1), 0.0};
        points[1] = origin + Double3{0.0, size(1), 0.0};
        radius = size(0);
        break;
    case ColliderKind::hull:
        hull = geometry.hull;
        break;
    default:
        half = {size(0), size(1), size(2)};
        break;
    }
}

PlacedCollider::PlacedCollider(const Vector (&corners)[3], Vector body_position)
    : count(3), origin(-to_double(body_position)) {
    for (uint32_t i = 0; i < 3; ++i) points[i] = origin + to_double(corners[i]);
}

Double3 PlacedCollider::support(Double3 d) const {
    if (count > 0) {
        uint32_t best = 0;
        double most = dot(d, points[0]);
        for (uint32_t i = 1; i < count; ++i) {
            const double along = dot(d, points[i]);
            if (along > most) most = along, best = i;
        }
        return points[best];
    }
    if (hull) {
        const float* const v = hull->vertices;
        return origin + to_double(hull->corner(farthest_point<3>(v, v + 1, v + 2, hull->vertex_count, to_float(d))));
    }
    return origin + Double3{d.x < 0.0 ? -half.x : half.x, d.y < 0.0 ? -half.y : half.y, d.z < 0.0 ? -half.z : half.z};
}

Double3 PlacedCollider::middle() const {
    if (count == 0 && !hull) return origin;
    Double3 sum{0.0, 0.0, 0.0};
    const uint32_t n = hull ? hull->vertex_count : count;
    for (uint32_t i = 0; i < n; ++i) sum = sum + (hull ? origin + to_double(hull->corner(i)) : points[i]);
    return 1.0 / static_cast<double>(n) * sum;
}
} // namespace lr
