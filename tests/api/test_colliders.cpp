// Colliders through the public API: arguments, ids, motion, memory, snapshots.
#include "support/colliders.h"
#include "support/counting_memory.h"
#include "support/random.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

using namespace test;

namespace {

lr_status try_create(const World& w, const lr_collider_desc& d) {
    return lr_collider_create(w.get(), &d, 1, nullptr);
}
lr_status try_move(const World& w, const lr_collider_motion& m) {
    return lr_collider_move(w.get(), &m, 1);
}

// A collider of each kind, with its arrays.
struct EachKind {
    Triangles sheet = bumpy_sheet(5, 1);
    std::vector<float> corners = tetrahedron(0.5f), heights = std::vector<float>(35, 0.25f);
    std::vector<lr_collider_desc> descs;
    EachKind() {
        lr_collider_desc capsule = collider_desc(LR_COLLIDER_CAPSULE);
        capsule.size[0] = 0.1f, capsule.size[1] = 0.4f;
        descs = {collider_desc(LR_COLLIDER_PLANE),
                 sphere_collider(0.3f),
                 capsule,
                 box_collider(1.0f, 2.0f, 3.0f),
                 hull_collider(corners),
                 heightfield_collider(heights, 5, 0.5f),
                 mesh_collider(sheet)};
        for (size_t i = 0; i < descs.size(); ++i) {
            descs[i].position[0] = static_cast<float>(i);
            descs[i].friction = 0.1f * static_cast<float>(i);
            descs[i].layers = 1u << i;
        }
    }
    std::vector<lr_collider> add(const World& w) const {
        std::vector<lr_collider> ids(descs.size());
        REQUIRE(lr_collider_create(w.get(), descs.data(), static_cast<uint32_t>(descs.size()), ids.data()) == LR_OK);
        return ids;
    }
};

} // namespace

TEST_CASE("each kind of collider is made, and tells what it is") {
    const World world = make(world_desc());
    const EachKind each;
    const std::vector<lr_collider> ids = each.add(world);
    CHECK(info_of(world).collider_count == 7);
    for (size_t i = 0; i < ids.size(); ++i) {
        CHECK(ids[i].id != 0);
        const lr_collider_state s = state_of_collider(world, ids[i]);
        CHECK(s.kind == static_cast<int32_t>(i) + 1);
        CHECK(s.position[0] == static_cast<float>(i));
        CHECK(s.orientation[3] == 1.0f);
        CHECK(s.friction == 0.1f * static_cast<float>(i));
        CHECK(s.restitution == 0.2f);
        CHECK(s.layers == 1u << i);
        CHECK(lr_collider_get_state(world.get(), ids[i], nullptr) == LR_ERROR_NULL_ARGUMENT);
    }
    steps(world, 3, 0.01f);
    CHECK(lr_collider_destroy(world.get(), ids.data(), 7) == LR_OK);
    CHECK(info_of(world).collider_count == 0);
    steps(world, 3, 0.01f);
}

