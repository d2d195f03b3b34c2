// Coefficients of the quasi-steady loads across the ABI.
#pragma once

#include "api/arguments.h"
#include "format/asset_data.h"
#include "langevin_rigid.h"

#include <algorithm>
#include <iterator>
#include <type_traits>

namespace lr::api {

// Calls `each` with every number of the one beside that of the other: pairs of scalars and of arrays.
template <class Data, class Struct, class Each> void pair_up(Data& data, Struct& at, Each each) {
    each(data.axes, at.axes);
    each(data.drag, at.drag);
    each(data.drag_blunt, at.drag_blunt);
    each(data.drag_layer, at.drag_layer);
    each(data.drag_stokes, at.drag_stokes);
    each(data.lift, at.lift);
    each(data.spin_lift, at.spin_lift);
    each(data.lift_moment, at.lift_moment);
    each(data.spin_drag, at.spin_drag);
    each(data.spin_drag_stream, at.spin_drag_stream);
    each(data.spin_drag_stokes, at.spin_drag_stokes);
    each(data.intensity, at.intensity);
    each(data.length, at.length);
    each(data.wake_reynolds, at.wake_reynolds);
    each(data.broadside, at.broadside);
    each(data.lift_stall, at.lift_stall);
    each(data.lift_moment_stalled, at.lift_moment_stalled);
}

template <class From, class To> void copy_numbers(const From& from, To& to) {
    if constexpr (std::is_arithmetic_v<To>)
        to = from;
    else
        std::copy(std::begin(from), std::end(from), std::begin(to));
}

// All but struct_size, which is left to the caller.
inline lr_aerodynamics to_struct(const AerodynamicData& from) {
    lr_aerodynamics to{};
    pair_up(from, to, [](const auto& data, auto& at) { copy_numbers(data, at); });
    return to;
}

inline AerodynamicData from_struct(const lr_aerodynamics& from) {
    AerodynamicData to;
    pair_up(to, from, [](auto& data, const auto& at) { copy_numbers(at, data); });
    return to;
}

// Whatever cannot be a body's is refused by is_usable afterwards.
inline lr_status read_loads(const lr_aerodynamics* from, lr_aerodynamics& a) {
    const lr_status status = read_struct(from, a);
    if (status != LR_OK) return status;
    bool all_finite = true;
    const AerodynamicData unused;
    pair_up(unused, a, [&](const auto&, const auto& at) {
        if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(at)>>)
            all_finite = all_finite && std::isfinite(at);
        else
            all_finite = all_finite && finite(at);
    });
    if (!all_finite) return LR_ERROR_NOT_FINITE;
    return a.reserved == 0 ? LR_OK : LR_ERROR_INVALID_ARGUMENT;
}

} // namespace lr::api
