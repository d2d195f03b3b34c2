#include "baker/card/planar_mesh.h"

#include "baker/card/delaunay.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

namespace lr::baker {
namespace {

constexpr uint32_t none = UINT32_MAX;
constexpr double too_large = 0.75;     // circumradius over edge length; 0.577 in an equilateral triangle
constexpr double seed_clearance = 0.7; // of lattice points to the outline, in edge lengths
constexpr double finest = 0.03;        // triangles below this fraction of the edge length are not split for their shape
// 1/2 over sin(a), and 1/2 over tan(a/2), of the wanted angle a = 25 degrees; literals, because sin and tan differ between machines.
constexpr double best_ratio = 1.1831007915762493, height = 2.2553542518310286;
constexpr int max_flip_rounds = 80;
constexpr int smoothing_rounds = 12;
// Cosine of the angle between sides; at sharper corners the splits of both sides must match.
constexpr double sharp = 0.5;

int64_t dot(const GridPoint& o, const GridPoint& a, const GridPoint& b) {
    return (int64_t{a.x} - o.x) * (int64_t{b.x} - o.x) + (int64_t{a.y} - o.y) * (int64_t{b.y} - o.y);
}

double distance(const GridPoint& a, const GridPoint& b) {
    return std::sqrt(static_cast<double>(dot(a, b, b)));
}

struct Segment {
    uint32_t from, to; // the region is on the left
    uint32_t side;     // its side of the outline
};

struct Circle {
    double x, y, radius, shortest;
    std::size_t shortest_at; // the side from this corner to the next
};

Circle circumcircle(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
    const double bx = static_cast<double>(b.x) - a.x, by = static_cast<double>(b.y) - a.y;
    const double cx = static_cast<double>(c.x) - a.x, cy = static_cast<double>(c.y) - a.y;
    const double b2 = bx * bx + by * by, c2 = cx * cx + cy * cy, d = 2.0 * static_cast<double>(doubled_area(a, b, c));
    const double ux = (cy * b2 - by * c2) / d, uy = (bx * c2 - cx * b2) / d;
    const double sides[3] = {b2, (cx - bx) * (cx - bx) + (cy - by) * (cy - by), c2};
    const auto least = static_cast<std::size_t>(std::min_element(sides, sides + 3) - sides);
    return {a.x + ux, a.y + uy, std::sqrt(ux * ux + uy * uy), std::sqrt(sides[least]), least};
}

// Sine of the smallest angle is shortest / (2 R).
double shape(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
    if (doubled_area(a, b, c) <= 0) return -1.0;
    const Circle circle = circumcircle(a, b, c);
    return circle.shortest / (2.0 * circle.radius);
}

// Indices in square cells, to find neighbours within one cell width.
class Bins {
public:
    explicit Bins(double width) : width_(width) {}
    void add(double x, double y, uint32_t number) { bins_[key(x, y)].push_back(number); }
    template <class Test> bool any_near(double x, double y, const Test& test) const {
        const auto [row, column] = key(x, y);
        for (int64_t r = row - 1; r <= row + 1; ++r)
            for (int64_t c = column - 1; c <= column + 1; ++c) {
                const auto bin = bins_.find({r, c});
                if (bin == bins_.end()) continue;
                for (const uint32_t number : bin->second)
                    if (test(number)) return true;
            }
        return false;
    }

private:
    std::pair<int64_t, int64_t> key(double x, double y) const {
        return {static_cast<int64_t>(std::floor(y / width_)), static_cast<int64_t>(std::floor(x / width_))};
    }
    double width_;
    std::map<std::pair<int64_t, int64_t>, std::vector<uint32_t>> bins_;
};

// Delaunay refinement (Ruppert 1995, A Delaunay refinement algorithm for quality 2-dimensional mesh generation), many points
// per round, with the off-centres of Ungor 2004 and, at sharp corners, splits on concentric shells. Starts from a hexagonal lattice.
class PlanarRefiner {
public:
    PlanarRefiner(double edge, std::size_t max_faces) : edge_(edge), max_points_(max_faces + 100) {}

    // loops: in grid coordinates.
    bool run(const std::vector<std::vector<GridPoint>>& loops) {
        for (const std::vector<GridPoint>& loop : loops) add_loop(loop);
        if (!split_until_present()) return false;
        seed();
        for (int round = 0; round < max_flip_rounds; ++round) {
            if (!split_until_present()) return false;
            if (!insert_points()) break;
        }
        for (int round = 0; round < smoothing_rounds; ++round) {
            smooth();
            if (!split_until_present()) return false;
        }
        return fills();
    }

