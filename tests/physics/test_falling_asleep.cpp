// Falling asleep by lack of progress: a trembling body sleeps, a creeping, rolling or rotating one does not.
#include "asset/asset_file.h"
#include "base/convex_hull.h"
#include "support/asset_bytes.h"
#include "support/body_contact.h"
#include "support/heap_quality.h"

#include <cmath>
#include <numbers>

using namespace test;

namespace {

// Hills and valleys of triangles about as large as the bodies, which lie on edges and across them.
std::vector<float> waves(uint32_t n, float spacing, float size) {
    std::vector<float> heights;
    const float half = 0.5f * spacing * static_cast<float>(n - 1);
    for (uint32_t k = 0; k < n; ++k)
        for (uint32_t i = 0; i < n; ++i) {
            const float x = spacing * static_cast<float>(i) - half, z = spacing * static_cast<float>(k) - half;
            heights.push_back(0.45f * size * std::sin(x / size / 2.5f) * std::cos(z / size / 3.1f));
        }
    return heights;
}

// n samples across, about the origin; heights: must last as long.
lr_collider_desc uneven_ground(const std::vector<float>& heights, uint32_t n, float reach) {
    lr_collider_desc ground = heightfield_collider(heights, n, reach);
    ground.position[0] = ground.position[2] = -0.5f * static_cast<float>(n - 1) * reach;
    return ground;
}

// The loads of an ellipsoid, and the hull of the points.
Asset asset_with_hull(const lr::shape::EllipsoidSpec& spec, const std::vector<lr::shape::HullPoint>& points) {
    lr::AssetData data;
    lr::Faults faults;
    REQUIRE(lr::shape::ellipsoid_body(spec, data, faults));
    data.turbulence = lr::shape::decay_table(data, 1.0);
    lr::shape::ConvexHull hull;
    REQUIRE(lr::shape::convex_hull(points, hull) == lr::shape::HullOutcome::done);
    data.hull = {};
    for (const uint32_t corner : hull.points)
        for (const double x : points[corner]) data.hull.vertices.push_back(narrow(x));
    for (const auto& triangle : hull.triangles)
        data.hull.triangles.insert(data.hull.triangles.end(), triangle.begin(), triangle.end());
    const std::vector<uint8_t> bytes = lr::write_asset(data);
    lr_asset* asset = nullptr;
    const lr_status status = lr_asset_load_memory(bytes.data(), bytes.size(), &asset);
    INFO(std::string(lr_last_error()));
    REQUIRE(status == LR_OK);
    return Asset(asset);
}

// A petal: a thin bowl 12 mm x 11 mm, whose hull has a curved side. Heights in m; low: of its bottom.
Asset petal(double height = 0.0012, double low = -0.0006, double density = 350.0) {
    lr::shape::EllipsoidSpec spec;
    spec.semi_axes = {0.006, 0.0055, 0.0006};
    spec.density = density;
    std::vector<lr::shape::HullPoint> points{{0.0, 0.0, low}};
    for (int ring = 1; ring <= 6; ++ring)
        for (int k = 0; k < 24; ++k) {
            const double r = ring / 6.0, turn = std::numbers::pi * (k + 0.5 * (ring % 2)) / 12.0;
            points.push_back({0.006 * r * std::cos(turn), 0.0055 * r * std::sin(turn), height * r * r + low});
        }
    return asset_with_hull(spec, points);
}

// A leaf of 80 mm x 40 mm, curled along its midrib and twisted: it lies on a keel with its rims some millimetres above the ground.
Asset twisted_leaf() {
    lr::shape::EllipsoidSpec spec;
    spec.semi_axes = {0.04, 0.02, 0.002};
    spec.density = 40.0;
    std::vector<lr::shape::HullPoint> points;
    for (int ring = 0; ring <= 2; ++ring)
        for (int k = 0; k < 24; ++k) {
            const double r = ring / 2.0, turn = std::numbers::pi * k / 12.0;
            const double x = 0.04 * r * std::cos(turn), y = 0.02 * r * std::sin(turn), up = 6.0 * y * (y + x) - 0.0005;
            points.push_back({x, y, up});
            points.push_back({x, y, up + 0.0003});
        }
    return asset_with_hull(spec, points);
}

// Half extents of a plate of 0.18 g, and the plate.
constexpr Vec plate_half = {0.035, 0.0002, 0.02};
Asset plate() {
    lr::shape::EllipsoidSpec spec;
    spec.semi_axes = {0.039, 0.00023, 0.0223};
    spec.density = 215.0;
    std::vector<lr::shape::HullPoint> points;
    for (uint32_t i = 0; i < 8; ++i) {
        points.push_back({});
        for (uint32_t k = 0; k < 3; ++k) points.back()[k] = (i >> k & 1u) != 0 ? plate_half[k] : -plate_half[k];
    }
    return asset_with_hull(spec, points);
}

} // namespace

