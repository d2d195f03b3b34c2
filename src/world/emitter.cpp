#include "world/emitter.h"

#include "contact/pose.h"
#include "kernel/limits.h"
#include "world/counter_random.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

template <size_t N> double squared(const float (&v)[N]) {
    double sum = 0.0;
    for (float x : v) sum += wide(x) * wide(x);
    return sum;
}
template <size_t N> bool normalisable(const float (&v)[N]) {
    const double s = squared(v);
    return s >= 1e-12 && s <= 1e12;
}
template <size_t N> void normalise(const float (&v)[N], double (&out)[N]) {
    const double length = std::sqrt(squared(v));
    for (size_t i = 0; i < N; ++i) out[i] = wide(v[i]) / length;
}

// 1 - cos x = 2 sin^2(x/2) for 0 <= x <= pi, by the series of the sine: the C library's differs between machines.
double one_minus_cosine(double x) {
    const double y = 0.5 * x;
    double term = y, sine = y;
    for (int n = 1; n <= 10; ++n) {
        term *= -y * y / ((2.0 * n) * (2.0 * n + 1.0));
        sine += term;
    }
    return 2.0 * sine * sine;
}

WideVector add_scaled(const WideVector& a, double s, const WideVector& b) {
    return {{a.v[0] + s * b.v[0], a.v[1] + s * b.v[1], a.v[2] + s * b.v[2]}};
}

// A unit vector in any direction (Marsaglia 1972).
WideVector direction(CounterRandom& random) {
    double x, y;
    const double s = random.disc(x, y);
    const double r = 2.0 * std::sqrt(1.0 - s);
    return {{x * r, y * r, 1.0 - 2.0 * s}};
}

// Any orientation (Marsaglia 1972).
void orientation(CounterRandom& random, double (&q)[4]) {
    const double s = random.disc(q[0], q[1]), t = random.disc(q[2], q[3]);
    const double r = std::sqrt((1.0 - s) / t);
    q[2] *= r;
    q[3] *= r;
}

// On the surface of a box of these half extents: a face by its area, a point on it.
WideVector on_box(CounterRandom& random, const float (&half)[3]) {
    const double h[3] = {wide(half[0]), wide(half[1]), wide(half[2])};
    const double area[3] = {h[1] * h[2], h[2] * h[0], h[0] * h[1]};
    const double at = random.uniform() * (area[0] + area[1] + area[2]);
    const size_t face = at < area[0] ? 0 : at < area[0] + area[1] ? 1 : 2;
    WideVector p;
    for (size_t i = 0; i < 3; ++i) p.v[i] = random.between(-1.0, 1.0);
    p.v[face] = p.v[face] < 0.0 ? -1.0 : 1.0;
    return p;
}

// In a shape of unit size.
WideVector place(CounterRandom& random, int32_t shape, const float (&size)[3]) {
    WideVector p{};
    switch (shape) {
    case LR_EMIT_BOX:
        for (double& x : p.v) x = random.between(-1.0, 1.0);
        return p;
    case LR_EMIT_BOX_SURFACE:
        return on_box(random, size);
    case LR_EMIT_SPHERE:
        do
            for (double& x : p.v) x = random.between(-1.0, 1.0);
        while (p.v[0] * p.v[0] + p.v[1] * p.v[1] + p.v[2] * p.v[2] > 1.0);
        return p;
    case LR_EMIT_SPHERE_SURFACE:
        return direction(random);
    case LR_EMIT_DISC:
        random.disc(p.v[0], p.v[1]);
        return p;
    default:
        return p;
    }
}

} // namespace

