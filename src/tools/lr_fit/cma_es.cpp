#include "tools/lr_fit/cma_es.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lr::fit {

SeparableCmaEs::SeparableCmaEs(Point start, double step, size_t population, uint64_t seed)
    : random_(seed), mean_(std::move(start)), best_(mean_), step_(step), points_(population),
      variance_(mean_.size(), 1.0), path_(mean_.size(), 0.0), step_path_(path_) {
    const size_t half = population / 2;
    for (size_t i = 0; i < half; ++i)
        weights_.push_back(std::log(static_cast<double>(half) + 0.5) - std::log(static_cast<double>(i) + 1.0));
    const double sum = std::accumulate(weights_.begin(), weights_.end(), 0.0);
    for (double& w : weights_) w /= sum;
    selected_ = 1.0 / std::inner_product(weights_.begin(), weights_.end(), weights_.begin(), 0.0);
    const auto n = static_cast<double>(mean_.size());
    learn_path_ = (selected_ + 2.0) / (n + selected_ + 5.0);
    fade_ = 4.0 / (n + 4.0);
    // Rates of the full matrix times (n + 2)/3, because a diagonal matrix has fewer parameters.
    const double faster = (n + 2.0) / 3.0;
    learn_one_ = std::min(1.0, faster * 2.0 / ((n + 1.3) * (n + 1.3) + selected_));
    learn_all_ = std::min(1.0 - learn_one_,
                          faster * 2.0 * (selected_ - 2.0 + 1.0 / selected_) / ((n + 2.0) * (n + 2.0) + selected_));
}

const std::vector<Point>& SeparableCmaEs::ask() {
    for (Point& p : points_) {
        p = mean_;
        for (size_t i = 0; i < p.size(); ++i) {
            p[i] += step_ * std::sqrt(variance_[i]) * random_.gaussian();
            p[i] = std::clamp(p[i] < 0.0 ? -p[i] : p[i] > 1.0 ? 2.0 - p[i] : p[i], 0.0, 1.0);
        }
    }
    return points_;
}

void SeparableCmaEs::tell(std::span<const double> values) {
    std::vector<size_t> order(points_.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return values[a] < values[b]; });
    if (values[order[0]] < best_value_) {
        best_value_ = values[order[0]];
        best_ = points_[order[0]];
    }
    const auto n = static_cast<double>(mean_.size());
    Point move(mean_.size(), 0.0), spread = move; // means of y and y^2, y = (x - mean)/step
    double length = 0.0;
    for (size_t i = 0; i < mean_.size(); ++i) {
        for (size_t k = 0; k < weights_.size(); ++k) {
            const double y = (points_[order[k]][i] - mean_[i]) / step_;
            move[i] += weights_[k] * y;
            spread[i] += weights_[k] * y * y;
        }
        step_path_[i] = (1.0 - learn_path_) * step_path_[i] +
                        std::sqrt(learn_path_ * (2.0 - learn_path_) * selected_ / variance_[i]) * move[i];
        length += step_path_[i] * step_path_[i];
    }
    length = std::sqrt(length);
    const double expected = std::sqrt(n) * (1.0 - 1.0 / (4.0 * n) + 1.0 / (21.0 * n * n)); // of |N(0, I)|
    // p_c is not updated while the step still grows fast.
    const double begun = std::sqrt(1.0 - std::pow(1.0 - learn_path_, 2.0 * ++generations_));
    const bool waits = length / begun > (1.4 + 2.0 / (n + 1.0)) * expected;
    for (size_t i = 0; i < mean_.size(); ++i) {
        mean_[i] += step_ * move[i];
        path_[i] = (1.0 - fade_) * path_[i] + (waits ? 0.0 : std::sqrt(fade_ * (2.0 - fade_) * selected_) * move[i]);
        const double kept = waits ? fade_ * (2.0 - fade_) * variance_[i] : 0.0;
        variance_[i] = (1.0 - learn_one_ - learn_all_) * variance_[i] + learn_one_ * (path_[i] * path_[i] + kept) +
                       learn_all_ * spread[i];
    }
    const double damping =
        1.0 + learn_path_ + 2.0 * std::max(0.0, std::sqrt(std::max(0.0, selected_ - 1.0) / (n + 1.0)) - 1.0);
    step_ = std::min(0.4, step_ * std::exp(learn_path_ / damping * (length / expected - 1.0))); // of a range of 1
}
} // namespace lr::fit
