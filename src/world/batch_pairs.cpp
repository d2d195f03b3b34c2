#include "world/batch_pairs.h"

#include <cstring>
#include <utility>

namespace lr {
namespace {

uint32_t link_of(uint32_t slot, uint32_t partner) {
    return slot << batch_bits | partner;
}

BatchPairs::Pair pair_at(const unsigned char* from, uint32_t index) {
    BatchPairs::Pair pair;
    std::memcpy(&pair, from + sizeof pair * uint64_t{index}, sizeof pair);
    return pair;
}

} // namespace

bool BatchPairs::has(uint32_t a, uint32_t b) const {
    return std::binary_search(begin(), end(), link_of(a, b));
}

uint32_t BatchPairs::partners(uint32_t slot) const {
    return static_cast<uint32_t>(first(slot + 1) - first(slot));
}

bool BatchPairs::set(Allocator& allocator, uint32_t a, uint32_t b, bool on) {
    if (has(a, b) == on) return true;
    if (on && used_ + 2 > links_.size()) {
        Buffer<uint32_t> larger;
        if (!larger.allocate(allocator, std::max<size_t>(16, 2 * links_.size()))) return false;
        std::copy(begin(), end(), larger.data());
        links_.swap(larger);
    }
    const auto change = [&](uint32_t link) { on ? insert(link) : erase(link); };
    change(link_of(a, b));
    if (a != b) change(link_of(b, a));
    pairs_ = on ? pairs_ + 1 : pairs_ - 1;
    return true;
}

void BatchPairs::insert(uint32_t link) {
    uint32_t* const data = links_.data();
    uint32_t* const at = std::lower_bound(data, data + used_, link);
    std::copy_backward(at, data + used_, data + used_ + 1);
    *at = link;
    ++used_;
}

void BatchPairs::erase(uint32_t link) {
    uint32_t* const data = links_.data();
    uint32_t* const at = std::lower_bound(data, data + used_, link);
    std::copy(at + 1, data + used_, at);
    --used_;
}

void BatchPairs::remove(uint32_t slot) {
    pairs_ -= partners(slot);
    uint32_t* const data = links_.data();
    const auto gone = [slot](uint32_t link) { return link >> batch_bits == slot || (link & partner_mask) == slot; };
    used_ = static_cast<uint32_t>(std::remove_if(data, data + used_, gone) - data);
}

bool BatchPairs::consistent(const unsigned char* from, uint32_t count, uint32_t slots) {
    uint64_t last = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const Pair pair = pair_at(from, i);
        if (pair.low > pair.high || pair.high >= slots) return false;
        const uint64_t link = link_of(pair.low, pair.high);
        if (i != 0 && link <= last) return false;
        last = link;
    }
    return true;
}

bool BatchPairs::equal(const unsigned char* from, uint32_t count) const {
    uint32_t i = 0;
    bool same = count == pairs_;
    visit([&](uint32_t low, uint32_t high) {
        if (!same) return;
        const Pair pair = pair_at(from, i++);
        same = pair.low == low && pair.high == high;
    });
    return same;
}

bool BatchPairs::fill(Allocator& allocator, const unsigned char* from, uint32_t count) {
    Buffer<uint32_t> links;
    if (!links.allocate(allocator, 2 * size_t{count})) return false;
    used_ = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const Pair pair = pair_at(from, i);
        links[used_++] = link_of(pair.low, pair.high);
        if (pair.low != pair.high) links[used_++] = link_of(pair.high, pair.low);
    }
    std::sort(links.data(), links.data() + used_);
    links_.swap(links);
    pairs_ = count;
    return true;
}

void BatchPairs::swap(BatchPairs& other) {
    links_.swap(other.links_);
    std::swap(used_, other.used_);
    std::swap(pairs_, other.pairs_);
}

} // namespace lr
