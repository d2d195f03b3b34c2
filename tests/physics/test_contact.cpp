// Friction, restitution and rolling on colliders against closed forms. A body moves the fluid around it: along a slope its inertia
// is m + A, and the pull is its weight minus its buoyancy.
#include "support/contact.h"
#include "support/quick.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace test;

namespace {

constexpr double gravity = 9.81, degree = std::numbers::pi / 180.0;

// A surface that slopes down along +x by an angle, through the origin.
struct Slope {
    std::vector<float> heights, corners;
    Triangles sheet;
    lr_collider_desc desc{};
    Slope(int32_t kind, double angle, double size, float friction) {
        const auto s = narrow(size);
        Vec shift{0.0, 0.0, 0.0};
        if (kind == LR_COLLIDER_BOX) {
            desc = box_collider(s, 0.1f * s, s);
            shift = {0.0, -0.1 * size, 0.0};
        } else if (kind == LR_COLLIDER_HULL) {
            for (float x : {-s, s})
                for (float y : {-0.2f * s, 0.0f})
                    for (float z : {-s, s}) corners.insert(corners.end(), {x, y, z});
            desc = hull_collider(corners);
        } else if (kind == LR_COLLIDER_HEIGHTFIELD) {
            heights.assign(25, 0.0f);
            desc = heightfield_collider(heights, 5, 0.5f * s);
            shift = {-size, 0.0, -size};
        } else if (kind == LR_COLLIDER_MESH) {
            sheet.vertices = {-s, 0.0f, -s, s, 0.0f, -s, s, 0.0f, s, -s, 0.0f, s};
            sheet.indices = {0, 1, 2, 0, 2, 3};
            desc = mesh_collider(sheet);
        } else {
            desc = collider_desc(kind);
        }
        const Quat turn = about({0, 0, 1}, -angle);
        put(desc.orientation, turn);
        put(desc.position, to_world(turn, shift));
        desc.friction = friction, desc.restitution = 0.0f;
    }
};

struct Slid {
    double crept, speed; // m after the first half second; m/s
};
// A box of a given size on a slope, from rest.
Slid slide(int32_t kind, double angle, double size, double mu, uint32_t substeps, float seconds) {
    const World world = make(world_desc());
    const Asset asset = make(rigid_box(size, 0.3 * size, 0.6 * size, 300.0));
    const lr_batch batch = add_batch(world, unloaded(), asset, 1);
    set_contact(world, batch, contact_desc(narrow(mu), 0.0f));
    const Slope slope(kind, angle, 200.0 * size, narrow(mu));
    add_collider(world, slope.desc);
    const Quat turn = about({0, 0, 1}, -angle);
    lr_body_desc d = body_desc();
    put(d.orientation, turn);
    put(d.position, to_world(turn, {0.1 * size, 0.15 * size, 0.13 * size}));
    const lr_body body = add_body(world, batch, d);
    const Vec down = to_world(turn, {1, 0, 0});
    const int frames = static_cast<int>(seconds * 60.0f), settled = std::min(frames, 30);
    steps(world, settled, 1.0f / 60.0f, substeps);
    const double from = dot(vec(state_of(world, body).position), down);
    steps(world, frames - settled, 1.0f / 60.0f, substeps);
    const lr_body_state s = state_of(world, body);
    return {dot(vec(s.position), down) - from, dot(vec(s.linear_velocity), down)};
}

} // namespace

