// Finds contacts of a pair of bodies at rest, without others.
#pragma once

#include "collision/pair_contacts.h"
#include "kernel/integrator/step.h"
#include "langevin_rigid.h"

namespace test {

// All contacts of two bodies with gaps below `margin`.
inline void find_manifold(const lr::PairBody& a, const lr::PairBody& b, float margin, lr::Manifold& out) {
    const auto take = [&](uint32_t, const lr::WayContact*, uint32_t, const lr::Manifold& found) { out = found; };
    lr::PairBatch batch(lr::find_target(LR_SIMD_AUTO)->search_pairs);
    batch.find(a, b, margin, 0.0f, 0, take);
    batch.finish(take);
}
inline uint32_t find_pair_contacts(const lr::PairBody& a, const lr::PairBody& b, float margin,
                                   lr::PairContact (&out)[lr::most_pair_contacts]) {
    uint32_t found = 0;
    const auto take = [&](uint32_t, const lr::WayContact* contacts, uint32_t count, const lr::Manifold&) {
        found = count;
        for (uint32_t i = 0; i < count; ++i) out[i] = contacts[i].begin;
    };
    lr::PairBatch batch(lr::find_target(LR_SIMD_AUTO)->search_pairs);
    batch.find(a, b, margin, 0.0f, 0, take);
    batch.finish(take);
    return found;
}
inline uint32_t find_pair_contacts(const lr::PairHull& a, float scale_a, const lr::Pose& at_a, const lr::PairHull& b,
                                   float scale_b, const lr::Pose& at_b, float margin,
                                   lr::PairContact (&out)[lr::most_pair_contacts]) {
    const lr::PairBody one{&a, scale_a, at_a, at_a, {}, 0.0f}, other{&b, scale_b, at_b, at_b, {}, 0.0f};
    return find_pair_contacts(one, other, margin, out);
}

} // namespace test
