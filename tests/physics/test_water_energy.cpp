// The effect of crossing a surface on the energy of body and fluid: docs/reference/wind_and_water.md, "Energy".
#include "support/floating_body.h"
#include "support/quick.h"
#include "support/random.h"

#include <algorithm>
#include <vector>

using namespace test;

namespace {

struct Draw {
    lr_ellipsoid_desc shape;
    int32_t loads;
    bool full = false;
    double couples = 0.0; // factor on the moment of the shedding
};

// Beads, needles, films and boards from foam to lead, every second one with its weight off centre.
lr_ellipsoid_desc draw_shape(Random& random, uint32_t i) {
    lr_ellipsoid_desc e = ellipsoid(random.logarithmic(1e-3, 1.0), random.logarithmic(1e-3, 1.0),
                                    random.logarithmic(1e-4, 1.0), random.logarithmic(2.0, 2e4));
    for (size_t k = 0; k < 3 && i % 2; ++k) e.center_of_mass[k] = random.uniform(-0.5, 0.5) * e.semi_axes[k];
    return e;
}
double longest(const lr_ellipsoid_desc& e) {
    return std::max({e.semi_axes[0], e.semi_axes[1], e.semi_axes[2]});
}
lr_body_desc draw_motion(Random& random, double size, double fastest, double spin) {
    lr_body_desc b = turned_anyhow(random, {0.0, random.uniform(-1.2, 1.2) * size, 0.0});
    const double v = random.logarithmic(0.01, fastest), w = random.logarithmic(0.1, spin);
    for (float& x : b.linear_velocity) x = random.real(-v, v);
    for (float& x : b.angular_velocity) x = random.real(-w, w);
    return b;
}

// A batch of bodies of one kind on still water, without noise.
class Floats {
public:
    Floats(const Draw& draw, double h) : asset_(make(draw.shape)), h_(h), reference_(info_of(asset_), h) {
        set_water(world, water_desc());
        lr_batch_desc d = batch_desc();
        d.load_model = draw.loads;
        batch_ = add_batch(world, d, asset_, capacity, draw.full);
        if (draw.loads != LR_LOADS_AERODYNAMIC) return;
        lr_aerodynamics a = initialised(lr_aerodynamics_init);
        REQUIRE(lr_batch_get_aerodynamics(world.get(), batch_, &a) == LR_OK);
        a.shedding_moment *= draw.couples, a.shedding_rate_moment *= draw.couples;
        // A little noise starts the oscillator, which then grows fast.
        a.intensity = draw.couples > 0.0 ? 1e-4 : 0.0, a.shedding_noise = 10.0, a.shedding_growth = 10.0;
        REQUIRE(lr_batch_set_aerodynamics(world.get(), batch_, &a) == LR_OK);
    }
    void add(const lr_body_desc& d) { add_body(world, batch_, d); }
    void step() { steps(world, 1, narrow(h_)); }

    struct Energy {
        double least, most; // J, kinetic: the range left by single precision in the fraction under water
        double potential;   // J
        double fraction;
        double total() const { return 0.5 * (least + most) + potential; }
    };
    std::vector<Energy> energies() const {
        std::vector<Energy> out;
        const lr_batch_view v = view_of(world, batch_);
        const std::vector<Velocity> u = velocities_of(world, batch_);
        for (uint32_t i = 0; i < v.count; ++i) {
            const auto at = [&](const float* const* field, size_t k) { return wide(field[k][i]); };
            const Vec x{at(v.position, 0), at(v.position, 1), at(v.position, 2)};
            const Quat q{at(v.orientation, 0), at(v.orientation, 1), at(v.orientation, 2), at(v.orientation, 3)};
            const Six t = join(to_body(q, vec(u[i].linear)), to_body(q, vec(u[i].angular)));
            const FloatingBody::Pose pose = reference_.pose(x, q);
            const double open = 3e-7 * (std::abs(x[1]) + reference_.largest()) / pose.half_height;
            out.push_back({reference_.kinetic(std::max(0.0, pose.fraction - open), t),
                           reference_.kinetic(std::min(1.0, pose.fraction + open), t), pose.potential, pose.fraction});
        }
        return out;
    }
    // Of weight and buoyancy in any orientation: the norm whose square is twice the kinetic energy from their impulse in a
    // second.
    double pull() const {
        const lr_asset_info info = info_of(asset_);
        double most = 0.0;
        for (double f = 0.0; f <= 1.0; f += 1.0 / 32.0) {
            const Matrix6 mobility = inverse(reference_.mass(f));
            const double fluid =
                info.volume * (air_density + f * (water_density - air_density)) * FloatingBody::gravity;
            // f.N f <= |f|^2 trace N, N positive definite. Along each axis the submerged centre is off the other one by at most 3/16 of the
            // semi-axis.
            double sum = std::sqrt(mobility[0][0] + mobility[1][1] + mobility[2][2]) *
                         std::abs(info.mass * FloatingBody::gravity - fluid);
            const auto arm = [&](size_t k) {
                return std::abs(info.center_of_buoyancy[k]) + 3.0 / 16.0 * reference_.semi_axis(k);
            };
            for (size_t k = 0; k < 3; ++k)
                sum += std::sqrt(mobility[k + 3][k + 3]) * fluid * (arm((k + 1) % 3) + arm((k + 2) % 3));
            most = std::max(most, sum);
        }
        return most;
    }

