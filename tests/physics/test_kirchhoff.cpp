// Force-free motion in an ideal fluid, Kirchhoff's equations: conserved quantities stay constant.
#include "support/quick.h"
#include "support/random.h"
#include "support/reference_body.h"
#include "support/scene.h"

#include <string>

using namespace test;

namespace {

struct Invariants {
    double energy;
    Vec impulse, moment; // of body and fluid, world frame; the moment about the origin
    double p_squared, p_dot_l;
};

// From get_state and get_info alone.
Invariants invariants(const ReferenceBody& reference, const lr_body_state& s) {
    const Quat q = quat(s.orientation);
    const Six twist = join(to_body(q, vec(s.linear_velocity)), to_body(q, vec(s.angular_velocity)));
    const Six momentum = reference.mass * twist;
    const Vec p = upper(momentum), l = lower(momentum), impulse = to_world(q, p);
    double energy = 0.0;
    for (size_t i = 0; i < 6; ++i) energy += 0.5 * twist[i] * momentum[i];
    return {energy, impulse, to_world(q, l) + cross(vec(s.position), impulse), dot(p, p), dot(p, l)};
}

struct Drift {
    double energy = 0.0, p = 0.0, p_dot_l = 0.0, impulse = 0.0, moment = 0.0; // relative, largest over bodies
};

// Many random bodies for `seconds`.
Drift drift(const Asset& asset, lr_batch_desc desc, int count, float dt, uint32_t substeps, double scale = 1.0,
            bool full = false) {
    const ReferenceBody reference(info_of(asset), scale);
    const World world = weightless();
    desc.load_model = LR_LOADS_NONE;
    const lr_batch batch = add_batch(world, desc, asset, 32, full);
    Random random(12);
    std::vector<lr_body> ids;
    std::vector<Invariants> before;
    for (int i = 0; i < 32; ++i) {
        lr_body_desc d = turned_anyhow(random);
        d.scale = narrow(scale);
        // Speeds at which a body rotates about once per second and moves its own length in a quarter of one.
        for (float& v : d.linear_velocity) v = random.real(-0.2, 0.2) * narrow(scale);
        for (float& w : d.angular_velocity) w = random.real(-5.0, 5.0);
        ids.push_back(add_body(world, batch, d));
        before.push_back(invariants(reference, state_of(world, ids.back())));
    }
    Drift worst;
    for (int check = 0; check < 4; ++check) {
        steps(world, count / 4, dt, substeps);
        for (size_t i = 0; i < ids.size(); ++i) {
            const Invariants a = before[i], b = invariants(reference, state_of(world, ids[i]));
            const double l = length(a.moment);
            worst.energy = std::max(worst.energy, std::abs(b.energy / a.energy - 1.0));
            worst.p = std::max(worst.p, std::abs(std::sqrt(b.p_squared / a.p_squared) - 1.0));
            worst.p_dot_l = std::max(worst.p_dot_l, std::abs(b.p_dot_l - a.p_dot_l) / (std::sqrt(a.p_squared) * l));
            worst.impulse = std::max(worst.impulse, length(b.impulse - a.impulse) / length(a.impulse));
            // The moment about the origin is position times impulse: scale its error by both.
            const double arm = length(vec(state_of(world, ids[i]).position)) * length(a.impulse);
            worst.moment = std::max(worst.moment, length(b.moment - a.moment) / (l + arm));
        }
    }
    MESSAGE("drift: energy ", worst.energy, ", |p| ", worst.p, ", p.l ", worst.p_dot_l, ", impulse ", worst.impulse,
            ", moment ", worst.moment);
    return worst;
}

Asset ballasted() {
    lr_ellipsoid_desc d = in_water(ellipsoid(0.04, 0.02, 0.01, 1200.0));
    d.center_of_mass[0] = 0.012, d.center_of_mass[1] = -0.006, d.center_of_mass[2] = 0.003;
    return make(d);
}

} // namespace

// 12 s are about 30 turns in 23040 substeps. A substep rounds each of about 40 operations to 6e-8 of the state. If all errors
// had one sign over a turn's 700 substeps and were random between turns, the sum would be 2e-4; with random signs it is at most
// 1e-5. RK4's own error at 0.01 rad per substep is much smaller. The default solves its implicit step in single precision, with a
// bias: 23040 times about 1e-7.
TEST_CASE("force-free motion keeps energy, momentum, p.l, and the impulse and its moment in the world") {
    const int count = quick() ? 60 : 360;
    const Asset plain = make(in_water(ellipsoid(0.04, 0.02, 0.01, 1200.0))), offset = ballasted();
    const struct {
        const char* name;
        const Asset& asset;
        bool full;
        double scale;
    } cases[] = {{"diagonal", plain, false, 1.0},
                 {"full path of a diagonal body", plain, true, 1.0},
                 {"full, ballasted", offset, false, 1.0},
                 {"full, ballasted, three times as large", offset, false, 3.0}};
    for (int32_t integrator : {LR_INTEGRATOR_RK4, LR_INTEGRATOR_DEFAULT})
        for (const auto& c : cases) {
            CAPTURE(std::string(c.name));
            CAPTURE(integrator);
            lr_batch_desc d = batch_desc();
            d.integrator = integrator;
            const Drift worst = drift(c.asset, d, count, 1.0f / 30.0f, 64, c.scale, c.full);
            const double bound = 1e-4; // rounding over 20,000 substeps and more
            CHECK(worst.energy < bound);
            CHECK(worst.p < bound);
            CHECK(worst.p_dot_l < bound);
            CHECK(worst.impulse < bound);
            CHECK(worst.moment < bound);
        }
}

