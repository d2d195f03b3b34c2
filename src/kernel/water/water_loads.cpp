// Bodies at the water surface. Compiled once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/water/water_loads.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

// One vector at a time: two side by side spill so much that they are slower, with twice the code.
#ifndef LR_NO_PAIRS
#define LR_NO_PAIRS
#endif

#include "hwy/highway.h"
#include "kernel/derived_constants-inl.h"
#include "kernel/integrator/equations_of_motion-inl.h"
#include "kernel/integrator/splitting_scheme-inl.h"
#include "kernel/integrator/step_bodies-inl.h"
#include "kernel/loads/aerodynamic_loads-inl.h"
#include "kernel/water/water_loads.h"

#include <cmath>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

// The water surface at a vector of points (docs/reference/wind_and_water.md).
struct SurfaceSample {
    VF height; // m above the plane
    Vec3 normal, velocity, rate;
};

// exp(-x) for x >= 0: error below 1e-6, tends to zero for large x.
HWY_INLINE VF decay(VF x) {
    const VF y = hn::Min(x, constant(64.0f)) * constant(1.0f / 16.0f);
    const VF d = polynomial({1.0f / 720.0f, 1.0f / 120.0f, 1.0f / 24.0f, 1.0f / 6.0f, 0.5f, 1.0f, 1.0f}, y);
    VF e = constant(1.0f) / d;
    for (int i = 0; i < 4; ++i) e *= e;
    return e;
}

// For a body as large as the equivalent ellipsoid waves are the mean over its volume: beside waves much longer than itself that is the water at its
// centre, and short waves neither lift nor carry it.
HWY_INLINE SurfaceSample sample_surface(const SurfaceInstant& s, const WaterBody& body, VF body_scale, Quaternion q,
                                        Vec3 x) {
    const VF zero = hn::Zero(DF()), one = constant(1.0f);
    const Vec3 up = broadcast(s.up), from = x - broadcast(s.point);
    VF sine[LR_MAX_WAVES], cosine[LR_MAX_WAVES];
    Vec3 slope = zero3(), turning = zero3(); // slope: minus the gradient of the height; -turning: its rate
    VF height = zero, lift = zero;
    for (uint32_t i = 0; i < s.wave_count; ++i) {
        const WaveInstant& w = s.waves[i];
        const Vec3 k = broadcast(w.direction);
        const VF turns = dot(k, from) * constant(w.turns_per_m) + constant(w.turn);
        sin_cos_turn(turns - hn::Floor(turns), sine[i], cosine[i]);
        // The ellipsoid's mean square distance from its centre along k is l^2/5, l its half length there: about exp(-|k|^2 l^2/10) of the wave.
        const Vec3 across = constant(w.number) * body_scale * rows(body.axes, to_body(q, k));
        const VF shrink = constant(1.0f / 40.0f) * dot(scaled_by(body.semi_axes_squared, across), across) + one;
        const VF shrink2 = shrink * shrink, mean = one / (shrink2 * shrink2);
        sine[i] *= mean, cosine[i] *= mean;
        height = constant(w.amplitude) * cosine[i] + height;
        lift = constant(w.speed) * sine[i] + lift;
        slope += constant(w.amplitude * w.number) * sine[i] * k;
        turning += constant(w.speed * w.number) * cosine[i] * k;
    }
    // Motion fades with depth below the wavy surface (Wheeler stretching): a wave on another one's crest moves no faster than on still water.
    const VF depth = hn::Max(height - dot(up, from), zero);
    Vec3 along = zero3(), push = zero3();
    VF rise = zero, fall = zero, steep = zero;
    for (uint32_t i = 0; i < s.wave_count; ++i) {
        const WaveInstant& w = s.waves[i];
        const Vec3 k = broadcast(w.direction);
        const VF fade = decay(constant(w.number) * depth), a = fade * constant(w.rate);
        const VF up_speed = fade * constant(w.speed) * sine[i];
        const Vec3 speed = fade * constant(w.speed) * cosine[i] * k;
        along += speed, rise += up_speed;
        turning += constant(w.number) * speed, steep = constant(w.number) * up_speed + steep;
        push += a * sine[i] * k;
        fall = a * cosine[i] + fall;
    }
    // To second order in the slope water at the surface stays there, and its rate is that along its own path. Else swell washes over leaves, and the
    // rate has a mean downward, which holds whatever moves with the water far below the surface.
    const VF climb = dot(along, turning) + ((rise - lift) * steep - dot(push, slope));
    return {height, constant(1.0f) / hn::Sqrt(dot(slope, slope) + constant(1.0f)) * (up + slope),
            broadcast(s.current) + along + (rise - dot(along, slope)) * up, push + (climb - fall) * up};
}

