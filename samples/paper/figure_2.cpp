// Fig. 2: chi and epsilon over time.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "chart.h"
#include "figures.h"
#include "panel.h"
#include "turbulence.h"

void figure_2(const Options& options, Numbers& numbers) {
    const BakeReport empty = read_report(options.baked + "/table.json"),
                     wake = read_report(options.baked + "/table_wake.json");
    const auto curve = [](const BakeReport& report, const std::vector<double>& values, const char* name, Colour colour,
                          double until) {
        Curve made{name, colour, {}};
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double t = static_cast<double>(i) * report.table_dt;
            if (t <= until) made.points.push_back({t, values[i]});
        }
        return made;
    };
    const double until = std::min(static_cast<double>(empty.chi.size() - 1) * empty.table_dt,
                                  static_cast<double>(wake.chi.size() - 1) * wake.table_dt);
    Curve chi_exact{"closed form", from_srgb(20, 20, 20), {}, true}, epsilon_exact = chi_exact;
    double worst = 0.0;
    for (std::size_t i = 0; i < empty.chi.size(); ++i) {
        const double t = static_cast<double>(i) * empty.table_dt, k = closed_form_decay(empty.chi[0], t);
        const double chi = empty.chi[0] / (1.0 + 0.92 * empty.chi[0] * t); // epsilon/k of the same solution
        const double epsilon = empty.epsilon[0] * k * chi / empty.chi[0];
        worst = std::max({worst, std::abs(empty.chi[i] / chi - 1.0), std::abs(empty.epsilon[i] / epsilon - 1.0)});
        if (t > until) continue;
        chi_exact.points.push_back({t, chi});
        epsilon_exact.points.push_back({t, epsilon});
    }
    const Colour blue = from_srgb(31, 95, 168), red = from_srgb(196, 72, 44);
    Picture picture(1000, 380, {1.0f, 1.0f, 1.0f});
    draw_chart(picture, {10, 10, 485, 360}, "chi (1/s)", "time (s)",
               {curve(empty, empty.chi, "empty stream", blue, until), chi_exact,
                curve(wake, wake.chi, "in the wake of the leaf", red, until)});
    draw_chart(picture, {505, 10, 485, 360}, "epsilon (m2/s3)", "time (s)",
               {curve(empty, empty.epsilon, "empty stream", blue, until), epsilon_exact,
                curve(wake, wake.epsilon, "in the wake of the leaf", red, until)});
    save(options, "2", picture);

    numbers.judge("2", "table", "Reynolds number", empty.reynolds, "", "3.8e3",
                  std::abs(empty.reynolds / 3.8e3 - 1.0) < 0.01);
    numbers.show("2", "table", "chi at first", empty.chi.front(), "1/s");
    numbers.show("2", "table", "chi at last over chi at first", empty.chi.back() / empty.chi.front(), "");
    numbers.show("2", "table", "epsilon at last over epsilon at first", empty.epsilon.back() / empty.epsilon.front(),
                 "");
    const bool falls = std::is_sorted(empty.epsilon.rbegin(), empty.epsilon.rend()) &&
                       empty.epsilon.back() < 0.1 * empty.epsilon.front();
    numbers.judge("2", "table", "epsilon decays throughout (1: yes)", falls ? 1.0 : 0.0, "",
                  "dissipates after an unstable beginning", falls);
    numbers.judge("2", "table", "largest error against the closed form of Eqs. 16 and 17", worst, "", "", worst < 1e-3);
    numbers.show("2", "table with wake", "chi where it has settled", wake.chi[wake.stationary], "1/s",
                 "no body in the stream");
}
