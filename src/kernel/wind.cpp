// Wind at blocks of bodies, compiled once for each instruction set. Sources are the outer loop: their constants are
// broadcast once, and one that is out of reach of the whole block costs a comparison.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/wind.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

#include "hwy/highway.h"
#include "kernel/faults-inl.h"
#include "kernel/rows-inl.h"
#include "kernel/step.h"
#include "kernel/wind-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

// What has left the finite numbers counts as 0, so that it cannot reach a neighbour through the bounds of the block.
HWY_INLINE Vec3 within(Vec3 v, float limit) {
    const VF most = constant(limit);
    const auto keep = [&](VF x) HWY_ATTR { return hn::IfThenElseZero(hn::Le(hn::Abs(x), most), x); };
    return {keep(v.x), keep(v.y), keep(v.z)};
}

void predict(const BatchArrays& a, size_t begin, size_t end, float h, FieldBlock& out) {
    const DF d;
    const auto field = [&](size_t f, size_t at) HWY_ATTR { return hn::Load(d, a.field[f] + at); };
    for (size_t at = begin; at < end; at += hn::Lanes(d)) {
        const Quaternion q{field(field_qx, at), field(field_qy, at), field(field_qz, at), field(field_qw, at)};
        const Vec3 body{field(field_vx, at), field(field_vy, at), field(field_vz, at)};
        const Vec3 v = within(to_world(q, body), 1e7f);
        const Vec3 x{field(field_x, at), field(field_y, at), field(field_z, at)};
        store3(out.velocity, at - begin, v);
        store3(out.position, at - begin, within(add_scaled(x, constant(0.5f * h), v), 1e12f));
    }
}

// The square of the distance of a point from the block's bounds.
float distance_squared(const float point[3], const float low[3], const float high[3]) {
    float sum = 0.0f;
    for (int i = 0; i < 3; ++i) {
        const float below = low[i] - point[i], above = point[i] - high[i];
        const float gap = below > above ? below : above;
        if (gap > 0.0f) sum += gap * gap;
    }
    return sum;
}

HWY_INLINE void begin_block(const FieldInstant& instant, size_t count, FieldBlock& b) {
    const DF d;
    const VF zero = hn::Zero(d);
    const Vec3 none{zero, zero, zero};
    for (size_t at = 0; at < count; at += hn::Lanes(d)) {
        store3(b.wind, at, broadcast(instant.wind));
        store3(b.change, at, broadcast(instant.change));
        store3(b.rate, at, none);
        for (Row& row : b.gradient) hn::Store(zero, d, row + at);
        hn::Store(constant(instant.reference), d, b.reference + at);
    }
}

// The pattern moves as a whole: du/dt at a point is - motion . grad u.
HWY_INLINE Vec3 carried_past(Vec3 motion, const VF g[9]) {
    return {dot(Vec3{g[0], g[1], g[2]}, motion), dot(Vec3{g[3], g[4], g[5]}, motion),
            dot(Vec3{g[6], g[7], g[8]}, motion)};
}

