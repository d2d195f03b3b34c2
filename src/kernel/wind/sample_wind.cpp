// Wind at blocks of bodies, compiled once for each instruction set. Formulas: docs/reference/wind_and_water.md.
#ifndef LR_NO_PAIRS
#define LR_NO_PAIRS // sums at one vector of places fill the registers
#endif
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/wind/sample_wind.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

#include "hwy/highway.h"
#include "kernel/integrator/equations_of_motion-inl.h"
#include "kernel/integrator/step.h"
#include "kernel/wind/sample_wind.h"
#include "langevin_rigid.h"

#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

struct Flow {
    Vec3 wind, rate;
    Matrix gradient;
};

// Divergence-free turbulence with its gradient: eddies w(t) a at the points of a body-centred lattice, of which a place feels those at the corners of
// its tetrahedron (Perlin's simplex noise): u = curl(f(|d|^2) a x d)/2, d from the point in cells.

// Well mixed bits: lowbias32 (Wellons, "hash prospector").
HWY_INLINE VU mix(VU v) {
    const DU du;
    v = hn::Xor(v, hn::ShiftRight<16>(v)) * hn::Set(du, 0x7feb352du);
    v = hn::Xor(v, hn::ShiftRight<15>(v)) * hn::Set(du, 0x846ca68bu);
    return hn::Xor(v, hn::ShiftRight<16>(v));
}
// A number of [2^n, 2^(n + 1)) for bits of 2^n, from the low 23 bits of a word.
HWY_INLINE VF mantissa(VU word, uint32_t bits) {
    const DU du;
    return hn::BitCast(DF(), hn::Or(hn::And(word, hn::Set(du, 0x007fffffu)), hn::Set(du, bits)));
}

// Each eddy keeps its axis and swings by two parabolas, 32 to 95 times as fast as the slowest beat: the field repeats with the period of that beat.
HWY_INLINE void add_eddy(const SourceInstant& s, VU word, Vec3 d, Flow& sum) {
    const DU du;
    const DI di;
    const VF one = constant(1.0f), two = constant(2.0f), three = constant(3.0f), zero = hn::Zero(DF());
    const VU h = mix(word), g = h * hn::Set(du, 0x9e3779b1u);
    const Vec3 a{mantissa(hn::ShiftRight<9>(h), 0x40000000u) - three, mantissa(h, 0x40000000u) - three,
                 mantissa(hn::ShiftRight<9>(g), 0x40000000u) - three};
    const VU beat = hn::And(hn::ShiftRight<12>(g), hn::Set(du, 63u)) + hn::Set(du, 32u);
    const VF beats = hn::ConvertTo(DF(), hn::BitCast(di, beat));
    const VF turns = beats * constant(s.turn) + mantissa(g, 0x3f800000u);
    const VF t = two * (turns - hn::Floor(turns)) - one, down = one - hn::Abs(t);
    const VF swing = t * down, swing_rate = beats * constant(2.0f * s.turn_rate) * (down + down - one);

    // With z = 2 |d|^2 and f = (1 - z)^3 (1 + 3 z): u = p a + q (d.a) d.
    const VF z = two * dot(d, d), left = hn::Max(one - z, zero), left2 = left * left;
    const VF p = left2 * ((two - constant(15.0f) * z) * z + one), z24 = constant(24.0f) * z, q = z24 * left2;
    const VF along = dot(d, a);
    const Vec3 u = p * a + (q * along) * d;
    sum.wind += swing * u;
    sum.rate += swing_rate * u;
    // The gradients of p and q are 4 dp/dz d and 4 dq/dz d.
    const VF slope = swing * left;
    const VF by_p = slope * (z24 + z24) * (constant(5.0f) * z - three);
    const VF by_q = slope * constant(96.0f) * (one - three * z) * along;
    const VF turning = swing * q, stretch = turning * along;
    Matrix m = outer(by_p * a + by_q * d, d) + outer(d, turning * a);
    m.row[0].x += stretch, m.row[1].y += stretch, m.row[2].z += stretch;
    sum.gradient = sum.gradient + m;
}

