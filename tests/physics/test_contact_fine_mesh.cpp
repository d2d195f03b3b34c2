// Meshes with triangles much finer than a body, or than its motion in a step: more than a list of candidates holds.
#include "support/contact.h"
#include "support/quick.h"

#include <algorithm>
#include <cmath>

using namespace test;

namespace {

struct Kind {
    Asset asset;
    float reach, half; // m; half of the thickness
};
std::vector<Kind> kinds() {
    std::vector<Kind> all;
    const auto plate = [&](double x, double y, double z) {
        all.push_back(
            {make(rigid_box(x, y, z, 500.0)), narrow(0.5 * std::sqrt(x * x + y * y + z * z)), narrow(0.5 * y)});
    };
    plate(0.003, 1e-4, 0.002); // confetti
    plate(0.02, 0.002, 0.02);
    plate(0.1, 3e-4, 0.06);
    return all;
}

float flat(float, float) {
    return 0.0f;
}

} // namespace

TEST_CASE("bodies land and rest on floors of fine triangles as on a plane" * doctest::test_suite("long")) {
    const uint32_t count = quick() ? 8 : 16;
    for (const Kind& kind : kinds())
        for (const float part : {0.1f, 0.5f, 1.3f}) { // of the reach: a cell
            CAPTURE(kind.reach);
            CAPTURE(part);
            const float cell = part * kind.reach;
            const auto cells = static_cast<uint32_t>(40.0f / part); // to 20 reaches from the middle
            const World world = make(world_desc());
            const Triangles floor = fine_sheet(cells, cell, flat);
            add_collider(world, mesh_collider(floor));
            const lr_batch batch = add_batch(world, kind.asset, count);
            Random random(3);
            std::vector<lr_body> bodies;
            for (uint32_t i = 0; i < count; ++i) {
                lr_body_desc d = turned_anyhow(random);
                d.position[0] = kind.reach * random.real(-1, 1), d.position[2] = kind.reach * random.real(-1, 1);
                d.position[1] = 4.0f * kind.reach;
                d.linear_velocity[1] = -std::sqrt(20.0f * 9.81f * kind.reach);
                bodies.push_back(add_body(world, batch, d));
            }
            steps(world, 360, 1.0f / 60.0f, 4);
            uint32_t over = 0, on_edge = 0;
            for (lr_body body : bodies) {
                const lr_body_state s = state_of(world, body);
                if (std::max(std::abs(s.position[0]), std::abs(s.position[2])) > 19.0f * kind.reach)
                    continue; // glided or slid over the edge of the sheet
                ++over;
                CHECK(s.sleep_state == LR_SLEEP_ASLEEP);
                CHECK(s.position[1] > kind.half - 0.01f * kind.reach);
                on_edge += s.position[1] > kind.half + 0.1f * kind.reach;
            }
            CHECK(over > count / 2);
            CHECK(on_edge <= 3); // no more than on a plane
        }
}

TEST_CASE("a floor of triangles is met as a heightfield of the same triangles") {
    constexpr uint32_t n = 40, count = 200;
    constexpr float cell = 0.1f, half = 0.5f * cell * n;
    const auto hills = [](float x, float z) { return 0.1f * std::sin(1.3f * x) * std::cos(1.1f * z); };
    Triangles floor = fine_sheet(n, cell, hills);
    std::vector<float> heights;
    for (size_t i = 0; i < floor.vertices.size(); i += 3) heights.push_back(floor.vertices[i + 1]);
    for (size_t i = 0; i < floor.indices.size(); i += 6) { // the other diagonal of each cell
        uint32_t* const t = floor.indices.data() + i;
        t[2] = t[5], t[3] = t[0], t[4] = t[5], t[5] = t[0] + 1;
    }
    lr_collider_desc field = heightfield_collider(heights, n + 1, cell);
    field.position[0] = field.position[2] = -half;
    const Asset assets[] = {make(rigid_box(0.07, 3e-4, 0.04, 500.0)), make(ellipsoid(0.01, 0.007, 0.004, 2500.0))};
    for (const Asset& asset : assets) {
        CAPTURE(&asset - assets);
        const World worlds[] = {make(world_desc()), make(world_desc())};
        std::vector<lr_body> bodies[2];
        for (int k = 0; k < 2; ++k) {
            add_collider(worlds[k], k == 0 ? field : mesh_collider(floor));
            const lr_batch batch = add_batch(worlds[k], asset, count);
            Random random(5);
            for (uint32_t i = 0; i < count; ++i) {
                lr_body_desc d = turned_anyhow(random, {random.uniform(-1.8, 1.8), 0.0, random.uniform(-1.8, 1.8)});
                d.position[1] = hills(d.position[0], d.position[2]) + random.real(0.005, 0.03);
                bodies[k].push_back(add_body(worlds[k], batch, d));
            }
            steps(worlds[k], 4, 1.0f / 60.0f);
        }
        // Some lie across so many triangles that the general search takes over; it keeps eight contacts, not four.
        uint32_t alike = 0;
        for (uint32_t i = 0; i < count; ++i) {
            const lr_body_state a = state_of(worlds[0], bodies[0][i]), b = state_of(worlds[1], bodies[1][i]);
            alike += length(vec(a.position) - vec(b.position)) < 1e-6;
        }
        CHECK(alike > count * 9 / 10);
    }
}