TEST_CASE("boxes stick below the angle of friction and slide as they should above" * doctest::test_suite("exact")) {
    const lr_rigid_desc box = rigid_box(1.0, 0.3, 0.6, 300.0);
    const double inertia = box.mass + box.added_mass[0], weight = (box.mass - 1.2 * box.volume) * gravity;
    for (int32_t kind :
         {LR_COLLIDER_PLANE, LR_COLLIDER_BOX, LR_COLLIDER_HEIGHTFIELD, LR_COLLIDER_HULL, LR_COLLIDER_MESH})
        for (double mu : {0.2, 0.5, 0.9})
            for (double size : {0.005, 0.05, 1.0})
                for (uint32_t substeps : {1u, 2u, 4u}) {
                    // It falls by more than its thickness in a substep.
                    if (size < 0.01 && substeps == 1) continue;
                    CAPTURE(kind);
                    CAPTURE(mu);
                    CAPTURE(size);
                    CAPTURE(substeps);
                    const double cone = std::atan(mu);
                    const Slid held = slide(kind, cone - degree, size, mu, substeps, 2.0f);
                    CHECK(std::abs(held.crept) < 0.01 * size);
                    CHECK(std::abs(held.speed) < 1e-3 * std::sqrt(gravity * size));
                    // Those of 5 mm on convex colliders and meshes are up to 17 % slow in one of three slides steeper than 30 degrees
                    // (docs/maintainers/contact.md); on planes and heightfields they are not.
                    const bool exact = size > 0.01 || kind == LR_COLLIDER_PLANE || kind == LR_COLLIDER_HEIGHTFIELD;
                    // The field is 200 sizes long on each side.
                    const auto slides = [&](double angle) {
                        const double a = weight / inertia * (std::sin(angle) - mu * std::cos(angle));
                        const auto seconds = std::min(1.0, std::sqrt(100.0 * size / a));
                        const double whole = std::floor(seconds * 60.0) / 60.0;
                        const Slid s = slide(kind, angle, size, mu, substeps, narrow(whole + 0.001));
                        CHECK(s.speed == doctest::Approx(a * whole).epsilon(exact ? 0.03 : 0.2));
                    };
                    slides(cone + degree);
                    slides(cone + 10.0 * degree);
                }
}

TEST_CASE("small boxes turned any way on a steep slope stick a degree below the angle of friction" *
          doctest::test_suite("exact")) {
    const double mu = 0.9, angle = std::atan(mu) - degree;
    for (int32_t kind : {LR_COLLIDER_PLANE, LR_COLLIDER_HEIGHTFIELD, LR_COLLIDER_BOX})
        for (uint32_t substeps : {2u, 4u})
            for (double size : {0.004, 0.005, 0.007}) {
                CAPTURE(kind);
                CAPTURE(substeps);
                CAPTURE(size);
                constexpr uint32_t bodies = 24;
                const World world = make(world_desc());
                const Asset asset = make(rigid_box(size, 0.3 * size, 0.6 * size, 300.0));
                const lr_batch batch = add_batch(world, unloaded(), asset, bodies);
                set_contact(world, batch, contact_desc(narrow(mu), 0.0f));
                const Slope slope(kind, angle, 200.0 * size, narrow(mu));
                add_collider(world, slope.desc);
                const Quat turn = about({0, 0, 1}, -angle);
                std::vector<lr_body> all;
                std::vector<Vec> from;
                for (uint32_t i = 0; i < bodies; ++i) {
                    lr_body_desc d = body_desc();
                    put(d.orientation, product(turn, about({0, 1, 0}, 15.0 * degree * i)));
                    put(d.position, to_world(turn, {0.1 * size, 0.15 * size, (2.0 * i - 23.0) * size}));
                    all.push_back(add_body(world, batch, d));
                }
                steps(world, 60, 1.0f / 60.0f, substeps);
                for (const lr_body& body : all) from.push_back(vec(state_of(world, body).position));
                steps(world, 60, 1.0f / 60.0f, substeps);
                for (uint32_t i = 0; i < bodies; ++i)
                    CHECK(length(vec(state_of(world, all[i]).position) - from[i]) < 0.01 * size);
            }
}

TEST_CASE("spheres bounce with their coefficient of restitution, and one of 1 gains no energy in 100 bounces") {
    const Asset asset = make(ellipsoid(0.02, 0.02, 0.02, 500.0));
    for (float e : {0.0f, 0.3f, 0.8f, 1.0f})
        for (double height : {0.05, 0.3, 2.0}) {
            CAPTURE(e);
            CAPTURE(height);
            const World world = make(world_desc());
            const lr_batch batch = add_batch(world, unloaded(), asset, 1);
            set_contact(world, batch, contact_desc(0.5f, e));
            add_collider(world, surface(collider_desc(LR_COLLIDER_PLANE), 0.5f));
            lr_body_desc d = body_desc();
            d.position[1] = narrow(0.02 + height);
            const lr_body body = add_body(world, batch, d);
            double before = 0.0, after = 0.0, highest = 0.0;
            int bounces = 0;
            const int frames = e == 1.0f ? 6000 : 120;
            for (int frame = 0; frame < frames; ++frame) {
                steps(world, 1, 1.0f / 60.0f, 4);
                const lr_body_state s = state_of(world, body);
                const double v = wide(s.linear_velocity[1]);
                if (v >= 0.0 && before < 0.0 && ++bounces == 1) after = v;
                if (bounces == 0 || v < 0.0)
                    before = v;
                else
                    before = 0.0;
                if (bounces > 0) highest = std::max(highest, wide(s.position[1]) - 0.02);
            }
            const lr_asset_info info = info_of(asset);
            const double pull = gravity * (info.mass - 1.2 * info.volume) / (info.mass + info.added_mass[0]);
            // From the height of the next rise; frames cut the first rise short.
            CHECK(bounces > 0);
            const double expected = wide(e) * std::sqrt(2.0 * pull * height);
            if (e < 1.0f && e > 0.0f)
                CHECK(std::sqrt(2.0 * pull * std::max(highest, 0.0)) == doctest::Approx(expected).epsilon(0.03));
            if (e == 0.0f) CHECK(highest < 1e-3);
            if (e == 1.0f) {
                CHECK(highest < height * 1.0001);
                CHECK(highest > height * 0.9);
            }
            CHECK(after < std::sqrt(2.0 * pull * height) * (wide(e) + 0.03));
        }
}

