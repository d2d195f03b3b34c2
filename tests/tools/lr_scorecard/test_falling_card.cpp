// The reference of the falling card: its order, its terms by hand, and the card as an asset.
#include "tools/lr_scorecard/card_asset.h"
#include "tools/lr_scorecard/falling_card.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace lr::scorecard;

namespace {

double apart(const CardState& a, const CardState& b) {
    return std::hypot(a.x - b.x, a.y - b.y) + std::abs(a.angle - b.angle) + std::abs(a.w - b.w);
}

CardState tilted(double angle) {
    CardState s;
    s.angle = angle;
    s.vx = 0.1, s.vy = -0.1; // off rest, where the drag has a corner
    return s;
}

} // namespace

TEST_CASE("falling card: RK4's error falls by sixteen when the step is halved") {
    const CardModel model;
    const CardState exact = fall(model, tilted(0.3), 4.0, 4.0, 1e-4).back();
    const double coarse = apart(fall(model, tilted(0.3), 4.0, 4.0, 0.1).back(), exact),
                 fine = apart(fall(model, tilted(0.3), 4.0, 4.0, 0.05).back(), exact);
    CHECK(coarse > 1e-7);
    CHECK(std::log2(coarse / fine) > 3.6);
}

TEST_CASE("falling card: dropped flat or edge on it reaches the speed at which drag is weight") {
    CardModel model;
    const double pi = std::numbers::pi;
    // Edge on, drag (A - B)/pi s^2; flat, (A + B)/pi s^2; the weight is 1. Edge on is unstable, but symmetric.
    const CardState edge = fall(model, {0, 0, 0, -pi / 2, 0, 0}, 8.0, 1.0, 0.01).back();
    CHECK(edge.vx == doctest::Approx(std::sqrt(pi / (model.a - model.b))).epsilon(0.05));
    model.mu1 = 20.0; // spin drag keeps it there
    const CardState flat = fall(model, CardState{}, 40.0, 1.0, 0.01).back();
    CHECK(flat.vy == doctest::Approx(-std::sqrt(pi / (model.a + model.b))).epsilon(1e-3));
}

TEST_CASE("falling card: the side it is released to is the only difference between left and right") {
    const CardModel model{1.4};
    const std::vector<CardState> a = fall(model, tilted(0.3), 20.0, 0.5, 0.01);
    CardState mirrored = tilted(-0.3);
    mirrored.vx = -0.1;
    const std::vector<CardState> b = fall(model, mirrored, 20.0, 0.5, 0.01);
    for (size_t i = 0; i < a.size(); ++i) {
        CHECK(a[i].x == doctest::Approx(-b[i].x).epsilon(1e-6));
        CHECK(a[i].y == doctest::Approx(b[i].y).epsilon(1e-6));
        CHECK(a[i].angle == doctest::Approx(-b[i].angle).epsilon(1e-6));
    }
}

TEST_CASE("falling card: means are over the second half") {
    std::vector<CardState> states(101);
    for (size_t i = 0; i < states.size(); ++i) {
        const double t = 0.1 * static_cast<double>(i);
        states[i].x = t < 5.0 ? 100.0 : 100.0 + 2.0 * (t - 5.0);
        states[i].y = -3.0 * t;
        states[i].angle = 0.5 * t;
    }
    const CardMeans m = means(states, 0.1);
    CHECK(m.vx == doctest::Approx(2.0));
    CHECK(m.vy == doctest::Approx(-3.0));
    CHECK(m.w == doctest::Approx(0.5));
}

TEST_CASE("falling card: the asset has the model's masses and its weight at the model's gravity") {
    for (double inertia : {1.1, 1.4, 2.2}) {
        const CardBody card = make_card(CardModel{inertia});
        const lr_asset_info info = info_of(card.asset);
        const double unit = info.added_mass[7]; // the model's unit of mass: the added mass along the normal
        const double a = card.length;
        CHECK(unit == doctest::Approx(1000.0 * std::numbers::pi * a * a * 0.02)); // its span
        CHECK(info.mass / unit == doctest::Approx(inertia));
        CHECK(info.inertia[8] / (unit * a * a) == doctest::Approx(0.25 * inertia));
        CHECK(info.added_mass[35] / (unit * a * a) == doctest::Approx(0.125));
        CHECK(info.added_mass[0] < 1e-5 * unit);
        const double weight = (info.mass - info.fluid_density * info.volume) * card.gravity;
        CHECK(weight / (unit * card.speed * card.speed / a) == doctest::Approx(1.0));
    }
}