TEST_CASE("values that no collider has are refused, and nothing is made") {
    const World world = make(world_desc());
    const uint64_t before = hash_of(world);
    const EachKind each;
    const float nan = std::nanf(""), inf = std::numeric_limits<float>::infinity();
    using D = lr_collider_desc;
    const auto refused = [&](size_t kind, lr_status status, auto&& change) {
        D d = each.descs[kind - 1];
        change(d);
        CAPTURE(kind);
        CHECK(try_create(world, d) == status);
    };
    constexpr lr_status invalid = LR_ERROR_INVALID_ARGUMENT, not_finite = LR_ERROR_NOT_FINITE;
    for (size_t kind = 1; kind <= 7; ++kind) {
        for (float bad : {nan, inf, -inf}) {
            refused(kind, not_finite, [&](D& d) { d.position[2] = bad; });
            refused(kind, not_finite, [&](D& d) { d.orientation[1] = bad; });
            refused(kind, not_finite, [&](D& d) { d.linear_velocity[0] = bad; });
            refused(kind, not_finite, [&](D& d) { d.angular_velocity[1] = bad; });
            refused(kind, not_finite, [&](D& d) { d.friction = bad; });
            refused(kind, not_finite, [&](D& d) { d.restitution = bad; });
        }
        refused(kind, invalid, [](D& d) { d.orientation[3] = 0.0f; });
        refused(kind, invalid, [](D& d) { d.orientation[3] = 1e-7f; });
        refused(kind, invalid, [](D& d) { d.position[1] = 2e9f; });
        refused(kind, invalid, [](D& d) { d.linear_velocity[1] = -2e6f; });
        refused(kind, invalid, [](D& d) { d.angular_velocity[1] = 2e6f; });
        refused(kind, invalid, [](D& d) { d.friction = -0.1f; });
        refused(kind, invalid, [](D& d) { d.friction = 10.1f; });
        refused(kind, invalid, [](D& d) { d.restitution = 1.1f; });
        refused(kind, invalid, [](D& d) { d.restitution = -0.1f; });
        refused(kind, invalid, [](D& d) { d.flags = 1; });
        refused(kind, invalid, [](D& d) { d.kind = 0; });
        refused(kind, invalid, [](D& d) { d.kind = 8; });
    }
    const int sizes[] = {0, 1, 2, 3};
    for (size_t kind = 2; kind <= 4; ++kind)
        for (int k = 0; k < sizes[kind - 1]; ++k) {
            for (float bad : {0.0f, -1.0f, 2e6f}) refused(kind, invalid, [&](D& d) { d.size[k] = bad; });
            refused(kind, not_finite, [&](D& d) { d.size[k] = nan; });
        }
    // Hulls: too few, too many, flat, not finite, far.
    refused(5, invalid, [](D& d) { d.vertex_count = 3; });
    std::vector<float> many(771, 0.5f);
    refused(5, invalid, [&](D& d) { d.vertices = many.data(), d.vertex_count = 257; });
    const std::vector<float> flat = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0.3f, 0.4f, 0};
    refused(5, invalid, [&](D& d) { d.vertices = flat.data(), d.vertex_count = 5; });
    const std::vector<float> point(12, 1.0f);
    refused(5, invalid, [&](D& d) { d.vertices = point.data(); });
    std::vector<float> bad_vertices = each.corners;
    bad_vertices[7] = nan;
    refused(5, not_finite, [&](D& d) { d.vertices = bad_vertices.data(); });
    bad_vertices[7] = 2e6f;
    refused(5, invalid, [&](D& d) { d.vertices = bad_vertices.data(); });
    // Heightfields.
    refused(6, invalid, [](D& d) { d.counts[0] = 1; });
    refused(6, invalid, [](D& d) { d.counts[1] = 0; });
    refused(6, invalid, [](D& d) { d.counts[0] = d.counts[1] = 0x80000000u; }); // the product is 0 in 32 and in 64 bits
    refused(6, invalid, [](D& d) { d.counts[0] = d.counts[1] = 0xffffffffu; });
    refused(6, invalid, [](D& d) { d.counts[0] = 3, d.counts[1] = LR_MAX_COLLIDER_VERTICES; });
    refused(6, invalid, [](D& d) { d.spacing[0] = 0.0f; });
    refused(6, invalid, [](D& d) { d.spacing[1] = -1.0f; });
    refused(6, not_finite, [&](D& d) { d.spacing[1] = nan; });
    std::vector<float> heights = each.heights;
    heights[34] = inf;
    refused(6, not_finite, [&](D& d) { d.heights = heights.data(); });
    // Meshes.
    refused(7, invalid, [](D& d) { d.triangle_count = 0; });
    refused(7, invalid, [](D& d) { d.triangle_count = 0xffffffffu; });
    refused(7, invalid, [](D& d) { d.vertex_count = 2; });
    refused(7, invalid, [](D& d) { d.vertex_count = 0xffffffffu; });
    std::vector<uint32_t> indices = each.sheet.indices;
    indices.back() = each.descs[6].vertex_count;
    refused(7, invalid, [&](D& d) { d.indices = indices.data(); });
    const uint32_t line[] = {0, 1, 2};
    const float straight[] = {0, 0, 0, 1, 0, 0, 2, 0, 0};
    refused(7, invalid, [&](D& d) {
        d.vertices = straight, d.vertex_count = 3;
        d.indices = line, d.triangle_count = 1;
    });
    CHECK(info_of(world).collider_count == 0);
    CHECK(hash_of(world) == before);
}