HWY_INLINE void turbulence(const SourceInstant& s, Vec3 x, Flow& out) {
    const DI di;
    const DU du;
    const Vec3 along_lattice = rows(s.lattice, x), none = zero3();
    const VF at[3] = {along_lattice.x, along_lattice.y, along_lattice.z};
    constexpr uint32_t prime[3] = {0x9e3779b1u, 0x85ebca77u, 0xc2b2ae3du};
    VU low[3], high[3];
    VF part[3];
    for (int i = 0; i < 3; ++i) {
        // Beyond 2^23 cells single precision has no fraction left; the clamp keeps the index in range.
        VF p = at[i] - constant(s.offset[i]);
        p = hn::Min(hn::Max(p, constant(-8388608.0f)), constant(8388608.0f));
        const VF floor = hn::Floor(p);
        part[i] = p - floor;
        const VU index = hn::BitCast(du, hn::ConvertTo(di, floor) - hn::Set(di, s.cell[i]));
        const auto word = [&](VU v) LR_LAMBDA { return hn::Xor(v, hn::ShiftRight<15>(v)); };
        low[i] = word(index * hn::Set(du, prime[i]));
        high[i] = word((index + hn::Set(du, 1u)) * hn::Set(du, prime[i]));
    }
    // The tetrahedron's corners lie from the lower to the upper point, along the axes in order of their parts.
    const auto xy = part[0] >= part[1], yz = part[1] >= part[2], xz = part[0] >= part[2];
    const auto first_x = hn::And(xy, xz), first_y = hn::And(hn::Not(xy), yz);
    const auto last_z = hn::And(xz, yz), last_y = hn::And(xy, hn::Not(yz));
    const auto choose = [](auto mask, VU yes, VU no)
                            LR_LAMBDA { return hn::IfThenElse(hn::RebindMask(DU(), mask), yes, no); };
    const VU difference[3] = {high[0] - low[0], high[1] - low[1], high[2] - low[2]};
    const VU first = choose(first_x, difference[0], choose(first_y, difference[1], difference[2]));
    const VU last = choose(last_z, difference[2], choose(last_y, difference[1], difference[0]));
    const VU lower = low[0] + (low[1] + (low[2] + hn::Set(du, s.seed))),
             upper = high[0] + (high[1] + (high[2] + hn::Set(du, s.seed)));
    const float* const b = s.basis;
    const Vec3 side[3] = {{constant(b[0]), constant(b[3]), constant(b[6])},
                          {constant(b[1]), constant(b[4]), constant(b[7])},
                          {constant(b[2]), constant(b[5]), constant(b[8])}};
    const Vec3 d = rows(b, {part[0], part[1], part[2]}), across = d - (side[0] + (side[1] + side[2]));
    out = {none, none, {{none, none, none}}};
    add_eddy(s, lower, d, out);
    add_eddy(s, lower + first, d - select(first_x, side[0], select(first_y, side[1], side[2])), out);
    add_eddy(s, upper - last, across + select(last_z, side[2], select(last_y, side[1], side[0])), out);
    add_eddy(s, upper, across, out);
    const VF strength = constant(s.strength);
    out.wind = strength * out.wind;
    out.rate = strength * out.rate;
    out.gradient = strength * constant(s.inverse_spacing[0]) * out.gradient;
}

HWY_INLINE VF clamp_unit(VF t) {
    return hn::Min(hn::Max(t, hn::Zero(DF())), constant(1.0f));
}
// 3 t^2 - 2 t^3 for t clamped to [0, 1], and its derivative by t, which is 0 outside.
HWY_INLINE VF smooth(VF t, VF& slope) {
    t = clamp_unit(t);
    slope = constant(6.0f) * (t * (constant(1.0f) - t));
    return t * t * (constant(3.0f) - constant(2.0f) * t);
}
// A window of squared distance over squared limit: 1 up to half of the limit, 0 beyond it.
HWY_INLINE VF window(VF squared, VF& slope) {
    const VF third = constant(4.0f / 3.0f);
    const VF s = smooth(squared * third - constant(1.0f / 3.0f), slope);
    slope = -(third * slope);
    return constant(1.0f) - s;
}

// exp(-x), x >= 0; relative error below 2e-7. Zero beyond 87 would be a denormal.
HWY_INLINE VF exp_negative(VF x) {
    const DI di;
    x = hn::Min(x, constant(86.0f));
    const VI n = hn::ConvertTo(di, x * constant(1.44269504f) + constant(0.5f));
    const VF nf = hn::ConvertTo(DF(), n);
    const VF r = nf * constant(0.693359375f) - x + nf * constant(-2.12194440e-4f);
    const VF p = polynomial({1.0f / 720.0f, 1.0f / 120.0f, 1.0f / 24.0f, 1.0f / 6.0f, 0.5f, 1.0f, 1.0f}, r);
    return p * hn::BitCast(DF(), hn::ShiftLeft<23>(hn::Set(di, 127) - n));
}

