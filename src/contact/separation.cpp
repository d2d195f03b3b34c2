#include "contact/separation.h"

#include "contact/ccd_pair.h"

#include <limits>

namespace lr {
namespace {

// libccd's direction has to be better by this part of the depth: what closed forms find as well, they answer.
constexpr double ccd_advantage = 0.01;
constexpr uint32_t most_refinements = 3;
constexpr double step_out = 1e-3; // of the body's reach, past touching, when a direction is refined

struct Search {
    const PlacedBody& body;
    const PlacedCollider& collider;
    const Sides& sides;
    Separation best{};
    bool any = false;

    bool allowed(Double3 n) const { return !sides.one || dot(n, sides.front) > 0.0; }
    void offer(Double3 n, double distance) {
        if (any && !(distance > best.distance)) return;
        any = true;
        best.normal = n;
        best.distance = distance;
    }
    void offer(Double3 n) {
        if (allowed(n)) offer(n, separation_along(body, collider, n));
    }
};

void offer_box(Search& search) {
    const Double3 half = search.collider.half, at = search.collider.origin;
    const double halves[3] = {half.x, half.y, half.z}, origin[3] = {at.x, at.y, at.z};
    for (uint32_t i = 0; i < 3; ++i)
        for (const double sign : {1.0, -1.0}) {
            const Double3 n{i == 0 ? sign : 0.0, i == 1 ? sign : 0.0, i == 2 ? sign : 0.0};
            // The centre of mass is in the body: it is no farther out than that.
            if (search.any && -sign * origin[i] - halves[i] <= search.best.distance) continue;
            search.offer(n, dot(n, search.body.support(-n)) - (sign * origin[i] + halves[i]));
        }
}

void offer_hull(Search& search) {
    const HullGeometry& hull = *search.collider.hull;
    const Double3 center = to_double(search.body.center);
    for (uint32_t f = 0; f < hull.face_count; ++f) {
        const float* face = hull.faces + size_t{4} * f;
        const Double3 n = to_double({face[0], face[1], face[2]});
        const double plane = static_cast<double>(face[3]) + dot(n, search.collider.origin);
        if (search.any && dot(n, center) - plane <= search.best.distance) continue;
        search.offer(n, dot(n, search.body.support(-n)) - plane);
    }
}

void offer_body_faces(Search& search) {
    const PlacedBody& body = search.body;
    const Double3 other = search.collider.middle();
    for (uint32_t f = 0; f < body.shape->face_count; ++f) {
        const ShapeFace& face = body.shape->faces[f];
        const Double3 n = -to_double(body.face_normal(f));
        const double plane = -static_cast<double>(body.scale) * static_cast<double>(face.offset);
        if (!search.allowed(n) || (search.any && plane - dot(n, other) <= search.best.distance)) continue;
        search.offer(n, plane - dot(n, search.collider.support(n)));
    }
}

// With the body moved out along a direction, the pair's nearest points give a better one.
void refine(Search& search, Separation from) {
    for (uint32_t round = 0; round < most_refinements; ++round) {
        const double out = step_out * static_cast<double>(search.body.reach) - from.distance;
        PlacedCollider moved = search.collider;
        const Double3 by = -out * from.normal;
        moved.origin = moved.origin + by;
        for (uint32_t i = 0; i < moved.count; ++i) moved.points[i] = moved.points[i] + by;
        const Nearest nearest = nearest_points(search.body, moved, std::numeric_limits<double>::infinity());
        if (nearest.overlap || !search.allowed(nearest.normal)) return;
        const double distance = separation_along(search.body, search.collider, nearest.normal);
        // The rest is rounding.
        if (!(distance > from.distance + 1e-4 * (out < 0.0 ? 0.0 : out))) return;
        from.normal = nearest.normal;
        from.distance = distance;
        if (distance > search.best.distance + 1e-4 * (out < 0.0 ? 0.0 : out)) search.offer(from.normal, distance);
    }
}

} // namespace

Separation separate_from_plane(const PlacedBody& body, const PlacedCollider& collider, Double3 normal, bool one_sided) {
    Separation out{};
    out.normal = normal;
    out.distance = separation_along(body, collider, normal);
    if (one_sided) return out;
    const double back = separation_along(body, collider, -normal);
    if (back > out.distance) {
        out.normal = -normal;
        out.distance = back;
    }
    return out;
}

Separation separate(const PlacedBody& body, const PlacedCollider& collider, double enough, const Sides& sides) {
    const Nearest nearest = nearest_points(body, collider, enough);
    if (!nearest.overlap && (!sides.one || dot(nearest.normal, sides.front) > 0.0))
        return {nearest.normal, nearest.lower, true, nearest.on_body, nearest.on_collider};

    Search search{body, collider, sides, {}, false};
    if (collider.count == 0) {
        if (collider.hull)
            offer_hull(search);
        else
            offer_box(search);
    } else if (collider.count == 3) {
        const Double3 across = cross(collider.points[1] - collider.points[0], collider.points[2] - collider.points[0]);
        const double square = dot(across, across);
        if (square > 0.0) {
            const Double3 n = 1.0 / std::sqrt(square) * across;
            search.offer(n);
            search.offer(-n);
        }
    } else if (collider.count == 2) {
        // Across the axis, to where most of the body is, and along the body's own axes across it.
        const Double3 axis = collider.points[1] - collider.points[0];
        const Double3 to = to_double(body.center) - collider.middle();
        const double square = dot(axis, axis);
        const Double3 across = square > 0.0 ? to - (dot(to, axis) / square) * axis : to;
        const double size = length(across);
        if (size > 0.0) search.offer(1.0 / size * across);
    } else {
        const Double3 to = to_double(body.center) - collider.points[0];
        const double size = length(to);
        if (size > 0.0) search.offer(1.0 / size * to);
    }
    const Separation of_collider = search.best;
    const bool has_collider = search.any;
    search.any = false;
    offer_body_faces(search);
    if (body.count == 0 && collider.count < 3) // an ellipsoid's own axes
        for (const Vector& a : body.axes) {
            const double size = length(to_double(a));
            if (!(size > 0.0)) continue;
            search.offer(1.0 / size * to_double(a));
            search.offer(-1.0 / size * to_double(a));
        }
    const Separation of_body = search.best;
    const bool has_body = search.any;
    if (has_collider) search.offer(of_collider.normal, of_collider.distance);
    if (!search.any) search.offer(sides.one ? sides.front : Double3{0.0, 1.0, 0.0});
    Double3 direction;
    // A sphere's centre in a hull is farthest out along one of its faces: nothing is better.
    if (!(collider.count == 1 && body.count > 0)) {
        // Each is the start of a way to a least depth nearby.
        if (has_collider) refine(search, of_collider);
        if (has_body) refine(search, of_body);
        if (!has_collider && !has_body) refine(search, search.best);
        if (ccd_direction(body, collider, direction) && search.allowed(direction)) {
            Search other = search;
            other.best = {direction, separation_along(body, collider, direction), false, {}, {}};
            refine(other, other.best);
            if (other.best.distance > search.best.distance * (1.0 - ccd_advantage)) search.best = other.best;
        }
    }
    return search.best;
}

} // namespace lr
