// Wrong calls in the middle of a scene: their statuses, and that the scene continues unaffected.
#include "support/contact.h"
#include "support/contact_events.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

using namespace test;

namespace {

constexpr float step = 1.0f / 60.0f;

Asset chip() {
    return make(rigid_box(0.05, 0.01, 0.04, 300.0));
}
lr_batch chips(const World& world, const Asset& asset, uint32_t capacity) {
    const lr_batch batch = add_batch(world, unloaded(), asset, capacity);
    lr_batch_contact c = contact_desc(0.5f, 0.1f, 0.05f);
    c.flags = 0;
    set_contact(world, batch, c);
    return batch;
}
std::vector<lr_body> drop(const World& world, lr_batch batch, uint32_t count, uint64_t seed) {
    Random random(seed);
    std::vector<lr_body> out;
    for (uint32_t i = 0; i < count; ++i) {
        out.push_back(add_body(
            world, batch,
            turned_anyhow(random, {random.uniform(-0.8, 0.8), random.uniform(0.3, 0.8), random.uniform(-0.8, 0.8)})));
    }
    return out;
}

double lowest_corner(const lr_body_state& s) {
    double least = 1e9;
    for (double x : {-0.025, 0.025})
        for (double y : {-0.005, 0.005})
            for (double z : {-0.02, 0.02})
                least = std::min(least, wide(s.position[1]) + to_world(quat(s.orientation), {x, y, z})[1]);
    return least;
}

// Two triangles per face.
Triangles cube(float half) {
    Triangles t;
    for (int i = 0; i < 8; ++i)
        for (int k = 0; k < 3; ++k) t.vertices.push_back((i >> k & 1) != 0 ? half : -half);
    t.indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    return t;
}

} // namespace

TEST_CASE("colliders that are told to go where nothing is stay where they are, and so does all that lies on them") {
    const Asset asset = chip();
    const World worlds[] = {make(world_desc()), make(world_desc())}; // the second receives no wrong calls
    lr_collider decks[2], sleds[2];
    for (size_t w = 0; w < 2; ++w) {
        const lr_batch batch = chips(worlds[w], asset, 60);
        decks[w] = add_collider(worlds[w], box_collider(1.0f, 0.1f, 1.0f));
        lr_collider_desc d = sphere_collider(0.2f);
        d.position[0] = -1.5f, d.position[1] = 0.2f;
        d.linear_velocity[0] = 1.0f;
        sleds[w] = add_collider(worlds[w], d);
        drop(worlds[w], batch, 60, 5);
        keep_events(worlds[w]);
    }
    const float nan = std::nanf(""), inf = std::numeric_limits<float>::infinity();
    Random random(3);
    for (int frame = 0; frame < 180; ++frame) {
        for (int i = 0; i < 8; ++i) {
            const lr_collider id = random.below(2) == 0 ? decks[0] : sleds[0];
            lr_collider_motion m = motion_of(id, 1 + static_cast<int32_t>(random.below(3)));
            m.position[1] = random.real(-1, 1);
            const uint32_t what = random.below(m.mode == LR_MOVE_TO ? 7 : 13);
            float* const fields[] = {m.position,
                                     m.position + 1,
                                     m.position + 2,
                                     m.orientation,
                                     m.orientation + 1,
                                     m.orientation + 2,
                                     m.orientation + 3,
                                     m.linear_velocity,
                                     m.linear_velocity + 1,
                                     m.linear_velocity + 2,
                                     m.angular_velocity,
                                     m.angular_velocity + 1,
                                     m.angular_velocity + 2};
            // With LR_MOVE_VELOCITY the pose is not used.
            float* const field = fields[m.mode == LR_MOVE_VELOCITY ? 7 + what % 6 : what];
            *field = random.below(2) == 0 ? nan : random.below(2) == 0 ? inf : -inf;
            const lr_collider_motion fine = motion_of(decks[0], LR_MOVE_PLACE), both[] = {fine, m};
            REQUIRE(lr_collider_move(worlds[0].get(), both, 2) == LR_ERROR_NOT_FINITE);
        }
        for (const World& world : worlds) steps(world, 1, step, 2);
        REQUIRE(hash_of(worlds[0]) == hash_of(worlds[1]));
        REQUIRE(event_list(worlds[0]).count == event_list(worlds[1]).count);
    }
}

