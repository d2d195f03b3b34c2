// Which pairs of batches have body contact, by batch slots. A batch can be paired with itself. docs/maintainers/contact.md
#pragma once

#include "base/allocator.h"
#include "base/handles.h"

#include <algorithm>
#include <cstdint>

namespace lr {

class BatchPairs {
public:
    bool any() const { return used_ != 0; }
    bool has(uint32_t a, uint32_t b) const; // in either order
    uint32_t partners(uint32_t slot) const; // how many batches it is paired with, itself included
    bool has_contact(uint32_t slot) const { return partners(slot) != 0; }

    // False when out of memory, and then nothing has changed.
    bool set(Allocator& allocator, uint32_t a, uint32_t b, bool on);
    void remove(uint32_t slot); // all of its pairs

    // Calls fn(slot) for each partner, in ascending order.
    template <class Function> void visit_partners(uint32_t slot, Function&& function) const {
        for (const uint32_t* at = first(slot); at != end() && *at >> batch_bits == slot; ++at)
            function(*at & partner_mask);
    }
    // Calls fn(low, high), low <= high, for each pair in ascending order.
    template <class Function> void visit(Function&& function) const {
        for (const uint32_t* at = begin(); at != end(); ++at) {
            const uint32_t low = *at >> batch_bits, high = *at & partner_mask;
            if (low <= high) function(low, high);
        }
    }

    // As in a snapshot: links in ascending order, bytes of any alignment.
    const uint32_t* links() const { return links_.data(); }
    uint32_t link_count() const { return used_; }
    bool equal(const unsigned char* from, uint32_t count) const;
    // Replaces all pairs. False when out of memory.
    bool fill(Allocator& allocator, const unsigned char* from, uint32_t count);
    bool consistent(uint32_t slots) const; // whether the pairs are valid for so many slots
    void swap(BatchPairs& other);

private:
    static uint32_t link_of(uint32_t slot, uint32_t partner) { return slot << batch_bits | partner; }
    static constexpr uint32_t partner_mask = (1u << batch_bits) - 1;
    static_assert(2 * batch_bits <= 32);

    const uint32_t* begin() const { return links_.data(); }
    const uint32_t* end() const { return links_.data() + used_; }
    const uint32_t* first(uint32_t slot) const { return std::lower_bound(begin(), end(), slot << batch_bits); }

    // Ascending: a slot in the upper bits, its partner in the lower ones. A pair of two batches is stored both ways.
    Buffer<uint32_t> links_;
    uint32_t used_ = 0;
};
} // namespace lr
