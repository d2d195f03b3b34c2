// Pairs of batches against a set that does the same in the plainest way.
#include "world/batch_pairs.h"

#include "support/counting_memory.h"
#include "support/random.h"

#include <doctest/doctest.h>

#include <set>
#include <utility>
#include <vector>

using namespace test;

namespace {

using Model = std::set<std::pair<uint32_t, uint32_t>>;

std::vector<lr::BatchPairs::Pair> all_of(const lr::BatchPairs& pairs) {
    std::vector<lr::BatchPairs::Pair> all;
    pairs.visit([&](uint32_t low, uint32_t high) { all.push_back({low, high}); });
    return all;
}
const unsigned char* bytes_of(const std::vector<lr::BatchPairs::Pair>& pairs) {
    return reinterpret_cast<const unsigned char*>(pairs.data());
}
bool same(const lr::BatchPairs& pairs, const Model& model, const std::vector<uint32_t>& slots) {
    bool equal = pairs.any() == !model.empty() && pairs.count() == model.size();
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
                pairs.meets(a) == !expected.empty();
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
            // What is written can be read back.
            const std::vector<lr::BatchPairs::Pair> saved = all_of(pairs);
            lr::BatchPairs other;
            equal = equal && lr::BatchPairs::consistent(bytes_of(saved), pairs.count(), lr::max_batches);
            equal = equal && other.fill(allocator, bytes_of(saved), pairs.count()) && same(other, model, slots);
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
    CHECK(refused == 1); // the buffer grows once, then there is memory again
    CHECK(same(pairs, model, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19}));
}

TEST_CASE("pairs out of order, twice, or of slots that there are not cannot be filled in") {
    using Pairs = std::vector<lr::BatchPairs::Pair>;
    const auto consistent = [](const Pairs& p) {
        return lr::BatchPairs::consistent(bytes_of(p), static_cast<uint32_t>(p.size()), 4);
    };
    for (const Pairs& good : {Pairs{}, Pairs{{0, 0}}, Pairs{{0, 3}, {1, 1}, {1, 2}, {3, 3}}}) CHECK(consistent(good));
    for (const Pairs& bad : {Pairs{{1, 0}}, Pairs{{0, 4}}, Pairs{{4, 4}}, Pairs{{0, 1}, {0, 1}}, Pairs{{0, 2}, {0, 1}},
                             Pairs{{1, 1}, {0, 2}}, Pairs{{0, 0xffffffffu}}, Pairs{{0xffffffffu, 0xffffffffu}}})
        CHECK(!consistent(bad));
}
