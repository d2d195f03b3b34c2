// Guarantees of the default scheme for any body and step: states stay finite, and energy grows only by the loads' work.
#include "support/aerodynamic_fields.h"
#include "support/energy.h"
#include "support/lost_bodies.h"
#include "support/quick.h"
#include "support/wind.h"

#include <cstddef>
#include <numbers>
#include <string>

using namespace test;

namespace {

constexpr double g = 9.81;

struct Draw {
    lr_ellipsoid_desc shape;
    lr_batch_desc batch;
    Asset asset;
    bool full = false;
    bool couples = false; // the wake sheds vortices, whose couple does work
};

// Confetti of 2 mm to banners of 1 m, down to 1:1000 thin, from barely heavier than the fluid to 10^4 times; and bubbles.
Draw draw_body(Random& random, int i, bool noise) {
    Draw out;
    const double size = 0.5 * random.logarithmic(2e-3, 1.0);
    const bool water = random.below(3) == 0;
    const double fluid = water ? 1000.0 : 1.2;
    const double ratio =
        std::array{random.logarithmic(1.01, 1e4), 1.0001, random.logarithmic(0.01, 0.99)}[random.below(3)];
    out.shape = ellipsoid(size, size * random.logarithmic(0.02, 1.0), size * random.logarithmic(1e-3, 1.0),
                          fluid * std::min(ratio, 2e4 / fluid));
    for (double& a : out.shape.semi_axes) a = std::max(a, 1.1e-6);
    if (water) out.shape = in_water(out.shape);
    if (i % 2)
        for (size_t k = 0; k < 3; ++k) out.shape.center_of_mass[k] = random.uniform(-0.5, 0.5) * out.shape.semi_axes[k];
    out.batch = batch_desc();
    out.batch.load_model =
        std::array{LR_LOADS_AERODYNAMIC, LR_LOADS_AERODYNAMIC, LR_LOADS_LANGEVIN, LR_LOADS_NONE}[random.below(4)];
    out.batch.clock = random.below(2) ? LR_CLOCK_AGE : LR_CLOCK_SPEED;
    out.batch.damping_gain = random.real(noise ? 0.5 : 0.0, 3.0);
    out.batch.noise_gain = noise ? random.real(0.0, 2.0) : 0.0f;
    if (random.below(4) == 0) out.full = true;
    out.asset = make(out.shape);
    return out;
}

// A plate and its wake with anything that an asset file can have.
void draw_plate(Random& random, double d, lr_aerodynamics& a) {
    for (const AerodynamicField& f : aerodynamic_fields) {
        if (f.offset < offsetof(lr_aerodynamics, plate_lift)) continue;
        const double unit = f.power == 0.0 ? 1.0 : 1e-10 * std::pow(d, f.power), least = unit * f.least,
                     most = unit * f.most;
        for (size_t k = 0; k < f.size; ++k) {
            double& value = f.in(a)[k];
            const uint32_t kind = random.below(8);
            if (kind < 4) continue; // the body's own
            if (kind == 4) value = least;
            if (kind == 5) value = most;
            if (kind == 6) value = random.uniform(least, std::min(most, least + 10.0 * unit));
            if (kind == 7)
                value = random.logarithmic(std::max(least, 1e-9 * most), most) *
                        (least < 0.0 && random.below(2) ? -1.0 : 1.0);
        }
    }
}

// Returns the coefficients and gains of AERODYNAMIC loads.
struct DrawnLoads {
    lr_aerodynamics at{};
    double lift_gain = 1.0;
};
DrawnLoads draw_loads(Random& random, const World& world, lr_batch batch, bool noise, Draw& draw) {
    DrawnLoads out;
    if (random.below(4) == 0) {
        // Turbulence with the SPEED clock grows with the body's own speed: it can have unlimited energy.
        const double chi = random.logarithmic(1e-3, 1e3);
        set_constant_table(world, batch, chi, chi * random.logarithmic(1e-4, 0.03), 2.0);
    }
    if (draw.batch.load_model != LR_LOADS_AERODYNAMIC) return out;
    lr_aerodynamics a = initialised(lr_aerodynamics_init);
    REQUIRE(lr_asset_get_aerodynamics(draw.asset.get(), &a) == LR_OK);
    if (random.below(3) == 0)
        for (size_t k = 0; k < 3; ++k) {
            for (double* c : {a.drag, a.drag_blunt, a.drag_layer, a.drag_stokes, a.lift, a.spin_lift, a.spin_drag,
                              a.spin_drag_stream, a.spin_drag_stokes})
                c[k] *= random.below(4) == 0 ? 0.0 : random.logarithmic(0.01, 100.0);
            if (random.below(2)) a.lift[k] = -a.lift[k];
        }
    if (random.below(2)) draw_plate(random, info_of(draw.asset).length_d, a);
    if (!draw.couples) a.shedding_moment = a.shedding_rate_moment = 0.0;
    REQUIRE(lr_batch_set_aerodynamics(world.get(), batch, &a) == LR_OK);
    lr_load_gains gains = initialised(lr_load_gains_init);
    gains.drag = random.real(0.0, 10.0), gains.lift = random.real(0.0, 10.0), gains.spin_drag = random.real(0.0, 10.0);
    gains.turbulence = noise ? random.real(0.0, 3.0) : 0.0f;
    REQUIRE(lr_batch_set_load_gains(world.get(), batch, &gains) == LR_OK);
    out.at = a, out.lift_gain = wide(gains.lift);
    return out;
}

// The speed, as the root of twice an energy, that the largest weight and buoyancy couple give in a second.
double pull(const ReferenceBody& body) {
    const Matrix6 m = inverse(body.mass);
    double trace_v = 0.0, trace_w = 0.0;
    for (size_t k = 0; k < 3; ++k) trace_v += m[k][k], trace_w += m[k + 3][k + 3];
    // f.N f <= |f|^2 trace N, N positive definite; force and couple one after the other.
    return std::sqrt(trace_v) * std::abs(body.weight) * g +
           std::sqrt(trace_w) * body.displaced * length(body.buoyancy_arm) * g;
}

// Bound of the shedding couple's contribution to the same root in a substep. It acts twice for h/2, with at most
// rho v^2 (|m| |q| + |n| |r|), in the second half extrapolated to thrice that, and pushes the rim at most to eight times the speed of the
// stream in each direction (docs/maintainers/numerics.md). Without noise the oscillator never exceeds its limit cycle.
class CoupleBound {
public:
    CoupleBound(const ReferenceBody& body, const lr_asset_info& info, const DrawnLoads& loads, double scale, bool full)
        : diagonal_(!full && (info.flags & LR_ASSET_DIAGONAL) != 0) {
        const Matrix6 m = inverse(body.mass);
        // The largest eigenvalues, by Gershgorin's circles. v.M v and w.I w are the squares of the root.
        double mobility = 0.0, spin_mobility = 0.0, inertia = 0.0;
        for (size_t k = 0; k < 3; ++k) {
            double row = 0.0, spin_row = 0.0;
            for (size_t j = 0; j < 3; ++j) row += std::abs(m[k][j]), spin_row += std::abs(m[k + 3][j + 3]);
            mobility = std::max(mobility, row), spin_mobility = std::max(spin_mobility, spin_row);
            inertia += body.mass[k + 3][k + 3];
        }
        fastest_ = std::sqrt(mobility) + length(body.buoyancy_arm) * std::sqrt(spin_mobility);
        strength_ = info.fluid_density * std::pow(scale, 3.0) * loads.lift_gain * std::sqrt(spin_mobility);
        // Both axes of the plate: one after the other, or of a diagonal body at once.
        rim_ = most_rim * std::sqrt((diagonal_ ? 1.0 : 2.0) * inertia) / (info.length_d * scale);
        moment_ = std::abs(loads.at.shedding_moment), rate_moment_ = std::abs(loads.at.shedding_rate_moment);
    }
    // The root of the energy after a substep, from its value before.
    double after(double root, double h, double pull) const {
        const double strongest = strength_ * std::numbers::sqrt2 * (moment_ + rate_moment_);
        double stream = root += h * pull;
        for (int i = 0; i < 2; ++i) {
            const double v = fastest_ * root, times = i == 0 ? 1.0 : 3.0;
            root += std::min(0.5 * h * times * strongest * v * v, rim_ * fastest_ * stream);
            if (!diagonal_) stream = root; // a couple moves a load centre that lies off the centre of mass
        }
        return root;
    }

private:
    static constexpr double most_rim = 8.0;
    bool diagonal_;
    double fastest_, strength_, rim_, moment_, rate_moment_;
};

// The rounding error of single precision in a step.
constexpr double rounding_share = 1e-4;

} // namespace