TEST_CASE("all or none: one that is bad, anywhere in an array, keeps all others from being made") {
    const World world = make(world_desc());
    const EachKind each;
    each.add(world);
    const std::vector<unsigned char> before = snapshot_of(world);
    const std::vector<float> flat = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    for (size_t at = 0; at <= each.descs.size(); ++at) {
        std::vector<lr_collider_desc> descs = each.descs;
        descs.insert(descs.begin() + static_cast<std::ptrdiff_t>(at), hull_collider(flat));
        std::vector<lr_collider> ids(descs.size(), lr_collider{77});
        CHECK(lr_collider_create(world.get(), descs.data(), 8, ids.data()) == LR_ERROR_INVALID_ARGUMENT);
        CHECK(ids == std::vector<lr_collider>(8, {77}));
        CHECK(snapshot_of(world) == before);
    }
}

TEST_CASE("destroyed colliders are stale, and their slots' next tenants are others") {
    const World world = make(world_desc());
    std::set<lr_collider> seen;
    const lr_collider_desc d = sphere_collider(1.0f);
    for (int life = 0; life < 1000; ++life) {
        const lr_collider id = add_collider(world, d);
        CHECK(seen.insert(id).second);
        CHECK(lr_collider_destroy(world.get(), &id, 1) == LR_OK);
    }
    add_collider(world, d);
    lr_collider_state s = initialised(lr_collider_state_init);
    const lr_material rough = initialised(lr_material_init);
    for (lr_collider id : seen)
        if (lr_collider_get_state(world.get(), id, &s) != LR_ERROR_STALE_COLLIDER ||
            lr_collider_destroy(world.get(), &id, 1) != LR_ERROR_STALE_COLLIDER ||
            try_move(world, motion_of(id, LR_MOVE_TO)) != LR_ERROR_STALE_COLLIDER ||
            lr_collider_set_material(world.get(), &id, 1, &rough) != LR_ERROR_STALE_COLLIDER)
            FAIL("an old id found a collider");
    for (uint64_t forged : {uint64_t{0}, uint64_t{1}, ~uint64_t{0}, uint64_t{1} << 32 | 5u}) {
        const lr_collider id{forged};
        CHECK(lr_collider_destroy(world.get(), &id, 1) == LR_ERROR_STALE_COLLIDER);
    }
    CHECK(info_of(world).collider_count == 1);
}

