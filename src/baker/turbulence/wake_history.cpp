#include "baker/turbulence/wake_history.h"

#include <algorithm>
#include <cmath>

namespace lr::baker {

using shape::TurbulenceState;

namespace {

constexpr double settled_spread = 0.02;
constexpr double repeats = 0.8; // least autocorrelation of a period
constexpr size_t shortest_period = 8;
} // namespace

bool is_stationary(const std::vector<TurbulenceState>& history, size_t window) {
    if (history.size() <= window) return false;
    double low_chi = 1e300, high_chi = 0.0, low_epsilon = 1e300, high_epsilon = 0.0;
    for (size_t n = history.size() - window - 1; n < history.size(); ++n) {
        const double chi = shape::turbulent_frequency(history[n]);
        low_chi = std::min(low_chi, chi);
        high_chi = std::max(high_chi, chi);
        low_epsilon = std::min(low_epsilon, history[n].epsilon);
        high_epsilon = std::max(high_epsilon, history[n].epsilon);
    }
    return high_chi - low_chi <= settled_spread * high_chi &&
           high_epsilon - low_epsilon <= settled_spread * high_epsilon;
}

size_t find_period(const std::vector<TurbulenceState>& history) {
    const size_t begin = history.size() / 2, count = history.size() - begin;
    if (count < 2 * shortest_period) return 0;
    std::vector<double> chi(count);
    double mean = 0.0;
    for (size_t n = 0; n < count; ++n) mean += chi[n] = shape::turbulent_frequency(history[begin + n]);
    mean /= static_cast<double>(count);
    for (double& x : chi) x -= mean;
    // Normalised by the two stretches that the lag compares, so that a growing or decaying oscillation is periodic, and a drift is not.
    const auto correlation = [&](size_t lag) {
        double both = 0.0, first = 0.0, second = 0.0;
        for (size_t n = 0; n + lag < count; ++n) {
            both += chi[n] * chi[n + lag];
            first += chi[n] * chi[n];
            second += chi[n + lag] * chi[n + lag];
        }
        const double norm = std::sqrt(first * second);
        return norm > 0.0 ? both / norm : 0.0;
    };
    bool fell = false; // below zero, as any oscillation does before its first repetition
    double before = 1.0, here = correlation(1);
    for (size_t lag = 2; 2 * lag <= count + 1; ++lag) {
        const double next = correlation(lag);
        fell = fell || here < 0.0;
        if (fell && lag > shortest_period && here >= repeats && here >= before && here > next) return lag - 1;
        before = here;
        here = next;
    }
    return 0;
}

WakeSummary summarise_wake(const std::vector<TurbulenceState>& history, size_t window) {
    WakeSummary summary;
    if (is_stationary(history, window)) {
        summary.end = WakeEnd::stationary;
        summary.count = window + 1;
    } else if (const size_t period = find_period(history); period > 0) {
        summary.end = WakeEnd::loop;
        summary.count = period;
    } else {
        summary.count = history.size() - history.size() / 2;
    }
    summary.begin = history.size() - summary.count;
    for (size_t n = summary.begin; n < history.size(); ++n) {
        summary.mean.k += history[n].k;
        summary.mean.epsilon += history[n].epsilon;
    }
    summary.mean.k /= static_cast<double>(summary.count);
    summary.mean.epsilon /= static_cast<double>(summary.count);
    return summary;
}
} // namespace lr::baker