// E(q) = (1 - exp(-q))/q and its derivative. The closed forms cancel for small q.
HWY_INLINE VF lamb_oseen(VF q, VF& slope) {
    const VF e = exp_negative(q);
    const VF inverse = constant(1.0f) / hn::Max(q, constant(0.25f));
    const VF far = (constant(1.0f) - e) * inverse;
    const VF far_slope = (e - far) * inverse;
    const VF near = polynomial({-1.0f / 720.0f, 1.0f / 120.0f, -1.0f / 24.0f, 1.0f / 6.0f, -0.5f, 1.0f}, q);
    const VF near_slope = polynomial({1.0f / 840.0f, -1.0f / 144.0f, 1.0f / 30.0f, -0.125f, 1.0f / 3.0f, -0.5f}, q);
    const auto small = q < constant(0.25f);
    slope = hn::IfThenElse(small, near_slope, far_slope);
    return hn::IfThenElse(small, near, far);
}

// u = f (a x d) is free of divergence for any f of the distances from and along the axis.
HWY_INLINE bool vortex(const SourceInstant& s, Vec3 x, Flow& out) {
    const Vec3 a = broadcast(s.axis), d = x - broadcast(s.position);
    const VF along = dot(a, d);
    const Vec3 r = d - along * a;
    const VF r2 = dot(r, r);
    const VF limit = r2 * constant(s.inverse_radius_sq);
    const VF ends = along * along * constant(s.inverse_length_sq);
    if (hn::AllTrue(DF(), hn::Max(limit, ends) >= constant(1.0f))) return false;

    const float core = 1.0f / (s.core * s.core);
    VF g, slope; // f and df/dr^2 of an endless vortex, over the strength
    if (s.kind == SourceInstant::lamb_oseen) {
        g = lamb_oseen(r2 * constant(core), slope) * constant(core);
        slope *= constant(core * core);
    } else {
        g = constant(1.0f) / hn::Max(r2, constant(s.core * s.core));
        slope = hn::IfThenElseZero(r2 > constant(s.core * s.core), -(g * g));
    }
    VF by_radius, by_length;
    const VF wr = window(limit, by_radius), wl = window(ends, by_length);
    const VF k = constant(s.strength), w = wr * wl;
    const VF f = k * (g * w);
    const VF inner = g * wl * (by_radius * constant(s.inverse_radius_sq));
    const VF df_dr2 = k * (slope * w + inner);
    const VF df_dz2 = k * (g * wr * (by_length * constant(s.inverse_length_sq)));
    const Vec3 slopes = (df_dr2 + df_dr2) * r + (df_dz2 + df_dz2) * along * a;
    const Vec3 turned = cross(a, r);
    out.wind = f * turned;
    out.gradient = outer(turned, slopes);
    // f times the matrix of a x.
    const Vec3 fa = f * a;
    Vec3(&row)[3] = out.gradient.row;
    row[0].y -= fa.z, row[0].z += fa.y;
    row[1].x += fa.z, row[1].z -= fa.x;
    row[2].x -= fa.y, row[2].y += fa.x;
    return true;
}

