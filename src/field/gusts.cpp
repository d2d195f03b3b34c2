#include "field/gusts.h"

#include "field/harmonic.h"
#include "shape/portable_math.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

// Frequencies times the integral time. Below the first lie 2 % of the energy of the spectrum, above the last 3 %: the
// sum is scaled to the variance that was asked for.
constexpr double lowest = 0.005, highest = 20.0;
// Integral times after which all harmonics have their amplitude. Slow ones would else take up to 1 / lowest.
constexpr double youth = 4.0;

// von Karman's longitudinal spectrum, times 1/(4 rms^2 period), of f times the period.
double spectrum(double f) {
    return shape::portable_pow(1.0 + 70.8 * f * f, -5.0 / 6.0);
}

} // namespace

Gusts::Gusts(const GustSettings& s, CounterRandom random) {
    const double ratio = shape::portable_pow(highest / lowest, 1.0 / static_cast<double>(modes));
    double angle[modes], energy[modes], total = 0.0, angles = 0.0;
    double edge = lowest;
    for (size_t i = 0; i < modes; ++i, edge *= ratio) {
        const double f = edge * random.between(1.0, ratio);
        energy[i] = spectrum(f) * edge * (ratio - 1.0);
        mode_[i].frequency = f / s.period;
        mode_[i].growth = std::max(f, 1.0 / youth) / s.period;
        mode_[i].phase = random.uniform();
        double sine, cosine;
        sin_cos_turns(random.uniform(), sine, cosine);
        angle[i] = std::sqrt(-2.0 * shape::portable_log(random.uniform())) * cosine; // Box and Muller
        total += energy[i];
        angles += energy[i] * angle[i] * angle[i];
    }
    // Two directions across the main one.
    const double* const d = s.direction;
    const int least = std::abs(d[0]) <= std::abs(d[1]) ? (std::abs(d[0]) <= std::abs(d[2]) ? 0 : 2)
                                                       : (std::abs(d[1]) <= std::abs(d[2]) ? 1 : 2);
    double side[3] = {-d[least] * d[0], -d[least] * d[1], -d[least] * d[2]};
    side[least] += 1.0;
    const double norm = std::sqrt(side[0] * side[0] + side[1] * side[1] + side[2] * side[2]);
    for (double& x : side) x /= norm;
    const double up[3] = {d[1] * side[2] - d[2] * side[1], d[2] * side[0] - d[0] * side[2],
                          d[0] * side[1] - d[1] * side[0]};
    constexpr double turn = 0.15915494309189533577; // 1/(2 pi)
    for (size_t i = 0; i < modes; ++i) {
        const double amplitude = s.rms * std::sqrt(2.0 * energy[i] / total);
        double along, across, first, second;
        // So scaled, the energy's mean square angle is exactly that of the spread.
        sin_cos_turns(s.spread * angle[i] / std::sqrt(angles / total) * turn, across, along);
        sin_cos_turns(random.uniform(), first, second);
        for (size_t k = 0; k < 3; ++k)
            mode_[i].amplitude[k] = amplitude * (along * d[k] + across * (first * side[k] + second * up[k]));
    }
}

void Gusts::add(double age, double velocity[3]) const {
    if (!(age > 0.0)) return; // also a batch that catches up on time before the source was there
    for (const Mode& m : mode_) {
        const double part = std::min(m.growth * age, 1.0), grown = part * part * (3.0 - 2.0 * part);
        double sine, cosine;
        sin_cos_turns(m.frequency * age + m.phase, sine, cosine);
        for (size_t k = 0; k < 3; ++k) velocity[k] += grown * cosine * m.amplitude[k];
    }
}

} // namespace lr
