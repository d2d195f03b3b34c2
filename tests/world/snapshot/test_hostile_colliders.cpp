// Like test_hostile_snapshot.cpp, for colliders: changed and resealed snapshots.
#include "support/colliders.h"
#include "support/quick.h"
#include "support/reseal_snapshot.h"
#include "world/snapshot/snapshot_format.h"

using namespace test;

namespace {

struct Scene {
    std::vector<float> corners = tetrahedron(0.5f), heights = std::vector<float>(9, 0.1f);
    Triangles sheet = bumpy_sheet(4, 2);
    World world = make(world_desc());
    std::vector<lr_collider> ids;

    Scene() {
        const lr_collider_desc descs[] = {sphere_collider(0.1f),
                                          collider_desc(LR_COLLIDER_PLANE),
                                          box_collider(1.0f, 1.0f, 1.0f),
                                          hull_collider(corners),
                                          heightfield_collider(heights, 3, 1.0f),
                                          mesh_collider(sheet),
                                          sphere_collider(0.2f),
                                          sphere_collider(0.3f)};
        for (const lr_collider_desc& d : descs) ids.push_back(add_collider(world, d));
        REQUIRE(lr_collider_destroy(world.get(), &ids[6], 1) == LR_OK);
        REQUIRE(lr_collider_destroy(world.get(), &ids[0], 1) == LR_OK);
        lr_collider_motion m = motion_of(ids[5], LR_MOVE_VELOCITY);
        m.angular_velocity[0] = 3.0f;
        REQUIRE(lr_collider_move(world.get(), &m, 1) == LR_OK);
        steps(world, 2, 0.01f);
        m = motion_of(ids[3], LR_MOVE_TO);
        REQUIRE(lr_collider_move(world.get(), &m, 1) == LR_OK);
    }
};

void exercise(const Scene& scene) {
    lr_world* const w = scene.world.get();
    lr_world_step(w, 0.01f, 1);
    lr_collider_state s = initialised(lr_collider_state_init);
    const lr_collider_desc ball = sphere_collider(0.1f), mesh = mesh_collider(scene.sheet);
    std::vector<lr_collider> spawned(12);
    for (lr_collider& id : spawned) lr_collider_create(w, &id - spawned.data() < 6 ? &ball : &mesh, 1, &id);
    for (lr_collider id : scene.ids) {
        lr_collider_get_state(w, id, &s);
        const lr_collider_motion m = motion_of(id, LR_MOVE_TO);
        lr_collider_move(w, &m, 1);
    }
    lr_world_step(w, 0.01f, 1);
    for (lr_collider id : scene.ids) lr_collider_destroy(w, &id, 1);
    lr_collider_destroy(w, spawned.data(), 12);
    lr_world_step(w, 0.01f, 1);
    uint64_t hash = 0;
    lr_world_hash(w, &hash);
}

} // namespace

TEST_CASE("changed colliders in a snapshot are refused, or restore a world that works" * doctest::test_suite("long")) {
    const std::vector<unsigned char> good = snapshot_of(Scene().world);
    const size_t plain = snapshot_of(make(world_desc())).size();
    REQUIRE(good.size() > plain + 6 * 136);
    Random random(21);
    const int rounds = quick() ? 1500 : 6000;
    int restored = 0, refused = 0;
    for (int round = 0; round < rounds; ++round) {
        std::vector<unsigned char> bytes = good;
        for (uint32_t n = 1 + random.below(2); n > 0; --n) {
            // Colliders come last in a world without batches.
            const auto words = static_cast<uint32_t>((good.size() - plain + 16) / 4);
            const size_t at = bytes.size() - 4 * (1 + random.below(words));
            const uint32_t candidates[] = {0,           1,           2,           5,
                                           6,           7,           8,           0xffffffffu,
                                           0xfffffffeu, 0x04000000u, 0x7fc00000u, 0x7f800000u,
                                           0x7f7fffffu, 0x3f800000u, 0xbf800000u, static_cast<uint32_t>(random.bits())};
            const uint32_t word = candidates[random.below(16)];
            std::memcpy(bytes.data() + at, &word, 4);
        }
        seal(bytes);
        const Scene scene;
        const std::vector<unsigned char> before = snapshot_of(scene.world);
        const lr_status status = lr_world_snapshot_restore(scene.world.get(), bytes.data(), bytes.size());
        if (status == LR_OK) {
            ++restored;
        } else {
            ++refused;
            if (snapshot_of(scene.world) != before) FAIL("a refused snapshot changed the world");
            if (status != LR_ERROR_SNAPSHOT_FORMAT && status != LR_ERROR_SNAPSHOT_MISMATCH) FAIL("status ", status);
        }
        exercise(scene);
    }
    CHECK(restored > 100);
    CHECK(refused > 100);
}

TEST_CASE("a queue of free colliders that is not one of all of them is refused") {
    const Scene scene;
    const std::vector<unsigned char> good = snapshot_of(scene.world);
    // 6 and 0 are free, in this order.
    const size_t list = offsetof(lr::SnapshotHeader, colliders), slots = good.size() - 6 * 136 - 8 * 8;
    const auto word_at = [&](size_t at) {
        uint32_t word = 0;
        std::memcpy(&word, good.data() + at, 4);
        return word;
    };
    REQUIRE((word_at(list) == 8 && word_at(list + 4) == 6 && word_at(list + 8) == 6 && word_at(list + 12) == 0));
    REQUIRE((word_at(slots + 8 * 6 + 4) == 0 && word_at(slots + 4) == 0xffffffffu));
    const struct {
        size_t at;
        uint32_t word;
    } forgeries[] = {
        {slots + 8 * 6 + 4, 6},           // points to itself
        {slots + 4, 6},                   // points back
        {slots + 8 * 6 + 4, 0xffffffffu}, // ends too early
        {slots + 8 * 6 + 4, 3},           // points to a used slot
        {slots + 8 * 6 + 4, 8},           // points outside
        {list + 8, 0},                    // leaves one out
        {list + 12, 6},                   // ends elsewhere
        {slots + 8 * 2 + 4, 0},           // one more free slot
        {list + 4, 5},                    // one used slot less
        {list, 9},
    };
    for (const auto& forged : forgeries) {
        CAPTURE(forged.at);
        CAPTURE(forged.word);
        std::vector<unsigned char> bytes = good;
        std::memcpy(bytes.data() + forged.at, &forged.word, 4);
        seal(bytes);
        CHECK(lr_world_snapshot_restore(scene.world.get(), bytes.data(), bytes.size()) == LR_ERROR_SNAPSHOT_FORMAT);
    }
}