// A substep's fall can end on the ground: what lay that high must not be put back there.
TEST_CASE("balls fall asleep on the ground, and none above it by the fall of a substep") {
    const Triangles sheet{{-9.0f, 0.0f, -9.0f, 9.0f, 0.0f, -9.0f, 0.0f, 0.0f, 9.0f}, {0, 1, 2}};
    const std::pair<float, uint32_t> clocks[] = {{1.0f / 30.0f, 1}, {1.0f / 60.0f, 1}, {1.0f / 60.0f, 2}};
    for (const lr_collider_desc& ground : {collider_desc(LR_COLLIDER_PLANE), mesh_collider(sheet)})
        for (const auto& [dt, substeps] : clocks) {
            CAPTURE(ground.kind);
            CAPTURE(dt);
            CAPTURE(substeps);
            const World world = make(world_desc());
            add_collider(world, ground);
            const lr_batch batch = add_batch(world, make(ellipsoid(0.03, 0.03, 0.03, 200.0)), 300);
            for (int i = 0; i < 300; ++i)
                add_body(world, batch, at_rest_at({0.1 * (i % 20) - 1.0, 0.1 + 0.5 * i / 300.0, 0.1 * (i / 20) - 1.0}));
            steps(world, static_cast<int>(std::lround(8.0f / dt)), dt, substeps);
            const lr_batch_view v = view_of(world, batch);
            CHECK(v.awake_count == 0);
            float highest = 0.0f;
            for (uint32_t i = 0; i < v.count; ++i) highest = std::max(highest, v.position[1][i]);
            CHECK(highest < 0.03f + 2e-3f * 0.03f);
        }
}

// In a fall of a substep all of a shallow bowl can reach the ground: its contacts must be those below its middle, not those at its rim; those of a boat
// lie on both sides of its keel.
TEST_CASE("petals and twisted leaves lie still on planes, boxes, hulls and meshes, however coarse the steps") {
    const std::array assets{petal(), twisted_leaf()};
    const Triangles sheet = fine_sheet(40, 0.05f, [](float, float) { return 0.0f; });
    lr_collider_desc table = box_collider(1.0f, 0.1f, 1.0f);
    const std::vector<float> corners = box_corners(1.0f, 0.1f, 1.0f);
    lr_collider_desc slab = hull_collider(corners);
    table.position[1] = slab.position[1] = -0.1f;
    for (const lr_collider_desc& ground : {collider_desc(LR_COLLIDER_PLANE), table, slab, mesh_collider(sheet)})
        for (const Asset& asset : assets)
            for (const auto& [rate, substeps] : {std::pair{30, 1}, {60, 1}, {60, 2}, {60, 4}}) {
                CAPTURE(ground.kind);
                CAPTURE(&asset - assets.data());
                CAPTURE(rate);
                CAPTURE(substeps);
                const World world = make(world_desc());
                add_collider(world, ground);
                const lr_batch batch = add_batch(world, asset, 100);
                Random random(8);
                for (uint32_t i = 0; i < 100; ++i)
                    add_body(world, batch, turned_anyhow(random, {0.05 * (i % 10), 0.2, 0.05 * (i / 10)}));
                steps(world, 8 * rate, 1.0f / static_cast<float>(rate), static_cast<uint32_t>(substeps));
                CHECK(view_of(world, batch).awake_count == 0);
            }
}

