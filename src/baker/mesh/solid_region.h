// The region that closed surfaces enclose together: their union, whether they cross, touch or lie in each other.
#pragma once

#include "baker/mesh/mass_properties.h"
#include "baker/mesh/mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace lr::baker {

// Moments of the union for density 1 about the origin of the mesh.
struct RegionMoments {
    double volume = 0.0;
    Eigen::Vector3d first = Eigen::Vector3d::Zero();
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
    double counted = 0.0; // volume with overlaps counted as often as they are covered
};

// Winding numbers from the faces that a line crosses. Each surface must be closed and wound outward, or inward if it is a cavity; at any edge as many
// faces must run forward as backward.
class SolidRegion {
public:
    SolidRegion(const Mesh& mesh, const std::vector<Face>& faces);

    bool empty() const { return faces_.empty(); }
    bool contains(const Eigen::Vector3d& point) const;

    // The sum over parts in closed form, less overlaps, which rays along the three axes measure.
    RegionMoments moments(const MassProperties& sum_of_parts) const;

    // Open shares of the faces of a grid of cubes: for each direction, the part inside of the space half a cube to each side of a face, by 4^3
    // samples. Face (i, j, k) of direction d is below cell (i, j, k).
    struct Grid {
        Eigen::Vector3d low;
        double step = 0.0;
        std::array<std::size_t, 3> cells{};
        std::array<std::vector<float>, 3> inside;
        std::size_t at(std::size_t i, std::size_t j, std::size_t k) const { return (k * cells[1] + j) * cells[0] + i; }
    };
    Grid grid(std::size_t longest) const;

private:
    using Crossings = std::vector<std::pair<double, int>>;

    std::size_t bin(std::size_t axis, double x, Eigen::Index k) const; // for lines along an axis, of the coordinate k

    // Crossings of faces along a line, in order, with the change of the winding number.
    void cross(std::size_t axis, double p, double q, Crossings& out) const;

    std::vector<std::array<Eigen::Vector3d, 3>> faces_;
    Eigen::Vector3d low_, high_;
    std::array<std::size_t, 3> bins_{1, 1, 1};  // along each side of the box, for lines along each axis
    std::array<std::size_t, 3> order_{0, 1, 2}; // axes, those with short lists first
    std::array<std::vector<uint32_t>, 3> start_, list_;
};

// Inertia, for density 1, of a fluid that fills the region when the region spins about its centroid: the least energy of a flow driven by the walls,
// from the potential on a grid (Batty, Bertails and Bridson 2007: faces weighted by the space inside around them). frozen: inertia of the region
// about its centroid, by which that of the grid is corrected.
Eigen::Matrix3d trapped_fluid_inertia(const SolidRegion& region, const Eigen::Vector3d& centroid,
                                      const Eigen::Matrix3d& frozen);
} // namespace lr::baker
