// Conservative advancement (Mirtich 1996): along the normal in which the pair is farthest apart, how far can the body go?
#include "contact/separation.h"
#include "contact/terrain.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lr {
namespace {

constexpr uint32_t most_rounds = 24, most_tries = 4;
// Of the body's thickness, and of its reach if that is less: nearer than that is touching.
constexpr float touching = 0.1f, touching_reach = 0.01f;
// Of the body's thickness: no way this short leads through anything.
constexpr float short_way = 0.25f;

struct Way {
    const BodyShape& shape;
    float scale;
    Pose from, to; // rotations on the same side
    Vector move;
    Vector axis;    // of the rotation, unit
    float turn;     // rad, an upper bound
    float reach;    // m, of the body about its centre of mass, rounding included
    float farthest; // m, no point moves more
    float tolerance;

    Way(const BodyShape& body, float body_scale, const Pose& a, const Pose& b)
        : shape(body), scale(body_scale), from(a), to(b), move(b.position - a.position), axis{0.0f, 0.0f, 0.0f},
          turn(0.0f), reach(body_scale * body.reach), farthest(0.0f),
          tolerance(body_scale * std::min(touching * body.thickness, touching_reach * body.reach)) {
        Rotation& q = to.rotation;
        if (q.x * a.rotation.x + q.y * a.rotation.y + q.z * a.rotation.z + q.w * a.rotation.w < 0.0f)
            q = {-q.x, -q.y, -q.z, -q.w};
        const Rotation by = q * inverse(a.rotation);
        const Vector sine{by.x, by.y, by.z};
        const float size = length(sine);
        if (size > 0.0f) axis = 1.0f / size * sine;
        // 4 tan(turn/4) is no less than the turn, and is the fastest of its rates times the time.
        const auto square = [](float x, float y, float z, float w) { return x * x + y * y + z * z + w * w; };
        const Rotation r = a.rotation;
        const float apart = square(q.x - r.x, q.y - r.y, q.z - r.z, q.w - r.w);
        const float sum = square(q.x + r.x, q.y + r.y, q.z + r.z, q.w + r.w);
        turn = 4.0f * std::sqrt(apart / sum);
        farthest = length(move) + turn * reach;
    }

