// Snapshots of a heap while it lands: the pairs of touching bodies are state.
#include "body_contact/pair_cache.h"
#include "support/body_contact.h"
#include "support/random.h"
#include "support/reseal_snapshot.h"

#include <cstring>

using namespace test;

namespace {

constexpr uint32_t cards = 40;

struct Heap {
    Asset asset = make(rigid_box(0.05, 0.0006, 0.035, 600.0));
    World world = make(world_desc());
    lr_batch batch = add_batch(world, unloaded(), asset, cards);

    explicit Heap(bool full) {
        set_contact(world, batch, contact_desc(0.5f, 0.0f, 0.05f));
        set_pair(world, batch, batch);
        add_collider(world, collider_desc(LR_COLLIDER_PLANE));
        Random random(8);
        for (uint32_t i = 0; i < cards && full; ++i) {
            const double x = random.uniform(-0.03, 0.03), z = random.uniform(-0.03, 0.03);
            add_body(world, batch, turned_anyhow(random, {x, 0.05 + 0.006 * i, z}));
        }
    }
    lr_status restore(const std::vector<unsigned char>& bytes) const {
        return lr_world_snapshot_restore(world.get(), bytes.data(), bytes.size());
    }
    void step(int count) const { steps(world, count, 1.0f / 60.0f, 2); }
};

// The world's header has 120 bytes, the last 8 of which count the pairs.
constexpr size_t count_at = 112, pair_bytes = sizeof(lr::CachedPair);
// Two pairs of batch 0 follow each other: their keys are below 2^32, and their normals of unit length.
bool pair_at(const std::vector<unsigned char>& bytes, size_t at) {
    lr::CachedPair pair;
    std::memcpy(&pair, bytes.data() + at, sizeof pair);
    const float unit = lr::length(pair.normal.times(1.0f));
    return pair.a < pair.b && pair.b < uint64_t{1} << 32 && std::abs(unit - 1.0f) < 1e-4f;
}
size_t first_pair(const std::vector<unsigned char>& bytes) {
    for (size_t at = 752; at + 2 * pair_bytes < bytes.size(); at += 8)
        if (pair_at(bytes, at) && pair_at(bytes, at + pair_bytes)) return at;
    return 0;
}
uint64_t pair_count(const std::vector<unsigned char>& bytes) {
    uint64_t count = 0;
    std::memcpy(&count, bytes.data() + count_at, sizeof count);
    return count;
}

} // namespace

TEST_CASE("a heap that is restored half-way through its landing goes on with the same bits") {
    const Heap first(true), second(false), third(true);
    first.step(25);
    const std::vector<unsigned char> half = snapshot_of(first.world);
    CHECK(pair_count(half) > cards / 2);
    first.step(40);
    REQUIRE(second.restore(half) == LR_OK);
    CHECK(snapshot_of(second.world) == half);
    second.step(40);
    CHECK(hash_of(second.world) == hash_of(first.world));
    third.step(90);
    REQUIRE(third.restore(half) == LR_OK);
    third.step(40);
    CHECK(hash_of(third.world) == hash_of(first.world));
    CHECK(snapshot_of(third.world) == snapshot_of(first.world));
}

TEST_CASE("the hash tells heaps apart that differ in kept impulses alone") {
    const Heap heap(true);
    heap.step(40);
    std::vector<unsigned char> bytes = snapshot_of(heap.world);
    const uint64_t before = hash_of(heap.world);
    const size_t at = first_pair(bytes);
    REQUIRE(at != 0);
    lr::CachedPair pair;
    std::memcpy(&pair, bytes.data() + at, sizeof pair);
    pair.pressed[0] += 1.0f;
    std::memcpy(bytes.data() + at, &pair, sizeof pair);
    seal(bytes);
    REQUIRE(heap.restore(bytes) == LR_OK);
    CHECK(hash_of(heap.world) != before);
}

TEST_CASE("forged pairs are refused, or fall as bodies do") {
    const Heap heap(true);
    heap.step(30);
    const std::vector<unsigned char> good = snapshot_of(heap.world);
    const size_t at = first_pair(good);
    REQUIRE(at != 0);
    Random random(9);
    uint32_t refused = 0, taken = 0;
    for (int i = 0; i < 400; ++i) {
        std::vector<unsigned char> bytes = good;
        const size_t word = at + 4 * size_t{random.below(static_cast<uint32_t>(pair_bytes * 4 / 4))};
        const uint32_t forged = random.below(3) == 0 ? 0x7fc00000u : random.below(UINT32_MAX);
        std::memcpy(bytes.data() + word, &forged, 4);
        seal(bytes);
        const lr_status status = heap.restore(bytes);
        REQUIRE((status == LR_OK || status == LR_ERROR_SNAPSHOT_FORMAT));
        if (status != LR_OK) {
            ++refused;
            continue;
        }
        ++taken;
        heap.step(3);
        const lr_batch_view v = view_of(heap.world, heap.batch);
        for (uint32_t n = 0; n < v.count; ++n)
            for (const float* row : v.position) CHECK(std::abs(row[n]) < 1e6f);
    }
    CHECK(refused > 50);
    CHECK(taken > 50);
    for (uint64_t count : {uint64_t{0}, pair_count(good) + 1, uint64_t{1} << 62, ~uint64_t{0}}) {
        std::vector<unsigned char> bytes = good;
        std::memcpy(bytes.data() + count_at, &count, sizeof count);
        seal(bytes);
        CHECK(heap.restore(bytes) == LR_ERROR_SNAPSHOT_FORMAT);
    }
}
