#include "collision/colliders.h"

#include "kernel/divergence.h"

#include <cmath>

namespace lr {
namespace {

double squared_difference(const Rotation& a, const Rotation& b) {
    const Quaternion<double> d = to_double(a) - to_double(b);
    return dot(d, d);
}

Double3 sizes_of(Double3 a) {
    return {std::abs(a.x), std::abs(a.y), std::abs(a.z)};
}
Double3 all(double a) {
    return {a, a, a};
}

// m: the greatest distance of a point of the box from the frame's origin.
double radius(const Box& box) {
    return length(high_of(sizes_of(to_double(box.low)), sizes_of(to_double(box.high))));
}

struct WideBox {
    Double3 low, high;
};

WideBox box_at(const LocalBounds& local, const Pose& pose) {
    const Quaternion<double> q = to_double(pose.rotation);
    const Double3 low = to_double(local.box.low), high = to_double(local.box.high), one = all(1.0);
    const Double3 m = 0.5 * (low + high), h = 0.5 * (high - low);
    const Double3 middle = to_double(pose.position) + rotate(q, m);
    const auto along = [&](uint32_t k) { return sizes_of(rotate(q, along_axis(k, h[k]))); };
    Double3 half = along(0) + along(1) + along(2);
    // The quaternion has unit length only up to rounding, and the results carry that error.
    const double round = wide(local.round), size = round + dot(sizes_of(m) + h, one);
    half = half + all(round + 1e-6 * size);
    return {middle - half, middle + half};
}

float rounded_down(double x) {
    return static_cast<float>(x - std::abs(x) * 0x1.1p-23);
}
float rounded_up(double x) {
    return static_cast<float>(x + std::abs(x) * 0x1.1p-23);
}

// Sine and cosine by series at an eighth of the angle, doubled three times: the same bits everywhere.
void sine_cosine(double angle, double& sine, double& cosine) {
    constexpr double turn = 6.283185307179586476925;
    const double x = 0.125 * (angle - turn * std::floor(angle / turn));
    double s = 0.0, c = 0.0, term = 1.0;
    for (int n = 1; n <= 17; n += 2) {
        c += term;
        term *= x / n;
        s += term;
        term *= -x / (n + 1);
    }
    for (int i = 0; i < 3; ++i) {
        const double twice = 2.0 * s * c;
        c = 1.0 - 2.0 * s * s;
        s = twice;
    }
    sine = s;
    cosine = c;
}
} // namespace

LocalBounds bounds_of(const Geometry& geometry, const SharedGeometry* shared) {
    const float(&s)[3] = geometry.size;
    switch (geometry.kind) {
    case ColliderKind::sphere:
        return {{{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}}, s[0]};
    case ColliderKind::capsule:
        return {{{0.0f, -s[1], 0.0f}, {0.0f, s[1], 0.0f}}, s[0]};
    case ColliderKind::box:
        return {{{-s[0], -s[1], -s[2]}, {s[0], s[1], s[2]}}, 0.0f};
    default:
        return {shared ? shared->box : Box{}, 0.0f};
    }
}

// With the quaternion interpolated linearly, u in [-1, 1] and k the tangent of a quarter of the angle between the ends, a point at distance r from
// the axis deviates from its chord by 2 r k^2 (1 - u^2) sqrt(1 + u^2 k^2)/((1 + u^2 k^2)(1 + k^2)). This never exceeds the height of the arc,
// r (1 - cos(angle/2)) = r (1 - q_begin . q_end). The ends of the chord are in the boxes at both ends.
Box swept_box(const LocalBounds& local, const Pose& begin, const Pose& end, bool moves) {
    WideBox box = box_at(local, begin);
    if (moves) {
        const WideBox other = box_at(local, end);
        const double bulge = radius(local.box) * 0.5 * squared_difference(begin.rotation, end.rotation) * (1.0 + 1e-6);
        box = {low_of(box.low, other.low) - all(bulge), high_of(box.high, other.high) + all(bulge)};
    }
    return {{rounded_down(box.low.x), rounded_down(box.low.y), rounded_down(box.low.z)},
            {rounded_up(box.high.x), rounded_up(box.high.y), rounded_up(box.high.z)}};
}

float most_travel(const Box& local, const Pose& begin, const Pose& end) {
    // The chord of the angle is 2 sin(angle/2), at most twice the difference of the quaternions, 2 sin(angle/4).
    const double turned = 2.0 * std::sqrt(squared_difference(begin.rotation, end.rotation));
    return rounded_up((length(to_double(end.position) - to_double(begin.position)) + turned * radius(local)) *
                      (1.0 + 1e-6));
}

Rotation nearer_to(const Rotation& to, const Rotation& q) {
    return dot(to_double(to), to_double(q)) < 0.0 ? -1.0f * q : q;
}

Pose advanced(const Pose& from, Vector linear, Vector angular, double dt, Vector& remainder) {
    Pose to = from;
    constexpr auto most = static_cast<double>(farthest_place); // bodies never get so far
    const Double3 w = to_double(angular);
    const Double3 next = high_of(
        low_of(to_double(from.position) + to_double(remainder) + dt * to_double(linear), all(most)), all(-most));
    to.position = to_float(next);
    remainder = to_float(next - to_double(to.position));
    const double speed = length(w);
    if (!(speed > 0.0)) return to;
    double s = 0.0, c = 1.0;
    sine_cosine(0.5 * speed * dt, s, c);
    const double scale = s / speed;
    const Quaternion<double> turn{scale * w.x, scale * w.y, scale * w.z, c};
    to.rotation = nearer_to(from.rotation, unit_of(turn * to_double(from.rotation)));
    return to;
}
} // namespace lr
