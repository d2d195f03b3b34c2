// Vectors and poses of bodies whose numbers lie in rows, a body's in one place of each: BatchArrays::field, LaneRow and their like.
#pragma once

#include "contact/pose.h"
#include "kernel/batch_arrays.h"

#include <cstddef>

namespace lr {

template <class Rows> Vector vector_in(const Rows& rows, size_t first, size_t i) {
    return {rows[first][i], rows[first + 1][i], rows[first + 2][i]};
}
template <class Rows> void put_in(Rows& rows, size_t first, size_t i, Vector v) {
    rows[first][i] = v.x, rows[first + 1][i] = v.y, rows[first + 2][i] = v.z;
}
// In rows that begin with those of fields.
template <class Rows> Pose pose_in(const Rows& rows, size_t i) {
    return {vector_in(rows, field_x, i), {rows[field_qx][i], rows[field_qy][i], rows[field_qz][i], rows[field_qw][i]}};
}
inline Pose pose_of(const BatchArrays& arrays, size_t i) {
    return pose_in(arrays.field, i);
}

} // namespace lr
