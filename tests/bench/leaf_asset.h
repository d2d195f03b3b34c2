// The body of benchmarks: a leaf of 8 cm x 2 cm x 0.1 mm.
#pragma once

#include "langevin_rigid.h"

namespace bench {

// Null after an error.
inline lr_asset* leaf_asset() {
    lr_ellipsoid_desc shape;
    lr_asset* asset = nullptr;
    if (lr_ellipsoid_desc_init(&shape, sizeof shape) != LR_OK) return nullptr;
    shape.semi_axes[0] = 0.04, shape.semi_axes[1] = 0.01, shape.semi_axes[2] = 0.00005;
    shape.density = 800.0;
    return lr_asset_create_ellipsoid(&shape, &asset) == LR_OK ? asset : nullptr;
}

} // namespace bench