TEST_CASE("destroying, moving and setting surfaces of many is all or none") {
    const World world = make(world_desc());
    const EachKind each;
    std::vector<lr_collider> ids = each.add(world);
    const std::vector<unsigned char> before = snapshot_of(world);
    std::vector<lr_collider> twice = ids;
    twice.push_back(ids[3]);
    CHECK(lr_collider_destroy(world.get(), twice.data(), 8) == LR_ERROR_STALE_COLLIDER);
    twice.back().id += uint64_t{1} << 32;
    CHECK(lr_collider_destroy(world.get(), twice.data(), 8) == LR_ERROR_STALE_COLLIDER);
    lr_material rough = initialised(lr_material_init);
    rough.friction = 2.0f;
    CHECK(lr_collider_set_material(world.get(), twice.data(), 8, &rough) == LR_ERROR_STALE_COLLIDER);
    std::vector<lr_collider_motion> motions;
    motions.reserve(twice.size());
    for (lr_collider id : twice) motions.push_back(motion_of(id, LR_MOVE_TO));
    CHECK(lr_collider_move(world.get(), motions.data(), 8) == LR_ERROR_STALE_COLLIDER);
    motions.pop_back();
    const float nan = std::nanf("");
    const auto refused = [&](lr_status status, auto&& change) {
        std::vector<lr_collider_motion> bad = motions;
        change(bad[6]);
        CHECK(lr_collider_move(world.get(), bad.data(), 7) == status);
    };
    using M = lr_collider_motion;
    refused(LR_ERROR_NOT_FINITE, [&](M& m) { m.position[0] = nan; });
    refused(LR_ERROR_NOT_FINITE, [&](M& m) { m.orientation[0] = nan; });
    refused(LR_ERROR_NOT_FINITE, [&](M& m) { m.angular_velocity[0] = nan; });
    refused(LR_ERROR_INVALID_ARGUMENT, [](M& m) { m.mode = 0; });
    refused(LR_ERROR_INVALID_ARGUMENT, [](M& m) { m.mode = 4; });
    refused(LR_ERROR_INVALID_ARGUMENT, [](M& m) { m.reserved = 1; });
    refused(LR_ERROR_INVALID_ARGUMENT, [](M& m) { m.orientation[3] = 0.0f; });
    refused(LR_ERROR_INVALID_ARGUMENT, [](M& m) { m.position[2] = -2e9f; });
    refused(LR_ERROR_INVALID_ARGUMENT, [](M& m) { m.mode = LR_MOVE_VELOCITY, m.linear_velocity[2] = 2e6f; });
    CHECK(snapshot_of(world) == before);
    rough.friction = nan;
    CHECK(lr_collider_set_material(world.get(), ids.data(), 7, &rough) == LR_ERROR_NOT_FINITE);
    rough.friction = 2.0f, rough.restitution = 1.5f;
    CHECK(lr_collider_set_material(world.get(), ids.data(), 7, &rough) == LR_ERROR_INVALID_ARGUMENT);
    rough.restitution = 0.9f, rough.layers = 6;
    CHECK(lr_collider_set_material(world.get(), ids.data(), 7, &rough) == LR_OK);
    for (lr_collider id : ids) {
        const lr_collider_state s = state_of_collider(world, id);
        CHECK((s.friction == 2.0f && s.restitution == 0.9f && s.layers == 6));
    }
    CHECK(lr_collider_destroy(world.get(), ids.data(), 7) == LR_OK);
}

TEST_CASE("the three ways of moving") {
    const World world = make(world_desc());
    lr_collider_desc d = box_collider(1.0f, 1.0f, 1.0f);
    d.linear_velocity[0] = 2.0f;
    d.angular_velocity[1] = 1.0f;
    const lr_collider id = add_collider(world, d), still = add_collider(world, sphere_collider(1.0f));
    steps(world, 10, 0.01f, 3);
    lr_collider_state s = state_of_collider(world, id);
    CHECK(s.position[0] == doctest::Approx(0.2));
    CHECK(s.orientation[1] == doctest::Approx(std::sin(0.05)));
    CHECK(s.linear_velocity[0] == 2.0f);
    // To a pose, over one step; then it stops.
    lr_collider_motion m = motion_of(id, LR_MOVE_TO);
    m.position[0] = 5.0f, m.position[2] = -1.0f;
    m.orientation[0] = 3.0f, m.orientation[3] = -4.0f;
    REQUIRE(try_move(world, m) == LR_OK);
    s = state_of_collider(world, id);
    CHECK(s.position[0] == doctest::Approx(0.2));
    CHECK(s.linear_velocity[0] == 0.0f);
    for (int i = 0; i < 3; ++i) {
        steps(world, 1, 0.01f);
        s = state_of_collider(world, id);
        CHECK((s.position[0] == 5.0f && s.position[2] == -1.0f && s.linear_velocity[0] == 0.0f));
        CHECK(std::abs(s.orientation[0]) == 0.6f);
        CHECK(s.orientation[0] * s.orientation[3] == doctest::Approx(-0.48)); // a quaternion or its negative
    }
    // Placed, with velocities; the last of several motions counts.
    const lr_collider_motion first = m;
    m.mode = LR_MOVE_PLACE;
    m.position[0] = 7.0f;
    m.linear_velocity[1] = 3.0f;
    const lr_collider_motion both[] = {first, m};
    REQUIRE(lr_collider_move(world.get(), both, 2) == LR_OK);
    CHECK(state_of_collider(world, id).position[0] == 7.0f);
    steps(world, 4, 0.25f);
    s = state_of_collider(world, id);
    CHECK((s.position[0] == 7.0f && s.position[1] == 3.0f && s.linear_velocity[1] == 3.0f));
    // Velocities alone, which also cancel a pending motion.
    REQUIRE(try_move(world, first) == LR_OK);
    m = motion_of(id, LR_MOVE_VELOCITY);
    m.position[0] = std::numeric_limits<float>::max(); // not used
    m.orientation[3] = 0.0f;
    REQUIRE(try_move(world, m) == LR_OK);
    const lr_collider_state before = state_of_collider(world, id);
    steps(world, 2, 0.25f);
    CHECK(same_bits(state_of_collider(world, id), before));
    CHECK(before.position[1] == 3.0f);
    CHECK(state_of_collider(world, still).position[0] == 0.0f);
}

