#include "base/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lr::shape {
namespace {

// Quickhull (Barber, Dobkin and Huhdanpaa 1996) on points rounded to an integer grid, where every orientation is exact: no tolerance decides
// topology, so flat, thin and regular input cannot break it. Points at most this many grid steps outside count as on the hull, so that rounding does
// not turn flat faces into bumps.
constexpr double usual_skin = 4.0;
constexpr int max_passes = 8;
constexpr uint32_t none = UINT32_MAX;

using Point = GridPoint;

Point subtract(const Point& a, const Point& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// Coordinates have 25 bits with their sign, differences 26, each component here 52.
Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double norm(const Point& a) {
    const auto x = static_cast<double>(a[0]), y = static_cast<double>(a[1]), z = static_cast<double>(a[2]);
    return std::sqrt(x * x + y * y + z * z);
}

// n.d exactly, as high * 2^26 + low with 0 <= low < 2^26: the sum itself can need 79 bits.
struct Wide {
    int64_t high, low;
    int sign() const { return high != 0 ? (high > 0 ? 1 : -1) : (low > 0 ? 1 : 0); }
    double value() const { return std::ldexp(static_cast<double>(high), 26) + static_cast<double>(low); }
};

Wide dot(const Point& n, const Point& d) {
    constexpr int64_t base = int64_t{1} << 26;
    int64_t high = 0, low = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const int64_t floor = n[k] >> 26; // arithmetic shift: rounds down, also for negative n
        high += floor * d[k];
        low += (n[k] - floor * base) * d[k];
    }
    const int64_t carry = low >> 26;
    return {high + carry, low - carry * base};
}

struct HullFace {
    std::array<uint32_t, 3> vertex;
    std::array<uint32_t, 3> neighbour; // across the edge from vertex[k] to vertex[k+1]
    Point normal;
    double normal_length;
    std::vector<uint32_t> outside; // points above this face, each in one list only
    bool alive = true;
    uint32_t visit = none;
};

class Quickhull {
public:
    explicit Quickhull(std::vector<Point> points, double skin = usual_skin)
        : points_(std::move(points)), skin_(skin), starts_(points_.size(), none) {}

    // Dimension of the input: 3 if a first tetrahedron is found, else 0, 1 or 2.
    int find_simplex() {
        const uint32_t a = 0;
        const uint32_t b = furthest([&](uint32_t i) { return norm(subtract(points_[i], points_[a])); }, 0.0);
        if (b == none) return 0;
        const Point ab = subtract(points_[b], points_[a]);
        const uint32_t c =
            furthest([&](uint32_t i) { return norm(cross(ab, subtract(points_[i], points_[a]))); }, skin_ * norm(ab));
        if (c == none) return 1;
        plane_origin_ = points_[a];
        plane_normal_ = cross(ab, subtract(points_[c], points_[a]));
        const uint32_t d =
            furthest([&](uint32_t i) { return std::abs(dot(plane_normal_, subtract(points_[i], points_[a])).value()); },
                     skin_ * norm(plane_normal_));
        if (d == none) return 2;
        const bool below = dot(plane_normal_, subtract(points_[d], points_[a])).sign() < 0;
        start(below ? a : b, below ? b : a, c, d);
        return 3;
    }

    bool is_outside(const Point& point) const {
        for (const HullFace& face : faces_)
            if (face.alive &&
                dot(face.normal, subtract(point, points_[face.vertex[0]])).value() > skin_ * face.normal_length)
                return true;
        return false;
    }

    const Point& plane_normal() const { return plane_normal_; }
    std::size_t made() const { return made_; }

    bool run(std::size_t most_faces = SIZE_MAX) {
        for (uint32_t f = 0; f < faces_.size(); ++f) {
            while (faces_[f].alive && !faces_[f].outside.empty())
                if (made_ > most_faces || !insert_furthest(f)) return false;
            if (dead_ > 1000 + faces_.size() / 2) f = drop_dead(f + 1) - 1;
        }
        return true;
    }

