#include "collision/collider_narrow_phase.h"

#include "collision/convex_separation.h"
#include "collision/triangle_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lr {
namespace {

void add_plane(ContactPoints& set) {
    const PlacedBody& body = set.body;
    const Vector up{0.0f, 1.0f, 0.0f};
    const float height = body.at.position.y;
    for (uint32_t i = 0; i < body.count; ++i) set.add_core(body.point(i), up, height + body.y[i]);
    if (body.count > 0) return;
    const Vector p = to_float(body.support({0.0, -1.0, 0.0}));
    set.add_core(p, up, height + p.y);
}

bool add_flat_side(ContactPoints& set, const Geometry& solid) {
    const PlacedBody& body = set.body;
    const Vector at = body.at.position, from = set.before ? set.before->position : at;
    const auto side = flat_side(solid, from, at, body.reach + body.radius);
    if (!side) return false;
    const Vector n = side->normal;
    const float height = dot(n, at) - side->offset;
    const auto gap = [&](Vector core) { return height + dot(n, core); };
    for (uint32_t i = 0; i < body.count; ++i) set.add_core(body.point(i), n, gap(body.point(i)));
    if (body.count > 0) return true;
    const Vector nearest = to_float(body.support(-to_double(n)));
    if (gap(nearest) >= set.margin) return true;
    set.add_core(nearest, n, gap(nearest));
    add_rims(set, to_double(n), gap(nearest), [&](Vector point, Vector& direction) {
        direction = n;
        return static_cast<double>(gap(point));
    });
    return true;
}

// On spheres larger than the body, the body can rest on its corners.
void add_sphere_points(ContactPoints& set, float radius) {
    for (uint32_t i = 0; i < set.body.count; ++i) {
        const Vector p = set.body.point(i), from = set.body.at.position + p;
        const float out = length(from);
        if (out > 0.5f * radius) set.add_core(p, 1.0f / out * from, out - radius);
    }
}

} // namespace

float distance_from(const Geometry& g, Vector p) {
    const auto beyond = [](float v, float h) { return std::max(std::abs(v) - h, 0.0f); };
    switch (g.kind) {
    case ColliderKind::plane:
        return p.y;
    case ColliderKind::sphere:
        return length(p) - g.size[0];
    case ColliderKind::capsule:
        return length(Vector{p.x, beyond(p.y, g.size[1]), p.z}) - g.size[0];
    case ColliderKind::box:
        return length(Vector{beyond(p.x, g.size[0]), beyond(p.y, g.size[1]), beyond(p.z, g.size[2])});
    case ColliderKind::hull: {
        float most = -std::numeric_limits<float>::infinity();
        for (uint32_t f = 0; f < g.hull->face_count; ++f)
            most = std::max(most, dot(g.hull->normal(f), p) - g.hull->offset(f));
        return most;
    }
    default:
        return 0.0f;
    }
}

std::optional<FlatSide> flat_side(const Geometry& solid, Vector from, Vector to, float far) {
    FlatSide side{{}, 0.0f};
    float most = 0.0f;
    if (solid.kind == ColliderKind::box) {
        for (uint32_t i = 0; i < 3; ++i) {
            if (std::max(std::abs(from[i]), std::abs(to[i])) + far <= solid.size[i]) continue;
            if (most > 0.0f || std::abs(from[i]) <= solid.size[i]) return {};
            most = std::abs(from[i]) - solid.size[i];
            side = {along_axis(i, from[i] < 0.0f ? -1.0f : 1.0f), solid.size[i]};
        }
    } else if (const HullGeometry* const hull = solid.hull) {
        uint32_t face = 0;
        for (uint32_t f = 0; f < hull->face_count; ++f)
            if (const float out = dot(hull->normal(f), from) - hull->offset(f); out > most) most = out, face = f;
        side = {hull->normal(face), hull->offset(face)};
        for (uint32_t k = 0, count = hull->corner_count(face); most > 0.0f && k < count; ++k) {
            const Vector corner = hull->corner(face, k), edge = hull->corner(face, (k + 1) % count) - corner;
            const Vector inward = cross(side.normal, edge);
            if (std::min(dot(inward, from - corner), dot(inward, to - corner)) < far * length(edge)) return {};
        }
    }
    return most > 0.0f ? std::optional(side) : std::nullopt;
}

