#include "baker/card/outline_simplify.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>

namespace lr::baker {
namespace {

using Point = Eigen::Vector2d;

constexpr double part_of_gap = 0.25;

double cross(const Point& a, const Point& b) {
    return a.x() * b.y() - a.y() * b.x();
}

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
    const Point ab = b - a;
    const double length = ab.squaredNorm();
    const double t = length > 0.0 ? std::clamp((p - a).dot(ab) / length, 0.0, 1.0) : 0.0;
    return (p - a - t * ab).norm();
}

bool segments_meet(const Point& a, const Point& b, const Point& c, const Point& d) {
    const auto apart = [](double s, double t) { return (s > 0.0 && t > 0.0) || (s < 0.0 && t < 0.0); };
    return !apart(cross(b - a, c - a), cross(b - a, d - a)) && !apart(cross(d - c, a - c), cross(d - c, b - c)) &&
           std::max(a.x(), b.x()) >= std::min(c.x(), d.x()) && std::max(c.x(), d.x()) >= std::min(a.x(), b.x()) &&
           std::max(a.y(), b.y()) >= std::min(c.y(), d.y()) && std::max(c.y(), d.y()) >= std::min(a.y(), b.y());
}

double segment_distance(const Point& a, const Point& b, const Point& c, const Point& d) {
    if (segments_meet(a, b, c, d)) return 0.0;
    return std::min({distance_to_segment(a, c, d), distance_to_segment(b, c, d), distance_to_segment(c, a, b),
                     distance_to_segment(d, a, b)});
}

// Edges by the cells that they cross. An edge is named by its first vertex; readers check the vertex, because entries can be stale.
class EdgeGrid {
public:
    EdgeGrid(const Point& low, const Point& high, double cell) : low_(low), cell_(cell) {
        columns_ = index(high.x() - low.x()) + 1;
        rows_ = index(high.y() - low.y()) + 1;
        cells_.resize(columns_ * rows_);
    }

    void insert(uint32_t edge, const Point& a, const Point& b) {
        for_cells(a, b, 0.0, [&](std::vector<uint32_t>& cell) { cell.push_back(edge); });
    }

    template <class Visit> void visit_near(const Point& a, const Point& b, double reach, const Visit& visit) {
        for_cells(a, b, reach, [&](std::vector<uint32_t>& cell) {
            std::size_t kept = 0;
            for (std::size_t i = 0; i < cell.size(); ++i)
                if (visit(cell[i])) cell[kept++] = cell[i];
            cell.resize(kept);
        });
    }

private:
    std::size_t index(double x) const { return static_cast<std::size_t>(std::max(0.0, x / cell_)); }

    // The cells within reach of a segment, row by row.
    template <class Work> void for_cells(const Point& a, const Point& b, double reach, const Work& work) {
        const Point &bottom = a.y() <= b.y() ? a : b, &top = a.y() <= b.y() ? b : a;
        const double slack = reach + 1e-6 * cell_;
        const std::size_t first = std::min(rows_ - 1, index(bottom.y() - low_.y() - slack));
        const std::size_t last = std::min(rows_ - 1, index(top.y() - low_.y() + slack));
        const double rise = top.y() - bottom.y();
        for (std::size_t row = first; row <= last; ++row) {
            double from = 0.0, to = 1.0;
            if (rise > 0.0) {
                const double y = low_.y() + static_cast<double>(row) * cell_;
                from = std::clamp((y - slack - bottom.y()) / rise, 0.0, 1.0);
                to = std::clamp((y + cell_ + slack - bottom.y()) / rise, 0.0, 1.0);
            }
            const double x0 = bottom.x() + from * (top.x() - bottom.x()), x1 = bottom.x() + to * (top.x() - bottom.x());
            const std::size_t left = std::min(columns_ - 1, index(std::min(x0, x1) - low_.x() - slack));
            const std::size_t right = std::min(columns_ - 1, index(std::max(x0, x1) - low_.x() + slack));
            for (std::size_t column = left; column <= right; ++column) work(cells_[row * columns_ + column]);
        }
    }