// Immersion of the equivalent ellipsoid: scaled to a sphere, from which a plane cuts a cap.
struct Immersion {
    VF fraction;    // of the volume in water
    Vec3 lowered;   // m, body frame: fraction times the submerged part's centre, from the centre of buoyancy
    VF half_height; // m, of the ellipsoid along the surface's normal
    VF second;      // 3/16 (1 - level^2)^2, level: depth of the centre over half_height
    Vec3 normal;    // body frame
};

// A body thinner than its fall in a substep, `blur`, counts as that thick; else it would jump over the surface. It is raised to float, lying flat, at
// its own draught, not at that of a thick one.
HWY_NOINLINE Immersion immersed_at(const StepInput& in, const WetSubstep& s, const SurfaceBlock& b, size_t at,
                                   VF body_scale, Quaternion q, Vec3 x) {
    const WaterBody& w = *s.body;
    const float* const g = s.gravity;
    const float blur = std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]) * (in.h * in.h);
    const VF one = constant(1.0f);
    const Vec3 normal = load3(b.normal, at);
    Immersion out;
    out.normal = to_body(q, normal);
    const Vec3 along = rows(w.axes, out.normal);
    const Vec3 stretched = body_scale * body_scale * scaled_by(w.semi_axes_squared, along);
    out.half_height = hn::Sqrt(dot(stretched, along) + constant(blur * blur));
    const Vec3 middle = body_scale * broadcast(w.center);
    const Vec3 up = broadcast(s.plane->up);
    const VF above = dot(up, x + to_world(q, middle) - broadcast(s.plane->point));
    const VF thin = body_scale * constant(w.thin);
    const VF raised = constant(w.draught) * (hn::Sqrt(thin * thin + constant(blur * blur)) - thin);
    const VF depth = (load1(b.height, at) - above) * dot(up, normal) + raised;
    const VF level = hn::Max(hn::Min(depth / out.half_height, one), constant(-1.0f));
    const VF level2 = level * level, rest = one - level2;
    out.fraction = constant(0.25f) * (level * (constant(3.0f) - level2) + constant(2.0f));
    out.second = constant(0.1875f) * (rest * rest);
    const VF lowered = -(out.second / out.half_height);
    out.lowered = lowered * columns(w.axes, stretched);
    return out;
}

// Constants of bodies with a share f in water. All that scales with density has rho(f) = rho_a + f (rho_w - rho_a)
// (docs/reference/wind_and_water.md).

using LaneConstants = BodyConstantsOf<VF>;

// Eigenvalues to the diagonal of `a`, eigenvectors to columns of `v`: cyclic Jacobi. For six rows seven sweeps leave only rounding, in all lanes.
template <int N> static HWY_NOINLINE void eigen(VF (&a)[N][N], VF (&v)[N][N]) {
    const VF zero = hn::Zero(DF()), one = constant(1.0f);
    for (int i = 0; i < N; ++i)
        for (int j = 0; j < N; ++j) v[i][j] = i == j ? one : zero;
    const auto rotate = [&](VF& x, VF& y, VF c, VF s) LR_LAMBDA {
        const VF p = x, q = y;
        x = c * p - s * q;
        y = s * p + c * q;
    };
    for (int sweep = 0; sweep < N + 1; ++sweep)
        for (int p = 0; p < N; ++p)
            for (int q = p + 1; q < N; ++q) {
                const VF gap = a[q][q] - a[p][p], twice = a[p][q] + a[p][q];
                const VF root = hn::Sqrt(gap * gap + twice * twice);
                const VF size = hn::Abs(gap) + root + constant(1e-30f);
                const VF t = hn::IfThenElse(gap < zero, -twice, twice) / size;
                const VF c = one / hn::Sqrt(t * t + one), s = t * c;
                for (int k = 0; k < N; ++k) rotate(a[k][p], a[k][q], c, s);
                for (int k = 0; k < N; ++k) rotate(a[p][k], a[q][k], c, s);
                for (int k = 0; k < N; ++k) rotate(v[k][p], v[k][q], c, s);
            }
}

