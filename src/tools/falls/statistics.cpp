#include "tools/falls/statistics.h"

#include <algorithm>
#include <cmath>

namespace lr::falls {

double quantile(std::span<const double> sorted, double part) {
    const double at = part * static_cast<double>(sorted.size() - 1);
    const auto low = static_cast<size_t>(at), high = std::min(low + 1, sorted.size() - 1);
    return sorted[low] + (at - static_cast<double>(low)) * (sorted[high] - sorted[low]);
}

Statistic summarise(std::vector<double> values) {
    Statistic s;
    s.count = values.size();
    if (values.empty()) return s;
    std::sort(values.begin(), values.end());
    const auto n = static_cast<double>(values.size());
    for (double v : values) s.mean += v / n;
    double squares = 0.0;
    for (double v : values) squares += (v - s.mean) * (v - s.mean);
    if (values.size() > 1) s.deviation = std::sqrt(squares / (n - 1.0));
    s.standard_error = s.deviation / std::sqrt(n);
    s.p5 = quantile(values, 0.05), s.p25 = quantile(values, 0.25), s.p50 = quantile(values, 0.5);
    s.p75 = quantile(values, 0.75), s.p95 = quantile(values, 0.95);
    return s;
}

std::vector<size_t> peaks(std::span<const double> signal, double hysteresis) {
    std::vector<size_t> found;
    if (signal.empty()) return found;
    bool rising = false; // by at least `hysteresis` since the last minimum
    size_t highest = 0;
    double lowest = signal[0];
    for (size_t i = 1; i < signal.size(); ++i)
        if (rising) {
            if (signal[i] > signal[highest]) highest = i;
            if (signal[i] <= signal[highest] - hysteresis) {
                found.push_back(highest);
                rising = false;
                lowest = signal[i];
            }
        } else {
            lowest = std::min(lowest, signal[i]);
            if (signal[i] >= lowest + hysteresis) {
                rising = true;
                highest = i;
            }
        }
    return found;
}
} // namespace lr::falls
