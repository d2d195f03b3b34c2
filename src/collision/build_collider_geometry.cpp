#include "collision/build_collider_geometry.h"

#include "base/disjoint_sets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace lr {
namespace {

using shape::HullPoint;

// Hulls thinner than this share of their largest extent are flat.
constexpr double flat = 1e-4;
// Sine of the angle between neighbours up to which an edge counts as flat.
constexpr double bend = 1e-3;

Double3 over(Double3 a, double b) {
    return {a.x / b, a.y / b, a.z / b};
}

// Maps each vertex to the first one at its position, so that triangles without shared vertices still have neighbours.
std::vector<uint32_t> welded(const float* vertices, uint32_t count) {
    std::vector<uint32_t> order(count), first(count);
    std::iota(order.begin(), order.end(), 0u);
    const auto at = [&](uint32_t i) { return vertices + size_t{3} * i; };
    std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
        for (uint32_t k = 0; k < 3; ++k)
            if (at(a)[k] < at(b)[k] || at(b)[k] < at(a)[k]) return at(a)[k] < at(b)[k];
        return a < b;
    });
    for (uint32_t n = 0; n < count; ++n) {
        const uint32_t i = order[n];
        const bool same = n > 0 && std::equal(at(i), at(i) + 3, at(order[n - 1]));
        first[i] = same ? first[order[n - 1]] : i;
    }
    return first;
}

struct Edge {
    uint32_t low, high; // welded vertices
    uint32_t triangle, number;
    bool downwards; // from high to low
};

// Disjoint sets of triangles joined by edges. A triangle t is two elements, 2 t as it is wound and 2 t + 1 turned.
struct Surfaces {
    std::vector<uint32_t> parents;

    explicit Surfaces(uint32_t triangles) : parents(size_t{2} * triangles) {
        std::iota(parents.begin(), parents.end(), 0u);
    }
    void join(uint32_t a, uint32_t b, bool alike) {
        const auto parent = [this](uint32_t i) -> uint32_t& { return parents[i]; };
        join_sets(parent, 2 * a, 2 * b + (alike ? 0 : 1));
        join_sets(parent, 2 * a + 1, 2 * b + (alike ? 1 : 0));
    }
    // The first triangle of t's surface. turned: whether t is wound against it; of a surface that is wound against itself, such as a Moebius strip,
    // no triangle is.
    uint32_t first(uint32_t t, char& turned) {
        const uint32_t found = first_of_set([this](uint32_t i) -> uint32_t& { return parents[i]; }, 2 * t);
        turned = static_cast<char>(found % 2);
        return found / 2;
    }
};

struct Surface {
    Box box;
    double volume; // six times, m^3; negative: wound inwards
    bool any, open, turned;
};

// With more surfaces the search for rooms would be slow.
constexpr size_t most_solids = 4096;

// The front of one solid must not be the inside of the next. So if windings are mixed, closed surfaces count as wound outwards. Else those of the rarer
// winding are turned, such as mirrored copies, unless they are rooms: a room that contains things is wound against them.
void turn_solids(std::vector<Surface>& solids, bool mixed) {
    std::vector<Surface*> order;
    uint32_t inwards = 0, outwards = 0;
    for (Surface& s : solids) {
        if (!s.any) continue;
        order.push_back(&s);
        s.turned = mixed && !s.open && s.volume < 0.0;
        if (!s.open) ++(s.volume < 0.0 ? inwards : outwards);
    }
    if (mixed || inwards == 0 || outwards == 0 || order.size() > most_solids) return;
    inwards = outwards = 0;
    for (Surface* const each : order) {
        Surface& s = *each;
        for (size_t k = 0; k < order.size() && !s.open; ++k) {
            if (order[k] == each) continue;
            const Box& b = order[k]->box;
            const Vector below = low_of(b.low, s.box.low) - s.box.low, above = high_of(b.high, s.box.high) - s.box.high;
            s.open = dot(below, below) + dot(above, above) == 0.0f;
        }
        if (!s.open) ++(s.volume < 0.0 ? inwards : outwards);
    }
    for (Surface* const s : order) s->turned = !s->open && (s->volume < 0.0) == (inwards <= outwards);
}
} // namespace

