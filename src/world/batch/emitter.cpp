#include "base/counter_random.h"
#include "world/batch/lifecycle.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

Double3 unit(const float (&v)[3]) {
    const Double3 given = to_double(vector_of(v));
    return given / length(given);
}
Quaternion<double> unit(const float (&v)[4]) {
    const Quaternion<double> q = to_double(rotation_of(v));
    const double n = std::sqrt(dot(q, q));
    return {q.x / n, q.y / n, q.z / n, q.w / n};
}

// 1 - cos x = 2 sin^2(x/2) for 0 <= x <= pi by a series, since the C library's differs between machines.
double one_minus_cosine(double x) {
    const double y = 0.5 * x;
    double term = y, sine = y;
    for (int n = 1; n <= 10; ++n) {
        term *= -y * y / ((2.0 * n) * (2.0 * n + 1.0));
        sine += term;
    }
    return 2.0 * sine * sine;
}

// A uniform direction (Marsaglia 1972).
Double3 direction(CounterRandom& random) {
    double x, y;
    const double s = random.disc(x, y);
    const double r = 2.0 * std::sqrt(1.0 - s);
    return {x * r, y * r, 1.0 - 2.0 * s};
}

// A uniform orientation (Marsaglia 1972).
Quaternion<double> orientation(CounterRandom& random) {
    Quaternion<double> q{};
    const double s = random.disc(q.x, q.y), t = random.disc(q.z, q.w);
    const double r = std::sqrt((1.0 - s) / t);
    return {q.x, q.y, q.z * r, q.w * r};
}

Double3 in_cube(CounterRandom& random) {
    const double x = random.between(-1.0, 1.0), y = random.between(-1.0, 1.0);
    return {x, y, random.between(-1.0, 1.0)};
}

// A uniform point on the surface of a box: a face by area, then a point on it.
Double3 on_box(CounterRandom& random, Double3 h) {
    const double area[3] = {h.y * h.z, h.z * h.x, h.x * h.y};
    const double at = random.uniform() * (area[0] + area[1] + area[2]);
    Double3 p = in_cube(random);
    double& across = at < area[0] ? p.x : at < area[0] + area[1] ? p.y : p.z;
    across = across < 0.0 ? -1.0 : 1.0;
    return p;
}

Double3 place(CounterRandom& random, int32_t shape, Double3 size) {
    Double3 p{};
    switch (shape) {
    case LR_EMIT_BOX:
        return in_cube(random);
    case LR_EMIT_BOX_SURFACE:
        return on_box(random, size);
    case LR_EMIT_SPHERE:
        do p = in_cube(random);
        while (dot(p, p) > 1.0);
        return p;
    case LR_EMIT_SPHERE_SURFACE:
        return direction(random);
    case LR_EMIT_DISC:
        random.disc(p.x, p.y);
        return p;
    default:
        return p;
    }
}

// Numbers must be finite. Null if valid, else the reason.
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
        return "speed_min to speed_max is not a range within 0 to 1e6 m/s";
    if (!in_range(d.spin_min, 0.0, most_speed) || !in_range(d.spin_max, wide(d.spin_min), most_speed))
        return "spin_min to spin_max is not a range within 0 to 1e6 rad/s";
    if (!in_range(d.scale_min, wide(least_scale), wide(most_scale)) ||
        !in_range(d.scale_max, wide(d.scale_min), wide(most_scale)))
        return "scale_min to scale_max is not a range within 0.001 to 1000";
    if (!in_range(d.rate, 0.0, 1e9)) return "rate is not 0 to 1e9 per second";
    if (d.burst_count != 0 ? !in_range(d.burst_interval, static_cast<double>(1e-4f), 1e9)
                           : !in_range(d.burst_interval, 0.0, 1e9))
        return "burst_interval is not 1e-4 to 1e9 s";
    if (d.burst_count > max_capacity) return "burst_count is over 2^26";
    if (d.reserved != 0) return "reserved is not 0";
    return nullptr;
}
} // namespace

Outcome check(const lr_emitter_desc& d) {
    const bool numbers =
        finite(d.position, d.orientation, d.size, d.body_orientation, d.direction, d.spread, d.speed_min, d.speed_max,
               d.spin_min, d.spin_max, d.scale_min, d.scale_max, d.rate, d.burst_interval);
    return numbers ? invalid(wrong_in(d)) : LR_ERROR_NOT_FINITE;
}

Emitter::Emitter(const lr_emitter_desc& desc)
    : desc_(desc), orientation_(unit(desc.orientation)), pose_(unit(desc.body_orientation)),
      axis_(unit(desc.direction)), across_(right_angles_to(axis_)),
      cone_(one_minus_cosine(std::min(wide(desc.spread), 3.14159265358979))) {}

BodyState Emitter::draw(uint64_t seed, uint32_t noise_seed, uint32_t life) const {
    CounterRandom random(seed, noise_seed, life);
    BodyState out{};
    out.noise_seed = noise_seed;
    const Double3 size = to_double(vector_of(desc_.size)), local = place(random, desc_.shape, size);
    const Double3 at = rotate(orientation_, {size.x * local.x, size.y * local.y, size.z * local.z});
    const Quaternion<double> q = desc_.pose == LR_POSE_RANDOM ? orientation(random) : pose_, to_body = inverse(q);

    double x, y;
    const double s = std::sqrt(random.disc(x, y));
    const double down = random.uniform() * cone_, aside = std::sqrt(down * (2.0 - down)) / s;
    const Double3 way = (1.0 - down) * axis_ + aside * x * across_.first + aside * y * across_.second;
    const Double3 v = random.between(wide(desc_.speed_min), wide(desc_.speed_max)) * way;
    const Double3 about = direction(random);
    const Double3 w = random.between(wide(desc_.spin_min), wide(desc_.spin_max)) * about;

    put(to_float(to_double(vector_of(desc_.position)) + at), out.value + field_x);
    put(to_float(rotate(to_body, v)), out.value + field_vx);
    put(to_float(rotate(to_body, w)), out.value + field_wx);
    put(to_float(q), out.value + field_qx);
    const double scale = random.between(wide(desc_.scale_min), wide(desc_.scale_max));
    out.value[field_scale] = std::clamp(static_cast<float>(scale), desc_.scale_min, desc_.scale_max);
    return out;
}
} // namespace lr