// The root of the kinetic energy is a norm of the velocities. For any step, drag, lift, Munk moment, added mass, momentum left in the
// wake, the wake's memory and its starting drag cannot increase it; weight and buoyancy at most by their impulse, h times the norm of
// the force, and the couple of shed vortices by its bound.
TEST_CASE("random bodies at random steps gain no more energy than weight and the couple of shedding give them") {
    const int batches = quick() ? 300 : 2000; // couples give energy in few of them
    const uint32_t bodies = 50;
    double worst[3] = {-1.0, -1.0, -1.0};
    uint32_t gained = 0; // steps in which a couple gave more than weight can
    for (int i = 0; i < batches; ++i) {
        Random random(4000 + static_cast<uint64_t>(i));
        Draw draw = draw_body(random, i, false);
        draw.couples = i % 4 >= 2;
        const World world = make(world_desc());
        const double gust = random.below(2) ? 60.0 : 0.0;
        const Vec wind{wide(random.real(-0.57, 0.57)) * gust, wide(random.real(-0.57, 0.57)) * gust, 0.0};
        set_wind(world, narrow(wind[0]), narrow(wind[1]), narrow(wind[2]));
        const lr_batch batch = add_batch(world, draw.batch, draw.asset, bodies, draw.full);
        const DrawnLoads loads = draw_loads(random, world, batch, false, draw);
        const lr_asset_info info = info_of(draw.asset);
        std::vector<ReferenceBody> reference;
        std::vector<CoupleBound> couples;
        for (uint32_t k = 0; k < bodies; ++k) {
            const lr_body_desc b = draw_motion(random, draw.shape.semi_axes[2]);
            add_body(world, batch, b);
            reference.emplace_back(info, wide(b.scale));
            couples.emplace_back(reference.back(), info, loads, wide(b.scale), draw.full);
        }
        const bool coupled =
            (loads.at.shedding_moment != 0.0 || loads.at.shedding_rate_moment != 0.0) && loads.lift_gain > 0.0;
        // Diagonal batches drop entries off the diagonals, which a whole ellipsoid does not have.
        const float dt = static_cast<float>(random.logarithmic(1e-4, 0.1));
        const uint32_t substeps = 1 + random.below(3);
        std::vector<double> before(bodies);
        lr_batch_view v = view_of(world, batch);
        std::vector<Velocity> u = velocities_of(world, batch);
        for (uint32_t k = 0; k < bodies; ++k) before[k] = std::sqrt(2.0 * energy(reference[k], v, u, k, wind));
        for (int n = 0; n < 20; ++n) {
            steps(world, 1, dt, substeps);
            v = view_of(world, batch);
            u = velocities_of(world, batch);
            for (uint32_t k = 0; k < bodies; ++k) {
                const double now = std::sqrt(2.0 * energy(reference[k], v, u, k, wind));
                double most = before[k] + wide(dt) * pull(reference[k]);
                if (coupled) {
                    most = before[k];
                    for (uint32_t j = 0; j < substeps; ++j)
                        most = couples[k].after(most, wide(dt) / substeps, pull(reference[k]));
                }
                // Adding and subtracting the wind rounds single numbers.
                const double rounding =
                    1e-6 *
                    (before[k] +
                     std::sqrt(reference[k].mass[0][0] + reference[k].mass[1][1] + reference[k].mass[2][2]) * gust);
                const double excess = (now - most - 20.0 * rounding) / (most + rounding);
                if (coupled && now > before[k] + wide(dt) * pull(reference[k]) * 1.01) ++gained;
                double& so_far = worst[draw.batch.load_model == LR_LOADS_NONE ? 1 : coupled ? 2 : 0];
                if (!(excess <= so_far)) {
                    so_far = excess;
                    CAPTURE(i);
                    CAPTURE(k);
                    CAPTURE(n);
                    CAPTURE(dt);
                    CAPTURE(draw.batch.load_model);
                    CHECK(excess <= rounding_share);
                }
                before[k] = now;
            }
        }
    }
    MESSAGE("largest excess with loads ", worst[0], ", without ", worst[1], ", with couples of shedding ", worst[2],
            ", which gave energy in ", gained, " steps");
    CHECK(gained > 0);
}

