// Every lane of every batch is stepped once, in pieces with cuts that no two threads share. If few bodies are left for the last
// lanes, the narrow target steps them, and no lanes behind them.
#include "world/schedule/step_chunks.h"

#include "support/scene.h"
#include "world/world.h"

#include <algorithm>
#include <map>
#include <utility>

using namespace lr;

namespace {

std::map<const float*, std::vector<std::pair<size_t, size_t>>> pieces; // by a batch's first array

void record(const StepInput&, const BatchArrays& a, size_t begin, size_t end) {
    pieces[a.field[0]].emplace_back(begin, end);
}

void check(const std::vector<uint32_t>& counts, uint32_t substeps, uint32_t helpers, bool narrow = false) {
    const test::Asset asset = test::leaf();
    const test::World world = test::make(test::world_desc());
    std::vector<StepItem> items;
    uint64_t blocks = 0;
    for (uint32_t count : counts) {
        const lr_batch handle = test::add_batch(world, asset, count);
        const std::vector<lr_body_desc> bodies(count, test::body_desc());
        REQUIRE(lr_body_create(world.get(), handle, bodies.data(), count, nullptr) == LR_OK);
        Batch* const batch = world->find(handle);
        items.push_back({batch, handle, blocks});
        blocks += batch->padded_count() / lane_block;
    }
    KernelTarget recorder = *world->target;
    recorder.splitting = recorder.aerodynamic = &record;
    const KernelTarget* const real = std::exchange(world->target, &recorder);
    world->narrow = narrow ? &recorder : nullptr;
    StepChunks chunks(*world, items.data(), static_cast<uint32_t>(items.size()), blocks, substeps, substeps, helpers);
    CHECK(chunks.helpers() <= helpers);
    CHECK((chunks.helpers() != 0 || chunks.count() == 1));
    pieces.clear();
    for (uint32_t i = chunks.count(); i-- > 0;) chunks.run(i);
    world->target = real;
    for (const StepItem& item : items) {
        auto& got = pieces[item.batch->arrays().field[0]];
        std::sort(got.begin(), got.end());
        size_t at = 0;
        for (const auto& [begin, end] : got) {
            CHECK(begin == at);
            CHECK(begin < end);
            const bool few = narrow && end - begin == narrow_lanes && begin % lane_block == 0;
            CHECK((end % cut_bodies == 0 || end == item.batch->padded_count() || few ||
                   (narrow && end % lane_block == 0)));
            at = end;
        }
        const uint32_t count = item.batch->count(), rest = count % lane_block;
        if (narrow && rest > 0 && rest <= narrow_lanes)
            CHECK(at == count - rest + narrow_lanes);
        else
            CHECK(at == item.batch->padded_count());
    }
}

} // namespace

TEST_CASE("chunks cover batches of any sizes, for any number of helpers") {
    const std::vector<std::vector<uint32_t>> worlds = {{1},          {16, 1},      {255, 256, 257},           {5000},
                                                       {1, 5000, 1}, {4096, 4096}, {20001, 300, 17, 40000, 1}};
    for (const auto& counts : worlds)
        for (uint32_t substeps : {1u, 4u, 65536u})
            for (uint32_t helpers : {0u, 1u, 5u, 64u}) {
                CAPTURE(counts.size());
                CAPTURE(counts[0]);
                CAPTURE(substeps);
                CAPTURE(helpers);
                check(counts, substeps, helpers);
                check(counts, substeps, helpers, true);
            }
    std::vector<uint32_t> many;
    for (uint32_t i = 0; i < 1000; ++i) many.push_back(1 + i % 33);
    check(many, 4, 3);
    check(many, 1, 0);
    check(many, 1, 0, true);
}
