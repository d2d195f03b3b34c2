// The bodies at rest that a batch's bodies meet: its partners' and perhaps its own.
#pragma once

#include "contact/contact_group.h"
#include "contact/resting_bodies.h"
#include "kernel/batch_arrays.h"

#include <cstdint>

struct lr_world;

namespace lr {

class RestingNeighbours final : public RestingBodies {
public:
    RestingNeighbours(const lr_world& world, uint32_t slot);
    bool any() const { return any_; }
    uint32_t touched_by(uint32_t key, float scale, const Pose& from, const Pose& to, float margin,
                        RestingTouch (&out)[most_resting]) const override;

private:
    const lr_world* world_;
    uint32_t slot_; // of the batch
    bool any_ = false;
};

} // namespace lr
