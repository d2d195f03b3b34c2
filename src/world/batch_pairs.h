// Which batches' bodies meet each other: pairs of batch slots, of which both may be the same. docs/maintainers/contact.md
#pragma once

#include "world/allocator.h"
#include "world/handles.h"

#include <algorithm>
#include <cstdint>

namespace lr {

class BatchPairs {
public:
    bool any() const { return used_ != 0; }
    bool has(uint32_t a, uint32_t b) const; // their order does not matter
    uint32_t partners(uint32_t slot) const; // how many it meets, itself among them
    bool meets(uint32_t slot) const { return partners(slot) != 0; }
    uint32_t count() const { return pairs_; }

    // False when out of memory, and then nothing has changed.
    bool set(Allocator& allocator, uint32_t a, uint32_t b, bool on);
    void remove(uint32_t slot); // all of its pairs

    // Calls fn(slot) for each that it meets, in ascending order.
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

    struct Pair {
        uint32_t low, high;
    };
    // In place of all there are. `count` of them, of any alignment; false when out of memory.
    bool fill(Allocator& allocator, const unsigned char* from, uint32_t count);
    // Whether bytes that say to be pairs of so many slots can be filled in: in the order of visit(), none twice.
    static bool consistent(const unsigned char* from, uint32_t count, uint32_t slots);
    // Whether they are those there are.
    bool equal(const unsigned char* from, uint32_t count) const;
    void swap(BatchPairs& other);

private:
    static constexpr uint32_t partner_mask = (1u << batch_bits) - 1;
    static_assert(2 * batch_bits <= 32);

    const uint32_t* begin() const { return links_.data(); }
    const uint32_t* end() const { return links_.data() + used_; }
    const uint32_t* first(uint32_t slot) const { return std::lower_bound(begin(), end(), slot << batch_bits); }
    void insert(uint32_t link);
    void erase(uint32_t link);

    // Ascending: a slot in the upper bits, its partner below. Each pair of two is there both ways.
    Buffer<uint32_t> links_;
    uint32_t used_ = 0, pairs_ = 0;
};

} // namespace lr
