// A restore keeps equal parts of the present world: boxes of sleeping bodies, wind sources, colliders, pairs, loads. The previous
// state must not matter.
#include "support/colliders.h"
#include "support/random.h"
#include "support/scene.h"
#include "world/world.h"

#include <functional>

using namespace test;

namespace {

using Bytes = std::vector<unsigned char>;

struct Place {
    Asset asset = leaf();
    World world = make(world_desc());
    lr_batch batch{};
    std::vector<lr_body> ids;
    lr_collider ground{}, ball{};
    lr_wind_source vortex{};
    lr_vortex_desc vortex_desc = initialised(lr_vortex_desc_init);

    explicit Place(bool lived = true) {
        batch = add_batch(world, asset, 120);
        if (!lived) return;
        Random random(3);
        for (int i = 0; i < 100; ++i) {
            const auto along = [&] { return random.uniform(0.05, 0.5); };
            ids.push_back(add_body(world, batch, turned_anyhow(random, {along(), along(), along()})));
        }
        const lr_collider_desc solids[2] = {collider_desc(LR_COLLIDER_PLANE), sphere_collider(0.1f)};
        lr_collider colliders[2] = {};
        REQUIRE(lr_collider_create(world.get(), solids, 2, colliders) == LR_OK);
        ground = colliders[0], ball = colliders[1];
        vortex_desc.core = LR_VORTEX_RANKINE, vortex_desc.velocity[0] = 0.5f;
        vortex_desc.position[0] = 1000.0f; // otherwise it wakes them
        REQUIRE(lr_world_add_vortex(world.get(), &vortex_desc, &vortex) == LR_OK);
        meet(1);
        steps(world, 4, 0.016f, 2);
        rest(0, 60);
        steps(world, 1, 0.016f, 2);
    }
    void meet(int32_t on) { REQUIRE(lr_batch_set_body_contact(world.get(), batch, batch, on) == LR_OK); }
    void rest(size_t first, uint32_t count, int32_t how = LR_SLEEP_ASLEEP) {
        REQUIRE(lr_body_set_sleep(world.get(), ids.data() + first, count, how) == LR_OK);
    }
    void put(size_t body, float x) {
        lr_body_state s = state_of(world, ids[body]);
        s.position[0] = x;
        REQUIRE(lr_body_set_state(world.get(), ids[body], &s) == LR_OK);
    }
    // By slot; 0 for awake bodies.
    std::vector<lr::Box> boxes() const {
        const lr::Batch& b = *world->batches[0].batch;
        std::vector<lr::Box> out(b.capacity(), lr::Box{});
        for (uint32_t i = b.awake(); i < b.count(); ++i) {
            const uint32_t slot = lr::unpack(b.ids()[i]).slot;
            out[slot] = b.sleeping()->box(slot);
        }
        return out;
    }
    void restore(const Bytes& snapshot) const {
        REQUIRE(lr_world_snapshot_restore(world.get(), snapshot.data(), snapshot.size()) == LR_OK);
    }
};

bool same_bits(const std::vector<lr::Box>& a, const std::vector<lr::Box>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

} // namespace

TEST_CASE("a world's state before a restore does not matter, to the byte") {
    const std::pair<const char*, std::function<void(Place&)>> ways[] = {
        {"nothing", [](Place&) {}},
        {"steps", [](Place& p) { steps(p.world, 7, 0.016f, 2); }},
        {"all rest", [](Place& p) { p.rest(0, 100); }},
        {"all wake", [](Place& p) { p.rest(0, 100, LR_SLEEP_AWAKE); }},
        {"some rest elsewhere",
         [](Place& p) {
             for (size_t i = 10; i < 40; ++i) p.put(i, 2.0f + 0.1f * static_cast<float>(i));
             p.rest(0, 50);
         }},
        {"one moves, whose box is not used", [](Place& p) { p.put(20, 5.0f), p.rest(60, 40); }},
        {"none are left", [](Place& p) { REQUIRE(lr_body_destroy(p.world.get(), p.ids.data(), 100) == LR_OK); }},
        {"others are in their slots",
         [](Place& p) {
             REQUIRE(lr_body_destroy(p.world.get(), p.ids.data(), 70) == LR_OK);
             for (int round = 0; round < 2; ++round)
                 for (size_t i = 0; i < 70; ++i) {
                     lr_body_desc d = body_desc();
                     d.position[1] = 3.0f;
                     if (round == 1) REQUIRE(lr_body_destroy(p.world.get(), &p.ids[i], 1) == LR_OK);
                     p.ids[i] = add_body(p.world, p.batch, d);
                 }
             p.rest(0, 70);
         }},
        {"the same source, later",
         [](Place& p) {
             steps(p.world, 1, 0.016f, 2);
             REQUIRE(lr_world_update_vortex(p.world.get(), p.vortex, &p.vortex_desc) == LR_OK);
         }},
        {"another source",
         [](Place& p) {
             p.vortex_desc.circulation = 3.0f;
             REQUIRE(lr_world_update_vortex(p.world.get(), p.vortex, &p.vortex_desc) == LR_OK);
         }},
        {"no source, and two others",
         [](Place& p) {
             REQUIRE(lr_world_remove_wind(p.world.get(), p.vortex) == LR_OK);
             for (int i = 0; i < 2; ++i)
                 REQUIRE(lr_world_add_vortex(p.world.get(), &p.vortex_desc, &p.vortex) == LR_OK);
         }},
        {"the ball moves",
         [](Place& p) {
             lr_collider_motion m = motion_of(p.ball, LR_MOVE_TO);
             m.position[0] = 1.0f;
             REQUIRE(lr_collider_move(p.world.get(), &m, 1) == LR_OK);
             steps(p.world, 2, 0.016f, 2);
         }},
        {"no ball", [](Place& p) { REQUIRE(lr_collider_destroy(p.world.get(), &p.ball, 1) == LR_OK); }},
        {"bodies do not meet", [](Place& p) { p.meet(0); }},
        {"other loads", [](Place& p) { set_constant_table(p.world, p.batch, 30.0, 2.0, 2.0); }},
    };
    const Place lived;
    const Bytes snapshot = snapshot_of(lived.world);
    REQUIRE(info_of(lived.world).awake_count < 70);
    const auto go_on = [&](const Place& p) {
        const float low[3] = {0.0f, 0.0f, 0.0f}, high[3] = {0.3f, 0.3f, 0.3f};
        REQUIRE(lr_world_wake_box(p.world.get(), low, high, nullptr) == LR_OK);
        steps(p.world, 12, 0.016f, 2);
        return snapshot_of(p.world);
    };
    const Place fresh(false);
    fresh.restore(snapshot);
    const std::vector<lr::Box> boxes = fresh.boxes();
    const Bytes later = go_on(fresh);
    REQUIRE(same_bits(boxes, lived.boxes()));
    for (const auto& [name, change] : ways) {
        CAPTURE(name);
        Place place;
        change(place);
        place.restore(snapshot);
        CHECK(snapshot_of(place.world) == snapshot);
        CHECK(same_bits(place.boxes(), boxes));
        CHECK(go_on(place) == later);
    }
}

TEST_CASE("a world of another seed has other gusts, also where their description is the same") {
    lr_gusts_desc gusts = initialised(lr_gusts_desc_init);
    const auto with_seed = [&](uint64_t seed) {
        lr_world_desc d = world_desc();
        d.seed = seed;
        World world = make(d);
        lr_wind_source source{};
        REQUIRE(lr_world_add_gusts(world.get(), &gusts, &source) == LR_OK);
        steps(world, 8, 0.1f, 2); // they begin at 0
        return world;
    };
    const auto wind_in = [](const World& world) {
        const float at[3] = {};
        std::array<float, 3> wind{};
        REQUIRE(lr_world_sample_wind(world.get(), at, 1, wind.data()) == LR_OK);
        return wind;
    };
    const World one = with_seed(1), two = with_seed(2);
    REQUIRE(wind_in(one) != wind_in(two));
    const Bytes snapshot = snapshot_of(one);
    REQUIRE(lr_world_snapshot_restore(two.get(), snapshot.data(), snapshot.size()) == LR_OK);
    CHECK(wind_in(one) == wind_in(two));
}

// Their order decides the ids of later bodies and to whom arrays of forces belong: a recording replays both.
TEST_CASE("a restored world wakes bodies in the order of the one that was saved") {
    const auto empty = [](lr_batch& batch) {
        World world = make(world_desc());
        batch = add_batch(world, leaf(), 2000);
        return world;
    };
    lr_batch batch{}, same{};
    const World world = empty(batch);
    std::vector<lr_body_desc> descs;
    Random random(5);
    for (int i = 0; i < 2000; ++i) descs.push_back(strewn(random, 0.2));
    std::vector<lr_body> ids(2000);
    REQUIRE(lr_body_create(world.get(), batch, descs.data(), 2000, ids.data()) == LR_OK);
    lr_collider balls[3] = {};
    lr_collider_desc solids[3];
    for (int i = 0; i < 3; ++i) {
        solids[i] = sphere_collider(0.05f);
        solids[i].position[0] = 0.05f * static_cast<float>(i), solids[i].position[1] = 3.0f;
    }
    REQUIRE(lr_collider_create(world.get(), solids, 3, balls) == LR_OK);
    for (uint32_t i = 0; i < 2600; ++i) { // in an order of their own, which some leave again
        const int32_t how = i < 2000 ? LR_SLEEP_ASLEEP : LR_SLEEP_AWAKE;
        REQUIRE(lr_body_set_sleep(world.get(), &ids[i * 997 % 2000], 1, how) == LR_OK);
    }
    const auto sweep = [&](const World& in, float height, std::initializer_list<int> order) {
        for (int i : order) {
            lr_collider_motion m = initialised(lr_collider_motion_init);
            m.collider = balls[i];
            m.position[0] = 0.05f * static_cast<float>(i), m.position[1] = height;
            REQUIRE(lr_collider_move(in.get(), &m, 1) == LR_OK);
        }
        steps(in, 1, 1e-4f, 1);
    };
    steps(world, 200, 1e-5f, 1); // resting colliders go to a list of their own
    sweep(world, 2.9f, {2, 0, 1});
    const Bytes saved = snapshot_of(world);
    const World copy = empty(same);
    REQUIRE(lr_world_snapshot_restore(copy.get(), saved.data(), saved.size()) == LR_OK);
    for (const World* in : {&world, &copy}) {
        const float low[3] = {-0.02f, -0.02f, -0.02f}, high[3] = {0.02f, 0.02f, 0.02f};
        uint32_t woken = 0;
        REQUIRE(lr_world_wake_box(in->get(), low, high, &woken) == LR_OK);
        CHECK(woken > 10);
    }
    CHECK(snapshot_of(world) == snapshot_of(copy));
    for (const World* in : {&world, &copy}) sweep(*in, -0.1f, {2, 0, 1});
    lr_world_info info = initialised(lr_world_info_init);
    REQUIRE(lr_world_get_info(world.get(), &info) == LR_OK);
    CHECK(info.awake_count > 650);
    CHECK(info.awake_count < 2000);
    CHECK(snapshot_of(world) == snapshot_of(copy));
}
