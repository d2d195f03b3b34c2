#include "kernel/compiled_once.h"

#include "collision/convex_separation.h"

#include "kernel/contact/gjk-inl.h"

#include <limits>

namespace lr {
namespace {

using Lane = HWY_NAMESPACE::OnePair<double, Double3, true, 40>;
// converged: relative to the squared distance. touching: relative to the pair's size; the direction between closer points is only rounding.
constexpr double converged = 1e-7, touching = 1e-7;

// First guess of the normal: unit, from the collider to the body.
Double3 between(const PlacedBody& body, const PlacedCollider& collider) {
    Double3 out = to_double(body.center) - collider.middle();
    if (collider.count == 0 && !collider.hull) {
        const auto beyond = [](double v, double h) { return v < -h ? v + h : v > h ? v - h : 0.0; };
        const Double3 half = collider.half;
        out = {beyond(out.x, half.x), beyond(out.y, half.y), beyond(out.z, half.z)};
    }
    const double size = length(out);
    return size > 0.0 ? 1.0 / size * out : Double3{0.0, 1.0, 0.0};
}
} // namespace

HWY_ATTR Nearest nearest_points(const PlacedBody& body, const PlacedCollider& collider, double enough,
                                const Double3* guess) {
    const auto support = [&](Double3 direction) {
        const Double3 on_body = body.support(-direction);
        return HWY_NAMESPACE::Corner<Lane>{on_body - collider.support(direction), on_body};
    };
    const auto found = HWY_NAMESPACE::closest<Lane>(support, guess ? *guess : between(body, collider), enough, touching,
                                                    0.5 * converged);
    // If rounding prevented convergence, the best normal is not that of the last points.
    const bool overlap = found.overlap || !(found.lower >= 0.0);
    return {overlap, found.distance, found.lower, found.normal, found.on_a, found.on_a - found.v};
}

namespace {

constexpr uint32_t most_refinements = 3;
constexpr double step_out = 1e-3; // share of the reach by which the body is moved beyond touching
// Sine of 3 degrees: up and out of the joint of two tiles leads along their walls, and rounding must not decide on it.
constexpr double along_side = 0.05;

struct Search {
    const PlacedBody& body;
    const PlacedCollider& collider;
    const Sides& sides;
    Separation best{};
    bool any = false;

    bool allowed(Double3 n) const {
        return dot(n, sides.front) > sides.least - along_side && dot(n, sides.up) > into_support;
    }
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

// Tries a side of the collider, unless a point inside the body shows that it cannot be better.
void offer_side(Search& search, Double3 n, double plane, Double3 in_body) {
    if (!search.allowed(n) || (search.any && dot(n, in_body) - plane <= search.best.distance)) return;
    search.offer(n, dot(n, search.body.support(-n)) - plane);
}

void offer_sides(Search& search) {
    const PlacedCollider& c = search.collider;
    if (c.hull) {
        for (uint32_t f = 0; f < c.hull->face_count; ++f) {
            const Double3 n = to_double(c.hull->normal(f));
            offer_side(search, n, wide(c.hull->offset(f)) + dot(n, c.origin), to_double(search.body.center));
        }
        return;
    }
    for (uint32_t i = 0; i < 3; ++i) // for a box; the body's centre of mass is the origin
        for (const double sign : {1.0, -1.0})
            offer_side(search, along_axis(i, sign), sign * c.origin[i] + c.half[i], {0.0, 0.0, 0.0});
}

// Tries a direction, unless it is zero.
void offer_along(Search& search, Double3 way, bool both_ways = false) {
    const double size = length(way);
    if (!(size > 0.0)) return;
    search.offer(1.0 / size * way);
    if (both_ways) search.offer(-(1.0 / size * way));
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

// Moves the body out along a direction; the nearest points there give a better one.
void refine(Search& search, Separation from) {
    for (uint32_t round = 0; round < most_refinements; ++round) {
        const double out = step_out * static_cast<double>(search.body.reach) - from.distance;
        PlacedCollider moved = search.collider;
        const Double3 by = -out * from.normal;
        moved.origin = moved.origin + by;
        for (uint32_t i = 0; i < moved.count; ++i) moved.points[i] = moved.points[i] + by;
        const Nearest nearest =
            nearest_points(search.body, moved, std::numeric_limits<double>::infinity(), &from.normal);
        if (nearest.overlap || !search.allowed(nearest.normal)) return;
        const double distance = separation_along(search.body, search.collider, nearest.normal);
        // Further gain would be rounding.
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

Separation separate(const PlacedBody& body, const PlacedCollider& collider, const Nearest& nearest,
                    const Sides& sides) {
    if (!nearest.overlap && (sides.least < 0.0 || dot(nearest.normal, sides.front) > 0.0))
        return {nearest.normal, nearest.lower, true, nearest.on_body, nearest.on_collider};

    Search search{body, collider, sides, {}, false};
    if (collider.count == 0) {
        offer_sides(search);
    } else if (collider.count == 3) {
        offer_along(search, cross(collider.points[1] - collider.points[0], collider.points[2] - collider.points[0]),
                    true);
    } else if (collider.count == 2) {
        // Tries directions across the capsule's axis: towards the body, and along the body's own axes.
        const Double3 axis = collider.points[1] - collider.points[0];
        const Double3 to = to_double(body.center) - collider.middle();
        const double square = dot(axis, axis);
        offer_along(search, square > 0.0 ? to - (dot(to, axis) / square) * axis : to);
    } else {
        offer_along(search, to_double(body.center) - collider.points[0]);
    }
    const Separation of_collider = search.best;
    const bool has_collider = search.any;
    search.any = false;
    offer_body_faces(search);
    if (body.count == 0 && collider.count < 3) // an ellipsoid's own axes
        for (const Vector& a : body.axes) offer_along(search, to_double(a), true);
    const Separation of_body = search.best;
    const bool has_body = search.any;
    if (has_collider) search.offer(of_collider.normal, of_collider.distance);
    if (!search.any) {
        const Double3 n = sides.least == 0.0 ? sides.front : Double3{0.0, 1.0, 0.0};
        search.offer(n, separation_along(body, collider, n));
    }
    // For a sphere against a polytope a face normal is exact.
    if (collider.count == 1 && body.count > 0) return search.best;
    // Each start leads to a local minimum of the depth. Out of a triangle on a known side some hardly ever lead to a lesser one, and took half of the time
    // on rough ground.
    const bool known_side = collider.count == 3 && sides.least == 0.0;
    if (has_collider) refine(search, of_collider);
    if (has_body && !(known_side && has_collider && of_collider.distance >= of_body.distance)) refine(search, of_body);
    if (!has_collider && !has_body) refine(search, search.best);
    if (collider.count == 1 || known_side) return search.best; // of a point the line between the middles has been tried
    const Double3 apart = to_double(body.center) - collider.middle();
    const double size = length(apart);
    if (const Double3 n = 1.0 / size * apart; size > 0.0 && search.allowed(n))
        refine(search, {n, separation_along(body, collider, n), false, {}, {}});
    return search.best;
}
} // namespace lr