TEST_CASE("equal hulls, heightfields and meshes take their memory once, and give it back with the last") {
    const World world = make(world_desc());
    const Triangles sheet = bumpy_sheet(60, 9), copy = sheet, other = bumpy_sheet(60, 10);
    std::vector<lr_collider> ids;
    const auto bytes_for = [&](const lr_collider_desc& d) {
        const uint64_t before = info_of(world).memory_bytes;
        ids.push_back(add_collider(world, d));
        return info_of(world).memory_bytes - before;
    };
    const std::vector<lr_collider_desc> room(9000, sphere_collider(1.0f)); // so that tables do not grow below
    std::vector<lr_collider> spheres(9000);
    REQUIRE(lr_collider_create(world.get(), room.data(), 9000, spheres.data()) == LR_OK);
    REQUIRE(lr_collider_destroy(world.get(), spheres.data(), 9000) == LR_OK);
    const uint64_t before = info_of(world).memory_bytes;
    const uint64_t data = sheet.vertices.size() * 4 + sheet.indices.size() * 4;
    CHECK(bytes_for(mesh_collider(sheet)) > data);
    CHECK(bytes_for(mesh_collider(sheet)) == 0);
    CHECK(bytes_for(mesh_collider(copy)) == 0);
    CHECK(bytes_for(mesh_collider(other)) > data);
    for (size_t i : {0u, 2u, 3u}) CHECK(lr_collider_destroy(world.get(), &ids[i], 1) == LR_OK);
    CHECK(info_of(world).memory_bytes > before + data);
    CHECK(lr_collider_destroy(world.get(), &ids[1], 1) == LR_OK);
    CHECK(info_of(world).memory_bytes < before + 1000); // the table of geometries
}

TEST_CASE("colliders that are made and destroyed while others move") {
    Random random(4);
    const World world = make(world_desc());
    const EachKind each;
    std::vector<lr_collider> ids;
    for (int step = 0; step < 300; ++step) {
        for (uint32_t n = random.below(4); n > 0; --n) {
            lr_collider_desc d = each.descs[random.below(7)];
            for (float& x : d.position) x = random.real(-5, 5);
            if (random.below(2)) d.linear_velocity[1] = random.real(-5, 5);
            if (random.below(2)) d.angular_velocity[2] = random.real(-5, 5);
            ids.push_back(add_collider(world, d));
        }
        for (uint32_t n = random.below(4); n > 0 && !ids.empty(); --n) {
            const auto i = static_cast<std::ptrdiff_t>(random.below(static_cast<uint32_t>(ids.size())));
            REQUIRE(lr_collider_destroy(world.get(), &ids[static_cast<size_t>(i)], 1) == LR_OK);
            ids.erase(ids.begin() + i);
        }
        for (uint32_t n = random.below(9); n > 0 && !ids.empty(); --n) {
            lr_collider_motion m = motion_of(ids[random.below(static_cast<uint32_t>(ids.size()))],
                                             1 + static_cast<int32_t>(random.below(3)));
            for (float& x : m.position) x = random.real(-5, 5);
            REQUIRE(try_move(world, m) == LR_OK);
        }
        REQUIRE(lr_world_step(world.get(), 0.01f, 1) == LR_OK);
        CHECK(info_of(world).collider_count == ids.size());
    }
    for (lr_collider id : ids) CHECK(std::isfinite(state_of_collider(world, id).position[1]));
}

