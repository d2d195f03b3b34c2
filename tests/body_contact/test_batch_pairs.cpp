// Pairs of batches against a plain set as reference.
#include "body_contact/batch_pairs.h"

#include "support/counting_memory.h"
#include "support/random.h"

#include <doctest/doctest.h>

#include <set>
#include <utility>
#include <vector>

using namespace test;

namespace {

using Model = std::set<std::pair<uint32_t, uint32_t>>;

const unsigned char* bytes_of(const uint32_t* links) {
    return reinterpret_cast<const unsigned char*>(links);
}
bool same(const lr::BatchPairs& pairs, const Model& model, const std::vector<uint32_t>& slots) {
    bool equal = pairs.any() == !model.empty();
    Model seen;
    uint32_t visits = 0;
    pairs.visit([&](uint32_t low, uint32_t high) {
        const auto added = seen.insert({low, high});
        equal = equal && std::next(added.first) == seen.end(); // in ascending order
        ++visits;
    });
    equal = equal && seen == model && visits == model.size();
    for (const uint32_t a : slots) {
        std::vector<uint32_t> partners, expected;
        for (const uint32_t b : slots) {
            const bool there = model.count({std::min(a, b), std::max(a, b)}) != 0;
            equal = equal && pairs.has(a, b) == there;
            if (there) expected.push_back(b);
        }
        pairs.visit_partners(a, [&](uint32_t b) { partners.push_back(b); });
        equal = equal && partners == expected && pairs.partners(a) == expected.size() &&
                pairs.has_contact(a) == !expected.empty();
    }
    return equal;
}

} // namespace

TEST_CASE("pairs of batches are those that were switched on, whatever the order of calls") {
    const std::vector<uint32_t> slots{0, 1, 2, 3, 5, 8, 100, lr::max_batches - 2, lr::max_batches - 1};
    CountingAllocator memory;
    lr::Allocator allocator(memory.callbacks());
    {
        lr::BatchPairs pairs;
        Model model;
        Random random(61);
        const auto any_slot = [&] { return slots[random.below(static_cast<uint32_t>(slots.size()))]; };
        bool equal = same(pairs, model, slots);
        size_t most = 0;
        for (int i = 0; i < 5000 && equal; ++i) {
            const uint32_t a = any_slot(), b = any_slot();
            if (random.below(40) == 0) {
                pairs.remove(a);
                for (auto at = model.begin(); at != model.end();)
                    at = at->first == a || at->second == a ? model.erase(at) : std::next(at);
            } else {
                const bool on = random.below(3) != 0;
                equal = equal && pairs.set(allocator, a, b, on);
                if (on)
                    model.insert({std::min(a, b), std::max(a, b)});
                else
                    model.erase({std::min(a, b), std::max(a, b)});
            }
            most = std::max(most, model.size());
            equal = equal && same(pairs, model, slots);
            if (i % 50 != 0) continue;
            // Saved pairs load again.
            lr::BatchPairs other;
            equal = equal && other.fill(allocator, bytes_of(pairs.links()), pairs.link_count());
            equal = equal && other.consistent(lr::max_batches) && same(other, model, slots);
            equal = equal && other.equal(bytes_of(pairs.links()), pairs.link_count());
            pairs.swap(other);
            equal = equal && same(pairs, model, slots);
        }
        CHECK(equal);
        CHECK(most > 30);
    }
    CHECK(memory.live() == 0);
    CHECK(!memory.mismatch);
}

TEST_CASE("a pair for which there is no memory changes none of the others") {
    CountingAllocator memory;
    lr::Allocator allocator(memory.callbacks());
    lr::BatchPairs pairs;
    memory.fail_at = memory.calls;
    CHECK(!pairs.set(allocator, 1, 2, true));
    CHECK(!pairs.any());
    Model model;
    memory.fail_at = memory.calls + 1;
    uint32_t refused = 0;
    for (uint32_t i = 0; i < 20; ++i) {
        if (pairs.set(allocator, i, 7, true))
            model.insert({std::min(i, 7u), std::max(i, 7u)});
        else
            ++refused;
    }
    CHECK(refused == 1); // the buffer grows once, then no call lacks memory
    CHECK(same(pairs, model, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19}));
}

TEST_CASE("pairs out of order, twice, one way, or of slots that there are not are seen when they have been filled in") {
    using Links = std::vector<std::pair<uint32_t, uint32_t>>;
    CountingAllocator memory;
    lr::Allocator allocator(memory.callbacks());
    const auto consistent = [&](const Links& from) {
        std::vector<uint32_t> links;
        for (const auto& [slot, partner] : from) links.push_back(slot << lr::batch_bits | partner);
        lr::BatchPairs pairs;
        REQUIRE(pairs.fill(allocator, bytes_of(links.data()), static_cast<uint32_t>(links.size())));
        return pairs.consistent(4);
    };
    for (const Links& good : {Links{}, Links{{0, 0}}, Links{{0, 3}, {1, 1}, {1, 2}, {2, 1}, {3, 0}, {3, 3}}})
        CHECK(consistent(good));
    for (const Links& bad : {Links{{1, 0}}, Links{{0, 4}, {4, 0}}, Links{{4, 4}}, Links{{0, 1}, {0, 1}, {1, 0}},
                             Links{{0, 2}, {0, 1}, {1, 0}, {2, 0}}, Links{{1, 1}, {0, 0}}, Links{{0x3ffff, 0x3fff}}})
        CHECK(!consistent(bad));
}
