// The quasi-steady loads of docs/maintainers/physics.md section 5 in double, implemented independently of the kernel: force and torque
// about the centre of mass, body axes, in N and N m.
#pragma once

#include "langevin_rigid_research.h"
#include "support/vector.h"

#include <algorithm>
#include <cmath>

namespace test {

// The fluid's share of the moment of inertia about the axis in the plate where it is larger. axes: of the loads.
inline double fluid_inertia(const lr_asset_info& info, const double* axes, size_t normal) {
    double most = 0.0;
    for (size_t k = 0; k < 3; ++k) {
        if (k == normal) continue;
        double own = 0.0, fluid = 0.0;
        for (size_t i = 0; i < 3; ++i)
            for (size_t j = 0; j < 3; ++j) {
                own += axes[3 * k + i] * info.inertia[3 * i + j] * axes[3 * k + j];
                fluid += axes[3 * k + i] * info.added_mass[(i + 3) * 6 + j + 3] * axes[3 * k + j];
            }
        most = std::max(most, fluid / (own + fluid));
    }
    return most;
}

// Share of loads that need a shed wake. light: fluid_inertia.
inline double streaming(double light) {
    return 1.0 / (1.0 + std::pow(light / (2.0 / 3.0), 4.0));
}

struct ReferenceLoads {
    lr_aerodynamics at{}; // at scale 1
    double scale = 1.0;
    double density = 0.0, viscosity = 0.0; // of the fluid
    double length = 0.0;                   // d, scale 1
    Vec arm{};                             // from the centre of mass to the centre of the loads, at this scale
    double light = 0.0;                    // fluid_inertia

    struct Wrench {
        Vec force, torque;
    };

    // The wake, along the load axes: the stream in its memory, and the oscillator (q, r).
    Vec lag{};
    double shedding[4] = {};

    size_t normal() const { // the first of equals
        return static_cast<size_t>(std::max_element(at.broadside, at.broadside + 3) - at.broadside);
    }
    Vec normal_of_body() const { return {at.axes[3 * normal()], at.axes[3 * normal() + 1], at.axes[3 * normal() + 2]}; }

    // A plate in a stream v along the load axes: normal force over rho, and the share of the added momentum that it sheds.
    struct Plate {
        double force, shed;
    };
    Plate plate(Vec v) const {
        const size_t n = normal();
        const double s = std::max(test::length(v), 1e-10);
        const Vec u = v + at.wake_share * (lag - v);
        const double u2 = dot(u, u), along = u2 - u[n] * u[n];
        double slope = 0.0, vortex = 0.0, stall = 0.0;
        for (size_t i = 0; i < 3; ++i) {
            if (i == n || !(along > 0.0)) continue;
            const double part = u[i] * u[i] / along;
            slope += part * at.plate_lift[i], vortex += part * at.plate_vortex[i];
            stall += part / at.plate_stall[i];
        }
        const double sine2 = u[n] * u[n] / u2, limit = 1.0 / (1.0 + open_wake(s) * (stall - 1.0));
        const double attached =
            along > 0.0 ? (1.0 - sine2) / (1.0 - sine2 + (1.0 - limit) * std::pow(sine2 / limit, 4.0)) : 0.0;
        const Vec behind = lag - v;
        const double start =
            streaming(light) * at.start_drag * at.plate_drag * test::length(behind) * -dot(behind, v) / (s * s);
        const double separated = at.plate_drag * (s + 0.8 * (s * s - v[n] * v[n]) / s);
        const double force = attached * u[n] * (slope * std::sqrt(along) + vortex * std::abs(u[n])) +
                             ((1.0 - attached) * separated + start) * v[n];
        return {0.5 * scale * scale * force, (1.0 - attached) * at.plate_separated_shedding * shedding_share(s)};
    }
    double over_onset(double s) const { return at.shedding_reynolds * viscosity / (s * at.wake_length * scale); }
    double open_wake(double s) const { return 1.0 - 0.6 * std::min(std::pow(over_onset(s), 2.0), 1.0); }
    double shedding_share(double s) const {
        const double x = over_onset(s);
        return std::max(1.0 - std::pow(x, 4.0) * std::pow(30.0 * light / (1.0 + 30.0 * light), 2.0), 0.0);
    }
    Vec along_axes(Vec a) const {
        Vec out{};
        for (size_t i = 0; i < 3; ++i)
            for (size_t j = 0; j < 3; ++j) out[i] += at.axes[i * 3 + j] * a[j];
        return out;
    }
    double shed(Vec velocity, Vec spin) const { return plate(along_axes(velocity + cross(spin, arm))).shed; }

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
        double whirl = 0.0, most = 0.0;
        for (size_t i = 0; i < 3; ++i) most = std::max(most, at.spin_drag[i]);
        for (size_t i = 0; i < 3; ++i)
            if (most > 0.0) whirl += at.spin_drag[i] / most * w[i] * w[i];
        whirl = std::sqrt(whirl);
        const size_t n = normal(), first = (n + 1) % 3, second = (n + 2) % 3;
        const double plate_share = at.plate_drag / (at.plate_drag + at.drag[n] + at.drag_blunt[n]);
        Vec force{}, torque{}, circulation{};
        for (size_t k = 0; k < 3; ++k) {
            const size_t i = (k + 1) % 3, j = (k + 2) % 3;
            const double turning =
                k == n || !(at.plate_drag > 0.0) ? 1.0 : 1.0 - plate_share * (1.0 - streaming(light));
            circulation[k] = turning * at.spin_lift[k] * s3 * w[k] - at.lift[k] * s2 * v[i] * v[j] / s;
            torque[k] =
                -density *
                (at.spin_drag[k] * s5 * whirl + at.spin_drag_stream[k] * s4 * s +
                 at.spin_drag_layer[k] * s3 * std::sqrt(scale * viscosity * (s + 0.5 * whirl * length * scale)) +
                 at.spin_drag_stokes[k] * s3 * viscosity) *
                w[k];
        }
        const auto moment = [&](size_t i) {
            return density * s3 * v[n] * v[n] *
                   (at.shedding_moment * shedding[i] + at.shedding_rate_moment * shedding[i + 2]);
        };
        torque[second] += moment(0);
        torque[first] -= moment(1);
        force[n] -= density * plate(v).force;
        double opposing = 0.0; // drag against the velocity
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