// A turbulent jet: Gaussian across, b = b0 + spread z wide, with constant momentum along the axis.
HWY_INLINE bool blower(const SourceInstant& s, Vec3 x, Flow& out) {
    const bool line = s.kind == SourceInstant::line_blower;
    const VF zero = hn::Zero(DF()), one = constant(1.0f);
    const Vec3 a = broadcast(s.axis), side = broadcast(s.side), d = x - broadcast(s.position);
    const VF z = dot(a, d);
    const VF y = dot(side, d);
    Vec3 r = d - z * a;
    if (line) r -= y * side;
    const VF r2 = dot(r, r);
    const auto ahead = z > zero;
    const VF b = constant(s.spread) * hn::Max(z, zero) + constant(s.core);
    const VF inverse = one / b, inverse2 = inverse * inverse;
    const VF q = r2 * inverse2;
    VF inside_slope, range_slope, end_slope = zero;
    const VF core = constant(1.0f / s.core);
    const VF mouth = smooth(z * core + one, inside_slope);
    const VF tail = one - smooth(z * constant(2.0f / s.range) - one, range_slope);
    VF ends = one;
    if (line) ends = one - smooth((hn::Abs(y) - constant(s.half_length)) * core, end_slope);
    const VF lit = mouth * tail * ends;
    // exp(-16) of the speed at the nozzle is below single precision.
    const auto in = hn::And(lit > zero, q < constant(16.0f));
    if (hn::AllFalse(DF(), in)) return false;

    VF decay = constant(s.core) * inverse;
    if (line) decay = hn::Sqrt(decay);
    const VF jet = hn::IfThenElseZero(in, constant(s.strength) * (decay * exp_negative(q)));
    const VF speed = jet * lit;
    const VF widening = hn::IfThenElseZero(ahead, constant(s.spread) * inverse);
    const VF power = constant(line ? -0.5f : -1.0f);
    const VF by_width = speed * widening * (constant(2.0f) * q + power);
    const VF by_mouth = inside_slope * core * (tail * ends);
    const VF by_tail = range_slope * constant(2.0f / s.range) * (mouth * ends);
    const VF by_z = jet * (by_mouth - by_tail) + by_width;
    Vec3 slopes = by_z * a + constant(-2.0f) * (speed * inverse2) * r;
    if (line) {
        const VF outwards = end_slope * core * (mouth * tail);
        const VF by_y = jet * hn::IfThenElse(y < zero, outwards, -outwards);
        slopes += by_y * side;
    }
    out.wind = speed * a;
    out.gradient = outer(a, slopes);
    return true;
}

// Trilinear in space, linear between two frames.
HWY_INLINE bool grid(const SourceInstant& s, Vec3 x, Flow& out) {
    const DI di;
    const VF zero = hn::Zero(DF());
    const Vec3 d = x - broadcast(s.position);
    const VF at[3] = {d.x, d.y, d.z};
    VF part[3], slope[3];
    VI low[3], high[3];
    auto in = hn::Eq(zero, zero);
    for (int i = 0; i < 3; ++i) {
        const float samples = static_cast<float>(s.count[i]);
        VF p = at[i] * constant(s.inverse_spacing[i]);
        slope[i] = constant(s.inverse_spacing[i]);
        const VF last = constant(samples - 1.0f);
        if (s.outside == LR_WIND_OUTSIDE_REPEAT) {
            p -= hn::Floor(p * constant(1.0f / samples)) * constant(samples);
            p = hn::Max(p, zero); // rounding can pass either end
        } else {
            const auto inside = hn::And(p >= zero, p <= last);
            if (s.outside == LR_WIND_OUTSIDE_ZERO) in = hn::And(in, inside);
            slope[i] = hn::IfThenElseZero(inside, slope[i]);
            p = hn::Min(hn::Max(p, zero), last);
        }
        const VI top = hn::Set(di, s.count[i] - 1);
        low[i] = hn::Max(hn::Min(hn::ConvertTo(di, p), top), hn::Zero(di));
        part[i] = clamp_unit(p - hn::ConvertTo(DF(), low[i]));
        const VI next = low[i] + hn::Set(di, 1);
        const VI beyond = s.outside == LR_WIND_OUTSIDE_REPEAT ? hn::Zero(di) : top;
        high[i] = hn::IfThenElse(next > top, beyond, next);
        if (s.count[i] == 1) slope[i] = zero;
    }
    if (hn::AllFalse(DF(), in)) return false;
    const VI nx = hn::Set(di, s.count[0]), ny = hn::Set(di, s.count[1]), three = hn::Set(di, 3);
    VI corner[8];
    for (int i = 0; i < 8; ++i) {
        const VI row = (i & 4 ? high[2] : low[2]) * ny + (i & 2 ? high[1] : low[1]);
        corner[i] = (row * nx + (i & 1 ? high[0] : low[0])) * three;
    }
    // Whole samples of four floats (the last is not used), transposed: quicker than three gathers.
    constexpr size_t most_lanes = HWY_MAX_BYTES / sizeof(float);
    const bool two = s.frame[1] != s.frame[0];
    alignas(64) float sample[2][8][4 * most_lanes];
    for (int i = 0; i < 8; ++i) {
        alignas(64) int32_t from[most_lanes];
        hn::Store(corner[i], di, from);
        for (size_t lane = 0; lane < hn::Lanes(di); ++lane)
            for (int f = 0; f < 1 + two; ++f)
                std::memcpy(sample[f][i] + 4 * lane, s.frame[f] + from[lane], 4 * sizeof(float));
    }
    const auto between = [&](VF a, VF b, VF t) LR_LAMBDA { return t * (b - a) + a; };
    VF value[3][8], change[3][8], unused;
    for (int i = 0; i < 8; ++i) {
        hn::LoadInterleaved4(DF(), sample[0][i], value[0][i], value[1][i], value[2][i], unused);
        if (!two) continue;
        VF later[3];
        hn::LoadInterleaved4(DF(), sample[1][i], later[0], later[1], later[2], unused);
        for (int k = 0; k < 3; ++k) {
            change[k][i] = later[k] - value[k][i];
            value[k][i] = constant(s.part) * change[k][i] + value[k][i];
        }
    }
    VF wind[3], rate[3];
    for (int k = 0; k < 3; ++k) {
        const auto across = [&](const VF v[8], VF line[4], VF plane[2]) LR_LAMBDA {
            for (int i = 0; i < 4; ++i) line[i] = between(v[2 * i], v[2 * i + 1], part[0]);
            for (int i = 0; i < 2; ++i) plane[i] = between(line[2 * i], line[2 * i + 1], part[1]);
            return between(plane[0], plane[1], part[2]);
        };
        VF line[4], plane[2];
        rate[k] = zero;
        if (two) rate[k] = across(change[k], line, plane) * constant(s.part_rate);
        const VF(&v)[8] = value[k];
        wind[k] = across(v, line, plane);
        const VF dx0 = between(v[1] - v[0], v[3] - v[2], part[1]);
        const VF dx1 = between(v[5] - v[4], v[7] - v[6], part[1]);
        const VF dy = between(line[1] - line[0], line[3] - line[2], part[2]);
        out.gradient.row[k] = {hn::IfThenElseZero(in, slope[0] * between(dx0, dx1, part[2])),
                               hn::IfThenElseZero(in, slope[1] * dy),
                               hn::IfThenElseZero(in, slope[2] * (plane[1] - plane[0]))};
        wind[k] = hn::IfThenElseZero(in, wind[k]);
        rate[k] = hn::IfThenElseZero(in, rate[k]);
    }
    out.wind = {wind[0], wind[1], wind[2]};
    out.rate = {rate[0], rate[1], rate[2]};
    return true;
}

