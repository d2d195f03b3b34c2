// Vectors and quaternions in double, for tests.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace test {

using Vec = std::array<double, 3>;
using Quat = std::array<double, 4>; // x y z w

inline Vec vec(const float v[3]) {
    return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}
inline Quat quat(const float q[4]) {
    return {static_cast<double>(q[0]), static_cast<double>(q[1]), static_cast<double>(q[2]), static_cast<double>(q[3])};
}
inline Vec operator+(Vec a, Vec b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vec operator-(Vec a, Vec b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vec operator*(double s, Vec a) {
    return {s * a[0], s * a[1], s * a[2]};
}
inline double dot(Vec a, Vec b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vec cross(Vec a, Vec b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(Vec a) {
    return std::sqrt(dot(a, a));
}

// Columns of the rotation matrix, directly from its definition by products of quaternion components.
using Matrix3 = std::array<Vec, 3>; // rows
inline Matrix3 rotation(Quat q) {
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    return {{{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
             {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
             {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}}};
}
inline Vec to_world(Quat q, Vec a) {
    const Matrix3 r = rotation(q);
    return {dot(r[0], a), dot(r[1], a), dot(r[2], a)};
}
inline Vec to_body(Quat q, Vec a) {
    const Matrix3 r = rotation(q);
    return a[0] * r[0] + a[1] * r[1] + a[2] * r[2];
}
inline Quat product(Quat a, Quat b) {
    return {
        a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
        a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}
inline Quat normalised(Quat q) {
    const double n = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    return {q[0] / n, q[1] / n, q[2] / n, q[3] / n};
}
inline Quat about(Vec axis, double angle) {
    const Vec n = 1.0 / length(axis) * axis;
    const double s = std::sin(0.5 * angle);
    return {s * n[0], s * n[1], s * n[2], std::cos(0.5 * angle)};
}

} // namespace test