    const std::vector<GridPoint>& points() const { return points_; }
    const std::vector<Face>& faces() const { return faces_; }

private:
    uint32_t add_point(const GridPoint& p, uint32_t side) {
        points_.push_back(p);
        side_.push_back(side);
        sharp_.push_back(false);
        tip_.push_back(false);
        return static_cast<uint32_t>(points_.size() - 1);
    }

    void add_loop(const std::vector<GridPoint>& loop) {
        const std::size_t n = loop.size();
        std::vector<uint32_t> corner(n);
        const auto first_side = static_cast<uint32_t>(after_tip_.size());
        for (std::size_t i = 0; i < n; ++i) {
            corner[i] = add_point(loop[i], none);
            const GridPoint &before = loop[(i + n - 1) % n], &after = loop[(i + 1) % n];
            const bool narrow = static_cast<double>(dot(loop[i], before, after)) >
                                sharp * distance(loop[i], before) * distance(loop[i], after);
            sharp_.back() = narrow;
            tip_.back() = narrow && doubled_area(before, loop[i], after) > 0;
        }
        for (std::size_t i = 0; i < n; ++i) {
            const auto side = first_side + static_cast<uint32_t>(i);
            const uint32_t next = first_side + static_cast<uint32_t>((i + 1) % n);
            after_tip_.push_back(tip_[corner[(i + 1) % n]] ? next : none);
            const GridPoint &a = loop[i], &b = loop[(i + 1) % n];
            const auto parts = static_cast<int64_t>(std::max(1.0, std::ceil(distance(a, b) / edge_ - 0.1)));
            uint32_t from = corner[i];
            for (int64_t k = 1; k <= parts; ++k) {
                const auto between = [&](int32_t p, int32_t q) {
                    return static_cast<int32_t>(p + (int64_t{q} - p) * k / parts);
                };
                const uint32_t to =
                    k == parts ? corner[(i + 1) % n] : add_point({between(a.x, b.x), between(a.y, b.y)}, side);
                segments_.push_back({from, to, side});
                from = to;
            }
        }
    }

    // Splits at the middle or, next to a sharp corner, at a power of two from the corner, so that both sides split at equal distances and do not
    // encroach on each other endlessly.
    bool split(std::size_t index) {
        const Segment s = segments_[index];
        const GridPoint a = points_[s.from], b = points_[s.to];
        const double length = distance(a, b);
        if (length < 32.0 || points_.size() >= max_points_) return false;
        double part = 0.5;
        const std::vector<char>& narrow = tip_[s.from] != tip_[s.to] ? tip_ : sharp_;
        if (narrow[s.from] != narrow[s.to]) {
            int exponent = 0;
            std::frexp(length * (2.0 / 3.0), &exponent);
            part = std::ldexp(1.0, exponent - 1) / length;
            if (narrow[s.to]) part = 1.0 - part;
        }
        const auto between = [&](int32_t p, int32_t q) {
            return static_cast<int32_t>(std::floor(p + part * (static_cast<double>(q) - p) + 0.5));
        };
        const uint32_t middle = add_point({between(a.x, b.x), between(a.y, b.y)}, s.side);
        segments_[index].to = middle;
        segments_.push_back({middle, s.to, s.side});
        return true;
    }

    // Whether a point is behind the segment, or sees it from the front under more than 120 degrees. With full circles (90 degrees) splits of one
    // tooth of a serrated leaf would propagate to all others.
    bool encroaches(const GridPoint& p, const Segment& s) const {
        return is_too_close(p, points_[s.from], points_[s.to]);
    }
    static bool is_too_close(const GridPoint& p, const GridPoint& a, const GridPoint& b) {
        const int64_t d = dot(p, a, b);
        if (d >= 0) return false;
        return doubled_area(a, b, p) <= 0 || static_cast<double>(d) < -0.5 * distance(p, a) * distance(p, b);
    }

    static uint64_t key(uint32_t from, uint32_t to) { return uint64_t{from} << 32 | to; }

    // The face to the left of a directed edge, or none.
    uint32_t face_at(uint32_t from, uint32_t to) const {
        const auto at = std::lower_bound(half_edges_.begin(), half_edges_.end(), std::pair{key(from, to), uint32_t{0}});
        return at != half_edges_.end() && at->first == key(from, to) ? at->second : none;
    }

