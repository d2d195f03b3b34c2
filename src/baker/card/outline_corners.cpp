#include "baker/card/outline_corners.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace lr::baker {
namespace {

constexpr double run_length = 3.0;  // pixels of straight outline on both sides; stairs of a slope have shorter runs
constexpr double straight = 0.06;   // pixels; deviation of an anti-aliased slope from a line
constexpr double longest_cut = 1.5; // pixels along the outline
constexpr double nearest_end = 1.0 / 64.0; // pixels from the corner to the ends of the cut, at least
constexpr double farthest = 1.5;           // the same, at most
constexpr double least_turn = 0.5;         // sine of the angle between the runs

double signed_area(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

// Unit direction from loop[i] along `step` (1 or n - 1) if the outline is straight for run_length.
std::optional<Eigen::Vector2d> straight_run(const Loop& loop, std::size_t i, std::size_t step) {
    const std::size_t n = loop.size();
    std::size_t end = i;
    double length = 0.0;
    for (std::size_t count = 0; length < run_length && count + 1 < n; ++count) {
        const std::size_t next = (end + step) % n;
        length += (loop[next] - loop[end]).norm();
        end = next;
    }
    const Eigen::Vector2d chord = loop[end] - loop[i];
    if (length < run_length || chord.norm() < 0.9 * run_length) return std::nullopt;
    const Eigen::Vector2d direction = chord / chord.norm();
    for (std::size_t k = i; k != end; k = (k + step) % n)
        if (std::abs(signed_area(direction, loop[k] - loop[i])) > straight) return std::nullopt;
    return direction;
}

// The corner, if any, that was cut off between loop[i] and loop[j].
std::optional<Eigen::Vector2d> find_corner(const Loop& loop, std::size_t i, std::size_t j) {
    const auto before = straight_run(loop, i, loop.size() - 1), after = straight_run(loop, j, 1);
    if (!before || !after) return std::nullopt;
    const double turn = signed_area(*before, *after);
    if (std::abs(turn) < least_turn) return std::nullopt;
    const Eigen::Vector2d gap = loop[j] - loop[i];
    const double beyond_i = -signed_area(gap, *after) / turn, beyond_j = -signed_area(gap, *before) / turn;
    if (!(beyond_i > nearest_end && beyond_j > nearest_end && beyond_i <= farthest && beyond_j <= farthest))
        return std::nullopt;
    return loop[i] - beyond_i * *before;
}

std::ptrdiff_t cell_of(double x) {
    return static_cast<std::ptrdiff_t>(std::floor(x + 0.5));
}
} // namespace

// Number of cell edges that outlines cross: 0, 2, or 4 in a saddle.
int CornerRestorer::crossings(const Cell& cell) const {
    const auto [x, y] = cell;
    const bool in[4] = {mask_.at(x - 1, y - 1) >= level_, mask_.at(x, y - 1) >= level_, mask_.at(x, y) >= level_,
                        mask_.at(x - 1, y) >= level_};
    return (in[0] != in[1]) + (in[1] != in[2]) + (in[2] != in[3]) + (in[3] != in[0]);
}

// Whether the added triangle overlaps only empty cells and cells of this part of the outline.
bool CornerRestorer::is_free(const Loop& loop, std::size_t i, std::size_t j, const Eigen::Vector2d& corner) {
    const std::size_t n = loop.size();
    std::set<Cell> own, empty;
    for (std::size_t k = (i + n - 2) % n; k != (j + 2) % n; k = (k + 1) % n) {
        const Eigen::Vector2d middle = 0.5 * (loop[k] + loop[(k + 1) % n]);
        own.insert({cell_of(middle.x()), cell_of(middle.y())});
    }
    const Eigen::Vector2d low = corner.cwiseMin(loop[i]).cwiseMin(loop[j]);
    const Eigen::Vector2d high = corner.cwiseMax(loop[i]).cwiseMax(loop[j]);
    for (std::ptrdiff_t x = cell_of(low.x()); x <= cell_of(high.x()); ++x)
        for (std::ptrdiff_t y = cell_of(low.y()); y <= cell_of(high.y()); ++y) {
            const int crossed = crossings({x, y});
            if (crossed == 4 || (crossed == 2 && !own.contains({x, y})) || taken_.contains({x, y})) return false;
            if (crossed == 0) empty.insert({x, y});
        }
    taken_.merge(empty);
    return true;
}

void CornerRestorer::restore(Loop& loop) {
    const std::size_t n = loop.size();
    if (n < 8) return;
    Loop with_corners;
    std::size_t skip_first = 0; // points at the start that belong to a cut across the end
    for (std::size_t i = 0; i < n; ++i) {
        with_corners.push_back(loop[i]);
        double cut = 0.0;
        for (std::size_t count = 1; count <= 3; ++count) {
            const std::size_t j = (i + count) % n;
            cut += (loop[j] - loop[(i + count - 1) % n]).norm();
            if (cut > longest_cut) break;
            const auto corner = find_corner(loop, i, j);
            if (!corner || !is_free(loop, i, j, *corner)) continue;
            with_corners.push_back(*corner);
            if (i + count >= n) skip_first = i + count - n;
            i += count - 1;
            break;
        }
    }
    with_corners.erase(with_corners.begin(), with_corners.begin() + static_cast<std::ptrdiff_t>(skip_first));
    loop = std::move(with_corners);
}
} // namespace lr::baker
