// Constants of bodies of which a part f is in the lower fluid: rho(f) = rho_a + f (rho_w - rho_a) in everything that
// goes with the fluid's density (docs/reference/wind_and_water.md).
#if defined(LR_KERNEL_SURFACE_CONSTANTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_SURFACE_CONSTANTS_INL_H_
#undef LR_KERNEL_SURFACE_CONSTANTS_INL_H_
#else
#define LR_KERNEL_SURFACE_CONSTANTS_INL_H_
#endif

#include "kernel/aerodynamic-inl.h"
#include "kernel/splitting-inl.h"
#include "kernel/surface.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

using LaneConstants = BodyConstantsOf<VF>;

// Eigenvalues on the diagonal of `a`, eigenvectors in the columns of `v`. Cyclic Jacobi with a fixed number of sweeps:
// it converges quadratically, and all lanes must do the same. Seven leave single precision's rounding for six rows.
template <int N> static HWY_NOINLINE void eigen(VF (&a)[N][N], VF (&v)[N][N]) {
    const VF zero = hn::Zero(DF()), one = constant(1.0f);
    for (int i = 0; i < N; ++i)
        for (int j = 0; j < N; ++j) v[i][j] = i == j ? one : zero;
    const auto rotate = [&](VF& x, VF& y, VF c, VF s) LR_LAMBDA {
        const VF p = x, q = y;
        x = mul_sub(c, p, hn::Mul(s, q));
        y = mul_add(s, p, hn::Mul(c, q));
    };
    for (int sweep = 0; sweep < N + 1; ++sweep)
        for (int p = 0; p < N; ++p)
            for (int q = p + 1; q < N; ++q) {
                const VF gap = hn::Sub(a[q][q], a[p][p]), twice = hn::Add(a[p][q], a[p][q]);
                const VF root = hn::Sqrt(mul_add(gap, gap, hn::Mul(twice, twice)));
                const VF size = hn::Add(hn::Add(hn::Abs(gap), root), constant(1e-30f));
                const VF t = hn::Div(hn::IfThenElse(hn::Lt(gap, zero), hn::Neg(twice), twice), size);
                const VF c = hn::Div(one, hn::Sqrt(mul_add(t, t, one))), s = hn::Mul(t, c);
                for (int k = 0; k < N; ++k) rotate(a[k][p], a[k][q], c, s);
                for (int k = 0; k < N; ++k) rotate(a[p][k], a[q][k], c, s);
                for (int k = 0; k < N; ++k) rotate(v[k][p], v[k][q], c, s);
            }
}

// Of a symmetric 3x3 matrix by its upper triangle.
HWY_INLINE void invert3(const VF* m, VF* out) {
    const VF xx = mul_sub(m[3], m[5], hn::Mul(m[4], m[4])), xy = mul_sub(m[2], m[4], hn::Mul(m[1], m[5])),
             xz = mul_sub(m[1], m[4], hn::Mul(m[2], m[3]));
    const VF inverse = hn::Div(constant(1.0f), mul_add(m[0], xx, mul_add(m[1], xy, hn::Mul(m[2], xz))));
    out[0] = hn::Mul(inverse, xx);
    out[1] = hn::Mul(inverse, xy);
    out[2] = hn::Mul(inverse, xz);
    out[3] = hn::Mul(inverse, mul_sub(m[0], m[5], hn::Mul(m[2], m[2])));
    out[4] = hn::Mul(inverse, mul_sub(m[1], m[2], hn::Mul(m[0], m[4])));
    out[5] = hn::Mul(inverse, mul_sub(m[0], m[3], hn::Mul(m[1], m[1])));
}

HWY_INLINE VF component(Vec3 v, int i) {
    return i == 0 ? v.x : i == 1 ? v.y : v.z;
}
HWY_INLINE VF component(const Twist& t, int i) {
    return i < 3 ? component(t.v, i) : component(t.u, i - 3);
}

// Shares of two sets of constants in their mean; each at its end exactly.
struct Shares {
    VF air, water;
    HWY_INLINE VF operator()(float a, float w) const { return mul_add(air, constant(a), hn::Mul(water, constant(w))); }
    template <size_t N> HWY_INLINE void operator()(const float (&a)[N], const float (&w)[N], VF (&out)[N]) const {
        for (size_t i = 0; i < N; ++i) out[i] = (*this)(a[i], w[i]);
    }
};

