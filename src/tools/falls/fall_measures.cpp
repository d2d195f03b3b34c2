#include "tools/falls/fall_measures.h"

#include "baker/eigensystem.h"
#include "tools/falls/regime.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace lr::falls {
namespace {

constexpr size_t most_judged = 512;        // samples: some twenty swings, and the autocorrelation is quadratic in them
constexpr double judged_turn = 1.0 / 40.0; // mean turn of the normal between judged samples, in turns, at most
constexpr double turn = 2.0 * std::numbers::pi;

Eigen::Vector3d horizontal(const Eigen::Vector3d& v) {
    return {v.x(), 0.0, v.z()};
}

// Motion over part of a fall, relative to the mean wind.
struct Travel {
    double time = 0.0, fallen = 0.0, path = 0.0, net = 0.0; // s, m; path and net: horizontal
};

Travel travel_of(std::span<const Sample> samples, double interval, const Eigen::Vector3d& wind) {
    Travel w;
    w.time = interval * static_cast<double>(samples.size() - 1);
    const Eigen::Vector3d drift = interval * wind;
    for (size_t i = 1; i < samples.size(); ++i)
        w.path += horizontal(samples[i].position - samples[i - 1].position - drift).norm();
    const Eigen::Vector3d whole = samples.back().position - samples.front().position;
    w.fallen = -whole.y();
    w.net = horizontal(whole - w.time * wind).norm();
    return w;
}

// Swings of the normal to and fro, along the horizontal direction in which it moves most.
double count_swings(std::span<const Eigen::Vector3d> normals) {
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    const auto flat = [](const Eigen::Vector3d& n) { return Eigen::Vector2d(n.x(), n.z()); };
    for (const Eigen::Vector3d& n : normals) mean += flat(n) / static_cast<double>(normals.size());
    for (const Eigen::Vector3d& n : normals) spread += (flat(n) - mean) * (flat(n) - mean).transpose();
    const Eigen::Vector2d axis = baker::eigensystem(spread).vectors.col(1);
    std::vector<double> signal;
    for (const Eigen::Vector3d& n : normals) signal.push_back(axis.dot(flat(n) - mean));
    std::vector<double> sorted = signal;
    std::sort(sorted.begin(), sorted.end());
    return static_cast<double>(peaks(signal, 0.5 * (quantile(sorted, 0.95) - quantile(sorted, 0.05))).size());
}

// Degrees: the angle from their mean that holds 95 % of the normals.
double attitude_change(std::span<const Eigen::Vector3d> normals) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& n : normals) mean += n;
    std::vector<double> angles;
    for (const Eigen::Vector3d& n : normals) angles.push_back(std::atan2(n.cross(mean).norm(), n.dot(mean)));
    std::sort(angles.begin(), angles.end());
    return quantile(angles, 0.95) * 180.0 / std::numbers::pi;
}

// Samples without the first quarter; if they are too many, thinned as far as the turning of the normal allows.
std::vector<Sample> judged(std::span<const Sample> all, const Shape& shape, size_t& stride) {
    const std::span<const Sample> last = all.last(all.size() - all.size() / 4);
    double turned = 0.0;
    for (size_t i = 1; i < last.size(); ++i) {
        const Eigen::Vector3d a = last[i - 1].orientation * shape.normal, b = last[i].orientation * shape.normal;
        turned += std::atan2(a.cross(b).norm(), a.dot(b)) / turn;
    }
    const double fine = judged_turn * static_cast<double>(last.size()) / std::max(turned, 1e-9);
    stride = std::clamp<size_t>((last.size() + most_judged - 1) / most_judged, 1,
                                static_cast<size_t>(std::clamp(fine, 1.0, 1e6)));
    std::vector<Sample> samples;
    for (size_t i = last.size(); i > 0 && samples.size() < most_judged; i -= std::min(i, stride))
        samples.push_back(last[i - 1]);
    std::reverse(samples.begin(), samples.end());
    return samples;
}

void judge(Fall& fall, std::span<const Sample> samples, double interval, const Shape& shape,
           const Eigen::Vector3d& wind, const MotionLimits& limits) {
    std::vector<Eigen::Vector3d> normals;
    double spin = 0.0, squares = 0.0; // about the vertical
    for (const Sample& s : samples) {
        normals.push_back(s.orientation * shape.normal);
        spin += s.spin.dot(up()) / static_cast<double>(samples.size());
        squares += s.spin.dot(up()) * s.spin.dot(up()) / static_cast<double>(samples.size());
    }
    RegimeLimits regime_limits;
    regime_limits.tumbling_run = 2;
    const RegimeMeasures m = measure_regime(normals, up(), regime_limits);
    const Travel travel = travel_of(samples, interval, wind);
    const double swings = count_swings(normals);
    fall.turnovers = 0.5 * m.half_turns / travel.time;
    fall.swings = swings / travel.time;

    const double turns = std::abs(spin) * travel.time / turn, lengths = std::abs(travel.fallen) / shape.length;
    const bool one_way = turns >= limits.spin_turns && std::abs(spin) >= limits.spin_constancy * std::sqrt(squares);
    const bool turns_over = m.half_turns > 0.0 || m.net_half_turns >= 2.0; // flutter past the vertical swings back
    const double flat = std::max(std::abs(travel.fallen), shape.length);
    fall.spirals = one_way && !turns_over && travel.path >= flat;
    const bool spins =
        !fall.spirals && one_way && turns >= limits.spin_per_length * lengths && turns > 0.5 * m.half_turns;
    const bool glides =
        fall.spirals || (!turns_over && travel.net >= flat && travel.net >= limits.glide_straightness * travel.path);
    const double change = attitude_change(normals);
    const bool keeps_attitude = change < limits.steady_angle;
    const bool irregular =
        swings >= limits.judged_swings && m.regularity < limits.regularity && change >= limits.rocking_angle;
    fall.motion = spins                                       ? Motion::spinning
                  : m.tumbling_share >= limits.tumbling_share ? Motion::tumbling
                  : glides                                    ? Motion::gliding
                  : keeps_attitude                            ? Motion::steady
                  : turns_over                                ? Motion::chaotic
                  : swings == 0.0                             ? Motion::steady // turns too slowly to swing
                  : irregular                                 ? Motion::chaotic
                                                              : Motion::fluttering;
}

