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
    double area;       // of the plate that it is a face of: half of what the fluid touches
    double open = 1.0; // of its sides, the share that does not face another part of the body
    Eigen::Vector3d middle() const { return (at[0] + at[1] + at[2]) / 3.0; }
};
using Part = std::vector<Facet>;

// The first `solid_faces` faces have one side, the others `sides_of_sheets`.
Part part_of(const Mesh& mesh, double sides_of_sheets, std::size_t solid_faces = 0);

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

// A piece of a part, and where along the direction of the cuts its loads act.
struct Slice {
    Part part;
    double node;
};

// Pieces whose areas and nodes are the weights and points of Gauss's rule for the area along the direction: sums over n of them are exact for
// polynomials up to degree 2 n - 1, as forces (2) and moments (3) of a wing that turns are in the place.
std::vector<Slice> sliced(const Part& part, const Eigen::Vector3d& direction, std::size_t n);

// Groups of faces with about the same normal axis: the wings and the keel of a dart, the sides of a sharp fold. A part that is only curved stays
// together up to tilts of 60 degrees.
std::vector<Part> split_by_normal(Part part, std::size_t most);

// Of such a group the two walls of a steep bowl, if it lies to both sides of a gap.
std::vector<Part> split_walls(Part part);

// Seen along `normal`, parts that each are about as compact as a plate: the arms of a cross or star, the sides of a ring, as sectors about the
// centroid; else by straight cuts.
std::vector<Part> split_by_outline(Part part, const Eigen::Vector3d& normal, std::size_t most);

// How compact a silhouette is: area/(12 sqrt(det)) of its second moments; 1 for any rectangle, 1.05 for an ellipse, 0.87 for a triangle, 0.63 for
// a cross five times as long as wide.
double compactness(const Part& part, const Eigen::Vector3d& normal);
inline constexpr double least_compactness = 0.8; // of a plate
} // namespace lr::baker