    Point low_;
    double cell_;
    std::size_t columns_, rows_;
    std::vector<std::vector<uint32_t>> cells_;
};

struct Vertex {
    Point position;
    Point traced; // position on the traced outline
    uint32_t before, after, loop;
    uint32_t stands_for; // the nearest traced vertex
    bool alive = true;
};

// The collapse of the edge from `first` to the vertex after it.
struct Collapse {
    double moved;
    uint32_t first;
    uint32_t version;
    uint32_t stands_for;
    Point to;
    bool operator<(const Collapse& other) const { // best on top of the queue
        return moved != other.moved ? moved > other.moved : first > other.first;
    }
};

class Simplifier {
public:
    Simplifier(std::vector<Loop>& loops, double tolerance, double shortest)
        : loops_(loops), tolerance_(tolerance), shortest_(shortest) {
        Point low = Point::Constant(std::numeric_limits<double>::max()), high = -low;
        for (const Loop& loop : loops) {
            const auto base = static_cast<uint32_t>(vertices_.size()), n = static_cast<uint32_t>(loop.size());
            for (uint32_t i = 0; i < n; ++i) {
                Vertex v;
                v.position = v.traced = loop[i];
                v.stands_for = base + i;
                v.before = base + (i + n - 1) % n;
                v.after = base + (i + 1) % n;
                v.loop = static_cast<uint32_t>(left_.size());
                vertices_.push_back(v);
                low = low.cwiseMin(loop[i]);
                high = high.cwiseMax(loop[i]);
            }
            first_.push_back(base);
            left_.push_back(n);
        }
        version_.assign(vertices_.size(), 0);
        const Point extent = high - low;
        const double cell = std::max({4.0 * tolerance, 2.0, extent.maxCoeff() / 1024.0});
        grid_.emplace(low, high, cell);
    }

    void run() {
        for (uint32_t i = 0; i < vertices_.size(); ++i) grid_->insert(i, position(i), position(vertices_[i].after));
        for (uint32_t i = 0; i < vertices_.size(); ++i) propose(i);
        while (!queue_.empty()) {
            const Collapse best = queue_.top();
            queue_.pop();
            if (!vertices_[best.first].alive || best.version != version_[best.first]) continue;
            if (left_[vertices_[best.first].loop] > 3 && is_clear(best)) apply(best);
        }
        write();
    }

private:
    const Point& position(uint32_t i) const { return vertices_[i].position; }

    void propose(uint32_t first) {
        ++version_[first];
        const Vertex& b = vertices_[first];
        const uint32_t second = b.after, last = vertices_[second].after;
        if (last == b.before) return; // a triangle
        const Point &pa = position(b.before), &pb = b.position, &pc = position(second), &pd = position(last);
        const Point ad = pd - pa;
        const double length = (pc - pb).norm(),
                     limit = tolerance_ + (length < shortest_ ? std::min(length, 0.2 * shortest_) : 0.0);
        // Points p with area(a p d) = area(a b c d) form a line.
        const double twice_area = cross(pb - pa, pc - pa) + cross(pc - pa, pd - pa);
        Collapse best{std::numeric_limits<double>::max(), first, version_[first], b.stands_for, pb};
        const auto consider = [&](const Point& p) {
            if (distance_to_segment(p, pb, pc) > 4.0 * limit) return;
            const uint32_t nearest = nearest_traced(b.before, last, p);
            const double moved = std::max({distance_to_traced(nearest, p),
                                           deviation(vertices_[b.before].stands_for, nearest, pa, p, limit),
                                           deviation(nearest, vertices_[last].stands_for, p, pd, limit)});
            if (!(moved < best.moved)) return;
            best.moved = moved;
            best.to = p;
            best.stands_for = nearest;
        };
        // Its intersection with the line a b or c d keeps corners sharp; its point nearest to the edge smooths stairs.
        const double base = ad.norm();
        const auto on_line = [&](const Point& from, const Point& direction) {
            const double slope = cross(ad, direction);
            if (std::abs(slope) > 1e-9 * base * direction.norm())
                consider(from + direction * ((-twice_area - cross(ad, from - pa)) / slope));
        };
        on_line(pa, pb - pa);
        on_line(pc, pd - pc);
        on_line(0.5 * (pb + pc), {-ad.y(), ad.x()});
        if (best.moved <= limit) queue_.push(best);
    }

    // The traced vertex after i in its loop.
    uint32_t next(uint32_t i) const {
        const uint32_t loop = vertices_[i].loop, end = loop + 1 < first_.size() ? first_[loop + 1] : size();
        return i + 1 < end ? i + 1 : first_[loop];
    }
    uint32_t before(uint32_t i) const {
        const uint32_t loop = vertices_[i].loop, end = loop + 1 < first_.size() ? first_[loop + 1] : size();
        return i > first_[loop] ? i - 1 : end - 1;
    }
    uint32_t size() const { return static_cast<uint32_t>(vertices_.size()); }

