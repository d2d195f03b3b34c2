// Vortices, blowers, grids and the ground's boundary layer, for one vector of positions (docs/reference/wind_and_water.md: each formula).
#if defined(LR_KERNEL_WIND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_WIND_INL_H_
#undef LR_KERNEL_WIND_INL_H_
#else
#define LR_KERNEL_WIND_INL_H_
#endif

#include "kernel/motion-inl.h"
#include "kernel/turbulence_field-inl.h"
#include "kernel/wind.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

HWY_INLINE VF clamp_unit(VF t) {
    return hn::Min(hn::Max(t, hn::Zero(DF())), constant(1.0f));
}
// 3 t^2 - 2 t^3 for t held in [0, 1], and its derivative by t, which is 0 outside.
HWY_INLINE VF smooth(VF t, VF& slope) {
    t = clamp_unit(t);
    slope = hn::Mul(constant(6.0f), hn::Mul(t, hn::Sub(constant(1.0f), t)));
    return hn::Mul(hn::Mul(t, t), neg_mul_add(constant(2.0f), t, constant(3.0f)));
}
// A window of the square of a distance over the square of its limit: 1 to a half of the limit, 0 from it on.
HWY_INLINE VF window(VF squared, VF& slope) {
    const VF third = constant(4.0f / 3.0f);
    const VF s = smooth(mul_sub(squared, third, constant(1.0f / 3.0f)), slope);
    slope = hn::Neg(hn::Mul(third, slope));
    return hn::Sub(constant(1.0f), s);
}

// exp(-x), x >= 0; relative error below 2e-7. Zero beyond 87 would be a denormal.
HWY_INLINE VF exp_negative(VF x) {
    const DI di;
    x = hn::Min(x, constant(86.0f));
    const VI n = hn::ConvertTo(di, mul_add(x, constant(1.44269504f), constant(0.5f)));
    const VF nf = hn::ConvertTo(DF(), n);
    const VF r = hn::Add(mul_sub(nf, constant(0.693359375f), x), hn::Mul(nf, constant(-2.12194440e-4f)));
    VF p = constant(1.0f / 720.0f);
    p = mul_add(p, r, constant(1.0f / 120.0f));
    p = mul_add(p, r, constant(1.0f / 24.0f));
    p = mul_add(p, r, constant(1.0f / 6.0f));
    p = mul_add(p, r, constant(0.5f));
    p = mul_add(p, r, constant(1.0f));
    p = mul_add(p, r, constant(1.0f));
    return hn::Mul(p, hn::BitCast(DF(), hn::ShiftLeft<23>(hn::Sub(hn::Set(di, 127), n))));
}

// E(q) = (1 - exp(-q))/q and its derivative. The closed forms cancel for small q.
HWY_INLINE VF lamb_oseen(VF q, VF& slope) {
    const VF e = exp_negative(q);
    const VF safe = hn::Max(q, constant(0.25f));
    const VF far = hn::Div(hn::Sub(constant(1.0f), e), safe);
    const VF far_slope = hn::Div(hn::Sub(e, far), safe);
    VF near = constant(-1.0f / 720.0f);
    near = mul_add(near, q, constant(1.0f / 120.0f));
    near = mul_add(near, q, constant(-1.0f / 24.0f));
    near = mul_add(near, q, constant(1.0f / 6.0f));
    near = mul_add(near, q, constant(-0.5f));
    near = mul_add(near, q, constant(1.0f));
    VF near_slope = constant(1.0f / 840.0f);
    near_slope = mul_add(near_slope, q, constant(-1.0f / 144.0f));
    near_slope = mul_add(near_slope, q, constant(1.0f / 30.0f));
    near_slope = mul_add(near_slope, q, constant(-0.125f));
    near_slope = mul_add(near_slope, q, constant(1.0f / 3.0f));
    near_slope = mul_add(near_slope, q, constant(-0.5f));
    const auto small = hn::Lt(q, constant(0.25f));
    slope = hn::IfThenElse(small, near_slope, far_slope);
    return hn::IfThenElse(small, near, far);
}

