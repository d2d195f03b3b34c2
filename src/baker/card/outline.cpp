#include "baker/card/outline.h"

#include "baker/card/outline_corners.h"
#include "baker/file_faults.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <new>
#include <numeric>
#include <optional>
#include <span>

namespace lr::baker {
namespace {

// A crossing closer to a pixel centre is moved away from it, so that loops through one pixel never touch.
constexpr double clearance = 1.0 / 256.0;
// A mask with more points is noise; 16 bytes each.
constexpr std::size_t max_points = 1 << 24;
constexpr std::size_t points_of_pinhole = sizeof(Pinhole) / sizeof(Eigen::Vector2d);

// The corners 0 to 3 of cell (x, y) are the centres of the pixels (x-1, y-1), (x, y-1), (x, y), (x-1, y); edge k runs from
// corner k to k + 1.
class Tracer {
public:
    // least_hole: pixels^2; holes at least as large are kept even if they are specks.
    Tracer(const AlphaMask& mask, double level, double speck, double least_hole = HUGE_VAL)
        : mask_(mask), level_(level), speck_(speck), least_hole_(least_hole),
          visited_((mask.width + 1) * (mask.height + 1), false) {}

    bool run() {
        for (std::size_t y = 1; y <= mask_.height; ++y)
            for (std::size_t x = 0; x <= mask_.width; ++x) {
                const auto sx = static_cast<std::ptrdiff_t>(x), sy = static_cast<std::ptrdiff_t>(y);
                if (opaque(sx - 1, sy - 1) && !opaque(sx, sy - 1) && !visited_[y * (mask_.width + 1) + x] &&
                    !follow(sx, sy))
                    return false;
            }
        return true;
    }

    std::vector<Loop> outer, holes;
    std::vector<double> outer_area, hole_area;
    std::vector<std::size_t> hole_pixel;
    std::vector<Pinhole> pinholes;
    std::size_t dropped_outer = 0;
    double dropped_outer_area = 0.0, largest = 0.0;

private:
    bool opaque(std::ptrdiff_t x, std::ptrdiff_t y) const { return mask_.at(x, y) >= level_; }

    // Follows a loop; enters the cell upwards with the opaque side on the left.
    bool follow(std::ptrdiff_t x, std::ptrdiff_t y) {
        static constexpr std::ptrdiff_t dx[4] = {-1, 0, 0, -1}, dy[4] = {-1, -1, 0, 0};
        static constexpr std::ptrdiff_t to_x[4] = {0, 1, 0, -1}, to_y[4] = {-1, 0, 1, 0};
        const std::ptrdiff_t first_x = x, first_y = y;
        std::size_t entry = 0;
        loop_.clear();
        do {
            double value[4];
            for (std::size_t k = 0; k < 4; ++k) value[k] = mask_.at(x + dx[k], y + dy[k]);
            const auto in = [&](std::size_t k) { return value[k % 4] >= level_; };
            if (entry == 0)
                visited_[static_cast<std::size_t>(y) * (mask_.width + 1) + static_cast<std::size_t>(x)] = true;
            abrupt_ += value[entry] >= 65535.0 && value[(entry + 1) % 4] <= 0.0;
            ++crossings_;
            loop_.push_back(crossing(x + dx[entry], y + dy[entry], value[entry], entry, value[(entry + 1) % 4]));
            std::size_t exit = entry;
            if (in(entry + 2) && !in(entry + 3)) {
                // In a saddle, leaving on the right joins the opaque corners; leaving on the left separates them.
                const double determinant = value[0] * value[2] - value[1] * value[3];
                const double twist = value[0] + value[2] - value[1] - value[3];
                const bool joined = twist > 0.0 ? determinant > level_ * twist : determinant < level_ * twist;
                exit = joined ? entry + 1 : entry + 3;
            } else {
                for (std::size_t turn = 1; turn < 4; ++turn)
                    if (!in(entry + turn) && in(entry + turn + 1)) exit = entry + turn;
            }
            exit %= 4;
            x += to_x[exit];
            y += to_y[exit];
            entry = (exit + 2) % 4;
        } while (x != first_x || y != first_y || entry != 0);
        return keep(static_cast<std::size_t>(first_y - 1) * mask_.width + static_cast<std::size_t>(first_x));
    }

