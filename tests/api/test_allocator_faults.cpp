// Failing allocations, at any point of a scenario with every call that can allocate: docs/maintainers/testing.md.
#include "support/allocating_scenario.h"
#include "support/counting_memory.h"

#include <optional>

using namespace test;

namespace {

// Sanitizers test only some of them: each run takes them a tenth of a second.
const uint64_t thinned = counts_global ? 1 : 5;

// The observable state of a world.
struct Seen {
    uint64_t hash = 0;
    lr_world_info info{};
    std::vector<unsigned char> snapshot;
    std::vector<lr_ray_hit> hits;
    uint32_t events = 0;
    uint64_t events_lost = 0;
};

Seen look(lr_world* world) {
    Seen seen;
    seen.info = initialised(lr_world_info_init);
    REQUIRE(lr_world_hash(world, &seen.hash) == LR_OK);
    REQUIRE(lr_world_get_info(world, &seen.info) == LR_OK);
    seen.snapshot.resize(lr_world_snapshot_size(world));
    REQUIRE(lr_world_snapshot_save(world, seen.snapshot.data(), seen.snapshot.size(), nullptr) == LR_OK);
    std::vector<lr_ray> rays(12, initialised(lr_ray_init));
    for (size_t i = 0; i < rays.size(); ++i) {
        rays[i].origin[0] = -1.0f + 0.3f * static_cast<float>(i);
        rays[i].origin[1] = 9.0f;
        rays[i].origin[2] = -1.0f * static_cast<float>(i);
    }
    seen.hits.resize(rays.size());
    REQUIRE(lr_world_ray_cast(world, rays.data(), static_cast<uint32_t>(rays.size()), seen.hits.data()) == LR_OK);
    lr_event_list list = initialised(lr_event_list_init);
    REQUIRE(lr_world_get_events(world, &list) == LR_OK);
    seen.events = list.count;
    seen.events_lost = list.total_lost;
    return seen;
}

void check_same(const Seen& a, const Seen& b) {
    CHECK(a.hash == b.hash);
    CHECK(a.snapshot == b.snapshot);
    CHECK(std::memcmp(a.hits.data(), b.hits.data(), a.hits.size() * sizeof(lr_ray_hit)) == 0);
    CHECK(a.events == b.events);
    CHECK(a.events_lost == b.events_lost);
    lr_world_info i = a.info;
    i.memory_bytes = b.info.memory_bytes; // memory allocated before the failure is kept for the next try
    CHECK(std::memcmp(&i, &b.info, sizeof i) == 0);
}

// From a run without faults: the number of allocations before each call, and the worlds' hashes after it.
struct Golden {
    std::vector<uint64_t> begins, taken; // before and in each call
    std::vector<uint64_t> hashes[2];
    uint64_t total = 0;
};

uint64_t hash_or_zero(const lr_world* world) {
    uint64_t hash = 0;
    if (world) lr_world_hash(world, &hash);
    return hash;
}

template <class Count> Golden golden_run(const WholeScenario::Kit& kit, CountingAllocator& memory, const Count& count) {
    Golden g;
    {
        WholeScenario s(kit, memory.callbacks());
        const uint64_t since = count();
        for (size_t call = 0; call < s.size(); ++call) {
            g.begins.push_back(count() - since);
            const uint64_t before = count();
            const lr_status status = s.run(call);
            g.taken.push_back(count() - before);
            g.total = count() - since;
            REQUIRE_MESSAGE(status == LR_OK, s.name(call), ": ", lr_status_string(status));
            for (uint32_t w : {0u, 1u}) g.hashes[w].push_back(hash_or_zero(s.world(w)));
        }
        CHECK(s.warnings() == 0);
    }
    CHECK(memory.live() == 0);
    CHECK_FALSE(memory.mismatch);
    return g;
}

// A call with a failed allocation. Runs it again with memory, and compares with the run without faults.
void after_fault(WholeScenario& s, size_t call, lr_status status, const std::optional<Seen> (&before)[2]) {
    CHECK_MESSAGE(status == LR_ERROR_OUT_OF_MEMORY, lr_status_string(status));
    for (uint32_t w : {0u, 1u})
        if (s.world(w) && before[w]) check_same(*before[w], look(s.world(w)));
    if (s.creates_world(call)) CHECK(s.world(static_cast<uint32_t>(call)) == nullptr);
    CHECK(s.run(call) == LR_OK);
}

uint32_t small(uint64_t& state) { // xorshift
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return static_cast<uint32_t>(state >> 40);
}

} // namespace

