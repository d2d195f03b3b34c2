// Divergence-free turbulence from a lattice of random eddies, with its gradient, for one vector of positions.
// Each lattice point c carries w(d) (omega x d)/2 of a vector potential, d = x - c in cells, w a product of quintic
// steps; the field is the curl of their sum (docs/reference/wind_and_water.md, "Turbulence").
#if defined(LR_KERNEL_TURBULENCE_FIELD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_TURBULENCE_FIELD_INL_H_
#undef LR_KERNEL_TURBULENCE_FIELD_INL_H_
#else
#define LR_KERNEL_TURBULENCE_FIELD_INL_H_
#endif

#include "kernel/motion-inl.h"
#include "kernel/wind.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

// A velocity, its rate and gradient.
struct Flow {
    Vec3 wind, rate;
    VF gradient[9];
};

// Three words from three, by the mixing of pcg3d (Jarzynski and Olano, JCGT 9(3), 2020).
struct Words {
    VU x, y, z;
};
HWY_INLINE Words mix(Words v, uint32_t seed) {
    const DU du;
    const auto step = [&](VU a) LR_LAMBDA {
        return hn::Add(hn::Mul(a, hn::Set(du, 1664525u)), hn::Set(du, 1013904223u + seed));
    };
    const auto cross_over = [&]() LR_LAMBDA {
        v.x = hn::Add(v.x, hn::Mul(v.y, v.z));
        v.y = hn::Add(v.y, hn::Mul(v.z, v.x));
        v.z = hn::Add(v.z, hn::Mul(v.x, v.y));
    };
    v = {step(v.x), step(v.y), step(v.z)};
    cross_over();
    v.x = hn::Xor(v.x, hn::ShiftRight<16>(v.x));
    v.y = hn::Xor(v.y, hn::ShiftRight<16>(v.y));
    v.z = hn::Xor(v.z, hn::ShiftRight<16>(v.z));
    cross_over();
    return v;
}

// Two numbers, -1 to 1, from the halves of a word.
HWY_INLINE void unit_pair(VU word, VF& a, VF& b) {
    const DU du;
    const DI di;
    const VF unit = constant(2.0f / 65535.0f), one = constant(1.0f);
    a = mul_sub(hn::ConvertTo(DF(), hn::BitCast(di, hn::And(word, hn::Set(du, 0xffffu)))), unit, one);
    b = mul_sub(hn::ConvertTo(DF(), hn::BitCast(di, hn::ShiftRight<16>(word))), unit, one);
}

// The quintic step and its derivatives, one for the lower and one for the upper lattice point.
struct Step {
    VF w[2], first[2], second[2], d[2];
};
HWY_INLINE Step quintic(VF f) {
    const VF one = constant(1.0f), g = hn::Sub(one, f), fg = hn::Mul(f, g);
    const VF cube = hn::Mul(f, hn::Mul(f, f));
    const VF up = hn::Mul(cube, mul_add(f, mul_sub(constant(6.0f), f, constant(15.0f)), constant(10.0f)));
    const VF slope = hn::Mul(constant(30.0f), hn::Mul(fg, fg));
    const VF bend = hn::Mul(constant(60.0f), hn::Mul(fg, hn::Sub(g, f)));
    return {{hn::Sub(one, up), up}, {hn::Neg(slope), slope}, {hn::Neg(bend), bend}, {f, hn::Neg(g)}};
}

// Eddies turn about in 64 beats, each at 32 to 95 of them a period: after that the field repeats itself in time.
HWY_INLINE void eddy(Words h, const SourceInstant& s, Vec3& omega, Vec3& omega_rate) {
    const DU du;
    const DI di;
    Vec3 a, b;
    unit_pair(h.x, a.x, b.x);
    unit_pair(h.y, a.y, b.y);
    unit_pair(h.z, a.z, b.z);
    const VU bits = hn::Xor(h.x, hn::Xor(hn::ShiftRight<8>(h.y), hn::ShiftRight<16>(h.z)));
    const VU beat = hn::Add(hn::And(bits, hn::Set(du, 63u)), hn::Set(du, 32u));
    const VF beats = hn::ConvertTo(DF(), hn::BitCast(di, beat));
    const VF turns = hn::Mul(beats, constant(s.turn));
    VF sine, cosine;
    sin_cos_turn(hn::Sub(turns, hn::ConvertTo(DF(), hn::ConvertTo(di, turns))), sine, cosine);
    omega = add(scale(cosine, a), scale(sine, b));
    omega_rate = scale(hn::Mul(beats, constant(6.2831853f * s.turn_rate)), sub(scale(cosine, b), scale(sine, a)));
}

