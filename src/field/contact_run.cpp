#include "field/contact_run.h"

#include "kernel/faults.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

constexpr auto lanes = static_cast<uint32_t>(contact_lanes);

// Near bodies of a block in arrays of their own; the last one fills up the lanes.
struct States {
    const NearContacts* near;
    uint32_t padded;
    alignas(64) float field[field_count][field_block];
    alignas(64) uint32_t key[field_block];
    alignas(64) float force[force_components][field_block];

    void take(const BatchArrays& from, const NearContacts& some) {
        near = &some;
        padded = (some.count() + lanes - 1) / lanes * lanes;
        const auto gather = [&](const auto* source, auto* to) {
            for (uint32_t i = 0; i < padded; ++i) to[i] = source[some.index(std::min(i, some.count() - 1))];
        };
        for (size_t f = 0; f < field_count; ++f)
            if (from.field[f]) gather(from.field[f], field[f]);
        gather(from.key, key);
    }
    // They are for what follows alone.
    void take_forces(const ExternalInput& in) {
        for (size_t c = 0; c < force_components && in.used != 0; ++c) {
            float* const source = in.bodies + c * in.stride;
            for (uint32_t i = 0; i < padded; ++i) force[c][i] = source[near->index(std::min(i, near->count() - 1))];
            for (uint32_t i = 0; i < near->count(); ++i) source[near->index(i)] = 0.0f;
        }
    }
    void put_back(const BatchArrays& to) const {
        for (size_t f = 0; f < field_count; ++f)
            for (uint32_t i = 0; i < near->count() && to.field[f]; ++i) to.field[f][near->index(i)] = field[f][i];
    }
    BatchArrays group(uint32_t first) {
        BatchArrays a{};
        for (size_t f = 0; f < field_count; ++f) a.field[f] = field[f] + first;
        a.key = key + first;
        return a;
    }
    uint32_t bodies(uint32_t first) const { return std::min(lanes, near->count() - first); }
};

// After a substep: what the bodies of a group touch, and how long they have lain still.
void enter(const ContactRun& run, const ContactGroup& group, const States& states, const LaneRow (&before)[pose_fields],
           uint32_t first, float seconds, bool last) {
    if (!run.book.rest_time) return;
    for (uint32_t i = 0; i < states.bodies(first); ++i) {
        if (is_held(states.field[field_age_rest][first + i])) continue;
        const auto value = [&](size_t f) { return states.field[f][first + i]; };
        const BodyAfter body = body_after(run, group, i, states.near->index(first + i), value, before);
        enter_body(run.book, body, run.step.settings->may_rest, seconds, last,
                   [&](uint32_t collider) { return group.meeting(i, collider, before); });
    }
}

// What touching has made of the bodies of a group.
void hold_insane(const BatchArrays& arrays, const LaneRow (&before)[pose_fields], uint32_t* faults) {
    for (uint32_t i = 0; i < contact_lanes; ++i)
        hold_if_insane(arrays, i, faults, [&](size_t f) { return before[f][i]; });
}

// Bodies that were far all through the step touch nothing.
void leave(const ContactBook& book, const NearContacts& near, uint32_t begin, uint32_t end) {
    if (!book.rest_time) return;
    for (uint32_t i = begin; i < end; ++i) {
        if (near.holds(i)) continue;
        book.rest_time[i] = 0.0f;
        if (book.stay[0][i] != 0.0f)
            for (float* row : book.stay) row[i] = 0.0f;
        if (book.notes.noted && book.touching[0][i] != 0) book.notes.noted[book.notes.slot(i)] |= noted_touch;
        for (uint32_t* row : book.touching) row[i] = 0;
    }
}

// Bodies in the air, those that touch something and move, and those that hardly do: the solver's sweeps go on until the last body of a
// vector is done.
void arrange(const ContactBook& book, NearContacts& near) {
    if (!book.rest_time) return;
    near.arrange(3, [&](uint32_t i) { return book.touching[0][i] == 0 ? 0u : book.rest_time[i] == 0.0f ? 1u : 2u; });
}