TEST_CASE("no shot goes through walls of fine triangles" * doctest::test_suite("long-exact")) {
    const uint32_t count = quick() ? 60 : 100;
    for (const Kind& kind : kinds()) {
        CAPTURE(kind.reach);
        const float cell = std::max(0.2f * kind.reach, 1e-3f);
        const World world = make(world_desc());
        REQUIRE(lr_world_set_gravity(world.get(), std::array<float, 3>{}.data()) == LR_OK);
        const auto waves = [&](float x, float z) {
            return 0.3f * kind.reach * std::sin(x / kind.reach) * std::cos(z / kind.reach);
        };
        const Triangles wall = fine_sheet(300, cell, waves);
        add_collider(world, mesh_collider(wall));
        const lr_batch batch = add_batch(world, unloaded(), kind.asset, count);
        Random random(4);
        const float half = 140.0f * cell;
        const float fast = std::min(20.0f, 60.0f * half); // it must not leave the wall within a step
        std::vector<lr_body> bodies;
        for (uint32_t i = 0; i < count; ++i) {
            lr_body_desc d = turned_anyhow(random);
            const float side = i % 2 == 0 ? 1.0f : -1.0f;
            const Vec target{wide(half) * random.uniform(-0.5, 0.5), 0.0, wide(half) * random.uniform(-0.5, 0.5)};
            const Vec aside{0.3 * wide(half) * random.uniform(-1, 1), wide(side) * (3.0 * wide(kind.reach) + 0.05),
                            0.0};
            put(d.position, target + aside);
            const double speed = wide(fast) / length(target - vec(d.position));
            put(d.linear_velocity, speed * (target - vec(d.position)));
            for (float& w : d.angular_velocity) w = random.real(-30, 30);
            bodies.push_back(add_body(world, batch, d));
        }
        // Until they have hit it, and are on their way back.
        std::vector<char> through(count, 0), away(count, 0);
        uint32_t met = 0;
        for (int frame = 0; frame < 30; ++frame) {
            steps(world, 1, 1.0f / 60.0f, 1);
            for (uint32_t i = 0; i < count; ++i) {
                const lr_body_state s = state_of(world, bodies[i]);
                const float side = i % 2 == 0 ? 1.0f : -1.0f;
                // A body that has left the wall sideways can come back on any side.
                away[i] = away[i] || std::max(std::abs(s.position[0]), std::abs(s.position[2])) > half;
                if (!away[i] && side * (s.position[1] - waves(s.position[0], s.position[2])) < -0.2f * kind.reach)
                    through[i] = 1;
            }
        }
        for (uint32_t i = 0; i < count; ++i) {
            const lr_body_state s = state_of(world, bodies[i]);
            met += std::abs(s.linear_velocity[1]) < 0.75f * fast;
        }
        CHECK(std::count(through.begin(), through.end(), 1) == 0);
        CHECK(met > count * 9 / 10);
    }
}