    std::vector<HullTriangle> result() const {
        std::vector<HullTriangle> faces;
        for (const HullFace& face : faces_)
            if (face.alive) faces.push_back(face.vertex);
        return faces;
    }

private:
    template <typename Measure> uint32_t furthest(const Measure& measure, double more_than) const {
        uint32_t best = none;
        for (uint32_t i = 0; i < points_.size(); ++i) {
            const double value = measure(i);
            if (value <= more_than) continue;
            more_than = value;
            best = i;
        }
        return best;
    }

    // Removes dead faces and keeps the order. Around a flat round side they would take memory with the square of its corners. Returns the number kept
    // before `at`.
    uint32_t drop_dead(std::size_t at) {
        std::vector<uint32_t> moved(faces_.size(), none);
        uint32_t left = 0, before = 0;
        for (std::size_t f = 0; f < faces_.size(); ++f) {
            if (f < at && faces_[f].alive) ++before;
            if (!faces_[f].alive) continue;
            moved[f] = left;
            if (left != f) faces_[left] = std::move(faces_[f]);
            ++left;
        }
        faces_.resize(left);
        for (HullFace& face : faces_)
            for (uint32_t& other : face.neighbour) other = moved[other];
        dead_ = 0;
        return before;
    }

    uint32_t add_face(uint32_t a, uint32_t b, uint32_t c) {
        HullFace face;
        face.vertex = {a, b, c};
        face.neighbour = {none, none, none};
        face.normal = cross(subtract(points_[b], points_[a]), subtract(points_[c], points_[a]));
        face.normal_length = norm(face.normal);
        faces_.push_back(std::move(face));
        ++made_;
        return static_cast<uint32_t>(faces_.size() - 1);
    }

    Wide height(const HullFace& face, uint32_t point) const {
        return dot(face.normal, subtract(points_[point], points_[face.vertex[0]]));
    }

    void assign(uint32_t point, uint32_t first_face) {
        for (uint32_t f = first_face; f < faces_.size(); ++f)
            if (height(faces_[f], point).value() > skin_ * faces_[f].normal_length) {
                faces_[f].outside.push_back(point);
                return;
            }
    }

    // d lies below a, b, c seen counter-clockwise from outside.
    void start(uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
        add_face(a, b, c);
        add_face(a, d, b);
        add_face(b, d, c);
        add_face(c, d, a);
        faces_[0].neighbour = {1, 2, 3};
        faces_[1].neighbour = {3, 2, 0};
        faces_[2].neighbour = {1, 3, 0};
        faces_[3].neighbour = {2, 1, 0};
        for (uint32_t i = 0; i < points_.size(); ++i) assign(i, 0);
    }

    bool insert_furthest(uint32_t seed) {
        uint32_t apex = none;
        double best = 0.0;
        for (const uint32_t i : faces_[seed].outside) {
            const double value = height(faces_[seed], i).value();
            if (value <= best) continue;
            best = value;
            apex = i;
        }
        if (apex == none) return false;

        // Faces in the apex's own plane are removed as well, so the fan around the apex replaces the whole flat facet. The apex is never on the line
        // of a horizon edge, so no new face is degenerate.
        std::vector<uint32_t> visible{seed};
        std::vector<std::pair<uint32_t, std::size_t>> horizon; // hidden face, its edge
        faces_[seed].visit = apex;
        for (std::size_t i = 0; i < visible.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const uint32_t other = faces_[visible[i]].neighbour[k];
                if (faces_[other].visit == apex) continue;
                if (height(faces_[other], apex).sign() >= 0) {
                    faces_[other].visit = apex;
                    visible.push_back(other);
                    continue;
                }
                const auto& back = faces_[other].neighbour;
                const auto edge =
                    static_cast<std::size_t>(std::find(back.begin(), back.end(), visible[i]) - back.begin());
                horizon.emplace_back(other, edge);
            }

        const auto first_new = static_cast<uint32_t>(faces_.size());
        for (const auto& [hidden, edge] : horizon) {
            const uint32_t from = faces_[hidden].vertex[(edge + 1) % 3], to = faces_[hidden].vertex[edge];
            const uint32_t created = add_face(from, to, apex);
            faces_[created].neighbour[0] = hidden;
            faces_[hidden].neighbour[edge] = created;
            if (starts_[from] != none) return false; // the horizon would touch itself
            starts_[from] = created;
        }
        for (uint32_t f = first_new; f < faces_.size(); ++f) {
            const uint32_t next = starts_[faces_[f].vertex[1]];
            if (next == none) return false;
            faces_[f].neighbour[1] = next;
            faces_[next].neighbour[2] = f;
        }
        for (uint32_t f = first_new; f < faces_.size(); ++f) starts_[faces_[f].vertex[0]] = none;
        dead_ += visible.size();
        for (const uint32_t f : visible) {
            faces_[f].alive = false;
            const std::vector<uint32_t> orphans = std::move(faces_[f].outside);
            faces_[f].outside.clear();
            for (const uint32_t i : orphans)
                if (i != apex) assign(i, first_new);
        }
        return true;
    }

