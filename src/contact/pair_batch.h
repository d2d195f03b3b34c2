// Where many pairs of bodies touch in a substep: those of the same shapes are searched side by side.
#pragma once

#include "contact/pair_way.h"
#include "contact/placed_pair.h"
#include "kernel/pair_search.h"

#include <cstdint>

namespace lr {

// What is found of a pair is the same in any company.
class PairBatch {
public:
    explicit PairBatch(PairSearch target) : target_(target) {}

    // Calls found(id, contacts, count) once for each pair, now or in a later call, until finish(). The bodies must last till then.
    template <class Found>
    void find(const PairBody& a, const PairBody& b, float margin, uint32_t id, const Found& found) {
        Waiting& next = waiting_[count_];
        WayContact contacts[most_pair_contacts];
        if (!relate(*a.shape, a.scale, a.from, *b.shape, b.scale, b.from, near_enough(a, b, margin), next.near)) {
            found(id, contacts, 0);
            return;
        }
        next.a = &a;
        next.b = &b;
        next.margin = margin;
        next.id = id;
        if (a.shape->flat || b.shape->flat) {
            PairContact touching[most_pair_contacts];
            const uint32_t count = search_contacts(next.near, touching);
            found(id, contacts, keep_way_contacts(a, b, margin, touching, count, contacts));
            return;
        }
        if (++count_ == most) finish(found);
    }
    template <class Found> void finish(const Found& found) {
        for (uint32_t first = 0; first < count_;) {
            const uint32_t lanes = search(first);
            for (uint32_t lane = 0; lane < lanes; ++lane, ++first) {
                WayContact contacts[most_pair_contacts];
                found(waiting_[order_[first]].id, contacts, contacts_at(first, lane, contacts));
            }
        }
        count_ = 0;
    }

private:
    static constexpr uint32_t most = 4 * search_lanes;
    struct Waiting {
        NearPair near;
        const PairBody *a, *b;
        float margin;
        uint32_t id;
    };
    // Of those from `first` on in the order, as many as have the shapes of the first.
    uint32_t search(uint32_t first);
    uint32_t contacts_at(uint32_t at, uint32_t lane, WayContact (&out)[most_pair_contacts]) const;

    PairSearch target_;
    uint32_t count_ = 0;
    uint32_t order_[most];
    Waiting waiting_[most];
    SearchBlock block_;
};

} // namespace lr