// Slopes of up to 45 degrees, with ridges and valleys at every edge. A body that falls through goes on falling below the ground. Artists wind
// triangles either way.
TEST_CASE("nothing falls through uneven ground of triangles, and all comes to rest, also with one coarse substep" *
          doctest::test_suite("long")) {
    const uint32_t count = quick() ? 16 : 100;
    struct Pace {
        float step, steep; // s; of a cell, up and down
        uint32_t substeps, mixed;
    };
    for (const Kind& kind : kinds())
        for (const float cell : {0.7f * kind.reach, 3.0f * kind.reach, 15.0f * kind.reach})
            for (const Pace& pace : {Pace{1.0f / 60.0f, 0.3f, 2, 0}, Pace{1.0f / 60.0f, 0.3f, 1, 2},
                                     Pace{1.0f / 30.0f, 0.3f, 1, 1}, Pace{1.0f / 30.0f, 0.5f, 1, 0}}) {
                // Where a body falls through two slopes within a substep, not even the swept test holds all.
                const float h = pace.step / static_cast<float>(pace.substeps), fall = 9.81f * h * h;
                if (fall > 2.1f * cell) continue;
                CAPTURE(kind.reach);
                CAPTURE(cell);
                CAPTURE(pace.substeps);
                CAPTURE(pace.mixed);
                const World world = make(world_desc());
                Random heights(7);
                const uint32_t cells = static_cast<uint32_t>(60.0f * kind.reach / cell) + 20;
                const float half = 0.5f * cell * static_cast<float>(cells);
                Triangles ground =
                    fine_sheet(cells, cell, [&](float, float) { return pace.steep * cell * heights.real(-1, 1); });
                // Every second triangle, or every one, the other way round.
                for (size_t t = 0; pace.mixed != 0 && t < ground.indices.size(); t += 3 * size_t{pace.mixed})
                    std::swap(ground.indices[t], ground.indices[t + 1]);
                add_collider(world, mesh_collider(ground));
                const lr_batch batch = add_batch(world, kind.asset, count);
                Random random(6);
                std::vector<lr_body> bodies;
                for (uint32_t i = 0; i < count; ++i) {
                    lr_body_desc d = turned_anyhow(random);
                    d.position[0] = 4.0f * cell * random.real(-1, 1), d.position[2] = 4.0f * cell * random.real(-1, 1);
                    d.position[1] = pace.steep * cell + 3.0f * kind.reach;
                    d.linear_velocity[1] = -1.0f;
                    bodies.push_back(add_body(world, batch, d));
                }
                const float bottom = -pace.steep * cell - kind.reach;
                uint32_t through = 0, beside = 0;
                std::vector<char> gone(count, 0);
                for (int frame = 0; frame < static_cast<int>(6.0f / pace.step); ++frame) {
                    steps(world, 1, pace.step, pace.substeps);
                    for (uint32_t i = 0; i < count; ++i) {
                        const lr_body_state s = state_of(world, bodies[i]);
                        if (gone[i] || s.position[1] > bottom) continue;
                        gone[i] = 1; // beside the sheet, if it glided off
                        (std::max(std::abs(s.position[0]), std::abs(s.position[2])) < half ? through : beside) += 1;
                    }
                }
                CHECK(through == 0);
                CHECK(beside < count / 2);
                if (fall < cell) CHECK(view_of(world, batch).awake_count <= beside + 1 + count / 5);
            }
}

// On its way a body met more triangles than it slid past, and stopped with its whole speed: a plate got from 1 cm to 38 cm, a ball to 10 cm.
TEST_CASE("bodies that slide or roll in a bowl of fine triangles gain no energy") {
    constexpr double gravity = 9.81, radius = 0.5, reach = 0.2; // rad: as far out as they start
    struct Case {
        Asset asset;
        double half; // m, of the thickness
        float friction;
        int rate;
        uint32_t substeps, cells;
        double gain; // m, as a height
    };
    const auto plate = [] { return make(rigid_box(0.07, 0.0004, 0.04, 600.0)); };
    const auto ball = [] { return make(ellipsoid(0.02, 0.02, 0.02, 900.0)); };
    Case cases[] = {{plate(), 2e-4, 0.02f, 60, 2, 200, 1e-3},
                    {plate(), 2e-4, 0.02f, 60, 1, 300, 1e-3},
                    {ball(), 0.02, 0.5f, 60, 1, 300, 1e-3},
                    {ball(), 0.02, 0.5f, 30, 1, 200, 4e-3}};
    for (const Case& c : cases) {
        CAPTURE(c.half);
        CAPTURE(c.cells);
        const World world = make(world_desc());
        const lr_batch batch = add_batch(world, unloaded(), c.asset, 4);
        set_contact(world, batch, contact_desc(c.friction, 0.0f));
        const auto height = [&](double x, double z) {
            return narrow(radius - std::sqrt(radius * radius - std::min(x * x + z * z, 0.2)));
        };
        const Triangles bowl = fine_sheet(c.cells, 1.0f / static_cast<float>(c.cells), height);
        add_collider(world, surface(mesh_collider(bowl), c.friction));
        std::vector<lr_body> bodies;
        for (int k = 1; k <= 4; ++k) {
            const double angle = 0.25 * reach * k, out = radius - c.half - 0.002;
            lr_body_desc d = body_desc();
            put(d.position, Vec{out * std::sin(angle), radius - out * std::cos(angle), 0.003});
            put(d.orientation, about({0, 0, 1}, angle));
            d.linear_velocity[2] = 0.2f;
            bodies.push_back(add_body(world, batch, d));
        }
        const auto energy = [&](lr_body body) {
            const lr_body_state s = state_of(world, body);
            const Vec v = vec(s.linear_velocity);
            return 0.5 * dot(v, v) / gravity + wide(s.position[1]);
        };
        std::vector<double> first;
        for (const lr_body& body : bodies) first.push_back(energy(body));
        for (int n = 0; n < c.rate / (quick() ? 2 : 1); ++n) {
            steps(world, 1, 1.0f / static_cast<float>(c.rate), c.substeps);
            for (size_t k = 0; k < bodies.size(); ++k) CHECK(energy(bodies[k]) - first[k] < c.gain);
        }
    }
}