// Weights of two sets of constants in their mean; exact at both ends.
struct Shares {
    VF air, water;
    HWY_INLINE VF operator()(float a, float w) const { return air * constant(a) + water * constant(w); }
    template <size_t N> HWY_INLINE void operator()(const float (&a)[N], const float (&w)[N], VF (&out)[N]) const {
        for (size_t i = 0; i < N; ++i) out[i] = (*this)(a[i], w[i]);
    }
};

// For structs of numbers alone. Unrolled, since a loop takes a hundredth of a wet body's step.
template <template <class> class Numbers, class Function> HWY_INLINE void each_of(const Function& function) {
    [&]<size_t... kIndex>(std::index_sequence<kIndex...>) LR_LAMBDA {
        (function(kIndex), ...);
    }
    (std::make_index_sequence<sizeof(Numbers<float>) / sizeof(float)>());
}
template <template <class> class Numbers> HWY_INLINE const float* numbers(const Numbers<float>& of) {
    return reinterpret_cast<const float*>(&of);
}
template <template <class> class Numbers> HWY_INLINE VF* numbers(Numbers<VF>& of) {
    return reinterpret_cast<VF*>(&of);
}

HWY_INLINE void blend_aerodynamics(const AerodynamicConstants& a, const WaterBody& w, const Shares& mean, VF f,
                                   AerodynamicConstantsOf<VF>& out) {
    // The dynamic viscosity is linear in the water's share of the displaced mass.
    const VF one = constant(1.0f), water = f * constant(w.water_density);
    const VF wet = water / ((one - f) * constant(w.air_density) + water);
    out.viscosity = Shares{one - wet, wet}(a.viscosity, w.water.aerodynamics.viscosity);
    const float *const loads = numbers<FluidLoadsOf>(a), *const wet_loads = numbers<FluidLoadsOf>(w.water.aerodynamics);
    each_of<FluidLoadsOf>([&](size_t i) LR_LAMBDA { numbers<FluidLoadsOf>(out)[i] = mean(loads[i], wet_loads[i]); });
    each_of<ShapeLoadsOf>([&](size_t i)
                              LR_LAMBDA { numbers<ShapeLoadsOf>(out)[i] = constant(numbers<ShapeLoadsOf>(a)[i]); });
    for (VF& x : out.fall) x = hn::Zero(DF()); // gravity is part of Floating
}

static HWY_NOINLINE void aerodynamic_frame(LaneConstants& c) {
    set_frame(hn::Zero(DF()), constant(1.0f), c);
}

// Modes with mass 1 and diagonal damping: with Z = X (1 + f lambda)^-1/2 mass is 1, and Jacobi makes Z^T W Z diagonal.
static HWY_NOINLINE void langevin_modes(bool damped, const WaterBody& w, VF f, VF unit, LaneConstants& c) {
    const VF one = constant(1.0f), root = hn::Sqrt(unit);
    VF stretch[6], z[6][6], q[6][6];
    for (int j = 0; j < 6; ++j) {
        stretch[j] = hn::Sqrt(f * constant(w.lambda[j]) + one) / root;
        for (int i = 0; i < 6; ++i) z[i][j] = constant(w.from[i * 6 + j]) / stretch[j];
    }
    if (!damped) {
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < 6; ++j) c.from_modes[i * 6 + j] = z[i][j];
        return;
    }
    VF k[6][6];
    for (int j = 0; j < 6; ++j) {
        const VF mode[6] = {z[0][j], z[1][j], z[2][j], z[3][j], z[4][j], z[5][j]};
        VF wz[6];
        times_symmetric3(c.full_damping, mode, wz);
        times_symmetric3(c.full_spin_damping, mode + 3, wz + 3);
        for (int i = 0; i < 6; ++i) {
            VF sum = z[0][i] * wz[0];
            for (int m = 1; m < 6; ++m) sum = z[m][i] * wz[m] + sum;
            k[i][j] = sum;
        }
    }
    eigen(k, q);
    for (int j = 0; j < 6; ++j) {
        c.rate[j] = hn::Max(k[j][j], hn::Zero(DF()));
        for (int i = 0; i < 6; ++i) {
            VF from = z[i][0] * q[0][j];
            VF to = q[0][j] * stretch[0] * constant(w.to[i]);
            for (int m = 1; m < 6; ++m) {
                from = z[i][m] * q[m][j] + from;
                to = q[m][j] * stretch[m] * constant(w.to[m * 6 + i]) + to;
            }
            c.from_modes[i * 6 + j] = from;
            c.to_modes[j * 6 + i] = to;
        }
    }
    set_noise_of_modes(c);
}