HWY_INLINE void outer(Vec3 a, Vec3 b, VF out[9]) {
    const VF l[3] = {a.x, a.y, a.z}, r[3] = {b.x, b.y, b.z};
    for (int i = 0; i < 9; ++i) out[i] = hn::Mul(l[i / 3], r[i % 3]);
}

// u = f (a x d): whatever f is of the distances from and along the axis, free of divergence.
HWY_INLINE bool vortex(const SourceInstant& s, Vec3 x, Flow& out) {
    const Vec3 a = broadcast(s.axis), d = sub(x, broadcast(s.position));
    const VF along = dot(a, d);
    const Vec3 r = sub(d, scale(along, a));
    const VF r2 = dot(r, r);
    const VF limit = hn::Mul(r2, constant(s.inverse_radius_sq));
    const VF ends = hn::Mul(hn::Mul(along, along), constant(s.inverse_length_sq));
    if (hn::AllTrue(DF(), hn::Ge(hn::Max(limit, ends), constant(1.0f)))) return false;

    const float core = 1.0f / (s.core * s.core);
    VF g, slope; // f and df/dr^2 of an endless vortex, over the strength
    if (s.kind == SourceKind::lamb_oseen) {
        g = hn::Mul(lamb_oseen(hn::Mul(r2, constant(core)), slope), constant(core));
        slope = hn::Mul(slope, constant(core * core));
    } else {
        g = hn::Div(constant(1.0f), hn::Max(r2, constant(s.core * s.core)));
        slope = hn::IfThenElseZero(hn::Gt(r2, constant(s.core * s.core)), hn::Neg(hn::Mul(g, g)));
    }
    VF by_radius, by_length;
    const VF wr = window(limit, by_radius), wl = window(ends, by_length);
    const VF k = constant(s.strength), w = hn::Mul(wr, wl);
    const VF f = hn::Mul(k, hn::Mul(g, w));
    const VF inner = hn::Mul(hn::Mul(g, wl), hn::Mul(by_radius, constant(s.inverse_radius_sq)));
    const VF df_dr2 = hn::Mul(k, mul_add(slope, w, inner));
    const VF df_dz2 = hn::Mul(k, hn::Mul(hn::Mul(g, wr), hn::Mul(by_length, constant(s.inverse_length_sq))));
    const Vec3 slopes = add(scale(hn::Add(df_dr2, df_dr2), r), scale(hn::Mul(hn::Add(df_dz2, df_dz2), along), a));
    const Vec3 turned = cross(a, r);
    out.wind = scale(f, turned);
    outer(turned, slopes, out.gradient);
    // f times the matrix of a x.
    const Vec3 fa = scale(f, a);
    out.gradient[1] = hn::Sub(out.gradient[1], fa.z);
    out.gradient[2] = hn::Add(out.gradient[2], fa.y);
    out.gradient[3] = hn::Add(out.gradient[3], fa.z);
    out.gradient[5] = hn::Sub(out.gradient[5], fa.x);
    out.gradient[6] = hn::Sub(out.gradient[6], fa.y);
    out.gradient[7] = hn::Add(out.gradient[7], fa.x);
    return true;
}

