#include "tools/falls/regime.h"

#include "tools/falls/statistics.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace lr::falls {
namespace {

// Hysteresis of an overturn: the cosine between normal and vertical must pass from beyond one sign of this to beyond the other.
constexpr double over = 0.1;

struct Crossing {
    size_t at;
    Eigen::Vector3d axis; // of the normal's rotation during the overturn
};

struct Motion {
    std::vector<double> path; // rad, path of the normal since the first sample
    std::vector<Crossing> crossings;
};

Motion follow(std::span<const Eigen::Vector3d> normals, const Eigen::Vector3d& up) {
    Motion m;
    m.path.assign(1, 0.0);
    std::vector<Eigen::Vector3d> turned(1, Eigen::Vector3d::Zero()); // sum of n x dn
    for (size_t i = 1; i < normals.size(); ++i) {
        const Eigen::Vector3d axis = normals[i - 1].cross(normals[i]);
        m.path.push_back(m.path.back() + std::atan2(axis.norm(), normals[i - 1].dot(normals[i])));
        turned.push_back(turned.back() + axis);
    }
    int side = 0;
    size_t left = 0; // last sample on the previous side
    for (size_t i = 0; i < normals.size(); ++i) {
        const double cosine = normals[i].dot(up);
        const int now = cosine > over ? 1 : cosine < -over ? -1 : 0;
        if (now == 0) continue;
        if (side != 0 && now != side) m.crossings.push_back({(left + i) / 2, turned[i] - turned[left]});
        side = now;
        left = i;
    }
    return m;
}

// Autocorrelation of the horizontal part of the normal minus its mean; 1 at lag 0.
std::vector<double> autocorrelation(std::span<const Eigen::Vector3d> normals, const Eigen::Vector3d& up, size_t lags) {
    std::vector<Eigen::Vector3d> h;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& n : normals) {
        h.push_back(n - n.dot(up) * up);
        mean += h.back() / static_cast<double>(normals.size());
    }
    for (Eigen::Vector3d& v : h) v -= mean;
    std::vector<double> r(lags, 0.0);
    for (size_t lag = 0; lag < lags; ++lag) {
        // Normalised by the energy of both stretches, so that the shorter overlap of a long lag does not damp it.
        double product = 0.0, early = 0.0, late = 0.0;
        for (size_t i = 0; i + lag < h.size(); ++i) {
            product += h[i].dot(h[i + lag]);
            early += h[i].squaredNorm();
            late += h[i + lag].squaredNorm();
        }
        const double energy = std::sqrt(early * late);
        r[lag] = energy > 0.0 ? product / energy : 0.0;
    }
    return r;
}
} // namespace

RegimeMeasures measure_regime(std::span<const Eigen::Vector3d> normals, const Eigen::Vector3d& up,
                              const RegimeLimits& limits) {
    RegimeMeasures m;
    if (normals.size() < 3) return m;
    std::vector<double> tilts;
    for (const Eigen::Vector3d& n : normals)
        tilts.push_back(std::acos(std::min(1.0, std::abs(n.dot(up)))) * 180.0 / std::numbers::pi);
    std::vector<double> sorted = tilts;
    std::sort(sorted.begin(), sorted.end());
    m.tilt95 = quantile(sorted, 0.95);

    const Motion motion = follow(normals, up);
    m.overturns = static_cast<double>(motion.crossings.size());
    // Flutter beyond the horizontal also makes straight half turns, but returns, so only two in a row (a whole turn) count.
    std::vector<bool> straight;
    double net = motion.crossings.empty() ? 0.0 : 1.0, way_round = 1.0;
    for (size_t i = 1; i < motion.crossings.size(); ++i) {
        const Crossing &a = motion.crossings[i - 1], &b = motion.crossings[i];
        const double turn = motion.path[b.at] - motion.path[a.at];
        if (a.axis.dot(b.axis) < 0.0) way_round = -way_round;
        net += way_round;
        straight.push_back(a.axis.dot(b.axis) > 0.0 && turn < limits.longest_half_turn * std::numbers::pi);
    }
    m.net_half_turns = std::abs(net);
    size_t time = 0;
    for (size_t begin = 0; begin < straight.size();) {
        size_t end = begin;
        while (end < straight.size() && straight[end]) ++end;
        if (end - begin >= 2) m.half_turns += static_cast<double>(end - begin);
        if (end - begin >= limits.tumbling_run) time += motion.crossings[end].at - motion.crossings[begin].at;
        begin = end + 1;
    }
    m.tumbling_share = static_cast<double>(time) / static_cast<double>(normals.size() - 1);

    // From the side that is up most of the time, because flutter past the horizontal has maxima beyond 90 degrees.
    double height = 0.0;
    for (const Eigen::Vector3d& n : normals) height += n.dot(up);
    const Eigen::Vector3d zenith = height < 0.0 ? Eigen::Vector3d(-up) : up;
    for (size_t i = 0; i < normals.size(); ++i)
        tilts[i] = std::acos(std::clamp(normals[i].dot(zenith), -1.0, 1.0)) * 180.0 / std::numbers::pi;
    std::vector<double> maxima;
    for (size_t i : peaks(tilts, std::max(0.1 * m.tilt95, 0.25))) maxima.push_back(tilts[i]);
    const Statistic amplitude = summarise(std::move(maxima));
    m.amplitude_spread = amplitude.mean > 0.0 ? amplitude.deviation / amplitude.mean : 0.0;

    const std::vector<double> r = autocorrelation(normals, up, normals.size() / 2);
    const std::vector<size_t> returns = peaks(r, 0.2);
    if (!returns.empty()) {
        // An elliptic orbit has a smaller maximum at half its period, so the highest of the first few is the whole period.
        size_t best = returns[0];
        for (size_t i = 1; i < std::min<size_t>(returns.size(), 3); ++i)
            if (r[returns[i]] > r[best] + 0.1) best = returns[i];
        m.period = static_cast<double>(best);
        m.regularity = r[best];
    }
    return m;
}

Regime classify(const RegimeMeasures& m, size_t samples, const RegimeLimits& limits) {
    if (m.tilt95 < limits.steady_tilt) return Regime::steady;
    if (m.tumbling_share >= limits.tumbling_share) return Regime::tumbling;
    const bool regular = m.period > 0.0 && m.regularity >= limits.regularity &&
                         m.amplitude_spread <= limits.amplitude_spread &&
                         static_cast<double>(samples) >= limits.least_periods * m.period;
    return m.half_turns == 0.0 && regular ? Regime::periodic : Regime::chaotic;
}

Regime classify(std::span<const Eigen::Vector3d> normals, const Eigen::Vector3d& up, const RegimeLimits& limits) {
    return classify(measure_regime(normals, up, limits), normals.size(), limits);
}
} // namespace lr::falls
