// Steps bodies through the substeps of a step, a vector at a time, with all loads and integrators.
#if defined(LR_KERNEL_INTEGRATOR_STEP_BODIES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_INTEGRATOR_STEP_BODIES_INL_H_
#undef LR_KERNEL_INTEGRATOR_STEP_BODIES_INL_H_
#else
#define LR_KERNEL_INTEGRATOR_STEP_BODIES_INL_H_
#endif

#include "hwy/cache_control.h"
#include "kernel/integrator/equations_of_motion-inl.h"
#include "kernel/integrator/splitting_scheme-inl.h"
#include "kernel/integrator/step.h"
#include "kernel/loads/aerodynamic_loads-inl.h"
#include "kernel/loads/station_loads-inl.h"
#include "kernel/math/gaussian_noise-inl.h"

#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

// In sample_wind.cpp: before and after a substep in a wind field, for the bodies from `first` on.
void enter_wind(const StepInput&, const WindAlong&, uint32_t substep, size_t first, size_t lanes, BodiesInWind& bodies);
void leave_wind(const StepInput&, const WindAlong&, size_t first, size_t lanes, BodiesInWind& bodies);
} // namespace lr::HWY_NAMESPACE
namespace lr::LR_KERNEL_NAMESPACE {

// Time derivative of the twist (physics.md, section 3). P, L: momenta over the mass unit, w = u/(d s).
//   P' = P x w + weight vector - alpha rho (V + A) v + noise
//   L' = L x w + P x v/(d s) + b x R^T g - alpha rho D' (u - fluid spin) + noise
// In Munk's moment P x v the body's own momentum is parallel to v and drops out.
template <bool kFull, bool kAerodynamic, class C>
HWY_INLINE Twist twist_rate(const StepInput& in, const C& c, const Held& held, Quaternion q, Twist t) {
    const Twist p = moving_momentum<kFull, kAerodynamic>(c, held.shed, momentum<kFull>(c, t), t);
    Twist f;
    f.v = to_body(q, held.weight) + held.inverse_length * cross(p.v, t.u);
    f.u = held.inverse_length * (cross(p.u, t.u) + cross(p.v, t.v));
    if constexpr (kFull) f.u += cross(broadcast(c.buoyancy), to_body(q, held.gravity));
    if (held.external) f += external_force<kFull>(c, *held.external, q);
    if (!kAerodynamic && in.loads == Loads::langevin) {
        VF alpha = held.alpha;
        if (in.clock == Clock::speed) alpha = constant(c.speed_alpha) * held.inverse_length * hn::Sqrt(dot(t.v, t.v));
        if (held.sheared) t.u -= to_body(q, held.fluid_spin); // the drag of spin acts on the spin relative to the fluid
        const Twist d = dragged<kFull>(c, t);
        f.v = f.v + held.noise.v - alpha * d.v;
        f.u = f.u + held.noise.u - alpha * d.u;
    }
    return acceleration<kFull>(c, f);
}

// The paper's scheme: classical Runge-Kutta with the noise fixed over the stages (physics.md, section 4; numerics.md).
template <bool kFull, bool kAerodynamic, class C>
HWY_INLINE void rk4_substep(const StepInput& in, const C& c, Held& held, VF beta_unit, const VF gauss[6], Body& b) {
    const VF h = constant(in.h), half = constant(0.5f * in.h), quarter = constant(0.25f * in.h);
    if (!kAerodynamic && in.loads == Loads::langevin) {
        VF beta;
        if (in.clock == Clock::speed) {
            const VF s2 = dot(b.t.v, b.t.v);
            beta = hn::Sqrt(beta_unit * (s2 * hn::Sqrt(s2)));
        } else {
            VF beta_squared;
            sample_table(in.table, b.age + half, held.alpha, beta_squared);
            beta = hn::Sqrt(beta_squared);
        }
        beta *= constant(in.inverse_sqrt_h);
        const VF spin_beta = beta * constant(c.noise_spin);
        held.noise = dragged<kFull>(c, {beta * broadcast(gauss), spin_beta * broadcast(gauss + 3)});
    }
    static_assert(kFull || !kAerodynamic);
    const auto rate = [&](Quaternion q, Twist t) LR_LAMBDA {
        if constexpr (!kAerodynamic) {
            return twist_rate<kFull, false>(in, c, held, q, t);
        } else {
            const Vec3 fluid_spin = held.sheared ? to_body(q, held.fluid_spin) : zero3();
            Twist loads;
            if (in.body.stations.count != 0) {
                const VF nu = constant(c.aerodynamics.viscosity) * held.inverse_length;
                loads = station_loads(in, c, held, nu, b, fluid_spin, t);
            } else {
                loads = aerodynamic_loads(c.aerodynamics, held, b, {t.v, t.u - fluid_spin}, held.shed);
            }
            return twist_rate<true, true>(in, c, held, q, t) + acceleration<true>(c, loads);
        }
    };
    const auto spin = [&](Twist t) LR_LAMBDA { return held.inverse_length * t.u; };

    const Twist k1 = rate(b.q, b.t);
    const Vec3 w1 = spin(b.t);
    Vec3 travel = to_world(b.q, b.t.v);
    Quaternion turned = turn(b.q, b.q, constant(in.h / 12.0f), w1);

    Quaternion q = turn(b.q, b.q, quarter, w1);
    Twist t = b.t + half * k1;
    const Twist k2 = rate(q, t);
    const Vec3 w2 = spin(t);
    Vec3 middle = to_world(q, t.v);
    turned = turn(turned, q, constant(in.h / 6.0f), w2);

    q = turn(b.q, q, quarter, w2);
    t = b.t + half * k2;
    const Twist k3 = rate(q, t);
    const Vec3 w3 = spin(t);
    middle += to_world(q, t.v);
    turned = turn(turned, q, constant(in.h / 6.0f), w3);

    q = turn(b.q, q, half, w3);
    t = b.t + h * k3;
    const Twist k4 = rate(q, t);
    travel += to_world(q, t.v);
    turned = turn(turned, q, constant(in.h / 12.0f), spin(t));

    const VF sixth = constant(in.h / 6.0f);
    b.x += h * held.wind;
    b.x += sixth * (travel + (middle + middle));
    const Twist inner = k2 + k3;
    b.t += sixth * (k1 + k4 + (inner + inner));
    b.q = normalised(turned);
    grow_older(b, h);
}

// External forces over a step, in kernel units. Clears those on single bodies for the next step.
template <class C>
static HWY_NOINLINE External take_external(const ExternalInput& in, const C& c, VF body_scale, size_t at) {
    VF sum[force_components];
    for (size_t i = 0; i < force_components; ++i) {
        sum[i] = constant(in.batch[i]);
        if ((in.used >> i / 3 & 1u) == 0) continue;
        float* const own = in.bodies + i * in.stride + at;
        sum[i] += load1(own, 0);
        if (in.clear) store1(own, 0, hn::Zero(DF()));
    }
    const VF length = body_scale * constant(c.length);
    const VF cube = body_scale * body_scale * body_scale;
    const VF per_mass = constant(1.0f) / (cube * constant(c.unit_mass));
    const VF per_moment = per_mass / length;
    const auto vector = [&](size_t frame, size_t kind, VF unit) LR_LAMBDA {
        const VF* const v = sum + force_component(frame, kind);
        return Vec3{v[0] * unit, v[1] * unit, v[2] * unit};
    };
    External out;
    for (size_t frame = 0; frame < 2; ++frame) {
        out.force[frame] = {vector(frame, force_newton, per_mass), vector(frame, force_torque, per_moment)};
        out.rate[frame] = {vector(frame, force_acceleration, constant(1.0f)), vector(frame, force_spin, length)};
    }
    return out;
}

// Uniform wind in the middle of a substep.
HWY_INLINE Vec3 wind_of_substep(const StepInput& in, uint32_t i) {
    const float part = (static_cast<float>(i) + 0.5f) / static_cast<float>(in.substeps);
    float wind[3];
    for (int k = 0; k < 3; ++k) wind[k] = in.wind_begin[k] + part * (in.wind[k] - in.wind_begin[k]);
    return broadcast(wind);
}

// Rate and stationary variance of gusts. Near water, where constants differ from lane to lane, a gust also decays by its own speed: what floats goes
// along with it, and would otherwise keep it for ever.
struct Gusts {
    VF alpha, variance;
};
template <class A>
HWY_INLINE Gusts gusts_at(const StepInput& in, const A& a, const Held& held, VF nu, const Body& b, Vec3 v) {
    if (HWY_LIKELY(in.clock == Clock::speed)) {
        const VF speed = hn::Sqrt(speed_squared(v)), turbulent = speed / (constant(a.wake_reynolds) * nu + speed);
        VF pace = speed;
        if constexpr (!std::is_same_v<A, AerodynamicConstants>) pace = hn::Max(speed, hn::Sqrt(dot(b.gust, b.gust)));
        return {constant(a.rate_of_gusts) * held.inverse_length * pace,
                constant(a.variance_of_gusts) * (turbulent * turbulent) * weighted(a.broadside, times(v, v))};
    }
    VF alpha, beta_squared;
    sample_table(in.table, constant(0.5f) * constant(in.h) + b.age, alpha, beta_squared);
    return {alpha, constant(a.gust_gain) * beta_squared / (alpha + alpha + constant(1e-20f))};
}

// One motion of a substep. The body is in a patch of air with its own gust: it moves through the patch, and after the last motion the patch takes its
// next velocity while the body keeps its velocity in the world. The wake advances once a substep, before the first motion.
template <bool kFull, Integrator kIntegrator, class C>
HWY_INLINE void aerodynamic_motion(const StepInput& in, const C& c, Held& held, VU noise_seed, uint32_t substep,
                                   uint32_t motion, Body& b) {
    const auto& a = c.aerodynamics;
    const VF nu = constant(a.viscosity) * held.inverse_length;
    VF gauss[3], noise[2];
    three_gaussians(noise_seed, in.first_substep + substep, in.seed, gauss, noise);
    if (HWY_LIKELY(motion == 0)) {
        b.t.v -= to_body(b.q, b.gust);
        const Vec3 v = centre_velocity<kFull>(a, b.t);
        if (!kFull || in.body.stations.count == 0) {
            // Gusts disturb the shedding of a plate. Its couple is n x q: without `side`, which tells if n points downstream, discs would tumble more
            // one way.
            const VF side = hn::IfThenElse(v.z > hn::Zero(DF()), constant(-1.0f), constant(1.0f));
            const Vec3 seen = side * load_spin<kFull>(a, {zero3(), to_body(b.q, broadcast(gauss))});
            noise[0] = seen.x, noise[1] = seen.y;
        }
        advance_wake(in, a, held, nu, hn::Sqrt(gusts_at(in, a, held, nu, b, v).variance), noise, v,
                     load_spin<kFull>(a, b.t), b);
        b.x += constant(in.h) * b.gust;
    }
    Vec3 middle;
    if constexpr (kIntegrator == Integrator::splitting) {
        const float h = in.h / static_cast<float>(in.motions);
        if (kFull && in.body.stations.count != 0)
            middle = station_motion(in, h, c, held, nu, b);
        else
            middle = splitting_motion<kFull>(h, c, held, nu, b);
        if (HWY_UNLIKELY(motion + 1 < in.motions)) return;
        b.x += constant(in.h) * held.wind;
        grow_older(b, constant(in.h));
    } else {
        middle = centre_velocity<kFull>(a, b.t);
        rk4_substep<kFull, true>(in, c, held, hn::Zero(DF()), gauss, b);
    }
    b.t.v += to_body(b.q, b.gust);
    const Gusts gusts = gusts_at(in, a, held, nu, b, middle);
    b.gust = without_dust(next_gust(b.gust, gusts.alpha, gusts.variance, in.h, gauss));
}

// Motions in a substep: one, except in the splitting scheme with AERODYNAMIC loads.
template <bool kAerodynamic, Integrator kIntegrator> HWY_INLINE uint32_t motions_of(const StepInput& in) {
    return kAerodynamic && kIntegrator == Integrator::splitting ? in.motions : 1;
}
template <bool kFull, bool kAerodynamic, Integrator kIntegrator, bool kUsual = false, class C>
HWY_INLINE void one_motion(const StepInput& in, const C& c, Held& held, VU noise_seed, uint32_t substep,
                           uint32_t motion, VF beta_unit, Body& b) {
    if constexpr (kAerodynamic) {
        aerodynamic_motion<kFull, kIntegrator>(in, c, held, noise_seed, substep, motion, b);
        return;
    }
    VF gauss[6];
    if (HWY_LIKELY(!without_loads<kUsual>(in)))
        six_gaussians(noise_seed, in.first_substep + substep, in.seed, gauss);
    else
        for (VF& g : gauss) g = hn::Zero(DF());
    if constexpr (kIntegrator == Integrator::splitting)
        splitting_substep<kFull, kUsual>(in, c, held, beta_unit, gauss, b);
    else
        rk4_substep<kFull, false>(in, c, held, beta_unit, gauss, b);
}

// Calls f<kFull, kAerodynamic>() for the batch, in the body's frame. Loads::none uses the LANGEVIN variant.
template <class F> HWY_INLINE void for_variant(const StepInput& in, const F& f) {
    if (in.loads == Loads::aerodynamic)
        f.template operator()<true, true>();
    else
        in.body.diagonal ? f.template operator()<false, false>() : f.template operator()<true, false>();
}

constexpr size_t line = 64 / sizeof(float);

// Prefetches the next bodies: a large world has too many arrays for the hardware prefetcher. `at` may be past the last body.
template <bool kAerodynamic> HWY_INLINE void prefetch(const BatchArrays& a, size_t at, size_t count) {
    constexpr size_t fields = kAerodynamic ? field_count : size_t{field_gust_x};
    for (size_t i = 0; i < count; i += line) {
        for (size_t f = 0; f < fields; ++f) hwy::Prefetch(a.field[f] + at + i);
        hwy::Prefetch(a.noise_seed + at + i);
    }
}

// Into a sheet's frame with its load centre, and back.
template <class C> HWY_INLINE void enter_frame(const C& c, Quaternion frame, Body& b) {
    b.q = product(b.q, frame);
    b.t.u = rows(c.aerodynamics.axes, b.t.u);
    b.t.v = rows(c.aerodynamics.axes, b.t.v) + arm_velocity(c, b.t.u);
}
template <class C> HWY_INLINE void leave_frame(const C& c, Quaternion frame, Body& b) {
    b.q = product(b.q, {-frame.x, -frame.y, -frame.z, frame.w});
    b.t = {columns(c.aerodynamics.axes, b.t.v - arm_velocity(c, b.t.u)), columns(c.aerodynamics.axes, b.t.u)};
}

// AERODYNAMIC loads without kFull: a sheet, in its own frame.
template <bool kFull, bool kAerodynamic, Integrator kIntegrator, bool kUsual = false>
HWY_NOINLINE void step_bodies(const StepInput& in, const BatchArrays& a, size_t begin, size_t end) {
    constexpr bool kSheet = kAerodynamic && !kFull;
    const BodyConstantsOf<float>* constants = &in.body;
    if constexpr (kSheet) constants = &in.sheet;
    const BodyConstantsOf<float>& c = *constants;
    const WindAlong* const wind = a.wind;
    BodiesInWind moving;
    const Vec3 gravity = broadcast(in.gravity);
    const Vec3 weight = constant(c.weight) * gravity;
    Quaternion frame;
    if constexpr (kSheet)
        frame = {constant(in.sheet.turn[0]), constant(in.sheet.turn[1]), constant(in.sheet.turn[2]),
                 constant(in.sheet.turn[3])};
    for (size_t at = begin; at < end; at += hn::Lanes(DF())) {
        const size_t together = HWY_MAX(hn::Lanes(DF()), line);
        if (at % together == 0) prefetch<kAerodynamic>(a, at + together, together);
        Body b = load_body<kAerodynamic>(a, at);
        const VF length = load1(a, field_scale, at) * constant(c.length);
        Held held;
        held.inverse_length = constant(1.0f) / length;
        held.alpha = held.beta = held.shed = hn::Zero(DF());
        held.wind = broadcast(in.wind);
        held.gravity = gravity;
        held.weight = weight;
        held.fluid_spin = zero3();
        held.sheared = false;
        held.uniform = true;
        // In uniform wind the velocity relative to the wind is stepped, as in fluid at rest.
        b.t = {load3(a, field_vx, at), length * load3(a, field_wx, at)};
        if (!wind) b.t.v -= to_body(b.q, broadcast(in.wind_begin));
        External external;
        if (in.external.any) {
            external = take_external(in.external, c, load1(a, field_scale, at), at);
            held.external = &external;
        }
        const VU noise_seed = load1(a.noise_seed, at);
        if constexpr (kAerodynamic) vary(in, noise_seed, held);
        store1(moving.length, 0, length);
        const VF beta_unit = constant(c.speed_beta) * held.inverse_length;

        const uint32_t motions = motions_of<kAerodynamic, kIntegrator>(in);
        const size_t first = wind && wind->known ? at - begin : 0;
        for (uint32_t i = 0; i < in.substeps; ++i) {
            if (in.wind_changes) held.wind = wind_of_substep(in, i);
            if (wind) {
                // Rounded as if stored and loaded, so that results do not depend on how a step is divided into calls.
                if (i != 0) b.t.u = length * without_dust(held.inverse_length * b.t.u);
                store3(moving.x, 0, b.x);
                store4(moving.q, 0, b.q);
                store3(moving.v, 0, b.t.v);
                enter_wind(in, *wind, i, first, hn::Lanes(DF()), moving);
                held.wind = load3(moving.wind, 0);
                held.weight = load3(moving.weight, 0);
                if constexpr (kFull || kSheet) held.gravity = load3(moving.gravity, 0);
                held.uniform = wind->everywhere;
                held.sheared = !held.uniform;
                if (held.sheared) held.fluid_spin = load3(moving.spin, 0);
                b.t.v = load3(moving.v, 0);
            }
            if constexpr (kSheet) enter_frame(c, frame, b);
            for (uint32_t motion = 0; motion < motions; ++motion)
                one_motion<kFull, kAerodynamic, kIntegrator, kUsual>(in, c, held, noise_seed, i, motion, beta_unit, b);
            if constexpr (kSheet)
                leave_frame(c, frame, b); // in each substep: results must not depend on how a step is divided
            if (wind) {
                store4(moving.q, 0, b.q);
                store3(moving.v, 0, b.t.v);
                store3(moving.u, 0, b.t.u);
                leave_wind(in, *wind, first, hn::Lanes(DF()), moving);
                b.t = {load3(moving.v, 0), load3(moving.u, 0)};
            }
        }

        if (!wind) b.t.v += to_body(b.q, broadcast(in.wind));
        store_body<kAerodynamic>(a, at, b, b.t.v, held.inverse_length * b.t.u, in.h * static_cast<float>(in.substeps),
                                 in.faults);
    }
}
} // namespace lr::LR_KERNEL_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