    Eigen::Vector2d crossing(std::ptrdiff_t x, std::ptrdiff_t y, double from, std::size_t edge, double to) const {
        static constexpr double along_x[4] = {1.0, 0.0, -1.0, 0.0}, along_y[4] = {0.0, 1.0, 0.0, -1.0};
        const double t = std::clamp((level_ - from) / (to - from), clearance, 1.0 - clearance);
        const Eigen::Vector2d p(static_cast<double>(x) + 0.5 + t * along_x[edge],
                                static_cast<double>(y) + 0.5 + t * along_y[edge]);
        return {std::clamp(p.x(), 0.0, static_cast<double>(mask_.width)),
                std::clamp(p.y(), 0.0, static_cast<double>(mask_.height))};
    }

    // pixel: right of the first crossing; of a hole, within it.
    bool keep(std::size_t pixel) {
        const double area = signed_area(loop_);
        const bool hole = area < 0.0;
        if (!hole) largest = std::max(largest, area);
        const bool dropped = std::abs(area) < least(hole);
        if (dropped && !hole) drop(area);
        if (dropped && hole) close(pixel, loop_);
        points_ += !dropped ? loop_.size() : hole ? points_of_pinhole : 0;
        if (points_ > max_points) return false;
        if (dropped) return true;
        (hole ? holes : outer).push_back(loop_);
        (hole ? hole_area : outer_area).push_back(std::abs(area));
        if (hole) hole_pixel.push_back(pixel);
        return true;
    }

public:
    bool stairs() const { return 2 * abrupt_ > crossings_; }
    double least(bool hole) const { return hole ? std::min(speck_ * largest, least_hole_) : speck_ * largest; }
    void drop(double area) {
        ++dropped_outer;
        dropped_outer_area += area;
    }
    void close(std::size_t pixel, const Loop& hole) { pinholes.push_back({pixel, moments(hole, mask_.centre())}); }

private:
    const AlphaMask& mask_;
    const double level_, speck_, least_hole_;
    std::vector<bool> visited_; // edges between horizontal neighbours, crossed upwards
    Loop loop_;
    std::size_t points_ = 0, crossings_ = 0, abrupt_ = 0;
};

// A fern has thousands of holes, each a pinhole, together a fifth of its area. The largest are kept until the others hardly count; returns the area
// of the smallest that is kept.
double least_hole_that_counts(const Tracer& traced) {
    constexpr double uncounted = 0.01; // of the largest region
    constexpr std::size_t most = 5000; // noise has more
    std::vector<double> areas;
    for (const Pinhole& hole : traced.pinholes) areas.push_back(-hole.moments.area);
    for (const double area : traced.hole_area)
        if (area < traced.least(true)) areas.push_back(area);
    std::sort(areas.begin(), areas.end(), std::greater<>());
    double left = std::accumulate(areas.begin(), areas.end(), 0.0), least = HUGE_VAL;
    for (std::size_t i = 0; i < std::min(most, areas.size()) && left > uncounted * traced.largest; ++i)
        left -= least = areas[i];
    return least;
}

// Even-odd test whether a point lies inside an outline; points of different loops never coincide. Edges are listed by row, since a hole meets few
// rows.
class Inside {
public:
    explicit Inside(std::span<const Eigen::Vector2d> loop) : loop_(loop) {
        for (const Eigen::Vector2d& p : loop) box_.extend(p);
        edges_.resize(row(box_.max().y()) + 1);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const double from = start(i).y(), to = loop[i].y();
            for (std::size_t k = row(std::min(from, to)); k <= row(std::max(from, to)); ++k) edges_[k].push_back(i);
        }
    }

    bool contains(const Eigen::Vector2d& p) const {
        bool inside = false;
        if (!box_.contains(p)) return inside;
        for (const std::size_t i : edges_[row(p.y())]) {
            const Eigen::Vector2d &a = start(i), &b = loop_[i];
            if ((a.y() > p.y()) != (b.y() > p.y()) &&
                p.x() < a.x() + (b.x() - a.x()) * ((p.y() - a.y()) / (b.y() - a.y())))
                inside = !inside;
        }
        return inside;
    }

private:
    std::size_t row(double y) const { return static_cast<std::size_t>(y - box_.min().y()); }
    const Eigen::Vector2d& start(std::size_t i) const { return loop_[i > 0 ? i - 1 : loop_.size() - 1]; }