// The swept test ends a substep at the touch, where the sphere is slower than at its end.
TEST_CASE("spheres bounce as high on boxes, meshes and fine heightfields, in coarse substeps too, and come to rest") {
    const Asset asset = make(ellipsoid(0.035, 0.035, 0.035, 400.0));
    const Triangles sheet{{-3, 0, -3, 3, 0, -3, 3, 0, 3, -3, 0, 3}, {0, 1, 2, 0, 2, 3}};
    const std::vector<float> heights(101 * 101, 0.0f);
    lr_collider_desc table = box_collider(3.0f, 1.0f, 3.0f), field = heightfield_collider(heights, 101, 0.02f);
    table.position[1] = -1.0f;
    field.position[0] = field.position[2] = -1.0f;
    for (const lr_collider_desc& ground : {collider_desc(LR_COLLIDER_PLANE), table, mesh_collider(sheet), field})
        for (const uint32_t substeps : {1u, 4u})
            for (const float e : {0.5f, 0.9f}) {
                CAPTURE(ground.kind);
                CAPTURE(substeps);
                CAPTURE(e);
                lr_world_desc wd = world_desc();
                wd.fluid_density = 1e-6f;
                const World world = make(wd);
                const lr_batch batch = add_batch(world, unloaded(), asset, 16);
                set_contact(world, batch, contact_desc(0.5f, 0.0f));
                add_collider(world, surface(ground, 0.5f, e));
                std::vector<lr_body> bodies;
                for (int i = 0; i < 16; ++i) {
                    lr_body_desc d = body_desc();
                    d.position[0] = 0.1f * static_cast<float>(i) - 0.8f;
                    d.position[1] = 1.035f + 0.01f * static_cast<float>(i);
                    bodies.push_back(add_body(world, batch, d));
                }
                steps(world, 37, 1.0f / 60.0f, substeps); // the lowest has bounced at 27, the highest at 29
                for (size_t i = 0; i < bodies.size(); ++i) {
                    const lr_body_state s = state_of(world, bodies[i]);
                    const double v = wide(s.linear_velocity[1]),
                                 to = wide(s.position[1]) - 0.035 + 0.5 * v * v / gravity;
                    CHECK(to == doctest::Approx(wide(e * e) * (1.0 + 0.01 * static_cast<double>(i))).epsilon(0.01));
                }
                steps(world, 14 * 60, 1.0f / 60.0f, substeps);
                for (const lr_body body : bodies) CHECK(state_of(world, body).position[1] < 0.0355f);
            }
}

// The correction of its path turns a tilted body by up to half a radian; its velocity must not turn along.
TEST_CASE("without friction a vertical blow throws no tilted body sideways") {
    const Asset assets[] = {make(rigid_box(0.06, 0.0006, 0.04, 400.0)), make(ellipsoid(0.05, 0.005, 0.005, 600.0))};
    lr_collider_desc table = box_collider(3.0f, 1.0f, 3.0f);
    table.position[1] = -1.0f;
    for (const Asset& asset : assets)
        for (const lr_collider_desc& ground : {collider_desc(LR_COLLIDER_PLANE), table})
            for (const uint32_t substeps : {1u, 4u}) {
                CAPTURE(&asset - assets);
                CAPTURE(ground.kind);
                CAPTURE(substeps);
                lr_world_desc wd = world_desc();
                wd.fluid_density = 1e-6f;
                const World world = make(wd);
                const lr_batch batch = add_batch(world, unloaded(), asset, 64);
                set_contact(world, batch, contact_desc(0.0f, 0.0f));
                add_collider(world, surface(ground, 0.0f));
                Random random(7);
                std::vector<lr_body> bodies;
                for (int i = 0; i < 64; ++i)
                    bodies.push_back(add_body(
                        world, batch, turned_anyhow(random, {random.uniform(-1, 1), 1.0, random.uniform(-1, 1)})));
                steps(world, 30, 1.0f / 60.0f, substeps); // they hit at 4.4 m/s
                double sum = 0.0;
                for (const lr_body body : bodies) {
                    const Vec v = vec(state_of(world, body).linear_velocity);
                    sum += std::hypot(v[0], v[2]);
                }
                CHECK(sum / 64.0 < 0.05);
            }
}

