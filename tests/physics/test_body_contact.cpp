// Contact of two bodies: momentum, energy, restitution and friction against Newton's laws.
#include "support/body_contact.h"
#include "support/quick.h"

#include <numbers>

using namespace test;

namespace {

constexpr double h = 1.0 / 480.0, short_h = 1.0 / 7680.0;
const int rounds = quick() ? 30 : 150;

Vec any_vector(Random& random, double most) {
    return {random.uniform(-most, most), random.uniform(-most, most), random.uniform(-most, most)};
}

struct Totals {
    Vec momentum{}, angular{};
    double energy = 0.0;
};
struct Pair {
    World world = weightless();
    Asset asset[2];
    lr_body body[2] = {};
    lr_batch batch[2] = {};

    template <class A, class B> Pair(const A& a, const B& b, float friction, float restitution) {
        asset[0] = make(a), asset[1] = make(b);
        for (size_t i = 0; i < 2; ++i) {
            batch[i] = add_batch(world, unloaded(), asset[i], 1);
            set_contact(world, batch[i], contact_desc(friction, restitution));
        }
        set_pair(world, batch[0], batch[1]);
    }
    void place(size_t i, const lr_body_desc& d) { body[i] = add_body(world, batch[i], d); }
    Moving at(size_t i) const { return {info_of(asset[i]), state_of(world, body[i])}; }
    Totals totals() const {
        Totals t;
        for (size_t i = 0; i < 2; ++i) {
            const Moving m = at(i);
            t.momentum = t.momentum + m.momentum();
            t.angular = t.angular + m.angular_momentum({});
            t.energy += m.energy();
        }
        return t;
    }
};

} // namespace

// Each ball gets J = min(mu (1 + e) u_n/2, u_t/7) along the slip, over its mass: 1/7 of it for solid balls that end without slip.
TEST_CASE("a spinning ball turns the one that it hits by Coulomb's law, at any step") {
    for (const double radius : {0.005, 0.02, 0.1})
        for (const double friction : {0.1, 0.5})
            for (const float rate : {30.0f, 60.0f, 240.0f}) {
                const double speed = 2.0, slip = 3.0, e = 0.3;
                if (slip / radius > 12.0 * wide(rate)) continue; // three turns in a step
                CAPTURE(radius);
                CAPTURE(friction);
                CAPTURE(rate);
                for (int i = 0; i < 10; ++i) {
                    Pair p(ellipsoid(radius, radius, radius, 900.0), ellipsoid(radius, radius, radius, 900.0),
                           narrow(friction), narrow(e));
                    lr_body_desc d = body_desc();
                    p.place(1, d);
                    put(d.position, Vec{-2.0 * radius - 0.02 - 0.005 * i, 0.0, 0.0});
                    d.linear_velocity[0] = narrow(speed), d.angular_velocity[2] = narrow(slip / radius);
                    p.place(0, d);
                    steps(p.world, static_cast<int>(0.05f * rate) + 2, 1.0f / rate, 1);
                    const double along = std::min(friction * (1.0 + e) * speed / 2.0, slip / 7.0);
                    for (size_t k = 0; k < 2; ++k) {
                        const lr_body_state s = state_of(p.world, p.body[k]);
                        CHECK(wide(s.linear_velocity[0]) ==
                              doctest::Approx(speed * (k == 0 ? 1.0 - e : 1.0 + e) / 2.0).epsilon(0.01));
                        CHECK(wide(s.linear_velocity[1]) == doctest::Approx(k == 0 ? -along : along).epsilon(0.01));
                        CHECK(wide(s.angular_velocity[2]) * radius ==
                              doctest::Approx((k == 0 ? slip : 0.0) - 2.5 * along).epsilon(0.01));
                    }
                }
            }
}

TEST_CASE("boxes that meet head-on come apart with their coefficient of restitution, at every mass ratio and size") {
    double worst = 0.0, drift = 0.0, over = 0.0;
    for (double e : {0.0, 0.5, 1.0})
        for (double ratio : {1.0, 10.0, 1000.0})
            for (double scale : {0.1, 1.0, 10.0})
                for (int i = 0; i < 4; ++i) {
                    const double size = 0.05, x = size * scale;
                    Pair p(vacuum_box(size, size, size, 500.0), vacuum_box(size, 2.0 * size, size, 500.0 * ratio / 2.0),
                           0.5f, narrow(e));
                    lr_body_desc d = body_desc();
                    d.scale = narrow(scale);
                    d.position[0] = narrow(-x);
                    const double speed = (1.0 + 0.37 * i) * std::sqrt(9.81 * x);
                    d.linear_velocity[0] = narrow(speed);
                    p.place(0, d);
                    d.position[0] = narrow(x * (0.3 + 0.11 * i));
                    d.linear_velocity[0] = narrow(-0.4 * speed);
                    p.place(1, d);
                    const Totals before = p.totals();
                    const int count = static_cast<int>(3.0 * x / speed / h);
                    steps(p.world, count, narrow(h));
                    const Totals after = p.totals();
                    const Moving a = p.at(0), b = p.at(1);
                    CAPTURE(e);
                    CAPTURE(ratio);
                    CAPTURE(scale);
                    CHECK(a.velocity[0] < speed * 0.999);
                    const double apart = (b.velocity[0] - a.velocity[0]) / (1.4 * speed);
                    worst = std::max(worst, std::abs(apart - e));
                    drift = std::max(drift, length(after.momentum - before.momentum) / ((a.mass + b.mass) * speed));
                    over = std::max(over, after.energy / before.energy - 1.0);
                }
    MESSAGE("restitution " << worst << ", momentum " << drift << ", energy " << over);
    CHECK(worst < 1e-4);
    CHECK(drift < 1e-6);
    CHECK(over < 1e-5);
}

