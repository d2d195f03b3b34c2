#include "world/pace.h"

#include "kernel/limits.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

// Up to these, the statistics of falls are kept within some per cent, and longer ones save nothing: docs/reference/stepping.md.
constexpr double longest_of_all = 1.0 / 60.0; // s
constexpr double pace_of_length = 1.5;        // m/s

// Rounding of lengths of steps must not count as another substep.
constexpr double slack = 0.01;

} // namespace

Pace::Pace(double length) : record_{}, longest_(std::min(longest_of_all, length / pace_of_length)) {
    record_.divisor = 1;
}

bool Pace::consistent(const Record& r, double time, uint64_t substep_count) {
    if (r.divisor < 1 || r.divisor > largest_of_all || r.passed_over > 1 || wrong_wind(r.wind) ||
        !within(r.drift, most_way) || !in_range(r.lost, 0.0, most_time) || !in_range(r.behind, 0.0, most_time))
        return false;
    if (r.steps == 0) return r.substeps == 0 && r.behind == 0.0 && r.passed_over == 0;
    // Sums of the same steps, but for rounding.
    const bool meets = std::abs(r.begin + r.behind - time) <= 1e-9 * std::abs(time) + 1e-9;
    // The count of substeps may have gone once around.
    return meets && in_range(r.begin, 0.0, time) && r.behind > 0.0 && r.substeps >= r.steps &&
           r.first_substep + r.substeps == substep_count;
}

void Pace::restore(const Record& record) {
    record_ = record;
    granted_ = 0;
    lost_now_ = 0.0;
}

void Pace::wait(double dt, uint32_t substeps, double time, uint64_t substep_count, const UniformWind& wind) {
    if (record_.steps == 0) {
        record_.begin = time;
        record_.first_substep = substep_count;
        std::copy(wind.before, wind.before + 3, record_.wind);
        std::copy(wind.drift, wind.drift + 3, record_.drift);
    }
    record_.steps += record_.steps != UINT32_MAX ? 1 : 0;
    record_.substeps += substeps;
    record_.behind = record_.steps == 1 ? dt : record_.behind + dt;
}

void Pace::rest() {
    record_.steps = record_.passed_over = 0;
    record_.substeps = 0;
    record_.behind = 0.0;
    lost_now_ = 0.0;
    granted_ = 0;
}

uint32_t Pace::divisor(double h) const {
    return static_cast<uint32_t>(std::clamp(longest_ / h + slack, 1.0, static_cast<double>(record_.divisor)));
}

// Batches of different phases take different steps.
bool Pace::due(uint32_t divisor, uint32_t substeps, uint64_t step, uint32_t phase) const {
    const uint32_t period = std::max(divisor / substeps, 1u);
    return record_.steps >= period || (step + phase) % period == 0;
}

uint32_t Pace::least() const {
    const double needed = std::ceil(record_.behind / longest_ - slack);
    return static_cast<uint32_t>(std::clamp(needed, 1.0, static_cast<double>(most())));
}

uint32_t Pace::wanted(uint32_t divisor) const {
    if (divisor == 1) return most();
    const uint64_t even = std::min<uint64_t>((record_.substeps + divisor - 1) / divisor, most());
    return std::max(static_cast<uint32_t>(even), least());
}

void Pace::grant(uint32_t substeps, bool passed_over, double h) {
    granted_ = substeps;
    lost_now_ = 0.0;
    record_.passed_over = passed_over ? 1 : 0;
    if (substeps == 0) return;
    const double most = substeps * std::max(longest_, h);
    if (record_.behind > most * (1.0 + slack)) {
        lost_now_ = record_.behind - most;
        record_.lost = std::min(record_.lost + lost_now_, most_time);
        record_.begin += lost_now_;
        record_.behind = most;
    }
    h_ = record_.behind / substeps;
}

void Pace::stepped(uint32_t bodies) {
    record_.taken += uint64_t{bodies} * granted_;
    record_.steps = 0;
    record_.substeps = 0;
    record_.behind = 0.0;
}

bool Pace::at_same_time(const Pace& other) const {
    const Record &a = record_, &b = other.record_;
    return a.begin == b.begin && a.behind == b.behind && granted_ == other.granted_ &&
           std::equal(a.wind, a.wind + 3, b.wind) && std::equal(a.drift, a.drift + 3, b.drift);
}

UniformWind Pace::wind(const UniformWind& now) const {
    UniformWind over = now;
    std::copy(record_.wind, record_.wind + 3, over.before);
    std::copy(record_.drift, record_.drift + 3, over.drift);
    return over;
}

} // namespace lr
