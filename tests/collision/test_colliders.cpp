// The class alone: its contents, and its candidates. Creation through the API: tests/api/test_colliders.cpp.
#include "collision/build_collider_geometry.h"
#include "collision/colliders.h"
#include "near_collider_marks.h"
#include "support/colliders.h"

#include <algorithm>

using namespace test;
using lr::Box;
using lr::Colliders;
using lr::Vector;

namespace {

lr_collider add(Colliders& c, const lr_collider_desc& d) {
    REQUIRE(c.begin_create(1) == LR_OK);
    REQUIRE(c.create(d) == LR_OK);
    lr_collider id{};
    REQUIRE(c.finish_create(&id) == LR_OK);
    return id;
}
void move(Colliders& c, const lr_collider_motion& m) {
    uint32_t slot = 0;
    REQUIRE(c.find(m.collider, slot));
    c.begin_reserve();
    c.reserve_move(slot, m);
    REQUIRE(c.finish_reserve());
    c.move(slot, m);
}

void scatter(Random& random, float (&position)[3], float (&orientation)[4], double most) {
    for (float& x : position) x = random.real(-most, most);
    for (float& q : orientation) q = random.real(-1, 1);
    orientation[3] += 2.0f;
}

// Finite colliders and parts of meshes by brute force: the expected result of candidates().
std::vector<std::pair<uint32_t, uint32_t>> brute(const Colliders& c, const std::vector<lr_collider>& ids,
                                                 const Triangles& sheet, const Box& box, uint32_t layers) {
    std::vector<std::pair<uint32_t, uint32_t>> out;
    std::vector<lr::MeshPart> parts;
    std::vector<uint32_t> indices = sheet.indices;
    lr::make_mesh_parts(sheet.vertices.data(), indices.data(), static_cast<uint32_t>(indices.size() / 3), parts);
    for (lr_collider id : ids) {
        uint32_t slot = 0;
        REQUIRE(c.find(id, slot));
        const lr::Collider& one = c.at(slot);
        if ((one.layers & layers) == 0) continue;
        const auto reaches = [&](const lr::LocalBounds& local) {
            return lr::overlap(lr::swept_box(local, one.begin, one.end, one.moves), box);
        };
        if (one.geometry.kind != lr::ColliderKind::mesh) {
            if (reaches(lr::bounds_of(one.geometry, nullptr))) out.emplace_back(slot, 0u);
            continue;
        }
        for (const lr::MeshPart& part : parts)
            if (reaches({part.box, 0.0f})) out.emplace_back(slot, part.part.first);
    }
    std::sort(out.begin(), out.end());
    return out;
}

} // namespace

TEST_CASE("candidates are those that going through all gives, whatever is made, moved and destroyed") {
    const Triangles sheet = bumpy_sheet(6, 3);
    for (uint64_t seed = 0; seed < 6; ++seed) {
        Random random(seed);
        lr::Allocator allocator;
        Colliders colliders(allocator);
        std::vector<lr_collider> ids;
        size_t found_in_all = 0;
        uint32_t full_lists = 0;
        for (int step = 0; step < 60; ++step) {
            for (uint32_t n = step == 0 ? 300 : random.below(6); n > 0; --n) {
                const uint32_t kind = random.below(8);
                lr_collider_desc d = kind < 4   ? sphere_collider(random.real(0.01, 0.3))
                                     : kind < 7 ? box_collider(random.real(0.01, 1), random.real(0.01, 1), 0.05f)
                                                : mesh_collider(sheet);
                scatter(random, d.position, d.orientation, 5.0);
                d.layers = 1u << random.below(3);
                if (random.below(4) == 0)
                    for (float& v : d.linear_velocity) v = random.real(-9, 9);
                if (random.below(4) == 0) d.angular_velocity[1] = random.real(-90, 90);
                ids.push_back(add(colliders, d));
            }
            for (uint32_t n = random.below(6); n > 0 && !ids.empty(); --n) {
                const uint32_t i = random.below(static_cast<uint32_t>(ids.size()));
                colliders.destroy(&ids[i], 1);
                ids.erase(ids.begin() + i);
            }
            for (uint32_t n = random.below(30); n > 0; --n) {
                lr_collider_motion m{};
                m.mode = 1 + static_cast<int32_t>(random.below(3));
                m.collider = ids[random.below(static_cast<uint32_t>(ids.size()))];
                scatter(random, m.position, m.orientation, 5.0);
                if (random.below(2))
                    for (float& v : m.linear_velocity) v = random.real(-9, 9);
                move(colliders, m);
            }
            const float reach = step < 30 ? 0.25f : random.real(0.05, 0.5);
            colliders.begin_step(1.0 / 60.0, reach);
            for (int q = 0; q < 40; ++q) {
                const Vector at{random.real(-6, 6), random.real(-6, 6), random.real(-6, 6)};
                const float r = random.real(0.01, q == 0 ? 3.0 : 0.3);
                const Box box{at - Vector{r, r, r}, at + Vector{r, r, r}};
                const uint32_t layers = 1 + random.below(7);
                const auto expected = brute(colliders, ids, sheet, box, layers);
                lr::Candidate out[lr::most_candidates], last{};
                bool more = true;
                size_t listed = 0;
                for (const lr::Candidate* after = nullptr; more; after = &last) {
                    const uint32_t count = colliders.candidates(box, layers, after, out, more);
                    if (listed + count > expected.size()) FAIL("more than there are");
                    if (more && count < lr::most_candidates) FAIL("not as many as there is room for");
                    for (uint32_t i = 0; i < count; ++i, ++listed)
                        if (out[i].slot != expected[listed].first || out[i].part.first != expected[listed].second)
                            FAIL("another one, or not in order");
                    if (more) last = out[count - 1];
                }
                if (listed != expected.size()) FAIL(listed, " for ", expected.size());
                full_lists += listed > lr::most_candidates;
                found_in_all += static_cast<uint32_t>(listed);
                if (layers == 7 && r <= reach && !expected.empty() && !marked(colliders.near(), at, r))
                    FAIL("told to be far");
            }
            colliders.end_step();
        }
        CHECK(found_in_all > 1000);
        CHECK(full_lists > 0);
    }
}

