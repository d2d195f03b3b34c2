// Quasi-steady loads for one vector of bodies: docs/maintainers/physics.md, "AERODYNAMIC". Kernel units and constants: constants.h.
// `b`: 1/(d s). `nu`: viscosity over d s, a velocity. v: of the centre of the loads, along their axes.
#if defined(LR_KERNEL_AERODYNAMIC_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_AERODYNAMIC_INL_H_
#undef LR_KERNEL_AERODYNAMIC_INL_H_
#else
#define LR_KERNEL_AERODYNAMIC_INL_H_
#endif

#include "kernel/motion-inl.h"
#include "kernel/noise-inl.h"
#include "kernel/step.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

HWY_INLINE Vec3 times(Vec3 a, Vec3 b) {
    return {hn::Mul(a.x, b.x), hn::Mul(a.y, b.y), hn::Mul(a.z, b.z)};
}

// Transpose of a row-major 3x3 matrix.
template <class T> HWY_INLINE Vec3 columns(const T* m, Vec3 a) {
    return add(scale(a.x, broadcast(m)), add(scale(a.y, broadcast(m + 3)), scale(a.z, broadcast(m + 6))));
}
template <class T> HWY_INLINE Twist rows6(const T* m, Vec3 a) {
    return {rows(m, a), rows(m + 9, a)};
}

// Above zero, so that directions exist; far below any speed that can be seen.
HWY_INLINE VF speed_squared(Vec3 v) {
    return hn::Add(dot(v, v), constant(1e-20f));
}

// Drag is -drag_rate v, per mass unit.
template <class A> HWY_INLINE VF drag_rate(const A& c, VF b, VF nu, Vec3 v) {
    const VF s2 = speed_squared(v), s = hn::Sqrt(s2);
    const Vec3 part = scale(hn::Div(constant(1.0f), s2), times(v, v));
    const VF separated = hn::Div(s, mul_add(constant(8710.0f), nu, s)); // Re/(Re + 8710)
    const VF form = mul_add(separated, weighted(c.drag_blunt, part), weighted(c.drag, part));
    const VF layer = hn::Mul(hn::Sqrt(hn::Mul(s, nu)), weighted(c.drag_layer, part));
    return hn::Mul(b, mul_add(s, form, mul_add(nu, weighted(c.drag_stokes, part), layer)));
}

// How far the flow is from edge-on: sin^2 of the angle of attack for a sheet.
template <class A> HWY_INLINE VF stall(const A& c, VF inverse_s2, Vec3 v) {
    return hn::Mul(weighted(c.broadside, times(v, v)), inverse_s2);
}

// Lift is circulation x v, per mass unit: of translation, of rotation, and the sideways part of an uneven viscous drag.
template <class A> HWY_INLINE Vec3 circulation(const A& c, VF b, VF nu, Vec3 v, Vec3 u) {
    const VF s2 = speed_squared(v), s = hn::Sqrt(s2);
    const VF inverse_s2 = hn::Div(constant(1.0f), s2), inverse = hn::Mul(b, inverse_s2);
    const VF root = hn::Sqrt(hn::Mul(s, nu));
    const VF attached = neg_mul_add(constant(c.lift_stall), stall(c, inverse_s2, v), constant(1.0f));
    const VF full = hn::Mul(s, attached);
    const auto along = [&](int k, VF vi, VF vj, VF uk) LR_LAMBDA {
        const VF sum = mul_add(constant(c.lift[k]), full,
                               mul_add(constant(c.lift_layer[k]), root, hn::Mul(constant(c.lift_stokes[k]), nu)));
        return mul_sub(hn::Mul(b, constant(c.spin_lift[k])), uk, hn::Mul(hn::Mul(inverse, hn::Mul(vi, vj)), sum));
    };
    return {along(0, v.y, v.z, u.x), along(1, v.z, v.x, u.y), along(2, v.x, v.y, u.z)};
}

