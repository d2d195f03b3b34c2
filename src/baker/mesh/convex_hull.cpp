#include "baker/mesh/convex_hull.h"

#include "asset/asset_file.h"
#include "base/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lr::baker {
namespace {

// About a second of work. A hull has some ten intermediate faces per point, more with a flat round side of thousands of corners.
constexpr std::size_t most_hull_faces = 2000000;
// The time to load an asset goes with their square: half a second.
constexpr std::size_t most_corners = 4000;

// Rounds the points to floats of one spacing, at most half a unit in the last place of the largest coordinate, and takes their hull, which is convex
// without a tolerance. Rounding the corners of a hull instead tilts slivers, which can become concave. Rounding also turns flat faces into bumps, so
// the points should be corners.
bool rounded_hull(std::vector<shape::HullPoint>& points, shape::ConvexHull& out) {
    double largest = 0.0;
    for (const shape::HullPoint& p : points)
        for (const double x : p) largest = std::max(largest, std::abs(x));
    if (points.size() < 3 || !(largest > 0.0)) return false;
    int exponent = 0;
    std::frexp(largest, &exponent);
    const double step = std::ldexp(1.0, exponent - shape::grid_bits); // multiples of it up to `largest` are floats
    std::vector<shape::GridPoint> grid(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            grid[i][k] = std::llround(points[i][k] / step);
            points[i][k] = static_cast<double>(grid[i][k]) * step;
        }
    return shape::exact_hull(grid, out) == shape::HullOutcome::done;
}

// Coordinates side by side, which the compiler takes in vectors.
struct Coordinates {
    Coordinates(const std::vector<shape::HullPoint>& points, const std::vector<uint32_t>& among) {
        for (Eigen::ArrayXd* a : {&x, &y, &z}) a->resize(static_cast<Eigen::Index>(among.size()));
        for (std::size_t i = 0; i < among.size(); ++i) {
            const auto at = static_cast<Eigen::Index>(i);
            const shape::HullPoint& p = points[among[i]];
            x[at] = p[0], y[at] = p[1], z[at] = p[2];
        }
    }
    Eigen::ArrayXd x, y, z;
};

// The furthest points in many directions, spread evenly over the sphere (spherical Fibonacci points).
std::vector<uint32_t> extreme_points(const Coordinates& at, const std::vector<uint32_t>& among) {
    constexpr std::size_t directions = most_corners;
    std::vector<uint32_t> found;
    Eigen::ArrayXd reach(at.x.size());
    for (std::size_t i = 0; i < directions; ++i) {
        const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(directions);
        const double turn = 2.399963229728653 * static_cast<double>(i), r = std::sqrt(1.0 - z * z);
        reach = r * std::cos(turn) * at.x + r * std::sin(turn) * at.y + z * at.z;
        const auto furthest = std::find(reach.begin(), reach.end(), reach.maxCoeff());
        found.push_back(among[static_cast<std::size_t>(furthest - reach.begin())]);
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

double furthest_outside(const std::vector<shape::HullPoint>& points, const Coordinates& among,
                        const shape::ConvexHull& hull) {
    const auto at = [&](uint32_t i) { return Eigen::Vector3d(points[i][0], points[i][1], points[i][2]); };
    double most = 0.0;
    for (const shape::HullTriangle& f : hull.triangles) {
        const Eigen::Vector3d a = at(hull.points[f[0]]);
        const Eigen::Vector3d n = (at(hull.points[f[1]]) - a).cross(at(hull.points[f[2]]) - a).normalized();
        most = std::max(most, (n[0] * among.x + (n[1] * among.y + n[2] * among.z)).maxCoeff() - n.dot(a));
    }
    return most;
}

// The hull of all points or, where that takes too long or has too many corners, of extreme_points.
shape::HullOutcome hull_in_time(const std::vector<shape::HullPoint>& points, shape::ConvexHull& hull) {
    const shape::HullOutcome outcome = shape::convex_hull(points, hull, most_hull_faces);
    const bool costly = outcome == shape::HullOutcome::too_costly;
    if (!costly && (outcome != shape::HullOutcome::done || hull.flat || hull.points.size() <= most_corners))
        return outcome;
    std::vector<uint32_t> among = hull.points;
    if (costly) {
        among.resize(points.size());
        std::iota(among.begin(), among.end(), 0U);
    }
    const double slack = costly ? 0.0 : hull.slack;
    const Coordinates coordinates(points, among);
    const std::vector<uint32_t> kept = extreme_points(coordinates, among);
    std::vector<shape::HullPoint> few;
    for (const uint32_t i : kept) few.push_back(points[i]);
    const shape::HullOutcome then = shape::convex_hull(few, hull);
    for (uint32_t& i : hull.points) i = kept[i];
    if (then == shape::HullOutcome::done)
        hull.slack = std::max(hull.slack, slack + furthest_outside(points, coordinates, hull));
    return then;
}
} // namespace

bool compute_convex_hull(const std::vector<Eigen::Vector3d>& points, ConvexHull& out, Faults& faults) {
    out = {};
    const auto fail = [&](FaultId id, const char* what, const char* remedy) {
        faults.push_back({id, Severity::error, "convex hull", what, remedy});
        return false;
    };
    std::vector<shape::HullPoint> from;
    from.reserve(points.size());
    for (const Eigen::Vector3d& p : points) from.push_back({p.x(), p.y(), p.z()});
    shape::ConvexHull hull;
    switch (hull_in_time(from, hull)) {
    case shape::HullOutcome::done:
        break;
    case shape::HullOutcome::not_finite:
        return fail(FaultId::mesh_not_finite, "A point is not finite.", "Correct or delete this vertex.");
    case shape::HullOutcome::too_few:
        return fail(FaultId::mesh_empty, "A hull needs at least three points.", "Check that the mesh has faces.");
    case shape::HullOutcome::one_point:
        return fail(FaultId::mesh_zero_volume, "All points coincide.", "Check the unit and the mesh.");
    case shape::HullOutcome::one_line:
        return fail(FaultId::mesh_zero_volume, "All points are on one line.", "Check the unit and the mesh.");
    case shape::HullOutcome::not_closed:
    case shape::HullOutcome::too_costly:
        return fail(FaultId::mesh_ill_conditioned, "The hull did not close.", "Report this mesh as a bug.");
    }
    for (const uint32_t i : hull.points) out.vertices.push_back(points[i]);
    out.faces = std::move(hull.triangles);
    out.slack = hull.slack;
    return true;
}

HullData store_hull(const ConvexHull& hull, double length) {
    const auto store = [](const auto& points, const auto& triangles) {
        HullData out;
        for (const auto& p : points)
            for (const double x : p) out.vertices.push_back(static_cast<float>(x));
        for (const auto& t : triangles) out.triangles.insert(out.triangles.end(), t.begin(), t.end());
        return out;
    };
    HullData stored = store(hull.vertices, hull.faces);
    if (!find_hull_flaw(stored, length)) return stored;
    std::vector<shape::HullPoint> points;
    for (const Eigen::Vector3d& p : hull.vertices) points.push_back({p.x(), p.y(), p.z()});
    shape::ConvexHull exact;
    if (!rounded_hull(points, exact)) return stored;
    std::vector<shape::HullPoint> corners;
    for (const uint32_t i : exact.points) corners.push_back(points[i]);
    return store(corners, exact.triangles);
}
} // namespace lr::baker