TEST_CASE("in oblique hits momentum and angular momentum are kept and no energy is gained") {
    Random random(3);
    int hits = 0;
    double drift = 0.0, angular = 0.0, over[2] = {0.0, 0.0};
    for (int i = 0; i < rounds; ++i) {
        const double ratio = random.logarithmic(0.001, 1000.0), size = random.logarithmic(0.005, 0.5);
        const double mu = random.uniform(0.0, 1.0), e = random.below(3) * 0.5;
        const bool plates = random.below(2) == 0;
        Pair p(vacuum_box(size, (plates ? 0.02 : 0.6) * size, 0.7 * size, 500.0),
               vacuum_box(0.8 * size, 0.9 * size, (plates ? 0.03 : 0.5) * size, 500.0 * ratio), narrow(mu), narrow(e));
        const Vec where = any_vector(random, size), way = any_vector(random, 1.0);
        const double speed = 10.0 * size * random.uniform(0.3, 1.0);
        for (size_t k = 0; k < 2; ++k) {
            const Vec v = ((k == 0 ? 0.5 : -0.5) * speed / length(way)) * way;
            lr_body_desc d = at_rest_at(where + any_vector(random, 0.2 * size) - 0.25 * v);
            put(d.orientation, any_turn(random));
            put(d.linear_velocity, v);
            put(d.angular_velocity, any_vector(random, 4.0));
            p.place(k, d);
        }
        const double least = std::min(p.at(0).mass, p.at(1).mass), heavy = std::max(p.at(0).mass, p.at(1).mass);
        bool hit = false;
        Totals now = p.totals();
        for (int n = 0; n < 240; ++n) {
            const Totals former = now;
            const Vec mine = p.at(0).momentum();
            steps(p.world, 1, narrow(h));
            now = p.totals();
            // Steps without an impact have the integrator's error alone.
            if (length(p.at(0).momentum() - mine) < 1e-2 * least * speed) continue;
            hit = true;
            drift = std::max(drift, length(now.momentum - former.momentum) / (heavy * speed));
            angular = std::max(angular, length(now.angular - former.angular) / (heavy * speed * size));
            const double rose = (now.energy - former.energy) / (least * speed * speed);
            over[e == 1.0 ? 1 : 0] = std::max(over[e == 1.0 ? 1 : 0], rose);
        }
        hits += hit ? 1 : 0;
    }
    MESSAGE(hits << " hits; momentum " << drift << ", angular " << angular << ", energy " << over[0] << ", "
                 << over[1]);
    CHECK(hits > rounds / 2);
    CHECK(drift < 1e-5);
    CHECK(angular < 0.02);
    CHECK(over[0] < 1e-3);
    CHECK(over[1] < 0.02); // restitution and friction together can add energy (Kane 1984)
}

TEST_CASE("balls that meet off centre, without friction, part along the line of their centres as spheres do") {
    Random random(5);
    double tilt = 0.0, size_error = 0.0, bounce = 0.0, spin = 0.0;
    int hits = 0;
    for (int i = 0; i < rounds; ++i) {
        const double size = random.logarithmic(0.005, 0.5), ratio = random.logarithmic(0.2, 5.0),
                     e = random.below(3) * 0.5;
        const auto ball = [](double radius) {
            lr_ellipsoid_desc d = ellipsoid(radius, radius, radius, 500.0);
            d.fluid_density = 1e-3;
            return d;
        };
        Pair p(ball(size), ball(ratio * size), 0.0f, narrow(e));
        const double both = (1.0 + ratio) * size, speed = 5.0 * both, beside = random.uniform(0.0, 0.9) * both;
        lr_body_desc d = at_rest_at({-1.2 * both, beside, 0.0});
        put(d.orientation, any_turn(random));
        put(d.linear_velocity, Vec{speed, 0.0, 0.0});
        p.place(0, d);
        d = at_rest_at({0.0, 0.0, 0.0});
        put(d.orientation, any_turn(random));
        p.place(1, d);
        for (int n = 0; n < 4000; ++n) {
            const Moving a = p.at(0), b = p.at(1);
            steps(p.world, 1, narrow(short_h));
            const Moving c = p.at(0), g = p.at(1);
            const Vec impulse = c.momentum() - a.momentum();
            if (length(impulse) < 0.1 * std::min(a.mass, b.mass) * speed) continue;
            const Vec line = a.position - b.position;
            const double apart = length(line);
            ++hits;
            tilt = std::max(tilt, std::acos(std::min(1.0, dot(impulse, line) / (length(impulse) * apart))));
            size_error = std::max(size_error, std::abs(apart / both - 1.0));
            const double before = dot(a.velocity - b.velocity, line), after = dot(c.velocity - g.velocity, line);
            bounce = std::max(bounce, std::abs(after / before + e));
            spin = std::max(spin, length(c.spin) * size / speed);
            break;
        }
    }
    MESSAGE(hits << " hits: normal off by " << 180.0 / std::numbers::pi * tilt << " degrees, distance by " << size_error
                 << ", restitution by " << bounce << ", spin " << spin);
    CHECK(hits == rounds);
    CHECK(tilt < 0.006);
    CHECK(size_error < 0.003);
    CHECK(bounce < 0.03);
    CHECK(spin < 0.01);
}

