// Vectors, positions and orientations for the scalar part of contact.
#pragma once

#include "base/lane_arrays.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

// Also where code is compiled for size: a call of these is longer than what it calls.
#if defined(_MSC_VER) && !defined(__clang__)
#define LR_INLINE [[msvc::forceinline]]
#else
#define LR_INLINE [[gnu::always_inline]]
#endif

namespace lr {

template <class T> struct Vector3 {
    T x, y, z;
    constexpr T operator[](uint32_t k) const { return k == 0 ? x : k == 1 ? y : z; }
};
template <class T> constexpr Vector3<T> along_axis(uint32_t k, T size) {
    return {k == 0 ? size : T(0), k == 1 ? size : T(0), k == 2 ? size : T(0)};
}
template <class T> LR_INLINE constexpr Vector3<T> operator+(Vector3<T> a, Vector3<T> b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T> LR_INLINE constexpr Vector3<T> operator-(Vector3<T> a, Vector3<T> b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T> LR_INLINE constexpr Vector3<T> operator-(Vector3<T> a) {
    return {-a.x, -a.y, -a.z};
}
template <class T> LR_INLINE constexpr Vector3<T> operator*(std::type_identity_t<T> s, Vector3<T> a) {
    return {s * a.x, s * a.y, s * a.z};
}
template <class T> LR_INLINE constexpr Vector3<T> operator/(Vector3<T> a, std::type_identity_t<T> s) {
    return {a.x / s, a.y / s, a.z / s};
}
template <class T> LR_INLINE constexpr T dot(Vector3<T> a, Vector3<T> b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T> LR_INLINE constexpr Vector3<T> cross(Vector3<T> a, Vector3<T> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T> LR_INLINE inline T length(Vector3<T> a) {
    return std::sqrt(dot(a, a));
}
// The lesser and the greater of each coordinate.
template <class T> LR_INLINE constexpr Vector3<T> low_of(Vector3<T> a, Vector3<T> b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
template <class T> LR_INLINE constexpr Vector3<T> high_of(Vector3<T> a, Vector3<T> b) {
    return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}
using Vector = Vector3<float>;
// For differences of large coordinates, where single precision would lose small distances.
using Double3 = Vector3<double>;

LR_INLINE constexpr Double3 to_double(Vector a) {
    return {static_cast<double>(a.x), static_cast<double>(a.y), static_cast<double>(a.z)};
}
LR_INLINE constexpr Vector to_float(Double3 a) {
    return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
}
constexpr double wide(float x) {
    return static_cast<double>(x);
}
LR_INLINE constexpr void put(Vector v, float* to) {
    to[0] = v.x, to[1] = v.y, to[2] = v.z;
}
LR_INLINE constexpr Vector vector_of(const float* v) {
    return {v[0], v[1], v[2]};
}

// Two unit vectors normal to a unit vector and to each other.
struct RightAngles {
    Double3 first, second;
};
inline RightAngles right_angles_to(Double3 n) {
    // From the coordinate axis farthest from n.
    const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
    const uint32_t least = x <= y ? (x <= z ? 0 : 2) : (y <= z ? 1 : 2);
    const Double3 side = along_axis(least, 1.0) - n[least] * n, first = side / length(side);
    return {first, cross(n, first)};
}

struct Box {
    Vector low, high; // m
};
constexpr Box around(const Box& a, const Box& b) {
    return {low_of(a.low, b.low), high_of(a.high, b.high)};
}
LR_INLINE constexpr Box grown(const Box& box, Vector by) {
    return {box.low - by, box.high + by};
}
LR_INLINE constexpr Box grown(const Box& box, float by) {
    return grown(box, Vector{by, by, by});
}
constexpr float extent(const Box& box) {
    const Vector e = box.high - box.low;
    return std::max(e.x, std::max(e.y, e.z));
}
LR_INLINE constexpr Vector middle_of(const Box& box) {
    return 0.5f * (box.low + box.high);
}
LR_INLINE constexpr bool overlap(const Box& a, const Box& b) {
    const auto along = [](float low_a, float high_a, float low_b, float high_b) -> uint32_t {
        return (low_a <= high_b) & (low_b <= high_a);
    };
    return (along(a.low.x, a.high.x, b.low.x, b.high.x) & along(a.low.y, a.high.y, b.low.y, b.high.y) &
            along(a.low.z, a.high.z, b.low.z, b.high.z)) != 0;
}
constexpr bool contains(const Box& a, const Box& b) {
    return a.low.x <= b.low.x && a.low.y <= b.low.y && a.low.z <= b.low.z && b.high.x <= a.high.x &&
           b.high.y <= a.high.y && b.high.z <= a.high.z;
}

// Unit quaternions: R(q) rotates vectors from the inner to the outer frame.
template <class T> struct Quaternion {
    T x, y, z, w;
    constexpr bool operator==(const Quaternion&) const = default;
};
template <class T> constexpr Quaternion<T> operator+(Quaternion<T> a, Quaternion<T> b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
}
template <class T> constexpr Quaternion<T> operator-(Quaternion<T> a, Quaternion<T> b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w};
}
template <class T> constexpr Quaternion<T> operator*(std::type_identity_t<T> s, Quaternion<T> a) {
    return {s * a.x, s * a.y, s * a.z, s * a.w};
}
template <class T> constexpr Quaternion<T> operator*(Quaternion<T> a, Quaternion<T> b) {
    return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}
template <class T> constexpr T dot(Quaternion<T> a, Quaternion<T> b) {
    return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}
template <class T> LR_INLINE constexpr Quaternion<T> inverse(Quaternion<T> q) {
    return {-q.x, -q.y, -q.z, q.w};
}
template <class T> constexpr Vector3<T> rotate(Quaternion<T> q, std::type_identity_t<Vector3<T>> a) {
    const Vector3<T> axis{q.x, q.y, q.z}, t = T(2) * cross(axis, a);
    return a + q.w * t + cross(axis, t);
}
using Rotation = Quaternion<float>;
constexpr Rotation rotation_of(const float* q) {
    return {q[0], q[1], q[2], q[3]};
}
LR_INLINE constexpr void put(Rotation q, float* to) {
    to[0] = q.x, to[1] = q.y, to[2] = q.z, to[3] = q.w;
}
constexpr Quaternion<double> to_double(Rotation q) {
    return {wide(q.x), wide(q.y), wide(q.z), wide(q.w)};
}
constexpr Rotation to_float(Quaternion<double> q) {
    return {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z), static_cast<float>(q.w)};
}
inline Rotation normalised(Rotation q) {
    return 1.0f / std::sqrt(dot(q, q)) * q;
}
// Normalised with one rounding.
inline Rotation unit_of(Quaternion<double> q) {
    const double n = std::sqrt(dot(q, q));
    return {static_cast<float>(q.x / n), static_cast<float>(q.y / n), static_cast<float>(q.z / n),
            static_cast<float>(q.w / n)};
}
// For a caller's numbers: a unit quaternion keeps its bits.
inline Rotation unit_rotation(const float* q) {
    const Quaternion<double> exact = to_double(rotation_of(q));
    return std::abs(std::sqrt(dot(exact, exact)) - 1.0) < 1e-7 ? rotation_of(q) : unit_of(exact);
}
// Axis times twice the sine of half the angle.
constexpr Vector chord(Rotation q) {
    return (q.w < 0.0f ? -2.0f : 2.0f) * Vector{q.x, q.y, q.z};
}
// The inner frame's axes in the outer frame: columns of R(q).
struct Axes {
    Vector x, y, z;
};
constexpr Axes axes_of(Rotation q) {
    return {rotate(q, {1.0f, 0.0f, 0.0f}), rotate(q, {0.0f, 1.0f, 0.0f}), rotate(q, {0.0f, 0.0f, 1.0f})};
}

struct Pose {
    Vector position; // m
    Rotation rotation;
};
constexpr Vector to_outer(const Pose& pose, Vector inner) {
    return pose.position + rotate(pose.rotation, inner);
}
constexpr Vector to_inner(const Pose& pose, Vector outer) {
    return rotate(inverse(pose.rotation), outer - pose.position);
}
// Linear interpolation; rotations by normalised quaternions, the shorter way round.
constexpr Vector mix(Vector a, Vector b, float part) {
    return a + part * (b - a);
}
inline Rotation mix(Rotation a, Rotation b, float part) {
    const float sign = dot(a, b) < 0.0f ? -1.0f : 1.0f;
    return normalised(a + part * (sign * b - a));
}
inline Pose mix(const Pose& a, const Pose& b, float part) {
    return {mix(a.position, b.position, part), mix(a.rotation, b.rotation, part)};
}
// `of` relative to `frame`; both are given in the same outer frame.
constexpr Pose relative(const Pose& frame, const Pose& of) {
    return {to_inner(frame, of.position), inverse(frame.rotation) * of.rotation};
}

// Bodies stored as rows, with one index for each body: BatchArrays::field, LaneRow and the like.
template <class Rows> LR_INLINE inline Vector vector_in(const Rows& rows, size_t first, size_t i) {
    return {rows[first][i], rows[first + 1][i], rows[first + 2][i]};
}
template <class Rows> LR_INLINE inline void put_in(Rows& rows, size_t first, size_t i, Vector v) {
    rows[first][i] = v.x, rows[first + 1][i] = v.y, rows[first + 2][i] = v.z;
}
// For rows that begin with those of BatchArrays::field.
template <class Rows> LR_INLINE inline Pose pose_in(const Rows& rows, size_t i) {
    return {vector_in(rows, field_x, i), {rows[field_qx][i], rows[field_qy][i], rows[field_qz][i], rows[field_qw][i]}};
}
inline Pose pose_of(const BatchArrays& arrays, size_t i) {
    return pose_in(arrays.field, i);
}
} // namespace lr
