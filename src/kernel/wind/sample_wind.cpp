// Wind at blocks of bodies, compiled once for each instruction set. Sources are the outer loop: their constants are broadcast once, and a source out
// of reach of the block costs one comparison. Formulas: docs/reference/wind_and_water.md.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/wind/sample_wind.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

#include "hwy/highway.h"
#include "kernel/integrator/equations_of_motion-inl.h"
#include "kernel/integrator/step.h"
#include "kernel/wind/sample_wind.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

// Divergence-free turbulence from a lattice of random eddies, with its gradient. Lattice point c carries w(d) (omega x d)/2 of a vector potential,
// d = x - c in cells, w a product of quintic steps; the field is the curl of their sum.

struct Flow {
    Vec3 wind, rate;
    Matrix gradient;
};

// Mixes three words by pcg3d (Jarzynski and Olano, JCGT 9(3), 2020).
struct Words {
    VU x, y, z;
};
HWY_INLINE Words mix(Words v, uint32_t seed) {
    const DU du;
    const auto step = [&](VU a) LR_LAMBDA { return a * hn::Set(du, 1664525u) + hn::Set(du, 1013904223u + seed); };
    const auto cross_over = [&]() LR_LAMBDA {
        v.x += v.y * v.z;
        v.y += v.z * v.x;
        v.z += v.x * v.y;
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
    a = hn::ConvertTo(DF(), hn::BitCast(di, hn::And(word, hn::Set(du, 0xffffu)))) * unit - one;
    b = hn::ConvertTo(DF(), hn::BitCast(di, hn::ShiftRight<16>(word))) * unit - one;
}

// The quintic step and its derivatives, at the lower and the upper lattice point.
struct Step {
    VF w[2], first[2], second[2], d[2];
};
HWY_INLINE Step quintic(VF f) {
    const VF one = constant(1.0f), g = one - f, fg = f * g;
    const VF cube = f * (f * f);
    const VF up = cube * (f * (constant(6.0f) * f - constant(15.0f)) + constant(10.0f));
    const VF slope = constant(30.0f) * (fg * fg);
    const VF bend = constant(60.0f) * (fg * (g - f));
    return {{one - up, up}, {-slope, slope}, {-bend, bend}, {f, -g}};
}

// Each eddy oscillates with 32 to 95 times the slowest beat: the field repeats with the period of that beat.
HWY_INLINE void eddy(Words h, const SourceInstant& s, Vec3& omega, Vec3& omega_rate) {
    const DU du;
    const DI di;
    Vec3 a, b;
    unit_pair(h.x, a.x, b.x);
    unit_pair(h.y, a.y, b.y);
    unit_pair(h.z, a.z, b.z);
    const VU bits = hn::Xor(h.x, hn::Xor(hn::ShiftRight<8>(h.y), hn::ShiftRight<16>(h.z)));
    const VU beat = hn::And(bits, hn::Set(du, 63u)) + hn::Set(du, 32u);
    const VF beats = hn::ConvertTo(DF(), hn::BitCast(di, beat));
    const VF turns = beats * constant(s.turn);
    VF sine, cosine;
    sin_cos_turn(turns - hn::ConvertTo(DF(), hn::ConvertTo(di, turns)), sine, cosine);
    omega = cosine * a + sine * b;
    omega_rate = beats * constant(6.2831853f * s.turn_rate) * (cosine * b - sine * a);
}

HWY_INLINE void turbulence(const SourceInstant& s, Vec3 x, Flow& out) {
    const DI di;
    const DU du;
    const VF inverse_cell = constant(s.inverse_spacing[0]);
    const Vec3 along_lattice = rows(s.lattice, x);
    const VF at[3] = {along_lattice.x, along_lattice.y, along_lattice.z};
    VU index[3];
    Step step[3];
    for (int i = 0; i < 3; ++i) {
        // Beyond 2^23 cells single precision has no fraction left; the clamp keeps the index in range.
        VF p = at[i] * inverse_cell - constant(s.offset[i]);
        p = hn::Min(hn::Max(p, constant(-8388608.0f)), constant(8388608.0f));
        const VF floor = hn::Floor(p);
        index[i] = hn::BitCast(du, hn::ConvertTo(di, floor) - hn::Set(di, s.cell[i]));
        step[i] = quintic(p - floor);
    }
    const VF half = constant(0.5f), strength = constant(s.strength);
    Vec3 wind = zero3(), rate = wind;
    Matrix gradient{{wind, wind, wind}};
    for (int corner = 0; corner < 8; ++corner) {
        const int i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
        const VU one = hn::Set(du, 1u);
        const Words h =
            mix({i ? index[0] + one : index[0], j ? index[1] + one : index[1], k ? index[2] + one : index[2]}, s.seed);
        Vec3 omega, omega_rate;
        eddy(h, s, omega, omega_rate);

        const Step &a = step[0], &b = step[1], &c = step[2];
        const VF bc = b.w[j] * c.w[k], ac = a.w[i] * c.w[k], ab = a.w[i] * b.w[j];
        const Vec3 d{a.d[i], b.d[j], c.d[k]};
        const VF w = a.w[i] * bc;
        const Vec3 g{a.first[i] * bc, b.first[j] * ac, c.first[k] * ab};
        const VF hessian[6] = {a.second[i] * bc, a.first[i] * b.first[j] * c.w[k], a.first[i] * c.first[k] * b.w[j],
                               b.second[j] * ac, b.first[j] * c.first[k] * a.w[i], c.second[k] * ab};
        // curl (w omega x d)/2 = omega (w + g.d/2) - d (g.omega)/2
        const VF along = half * dot(g, d) + w;
        const VF q = half * dot(g, omega);
        wind += along * omega - q * d;
        rate += along * omega_rate - half * dot(g, omega_rate) * d;
        const Vec3 p = constant(1.5f) * g + half * symmetric3(hessian, d);
        const Vec3 r = half * symmetric3(hessian, omega);
        Matrix sum = outer(omega, p) - outer(d, r);
        sum.row[0].x -= q, sum.row[1].y -= q, sum.row[2].z -= q;
        gradient = gradient + sum;
    }
    out.wind = columns(s.lattice, strength * wind);
    out.rate = columns(s.lattice, strength * rate);
    const auto turned = [&](const Matrix& m) LR_LAMBDA {
        return Matrix{{columns(s.lattice, m.row[0]), columns(s.lattice, m.row[1]), columns(s.lattice, m.row[2])}};
    };
    out.gradient = transposed(turned(transposed(strength * inverse_cell * turned(gradient))));
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
    const VF safe = hn::Max(q, constant(0.25f));
    const VF far = (constant(1.0f) - e) / safe;
    const VF far_slope = (e - far) / safe;
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
    if (s.kind == SourceKind::lamb_oseen) {
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
    const bool line = s.kind == SourceKind::line_blower;
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
        if (s.outside == outside_repeat) {
            p -= hn::Floor(p * constant(1.0f / samples)) * constant(samples);
            p = hn::Max(p, zero); // rounding can pass either end
        } else {
            const auto inside = hn::And(p >= zero, p <= last);
            if (s.outside == outside_zero) in = hn::And(in, inside);
            slope[i] = hn::IfThenElseZero(inside, slope[i]);
            p = hn::Min(hn::Max(p, zero), last);
        }
        const VI top = hn::Set(di, s.count[i] - 1);
        low[i] = hn::Max(hn::Min(hn::ConvertTo(di, p), top), hn::Zero(di));
        part[i] = clamp_unit(p - hn::ConvertTo(DF(), low[i]));
        const VI next = low[i] + hn::Set(di, 1);
        const VI beyond = s.outside == outside_repeat ? hn::Zero(di) : top;
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
    const auto between = [&](VF a, VF b, VF t) LR_LAMBDA { return t * (b - a) + a; };
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
                change[i] = later[i] - value[i];
                value[i] = between(value[i], later[i], constant(s.part));
            }
            rate[k] = across(change, line, plane) * constant(s.part_rate);
        }
        wind[k] = across(value, line, plane);
        const VF dx0 = between(value[1] - value[0], value[3] - value[2], part[1]);
        const VF dx1 = between(value[5] - value[4], value[7] - value[6], part[1]);
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

void predict(const BatchArrays& a, size_t begin, size_t end, float h, FieldBlock& out) {
    for (size_t at = begin; at < end; at += hn::Lanes(DF())) {
        const Vec3 v = within(to_world(load4(a, at), load3(a, field_vx, at)), 1e7f);
        store3(out.velocity, at - begin, v);
        store3(out.position, at - begin, within(load3(a, field_x, at) + constant(0.5f * h) * v, 1e12f));
    }
}

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
    const Vec3 none = zero3();
    for (size_t at = 0; at < count; at += hn::Lanes(DF())) {
        store3(b.wind, at, broadcast(instant.wind));
        store3(b.change, at, broadcast(instant.change));
        store3(b.rate, at, none);
        store_matrix(b.gradient, at, {{none, none, none}});
        store1(b.reference, at, constant(instant.reference));
    }
}