namespace {
void hit_obliquely(int32_t kind, double radius, double friction, double spin, float rate) {
    CAPTURE(kind);
    CAPTURE(radius);
    CAPTURE(friction);
    CAPTURE(spin);
    CAPTURE(rate);
    const Asset asset = make(ellipsoid(radius, radius, radius, 900.0));
    const lr_asset_info info = info_of(asset);
    const double mass = info.mass + info.added_mass[0], slip = 3.0 + spin * radius;
    const double rolls = info.inertia[0] / (info.inertia[0] + mass * radius * radius);
    const double e = 0.2, lost = std::min(friction * (1.0 + e) * 2.0, rolls * std::abs(slip));
    const double change = slip > 0.0 ? -lost : lost;
    lr_world_desc weightless = world_desc();
    put(weightless.gravity, Vec{});
    const World world = make(weightless);
    const lr_batch batch = add_batch(world, unloaded(), asset, 20);
    set_contact(world, batch, contact_desc(narrow(friction), narrow(e)));
    lr_collider_desc ground = kind == LR_COLLIDER_PLANE ? collider_desc(kind) : box_collider(3.0f, 1.0f, 30.0f);
    if (kind == LR_COLLIDER_BOX) ground.position[1] = -1.0f;
    add_collider(world, surface(ground, narrow(friction), narrow(e)));
    Random random(3);
    std::vector<lr_body> balls;
    for (int i = 0; i < 20; ++i) {
        lr_body_desc d = turned_anyhow(random, {0.0, radius + 0.02 + 0.05 * i / 20.0, 1.0 * i});
        d.linear_velocity[0] = 3.0f, d.linear_velocity[1] = -2.0f;
        put(d.angular_velocity, Vec{0.0, 0.0, spin});
        balls.push_back(add_body(world, batch, d));
    }
    steps(world, static_cast<int>(0.1f * rate) + 2, 1.0f / rate, 1);
    for (const lr_body ball : balls) {
        const lr_body_state s = state_of(world, ball);
        CHECK(wide(s.linear_velocity[0]) == doctest::Approx(3.0 + change).epsilon(0.001));
        CHECK(wide(s.linear_velocity[1]) == doctest::Approx(e * 2.0).epsilon(0.01));
        const double turned = mass * radius / info.inertia[0] * change;
        CHECK(std::abs(wide(s.angular_velocity[2]) - spin - turned) < 0.003 * (std::abs(turned) + std::abs(spin)));
    }
}
} // namespace

// Coulomb's law: friction takes mu (1 + e) of the closing speed, until the ball rolls. If the contact turned with a ball that friction turns within the
// substep, the speed would be 0.3 m/s off at any step. On boxes, where a body is swept, it turned on from where it met them: up to 0.4 m/s.
TEST_CASE("a ball that hits the ground obliquely slips by Coulomb's law, or rolls, at any step") {
    for (const int32_t kind : {LR_COLLIDER_PLANE, LR_COLLIDER_BOX})
        for (const double radius : {0.005, 0.02, 0.1})
            for (const double friction : {0.1, 0.5})
                for (const double spin : {0.0, -100.0, 60.0})
                    for (const float rate : {30.0f, 60.0f, 240.0f}) hit_obliquely(kind, radius, friction, spin, rate);
}

