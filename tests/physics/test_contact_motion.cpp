// Bodies on moving colliders: pushed, carried, spun, swept aside. Closed forms if they exist; a body's inertia is m + A, and its
// weight minus its buoyancy presses it down.
#include "support/contact.h"
#include "support/contact_events.h"

#include <algorithm>
#include <cmath>

using namespace test;

namespace {

constexpr double gravity = 9.81, dt = 1.0 / 60.0;

struct Crate {
    double x, y, z, reach, slop, pull; // m; m/s^2, its acceleration of fall in the fluid
    Asset asset;
    explicit Crate(double size) : x(size), y(0.5 * size), z(0.8 * size) {
        const lr_rigid_desc d = rigid_box(x, y, z, 300.0);
        pull = gravity * (d.mass - d.fluid_density * d.volume) / (d.mass + d.added_mass[0]);
        reach = 0.5 * std::sqrt(x * x + y * y + z * z);
        slop = 1e-3 * reach;
        asset = make(d);
    }
    // Without loads, standing at (x, 0, z), rotated about the vertical.
    lr_body place(const World& w, lr_batch batch, Vec at, Vec velocity = {0, 0, 0}, Vec spin = {0, 0, 0}) const {
        lr_body_desc d = body_desc();
        put(d.position, at + Vec{0.0, 0.5 * y, 0.0});
        put(d.linear_velocity, velocity);
        put(d.angular_velocity, spin);
        return add_body(w, batch, d);
    }
};
lr_batch crates(const World& w, const Crate& crate, double friction, double restitution = 0.0) {
    const lr_batch batch = add_batch(w, unloaded(), crate.asset, 8);
    set_contact(w, batch, contact_desc(narrow(friction), narrow(restitution)));
    return batch;
}
void move(const World& w, lr_collider_motion m) {
    REQUIRE(lr_collider_move(w.get(), &m, 1) == LR_OK);
}

// Colliders to stand on at y = 0.
struct Deck {
    std::vector<float> heights, corners;
    Triangles sheet;
    lr_collider_desc desc{};
    Deck(int32_t kind, double size, double friction) {
        const auto s = narrow(size);
        if (kind == LR_COLLIDER_BOX) {
            desc = box_collider(s, s, s);
            desc.position[1] = -s;
        } else if (kind == LR_COLLIDER_HULL) {
            for (float x : {-s, s})
                for (float y : {-s, 0.0f})
                    for (float z : {-s, s}) corners.insert(corners.end(), {x, y, z});
            desc = hull_collider(corners);
        } else if (kind == LR_COLLIDER_HEIGHTFIELD) {
            heights.assign(81, 0.0f);
            desc = heightfield_collider(heights, 9, 0.25f * s);
            desc.position[0] = desc.position[2] = -s;
        } else if (kind == LR_COLLIDER_MESH) {
            sheet.vertices = {-s, 0.0f, -s, s, 0.0f, -s, s, 0.0f, s, -s, 0.0f, s};
            sheet.indices = {0, 1, 2, 0, 2, 3};
            desc = mesh_collider(sheet);
        } else {
            desc = collider_desc(kind);
        }
        desc = surface(desc, narrow(friction));
    }
};
constexpr int32_t decks[] = {LR_COLLIDER_PLANE, LR_COLLIDER_BOX, LR_COLLIDER_HULL, LR_COLLIDER_HEIGHTFIELD,
                             LR_COLLIDER_MESH};

} // namespace

