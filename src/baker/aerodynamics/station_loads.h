// Loads of stations in double precision, by which the baker judges a partition.
#pragma once

#include "asset/asset_data.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace lr::baker {

using Wrench = Eigen::Matrix<double, 6, 1>; // force, then moment about the centre of mass

// A body in steady motion through fluid of density 1 at rest.
struct Motion {
    Eigen::Vector3d velocity, spin;
};

// Steady loads of one station, without the momentum of the fluid and its corrections: docs/maintainers/physics.md, "Stations". length: of the
// Reynolds number. lift: of AerodynamicData, for a body that is one station; else null.
Wrench loads_of(const StationData& station, const Motion& motion, double viscosity, double length,
                const Eigen::Vector3d* lift = nullptr);

// The loads of a whole body as one station. center: of its loads, from the centre of mass.
StationData as_station(const AerodynamicData& loads, const Eigen::Vector3d& center, Eigen::Vector3d& lift);

// Streams from all sides, spins, and both together; a spin moves the rim as fast as the stream.
std::vector<Motion> test_motions(double speed, double size);

// Root mean square of the difference over that of the reference; the larger of that of forces and that of moments.
double difference(std::span<const Wrench> loads, std::span<const Wrench> reference);
} // namespace lr::baker