TEST_CASE("bodies that are told to be nowhere go on as they were") {
    const Asset asset = chip();
    const World worlds[] = {make(world_desc()), make(world_desc())};
    std::vector<lr_body> bodies[2];
    lr_batch batches[2];
    for (size_t w = 0; w < 2; ++w) {
        add_collider(worlds[w], collider_desc(LR_COLLIDER_PLANE));
        batches[w] = chips(worlds[w], asset, 41);
        bodies[w] = drop(worlds[w], batches[w], 40, 6);
    }
    const float nan = std::nanf("");
    for (int frame = 0; frame < 120; ++frame) {
        const lr_body body = bodies[0][static_cast<size_t>(frame) % 40];
        lr_body_state s = state_of(worlds[0], body);
        float* const fields[] = {s.position + 1, s.orientation, s.linear_velocity + 2, s.angular_velocity};
        *fields[frame % 4] = nan;
        CHECK(lr_body_set_state(worlds[0].get(), body, &s) == LR_ERROR_NOT_FINITE);
        lr_body_desc d = body_desc();
        d.position[frame % 3] = nan;
        CHECK(lr_body_create(worlds[0].get(), batches[0], &d, 1, nullptr) == LR_ERROR_NOT_FINITE);
        const lr_batch_contact c = contact_desc(nan, 0.0f);
        CHECK(lr_batch_set_contact(worlds[0].get(), batches[0], &c) == LR_ERROR_NOT_FINITE);
        for (const World& world : worlds) steps(world, 1, step, 2);
        REQUIRE(hash_of(worlds[0]) == hash_of(worlds[1]));
    }
}

TEST_CASE("meshes that are inside out, and those with triangles that are none, hold bodies like others" *
          doctest::test_suite("native")) {
    const Asset asset = chip();
    const Triangles right = cube(0.6f);
    Triangles inside_out = right, mixed = right, crumbs = right;
    for (size_t t = 0; t < right.indices.size(); t += 3) {
        std::swap(inside_out.indices[t], inside_out.indices[t + 1]);
        if (t % 2 == 0) std::swap(mixed.indices[t], mixed.indices[t + 2]);
    }
    // Points, lines and slivers, on top of it and in its corners.
    for (uint32_t i = 0; i < 8; ++i) crumbs.indices.insert(crumbs.indices.end(), {i, i, i, i, (i + 1) % 8, i});
    const auto more = static_cast<uint32_t>(crumbs.vertices.size() / 3);
    crumbs.vertices.insert(crumbs.vertices.end(), {-0.5f, 0.6f, 0.0f, 0.5f, 0.6f, 0.0f, 0.0f, 0.6f, 0.0f});
    crumbs.indices.insert(crumbs.indices.end(), {more, more + 1, more + 2, more + 2, more + 1, more});
    std::vector<lr_body_state> first;
    for (const Triangles* mesh : {&right, &std::as_const(inside_out), &std::as_const(mixed), &std::as_const(crumbs)}) {
        const World world = make(world_desc());
        const lr_batch batch = chips(world, asset, 50);
        add_collider(world, collider_desc(LR_COLLIDER_PLANE));
        lr_collider_desc d = mesh_collider(*mesh);
        d.position[1] = -0.3f; // its top at 0.3 m
        add_collider(world, d);
        Random random(9);
        std::vector<lr_body> bodies;
        for (int i = 0; i < 50; ++i) {
            bodies.push_back(add_body(world, batch,
                                      turned_anyhow(random, {random.uniform(-0.4, 0.4), random.uniform(0.4, 0.9),
                                                             random.uniform(-0.4, 0.4)})));
        }
        steps(world, 240, step, 2);
        CHECK(view_of(world, batch).awake_count <= 2);
        uint32_t alike = 0;
        for (size_t i = 0; i < bodies.size(); ++i) {
            const lr_body_state s = state_of(world, bodies[i]);
            CHECK(std::abs(lowest_corner(s) - 0.3) < (s.sleep_state == LR_SLEEP_ASLEEP ? 2e-4 : 2e-3));
            if (mesh == &right) first.push_back(s);
            if (length(vec(s.position) - vec(first[i].position)) < 1e-3) ++alike;
        }
        // Corners in another order, with the other orientation.
        CHECK(alike > 40);
    }
}

