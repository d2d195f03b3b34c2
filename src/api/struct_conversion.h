// Conversion between structs of the ABI and of the library.
#pragma once

#include "api/check_arguments.h"
#include "asset/asset_data.h"
#include "base/pose.h"
#include "collision/collider_contact_group.h"
#include "langevin_rigid_research.h"

#include <algorithm>
#include <iterator>
#include <type_traits>

namespace lr::api {

// Calls `each` for every pair of corresponding fields, scalars and arrays.
template <class Data, class Struct, class Each> void pair_up(Data& data, Struct& at, Each each) {
    each(data.axes, at.axes);
#define LR_PAIR(name, ...) each(data.name, at.name);
    LR_AERODYNAMIC_VECTORS(LR_PAIR)
    LR_AERODYNAMIC_NUMBERS(LR_PAIR)
#undef LR_PAIR
}

template <class From, class To> void copy_numbers(const From& from, To& to) {
    if constexpr (std::is_arithmetic_v<To>)
        to = from;
    else
        std::copy(std::begin(from), std::end(from), std::begin(to));
}

// The caller sets struct_size.
inline lr_aerodynamics to_struct(const AerodynamicData& from) {
    lr_aerodynamics to{};
    pair_up(from, to, [](const auto& data, auto& at) { copy_numbers(data, at); });
    return to;
}

// Checks no ranges; wrong_in does. out: fields that an older caller's struct lacks keep their values.
inline lr_status read_loads(const lr_aerodynamics* from, AerodynamicData& out) {
    lr_aerodynamics a = to_struct(out);
    if (const Outcome outcome = read_struct(from, a); outcome.refused()) return outcome.status;
    bool all_finite = true;
    pair_up(out, a, [&](auto& data, const auto& at) {
        all_finite = all_finite && finite(at);
        copy_numbers(at, data);
    });
    return all_finite ? LR_OK : LR_ERROR_NOT_FINITE;
}

// A velocity in the world frame, from storage in the body frame.
inline Vector to_world(Rotation q, Vector v) {
    return to_float(rotate(to_double(q), to_double(v)));
}

// An optional setting. Without one, `out` gets the initial values.
template <Sized S> void read_back(const S* from, lr_status (*init)(S*, uint32_t), S& out, int32_t& present) {
    present = from ? 1 : 0;
    if (from)
        out = *from;
    else
        init(&out, sizeof out);
}
} // namespace lr::api
