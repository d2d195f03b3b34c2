// SPDX-License-Identifier: MIT
#include "statistics.h"

#include <algorithm>
#include <cmath>

void Histogram::add(double value) {
    const double bin = std::clamp((value + 50.0) * 500.0, 0.0, static_cast<double>(bins_.size() - 1));
    ++bins_[static_cast<std::size_t>(bin)];
    ++total_;
}

double Histogram::quantile(double part) const {
    const double wanted = part * static_cast<double>(total_);
    double below = 0.0;
    for (std::size_t i = 0; i < bins_.size(); ++i) {
        const auto here = static_cast<double>(bins_[i]);
        if (here > 0.0 && below + here >= wanted) {
            return (static_cast<double>(i) + (wanted - below) / here) / 500.0 - 50.0;
        }
        below += here;
    }
    return 0.0;
}

void Sampler::add(const lr_batch_view& view, const float* wind, Histogram* descents) {
    sample_.at_rest += view.count - view.awake_count;
    for (std::uint32_t i = 0; i < view.awake_count; ++i) {
        const double x = view.orientation[0][i], y = view.orientation[1][i], z = view.orientation[2][i],
                     w = view.orientation[3][i];
        const double v[3] = {view.velocity[0][i], view.velocity[1][i], view.velocity[2][i]};
        // Body to world: v + 2 w (q x v) + 2 q x (q x v).
        const double tx = 2.0 * (y * v[2] - z * v[1]), ty = 2.0 * (z * v[0] - x * v[2]),
                     tz = 2.0 * (x * v[1] - y * v[0]);
        const double east = v[0] + w * tx + y * tz - z * ty - static_cast<double>(wind[0]);
        const double up = v[1] + w * ty + z * tx - x * tz - static_cast<double>(wind[1]);
        const double south = v[2] + w * tz + x * ty - y * tx - static_cast<double>(wind[2]);
        const double spin[3] = {view.spin[0][i], view.spin[1][i], view.spin[2][i]};
        const double horizontal = std::sqrt(east * east + south * south);
        const double turning = std::sqrt(spin[0] * spin[0] + spin[1] * spin[1] + spin[2] * spin[2]);
        if (!std::isfinite(horizontal + up + turning)) continue; // the next step reports it
        ++sample_.bodies;
        sample_.descent -= up;
        sample_.horizontal += horizontal;
        sample_.spin += turning;
        sample_.tilt += std::abs(2.0 * (y * z - w * x));
        if (descents) descents->add(-up);
    }
}

Sample Sampler::finish() const {
    Sample mean = sample_;
    const double n = std::max(1.0, static_cast<double>(mean.bodies));
    mean.descent /= n;
    mean.horizontal /= n;
    mean.spin /= n;
    mean.tilt /= n;
    return mean;
}

int thin_axis(const lr_asset_info& info) {
    const double* i = info.inertia;
    return i[8] >= i[0] && i[8] >= i[4] ? 2 : (i[4] >= i[0] ? 1 : 0);
}

Summary summarise(const std::vector<Sample>& samples, const Histogram& descents, double from) {
    Summary result;
    result.from = from;
    for (const Sample& sample : samples) {
        if (sample.time < from) continue;
        result.to = sample.time;
        ++result.samples;
        result.mean_descent += sample.descent;
        result.horizontal += sample.horizontal;
        result.spin += sample.spin;
        result.tilt += sample.tilt;
    }
    const double n = std::max(1.0, static_cast<double>(result.samples));
    result.mean_descent /= n;
    result.horizontal /= n;
    result.spin /= n;
    result.tilt /= n;
    result.median_descent = descents.quantile(0.5);
    result.descent_5 = descents.quantile(0.05);
    result.descent_95 = descents.quantile(0.95);
    return result;
}
