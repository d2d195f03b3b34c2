// The fluid's loads on one body, for lr_body_get_loads(). Compiled once, next to Runge-Kutta, whose functions it shares.
#if defined(LR_KERNEL_LOADS_BODY_LOADS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_LOADS_BODY_LOADS_INL_H_
#undef LR_KERNEL_LOADS_BODY_LOADS_INL_H_
#else
#define LR_KERNEL_LOADS_BODY_LOADS_INL_H_
#endif

#include "kernel/loads/station_loads-inl.h"
#include "langevin_rigid_research.h"

HWY_BEFORE_NAMESPACE();
namespace lr::LR_KERNEL_NAMESPACE {

HWY_INLINE void body_loads(const StepInput& in, const BodyConstants& c, const BatchArrays& arrays,
                           const float (&fluid)[3], lr_body_loads& out) {
    const auto& a = c.aerodynamics;
    const auto put = [](Vec3 v, float* to) LR_LAMBDA { // all lanes are equal
        to[0] = least_lane(v.x), to[1] = least_lane(v.y), to[2] = least_lane(v.z);
    };
    const Body b = load_body<true>(arrays, 0);
    const VF scale = load1(arrays, field_scale, 0), length = scale * constant(c.length);
    const VF mass = scale * scale * scale * constant(c.unit_mass);
    Held held;
    held.inverse_length = constant(1.0f) / length;
    vary(in, load1(arrays.noise_seed, 0), held);
    const VF nu = constant(a.viscosity) * held.inverse_length;
    const Vec3 stream = broadcast(fluid) + b.gust - to_world(b.q, load3(arrays, field_vx, 0));
    const Twist t{zero3() - to_body(b.q, stream), length * load3(arrays, field_wx, 0)};

    const auto add = [&](const float* place, Vec3 force) LR_LAMBDA {
        put(b.x + length * to_world(b.q, broadcast(place)), out.station_position + 3 * out.station_count);
        put(mass * to_world(b.q, force), out.station_force + 3 * out.station_count);
        ++out.station_count;
    };
    Twist sum;
    out.station_count = 0;
    if (c.stations.count == 0) {
        VF shed;
        sum = aerodynamic_loads(a, held, b, t, shed);
        const Twist none{zero3(), zero3()};
        sum += push_of_shed(held.inverse_length, none - moving_momentum<true, true>(c, shed, none, t), t);
        add(a.arm, sum.v);
    } else {
        sum = {zero3(), columns(a.axes, shedding_couple(a, held, b.shedding, centre_velocity<true>(a, t)))};
        for (uint32_t i = 0; i < c.stations.count; ++i) {
            StationSet one;
            one.station[0] = c.stations.station[i];
            one.count = 1;
            const Resistance k = station_resistance(one, a, held, nu, b.lag, t);
            const Twist f = resisted(k, t) + push_of_shed(held.inverse_length, k.lost, t);
            add(one.station[0].place, f.v);
            sum += f;
        }
    }
    put(stream, out.stream);
    put(zero3() - to_world(b.q, columns(a.axes, b.lag)), out.wake);
    put(to_world(b.q, columns(a.axes, Vec3{b.shedding[0], b.shedding[1], hn::Zero(DF())})), out.shedding);
    put(mass * to_world(b.q, sum.v), out.force);
    put(mass * length * to_world(b.q, sum.u), out.torque);
}
} // namespace lr::LR_KERNEL_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
