// The equations of docs/maintainers/physics.md sections 2 and 3 for a body, in SI units and double, implemented independently of the
// kernel and integrated in small steps: the reference for the kernel. Noise is off.
#pragma once

#include "support/reference_aerodynamics.h"
#include "support/reference_stations.h"
#include "support/scene.h"
#include "support/vector.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace test {

using Six = std::array<double, 6>;
using Matrix6 = std::array<Six, 6>;

inline Six operator*(const Matrix6& m, const Six& t) {
    Six out{};
    for (size_t i = 0; i < 6; ++i)
        for (size_t j = 0; j < 6; ++j) out[i] += m[i][j] * t[j];
    return out;
}
inline Vec upper(const Six& t) {
    return {t[0], t[1], t[2]};
}
inline Vec lower(const Six& t) {
    return {t[3], t[4], t[5]};
}
inline Six join(Vec a, Vec b) {
    return {a[0], a[1], a[2], b[0], b[1], b[2]};
}

inline Matrix6 inverse(Matrix6 m) {
    Matrix6 out{};
    for (size_t i = 0; i < 6; ++i) out[i][i] = 1.0;
    for (size_t c = 0; c < 6; ++c) {
        size_t pivot = c;
        for (size_t r = c; r < 6; ++r)
            if (std::abs(m[r][c]) > std::abs(m[pivot][c])) pivot = r;
        std::swap(m[c], m[pivot]);
        std::swap(out[c], out[pivot]);
        const double scale = 1.0 / m[c][c];
        for (size_t j = 0; j < 6; ++j) m[c][j] *= scale, out[c][j] *= scale;
        for (size_t r = 0; r < 6; ++r) {
            const double factor = m[r][c];
            if (r == c || factor == 0.0) continue;
            for (size_t j = 0; j < 6; ++j) m[r][j] -= factor * m[c][j], out[r][j] -= factor * out[c][j];
        }
    }
    return out;
}

// Errors at steps halved again and again. Rounding limits the smallest error, and grows with the number of steps. The order is that of the last
// halving well above rounding.
struct Convergence {
    double order, coarse, fine; // errors before and after that halving
    size_t halvings;
};
inline Convergence convergence(const std::vector<double>& errors) {
    const double rounding = *std::min_element(errors.begin(), errors.end());
    size_t last = 1;
    while (last + 1 < errors.size() && errors[last + 1] > 5.0 * rounding) ++last;
    return {std::log2(errors[last - 1] / errors[last]), errors[last - 1], errors[last], last};
}

class ReferenceBody {
public:
    // Body and fluid together: momenta are mass * twist.
    Matrix6 mass{};
    Matrix6 dragged{};      // rho (V I + A), rho D with its viscous floor
    double weight = 0.0;    // m - rho V, kg
    double displaced = 0.0; // rho V, kg
    Vec buoyancy_arm{};     // m
    Vec gravity{0.0, -9.81, 0.0}, wind{};
    Six world_force{}, body_force{}; // N and N m
    // alpha, 1/s, by speed through the fluid and age.
    std::function<double(double, double)> alpha = [](double, double) { return 0.0; };

    // Quasi-steady loads, when `aerodynamic`.
    ReferenceLoads loads;
    bool aerodynamic = false;
    // Loads of stations instead of `loads`, by velocity and spin.
    std::function<ReferenceStations::Loads(Vec, Vec)> stations;

    // The floor under the damping of spin: docs/maintainers/physics.md, "Viscous floor".
    static constexpr double viscous_floor = 0.02;

