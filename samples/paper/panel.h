// Shared by the figures of falls.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <string>

#include "asset_file.h"
#include "figure_numbers.h"
#include "options.h"
#include "recorded_falls.h"
#include "scene.h"

struct LoadModel {
    const char* name;
    std::int32_t loads;
};
inline constexpr LoadModel both_models[] = {{"LANGEVIN", LR_LOADS_LANGEVIN}, {"AERODYNAMIC", LR_LOADS_AERODYNAMIC}};

// The same numbers on every machine, unlike the standard's distributions.
class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double within(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }

private:
    std::mt19937_64 engine_;
};

struct Actor {
    AssetPointer asset;
    Mesh mesh;
    Colour front, back;
    bool octants; // alternating colours by octant, for solids
};

Actor load_actor(const Options& options, const std::string& asset, const std::string& mesh, Colour front, Colour back,
                 bool octants);

// Thin axis z up, x along the world's x.
Quaternion lying();

inline constexpr double degree = 3.14159265358979323846 / 180.0;

// Draws poses from `first` to `last`, every `stride`, the path of the centre, and a scale bar.
void draw_fall(Picture& picture, Frame frame, const View& view, const Actor& actor, const Track& track,
               std::size_t first, std::size_t last, std::size_t stride, double metres_per_pixel);

// The smallest metres per pixel with which draw_fall fits the frame.
double fitting(Frame frame, const View& view, const Actor& actor, const Track& track, std::size_t first,
               std::size_t last);

double share_of(const std::vector<bool>& seen);
std::size_t first_of(const std::vector<bool>& seen); // 0 if there is none

void save(const Options& options, const std::string& figure, const Picture& picture);