template <bool kAerodynamic>
HWY_INLINE void blend_full(bool damped, const BodyConstants& a, const WaterBody& w, VF f, VF unit, const Shares& mean,
                           LaneConstants& c) {
    mean(a.full_mass, w.water.full_mass, c.full_mass);
    mean(a.full_damping, w.water.full_damping, c.full_damping);
    mean(a.full_spin_damping, w.water.full_spin_damping, c.full_spin_damping);
    // M^-1 = X (1 + f lambda)^-1 X^T, in units of U(f)
    VF weight[6];
    for (int m = 0; m < 6; ++m) weight[m] = unit / (f * constant(w.lambda[m]) + constant(1.0f));
    for (int i = 0, n = 0; i < 6; ++i)
        for (int j = i; j < 6; ++j, ++n) {
            VF sum = weight[0] * constant(w.from[i * 6] * w.from[j * 6]);
            for (int m = 1; m < 6; ++m) sum = weight[m] * constant(w.from[i * 6 + m] * w.from[j * 6 + m]) + sum;
            c.full_inverse[n] = sum;
        }
    set_slip(constant(1.0f), c);
    if constexpr (kAerodynamic)
        aerodynamic_frame(c);
    else
        langevin_modes(damped, w, f, unit, c);
}

// unit: receives U(f)/U_a.
template <bool kFull, bool kAerodynamic>
static HWY_NOINLINE void blend(bool damped, const BodyConstants& a, const WaterBody& w, VF f, LaneConstants& c,
                               VF& unit) {
    const VF one = constant(1.0f), dry = one - f;
    const VF ratio = constant(w.water.unit_mass / a.unit_mass);
    unit = f * ratio + dry;
    const Shares mean{dry / unit, f * ratio / unit};
    c.length = constant(a.length);
    c.unit_mass = unit * constant(a.unit_mass);
    c.weight = mean(a.weight, w.water.weight);
    mean(a.buoyancy, w.water.buoyancy, c.buoyancy);
    c.speed_alpha = constant(a.speed_alpha);
    c.speed_beta = constant(a.speed_beta);
    c.noise_spin = constant(a.noise_spin);
    mean(a.mass, w.water.mass, c.mass);
    mean(a.spin_mass, w.water.spin_mass, c.spin_mass);
    if constexpr (kAerodynamic)
        blend_aerodynamics(a.aerodynamics, w, mean, f, c.aerodynamics);
    else if constexpr (kFull) // resolve_motion() reads them
        for (int i = 0; i < 3; ++i) c.aerodynamics.normal[i] = c.aerodynamics.normal_arm[i] = hn::Zero(DF());
    if constexpr (kFull) {
        blend_full<kAerodynamic>(damped, a, w, f, unit, mean, c);
        for (int i = 0; i < 3; ++i) {
            c.inverse_mass[i] = c.full_inverse[upper6[i][i]];
            c.inverse_spin_mass[i] = c.full_inverse[upper6[i + 3][i + 3]];
        }
        return;
    }
    mean(a.damping, w.water.damping, c.damping);
    mean(a.spin_damping, w.water.spin_damping, c.spin_damping);
    for (int i = 0; i < 3; ++i) {
        c.inverse_mass[i] = one / c.mass[i];
        c.inverse_spin_mass[i] = one / c.spin_mass[i];
        c.rate[i] = c.damping[i] * c.inverse_mass[i];
        c.rate[i + 3] = c.spin_damping[i] * c.inverse_spin_mass[i];
    }
    set_turning(c);
}

