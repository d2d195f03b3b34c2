// Steps bodies near colliders: copies them out of their block, steps them, solves their contacts, puts them back.
#pragma once

#include "collision/collider_contact_group.h"
#include "collision/contact_cache.h"
#include "collision/near_walls.h"
#include "kernel/integrator/step.h"
#include "world/step/step_near_water.h"

namespace lr {

struct ContactRun {
    ContactStep step;
    const KernelTarget* target;
    const WaterStep* surface; // null without water
    StepTime time;
    ContactCache book;
    float still;           // m/s over sqrt(m): limit of still bodies in contact
    float* fall = nullptr; // by body: receives ContactGroup::fall() after one substep. Null: not wanted.
};

// Times of substep `substep`. before: the bodies at its beginning.
inline ContactSubstep contact_substep(const StepTime& time, uint32_t substep, const LaneRow* before) {
    const auto n = static_cast<float>(time.substeps), first = static_cast<float>(substep);
    return {before, first / n, static_cast<float>(substep + 1) / n, static_cast<float>(time.h)};
}

// rows, at: the body after the substep; before: at its beginning.
template <class Rows>
BodyAfter body_after(const ContactRun& run, const ContactGroup& group, uint32_t lane, uint32_t index, const Rows& rows,
                     uint32_t at, const LaneRow* before) {
    BodyAfter body = body_moved(index, *run.step.shape, rows[field_scale][at], run.still, vector_in(rows, field_vx, at),
                                vector_in(rows, field_wx, at), pose_in(before, lane), pose_in(rows, at));
    group.touched(lane, body.now);
    return body;
}

// Whether there is uniform wind in the step.
inline bool blows(const StepInput& in) {
    const Vector first = vector_of(in.wind_begin), last = vector_of(in.wind);
    return dot(first, first) > 0.0f || dot(last, last) > 0.0f;
}

// Steps bodies [begin, end) through a step in uniform wind.
void step_near_colliders(const ContactRun& run, const StepInput& in, const BatchArrays& arrays, lr_batch batch,
                         uint32_t live, uint32_t begin, uint32_t end);

// In a wind field: the bodies among [begin, end), at most field_block, that can touch something within a substep.
class ContactPass {
public:
    // Finds them, before substep `substep`.
    ContactPass(const ContactRun& run, const StepInput& in, const BatchArrays& arrays, uint32_t live, uint32_t begin,
                uint32_t end, uint32_t substep);
    const NearContacts& near() const { return near_; }
    // Walls near a near body, before the substep.
    NearWalls walls(uint32_t body) const;
    // After the substep. submerged: shares in water, from `begin` on; null without water.
    void resolve(const float* submerged);

private:
    const ContactRun* run_;
    const StepInput* in_;
    const BatchArrays* arrays_;
    uint32_t begin_, substep_;
    NearContacts near_;
    alignas(64) float before_[pose_fields][field_block];
};
} // namespace lr
