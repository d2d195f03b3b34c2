#include "base/handles.h"

#include "support/scene.h"
#include "world/batch/batch.h"

#include <set>

using namespace lr;

TEST_CASE("handles give back what was packed, and 0 is none") {
    for (uint32_t slot : {0u, 1u, max_capacity - 1})
        for (uint32_t generation : {1u, 2u, max_generation})
            for (uint32_t batch : {0u, 1u, max_batches - 1}) {
                const lr_body id = pack(BodyHandle{slot, generation, batch});
                const BodyHandle h = unpack(id);
                CHECK((h.slot == slot && h.generation == generation && h.batch == batch));
                CHECK(id.id != 0);
            }
    for (uint32_t index : {0u, max_batches - 1})
        for (uint32_t generation : {1u, max_batch_generation}) {
            const lr_batch id = pack(BatchHandle{index, generation});
            CHECK((unpack(id).index == index && unpack(id).generation == generation));
            CHECK(id.id != 0);
        }
    CHECK(next_generation(1) == 2);
    CHECK(next_generation(max_generation) == 1); // never 0: 0 is no handle
}

TEST_CASE("a slot goes on after its last generation") {
    Allocator allocator;
    const test::Asset asset = test::leaf();
    lr_status status = LR_ERROR_INTERNAL;
    Batch* const batch = Batch::create(allocator, *asset, 1, BatchSettings{}, 5, max_generation - 2, status);
    REQUIRE(batch != nullptr);
    BodyState state{};
    state.value[field_qw] = state.value[field_scale] = 1.0f;
    std::set<lr_body> seen;
    uint32_t index = 0;
    for (int life = 0; life < 6; ++life) {
        const lr_body id = batch->add(state);
        CHECK(unpack(id).generation != 0);
        CHECK(unpack(id).batch == 5);
        CHECK(seen.insert(id).second);
        CHECK(batch->find(id, index));
        batch->remove(id);
        CHECK_FALSE(batch->find(id, index));
    }
    Batch::destroy(batch);
    CHECK(allocator.bytes() == 0);
}

TEST_CASE("a freed slot rests until all others have been used") {
    Allocator allocator;
    const test::Asset asset = test::leaf();
    lr_status status = LR_ERROR_INTERNAL;
    Batch* const batch = Batch::create(allocator, *asset, 8, BatchSettings{}, 0, 1, status);
    REQUIRE(batch != nullptr);
    BodyState state{};
    std::vector<uint32_t> slots;
    for (int life = 0; life < 24; ++life) {
        const lr_body id = batch->add(state);
        slots.push_back(unpack(id).slot);
        batch->remove(id);
    }
    for (size_t i = 8; i < 24; ++i) CHECK(slots[i] == slots[i - 8]);
    CHECK(std::set<uint32_t>(slots.begin(), slots.begin() + 8).size() == 8);
    Batch::destroy(batch);
}
