#include "baker/mesh/mass_properties.h"

#include "baker/eigensystem.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lr::baker {
namespace {

// Integrals over the tetrahedron (origin, a, b, c): volume, first and second moments. Their sum over the faces of a closed
// surface is the integral over the solid (Tonon 2004; Mirtich 1996 by a different derivation).
struct Moments {
    double volume = 0.0;
    Eigen::Vector3d first = Eigen::Vector3d::Zero();
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();

    void add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
        const double tetrahedron = a.dot(b.cross(c)) / 6.0;
        const Eigen::Vector3d sum = a + b + c;
        volume += tetrahedron;
        first += tetrahedron / 4.0 * sum;
        second +=
            tetrahedron / 20.0 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
    }
};

// Eigenvectors have no defined sign and, for equal moments, no defined direction. Fixes both, so that a cube gets the axes of its mesh instead of
// rounding errors.
void fix_axes(const Eigen::Vector3d& moments, Eigen::Matrix3d& axes) {
    const double equal = 1e-7 * moments[2];
    const bool low_pair = moments[1] - moments[0] < equal, high_pair = moments[2] - moments[1] < equal;
    if (low_pair && high_pair) {
        axes.setIdentity();
        return;
    }
    if (low_pair || high_pair) {
        const Eigen::Index single = low_pair ? 2 : 0;
        const Eigen::Vector3d axis = axes.col(single);
        Eigen::Index least = 0;
        axis.cwiseAbs().minCoeff(&least);
        const Eigen::Vector3d first = (Eigen::Vector3d::Unit(least) - axis[least] * axis).normalized();
        axes.col(low_pair ? 0 : 1) = first;
    }
    for (Eigen::Index k = 0; k < 2; ++k) {
        Eigen::Index largest = 0;
        axes.col(k).cwiseAbs().maxCoeff(&largest);
        if (axes(largest, k) < 0.0) axes.col(k) = -axes.col(k);
    }
    if (low_pair) axes.col(1) = axes.col(2).cross(axes.col(0));
    axes.col(2) = axes.col(0).cross(axes.col(1));
}

struct Bounds {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d high = -low;

    void extend(const Eigen::Vector3d& p) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
};

// Integrals use a mesh centred and scaled to size one, so that distant and tiny meshes lose no digits.
struct UnitFrame {
    explicit UnitFrame(const Mesh& mesh) {
        Bounds bounds;
        for (const Eigen::Vector3d& v : mesh.vertices) bounds.extend(v);
        origin = 0.5 * (bounds.low + bounds.high);
        size = (bounds.high - bounds.low).norm();
    }
    std::array<Eigen::Vector3d, 3> corners(const Mesh& mesh, const Face& face) const {
        return {(mesh.vertices[face[0]] - origin) / size, (mesh.vertices[face[1]] - origin) / size,
                (mesh.vertices[face[2]] - origin) / size};
    }

    Eigen::Vector3d origin;
    double size;
};

// covariance: for unit density, in the unit frame.
void set_inertia(const Eigen::Matrix3d& covariance, double size, MassProperties& result) {
    const Eigen::Matrix3d inertia = covariance.trace() * Eigen::Matrix3d::Identity() - covariance;
    result.inertia = 0.5 * (inertia + inertia.transpose()) * std::pow(size, 5);
    const Eigensystem<Eigen::Matrix3d> solver = eigensystem(inertia);
    result.principal = solver.values * std::pow(size, 5);
    result.axes = solver.vectors;
    fix_axes(solver.values, result.axes);
}

// The first `solid_faces` faces cover their projection twice, as a closed surface does, the others once.
void set_extents(const Mesh& mesh, std::size_t solid_faces, MassProperties& result) {
    Bounds bounds;
    for (const Eigen::Vector3d& v : mesh.vertices) bounds.extend(result.axes.transpose() * (v - result.centroid));
    result.extents = bounds.high - bounds.low;
    result.projected_areas.setZero();
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        const Face& face = mesh.faces[i];
        const double sides = i < solid_faces ? 2.0 : 1.0;
        const Eigen::Vector3d& a = mesh.vertices[face[0]];
        const Eigen::Vector3d twice_area = (mesh.vertices[face[1]] - a).cross(mesh.vertices[face[2]] - a);
        result.projected_areas += 0.5 / sides * (result.axes.transpose() * twice_area).cwiseAbs();
    }
    result.max_projected_area = result.projected_areas.maxCoeff();
}
} // namespace

MassProperties compute_mass_properties(const Mesh& mesh) {
    const UnitFrame frame(mesh);
    Moments moments;
    double area = 0.0;
    for (const Face& face : mesh.faces) {
        const auto [a, b, c] = frame.corners(mesh, face);
        moments.add(a, b, c);
        area += 0.5 * (b - a).cross(c - a).norm();
    }
    const Eigen::Vector3d centroid = moments.first / moments.volume;
    MassProperties result;
    result.volume = moments.volume * frame.size * frame.size * frame.size;
    result.area = area * frame.size * frame.size;
    result.centroid = frame.origin + frame.size * centroid;
    set_inertia(moments.second - moments.volume * centroid * centroid.transpose(), frame.size, result);
    set_extents(mesh, mesh.faces.size(), result);
    return result;
}

MassProperties compute_sheet_mass_properties(const Mesh& mesh, double thickness) {
    const UnitFrame frame(mesh);
    const double t = thickness / frame.size;
    double area = 0.0;
    Eigen::Vector3d first = Eigen::Vector3d::Zero();
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
    for (const Face& face : mesh.faces) {
        const auto [a, b, c] = frame.corners(mesh, face);
        const Eigen::Vector3d twice_area = (b - a).cross(c - a), sum = a + b + c;
        const double length = twice_area.norm(), panel = 0.5 * length;
        area += panel;
        first += panel / 3.0 * sum;
        second += panel / 12.0 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
        if (length > 0.0) second += panel * t * t / 12.0 * (twice_area / length) * (twice_area / length).transpose();
    }
    const Eigen::Vector3d centroid = first / area;
    MassProperties result;
    result.area = area * frame.size * frame.size;
    result.volume = result.area * thickness;
    result.centroid = frame.origin + frame.size * centroid;
    set_inertia(t * (second - area * centroid * centroid.transpose()), frame.size, result);
    set_extents(mesh, 0, result);
    return result;
}

MassProperties combined_mass_properties(const Mesh& mesh, std::size_t solid_faces, double volume,
                                        const Eigen::Vector3d& first, const Eigen::Matrix3d& second) {
    const double size = UnitFrame(mesh).size;
    MassProperties result;
    result.volume = volume;
    result.centroid = first / volume;
    for (const Face& f : mesh.faces) {
        const Eigen::Vector3d& a = mesh.vertices[f[0]];
        result.area += 0.5 * (mesh.vertices[f[1]] - a).cross(mesh.vertices[f[2]] - a).norm();
    }
    set_inertia((second - volume * result.centroid * result.centroid.transpose()) / std::pow(size, 5), size, result);
    set_extents(mesh, solid_faces, result);
    return result;
}
} // namespace lr::baker
