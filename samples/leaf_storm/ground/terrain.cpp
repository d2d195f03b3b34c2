// SPDX-License-Identifier: MIT
#include "ground/terrain.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "storm_scene.h"

namespace {

float fade(float t) {
    t = std::clamp(t, 0.0f, 1.0f);
    return t * t * t * (t * (6.0f * t - 15.0f) + 10.0f);
}

// Interpolates random values at lattice points `length` apart: -1 to 1, with two continuous derivatives.
float value_noise(std::uint64_t seed, float x, float z, float length) {
    const float u = x / length + 1000.0f, v = z / length + 1000.0f;
    const float i = std::floor(u), k = std::floor(v);
    const auto lattice = [&](float a, float b) {
        const auto index = static_cast<std::uint64_t>(a) * 65536u + static_cast<std::uint64_t>(b);
        return 2.0f * storm::random_unit(seed, index, 0) - 1.0f;
    };
    const float p = fade(u - i), q = fade(v - k);
    const float near = lattice(i, k) + p * (lattice(i + 1.0f, k) - lattice(i, k));
    const float far = lattice(i, k + 1.0f) + p * (lattice(i + 1.0f, k + 1.0f) - lattice(i, k + 1.0f));
    return near + q * (far - near);
}

} // namespace

Terrain::Terrain(std::uint64_t seed) : heights_(std::size_t{side} * side) {
    for (std::uint32_t k = 0; k < side; ++k) {
        for (std::uint32_t i = 0; i < side; ++i) {
            const float x = cell * static_cast<float>(i) - half_width, z = cell * static_cast<float>(k) - half_width;
            const float border = half_width - std::max(std::abs(x), std::abs(z));
            const float rolling = 0.22f * value_noise(seed, x, z, 3.7f) + 0.06f * value_noise(seed + 1, x, z, 1.3f);
            const float height = fade(0.4f * border) * rolling;
            heights_[i + std::size_t{side} * k] = height;
            lowest_ = std::min(lowest_, static_cast<double>(height));
        }
    }
}

Terrain::Place Terrain::at(double x, double z) const {
    const double most = static_cast<double>(side) - 1.0;
    const double u = std::clamp((x + half_width) / cell, 0.0, most), v = std::clamp((z + half_width) / cell, 0.0, most);
    const auto i = static_cast<std::size_t>(std::min(std::floor(u), most - 1.0)),
               k = static_cast<std::size_t>(std::min(std::floor(v), most - 1.0));
    const auto height = [&](std::size_t a, std::size_t b) { return static_cast<double>(heights_[a + side * b]); };
    const double p = u - static_cast<double>(i), q = v - static_cast<double>(k), corner = height(i, k);
    // The diagonal of the cell goes from (i, k) to (i + 1, k + 1).
    const double rise_x = p >= q ? height(i + 1, k) - corner : height(i + 1, k + 1) - height(i, k + 1);
    const double rise_z = p >= q ? height(i + 1, k + 1) - height(i + 1, k) : height(i, k + 1) - corner;
    const double size = static_cast<double>(cell);
    return {corner + p * rise_x + q * rise_z, unit({-rise_x / size, 1.0, -rise_z / size})};
}