TEST_CASE("a box that pushes a body along the floor stays in touch with it") {
    for (double size : {0.005, 0.05, 1.0})
        for (uint32_t substeps : {1u, 2u, 4u})
            for (double angle : {0.0, 0.7}) {
                // It falls by more than its thickness in a substep.
                if (size < 0.01 && substeps == 1) continue;
                CAPTURE(size);
                CAPTURE(substeps);
                CAPTURE(angle);
                const double speed = 0.3 * std::sqrt(gravity * size);
                const Crate crate(size);
                const World world = make(world_desc());
                const lr_batch batch = crates(world, crate, 0.4);
                add_collider(world, surface(collider_desc(LR_COLLIDER_PLANE), 0.4f));
                const Quat turn = about({0, 1, 0}, angle);
                const Vec ahead = to_world(turn, {1, 0, 0});
                const auto half = narrow(size);
                lr_collider_desc d = surface(box_collider(half, half, 2.0f * half), 0.4f);
                put(d.orientation, turn);
                put(d.position, to_world(turn, {-1.7 * size, 1.05 * size, 0.0}));
                put(d.linear_velocity, speed * ahead);
                const lr_collider pusher = add_collider(world, d);
                lr_body_desc bd = body_desc();
                put(bd.orientation, turn);
                bd.position[1] = narrow(0.5 * crate.y);
                const lr_body body = add_body(world, batch, bd);
                const auto gap = [&] {
                    const lr_body_state s = state_of(world, body);
                    const Vec from = vec(s.position) - vec(state_of_collider(world, pusher).position);
                    return dot(from, ahead) - size - 0.5 * crate.x;
                };
                bool met = false;
                double deepest = 0.0, farthest = 0.0;
                for (int frame = 0; frame < 300; ++frame) {
                    steps(world, 1, narrow(dt), substeps);
                    const double now = gap();
                    met = met || now < crate.slop;
                    deepest = std::min(deepest, now);
                    if (met) farthest = std::max(farthest, now);
                }
                CHECK(met);
                CHECK(deepest > -2.0 * crate.slop);
                CHECK(farthest < 2.0 * crate.slop);
                const lr_body_state s = state_of(world, body);
                CHECK(length(vec(s.linear_velocity) - speed * ahead) < 0.01 * speed);
                CHECK(std::abs(wide(s.position[1]) - 0.5 * crate.y) < 2.0 * crate.slop);
            }
}

// (m + A) r w^2 against mu times the normal force.
TEST_CASE("bodies on a turntable turn with it as far out as friction holds them") {
    for (int32_t kind : {LR_COLLIDER_BOX, LR_COLLIDER_PLANE, LR_COLLIDER_MESH})
        for (double size : {0.02, 0.2})
            for (double share : {0.5, 0.97, 1.03}) {
                CAPTURE(kind);
                CAPTURE(size);
                CAPTURE(share);
                constexpr double mu = 0.5;
                const Crate crate(size);
                const double r = 3.0 * size, w = std::sqrt(share * mu * crate.pull / r);
                const World world = make(world_desc());
                const lr_batch batch = crates(world, crate, mu);
                Deck deck(kind, 50.0 * size, mu);
                deck.desc.angular_velocity[1] = narrow(w);
                add_collider(world, deck.desc);
                const lr_body body = crate.place(world, batch, {r, 0, 0}, {0, 0, -r * w}, {0, w, 0});
                // A turn and a half.
                steps(world, static_cast<int>(std::ceil(9.0 / w / dt)), narrow(dt), 4);
                const lr_body_state s = state_of(world, body);
                const double now = std::hypot(wide(s.position[0]), wide(s.position[2]));
                if (share <
                    1.0) { // it creeps outwards by a sixteenth of a substep's angle each radian, farther near the limit
                    CHECK(std::abs(now / r - 1.0) < 9.0 * (share < 0.9 ? 0.1 : 0.4) * w * dt / 4.0);
                    CHECK(wide(s.angular_velocity[1]) == doctest::Approx(w).epsilon(0.02));
                } else {
                    CHECK(now > 1.5 * r);
                }
            }
}

TEST_CASE("an elevator carries what stands on it, up and down at 1 m/s") {
    for (int32_t kind : decks)
        for (double size : {0.005, 0.05, 1.0})
            for (double speed : {1.0, -1.0}) {
                CAPTURE(kind);
                CAPTURE(size);
                CAPTURE(speed);
                const Crate crate(size);
                const World world = make(world_desc());
                const lr_batch batch = crates(world, crate, 0.5);
                Deck deck(kind, 10.0 * size, 0.5);
                deck.desc.linear_velocity[1] = narrow(speed);
                const lr_collider floor = add_collider(world, deck.desc);
                const double base = wide(deck.desc.position[1]);
                const lr_body body = crate.place(world, batch, {0.3 * size, 0, 0.2 * size});
                steps(world, 60, narrow(dt), 4); // a body above a descending floor lands on it after a while
                const Vec landed = vec(state_of(world, body).position);
                double least = 1.0, most = -1.0;
                for (int frame = 0; frame < 60; ++frame) {
                    steps(world, 1, narrow(dt), 4);
                    const lr_body_state s = state_of(world, body);
                    const double top = wide(state_of_collider(world, floor).position[1]) - base;
                    const double gap = wide(s.position[1]) - 0.5 * crate.y - top;
                    least = std::min(least, gap), most = std::max(most, gap);
                    CHECK(wide(s.linear_velocity[1]) == doctest::Approx(speed).epsilon(0.01));
                }
                const double round = 1e-6 * 2.0;
                CHECK(least > -2.0 * crate.slop - round);
                CHECK(most < 2.0 * crate.slop + round);
                const Vec carried = vec(state_of(world, body).position) - landed;
                CHECK(std::hypot(carried[0], carried[2]) < 0.01 * size);
            }
}

