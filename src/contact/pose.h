// Vectors, positions and orientations of single things: what the scalar part of contact computes with.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

namespace lr {

template <class T> struct Vector3 { T x, y, z; };
template <class T> constexpr Vector3<T> operator+(Vector3<T> a, Vector3<T> b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T> constexpr Vector3<T> operator-(Vector3<T> a, Vector3<T> b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T> constexpr Vector3<T> operator-(Vector3<T> a) {
    return {-a.x, -a.y, -a.z};
}
template <class T> constexpr Vector3<T> operator*(std::type_identity_t<T> s, Vector3<T> a) {
    return {s * a.x, s * a.y, s * a.z};
}
template <class T> constexpr T dot(Vector3<T> a, Vector3<T> b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T> constexpr Vector3<T> cross(Vector3<T> a, Vector3<T> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T> inline T length(Vector3<T> a) {
    return std::sqrt(dot(a, a));
}
// Of each coordinate.
template <class T> constexpr Vector3<T> low_of(Vector3<T> a, Vector3<T> b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
template <class T> constexpr Vector3<T> high_of(Vector3<T> a, Vector3<T> b) {
    return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}
using Vector = Vector3<float>;
// Where differences of large things' corners would leave nothing of a small one in single precision.
using Double3 = Vector3<double>;

constexpr Double3 to_double(Vector a) {
    return {static_cast<double>(a.x), static_cast<double>(a.y), static_cast<double>(a.z)};
}
constexpr Vector to_float(Double3 a) {
    return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
}
constexpr double wide(float x) {
    return static_cast<double>(x);
}
constexpr void put(Vector v, float* to) {
    to[0] = v.x, to[1] = v.y, to[2] = v.z;
}
constexpr Vector vector_of(const float* v) {
    return {v[0], v[1], v[2]};
}

struct Box {
    Vector low, high; // m
};
constexpr Box around(const Box& a, const Box& b) {
    return {low_of(a.low, b.low), high_of(a.high, b.high)};
}
constexpr Box grown(const Box& box, float by) {
    const Vector more{by, by, by};
    return {box.low - more, box.high + more};
}
constexpr float extent(const Box& box) {
    const Vector e = box.high - box.low;
    return std::max(e.x, std::max(e.y, e.z));
}
constexpr Vector middle_of(const Box& box) {
    return 0.5f * (box.low + box.high);
}
constexpr bool overlap(const Box& a, const Box& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
           a.low.z <= b.high.z && b.low.z <= a.high.z;
}

// Unit quaternion, x y z w: R(q) takes vectors from the thing's own frame to the outer one.
struct Rotation {
    float x, y, z, w;
};
constexpr Rotation inverse(Rotation q) {
    return {-q.x, -q.y, -q.z, q.w};
}
constexpr Vector rotate(Rotation q, Vector a) {
    const Vector axis{q.x, q.y, q.z}, t = 2.0f * cross(axis, a);
    return a + q.w * t + cross(axis, t);
}
constexpr Rotation operator*(Rotation a, Rotation b) {
    return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}
inline Rotation normalised(Rotation q) {
    const float s = 1.0f / std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    return {s * q.x, s * q.y, s * q.z, s * q.w};
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
// Part of the way from one to the other; rotations by the normalised linear quaternion, the shorter way round.
constexpr Vector mix(Vector a, Vector b, float part) {
    return a + part * (b - a);
}
inline Rotation mix(Rotation a, Rotation b, float part) {
    const float sign = a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w < 0.0f ? -1.0f : 1.0f;
    const auto between = [&](float from, float to) { return from + part * (sign * to - from); };
    return normalised({between(a.x, b.x), between(a.y, b.y), between(a.z, b.z), between(a.w, b.w)});
}
inline Pose mix(const Pose& a, const Pose& b, float part) {
    return {mix(a.position, b.position, part), mix(a.rotation, b.rotation, part)};
}
// `of` as seen from `frame`, both given in the same outer frame.
constexpr Pose relative(const Pose& frame, const Pose& of) {
    return {to_inner(frame, of.position), inverse(frame.rotation) * of.rotation};
}

} // namespace lr