// With the shape's own coefficients and wake noise, during a long fall: no load keeps more energy in a body than at its start, or than
// at terminal speed edge on with the spin at which spin drag balances the couple of shedding, its oscillator being in its limit cycle:
// at terminal speed, or in the fastest stream from its initial energy. The wake carries a body along with up to 3 I^2 of the square of
// its speed, averaged over bodies.
TEST_CASE("falls with couples of shedding and noise keep to the energy of their terminal speed") {
    const int batches = quick() ? 50 : 1000;
    const uint32_t bodies = 50;
    double worst = 0.0;
    for (int i = 0; i < batches; ++i) {
        Random random(300000 + static_cast<uint64_t>(i));
        Draw draw = draw_body(random, i, false);
        draw.batch.load_model = LR_LOADS_AERODYNAMIC, draw.batch.clock = LR_CLOCK_SPEED;
        draw.batch.noise_gain = 1.0f;
        const World world = make(world_desc());
        const Vec wind{wide(random.real(-60.0, 60.0)), 0.0, 0.0};
        set_wind(world, narrow(wind[0]), 0.0f, 0.0f);
        const lr_batch batch = add_batch(world, draw.batch, draw.asset, bodies, draw.full);
        lr_load_gains gains = initialised(lr_load_gains_init);
        gains.turbulence = random.real(0.0, 3.0);
        REQUIRE(lr_batch_set_load_gains(world.get(), batch, &gains) == LR_OK);
        lr_aerodynamics a = initialised(lr_aerodynamics_init);
        REQUIRE(lr_asset_get_aerodynamics(draw.asset.get(), &a) == LR_OK);
        const lr_asset_info info = info_of(draw.asset);
        const double intensity = a.intensity * wide(gains.turbulence);
        std::vector<ReferenceBody> reference;
        lr_body_desc b = draw_motion(random, draw.shape.semi_axes[2]);
        for (uint32_t k = 0; k < bodies; ++k) {
            for (float& q : b.orientation) q = random.real(-1.0, 1.0);
            add_body(world, batch, b);
            reference.emplace_back(info, wide(b.scale));
        }
        const ReferenceBody& body = reference.front();
        const size_t normal = static_cast<size_t>(std::max_element(a.broadside, a.broadside + 3) - a.broadside);
        double edge = a.plate_drag + a.drag[normal];
        for (size_t k = 0; k < 3; ++k)
            if (k != normal) edge = std::min(edge, a.drag[k]);
        const double s = wide(b.scale);
        const double terminal2 = 2.0 * std::abs(body.weight) * g / (info.fluid_density * edge * s * s);
        // A share of the initial energy E moves along the normal: the couple c v_n^2 is at most c E/m_n.
        const double limit = std::numbers::sqrt2;
        const double c = std::abs(a.shedding_moment) * limit + std::abs(a.shedding_rate_moment) * limit;
        double mass = 0.0, spinning = 0.0;
        for (size_t k = 0; k < 3; ++k) {
            mass = std::max(mass, body.mass[k][k]);
            if (k != normal && a.spin_drag[k] > 0.0) spinning += c / (a.spin_drag[k] * s * s) * body.mass[k + 3][k + 3];
        }
        const double spun = spinning / body.mass[normal][normal];
        const double most = terminal2 * (mass + spinning);
        const float dt = static_cast<float>(random.logarithmic(1e-3, 0.1));
        double start = 0.0;
        lr_batch_view v = view_of(world, batch);
        std::vector<Velocity> u = velocities_of(world, batch);
        for (uint32_t k = 0; k < bodies; ++k) start += 2.0 * energy(reference[k], v, u, k, wind) / bodies;
        for (int n = 0; n < 40; ++n) {
            steps(world, 5, dt);
            v = view_of(world, batch);
            u = velocities_of(world, batch);
            double mean = 0.0;
            for (uint32_t k = 0; k < bodies; ++k) mean += 2.0 * energy(reference[k], v, u, k, wind) / bodies;
            const double ratio = mean * (1.0 - 3.0 * intensity * intensity) / (start * (1.0 + spun) + most);
            if (!(ratio <= worst)) {
                worst = ratio;
                CAPTURE(i);
                CAPTURE(n);
                CAPTURE(dt);
                CAPTURE(s);
                CAPTURE(start / most);
                CHECK(ratio <= 1.0);
            }
        }
    }
    MESSAGE("largest share of it ", worst);
}

