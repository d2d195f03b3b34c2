// An order of handles, for std::set and std::map of tests.
#pragma once

#include "langevin_rigid_research.h"

inline bool operator<(lr_batch a, lr_batch b) {
    return a.id < b.id;
}
inline bool operator<(lr_body a, lr_body b) {
    return a.id < b.id;
}
inline bool operator<(lr_collider a, lr_collider b) {
    return a.id < b.id;
}
