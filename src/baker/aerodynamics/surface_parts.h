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
    double sides; // sides in the fluid: 1 on a solid, 2 on a sheet
    Eigen::Vector3d normal;
    double area;       // of the plate: half of the wetted area
    double open = 1.0; // share of the sides that do not face another part of the body
    Eigen::Vector3d middle() const { return (at[0] + at[1] + at[2]) / 3.0; }
};
using Part = std::vector<Facet>;

// The first `solid_faces` faces have one side, the others, of sheets, two.
Part part_of(const Mesh& mesh, std::size_t solid_faces = 0);

// The parts below and above the plane direction.x = offset.
std::pair<Part, Part> cut(const Part& part, const Eigen::Vector3d& direction, double offset);

// Divides triangles until no edge is longer than this.
Part refined(const Part& part, double longest);

struct PartMoments {
    double area = 0.0;
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  // central, of the area, over the area
    Eigen::Matrix3d normals = Eigen::Matrix3d::Zero(); // mean of n n^T, the same for both sides of a face
};
PartMoments moments_of(const Part& part);

// The direction nearest to all normals of either sign, on the side of `like`.
Eigen::Vector3d common_normal(const PartMoments& moments, const Eigen::Vector3d& like);

// Least and largest coordinate along a direction.
std::pair<double, double> extent_of(const Part& part, const Eigen::Vector3d& direction);

// A piece of a part; its loads act at `node` along the direction of the cuts.
struct Slice {
    Part part;
    double node;
};

// Pieces whose areas and nodes are the weights and points of Gauss's rule for the area along the direction. Sums over n pieces are exact for
// polynomials up to degree 2 n - 1; forces of a turning wing have degree 2 in the place, moments 3.
class Slicer {
public:
    Slicer(Part part, const Eigen::Vector3d& direction) : part_(std::move(part)), direction_(direction) {}
    std::vector<Slice> sliced(std::size_t n);

private:
    void find_points();

    Part part_;
    Eigen::Vector3d direction_;
    // Area as weighted points on -1..1, for every n.
    std::vector<std::pair<double, double>> points_;
    double centre_ = 0.0, scale_ = 0.0, area_ = 0.0;
};

// Groups of faces with about the same normal axis: wings and keel of a dart, sides of a sharp fold. A curved part stays whole up to tilts of 60
// degrees.
std::vector<Part> split_by_normal(Part part, std::size_t most);

// Splits such a group into the two walls of a steep bowl, if it has faces on both sides of a gap.
std::vector<Part> split_walls(Part part);

inline constexpr double least_share = 0.04; // least share of the area in a group or on a side of a cut
} // namespace lr::baker