// Wind that changes by up to 60 m/s between steps and has gusts, noise, gains, and couples of shedding.
TEST_CASE("random bodies in changing winds with noise stay finite") {
    const int batches = quick() ? 60 : 1000;
    const uint32_t bodies = 50;
    Extremes all;
    for (int i = 0; i < batches; ++i) {
        Random random(90000 + static_cast<uint64_t>(i));
        Draw draw = draw_body(random, i, true);
        draw.couples = true;
        const World world = make(world_desc());
        const lr_batch batch = add_batch(world, draw.batch, draw.asset, bodies, draw.full);
        draw_loads(random, world, batch, true, draw);
        if (i % 3 == 0) {
            lr_gusts_desc gusts = initialised(lr_gusts_desc_init);
            gusts.rms = 20.0f, gusts.integral_time = 0.5f, gusts.angle_rms = 1.0f;
            add_source(world, gusts);
        }
        for (uint32_t k = 0; k < bodies; ++k) add_body(world, batch, draw_motion(random, draw.shape.semi_axes[2]));
        const float dt = static_cast<float>(random.logarithmic(1e-4, 0.1));
        for (int n = 0; n < 30; ++n) {
            set_wind(world, random.real(-60.0, 60.0), random.real(-60.0, 60.0), random.real(-60.0, 60.0));
            steps(world, 1, dt, 1 + random.below(2));
        }
        all.add(world, batch);
    }
    CHECK(all.lost == 0);
}