HWY_INLINE void add_ground(const SourceInstant& s, size_t count, FieldBlock& b) {
    const DF d;
    const Vec3 none{hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    for (size_t at = 0; at < count; at += hn::Lanes(d)) {
        Vec3 slopes;
        const VF factor = ground_factor(s, load3(b.position, at), slopes);
        VF lifted[9];
        outer(load3(b.wind, at), slopes, lifted);
        for (int i = 0; i < 9; ++i) {
            const VF before = hn::Load(d, b.gradient[i] + at);
            hn::Store(hn::Add(mul_add(factor, before, lifted[i]), none.x), d, b.gradient[i] + at);
        }
        // Plus zero: no zero is negative, or a source that adds nothing could change a sign.
        store3(b.wind, at, add(scale(factor, load3(b.wind, at)), none));
        store3(b.change, at, add(scale(factor, load3(b.change, at)), none));
        const Vec3 rate = sub(scale(factor, load3(b.rate, at)), carried_past(broadcast(s.motion), lifted));
        store3(b.rate, at, add(rate, none));
    }
}

HWY_INLINE bool flow_of(const SourceInstant& s, Vec3 x, Flow& flow) {
    switch (s.kind) {
    case SourceKind::rankine:
    case SourceKind::lamb_oseen:
        return vortex(s, x, flow);
    case SourceKind::point_blower:
    case SourceKind::line_blower:
        return blower(s, x, flow);
    case SourceKind::grid:
        return grid(s, x, flow);
    case SourceKind::turbulence:
        turbulence(s, x, flow);
        return true;
    case SourceKind::ground:
        break;
    }
    return false;
}

HWY_INLINE void add_source(const SourceInstant& s, size_t count, FieldBlock& b) {
    const DF d;
    const VF zero = hn::Zero(d);
    const Vec3 motion = broadcast(s.motion);
    for (size_t at = 0; at < count; at += hn::Lanes(d)) {
        Flow flow;
        flow.rate = {zero, zero, zero};
        if (!flow_of(s, load3(b.position, at), flow)) continue;
        const VF* const g = flow.gradient;
        for (int i = 0; i < 9; ++i) hn::Store(hn::Add(hn::Load(d, b.gradient[i] + at), g[i]), d, b.gradient[i] + at);
        store3(b.wind, at, add(load3(b.wind, at), flow.wind));
        store3(b.rate, at, add(load3(b.rate, at), sub(flow.rate, carried_past(motion, g))));
    }
}

void evaluate(const FieldInstant& instant, size_t count, FieldBlock& b) {
    const DF d;
    begin_block(instant, count, b);
    float low[3], high[3];
    for (int i = 0; i < 3; ++i) {
        VF least = hn::Load(d, b.position[i]), most = least;
        for (size_t at = 0; at < count; at += hn::Lanes(d)) {
            const VF x = hn::Load(d, b.position[i] + at);
            least = hn::Min(least, x);
            most = hn::Max(most, x);
        }
        low[i] = least_lane(least);
        high[i] = greatest_lane(most);
    }
    // The ground multiplies the uniform wind, before anything is added to it.
    for (uint32_t i = 0; i < instant.source_count; ++i)
        if (instant.sources[i].kind == SourceKind::ground) add_ground(instant.sources[i], count, b);
    for (uint32_t i = 0; i < instant.source_count; ++i) {
        const SourceInstant& s = instant.sources[i];
        if (s.kind == SourceKind::ground) continue;
        if (s.reach > 0.0f && distance_squared(s.center, low, high) > s.reach * s.reach) continue;
        add_source(s, count, b);
    }
}

// The change of the wind along a way at velocity v, over the substep: h (du/dt + v . grad u), held below the speed of
// the field itself. Where a substep crosses more than a gradient's length the product says nothing; without the limit a
// body in a vortex core would gain without bound. For short substeps it is of second order.
HWY_INLINE Vec3 limited_change(const FieldBlock& b, size_t at, VF h, Vec3 v) {
    const DF d;
    const auto row = [&](int i) HWY_ATTR { return hn::Load(d, b.gradient[i] + at); };
    const auto along = [&](int i) HWY_ATTR { return dot(Vec3{row(3 * i), row(3 * i + 1), row(3 * i + 2)}, v); };
    const Vec3 change = scale(h, add(load3(b.rate, at), Vec3{along(0), along(1), along(2)}));
    // 1e-12 m/s and less would square to a denormal; the floor keeps the quotient finite.
    const VF reference = hn::Max(hn::Load(d, b.reference + at), constant(1e-12f));
    const Vec3 ratio = scale(hn::Div(constant(1.0f), reference), change);
    const VF most = hn::Max(hn::Abs(ratio.x), hn::Max(hn::Abs(ratio.y), hn::Abs(ratio.z)));
    // change / sqrt(1 + |change|^2/reference^2), with squares that cannot overflow.
    const VF small = hn::Div(constant(1.0f), hn::Max(most, constant(1.0f)));
    const Vec3 held = scale(small, ratio);
    const VF norm = hn::Sqrt(mul_add(small, small, dot(held, held)));
    return scale(hn::Mul(hn::Div(constant(1.0f), norm), reference), held);
}

void combine(float h, size_t count, const FieldBlock& b, FluidSample& out) {
    const DF d;
    // Steps below a nanosecond do not move anything; their inverse must stay finite.
    const VF half = constant(0.5f), hv = constant(h), rate = constant(1.0f / (h > 1e-9f ? h : 1e-9f));
    for (size_t at = 0; at < count; at += hn::Lanes(d)) {
        const Vec3 wind = load3(b.wind, at), uniform = load3(b.change, at);
        const Vec3 met = add(uniform, limited_change(b, at, hv, load3(b.velocity, at)));
        const Vec3 own = add(uniform, limited_change(b, at, hv, wind));
        const VF half_rate = hn::Mul(half, rate);
        store3(out.wind, at, wind);
        store3(out.half_change, at, scale(half, met));
        store3(out.mean, at, scale(half_rate, add(own, met)));
        store3(out.difference, at, scale(half_rate, sub(own, met)));
        const auto row = [&](int i) HWY_ATTR { return hn::Load(d, b.gradient[i] + at); };
        store3(out.spin, at,
               scale(half, Vec3{hn::Sub(row(7), row(5)), hn::Sub(row(2), row(6)), hn::Sub(row(3), row(1))}));
    }
}

// The substep took the wind's change along the way from the velocity at its beginning. What the mean of both ends makes
// of it is d more: the wind at the end is that much stronger, and -m d has been missing in the momentum.
void settle(const BodyConstants& c, float h, const FieldBlock& b, const FluidSample& sample, const BatchArrays& a,
            size_t begin, size_t end, uint32_t* faults) {
    const DF d;
    const VF half = constant(0.5f), hv = constant(h), mass = constant(0.5f * (1.0f + c.weight));
    const auto field = [&](size_t f, size_t at) HWY_ATTR { return hn::Load(d, a.field[f] + at); };
    const auto store = [&](size_t f, size_t at, Vec3 v) HWY_ATTR {
        hn::Store(without_dust(v.x), d, a.field[f] + at);
        hn::Store(without_dust(v.y), d, a.field[f + 1] + at);
        hn::Store(without_dust(v.z), d, a.field[f + 2] + at);
    };
    for (size_t at = begin; at < end; at += hn::Lanes(d)) {
        const size_t i = at - begin;
        const Quaternion q{field(field_qx, at), field(field_qy, at), field(field_qz, at), field(field_qw, at)};
        const Vec3 v{field(field_vx, at), field(field_vy, at), field(field_vz, at)};
        const Vec3 last = within(to_world(q, v), 1e7f);
        const Vec3 mean = scale(half, add(load3(b.velocity, i), last));
        const Vec3 met = add(load3(b.change, i), limited_change(b, i, hv, mean));
        const Vec3 taken = load3(sample.half_change, i);
        const Vec3 more = to_body(q, sub(met, add(taken, taken)));
        const Vec3 lost = scale(mass, more);
        const Vec3 w{field(field_wx, at), field(field_wy, at), field(field_wz, at)};
        Vec3 settled, turns = w;
        if (c.diagonal) {
            settled = add(v, sub(more, scaled_by(c.inverse_mass, lost)));
        } else {
            const VF zero = hn::Zero(d);
            const Twist t = symmetric6(c.full_inverse, {lost, {zero, zero, zero}});
            const VF length = hn::Mul(field(field_scale, at), constant(c.length));
            settled = add(v, sub(more, t.v));
            turns = sub(w, scale(hn::Div(constant(1.0f), length), t.u));
        }
        const bool all_sane = hn::AllTrue(d, hn::And(sane_motion(settled, turns), not_held(a, at)));
        BodiesBefore before;
        if (HWY_UNLIKELY(!all_sane)) before.take(a, at, hn::Lanes(d));
        store(field_vx, at, settled);
        if (!c.diagonal) store(field_wx, at, turns);
        if (HWY_UNLIKELY(!all_sane)) before.hold(a, at, hn::Lanes(d), 0.0f, false, faults);
    }
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
