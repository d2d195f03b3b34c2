// Puts a diagonal body on the path of full mass matrices: its loads act slightly off its mirror planes.
#pragma once

#include <langevin_rigid_research.h>

inline bool take_full_path(lr_world* world, lr_batch batch) {
    lr_aerodynamics a;
    if (lr_aerodynamics_init(&a, sizeof a) != LR_OK || lr_batch_get_aerodynamics(world, batch, &a) != LR_OK)
        return false;
    for (double& x : a.center) x = 1e-6;
    return lr_batch_set_aerodynamics(world, batch, &a) == LR_OK;
}