TEST_CASE("coins, rods and bricks come to rest on uneven ground") {
    const std::array<std::array<double, 3>, 3> sizes{{{0.02, 0.002, 0.018}, {0.2, 0.002, 0.002}, {0.04, 0.03, 0.05}}};
    for (const auto& size : sizes) {
        CAPTURE(size[0]);
        const float reach = narrow(0.5 * std::hypot(size[0], std::hypot(size[1], size[2])));
        const double apart = 4.2 * wide(reach);
        const World world = make(world_desc());
        const Asset asset = make(rigid_box(size[0], size[1], size[2], 800.0));
        const lr_batch batch = add_batch(world, asset, 64);
        const std::vector<float> heights = waves(81, reach, reach);
        add_collider(world, uneven_ground(heights, 81, reach));
        Random random(9);
        for (uint32_t i = 0; i < 64; ++i)
            add_body(world, batch,
                     turned_anyhow(random, {apart * (i % 8 - 3.5), 3.0 * wide(reach), apart * (i / 8 - 3.5)}));
        steps(world, 600, 1.0f / 60.0f, 4);
        CHECK(view_of(world, batch).awake_count <= 1);
    }
}

TEST_CASE("a body that slides or turns slowly but steadily does not fall asleep") {
    const World world = make(world_desc());
    const Asset asset = make(rigid_box(0.1, 0.05, 0.1, 500.0));
    const lr_batch batch = add_batch(world, unloaded(), asset, 2);
    // A belt, and a rotating plate: 3 % of the reach in a second.
    const float reach = narrow(0.5 * std::sqrt(0.1 * 0.1 + 0.05 * 0.05 + 0.1 * 0.1));
    lr_collider_desc belt = box_collider(1.0f, 0.1f, 1.0f), table = belt;
    belt.position[1] = table.position[1] = -0.1f;
    table.position[0] = 5.0f;
    belt.linear_velocity[0] = 0.03f * reach, table.angular_velocity[1] = 0.04f;
    const lr_collider belt_id = add_collider(world, belt), table_id = add_collider(world, table);
    lr_body_desc d = body_desc();
    d.position[1] = 0.025f;
    const lr_body slides = add_body(world, batch, d);
    d.position[0] = 5.0f;
    const lr_body turns = add_body(world, batch, d);
    for (int second = 0; second < 5; ++second) {
        steps(world, 60, 1.0f / 60.0f, 4);
        CHECK(state_of(world, slides).sleep_state == LR_SLEEP_AWAKE);
        CHECK(state_of(world, turns).sleep_state == LR_SLEEP_AWAKE);
    }
    CHECK(wide(state_of(world, slides).position[0]) ==
          doctest::Approx(5.0 * wide(belt.linear_velocity[0])).epsilon(0.05));
    // They sleep when these stop.
    for (lr_collider id : {belt_id, table_id}) {
        const lr_collider_motion stop = motion_of(id, LR_MOVE_VELOCITY);
        REQUIRE(lr_collider_move(world.get(), &stop, 1) == LR_OK);
    }
    steps(world, 120, 1.0f / 60.0f, 4);
    CHECK(view_of(world, batch).awake_count == 0);
}

TEST_CASE("a body that trembled long enough half-way through a snapshot comes to rest in the same step") {
    const World world = make(world_desc());
    const Asset asset = make(rigid_box(0.02, 0.002, 0.018, 800.0));
    const lr_batch batch = add_batch(world, asset, 8);
    const float reach = 0.0135f;
    const std::vector<float> heights = waves(41, reach, reach);
    add_collider(world, uneven_ground(heights, 41, reach));
    Random random(12);
    for (uint32_t i = 0; i < 8; ++i)
        add_body(world, batch, turned_anyhow(random, {4.0 * wide(reach) * (i - 3.5), 2.0 * wide(reach), 0.0}));
    for (int frame = 0; frame < 200; ++frame) {
        const std::vector<unsigned char> saved = snapshot_of(world);
        steps(world, 1, 1.0f / 60.0f, 4);
        const uint64_t expected = hash_of(world);
        REQUIRE(lr_world_snapshot_restore(world.get(), saved.data(), saved.size()) == LR_OK);
        steps(world, 1, 1.0f / 60.0f, 4);
        REQUIRE(hash_of(world) == expected);
    }
    CHECK(view_of(world, batch).awake_count <= 1);
}

