// Contact has no length, place, heading or speed of its own: a transformed scene ends alike.
#include "support/contact.h"

#include <algorithm>
#include <cmath>

using namespace test;

namespace {

constexpr double gravity = 9.81;
constexpr uint32_t thrown = 60;

// A scene of lengths about 1, and its scaling: lengths by `length`, times and speeds by its root.
struct Frame {
    double length = 1.0, yaw = 0.0;
    Vec origin{0, 0, 0}, velocity{0, 0, 0};
    double root() const { return std::sqrt(length); }
    Quat turn() const { return about({0, 1, 0}, yaw); }
    Vec place(Vec x) const { return origin + to_world(turn(), length * x); }
    Vec speed(Vec v) const { return velocity + to_world(turn(), root() * v); }
    Vec spin(Vec w) const { return to_world(turn(), 1.0 / root() * w); }
    Vec back(Vec x, double seconds) const {
        const Vec moved = x - origin - seconds * velocity;
        return 1.0 / length * to_body(turn(), moved);
    }
};

// A room: a floor or ground with a step, a ball, a capsule, a wedge and a ramp on it, and bodies thrown in.
class Room {
public:
    Room(const Frame& frame, uint32_t bodies, double restitution, uint64_t seed) : frame_(frame) {
        world_ = make(world_desc());
        const double l = frame.length;
        assets_.push_back(make(rigid_box(0.1 * l, 0.06 * l, 0.08 * l, 300.0)));
        assets_.push_back(make(rigid_box(0.12 * l, 0.008 * l, 0.1 * l, 300.0)));
        assets_.push_back(make(ellipsoid(0.05 * l, 0.05 * l, 0.05 * l, 300.0)));
        for (const Asset& asset : assets_) {
            batches_.push_back(add_batch(world_, unloaded(), asset, bodies));
            set_contact(world_, batches_.back(), contact_desc(0.5f, narrow(restitution), 0.05f));
        }
        furnish(narrow(l));
        Random random(seed);
        for (uint32_t i = 0; i < bodies; ++i) {
            lr_body_desc d = body_desc();
            put(d.orientation, product(frame.turn(), any_turn(random)));
            put(d.position, frame.place({random.uniform(-1, 1), random.uniform(0.4, 1.0), random.uniform(-1, 1)}));
            put(d.linear_velocity, frame.speed({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}));
            put(d.angular_velocity, frame.spin({random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5)}));
            bodies_.push_back(add_body(world_, batches_[i % 3], d));
        }
    }
    static std::vector<Vec> played(const Frame& frame, double seconds) {
        Room room(frame, thrown, 0.3, 1);
        room.run(seconds);
        return room.positions();
    }
    // Times, lengths and speeds here and below are for a scene of length 1.
    void run(double seconds) {
        constexpr double dt = 1.0 / 64.0;
        steps(world_, static_cast<int>(seconds / dt), narrow(dt * frame_.root()), 4);
        seconds_ += seconds;
    }
    std::vector<Vec> positions() const {
        std::vector<Vec> out;
        for (lr_body body : bodies_)
            out.push_back(frame_.back(vec(state_of(world_, body).position), seconds_ * frame_.root()));
        return out;
    }
    double lowest() const { // of the centres
        double least = 1e9;
        for (const Vec& x : positions()) least = std::min(least, x[1]);
        return least;
    }

private:
    void add(lr_collider_desc d, Vec at, Quat turn = {0, 0, 0, 1}) {
        put(d.position, frame_.place(at));
        put(d.orientation, product(frame_.turn(), turn));
        put(d.linear_velocity, frame_.velocity);
        d.friction = 0.5f, d.restitution = 0.0f;
        add_collider(world_, d);
    }
    void furnish(float l) {
        add(collider_desc(LR_COLLIDER_PLANE), {0, 0, 0});
        add(box_collider(0.3f * l, 0.1f * l, 0.2f * l), {0.5, 0.1, 0.5});
        add(sphere_collider(0.3f * l), {-0.5, 0, 0.5});
        lr_collider_desc capsule = collider_desc(LR_COLLIDER_CAPSULE);
        capsule.size[0] = 0.15f * l, capsule.size[1] = 0.4f * l;
        add(capsule, {0.5, 0.1, -0.5}, about({0, 0, 1}, 1.4));
        std::vector<float> wedge = tetrahedron(0.5f * l);
        add(hull_collider(wedge), {-0.7, 0, -0.7});
        Triangles ramp;
        ramp.vertices = {-0.2f, 0.0f, -0.2f, 0.2f, 0.1f, -0.2f, 0.2f, 0.1f, 0.2f, -0.2f, 0.0f, 0.2f};
        for (float& x : ramp.vertices) x *= l;
        ramp.indices = {0, 2, 1, 0, 3, 2};
        add(mesh_collider(ramp), {0, 0, 0});
        std::vector<float> heights(81);
        for (size_t i = 0; i < heights.size(); ++i)
            heights[i] = 0.02f * l * static_cast<float>(i % 9 * (i % 9) % 5 + i / 9 % 3);
        add(heightfield_collider(heights, 9, 0.125f * l), {-0.5, 0.01, -0.6});
    }

    Frame frame_;
    World world_;
    std::vector<Asset> assets_;
    std::vector<lr_batch> batches_;
    std::vector<lr_body> bodies_;
    double seconds_ = 0.0;
};

