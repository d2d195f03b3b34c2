// Bodies dropped into a bin: the energy of the pile, its sleep, and overlaps in it.
#include "support/body_contact.h"
#include "support/quick.h"

using namespace test;

namespace {

constexpr double gravity = 9.81;
const uint32_t dropped = quick() ? 20 : 60;
constexpr int frames = 240;

double energy_of(const World& world, lr_batch batch, const lr_asset_info& info) {
    const lr_batch_view v = view_of(world, batch);
    const std::vector<Velocity> u = velocities_of(world, batch);
    double sum = 0.0;
    for (uint32_t i = 0; i < v.count; ++i) {
        sum += gravity * (info.mass - info.fluid_density * info.volume) * wide(v.position[1][i]);
        const Quat q{wide(v.orientation[0][i]), wide(v.orientation[1][i]), wide(v.orientation[2][i]),
                     wide(v.orientation[3][i])};
        const Vec speed = to_body(q, vec(u[i].linear)), spin = to_body(q, vec(u[i].angular));
        for (size_t k = 0; k < 3; ++k) {
            sum += 0.5 * (info.mass + info.added_mass[7 * k]) * speed[k] * speed[k];
            sum += 0.5 * (info.inertia[4 * k] + info.added_mass[7 * (k + 3)]) * spin[k] * spin[k];
        }
    }
    return sum;
}

void add_bin(const World& world, float half, float high) {
    add_collider(world, collider_desc(LR_COLLIDER_PLANE));
    for (int side = 0; side < 4; ++side) {
        const bool x = side % 2 == 0;
        lr_collider_desc wall = box_collider(x ? half : 2.0f * half, high, x ? 2.0f * half : half);
        wall.position[x ? 0 : 2] = side < 2 ? 2.0f * half : -2.0f * half;
        add_collider(world, wall);
    }
}

} // namespace

TEST_CASE("a pile in a bin loses energy, hardly overlaps, and nothing is outside, boxes and cards come to rest") {
    struct Kind {
        const char* name;
        Asset asset;
        float half;
        double awake; // largest share awake after four seconds
    };
    const Kind kinds[] = {{"boxes", make(rigid_box(0.04, 0.03, 0.05, 300.0)), 0.12f, 0.1},
                          {"cards", make(rigid_box(0.05, 0.0006, 0.035, 600.0)), 0.12f, 0.1},
                          {"flat ellipsoids", make(ellipsoid(0.03, 0.02, 0.001, 500.0)), 0.12f, 1.0}};
    for (const Kind& kind : kinds) {
        Random random(5);
        const World world = make(world_desc());
        const lr_batch batch = add_batch(world, unloaded(), kind.asset, dropped);
        lr_batch_contact c = contact_desc(0.5f, 0.1f, 0.05f);
        c.flags = 0;
        set_contact(world, batch, c);
        set_pair(world, batch, batch);
        add_bin(world, kind.half, 2.0f);
        const auto room = 0.6 * wide(kind.half);
        for (uint32_t i = 0; i < dropped; ++i) {
            const double x = random.uniform(-room, room), z = random.uniform(-room, room);
            add_body(world, batch, turned_anyhow(random, {x, 0.06 + 0.006 * i, z}));
        }
        const lr_asset_info info = info_of(kind.asset);
        const double unit = info.mass * gravity * info.length_d * dropped; // of all bodies, relative to their length
        double least = energy_of(world, batch, info), rise = 0.0;
        for (int n = 0; n < frames; ++n) {
            steps(world, 1, 1.0f / 60.0f, 2);
            const double now = energy_of(world, batch, info);
            if (n >= frames / 3) rise = std::max(rise, (now - least) / unit);
            least = std::min(least, now);
        }
        const lr_batch_view v = view_of(world, batch);
        double out = 0.0, low = 1.0;
        for (uint32_t i = 0; i < v.count; ++i) {
            out = std::max({out, std::abs(wide(v.position[0][i])), std::abs(wide(v.position[2][i]))});
            low = std::min(low, wide(v.position[1][i]));
        }
        const double awake = wide(static_cast<float>(v.awake_count)) / dropped;
        MESSAGE(std::string(kind.name) << ": energy rises by " << rise << ", out " << out / wide(kind.half)
                                       << ", lowest " << low / info.length_d << ", awake " << awake);
        CHECK(rise < 0.02);
        CHECK(out < wide(kind.half));
        CHECK(low > -0.02 * info.length_d);
        CHECK(awake <= kind.awake);
    }
}