// Logarithmic profile over a plane, ln(1 + z/z0)/ln(1 + z_ref/z0): the factor of the uniform wind.
HWY_INLINE VF ground_factor(const SourceInstant& s, Vec3 x, Vec3& slopes) {
    const VF one = constant(1.0f), zero = hn::Zero(DF());
    const Vec3 n = broadcast(s.axis);
    const VF z = dot(n, x - broadcast(s.position));
    const VF inverse = constant(s.inverse_roughness), scale_log = constant(s.inverse_log);
    const VF below = one / (hn::Max(z, zero) * inverse + one);
    slopes = hn::IfThenElseZero(z > zero, inverse * below * scale_log) * n;
    return (zero - log_unit(hn::Max(below, constant(1e-30f)))) * scale_log;
}

HWY_INLINE bool flow_of(const SourceInstant& s, Vec3 x, Flow& flow) {
    switch (s.kind) {
    case SourceInstant::rankine:
    case SourceInstant::lamb_oseen:
        return vortex(s, x, flow);
    case SourceInstant::point_blower:
    case SourceInstant::line_blower:
        return blower(s, x, flow);
    case SourceInstant::grid:
        return grid(s, x, flow);
    case SourceInstant::turbulence:
        turbulence(s, x, flow);
        return true;
    default:
        return false;
    }
}

// The sums at one vector of places.
struct Sum {
    Vec3 wind, change, rate;
    Matrix gradient;
    VF grounds; // product of their factors
};