    explicit ReferenceBody(const lr_asset_info& info, double scale = 1.0) {
        const double s3 = scale * scale * scale;
        const auto power = [&](size_t i, size_t j) { return s3 * (i < 3 ? 1.0 : scale) * (j < 3 ? 1.0 : scale); };
        displaced = info.fluid_density * info.volume * s3;
        weight = info.mass * s3 - displaced;
        double broadside = 0.0;
        for (size_t i = 0; i < 3; ++i) broadside = std::max(broadside, info.added_mass[i * 7]);
        const double floor = viscous_floor * (info.fluid_density * info.volume + broadside) / info.mass;
        for (size_t i = 0; i < 6; ++i)
            for (size_t j = 0; j < 6; ++j) {
                const double own = i < 3 || j < 3 ? (i == j ? info.mass : 0.0) : info.inertia[(i - 3) * 3 + j - 3];
                const double added = info.added_mass[i * 6 + j];
                mass[i][j] = power(i, j) * (own + added);
                added_[i][j] = power(i, j) * added;
                if ((i < 3) == (j < 3))
                    dragged[i][j] = power(i, j) *
                                    (added + (i < 3 ? (i == j ? info.fluid_density * info.volume : 0.0) : floor * own));
            }
        for (size_t i = 0; i < 3; ++i) buoyancy_arm[i] = scale * info.center_of_buoyancy[i];
        inverse_mass_ = inverse(mass);
    }

    struct State {
        Vec x;
        Quat q;
        Six twist; // body frame, velocity through the fluid
        double age;
    };

    State begin(const lr_body_desc& d) const {
        const Quat q = normalised(quat(d.orientation));
        return {vec(d.position), q,
                join(to_body(q, vec(d.linear_velocity) - wind), to_body(q, vec(d.angular_velocity))), wide(d.age)};
    }
    State run(State s, double time, int count) const {
        const double h = time / count;
        for (int i = 0; i < count; ++i) {
            const State k1 = rate(s), k2 = rate(moved(s, k1, h / 2)), k3 = rate(moved(s, k2, h / 2)),
                        k4 = rate(moved(s, k3, h));
            s = moved(moved(moved(moved(s, k1, h / 6), k2, h / 3), k3, h / 3), k4, h / 6);
            s.q = normalised(s.q);
        }
        return s;
    }
    Vec velocity(const State& s) const { return to_world(s.q, upper(s.twist)) + wind; }
    Vec spin(const State& s) const { return to_world(s.q, lower(s.twist)); }

    // The added mass along a direction.
    double added_along(Vec n) const {
        double sum = 0.0;
        for (size_t i = 0; i < 3; ++i)
            for (size_t j = 0; j < 3; ++j) sum += n[i] * added_[i][j] * n[j];
        return sum;
    }

private:
    State rate(const State& s) const {
        const Vec v = upper(s.twist), w = lower(s.twist), g = to_body(s.q, gravity);
        const Six momentum = mass * s.twist, drag = dragged * s.twist;
        const double a = alpha(length(v), s.age);
        Vec p = upper(momentum), l = lower(momentum);
        if (aerodynamic) { // momentum that stays in the wake
            const Vec n = loads.normal_of_body(), arm = cross(loads.arm, n);
            const double lost = loads.shed(v, w) * added_along(n) * (dot(n, v) + dot(arm, w));
            p = p - lost * n, l = l - lost * arm;
        }
        ReferenceStations::Loads parts;
        if (stations) {
            parts = stations(v, w);
            p = p - parts.lost, l = l - parts.lost_moment;
        }
        Vec force = parts.force + cross(p, w) + weight * g - a * upper(drag) + to_body(s.q, upper(world_force)) +
                    upper(body_force);
        Vec torque = parts.torque + cross(l, w) + cross(p, v) - displaced * cross(buoyancy_arm, g) - a * lower(drag) +
                     to_body(s.q, lower(world_force)) + lower(body_force);
        if (aerodynamic) {
            const ReferenceLoads::Wrench load = loads(v, w);
            force = force + load.force;
            torque = torque + load.torque;
        }
        const Quat turning = product(s.q, {0.5 * w[0], 0.5 * w[1], 0.5 * w[2], 0.0});
        return {to_world(s.q, v) + wind, turning, inverse_mass_ * join(force, torque), 1.0};
    }
    static State moved(State s, const State& rate, double h) {
        for (size_t i = 0; i < 3; ++i) s.x[i] += h * rate.x[i];
        for (size_t i = 0; i < 4; ++i) s.q[i] += h * rate.q[i];
        for (size_t i = 0; i < 6; ++i) s.twist[i] += h * rate.twist[i];
        s.age += h * rate.age;
        return s;
    }

    Matrix6 inverse_mass_{}, added_{};
};

} // namespace test
