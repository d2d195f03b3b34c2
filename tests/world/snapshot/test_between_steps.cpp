// Everything that calls leave for the next step is in a snapshot: a world restored from one that was saved right after a call goes on as
// the saved one does, with the same hash and the same events.
#include "support/contact_events.h"
#include "support/random.h"
#include "support/scene.h"
#include "world/world.h"

#include <functional>
#include <string>

using namespace test;

namespace {

// Bricks that fall, lie, float, are spawned and end.
struct Scene {
    Asset shape = brick();
    World world = make(world_desc());
    lr_batch bricks = add_batch(world, langevin(), shape, 60), others = add_batch(world, langevin(), shape, 30);
    std::vector<lr_body> ids;
    lr_collider ground{}, table{}, belt{};
    lr_wind_source vortex{};
    lr_vortex_desc vortex_desc = initialised(lr_vortex_desc_init);

    Scene() {
        const lr_collider_desc flat = collider_desc(LR_COLLIDER_PLANE);
        ground = add_collider(world, flat);
        lr_collider_desc top = box_collider(0.5f, 0.05f, 0.5f);
        top.position[1] = 0.3f;
        table = add_collider(world, top);
        top.position[0] = 2.0f;
        belt = add_collider(world, top);
        vortex_desc.position[0] = 1000.0f;
        REQUIRE(lr_world_add_vortex(world.get(), &vortex_desc, &vortex) == LR_OK);
        keep_events(world);
        REQUIRE(lr_batch_set_body_contact(world.get(), bricks, bricks, 1) == LR_OK);
        Random random(5);
        for (int i = 0; i < 40; ++i) {
            lr_body_desc d = turned_anyhow(
                random, {random.uniform(-0.4, 0.4), random.uniform(0.45, 0.9), random.uniform(-0.4, 0.4)});
            if (i % 4 == 3) d.position[0] += 2.0f;
            if (i % 4 == 1) d.position[0] -= 2.0f;
            ids.push_back(add_body(world, i % 2 ? others : bricks, d));
        }
        lr_batch_rules rules = initialised(lr_batch_rules_init);
        rules.max_age = 30.0f;
        REQUIRE(lr_batch_set_rules(world.get(), others, &rules) == LR_OK);
    }
    void run(int count) const { steps(world, count, 1.0f / 60.0f, 2); }
    void done(lr_status status) const { REQUIRE(status == LR_OK); }
    void destroy(lr_collider one) const { done(lr_collider_destroy(world.get(), &one, 1)); }
    void create(float height) const {
        lr_collider_desc top = box_collider(0.5f, 0.05f, 0.5f);
        top.position[1] = height;
        add_collider(world, top);
    }
    void move(lr_collider one, int32_t mode, float x, float y, float v = 0.0f) const {
        lr_collider_motion m = motion_of(one, mode);
        m.position[0] = x, m.position[1] = y, m.linear_velocity[0] = v;
        done(lr_collider_move(world.get(), &m, 1));
    }
    void push(lr_body body, float x) const {
        lr_body_force f = initialised(lr_body_force_init);
        f.body = body, f.force[0] = x;
        done(lr_body_add_force(world.get(), &f, 1));
    }
    void put(lr_body body, float y) const {
        lr_body_state s = state_of(world, body);
        s.position[1] += y;
        done(lr_body_set_state(world.get(), body, &s));
    }
    void sleep(int32_t how) const {
        done(lr_body_set_sleep(world.get(), ids.data(), static_cast<uint32_t>(ids.size()), how));
    }
    void water(float level) const {
        lr_water_desc d = initialised(lr_water_desc_init);
        d.position[1] = level;
        done(lr_world_set_water(world.get(), &d));
    }
};

const std::pair<std::string, std::function<void(Scene&)>> calls[] = {
    {"none", [](Scene&) {}},
    {"destroy table", [](Scene& s) { s.destroy(s.table); }},
    {"destroy ground", [](Scene& s) { s.destroy(s.ground); }},
    {"destroy all", [](Scene& s) { s.destroy(s.ground), s.destroy(s.table), s.destroy(s.belt); }},
    {"replace table", [](Scene& s) { s.destroy(s.table), s.create(0.3f); }},
    {"replace table twice", [](Scene& s) { s.destroy(s.table), s.create(0.3f), s.destroy(s.belt), s.create(0.3f); }},
    {"create", [](Scene& s) { s.create(0.45f); }},
    {"move to", [](Scene& s) { s.move(s.table, LR_MOVE_TO, 0.1f, 0.3f); }},
    {"place", [](Scene& s) { s.move(s.table, LR_MOVE_PLACE, 0.0f, -0.5f); }},
    {"place and back",
     [](Scene& s) { s.move(s.table, LR_MOVE_PLACE, 0.0f, -0.5f), s.move(s.table, LR_MOVE_PLACE, 0.0f, 0.3f); }},
    {"velocity", [](Scene& s) { s.move(s.belt, LR_MOVE_VELOCITY, 0.0f, 0.0f, 0.3f); }},
    {"velocity and stop",
     [](Scene& s) {
         s.move(s.belt, LR_MOVE_VELOCITY, 0.0f, 0.0f, 0.3f), s.move(s.belt, LR_MOVE_VELOCITY, 0.0f, 0.0f);
     }},
    {"layers",
     [](Scene& s) {
         lr_material m = initialised(lr_material_init);
         m.layers = 4;
         s.done(lr_collider_set_material(s.world.get(), &s.table, 1, &m));
     }},
    {"friction",
     [](Scene& s) {
         lr_material m = initialised(lr_material_init);
         m.friction = 0.0f;
         s.done(lr_collider_set_material(s.world.get(), &s.table, 1, &m));
     }},
    {"wake", [](Scene& s) { s.sleep(LR_SLEEP_AWAKE); }},
    {"sleep", [](Scene& s) { s.sleep(LR_SLEEP_ASLEEP); }},
    {"wake and sleep", [](Scene& s) { s.sleep(LR_SLEEP_AWAKE), s.sleep(LR_SLEEP_ASLEEP); }},
    {"sleep and wake", [](Scene& s) { s.sleep(LR_SLEEP_ASLEEP), s.sleep(LR_SLEEP_AWAKE); }},
    {"wake box",
     [](Scene& s) {
         const float low[3] = {-1.0f, -1.0f, -1.0f}, high[3] = {0.1f, 1.0f, 1.0f};
         s.done(lr_world_wake_box(s.world.get(), low, high, nullptr));
     }},
    {"force", [](Scene& s) { s.push(s.ids[2], 0.5f), s.push(s.ids[5], -0.5f); }},
    {"force of none", [](Scene& s) { s.push(s.ids[2], 0.0f); }},
    {"force of a batch",
     [](Scene& s) {
         lr_batch_force f = initialised(lr_batch_force_init);
         f.force[0] = 0.1f;
         s.done(lr_batch_set_force(s.world.get(), s.bricks, &f));
     }},
    {"state", [](Scene& s) { s.put(s.ids[2], 0.1f), s.put(s.ids[3], 0.1f); }},
    {"state not finite",
     [](Scene& s) {
         lr_body_state now = state_of(s.world, s.ids[2]);
         now.linear_velocity[0] = 3e30f;
         lr_body_set_state(s.world.get(), s.ids[2], &now);
     }},
    {"destroy bodies", [](Scene& s) { s.done(lr_body_destroy(s.world.get(), s.ids.data() + 4, 9)); }},
    {"create bodies", [](Scene& s) { add_body(s.world, s.others, body_desc()); }},
    {"destroy and create bodies",
     [](Scene& s) {
         s.done(lr_body_destroy(s.world.get(), s.ids.data() + 4, 9));
         for (int i = 0; i < 4; ++i) add_body(s.world, s.bricks, body_desc());
     }},
    {"spawn",
     [](Scene& s) {
         const float low[3] = {-0.2f, 0.4f, -0.2f}, high[3] = {0.2f, 0.5f, 0.2f};
         s.done(lr_batch_spawn_box(s.world.get(), s.bricks, low, high, 5, nullptr));
     }},
    {"spawn and sleep",
     [](Scene& s) {
         const float low[3] = {-0.2f, 0.4f, -0.2f}, high[3] = {0.2f, 0.5f, 0.2f};
         lr_body spawned[5];
         s.done(lr_batch_spawn_box(s.world.get(), s.bricks, low, high, 5, spawned));
         s.done(lr_body_set_sleep(s.world.get(), spawned, 5, LR_SLEEP_ASLEEP));
     }},
    {"emitter",
     [](Scene& s) {
         lr_emitter_desc d = initialised(lr_emitter_desc_init);
         d.rate = 200.0f;
         s.done(lr_batch_set_emitter(s.world.get(), s.others, &d));
         s.done(lr_batch_spawn(s.world.get(), s.others, 2, nullptr));
     }},
    {"rules",
     [](Scene& s) {
         lr_batch_rules d = initialised(lr_batch_rules_init);
         d.max_age = 0.1f;
         s.done(lr_batch_set_rules(s.world.get(), s.others, &d));
         s.done(lr_batch_set_rules(s.world.get(), s.bricks, &d));
     }},
    {"no rules", [](Scene& s) { s.done(lr_batch_set_rules(s.world.get(), s.others, nullptr)); }},
    {"policy", [](Scene& s) { s.done(lr_batch_set_divergence_policy(s.world.get(), s.others, LR_DIVERGENCE_REMOVE)); }},
    {"wind", [](Scene& s) { s.done(lr_world_set_uniform_wind(s.world.get(), 8.0f, 0.0f, 0.0f)); }},
    {"wind and back",
     [](Scene& s) {
         s.done(lr_world_set_uniform_wind(s.world.get(), 8.0f, 0.0f, 0.0f));
         s.done(lr_world_set_uniform_wind(s.world.get(), 0.0f, 0.0f, 0.0f));
     }},
    {"update vortex",
     [](Scene& s) {
         s.vortex_desc.position[0] = 0.3f, s.vortex_desc.circulation = 3.0f;
         s.done(lr_world_update_vortex(s.world.get(), s.vortex, &s.vortex_desc));
     }},
    {"remove vortex", [](Scene& s) { s.done(lr_world_remove_wind(s.world.get(), s.vortex)); }},
    {"gusts",
     [](Scene& s) {
         lr_gusts_desc d = initialised(lr_gusts_desc_init);
         lr_wind_source out{};
         s.done(lr_world_add_gusts(s.world.get(), &d, &out));
     }},
    {"water", [](Scene& s) { s.water(0.5f); }},
    {"water rises", [](Scene& s) { s.water(0.2f), s.water(0.5f); }},
    {"water and none", [](Scene& s) { s.water(0.5f), s.done(lr_world_set_water(s.world.get(), nullptr)); }},
    {"gravity",
     [](Scene& s) {
         const float up[3] = {0.0f, 1.0f, 0.0f};
         s.done(lr_world_set_gravity(s.world.get(), up));
     }},
    {"gravity and back",
     [](Scene& s) {
         const float up[3] = {0.0f, 1.0f, 0.0f}, down[3] = {0.0f, -9.81f, 0.0f};
         s.done(lr_world_set_gravity(s.world.get(), up)), s.done(lr_world_set_gravity(s.world.get(), down));
     }},
    {"body contact off", [](Scene& s) { s.done(lr_batch_set_body_contact(s.world.get(), s.bricks, s.bricks, 0)); }},
    {"body contact off and on",
     [](Scene& s) {
         s.done(lr_batch_set_body_contact(s.world.get(), s.bricks, s.bricks, 0));
         s.done(lr_batch_set_body_contact(s.world.get(), s.bricks, s.bricks, 1));
     }},
    {"body contact on", [](Scene& s) { s.done(lr_batch_set_body_contact(s.world.get(), s.bricks, s.others, 1)); }},
    {"contact",
     [](Scene& s) {
         lr_batch_contact c = initialised(lr_batch_contact_init);
         c.layers = 0;
         s.done(lr_batch_set_contact(s.world.get(), s.bricks, &c));
     }},
    {"contact and back",
     [](Scene& s) {
         lr_batch_contact c = initialised(lr_batch_contact_init);
         c.layers = 0;
         s.done(lr_batch_set_contact(s.world.get(), s.bricks, &c));
         s.done(lr_batch_set_contact(s.world.get(), s.bricks, nullptr));
     }},
    {"never sleep",
     [](Scene& s) {
         lr_batch_contact c = initialised(lr_batch_contact_init);
         c.flags = LR_CONTACT_NEVER_SLEEP;
         s.done(lr_batch_set_contact(s.world.get(), s.bricks, &c));
     }},
    {"rate", [](Scene& s) { s.done(lr_batch_set_rate(s.world.get(), s.bricks, 3)); }},
    {"rate and back",
     [](Scene& s) {
         s.done(lr_batch_set_rate(s.world.get(), s.bricks, 3)), s.done(lr_batch_set_rate(s.world.get(), s.bricks, 1));
     }},
    {"budget", [](Scene& s) { s.done(lr_world_set_budget(s.world.get(), 30)); }},
    {"gains",
     [](Scene& s) {
         lr_load_gains g = initialised(lr_load_gains_init);
         g.drag = 2.0f;
         s.done(lr_batch_set_load_gains(s.world.get(), s.bricks, &g));
     }},
};

// The first few that differ; empty: none.
std::string difference(const std::vector<lr_event>& a, const std::vector<lr_event>& b) {
    std::string text;
    const auto list = [&](const char* name, const std::vector<lr_event>& of, const std::vector<lr_event>& in) {
        for (const lr_event& e : of)
            if (std::none_of(in.begin(), in.end(),
                             [&](const lr_event& o) { return std::memcmp(&e, &o, sizeof e) == 0; }))
                text += std::string(" ") + name + " kind " + std::to_string(e.kind) + " collider " +
                        std::to_string(e.collider.id) + ",";
    };
    list("lost", a, b);
    list("new", b, a);
    return text.empty() && a.size() != b.size() ? "count" : text.substr(0, 300);
}

} // namespace

TEST_CASE("a world restored from a snapshot of what any call has left for the next step goes on as the saved one, "
          "events included") {
    Scene other; // of another past
    other.run(33);
    for (const uint32_t rate : {1u, 3u})
        for (const int before : {23, 61, 62, 150, 400})
            for (const auto& call : calls) {
                CAPTURE(rate);
                CAPTURE(before);
                CAPTURE(call.first);
                Scene one;
                REQUIRE(lr_batch_set_rate(one.world.get(), one.others, rate) == LR_OK);
                one.run(before);
                call.second(one);
                const std::vector<unsigned char> bytes = snapshot_of(one.world);
                REQUIRE(lr_world_snapshot_restore(other.world.get(), bytes.data(), bytes.size()) == LR_OK);
                for (int i = 0; i < 6; ++i) {
                    CAPTURE(i);
                    CHECK(hash_of(other.world) == hash_of(one.world));
                    one.run(1), other.run(1);
                    CHECK(difference(events_of(one.world), events_of(other.world)) == "");
                }
                CHECK(hash_of(other.world) == hash_of(one.world));
            }
}