// The ground multiplies the uniform wind, before anything is added to it.
HWY_INLINE void put_ground(const SourceInstant& s, Vec3 x, Sum& sum) {
    const Vec3 none = zero3();
    Vec3 slopes;
    VF factor = ground_factor(s, x, slopes);
    // 64 grounds far below would overflow; one makes no more than 47.
    factor = hn::IfThenElse(sum.grounds > constant(40.0f), hn::Min(factor, constant(1.0f)), factor);
    sum.grounds *= factor;
    const Matrix lifted = outer(sum.wind, slopes);
    // Plus zero: removes negative zeros, or a source that adds nothing could change a sign.
    sum.gradient = factor * sum.gradient + lifted + Matrix{{none, none, none}};
    sum.wind = factor * sum.wind + none;
    sum.change = factor * sum.change + none;
    // The pattern moves as a whole: du/dt at a point is - motion . grad u.
    sum.rate = factor * sum.rate - lifted * broadcast(s.motion) + none;
}

HWY_INLINE bool out_of_reach(const SourceInstant& s, Vec3 x) {
    const Vec3 d = x - broadcast(s.center);
    return s.reach > 0.0f && hn::AllTrue(DF(), dot(d, d) > constant(s.reach * s.reach));
}

void evaluate(const FieldInstant& instant, size_t count, FieldBlock* blocks) {
    const SourceInstant* const end = instant.sources + instant.source_count;
    for (size_t i = 0; i < count; i += hn::Lanes(DF())) {
        FieldBlock& b = blocks[i / lane_block];
        const size_t at = i % lane_block;
        const Vec3 x = load3(b.position, at), none = zero3();
        Sum sum{broadcast(instant.wind), broadcast(instant.change), none, {{none, none, none}}, constant(1.0f)};
        for (const SourceInstant* s = instant.sources; s != end; ++s)
            if (s->kind == SourceInstant::ground) put_ground(*s, x, sum);
        for (const SourceInstant* s = instant.sources; s != end; ++s) {
            Flow flow;
            flow.rate = none;
            if (s->kind == SourceInstant::ground || out_of_reach(*s, x) || !flow_of(*s, x, flow)) continue;
            sum.gradient = sum.gradient + flow.gradient;
            sum.wind += flow.wind;
            sum.rate += flow.rate - flow.gradient * broadcast(s->motion);
        }
        store3(b.wind, at, sum.wind);
        store3(b.change, at, sum.change);
        store3(b.rate, at, sum.rate);
        store_matrix(b.gradient, at, sum.gradient);
        store1(b.reference, at, constant(instant.reference));
    }
}

// The place in the middle of a substep, and the velocity. v: body axes.
HWY_INLINE void store_place(Vec3 x, Quaternion q, Vec3 v, float h, size_t lane, FieldBlock& b) {
    const Vec3 velocity = within(to_world(q, v), 1e7f);
    store3(b.velocity, lane, velocity);
    store3(b.position, lane, within(x + constant(0.5f * h) * velocity, 1e12f));
}

void predict(const BatchArrays& a, size_t begin, size_t end, float h, FieldBlock* out) {
    for (size_t at = begin; at < end; at += hn::Lanes(DF()))
        store_place(load3(a, field_x, at), load4(a, at), load3(a, field_vx, at), h, (at - begin) % lane_block,
                    out[(at - begin) / lane_block]);
}

// The change of the wind along a path at velocity v over the substep, h (du/dt + v . grad u).
HWY_INLINE Vec3 change_along(const FieldBlock& b, size_t lane, float h, Vec3 v) {
    return constant(h) * (load3(b.rate, lane) + load_matrix(b.gradient, lane) * v);
}
// Holds changes below the speed of the field. If a substep crosses more than a gradient's length they mean nothing, and a body in a vortex core would
// gain without bound. squares: of the changes over that speed. Short substeps: second order.
HWY_INLINE VF held_back(VF squares) {
    return constant(1.0f) / hn::Sqrt(squares + constant(1.0f));
}