// A ball that spins kept the points of its surface, which turned away from those that it touched: in heaps of little friction, where balls spin
// longest, all sank to the ground and lay in each other.
TEST_CASE("balls rest on each other in a bin, with usual friction, with little, and with none") {
    constexpr double radius = 0.01;
    constexpr uint32_t count = 200;
    struct Fall {
        float friction;
        uint32_t substeps, seed;
    };
    // If contacts on a rounding turned with the ball, those with one substep would lie in each other as a hot gas, at 1 m/s (rms).
    for (const auto [friction, substeps, seed] : {Fall{0.5f, 2, 5},
                                                  {0.1f, 2, 5},
                                                  {0.05f, 2, 5},
                                                  {0.05f, 2, 2},
                                                  {0.0f, 2, 5},
                                                  {0.5f, 1, 5},
                                                  {0.1f, 1, 5},
                                                  {0.05f, 1, 2}}) {
        CAPTURE(friction);
        CAPTURE(substeps);
        const World world = make(world_desc());
        const lr_batch batch = add_batch(world, unloaded(), make(ellipsoid(radius, radius, radius, 900.0)), count);
        lr_batch_contact c = contact_desc(friction, 0.1f, 0.05f);
        c.flags = 0;
        set_contact(world, batch, c);
        set_pair(world, batch, batch);
        add_bin(world, 0.06f, 1.0f);
        Random random(seed);
        for (uint32_t i = 0; i < count; ++i) {
            const Vec place{(i % 4 - 1.5) * 2.6 * radius, (2.0 + 2.6 * (i / 16)) * radius,
                            (i / 4 % 4 - 1.5) * 2.6 * radius};
            add_body(
                world, batch,
                turned_anyhow(random, place + Vec{random.uniform(-0.002, 0.002), 0.0, random.uniform(-0.002, 0.002)}));
        }
        steps(world, 240, 1.0f / 60.0f, substeps);
        const lr_batch_view v = view_of(world, batch);
        int deep = 0;
        double height = 0.0;
        const auto at = [&](uint32_t i) {
            return Vec{wide(v.position[0][i]), wide(v.position[1][i]), wide(v.position[2][i])};
        };
        for (uint32_t i = 0; i < count; ++i) {
            height += at(i)[1] / count;
            for (uint32_t k = 0; k < i; ++k) deep += length(at(i) - at(k)) < 1.9 * radius ? 1 : 0;
        }
        MESSAGE("friction " << friction << ": " << deep << " pairs overlap by more than a tenth, mean height " << height
                            << ", awake " << v.awake_count);
        CHECK(deep <= 2);
        if (friction > 0.0f) CHECK(v.awake_count == 0); // nothing stops them from rolling on
    }
}

// In a short substep nearly all of the correction undoes older overlap: none of that may become velocity, in that substep or in the next long one.
TEST_CASE("a heap stays at rest in slow motion, and when time goes on") {
    for (const Asset& asset : {make(ellipsoid(0.03, 0.03, 0.03, 200.0)), make(rigid_box(0.06, 0.03, 0.05, 300.0))}) {
        Random random(5);
        const World world = make(world_desc());
        const lr_batch batch = add_batch(world, unloaded(), asset, dropped);
        set_contact(world, batch, contact_desc(0.5f, 0.1f, 0.05f)); // bodies do not fall asleep
        set_pair(world, batch, batch);
        add_bin(world, 0.12f, 1.0f);
        for (uint32_t i = 0; i < dropped; ++i)
            add_body(world, batch,
                     turned_anyhow(random, {random.real(-0.05, 0.05), 0.1 + 0.03 * i, random.real(-0.05, 0.05)}));
        steps(world, 600, 1.0f / 60.0f, 2);
        // m^2/s^2: kinetic energy over the mass of one, and what bodies that have rolled down since had to lose.
        const auto kinetic = [&] {
            double sum = 0.0;
            for (const Velocity& u : velocities_of(world, batch)) sum += 0.5 * dot(vec(u.linear), vec(u.linear));
            return sum;
        };
        std::vector<double> began;
        const auto fallen = [&] {
            const lr_batch_view v = view_of(world, batch);
            double sum = 0.0;
            for (uint32_t i = 0; i < dropped; ++i) {
                const double y = wide(v.position[1][i]);
                if (began.size() == i) began.push_back(y);
                sum += gravity * std::max(began[i] - y, 0.0);
            }
            return sum;
        };
        REQUIRE(kinetic() < 0.002);
        REQUIRE(fallen() == 0.0);
        for (int round = 0; round < 10; ++round)
            for (const float dt : {1e-6f, 1e-9f, 1e-4f, 1.0f / 60.0f, 1e-5f, 1e-3f}) {
                CAPTURE(round);
                CAPTURE(dt);
                for (int k = 0; k < 4; ++k) {
                    steps(world, 1, dt, 2);
                    REQUIRE(kinetic() < 0.002 + fallen());
                }
            }
    }
}

TEST_CASE("a heap presses none of its bodies through a thin shelf") {
    constexpr uint32_t count = 60;
    constexpr double high = 0.2; // m, the shelf
    const std::vector<float> corners = box_corners(0.5f, 2.5e-3f, 0.5f);
    const Triangles fine = fine_sheet(120, 0.01f, [](float, float) { return 0.0f; });
    const Triangles coarse = fine_sheet(12, 0.1f, [](float, float) { return 0.0f; });
    const lr_collider_desc shelves[] = {box_collider(0.5f, 2.5e-3f, 0.5f), hull_collider(corners), mesh_collider(fine),
                                        mesh_collider(coarse)};
    const Asset kinds[] = {make(rigid_box(0.06, 4e-4, 0.04, 700.0)), make(rigid_box(0.06, 0.003, 0.002, 400.0))};
    for (lr_collider_desc shelf : shelves)
        for (const Asset& kind : kinds) {
            CAPTURE(shelf.kind);
            CAPTURE(shelf.triangle_count);
            const World world = make(world_desc());
            add_collider(world, collider_desc(LR_COLLIDER_PLANE));
            shelf.position[1] = narrow(high);
            add_collider(world, shelf);
            const lr_batch batch = add_batch(world, unloaded(), kind, count);
            set_pair(world, batch, batch);
            Random random(7);
            std::vector<lr_body> bodies;
            for (uint32_t i = 0; i < count; ++i) {
                lr_body_desc d = turned_anyhow(
                    random, {random.uniform(-0.07, 0.07), high + 0.08 + 0.006 * i, random.uniform(-0.07, 0.07)});
                d.linear_velocity[1] = -1.0f;
                bodies.push_back(add_body(world, batch, d));
            }
            steps(world, 90, 1.0f / 60.0f);
            // None is far enough from the middle to fall off.
            for (lr_body body : bodies) CHECK(wide(state_of(world, body).position[1]) > high - 2.5e-3);
        }
}
