#include "contact/narrow.h"

#include "contact/manifold.h"
#include "contact/terrain.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lr {
namespace {

void add_plane(const PlacedBody& body, float margin, ContactSet& set) {
    const Vector up{0.0f, 1.0f, 0.0f};
    const float height = body.at.position.y;
    for (uint32_t i = 0; i < body.count; ++i)
        if (height + body.y[i] - body.radius < margin) set.add_core(body.point(i), up, height + body.y[i]);
    if (body.count > 0) return;
    const Vector p = to_float(body.support({0.0, -1.0, 0.0}));
    if (height + p.y < margin) set.add_core(p, up, height + p.y);
}

// Where all of the body is over the inside of one side of the box, that side is a plane.
bool add_box_side(const PlacedBody& body, const Geometry& box, float margin, ContactSet& set) {
    if (body.count == 0) return false;
    const Vector at = body.at.position;
    const float p[3] = {at.x, at.y, at.z}, far = body.reach + body.radius;
    uint32_t axis = 3;
    for (uint32_t i = 0; i < 3; ++i) {
        if (std::abs(p[i]) + far <= box.size[i]) continue;
        if (axis < 3 || std::abs(p[i]) <= box.size[i]) return false;
        axis = i;
    }
    if (axis == 3) return false;
    const float sign = p[axis] < 0.0f ? -1.0f : 1.0f;
    const Vector n{axis == 0 ? sign : 0.0f, axis == 1 ? sign : 0.0f, axis == 2 ? sign : 0.0f};
    const float height = std::abs(p[axis]) - box.size[axis];
    const float* along = axis == 0 ? body.x : axis == 1 ? body.y : body.z;
    for (uint32_t i = 0; i < body.count; ++i) {
        const float gap = height + sign * along[i];
        if (gap - body.radius < margin) set.add_core(body.point(i), n, gap);
    }
    return true;
}

// Spheres larger than the body: its corners as well, on which it can rest.
void add_sphere_points(const PlacedBody& body, float radius, float margin, ContactSet& set) {
    for (uint32_t i = 0; i < body.count; ++i) {
        const Vector p = body.point(i), from = body.at.position + p;
        const float out = length(from);
        if (out - radius - body.radius < margin && out > 0.5f * radius)
            set.add_core(p, 1.0f / out * from, out - radius);
    }
}

// Farther than this from the collider's surface there is nothing to find. From below, m.
float center_distance(const Geometry& g, Vector p) {
    const auto beyond = [](float v, float h) { return std::max(std::abs(v) - h, 0.0f); };
    switch (g.kind) {
    case ColliderKind::sphere:
        return length(p) - g.size[0];
    case ColliderKind::capsule:
        return length(Vector{p.x, beyond(p.y, g.size[1]), p.z}) - g.size[0];
    case ColliderKind::box:
        return length(Vector{beyond(p.x, g.size[0]), beyond(p.y, g.size[1]), beyond(p.z, g.size[2])});
    case ColliderKind::hull: {
        float most = -std::numeric_limits<float>::infinity();
        for (uint32_t f = 0; f < g.hull->face_count; ++f) {
            const float* face = g.hull->faces + size_t{4} * f;
            most = std::max(most, dot({face[0], face[1], face[2]}, p) - face[3]);
        }
        return most;
    }
    default:
        return 0.0f;
    }
}

} // namespace

uint32_t find_contacts(const BodyShape& shape, float scale, const Pose& at, const Geometry& collider, ColliderPart part,
                       float margin, Contact* out) {
    const float far = scale * shape.reach + margin;
    if (collider.kind == ColliderKind::plane ? at.position.y > far : center_distance(collider, at.position) > far)
        return 0;
    const PlacedBody body(shape, scale, at);
    ContactSet set(body);
    switch (collider.kind) {
    case ColliderKind::plane:
        add_plane(body, margin, set);
        break;
    case ColliderKind::heightfield:
        add_heightfield(body, *collider.heightfield, margin, set);
        break;
    case ColliderKind::mesh:
        add_mesh(body, *collider.mesh, part, margin, set);
        break;
    default: {
        if (collider.kind == ColliderKind::box && add_box_side(body, collider, margin, set)) break;
        const PlacedCollider placed(collider, at.position);
        const double enough = static_cast<double>(margin + body.radius) + placed.radius;
        const Separation along = separate(body, placed, enough);
        if (along.distance >= enough) break;
        if (collider.kind == ColliderKind::sphere && collider.size[0] > body.reach)
            add_sphere_points(body, collider.size[0], margin, set);
        add_manifold(body, placed, along, margin, set);
        break;
    }
    }
    return set.keep(out);
}

} // namespace lr
