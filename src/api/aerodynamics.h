// Coefficients of the quasi-steady loads across the ABI.
#pragma once

#include "api/arguments.h"
#include "format/asset_data.h"
#include "langevin_rigid.h"

#include <algorithm>
#include <iterator>

namespace lr::api {

// All but struct_size, which is left to the caller.
inline lr_aerodynamics to_struct(const AerodynamicData& from) {
    lr_aerodynamics to{};
    const auto copy = [](const auto& values, double* at) { std::copy(values.begin(), values.end(), at); };
    copy(from.axes, to.axes);
    copy(from.drag, to.drag);
    copy(from.drag_blunt, to.drag_blunt);
    copy(from.drag_layer, to.drag_layer);
    copy(from.drag_stokes, to.drag_stokes);
    copy(from.lift, to.lift);
    copy(from.spin_lift, to.spin_lift);
    copy(from.lift_moment, to.lift_moment);
    copy(from.spin_drag, to.spin_drag);
    copy(from.spin_drag_stream, to.spin_drag_stream);
    copy(from.spin_drag_stokes, to.spin_drag_stokes);
    to.intensity = from.intensity;
    to.length = from.length;
    to.wake_reynolds = from.wake_reynolds;
    copy(from.broadside, to.broadside);
    to.lift_stall = from.lift_stall;
    copy(from.lift_moment_stalled, to.lift_moment_stalled);
    return to;
}

inline AerodynamicData from_struct(const lr_aerodynamics& from) {
    AerodynamicData to;
    const auto copy = [](const auto& values, auto& array) {
        std::copy(std::begin(values), std::end(values), array.begin());
    };
    copy(from.axes, to.axes);
    copy(from.drag, to.drag);
    copy(from.drag_blunt, to.drag_blunt);
    copy(from.drag_layer, to.drag_layer);
    copy(from.drag_stokes, to.drag_stokes);
    copy(from.lift, to.lift);
    copy(from.spin_lift, to.spin_lift);
    copy(from.lift_moment, to.lift_moment);
    copy(from.spin_drag, to.spin_drag);
    copy(from.spin_drag_stream, to.spin_drag_stream);
    copy(from.spin_drag_stokes, to.spin_drag_stokes);
    to.intensity = from.intensity;
    to.length = from.length;
    to.wake_reynolds = from.wake_reynolds;
    copy(from.broadside, to.broadside);
    to.lift_stall = from.lift_stall;
    copy(from.lift_moment_stalled, to.lift_moment_stalled);
    return to;
}

// Whatever cannot be a body's is refused by is_usable afterwards.
inline lr_status read_loads(const lr_aerodynamics* from, lr_aerodynamics& a) {
    const lr_status status = read_struct(from, a);
    if (status != LR_OK) return status;
    const double scalars[] = {a.intensity, a.length, a.wake_reynolds, a.lift_stall};
    if (!finite(a.axes) || !finite(a.drag) || !finite(a.drag_blunt) || !finite(a.drag_layer) ||
        !finite(a.drag_stokes) || !finite(a.lift) || !finite(a.spin_lift) || !finite(a.lift_moment) ||
        !finite(a.spin_drag) || !finite(a.spin_drag_stream) || !finite(a.spin_drag_stokes) || !finite(a.broadside) ||
        !finite(a.lift_moment_stalled) || !finite(scalars))
        return LR_ERROR_NOT_FINITE;
    return a.reserved == 0 ? LR_OK : LR_ERROR_INVALID_ARGUMENT;
}

} // namespace lr::api
