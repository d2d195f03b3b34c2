#include "body_contact/batch_pairs.h"

#include <cstring>
#include <functional>
#include <utility>

namespace lr {

bool BatchPairs::has(uint32_t a, uint32_t b) const {
    return std::binary_search(begin(), end(), link_of(a, b));
}

uint32_t BatchPairs::partners(uint32_t slot) const {
    return static_cast<uint32_t>(first(slot + 1) - first(slot));
}

bool BatchPairs::set(Allocator& allocator, uint32_t a, uint32_t b, bool on) {
    if (has(a, b) == on) return true;
    if (on && used_ + 2 > links_.size() && !enlarge(allocator, links_, std::max<size_t>(16, 2 * links_.size()), used_))
        return false;
    const auto change = [&](uint32_t link) {
        uint32_t* const last = links_.data() + used_;
        uint32_t* const at = std::lower_bound(links_.data(), last, link);
        if (on) {
            std::copy_backward(at, last, last + 1);
            *at = link;
            ++used_;
        } else {
            std::copy(at + 1, last, at);
            --used_;
        }
    };
    change(link_of(a, b));
    if (a != b) change(link_of(b, a));
    return true;
}

void BatchPairs::remove(uint32_t slot) {
    uint32_t* const data = links_.data();
    const auto gone = [slot](uint32_t link) { return link >> batch_bits == slot || (link & partner_mask) == slot; };
    used_ = static_cast<uint32_t>(std::remove_if(data, data + used_, gone) - data);
}

bool BatchPairs::equal(const unsigned char* from, uint32_t count) const {
    return count == used_ && (count == 0 || std::memcmp(links(), from, sizeof(uint32_t) * size_t{count}) == 0);
}

bool BatchPairs::fill(Allocator& allocator, const unsigned char* from, uint32_t count) {
    Buffer<uint32_t> links;
    if (!links.allocate(allocator, count)) return false;
    if (count != 0) std::memcpy(links.data(), from, sizeof(uint32_t) * size_t{count});
    links_.swap(links);
    used_ = count;
    return true;
}

bool BatchPairs::consistent(uint32_t slots) const {
    const auto both_ways = [&](uint32_t link) {
        const uint32_t slot = link >> batch_bits, partner = link & partner_mask;
        return slot < slots && has(partner, slot);
    };
    return std::adjacent_find(begin(), end(), std::greater_equal<>()) == end() &&
           std::all_of(begin(), end(), both_ways);
}

void BatchPairs::swap(BatchPairs& other) {
    links_.swap(other.links_);
    std::swap(used_, other.used_);
}
} // namespace lr