    World world = make(world_desc());

private:
    static constexpr uint32_t capacity = 20;
    Asset asset_;
    lr_batch batch_{};
    double h_;
    FloatingBody reference_;
};

// Roots of energies above each body's lowest potential, as norms: the excess of the largest over the first, relative to that
// and to the gain by weight and buoyancy in a step.
double largest_gain(Floats& floats, int frames, double impulse) {
    const std::vector<Floats::Energy> first = floats.energies();
    std::vector<double> most(first.size()), lowest(first.size());
    for (size_t k = 0; k < first.size(); ++k) most[k] = first[k].total(), lowest[k] = first[k].potential;
    for (int n = 0; n < frames; ++n) {
        floats.step();
        const std::vector<Floats::Energy> now = floats.energies();
        for (size_t k = 0; k < first.size(); ++k) {
            most[k] = std::max(most[k], now[k].least + now[k].potential);
            lowest[k] = std::min(lowest[k], now[k].potential);
        }
    }
    double gain = 0.0;
    for (size_t k = 0; k < first.size(); ++k) {
        const double begun = std::sqrt(2.0 * (first[k].total() - lowest[k]));
        gain = std::max(gain, (std::sqrt(2.0 * (most[k] - lowest[k])) - begun) / (begun + impulse));
    }
    return gain;
}

// The largest rise of any body's energy above its minimum so far, relative to the first energy above the lowest potential;
// and the share of their volume that all bodies together have moved through the surface.
struct Return {
    double ripple, passed;
};
Return follow(Floats& floats, int frames) {
    const std::vector<Floats::Energy> first = floats.energies();
    std::vector<Floats::Energy> last = first;
    std::vector<double> least(first.size()), lowest(first.size()), above(first.size());
    for (size_t k = 0; k < first.size(); ++k) least[k] = first[k].total(), lowest[k] = first[k].potential;
    Return out{};
    for (int n = 0; n < frames; ++n) {
        floats.step();
        const std::vector<Floats::Energy> now = floats.energies();
        for (size_t k = 0; k < first.size(); ++k) {
            above[k] = std::max(above[k], now[k].total() - least[k]);
            least[k] = std::min(least[k], now[k].total());
            lowest[k] = std::min(lowest[k], now[k].potential);
            out.passed += std::abs(now[k].fraction - last[k].fraction);
        }
        last = now;
    }
    for (size_t k = 0; k < first.size(); ++k)
        out.ripple = std::max(out.ripple, above[k] / (first[k].total() - lowest[k]));
    return out;
}

} // namespace

// As in test_energy_bounds.cpp for one fluid: the norm of the velocities grows by at most the impulse of weight and buoyancy.
// The surface's effect on the mass matrix can only reduce it.
TEST_CASE("at any step a body that crosses the surface gains no more than weight and buoyancy give") {
    const uint32_t batches = quick() ? 60 : 1200;
    double worst = -1.0;
    uint32_t crossings = 0;
    for (uint32_t i = 0; i < batches; ++i) {
        Random random(7000 + i);
        Draw draw{draw_shape(random, i), random.below(4) ? LR_LOADS_AERODYNAMIC : LR_LOADS_NONE};
        if (random.below(4) == 0) draw.full = true;
        const double h = wide(narrow(random.logarithmic(1e-4, 0.1)));
        Floats floats(draw, h);
        for (int k = 0; k < 20; ++k) floats.add(draw_motion(random, longest(draw.shape), 10.0, 300.0));
        const double impulse = h * floats.pull();
        std::vector<Floats::Energy> before = floats.energies();
        for (int n = 0; n < 40; ++n) {
            floats.step();
            const std::vector<Floats::Energy> now = floats.energies();
            for (size_t k = 0; k < now.size(); ++k) {
                const double most = std::sqrt(2.0 * before[k].most) + impulse;
                const double excess = (std::sqrt(2.0 * now[k].least) - most) / most;
                crossings += now[k].fraction != before[k].fraction;
                if (excess <= worst) continue;
                worst = excess;
                CAPTURE(i);
                CAPTURE(k);
                CAPTURE(n);
                CHECK(excess <= 1e-4);
            }
            before = now;
        }
    }
    MESSAGE("largest excess ", worst);
    CHECK(crossings > batches * 100);
}