void near_surface(const SurfaceInstant& plane, float highest, const WaterBody& w, float dt, float gravity,
                  const BatchArrays& a, size_t begin, size_t end, uint32_t* near) {
    const DU du;
    const VF fall = constant(highest + 2.0f * gravity * dt * dt), travel = constant(1.5f * dt);
    for (size_t at = begin; at < end; at += hn::Lanes(DF())) {
        const Vec3 v = load3(a, field_vx, at);
        const VF radius = constant(w.radius) * load1(a, field_scale, at);
        const VF reach = travel * hn::Sqrt(dot(v, v)) + (radius + fall);
        const VF above = dot(broadcast(plane.up), load3(a, field_x, at) - broadcast(plane.point));
        const auto is_near = hn::RebindMask(du, above <= reach); // false for NaN
        hn::Store(hn::IfThenElseZero(is_near, hn::Set(du, 1)), du, near + (at - begin));
    }
}

void evaluate_surface(const SurfaceInstant& plane, const WaterBody& body, const BatchArrays& a, size_t count, float h,
                      SurfaceBlock& b) {
    for (size_t at = 0; at < count; at += hn::Lanes(DF())) {
        const Quaternion q = load4(a, at);
        const Vec3 v = to_world(q, load3(a, field_vx, at));
        const Vec3 x = within(load3(a, field_x, at) + constant(h) * v, 1e12f);
        const SurfaceSample s = sample_surface(plane, body, load1(a, field_scale, at), q, x);
        store3(b.position, at, x);
        store1(b.height, at, s.height);
        store3(b.normal, at, s.normal);
        store3(b.velocity, at, s.velocity);
        store3(b.rate, at, s.rate);
    }
}

// Loss of motion along the surface's normal by the waves that the body makes (docs/reference/wind_and_water.md, "Waves that bodies make"): minus the
// share lost in half a substep, over the mobility along the normal, in mass units of the body in air.
HWY_NOINLINE VF radiated(const StepInput& in, const WetSubstep& s, const Immersion& at, VF body_scale, VF mobility) {
    const WaterBody& w = *s.body;
    const float *const a = w.semi_axes_squared, *const g = s.gravity;
    const VF one = constant(1.0f);
    const Vec3 along = rows(w.axes, at.normal), stretched = scaled_by(a, along);
    // At scale 1. Without blur: a thin body's waterplane does not depend on the step.
    const VF squared = dot(stretched, along), per_height = one / hn::Sqrt(squared);
    const VF part = hn::Sqrt(constant(16.0f / 3.0f) * at.second); // of the section through the centre
    const VF waterplane = constant(0.75f) * part * per_height;    // over the volume
    const VF unit = mobility * constant(1.0f / in.body.unit_mass);
    const VF number = constant(w.water_mass) * unit * waterplane;
    const VF deep = unit * (constant(w.water_mass) * at.fraction - constant(1.6f * w.mass)) + constant(1.6f);
    const VF force = one / (deep * (constant(0.5f) * deep + one) + one);
    const VF difference = hn::Max(constant(a[0] + a[1] + a[2]) - dot(stretched, stretched) / squared -
                                      constant(2.0f * std::sqrt(a[0] * a[1] * a[2])) * per_height,
                                  hn::Zero(DF()));
    const VF n2 = number * number;
    const VF loss = constant(w.water_mass / w.water_density) * waterplane * n2 * (force * force) /
                    hn::Sqrt(constant(0.25f) * n2 * part * difference + one);
    const float pull = std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    const VF x = constant(0.25f * in.h) * hn::Sqrt(constant(pull) * number / body_scale) * loss;
    return (one / relaxation(x).d - one) / mobility;
}

// Change of added mass in a substep. Fluid that the body begins to move is accelerated, with momentum conserved. Fluid that it leaves keeps its
// momentum, and the body its velocity. Waves are made at the pose `at`, before or after that. None of this adds energy. v, u: relative to the water.
template <bool kFull>
HWY_NOINLINE Twist struck(const StepInput& in, const WetSubstep& s, const Immersion& at, VF body_scale, bool ends,
                          VF before, VF after, Twist t) {
    const WaterBody& w = *s.body;
    const VF one = constant(1.0f);
    const Twist lambda = broadcast6(w.lambda), normal{at.normal, zero3()};
    Twist y = t, along = normal, push = normal;
    if constexpr (kFull) {
        y = general6<false>(w.to, t);
        push = along = general6<true>(w.from, normal);
    } else {
        push.v = scaled_by(in.body.inverse_mass, normal.v);
    }
    push = each_axis6([&](VF p, VF l) LR_LAMBDA { return p / (at.fraction * l + one); }, push, lambda);
    const auto sum = [](const Twist& a, const Twist& b) LR_LAMBDA { return dot(a.v, b.v) + dot(a.u, b.u); };
    push = radiated(in, s, at, body_scale, sum(along, push)) * push;
    const Twist was = y;
    if (!ends) y += sum(along, y) * push;
    y = each_axis6([&](VF x, VF l) LR_LAMBDA { return x * hn::Min((before * l + one) / (after * l + one), one); }, y,
                   lambda);
    if (ends) y += sum(along, y) * push;
    if constexpr (!kFull) return y;
    // Adds the change alone: a zero change must keep every bit.
    return t + general6<false>(w.from, y - was);
}

