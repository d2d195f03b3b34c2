#include "baker/mesh/convex_hull.h"

#include "asset/asset_file.h"
#include "base/convex_hull.h"

namespace lr::baker {

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
    switch (shape::convex_hull(from, hull)) {
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
    if (shape::exact_hull(points, exact) != shape::HullOutcome::done) return stored;
    std::vector<shape::HullPoint> corners;
    for (const uint32_t i : exact.points) corners.push_back(points[i]);
    return store(corners, exact.triangles);
}
} // namespace lr::baker
