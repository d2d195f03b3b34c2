// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "langevin_rigid.h"

struct Options {
    std::vector<std::string> assets;
    std::vector<std::string> meshes; // to draw; by position in `assets`
    std::uint64_t count = 20000;
    double seconds = 10.0;
    double dt = 1.0 / 60.0; // s
    std::uint32_t substeps = 4;
    std::uint32_t threads = 1; // total; the library gets one less as workers
    float wind[3] = {1.5f, 0.0f, 0.5f};
    std::uint64_t seed = 1;
    float noise = 1.0f, variation = 0.15f;
    std::int32_t simd = LR_SIMD_AUTO;
    bool same_size = false;
    std::int32_t clock = LR_CLOCK_SPEED;
    std::int32_t loads = LR_LOADS_AERODYNAMIC;
    std::int32_t integrator = LR_INTEGRATOR_SPLITTING;
    std::string png, csv, json, tracks;
    std::uint32_t track_count = 40;
    double track_seconds = 1.5;
    int width = 1920, height = 1080; // px, of the large frame
    int frames = 6;
    bool quiet = false;

    bool ground = false;
    bool heap = false;
    double fall = 7.0;       // s in which all leaves start
    double walk = -1.0;      // s: start of the walk; negative: none
    double gusts = -1.0;     // s: start of the gust; negative: none
    double gust_speed = 9.0; // m/s, 10 m above the ground
    std::uint32_t divisor = 1;
    bool check = false;
    std::vector<double> at; // s: times of the frames

    std::uint64_t steps() const;
    std::uint64_t frame_step(int frame) const; // the step before the frame
};

// Empty if the program has nothing more to do (--help, or bad usage, already reported): then exit_code is its exit
// code.
std::optional<Options> parse_options(int argc, char** argv, int& exit_code);
