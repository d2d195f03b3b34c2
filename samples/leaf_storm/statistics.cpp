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

void Sampler::add(const lr_batch_view& view, const std::vector<float>& velocities, const float* wind,
                  Histogram* descents) {
    sample_.at_rest += view.count - view.awake_count;
    for (std::size_t i = 0; i < view.awake_count; ++i) {
        const double x = view.orientation[0][i], y = view.orientation[1][i], z = view.orientation[2][i],
                     w = view.orientation[3][i];
        double v[3], spin[3]; // v: relative to the wind
        for (std::size_t k = 0; k < 3; ++k) {
            v[k] = static_cast<double>(velocities[6 * i + k]) - static_cast<double>(wind[k]);
            spin[k] = static_cast<double>(velocities[6 * i + 3 + k]);
        }
        const double up = v[1];
        const double horizontal = std::sqrt(v[0] * v[0] + v[2] * v[2]);
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
