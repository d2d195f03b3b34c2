#include "world/step/step_near_colliders.h"

#include "base/scratch.h"
#include "kernel/divergence.h"
#include "world/step/step_in_wind.h"

#include <algorithm>

namespace lr {
namespace {

constexpr auto lanes = static_cast<uint32_t>(contact_lanes);

using States = BodyCopies<field_block>;

uint32_t bodies_from(const States& states, uint32_t first) {
    return std::min(lanes, states.count - first);
}

// After substep `substep`: solves a group's contacts and updates how long its bodies have been still.
void touch(const ContactRun& run, ContactGroup& group, const States& states, const NearContacts& near,
           const BatchArrays& arrays, const LaneRow* before, const float* submerged, uint32_t first, uint32_t substep,
           uint32_t* faults) {
    const ContactSubstep now = contact_substep(run.time, substep, before);
    group.collect(now);
    group.solve(now, submerged);
    for (uint32_t i = 0; i < contact_lanes; ++i)
        hold_if_insane(arrays, i, faults, [&](size_t f) { return before[f][i]; });
    for (uint32_t i = 0; i < bodies_from(states, first) && run.fall; ++i)
        run.fall[near.index(first + i)] = group.fall(i);
    if (!run.book.stillness) return;
    for (uint32_t i = 0; i < bodies_from(states, first); ++i) {
        if (is_held(states.field[field_age_remainder][first + i])) continue;
        BodyAfter body = body_after(run, group, i, near.index(first + i), states.field, first + i, before);
        const float fall = group.fall(i) * now.h, scale = states.field[field_scale][first + i];
        if (!lies_deep(group.least_gap(i), *run.step.shape, scale, fall * now.h))
            body.speed = lasting_speed(body, vector_in(before, field_vx, i), vector_in(before, field_wx, i),
                                       vector_in(states.field, field_vx, first + i),
                                       vector_in(states.field, field_wx, first + i), fall);
        const bool sleeps = may_sleep(*run.step.settings) && !group.carried(i, body.moving);
        enter_body(run.book, body, sleeps, now.h, substep + 1 == run.time.substeps,
                   [&](uint32_t collider) { return group.touch_with(i, collider, now); });
    }
}

// Bodies that were far throughout the step touch nothing any more.
void leave(const ContactCache& book, uint32_t* floor, const NearContacts& near, uint32_t begin, uint32_t end) {
    if (!book.stillness) return;
    for (uint32_t i = begin; i < end; ++i) {
        if (near.holds(i)) continue;
        floor[i] = 0; // it may come back from the other side
        if (book.touching[0][i] == touching_water) continue;
        if (book.notes.noted && book.touching[0][i] != 0) book.notes.noted[book.notes.slot(i)] |= noted_touch;
        book.forget(i);
    }
}

// Sorts bodies: in the air, not over grounds and over them; moving on grounds, moving on other things; nearly still on others, on grounds. A vector
// has the contacts of its body with most, more on other things than on grounds, and is swept until its last body is done.
void arrange(const ContactCache& book, const Colliders& colliders, NearContacts& near) {
    if (!book.stillness) return;
    const auto on_others = [&](uint32_t i) {
        for (const uint32_t* const row : book.touching)
            if (row[i] != 0 && !(colliders.in_use(row[i] - 1) && is_ground(colliders.at(row[i] - 1).geometry.kind)))
                return true;
        return false;
    };
    near.arrange(6, [&](uint32_t i) {
        if (book.touching[0][i] == 0) return near.over_ground(i) ? 1u : 0u;
        return book.stillness[i] == 0.0f ? (on_others(i) ? 3u : 2u) : (on_others(i) ? 4u : 5u);
    });
}

void step_group(const ContactRun& run, const StepInput& in, lr_batch batch, States& states, const NearContacts& near,
                uint32_t first) {
    const BatchArrays arrays = states.arrays(first);
    const uint32_t count = bodies_from(states, first);
    const InScratch<ContactGroup> in_scratch(run.step, in, arrays, count);
    ContactGroup& group = *in_scratch;
    const bool wet = run.surface && in.water;
    const auto every = [](uint32_t k) { return k; };
    alignas(64) LaneRow before[pose_fields], submerged;
    for (uint32_t i = 0; i < in.substeps; ++i) {
        for (size_t f = 0; f < pose_fields; ++f) std::copy_n(arrays.field[f], contact_lanes, before[f]);
        StepInput one = substep_of(in, i);
        states.lend_forces(one.external, first);
        const InScratch<StepApart> apart(
            one, arrays, wet || blows(one) ? count : 0, every, [&](uint32_t body, FeltFlow& felt) {
                felt.walls = walls_near(run.step, arrays, body, !near.near_finite(near.index(first + body)),
                                        contact_substep(run.time, i, nullptr));
                return wet ? felt.walls.count != 0
                           : felt.walls.met_by(vector_of(one.wind_begin)) || felt.walls.met_by(vector_of(one.wind));
            });
        step_lanes(*run.target, run.surface, {run.time.begin + i * run.time.h, run.time.h, 1}, one, arrays, batch,
                   count, 0, lanes, submerged);
        if (apart->any()) {
            FieldInstant instant{};
            for (size_t k = 0; k < 3; ++k) {
                instant.wind[k] = 0.5f * (one.wind_begin[k] + one.wind[k]);
                instant.change[k] = one.wind[k] - one.wind_begin[k];
            }
            WaterStep here = run.surface ? *run.surface : WaterStep{};
            here.time = run.time;
            apart->step({run.target, nullptr, &instant, run.time, i, 1, run.surface ? &here : nullptr}, in,
                        run.step.weight, arrays, batch, submerged, 0);
        }
        touch(run, group, states, near, arrays, before, wet ? submerged : nullptr, first, i, in.faults);
    }
}
} // namespace

void step_near_colliders(const ContactRun& run, const StepInput& in, const BatchArrays& arrays, lr_batch batch,
                         uint32_t live, uint32_t begin, uint32_t end) {
    const auto step = [&](uint32_t from, uint32_t to) {
        step_lanes(*run.target, run.surface, run.time, in, arrays, batch, live, from, to);
    };
    for (uint32_t at = begin, last = begin; at < end; at = last) {
        const InScratch<NearContacts> found(run.step, arrays, live, at, end, run.step.dt);
        NearContacts& near = *found;
        last = near.end();
        leave(run.book, arrays.floor, near, at, std::min(last, live));
        if (near.count() == 0) {
            step(at, last);
            continue;
        }
        arrange(run.book, *run.step.colliders, near);
        const InScratch<States> copies;
        States& states = *copies;
        states.take(arrays, near.count(), [&](uint32_t i) { return near.index(i); });
        states.take_forces(in.external, true);
        step_others(at, last, live, near.marks(), step);
        for (uint32_t first = 0; first < near.count(); first += lanes) step_group(run, in, batch, states, near, first);
        states.put_back(arrays);
    }
}

ContactPass::ContactPass(const ContactRun& run, const StepInput& in, const BatchArrays& arrays, uint32_t live,
                         uint32_t begin, uint32_t end, uint32_t substep)
    : run_(&run), in_(&in), arrays_(&arrays), begin_(begin), substep_(substep),
      near_(run.step, arrays, live, begin, end, static_cast<float>(run.time.h)) {
    if (substep + 1 == run.time.substeps) leave(run.book, arrays.floor, near_, begin, std::min(end, live));
    arrange(run.book, *run.step.colliders, near_);
    for (size_t f = 0; f < pose_fields && near_.count() != 0; ++f)
        for (uint32_t i = 0; i < field_block; ++i)
            before_[f][i] = arrays.field[f][near_.index(std::min(i, near_.count() - 1))];
}

NearWalls ContactPass::walls(uint32_t body) const {
    return walls_near(run_->step, *arrays_, body, !near_.near_finite(body),
                      contact_substep(run_->time, substep_, nullptr));
}

void ContactPass::resolve(const float* submerged) {
    if (near_.count() == 0) return;
    const InScratch<States> copies;
    States& states = *copies;
    states.take(*arrays_, near_.count(), [this](uint32_t i) { return near_.index(i); });
    for (uint32_t first = 0; first < near_.count(); first += lanes) {
        const BatchArrays arrays = states.arrays(first);
        const InScratch<ContactGroup> group(run_->step, *in_, arrays, bodies_from(states, first));
        alignas(64) LaneRow before[pose_fields], own;
        for (size_t f = 0; f < pose_fields; ++f) std::copy_n(before_[f] + first, contact_lanes, before[f]);
        for (uint32_t i = 0; i < bodies_from(states, first) && submerged; ++i)
            own[i] = submerged[near_.index(first + i) - begin_];
        touch(*run_, *group, states, near_, arrays, before, submerged ? own : nullptr, first, substep_, in_->faults);
    }
    states.put_back(*arrays_);
}
} // namespace lr
