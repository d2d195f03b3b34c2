// Stations: parts of a body that each see their own stream; docs/maintainers/physics.md, "Partition".
#pragma once

#include "asset/asset_data.h"
#include "baker/mesh/mesh.h"

#include <Eigen/Core>

#include <vector>

namespace lr::baker {

struct StationOptions {
    std::size_t solid_faces = 0; // so many of the first faces bound solids; the others are sheets
    double volume = 0.0;         // m^3, of the body
    double hull_volume = 0.0;    // m^3
    double length = 1.0;         // m, of the Reynolds number
    double viscosity = 1.5e-5;
    std::size_t most = most_stations;
};

// Reason for a body's number of stations.
enum class StationFit {
    one,    // one station: the body is flat and compact, or thick
    fits,   // the error is within bad_error
    coarse, // the error is larger even with the most stations
    hidden, // one station: parts lie in each other's lee, so no sum over parts is right
    hollow, // one station: a thick body far from convex
};

struct Stations {
    std::vector<StationData> at;
    StationFit fit = StationFit::one;
    // Error of the loads of `at` against many stations: difference() over test_motions().
    double error = 0.0;
    double error_one = 0.0; // the same with the loads of the whole body
};

// Mesh in the body frame, repaired. loads: of the whole body about `center` (from the centre of mass, body frame).
Stations make_stations(const Mesh& mesh, const AerodynamicData& loads, const Eigen::Vector3d& center,
                       const StationOptions& options);

// Sets where attached lift acts, and the momentum that separated streams leave behind, from the added masses of strips. These are scaled so that
// their sum along the body's broadside normal is that of the matrix.
void share_added_mass(const AerodynamicData& loads, const std::array<double, 36>& added_mass,
                      std::vector<StationData>& stations);
} // namespace lr::baker