// A turbulent jet: Gaussian across, b = b0 + spread z wide, its momentum kept along the way.
HWY_INLINE bool blower(const SourceInstant& s, Vec3 x, Flow& out) {
    const bool line = s.kind == SourceKind::line_blower;
    const VF zero = hn::Zero(DF()), one = constant(1.0f);
    const Vec3 a = broadcast(s.axis), side = broadcast(s.side), d = sub(x, broadcast(s.position));
    const VF z = dot(a, d);
    const VF y = dot(side, d);
    Vec3 r = sub(d, scale(z, a));
    if (line) r = sub(r, scale(y, side));
    const VF r2 = dot(r, r);
    const auto ahead = hn::Gt(z, zero);
    const VF b = mul_add(constant(s.spread), hn::Max(z, zero), constant(s.core));
    const VF inverse = hn::Div(one, b), inverse2 = hn::Mul(inverse, inverse);
    const VF q = hn::Mul(r2, inverse2);
    VF inside_slope, range_slope, end_slope = zero;
    const VF core = constant(1.0f / s.core);
    const VF mouth = smooth(mul_add(z, core, one), inside_slope);
    const VF tail = hn::Sub(one, smooth(mul_sub(z, constant(2.0f / s.range), one), range_slope));
    VF ends = one;
    if (line) ends = hn::Sub(one, smooth(hn::Mul(hn::Sub(hn::Abs(y), constant(s.half_length)), core), end_slope));
    const VF lit = hn::Mul(hn::Mul(mouth, tail), ends);
    // exp(-16) is under what single precision adds to the speed at the nozzle.
    const auto in = hn::And(hn::Gt(lit, zero), hn::Lt(q, constant(16.0f)));
    if (hn::AllFalse(DF(), in)) return false;

    VF decay = hn::Mul(constant(s.core), inverse);
    if (line) decay = hn::Sqrt(decay);
    const VF jet = hn::IfThenElseZero(in, hn::Mul(constant(s.strength), hn::Mul(decay, exp_negative(q))));
    const VF speed = hn::Mul(jet, lit);
    const VF widening = hn::IfThenElseZero(ahead, hn::Mul(constant(s.spread), inverse));
    const VF power = constant(line ? -0.5f : -1.0f);
    const VF by_width = hn::Mul(hn::Mul(speed, widening), mul_add(constant(2.0f), q, power));
    const VF by_mouth = hn::Mul(hn::Mul(inside_slope, core), hn::Mul(tail, ends));
    const VF by_tail = hn::Mul(hn::Mul(range_slope, constant(2.0f / s.range)), hn::Mul(mouth, ends));
    const VF by_z = mul_add(jet, hn::Sub(by_mouth, by_tail), by_width);
    Vec3 slopes = add(scale(by_z, a), scale(hn::Mul(constant(-2.0f), hn::Mul(speed, inverse2)), r));
    if (line) {
        const VF outwards = hn::Mul(hn::Mul(end_slope, core), hn::Mul(mouth, tail));
        const VF by_y = hn::Mul(jet, hn::IfThenElse(hn::Lt(y, zero), outwards, hn::Neg(outwards)));
        slopes = add(slopes, scale(by_y, side));
    }
    out.wind = scale(speed, a);
    outer(a, slopes, out.gradient);
    return true;
}

