// The stations of a body in kernel units (body_constants.h), without the fluid's density: AerodynamicConstantsOf::fluid has that.
#pragma once

#include "asset/asset_data.h"

#include <cstdint>

namespace lr {

struct StationConstants {
    float along[3][6]; // velocities along chord, span and normal by the body's velocity and spin
    float axes[9], place[3];
    float spread[6];   // |r|^2 - r r^T, r: the place; upper triangle
    float outer[3][6]; // upper triangles of e e^T, e: the axes
    float drag[3], drag_blunt[3], drag_layer[3], drag_stokes[3];
    float spin_lift[3], spin_drag[3], spin_drag_stream[3], spin_drag_stokes[3], spin_weight[3];
    float lift[2], vortex[2], stall[2]; // along chord and span; stall: the inverse
    float plate_drag, start_drag;
    float lift_arm[2], separated_shedding;
    float camber;
};

struct StationSet {
    StationConstants station[most_stations];
    uint32_t count = 0;
};

// None if `loads` are not the asset's own: others replace its stations.
void make_stations(const AssetData& asset, const AerodynamicData& loads, StationSet& out);
} // namespace lr