// The fraction's share of the fluid's mass.
HWY_INLINE VF water_share(const WaterBody& w, VF f) {
    const VF wet = hn::Mul(f, constant(w.water_density));
    return hn::Div(wet, mul_add(hn::Sub(constant(1.0f), f), constant(w.air_density), wet));
}

HWY_INLINE void blend_aerodynamics(const AerodynamicConstants& a, const AerodynamicConstants& w, const Shares& mean,
                                   VF wet, AerodynamicConstantsOf<VF>& out) {
    // The dynamic viscosity goes with the fraction.
    out.viscosity = Shares{hn::Sub(constant(1.0f), wet), wet}(a.viscosity, w.viscosity);
    mean(a.drag, w.drag, out.drag);
    mean(a.drag_blunt, w.drag_blunt, out.drag_blunt);
    mean(a.drag_layer, w.drag_layer, out.drag_layer);
    mean(a.drag_stokes, w.drag_stokes, out.drag_stokes);
    mean(a.lift, w.lift, out.lift);
    mean(a.lift_layer, w.lift_layer, out.lift_layer);
    mean(a.lift_stokes, w.lift_stokes, out.lift_stokes);
    mean(a.spin_lift, w.spin_lift, out.spin_lift);
    mean(a.lift_moment, w.lift_moment, out.lift_moment);
    mean(a.lift_moment_stalled, w.lift_moment_stalled, out.lift_moment_stalled);
    mean(a.spin_drag, w.spin_drag, out.spin_drag);
    mean(a.spin_drag_stream, w.spin_drag_stream, out.spin_drag_stream);
    mean(a.spin_drag_stokes, w.spin_drag_stokes, out.spin_drag_stokes);
    for (int i = 0; i < 3; ++i) out.roll[i] = hn::Sqrt(mean(a.roll[i] * a.roll[i], w.roll[i] * w.roll[i]));
    // These do not depend on the fluid.
    const auto same = [&](const auto& from, auto& to) LR_LAMBDA {
        for (size_t i = 0; i < sizeof from / sizeof from[0]; ++i) to[i] = constant(from[i]);
    };
    same(a.broadside, out.broadside);
    same(a.spin_weight, out.spin_weight);
    same(a.axes, out.axes);
    same(a.arm, out.arm);
    out.lift_stall = constant(a.lift_stall);
    out.rate_of_gusts = constant(a.rate_of_gusts);
    out.variance_of_gusts = constant(a.variance_of_gusts);
    out.wake_reynolds = constant(a.wake_reynolds);
    out.gust_gain = constant(a.gust_gain);
}

// As make_frame() of kernel/aerodynamics.cpp, for the inverse mass matrix in `c`.
static HWY_NOINLINE void aerodynamic_frame(LaneConstants& c) {
    AerodynamicConstantsOf<VF>& a = c.aerodynamics;
    const VF zero = hn::Zero(DF());
    const Vec3 arm = broadcast(a.arm), none{zero, zero, zero};
    Twist to[3], response[3], spin_response[3];
    for (int j = 0; j < 3; ++j) {
        const Vec3 q = broadcast(a.axes + 3 * j);
        to[j] = {q, cross(arm, q)};
        response[j] = symmetric6(c.full_inverse, to[j]);
        spin_response[j] = symmetric6(c.full_inverse, Twist{none, q});
    }
    VF n[3][3], vectors[3][3], spin[6], inverse[6], inverse_spin[6];
    for (int i = 0, k = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j, ++k) {
            n[i][j] = n[j][i] = hn::Add(dot(to[i].v, response[j].v), dot(to[i].u, response[j].u));
            spin[k] = dot(broadcast(a.axes + 3 * i), spin_response[j].u);
            a.mobility[k] = n[i][j];
            a.spin_mobility[k] = spin[k];
        }
    for (int i = 0, k = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j, ++k) {
            const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            a.mobility_adjugate[k] = mul_sub(n[i1][j1], n[i2][j2], hn::Mul(n[i1][j2], n[i2][j1]));
        }
    invert3(spin, inverse_spin);
    invert3(a.mobility, inverse);
    Vec3 mixed[3], turned[3]; // rows
    for (int i = 0; i < 3; ++i) {
        const Vec3 q = broadcast(a.axes + 3 * i);
        turned[i] = {dot(q, response[0].u), dot(q, response[1].u), dot(q, response[2].u)};
    }
    for (int i = 0; i < 3; ++i) mixed[i] = {component(turned[0], i), component(turned[1], i), component(turned[2], i)};
    const auto store_row = [&](Vec3 row, VF* out) LR_LAMBDA { out[0] = row.x, out[1] = row.y, out[2] = row.z; };
    for (int i = 0; i < 3; ++i) {
        store_row(turned[i], a.spin_response_to_force + 3 * i);
        store_row(symmetric3(inverse, turned[i]), a.spin_of_force + 3 * i);
        store_row(symmetric3(inverse_spin, mixed[i]), a.velocity_of_couple + 3 * i);
    }
    const VF over[3] = {hn::Div(constant(1.0f), spin[0]), hn::Div(constant(1.0f), spin[3]),
                        hn::Div(constant(1.0f), spin[5])};
    const VF beside[6] = {spin[1], spin[2], spin[1], spin[4], spin[2], spin[4]};
    for (int i = 0; i < 6; ++i) a.spin_answer[i] = hn::Mul(beside[i], over[i / 2]);
    eigen(n, vectors);
    for (int j = 0; j < 3; ++j) {
        a.rate[j] = n[j][j];
        for (int i = 0; i < 3; ++i) a.modes[i * 3 + j] = vectors[i][j];
    }
    for (int i = 0; i < 6; ++i)
        store_row(symmetric3(inverse_spin, Vec3{component(spin_response[0], i), component(spin_response[1], i),
                                                component(spin_response[2], i)}),
                  a.spin_response + 3 * i);
}

