// Copies of some bodies of a batch: stepped on their own, then put back.
#pragma once

#include "base/pose.h"
#include "kernel/integrator/step.h"

#include <algorithm>
#include <cstdint>

namespace lr {

// Lanes for so many bodies, in whole blocks.
constexpr uint32_t whole_blocks(uint32_t bodies) {
    constexpr auto block = static_cast<uint32_t>(lane_block);
    return (bodies + block - 1) / block * block;
}

template <size_t kMost> struct BodyCopies {
    uint32_t count = 0, padded = 0; // the last body fills the remaining lanes
    bool has_floor = false;
    uint32_t place[kMost]; // of each in the arrays that it was copied from
    alignas(64) float field[field_count][kMost];
    alignas(64) uint32_t noise_seed[kMost], floor[kMost];
    alignas(64) float force[force_components][kMost];

    // index(i): where the i-th body is in `from`.
    template <class Index> void take(const BatchArrays& from, uint32_t some, const Index& index) {
        count = some;
        padded = whole_blocks(some);
        for (uint32_t i = 0; i < padded; ++i) place[i] = index(std::min(i, count - 1));
        for (size_t f = 0; f < field_count; ++f)
            if (from.field[f]) gather(from.field[f], field[f]);
        gather(from.noise_seed, noise_seed);
        has_floor = from.floor != nullptr;
        if (has_floor) gather(from.floor, floor);
    }
    // forget: clears the originals, so the forces apply to the following substeps only.
    void take_forces(const ExternalInput& in, bool forget) {
        for (size_t c = 0; c < force_components && in.used != 0; ++c) {
            float* const source = in.bodies + c * in.stride;
            gather(source, force[c]);
            for (uint32_t i = 0; i < count && forget; ++i) source[place[i]] = 0.0f;
        }
    }
    template <class T> void gather(const T* source, T* to) const {
        for (uint32_t i = 0; i < padded; ++i) to[i] = source[place[i]];
    }
    template <class T, class Index> void gather(const T* source, const Index& index, T* to) const {
        for (uint32_t i = 0; i < padded; ++i) to[i] = source[index(std::min(i, count - 1))];
    }
    void put_back(const BatchArrays& to) const {
        for (size_t f = 0; f < field_count; ++f)
            for (uint32_t i = 0; i < count && to.field[f]; ++i) to.field[f][place[i]] = field[f][i];
        for (uint32_t i = 0; i < count && has_floor; ++i) to.floor[place[i]] = floor[i];
    }
    BatchArrays arrays(uint32_t first = 0) {
        BatchArrays a{};
        for (size_t f = 0; f < field_count; ++f) a.field[f] = field[f] + first;
        a.noise_seed = noise_seed + first;
        if (has_floor) a.floor = floor + first;
        return a;
    }
    // Points `to` at the forces of the copies from `first` on.
    void lend_forces(ExternalInput& to, uint32_t first = 0) {
        to.bodies = force[0] + first;
        to.stride = kMost;
        to.clear = false;
    }
};

// Calls step(begin, end) for the lane blocks of [at, last) that contain a body without a copy. live: bodies of the batch. copied: of each from `at`
// on; 0: it has none.
template <class Step>
void step_others(uint32_t at, uint32_t last, uint32_t live, const uint32_t* copied, const Step& step) {
    constexpr auto lanes = static_cast<uint32_t>(lane_block);
    const auto others = [&](uint32_t begin) {
        for (uint32_t i = begin; i < std::min(begin + lanes, live); ++i)
            if (copied[i - at] == 0) return true;
        return false;
    };
    for (uint32_t from = at; from < last;) {
        uint32_t to = from;
        while (to < last && others(to)) to += lanes;
        if (to != from) step(from, to);
        from = to + lanes;
    }
}

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
