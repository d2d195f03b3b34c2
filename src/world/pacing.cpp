#include "world/pacing.h"

#include "world/batch.h"

#include <algorithm>

namespace lr {

Pacing::Pacing() : report_{} {
    report_.struct_size = sizeof report_;
}

bool Pacing::reserve(Allocator& allocator, size_t batches) {
    Buffer<Claim> larger;
    if (!larger.allocate(allocator, batches)) return false;
    claims_.swap(larger);
    return true;
}

void Pacing::set_budget(uint64_t body_substeps) {
    record_ = {body_substeps, 0};
}

void Pacing::begin() {
    count_ = 0;
    report_ = {};
    report_.struct_size = sizeof report_;
}

void Pacing::ask(Batch& batch, uint32_t slot, const Step& step) {
    const Pace& pace = batch.pace;
    const uint32_t divisor = pace.divisor(step.h);
    Claim& claim = claims_[count_++];
    claim = {};
    claim.batch = &batch;
    claim.bodies = batch.awake();
    claim.forced = batch.external.pending();
    claim.due = claim.forced || pace.passed_over() || pace.due(divisor, step.substeps, step.number, slot);
    claim.wanted = claim.due ? pace.wanted(divisor) : 0;
    claim.granted = claim.wanted;
    claim.urgency = claim.due ? static_cast<double>(pace.record().substeps) / divisor : 0.0;
}

// In the order of their waiting, each gets the fewest substeps that keep to its longest one; then, in the same order, as many as it
// wants of what is left.
void Pacing::share(uint64_t step) {
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
        // Others that still fit must not be taken before it: it would wait for ever. What is left is saved for it.
        short_of = c->granted == 0;
    }
    record_.saved = short_of ? left : 0;
    for (Claim* c = claims_.data(); c != end && !short_of; ++c) grant(*c, c->wanted - c->granted);
    // Beyond the budget, and not instead of those whose turn it was.
    for (Claim* c = claims_.data(); c != end; ++c)
        if (c->forced) c->granted = std::max(c->granted, 1u);
}

void Pacing::decide(const Step& step) {
    for (uint32_t i = 0; i < count_; ++i)
        report_.body_substeps_wanted += uint64_t{claims_[i].bodies} * claims_[i].wanted;
    if (limited() && report_.body_substeps_wanted > record_.budget)
        share(step.number);
    else
        record_.saved = 0;
    for (uint32_t i = 0; i < count_; ++i) {
        const Claim& c = claims_[i];
        Pace& pace = c.batch->pace;
        pace.grant(c.granted, c.due && c.granted == 0, step.h);
        report_.body_substeps += uint64_t{c.bodies} * c.granted;
        report_.batches_stepped += c.granted != 0 ? 1 : 0;
        report_.batches_passed_over += c.due && c.granted == 0 ? 1 : 0;
        report_.batches_waiting += c.due ? 0 : 1;
        if (c.granted == 0) report_.behind = std::max(report_.behind, pace.behind());
        report_.lost = std::max(report_.lost, pace.lost_now());
    }
}

bool Pacing::consistent(const Record& r) {
    return r.budget <= largest_budget && r.saved <= 2 * largest_budget;
}

void Pacing::restore(const Record& record) {
    record_ = record;
    begin();
}

} // namespace lr