// The floor moves evenly within a step, on chords of its parabola: at a chord's end a body on it is faster than the next chord by half
// of the floor's gain in a step, and hops accordingly.
TEST_CASE("a floor that goes down faster than bodies fall leaves them") {
    for (int32_t kind : decks)
        for (double share : {-0.5, 0.5, 0.9, 1.2, 2.0}) {
            CAPTURE(kind);
            CAPTURE(share);
            const Crate crate(0.1);
            const World world = make(world_desc());
            const lr_batch batch = crates(world, crate, 0.5);
            const Deck deck(kind, 2.0, 0.5);
            const lr_collider floor = add_collider(world, deck.desc);
            const lr_body body = crate.place(world, batch, {0.1, 0, 0.05});
            keep_events(world);
            steps(world, 30, narrow(dt), 4);
            const double began = wide(state_of(world, body).position[1]);
            const double a = share * crate.pull;
            double most = 0.0, least = 0.0;
            bool left = false;
            const int frames = 30;
            for (int frame = 1; frame <= frames; ++frame) {
                lr_collider_motion m = motion_of(floor, LR_MOVE_TO);
                const double t = frame * dt, fallen = 0.5 * a * t * t;
                m.position[0] = deck.desc.position[0], m.position[2] = deck.desc.position[2];
                m.position[1] = narrow(wide(deck.desc.position[1]) - fallen);
                move(world, m);
                steps(world, 1, narrow(dt), 4);
                left = left || count_of(events_of(world), LR_EVENT_LIFTED) != 0;
                const double gap = wide(state_of(world, body).position[1]) - began + fallen;
                most = std::max(most, gap), least = std::min(least, gap);
            }
            const double t = frames * dt;
            CHECK(least > -2.0 * crate.slop);
            if (share < 1.0) {
                const double hop = 0.125 * share * share / (1.0 - share), chord = 0.125 * std::abs(share);
                CHECK(most < 1.1 * (hop + chord) * crate.pull * dt * dt + 2.0 * crate.slop);
            } else {
                CHECK(left);
                CHECK(most == doctest::Approx(0.5 * (a - crate.pull) * t * t).epsilon(0.05));
                CHECK(wide(state_of(world, body).linear_velocity[1]) == doctest::Approx(-crate.pull * t).epsilon(0.01));
            }
        }
}

// A belt: each step returns it to its place, with its velocity.
TEST_CASE("a conveyor takes along what is laid on it, by friction first and then at its own speed") {
    for (int32_t kind : decks)
        for (double size : {0.01, 0.1, 1.0}) {
            CAPTURE(kind);
            CAPTURE(size);
            constexpr double mu = 0.4;
            const Crate crate(size);
            const double speed = std::sqrt(gravity * size), a = mu * crate.pull;
            const World world = make(world_desc());
            const lr_batch batch = crates(world, crate, mu);
            const Deck deck(kind, 100.0 * size, mu);
            const lr_collider belt = add_collider(world, deck.desc);
            const lr_body body = crate.place(world, batch, {0.0, 0.0, 0.0});
            const int slides = static_cast<int>(speed / a / dt);
            double worst = 0.0;
            for (int frame = 1; frame <= 2 * slides + 4; ++frame) {
                lr_collider_motion m = motion_of(belt, LR_MOVE_PLACE);
                std::copy_n(deck.desc.position, 3, m.position);
                m.linear_velocity[0] = narrow(speed);
                move(world, m);
                steps(world, 1, narrow(dt), 4);
                const double expected = std::min(speed, a * frame * dt);
                worst = std::max(worst, std::abs(wide(state_of(world, body).linear_velocity[0]) - expected));
            }
            CHECK(worst < 0.02 * speed);
            const lr_body_state s = state_of(world, body);
            CHECK(std::abs(wide(s.position[1]) - 0.5 * crate.y) < 2.0 * crate.slop);
            CHECK(wide(s.linear_velocity[0]) == doctest::Approx(speed).epsilon(0.001));
            CHECK(length(vec(s.angular_velocity)) < 1e-3 * speed / size);
        }
}

