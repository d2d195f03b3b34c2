// What rays hit, and what is in a sphere or box. Arguments have been checked.
#pragma once

#include "langevin_rigid.h"

namespace lr {

// only: whose bodies can be hit; null: all.
class Batch;
lr_ray_hit cast_ray(const lr_world& world, const lr_ray& ray, const Batch* only);

// How many bodies overlap; the ids of the first `capacity` that are found, in order when there is room for all.
uint32_t find_overlaps(const lr_world& world, const lr_overlap_desc& desc, const Batch* only, lr_body* bodies,
                       uint32_t capacity);

} // namespace lr