// Weight and buoyancy between the fluids, over the mass unit. Restoring loads are divided by 1 + h^2/4 times their steepest rate, which makes
// position Verlet stable for any substep.
struct Floating {
    Vec3 force;  // world
    Vec3 torque; // body frame, over d s
    VF stream; // the water's share of it: floats drift at the speed at which both fluids drag alike, by the squares of the speeds
};
HWY_NOINLINE Floating floating(const StepInput& in, const WetSubstep& s, const LaneConstants& c, const Immersion& at,
                               VF body_scale, VF inverse_length, Quaternion q, Vec3 normal, Vec3 rate) {
    const WaterBody& w = *s.body;
    const VF one = constant(1.0f), zero = hn::Zero(DF()), f = at.fraction, dry = one - f;
    const VF per_unit = one / c.unit_mass;
    const VF air = per_unit * constant(w.air_mass), water = per_unit * constant(w.water_mass);
    const Vec3 gravity = broadcast(s.gravity), lower = gravity - rate;
    Floating out;
    const VF wet = hn::Sqrt(f * constant(w.water_density));
    out.stream = wet / (hn::Sqrt(hn::Max(dry, zero) * constant(w.air_density)) + wet);
    out.force = per_unit * constant(w.mass) * (gravity - out.stream * rate);
    out.force -= water * f * lower + air * dry * gravity;
    const Vec3 middle = body_scale * broadcast(w.center);
    // The surface has one pressure, so the parts that it makes of the body are pulled along its normal: a ball in waves is not turned.
    const Vec3 whole = cross(middle, to_body(q, water * f * lower + air * dry * gravity));
    const VF parts = water * dot(normal, lower) - air * dot(normal, gravity);
    out.torque = -inverse_length * (whole + cross(at.lowered, parts * at.normal));

    const auto between = hn::And(f > zero, f < one);
    const VF quarter = hn::IfThenElseZero(between, constant(0.25f * in.h * in.h));
    const VF pull = water * hn::Sqrt(dot(gravity, gravity)) * quarter;
    const VF stiff = pull / at.half_height;
    const Vec3 n = at.normal, mobile = broadcast(c.inverse_mass);
    const VF heave = stiff * constant(0.75f) * dot(n, times(mobile, n));
    const VF less = one / (one + heave) - one;
    out.force += less * dot(normal, out.force) * normal;

    // For each axis of the ellipsoid.
    const VF area = body_scale * body_scale, gyration = inverse_length * inverse_length;
    const VF arm = pull * hn::Sqrt(dot(middle, middle));
    const Vec3 spin = broadcast(c.inverse_spin_mass);
    const auto weaker = [&](int i, VF torque) HWY_ATTR {
        const float gap = w.semi_axes_squared[(i + 1) % 3] - w.semi_axes_squared[(i + 2) % 3];
        const VF steep = stiff * at.second * (area * constant(gap < 0.0f ? -gap : gap)) + arm;
        const Vec3 e = broadcast(w.axes + 3 * i);
        const VF roll = steep * gyration * dot(e, times(spin, e));
        return torque / (one + roll);
    };
    const Vec3 torque = rows(w.axes, out.torque);
    out.torque = columns(w.axes, Vec3{weaker(0, torque.x), weaker(1, torque.y), weaker(2, torque.z)});
    return out;
}

