// Drops bodies of an asset from rest and follows each until its centre has fallen, or risen, by a height. Each is alone in an
// unbounded fluid. Uses the public C API only.
#pragma once

#include "langevin_rigid.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <string>
#include <vector>

namespace lr::falls {

enum class Release : uint8_t { flat, edge, random };

struct Drop {
    Release release = Release::random; // with any heading; edge: broad side upright, at any angle in its plane
    double height = 1.0;               // m
    uint32_t count = 500;
    double step = 0.0;    // s; 0: default_step
    double longest = 0.0; // s, after which a body that has not arrived is given up; 0: from the height
    Eigen::Vector3d wind = Eigen::Vector3d::Zero();    // m/s; up is +y
    double turbulence = 0.0;                           // m/s, root mean square of each component of the wind
    double fluid_density = 0.0, fluid_viscosity = 0.0; // kg/m^3, m^2/s; 0: those of the asset
    uint64_t seed = 0;
};

// The body as pictures show it: the runtime has no mesh, so it is the ellipsoid with the body's moments of inertia.
struct Shape {
    std::string name;
    double density = 0.0, fluid_density = 0.0; // kg/m^3
    double length = 0.0;                       // m, largest extent
    double thickness = 0.0;                    // m
    Eigen::Vector3d normal;    // of the broad side, body frame: motion along it has the largest added mass
    Eigen::Matrix3d ellipsoid; // sum of semi-axis squared times the dyad of the axis, m^2
};

struct Sample {
    Eigen::Vector3d position; // m, from the point of release; up is +y
    Eigen::Vector3d spin;     // rad/s, world frame
    Eigen::Quaterniond orientation;
};

struct Track {
    double interval = 0.0;       // s between samples; the first is at rest
    std::vector<Sample> samples; // before the end
    bool arrived = false;        // at the floor, or as far above
    double time = 0.0;           // s, of the whole fall
    Eigen::Vector3d end = Eigen::Vector3d::Zero();
};

// Throws std::runtime_error with the name of a refused call, here and below.
Shape shape_of(const lr_asset* asset, const Drop& options);

// 1/120 s, or less for bodies that move far for their length: docs/maintainers/numerics.md.
double default_step(const Shape& shape);

// Tracks of bodies `first` to `first + count - 1`, the same for any split.
std::vector<Track> drop(const lr_asset* asset, const Drop& options, uint32_t first, uint32_t count);

inline Eigen::Vector3d up() {
    return Eigen::Vector3d::UnitY();
}
} // namespace lr::falls