double farthest_apart(const std::vector<Vec>& a, const std::vector<Vec>& b) {
    double most = 0.0;
    for (size_t i = 0; i < a.size(); ++i) most = std::max(most, length(a[i] - b[i]));
    return most;
}
// The share of bodies within `near` of their earlier places.
size_t alike(const std::vector<Vec>& a, const std::vector<Vec>& b, double near) {
    size_t found = 0;
    for (size_t i = 0; i < a.size(); ++i) found += length(a[i] - b[i]) < near ? 1u : 0u;
    return found;
}

} // namespace

// Lengths by a power of four make times and speeds powers of two, so that each product rounds alike.
TEST_CASE("a scene four times or a thousand times smaller ends in the same bits, and one of a millimetre or centimetre "
          "alike" *
          doctest::test_suite("exact")) {
    const std::vector<Vec> first = Room::played({}, 3.0);
    for (double l : {16.0, 0.25, 1.0 / 1024.0}) {
        Frame frame;
        frame.length = l;
        CAPTURE(l);
        CHECK(farthest_apart(first, Room::played(frame, 3.0)) == 0.0);
    }
    for (double l : {0.01, 0.001}) {
        Frame frame;
        frame.length = l;
        CAPTURE(l);
        CHECK(alike(first, Room::played(frame, 3.0), 0.01) > 50);
    }
}

TEST_CASE("a scene that is turned about the vertical ends turned" * doctest::test_suite("exact")) {
    const std::vector<Vec> first = Room::played({}, 3.0);
    for (double yaw : {0.3, 1.0, 2.5}) {
        Frame frame;
        frame.yaw = yaw;
        CAPTURE(yaw);
        CHECK(alike(first, Room::played(frame, 3.0), 0.01) > 50);
    }
}

// Nothing is at rest in the world, but bodies come to rest relative to their support.
TEST_CASE("in a room that moves evenly all comes to rest in it" * doctest::test_suite("exact")) {
    for (const Vec& velocity : {Vec{0, 1, 0}, Vec{0, -1, 0}, Vec{2, 0, 1}}) {
        CAPTURE(velocity[0]);
        CAPTURE(velocity[1]);
        Frame frame;
        frame.velocity = velocity;
        Room room(frame, thrown, 0.0, 1);
        room.run(4.0);
        const std::vector<Vec> lay = room.positions();
        room.run(1.0);
        CHECK(alike(lay, room.positions(), 2e-3) >= thrown - 1);
        CHECK(room.lowest() > 0.004 - 1e-3);
    }
}

// Far away, positions are rounded to 6e-5 m, and contact treats 1e-6 of the position as touching.
TEST_CASE("a kilometre from the origin bodies of a decimetre come to rest on the ground, and not in it" *
          doctest::test_suite("exact")) {
    Frame frame;
    frame.origin = {1000, 0, -1000};
    Room room(frame, thrown, 0.3, 1);
    room.run(6.0);
    const std::vector<Vec> lay = room.positions();
    room.run(2.0);
    CHECK(room.lowest() > 0.004 - 2e-3);

    CHECK(alike(lay, room.positions(), 1e-3) >= thrown - 1);
}

TEST_CASE("a box slides as far on a floor that moves evenly as on one that does not, and stops") {
    constexpr double mu = 0.4, size = 0.1, pushed = 1.0;
    const lr_rigid_desc box = rigid_box(size, 0.5 * size, 0.8 * size, 300.0);
    const Asset asset = make(box);
    const double pull = gravity * (box.mass - box.fluid_density * box.volume) / (box.mass + box.added_mass[0]);
    const double way = pushed * pushed / (2.0 * mu * pull);
    for (const Vec& velocity :
         {Vec{0, 0, 0}, Vec{0, 1, 0}, Vec{0, -1, 0}, Vec{2, 0, 0}, Vec{-1, 0.5, 0.7}, Vec{0, 0, 5}})
        for (bool plane : {true, false})
            for (double yaw : {0.0, 0.8}) {
                CAPTURE(velocity[0]);
                CAPTURE(velocity[1]);
                CAPTURE(velocity[2]);
                CAPTURE(plane);
                CAPTURE(yaw);
                Frame frame;
                frame.velocity = velocity;
                frame.yaw = yaw;
                const World world = make(world_desc());
                const lr_batch batch = add_batch(world, unloaded(), asset, 1);
                set_contact(world, batch, contact_desc(narrow(mu), 0.0f));
                lr_collider_desc d = plane ? collider_desc(LR_COLLIDER_PLANE) : box_collider(4.0f, 0.1f, 4.0f);
                d.position[1] = plane ? 0.0f : -0.1f;
                put(d.linear_velocity, velocity);
                add_collider(world, surface(d, narrow(mu)));
                lr_body_desc b = body_desc();
                put(b.position, {0.0, 0.25 * size, 0.0});
                put(b.orientation, frame.turn());
                put(b.linear_velocity, frame.speed({pushed, 0, 0}));
                const lr_body body = add_body(world, batch, b);
                const auto place = [&](double seconds) {
                    return frame.back(vec(state_of(world, body).position), seconds);
                };
                steps(world, 60, 1.0f / 60.0f, 4);
                const Vec first = place(1.0);
                CHECK(first[0] == doctest::Approx(way).epsilon(0.01));
                CHECK(std::abs(first[2]) < 0.01 * way);
                steps(world, 60, 1.0f / 60.0f, 4);
                CHECK(length(place(2.0) - first) < 1e-4 * size + 1e-5 * length(velocity));
            }
}
