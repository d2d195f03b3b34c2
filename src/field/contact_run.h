// Bodies near colliders through a step: taken out of a block, stepped and held against what they touch, and put back.
#pragma once

#include "contact/contact_group.h"
#include "field/surface_step.h"
#include "field/touch_notes.h"
#include "kernel/step.h"

namespace lr {

// Per body of a batch, by dense index; each written by the thread that steps the body.
struct ContactBook {
    float* rest_time = nullptr;            // s, for which it has lain still; null: nothing is noted
    uint32_t* touching[most_touches] = {}; // slots + 1 of colliders, touching_body; 0: none
    void (*comes_to_rest)(void* batch, uint32_t index) = nullptr;
    void* batch = nullptr;
    TouchNotes notes;
};

// A body comes to rest when it has touched something and hardly moved for so long.
inline constexpr float time_to_rest = 0.5f; // s

// Of a batch in a step.
struct ContactRun {
    ContactStep step;
    const KernelTarget* target;
    const SurfaceStep* surface; // null without one
    StepTime time;
    ContactBook book;
    float still; // m/s times sqrt(reach in m): slower bodies that touch something lie still
};

// [begin, end) through all substeps of a step in a uniform wind.
void step_near_colliders(const ContactRun& run, const StepInput& in, const BatchArrays& arrays, lr_batch batch,
                         uint32_t live, uint32_t begin, uint32_t end);

// In a wind field: of [begin, end), field_block at most, those that may touch something within a substep.
class ContactPass {
public:
    // Before substep `substep` of the step.
    ContactPass(const ContactRun& run, const BodyConstants& body, const BatchArrays& arrays, uint32_t live,
                uint32_t begin, uint32_t end, uint32_t substep);
    // After it.
    void resolve();

private:
    const ContactRun* run_;
    const BodyConstants* body_;
    const BatchArrays* arrays_;
    uint32_t substep_;
    NearContacts near_;
    alignas(64) float before_[pose_fields][field_block];
};

} // namespace lr