    // Around all of it.
    Box box() const { return grown({low_of(from.position, to.position), high_of(from.position, to.position)}, reach); }
    Pose at(float t) const {
        const Rotation a = from.rotation, b = to.rotation;
        const float s = 1.0f - t;
        return {from.position + t * move,
                normalised({s * a.x + t * b.x, s * a.y + t * b.y, s * a.z + t * b.z, s * a.w + t * b.w})};
    }
};

// The fraction of the way until the cores, the body's drawn to `size`, are `target` apart; 1 where they come nearer by no more
// than `slack`. collider(position) places it.
template <typename Place>
float advance(const Way& way, float size, double first, double target, double slack, Double3 normal,
              const Place& collider) {
    float t = 0.0f;
    double distance = first;
    for (uint32_t round = 0; round < most_rounds; ++round) {
        const double sideways = length(cross(normal, to_double(way.axis)));
        const double lever = sideways * static_cast<double>(way.reach);
        const double room = distance - target;
        float step = 1.0f - t;
        bool moved = false;
        for (uint32_t i = 0; i < most_tries; ++i) {
            const Pose pose = way.at(t + step);
            const double then =
                separation_along(PlacedBody(way.shape, way.scale, pose, size), collider(pose.position), normal);
            // Between the two a point is nearer than on the straight line by no more than an eighth of its acceleration:
            // of the arc, and because the normalised linear quaternion does not turn at a steady rate.
            const auto turn = static_cast<double>(way.turn), part = static_cast<double>(step);
            const double bulge = 0.125 * lever * turn * turn * (1.0 + 0.25 * turn) * part * part;
            if (std::min(distance, then) - bulge >= target - (i == 0 ? slack : 0.0)) {
                if (i == 0) return 1.0f;
                moved = true;
                break;
            }
            if (room <= static_cast<double>(way.tolerance)) return t;
            const double fall = distance - then + bulge;
            step *= static_cast<float>(std::min(0.99 * room / fall, 0.9));
        }
        if (!moved) { // by the rate at which the nearest point could come
            const double rate =
                std::max(-dot(normal, to_double(way.move)), 0.0) + static_cast<double>(way.turn) * lever;
            step = std::min(step, static_cast<float>(0.99 * room / rate));
        }
        if (!(step > 1e-6f)) return t;
        t += step;
        const Pose pose = way.at(t);
        const PlacedBody body(way.shape, way.scale, pose, size);
        const Nearest nearest = nearest_points(body, collider(pose.position), std::numeric_limits<double>::infinity());
        if (nearest.overlap) return t - step; // by rounding
        distance = nearest.lower;
        normal = nearest.normal;
        if (distance - target <= 0.0) return t;
    }
    return t;
}

// A body that touches already may still not go through: its core keeps half of the rounding or most of the distance that is
// left, and where the core overlaps as well, that drawn together to its half, and to its middle.
template <typename Place> float sweep(const Way& way, const Place& collider) {
    for (const float size : {1.0f, 0.5f, 0.0f}) {
        const PlacedBody body(way.shape, way.scale, way.from, size);
        const PlacedCollider placed = collider(way.from.position);
        const double rounding = placed.radius + static_cast<double>(body.radius);
        const Nearest start =
            nearest_points(body, placed, static_cast<double>(way.farthest) + (size == 1.0f ? rounding : 0.0));
        if (start.overlap) continue;
        const bool apart = size == 1.0f && start.lower > rounding;
        const double target = apart                                           ? rounding
                              : size == 1.0f && start.lower > 0.75 * rounding ? 0.5 * rounding
                                                                              : 0.75 * start.lower;
        if (start.lower - target > static_cast<double>(way.farthest)) return 1.0f;
        return advance(way, size, start.lower, target, apart ? static_cast<double>(way.tolerance) : 0.0, start.normal,
                       collider);
    }
    return 1.0f;
}

bool near_box(const Way& way, const float* half) {
    const float a[3] = {way.from.position.x, way.from.position.y, way.from.position.z};
    const float b[3] = {way.to.position.x, way.to.position.y, way.to.position.z};
    for (uint32_t i = 0; i < 3; ++i)
        if (std::min(a[i], b[i]) - way.reach > half[i] || std::max(a[i], b[i]) + way.reach < -half[i]) return false;
    return true;
}

// The way of the centre against a line along y (a point where its half length is 0): may it come near?
bool near_axis(const Way& way, float radius, float half_length) {
    const float far = radius + way.reach, half[3] = {radius, half_length + radius, radius};
    if (!near_box(way, half)) return false;
    const Vector a = way.from.position, d = way.move;
    if (half_length > 0.0f) {
        const float square = d.x * d.x + d.z * d.z, along = -(a.x * d.x + a.z * d.z);
        const float t = along > 0.0f ? (along < square ? along / square : 1.0f) : 0.0f;
        const float x = a.x + t * d.x, z = a.z + t * d.z;
        return x * x + z * z <= far * far;
    }
    const float square = dot(d, d), along = -dot(a, d);
    const float t = along > 0.0f ? (along < square ? along / square : 1.0f) : 0.0f;
    const Vector p = a + t * d;
    return dot(p, p) <= far * far;
}

bool near_hull(const Way& way, const HullGeometry& hull) {
    for (uint32_t f = 0; f < hull.face_count; ++f) {
        const float* face = hull.faces + size_t{4} * f;
        const Vector n{face[0], face[1], face[2]};
        if (std::min(dot(n, way.from.position), dot(n, way.to.position)) - way.reach > face[3]) return false;
    }
    return true;
}

bool near_triangle(const Way& way, const Triangle& t) {
    const float a = dot(t.normal, way.from.position - t.corners[0]), b = dot(t.normal, way.to.position - t.corners[0]);
    if (std::min(a, b) > way.reach || std::max(a, b) < -way.reach) return false;
    return reaches(way.box(), t);
}

float sweep_triangle(const Way& way, const Triangle& t) {
    return sweep(way, [&](Vector position) { return PlacedCollider(t.corners, position); });
}

// Of a row's columns [first, last), where these are very many, those about the way: a long one across a field goes over few of its cells.
void columns_under(const Way& way, const HeightfieldGeometry& field, uint32_t row, uint32_t& first, uint32_t& last) {
    constexpr uint32_t many = 64;
    if (last - first <= many) return;
    const Vector a = way.from.position, d = way.move;
    const float reach = way.reach + field.spacing[1], z = static_cast<float>(row) * field.spacing[1];
    float begin = 0.0f, end = 1.0f; // of the way
    if (d.z != 0.0f) {
        const float t = (z - reach - a.z) / d.z, u = (z + field.spacing[1] + reach - a.z) / d.z;
        begin = std::clamp(std::min(t, u), 0.0f, 1.0f);
        end = std::clamp(std::max(t, u), 0.0f, 1.0f);
    }
    const float low = a.x + (d.x < 0.0f ? end : begin) * d.x, high = a.x + (d.x < 0.0f ? begin : end) * d.x;
    // What rounding may take from both ends.
    const float more = way.reach + field.spacing[0] + 1e-5f * (std::abs(a.x) + std::abs(d.x));
    const Cells cells = cells_between(field, {{low - more, 0.0f, z}, {high + more, 0.0f, z}});
    first = std::max(first, cells.first[0]);
    last = std::min(last, cells.last[0]);
}

float sweep_heightfield(const Way& way, const HeightfieldGeometry& field) {
    const Vector a = way.from.position, b = way.to.position;
    const float lowest = std::min(a.y, b.y) - way.reach;
    if (lowest > field.highest) return 1.0f;
    const Cells cells = cells_between(field, way.box());
    if (cells.first[0] == cells.last[0] || cells.first[1] == cells.last[1]) return 1.0f;
    // From below the surface there is only the way up.
    const float width = static_cast<float>(field.counts[0] - 1) * field.spacing[0];
    const float depth = static_cast<float>(field.counts[1] - 1) * field.spacing[1];
    if (a.x >= 0.0f && a.z >= 0.0f && a.x <= width && a.z <= depth && a.y < height_at(field, a.x, a.z).height)
        return 1.0f;
    float least = 1.0f;
    for (uint32_t k = cells.first[1]; k < cells.last[1]; ++k) {
        uint32_t first = cells.first[0], last = cells.last[0];
        columns_under(way, field, k, first, last);
        for (uint32_t i = first; i < last; ++i)
            for (const bool second : {false, true}) {
                const Triangle t = field_triangle(field, i, k, second);
                if (std::max({t.corners[0].y, t.corners[1].y, t.corners[2].y}) < lowest || !near_triangle(way, t))
                    continue;
                least = std::min(least, sweep_triangle(way, t));
            }
    }
    return least;
}

} // namespace