    uint32_t nearest_traced(uint32_t from, uint32_t to, const Point& p) const {
        const uint32_t end = vertices_[to].stands_for;
        uint32_t nearest = next(vertices_[from].stands_for);
        for (uint32_t i = nearest; i != end; i = next(i))
            if ((vertices_[i].traced - p).squaredNorm() < (vertices_[nearest].traced - p).squaredNorm()) nearest = i;
        return nearest;
    }

    double distance_to_traced(uint32_t nearest, const Point& p) const {
        const Point& middle = vertices_[nearest].traced;
        return std::min(distance_to_segment(p, vertices_[before(nearest)].traced, middle),
                        distance_to_segment(p, middle, vertices_[next(nearest)].traced));
    }

    // Largest distance of the traced outline between two vertices from the edge that replaces it.
    double deviation(uint32_t from, uint32_t to, const Point& a, const Point& b, double limit) const {
        double most = 0.0;
        for (uint32_t i = next(from); i != to && most <= limit; i = next(i))
            most = std::max(most, distance_to_segment(vertices_[i].traced, a, b));
        return most;
    }

    // Other parts of the outlines must be farther away than a few times the displacement, and must not be crossed.
    bool is_clear(const Collapse& c) {
        const uint32_t b = c.first, d2 = vertices_[b].after, a = vertices_[b].before, d = vertices_[d2].after;
        const Point &pa = position(a), &pd = position(d);
        const double reach = c.moved / part_of_gap;
        // Adjacent parts of the same outline are always near, and must only not be crossed.
        std::vector<uint32_t> along;
        double length = 0.0;
        for (uint32_t v = a; length <= 4.0 * reach && vertices_[v].before != d; v = vertices_[v].before) {
            along.push_back(vertices_[v].before);
            length += (position(v) - position(vertices_[v].before)).norm();
        }
        length = 0.0;
        for (uint32_t v = d; length <= 4.0 * reach && vertices_[v].after != a; v = vertices_[v].after) {
            along.push_back(v);
            length += (position(v) - position(vertices_[v].after)).norm();
        }
        bool clear = true;
        const auto look = [&](const Point& from, const Point& to) {
            grid_->visit_near(from, to, reach, [&](uint32_t edge) {
                if (!vertices_[edge].alive) return false;
                if (!clear || edge == a || edge == b || edge == d2) return true;
                const Point &p = position(edge), &q = position(vertices_[edge].after);
                if (vertices_[edge].after == a)
                    clear = !segments_meet(p, q, c.to, pd);
                else if (edge == d)
                    clear = !segments_meet(p, q, pa, c.to);
                else if (std::find(along.begin(), along.end(), edge) != along.end())
                    clear = !segments_meet(p, q, pa, c.to) && !segments_meet(p, q, c.to, pd);
                else
                    clear = segment_distance(p, q, pa, c.to) > reach && segment_distance(p, q, c.to, pd) > reach &&
                            segment_distance(p, q, position(b), position(d2)) > reach;
                return true;
            });
        };
        look(pa, c.to);
        if (clear) look(c.to, pd);
        return clear;
    }

    void apply(const Collapse& c) {
        Vertex& b = vertices_[c.first];
        Vertex& gone = vertices_[b.after];
        const uint32_t a = b.before, d = gone.after;
        gone.alive = false;
        b.position = c.to;
        b.stands_for = c.stands_for;
        b.after = d;
        vertices_[d].before = c.first;
        --left_[b.loop];
        grid_->insert(a, position(a), b.position);
        grid_->insert(c.first, b.position, position(d));
        propose(vertices_[a].before);
        propose(a);
        propose(c.first);
        propose(d);
    }

    void write() {
        for (Loop& loop : loops_) loop.clear();
        for (const Vertex& v : vertices_)
            if (v.alive) loops_[v.loop].push_back(v.position); // in order, because the surviving vertex keeps its place
    }

    std::vector<Loop>& loops_;
    const double tolerance_, shortest_;
    std::vector<Vertex> vertices_;
    std::vector<uint32_t> version_, first_; // first_: of each loop
    std::vector<std::size_t> left_;
    std::optional<EdgeGrid> grid_;
    std::priority_queue<Collapse> queue_;
};
} // namespace

void simplify_outlines(std::vector<Loop>& loops, double tolerance, double shortest) {
    if (tolerance > 0.0 && !loops.empty()) Simplifier(loops, tolerance, shortest).run();
}
} // namespace lr::baker