HWY_INLINE void add_ground(const SourceInstant& s, size_t count, FieldBlock& b) {
    const Vec3 none = zero3();
    for (size_t at = 0; at < count; at += hn::Lanes(DF())) {
        Vec3 slopes;
        const VF factor = ground_factor(s, load3(b.position, at), slopes);
        const Matrix lifted = outer(load3(b.wind, at), slopes);
        // Plus zero: removes negative zeros, or a source that adds nothing could change a sign.
        store_matrix(b.gradient, at, factor * load_matrix(b.gradient, at) + lifted + Matrix{{none, none, none}});
        store3(b.wind, at, factor * load3(b.wind, at) + none);
        store3(b.change, at, factor * load3(b.change, at) + none);
        // The pattern moves as a whole: du/dt at a point is - motion . grad u.
        store3(b.rate, at, factor * load3(b.rate, at) - lifted * broadcast(s.motion) + none);
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
    const Vec3 motion = broadcast(s.motion);
    for (size_t at = 0; at < count; at += hn::Lanes(DF())) {
        Flow flow;
        flow.rate = zero3();
        if (!flow_of(s, load3(b.position, at), flow)) continue;
        store_matrix(b.gradient, at, load_matrix(b.gradient, at) + flow.gradient);
        store3(b.wind, at, load3(b.wind, at) + flow.wind);
        store3(b.rate, at, load3(b.rate, at) + (flow.rate - flow.gradient * motion));
    }
}

void evaluate(const FieldInstant& instant, size_t count, FieldBlock& b) {
    begin_block(instant, count, b);
    float low[3], high[3];
    for (int i = 0; i < 3; ++i) {
        VF least = load1(b.position[i], 0), most = least;
        for (size_t at = 0; at < count; at += hn::Lanes(DF())) {
            const VF x = load1(b.position[i], at);
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

// The change of the wind along a path at velocity v over the substep: h (du/dt + v . grad u), limited to the speed of the field. If a substep crosses
// more than a gradient's length the product means nothing, and a body in a vortex core would gain without bound. Short substeps: second order.
HWY_INLINE Vec3 limited_change(const FieldBlock& b, size_t at, VF h, Vec3 v) {
    const Vec3 change = h * (load3(b.rate, at) + load_matrix(b.gradient, at) * v);
    // 1e-12 m/s and less would square to a denormal; the floor keeps the quotient finite.
    const VF reference = hn::Max(load1(b.reference, at), constant(1e-12f));
    const Vec3 ratio = constant(1.0f) / reference * change;
    const VF most = greatest(ratio);
    // change / sqrt(1 + |change|^2/reference^2), with squares that cannot overflow.
    const VF small = constant(1.0f) / hn::Max(most, constant(1.0f));
    const Vec3 held = small * ratio;
    const VF norm = hn::Sqrt(small * small + dot(held, held));
    return constant(1.0f) / norm * reference * held;
}

void combine(float h, size_t count, const FieldBlock& b, FluidSample& out) {
    // Steps below a nanosecond move nothing; their inverse must stay finite.
    const VF half = constant(0.5f), hv = constant(h), rate = constant(1.0f / (h > 1e-9f ? h : 1e-9f));
    for (size_t at = 0; at < count; at += hn::Lanes(DF())) {
        const Vec3 wind = load3(b.wind, at), uniform = load3(b.change, at);
        const Vec3 met = uniform + limited_change(b, at, hv, load3(b.velocity, at));
        const Vec3 own = uniform + limited_change(b, at, hv, wind);
        const VF half_rate = half * rate;
        store3(out.wind, at, wind);
        store3(out.half_change, at, half * met);
        store3(out.mean, at, half_rate * (own + met));
        store3(out.difference, at, half_rate * (own - met));
        const Vec3 row[3] = {load3(b.gradient, at), load3(b.gradient + 3, at), load3(b.gradient + 6, at)};
        store3(out.spin, at, half * Vec3{row[2].y - row[1].z, row[0].z - row[2].x, row[1].x - row[0].y});
    }
}

// The substep used the wind's change along the path at its first velocity. The mean velocity adds d to the wind at the end, and -m d to the momentum.
void settle(const BodyConstants& c, float h, const FieldBlock& b, const FluidSample& sample, const BatchArrays& a,
            size_t begin, size_t end, uint32_t* faults) {
    const VF half = constant(0.5f), hv = constant(h), mass = constant(0.5f * (1.0f + c.weight));
    for (size_t at = begin; at < end; at += hn::Lanes(DF())) {
        const size_t i = at - begin;
        const Quaternion q = load4(a, at);
        const Vec3 v = load3(a, field_vx, at), w = load3(a, field_wx, at);
        const Vec3 last = within(to_world(q, v), 1e7f);
        const Vec3 mean = half * (load3(b.velocity, i) + last);
        const Vec3 met = load3(b.change, i) + limited_change(b, i, hv, mean);
        const Vec3 taken = load3(sample.half_change, i);
        const Vec3 more = to_body(q, met - (taken + taken));
        const Vec3 lost = mass * more;
        Vec3 settled, turns = w;
        if (c.diagonal) {
            settled = v + (more - scaled_by(c.inverse_mass, lost));
        } else {
            const Twist t = symmetric6(c.full_inverse, {lost, zero3()});
            const VF length = load1(a, field_scale, at) * constant(c.length);
            settled = v + (more - t.v);
            turns = w - constant(1.0f) / length * t.u;
        }
        store_velocities(a, at, settled, turns, faults);
    }
}
} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