// Modes in which mass is 1 and the turbulent damping diagonal: with Z = X (1 + f lambda)^-1/2 mass is 1 already, and
// Jacobi turns Z^T W Z.
static HWY_NOINLINE void langevin_modes(bool damped, const WaterBody& w, VF f, VF unit, LaneConstants& c) {
    const VF one = constant(1.0f), root = hn::Sqrt(unit);
    VF stretch[6], z[6][6], q[6][6];
    for (int j = 0; j < 6; ++j) {
        stretch[j] = hn::Div(hn::Sqrt(mul_add(f, constant(w.lambda[j]), one)), root);
        for (int i = 0; i < 6; ++i) z[i][j] = hn::Div(constant(w.from[i * 6 + j]), stretch[j]);
    }
    if (!damped) {
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < 6; ++j) c.from_modes[i * 6 + j] = z[i][j];
        return;
    }
    VF k[6][6];
    for (int j = 0; j < 6; ++j) {
        const Twist wz = dragged<true>(c, Twist{{z[0][j], z[1][j], z[2][j]}, {z[3][j], z[4][j], z[5][j]}});
        for (int i = 0; i < 6; ++i) {
            VF sum = hn::Mul(z[0][i], component(wz, 0));
            for (int m = 1; m < 6; ++m) sum = mul_add(z[m][i], component(wz, m), sum);
            k[i][j] = sum;
        }
    }
    eigen(k, q);
    for (int j = 0; j < 6; ++j) {
        c.rate[j] = hn::Max(k[j][j], hn::Zero(DF()));
        for (int i = 0; i < 6; ++i) {
            VF from = hn::Mul(z[i][0], q[0][j]);
            VF to = hn::Mul(hn::Mul(q[0][j], stretch[0]), constant(w.to[i]));
            for (int m = 1; m < 6; ++m) {
                from = mul_add(z[i][m], q[m][j], from);
                to = mul_add(hn::Mul(q[m][j], stretch[m]), constant(w.to[m * 6 + i]), to);
            }
            c.from_modes[i * 6 + j] = from;
            c.to_modes[j * 6 + i] = to;
        }
        const VF* const z0 = c.from_modes + j; // a column
        const Twist noise = dragged<true>(c, Twist{{z0[0], z0[6], z0[12]}, {z0[18], z0[24], z0[30]}});
        for (int i = 0; i < 3; ++i) {
            c.modes_of_noise[j * 6 + i] = component(noise, i);
            c.modes_of_noise[j * 6 + 3 + i] = hn::Mul(c.noise_spin, component(noise, i + 3));
        }
    }
}