// Spin drag is -rate u along each axis.
template <class A> HWY_INLINE Vec3 spin_drag_rate(const A& c, VF b, VF nu, VF s, Vec3 u) {
    const VF spin = hn::Sqrt(weighted(c.spin_weight, times(u, u)));
    const auto along = [&](int k) LR_LAMBDA {
        return hn::Mul(
            b, mul_add(constant(c.spin_drag[k]), spin,
                       mul_add(constant(c.spin_drag_stream[k]), s, hn::Mul(constant(c.spin_drag_stokes[k]), nu))));
    };
    return {along(0), along(1), along(2)};
}

// Roll damping is -rate (axis . u) axis.
struct Roll {
    Vec3 axis;
    VF rate;
};
template <class A> HWY_INLINE Roll roll_damping(const A& c, VF b, VF s, Vec3 v) {
    return {times(broadcast(c.roll), v), hn::Div(b, s)};
}

template <class A> HWY_INLINE Vec3 lift_moment(const A& c, VF b, Vec3 v) {
    const VF sigma = stall(c, hn::Div(constant(1.0f), speed_squared(v)), v);
    const auto along = [&](int k, VF vi, VF vj) LR_LAMBDA {
        return hn::Mul(hn::Mul(b, hn::Mul(vi, vj)),
                       mul_add(constant(c.lift_moment_stalled[k]), sigma, constant(c.lift_moment[k])));
    };
    return {along(0, v.y, v.z), along(1, v.z, v.x), along(2, v.x, v.y)};
}

template <bool kFull, class A> HWY_INLINE Vec3 centre_velocity(const A& c, Twist t) {
    if constexpr (!kFull) return t.v;
    return rows(c.axes, add(t.v, cross(t.u, broadcast(c.arm))));
}
template <bool kFull, class A> HWY_INLINE Vec3 load_spin(const A& c, Twist t) {
    if constexpr (!kFull) return t.u;
    return rows(c.axes, t.u);
}

// All of them as force and torque about the centre of mass, body axes.
template <bool kFull, class A> HWY_INLINE Twist aerodynamic_loads(const A& c, VF b, Twist t) {
    const VF nu = hn::Mul(constant(c.viscosity), b);
    const Vec3 v = centre_velocity<kFull>(c, t), u = load_spin<kFull>(c, t);
    const Vec3 force = sub(cross(circulation(c, b, nu, v, u), v), scale(drag_rate(c, b, nu, v), v));
    const VF s = hn::Sqrt(speed_squared(v));
    const Roll roll = roll_damping(c, b, s, v);
    const Vec3 resisted =
        add_scaled(times(spin_drag_rate(c, b, nu, s, u), u), hn::Mul(roll.rate, dot(roll.axis, u)), roll.axis);
    const Vec3 torque = sub(lift_moment(c, b, v), resisted);
    if constexpr (!kFull) return {force, torque};
    const Vec3 f = columns(c.axes, force);
    return {f, add(columns(c.axes, torque), cross(broadcast(c.arm), f))};
}

// The fluid's own velocity after a substep (world frame): an Ornstein-Uhlenbeck process whose rate and variance, alpha
// and beta^2/(2 alpha), are held over it.
HWY_INLINE Vec3 next_gust(Vec3 gust, VF alpha, VF variance, float h, const VF gauss[3]) {
    // exp(-x) to 1e-6 for x below 1, zero in the end for all above.
    const VF x = hn::Min(hn::Mul(alpha, constant(0.125f * h)), constant(8.0f));
    VF d = mul_add(x, constant(1.0f / 24.0f), constant(1.0f / 6.0f));
    d = mul_add(x, d, constant(0.5f));
    d = mul_add(x, d, constant(1.0f));
    VF e = hn::Div(constant(1.0f), mul_add(x, d, constant(1.0f)));
    e = hn::Mul(e, e);
    e = hn::Mul(e, e);
    e = hn::Mul(e, e);
    const VF kick = hn::Sqrt(hn::Mul(variance, hn::Max(neg_mul_add(e, e, constant(1.0f)), constant(0.0f))));
    return add_scaled(scale(e, gust), kick, Vec3{gauss[0], gauss[1], gauss[2]});
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