// The mesh that a body lay on must not make the next one solid on its far side.
TEST_CASE("bodies that left the ground meet a sheet above them from below") {
    const World world = make(world_desc());
    const Asset asset = make(rigid_box(0.06, 0.002, 0.06, 2000.0));
    constexpr uint32_t count = 40;
    const lr_batch batch = add_batch(world, asset, count);
    const Triangles sheet = fine_sheet(4, 0.6f, flat);
    std::vector<lr_body> bodies;
    std::vector<lr_collider> floors;
    const auto add_sheet = [&](uint32_t i, float height) {
        lr_collider_desc d = mesh_collider(sheet);
        d.position[0] = 4.0f * static_cast<float>(i), d.position[1] = height;
        return add_collider(world, d);
    };
    const auto ceiling = [](uint32_t i) { return 1.0f + 0.01f * static_cast<float>(i); };
    for (uint32_t i = 0; i < count; ++i) {
        floors.push_back(add_sheet(i, 0.0f));
        add_sheet(i, ceiling(i));
        lr_body_desc d = body_desc();
        d.position[0] = 4.0f * static_cast<float>(i), d.position[1] = 0.002f;
        bodies.push_back(add_body(world, batch, d));
    }
    steps(world, 10, 1.0f / 30.0f);
    REQUIRE(lr_collider_destroy(world.get(), floors.data(), count) == LR_OK);
    const float upwards[3] = {0.0f, 9.81f, 0.0f};
    REQUIRE(lr_world_set_gravity(world.get(), upwards) == LR_OK);
    steps(world, 60, 1.0f / 30.0f);
    for (uint32_t i = 0; i < count; ++i)
        CHECK(state_of(world, bodies[i]).position[1] == doctest::Approx(ceiling(i) - 0.001f).epsilon(0.003));
}

// Both sheets are near a body that is between them, and look the same way: the side on which it is of one is not that of the other.
TEST_CASE("bodies between two parallel sheets stay there") {
    struct Case {
        bool one_mesh;
        float gap, speed;     // m, m/s
        uint32_t between = 0; // colliders whose slots are between those of the sheets
    };
    constexpr uint32_t count = 30;
    for (const Case& c : {Case{true, 0.05f, 0.5f}, Case{true, 0.05f, 2.0f}, Case{true, 0.08f, 0.5f},
                          Case{true, 0.08f, 2.0f}, Case{false, 0.08f, 0.5f}, Case{false, 0.05f, 0.5f, 254}})
        for (const uint32_t substeps : {1u, 2u}) {
            CAPTURE(c.one_mesh);
            CAPTURE(c.gap);
            CAPTURE(c.speed);
            CAPTURE(c.between);
            lr_world_desc still = world_desc();
            still.gravity[1] = 0.0f;
            const World world = make(still);
            Triangles low = fine_sheet(40, 0.1f, flat),
                      high = fine_sheet(40, 0.1f, [&](float, float) { return c.gap; });
            if (c.one_mesh)
                join(low, high);
            else
                add_collider(world, mesh_collider(high));
            lr_collider_desc far = sphere_collider(0.1f);
            far.position[1] = 1000.0f;
            for (uint32_t i = 0; i < c.between; ++i) add_collider(world, far);
            add_collider(world, mesh_collider(low));
            const Asset asset = make(rigid_box(0.06, 0.002, 0.06, 2000.0));
            const lr_batch batch = add_batch(world, asset, count);
            Random random(3);
            std::vector<lr_body> bodies;
            for (uint32_t i = 0; i < count; ++i) {
                lr_body_desc d = body_desc();
                d.position[0] = random.real(-0.5, 0.5), d.position[2] = random.real(-0.5, 0.5);
                d.position[1] = c.gap * random.real(0.4f, 0.6f);
                d.linear_velocity[1] = i % 2 == 0 ? c.speed : -c.speed;
                bodies.push_back(add_body(world, batch, d));
            }
            steps(world, 60, 1.0f / 30.0f, substeps);
            CHECK(std::all_of(bodies.begin(), bodies.end(), [&](lr_body body) {
                const float y = state_of(world, body).position[1];
                return y > 0.0f && y < c.gap;
            }));
        }
}

