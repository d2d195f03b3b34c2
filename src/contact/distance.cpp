#include "contact/distance.h"

#include <limits>

namespace lr {
namespace {

struct Corner {
    Double3 difference, on_body, on_collider;
};

struct Simplex {
    uint32_t count = 0;
    Corner corners[4] = {};
    double weights[4] = {};

    Double3 point() const {
        Double3 sum{0.0, 0.0, 0.0};
        for (uint32_t i = 0; i < count; ++i) sum = sum + weights[i] * corners[i].difference;
        return sum;
    }
    bool holds(Double3 p) const {
        for (uint32_t i = 0; i < count; ++i) {
            const Double3 d = corners[i].difference - p;
            if (d.x == 0.0 && d.y == 0.0 && d.z == 0.0) return true;
        }
        return false;
    }
};

Simplex of_one(const Corner& a) {
    Simplex s;
    s.count = 1;
    s.corners[0] = a;
    s.weights[0] = 1.0;
    return s;
}

Simplex of_two(const Corner& a, const Corner& b) {
    const Double3 ab = b.difference - a.difference;
    const double along = -dot(a.difference, ab), square = dot(ab, ab);
    if (!(along > 0.0)) return of_one(a);
    if (along >= square) return of_one(b);
    Simplex s;
    s.count = 2;
    s.corners[0] = a;
    s.corners[1] = b;
    s.weights[1] = along / square;
    s.weights[0] = 1.0 - s.weights[1];
    return s;
}

// Regions of a triangle after Ericson, Real-Time Collision Detection (2005), 5.1.5, for the origin.
Simplex of_three(const Corner& a, const Corner& b, const Corner& c) {
    const Double3 ab = b.difference - a.difference, ac = c.difference - a.difference;
    const double d1 = -dot(ab, a.difference), d2 = -dot(ac, a.difference);
    if (d1 <= 0.0 && d2 <= 0.0) return of_one(a);
    const double d3 = -dot(ab, b.difference), d4 = -dot(ac, b.difference);
    if (d3 >= 0.0 && d4 <= d3) return of_one(b);
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return of_two(a, b);
    const double d5 = -dot(ab, c.difference), d6 = -dot(ac, c.difference);
    if (d6 >= 0.0 && d5 <= d6) return of_one(c);
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return of_two(a, c);
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) return of_two(b, c);
    const double sum = va + vb + vc;
    if (!(sum > 0.0)) return of_two(a, b);
    Simplex s;
    s.count = 3;
    s.corners[0] = a;
    s.corners[1] = b;
    s.corners[2] = c;
    s.weights[1] = vb / sum;
    s.weights[2] = vc / sum;
    s.weights[0] = 1.0 - s.weights[1] - s.weights[2];
    return s;
}

// Count 4: the origin is inside.
Simplex of_four(const Simplex& from) {
    constexpr uint32_t faces[4][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 3, 2, 0}};
    Simplex best = from;
    double least = std::numeric_limits<double>::infinity();
    for (const auto& f : faces) {
        const Corner &a = from.corners[f[0]], &b = from.corners[f[1]], &c = from.corners[f[2]];
        const Double3 normal = cross(b.difference - a.difference, c.difference - a.difference);
        const double fourth = dot(normal, from.corners[f[3]].difference - a.difference);
        const double origin = -dot(normal, a.difference);
        if (fourth * origin > 0.0) continue;
        const Simplex s = of_three(a, b, c);
        const Double3 p = s.point();
        if (dot(p, p) < least) {
            least = dot(p, p);
            best = s;
        }
    }
    return best;
}

Simplex reduced(const Simplex& s) {
    switch (s.count) {
    case 1:
        return of_one(s.corners[0]);
    case 2:
        return of_two(s.corners[0], s.corners[1]);
    case 3:
        return of_three(s.corners[0], s.corners[1], s.corners[2]);
    default:
        return of_four(s);
    }
}

constexpr uint32_t most_rounds = 40;
constexpr double converged = 1e-7;
// Of the pair's size, below which a distance has no direction that means anything.
constexpr double touching = 1e-7;

} // namespace

Nearest nearest_points(const PlacedBody& body, const PlacedCollider& collider, double enough) {
    Nearest out{};
    const auto corner = [&](Double3 direction) {
        Corner c;
        c.on_body = body.support(-direction);
        c.on_collider = collider.support(direction);
        c.difference = c.on_body - c.on_collider;
        return c;
    };
    Simplex simplex;
    if (collider.count == 0 && !collider.hull) {
        const Double3 at = to_double(body.center) - collider.origin;
        const auto clamp = [](double v, double h) { return v < -h ? -h : v > h ? h : v; };
        const Double3 out_of =
            at - Double3{clamp(at.x, collider.half.x), clamp(at.y, collider.half.y), clamp(at.z, collider.half.z)};
        const double square = dot(out_of, out_of);
        simplex = of_one(corner(square > 0.0 ? out_of : Double3{0.0, 1.0, 0.0}));
    } else {
        simplex = of_one(corner(to_double(body.center) - collider.middle()));
    }
    Double3 v = simplex.point();
    double square = dot(v, v), size = square;
    out.lower = -std::numeric_limits<double>::infinity();
    for (uint32_t round = 0; round < most_rounds; ++round) {
        if (square <= touching * touching * size || simplex.count == 4) {
            out.overlap = true;
            return out;
        }
        const double distance = std::sqrt(square);
        const Corner next = corner(v);
        const double along = dot(v, next.difference);
        if (along > out.lower * distance) {
            out.lower = along / distance;
            out.normal = 1.0 / distance * v;
        }
        if (out.lower > enough || square - along <= converged * square || simplex.holds(next.difference)) break;
        Simplex larger = simplex;
        larger.corners[larger.count++] = next;
        larger = reduced(larger);
        const double reach = dot(next.difference, next.difference);
        size = reach > size ? reach : size;
        const Double3 p = larger.point();
        const double nearer = dot(p, p);
        if (larger.count < 4 && !(nearer < square)) break;
        simplex = larger;
        v = p;
        square = nearer;
    }
    out.distance = std::sqrt(square);
    // Where rounding kept the rounds from closing, the best normal seen is not that of the last points.
    if (out.lower < 0.0) {
        out.overlap = true;
        return out;
    }
    out.on_body = out.on_collider = {0.0, 0.0, 0.0};
    for (uint32_t i = 0; i < simplex.count; ++i) {
        out.on_body = out.on_body + simplex.weights[i] * simplex.corners[i].on_body;
        out.on_collider = out.on_collider + simplex.weights[i] * simplex.corners[i].on_collider;
    }
    return out;
}

} // namespace lr
