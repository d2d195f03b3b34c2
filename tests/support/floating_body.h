// An ellipsoid under a flat, still surface at height 0, in double: its wet share and energy (docs/reference/wind_and_water.md).
#pragma once

#include "support/reference_body.h"
#include "support/water.h"

#include <algorithm>
#include <cmath>

namespace test {

class FloatingBody {
public:
    static constexpr double gravity = 9.81;

    // h: s, the substep; a body counts as at least as thick as its fall in a substep, and is raised to float flat at its own draught.
    FloatingBody(const lr_asset_info& info, double h)
        : air_(info), more_(info), mass_(info.mass), volume_(info.volume), blur_(gravity * h * h) {
        for (size_t i = 0; i < 3; ++i) {
            const double* const j = info.inertia;
            const double moment[3] = {j[0], j[4], j[8]};
            squared_[i] = 2.5 / mass_ * (moment[(i + 1) % 3] + moment[(i + 2) % 3] - moment[i]);
            center_[i] = info.center_of_buoyancy[i];
        }
        const double thin = std::min({semi_axis(0), semi_axis(1), semi_axis(2)});
        raised_ = draught(mass_ / volume_) * (std::sqrt(thin * thin + blur_ * blur_) - thin);
        // The fluid's part of the mass matrix is proportional to its density.
        lr_asset_info wet = info;
        for (double& m : wet.added_mass) m *= water_density / info.fluid_density;
        const Matrix6 water = ReferenceBody(wet).mass;
        for (size_t i = 0; i < 6; ++i)
            for (size_t k = 0; k < 6; ++k) more_.mass[i][k] = water[i][k] - air_.mass[i][k];
    }

    struct Pose {
        double fraction;
        double potential;   // J
        double half_height; // m, along the vertical
    };
    Pose pose(Vec position, Quat q) const {
        const Vec n = to_body(q, {0.0, 1.0, 0.0});
        double square = blur_ * blur_;
        Vec stretched{};
        for (size_t i = 0; i < 3; ++i) stretched[i] = squared_[i] * n[i], square += stretched[i] * n[i];
        const double half = std::sqrt(square), height = position[1] + dot(n, center_);
        const double depth = raised_ - height, s = std::clamp(depth / half, -1.0, 1.0);
        // Displaced water: its force is rho V f g, and its depth the integral of f.
        const double lifted =
            depth > half ? depth : half * ((2.0 * s + 1.5 * s * s - 0.25 * s * s * s * s) / 4.0 + 3.0 / 16.0);
        return {(2.0 + 3.0 * s - s * s * s) / 4.0,
                gravity * (mass_ * position[1] - air_density * volume_ * height +
                           (water_density - air_density) * volume_ * lifted),
                half};
    }
    // Of body and fluid. twist: body frame, relative to the fluid.
    double kinetic(double fraction, const Six& twist) const {
        const Six a = air_.mass * twist, b = more_.mass * twist;
        double sum = 0.0;
        for (size_t i = 0; i < 6; ++i) sum += 0.5 * twist[i] * (a[i] + fraction * b[i]);
        return sum;
    }
    double semi_axis(size_t i) const { return std::sqrt(squared_[i]); }
    double largest() const { return std::max({semi_axis(0), semi_axis(1), semi_axis(2)}); }
    Matrix6 mass(double fraction) const {
        Matrix6 out = air_.mass;
        for (size_t i = 0; i < 6; ++i)
            for (size_t k = 0; k < 6; ++k) out[i][k] += fraction * more_.mass[i][k];
        return out;
    }

private:
    ReferenceBody air_, more_;
    double mass_, volume_, blur_, raised_;
    Vec squared_{}, center_{};
};

} // namespace test