// Of a triangle beside a body, over which it slides next, the side must not be left to rounding.
TEST_CASE("cubes stay on a slab of fine triangles, however thin") {
    constexpr uint32_t count = 150;
    constexpr float reach = 0.0433f, half = 0.01f * reach, cell = 0.4f * reach;
    Triangles slab = fine_sheet(60, cell, [&](float, float) { return half; });
    Triangles below = fine_sheet(60, cell, [&](float, float) { return -half; });
    std::reverse(below.indices.begin(), below.indices.end()); // turned over
    join(slab, below);
    const World world = make(world_desc());
    add_collider(world, mesh_collider(slab));
    const Asset asset = make(rigid_box(0.05, 0.05, 0.05, 500.0));
    const lr_batch batch = add_batch(world, asset, count);
    Random random(5);
    for (uint32_t i = 0; i < count; ++i) {
        lr_body_desc d = turned_anyhow(random);
        d.position[0] = 6.0f * reach * random.real(-1, 1), d.position[2] = 6.0f * reach * random.real(-1, 1);
        d.position[1] = half + reach * random.real(1.2f, 2.2f);
        d.linear_velocity[1] = -1.0f;
        for (float& w : d.angular_velocity) w = random.real(-10, 10);
        add_body(world, batch, d);
    }
    steps(world, 40, 1.0f / 60.0f);
    const lr_batch_view v = view_of(world, batch);
    const float* const y = v.position[1];
    CHECK(std::count_if(y, y + count, [](float height) { return height < 0.5f * reach; }) == 0);
}

TEST_CASE("no card goes through a groove that is narrower than itself" * doctest::test_suite("long")) {
    const uint32_t count = quick() ? 10 : 100;
    for (const Kind& kind : kinds())
        for (const float width : {0.1f, 0.3f, 0.7f}) // of the reach
            for (const float depth : {0.35f, 0.7f, 1.5f})
                for (const float speed : {5.0f, 20.0f}) {
                    CAPTURE(kind.reach);
                    CAPTURE(width);
                    CAPTURE(depth);
                    CAPTURE(speed);
                    const float half = 0.5f * width * kind.reach, deep = depth * kind.reach, far = 10.0f;
                    Triangles ground; // a V along z
                    const std::array<std::array<float, 2>, 5> profile{
                        {{-far, 0.0f}, {-half, 0.0f}, {0.0f, -deep}, {half, 0.0f}, {far, 0.0f}}};
                    constexpr uint32_t pieces = 12;
                    for (uint32_t k = 0; k <= pieces; ++k)
                        for (const auto& [x, y] : profile)
                            ground.vertices.insert(ground.vertices.end(),
                                                   {x, y, far * (2.0f * static_cast<float>(k) / pieces - 1.0f)});
                    for (uint32_t k = 0; k < pieces; ++k)
                        for (uint32_t i = 0; i < 4; ++i) {
                            const uint32_t a = i + 5 * k, b = a + 5;
                            ground.indices.insert(ground.indices.end(), {a, b, a + 1, a + 1, b, b + 1});
                        }
                    const World world = make(world_desc());
                    add_collider(world, mesh_collider(ground));
                    const lr_batch batch = add_batch(world, kind.asset, count);
                    Random random(6);
                    std::vector<lr_body> bodies;
                    for (uint32_t i = 0; i < count; ++i) {
                        lr_body_desc d = turned_anyhow(random);
                        d.position[0] = 0.5f * kind.reach * random.real(-1, 1);
                        d.position[1] = kind.reach * random.real(1.2f, 2.2f);
                        d.position[2] = 5.0f * kind.reach * random.real(-1, 1);
                        d.linear_velocity[1] = -speed;
                        for (float& w : d.angular_velocity) w = random.real(-10, 10);
                        bodies.push_back(add_body(world, batch, d));
                    }
                    // Half a second: none has reached the edge, whichever way it was turned.
                    steps(world, 30, 1.0f / 60.0f, 2);
                    const auto is_through = [&](lr_body body) {
                        const lr_body_state s = state_of(world, body);
                        return s.position[1] < -deep - 1.05f * kind.reach &&
                               std::max(std::abs(s.position[0]), std::abs(s.position[2])) < 0.9f * far;
                    };
                    CHECK(std::count_if(bodies.begin(), bodies.end(), is_through) == 0);
                }
}
