// All values at the API's limits: bodies stay finite, or are reported as diverged and held.
// docs/reference/bodies.md; LR_HOSTILE_WORLDS=from:to runs these seeds.
#include "support/hostile_world.h"
#include "support/quick.h"
#include "support/threads.h"

#include <cstdio>
#include <cstdlib>

using namespace test;

namespace {

struct Seeds {
    uint64_t from, to;
};
Seeds seeds() {
    Seeds s{1, quick() ? 10u : 40u};
    unsigned long long from = 0, to = 0;
    if (const char* const asked = std::getenv("LR_HOSTILE_WORLDS"))
        if (std::sscanf(asked, "%llu:%llu", &from, &to) == 2) s = {from, to};
    return s;
}

uint64_t played(uint64_t seed, const HostileWorld::How& how, uint64_t& faults) {
    HostileWorld hostile(seed, how);
    uint64_t hash = 0;
    for (int frame = 0; frame < HostileWorld::frames; ++frame) {
        CAPTURE(frame);
        hostile.step(frame);
        hash = hash * 31 + hash_of(hostile.world);
    }
    faults = hostile.faults();
    return hash;
}

} // namespace

TEST_CASE("in a world of extreme values bodies are within limits, on every instruction set alike, also through a "
          "snapshot" *
          doctest::test_suite("native")) {
    const std::vector<int32_t> targets = simd_targets();
    const Seeds range = seeds();
    uint64_t all = 0, with = 0;
    for (uint64_t seed = range.from; seed <= range.to; ++seed) {
        CAPTURE(seed);
        uint64_t faults = 0, again = 0;
        const uint64_t hash = played(seed, {}, faults);
        all += faults;
        with += faults != 0 ? 1 : 0;
        HostileWorld::How how;
        how.simd = targets[seed % targets.size()];
        CHECK(played(seed, how, again) == hash);
        how.simd = targets.back();
        how.workers = LR_TEST_THREADS ? 2 : 0;
        how.through_snapshot = static_cast<int>(seed % HostileWorld::frames);
        CHECK(played(seed, how, again) == hash);
        CHECK(again == faults);
    }
    MESSAGE(all, " bodies have left physics in ", with, " of ", range.to - range.from + 1, " worlds");
    CHECK(with > (range.to - range.from) / 10);
}