double extent_of(const std::vector<HullPoint>& points) {
    double extent = 0.0;
    for (size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax_element(
            points.begin(), points.end(), [k](const HullPoint& a, const HullPoint& b) { return a[k] < b[k]; });
        extent = std::max(extent, (*high)[k] - (*low)[k]);
    }
    return extent;
}

void put_in_turn(const std::vector<HullPoint>& points, Double3 normal, std::vector<uint32_t>& corners) {
    Double3 middle{0.0, 0.0, 0.0};
    for (const uint32_t i : corners) middle = middle + 1.0 / static_cast<double>(corners.size()) * of(points[i]);
    const Double3 start = of(points[corners[0]]) - middle;
    // Sorts into half turns from the first, then by the sense of rotation.
    const auto half = [&](Double3 a) {
        const double across = dot(normal, cross(start, a));
        return across > 0.0 || (across == 0.0 && dot(start, a) > 0.0) ? 0 : 1;
    };
    std::sort(corners.begin() + 1, corners.end(), [&](uint32_t i, uint32_t j) {
        const Double3 a = of(points[i]) - middle, b = of(points[j]) - middle;
        if (half(a) != half(b)) return half(a) < half(b);
        return dot(normal, cross(a, b)) > 0.0;
    });
}

std::vector<HullFace> hull_faces(const std::vector<HullPoint>& points, const shape::ConvexHull& hull) {
    const size_t count = hull.triangles.size();
    std::vector<HullPoint> corners;
    for (const uint32_t i : hull.points) corners.push_back(points[i]);
    std::vector<Double3> normals(count);
    std::vector<double> areas(count);
    double size = 0.0;
    for (const HullPoint& p : corners) size = std::max(size, length(of(p) - of(corners[0])));
    for (size_t i = 0; i < count; ++i) {
        const auto& t = hull.triangles[i];
        normals[i] = cross(of(corners[t[1]]) - of(corners[t[0]]), of(corners[t[2]]) - of(corners[t[0]]));
        areas[i] = length(normals[i]);
        if (areas[i] > 0.0) normals[i] = over(normals[i], areas[i]);
    }
    std::vector<size_t> order(count);
    std::iota(order.begin(), order.end(), size_t{0});
    std::sort(order.begin(), order.end(),
              [&](size_t a, size_t b) { return areas[a] > areas[b] || (areas[a] == areas[b] && a < b); });
    const double slack = 2.0 * hull.slack + 1e-6 * size;
    std::vector<char> taken(count, 0);
    std::vector<HullFace> faces;
    for (const size_t i : order) {
        if (taken[i] || !(areas[i] > 0.0)) continue;
        HullFace face{normals[i], -std::numeric_limits<double>::infinity(), 0.0, {}};
        const auto along = [&](uint32_t corner) { return dot(face.normal, of(corners[corner])); };
        for (uint32_t k = 0; k < corners.size(); ++k) face.offset = std::max(face.offset, along(k));
        for (uint32_t k = 0; k < corners.size(); ++k) {
            face.width = std::max(face.width, face.offset - along(k));
            if (face.offset - along(k) <= 2.0 * slack) face.corners.push_back(k);
        }
        put_in_turn(corners, face.normal, face.corners);
        for (size_t j = 0; j < count; ++j) {
            bool in = true;
            for (const uint32_t corner : hull.triangles[j]) in = in && face.offset - along(corner) <= slack;
            taken[j] = taken[j] || (in && (areas[j] <= 1e-6 * areas[i] || dot(face.normal, normals[j]) > 0.5));
        }
        taken[i] = 1;
        faces.push_back(std::move(face));
    }
    return faces;
}

