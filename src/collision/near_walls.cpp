#include "collision/near_walls.h"

#include "collision/triangle_contact.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

// Cosines of a side's slope: steeper than `steep` it is a wall, flatter than `level` it is ground. There gravity holds bodies, not the wind.
constexpr float level = 0.7f, steep = 0.5f;
// Times the reach: up to `close` a wall takes all of the wind's component, beyond `far` nothing. Contact begins at `far` too.
constexpr float close = 1.0f, far = 1.5f;

// Triangles of a mesh that face about the same way, in the world frame.
struct MeshSide {
    const Collider* collider;
    Vector normal;  // m^2, times their areas
    float distance; // m, of the body's middle from the nearest one's plane
};

// Walls at a place, in the world frame.
struct Found {
    const ContactStep* step;
    Vector x;
    float reach;
    NearWalls walls;
    uint32_t side_count;
    MeshSide sides[NearWalls::most];

    float steepness(Vector normal) const {
        const float up = step->gravity > 0.0f ? -dot(normal, step->weight) / step->gravity : 0.0f;
        return std::clamp((level - up) / (level - steep), 0.0f, 1.0f);
    }
    // distance: m, of the middle from the side.
    void add(const Collider& c, Vector normal, float area, float distance) {
        MeshSide* const end = sides + side_count;
        MeshSide* side = std::find_if(sides, end, [&](const MeshSide& s) {
            return s.collider == &c && dot(s.normal, normal) > 0.5f * length(s.normal);
        });
        if (side == end) {
            if (side_count == NearWalls::most) return;
            ++side_count;
            *side = {&c, {}, distance};
        }
        side->normal = side->normal + area * normal;
        side->distance = std::min(side->distance, distance);
    }
    void take_sides(const ContactSubstep& substep) {
        for (const MeshSide* s = sides; s != sides + side_count; ++s) {
            const float net = length(s->normal);
            // Less than the square of the reach is a post or a bump, twice as much is a wall.
            const float wide = std::clamp(net / (reach * reach) - 1.0f, 0.0f, 1.0f);
            if (wide > 0.0f) take(*s->collider, substep, 1.0f / net * s->normal, s->distance, wide);
        }
    }
    // wide: less than 1 takes less of the flow.
    void take(const Collider& c, const ContactSubstep& substep, Vector normal, float distance, float wide = 1.0f) {
        const float near = std::clamp((far - distance / reach) / (far - close), 0.0f, 1.0f);
        const float share = wide * near * steepness(normal);
        if (!(share > 0.0f)) return;
        for (uint32_t k = 0; k < walls.count; ++k) {
            NearWalls::Wall& same = walls.wall[k]; // both sides of a thin wall, or one side in two triangles
            if (dot(same.normal, normal) < 0.999f) continue;
            same.share = std::max(same.share, share);
            return;
        }
        if (walls.count == NearWalls::most) return;
        const float speed = c.moves ? dot(normal, motion_of(c, substep).velocity_at(x)) : 0.0f;
        walls.wall[walls.count++] = {normal, share, speed};
    }
};

// The mean slope across the body: a bump smaller than it turns no wind.
void add_heightfield(const Collider& c, const ContactSubstep& substep, const Pose& pose, Found& found) {
    const HeightfieldGeometry& f = *c.geometry.heightfield;
    const Vector p = to_inner(pose, found.x);
    if (!f.covers(p.x, p.z)) return;
    const HeightPoint below = height_at(f, p.x, p.z);
    if (found.steepness(rotate(pose.rotation, below.normal)) == 0.0f) return;
    const auto height = [&](float x, float z) {
        return height_at(f, std::clamp(x, 0.0f, f.extent(0)), std::clamp(z, 0.0f, f.extent(1))).height;
    };
    const float r = found.reach;
    const Vector up{height(p.x - r, p.z) - height(p.x + r, p.z), 2.0f * r, height(p.x, p.z - r) - height(p.x, p.z + r)};
    const Vector normal = 1.0f / length(up) * up;
    found.take(c, substep, rotate(pose.rotation, normal), (p.y - below.height) * normal.y);
}

// m^2, twice its area along its normal.
Vector doubled(const Triangle& t) {
    return cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]);
}
// A rough wall turns the flow as a smooth one: not along the stone that is nearest, which would carry bodies from one to the next.
Vector mean_normal(const MeshGeometry& mesh, ColliderPart part, Vector normal) {
    Vector sum{};
    for (uint32_t i = part.first; i < part.first + part.count && i < mesh.triangle_count; ++i) {
        const Vector n = doubled(mesh_triangle(mesh, i));
        const float along = dot(n, normal);
        if (std::abs(along) > 0.5f * length(n)) sum = sum + (along < 0.0f ? -n : n);
    }
    const float size = length(sum);
    return size > 0.0f ? 1.0f / size * sum : normal; // of triangles without area
}

