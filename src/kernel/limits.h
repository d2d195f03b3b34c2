// Limits of input, for setters and snapshots. Quantities that grow with steps are kept below them: a world always accepts its own snapshot.
#pragma once

#include "kernel/body_constants.h"
#include "kernel/divergence.h"
#include "langevin_rigid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <type_traits>

namespace lr {

inline constexpr double most_place =
    1e9; // m, each coordinate that a caller gives; farthest_place is where bodies and colliders end
inline constexpr double most_speed = 1e6;                       // m/s and rad/s: far beyond physics, far below overflow
inline constexpr double most_size = 1e6;                        // m, of colliders
inline constexpr double most_gravity = 1e4, most_wind = 1000.0; // m/s^2, m/s, each component
inline constexpr double most_force = 1e9;                       // N, N m, m/s^2, 1/s^2: on every body of a batch
inline constexpr float most_age = 1e9f;                         // s: ages stop here
inline constexpr float least_scale = 1e-3f, most_scale = 1e3f;  // of bodies
inline constexpr double most_gain = 100.0;
// s, and m of the wind's path: so large that rounding removes whatever steps add.
inline constexpr double most_time = 1e22, most_way = 1e25;
// Turbulence tables from a caller: 1/s, m^2/s^3, s.
inline constexpr double most_chi = 1e9, most_epsilon = 1e12, least_interval = 1e-9, most_interval = 1e9;

// False for NaN, like the functions below.
template <class T> bool in_range(T value, double low, double high) {
    return static_cast<double>(value) >= low && static_cast<double>(value) <= high;
}
template <class T, size_t N> bool within(const T (&values)[N], double most) {
    return std::all_of(std::begin(values), std::end(values), [&](T v) { return in_range(v, -most, most); });
}
// Numbers, and arrays of numbers.
template <class... T> bool finite(const T&... values) {
    const auto one = [](const auto& value) {
        if constexpr (std::is_array_v<std::remove_cvref_t<decltype(value)>>)
            return std::all_of(std::begin(value), std::end(value), [](auto v) { return std::isfinite(v); });
        else
            return std::isfinite(value);
    };
    return (one(values) && ...);
}
// Whether a quaternion or direction is long enough to be normalised.
template <size_t N> bool normalisable(const float (&v)[N]) {
    double square = 0.0;
    for (float x : v) square += static_cast<double>(x) * static_cast<double>(x);
    return in_range(square, 1e-12, 1e12);
}

// Whether an input can be used. A refusal has a reason, unless its status is reason enough.
struct Outcome {
    Outcome(lr_status s = LR_OK, const char* w = nullptr) : status(s), why(w) {}
    bool refused() const { return status != LR_OK; }
    lr_status status;
    const char* why;
};
inline Outcome invalid(const char* why) { // null: valid
    return {why ? LR_ERROR_INVALID_ARGUMENT : LR_OK, why};
}

// Null if valid, else the reason.
inline const char* wrong_gravity(const float (&gravity)[3]) {
    return within(gravity, most_gravity) ? nullptr : "gravity is over 1e4 m/s^2";
}
inline const char* wrong_wind(const float (&wind)[3]) {
    return within(wind, most_wind) ? nullptr : "velocity is over 1000 m/s";
}
inline const char* wrong_in(const Gains& g) {
    for (double v : {g.damping, g.noise, g.drag, g.lift, g.spin_drag, g.turbulence})
        if (!in_range(v, 0.0, most_gain)) return "a gain is not 0 to 100";
    return nullptr;
}
inline const char* wrong_in(const TurbulenceSample& s) {
    if (!in_range(s.u0, 1e-9, 1e6)) return "u0 is not positive";
    if (!in_range(s.l, 1e-9, 1e6)) return "l is not positive";
    if (!in_range(s.c0, 1e-9, 100.0)) return "c0 is not positive, or over 100";
    return in_range(s.chi, 0.0, most_chi) && in_range(s.epsilon, 0.0, most_epsilon)
               ? nullptr
               : "a sample is negative or far too large";
}
} // namespace lr