    // Triangulates until each segment is an edge and no segment is encroached.
    bool split_until_present() {
        for (;;) {
            faces_ = delaunay(points_);
            half_edges_.clear();
            for (std::size_t i = 0; i < faces_.size(); ++i)
                for (std::size_t k = 0; k < 3; ++k)
                    half_edges_.emplace_back(key(faces_[i][k], faces_[i][(k + 1) % 3]), static_cast<uint32_t>(i));
            std::sort(half_edges_.begin(), half_edges_.end());
            bool complete = true;
            for (std::size_t i = 0, n = segments_.size(); i < n; ++i) {
                const Segment s = segments_[i];
                const uint32_t face = face_at(s.from, s.to);
                bool bad = face == none;
                if (!bad)
                    for (const uint32_t apex : faces_[face])
                        if (apex != s.from && apex != s.to && encroaches(points_[apex], s))
                            bad = distance(points_[s.from], points_[s.to]) > finest * edge_;
                if (!bad) continue;
                if (!split(i)) return false;
                complete = false;
            }
            if (complete) return keep_inside();
        }
    }

    // Keeps the faces of the region, found by a flood from the left of the segments.
    bool keep_inside() {
        std::vector<uint64_t> walls;
        for (const Segment& s : segments_) walls.push_back(key(s.from, s.to));
        std::sort(walls.begin(), walls.end());
        const auto is_wall = [&](uint64_t k) { return std::binary_search(walls.begin(), walls.end(), k); };
        std::vector<char> inside(faces_.size(), 0);
        std::vector<uint32_t> stack;
        const auto reach = [&](uint32_t face) {
            if (face == none || inside[face]) return;
            inside[face] = 1;
            stack.push_back(face);
        };
        for (const Segment& s : segments_) reach(face_at(s.from, s.to));
        while (!stack.empty()) {
            const Face face = faces_[stack.back()];
            stack.pop_back();
            for (std::size_t k = 0; k < 3; ++k) {
                const uint32_t a = face[k], b = face[(k + 1) % 3];
                if (is_wall(key(b, a))) return false; // the flood reaches a segment from behind, so the loops cross
                if (!is_wall(key(a, b))) reach(face_at(b, a));
            }
        }
        std::size_t kept = 0;
        for (std::size_t i = 0; i < faces_.size(); ++i)
            if (inside[i]) faces_[kept++] = faces_[i];
        faces_.resize(kept);
        return true;
    }

    Bins segment_bins() const {
        Bins bins(1.2 * edge_); // segments are at most 1.1 edges long
        for (std::size_t i = 0; i < segments_.size(); ++i) {
            const GridPoint &a = points_[segments_[i].from], &b = points_[segments_[i].to];
            bins.add(0.5 * (static_cast<double>(a.x) + b.x), 0.5 * (static_cast<double>(a.y) + b.y),
                     static_cast<uint32_t>(i));
        }
        return bins;
    }

    // Adds a hexagonal lattice with a clearance from the outline.
    void seed() {
        int32_t bottom = max_grid_coordinate, top = -max_grid_coordinate;
        for (const GridPoint& p : points_) {
            bottom = std::min(bottom, p.y);
            top = std::max(top, p.y);
        }
        const Bins bins = segment_bins();
        const double rise = edge_ * std::numbers::sqrt3 / 2.0;
        const auto rows = static_cast<int64_t>((static_cast<double>(top) - bottom) / rise);
        const double offset = bottom + 0.5 * (static_cast<double>(top) - bottom - static_cast<double>(rows) * rise);
        const std::vector<Segment> outline = segments_;
        for (int64_t row = 0; row <= rows; ++row) {
            const double y = std::floor(offset + static_cast<double>(row) * rise) + 0.5; // no vertex has this y
            std::vector<double> crossings;
            for (const Segment& s : outline) {
                const GridPoint &a = points_[s.from], &b = points_[s.to];
                if ((a.y > y) != (b.y > y))
                    crossings.push_back(a.x + (y - a.y) / (static_cast<double>(b.y) - a.y) *
                                                  (static_cast<double>(b.x) - a.x));
            }
            std::sort(crossings.begin(), crossings.end());
            for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
                const double shift = row % 2 ? 0.5 : 0.0;
                for (double k = std::ceil(crossings[i] / edge_ - shift); (k + shift) * edge_ < crossings[i + 1]; ++k) {
                    const GridPoint p{static_cast<int32_t>((k + shift) * edge_), static_cast<int32_t>(y)};
                    const bool close = bins.any_near(p.x, p.y, [&](uint32_t number) {
                        const GridPoint &a = points_[outline[number].from], &b = points_[outline[number].to];
                        const double length2 = static_cast<double>(dot(a, b, b));
                        const double t = std::clamp(static_cast<double>(dot(a, b, p)) / length2, 0.0, 1.0);
                        const double dx = a.x + t * (static_cast<double>(b.x) - a.x) - p.x;
                        const double dy = a.y + t * (static_cast<double>(b.y) - a.y) - p.y;
                        return std::sqrt(dx * dx + dy * dy) < seed_clearance * edge_;
                    });
                    if (!close && points_.size() < max_points_) add_point(p, none);
                }
            }
        }
    }

