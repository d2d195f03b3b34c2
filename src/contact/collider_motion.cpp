#include "contact/collider_motion.h"

#include "kernel/faults.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

double wide(float x) {
    return static_cast<double>(x);
}

struct Wide {
    double v[3];
};
Wide wide(Vector a) {
    return {{wide(a.x), wide(a.y), wide(a.z)}};
}

double quaternion_dot(const Rotation& a, const Rotation& b) {
    return wide(a.x) * wide(b.x) + wide(a.y) * wide(b.y) + wide(a.z) * wide(b.z) + wide(a.w) * wide(b.w);
}

// |a - b|^2
double squared_difference(const Rotation& a, const Rotation& b) {
    const double d[4] = {wide(a.x) - wide(b.x), wide(a.y) - wide(b.y), wide(a.z) - wide(b.z), wide(a.w) - wide(b.w)};
    return d[0] * d[0] + d[1] * d[1] + d[2] * d[2] + d[3] * d[3];
}

// m: how far a point of the box can be from the frame's origin.
double radius(const Box& box) {
    const Wide low = wide(box.low), high = wide(box.high);
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) {
        const double most = std::max(std::abs(low.v[k]), std::abs(high.v[k]));
        sum += most * most;
    }
    return std::sqrt(sum);
}

struct WideBox {
    double low[3], high[3];
};

WideBox box_at(const LocalBounds& local, const Pose& pose) {
    const Rotation& q = pose.rotation;
    const double x = wide(q.x), y = wide(q.y), z = wide(q.z), w = wide(q.w);
    const double rows[3][3] = {{1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - z * w), 2.0 * (x * z + y * w)},
                               {2.0 * (x * y + z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - x * w)},
                               {2.0 * (x * z - y * w), 2.0 * (y * z + x * w), 1.0 - 2.0 * (x * x + y * y)}};
    const Wide low = wide(local.box.low), high = wide(local.box.high), at = wide(pose.position);
    WideBox out{};
    for (int i = 0; i < 3; ++i) {
        double middle = at.v[i], half = wide(local.round), size = half;
        for (int k = 0; k < 3; ++k) {
            const double m = 0.5 * (low.v[k] + high.v[k]), h = 0.5 * (high.v[k] - low.v[k]);
            middle += rows[i][k] * m;
            half += std::abs(rows[i][k]) * h;
            size += std::abs(m) + h;
        }
        half += 1e-6 * size; // the quaternion's length is one up to rounding, and so is all that is computed with it
        out.low[i] = middle - half;
        out.high[i] = middle + half;
    }
    return out;
}

float rounded_down(double x) {
    return static_cast<float>(x - std::abs(x) * 0x1.1p-23);
}
float rounded_up(double x) {
    return static_cast<float>(x + std::abs(x) * 0x1.1p-23);
}

// Sine and cosine by their series on an eighth of the angle, which is then doubled.
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

// With the quaternion interpolated linearly, at u in [-1, 1] and k = tan of a quarter of the angle between the ends, a
// point at distance r from the axis is off the chord's own linear way by 2 r k^2 (1 - u^2) sqrt(1 + u^2 k^2) /
// ((1 + u^2 k^2)(1 + k^2)): never more than its greatest height above the chord, r (1 - cos(angle / 2)), which is
// r (1 - q_begin . q_end). The chord's ends are in the boxes at both ends.
Box swept_box(const LocalBounds& local, const Pose& begin, const Pose& end, bool moves) {
    WideBox box = box_at(local, begin);
    if (moves) {
        const WideBox other = box_at(local, end);
        const double bulge = radius(local.box) * 0.5 * squared_difference(begin.rotation, end.rotation) * (1.0 + 1e-6);
        for (int k = 0; k < 3; ++k) {
            box.low[k] = std::min(box.low[k], other.low[k]) - bulge;
            box.high[k] = std::max(box.high[k], other.high[k]) + bulge;
        }
    }
    return {{rounded_down(box.low[0]), rounded_down(box.low[1]), rounded_down(box.low[2])},
            {rounded_up(box.high[0]), rounded_up(box.high[1]), rounded_up(box.high[2])}};
}

float most_travel(const Box& local, const Pose& begin, const Pose& end) {
    const Wide from = wide(begin.position), to = wide(end.position);
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) sum += (to.v[k] - from.v[k]) * (to.v[k] - from.v[k]);
    // The chord of an angle, 2 sin(angle / 2), is at most twice the difference of the quaternions, 2 sin(angle / 4).
    const double turned = 2.0 * std::sqrt(squared_difference(begin.rotation, end.rotation));
    return rounded_up((std::sqrt(sum) + turned * radius(local)) * (1.0 + 1e-6));
}

Rotation nearer_to(const Rotation& to, const Rotation& q) {
    return quaternion_dot(to, q) < 0.0 ? Rotation{-q.x, -q.y, -q.z, -q.w} : q;
}

Pose advanced(const Pose& from, Vector linear, Vector angular, double dt, Vector& rest) {
    Pose to = from;
    const Wide x = wide(from.position), v = wide(linear), left = wide(rest), w = wide(angular);
    double next[3];
    constexpr auto most = static_cast<double>(farthest_place); // where no body comes
    for (int k = 0; k < 3; ++k) next[k] = std::clamp(x.v[k] + left.v[k] + v.v[k] * dt, -most, most);
    to.position = {static_cast<float>(next[0]), static_cast<float>(next[1]), static_cast<float>(next[2])};
    rest = {static_cast<float>(next[0] - wide(to.position.x)), static_cast<float>(next[1] - wide(to.position.y)),
            static_cast<float>(next[2] - wide(to.position.z))};
    const double speed = std::sqrt(w.v[0] * w.v[0] + w.v[1] * w.v[1] + w.v[2] * w.v[2]);
    if (!(speed > 0.0)) return to;
    double s = 0.0, c = 1.0;
    sine_cosine(0.5 * speed * dt, s, c);
    const double scale = s / speed;
    const double a[4] = {scale * w.v[0], scale * w.v[1], scale * w.v[2], c};
    const Rotation& q = from.rotation;
    const double b[4] = {wide(q.x), wide(q.y), wide(q.z), wide(q.w)};
    double p[4] = {
        a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
        a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
    const double n = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2] + p[3] * p[3]);
    for (double& e : p) e /= n;
    const Rotation turned{static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]),
                          static_cast<float>(p[3])};
    to.rotation = nearer_to(from.rotation, turned);
    return to;
}

} // namespace lr