    std::vector<Point> points_;
    double skin_;
    std::vector<uint32_t> starts_; // new face whose horizon edge starts at a vertex
    std::vector<HullFace> faces_;
    std::size_t dead_ = 0; // of these
    std::size_t made_ = 0;
    Point plane_origin_{}, plane_normal_{};
};

// Whether a point rises above its neighbours by at most the skin.
bool is_redundant(const std::vector<Point>& neighbours, const Point& point) {
    Quickhull ring(neighbours);
    const int dimension = ring.find_simplex();
    if (dimension < 2) return false;
    if (dimension == 2) {
        const Point normal = ring.plane_normal();
        return std::abs(dot(normal, subtract(point, neighbours[0])).value()) <= usual_skin * norm(normal);
    }
    return ring.run() && !ring.is_outside(point);
}

// Vertices found early that rounding keeps barely outside of their neighbours. Two neighbours are never removed at once, because each can make the
// other redundant.
std::vector<char> redundant_vertices(const std::vector<Point>& points, const std::vector<HullTriangle>& faces) {
    std::vector<std::vector<uint32_t>> rings(points.size());
    for (const HullTriangle& face : faces)
        for (std::size_t k = 0; k < 3; ++k) rings[face[k]].push_back(face[(k + 1) % 3]);
    std::vector<char> drop(points.size(), 0);
    for (uint32_t i = 0; i < points.size(); ++i) {
        if (rings[i].empty()) continue;
        std::vector<Point> neighbours;
        bool free = true;
        for (const uint32_t other : rings[i]) {
            neighbours.push_back(points[other]);
            free = free && !drop[other];
        }
        drop[i] = free && is_redundant(neighbours, points[i]);
    }
    return drop;
}

// Two-sided convex polygon of points in one plane (monotone chain, Andrew 1979).
std::vector<HullTriangle> flat_hull(const std::vector<Point>& points, const Point& normal, double skin = usual_skin) {
    std::size_t drop = 0; // projects along the largest component: exact, without new coordinates
    for (std::size_t k = 1; k < 3; ++k)
        if (std::abs(normal[k]) > std::abs(normal[drop])) drop = k;
    const std::size_t u = (drop + 1) % 3, v = (drop + 2) % 3;
    std::vector<uint32_t> order(points.size());
    for (uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
        if (points[a][u] != points[b][u]) return points[a][u] < points[b][u];
        return points[a][v] != points[b][v] ? points[a][v] < points[b][v] : a < b;
    });
    std::vector<uint32_t> ring;
    for (int pass = 0; pass < 2; ++pass) {
        const std::size_t base = ring.size();
        for (const uint32_t i : order) {
            while (ring.size() >= base + 2) {
                const Point &a = points[ring[ring.size() - 2]], &b = points[ring.back()], &c = points[i];
                const int64_t turn = (b[u] - a[u]) * (c[v] - b[v]) - (b[v] - a[v]) * (c[u] - b[u]);
                const auto du = static_cast<double>(c[u] - a[u]), dv = static_cast<double>(c[v] - a[v]);
                const double length = std::sqrt(du * du + dv * dv);
                if (static_cast<double>(turn) > skin * length) break;
                ring.pop_back();
            }
            ring.push_back(i);
        }
        ring.pop_back();
        std::reverse(order.begin(), order.end());
    }
    std::vector<HullTriangle> faces;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
        faces.push_back({ring[0], ring[i], ring[i + 1]});
        faces.push_back({ring[0], ring[i + 1], ring[i]});
    }
    return faces;
}