    // Whether the outline forces the angle: at a tip, and between the two sides of a tip.
    bool is_forced(const Face& f, const Circle& circle) const {
        if (tip_[f[0]] || tip_[f[1]] || tip_[f[2]]) return true;
        const uint32_t a = side_[f[circle.shortest_at]], b = side_[f[(circle.shortest_at + 1) % 3]];
        return a != none && b != none && (after_tip_[a] == b || after_tip_[b] == a);
    }

    struct Candidate {
        double radius; // distance to the corners of its face
        GridPoint at;
    };

    bool insert_points() {
        std::vector<Candidate> candidates;
        for (const Face& f : faces_) {
            const Circle circle = circumcircle(points_[f[0]], points_[f[1]], points_[f[2]]);
            const bool large = circle.radius > too_large * edge_;
            const bool thin = circle.radius > best_ratio * circle.shortest && circle.shortest > finest * edge_ &&
                              !is_forced(f, circle);
            if (!large && !thin) continue;
            double x = circle.x, y = circle.y, radius = circle.radius;
            if (thin) {
                const GridPoint &p = points_[f[circle.shortest_at]], &q = points_[f[(circle.shortest_at + 1) % 3]];
                const double mx = 0.5 * (static_cast<double>(p.x) + q.x), my = 0.5 * (static_cast<double>(p.y) + q.y);
                const double away = std::sqrt((x - mx) * (x - mx) + (y - my) * (y - my));
                if (away > height * circle.shortest) {
                    const double t = height * circle.shortest / away;
                    x = mx + t * (x - mx);
                    y = my + t * (y - my);
                    radius = circle.shortest * std::sqrt(height * height + 0.25);
                }
            }
            if (std::abs(x) > max_grid_coordinate || std::abs(y) > max_grid_coordinate) continue;
            candidates.push_back({radius, {static_cast<int32_t>(x), static_cast<int32_t>(y)}});
        }
        std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
            if (a.radius != b.radius) return a.radius > b.radius;
            return a.at.x != b.at.x ? a.at.x < b.at.x : a.at.y < b.at.y;
        });
        return take(candidates);
    }

    // Adds candidates that are far enough from each other. A candidate that encroaches on a segment splits the segment instead.
    bool take(const std::vector<Candidate>& candidates) {
        const Bins bins = segment_bins();
        Bins fresh(1.2 * edge_);
        std::vector<uint32_t> encroached;
        bool any = false;
        for (const Candidate& c : candidates) {
            const double x = c.at.x, y = c.at.y;
            if (points_.size() >= max_points_) break;
            bool clear = true;
            bins.any_near(x, y, [&](uint32_t number) {
                const Segment& s = segments_[number];
                if (!encroaches(c.at, s)) return false;
                if (distance(points_[s.from], points_[s.to]) > 2.0 * finest * edge_) encroached.push_back(number);
                clear = false;
                return false;
            });
            const double reach = std::min(0.9 * c.radius, edge_);
            if (!clear || fresh.any_near(x, y, [&](uint32_t i) { return distance(points_[i], c.at) < reach; }))
                continue;
            fresh.add(x, y, add_point(c.at, none));
            any = true;
        }
        std::sort(encroached.begin(), encroached.end());
        encroached.erase(std::unique(encroached.begin(), encroached.end()), encroached.end());
        for (const uint32_t i : encroached) any = split(i) || any;
        return any;
    }

    // Moves inner points to the mean of their neighbours if that improves the worst triangle around them.
    void smooth() {
        std::vector<std::vector<uint32_t>> around(points_.size());
        for (std::size_t i = 0; i < faces_.size(); ++i)
            for (const uint32_t v : faces_[i]) around[v].push_back(static_cast<uint32_t>(i));
        std::vector<char> fixed(points_.size(), 0);
        for (const Segment& s : segments_) fixed[s.from] = 1;
        const auto worst = [&](uint32_t v) {
            double least = 1.0;
            for (const uint32_t i : around[v]) {
                const Face& f = faces_[i];
                least = std::min(least, shape(points_[f[0]], points_[f[1]], points_[f[2]]));
                for (std::size_t k = 0; k < 3; ++k)
                    if (f[k] == v && fixed[f[(k + 1) % 3]] && fixed[f[(k + 2) % 3]] &&
                        is_too_close(points_[v], points_[f[(k + 1) % 3]], points_[f[(k + 2) % 3]]))
                        return -1.0; // too close, perhaps to a segment
            }
            return least;
        };
        for (uint32_t v = 0; v < points_.size(); ++v) {
            if (fixed[v] || around[v].empty()) continue;
            int64_t x = 0, y = 0, count = 0;
            for (const uint32_t i : around[v])
                for (const uint32_t other : faces_[i])
                    if (other != v) {
                        x += points_[other].x;
                        y += points_[other].y;
                        ++count;
                    }
            const GridPoint before = points_[v];
            const double quality = worst(v);
            for (const int64_t part : {4, 2}) {
                points_[v] = {static_cast<int32_t>(before.x + (x / count - before.x) * part / 4),
                              static_cast<int32_t>(before.y + (y / count - before.y) * part / 4)};
                if (worst(v) > quality) break;
                points_[v] = before;
            }
        }
    }

    // Whether the faces cover the area of the region exactly, in integers.
    bool fills() const {
        __extension__ using Wide = __int128;
        Wide difference = 0;
        for (const Face& f : faces_) difference += doubled_area(points_[f[0]], points_[f[1]], points_[f[2]]);
        const GridPoint origin{0, 0};
        for (const Segment& s : segments_) difference -= doubled_area(origin, points_[s.from], points_[s.to]);
        return difference == 0;
    }

    const double edge_;
    const std::size_t max_points_;
    std::vector<GridPoint> points_;
    std::vector<uint32_t> side_;      // the side of the outline that a point is inside of
    std::vector<char> sharp_;         // corners that are sharp, convex or concave
    std::vector<char> tip_;           // corners that are sharp within the region
    std::vector<uint32_t> after_tip_; // for each side, the next side if a tip is between them
    std::vector<Segment> segments_;
    std::vector<Face> faces_;
    std::vector<std::pair<uint64_t, uint32_t>> half_edges_; // of all faces of the triangulation, sorted
};
} // namespace