Statistic over(const std::vector<Fall>& falls, double (*value)(const Fall&), bool (*counts)(const Fall&)) {
    std::vector<double> values;
    for (const Fall& f : falls)
        if (counts(f)) values.push_back(value(f));
    return summarise(std::move(values));
}
} // namespace

Fall measure(const Track& track, const Shape& shape, const Eigen::Vector3d& wind, const MotionLimits& limits) {
    Fall fall;
    fall.arrived = track.arrived;
    fall.time = track.time;
    fall.end = track.end;
    const std::span<const Sample> all(track.samples);
    const size_t n = all.size();
    if (n < 8) { // too short for parts: the mean of the whole fall, which is not settled
        if (track.time > 0.0) fall.descent = fall.last_quarter = -track.end.y() / track.time;
        return fall;
    }
    const auto descent = [&](size_t from, size_t to) {
        return (all[from].position.y() - all[to].position.y()) / (track.interval * static_cast<double>(to - from));
    };
    const size_t half = (n - 1) / 2, quarter = (n - 1) * 3 / 4;
    fall.descent = descent(half, n - 1);
    fall.third_quarter = descent(half, quarter);
    fall.last_quarter = descent(quarter, n - 1);
    const Travel second = travel_of(all.subspan(half), track.interval, wind);
    fall.horizontal_speed = second.path / second.time;
    for (const Sample& s : all.subspan(half)) fall.spin += s.spin.dot(up()) / turn / static_cast<double>(n - half);
    size_t stride = 1;
    const std::vector<Sample> samples = judged(all, shape, stride);
    judge(fall, samples, track.interval * static_cast<double>(stride), shape, wind, limits);
    return fall;
}

Falls summarise(const std::vector<Fall>& falls) {
    Falls out;
    out.count = static_cast<uint32_t>(falls.size());
    const auto any = [](const Fall&) { return true; };
    out.descent = over(
        falls, [](const Fall& f) { return f.descent; }, any);
    out.horizontal_speed = over(
        falls, [](const Fall& f) { return f.horizontal_speed; }, any);
    out.spin = over(
        falls, [](const Fall& f) { return std::abs(f.spin); }, any);
    out.turnovers = over(
        falls, [](const Fall& f) { return f.turnovers; }, any);
    out.swings = over(
        falls, [](const Fall& f) { return f.swings; }, [](const Fall& f) { return f.motion == Motion::fluttering; });
    out.turning = over(
        falls, [](const Fall& f) { return std::abs(f.spin); },
        [](const Fall& f) { return f.motion == Motion::spinning; });
    out.time = over(
        falls, [](const Fall& f) { return f.time; }, [](const Fall& f) { return f.arrived; });
    out.arrived = static_cast<uint32_t>(out.time.count);
    if (falls.empty()) return out;

    // Settled: the last quarter is as fast as the third, to 5 % or within the scatter. Bodies of varying speed reach the floor when they are fast, by
    // some part of that variation. The speeds of the middle half of the bodies must not spread or shift by much either: while some bodies speed up
    // and others begin to turn, the mean can stay constant.
    const Statistic gain = over(
        falls, [](const Fall& f) { return f.last_quarter - f.third_quarter; }, any);
    const Statistic& third = out.third_quarter = over(
        falls, [](const Fall& f) { return f.third_quarter; }, any);
    const Statistic& last = out.last_quarter = over(
        falls, [](const Fall& f) { return f.last_quarter; }, any);
    const double speed = std::abs(last.mean), scatter = std::hypot(third.standard_error, last.standard_error);
    const double moved = std::abs(last.p50 - third.p50);
    const double widened = std::abs((last.p75 - last.p25) - (third.p75 - third.p25));
    out.settled = std::abs(gain.mean) <= std::max({0.05 * speed, 3.0 * gain.standard_error, 0.2 * gain.deviation}) &&
                  std::max(moved, widened) <= std::max(0.15 * speed, 5.0 * scatter);

    const auto count = static_cast<double>(falls.size());
    for (const Fall& f : falls) {
        out.shares[static_cast<size_t>(f.motion)] += 1.0;
        out.spirals += f.spirals ? 1.0 / count : 0.0;
        out.drift += horizontal(f.end) / count;
    }
    for (double& share : out.shares) share /= count;
    std::vector<double> distances;
    for (const Fall& f : falls) distances.push_back((horizontal(f.end) - out.drift).norm());
    std::sort(distances.begin(), distances.end());
    out.half_radius = quantile(distances, 0.5);
    out.most_radius = quantile(distances, 0.95);
    return out;
}

const char* summary_word(const Falls& falls) {
    static constexpr std::array<const char*, motion_names.size()> words{"steady", "flutters", "tumbles",
                                                                        "spins",  "glides",   "chaotic"};
    const auto most = std::max_element(falls.shares.begin(), falls.shares.end());
    return *most < 0.5 ? "mixed" : words[static_cast<size_t>(most - falls.shares.begin())];
}
} // namespace lr::falls