bool build_hull(const float* vertices, uint32_t count, BuiltHull& out) {
    out = {};
    std::vector<HullPoint> points(count);
    for (uint32_t i = 0; i < 3 * count; ++i) points[i / 3][i % 3] = wide(vertices[i]);
    shape::ConvexHull hull;
    if (shape::convex_hull(points, hull) != shape::HullOutcome::done || hull.flat) return false;
    const double extent = extent_of(points);
    const std::vector<HullFace> faces = hull_faces(points, hull);
    auto first = static_cast<uint32_t>(faces.size() + 1);
    for (const HullFace& face : faces) {
        if (!(face.width > flat * extent)) return false;
        for (const double n : {face.normal.x, face.normal.y, face.normal.z, face.offset})
            out.faces.push_back(static_cast<float>(n));
        out.corners.push_back(first);
        first += static_cast<uint32_t>(face.corners.size());
    }
    out.corners.push_back(first);
    for (const HullFace& face : faces) out.corners.insert(out.corners.end(), face.corners.begin(), face.corners.end());
    for (const uint32_t i : hull.points)
        out.vertices.insert(out.vertices.end(), vertices + size_t{3} * i, vertices + size_t{3} * i + 3);
    return faces.size() >= 4 &&
           std::all_of(out.faces.begin(), out.faces.end(), [](float f) { return std::isfinite(f); });
}

bool build_mesh(const float* vertices, uint32_t vertex_count, const uint32_t* indices, uint32_t triangle_count,
                std::vector<float>& normals, std::vector<uint8_t>& hidden_edges) {
    normals.assign(size_t{3} * triangle_count, 0.0f);
    hidden_edges.assign(triangle_count, 0);
    const auto at = [&](uint32_t triangle, uint32_t corner) {
        return to_double(vector_of(vertices + size_t{3} * indices[size_t{3} * triangle + corner % 3]));
    };
    bool any = false;
    std::vector<Double3> exact(triangle_count, Double3{});
    for (uint32_t t = 0; t < triangle_count; ++t) {
        const Double3 a = at(t, 1) - at(t, 0), b = at(t, 2) - at(t, 0), n = cross(a, b);
        const double area = length(n), c = length(b - a);
        const double longest = std::max({length(a), length(b), c});
        if (!(area > 1e-7 * longest * longest)) continue; // nearly a line: the normal would be rounding
        any = true;
        exact[t] = over(n, area);
        put(to_float(exact[t]), normals.data() + size_t{3} * t);
    }
    if (!any) return false;

    const std::vector<uint32_t> names = welded(vertices, vertex_count);
    std::vector<Edge> edges;
    for (uint32_t t = 0; t < triangle_count; ++t)
        for (uint32_t k = 0; k < 3 && length(exact[t]) > 0.5; ++k) {
            const uint32_t a = names[indices[size_t{3} * t + k]], b = names[indices[size_t{3} * t + (k + 1) % 3]];
            edges.push_back({std::min(a, b), std::max(a, b), t, k, a > b});
        }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        if (a.low != b.low) return a.low < b.low;
        if (a.high != b.high) return a.high < b.high;
        return a.triangle != b.triangle ? a.triangle < b.triangle : a.number < b.number;
    });
    Surfaces surfaces(triangle_count);
    std::vector<char> ends(triangle_count, 0);
    for (size_t from = 0; from < edges.size();) {
        size_t to = from;
        while (to < edges.size() && edges[to].low == edges[from].low && edges[to].high == edges[from].high) ++to;
        for (size_t i = from; i < to; ++i)
            for (size_t j = from; j < to; ++j) {
                const Edge &mine = edges[i], &other = edges[j];
                if (mine.triangle == other.triangle) continue;
                const Double3 out = at(other.triangle, other.number + 2) - at(other.triangle, other.number);
                const double rise = dot(exact[mine.triangle], out) / length(out);
                // A doubled face, or one of a solid that stands against this one, hides nothing.
                const Double3 edge = at(mine.triangle, mine.number + 1) - at(mine.triangle, mine.number);
                if (std::abs(rise) < bend && dot(cross(exact[mine.triangle], edge), out) > 0.0) continue;
                uint8_t& bits = hidden_edges[mine.triangle];
                if (rise > -bend) bits = static_cast<uint8_t>(bits | 1u << mine.number);
                if (rise < bend) bits = static_cast<uint8_t>(bits | 8u << mine.number);
            }
        // Where more than two meet, as where boxes stand side by side, each surface keeps its winding.
        if (to - from == 2)
            surfaces.join(edges[from].triangle, edges[from + 1].triangle,
                          edges[from].downwards != edges[from + 1].downwards);
        if (to - from == 1) ends[edges[from].triangle] = 1;
        from = to;
    }
    std::vector<uint32_t> of(triangle_count);
    std::vector<char> turned(triangle_count, 0);
    std::vector<Surface> solids(triangle_count);
    bool mixed = false;
    for (uint32_t t = 0; t < triangle_count; ++t) {
        of[t] = surfaces.first(t, turned[t]);
        mixed = mixed || turned[t] != 0;
        Surface& s = solids[of[t]];
        s.open = s.open || ends[t] != 0;
        const Double3 a = at(t, 0) - at(0, 0), b = at(t, 1) - at(0, 0), c = at(t, 2) - at(0, 0);
        s.volume += (turned[t] != 0 ? -1.0 : 1.0) * dot(a, cross(b, c));
        const Vector corners[3] = {to_float(a), to_float(b), to_float(c)};
        const Vector low = low_of(corners[0], low_of(corners[1], corners[2]));
        const Vector high = high_of(corners[0], high_of(corners[1], corners[2]));
        s.box = s.any ? Box{low_of(s.box.low, low), high_of(s.box.high, high)} : Box{low, high};
        s.any = true;
    }
    // A surface that meets others at some of its edges, as faces between boxes side by side do, encloses nothing by itself.
    for (size_t from = 0, to = 0; from < edges.size(); from = to) {
        while (to < edges.size() && edges[to].low == edges[from].low && edges[to].high == edges[from].high) ++to;
        for (size_t i = from; i < to && to - from > 2; ++i) {
            const auto own =
                std::count_if(edges.begin() + static_cast<ptrdiff_t>(from), edges.begin() + static_cast<ptrdiff_t>(to),
                              [&](const Edge& e) { return of[e.triangle] == of[edges[i].triangle]; });
            if (own % 2 != 0) solids[of[edges[i].triangle]].open = true;
        }
    }
    turn_solids(solids, mixed);
    for (uint32_t t = 0; t < triangle_count; ++t)
        if ((turned[t] != 0) != solids[of[t]].turned)
            hidden_edges[t] = static_cast<uint8_t>(hidden_edges[t] | turned_triangle);
    return true;
}

