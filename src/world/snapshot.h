// A world's state as bytes, checked whole before any of it is put back.
#pragma once

#include "langevin_rigid.h"

#include <cstdint>

namespace lr {

uint64_t snapshot_size(const lr_world& world);
lr_status snapshot_save(const lr_world& world, void* memory, uint64_t size, uint64_t* written);
// Whether it begins with a whole snapshot, by its header and its seal; snapshot_bytes() of it is then no more than `size`.
bool snapshot_is_whole(const void* memory, uint64_t size);
uint64_t snapshot_bytes(const void* memory);
// Of a whole one.
lr_status snapshot_restore(lr_world& world, const void* memory);

} // namespace lr
