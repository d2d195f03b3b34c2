// Where and how bodies are born: the distributions of an lr_emitter_desc.
#pragma once

#include "langevin_rigid.h"
#include "world/batch.h"
#include "world/rotate.h"

#include <cstdint>

namespace lr {

// Null when fine, else what is wrong. Of finite numbers only.
const char* wrong_in(const lr_emitter_desc& desc);
bool all_finite(const lr_emitter_desc& desc);

class Emitter {
public:
    Emitter() = default;
    explicit Emitter(const lr_emitter_desc& desc); // checked by wrong_in

    const lr_emitter_desc& desc() const { return desc_; }
    // The body with this key in this life, at age 0: the same wherever and whenever it is drawn.
    BodyState draw(uint64_t seed, uint32_t key, uint32_t life) const;

private:
    lr_emitter_desc desc_{};
    double orientation_[4] = {0.0, 0.0, 0.0, 1.0}; // of the shape
    double pose_[4] = {0.0, 0.0, 0.0, 1.0};        // of bodies, if fixed
    WideVector axis_{}, side_[2] = {};             // of the cone of velocities
    double cone_ = 0.0;                            // 1 - cos(spread)
};

} // namespace lr