template <bool kAerodynamic>
HWY_INLINE void blend_full(bool damped, const BodyConstants& a, const WaterBody& w, VF f, VF unit, const Shares& mean,
                           LaneConstants& c) {
    mean(a.full_mass, w.water.full_mass, c.full_mass);
    mean(a.full_damping, w.water.full_damping, c.full_damping);
    mean(a.full_spin_damping, w.water.full_spin_damping, c.full_spin_damping);
    // M^-1 = X (1 + f lambda)^-1 X^T, in units of U(f)
    VF weight[6];
    for (int m = 0; m < 6; ++m) weight[m] = hn::Div(unit, mul_add(f, constant(w.lambda[m]), constant(1.0f)));
    for (int i = 0, n = 0; i < 6; ++i)
        for (int j = i; j < 6; ++j, ++n) {
            VF sum = hn::Mul(weight[0], constant(w.from[i * 6] * w.from[j * 6]));
            for (int m = 1; m < 6; ++m) sum = mul_add(weight[m], constant(w.from[i * 6 + m] * w.from[j * 6 + m]), sum);
            c.full_inverse[n] = sum;
        }
    const VF* const m = c.full_mass;
    const VF first[6] = {m[0], m[1], m[2], m[6], m[7], m[11]};
    invert3(first, c.inverse_translation);
    const Vec3 coupling[3] = {{m[3], m[8], m[12]}, {m[4], m[9], m[13]}, {m[5], m[10], m[14]}}; // columns of M12
    const VF rotation[6] = {m[15], m[16], m[17], m[18], m[19], m[20]};
    Vec3 slips[3];
    for (int i = 0; i < 3; ++i) {
        slips[i] = symmetric3(c.inverse_translation, coupling[i]);
        for (int k = 0; k < 3; ++k) c.slip[i * 3 + k] = component(slips[i], k);
    }
    for (int i = 0, n = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j, ++n) c.reduced_rotation[n] = hn::Sub(rotation[n], dot(slips[i], coupling[j]));
    if constexpr (kAerodynamic)
        aerodynamic_frame(c);
    else
        langevin_modes(damped, w, f, unit, c);
}

// unit: receives U(f)/U_a.
template <bool kFull, bool kAerodynamic>
static HWY_NOINLINE void blend(bool damped, const BodyConstants& a, const WaterBody& w, VF f, LaneConstants& c,
                               VF& unit) {
    const VF one = constant(1.0f), dry = hn::Sub(one, f);
    const VF ratio = constant(w.water.unit_mass / a.unit_mass);
    unit = mul_add(f, ratio, dry);
    const Shares mean{hn::Div(dry, unit), hn::Div(hn::Mul(f, ratio), unit)};
    c.length = constant(a.length);
    c.unit_mass = hn::Mul(unit, constant(a.unit_mass));
    c.weight = mean(a.weight, w.water.weight);
    mean(a.buoyancy, w.water.buoyancy, c.buoyancy);
    c.speed_alpha = constant(a.speed_alpha);
    c.speed_beta = constant(a.speed_beta);
    c.noise_spin = constant(a.noise_spin);
    mean(a.mass, w.water.mass, c.mass);
    mean(a.spin_mass, w.water.spin_mass, c.spin_mass);
    if constexpr (kAerodynamic)
        blend_aerodynamics(a.aerodynamics, w.water.aerodynamics, mean, water_share(w, f), c.aerodynamics);
    if constexpr (kFull) {
        blend_full<kAerodynamic>(damped, a, w, f, unit, mean, c);
        for (int i = 0; i < 3; ++i) {
            c.inverse_mass[i] = c.full_inverse[i == 0 ? 0 : i == 1 ? 6 : 11];
            c.inverse_spin_mass[i] = c.full_inverse[i == 0 ? 15 : i == 1 ? 18 : 20];
        }
        return;
    }
    mean(a.damping, w.water.damping, c.damping);
    mean(a.spin_damping, w.water.spin_damping, c.spin_damping);
    for (int i = 0; i < 3; ++i) {
        c.inverse_mass[i] = hn::Div(one, c.mass[i]);
        c.inverse_spin_mass[i] = hn::Div(one, c.spin_mass[i]);
        c.rate[i] = hn::Mul(c.damping[i], c.inverse_mass[i]);
        c.rate[i + 3] = hn::Mul(c.spin_damping[i], c.inverse_spin_mass[i]);
    }
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        c.gyroscopic[i] = hn::Mul(hn::Sub(c.spin_mass[j], c.spin_mass[k]), c.inverse_spin_mass[i]);
        c.munk[i] = hn::Mul(hn::Sub(c.mass[j], c.mass[k]), c.inverse_spin_mass[i]);
        c.munk_turn[i] = hn::Mul(c.munk[i], c.inverse_mass[j]);
        c.munk_turn[i + 3] = hn::Mul(c.munk[i], c.inverse_mass[k]);
    }
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