uint32_t find_contacts(const BodyShape& shape, float scale, const Pose& at, const Geometry& collider, float margin,
                       Contact* out, const Pose* began, Vector lift) {
    const float far = scale * shape.reach + margin;
    if (distance_from(collider, at.position) > far) return 0;
    ContactPoints set(shape, scale, at, margin, began);
    set.up = direction_of(lift);
    switch (collider.kind) {
    case ColliderKind::plane:
        add_plane(set);
        break;
    case ColliderKind::heightfield:
        add_heightfield(set, *collider.heightfield);
        break;
    default: {
        if (add_flat_side(set, collider)) break;
        const PlacedCollider placed(collider, at.position);
        const double enough = static_cast<double>(margin + set.body.radius) + placed.radius;
        const Separation along = separate(set.body, placed, enough, {.up = set.up});
        if (along.distance >= enough) break;
        if (collider.kind == ColliderKind::sphere && collider.size[0] > set.body.reach)
            add_sphere_points(set, collider.size[0]);
        add_manifold(set, placed, along);
        break;
    }
    }
    return set.keep(out, true);
}

namespace {

// Swept test: conservative advancement (Mirtich 1996) along the normal of largest separation.

constexpr uint32_t most_rounds = 24, most_tries = 4;
// Distance that counts as touching, as shares of the body's thickness and its reach; the lesser counts.
constexpr float touching = 0.1f, touching_reach = 0.01f;
// Paths shorter than this share of the body's thickness jump over nothing.
constexpr float short_way = 0.25f;

struct Way {
    const BodyShape& shape;
    float scale;
    Pose from, to; // quaternions with the same sign
    Vector move;
    Vector axis;    // of the rotation, unit
    float turn;     // rad, an upper bound
    float reach;    // m, of the body about its centre of mass, rounding included
    float farthest; // m: bound of any point's displacement
    float tolerance;

    Way(const BodyShape& body, float body_scale, const Pose& a, const Pose& b)
        : shape(body), scale(body_scale), from(a), to(b), move(b.position - a.position), axis{0.0f, 0.0f, 0.0f},
          turn(0.0f), reach(body_scale * body.reach), farthest(0.0f),
          tolerance(body_scale * std::min(touching * body.thickness, touching_reach * body.reach)) {
        Rotation& q = to.rotation;
        const Rotation r = a.rotation;
        if (dot(q, r) < 0.0f) q = -1.0f * q;
        const Rotation by = q * inverse(r);
        const Vector sine{by.x, by.y, by.z};
        const float size = length(sine);
        if (size > 0.0f) axis = 1.0f / size * sine;
        // 4 tan(turn/4) is an upper bound of the turn: the greatest spin of the normalised linear quaternion times the time.
        turn = 4.0f * std::sqrt(dot(q - r, q - r) / dot(q + r, q + r));
        farthest = length(move) + turn * reach;
    }