// Trilinear in space, linear between two frames.
HWY_INLINE bool grid(const SourceInstant& s, Vec3 x, Flow& out) {
    const DI di;
    const VF zero = hn::Zero(DF());
    const Vec3 d = sub(x, broadcast(s.position));
    const VF at[3] = {d.x, d.y, d.z};
    VF part[3], slope[3];
    VI low[3], high[3];
    auto in = hn::Eq(zero, zero);
    for (int i = 0; i < 3; ++i) {
        const float samples = static_cast<float>(s.count[i]);
        VF p = hn::Mul(at[i], constant(s.inverse_spacing[i]));
        slope[i] = constant(s.inverse_spacing[i]);
        const VF last = constant(samples - 1.0f);
        if (s.outside == outside_repeat) {
            p = neg_mul_add(hn::Floor(hn::Mul(p, constant(1.0f / samples))), constant(samples), p);
            p = hn::Max(p, zero); // rounding may have gone past either end
        } else {
            const auto inside = hn::And(hn::Ge(p, zero), hn::Le(p, last));
            if (s.outside == outside_zero) in = hn::And(in, inside);
            slope[i] = hn::IfThenElseZero(inside, slope[i]);
            p = hn::Min(hn::Max(p, zero), last);
        }
        const VI top = hn::Set(di, s.count[i] - 1);
        low[i] = hn::Max(hn::Min(hn::ConvertTo(di, p), top), hn::Zero(di));
        part[i] = clamp_unit(hn::Sub(p, hn::ConvertTo(DF(), low[i])));
        const VI next = hn::Add(low[i], hn::Set(di, 1));
        const VI beyond = s.outside == outside_repeat ? hn::Zero(di) : top;
        high[i] = hn::IfThenElse(hn::Gt(next, top), beyond, next);
        if (s.count[i] == 1) slope[i] = zero;
    }
    if (hn::AllFalse(DF(), in)) return false;
    const VI nx = hn::Set(di, s.count[0]), ny = hn::Set(di, s.count[1]), three = hn::Set(di, 3);
    VI corner[8];
    for (int i = 0; i < 8; ++i) {
        const VI row = hn::Add(hn::Mul(i & 4 ? high[2] : low[2], ny), i & 2 ? high[1] : low[1]);
        corner[i] = hn::Mul(hn::Add(hn::Mul(row, nx), i & 1 ? high[0] : low[0]), three);
    }
    const auto between = [&](VF a, VF b, VF t) LR_LAMBDA { return mul_add(t, hn::Sub(b, a), a); };
    VF wind[3], rate[3];
    for (int k = 0; k < 3; ++k) {
        VF value[8];
        rate[k] = zero;
        for (int i = 0; i < 8; ++i) value[i] = hn::GatherIndex(DF(), s.frame[0] + k, corner[i]);
        const auto across = [&](const VF v[8], VF line[4], VF plane[2]) LR_LAMBDA {
            for (int i = 0; i < 4; ++i) line[i] = between(v[2 * i], v[2 * i + 1], part[0]);
            for (int i = 0; i < 2; ++i) plane[i] = between(line[2 * i], line[2 * i + 1], part[1]);
            return between(plane[0], plane[1], part[2]);
        };
        VF line[4], plane[2];
        if (s.frame[1] != s.frame[0]) {
            VF later[8], change[8];
            for (int i = 0; i < 8; ++i) {
                later[i] = hn::GatherIndex(DF(), s.frame[1] + k, corner[i]);
                change[i] = hn::Sub(later[i], value[i]);
                value[i] = between(value[i], later[i], constant(s.part));
            }
            rate[k] = hn::Mul(across(change, line, plane), constant(s.part_rate));
        }
        wind[k] = across(value, line, plane);
        const VF dx0 = between(hn::Sub(value[1], value[0]), hn::Sub(value[3], value[2]), part[1]);
        const VF dx1 = between(hn::Sub(value[5], value[4]), hn::Sub(value[7], value[6]), part[1]);
        const VF dy = between(hn::Sub(line[1], line[0]), hn::Sub(line[3], line[2]), part[2]);
        out.gradient[3 * k] = hn::IfThenElseZero(in, hn::Mul(slope[0], between(dx0, dx1, part[2])));
        out.gradient[3 * k + 1] = hn::IfThenElseZero(in, hn::Mul(slope[1], dy));
        out.gradient[3 * k + 2] = hn::IfThenElseZero(in, hn::Mul(slope[2], hn::Sub(plane[1], plane[0])));
        wind[k] = hn::IfThenElseZero(in, wind[k]);
        rate[k] = hn::IfThenElseZero(in, rate[k]);
    }
    out.wind = {wind[0], wind[1], wind[2]};
    out.rate = {rate[0], rate[1], rate[2]};
    return true;
}

// Logarithmic profile over a plane, ln(1 + z/z0)/ln(1 + z_ref/z0): what the uniform wind is multiplied by.
HWY_INLINE VF ground_factor(const SourceInstant& s, Vec3 x, Vec3& slopes) {
    const VF one = constant(1.0f), zero = hn::Zero(DF());
    const Vec3 n = broadcast(s.axis);
    const VF z = dot(n, sub(x, broadcast(s.position)));
    const VF inverse = constant(s.inverse_roughness), scale_log = constant(s.inverse_log);
    const VF below = hn::Div(one, mul_add(hn::Max(z, zero), inverse, one));
    slopes = scale(hn::IfThenElseZero(hn::Gt(z, zero), hn::Mul(hn::Mul(inverse, below), scale_log)), n);
    return hn::Mul(hn::Sub(zero, log_unit(hn::Max(below, constant(1e-30f)))), scale_log);
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
