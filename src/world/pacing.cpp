#include "world/pacing.h"

#include "world/batch.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

constexpr double unknown_price = 2e-8;   // s a body-substep, for the first step of a batch
constexpr double coarsest = 1048576.0;   // 2^20
constexpr double memory_of_prices = 0.7; // share of the old price in the new one

} // namespace

const char* wrong_in(const lr_budget& b) {
    switch (b.kind) {
    case LR_BUDGET_NONE:
        return nullptr;
    case LR_BUDGET_BODY_SUBSTEPS:
        return b.body_substeps >= 1 && b.body_substeps <= uint64_t{1} << 48 ? nullptr
                                                                            : "body_substeps is not 1 to 2^48";
    case LR_BUDGET_TIME:
        return b.seconds >= 1e-6 && b.seconds <= 1e3 ? nullptr : "seconds is not 1e-6 to 1e3";
    default:
        return "unknown kind of budget";
    }
}

Pacing::Pacing() : budget_{}, report_{} {
    budget_.struct_size = sizeof budget_;
    report_.struct_size = sizeof report_;
}

bool Pacing::reserve(Allocator& allocator, size_t batches) {
    Buffer<Claim> larger;
    if (!larger.allocate(allocator, batches)) return false;
    claims_.swap(larger);
    return true;
}

void Pacing::set_budget(const lr_budget& budget) {
    budget_ = budget;
    saved_ = 0.0;
}

void Pacing::begin() {
    count_ = 0;
    report_ = {};
    report_.struct_size = sizeof report_;
    report_.coarseness = 1.0;
}

void Pacing::ask(Batch& batch, uint32_t slot, const Step& step) {
    const Pace& pace = batch.pace;
    Claim& claim = claims_[count_++];
    claim = {};
    claim.batch = &batch;
    claim.slot = slot;
    claim.bodies = batch.awake();
    claim.divisor = pace.divisor(step.h);
    if (limited()) claim.largest = pace.largest_divisor(step.h);
    claim.forced = batch.external.pending();
    claim.due = claim.forced || pace.passed_over() || pace.due(claim.divisor, step.substeps, step.number, slot);
    claim.wanted = claim.due ? pace.wanted(claim.divisor) : 0;
    claim.granted = claim.wanted;
}

double Pacing::divisor(const Claim& c, const Coarsening& coarse) {
    const double slower = std::max(1.0, coarse.factor / static_cast<double>(c.batch->pace.record().rate.priority));
    return coarse.beyond ? c.divisor * slower : std::min(c.divisor * slower, static_cast<double>(c.largest));
}

// That with which all batches together take `amount` a step on average. The factor is found by halving an interval, so that
// it is the same on every machine.
Pacing::Coarsening Pacing::coarsening(double amount, uint32_t substeps) const {
    const auto load = [&](const Coarsening& coarse) {
        double sum = 0.0;
        for (uint32_t i = 0; i < count_; ++i) sum += claims_[i].price * substeps / divisor(claims_[i], coarse);
        return sum;
    };
    const bool beyond = load({coarsest, false}) > amount;
    double low = 1.0 / 128.0; // no priority is above 100 times that of which this is the factor
    if (load({low, beyond}) <= amount) return {low, beyond};
    double high = 1.0;
    while (load({high, beyond}) > amount && high < coarsest) {
        low = high;
        high *= 2.0;
    }
    for (int i = 0; i < 10; ++i) {
        const double middle = 0.5 * (low + high);
        (load({middle, beyond}) > amount ? low : high) = middle;
    }
    return {high, beyond};
}