    std::span<const Eigen::Vector2d> loop_;
    Eigen::AlignedBox2d box_;
    std::vector<std::vector<std::size_t>> edges_;
};

// Assigns each hole to the smallest region around it.
void nest(Tracer& traced, Outlines& out) {
    std::vector<std::size_t> order(traced.outer.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return traced.outer_area[a] > traced.outer_area[b]; });
    for (const std::size_t i : order) {
        if (traced.outer_area[i] < traced.least(false)) { // the largest was not known during tracing
            traced.drop(traced.outer_area[i]);
            continue;
        }
        out.pieces.emplace_back();
        out.pieces.back().loops.push_back(std::move(traced.outer[i]));
        out.pieces.back().area = traced.outer_area[i];
    }
    std::vector<Inside> insides;
    for (const Piece& piece : out.pieces)
        if (!traced.holes.empty()) insides.emplace_back(piece.loops.front());
    for (std::size_t i = 0; i < traced.holes.size(); ++i) {
        if (traced.hole_area[i] < traced.least(true)) {
            traced.close(traced.hole_pixel[i], traced.holes[i]);
            continue;
        }
        const Eigen::Vector2d p = traced.holes[i].front();
        for (std::size_t k = insides.size(); k-- > 0;)
            if (insides[k].contains(p)) {
                out.pieces[k].loops.push_back(std::move(traced.holes[i]));
                break;
            }
    }
}
} // namespace

PlaneMoments& PlaneMoments::operator+=(const PlaneMoments& other) {
    area += other.area;
    first += other.first;
    second += other.second;
    return *this;
}

// Sums over the triangles of the origin and each side.
PlaneMoments moments(const Loop& loop, const Eigen::Vector2d& origin) {
    PlaneMoments sum;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Eigen::Vector2d a = loop[i] - origin, b = loop[i + 1 < loop.size() ? i + 1 : 0] - origin, both = a + b;
        const double part = 0.5 * (a.x() * b.y() - a.y() * b.x());
        sum +=
            {part, part / 3.0 * both, part / 12.0 * (a * a.transpose() + b * b.transpose() + both * both.transpose())};
    }
    return sum;
}

double signed_area(const Loop& loop) {
    double twice = 0.0;
    if (loop.empty()) return twice;
    const Eigen::Vector2d origin = loop.front();
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Eigen::Vector2d a = loop[i] - origin, b = loop[(i + 1) % loop.size()] - origin;
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * twice;
}

double perimeter(const Loop& loop) {
    double length = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) length += (loop[(i + 1) % loop.size()] - loop[i]).norm();
    return length;
}

bool trace_outlines(const AlphaMask& mask, double threshold, double speck, bool keep_pinholes, const std::string& where,
                    Outlines& out, Faults& faults) {
    out = Outlines{};
    const double level = threshold * 65535.0;
    const auto [low, high] = std::minmax_element(mask.opacity.begin(), mask.opacity.end());
    if (mask.opacity.empty() || *high < level)
        return fail(faults, FaultId::image_no_outline, where,
                    "No pixel is opaque: the highest opacity is " +
                        shortest(mask.opacity.empty() ? 0.0 : std::round(*high / 65.535) / 1000.0) + ".",
                    "Check the alpha channel or the mask, or give a lower threshold with --alpha.");
    if (*low >= level)
        return fail(faults, FaultId::image_no_outline, where,
                    "Every pixel is opaque: the lowest opacity is " + shortest(std::round(*low / 65.535) / 1000.0) +
                        ".",
                    "Give the colour around the leaf, as --key white, a mask image, as --mask mask.png, or a higher "
                    "threshold with --alpha; or cut the leaf out in an image editor. Bake a whole rectangle as a mesh "
                    "of two triangles, with --sheet.");
    std::optional<Tracer> tracer(std::in_place, mask, level, speck);
    bool good = tracer->run();
    const double least = good && keep_pinholes ? least_hole_that_counts(*tracer) : HUGE_VAL;
    if (least < HUGE_VAL) good = tracer.emplace(mask, level, speck, least).run();
    if (!good)
        return fail(faults, FaultId::image_too_ragged, where,
                    "The outline of the mask has more than 16 million points.",
                    "It looks like noise: blur the mask or reduce the image.");
    Tracer& traced = *tracer;
    nest(traced, out);
    CornerRestorer corners(mask, level);
    for (Piece& piece : out.pieces) {
        piece.area = 0.0;
        for (Loop& loop : piece.loops) {
            corners.restore(loop);
            piece.area += signed_area(loop);
        }
    }
    std::stable_sort(out.pieces.begin(), out.pieces.end(),
                     [](const Piece& a, const Piece& b) { return a.area > b.area; });
    out.stairs = traced.stairs();
    out.specks = traced.dropped_outer;
    out.speck_area = traced.dropped_outer_area;
    for (const Pinhole& hole : traced.pinholes) out.pinhole_area -= hole.moments.area;
    out.pinholes = std::move(traced.pinholes);
    return true;
}
} // namespace lr::baker