TEST_CASE("planes and heightfields are near where bodies can touch them, also while they move") {
    Random random(5);
    uint32_t touching = 0, far = 0;
    for (int scene = 0; scene < 300; ++scene) {
        lr::Allocator allocator;
        Colliders colliders(allocator);
        std::vector<float> heights(126);
        for (float& h : heights) h = random.real(-0.5, 1.0) * random.real(0, 1) * 3.0f;
        lr_collider_desc d = scene % 2 ? collider_desc(LR_COLLIDER_PLANE) : heightfield_collider(heights, 9, 0.2f);
        scatter(random, d.position, d.orientation, 3.0);
        const lr_collider id = add(colliders, d);
        if (scene % 3 != 0) {
            lr_collider_motion m{};
            m.mode = scene % 3 == 1 ? LR_MOVE_TO : LR_MOVE_VELOCITY;
            m.collider = id;
            std::copy(d.orientation, d.orientation + 4, m.orientation);
            if (scene % 4 == 0) m.orientation[0] += 0.1f;
            for (int k = 0; k < 3; ++k) {
                m.position[k] = d.position[k] + random.real(-0.3, 0.3);
                m.linear_velocity[k] = random.real(-9, 9);
            }
            move(colliders, m);
        }
        colliders.begin_step(1.0 / 60.0, 0.25f);
        const lr::Collider& c = colliders.at(0);
        const lr::NearColliders& near = colliders.near();
        for (int i = 0; i < 300; ++i) {
            const Vector at{random.real(-5, 5), random.real(-5, 5), random.real(-5, 5)};
            const float reach = random.real(0.0, 0.25), t = random.real(0, 1);
            const lr::Rotation &a = c.begin.rotation, &b = c.end.rotation;
            const lr::Pose pose{c.begin.position + t * (c.end.position - c.begin.position),
                                lr::normalised({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z),
                                                a.w + t * (b.w - a.w)})};
            const Vector own = lr::to_inner(pose, at);
            // A little less than its reach: both sides of the comparison are rounded.
            const float r = 0.999f * reach - 1e-5f;
            bool touches = own.y < r, within = touches;
            if (scene % 2 == 0 && touches) {
                const auto i0 = std::lround(own.x / 0.2f), k0 = std::lround(own.z / 0.2f);
                touches = i0 >= 0 && k0 >= 0 && i0 < 9 && k0 < 14 &&
                          own.y < heights[static_cast<size_t>(i0 + 9 * k0)] && // over a sample, or next to it
                          std::abs(own.x - 0.2f * static_cast<float>(i0)) < r &&
                          std::abs(own.z - 0.2f * static_cast<float>(k0)) < r;
                within = touches &&
                         std::hypot(own.x - 0.2f * static_cast<float>(i0), own.z - 0.2f * static_cast<float>(k0)) < r;
            }
            lr::Candidate out[lr::most_candidates];
            bool more = false;
            const Vector e{reach, reach, reach};
            const uint32_t count = colliders.candidates({at - e, at + e}, 1, nullptr, out, more);
            if (touches && count != 1) FAIL("missed");
            const bool seen = marked(near, at, reach);
            if (within && !seen) FAIL("missed by the kernel");
            touching += within;
            far += !seen;
        }
    }
    CHECK(touching > 1000);
    CHECK(far > 10000);
}