void step_group(const ContactRun& run, const StepInput& in, lr_batch batch, States& states, uint32_t first) {
    const BatchArrays arrays = states.group(first);
    const uint32_t count = states.bodies(first);
    ContactGroup group(run.step, in.body, arrays, count);
    StepInput one = in;
    one.substeps = 1;
    one.external.bodies = states.force[0] + first;
    one.external.stride = field_block;
    one.external.clear = false;
    SurfaceStep wet{};
    if (run.surface) wet = *run.surface;
    const auto n = static_cast<float>(in.substeps);
    const auto h = static_cast<float>(run.time.h);
    alignas(64) LaneRow before[pose_fields];
    for (uint32_t i = 0; i < in.substeps; ++i) {
        for (size_t f = 0; f < pose_fields; ++f) std::copy_n(arrays.field[f], contact_lanes, before[f]);
        one.first_substep = in.first_substep + i;
        const float begin = static_cast<float>(i) / n, end = static_cast<float>(i + 1) / n;
        if (in.wind_changes) {
            for (size_t k = 0; k < 3; ++k) {
                const float change = in.wind[k] - in.wind_begin[k];
                one.wind_begin[k] = in.wind_begin[k] + begin * change;
                one.wind[k] = i + 1 < in.substeps ? in.wind_begin[k] + end * change : in.wind[k];
            }
        }
        if (run.surface && in.water) {
            wet.time = {run.time.begin + i * run.time.h, run.time.h, 1};
            step_at_surface(wet, one, arrays, batch, count, 0, lanes);
        } else {
            run.target->step(one, arrays, 0, lanes);
        }
        group.resolve(before, begin, end, h);
        hold_insane(arrays, before, in.faults);
        enter(run, group, states, before, first, h, i + 1 == in.substeps);
    }
}

} // namespace

void step_near_colliders(const ContactRun& run, const StepInput& in, const BatchArrays& arrays, lr_batch batch,
                         uint32_t live, uint32_t begin, uint32_t end) {
    const auto step_lanes = [&](uint32_t from, uint32_t to) {
        if (run.surface && in.water) {
            SurfaceStep wet = *run.surface;
            wet.time = run.time;
            step_at_surface(wet, in, arrays, batch, live, from, to);
        } else {
            run.target->step(in, arrays, from, to);
        }
    };
    for (uint32_t at = begin, last = begin; at < end; at = last) {
        NearContacts near(run.step, arrays, live, at, end, run.step.dt);
        last = near.end();
        leave(run.book, near, at, std::min(last, live));
        if (near.count() == 0) {
            step_lanes(at, last);
            continue;
        }
        arrange(run.book, near);
        States states;
        states.take(arrays, near);
        states.take_forces(in.external);
        for (uint32_t from = at; from < last;) {
            uint32_t to = from;
            while (to < last && near.others(to)) to += static_cast<uint32_t>(lane_block);
            if (to != from) step_lanes(from, to);
            from = to + static_cast<uint32_t>(lane_block);
        }
        for (uint32_t first = 0; first < near.count(); first += lanes) step_group(run, in, batch, states, first);
        states.put_back(arrays);
    }
}

ContactPass::ContactPass(const ContactRun& run, const StepInput& in, const BatchArrays& arrays, uint32_t live,
                         uint32_t begin, uint32_t end, uint32_t substep)
    : run_(&run), body_(&in.body), faults_(in.faults), arrays_(&arrays), substep_(substep),
      near_(run.step, arrays, live, begin, end, static_cast<float>(run.time.h)) {
    if (substep + 1 == run.time.substeps) leave(run.book, near_, begin, std::min(end, live));
    arrange(run.book, near_);
    for (size_t f = 0; f < pose_fields && near_.count() != 0; ++f)
        for (uint32_t i = 0; i < field_block; ++i)
            before_[f][i] = arrays.field[f][near_.index(std::min(i, near_.count() - 1))];
}

void ContactPass::resolve() {
    if (near_.count() == 0) return;
    States states;
    states.take(*arrays_, near_);
    const auto n = static_cast<float>(run_->time.substeps);
    const float begin = static_cast<float>(substep_) / n, end = static_cast<float>(substep_ + 1) / n;
    for (uint32_t first = 0; first < near_.count(); first += lanes) {
        const BatchArrays arrays = states.group(first);
        ContactGroup group(run_->step, *body_, arrays, states.bodies(first));
        alignas(64) LaneRow before[pose_fields];
        for (size_t f = 0; f < pose_fields; ++f) std::copy_n(before_[f] + first, contact_lanes, before[f]);
        group.resolve(before, begin, end, static_cast<float>(run_->time.h));
        hold_insane(arrays, before, faults_);
        enter(*run_, group, states, before, first, static_cast<float>(run_->time.h),
              substep_ + 1 == run_->time.substeps);
    }
    states.put_back(*arrays_);
}

} // namespace lr
