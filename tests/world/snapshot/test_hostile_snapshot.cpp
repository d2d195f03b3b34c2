// Changed and resealed snapshots: the checksum is no secret. Each is refused, or leaves a usable world; AddressSanitizer
// watches.
#include "support/quick.h"
#include "support/random.h"
#include "support/reseal_snapshot.h"
#include "support/scene.h"

#include <algorithm>

using namespace test;

namespace {

struct Scene {
    Asset asset = leaf();
    World world = make(world_desc());
    lr_batch batch{};
    std::vector<lr_body> ids;
    Scene() {
        batch = add_batch(world, asset, 12);
        for (int i = 0; i < 7; ++i) ids.push_back(add_body(world, batch, body_desc()));
        REQUIRE(lr_body_destroy(world.get(), &ids[2], 1) == LR_OK);
        set_constant_table(world, batch, 3.0, 0.1, 2.0);
        REQUIRE(lr_batch_set_rate(world.get(), batch, 4) == LR_OK);
        steps(world, 2, 0.01f);
    }
};

// Uses all operations that follow ids, slots and free slots.
void exercise(const World& world, lr_batch batch, const std::vector<lr_body>& ids) {
    lr_world* const w = world.get();
    lr_world_step(w, 0.01f, 2);
    lr_body_state s = body_state();
    for (lr_body id : ids) lr_body_get_state(w, id, &s);
    std::vector<lr_body> spawned;
    lr_body_desc d = body_desc();
    lr_body id{};
    for (int round = 0; round < 2; ++round) {
        while (lr_body_create(w, batch, &d, 1, &id) == LR_OK && spawned.size() < 40) spawned.push_back(id);
        uint64_t hash = 0;
        lr_world_hash(w, &hash);
        for (lr_body b : spawned) lr_body_destroy(w, &b, 1);
        for (lr_body b : ids) lr_body_destroy(w, &b, 1);
        spawned.clear();
    }
    lr_batch_view view = initialised(lr_batch_view_init);
    if (lr_batch_get_view(w, batch, &view) == LR_OK)
        for (uint32_t i = 0; i < view.count; ++i) lr_body_get_state(w, view.ids[i], &s);
    std::vector<unsigned char> again(lr_world_snapshot_size(w));
    lr_world_snapshot_save(w, again.data(), again.size(), nullptr);
    lr_world_step(w, 0.01f, 1);
    lr_batch_destroy(w, batch);
    lr_batch_desc bd = batch_desc();
    bd.asset = nullptr;
    lr_batch_create(w, &bd, &batch);
}

} // namespace

TEST_CASE("the test's seal is the library's") {
    const Scene scene;
    std::vector<unsigned char> bytes = snapshot_of(scene.world);
    const std::vector<unsigned char> good = bytes;
    seal(bytes);
    CHECK(bytes == good);
}

TEST_CASE("a snapshot that was changed and sealed is refused, or restores a world that works") {
    const std::vector<unsigned char> good = snapshot_of(Scene().world);
    Random random(15);
    const int rounds = quick() ? 1500 : 6000;
    int restored = 0, refused = 0;
    for (int round = 0; round < rounds; ++round) {
        std::vector<unsigned char> bytes = good;
        for (uint32_t n = 1 + random.below(3); n > 0; --n) {
            const size_t at = 4 * random.below(static_cast<uint32_t>(bytes.size() / 4));
            const uint32_t words[] = {0,           1,           2,           5,
                                      11,          12,          0xffffffffu, 0x04000000u,
                                      0x00ffffffu, 0x01000000u, 0x7fc00000u, static_cast<uint32_t>(random.bits())};
            const uint32_t word = words[random.below(12)];
            std::memcpy(bytes.data() + at, &word, 4);
        }
        seal(bytes);
        const Scene scene;
        const uint64_t before = hash_of(scene.world);
        const lr_status status = lr_world_snapshot_restore(scene.world.get(), bytes.data(), bytes.size());
        if (status == LR_OK) {
            ++restored;
        } else {
            ++refused;
            if (hash_of(scene.world) != before) FAIL("a refused snapshot changed the world");
            if (status != LR_ERROR_SNAPSHOT_FORMAT && status != LR_ERROR_SNAPSHOT_MISMATCH) FAIL("status ", status);
        }
        exercise(scene.world, scene.batch, scene.ids);
    }
    CHECK(restored > 100);
    CHECK(refused > 100);
}

// Two bodies must never share a slot, because an id would name both; and none must be lost.
TEST_CASE("a queue of free slots that is not one of all of them is refused") {
    const Scene scene;
    const std::vector<unsigned char> good = snapshot_of(scene.world);
    // One table sample, padded to 8 bytes, twice; before it 12 generations, and before those each slot's contents: free slots are
    // 7, 8, 9, 10, 11, 2, in this order.
    const size_t slots = good.size() - 16 - 4 * 12 - 4 * 12;
    const auto next_of = [&](const std::vector<unsigned char>& bytes, size_t slot) {
        uint32_t word = 0;
        std::memcpy(&word, bytes.data() + slots + 4 * slot, 4);
        return word;
    };
    constexpr uint32_t free_bit = 1u << 31;
    REQUIRE(next_of(good, 7) == (free_bit | 8));
    REQUIRE(next_of(good, 11) == (free_bit | 2));
    const struct {
        size_t slot;
        uint32_t next;
    } forgeries[] = {
        {8, 7},                      // points back
        {8, 8},                      // points to itself
        {7, 9},                      // leaves one out
        {9, 2},                      // reaches the last too early
        {11, 3},                     // points to a slot with a body
        {10, 12}, {10, 0x7fffffffu}, // points outside
    };
    for (const auto& forged : forgeries) {
        CAPTURE(forged.slot);
        CAPTURE(forged.next);
        std::vector<unsigned char> bytes = good;
        const uint32_t word = free_bit | forged.next;
        std::memcpy(bytes.data() + slots + 4 * forged.slot, &word, 4);
        seal(bytes);
        CHECK(lr_world_snapshot_restore(scene.world.get(), bytes.data(), bytes.size()) == LR_ERROR_SNAPSHOT_FORMAT);
    }
    std::vector<unsigned char> same = good;
    seal(same);
    CHECK(lr_world_snapshot_restore(scene.world.get(), same.data(), same.size()) == LR_OK);
}

// The next batch in its slot would begin with generation 0, and with a body whose id is 0.
TEST_CASE("a generation beyond the last is refused") {
    const Scene scene;
    std::vector<unsigned char> bytes = snapshot_of(scene.world);
    // The header of the first batch follows the 120 bytes of the world, 296 of the wind, 344 of the water and 16 for no colliders;
    // its generations are at 24 and 28.
    for (size_t at : {size_t{776 + 24}, size_t{776 + 28}}) {
        uint32_t generation = 0;
        std::memcpy(&generation, bytes.data() + at, 4);
        REQUIRE((generation == 1 || generation == 2));
        const uint32_t forged = UINT32_MAX;
        std::memcpy(bytes.data() + at, &forged, 4);
        seal(bytes);
        CHECK(lr_world_snapshot_restore(scene.world.get(), bytes.data(), bytes.size()) == LR_ERROR_SNAPSHOT_FORMAT);
        std::memcpy(bytes.data() + at, &generation, 4);
    }
}
