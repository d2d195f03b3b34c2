// A surface at a vector of points, and how much of a body is under it (docs/reference/wind_and_water.md).
#if defined(LR_KERNEL_SURFACE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_SURFACE_INL_H_
#undef LR_KERNEL_SURFACE_INL_H_
#else
#define LR_KERNEL_SURFACE_INL_H_
#endif

#include "kernel/aerodynamic-inl.h"
#include "kernel/surface.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

struct SurfaceSample {
    VF height; // m above the plane
    Vec3 normal, velocity, rate;
};

// exp(-x) for x >= 0, to 1e-6; zero in the end.
HWY_INLINE VF decay(VF x) {
    const VF y = hn::Mul(hn::Min(x, constant(64.0f)), constant(1.0f / 16.0f));
    VF d = constant(1.0f / 720.0f);
    for (float factor : {1.0f / 120.0f, 1.0f / 24.0f, 1.0f / 6.0f, 0.5f, 1.0f, 1.0f})
        d = mul_add(y, d, constant(factor));
    VF e = hn::Div(constant(1.0f), d);
    for (int i = 0; i < 4; ++i) e = hn::Mul(e, e);
    return e;
}

HWY_INLINE SurfaceSample sample_surface(const SurfaceInstant& s, Vec3 x) {
    const VF zero = hn::Zero(DF());
    const Vec3 up = broadcast(s.up), from = sub(x, broadcast(s.point));
    VF sine[most_waves], cosine[most_waves];
    SurfaceSample out{zero, up, broadcast(s.current), {zero, zero, zero}};
    for (uint32_t i = 0; i < s.wave_count; ++i) {
        const WaveInstant& w = s.waves[i];
        const Vec3 k = broadcast(w.direction);
        const VF turns = mul_add(dot(k, from), constant(w.turns_per_m), constant(w.turn));
        sin_cos_turn(hn::Sub(turns, hn::Floor(turns)), sine[i], cosine[i]);
        out.height = mul_add(constant(w.amplitude), cosine[i], out.height);
        out.normal = add_scaled(out.normal, hn::Mul(constant(w.amplitude * w.number), sine[i]), k);
    }
    out.normal = scale(hn::Div(constant(1.0f), hn::Sqrt(dot(out.normal, out.normal))), out.normal);
    // Motion fades with the depth below the surface itself (Wheeler's stretching): no wave rides on another's crest
    // faster than it would on still water.
    const VF depth = hn::Max(hn::Sub(out.height, dot(up, from)), zero);
    for (uint32_t i = 0; i < s.wave_count; ++i) {
        const WaveInstant& w = s.waves[i];
        const Vec3 k = broadcast(w.direction);
        const VF fade = decay(hn::Mul(constant(w.number), depth));
        const VF v = hn::Mul(fade, constant(w.speed)), a = hn::Mul(fade, constant(w.rate));
        out.velocity = add_scaled(add_scaled(out.velocity, hn::Mul(v, cosine[i]), k), hn::Mul(v, sine[i]), up);
        out.rate = add_scaled(add_scaled(out.rate, hn::Mul(a, sine[i]), k), hn::Neg(hn::Mul(a, cosine[i])), up);
    }
    return out;
}

// How a body lies in the surface, by its equivalent ellipsoid: cut by a plane, that is a sphere's cap.
struct Immersion {
    VF fraction;    // of the volume under the surface
    Vec3 center;    // m, body frame: fraction times the submerged centre, from the centre of mass
    VF half_height; // m, of the ellipsoid along the normal
    VF second;      // 3/16 (1 - s^2)^2
    Vec3 normal;    // body frame
};

// `blur`: m. A body thinner than the way that it falls in a substep counts as that thick, or it would miss the surface.
HWY_INLINE Immersion immersed(const WaterBody& w, const SurfaceInstant& plane, VF body_scale, Quaternion q, Vec3 x,
                              VF height, Vec3 normal, float blur) {
    const VF one = constant(1.0f);
    Immersion out;
    out.normal = to_body(q, normal);
    const Vec3 along = rows(w.axes, out.normal);
    const Vec3 stretched = scale(hn::Mul(body_scale, body_scale), scaled_by(w.semi_axes_squared, along));
    out.half_height = hn::Sqrt(hn::Add(dot(stretched, along), constant(blur * blur)));
    const Vec3 middle = scale(body_scale, broadcast(w.center));
    const Vec3 up = broadcast(plane.up);
    const VF above = dot(up, sub(add(x, to_world(q, middle)), broadcast(plane.point)));
    const VF depth = hn::Mul(hn::Sub(height, above), dot(up, normal));
    const VF s = hn::Max(hn::Min(hn::Div(depth, out.half_height), one), constant(-1.0f));
    const VF s2 = hn::Mul(s, s), rest = hn::Sub(one, s2);
    out.fraction = hn::Mul(constant(0.25f), mul_add(s, hn::Sub(constant(3.0f), s2), constant(2.0f)));
    out.second = hn::Mul(constant(0.1875f), hn::Mul(rest, rest));
    const VF lowered = hn::Neg(hn::Div(out.second, out.half_height));
    out.center = add_scaled(scale(out.fraction, middle), lowered, columns(w.axes, stretched));
    return out;
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
