#include "contact/placed_pair.h"

#include <utility>

namespace lr {
namespace {

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

// The point of a triangle, or of a part of it, nearest to the origin: which corners hold it, a bit each, and by how much.
struct Nearest {
    Vector point;
    uint32_t holds;
    float weights[3];
};

// Between the newest, c, and an older one, where the nearest point is not beyond c.
Vector between(Vector a, Vector c, float along, float& part) {
    const Vector edge = a - c;
    const float square = dot(edge, edge);
    part = along < square ? along / square : 1.0f;
    return c + part * edge;
}

// The nearest point of a triangle to the origin. The newest corner, c, holds it: without that it was farther.
Nearest of_three(Vector a, Vector b, Vector c) {
    const Vector ca = a - c, cb = b - c, n = cross(ca, cb);
    const float along_a = -dot(ca, c), along_b = -dot(cb, c), square = dot(n, n);
    // Parts of the triangle that the origin spans with the sides at c.
    const float of_a = -dot(n, cross(c, cb)), of_b = -dot(n, cross(ca, c));
    float part = 0.0f;
    if (of_a > 0.0f && of_b > 0.0f) {
        const float inverse = 1.0f / square, for_a = of_a * inverse, for_b = of_b * inverse;
        return {(dot(n, c) * inverse) * n, 7, {for_a, for_b, 1.0f - for_a - for_b}};
    }
    if (!(of_b > 0.0f) && along_a > 0.0f) {
        const Vector p = between(a, c, along_a, part);
        return {p, 5, {part, 0.0f, 1.0f - part}};
    }
    if (!(of_a > 0.0f) && along_b > 0.0f) {
        const Vector p = between(b, c, along_b, part);
        return {p, 6, {0.0f, part, 1.0f - part}};
    }
    return {c, 4, {0.0f, 0.0f, 1.0f}};
}

// Of three of its corners.
void keep(Simplex& s, const uint32_t (&of)[3], const Nearest& nearest) {
    uint32_t count = 0;
    for (uint32_t k = 0; k < 3; ++k) {
        if ((nearest.holds >> k & 1u) == 0) continue;
        s.corners[count] = s.corners[of[k]]; // those before are done with
        s.weights[count++] = nearest.weights[k];
    }
    s.count = count;
}

void keep_two(Simplex& s, Vector& nearest) {
    const Vector a = s.corners[0].w, c = s.corners[1].w;
    const float along = -dot(a - c, c);
    if (along > 0.0f) {
        float part = 0.0f;
        nearest = between(a, c, along, part);
        s.weights[0] = part;
        s.weights[1] = 1.0f - part;
        return;
    }
    nearest = c;
    s.count = 1;
    s.corners[0] = s.corners[1];
    s.weights[0] = 1.0f;
}

// False: the origin is inside.
bool keep_of_four(Simplex& s, Vector& nearest) {
    const Vector a = s.corners[0].w, b = s.corners[1].w, c = s.corners[2].w, d = s.corners[3].w;
    const Vector da = a - d, db = b - d, dc = c - d;
    const Vector ab = cross(da, db), bc = cross(db, dc), ca = cross(dc, da);
    const float volume = dot(ab, dc);
    bool any = false;
    float best = 0.0f;
    Nearest kept{};
    uint32_t face = 0;
    const auto offer = [&](Vector n, uint32_t which, Vector e, Vector f) {
        if (-dot(n, d) * volume > 0.0f) return; // the origin is on the inner side
        const Nearest here = of_three(e, f, d);
        const float square = dot(here.point, here.point);
        if (any && !(square < best)) return;
        any = true;
        best = square;
        kept = here;
        face = which;
    };
    offer(ab, 0, a, b);
    offer(bc, 1, b, c);
    offer(ca, 2, c, a);
    if (!any) return false;
    nearest = kept.point;
    if (face == 2) std::swap(s.corners[0], s.corners[2]); // c before a
    constexpr uint32_t corners[3][3] = {{0, 1, 3}, {1, 2, 3}, {0, 2, 3}};
    keep(s, corners[face], kept);
    return true;
}

bool reduce(Simplex& s, Vector& nearest) {
    if (s.count == 4) return keep_of_four(s, nearest);
    if (s.count == 2) {
        keep_two(s, nearest);
        return true;
    }
    const Nearest of = of_three(s.corners[0].w, s.corners[1].w, s.corners[2].w);
    nearest = of.point;
    keep(s, {0, 1, 2}, of);
    return true;
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
    const float near = touching_cores * pair.size;
    add(start);
    simplex.weights[0] = 1.0f;
    Found found;
    found.set(simplex);
    Vector v = simplex.corners[0].w;
    float square = dot(v, v), lower = dot(start, v);
    if (lower > enough) {
        out.state = Closest::State::beyond;
        return out;
    }
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