void Pacing::share(double amount, const Coarsening& coarse) {
    for (uint32_t i = 0; i < count_; ++i) {
        Claim& c = claims_[i];
        const Pace& pace = c.batch->pace;
        c.urgency = c.due ? static_cast<double>(pace.record().substeps) / divisor(c, coarse) : 0.0;
        const auto even = static_cast<uint32_t>(std::min(c.urgency, 65536.0));
        c.wanted = c.due ? std::max(even, coarse.beyond ? 1u : pace.least()) : 0;
        c.granted = 0;
    }
    std::sort(claims_.data(), claims_.data() + count_, [](const Claim& a, const Claim& b) {
        if (a.urgency != b.urgency) return a.urgency > b.urgency;
        return a.slot < b.slot;
    });
    double left = amount + saved_;
    bool short_of = false;
    for (uint32_t i = 0; i < count_; ++i) {
        Claim& c = claims_[i];
        if (!c.due) continue;
        const double affordable = std::clamp(std::floor(left / c.price), 0.0, 65536.0);
        c.granted = std::min(c.wanted, static_cast<uint32_t>(affordable));
        left -= c.granted * c.price;
        if (c.granted != 0) continue;
        // Others that still fit must not be taken before it: it would wait for ever. What is left is saved for it.
        short_of = true;
        break;
    }
    saved_ = short_of ? left : 0.0;
    // Rounding down has left some over.
    for (uint32_t i = 0; i < count_ && !short_of; ++i) {
        Claim& c = claims_[i];
        const uint32_t own = c.due ? c.batch->pace.wanted(c.divisor) : 0;
        if (c.granted == 0 || own <= c.granted) continue;
        const auto more = static_cast<uint32_t>(std::clamp(std::floor(left / c.price), 0.0, 65536.0));
        const uint32_t extra = std::min(own - c.granted, more);
        c.granted += extra;
        left -= extra * c.price;
    }
    // Beyond the budget, and not instead of those whose turn it was.
    for (uint32_t i = 0; i < count_; ++i)
        if (claims_[i].forced) claims_[i].granted = std::max(claims_[i].granted, 1u);
}

void Pacing::decide(const Step& step) {
    if (budget_.kind != LR_BUDGET_NONE) {
        const double amount =
            budget_.kind == LR_BUDGET_TIME ? budget_.seconds : static_cast<double>(budget_.body_substeps);
        double full = 0.0;
        for (uint32_t i = 0; i < count_; ++i) {
            Claim& c = claims_[i];
            const Pace& pace = c.batch->pace;
            const double each = !timed() ? 1.0 : pace.price > 0.0 ? pace.price : unknown_price;
            c.price = c.bodies * each;
            full += c.wanted * c.price;
        }
        const Coarsening coarse = coarsening(amount, step.substeps);
        report_.coarseness = std::max(coarse.factor, 1.0);
        // Else there is enough for all, in this step and on average.
        if (full > amount || coarse.factor > 1.0)
            share(amount, coarse);
        else
            saved_ = 0.0;
    }
    for (uint32_t i = 0; i < count_; ++i) {
        const Claim& c = claims_[i];
        Pace& pace = c.batch->pace;
        const uint64_t bodies = c.bodies;
        if (c.due) report_.body_substeps_wanted += bodies * (limited() ? pace.wanted(c.divisor) : c.granted);
        pace.grant(c.granted, c.due && c.granted == 0, step.h);
        report_.body_substeps += bodies * c.granted;
        report_.batches_stepped += c.granted != 0 ? 1 : 0;
        report_.batches_passed_over += c.due && c.granted == 0 ? 1 : 0;
        report_.batches_waiting += c.due ? 0 : 1;
        if (c.granted == 0) report_.behind = std::max(report_.behind, pace.behind());
        report_.lost = std::max(report_.lost, pace.lost_now());
    }
}

void Pacing::learn(double seconds) {
    report_.seconds = seconds;
    double all = 0.0; // of all threads
    for (uint32_t i = 0; i < count_; ++i) all += static_cast<double>(claims_[i].batch->spent.load());
    for (uint32_t i = 0; i < count_; ++i) {
        const Claim& c = claims_[i];
        const uint64_t spent = c.batch->spent.exchange(0);
        if (spent == 0) continue;
        Pace& pace = c.batch->pace;
        const double now = static_cast<double>(spent) / all * seconds / (static_cast<double>(c.bodies) * c.granted);
        pace.price = pace.price > 0.0 ? memory_of_prices * pace.price + (1.0 - memory_of_prices) * now : now;
    }
}

bool Pacing::consistent(const Record& r) {
    return std::isfinite(r.budget.seconds) && !wrong_in(r.budget) && r.saved >= 0.0 && r.saved <= 1e18;
}

void Pacing::restore(const Record& record) {
    set_budget(record.budget);
    saved_ = record.saved;
    begin();
    report_.coarseness = 0.0;
}

} // namespace lr