TEST_CASE("steps with colliders that move allocate nothing, nor does destroying") {
    CountingAllocator memory;
    lr_world_desc d = world_desc();
    d.allocator = memory.callbacks();
    const World world = make(d);
    const EachKind each;
    std::vector<lr_collider> ids;
    std::vector<lr_collider_motion> motions;
    for (int i = 0; i < 300; ++i)
        for (lr_collider id : each.add(world)) {
            ids.push_back(id);
            motions.push_back(motion_of(id, 1 + i % 3));
            motions.back().angular_velocity[i % 2] = 1.0f;
        }
    const auto count = static_cast<uint32_t>(ids.size());
    REQUIRE(lr_collider_move(world.get(), motions.data(), count) == LR_OK); // the largest number that moves at once
    const uint64_t own = memory.calls, global = global_allocations;
    bool ok = true;
    for (int i = 0; i < 60; ++i) {
        if (i % 10 == 3) ok = ok && lr_collider_move(world.get(), motions.data(), count / 2) == LR_OK;
        ok = ok && lr_world_step(world.get(), 0.01f, 1) == LR_OK;
        if (i % 10 == 7) {
            ok = ok && lr_collider_destroy(world.get(), ids.data() + count - 100, 100) == LR_OK;
            ok = ok && lr_world_step(world.get(), 0.01f, 1) == LR_OK;
            std::rotate(ids.begin(), ids.end() - 100, ids.end()); // destroyed colliders come last
            std::rotate(motions.begin(), motions.end() - 100, motions.end());
            ids.erase(ids.begin(), ids.begin() + 100);
            motions.erase(motions.begin(), motions.begin() + 100);
            break;
        }
    }
    CHECK(ok);
    CHECK(memory.calls == own);
    if (counts_global) CHECK(global_allocations == global);
}

