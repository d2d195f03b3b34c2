#include "kernel/compiled_once.h"

#include "collision/convex_separation.h"

#include "kernel/contact/gjk-inl.h"

#include <ccd/ccd.h>
#include <limits>

namespace lr {
namespace {

using Lane = HWY_NAMESPACE::OnePair<double, Double3, true, 40>;
// converged: relative to the square of the distance. touching: relative to the pair's size; closer points give no meaningful direction.
constexpr double converged = 1e-7, touching = 1e-7;

// A guess of the normal: unit, from the collider to the body.
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

static_assert(sizeof(ccd_real_t) == sizeof(double), "libccd has to be built for double precision");

// Refinement stops at libccd's own limit, but its search for a portal has none: past this many supports all points are equal, which ends it.
constexpr uint32_t most_supports = 400;

struct Side {
    const PlacedBody* body;
    const PlacedCollider* collider;
    Double3 middle;
    double inverse_size; // libccd's tolerances are absolute: scales the pair to a size of about 1
    uint32_t* calls;
};

void set(ccd_vec3_t* to, const Side& side, Double3 p) {
    const Double3 q = side.inverse_size * p;
    ccdVec3Set(to, q.x, q.y, q.z);
}

void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* out) {
    const Side& side = *static_cast<const Side*>(object);
    if (++*side.calls > most_supports) return set(out, side, side.middle);
    const Double3 d{ccdVec3X(direction), ccdVec3Y(direction), ccdVec3Z(direction)};
    const double square = dot(d, d);
    if (!(square > 0.0)) return set(out, side, side.middle);
    set(out, side, side.body ? side.body->support(1.0 / std::sqrt(square) * d) : side.collider->support(d));
}

void middle(const void* object, ccd_vec3_t* out) {
    const Side& side = *static_cast<const Side*>(object);
    set(out, side, side.middle);
}
} // namespace

HWY_ATTR Nearest nearest_points(const PlacedBody& body, const PlacedCollider& collider, double enough) {
    const auto support = [&](Double3 direction) {
        const Double3 on_body = body.support(-direction);
        return HWY_NAMESPACE::Corner<Lane>{on_body - collider.support(direction), on_body};
    };
    const auto found =
        HWY_NAMESPACE::closest<Lane>(support, between(body, collider), enough, touching, 0.5 * converged);
    // If rounding prevented convergence, the best normal is not that of the last points.
    const bool overlap = found.overlap || !(found.lower >= 0.0);
    return {overlap, found.distance, found.lower, found.normal, found.on_a, found.on_a - found.v};
}

bool ccd_direction(const PlacedBody& body, const PlacedCollider& collider, Double3& direction) {
    uint32_t calls = 0;
    const double size = static_cast<double>(body.reach > 0.0f ? body.reach : 1.0f);
    const Side one{&body, nullptr, to_double(body.center), 1.0 / size, &calls};
    const Side other{nullptr, &collider, collider.middle(), 1.0 / size, &calls};
    ccd_t ccd{}; // CCD_INIT would link libccd's other algorithm
    ccd.support1 = ccd.support2 = support;
    ccd.center1 = ccd.center2 = middle;
    ccd.max_iterations = 50;
    ccd.mpr_tolerance = 1e-5;
    ccd_real_t depth = 0.0;
    ccd_vec3_t out, at;
    ccdVec3Set(&out, 0.0, 0.0, 0.0);
    ccdVec3Set(&at, 0.0, 0.0, 0.0);
    // Moves the second out of the first, along `out`.
    if (ccdMPRPenetration(&other, &one, &ccd, &depth, &out, &at) != 0 || calls > most_supports) return false;
    const Double3 d{ccdVec3X(&out), ccdVec3Y(&out), ccdVec3Z(&out)};
    const double square = dot(d, d);
    if (!(square > 0.25 && square < 4.0)) return false;
    direction = 1.0 / std::sqrt(square) * d;
    return true;
}

namespace {

// libccd's direction must be better by this share of the depth: otherwise closed forms decide.
constexpr double ccd_advantage = 0.01;
constexpr uint32_t most_refinements = 3;
constexpr double step_out = 1e-3; // share of the body's reach beyond touching, when a direction is refined

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

// Tries one of the collider's sides, unless a point in the body shows that it is not better.
void offer_side(Search& search, Double3 n, double plane, Double3 in_body) {
    if (search.any && dot(n, in_body) - plane <= search.best.distance) return;
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

// Tries a direction, if it has a length.
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

// Improves a direction by the pair's nearest points with the body moved out along it.
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
        offer_sides(search);
    } else if (collider.count == 3) {
        offer_along(search, cross(collider.points[1] - collider.points[0], collider.points[2] - collider.points[0]),
                    true);
    } else if (collider.count == 2) {
        // Tries directions across the axis, towards the body, and along the body's own axes across it.
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
    if (!search.any) search.offer(sides.one ? sides.front : Double3{0.0, 1.0, 0.0});
    Double3 direction;
    // For a sphere's centre in a hull the best direction is one of the faces.
    if (!(collider.count == 1 && body.count > 0)) {
        // Each leads to a local minimum of the depth.
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