void add_part(const Collider& c, ColliderPart part, const Pose& pose, Found& found) {
    const MeshGeometry& mesh = *c.geometry.mesh;
    const Vector p = to_inner(pose, found.x);
    for (uint32_t i = part.first; i < part.first + part.count && i < mesh.triangle_count; ++i) {
        const Triangle t = mesh_triangle(mesh, i);
        const float off = dot(t.normal, p - t.corners[0]);
        if (!(std::abs(off) < far * found.reach)) continue;
        const Vector facing = off < 0.0f ? -t.normal : t.normal;
        if (found.steepness(rotate(pose.rotation, facing)) == 0.0f) continue;
        const float area = 0.5f * length(doubled(t));
        const Vector middle = 1.0f / 3.0f * (t.corners[0] + t.corners[1] + t.corners[2]);
        if (area < 2.0f * found.reach * found.reach ? length(p - middle) > far * found.reach : !is_over(t, p)) continue;
        found.add(c, rotate(pose.rotation, mean_normal(mesh, part, facing)), area, std::abs(off));
    }
}

// The nearest point of a sphere, or of a capsule's side.
void add_round(const Collider& c, const ContactSubstep& substep, const Pose& pose, Found& found) {
    Vector p = to_inner(pose, found.x);
    if (c.geometry.kind == ColliderKind::capsule) p.y -= std::clamp(p.y, -c.geometry.size[1], c.geometry.size[1]);
    const float out = length(p), radius = c.geometry.size[0];
    if (!(out > 0.5f * radius) || radius < 2.0f * found.reach) return;
    found.take(c, substep, rotate(pose.rotation, 1.0f / out * p), out - radius);
}

// A post thinner than the body turns no wind.
bool is_wide(const Geometry& solid, Vector normal, float reach) {
    Vector half = vector_of(solid.size);
    if (solid.hull) {
        Vector low = solid.hull->corner(0), high = low;
        for (uint32_t k = 1; k < solid.hull->vertex_count; ++k)
            low = low_of(low, solid.hull->corner(k)), high = high_of(high, solid.hull->corner(k));
        half = 0.5f * (high - low);
    }
    for (uint32_t k = 0; k < 3; ++k)
        if (half[k] < reach && std::abs(normal[k]) < 0.5f) return false;
    return true;
}

void add_solid(const Collider& c, const ContactSubstep& substep, const Pose& pose, Found& found) {
    const Vector p = to_inner(pose, found.x);
    const auto side = flat_side(c.geometry, p, p, 0.0f);
    if (!side || !is_wide(c.geometry, side->normal, found.reach)) return;
    found.take(c, substep, rotate(pose.rotation, side->normal), dot(side->normal, p) - side->offset);
}
} // namespace

bool NearWalls::met_by(Vector wind) const {
    // Less than a thousandth of the wind is rounding.
    return std::any_of(wall, wall + count, [&](const Wall& w) { return into(w, wind) < -1e-3f * length(wind); });
}

NearWalls walls_near(const ContactStep& step, const BatchArrays& arrays, uint32_t body, bool grounds,
                     const ContactSubstep& substep) {
    const Vector x = vector_in(arrays.field, field_x, body);
    const float reach = step.shape->reach * arrays.field[field_scale][body];
    Found found{&step, x, reach, {0, {}}, 0, {}};
    const Box around = grown({x, x}, far * reach);
    Candidate near[most_candidates];
    bool more = false; // the first ones count
    const uint32_t layers = step.settings->layers;
    const uint32_t count = grounds ? step.colliders->grounds(around, layers, near)
                                   : step.colliders->candidates(around, layers, nullptr, near, more);
    for (uint32_t k = 0; k < count; ++k) {
        const Collider& c = step.colliders->at(near[k].slot);
        const Pose pose = pose_at(c, substep.begin);
        switch (c.geometry.kind) {
        case ColliderKind::plane:
            found.take(c, substep, rotate(pose.rotation, {0.0f, 1.0f, 0.0f}), to_inner(pose, x).y);
            break;
        case ColliderKind::heightfield:
            add_heightfield(c, substep, pose, found);
            break;
        case ColliderKind::mesh:
            add_part(c, near[k].part, pose, found);
            break;
        case ColliderKind::sphere:
        case ColliderKind::capsule:
            add_round(c, substep, pose, found);
            break;
        default:
            add_solid(c, substep, pose, found);
        }
    }
    found.take_sides(substep);
    return found.walls;
}
} // namespace lr