namespace {

// Distance of a standing capsule's axis, at (x, z) from `low` to `high`, from a box.
double distance_to_axis(const lr_batch_view& v, uint32_t i, const Vec& half, Vec foot, double high) {
    const Quat q{wide(v.orientation[0][i]), wide(v.orientation[1][i]), wide(v.orientation[2][i]),
                 wide(v.orientation[3][i])};
    double least = 1e9;
    for (int k = 0; k <= 100; ++k) {
        const Vec at{foot[0], foot[1] + 0.01 * k * (high - foot[1]), foot[2]};
        Vec p = to_body(q, at - Vec{wide(v.position[0][i]), wide(v.position[1][i]), wide(v.position[2][i])});
        for (size_t axis = 0; axis < 3; ++axis) p[axis] -= std::clamp(p[axis], -half[axis], half[axis]);
        least = std::min(least, length(p));
    }
    return least;
}

} // namespace

// A person of 1.8 m, with feet as wide as the body, walks through bodies that are turned by `turn` rad from one to the next. Returns the deepest
// overlap that lasted two steps, in reaches of the body.
static double overlap_of_a_walk(double turn) {
    CAPTURE(turn);
    constexpr double radius = 0.25, axis = 0.65, walk = 1.4, x = 0.06, y = 0.03, z = 0.04;
    const Vec half{0.5 * x, 0.5 * y, 0.5 * z};
    const double reach = length(half);
    const Asset asset = make(rigid_box(x, y, z, 300.0));
    const World world = make(world_desc());
    constexpr uint32_t along = 40, across = 21, count = along * across;
    const lr_batch batch = add_batch(world, unloaded(), asset, count);
    lr_batch_contact c = contact_desc(0.5f, 0.1f, 0.05f);
    c.flags = 0;
    set_contact(world, batch, c);
    add_collider(world, collider_desc(LR_COLLIDER_PLANE));
    std::vector<Vec> laid;
    for (uint32_t i = 0; i < count; ++i) {
        lr_body_desc d = body_desc();
        const uint32_t column = i % along, row = i / along;
        const Vec at{0.1 * column - 2.0, half[1], 0.1 * row - 1.0};
        put(d.position, at);
        put(d.orientation, about({0, 1, 0}, turn * i));
        d.noise_seed = i;
        laid.push_back(at);
        add_body(world, batch, d);
    }
    steps(world, 60, narrow(dt), 2);
    REQUIRE(view_of(world, batch).awake_count == 0);
    lr_collider_desc d = surface(collider_desc(LR_COLLIDER_CAPSULE), 0.5f);
    d.size[0] = narrow(radius), d.size[1] = narrow(axis);
    d.position[0] = -3.0f, d.position[1] = narrow(axis + 0.5 * radius);
    d.linear_velocity[0] = narrow(walk);
    const lr_collider walker = add_collider(world, d);
    keep_events(world, 2 * count);
    std::vector<char> woke(count, 0);
    std::vector<double> before(count, 1.0);
    double deepest = 1.0, lasting = 1.0; // least gap ever, and least gap that lasted two steps
    for (int frame = 0; frame < 300; ++frame) {
        steps(world, 1, narrow(dt), 2);
        const lr_batch_view v = view_of(world, batch);
        const Vec at = vec(state_of_collider(world, walker).position);
        for (uint32_t i = 0; i < v.count; ++i) {
            const double gap = distance_to_axis(v, i, half, at - Vec{0, axis, 0}, at[1] + axis) - radius;
            deepest = std::min(deepest, gap);
            lasting = std::min(lasting, std::max(gap, before[v.noise_seed[i]]));
            before[v.noise_seed[i]] = gap;
        }
        for (const lr_event& e : events_of(world)) {
            if (e.kind != LR_EVENT_WOKE) continue;
            woke[state_of(world, e.body).noise_seed] = 1;
        }
    }
    // Bodies pushed by it rotate: part of the substep's motion is left for the next substep.
    CHECK(deepest > -0.5 * walk * dt / 2.0);
    CHECK(lasting > -1.2e-2 * reach);
    CHECK(lasting < 2e-3 * reach);
    uint32_t met = 0, far = 0;
    for (size_t i = 0; i < laid.size(); ++i) {
        const double away = std::abs(laid[i][2]);
        if (away < radius * 0.8) { // no body below the rounded end
            ++met;
            CHECK(woke[i] == 1);
        }
        if (away > radius + 3.0 * reach) {
            ++far;
            CHECK(woke[i] == 0);
        }
    }
    CHECK(met > 100);
    CHECK(far > 100);
    lr_collider_motion stop = motion_of(walker, LR_MOVE_VELOCITY);
    move(world, stop);
    steps(world, 120, narrow(dt), 2);
    const lr_batch_view v = view_of(world, batch);
    CHECK(v.awake_count == 0);
    double lowest = 1.0;
    for (uint32_t i = 0; i < v.count; ++i) lowest = std::min(lowest, wide(v.position[1][i]) - 0.5 * y);
    CHECK(lowest > -2e-3 * reach);
    return -lasting / reach;
}