// Triangles of input points become triangles of corners.
void number_corners(std::size_t count, ConvexHull& out) {
    std::vector<uint32_t> renumbered(count, none);
    for (const HullTriangle& face : out.triangles)
        for (const uint32_t i : face) renumbered[i] = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (renumbered[i] == none) continue;
        renumbered[i] = static_cast<uint32_t>(out.points.size());
        out.points.push_back(static_cast<uint32_t>(i));
    }
    for (HullTriangle& face : out.triangles)
        for (uint32_t& i : face) i = renumbered[i];
}
} // namespace

HullOutcome convex_hull(const std::vector<HullPoint>& points, ConvexHull& out, std::size_t most_faces) {
    out = {};
    constexpr double infinity = std::numeric_limits<double>::infinity();
    HullPoint low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
    for (const HullPoint& p : points)
        for (std::size_t k = 0; k < 3; ++k) {
            if (!std::isfinite(p[k])) return HullOutcome::not_finite;
            low[k] = std::min(low[k], p[k]);
            high[k] = std::max(high[k], p[k]);
        }
    if (points.size() < 3 || points.size() >= none) return HullOutcome::too_few;
    const double extent = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
    const double step = extent / (std::ldexp(1.0, grid_bits) - 1.0);
    if (!(step > 0.0) || !std::isfinite(step)) return HullOutcome::one_point;

    std::vector<Point> grid(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) grid[i][k] = std::llround((points[i][k] - low[k]) / step);

    std::vector<uint32_t> names(grid.size()); // of the grid points in use
    for (uint32_t i = 0; i < names.size(); ++i) names[i] = i;
    int passes = 0;
    for (bool done = false; !done; ++passes) {
        Quickhull hull(grid);
        const int dimension = hull.find_simplex();
        if (dimension < 2) return HullOutcome::one_line;
        if (dimension == 3 && !hull.run(most_faces))
            return hull.made() > most_faces ? HullOutcome::too_costly : HullOutcome::not_closed;
        out.triangles = dimension == 3 ? hull.result() : flat_hull(grid, hull.plane_normal());
        if (out.triangles.empty()) return HullOutcome::one_line;
        out.flat = dimension == 2;
        std::vector<char> keep(grid.size(), 0);
        for (const HullTriangle& face : out.triangles)
            for (const uint32_t i : face) keep[i] = 1;
        if (dimension == 3 && passes < max_passes) {
            const std::vector<char> drop = redundant_vertices(grid, out.triangles);
            done = std::find(drop.begin(), drop.end(), 1) == drop.end();
            for (std::size_t i = 0; i < drop.size(); ++i) keep[i] = keep[i] && !drop[i];
        } else {
            done = true;
        }
        if (done) break;
        std::size_t kept = 0;
        for (std::size_t i = 0; i < grid.size(); ++i) {
            if (!keep[i]) continue;
            names[kept] = names[i];
            grid[kept++] = grid[i];
        }
        grid.resize(kept);
        names.resize(kept);
    }
    for (HullTriangle& face : out.triangles)
        for (uint32_t& i : face) i = names[i];

    number_corners(points.size(), out);
    out.slack = (usual_skin * (1.0 + passes) + 2.0) * step; // skin of each pass, and rounding of point and face
    return HullOutcome::done;
}

HullOutcome exact_hull(const std::vector<Point>& grid, ConvexHull& out) {
    out = {};
    Quickhull hull(grid, 0.0);
    const int dimension = hull.find_simplex();
    if (dimension < 2) return HullOutcome::one_line;
    if (dimension == 3 && !hull.run()) return HullOutcome::not_closed;
    out.triangles = dimension == 3 ? hull.result() : flat_hull(grid, hull.plane_normal(), 0.0);
    out.flat = dimension == 2;
    if (out.triangles.empty()) return HullOutcome::one_line;
    number_corners(grid.size(), out);
    return HullOutcome::done;
}
} // namespace lr::shape