const char* wrong_in(const lr_emitter_desc& d) {
    if (d.shape < LR_EMIT_POINT || d.shape > LR_EMIT_SPHERE_SURFACE) return "unknown shape";
    if (d.pose != LR_POSE_RANDOM && d.pose != LR_POSE_FIXED) return "unknown pose";
    if (!within(d.position, most_place)) return "position is over 1e9 m";
    for (float x : d.size)
        if (!in_range(x, 0.0, most_place)) return "size is negative or over 1e9 m";
    if (!normalisable(d.orientation) || !normalisable(d.body_orientation)) return "an orientation cannot be normalised";
    if (!normalisable(d.direction)) return "direction cannot be normalised";
    if (!in_range(d.spread, 0.0, 3.1416)) return "spread is not 0 to pi";
    if (!in_range(d.speed_min, 0.0, most_speed) || !in_range(d.speed_max, wide(d.speed_min), most_speed))
        return "speeds are not 0 to 1e6 m/s in order";
    if (!in_range(d.spin_min, 0.0, most_speed) || !in_range(d.spin_max, wide(d.spin_min), most_speed))
        return "spins are not 0 to 1e6 rad/s in order";
    if (!in_range(d.scale_min, wide(least_scale), wide(most_scale)) ||
        !in_range(d.scale_max, wide(d.scale_min), wide(most_scale)))
        return "scales are not 0.001 to 1000 in order";
    if (!in_range(d.rate, 0.0, 1e9)) return "rate is not 0 to 1e9 a second";
    if (d.burst_count != 0 ? !in_range(d.burst_interval, static_cast<double>(1e-4f), 1e9)
                           : !in_range(d.burst_interval, 0.0, 1e9))
        return "burst_interval is not 1e-4 to 1e9 s";
    if (d.burst_count > max_capacity) return "burst_count is over 2^26";
    if (d.reserved != 0) return "reserved is not 0";
    return nullptr;
}

bool all_finite(const lr_emitter_desc& d) {
    const auto finite = [](const auto& values) {
        return std::all_of(std::begin(values), std::end(values), [](float v) { return std::isfinite(v); });
    };
    const float scalars[] = {d.spread,    d.speed_min, d.speed_max, d.spin_min,      d.spin_max,
                             d.scale_min, d.scale_max, d.rate,      d.burst_interval};
    return finite(d.position) && finite(d.orientation) && finite(d.size) && finite(d.body_orientation) &&
           finite(d.direction) && finite(scalars);
}

Emitter::Emitter(const lr_emitter_desc& desc) : desc_(desc) {
    normalise(desc.orientation, orientation_);
    normalise(desc.body_orientation, pose_);
    normalise(desc.direction, axis_.v);
    cone_ = one_minus_cosine(std::min(wide(desc.spread), 3.14159265358979));
    // Two sides at right angles: from the world axis that lies furthest from the cone's.
    const double* const n = axis_.v;
    size_t least = 0;
    for (size_t i = 1; i < 3; ++i)
        if (std::abs(n[i]) < std::abs(n[least])) least = i;
    double length = 0.0;
    for (size_t i = 0; i < 3; ++i) {
        side_[0].v[i] = (i == least ? 1.0 : 0.0) - n[least] * n[i];
        length += side_[0].v[i] * side_[0].v[i];
    }
    for (double& x : side_[0].v) x /= std::sqrt(length);
    const double* const a = side_[0].v;
    side_[1] = {{n[1] * a[2] - n[2] * a[1], n[2] * a[0] - n[0] * a[2], n[0] * a[1] - n[1] * a[0]}};
}

BodyState Emitter::draw(uint64_t seed, uint32_t key, uint32_t life) const {
    CounterRandom random(seed, key, life);
    BodyState out{};
    out.key = key;
    WideVector local = place(random, desc_.shape, desc_.size);
    for (size_t i = 0; i < 3; ++i) local.v[i] *= wide(desc_.size[i]);
    const WideVector at = rotate(orientation_, local.v, false);

    double q[4];
    std::copy(pose_, pose_ + 4, q);
    if (desc_.pose == LR_POSE_RANDOM) orientation(random, q);

    double x, y;
    const double s = std::sqrt(random.disc(x, y));
    const double down = random.uniform() * cone_, aside = std::sqrt(down * (2.0 - down)) / s;
    WideVector v = add_scaled(add_scaled({}, 1.0 - down, axis_), aside * x, side_[0]);
    v = add_scaled({}, random.between(wide(desc_.speed_min), wide(desc_.speed_max)),
                   add_scaled(v, aside * y, side_[1]));
    WideVector w = direction(random);
    w = add_scaled({}, random.between(wide(desc_.spin_min), wide(desc_.spin_max)), w);
    v = rotate(q, v.v, true);
    w = rotate(q, w.v, true);

    for (size_t i = 0; i < 3; ++i) {
        out.value[field_x + i] = static_cast<float>(wide(desc_.position[i]) + at.v[i]);
        out.value[field_vx + i] = static_cast<float>(v.v[i]);
        out.value[field_wx + i] = static_cast<float>(w.v[i]);
    }
    for (size_t i = 0; i < 4; ++i) out.value[field_qx + i] = static_cast<float>(q[i]);
    const double scale = random.between(wide(desc_.scale_min), wide(desc_.scale_max));
    out.value[field_scale] = std::clamp(static_cast<float>(scale), desc_.scale_min, desc_.scale_max);
    return out;
}

} // namespace lr
