// Bodies near colliders through a step: taken out of a block, stepped and held against what they touch, and put back.
#pragma once

#include "contact/contact_group.h"
#include "field/contact_book.h"
#include "field/surface_step.h"
#include "kernel/step.h"

#include <cmath>

namespace lr {

// Of a batch in a step.
struct ContactRun {
    ContactStep step;
    const KernelTarget* target;
    const SurfaceStep* surface; // null without one
    StepTime time;
    ContactBook book;
    float still; // m/s over sqrt(reach in m): slower bodies that touch something lie still
};

// rows, at: of the body after the substep; before: as it was before it.
template <class Rows>
BodyAfter body_after(const ContactRun& run, const ContactGroup& group, uint32_t lane, uint32_t index, const Rows& rows,
                     uint32_t at, const LaneRow (&before)[pose_fields]) {
    BodyAfter body = body_moved(index, *run.step.shape, rows[field_scale][at], run.still, vector_in(rows, field_vx, at),
                                vector_in(rows, field_wx, at), pose_in(before, lane), pose_in(rows, at));
    body.touches = group.touches(lane);
    group.touched(lane, body.now);
    return body;
}

// [begin, end) through all substeps of a step in a uniform wind.
void step_near_colliders(const ContactRun& run, const StepInput& in, const BatchArrays& arrays, lr_batch batch,
                         uint32_t live, uint32_t begin, uint32_t end);

// In a wind field: of [begin, end), field_block at most, those that may touch something within a substep.
class ContactPass {
public:
    // Before substep `substep` of the step.
    ContactPass(const ContactRun& run, const StepInput& in, const BatchArrays& arrays, uint32_t live, uint32_t begin,
                uint32_t end, uint32_t substep);
    // After it.
    void resolve();

private:
    const ContactRun* run_;
    const BodyConstants* body_;
    uint32_t* faults_;
    const BatchArrays* arrays_;
    uint32_t substep_;
    NearContacts near_;
    alignas(64) float before_[pose_fields][field_block];
};

} // namespace lr