    // Box around the whole path.
    Box box() const { return grown({low_of(from.position, to.position), high_of(from.position, to.position)}, reach); }
    Pose at(float t) const {
        return {from.position + t * move, normalised((1.0f - t) * from.rotation + t * to.rotation)};
    }
};

// Fraction of the path at which the cores, the body's scaled by `size`, are `target` apart; 1 if they approach by at most `slack`. collider(position)
// places the collider.
template <typename Place>
float advance(const Way& way, float size, double first, double target, double slack, Double3 normal,
              const Place& collider) {
    float t = 0.0f;
    double distance = first;
    for (uint32_t round = 0; round < most_rounds; ++round) {
        const double sideways = length(cross(normal, to_double(way.axis)));
        const double lever = sideways * static_cast<double>(size * way.reach);
        const double room = distance - target;
        float step = 1.0f - t;
        bool moved = false;
        for (uint32_t i = 0; i < most_tries; ++i) {
            const Pose pose = way.at(t + step);
            const double then =
                separation_along(PlacedBody(way.shape, way.scale, pose, size), collider(pose.position), normal);
            // Between two poses the gap may be less than the linear interpolation by an eighth of the acceleration: that of the arc, and that of the
            // normalised linear quaternion, which does not rotate at a steady rate.
            const auto turn = static_cast<double>(way.turn), part = static_cast<double>(step);
            const double bulge = 0.125 * lever * turn * turn * (1.0 + 0.25 * turn) * part * part;
            if (std::min(distance, then) - bulge >= target - (i == 0 ? slack : 0.0)) {
                if (i == 0) return 1.0f;
                moved = true;
                break;
            }
            if (room <= static_cast<double>(way.tolerance)) return t;
            const double fall = std::max(distance - then, 0.0) + bulge;
            step *= static_cast<float>(std::min(0.99 * room / fall, 0.9));
        }
        if (!moved) { // advances by the greatest approach rate of any point instead
            const double rate =
                std::max(-dot(normal, to_double(way.move)), 0.0) + static_cast<double>(way.turn) * lever;
            step = std::min(step, static_cast<float>(0.99 * room / rate));
        }
        if (!(step > 1e-6f)) return t;
        t += step;
        const Pose pose = way.at(t);
        const PlacedBody body(way.shape, way.scale, pose, size);
        const Nearest nearest = nearest_points(body, collider(pose.position), std::numeric_limits<double>::infinity());
        if (nearest.overlap) return t; // to rounding: along the former normal they are apart
        distance = nearest.lower;
        normal = nearest.normal;
        if (distance - target <= 0.0) return t;
    }
    return t;
}

// A body that already touches must not pass through either. Its core keeps half of the rounding, or three quarters of the remaining distance. If the
// core overlaps too, the core shrunk to a half does, or its centre.
template <typename Place> float sweep(const Way& way, const Place& collider) {
    for (const float size : core_sizes) {
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
    const Box box = way.box();
    for (uint32_t i = 0; i < 3; ++i)
        if (box.low[i] > half[i] || box.high[i] < -half[i]) return false;
    return true;
}

// Whether the centre's path comes near a segment along y (a point if half_length is 0).
bool near_axis(const Way& way, float radius, float half_length) {
    const float far = radius + way.reach, half[3] = {radius, half_length + radius, radius};
    if (!near_box(way, half)) return false;
    Vector a = way.from.position, d = way.move;
    if (half_length > 0.0f) a.y = d.y = 0.0f;
    const float square = dot(d, d), along = -dot(a, d);
    const float t = along > 0.0f ? (along < square ? along / square : 1.0f) : 0.0f;
    const Vector p = a + t * d;
    return dot(p, p) <= far * far;
}

bool near_hull(const Way& way, const HullGeometry& hull) {
    for (uint32_t f = 0; f < hull.face_count; ++f) {
        const Vector n = hull.normal(f);
        if (std::min(dot(n, way.from.position), dot(n, way.to.position)) - way.reach > hull.offset(f)) return false;
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

// A long path crosses few cells of a row: limits columns [first, last) to those near it, if there are many.
void columns_under(const Way& way, const HeightfieldGeometry& field, uint32_t row, uint32_t& first, uint32_t& last) {
    constexpr uint32_t many = 64;
    if (last - first <= many) return;
    const Vector a = way.from.position, d = way.move;
    const float reach = way.reach + field.spacing[1], z = static_cast<float>(row) * field.spacing[1];
    float begin = 0.0f, end = 1.0f; // fractions of the path
    if (d.z != 0.0f) {
        const float t = (z - reach - a.z) / d.z, u = (z + field.spacing[1] + reach - a.z) / d.z;
        begin = std::clamp(std::min(t, u), 0.0f, 1.0f);
        end = std::clamp(std::max(t, u), 0.0f, 1.0f);
    }
    const float low = a.x + (d.x < 0.0f ? end : begin) * d.x, high = a.x + (d.x < 0.0f ? begin : end) * d.x;
    // The margin covers rounding.
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
    // A body below the surface is not swept: contacts push it up.
    if (field.covers(a.x, a.z) && a.y < height_at(field, a.x, a.z).height) return 1.0f;
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

// Shorter paths jump over nothing.
bool sweeps(const Way& way) {
    return way.farthest > short_way * way.scale * way.shape.thickness;
}

} // namespace

MetTriangle first_triangle(const BodyShape& shape, float scale, const Pose& from, const Pose& to,
                           const MeshGeometry& mesh, ColliderPart part, SkipTriangle skips, const void* context) {
    const Way way(shape, scale, from, to);
    MetTriangle least{1.0f, 0};
    if (!sweeps(way)) return least;
    for (uint32_t i = part.first; i < part.first + part.count && i < mesh.triangle_count; ++i) {
        const Triangle t = mesh_triangle(mesh, i);
        if (!(dot(t.normal, t.normal) > 0.5f) || !near_triangle(way, t) || skips(context, t, i)) continue;
        const float free = sweep_triangle(way, t);
        if (free < least.free) least = {free, i};
    }
    return least;
}

float free_fraction(const BodyShape& shape, float scale, const Pose& from, const Pose& to, const Geometry& collider) {
    if (collider.kind == ColliderKind::plane) return 1.0f; // solid below: contacts push out from any depth
    const Way way(shape, scale, from, to);
    if (!sweeps(way)) return 1.0f;
    if (collider.kind == ColliderKind::heightfield) return sweep_heightfield(way, *collider.heightfield);
    const bool round = collider.kind == ColliderKind::sphere || collider.kind == ColliderKind::capsule;
    const float half_length = collider.kind == ColliderKind::capsule ? collider.size[1] : 0.0f;
    const bool near = round           ? near_axis(way, collider.size[0], half_length)
                      : collider.hull ? near_hull(way, *collider.hull)
                                      : near_box(way, collider.size);
    if (!near) return 1.0f;
    return sweep(way, [&](Vector position) { return PlacedCollider(collider, position); });
}
} // namespace lr
