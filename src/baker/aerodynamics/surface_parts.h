// Parts of a surface as triangles: cut by planes, grouped by their normals, measured.
#pragma once

#include "baker/mesh/mesh.h"

#include <Eigen/Core>

#include <array>
#include <utility>
#include <vector>

namespace lr::baker {

struct Facet {
    std::array<Eigen::Vector3d, 3> at;
    double sides; // that touch the fluid: 1 on a solid, 2 on a sheet
    Eigen::Vector3d normal;
    double area; // of the plate that it is a face of: half of what the fluid touches
    Eigen::Vector3d middle() const { return (at[0] + at[1] + at[2]) / 3.0; }
};
using Part = std::vector<Facet>;

Part part_of(const Mesh& mesh, double sides);

// The sides below and above the plane direction.x = offset.
std::pair<Part, Part> cut(const Part& part, const Eigen::Vector3d& direction, double offset);

// Triangles divided until no edge is longer than this.
Part refined(const Part& part, double longest);

struct PartMoments {
    double area = 0.0;
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  // central, of the area, over the area
    Eigen::Matrix3d normals = Eigen::Matrix3d::Zero(); // mean of n n^T: both sides of a face count alike
};
PartMoments moments_of(const Part& part);

// The direction nearest to all normals, whatever their signs; in the half space of `like`.
Eigen::Vector3d common_normal(const PartMoments& moments, const Eigen::Vector3d& like);

// Extent along a direction: least and most.
std::pair<double, double> extent_of(const Part& part, const Eigen::Vector3d& direction);

// Groups of faces with about the same normal axis: the wings and the keel of a dart, the sides of a fold. Faces that belong to one plane but for
// a tilt of some 20 degrees stay together.
std::vector<Part> split_by_normal(Part part, std::size_t most);

// Seen along `normal`, parts that each are about as compact as a plate: the bars of a cross, the sides of a ring.
std::vector<Part> split_by_outline(Part part, const Eigen::Vector3d& normal, std::size_t most);

// How compact a silhouette is: area/(12 sqrt(det)) of its second moments; 1 for any rectangle, 1.05 for an ellipse, 0.87 for a triangle, 0.63 for
// a cross five times as long as wide.
double compactness(const Part& part, const Eigen::Vector3d& normal);
} // namespace lr::baker