TEST_CASE("a sphere rolls down without slipping, and slower by rolling resistance") {
    for (double radius : {0.005, 0.05, 0.5}) {
        CAPTURE(radius);
        const Asset asset = make(ellipsoid(radius, radius, radius, 500.0));
        const lr_asset_info info = info_of(asset);
        const auto rolls = [&](double angle, float rolling, float seconds) {
            const World world = make(world_desc());
            const lr_batch batch = add_batch(world, unloaded(), asset, 1);
            set_contact(world, batch, contact_desc(0.9f, 0.0f, rolling));
            const Slope slope(LR_COLLIDER_PLANE, angle, 1.0, 0.9f);
            add_collider(world, slope.desc);
            lr_body_desc d = body_desc();
            put(d.position, to_world(about({0, 0, 1}, -angle), {0.0, radius, 0.0}));
            const lr_body body = add_body(world, batch, d);
            steps(world, static_cast<int>(seconds * 60.0f), 1.0f / 60.0f, 2);
            const lr_body_state s = state_of(world, body);
            const double v = length(vec(s.linear_velocity)), w = length(vec(s.angular_velocity));
            CHECK(std::abs(v - radius * w) <= 0.01 * v);
            return v;
        };
        const double angle = 10.0 * degree;
        const double inertia = info.mass + info.added_mass[0] + info.inertia[0] / (radius * radius);
        const double a = gravity * (info.mass - 1.2 * info.volume) / inertia * std::sin(angle);
        CHECK(rolls(angle, 0.0f, 1.001f) == doctest::Approx(a).epsilon(0.02));
        // The couple r N against the pull's m g sin R.
        CHECK(rolls(angle, narrow(0.8 * std::tan(angle)), 1.001f) == doctest::Approx(0.2 * a).epsilon(0.1));
        CHECK(rolls(angle, narrow(1.2 * std::tan(angle)), 1.001f) < 1e-3 * std::sqrt(gravity * radius));
    }
}

TEST_CASE("a lid that lies on the ground or on a box stays where it is for ten minutes" *
          doctest::test_suite("exact")) {
    const Asset asset = make(rigid_box(0.2, 0.01, 0.15, 300.0));
    for (int32_t kind : {LR_COLLIDER_PLANE, LR_COLLIDER_BOX})
        for (uint32_t flags : {0u, uint32_t{LR_CONTACT_NEVER_SLEEP}}) {
            CAPTURE(kind);
            CAPTURE(flags);
            const World world = make(world_desc());
            lr_batch_desc bd = batch_desc();
            bd.load_model = LR_LOADS_AERODYNAMIC;
            const lr_batch batch = add_batch(world, bd, asset, 1);
            lr_batch_contact c = initialised(lr_batch_contact_init);
            c.flags = flags;
            set_contact(world, batch, c);
            lr_collider_desc ground = kind == LR_COLLIDER_BOX ? box_collider(0.09f, 0.1f, 0.07f) : collider_desc(kind);
            ground.position[1] = kind == LR_COLLIDER_BOX ? -0.1f : 0.0f;
            add_collider(world, ground);
            lr_body_desc d = body_desc();
            d.position[1] = 0.005f;
            const lr_body body = add_body(world, batch, d);
            steps(world, 36000, 1.0f / 60.0f, 1);
            const lr_body_state s = state_of(world, body);
            CHECK(length(vec(s.position) - vec(d.position)) < 1e-4);
            CHECK(s.sleep_state == (flags == 0 ? LR_SLEEP_ASLEEP : LR_SLEEP_AWAKE));
        }
}