float steepest_secant(const uint32_t (&counts)[2], const float (&spacing)[2], const float* heights) {
    double most = 0.0; // squared slope
    const auto slope = [&](size_t from, size_t to, uint32_t axis) {
        const double rise = static_cast<double>(heights[to]) - static_cast<double>(heights[from]);
        return rise * rise / (static_cast<double>(spacing[axis]) * static_cast<double>(spacing[axis]));
    };
    for (uint32_t k = 0; k + 1 < counts[1]; ++k)
        for (uint32_t i = 0; i + 1 < counts[0]; ++i) {
            const size_t at = i + size_t{counts[0]} * k, along_x = at + 1, along_z = at + counts[0];
            most = std::max(most, slope(at, along_x, 0) + slope(along_x, along_z + 1, 1));
            most = std::max(most, slope(at, along_z, 1) + slope(along_z, along_z + 1, 0));
        }
    return static_cast<float>(std::min(std::sqrt(1.0 + most) * 1.000001, 1e30));
}

void build_coarse(const uint32_t (&counts)[2], const float* heights, std::vector<float>& coarse,
                  uint32_t (&coarse_counts)[2], float& lowest, float& highest) {
    constexpr uint32_t cells = HeightfieldGeometry::coarse_cells;
    const auto [low, high] = std::minmax_element(heights, heights + size_t{counts[0]} * counts[1]);
    lowest = *low;
    highest = *high;
    for (uint32_t a = 0; a < 2; ++a) coarse_counts[a] = (counts[a] - 2) / cells + 1;
    coarse.assign(size_t{coarse_counts[0]} * coarse_counts[1], -std::numeric_limits<float>::infinity());
    // Together with the surrounding squares: `cells` farther on each side.
    const auto from = [](uint32_t square) { return square > 0 ? (square - 1) * cells : 0; };
    const auto to = [&](uint32_t square, uint32_t a) {
        return static_cast<uint32_t>(std::min<uint64_t>((uint64_t{square} + 2) * cells, counts[a] - 1));
    };
    for (uint32_t sz = 0; sz < coarse_counts[1]; ++sz)
        for (uint32_t sx = 0; sx < coarse_counts[0]; ++sx) {
            float& most = coarse[size_t{sz} * coarse_counts[0] + sx];
            for (uint32_t k = from(sz); k <= to(sz, 1); ++k)
                for (uint32_t i = from(sx); i <= to(sx, 0); ++i)
                    most = std::max(most, heights[size_t{k} * counts[0] + i]);
        }
}