// Sweeps end before they converge, and leave high heaps a tremble that kept half of the plates awake for seconds.
TEST_CASE("a high heap of plates comes to rest within four seconds, and they do not sleep in each other" *
          doctest::test_suite("long-exact")) {
    constexpr uint32_t across = 3, landing = 220;
    struct Heap {
        uint32_t plates, seed, substeps;
    };
    // In denser heaps sweeps end before they converge. With a start of the velocities that does not balance 1,085 of the first 1,200 are awake, with
    // a warm start of the path by all of its former impulses 558 of the last, which swing (contact.md, 13). Pushed out of sleeping plates at once, and
    // waking all whose boxes they fall through, 174 and 137 of the same.
    // How many are awake, how deep plates lie in each other, and how high, is chance in a single heap: the sum and the means count. With one projection
    // of the whole path 99 of these are awake, 49 in one heap. If only 32 sleeping plates with boxes near a plate's count, a tenth lie deep with one
    // substep, and 1.3 % with four. If no more of deep overlap is undone than of shallow, 4.5 and 0.02 %.
    const Heap heaps[] = {{1000, 1, 1}, {1000, 2, 1}, {1000, 3, 1}, {1000, 2, 2}, {1000, 3, 2},
                          {1200, 3, 2}, {1200, 4, 2}, {1200, 1, 4}, {1200, 2, 4}, {1200, 3, 4},
                          {1200, 4, 4}, {1200, 5, 4}, {1200, 6, 4}, {1200, 7, 4}, {1200, 8, 4}};
    double deep[3] = {}, high[3] = {}; // with one substep, two and four
    uint32_t heaps_of[3] = {};
    uint32_t plates_in_all = 0, awake_in_all = 0;
    for (const auto [plates, seed, substeps] : heaps) {
        CAPTURE(plates);
        CAPTURE(seed);
        CAPTURE(substeps);
        const World world = make(world_desc());
        const lr_batch batch = add_batch(world, plate(), plates);
        lr_batch_contact c = contact_desc(0.5f, 0.0f);
        c.flags = 0;
        set_contact(world, batch, c);
        set_pair(world, batch, batch);
        add_collider(world, collider_desc(LR_COLLIDER_PLANE));
        Random random(seed);
        uint32_t started = 0;
        for (uint32_t step = 0; step < landing; ++step) {
            for (; started < plates && started * 180 < plates * (step + 1); ++started) {
                const uint32_t cell = started * 7 % (across * across);
                lr_body_desc d =
                    turned_anyhow(random, {0.082 * (cell % across) - 0.082, 0.5, 0.082 * (cell / across) - 0.082});
                d.linear_velocity[1] = -2.2f;
                add_body(world, batch, d);
            }
            steps(world, 1, 1.0f / 60.0f, substeps);
        }
        steps(world, 240, 1.0f / 60.0f, substeps);
        const HeapState state = heap_state(world.get(), batch);
        const HeapQuality quality = heap_quality(plate_half, state.poses);
        MESSAGE(state.awake << " awake, " << quality.share_deep << " deep, mean height " << quality.height_mean);
        CHECK(state.awake <= plates / 100);
        plates_in_all += plates, awake_in_all += state.awake;
        const size_t of = substeps / 2;
        deep[of] += quality.share_deep, high[of] += quality.height_mean, ++heaps_of[of];
        CHECK(quality.share_deep < 0.04);
        // More substeps leave fewer overlaps, and more air.
        CHECK(quality.height_mean > (substeps == 1 ? 0.014 : 0.018));
        CHECK(quality.height_mean < (substeps == 4 ? 0.028 : 0.026) * plates / 1000.0);
    }
    CHECK(awake_in_all <= plates_in_all / 500);
    const double most_deep[] = {0.03, 0.005, 0.002};
    const double least_high[] = {0.015, 0.02, 0.024}; // m
    for (size_t of = 0; of < 3; ++of) {
        CAPTURE(of);
        CHECK(deep[of] < most_deep[of] * heaps_of[of]);
        CHECK(high[of] > least_high[of] * heaps_of[of]);
    }
}