TEST_CASE("more planes than the kernel holds, and planes that turn, keep all bodies from being far") {
    lr::Allocator allocator;
    Colliders colliders(allocator);
    std::vector<lr_collider> ids;
    for (int i = 0; i < 17; ++i) {
        lr_collider_desc d = collider_desc(LR_COLLIDER_PLANE);
        d.position[1] = -static_cast<float>(i);
        ids.push_back(add(colliders, d));
    }
    lr::Candidate out[lr::most_candidates];
    bool more = false;
    colliders.begin_step(0.01, 0.25f);
    CHECK(colliders.near().everywhere);
    CHECK(colliders.candidates({{0.0f, -3.2f, 0.0f}, {0.1f, -3.1f, 0.1f}}, 1, nullptr, out, more) == 4);
    colliders.end_step();
    colliders.destroy(&ids[5], 1);
    colliders.begin_step(0.01, 0.25f);
    CHECK_FALSE(colliders.near().everywhere);
    CHECK(colliders.near().plane_count == 16);
    CHECK_FALSE(marked(colliders.near(), {0.0f, 1.0f, 0.0f}, 0.25f));
    colliders.end_step();
    lr_collider_motion m{};
    m.mode = LR_MOVE_VELOCITY;
    m.collider = ids[0];
    m.angular_velocity[0] = 1.0f;
    move(colliders, m);
    colliders.begin_step(0.01, 0.25f);
    CHECK(colliders.near().everywhere);
    CHECK(colliders.candidates({{0.0f, 9.0f, 0.0f}, {0.1f, 9.1f, 0.1f}}, 1, nullptr, out, more) == 1);
}

TEST_CASE("parts of a mesh hold each triangle once, and large triangles are alone") {
    for (uint32_t n : {1u, 5u, 40u}) {
        const Triangles sheet = bumpy_sheet(n, n);
        const auto count = static_cast<uint32_t>(sheet.indices.size() / 3);
        std::vector<uint32_t> sorted = sheet.indices;
        std::vector<lr::MeshPart> parts;
        lr::make_mesh_parts(sheet.vertices.data(), sorted.data(), count, parts);
        uint32_t next = 0;
        double volume = 0.0;
        for (const lr::MeshPart& part : parts) {
            CHECK(part.part.first == next);
            CHECK(part.part.count >= 1);
            CHECK(part.part.count <= lr::most_part_triangles);
            next += part.part.count;
            for (uint32_t i = 3 * part.part.first; i < 3 * next; ++i) {
                const float* const v = sheet.vertices.data() + size_t{3} * sorted[i];
                const Box point{{v[0], v[1], v[2]}, {v[0], v[1], v[2]}};
                if (!lr::overlap(part.box, point)) FAIL("a corner is outside");
            }
            const Vector e = part.box.high - part.box.low;
            if (e.x < 2.0f) volume += static_cast<double>(e.x * e.z);
        }
        CHECK(next == count);
        if (n == 40) {
            CHECK(parts.back().part.count == 1); // the large one
            CHECK(parts.size() < count / 4);     // 8 each, or nearly
            CHECK(volume < 3.0);                 // of a sheet of 1 m^2: neighbours
            CHECK(sorted[3 * (count - 1)] == 41u * 41u);
        }
        const auto triangles_of = [](const std::vector<uint32_t>& indices) {
            std::vector<std::array<uint32_t, 3>> all;
            for (size_t i = 0; i < indices.size(); i += 3) all.push_back({indices[i], indices[i + 1], indices[i + 2]});
            std::sort(all.begin(), all.end());
            return all;
        };
        CHECK(triangles_of(sorted) == triangles_of(sheet.indices));
    }
}

TEST_CASE("geometries are kept while they are used, and found again among hundreds") {
    Random random(11);
    lr::Allocator allocator;
    {
        lr::GeometryStore store(allocator);
        struct Kept {
            std::vector<float> vertices;
            std::vector<lr::SharedGeometry*> users;
        };
        std::vector<Kept> all(200);
        for (size_t i = 0; i < all.size(); ++i) all[i].vertices = tetrahedron(1.0f + static_cast<float>(i));
        for (int round = 0; round < 5000; ++round) {
            Kept& one = all[random.below(200)];
            if (random.below(2) == 0 && !one.users.empty()) {
                store.release(one.users.back());
                one.users.pop_back();
            } else {
                lr::SharedGeometry* shared = nullptr;
                REQUIRE(store.acquire(hull_collider(one.vertices), shared) == LR_OK);
                if (!one.users.empty() && one.users[0] != shared) FAIL("not shared");
                if (shared->box.high.x != one.vertices[3]) FAIL("another's");
                one.users.push_back(shared);
            }
            const Kept& any = all[random.below(200)];
            if (!any.users.empty() && store.find(lr::ColliderKind::hull, any.users[0]->hash) != any.users[0])
                FAIL("lost");
        }
        for (Kept& one : all)
            for (lr::SharedGeometry* shared : one.users) store.release(shared);
    }
    CHECK(allocator.bytes() == 0);
}