// One body of 840, wedged below the rounded end, decides about each overlap: it takes several walks to know how deep they are.
TEST_CASE(
    "a capsule that walks through bodies at rest wakes what it meets, moves it aside, and leaves the others alone" *
    doctest::test_suite("exact")) {
    double sum = 0.0;
    const std::array turns{0.37, 0.41, 0.43, 0.47, 0.53, 0.59, 0.61, 0.67};
    for (const double turn : turns) sum += overlap_of_a_walk(turn);
    CHECK(sum < 5e-3 * turns.size());
}

TEST_CASE("a roller that leaves no room presses nothing through a thin floor" * doctest::test_suite("long")) {
    constexpr uint32_t count = 64;
    constexpr double high = 1.0; // m, the floor
    const std::vector<float> corners = box_corners(0.5f, 2.5e-4f, 0.5f);
    const auto flat = [](float, float) { return 0.0f; };
    const Triangles fine = fine_sheet(75, 0.008f, flat), coarse = fine_sheet(4, 0.15f, flat);
    const lr_collider_desc floors[] = {box_collider(0.5f, 2.5e-4f, 0.5f), hull_collider(corners), mesh_collider(fine),
                                       mesh_collider(coarse)};
    const Asset kinds[] = {make(ellipsoid(0.03, 0.02, 5e-4, 400.0)), make(rigid_box(0.06, 0.003, 0.002, 400.0))};
    for (lr_collider_desc floor : floors)
        for (const Asset& kind : kinds) {
            CAPTURE(floor.kind);
            const World world = make(world_desc());
            floor.position[1] = narrow(high);
            add_collider(world, floor);
            lr_collider_desc roller = collider_desc(LR_COLLIDER_CAPSULE); // along z, a millimetre deep in the floor
            roller.size[0] = 0.05f, roller.size[1] = 0.3f;
            roller.orientation[0] = roller.orientation[3] = 1.0f;
            roller.position[0] = -0.25f, roller.position[1] = narrow(high) + 0.049f;
            const lr_collider id = add_collider(world, roller);
            const lr_batch batch = add_batch(world, unloaded(), kind, count);
            Random random(7);
            std::vector<lr_body> bodies;
            for (uint32_t i = 0; i < count; ++i)
                bodies.push_back(add_body(
                    world, batch,
                    turned_anyhow(random, {random.uniform(-0.1, 0.1), high + 0.05, random.uniform(-0.1, 0.1)})));
            steps(world, 30, 1.0f / 60.0f);
            lr_collider_motion m = motion_of(id, LR_MOVE_VELOCITY);
            for (const float speed : {1.0f, -1.5f}) {
                m.linear_velocity[0] = speed;
                m.angular_velocity[2] = 2.0f;
                REQUIRE(lr_collider_move(world.get(), &m, 1) == LR_OK);
                steps(world, 24, 1.0f / 60.0f);
            }
            // Bodies that roll off at the sides do not count.
            for (lr_body body : bodies) {
                const lr_body_state s = state_of(world, body);
                const bool over = std::abs(s.position[0]) < 0.25f && std::abs(s.position[2]) < 0.25f;
                CHECK((!over || wide(s.position[1]) > high - 1e-3));
            }
        }
}