// In a heap it would be thrown into the next sleeping body, and through it.
TEST_CASE("a body that crosses a sleeping one is not thrown out of it") {
    for (const uint32_t substeps : {1u, 2u, 4u}) {
        const World world = make(world_desc());
        const lr_batch batch = add_batch(world, plate(), 2);
        lr_batch_contact c = contact_desc(0.5f, 0.0f);
        c.flags = 0;
        set_contact(world, batch, c);
        set_pair(world, batch, batch);
        lr_body_desc d = at_rest_at({0.0, 0.05, 0.0});
        d.orientation[0] = std::sqrt(0.5f), d.orientation[3] = std::sqrt(0.5f); // level
        const lr_body asleep = add_body(world, batch, d);
        REQUIRE(lr_body_set_sleep(world.get(), &asleep, 1, LR_SLEEP_ASLEEP) == LR_OK);
        d.orientation[0] = 0.6f, d.orientation[3] = 0.8f; // 16 degrees off
        add_body(world, batch, d);
        const std::vector<Pose> before = heap_state(world.get(), batch).poses;
        steps(world, 1, 1.0f / 60.0f, substeps);
        const double moved = largest_movement(plate_half, before, heap_state(world.get(), batch).poses);
        CAPTURE(substeps);
        // A fiftieth of the reach in a substep, and the fall.
        CHECK(moved < substeps * 0.02 * 0.0405 + 0.5 * 9.81 / 3600.0);
    }
}

// Boxes of tilted plates overlap those of dozens of others in a heap. With 32 or 48 of these alone, the first by noise seed, the last of a stack let
// others through.
TEST_CASE("a body meets the one that it touches, however many are near it") {
    constexpr uint32_t stack = 60;
    constexpr double spacing = 0.0015; // m; plates count as 1.25 mm thick against each other
    const double third = std::sqrt(1.0 / 3.0);
    const Vec normal{-third, -third, -third}; // whose box is first along the axes finds the pairs
    for (const bool asleep : {false, true})
        for (const uint32_t substeps : {1u, 2u, 4u}) {
            CAPTURE(asleep);
            CAPTURE(substeps);
            lr_world_desc world_of = world_desc();
            put(world_of.gravity, Vec{});
            const World world = make(world_of);
            const lr_batch batch = add_batch(world, plate(), stack + 1);
            lr_batch_contact c = contact_desc(0.5f, 0.0f);
            c.flags = 0;
            set_contact(world, batch, c);
            set_pair(world, batch, batch);
            lr_body_desc d = body_desc();
            put(d.orientation, normalised(Quat{third, 0.0, -third, 1.0 + third})); // from y to the normal
            lr_body top{};
            for (uint32_t i = 0; i < stack; ++i) {
                put(d.position, spacing * (i + 1.0 - stack) * normal);
                d.noise_seed = i + 2;
                top = add_body(world, batch, d);
                if (asleep) REQUIRE(lr_body_set_sleep(world.get(), &top, 1, LR_SLEEP_ASLEEP) == LR_OK);
            }
            put(d.position, 0.002 * normal);
            put(d.linear_velocity, -0.1 * normal);
            d.noise_seed = 1; // or first by noise seed, within one cell
            const lr_body comes = add_body(world, batch, d);
            steps(world, 1, 1.0f / 60.0f, substeps);
            const double gap = dot(vec(state_of(world, comes).position) - vec(state_of(world, top).position), normal);
            CHECK(gap > 0.001);
            CHECK(gap < 0.0016);
        }
}

