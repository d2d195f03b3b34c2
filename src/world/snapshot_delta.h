// The difference between two snapshots as bytes. docs/reference/snapshots.md
#pragma once

#include "langevin_rigid.h"

#include <cstdint>

namespace lr {

uint64_t delta_bound(uint64_t snapshot_size);
// As their API functions; null and overlapping memory have been refused.
lr_status delta_encode(const unsigned char* base, uint64_t base_size, const unsigned char* snapshot,
                       uint64_t snapshot_size, unsigned char* memory, uint64_t capacity, uint64_t& written);
lr_status delta_apply(const unsigned char* base, uint64_t base_size, const unsigned char* delta, uint64_t delta_size,
                      unsigned char* memory, uint64_t capacity, uint64_t& written);

} // namespace lr
