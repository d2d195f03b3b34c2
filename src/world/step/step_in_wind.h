// Steps bodies in a wind field: for each block of bodies the wind there, then a substep.
#pragma once

#include "collision/near_walls.h"
#include "environment/wind_field.h"
#include "world/step/step_near_colliders.h"
#include "world/step/step_near_water.h"

namespace lr {

struct FieldSlice {
    const KernelTarget* target;
    WindField* field;             // asks the caller's callback; null: none is asked
    const FieldInstant* instants; // of the substeps to take
    StepTime time;
    uint32_t first, count;    // substeps of the step to take
    const WaterStep* surface; // null without water
    // By body from `begin` on. Null: all of the wind.
    const FeltFlow* felt = nullptr;
    // By body from `begin` on: receives its share in water after one substep. Null: not wanted.
    float* submerged = nullptr;
};

// batch: handle, passed to the wind callback. live: number of bodies, the lanes after them are empty. contact: null if there is nothing to touch.
void step_in_field(const FieldSlice& slice, const StepInput& in, const ContactRun* contact, const BatchArrays& arrays,
                   lr_batch batch, uint32_t live, uint32_t begin, uint32_t end);

// Bodies among others that feel a wind of their own in a substep: copied before the others are stepped, then stepped alone and put back.
class StepApart {
public:
    // Of the bodies at index(0 ... some), at most field_block, those for which felt(body, its wind) is true.
    template <class Index, class Felt>
    StepApart(const StepInput& in, const BatchArrays& arrays, uint32_t some, const Index& index, const Felt& felt) {
        for (uint32_t i = 0; i < some; ++i) {
            felt_[count_] = {1.0f, {0, {}}};
            index_[count_] = index(i);
            if (felt(index_[count_], felt_[count_])) ++count_;
        }
        if (count_ != 0) take(in, arrays);
    }
    bool any() const { return count_ != 0; }
    // gravity: the world's. submerged: by body from `first` on; receives its share in water. Null: not wanted.
    void step(FieldSlice slice, StepInput in, Vector gravity, const BatchArrays& to, lr_batch batch, float* submerged,
              uint32_t first);

private:
    void take(const StepInput& in, const BatchArrays& arrays);

    uint32_t count_ = 0;
    uint32_t index_[field_block + 1];
    FeltFlow felt_[field_block + 1];
    BodyCopies<field_block> copies_;
};

// Velocities at the prepared moment. positions, velocities: x y z each, may be one array. batch: passed to the wind callback; 0 for points.
void sample_field(const KernelTarget& target, WindField& field, double time, lr_batch batch, const float* positions,
                  uint32_t count, float* velocities);
} // namespace lr
