#include "baker/turbulence/turbulence_production.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <limits>

using namespace lr::shape;

namespace {

// Eqs. 14 to 17 as in the paper, by Runge-Kutta in small steps, independent of the closed forms.
TurbulenceState integrate(TurbulenceState s, double strain, double t, int steps) {
    const auto rate = [strain](TurbulenceState x) {
        const double g = 0.09 * x.k * x.k / x.epsilon * strain;
        return TurbulenceState{g - x.epsilon, x.epsilon / x.k * (1.44 * g - 1.92 * x.epsilon)};
    };
    const auto add = [](TurbulenceState x, TurbulenceState d, double h) {
        return TurbulenceState{x.k + h * d.k, x.epsilon + h * d.epsilon};
    };
    const double h = t / steps;
    for (int n = 0; n < steps; ++n) {
        const TurbulenceState a = rate(s), b = rate(add(s, a, h / 2)), c = rate(add(s, b, h / 2)),
                              d = rate(add(s, c, h));
        s.k += h / 6 * (a.k + 2 * b.k + 2 * c.k + d.k);
        s.epsilon += h / 6 * (a.epsilon + 2 * b.epsilon + 2 * c.epsilon + d.epsilon);
    }
    return s;
}

double relative(double a, double b) {
    return std::abs(a / b - 1.0);
}

} // namespace

TEST_CASE("inflow state follows Eq. 18 with the intensity as a parameter") {
    const TurbulenceState s = inflow_state(2.0, 0.5, 0.1);
    CHECK(relative(s.k, 1.5) < 1e-14);
    CHECK(relative(s.epsilon, std::pow(0.09, 0.75) * std::pow(1.5, 1.5) / 0.1) < 1e-14);
    CHECK(relative(eddy_viscosity(s), 0.09 * 1.5 * 1.5 / s.epsilon) < 1e-14);
    CHECK(relative(turbulent_frequency(inflow_state(1.0, 1.0, 1.0)), 0.201248) < 1e-5);
}

TEST_CASE("decay is the solution of Eqs. 16 and 17 without production") {
    const TurbulenceState s0 = inflow_state(0.7, 1.0, 0.02);
    for (double t : {0.01, 0.1, 1.0, 5.0}) {
        const TurbulenceState exact = decay(s0, t), numeric = integrate(s0, 0.0, t, 20000);
        CHECK(relative(exact.k, numeric.k) < 1e-9);
        CHECK(relative(exact.epsilon, numeric.epsilon) < 1e-9);
        const double q = 1.0 + 0.92 * turbulent_frequency(s0) * t;
        CHECK(relative(exact.k, s0.k * std::pow(q, -1.0 / 0.92)) < 1e-12);
        CHECK(relative(turbulent_frequency(exact), turbulent_frequency(s0) / q) < 1e-12);
    }
}

TEST_CASE("evolve is the solution of Eqs. 16 and 17 with production") {
    const TurbulenceState s0 = inflow_state(0.7, 0.3, 0.02);
    for (double strain : {1e-6, 0.1, 10.0, 1000.0})
        for (double t : {0.01, 0.1, 0.5}) {
            const TurbulenceState exact = evolve(s0, strain, t), numeric = integrate(s0, strain, t, 20000);
            CHECK(relative(exact.k, numeric.k) < 1e-8);
            CHECK(relative(exact.epsilon, numeric.epsilon) < 1e-8);
            // Two half steps are one step.
            const TurbulenceState twice = evolve(evolve(s0, strain, t / 2), strain, t / 2);
            CHECK(relative(twice.k, exact.k) < 1e-12);
            CHECK(relative(twice.epsilon, exact.epsilon) < 1e-12);
        }
    // No jump at the switch to the plain decay.
    const TurbulenceState still = decay(s0, 0.5);
    for (double strain : {0.0, 1e-20, 1e-17, 1e-15, 1e-12}) {
        CHECK(relative(evolve(s0, strain, 0.5).k, still.k) < 1e-9);
        CHECK(relative(evolve(s0, strain, 0.5).epsilon, still.epsilon) < 1e-9);
    }
}

TEST_CASE("constant strain tends to production over dissipation (C2-1)/(C1-1) from either side") {
    for (double chi0 : {0.01, 1.0, 100.0}) {
        const double strain = 4.0;
        const TurbulenceState s = evolve({1.0, chi0}, strain, 40.0);
        const double production = eddy_viscosity(s) * strain;
        CHECK(relative(production / s.epsilon, 0.92 / 0.44) < 1e-6);
    }
}

TEST_CASE("evolve stays positive and finite in extremes") {
    for (double k : {1e-12, 1.0, 1e12})
        for (double chi : {1e-12, 1.0, 1e12})
            for (double strain : {0.0, 1e-12, 1.0, 1e12})
                for (double t : {0.0, 1e-9, 1.0, 1e6}) {
                    const TurbulenceState s = evolve({k, k * chi}, strain, t);
                    CHECK(std::isfinite(s.k));
                    CHECK(std::isfinite(s.epsilon));
                    CHECK(s.k > 0.0);
                    CHECK(s.epsilon > 0.0);
                }
}

TEST_CASE("where there is no turbulence none comes, and in the end there is none") {
    const double endless = std::numeric_limits<double>::infinity();
    for (double t : {0.0, 1e-3, 1.0, 1e3, endless}) {
        const TurbulenceState still = decay({0.0, 0.0}, t), strained = evolve({0.0, 0.0}, 100.0, t);
        CHECK((still.k == 0.0 && still.epsilon == 0.0));
        CHECK((strained.k == 0.0 && strained.epsilon == 0.0));
    }
    const TurbulenceState end = decay(inflow_state(1.0, 1.0, 0.1), endless);
    CHECK((end.k == 0.0 && end.epsilon == 0.0));
    CHECK(kolmogorov_c0(endless) == 6.5);
}

TEST_CASE("C0 rises from 0 to 6.5 with the Taylor-scale Reynolds number") {
    CHECK(kolmogorov_c0(0.0) == 0.0);
    CHECK(kolmogorov_c0(-5.0) == 0.0);
    CHECK(kolmogorov_c0(std::numeric_limits<double>::quiet_NaN()) == 0.0);
    CHECK(kolmogorov_c0(std::numeric_limits<double>::infinity()) == 6.5);
    CHECK(kolmogorov_c0(1e300) == 6.5);
    CHECK(relative(kolmogorov_c0(1e9), 6.5) < 1e-9);
    CHECK(relative(kolmogorov_c0(1e-6), 6.5 * std::pow(140.0, -0.75) * 1e-6) < 1e-6);
    for (double r : {1.0, 30.0, 100.0, 4300.0})
        CHECK(relative(kolmogorov_c0(r), 6.5 * std::pow(1.0 + 140.0 * std::pow(r, -4.0 / 3.0), -0.75)) < 1e-12);
    double last = 0.0;
    for (double r = 1e-3; r < 1e7; r *= 1.5) {
        CHECK(kolmogorov_c0(r) > last);
        last = kolmogorov_c0(r);
    }
    // k = 1, epsilon = 2, nu = 1e-5: sqrt(20/(6e-5)).
    CHECK(relative(taylor_reynolds({1.0, 2.0}, 1e-5), 577.3502692) < 1e-9);
}