bool triangulate_region(const std::vector<Loop>& loops, double edge, std::size_t max_faces, PlanarMesh& out) {
    out = PlanarMesh{};
    double reach = 0.0;
    for (const Loop& loop : loops)
        for (const Eigen::Vector2d& p : loop) reach = std::max({reach, std::abs(p.x()), std::abs(p.y())});
    if (!(reach > 0.0 && reach < 1e6 && edge > 0.0)) return false;
    int exponent = 0;
    std::frexp(reach, &exponent);
    const double scale = std::ldexp(1.0, 29 - exponent); // a power of two keeps whole pixels exact
    std::vector<std::vector<GridPoint>> on_grid;
    for (const Loop& loop : loops) {
        std::vector<GridPoint>& points = on_grid.emplace_back();
        for (const Eigen::Vector2d& p : loop) {
            const GridPoint q{static_cast<int32_t>(std::floor(p.x() * scale + 0.5)),
                              static_cast<int32_t>(std::floor(p.y() * scale + 0.5))};
            if (points.empty() || !(points.back() == q)) points.push_back(q);
        }
        while (points.size() > 1 && points.back() == points.front()) points.pop_back();
        if (points.size() < 3) return false;
    }
    PlanarRefiner refiner(edge * scale, max_faces);
    if (!refiner.run(on_grid)) return false;
    std::vector<uint32_t> renumbered(refiner.points().size(), none);
    for (const Face& face : refiner.faces()) {
        Face f{};
        for (std::size_t k = 0; k < 3; ++k) {
            uint32_t& number = renumbered[face[k]];
            if (number == none) {
                number = static_cast<uint32_t>(out.vertices.size());
                const GridPoint& p = refiner.points()[face[k]];
                out.vertices.emplace_back(p.x / scale, p.y / scale);
            }
            f[k] = number;
        }
        out.faces.push_back(f);
    }
    return !out.faces.empty();
}

double smallest_angle(const PlanarMesh& mesh) {
    double least = 180.0;
    for (const Face& f : mesh.faces)
        for (std::size_t k = 0; k < 3; ++k) {
            const Eigen::Vector2d a = mesh.vertices[f[(k + 1) % 3]] - mesh.vertices[f[k]];
            const Eigen::Vector2d b = mesh.vertices[f[(k + 2) % 3]] - mesh.vertices[f[k]];
            least = std::min(least, std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)) * 180.0 / std::numbers::pi);
        }
    return least;
}
} // namespace lr::baker
