// The storm of samples, tests and benchmarks: a box of air, bodies in it, and the re-entry of bodies that leave. Depends on the
// public header only. The same seed gives the same bits on every machine: it has its own counter-based random numbers, and uses
// no functions of the C library that round differently between libraries.
//
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "langevin_rigid.h"

namespace storm {

struct Box {
    float low[3];  // m; low[1] is the ground
    float high[3]; // m

    float size(int axis) const { return high[axis] - low[axis]; }
};

// A box twice as wide and deep as high, in which `count` bodies of characteristic length `length` (m) are as far apart
// as leaves in a thick storm.
Box box_for(std::uint64_t count, double length);

// A number in [0, 1) that depends only on its arguments.
float random_unit(std::uint64_t seed, std::uint64_t index, std::uint32_t draw);

// A uniformly distributed rotation: quaternion x y z w.
void random_orientation(std::uint64_t seed, std::uint64_t index, float* quaternion);

// Bodies `first` to `first + count - 1` of a storm, anywhere in the box, in any orientation, 0.7 to 1.3 times the size of
// their asset, and at rest relative to the air, which moves with `wind` (m/s).
std::vector<lr_body_desc> births(const Box& box, std::uint64_t seed, std::uint64_t first, std::uint32_t count,
                                 const float* wind);

// Bodies that left the box re-enter through the opposite side with the same motion. So the storm lasts, and averages over it
// are those of a storm without walls.
class Reentry {
public:
    explicit Reentry(const Box& box) : box_(box) {}

    // Returns the first error: LR_ERROR_NOT_FINITE or LR_ERROR_INVALID_ARGUMENT if a body's motion has diverged.
    lr_status apply(lr_world* world, lr_batch batch);

    std::uint64_t count() const { return count_; }

private:
    Box box_;
    std::uint64_t count_ = 0;
    std::vector<lr_body> outside_; // kept to save an allocation per frame
};

} // namespace storm