float free_fraction(const BodyShape& shape, float scale, const Pose& from, const Pose& to, const Geometry& collider,
                    ColliderPart part) {
    if (collider.kind == ColliderKind::plane) return 1.0f; // solid below: the contacts see it from any depth
    const Way way(shape, scale, from, to);
    if (!(way.farthest > short_way * scale * shape.thickness)) return 1.0f;
    bool near = true;
    switch (collider.kind) {
    case ColliderKind::heightfield:
        return sweep_heightfield(way, *collider.heightfield);
    case ColliderKind::mesh: {
        float least = 1.0f;
        for (uint32_t i = part.first; i < part.first + part.count && i < collider.mesh->triangle_count; ++i) {
            const Triangle t = mesh_triangle(*collider.mesh, i);
            if (dot(t.normal, t.normal) > 0.5f && near_triangle(way, t))
                least = std::min(least, sweep_triangle(way, t));
        }
        return least;
    }
    case ColliderKind::sphere:
        near = near_axis(way, collider.size[0], 0.0f);
        break;
    case ColliderKind::capsule:
        near = near_axis(way, collider.size[0], collider.size[1]);
        break;
    case ColliderKind::hull:
        near = near_hull(way, *collider.hull);
        break;
    default:
        near = near_box(way, collider.size);
        break;
    }
    if (!near) return 1.0f;
    return sweep(way, [&](Vector position) { return PlacedCollider(collider, position); });
}

} // namespace lr
