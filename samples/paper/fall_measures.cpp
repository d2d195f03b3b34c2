// SPDX-License-Identifier: MIT
#include "fall_measures.h"

#include <algorithm>
#include <numbers>

namespace {

constexpr double pi = std::numbers::pi, degrees = 180.0 / pi;

double descent_of(const Track& track) {
    const Pose &middle = track[track.size() / 2], &last = track.back();
    return (middle.position[1] - last.position[1]) / (last.time - middle.time);
}

struct Axes {
    double main_x, main_z; // unit vector
    double along, across;  // root mean squares
};

// Principal directions of points in the horizontal plane about `x0`, `z0`.
Axes principal(const std::vector<double>& x, const std::vector<double>& z, double x0, double z0) {
    double xx = 0.0, xz = 0.0, zz = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - x0) * (x[i] - x0);
        xz += (x[i] - x0) * (z[i] - z0);
        zz += (z[i] - z0) * (z[i] - z0);
    }
    const double n = static_cast<double>(x.size()), angle = 0.5 * std::atan2(2.0 * xz, xx - zz);
    const double mean = 0.5 * (xx + zz), spread = std::hypot(0.5 * (xx - zz), xz);
    return {std::cos(angle), std::sin(angle), std::sqrt((mean + spread) / n),
            std::sqrt(std::max(0.0, mean - spread) / n)};
}

double mean_of(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

} // namespace

std::vector<std::size_t> reversals(const std::vector<double>& series, double height) {
    std::vector<std::size_t> found;
    std::size_t low = 0, high = 0;
    int going = 0; // 1 up, -1 down
    for (std::size_t i = 0; i < series.size(); ++i) {
        if (series[i] > series[high]) high = i;
        if (series[i] < series[low]) low = i;
        if (going >= 0 && series[i] < series[high] - height) {
            if (going > 0) found.push_back(high);
            going = -1;
            low = i;
        } else if (going <= 0 && series[i] > series[low] + height) {
            if (going < 0) found.push_back(low);
            going = 1;
            high = i;
        }
    }
    return found;
}

bool LeafFall::helical() const {
    return std::abs(helix) >= 1.0 && coherence >= 0.5;
}

bool LeafFall::side_to_side() const {
    return overturns >= 2.0 && side_turns >= 2.0;
}

LeafFall measure_leaf(const Track& track) {
    LeafFall fall;
    fall.descent = descent_of(track);
    const double interval = track[1].time - track[0].time;
    // The heading is averaged over 0.2 s, so that the swing of a flutter does not count as a turn.
    const auto smooth = std::max<std::size_t>(4, static_cast<std::size_t>(std::lround(0.2 / interval)));
    double before = 0.0, net = 0.0, total = 0.0;
    for (std::size_t i = 0; i + smooth < track.size(); i += smooth / 4) {
        const Vector way = minus(track[i + smooth].position, track[i].position);
        const double heading = std::atan2(way[2], way[0]);
        const double turn = i > 0 ? std::remainder(heading - before, 2.0 * pi) : 0.0;
        net += turn;
        total += std::abs(turn);
        before = heading;
    }
    fall.helix = net / (2.0 * pi);
    fall.coherence = total > 0.0 ? std::abs(net) / total : 0.0;

    std::vector<double> vx, vz, along;
    double side = 0.0;
    for (const Pose& pose : track) {
        vx.push_back(pose.velocity[0]);
        vz.push_back(pose.velocity[2]);
        fall.rolls += std::abs(dot(pose.spin, turned(pose.turn, {1.0, 0.0, 0.0}))) * interval / (2.0 * pi);
        const double up = turned(pose.turn, {0.0, 0.0, 1.0})[1];
        if (std::abs(up) < 0.1) continue;
        if (side * up < 0.0) fall.overturns += 1.0;
        side = up;
    }
    const Axes axes = principal(vx, vz, mean_of(vx), mean_of(vz));
    for (const Pose& pose : track) along.push_back(axes.main_x * pose.position[0] + axes.main_z * pose.position[2]);
    fall.side_turns = static_cast<double>(reversals(along, 0.01).size());
    return fall;
}

PlaneFlight measure_plane(const Track& track) {
    PlaneFlight flight;
    double before = 0.0, net = 0.0;
    bool first = true;
    for (const Pose& pose : track) {
        const Vector nose = turned(pose.turn, {1.0, 0.0, 0.0});
        flight.pitch = std::max(flight.pitch, std::abs(std::asin(std::clamp(nose[1], -1.0, 1.0))) * degrees);
        if (std::hypot(nose[0], nose[2]) < 0.2) continue; // upright: no heading
        const double heading = std::atan2(nose[2], nose[0]);
        if (!first) net += std::remainder(heading - before, 2.0 * pi) * degrees;
        first = false;
        before = heading;
        flight.heading = std::max(flight.heading, std::abs(net));
    }
    return flight;
}

Sinking measure_sinking(const Track& track) {
    Sinking sinking;
    sinking.descent = descent_of(track);
    std::vector<double> x, z, main, cross;
    for (const Pose& pose : track) {
        const Vector thin = turned(pose.turn, {0.0, 0.0, 1.0});
        sinking.tilt = std::max(sinking.tilt, std::acos(std::min(1.0, std::abs(thin[1]))) * degrees);
        const double face = thin[1] < 0.0 ? -1.0 : 1.0;
        x.push_back(face * thin[0]);
        z.push_back(face * thin[2]);
    }
    const Axes axes = principal(x, z, 0.0, 0.0);
    sinking.across = axes.along > 0.0 ? axes.across / axes.along : 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        main.push_back(axes.main_x * x[i] + axes.main_z * z[i]);
        cross.push_back(axes.main_x * z[i] - axes.main_z * x[i]);
    }
    const double two_degrees = 2.0 / degrees, five_degrees = 5.0 / degrees;
    sinking.reversals = static_cast<double>(reversals(main, two_degrees).size() + reversals(cross, two_degrees).size());
    sinking.directions = (axes.along >= five_degrees ? 1.0 : 0.0) + (axes.across >= five_degrees ? 1.0 : 0.0);
    return sinking;
}