HWY_INLINE void turbulence(const SourceInstant& s, Vec3 x, Flow& out) {
    const DI di;
    const DU du;
    const VF inverse_cell = constant(s.inverse_spacing[0]);
    const Vec3 ax = broadcast(s.lattice), ay = broadcast(s.lattice + 3), az = broadcast(s.lattice + 6);
    const VF at[3] = {dot(ax, x), dot(ay, x), dot(az, x)};
    VU index[3];
    Step step[3];
    for (int i = 0; i < 3; ++i) {
        // Beyond 2^23 cells single precision has no fraction left; the clamp keeps the index in range.
        VF p = hn::Sub(hn::Mul(at[i], inverse_cell), constant(s.offset[i]));
        p = hn::Min(hn::Max(p, constant(-8388608.0f)), constant(8388608.0f));
        const VF floor = hn::Floor(p);
        index[i] = hn::BitCast(du, hn::Sub(hn::ConvertTo(di, floor), hn::Set(di, s.cell[i])));
        step[i] = quintic(hn::Sub(p, floor));
    }
    const VF zero = hn::Zero(DF()), half = constant(0.5f), strength = constant(s.strength);
    Vec3 wind{zero, zero, zero}, rate{zero, zero, zero};
    VF gradient[9];
    for (VF& g : gradient) g = zero;
    for (int corner = 0; corner < 8; ++corner) {
        const int i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
        const VU one = hn::Set(du, 1u);
        const Words h = mix({i ? hn::Add(index[0], one) : index[0], j ? hn::Add(index[1], one) : index[1],
                             k ? hn::Add(index[2], one) : index[2]},
                            s.seed);
        Vec3 omega, omega_rate;
        eddy(h, s, omega, omega_rate);

        const Step &a = step[0], &b = step[1], &c = step[2];
        const VF bc = hn::Mul(b.w[j], c.w[k]), ac = hn::Mul(a.w[i], c.w[k]), ab = hn::Mul(a.w[i], b.w[j]);
        const Vec3 d{a.d[i], b.d[j], c.d[k]};
        const VF w = hn::Mul(a.w[i], bc);
        const Vec3 g{hn::Mul(a.first[i], bc), hn::Mul(b.first[j], ac), hn::Mul(c.first[k], ab)};
        const VF xx = hn::Mul(a.second[i], bc), yy = hn::Mul(b.second[j], ac), zz = hn::Mul(c.second[k], ab);
        const VF xy = hn::Mul(hn::Mul(a.first[i], b.first[j]), c.w[k]);
        const VF xz = hn::Mul(hn::Mul(a.first[i], c.first[k]), b.w[j]);
        const VF yz = hn::Mul(hn::Mul(b.first[j], c.first[k]), a.w[i]);
        const auto hessian = [&](Vec3 v) LR_LAMBDA {
            return Vec3{mul_add(xx, v.x, mul_add(xy, v.y, hn::Mul(xz, v.z))),
                        mul_add(xy, v.x, mul_add(yy, v.y, hn::Mul(yz, v.z))),
                        mul_add(xz, v.x, mul_add(yz, v.y, hn::Mul(zz, v.z)))};
        };
        // curl (w omega x d)/2 = omega (w + g.d/2) - d (g.omega)/2
        const VF along = mul_add(half, dot(g, d), w);
        const VF q = hn::Mul(half, dot(g, omega));
        wind = add(wind, sub(scale(along, omega), scale(q, d)));
        rate = add(rate, sub(scale(along, omega_rate), scale(hn::Mul(half, dot(g, omega_rate)), d)));
        const Vec3 p = add(scale(constant(1.5f), g), scale(half, hessian(d)));
        const Vec3 r = scale(half, hessian(omega));
        const VF o[3] = {omega.x, omega.y, omega.z}, e[3] = {d.x, d.y, d.z};
        const VF pj[3] = {p.x, p.y, p.z}, rj[3] = {r.x, r.y, r.z};
        for (int m = 0; m < 3; ++m)
            for (int n = 0; n < 3; ++n) {
                VF sum = neg_mul_add(e[m], rj[n], hn::Mul(o[m], pj[n]));
                if (m == n) sum = hn::Sub(sum, q);
                gradient[3 * m + n] = hn::Add(gradient[3 * m + n], sum);
            }
    }
    // Back to the world's axes.
    const auto turned = [&](VF along_x, VF along_y, VF along_z)
                            LR_LAMBDA { return add(scale(along_x, ax), add(scale(along_y, ay), scale(along_z, az))); };
    out.wind = turned(hn::Mul(strength, wind.x), hn::Mul(strength, wind.y), hn::Mul(strength, wind.z));
    out.rate = turned(hn::Mul(strength, rate.x), hn::Mul(strength, rate.y), hn::Mul(strength, rate.z));
    const VF per_cell = hn::Mul(strength, inverse_cell);
    Vec3 row[3]; // of each component along the lattice
    for (int i = 0; i < 3; ++i)
        row[i] = scale(per_cell, turned(gradient[3 * i], gradient[3 * i + 1], gradient[3 * i + 2]));
    const Vec3 to_x = turned(row[0].x, row[1].x, row[2].x), to_y = turned(row[0].y, row[1].y, row[2].y),
               to_z = turned(row[0].z, row[1].z, row[2].z);
    const VF g[9] = {to_x.x, to_y.x, to_z.x, to_x.y, to_y.y, to_z.y, to_x.z, to_y.z, to_z.z};
    for (int i = 0; i < 9; ++i) out.gradient[i] = g[i];
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