// Steps much longer than a body's settling time leave it where drag and weight balance.
TEST_CASE("terminal velocity is right at steps of a tenth of a second") {
    for (const double size : {1e-4, 1e-3, 1e-2, 0.1})
        for (const double ratio : {0.01, 0.5, 1.01, 8.0, 1e3}) {
            const lr_ellipsoid_desc shape = in_water(ellipsoid(size, size, size, std::min(1000.0 * ratio, 2e4)));
            const Asset asset = make(shape);
            const World world = make(world_desc());
            lr_batch_desc d = batch_desc();
            d.load_model = LR_LOADS_AERODYNAMIC;
            const lr_batch batch = add_batch(world, d, asset, 1);
            lr_load_gains gains = initialised(lr_load_gains_init);
            gains.turbulence = 0.0f;
            REQUIRE(lr_batch_set_load_gains(world.get(), batch, &gains) == LR_OK);
            const lr_body body = add_body(world, batch, body_desc());
            steps(world, 1000, 0.1f);
            const lr_asset_info info = info_of(asset);
            ReferenceLoads loads;
            loads.at = initialised(lr_aerodynamics_init);
            REQUIRE(lr_asset_get_aerodynamics(asset.get(), &loads.at) == LR_OK);
            loads.density = info.fluid_density, loads.viscosity = info.fluid_viscosity, loads.length = info.length_d;
            const double weight = (info.mass - info.fluid_density * info.volume) * g;
            const lr_body_state s = state_of(world, body);
            const double drag = length(loads(vec(s.linear_velocity), {}).force);
            CAPTURE(size);
            CAPTURE(ratio);
            CHECK(drag == doctest::Approx(std::abs(weight)).epsilon(0.01));
        }
}

// The couple of shed vortices has no reaction on the motion along the stream, so it does work. In the limit cycle it is at most
// C = rho v_n^2 sqrt(2) |(moment, rate_moment)|; with the spin drag D |w| w its work, C w - D w^3, is at
// most 2/3 C sqrt(C/(3 D)). Drag takes more in every direction of the stream.
TEST_CASE("couples of shedding do less work than drag takes" * doctest::test_suite("exact")) {
    double most = 0.0;
    for (uint64_t i = 0; i < 2000; ++i) {
        Random random(i);
        const Asset asset = make(ellipsoid(random.logarithmic(1e-3, 1.0), random.logarithmic(1e-3, 1.0),
                                           random.logarithmic(1e-4, 1.0), 700.0));
        ReferenceLoads loads;
        loads.at = initialised(lr_aerodynamics_init);
        REQUIRE(lr_asset_get_aerodynamics(asset.get(), &loads.at) == LR_OK);
        const lr_aerodynamics& a = loads.at;
        const lr_asset_info info = info_of(asset);
        loads.density = 1.0, loads.length = info.length_d, loads.viscosity = 1e-9;
        const size_t normal = loads.normal();
        double spin_drag = 1e300;
        for (size_t k = 0; k < 3; ++k)
            if (k != normal) spin_drag = std::min(spin_drag, a.spin_drag[k]);
        for (int direction = 0; direction < 500; ++direction) {
            Vec v{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
            v[random.below(3)] *= random.logarithmic(1e-3, 1.0);
            v = 1.0 / length(v) * v;
            loads.lag = v; // its wake is made
            const double couple =
                v[normal] * v[normal] * std::numbers::sqrt2 * std::hypot(a.shedding_moment, a.shedding_rate_moment);
            const double work = 2.0 / 3.0 * couple * std::sqrt(couple / (3.0 * spin_drag));
            most = std::max(most, work / -dot(loads(v, {}).force, v));
        }
    }
    MESSAGE("at most ", most, " of it");
    CHECK(most < 1.0);
    CHECK(most > 0.0);
}