TEST_CASE("with RK4 the drift of the invariants falls by sixteen and more when the step is halved") {
    const Asset offset = ballasted();
    lr_batch_desc d = batch_desc();
    d.integrator = LR_INTEGRATOR_RK4;
    // 0.3 rad per substep for the fastest, so that truncation is far above rounding.
    const Drift coarse = drift(offset, d, 8, 0.25f, 8), fine = drift(offset, d, 8, 0.25f, 16);
    CHECK(coarse.energy > 2e-5);
    CHECK(std::log2(coarse.energy / fine.energy) > 3.7);
    CHECK(std::log2(coarse.p / fine.p) > 3.7);
    CHECK(std::log2(coarse.impulse / fine.impulse) > 3.5);
}

TEST_CASE("a spinning force-free sphere goes straight") {
    const Asset sphere = make(in_water(ellipsoid(0.05, 0.05, 0.05, 700.0)));
    for (int32_t integrator : {LR_INTEGRATOR_RK4, LR_INTEGRATOR_DEFAULT})
        for (bool full : {false, true}) {
            const World world = weightless();
            lr_batch_desc d = batch_desc();
            d.load_model = LR_LOADS_NONE;
            d.integrator = integrator;
            const lr_batch batch = add_batch(world, d, sphere, 1, full);
            lr_body_desc b = body_desc();
            b.linear_velocity[0] = 1.0f, b.linear_velocity[1] = -0.5f, b.linear_velocity[2] = 0.25f;
            b.angular_velocity[0] = 10.0f, b.angular_velocity[1] = 15.0f, b.angular_velocity[2] = -5.0f;
            const lr_body id = add_body(world, batch, b);
            // 0.02 rad per substep for 3 s: 9 turns.
            steps(world, 180, 1.0f / 60.0f, 16);
            const lr_body_state s = state_of(world, id);
            CHECK(length(vec(s.position) - 3.0 * vec(b.linear_velocity)) < 3e-4);
            CHECK(length(vec(s.linear_velocity) - vec(b.linear_velocity)) < 4e-4);
            CHECK(length(vec(s.angular_velocity) - vec(b.angular_velocity)) < 2e-3);
            // It has rotated by |w| t about w.
            const Quat expected = about(vec(b.angular_velocity), 3.0 * length(vec(b.angular_velocity)));
            const Quat got = quat(s.orientation);
            double cosine = 0.0;
            for (size_t i = 0; i < 4; ++i) cosine += expected[i] * got[i];
            // Half the angle between the two; the default's angle can differ by h^2 w^2/24 of the 56 rad.
            CHECK(std::acos(std::min(1.0, std::abs(cosine))) < 2e-3);
        }
}

TEST_CASE("a force-free body spins steadily about its longest and shortest axis and tumbles about the middle one") {
    // Nearly a vacuum: a fluid of a thousandth of the body's density.
    const Asset asset = make(ellipsoid(0.04, 0.02, 0.01, 1200.0));
    const World world = weightless();
    lr_batch_desc d = batch_desc();
    d.load_model = LR_LOADS_NONE;
    const lr_batch batch = add_batch(world, d, asset, 3);
    double most_off[3] = {};
    lr_body ids[3];
    for (size_t axis = 0; axis < 3; ++axis) {
        lr_body_desc b = body_desc();
        for (float& w : b.angular_velocity) w = 0.01f;
        b.angular_velocity[axis] = 10.0f;
        ids[axis] = add_body(world, batch, b);
    }
    for (int i = 0; i < 300; ++i) {
        steps(world, 1, 1.0f / 60.0f, 8);
        for (size_t axis = 0; axis < 3; ++axis) {
            const lr_body_state s = state_of(world, ids[axis]);
            const Vec w = to_body(quat(s.orientation), vec(s.angular_velocity));
            most_off[axis] = std::max(most_off[axis], std::sqrt(std::max(0.0, dot(w, w) - w[axis] * w[axis])));
        }
    }
    CHECK(most_off[0] < 0.1);
    CHECK(most_off[1] > 5.0);
    CHECK(most_off[2] < 0.1);
}
