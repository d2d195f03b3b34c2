// Notes on touched bodies: kept as long as contact is possible, through snapshots, and without events.
#include "collision/contact_cache.h"
#include "support/colliders.h"
#include "support/contact_events.h"
#include "support/reseal_snapshot.h"
#include "world/world.h"

#include <array>

using namespace test;

namespace {

using Touched = std::array<uint32_t, lr::most_touches>;

struct Scene {
    Asset asset = make(ellipsoid(0.02, 0.02, 0.02, 500.0));
    World world = make(world_desc());
    lr_batch batch[3];
    lr_body body[3];

    Scene() {
        for (int i = 0; i < 3; ++i) {
            batch[i] = add_batch(world, asset, 4);
            lr_body_desc d = body_desc();
            d.position[2] = static_cast<float>(i); // m: none touches another
            body[i] = add_body(world, batch[i], d);
        }
    }
    lr::Batch& at(int i) const { return *world->find(batch[i]); }
    void meet(int a, int b, bool on = true) const {
        REQUIRE(lr_batch_set_body_contact(world.get(), batch[a], batch[b], on ? 1 : 0) == LR_OK);
    }
    void touch(int i, const Touched& touched) const {
        for (size_t k = 0; k < touched.size(); ++k) at(i).contact_cache().touching[k][0] = touched[k];
    }
    Touched touched(int i) const {
        Touched t{};
        for (size_t k = 0; k < t.size(); ++k) t[k] = at(i).contact_cache().touching[k][0];
        return t;
    }
};
constexpr uint32_t other = lr::touching_body;

} // namespace

TEST_CASE("a body is known to touch others as long as its batch meets any") {
    const struct {
        Touched before, after;
    } rows[] = {{{other, 0, 0, 0}, {0, 0, 0, 0}}, {{other, 3, 7, 1}, {3, 7, 1, 0}}, {{3, other, 7, 0}, {3, 7, 0, 0}},
                {{3, 7, 1, other}, {3, 7, 1, 0}}, {{3, 7, 0, 0}, {3, 7, 0, 0}},     {{0, 0, 0, 0}, {0, 0, 0, 0}}};
    for (const auto& row : rows)
        for (bool destroy : {false, true}) {
            const Scene s;
            s.meet(0, 2);
            s.meet(1, 2);
            s.meet(1, 1);
            for (int i : {0, 1}) s.touch(i, row.before);
            if (destroy)
                REQUIRE(lr_batch_destroy(s.world.get(), s.batch[2]) == LR_OK);
            else
                for (int i : {0, 1}) s.meet(2, i, false);
            CHECK(s.touched(0) == row.after);
            CHECK(s.touched(1) == row.before); // contact within the batch
            s.meet(1, 1, false);
            CHECK(s.touched(1) == row.after);
        }
}

TEST_CASE("snapshots have that bodies touch others, once and where they may meet") {
    const Scene s;
    s.meet(0, 1);
    s.touch(0, {5, other, 0, 0});
    s.touch(1, {other, 0, 0, 0});
    const std::vector<unsigned char> good = snapshot_of(s.world);
    const Scene to;
    REQUIRE(lr_world_snapshot_restore(to.world.get(), good.data(), good.size()) == LR_OK);
    CHECK(to.touched(0) == Touched{5, other, 0, 0});
    CHECK(to.touched(1) == Touched{other, 0, 0, 0});
    CHECK(hash_of(to.world) == hash_of(s.world));
    CHECK(snapshot_of(to.world) == good);

    const auto refused = [&] {
        const Scene fresh;
        const std::vector<unsigned char> bad = snapshot_of(s.world), before = snapshot_of(fresh.world);
        CHECK(lr_world_snapshot_restore(fresh.world.get(), bad.data(), bad.size()) == LR_ERROR_SNAPSHOT_FORMAT);
        CHECK(snapshot_of(fresh.world) == before);
    };
    for (const Touched& twice : {Touched{other, other, 0, 0}, Touched{other, 2, 3, other}}) {
        s.touch(0, twice);
        refused();
    }
    s.touch(0, {0, 0, 0, 0});
    REQUIRE(s.at(2).reserve_contact());
    s.touch(2, {other, 0, 0, 0}); // no contact with these
    refused();
}

TEST_CASE("bodies that are touched begin and end nothing, and the colliders beside them as ever") {
    for (size_t place = 0; place < lr::most_touches; ++place) {
        const Scene s;
        const lr_collider plane = add_collider(s.world, collider_desc(LR_COLLIDER_PLANE));
        const lr_collider ball = add_collider(s.world, sphere_collider(0.1f)),
                          far = add_collider(s.world, sphere_collider(0.1f));
        for (const lr_collider c : {ball, far}) {
            lr_collider_motion m = motion_of(c, LR_MOVE_PLACE);
            m.position[0] = c == ball ? 5.0f : 50.0f;
            REQUIRE(lr_collider_move(s.world.get(), &m, 1) == LR_OK);
        }
        s.meet(0, 1);
        steps(s.world, 300, 1.0f / 60.0f, 2);
        REQUIRE(state_of(s.world, s.body[0]).sleep_state == LR_SLEEP_ASLEEP);
        const uint32_t on_plane = s.touched(0)[0];
        REQUIRE(lr::is_collider(on_plane));
        Touched row{on_plane, on_plane + 1, 0, 0};
        for (size_t k = row.size() - 1; k > place; --k) row[k] = row[k - 1];
        row[place] = other;
        s.touch(0, row);
        keep_events(s.world);
        steps(s.world, 1, 1.0f / 60.0f, 2);
        CHECK(events_of(s.world).empty());
        // All are compared with what they touched.
        REQUIRE(lr_collider_destroy(s.world.get(), &far, 1) == LR_OK);
        steps(s.world, 1, 1.0f / 60.0f, 2);
        CHECK(events_of(s.world).empty());
        // It rises, and leaves all that it touched: only the two colliders end, if both were among the four.
        lr_body_force push = initialised(lr_body_force_init);
        push.body = s.body[0];
        push.mode = LR_FORCE_MODE_VELOCITY;
        push.force[1] = 3.0f;
        REQUIRE(lr_body_add_force(s.world.get(), &push, 1) == LR_OK);
        steps(s.world, 1, 1.0f / 60.0f, 2);
        const std::vector<lr_event> events = events_of(s.world);
        REQUIRE(events.size() == 3);
        CHECK((events[0].kind == LR_EVENT_LIFTED && events[0].collider == plane));
        CHECK((events[1].kind == LR_EVENT_LIFTED && events[1].collider == ball));
        CHECK(events[2].kind == LR_EVENT_WOKE);
        CHECK(s.touched(0) == Touched{0, 0, 0, 0});
    }
}