TEST_CASE("hulls that are as good as flat: refused, or something to land on") {
    const Asset asset = chip();
    const World world = make(world_desc());
    const lr_batch batch = chips(world, asset, 8);
    add_collider(world, collider_desc(LR_COLLIDER_PLANE));
    std::vector<lr_body> bodies;
    const float thickness[] = {0.0f, 1e-7f, 5e-5f, 3e-4f, 1e-3f, 1e-2f};
    for (size_t i = 0; i < 6; ++i) {
        const float t = thickness[i], x = 3.0f * static_cast<float>(i);
        // Repeated corners, points on edges and faces.
        std::vector<float> points;
        for (float u : {-1.0f, 0.0f, 1.0f, 1.0f})
            for (float v : {0.0f, -t})
                for (float w : {-1.0f, 0.0f, 1.0f}) points.insert(points.end(), {0.5f * u, v, 0.5f * w});
        lr_collider_desc d = hull_collider(points);
        d.position[0] = x, d.position[1] = 0.2f;
        lr_collider id{};
        const uint64_t before = hash_of(world);
        const lr_status status = lr_collider_create(world.get(), &d, 1, &id);
        CAPTURE(t);
        CHECK(status == (t < 1e-4f ? LR_ERROR_INVALID_ARGUMENT : LR_OK));
        if (status != LR_OK) CHECK(hash_of(world) == before);
        lr_body_desc b = body_desc();
        put(b.position, {wide(x) + 0.1, 0.5, 0.1});
        put(b.orientation, about({1, 0.3, 0.2}, 0.7));
        bodies.push_back(add_body(world, batch, b));
    }
    steps(world, 240, step, 2);
    for (size_t i = 0; i < 6; ++i) {
        const lr_body_state s = state_of(world, bodies[i]);
        CHECK(s.sleep_state == LR_SLEEP_ASLEEP);
        CHECK(std::abs(lowest_corner(s) - (thickness[i] < 1e-4f ? 0.0 : 0.2)) < 2e-4);
    }
}

TEST_CASE("bodies and colliders that are destroyed as their events are read: contacts that began end, once") {
    const Asset asset = chip();
    const World world = make(world_desc());
    constexpr uint32_t most = 200;
    const lr_batch batch = chips(world, asset, most);
    add_collider(world, collider_desc(LR_COLLIDER_PLANE));
    keep_events(world, 10000);
    Random random(12);
    std::vector<lr_collider> pads;
    std::map<std::pair<lr_body, lr_collider>, int> touching;
    std::vector<lr_body> gone;
    uint32_t ended_by_us = 0, bodies_destroyed = 0;
    for (int frame = 0; frame < 400; ++frame) {
        if (frame % 4 == 0 && pads.size() < 30) {
            lr_collider_desc d = box_collider(0.15f, 0.02f, 0.15f);
            put(d.position, {random.uniform(-0.8, 0.8), random.uniform(0.05, 0.25), random.uniform(-0.8, 0.8)});
            pads.push_back(add_collider(world, d));
        }
        if (info_of(world).body_count + 4 <= most) drop(world, batch, 4, random.bits());
        steps(world, 1, step, 2);
        // A copy: the call below destroys what the first list names.
        for (const lr_event& e : events_of(world)) {
            REQUIRE(std::find(gone.begin(), gone.end(), e.body) == gone.end()); // destroyed bodies never occur later
            if (e.kind == LR_EVENT_HIT) REQUIRE(++touching[{e.body, e.collider}] == 1);
            if (e.kind == LR_EVENT_LIFTED) REQUIRE(--touching[{e.body, e.collider}] == 0);
        }
        std::vector<lr_body> now;
        for (const lr_event& e : events_of(world)) {
            const auto pad = std::find(pads.begin(), pads.end(), e.collider);
            if (pad != pads.end() && random.below(20) == 0) {
                REQUIRE(lr_collider_destroy(world.get(), &e.collider, 1) == LR_OK);
                pads.erase(pad);
                ++ended_by_us;
            }
            if (random.below(20) != 0 || std::find(now.begin(), now.end(), e.body) != now.end()) continue;
            REQUIRE(lr_body_destroy(world.get(), &e.body, 1) == LR_OK);
            now.push_back(e.body);
            ++bodies_destroyed;
            for (auto& [pair, count] : touching)
                if (pair.first == e.body) count = 0;
        }
        gone.insert(gone.end(), now.begin(), now.end());
        REQUIRE(event_list(world).lost == 0);
    }
    CHECK(ended_by_us > 10);
    CHECK(bodies_destroyed > 50);
    // Contacts end when all colliders are destroyed.
    for (lr_collider pad : pads) REQUIRE(lr_collider_destroy(world.get(), &pad, 1) == LR_OK);
    steps(world, 1, step, 2);
    for (const lr_event& e : events_of(world)) {
        if (e.kind == LR_EVENT_HIT) CHECK(++touching[{e.body, e.collider}] == 1);
        if (e.kind == LR_EVENT_LIFTED) CHECK(--touching[{e.body, e.collider}] == 0);
    }
    for (const auto& [pair, count] : touching)
        if (std::find(pads.begin(), pads.end(), pair.second) != pads.end()) CHECK(count == 0);
}