TEST_CASE("running out of memory at any allocation leaves colliders as they were") {
    const EachKind each;
    uint64_t total = 0, refused = 0;
    for (uint64_t n = 0; n == 0 || n < total; ++n) {
        CountingAllocator memory;
        lr_world_desc d = world_desc();
        d.allocator = memory.callbacks();
        {
            const World world = make(d);
            const lr_collider first = add_collider(world, sphere_collider(1.0f));
            const std::vector<unsigned char> before = snapshot_of(world);
            const uint64_t calls = memory.calls;
            std::vector<lr_collider_desc> descs;
            for (int i = 0; i < 40; ++i) descs.insert(descs.end(), each.descs.begin(), each.descs.end());
            const auto count = static_cast<uint32_t>(descs.size());
            if (n != 0) memory.fail_at = calls + n - 1;
            const lr_status status = lr_collider_create(world.get(), descs.data(), count, nullptr);
            if (n == 0) {
                REQUIRE(status == LR_OK);
                total = memory.calls - calls + 1;
                REQUIRE(total > 15);
                continue;
            }
            memory.fail_at = CountingAllocator::never;
            CHECK(status == LR_ERROR_OUT_OF_MEMORY);
            ++refused;
            CHECK(snapshot_of(world) == before);
            steps(world, 1, 0.01f);
            CHECK(state_of_collider(world, first).kind == LR_COLLIDER_SPHERE);
            CHECK(lr_collider_create(world.get(), descs.data(), count, nullptr) == LR_OK);
            steps(world, 1, 0.01f);
        }
        CHECK(memory.live() == 0);
        CHECK_FALSE(memory.mismatch);
    }
    CHECK(refused > 15);
    // Many colliders start to move: the grid of moving ones grows.
    CountingAllocator memory;
    lr_world_desc d = world_desc();
    d.allocator = memory.callbacks();
    const World world = make(d);
    const std::vector<lr_collider_desc> descs(3000, sphere_collider(0.1f));
    std::vector<lr_collider> ids(3000);
    REQUIRE(lr_collider_create(world.get(), descs.data(), 3000, ids.data()) == LR_OK);
    steps(world, 1, 0.01f);
    std::vector<lr_collider_motion> motions;
    motions.reserve(ids.size());
    for (lr_collider id : ids) motions.push_back(motion_of(id, LR_MOVE_TO));
    const std::vector<unsigned char> before = snapshot_of(world);
    memory.fail_at = memory.calls;
    CHECK(lr_collider_move(world.get(), motions.data(), 3000) == LR_ERROR_OUT_OF_MEMORY);
    CHECK(snapshot_of(world) == before);
    steps(world, 1, 0.01f);
    CHECK(lr_collider_move(world.get(), motions.data(), 3000) == LR_OK);
    steps(world, 1, 0.01f);
}

TEST_CASE("operator new fails anywhere while geometry is built: a status, and nothing leaks" *
          doctest::test_suite("native") * doctest::skip(!counts_global)) {
    const EachKind each;
    const World world = make(world_desc());
    uint32_t failures = 0;
    std::vector<lr_collider> ids(7);
    for (uint64_t n = 1; n < 10000; ++n) {
        global_fail_in = n;
        const lr_status status = lr_collider_create(world.get(), each.descs.data(), 7, ids.data());
        const bool failed = global_fail_in == 0;
        global_fail_in = 0;
        if (!failed) {
            CHECK(status == LR_OK);
            break;
        }
        ++failures;
        // Functions of the C++ library can continue without memory that they did not get.
        CHECK((status == LR_ERROR_OUT_OF_MEMORY || status == LR_OK));
        if (status == LR_OK) CHECK(lr_collider_destroy(world.get(), ids.data(), 7) == LR_OK);
        CHECK(info_of(world).collider_count == 0);
    }
    CHECK(failures > 5);
}

TEST_CASE("a world without colliders has the hash that it had, each property of a collider is in it") {
    const World world = make(world_desc());
    const uint64_t none = hash_of(world);
    const lr_collider_desc d = box_collider(1.0f, 2.0f, 3.0f);
    std::set<uint64_t> seen = {none};
    const auto other = [&](const lr_collider_desc& desc) {
        const World w = make(world_desc());
        add_collider(w, desc);
        CHECK(seen.insert(hash_of(w)).second);
    };
    other(d);
    for (int k = 0; k < 3; ++k) {
        lr_collider_desc c = d;
        c.position[k] = 1e-30f;
        other(c);
        c = d, c.size[k] = 4.0f, other(c);
        c = d, c.linear_velocity[k] = 1.0f, other(c);
        c = d, c.angular_velocity[k] = 1.0f, other(c);
        c = d, c.orientation[k] = 1e-3f, other(c);
    }
    lr_collider_desc c = d;
    c.friction = 0.6f, other(c);
    c = d, c.restitution = 0.3f, other(c);
    c = d, c.layers = 3, other(c);
    other(sphere_collider(1.0f));
    const EachKind each;
    other(each.descs[4]);
    const std::vector<float> larger = tetrahedron(0.6f);
    other(hull_collider(larger));
    // Hashes and snapshots leave out unused fields.
    lr_collider_desc ball = sphere_collider(1.0f);
    ball.size[2] = 9.0f, ball.counts[0] = 4;
    const World w = make(world_desc());
    const lr_collider id = add_collider(w, ball);
    CHECK(seen.count(hash_of(w)) == 1);
    // They include pending motions, but a motion to where it is does nothing.
    lr_collider_motion m = motion_of(id, LR_MOVE_TO);
    REQUIRE(try_move(w, m) == LR_OK);
    CHECK(!seen.insert(hash_of(w)).second);
    m.position[1] = 1.0f;
    REQUIRE(try_move(w, m) == LR_OK);
    CHECK(seen.insert(hash_of(w)).second);
    REQUIRE(lr_collider_destroy(w.get(), &id, 1) == LR_OK);
    CHECK(hash_of(w) == none);
}