// Where a substep turns a stone from rim to rim, its nearest point alone throws it further each time. Over a joint of two boxes too.
TEST_CASE("stones that rock faster than a substep resolves come to rest") {
    const Triangles sheet = fine_sheet(40, 0.05f, [](float, float) { return 0.0f; });
    lr_collider_desc table = box_collider(1.0f, 0.1f, 1.0f), tile = box_collider(0.02f, 0.1f, 0.02f);
    table.position[1] = -0.1f;
    const Asset stone = make(ellipsoid(0.01, 0.007, 0.004, 2500.0));
    for (const lr_collider_desc& ground : {collider_desc(LR_COLLIDER_PLANE), table, mesh_collider(sheet), tile})
        for (const int rate : {30, 60}) {
            CAPTURE(ground.kind);
            CAPTURE(ground.size[0]);
            CAPTURE(rate);
            const World world = make(world_desc());
            Random random(4);
            const bool tiles = ground.size[0] == tile.size[0];
            for (int k = 0; k < (tiles ? 400 : 1); ++k) {
                lr_collider_desc d = ground;
                if (tiles) put(d.position, Vec{0.04 * (k % 20), random.uniform(-0.1005, -0.1), 0.04 * (k / 20)});
                add_collider(world, d);
            }
            const lr_batch batch = add_batch(world, stone, 100);
            for (uint32_t i = 0; i < 100; ++i)
                add_body(world, batch, turned_anyhow(random, {0.2 + 0.035 * (i % 10), 0.1, 0.2 + 0.035 * (i / 10)}));
            steps(world, 6 * rate, 1.0f / static_cast<float>(rate));
            CHECK(view_of(world, batch).awake_count <= 3);
        }
}

// On many tiles the contacts that are kept must hold both ends of a body; and walls within the floor must not push it aside.
TEST_CASE("cards, leaves and bricks lie still on tiles of uneven height, as boxes and as one mesh") {
    const Asset card = make(rigid_box(0.06, 0.0004, 0.04, 400.0)), bent = twisted_leaf(),
                block = make(rigid_box(0.012, 0.009, 0.007, 2500.0));
    for (const Asset* asset : {&card, &bent, &block})
        for (const bool one : {false, true}) {
            CAPTURE(asset == &card);
            CAPTURE(asset == &block);
            CAPTURE(one);
            const World world = make(world_desc());
            Random random(4);
            Triangles floor;
            const float half = asset == &block ? 0.02f : 0.01f;
            for (int k = 0; k < 1024; ++k) {
                lr_collider_desc d = box_collider(half, 0.05f, half);
                put(d.position, Vec{2.0 * wide(half) * (k % 32 - 16), random.uniform(-0.05 - 0.03 * wide(half), -0.05),
                                    2.0 * wide(half) * (k / 32 - 16)});
                if (!one) add_collider(world, d);
                join(floor, closed_box(d.size[0], d.size[1], d.size[2]), {d.position[0], d.position[1], d.position[2]});
            }
            if (one) add_collider(world, mesh_collider(floor));
            const lr_batch batch = add_batch(world, *asset, 25);
            for (int i = 0; i < 25; ++i)
                add_body(world, batch, turned_anyhow(random, {0.08 * (i % 5) - 0.16, 0.06, 0.08 * (i / 5) - 0.16}));
            steps(world, 240, 1.0f / 60.0f);
            uint32_t awake = 0;
            const lr_batch_view v = view_of(world, batch);
            for (uint32_t i = 0; i < v.awake_count; ++i) awake += v.position[1][i] > -0.1f; // the others fell beside it
            CHECK(awake <= 2);
        }
}

