// Releases bodies in a world of their own and samples their poses and velocities.
#pragma once

#include "tools/lr_scorecard/runtime_handles.h"

#include <Eigen/Geometry>

#include <limits>
#include <vector>

namespace lr::scorecard {

// World frame, m and s. Up is +y, as in the runtime's default gravity.
struct Sample {
    Eigen::Vector3d position, velocity, spin;
    Eigen::Quaterniond orientation;
};

// One body: samples at times 0, interval, 2 interval, ...
struct Track {
    double interval = 0.0;
    std::vector<Sample> samples;
};

struct Start {
    Eigen::Vector3d position = Eigen::Vector3d::Zero(), velocity = position, spin = position;
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
};

struct Run {
    Loads loads;
    double gravity = 9.81; // m/s^2, along -y
    float dt = 1e-3f;      // s
    uint32_t substeps = 1;
    double duration = 1.0;  // s
    double interval = 1e-2; // s between samples, interpolated between steps
    uint64_t seed = 1;      // of the world
    uint32_t threads = 1;   // in all
    int32_t simd_target = LR_SIMD_AUTO;
    Eigen::Vector3d wind = Eigen::Vector3d::Zero();
    double viscosity = 0.0; // m^2/s; 0: that of the asset's fluid
    // m: recording ends when all bodies are below it. Default: at the end of the duration.
    double floor = -std::numeric_limits<double>::infinity();
    std::function<void(lr_world*)> prepare; // called with the new world, to add wind; can be empty
};

// One track for each start, in the same order.
std::vector<Track> record(const Asset& asset, const Run& run, const std::vector<Start>& starts);

inline Eigen::Vector3d up() {
    return Eigen::Vector3d::UnitY();
}
} // namespace lr::scorecard