// Always by the splitting scheme, whatever integrator the batch uses in air.
template <bool kFull, bool kAerodynamic>
HWY_NOINLINE void step_wet_bodies(const StepInput& in, const WetSubstep& s, const BatchArrays& a, size_t count) {
    const VF zero = hn::Zero(DF()), half = constant(0.5f * in.h);
    const Vec3 none = zero3();
    for (size_t at = 0; at < count; at += hn::Lanes(DF())) {
        Body b = load_body<kAerodynamic>(a, at);
        const VF body_scale = load1(a, field_scale, at);
        const VF length = body_scale * constant(in.body.length);
        const VF inverse_length = constant(1.0f) / length;
        const Vec3 spin = load3(a, field_wx, at);
        Twist world{load3(a, field_vx, at), length * spin}; // the body's own, body axes

        const Quaternion q = normalised(turn(b.q, b.q, constant(0.25f * in.h), spin));
        const Immersion begin = immersed_at(in, s, *s.begin, at, body_scale, b.q, b.x);
        const Immersion middle = immersed_at(in, s, *s.middle, at, body_scale, q, load3(s.middle->position, at));
        const VF f = middle.fraction;
        store1(s.fraction, at, f);

        const Vec3 lower = load3(s.middle->velocity, at), upper = load3(s.wind, at), rate = load3(s.middle->rate, at);
        const Vec3 stream = to_body(b.q, lower);
        world = struck<kFull>(in, s, begin, body_scale, false, begin.fraction, f, {world.v - stream, world.u});
        world.v += stream;

        LaneConstants c;
        VF unit;
        blend<kFull, kAerodynamic>(in.loads == Loads::langevin, in.body, *s.body, f, c, unit);
        Held held;
        held.inverse_length = inverse_length;
        held.alpha = held.beta = held.shed = zero;
        held.gravity = held.fluid_spin = none;
        held.sheared = false;
        held.uniform = false;
        const Floating loads =
            floating(in, s, c, middle, body_scale, inverse_length, q, load3(s.middle->normal, at), rate);
        held.weight = loads.force;
        held.wind = upper + loads.stream * (lower - upper);
        External external{};
        for (Twist* t : {external.force, external.force + 1, external.rate, external.rate + 1}) *t = {none, none};
        if (in.external.any) external = take_external(in.external, c, body_scale, at);
        // As a torque in the body's frame: in the world's, a step that turns the body far would apply it about an axis without torque or inertia.
        external.force[1].u += loads.torque;
        held.external = &external;

        // The frame moves with the fluid, which accelerates.
        const Vec3 half_change = half * loads.stream * rate;
        b.t = {world.v - to_body(b.q, held.wind - half_change), world.u};
        const VU noise_seed = load1(a.noise_seed, at);
        if constexpr (kAerodynamic) vary(in, noise_seed, held);
        const VF beta_unit = c.speed_beta * inverse_length;
        const uint32_t motions = motions_of<kAerodynamic, Integrator::splitting>(in);
        for (uint32_t motion = 0; motion < motions; ++motion)
            one_motion<kFull, kAerodynamic, Integrator::splitting>(in, c, held, noise_seed, 0, motion, beta_unit, b);

        const Vec3 v = b.t.v + to_body(b.q, held.wind + half_change);
        store_body<kAerodynamic>(a, at, b, v, inverse_length * b.t.u, in.h, in.faults);
    }
}

void step_wet(const StepInput& in, const WetSubstep& s, const BatchArrays& a, size_t count) {
    for_variant(in, [&]<bool kFull, bool kAerodynamic>()
                        HWY_ATTR { step_wet_bodies<kFull, kAerodynamic>(in, s, a, count); });
}

void settle_wet(const StepInput& in, const WetSubstep& s, const BatchArrays& a, size_t count) {
    for (size_t at = 0; at < count; at += hn::Lanes(DF())) {
        const Quaternion q = load4(a, at);
        const VF body_scale = load1(a, field_scale, at);
        const VF length = body_scale * constant(in.body.length);
        const Immersion end = immersed_at(in, s, *s.end, at, body_scale, q, load3(a, field_x, at));
        const Vec3 stream = to_body(q, load3(s.end->velocity, at));
        const Twist t{load3(a, field_vx, at) - stream, length * load3(a, field_wx, at)};
        const VF f = load1(s.fraction, at);
        Twist after = s.body->diagonal ? struck<false>(in, s, end, body_scale, true, f, end.fraction, t)
                                       : struck<true>(in, s, end, body_scale, true, f, end.fraction, t);
        after.v += stream;
        const VF inverse_length = constant(1.0f) / length;
        store_velocities(a, at, after.v, inverse_length * after.u, in.faults);
        store1(s.fraction, at, end.fraction);
    }
}
} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
