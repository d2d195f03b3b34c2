// The quasi-steady loads of docs/maintainers/physics.md section 5 in double, implemented independently of the kernel: force and torque
// about the centre of mass, body axes, in N and N m.
#pragma once

#include "langevin_rigid_research.h"
#include "support/vector.h"

#include <cmath>

namespace test {

struct ReferenceLoads {
    lr_aerodynamics at{}; // at scale 1
    double scale = 1.0;
    double density = 0.0, viscosity = 0.0; // of the fluid
    double length = 0.0;                   // d, scale 1
    Vec arm{};                             // centre of mass to that of the loads, at this scale

    struct Wrench {
        Vec force, torque;
    };

    Wrench operator()(Vec velocity, Vec spin) const {
        const auto turned = [&](Vec a, bool back) {
            Vec out{};
            for (size_t i = 0; i < 3; ++i)
                for (size_t j = 0; j < 3; ++j) out[i] += at.axes[back ? j * 3 + i : i * 3 + j] * a[j];
            return out;
        };
        const Vec v = turned(velocity + cross(spin, arm), false), w = turned(spin, false);
        const double s = std::max(test::length(v), 1e-10);
        const double s2 = scale * scale, s3 = s2 * scale, s4 = s3 * scale, s5 = s4 * scale;
        const double reynolds = s * length * scale / viscosity, separated = reynolds / (reynolds + 8710.0);
        double sigma = 0.0, whirl = 0.0, most = 0.0;
        for (size_t i = 0; i < 3; ++i) {
            sigma += at.broadside[i] * v[i] * v[i] / (s * s);
            most = std::max(most, at.spin_drag[i]);
        }
        for (size_t i = 0; i < 3; ++i)
            if (most > 0.0) whirl += at.spin_drag[i] / most * w[i] * w[i];
        whirl = std::sqrt(whirl);
        Vec force{}, torque{}, circulation{}, roll{};
        for (size_t k = 0; k < 3; ++k) roll[k] = std::sqrt(at.roll_damping[k] * s4) * v[k];
        const double rolling = roll[0] * w[0] + roll[1] * w[1] + roll[2] * w[2];
        for (size_t k = 0; k < 3; ++k) {
            const size_t i = (k + 1) % 3, j = (k + 2) % 3;
            circulation[k] =
                at.spin_lift[k] * s3 * w[k] - at.lift[k] * s2 * (1.0 - at.lift_stall * sigma) * v[i] * v[j] / s;
            torque[k] = density * s3 * (at.lift_moment[k] + at.lift_moment_stalled[k] * sigma) * v[i] * v[j] -
                        density *
                            (at.spin_drag[k] * s5 * whirl + at.spin_drag_stream[k] * s4 * s +
                             at.spin_drag_stokes[k] * s3 * viscosity) *
                            w[k] -
                        density * roll[k] * rolling / s;
        }
        double opposing = 0.0; // the part of the drag against the velocity
        for (size_t i = 0; i < 3; ++i) {
            const double part = v[i] * v[i] / (s * s);
            opposing += part * 0.5 * (at.drag[i] + at.drag_blunt[i] * separated) * s2 * s;
            // Viscous drag acts along each axis separately.
            force[i] -= density * v[i] *
                        (at.drag_layer[i] * scale * std::sqrt(scale) * std::sqrt(viscosity * s) +
                         at.drag_stokes[i] * scale * viscosity);
        }
        force = force - density * opposing * v + density * cross(circulation, v);
        const Vec f = turned(force, true);
        return {f, turned(torque, true) + cross(arm, f)};
    }
};

} // namespace test
