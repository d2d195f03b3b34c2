#include "contact/placed_pair.h"

namespace lr {
namespace {

// Of the pair's size: nearer than this, rounding decides what the direction is.
constexpr float touching = 3e-5f;
constexpr uint32_t most_rounds = 24;

struct Corner {
    Vector w; // of the difference of a and b
    uint32_t i, j;
};
// Of at most three corners once it is reduced; the newest is always the last before that.
struct Simplex {
    uint32_t count;
    Corner corners[4];
    float weights[3];
};

Vector keep_one(Simplex& s, const Corner& a) {
    s.count = 1;
    s.corners[0] = a;
    s.weights[0] = 1.0f;
    return a.w;
}
// Between the newest, c, and an older one, where the nearest point is not beyond c.
Vector keep_two(Simplex& s, const Corner& a, const Corner& c, float along) {
    const Vector edge = a.w - c.w;
    const float square = dot(edge, edge), part = along < square ? along / square : 1.0f;
    const Vector p = c.w + part * edge;
    s.weights[0] = part;
    s.weights[1] = 1.0f - part;
    s.count = 2;
    s.corners[0] = a;
    s.corners[1] = c;
    return p;
}

Vector of_two(Simplex& s) {
    const Corner a = s.corners[0], c = s.corners[1];
    const float along = -dot(a.w - c.w, c.w);
    return along > 0.0f ? keep_two(s, a, c, along) : keep_one(s, c);
}

// The nearest point of a triangle to the origin. The newest corner, c, holds it: without that it was farther.
Vector of_three(Simplex& s, const Corner a, const Corner b, const Corner c) {
    const Vector ca = a.w - c.w, cb = b.w - c.w, n = cross(ca, cb);
    const float along_a = -dot(ca, c.w), along_b = -dot(cb, c.w), square = dot(n, n);
    // Parts of the triangle that the origin spans with the sides at c.
    const float of_a = -dot(n, cross(c.w, cb)), of_b = -dot(n, cross(ca, c.w));
    if (of_a > 0.0f && of_b > 0.0f) {
        const float inverse = 1.0f / square;
        s.weights[0] = of_a * inverse;
        s.weights[1] = of_b * inverse;
        s.weights[2] = 1.0f - s.weights[0] - s.weights[1];
        s.count = 3;
        s.corners[0] = a;
        s.corners[1] = b;
        s.corners[2] = c;
        return (dot(n, c.w) * inverse) * n;
    }
    if (!(of_b > 0.0f) && along_a > 0.0f) return keep_two(s, a, c, along_a);
    if (!(of_a > 0.0f) && along_b > 0.0f) return keep_two(s, b, c, along_b);
    return keep_one(s, c);
}

// False: the origin is inside.
bool of_four(Simplex& s, Vector& nearest) {
    const Corner a = s.corners[0], b = s.corners[1], c = s.corners[2], d = s.corners[3];
    const Vector da = a.w - d.w, db = b.w - d.w, dc = c.w - d.w;
    const Vector ab = cross(da, db), bc = cross(db, dc), ca = cross(dc, da);
    const float volume = dot(ab, dc);
    bool any = false;
    float best = 0.0f;
    const auto offer = [&](Vector n, const Corner& e, const Corner& f) {
        if (-dot(n, d.w) * volume > 0.0f) return; // the origin is on the inner side
        Simplex here{};
        const Vector p = of_three(here, e, f, d);
        const float square = dot(p, p);
        if (any && !(square < best)) return;
        any = true;
        best = square;
        nearest = p;
        s = here;
    };
    offer(ab, a, b);
    offer(bc, b, c);
    offer(ca, c, a);
    return any;
}

bool reduce(Simplex& s, Vector& nearest) {
    switch (s.count) {
    case 2:
        nearest = of_two(s);
        return true;
    case 3:
        nearest = of_three(s, s.corners[0], s.corners[1], s.corners[2]);
        return true;
    default:
        return of_four(s, nearest);
    }
}

// Where the points of a simplex are on both cores.
struct Found {
    uint32_t count;
    uint32_t i[3], j[3];
    float weights[3];

    void set(const Simplex& s) {
        count = s.count;
        for (uint32_t k = 0; k < s.count; ++k) {
            i[k] = s.corners[k].i;
            j[k] = s.corners[k].j;
            weights[k] = s.weights[k];
        }
    }
};

} // namespace

// Gilbert, Johnson and Keerthi 1988, bounded in work.
Closest closest_points(const PlacedPair& pair, Vector shift, float enough, float tolerance, Vector start) {
    Closest out{};
    Simplex simplex;
    simplex.count = 0;
    const auto add = [&](Vector d) {
        float along = 0.0f;
        const uint32_t i = farthest_of_a(pair, -d, along), j = support_of_b(pair, d);
        for (uint32_t k = 0; k < simplex.count; ++k)
            if (simplex.corners[k].i == i && simplex.corners[k].j == j) return false;
        simplex.corners[simplex.count++] = {pair.point_a(i) - pair.point_b(j) + shift, i, j};
        return true;
    };
    const float near = touching * pair.size;
    add(start);
    simplex.weights[0] = 1.0f;
    Found found;
    found.set(simplex);
    Vector v = simplex.corners[0].w;
    float square = dot(v, v), lower = dot(start, v);
    for (uint32_t round = 0; round < most_rounds; ++round) {
        if (!(square > near * near)) break;
        const float distance = std::sqrt(square);
        if (!add(v)) { // no point is nearer along v
            if (distance > enough) {
                out.state = Closest::State::beyond;
                return out;
            }
            break;
        }
        const float along = dot(v, simplex.corners[simplex.count - 1].w) / distance;
        lower = along > lower ? along : lower;
        if (lower > enough) {
            out.state = Closest::State::beyond;
            return out;
        }
        if (distance - along <= tolerance) break;
        Vector nearest{};
        if (!reduce(simplex, nearest)) {
            // Flat simplices look as if the origin were inside; a plane between the two says that it is not.
            if (!(lower > near)) {
                out.state = Closest::State::overlap;
                return out;
            }
            break;
        }
        const float nearer = dot(nearest, nearest);
        if (!(nearer < square)) break;
        found.set(simplex);
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
    for (uint32_t k = 0; k < found.count; ++k) {
        out.on_a = out.on_a + found.weights[k] * pair.point_a(found.i[k]);
        out.on_b = out.on_b + found.weights[k] * pair.point_b(found.j[k]);
    }
    return out;
}

} // namespace lr
