#include "contact/pair_batch.h"

#include <algorithm>

namespace lr {
namespace {

void put(SearchBlock::Row* rows, uint32_t lane, Vector v) {
    rows[0][lane] = v.x;
    rows[1][lane] = v.y;
    rows[2][lane] = v.z;
}
Vector get(const SearchBlock::Row* rows, uint32_t lane) {
    return {rows[0][lane], rows[1][lane], rows[2][lane]};
}

} // namespace

uint32_t PairBatch::search(uint32_t first) {
    if (first == 0)
        for (uint32_t i = 0; i < count_; ++i) order_[i] = i;
    const RelativePair& one = waiting_[order_[first]].near.pair;
    uint32_t lanes = 0;
    for (uint32_t i = first; i < count_ && lanes < search_lanes; ++i) {
        const RelativePair& pair = waiting_[order_[i]].near.pair;
        if (pair.a == one.a && pair.b == one.b) std::swap(order_[first + lanes++], order_[i]);
    }
    for (uint32_t lane = 0; lane < search_lanes; ++lane) {
        const NearPair& near =
            waiting_[order_[first + (lane < lanes ? lane : 0)]].near; // the others must come to an end
        block_.ratio[lane] = near.pair.ratio;
        put(block_.offset, lane, near.pair.offset);
        for (size_t k = 0; k < 3; ++k) put(block_.axes + 3 * k, lane, near.pair.axes[k]);
        put(block_.start, lane, near.start);
        block_.enough[lane] = near.enough;
        block_.near[lane] = touching_cores * near.pair.size;
        block_.tolerance[lane] = near.tolerance;
    }
    const MeetingShape &a = *one.a, &b = *one.b;
    target_({a.x, a.y, a.z, a.shape.count}, {b.x, b.y, b.z, b.shape.count}, lanes, block_);
    return lanes;
}

uint32_t PairBatch::contacts_at(uint32_t at, uint32_t lane, WayContact (&out)[most_pair_contacts]) const {
    if (block_.state[lane] == SearchBlock::beyond) return 0;
    const Waiting& waiting = waiting_[order_[at]];
    PlacedPair pair;
    static_cast<RelativePair&>(pair) = waiting.near.pair;
    pair.place_points();
    Closest closest{};
    closest.state = block_.state[lane] == SearchBlock::overlap ? Closest::State::overlap : Closest::State::apart;
    closest.normal = get(block_.normal, lane);
    closest.distance = block_.distance[lane];
    closest.on_a = get(block_.on_a, lane);
    closest.on_b = closest.on_a - closest.distance * closest.normal;
    PairContact touching[most_pair_contacts];
    const uint32_t count = contacts_of(waiting.near, pair, closest, touching);
    return keep_way_contacts(*waiting.a, *waiting.b, waiting.margin, touching, count, out);
}

} // namespace lr
