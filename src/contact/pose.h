// Positions and orientations of single things, in single precision: what the scalar part of contact computes with.
#pragma once

#include <array>
#include <cmath>

namespace lr {

struct Vector {
    float x, y, z;
};
constexpr Vector operator+(Vector a, Vector b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Vector operator-(Vector a, Vector b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Vector operator-(Vector a) {
    return {-a.x, -a.y, -a.z};
}
constexpr Vector operator*(float s, Vector a) {
    return {s * a.x, s * a.y, s * a.z};
}
constexpr float dot(Vector a, Vector b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Vector cross(Vector a, Vector b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline float length(Vector a) {
    return std::sqrt(dot(a, a));
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
