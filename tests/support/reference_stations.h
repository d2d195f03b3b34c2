// Loads of stations (docs/maintainers/physics.md, "Stations") in SI units and double, implemented independently of the kernel: forces at points. The
// wake is that of a body at rest until now, without memory or shed vortices.
#pragma once

#include "asset/asset_data.h"
#include "support/reference_aerodynamics.h"
#include "support/vector.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace test {

struct ReferenceStations {
    std::vector<lr::StationData> at; // at scale 1
    lr::AerodynamicData whole;       // for the numbers of the wake
    double scale = 1.0;
    double density = 0.0, viscosity = 0.0; // of the fluid
    double length = 0.0;                   // d, scale 1
    Vec arm{};                             // centre of mass to the centre of the whole body's loads, at this scale
    double light = 0.0;                    // fluid_inertia

    struct Loads {
        Vec force{}, torque{};
        Vec lost{}, lost_moment{}; // momentum of shed fluid
    };

    double fluid_inertia_of(const lr_asset_info& info) const {
        const auto& broadside = whole.broadside;
        const auto widest = std::max_element(broadside.begin(), broadside.end()); // the first of equals
        return fluid_inertia(info, whole.axes.data(), static_cast<size_t>(widest - broadside.begin()));
    }

    Loads operator()(Vec velocity, Vec spin) const {
        Loads sum;
        const auto n = static_cast<size_t>(std::max_element(whole.broadside.begin(), whole.broadside.end()) -
                                           whole.broadside.begin());
        const auto axis = [&](size_t k) {
            return Vec{whole.axes[3 * k], whole.axes[3 * k + 1], whole.axes[3 * k + 2]};
        };
        const Vec normal = axis(n);
        // The wake remembers the stream of the fall, not those of the ends that move by the spin. Spin about a long axis moves them little.
        const Vec fall = velocity + cross(spin, arm);
        const double most = std::max({whole.spin_drag[0], whole.spin_drag[1], whole.spin_drag[2]});
        double ends = 0.0;
        for (size_t k = 0; k < 3; ++k) {
            const double weight = whole.spin_drag[k] / most, along = length * scale * dot(axis(k), spin);
            ends += (k == n ? 1.0 : std::min(10.0 * weight * weight, 1.0)) * along * along;
        }
        const Vec behind = -dot(fall, fall) / (dot(fall, fall) + ends) * fall;
        // Spin about the body's normal is no pitching of a station that is tilted against it.
        const Vec tumbling = spin - dot(normal, spin) * normal;
        for (const lr::StationData& s : at) add(s, velocity, spin, tumbling, behind, sum);
        return sum;
    }

private:
    static constexpr double stall_power = 2.0; // of the squared sine