// The far side of a board is within a body's reach, but behind its floor.
TEST_CASE("leaves and petals fall asleep on boards in a mesh, however thin") {
    const std::array assets{petal(), twisted_leaf(), plate()};
    for (const Asset& asset : assets)
        for (const float half : {0.0005f, 0.0015f, 0.01f})
            for (const int rate : {30, 60}) {
                CAPTURE(&asset - assets.data());
                CAPTURE(half);
                CAPTURE(rate);
                const World world = make(world_desc());
                Random random(3);
                const Triangles board = closed_box(0.8f, half, 0.8f);
                add_collider(world, mesh_collider(board));
                const lr_batch batch = add_batch(world, asset, 36);
                for (int i = 0; i < 36; ++i)
                    add_body(world, batch, turned_anyhow(random, {0.12 * (i % 6) - 0.3, 0.2, 0.12 * (i / 6) - 0.3}));
                steps(world, 5 * rate, 1.0f / static_cast<float>(rate));
                const lr_batch_view v = view_of(world, batch);
                CHECK(v.awake_count == 0);
                CHECK(std::count_if(v.position[1], v.position[1] + v.count, [](float y) { return y < 0.0f; }) == 0);
            }
}

// Near the edges of a tile no triangle is a floor. A petal is pressed in there until it counts as below the tile, but its centre of mass is not.
TEST_CASE("petals fall through no tiles, be they closed boxes in one mesh or faces with open edges") {
    const Asset bowl = petal(0.0002, -0.0001, 100.0);
    const Triangles face{
        {-0.012f, 0.05f, -0.012f, 0.012f, 0.05f, -0.012f, -0.012f, 0.05f, 0.012f, 0.012f, 0.05f, 0.012f},
        {0, 2, 1, 1, 2, 3}};
    for (const bool open : {false, true})
        for (const uint32_t rate : {30u, 60u}) {
            const World world = make(world_desc());
            Random random(7);
            Triangles floor;
            for (int k = 0; k < 1600; ++k) {
                const float x = 0.024f * static_cast<float>(k % 40 - 20), z = 0.024f * static_cast<float>(k / 40 - 20);
                join(floor, open ? face : closed_box(0.012f, 0.05f, 0.012f),
                     {x, narrow(random.uniform(-0.0501, -0.05)), z});
            }
            add_collider(world, mesh_collider(floor));
            const lr_batch batch = add_batch(world, bowl, 100);
            for (int i = 0; i < 100; ++i)
                add_body(world, batch, turned_anyhow(random, {0.05 * (i % 10) - 0.23, 0.15, 0.05 * (i / 10) - 0.23}));
            steps(world, 4 * static_cast<int>(rate), 1.0f / static_cast<float>(rate));
            const lr_batch_view v = view_of(world, batch);
            int fell = 0;
            for (uint32_t i = 0; i < v.count; ++i) fell += v.position[1][i] < -0.02f;
            CAPTURE(open);
            CAPTURE(rate);
            CHECK(fell == 0);
        }
}

// Leaves over edges of stairs, where a mesh is no floor, need their other rims as on the ground, and must lie as level as there.
TEST_CASE("leaves fall asleep on stairs of closed boxes in one mesh") {
    Triangles stairs;
    const auto add = [&](float from, float to, float low, float high, float half) {
        join(stairs, closed_box(0.5f * (to - from), 0.5f * (high - low), half),
             {0.5f * (from + to), 0.5f * (low + high), 0.0f});
    };
    for (int k = 0; k < 8; ++k) {
        const float step = static_cast<float>(k);
        add(0.1f * step, 0.9f, 0.03f * step, 0.03f * (step + 1.0f), 0.5f);
    }
    add(-3.0f, 5.0f, -0.5f, 0.0f, 3.0f);
    uint32_t awake = 0;
    for (uint64_t seed = 1; seed <= 3; ++seed) {
        const World world = make(world_desc());
        add_collider(world, mesh_collider(stairs));
        const lr_batch batch = add_batch(world, make(ellipsoid(0.03, 0.0005, 0.02, 400.0)), 60);
        Random random(seed);
        for (int i = 0; i < 60; ++i)
            add_body(world, batch, turned_anyhow(random, {0.09 * (i % 10), 0.4, 0.15 * (i / 10) - 0.375}));
        steps(world, 480, 1.0f / 60.0f);
        awake += view_of(world, batch).awake_count;
    }
    CHECK(awake <= 9);
}
