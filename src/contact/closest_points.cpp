#include "contact/placed_pair.h"

namespace lr {
namespace {

// Of the pair's size: nearer than this, rounding decides what the direction is.
constexpr float touching = 3e-5f;
constexpr uint32_t most_rounds = 24;

struct Simplex {
    uint32_t count = 0;
    Vector w[4];
    uint32_t i[4], j[4]; // points of a and b
    float weights[4];
};

// The nearest point of a simplex to the origin; keeps its corners that hold it up. False: the origin is inside.
Vector keep_one(Simplex& s, uint32_t a) {
    s.w[0] = s.w[a];
    s.i[0] = s.i[a];
    s.j[0] = s.j[a];
    s.weights[0] = 1.0f;
    s.count = 1;
    return s.w[0];
}
Vector keep_two(Simplex& s, uint32_t a, uint32_t b, float along_b) {
    const Simplex from = s;
    s.count = 2;
    const uint32_t kept[2] = {a, b};
    for (uint32_t k = 0; k < 2; ++k) {
        s.w[k] = from.w[kept[k]];
        s.i[k] = from.i[kept[k]];
        s.j[k] = from.j[kept[k]];
    }
    s.weights[0] = 1.0f - along_b;
    s.weights[1] = along_b;
    return s.w[0] + along_b * (s.w[1] - s.w[0]);
}
Vector of_two(Simplex& s, uint32_t a, uint32_t b) {
    const Vector ab = s.w[b] - s.w[a];
    const float along = -dot(s.w[a], ab), square = dot(ab, ab);
    if (!(along > 0.0f)) return keep_one(s, a);
    if (along >= square) return keep_one(s, b);
    return keep_two(s, a, b, along / square);
}
// Regions of a triangle after Ericson, Real-Time Collision Detection (2005), 5.1.5, for the origin.
Vector of_three(Simplex& s, uint32_t a, uint32_t b, uint32_t c) {
    const Vector wa = s.w[a], wb = s.w[b], wc = s.w[c], ab = wb - wa, ac = wc - wa;
    const float d1 = -dot(ab, wa), d2 = -dot(ac, wa);
    if (d1 <= 0.0f && d2 <= 0.0f) return keep_one(s, a);
    const float d3 = -dot(ab, wb), d4 = -dot(ac, wb);
    if (d3 >= 0.0f && d4 <= d3) return keep_one(s, b);
    const float d5 = -dot(ab, wc), d6 = -dot(ac, wc);
    if (d6 >= 0.0f && d5 <= d6) return keep_one(s, c);
    const Vector n = cross(ab, ac);
    // Twice the areas that the origin spans with each side, in the triangle's sense.
    const float vc = dot(n, cross(wa, wb)), vb = dot(n, cross(wc, wa)), va = dot(n, cross(wb, wc));
    if (vc <= 0.0f && d1 >= 0.0f && d3 <= 0.0f) return of_two(s, a, b);
    if (vb <= 0.0f && d2 >= 0.0f && d6 <= 0.0f) return of_two(s, a, c);
    if (va <= 0.0f && d4 - d3 >= 0.0f && d5 - d6 >= 0.0f) return of_two(s, b, c);
    const float sum = va + vb + vc, square = dot(n, n);
    if (!(sum > 0.0f) || !(square > 0.0f)) return of_two(s, a, b);
    const Simplex from = s;
    const uint32_t kept[3] = {a, b, c};
    s.count = 3;
    for (uint32_t k = 0; k < 3; ++k) {
        s.w[k] = from.w[kept[k]];
        s.i[k] = from.i[kept[k]];
        s.j[k] = from.j[kept[k]];
    }
    const float inverse = 1.0f / sum;
    s.weights[1] = vb * inverse;
    s.weights[2] = vc * inverse;
    s.weights[0] = 1.0f - s.weights[1] - s.weights[2];
    return dot(n, wa) / square * n;
}
// Faces with the corner that came last; the one opposite was the nearest before.
bool of_four(Simplex& s, Vector& nearest) {
    constexpr uint32_t faces[3][4] = {{0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}};
    const Simplex from = s;
    bool any = false;
    float best = 0.0f;
    for (const auto& f : faces) {
        const Vector a = from.w[f[0]];
        const Vector normal = cross(from.w[f[1]] - a, from.w[f[2]] - a);
        const float fourth = dot(normal, from.w[f[3]] - a), origin = -dot(normal, a);
        if (fourth * origin > 0.0f) continue;
        Simplex here = from;
        const Vector p = of_three(here, f[0], f[1], f[2]);
        const float square = dot(p, p);
        if (any && !(square < best)) continue;
        any = true;
        best = square;
        nearest = p;
        s = here;
    }
    return any;
}

bool reduce(Simplex& s, Vector& nearest) {
    switch (s.count) {
    case 1:
        nearest = keep_one(s, 0);
        return true;
    case 2:
        nearest = of_two(s, 0, 1);
        return true;
    case 3:
        nearest = of_three(s, 0, 1, 2);
        return true;
    default:
        return of_four(s, nearest);
    }
}

} // namespace

// Gilbert, Johnson and Keerthi 1988, bounded in work.
Closest closest_points(const PlacedPair& pair, Vector shift, float enough, float tolerance, Vector start) {
    Closest out{};
    Simplex simplex{};
    const auto add = [&](Vector d) {
        float along = 0.0f;
        const uint32_t i = farthest_of_a(pair, -d, along), j = farthest_of_b(pair, d, along);
        const Vector w = pair.point_a(i) - pair.point_b(j) + shift;
        for (uint32_t k = 0; k < simplex.count; ++k)
            if (simplex.i[k] == i && simplex.j[k] == j) return false;
        simplex.w[simplex.count] = w;
        simplex.i[simplex.count] = i;
        simplex.j[simplex.count] = j;
        ++simplex.count;
        return true;
    };
    const float near = touching * pair.size;
    add(start);
    simplex.weights[0] = 1.0f;
    Vector v = simplex.w[0];
    float square = dot(v, v), lower = dot(start, v);
    for (uint32_t round = 0; round < most_rounds; ++round) {
        if (!(square > near * near)) break;
        const float distance = std::sqrt(square);
        Simplex before = simplex;
        if (!add(v)) { // no point is nearer along v
            if (distance > enough) {
                out.state = Closest::State::beyond;
                return out;
            }
            break;
        }
        const float along = dot(v, simplex.w[simplex.count - 1]) / distance;
        lower = along > lower ? along : lower;
        if (lower > enough) {
            out.state = Closest::State::beyond;
            return out;
        }
        if (distance - along <= tolerance) {
            simplex = before;
            break;
        }
        Vector nearest{};
        if (!reduce(simplex, nearest)) {
            // Flat simplices look as if the origin were inside; a plane between the two says that it is not.
            if (!(lower > near)) {
                out.state = Closest::State::overlap;
                return out;
            }
            simplex = before;
            break;
        }
        const float nearer = dot(nearest, nearest);
        if (!(nearer < square)) {
            simplex = before;
            break;
        }
        v = nearest;
        square = nearer;
    }
    out.distance = std::sqrt(square);
    if (!(out.distance > near)) {
        out.state = Closest::State::overlap;
        return out;
    }
    out.state = Closest::State::apart;
    out.normal = 1.0f / out.distance * v;
    out.on_a = shift;
    for (uint32_t k = 0; k < simplex.count; ++k) {
        out.on_a = out.on_a + simplex.weights[k] * pair.point_a(simplex.i[k]);
        out.on_b = out.on_b + simplex.weights[k] * pair.point_b(simplex.j[k]);
    }
    return out;
}

} // namespace lr