    static Vec row(const lr::StationData& s, size_t k) { return {s.axes[3 * k], s.axes[3 * k + 1], s.axes[3 * k + 2]}; }
    void add(const lr::StationData& s, Vec velocity, Vec spin, Vec tumbling, Vec behind, Loads& sum) const {
        const Vec chord = row(s, 0), span = row(s, 1), n = row(s, 2), place = scale * s.place;
        const double s2 = scale * scale, s3 = s2 * scale, s4 = s3 * scale, s5 = s4 * scale;
        const auto push = [&](Vec force, Vec point) {
            sum.force = sum.force + force;
            sum.torque = sum.torque + cross(point, force);
        };
        const Vec stream = velocity + cross(spin, place);
        const double speed = test::length(stream);
        const double u[3] = {dot(chord, stream), dot(span, stream), dot(n, stream)};

        // The plate in the stream that its attached part follows.
        const Vec followed = stream + whole.wake_share * behind;
        const double fx = dot(chord, followed), fy = dot(span, followed), along = std::hypot(fx, fy);
        const double incidence = dot(n, followed) - s.camber * std::abs(fx);
        const double cx = fx * fx / (along * along), cy = fy * fy / (along * along);
        const double stall = std::min(1.0 / (cx / s.plate_stall[0] + cy / s.plate_stall[1]), 1.0);
        const double sine2 = incidence * incidence / (along * along + incidence * incidence);
        const double attached = (1.0 - sine2) / (1.0 - sine2 + (1.0 - stall) * std::pow(sine2 / stall, stall_power));
        const double half = 0.5 * density * s2;
        const double open = std::max(1.0 - (s.hollow[0] * u[0] + s.hollow[1] * u[1] + s.hollow[2] * u[2]) / speed, 0.0);
        const double lift = open * half * attached *
                            ((cx * s.plate_lift[0] + cy * s.plate_lift[1]) * along +
                             (cx * s.plate_vortex[0] + cy * s.plate_vortex[1]) * std::abs(incidence));
        const double tilt = 1.0 - u[2] * u[2] / (speed * speed);
        const double broadside = open * half * s.plate_drag * (1.0 - attached) * speed * (1.0 + 0.8 * tilt);
        const double start = -half * streaming(light) * s.plate_drag * whole.start_drag * test::length(behind) *
                             dot(behind, stream) / (speed * speed);
        const double normal = std::max(lift + broadside + start, 0.0);
        // The attached part acts aft of the place for any direction of the stream, and the stream at that point damps.
        const Vec aft = -scale / along * (s.lift_arm[0] * fx * chord + s.lift_arm[1] * fy * span);
        const Vec point = place + std::min(lift / std::max(normal, 1e-30), 1.0) * aft;
        push(-normal * dot(n, velocity + cross(spin, point)) * n, point);
        // Lift of camber and of the wake's lag is normal to the stream, and does no work.
        push(-lift * (incidence - u[2]) * (n - u[2] / (speed * speed) * stream), place);

        const double reynolds = speed * length * scale / viscosity, late = reynolds / (reynolds + 8710.0);
        double drag = 0.0;
        for (size_t i = 0; i < 3; ++i)
            drag += u[i] * u[i] / (speed * speed) *
                    (half * (s.drag[i] + late * s.drag_blunt[i]) * speed +
                     density * scale *
                         (std::sqrt(scale * viscosity * speed) * s.drag_layer[i] + viscosity * s.drag_stokes[i]));
        push(-drag * stream, place);

        const double w[3] = {dot(chord, spin), dot(span, spin), dot(n, spin)};
        const double pitching[3] = {dot(chord, tumbling), dot(span, tumbling), w[2]};
        const Vec axes[3] = {chord, span, n};
        const double most = std::max({s.spin_drag[0], s.spin_drag[1], s.spin_drag[2]});
        double whirl = 0.0;
        for (size_t k = 0; k < 3; ++k) whirl += s.spin_drag[k] / most * w[k] * w[k];
        Vec circulation{};
        for (size_t k = 0; k < 3; ++k) {
            const double part = k == 2 ? 0.0 : s.plate_drag / (s.plate_drag + s.drag[2] + s.drag_blunt[2]);
            // A stream along the axis of a spin makes no lift.
            const double across = 1.0 - u[k] * u[k] / (speed * speed);
            const double crossing = k == 2 ? 1.0 : k == 1 ? across * across : across;
            circulation = circulation + crossing * (1.0 - part * (1.0 - streaming(light))) * s3 * s.spin_lift[k] *
                                            pitching[k] * axes[k];
            const double resists = s5 * s.spin_drag[k] * std::sqrt(whirl) +
                                   s4 * s.spin_drag_stream[k] * std::abs(u[2]) + s3 * s.spin_drag_stokes[k] * viscosity;
            sum.torque = sum.torque - density * resists * w[k] * axes[k];
        }
        push(density * cross(circulation, stream), place);

        const double critical = whole.shedding_reynolds * viscosity / (speed * whole.wake_length * scale);
        const double turned = s.plate_drag > 0.0 ? 1.25 * s.separated_shedding / s.plate_drag * scale * w[1] : 0.0;
        const double slow = speed * speed / (speed * speed + turned * turned);
        const double mass =
            density * s3 * s.separated_shedding * (1.0 - attached) * std::max(1.0 - critical * critical, 0.0) * slow;
        sum.lost = sum.lost + mass * u[2] * n;
        sum.lost_moment = sum.lost_moment + mass * u[2] * cross(place, n);
    }
};

} // namespace test