// Lost energy does not come back: over many crossings the energy never rises above its earlier values, except for the
// scheme's second-order ripple.
TEST_CASE("bobbing and rolling through the surface pump no energy, with couples and without" *
          doctest::test_suite("exact")) {
    const double shapes[][3] = {{0.05, 0.05, 0.05}, {0.1, 0.02, 0.03}, {0.08, 0.06, 0.006}, {0.02, 0.1, 0.02}};
    double worst[2][2] = {};
    for (int32_t loads : {LR_LOADS_NONE, LR_LOADS_AERODYNAMIC})
        for (double couples : {0.0, 1.0})
            for (const auto& shape : shapes)
                for (double density : {120.0, 500.0, 850.0})
                    for (bool off_centre : {false, true}) {
                        if (loads == LR_LOADS_NONE && couples > 0.0) continue;
                        CAPTURE(loads);
                        CAPTURE(couples);
                        CAPTURE(shape[0]);
                        CAPTURE(shape[2]);
                        CAPTURE(density);
                        CAPTURE(off_centre);
                        Draw draw{ellipsoid(shape[0], shape[1], shape[2], density), loads};
                        draw.couples = couples;
                        if (off_centre) draw.shape.center_of_mass[1] = -0.3 * shape[1];
                        Floats floats(draw, 0.001);
                        for (int k = 0; k < 4; ++k) {
                            lr_body_desc b = body_desc();
                            b.position[1] = 0.02f * static_cast<float>(k);
                            b.orientation[0] = 0.2f * static_cast<float>(k);
                            b.angular_velocity[2] = 0.5f * static_cast<float>(k);
                            floats.add(b);
                        }
                        const auto [ripple, passed] = follow(floats, 4000);
                        worst[loads == LR_LOADS_AERODYNAMIC][couples > 0.0] =
                            std::max(worst[loads == LR_LOADS_AERODYNAMIC][couples > 0.0], ripple);
                        CHECK(passed > 0.9);
                        CHECK(ripple < 5e-4);
                    }
    MESSAGE("largest return: without loads ", worst[0][0], ", without couples ", worst[1][0], ", with ", worst[1][1]);
}

// With couples of shedding the equations lose energy (test_energy_bounds.cpp). Steps too long for a body's rotation need not, but
// within them the couple is limited.
TEST_CASE("long steps and couples of shedding drive no body on its way through the surface" *
          doctest::test_suite("exact")) {
    const uint32_t batches = quick() ? 40 : 400, driven = quick() ? 1 : 8;
    double bare = 0.0, gain[2] = {}, beyond = 0.0;
    for (uint32_t i = 0; i < batches; ++i) {
        const auto most = [&](int32_t loads, double couples) {
            Random random(9000 + i);
            Draw draw{draw_shape(random, i), loads};
            draw.couples = couples;
            const double h = wide(narrow(random.logarithmic(1.0 / 960.0, 0.1)));
            Floats floats(draw, h);
            for (int k = 0; k < 20; ++k) floats.add(draw_motion(random, longest(draw.shape), 8.0, 50.0));
            return largest_gain(floats, 120, h * floats.pull());
        };
        bare = std::max(bare, most(LR_LOADS_NONE, 0.0));
        gain[0] = std::max(gain[0], most(LR_LOADS_AERODYNAMIC, 0.0));
        gain[1] = std::max(gain[1], most(LR_LOADS_AERODYNAMIC, 1.0));
        if (i % driven == 0) beyond = std::max(beyond, most(LR_LOADS_AERODYNAMIC, 1e4));
    }
    MESSAGE("largest gains: without loads ", bare, ", without couples ", gain[0], ", with ", gain[1],
            ", with couples ten thousand times as strong ", beyond);
    CHECK(bare < 0.8);
    CHECK(gain[0] < 0.2);
    CHECK(gain[1] < 0.5);
    CHECK(beyond > 1.0); // the measure detects driven motion
}