TEST_CASE("colliders come back with a snapshot: ids, motion, what is pending, and what they do next") {
    const EachKind each;
    Random random(8);
    const World world = make(world_desc());
    std::vector<lr_collider> ids = each.add(world);
    for (int i = 0; i < 5; ++i)
        for (lr_collider id : each.add(world)) ids.push_back(id);
    REQUIRE(lr_collider_destroy(world.get(), ids.data() + 8, 5) == LR_OK);
    std::vector<lr_collider> gone(ids.begin() + 8, ids.begin() + 13);
    ids.erase(ids.begin() + 8, ids.begin() + 13);
    std::vector<lr_collider_motion> motions;
    for (size_t i = 0; i < ids.size(); ++i) {
        motions.push_back(motion_of(ids[i], 1 + static_cast<int32_t>(i % 3)));
        for (float& x : motions.back().position) x = random.real(-5, 5);
        for (float& x : motions.back().angular_velocity) x = random.real(-5, 5);
        for (float& x : motions.back().linear_velocity) x = random.real(-5, 5);
    }
    const auto count = static_cast<uint32_t>(ids.size());
    REQUIRE(lr_collider_move(world.get(), motions.data(), count) == LR_OK);
    steps(world, 5, 0.01f);
    REQUIRE(lr_collider_move(world.get(), motions.data(), count / 2) == LR_OK); // pending
    const std::vector<unsigned char> saved = snapshot_of(world);
    const uint64_t hash = hash_of(world);

    // Another world that has the same data from other colliders.
    const World second = make(world_desc());
    for (int i = 0; i < 3; ++i) each.add(second);
    steps(second, 3, 0.01f);
    REQUIRE(lr_world_snapshot_restore(second.get(), saved.data(), saved.size()) == LR_OK);
    CHECK(hash_of(second) == hash);
    CHECK(snapshot_of(second) == saved);
    lr_collider_state s = initialised(lr_collider_state_init);
    for (lr_collider id : gone) CHECK(lr_collider_get_state(second.get(), id, &s) == LR_ERROR_STALE_COLLIDER);
    for (int i = 0; i < 20; ++i) {
        steps(world, 1, 0.01f);
        steps(second, 1, 0.01f);
        CHECK(hash_of(world) == hash_of(second));
    }
    for (lr_collider id : ids) CHECK(same_bits(state_of_collider(world, id), state_of_collider(second, id)));
    CHECK(each.add(world) == each.add(second)); // the same slots next

    // Back into the world itself. A world without the data refuses it.
    REQUIRE(lr_world_snapshot_restore(world.get(), saved.data(), saved.size()) == LR_OK);
    CHECK(snapshot_of(world) == saved);
    const World empty = make(world_desc());
    const uint64_t before = hash_of(empty);
    CHECK(lr_world_snapshot_restore(empty.get(), saved.data(), saved.size()) == LR_ERROR_SNAPSHOT_MISMATCH);
    CHECK(hash_of(empty) == before);
    // A snapshot without colliders restores none.
    const std::vector<unsigned char> nothing = snapshot_of(empty);
    REQUIRE(lr_world_snapshot_restore(second.get(), nothing.data(), nothing.size()) == LR_OK);
    CHECK(info_of(second).collider_count == 0);
    steps(second, 1, 0.01f);
}