// A step through all parts of the solver that a shot uses.
TEST_CASE("no shot at 20 m/s goes through a thin wall at 60 steps a second" * doctest::test_suite("long")) {
    const Asset assets[] = {make(rigid_box(0.03, 0.02, 0.001, 400.0)), make(ellipsoid(0.02, 0.01, 0.0005, 400.0)),
                            make(ellipsoid(0.005, 0.005, 0.005, 400.0))};
    Triangles quad;
    quad.vertices = {-50.0f, 0.0f, -50.0f, 50.0f, 0.0f, -50.0f, 50.0f, 0.0f, 50.0f, -50.0f, 0.0f, 50.0f};
    quad.indices = {0, 1, 2, 0, 2, 3};
    const std::vector<float> corners = box_corners(50.0f, 0.01f, 50.0f);
    Random random(1);
    for (const lr_collider_desc& wall :
         {box_collider(50.0f, 1e-4f, 50.0f), mesh_collider(quad), hull_collider(corners)}) {
        lr_world_desc wd = world_desc();
        wd.gravity[1] = 0.0f;
        const World world = make(wd);
        lr_batch batches[3];
        const uint32_t shots = quick() ? 500 : 17000; // of each shape
        add_collider(world, wall);
        for (size_t b = 0; b < 3; ++b) {
            batches[b] = add_batch(world, unloaded(), assets[b], shots);
            set_contact(world, batches[b], contact_desc(0.3f, 0.0f));
            std::vector<lr_body_desc> descs(shots);
            for (lr_body_desc& d : descs) {
                const float tilt = random.real(-0.8, 0.8), side = random.below(2) == 0 ? 1.0f : -1.0f;
                const double x = random.uniform(-40.0, 40.0), z = random.uniform(-40.0, 40.0);
                d = turned_anyhow(random, {x, wide(side) * random.uniform(0.05, 1.0), z});
                for (float& w : d.angular_velocity) w = random.real(-30.0, 30.0);
                d.linear_velocity[0] = 20.0f * std::sin(tilt);
                d.linear_velocity[1] = -side * 20.0f * std::cos(tilt);
            }
            REQUIRE(lr_body_create(world.get(), batches[b], descs.data(), shots, nullptr) == LR_OK);
        }
        std::vector<float> sides;
        for (lr_batch batch : batches) {
            const lr_batch_view v = view_of(world, batch);
            for (uint32_t i = 0; i < v.count; ++i) sides.push_back(v.position[1][i] < 0.0f ? -1.0f : 1.0f);
        }
        steps(world, 12, 1.0f / 60.0f, 1);
        size_t at = 0, through = 0, arrived = 0;
        for (lr_batch batch : batches) {
            const lr_batch_view v = view_of(world, batch);
            const std::vector<Velocity> u = velocities_of(world, batch);
            for (uint32_t i = 0; i < v.count; ++i, ++at) {
                if (v.position[1][i] * sides[at] < 0.0f) ++through;
                // No other force slows them down.
                if (length(vec(u[i].linear)) < 0.95 * 20.0) ++arrived;
            }
        }
        CAPTURE(wall.kind);
        CHECK(through == 0);
        CHECK(arrived > sides.size() / 2);
    }
}

// Over a side of a box or a hull they are not swept: contacts alone keep them out, of which that of a rod on its end only turns it.
TEST_CASE("no rod or card that flies up to its reach in a substep goes through a box or a hull") {
    constexpr uint32_t count = 200;
    for (const bool hull : {false, true})
        for (const auto& [asset, reach] : {std::pair(make(rigid_box(0.3, 0.01, 0.01, 500.0)), 0.1504f),
                                           std::pair(make(rigid_box(0.1, 3e-4, 0.06, 500.0)), 0.0583f)})
            for (const float half : {0.05f, 0.2f, 0.5f}) // of the reach
                for (const float way : {0.3f, 0.6f, 0.8f})
                    for (const uint32_t substeps : {1u, 2u}) {
                        CAPTURE(hull);
                        CAPTURE(reach);
                        CAPTURE(half);
                        CAPTURE(way);
                        CAPTURE(substeps);
                        const World world = make(world_desc());
                        const std::vector<float> corners = box_corners(30.0f * reach, half * reach, 30.0f * reach);
                        add_collider(world, hull ? hull_collider(corners)
                                                 : box_collider(30.0f * reach, half * reach, 30.0f * reach));
                        const lr_batch batch = add_batch(world, asset, count);
                        Random random(1);
                        for (uint32_t i = 0; i < count; ++i) {
                            lr_body_desc d = turned_anyhow(random);
                            for (const size_t k : {size_t{0}, size_t{2}})
                                d.position[k] = 5.0f * reach * random.real(-1, 1);
                            d.position[1] = (half + random.real(1.1f, 3.0f)) * reach;
                            d.linear_velocity[1] = -way * reach * 60.0f * static_cast<float>(substeps);
                            for (float& w : d.angular_velocity) w = random.real(-10, 10);
                            add_body(world, batch, d);
                        }
                        uint32_t through = 0; // counted in each step, before any can have gone round
                        for (int step = 0; step < 20; ++step) {
                            steps(world, 1, 1.0f / 60.0f, substeps);
                            const lr_batch_view v = view_of(world, batch);
                            for (uint32_t i = 0; i < count; ++i)
                                if (v.position[1][i] < -half * reach &&
                                    std::max(std::abs(v.position[0][i]), std::abs(v.position[2][i])) < 25.0f * reach)
                                    ++through;
                        }
                        CHECK(through == 0);
                    }
}
