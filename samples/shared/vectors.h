// Vectors, and quaternions x, y, z, w that rotate body vectors to the world.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

using Vector = std::array<double, 3>;
using Quaternion = std::array<double, 4>;

inline Vector plus(const Vector& a, const Vector& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vector minus(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vector times(double s, const Vector& a) {
    return {s * a[0], s * a[1], s * a[2]};
}
inline double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vector unit(const Vector& a) {
    const double length = std::sqrt(dot(a, a));
    return length > 0.0 ? times(1.0 / length, a) : Vector{0.0, 0.0, 1.0};
}

inline Vector turned(const Quaternion& q, const Vector& v) {
    const Vector axis{q[0], q[1], q[2]}, once = cross(axis, v);
    return plus(v, times(2.0, plus(times(q[3], once), cross(axis, once))));
}
inline Quaternion inverse(const Quaternion& q) {
    return {-q[0], -q[1], -q[2], q[3]};
}
// The rotation b, then a.
inline Quaternion after(const Quaternion& a, const Quaternion& b) {
    const Vector u{a[0], a[1], a[2]}, v{b[0], b[1], b[2]};
    const Vector w = plus(plus(times(a[3], v), times(b[3], u)), cross(u, v));
    return {w[0], w[1], w[2], a[3] * b[3] - dot(u, v)};
}
inline Quaternion rotation(const Vector& axis, double angle) {
    const Vector v = times(std::sin(0.5 * angle), unit(axis));
    return {v[0], v[1], v[2], std::cos(0.5 * angle)};
}