// In a wind field, the body's velocity through the fluid obeys the equations of still fluid with the force
//   (m - rho V) g + rho V a_f - m a_b,   m = (1 + weight)/2 and rho V = (1 - weight)/2 in mass units,
// a_f the fluid's acceleration, a_b that of the wind along the body's path (docs/reference/wind_and_water.md).
void enter_wind(const StepInput& in, const WindAlong& along, uint32_t substep, size_t first, size_t lanes,
                BodiesInWind& s) {
    const FieldInstant& instant = along.instant[substep];
    // Steps below a nanosecond move nothing; their inverse must stay finite.
    const VF half = constant(0.5f), half_rate = constant(0.5f / HWY_MAX(in.h, 1e-9f)),
             weight = constant(in.body.weight);
    const Vec3 gravity = broadcast(in.gravity), uniform = broadcast(instant.change);
    FieldBlock& b = along.blocks[first / lane_block];
    if (!along.everywhere && !along.known) {
        for (size_t i = 0; i < lanes; i += hn::Lanes(DF()))
            store_place(load3(s.x, i), load4(s.q, i), load3(s.v, i), in.h, i, b);
        evaluate(instant, lanes, &b);
    }
    for (size_t i = 0, at = first % lane_block; i < lanes; i += hn::Lanes(DF()), at += hn::Lanes(DF())) {
        Vec3 wind = broadcast(instant.wind), met = uniform, own = uniform;
        if (!along.everywhere) {
            wind = load3(b.wind, at);
            // In weaker winds than a micrometre a second the floor keeps squares of the quotient finite.
            const VF inverse = constant(1.0f) / hn::Max(load1(b.reference, at), constant(1e-6f));
            met = change_along(b, at, in.h, load3(b.velocity, at));
            own = change_along(b, at, in.h, wind);
            const Vec3 met_ratio = inverse * met, own_ratio = inverse * own;
            const VF own_squared = dot(own_ratio, own_ratio);
            const VF held = held_back(dot(met_ratio, met_ratio) + own_squared);
            met = load3(b.change, at) + held * met;
            own = load3(b.change, at) + held * own;
            const Matrix m = load_matrix(b.gradient, at);
            const Vec3 curl{m.row[2].y - m.row[1].z, m.row[0].z - m.row[2].x, m.row[1].x - m.row[0].y};
            // In eddies smaller than itself a body is not turned by the vorticity at one point: its ends move no faster than the field.
            const Vec3 spin = (half * load1(s.length, i)) * curl, ratio = (half * inverse) * spin;
            store3(s.spin, i, constant(1.0f) / hn::Sqrt(hn::Max(dot(ratio, ratio), constant(1.0f))) * spin);
            store1(s.inverse_reference, i, inverse);
            store1(s.own_squared, i, own_squared);
        }
        const Vec3 mean = half_rate * (own + met), difference = half_rate * (own - met), half_change = half * met;
        store3(s.wind, i, wind);
        store3(s.half_change, i, half_change);
        store3(s.weight, i, weight * (gravity - mean) + difference);
        store3(s.gravity, i, gravity - (mean + difference));
        store3(s.v, i, load3(s.v, i) - to_body(load4(s.q, i), wind - half_change));
    }
}

// The substep used the wind's change along the path at its first velocity. The mean velocity adds d to the wind at the end, and -m d to the momentum.
void leave_wind(const StepInput& in, const WindAlong& along, size_t first, size_t lanes, BodiesInWind& s) {
    const BodyConstants& c = in.body;
    const FieldBlock& b = along.blocks[first / lane_block];
    for (size_t i = 0, at = first % lane_block; i < lanes; i += hn::Lanes(DF()), at += hn::Lanes(DF())) {
        const Quaternion q = load4(s.q, i);
        const Vec3 half_change = load3(s.half_change, i);
        Vec3 v = load3(s.v, i) + to_body(q, load3(s.wind, i) + half_change), u = load3(s.u, i);
        if (!along.everywhere) {
            const Vec3 mean = constant(0.5f) * (load3(b.velocity, at) + within(to_world(q, v), 1e7f));
            const Vec3 change = change_along(b, at, in.h, mean), ratio = load1(s.inverse_reference, i) * change;
            const VF held = held_back(dot(ratio, ratio) + load1(s.own_squared, i));
            const Vec3 more = to_body(q, load3(b.change, at) + held * change - (half_change + half_change));
            const Vec3 lost = constant(0.5f * (1.0f + c.weight)) * more;
            if (c.diagonal) {
                v += more - scaled_by(c.inverse_mass, lost);
            } else {
                const auto answer = [&](int i) LR_LAMBDA {
                    const float* const m = c.full_inverse;
                    return constant(m[upper6[i][0]]) * lost.x +
                           (constant(m[upper6[i][1]]) * lost.y + constant(m[upper6[i][2]]) * lost.z);
                };
                v += more - Vec3{answer(0), answer(1), answer(2)};
                u -= Vec3{answer(3), answer(4), answer(5)};
            }
        }
        store3(s.v, i, without_dust(v));
        store3(s.u, i, u);
    }
}
} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
