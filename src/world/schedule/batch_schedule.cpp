#include "world/schedule/batch_schedule.h"

#include "collision/colliders.h"
#include "kernel/limits.h"
#include "world/batch/batch.h"

#include <cmath>

namespace lr {
namespace {

// Longest substep of any body. Up to here fall statistics change by a few per cent, and longer substeps save nothing: docs/reference/stepping.md.
constexpr double longest_of_all = 1.0 / 60.0; // s
constexpr double pace_of_length = 2.0;        // m/s

// Rounding of step lengths must not add a substep.
constexpr double slack = 0.01;
} // namespace

BatchClock::BatchClock(double length) : record_{}, longest_(std::min(longest_of_all, length / pace_of_length)) {
    record_.divisor = 1;
}

bool BatchClock::consistent(const Record& r, double time, uint64_t substep_count) {
    if (r.divisor < 1 || r.divisor > largest_of_all || r.passed_over > 1 || wrong_wind(r.wind) ||
        !within(r.drift, most_way) || !in_range(r.lost, 0.0, most_time) || !in_range(r.behind, 0.0, most_time))
        return false;
    if (r.steps == 0) return r.substeps == 0 && r.behind == 0.0 && r.passed_over == 0;
    // Both are sums of the same steps, equal up to rounding.
    const bool meets = std::abs(r.begin + r.behind - time) <= 1e-9 * std::abs(time) + 1e-9;
    // The unsigned count of substeps may wrap around.
    return meets && in_range(r.begin, 0.0, time) && r.behind > 0.0 && r.substeps >= r.steps &&
           r.first_substep + r.substeps == substep_count;
}

void BatchClock::restore(const Record& record) {
    record_ = record;
    granted_ = 0;
    lost_now_ = 0.0;
}

void BatchClock::wait(double dt, uint32_t substeps, double time, uint64_t substep_count, const UniformWind& wind) {
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

void BatchClock::caught_up() {
    record_.steps = 0;
    record_.substeps = 0;
    record_.behind = 0.0;
}

void BatchClock::skip() {
    caught_up();
    record_.passed_over = granted_ = 0;
    lost_now_ = 0.0;
}

uint32_t BatchClock::divisor(double h) const {
    return static_cast<uint32_t>(std::clamp(longest_ / h + slack, 1.0, static_cast<double>(record_.divisor)));
}

// Phases spread batches over different steps.
bool BatchClock::due(uint32_t divisor, uint32_t substeps, uint64_t step, uint32_t phase) const {
    const uint32_t period = std::max(divisor / substeps, 1u);
    return record_.steps >= period || (step + phase) % period == 0;
}

uint32_t BatchClock::least() const {
    const double needed = std::ceil(record_.behind / longest_ - slack);
    return static_cast<uint32_t>(std::clamp(needed, 1.0, static_cast<double>(most())));
}

uint32_t BatchClock::wanted(uint32_t divisor) const {
    if (divisor == 1) return most();
    const uint64_t even = std::min<uint64_t>((record_.substeps + divisor - 1) / divisor, most());
    return std::max(static_cast<uint32_t>(even), least());
}

void BatchClock::grant(uint32_t substeps, bool passed_over, double h) {
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

void BatchClock::stepped(uint32_t bodies) {
    record_.taken += uint64_t{bodies} * granted_;
    caught_up();
}

bool BatchClock::at_same_time(const BatchClock& other) const {
    const Record &a = record_, &b = other.record_;
    return a.begin == b.begin && a.behind == b.behind && granted_ == other.granted_ &&
           std::equal(a.wind, a.wind + 3, b.wind) && std::equal(a.drift, a.drift + 3, b.drift);
}

UniformWind BatchClock::wind(const UniformWind& now) const {
    UniformWind over = now;
    std::copy(record_.wind, record_.wind + 3, over.before);
    std::copy(record_.drift, record_.drift + 3, over.drift);
    return over;
}

void StepScheduler::ask(Batch& batch, uint32_t slot, const Step& step, const Colliders& colliders) {
    const BatchClock& pace = batch.pace;
    const uint32_t divisor = pace.divisor(step.h);
    Claim& claim = claims_[count_++];
    claim = {};
    claim.batch = &batch;
    claim.bodies = batch.awake();
    claim.forced = batch.external.pending();
    claim.due = claim.forced || pace.passed_over() || pace.due(divisor, step.substeps, step.number, slot) ||
                (colliders.any_moves() && batch.contact().layers != 0 && colliders.move_into(batch.box()));
    claim.wanted = claim.due ? pace.wanted(divisor) : 0;
    claim.granted = claim.wanted;
    claim.urgency = claim.due ? static_cast<double>(pace.record().substeps) / divisor : 0.0;
}

// Shares the budget in the order of urgency: first the fewest substeps that each batch may take, then, in the same order, as many as each wants.
void StepScheduler::share(uint64_t step) {
    Claim* const end = claims_.data() + count_;
    for (uint32_t i = 0; i < count_; ++i) claims_[i].turn = (step + i) % count_;
    std::sort(claims_.data(), end, [](const Claim& a, const Claim& b) {
        if (a.urgency != b.urgency) return a.urgency > b.urgency;
        return a.turn < b.turn;
    });
    uint64_t left = record_.budget + record_.saved;
    const auto grant = [&left](Claim& c, uint32_t substeps) {
        const auto more = static_cast<uint32_t>(std::min<uint64_t>(substeps, left / c.bodies));
        c.granted += more;
        left -= uint64_t{more} * c.bodies;
    };
    bool short_of = false;
    for (Claim* c = claims_.data(); c != end; ++c) {
        c->granted = 0;
        if (!c->due || short_of) continue;
        grant(*c, std::min(c->batch->pace.least(), c->wanted));
        // If smaller batches behind it went first, this one could wait forever; so the rest is saved for it.
        short_of = c->granted == 0;
    }
    record_.saved = short_of ? left : 0;
    for (Claim* c = claims_.data(); c != end && !short_of; ++c) grant(*c, c->wanted - c->granted);
    // Forces must not wait, so these batches are stepped beyond the budget.
    for (Claim* c = claims_.data(); c != end; ++c)
        if (c->forced) c->granted = std::max(c->granted, 1u);
}

void StepScheduler::decide(const Step& step) {
    for (uint32_t i = 0; i < count_; ++i)
        report_.body_substeps_wanted += uint64_t{claims_[i].bodies} * claims_[i].wanted;
    if (limited() && report_.body_substeps_wanted > record_.budget)
        share(step.number);
    else
        record_.saved = 0;
    for (uint32_t i = 0; i < count_; ++i) {
        const Claim& c = claims_[i];
        BatchClock& pace = c.batch->pace;
        pace.grant(c.granted, c.due && c.granted == 0, step.h);
        report_.body_substeps += uint64_t{c.bodies} * c.granted;
        report_.batches_stepped += c.granted != 0 ? 1 : 0;
        report_.batches_passed_over += c.due && c.granted == 0 ? 1 : 0;
        report_.batches_waiting += c.due ? 0 : 1;
        if (c.granted == 0) report_.behind = std::max(report_.behind, pace.behind());
        report_.lost = std::max(report_.lost, pace.lost_now());
    }
}
} // namespace lr