namespace {

constexpr float large = 8.0f; // times the mean extent

struct Triangle {
    Box box;
    uint32_t index;
};

Vector doubled_middle(const Triangle& t) {
    return t.box.low + t.box.high;
}

Box around(const Triangle* from, const Triangle* to) {
    Box box = from->box;
    for (; from != to; ++from) box = around(box, from->box);
    return box;
}

// Halves the triangles at the median along the longest axis until few are left. Libraries select in different orders; only the two sets are used, so
// the result is the same.
void split(Triangle* from, Triangle* to, uint32_t first, std::vector<MeshPart>& parts) {
    const auto count = static_cast<uint32_t>(to - from);
    if (count <= most_part_triangles) {
        std::sort(from, to, [](const Triangle& a, const Triangle& b) { return a.index < b.index; });
        parts.push_back({around(from, to), {first, count}});
        return;
    }
    Vector low = doubled_middle(*from), high = low;
    for (const Triangle* t = from; t != to; ++t) {
        low = low_of(low, doubled_middle(*t));
        high = high_of(high, doubled_middle(*t));
    }
    const Vector e = high - low;
    const auto key = [&](const Triangle& t) {
        const Vector m = doubled_middle(t);
        return e.x >= e.y && e.x >= e.z ? m.x : e.y >= e.z ? m.y : m.z;
    };
    const uint32_t half = (count / 2 + most_part_triangles - 1) / most_part_triangles * most_part_triangles;
    std::nth_element(from, from + half, to, [&](const Triangle& a, const Triangle& b) {
        return key(a) < key(b) || (!(key(b) < key(a)) && a.index < b.index);
    });
    split(from, from + half, first, parts);
    split(from + half, to, first + half, parts);
}
} // namespace

void make_mesh_parts(const float* vertices, uint32_t* indices, uint32_t triangle_count, std::vector<MeshPart>& parts) {
    std::vector<Triangle> triangles(triangle_count);
    double sum = 0.0;
    for (uint32_t i = 0; i < triangle_count; ++i) {
        Vector p[3];
        for (size_t k = 0; k < 3; ++k) p[k] = vector_of(vertices + size_t{3} * indices[size_t{3} * i + k]);
        triangles[i] = {{low_of(p[0], low_of(p[1], p[2])), high_of(p[0], high_of(p[1], p[2]))}, i};
        sum += static_cast<double>(extent(triangles[i].box));
    }
    const float limit = large * static_cast<float>(sum / triangle_count);
    const auto small =
        std::partition(triangles.begin(), triangles.end(), [&](const Triangle& t) { return extent(t.box) <= limit; });
    std::sort(small, triangles.end(), [](const Triangle& a, const Triangle& b) { return a.index < b.index; });
    parts.clear();
    Triangle* const begin = triangles.data();
    const auto small_count = static_cast<uint32_t>(small - triangles.begin());
    if (small_count != 0) split(begin, begin + small_count, 0, parts);
    for (uint32_t i = small_count; i < triangle_count; ++i) parts.push_back({triangles[i].box, {i, 1}});
    std::vector<uint32_t> sorted(size_t{3} * triangle_count);
    for (uint32_t i = 0; i < triangle_count; ++i)
        std::copy_n(indices + size_t{3} * triangles[i].index, 3, sorted.data() + size_t{3} * i);
    std::copy(sorted.begin(), sorted.end(), indices);
}
} // namespace lr