TEST_CASE("memory that fails at the n-th allocation of all, for every n: out of memory, nothing changes, and then all "
          "is well" *
          doctest::test_suite("long")) {
    const WholeScenario::Kit kit;
    CountingAllocator counted;
    const Golden golden = golden_run(kit, counted, [&] { return counted.calls; });
    REQUIRE(golden.total > 250);
    uint32_t weaker_steps = 0;
    for (uint64_t n = 0; n < golden.total; n += thinned) {
        CAPTURE(n);
        const bool after = n % 2 != 0;
        CountingAllocator memory;
        {
            WholeScenario s(kit, memory.callbacks());
            size_t call = 0;
            while (call + 1 < s.size() && golden.begins[call + 1] <= n) REQUIRE(s.run(call++) == LR_OK);
            CAPTURE(s.name(call));
            std::optional<Seen> before[2];
            for (uint32_t w : {0u, 1u})
                if (s.world(w)) before[w] = look(s.world(w));
            memory.fail_at = n;
            memory.fail_after = after;
            const lr_status status = s.run(call);
            memory.fail_at = CountingAllocator::never;
            CHECK(memory.calls > n);
            const bool taken = s.steps(call); // the step was taken nevertheless
            if (taken) {
                CHECK(status == LR_ERROR_OUT_OF_MEMORY);
                ++weaker_steps;
            } else {
                after_fault(s, call, status, before);
                for (uint32_t w : {0u, 1u}) CHECK(hash_or_zero(s.world(w)) == golden.hashes[w][call]);
            }
            CHECK(s.warnings() == 0);
            while (++call < s.size()) {
                const lr_status later = s.run(call);
                CHECK_MESSAGE(later == LR_OK, s.name(call));
            }
            if (!taken)
                for (uint32_t w : {0u, 1u}) CHECK(hash_or_zero(s.world(w)) == golden.hashes[w].back());
            uint64_t bytes = 0;
            for (uint32_t w : {0u, 1u}) bytes += look(s.world(w)).info.memory_bytes;
            CHECK(bytes == memory.bytes);
        }
        CHECK(memory.live() == 0);
        CHECK(memory.bytes == 0);
        CHECK_FALSE(memory.mismatch);
    }
    CHECK(weaker_steps > 20 / thinned);
}

TEST_CASE("memory that fails one time in ten: each call succeeds in the end, and the end is the same" *
          doctest::test_suite("long")) {
    const WholeScenario::Kit kit;
    CountingAllocator counted;
    const Golden golden = golden_run(kit, counted, [&] { return counted.calls; });
    for (uint64_t seed = 1; seed <= 60 / thinned; ++seed) {
        CAPTURE(seed);
        uint64_t state = seed * 0x9e3779b97f4a7c15ull;
        CountingAllocator memory;
        uint32_t faults = 0;
        {
            WholeScenario s(kit, memory.callbacks());
            for (size_t call = 0; call < s.size(); ++call) {
                CAPTURE(s.name(call));
                lr_status status = LR_ERROR_OUT_OF_MEMORY;
                for (int tries = 0; tries < 10000 && status == LR_ERROR_OUT_OF_MEMORY; ++tries) {
                    // Steps have enough memory here: otherwise they would end in another state.
                    uint64_t next = memory.calls;
                    while (small(state) % 10 != 0) ++next;
                    memory.fail_at = s.steps(call) ? CountingAllocator::never : next;
                    const uint64_t before[2] = {hash_or_zero(s.world(0)), hash_or_zero(s.world(1))};
                    status = s.run(call);
                    memory.fail_at = CountingAllocator::never;
                    if (status == LR_OK) continue;
                    ++faults;
                    for (uint32_t w : {0u, 1u}) CHECK(hash_or_zero(s.world(w)) == before[w]);
                }
                REQUIRE(status == LR_OK);
                for (uint32_t w : {0u, 1u}) CHECK(hash_or_zero(s.world(w)) == golden.hashes[w][call]);
            }
        }
        CHECK(faults > 5);
        CHECK(memory.live() == 0);
        CHECK_FALSE(memory.mismatch);
    }
}

// Hulls, meshes and shapes of bodies use the C++ library's memory. A hull takes thousands of allocations: each of a call's first
// allocations fails in turn, later ones ever more rarely.
TEST_CASE("operator new that throws at its n-th call: the same" * doctest::test_suite("long") *
          doctest::skip(!counts_global)) {
    const WholeScenario::Kit kit;
    CountingAllocator counted;
    const Golden golden = golden_run(kit, counted, [] { return global_allocations.load(); });
    uint32_t faults = 0;
    for (size_t failing = 0; failing < golden.taken.size(); ++failing)
        for (uint64_t n = 0; n < golden.taken[failing]; n += 1 + n / 8, ++faults) {
            CAPTURE(n);
            CountingAllocator memory;
            {
                WholeScenario s(kit, memory.callbacks());
                size_t call = 0;
                while (call < failing) REQUIRE(s.run(call++) == LR_OK);
                CAPTURE(s.name(call));
                std::optional<Seen> before[2];
                for (uint32_t w : {0u, 1u})
                    if (s.world(w)) before[w] = look(s.world(w));
                const uint64_t live = global_live;
                global_fail_in = n + 1;
                const lr_status status = s.run(call);
                const bool failed = global_fail_in == 0, leaked = global_live != live;
                global_fail_in = 0;
                CHECK(failed);
                CHECK_FALSE(leaked);
                after_fault(s, call, status, before);
                while (++call < s.size()) {
                    const lr_status later = s.run(call);
                    CHECK_MESSAGE(later == LR_OK, s.name(call));
                }
                for (uint32_t w : {0u, 1u}) CHECK(hash_or_zero(s.world(w)) == golden.hashes[w].back());
            }
            CHECK(memory.live() == 0);
            CHECK_FALSE(memory.mismatch);
        }
    CHECK(faults > 40);
}
