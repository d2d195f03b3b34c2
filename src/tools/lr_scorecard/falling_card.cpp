#include "tools/lr_scorecard/falling_card.h"

#include <array>
#include <cmath>
#include <numbers>

namespace lr::scorecard {
namespace {

using State = std::array<double, 6>; // vx vy w angle x y

State rate(const CardModel& m, const State& q) {
    using std::numbers::pi;
    const double vx = q[0], vy = q[1], w = q[2], sine = std::sin(q[3]), cosine = std::cos(q[3]);
    const double s = std::hypot(vx, vy), safe = s > 0.0 ? s : 1.0;
    const double circulation = 2.0 / pi * (-m.ct * vx * vy / safe + m.cr * w);
    const double drag = (m.a - m.b * (vx * vx - vy * vy) / (safe * safe)) * s / pi;
    const double i = m.inertia;
    return {((i + 1.0) * w * vy - circulation * vy - sine - drag * vx) / i,
            (-i * w * vx + circulation * vx - cosine - drag * vy) / (i + 1.0),
            4.0 * (-vx * vy - (m.mu1 + m.mu2 * std::abs(w)) * w) / (i + 0.5),
            w,
            vx * cosine - vy * sine,
            vx * sine + vy * cosine};
}

State plus(const State& a, double h, const State& b) {
    State out{};
    for (size_t i = 0; i < out.size(); ++i) out[i] = a[i] + h * b[i];
    return out;
}
} // namespace

std::vector<CardState> fall(const CardModel& model, CardState start, double duration, double interval, double step) {
    State q{start.vx, start.vy, start.w, start.angle, start.x, start.y};
    const auto substeps = static_cast<int>(std::ceil(interval / step));
    const double h = interval / substeps;
    const auto samples = static_cast<size_t>(duration / interval);
    std::vector<CardState> out{start};
    for (size_t n = 0; n < samples; ++n) {
        for (int i = 0; i < substeps; ++i) {
            const State a = rate(model, q), b = rate(model, plus(q, 0.5 * h, a)), c = rate(model, plus(q, 0.5 * h, b)),
                        d = rate(model, plus(q, h, c));
            for (size_t k = 0; k < q.size(); ++k) q[k] += h / 6.0 * (a[k] + 2.0 * (b[k] + c[k]) + d[k]);
        }
        out.push_back({q[0], q[1], q[2], q[3], q[4], q[5]});
    }
    return out;
}

CardMeans means(const std::vector<CardState>& states, double interval) {
    const CardState &begin = states[states.size() / 2], &end = states.back();
    const double time = interval * static_cast<double>(states.size() - 1 - states.size() / 2);
    return {(end.x - begin.x) / time, (end.y - begin.y) / time, (end.angle - begin.angle) / time};
}

std::vector<Eigen::Vector3d> normals(const std::vector<CardState>& states) {
    std::vector<Eigen::Vector3d> out;
    for (const CardState& s : states) out.emplace_back(-std::sin(s.angle), std::cos(s.angle), 0.0);
    return out;
}
} // namespace lr::scorecard
