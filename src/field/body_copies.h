// Some bodies of a batch in arrays of their own: taken out, stepped or tried by themselves, and put back.
#pragma once

#include "contact/pose_rows.h"
#include "kernel/step.h"

#include <algorithm>
#include <cstdint>

namespace lr {

template <size_t kMost> struct BodyCopies {
    uint32_t count = 0, padded = 0; // the last body fills up the lanes
    alignas(64) float field[field_count][kMost];
    alignas(64) uint32_t key[kMost];
    alignas(64) float force[force_components][kMost];

    // index(i): of the i-th of them.
    template <class Index> void take(const BatchArrays& from, uint32_t some, const Index& index) {
        constexpr auto lanes = static_cast<uint32_t>(lane_block);
        count = some;
        padded = (some + lanes - 1) / lanes * lanes;
        for (size_t f = 0; f < field_count; ++f)
            if (from.field[f]) gather(from.field[f], index, field[f]);
        gather(from.key, index, key);
    }
    // forget: they are for what follows alone.
    template <class Index> void take_forces(const ExternalInput& in, const Index& index, bool forget) {
        for (size_t c = 0; c < force_components && in.used != 0; ++c) {
            float* const source = in.bodies + c * in.stride;
            gather(source, index, force[c]);
            for (uint32_t i = 0; i < count && forget; ++i) source[index(i)] = 0.0f;
        }
    }
    template <class T, class Index> void gather(const T* source, const Index& index, T* to) const {
        for (uint32_t i = 0; i < padded; ++i) to[i] = source[index(std::min(i, count - 1))];
    }
    template <class Index> void put_back(const BatchArrays& to, const Index& index) const {
        for (size_t f = 0; f < field_count; ++f)
            for (uint32_t i = 0; i < count && to.field[f]; ++i) to.field[f][index(i)] = field[f][i];
    }
    BatchArrays arrays(uint32_t first = 0) {
        BatchArrays a{};
        for (size_t f = 0; f < field_count; ++f) a.field[f] = field[f] + first;
        a.key = key + first;
        return a;
    }
    // For substeps of those from `first` on.
    void lend_forces(ExternalInput& to, uint32_t first = 0) {
        to.bodies = force[0] + first;
        to.stride = kMost;
        to.clear = false;
    }
};

// One substep of a step by itself.
inline StepInput substep_of(const StepInput& in, uint32_t substep) {
    StepInput one = in;
    one.substeps = 1;
    one.first_substep += substep;
    const bool last = substep + 1 == in.substeps;
    one.external.clear = last;
    const auto n = static_cast<float>(in.substeps);
    const float begin = static_cast<float>(substep) / n, end = static_cast<float>(substep + 1) / n;
    for (size_t k = 0; k < 3 && in.wind_changes; ++k) {
        const float change = in.wind[k] - in.wind_begin[k];
        one.wind_begin[k] = in.wind_begin[k] + begin * change;
        if (!last) one.wind[k] = in.wind_begin[k] + end * change;
    }
    return one;
}

} // namespace lr