// A box hits the face of a much heavier one, edge or corner first: along its normal and across it.
TEST_CASE("friction between bodies is mu times the normal impulse while they slide, and no more" *
          doctest::test_suite("exact")) {
    Random random(4);
    double most = 0.0, least = 1.0;
    int sliding = 0;
    for (int i = 0; i < rounds; ++i) {
        const double size = random.logarithmic(0.005, 0.5), mu = random.uniform(0.05, 0.5), e = random.below(2) * 0.5;
        Pair p(vacuum_box(size, 0.6 * size, 0.8 * size, 500.0), vacuum_box(20.0 * size, 2.0 * size, 20.0 * size, 5e4),
               narrow(mu), narrow(e));
        const double speed = 5.0 * size;
        const bool slides = i % 2 == 0;
        const Vec v{(slides ? 6.0 : random.uniform(0.0, 2.0)) * speed, -speed, 0.0};
        lr_body_desc d = at_rest_at(Vec{0.0, 2.2 * size, 0.0} - 0.05 * v);
        put(d.orientation, any_turn(random));
        put(d.linear_velocity, v);
        p.place(0, d);
        p.place(1, body_desc());
        const Vec before = p.at(0).momentum();
        // A single impact, until the body leaves again or its other corners come down.
        Vec impulse{};
        for (int n = 0; n < 2000 && length(impulse) < 0.2 * p.at(0).mass * speed; ++n) {
            steps(p.world, 1, narrow(short_h));
            impulse = p.at(0).momentum() - before;
        }
        if (impulse[1] < 0.1 * p.at(0).mass * speed) continue;
        const double across = std::sqrt(impulse[0] * impulse[0] + impulse[2] * impulse[2]) / (mu * impulse[1]);
        most = std::max(most, across);
        if (slides) least = std::min(least, across), ++sliding;
    }
    MESSAGE(sliding << " slide: tangential over mu times normal " << least << " to " << most);
    CHECK(sliding > rounds / 3);
    CHECK(most < 1.001);
    CHECK(least > 0.98);
}

TEST_CASE("bodies of two batches meet where that is switched on, and those of one batch pass through each other") {
    for (int within : {0, 1}) {
        const World world = weightless();
        const Asset asset[2] = {make(vacuum_box(0.05, 0.05, 0.05, 300.0)), make(vacuum_box(0.05, 0.05, 0.05, 900.0))};
        lr_batch batch[2];
        for (size_t i = 0; i < 2; ++i) {
            batch[i] = add_batch(world, unloaded(), asset[i], 4);
            set_contact(world, batch[i], contact_desc(0.5f, 1.0f));
        }
        set_pair(world, batch[0], batch[1]);
        if (within) set_pair(world, batch[0], batch[0]);
        // Above, two of the first; below, one of each.
        lr_body body[4];
        for (size_t i = 0; i < 4; ++i) {
            lr_body_desc d = body_desc();
            d.position[0] = i % 2 ? 0.1f : -0.1f;
            d.position[1] = i < 2 ? 1.0f : 0.0f;
            d.linear_velocity[0] = i % 2 ? -1.0f : 1.0f;
            body[i] = add_body(world, batch[i == 3 ? 1 : 0], d);
        }
        steps(world, 60, 1.0f / 240.0f);
        const auto speed = [&](size_t i) { return wide(state_of(world, body[i]).linear_velocity[0]); };
        CHECK(speed(0) == doctest::Approx(within ? -1.0 : 1.0).epsilon(1e-3));
        CHECK(speed(1) == doctest::Approx(within ? 1.0 : -1.0).epsilon(1e-3));
        // Masses m and 3 m.
        CHECK(speed(2) == doctest::Approx(-2.0).epsilon(0.01));
        CHECK(std::abs(speed(3)) < 1e-5);
    }
}
