// External forces, against the inertia of body and fluid together.
#include "support/colliders.h"
#include "support/random.h"
#include "support/reference_body.h"
#include "support/water.h"

#include <numbers>

using namespace test;

namespace {

constexpr int32_t integrators[] = {LR_INTEGRATOR_RK4, LR_INTEGRATOR_DEFAULT};

// The added mass of this one is four times its own, broadside.
Asset foil() {
    return make(in_water(ellipsoid(0.04, 0.02, 0.004, 1000.0)));
}

lr_batch_desc without_loads(int32_t integrator) {
    lr_batch_desc d = langevin();
    d.load_model = LR_LOADS_NONE;
    d.integrator = integrator;
    return d;
}

void put(float (&to)[3], Vec v) {
    for (size_t i = 0; i < 3; ++i) to[i] = narrow(v[i]);
}

lr_body_force force_on(lr_body body, int32_t mode, int32_t frame, Vec force, Vec torque = {}) {
    lr_body_force f = initialised(lr_body_force_init);
    f.body = body;
    f.mode = mode;
    f.frame = frame;
    put(f.force, force);
    put(f.torque, torque);
    return f;
}
void push(const World& world, const lr_body_force& f) {
    REQUIRE(lr_body_add_force(world.get(), &f, 1) == LR_OK);
}

lr_body_desc turned(Random& random, double scale = 1.0) {
    lr_body_desc d = strewn(random, 1.0);
    d.scale = narrow(scale);
    return d;
}

// Velocity and spin in the body frame.
Six twist_of(const lr_body_state& s) {
    const Quat q = quat(s.orientation);
    return join(to_body(q, vec(s.linear_velocity)), to_body(q, vec(s.angular_velocity)));
}
double largest(const Six& t) {
    double most = 0.0;
    for (double x : t) most = std::max(most, std::abs(x));
    return most;
}
void check_close(const Six& got, const Six& expected, double tolerance) {
    // Spins are some hundred times as large as velocities here: compare each half relative to its own size.
    for (size_t half = 0; half < 2; ++half) {
        double error = 0.0, size = 0.0;
        for (size_t i = 3 * half; i < 3 * half + 3; ++i) {
            error = std::max(error, std::abs(got[i] - expected[i]));
            size = std::max(size, std::abs(expected[i]));
        }
        CHECK(error <= tolerance * size + 1e-12);
    }
}
Six scaled(const Six& a, double s) {
    Six out = a;
    for (double& x : out) x *= s;
    return out;
}

} // namespace

TEST_CASE("a body starts with force over own and added mass, and torque over own and added inertia, at its true size") {
    const Asset asset = foil();
    const lr_asset_info info = info_of(asset);
    const double dt = 1e-3;
    for (int32_t integrator : integrators)
        for (bool full : {false, true})
            for (double scale : {0.25, 1.0, 8.0})
                for (size_t axis = 0; axis < 3; ++axis) {
                    const World world = weightless();
                    const lr_batch batch = add_batch(world, without_loads(integrator), asset, 2, full);
                    lr_body_desc d = body_desc();
                    d.scale = narrow(scale);
                    const lr_body pushed = add_body(world, batch, d), wrung = add_body(world, batch, d);
                    const double s3 = scale * scale * scale, s5 = s3 * scale * scale;
                    const double mass = s3 * (info.mass + info.added_mass[axis * 7]);
                    const double inertia = s5 * (info.inertia[axis * 4] + info.added_mass[(axis + 3) * 7]);
                    Vec force{}, torque{};
                    force[axis] = 0.7 * s3 * info.mass;
                    torque[axis] = 0.3 * s5 * info.inertia[axis * 4];
                    push(world, force_on(pushed, LR_FORCE_MODE_FORCE, LR_FRAME_WORLD, force));
                    push(world, force_on(wrung, LR_FORCE_MODE_FORCE, LR_FRAME_BODY, {}, torque));
                    steps(world, 1, narrow(dt), 2);
                    CHECK(wide(state_of(world, pushed).linear_velocity[axis]) ==
                          doctest::Approx(force[axis] / mass * dt).epsilon(1e-5));
                    CHECK(wide(state_of(world, wrung).angular_velocity[axis]) ==
                          doctest::Approx(torque[axis] / inertia * dt).epsilon(1e-5));
                }
}

TEST_CASE("a force is gone after the step, and forces before it add up") {
    const Asset asset = foil();
    const double mass = info_of(asset).mass + info_of(asset).added_mass[0];
    for (int32_t integrator : integrators) {
        const World world = weightless();
        const lr_batch batch = add_batch(world, without_loads(integrator), asset, 20);
        const lr_body id = add_body(world, batch, body_desc());
        const lr_body other = add_body(world, batch, body_desc());
        push(world, force_on(id, LR_FORCE_MODE_FORCE, LR_FRAME_WORLD, {mass, 0.0, 0.0}));
        push(world, force_on(id, LR_FORCE_MODE_FORCE, LR_FRAME_WORLD, {0.5 * mass, 0.0, 0.0}));
        push(world, force_on(id, LR_FORCE_MODE_FORCE, LR_FRAME_BODY, {0.25 * mass, 0.0, 0.0}));
        push(world, force_on(id, LR_FORCE_MODE_ACCELERATION, LR_FRAME_WORLD, {0.25, 0.0, 0.0}));
        steps(world, 1, 0.25f, 3);
        CHECK(wide(state_of(world, id).linear_velocity[0]) == doctest::Approx(0.5).epsilon(1e-6));
        steps(world, 3, 0.25f, 2);
        CHECK(wide(state_of(world, id).linear_velocity[0]) == doctest::Approx(0.5).epsilon(1e-6));
        CHECK(state_of(world, other).linear_velocity[0] == 0.0f);
    }
}

TEST_CASE("an impulse changes the momentum of body and fluid by itself, a velocity the velocity, at once") {
    Random random(8);
    lr_ellipsoid_desc shape = in_water(ellipsoid(0.04, 0.02, 0.01, 1200.0));
    for (double offset : {0.0, 0.01}) {
        shape.center_of_mass[0] = offset;
        const Asset asset = make(shape);
        for (double scale : {0.1, 1.0, 3.0})
            for (int round = 0; round < 20; ++round) {
                // Every third body is baked in air and lies in water.
                const bool dips = round % 3 == 0;
                lr_ellipsoid_desc in_air = shape;
                in_air.fluid_density = 1.2, in_air.fluid_viscosity = 1.5e-5;
                const ReferenceBody reference(info_of(asset), scale);
                const World world = weightless();
                set_wind(world, 1.0f, -2.0f, 0.5f);
                if (dips) {
                    lr_water_desc water = water_desc();
                    water.position[1] = 100.0f, water.density = narrow(shape.fluid_density);
                    set_water(world, water);
                }
                const Asset used = make(dips ? in_air : shape);
                const lr_batch batch = add_batch(world, batch_desc(), used, 1);
                lr_body_desc d = turned(random, scale);
                for (float& v : d.linear_velocity) v = random.real(-0.1, 0.1);
                const lr_body id = add_body(world, batch, d);
                const lr_body_state before = state_of(world, id);
                const Quat q = quat(before.orientation);
                const double unit = scale * scale * scale * info_of(asset).mass;
                const Vec impulse{unit * random.uniform(-1.0, 1.0), unit * random.uniform(-1.0, 1.0), 0.3 * unit};
                const Vec arm{0.01 * scale, random.uniform(-0.02, 0.02) * scale, -0.005 * scale};
                const bool in_world = round % 2 == 0;
                lr_body_force f = force_on(id, LR_FORCE_MODE_IMPULSE, in_world ? LR_FRAME_WORLD : LR_FRAME_BODY,
                                           impulse, 0.1 * scale * 0.02 * impulse);
                f.flags = LR_FORCE_AT_POINT;
                put(f.point, in_world ? vec(before.position) + arm : arm);
                push(world, f);
                const lr_body_state after = state_of(world, id);
                // The arm as single precision has it.
                const Vec r = in_world ? vec(f.point) - vec(before.position) : vec(f.point);
                Vec j = vec(f.force), h = vec(f.torque) + cross(r, vec(f.force));
                if (in_world) j = to_body(q, j), h = to_body(q, h);
                const Six change = reference.mass * join(upper(twist_of(after)) - upper(twist_of(before)),
                                                         lower(twist_of(after)) - lower(twist_of(before)));
                check_close(change, join(j, h), 2e-5);
                for (int32_t frame : {LR_FRAME_WORLD, LR_FRAME_BODY}) {
                    const Vec dv{0.3, -0.2, 0.1}, dw{1.0, 2.0, -3.0};
                    const Six now = twist_of(state_of(world, id));
                    push(world, force_on(id, LR_FORCE_MODE_VELOCITY, frame, dv, dw));
                    const Six then = twist_of(state_of(world, id));
                    const Six expected = frame == LR_FRAME_BODY ? join(dv, dw) : join(to_body(q, dv), to_body(q, dw));
                    for (size_t i = 0; i < 6; ++i)
                        CHECK(std::abs(then[i] - now[i] - expected[i]) < 1e-6 * (1.0 + largest(now) + largest(then)));
                }
            }
    }
}

TEST_CASE("an impulse asks a water callback once, and its limit is that of the fluid that it moves") {
    const World world = weightless();
    const Asset film = make(ellipsoid(0.1, 0.1, 1e-5, 100.0));
    const lr_batch batch = add_batch(world, batch_desc(), film, 1);
    const lr_body id = add_body(world, batch, body_desc());
    const Vec impulse{0.0, 0.0, 1.5e6 * (info_of(film).mass + info_of(film).added_mass[14])};
    const lr_body_force strong = force_on(id, LR_FORCE_MODE_IMPULSE, LR_FRAME_BODY, impulse, {});
    CHECK(lr_body_add_force(world.get(), &strong, 1) == LR_ERROR_INVALID_ARGUMENT);
    uint32_t asked = 0;
    const auto count = [](void* sum, const lr_water_query* q) { *static_cast<uint32_t*>(sum) += q->count; };
    REQUIRE(lr_world_set_water_callback(world.get(), count, &asked) == LR_OK);
    lr_water_desc water = water_desc();
    water.position[1] = 1.0f;
    set_water(world, water);
    push(world, force_on(id, LR_FORCE_MODE_IMPULSE, LR_FRAME_BODY, 1e-6 * impulse, {}));
    CHECK(asked == 1);
    push(world, strong);
    CHECK(state_of(world, id).linear_velocity[2] < 1e5f);
}

TEST_CASE("an acceleration is the body's, whatever its mass and the fluid's") {
    Random random(3);
    lr_ellipsoid_desc shape = in_water(ellipsoid(0.04, 0.02, 0.001, 300.0));
    for (double offset : {0.0, 0.01}) {
        shape.center_of_mass[0] = offset;
        const Asset asset = make(shape);
        for (int32_t integrator : integrators)
            for (int32_t frame : {LR_FRAME_WORLD, LR_FRAME_BODY})
                for (double scale : {0.5, 2.0}) {
                    const World world = weightless();
                    const lr_batch batch = add_batch(world, without_loads(integrator), asset, 1);
                    const lr_body id = add_body(world, batch, turned(random, scale));
                    const Quat q = quat(state_of(world, id).orientation);
                    const Vec a{1.0, -2.0, 0.5}, alpha{3.0, 1.0, -2.0};
                    push(world, force_on(id, LR_FORCE_MODE_ACCELERATION, frame, a, alpha));
                    const double dt = 1e-4;
                    steps(world, 1, narrow(dt), 1);
                    const Six rate = frame == LR_FRAME_BODY ? join(a, alpha) : join(to_body(q, a), to_body(q, alpha));
                    check_close(twist_of(state_of(world, id)), scaled(rate, dt), 2e-3);
                }
    }
}

// Half a second of tumbling under forces in both frames, with the orientation of each substep.
TEST_CASE("motion under steady forces is that of the equations, on single bodies and on a batch with the same bits") {
    Random random(12);
    lr_ellipsoid_desc shape = in_water(ellipsoid(0.04, 0.02, 0.01, 1200.0));
    for (double offset : {0.0, 0.01}) {
        shape.center_of_mass[0] = offset;
        const Asset asset = make(shape);
        const double scale = 1.5, unit = 1.5 * 1.5 * 1.5 * info_of(asset).mass, time = 0.25;
        const Vec force{2.0 * unit, unit, -unit}, torque{0.02 * unit, -0.01 * unit, 0.01 * unit};
        for (int32_t integrator : integrators) {
            const auto make_world = [&](lr_batch& batch, lr_body& id) {
                lr_world_desc wd = world_desc();
                World world = make(wd);
                lr_batch_desc bd = langevin();
                bd.integrator = integrator;
                bd.noise_gain = 0.0f;
                bd.clock = LR_CLOCK_AGE;
                batch = add_batch(world, bd, asset, 1);
                set_constant_table(world, batch, 1.5, 0.1, 2.0);
                Random same(5);
                id = add_body(world, batch, turned(same, scale));
                return world;
            };
            lr_batch batch{}, batch2{};
            lr_body id{}, id2{};
            const World single = make_world(batch, id), whole = make_world(batch2, id2);
            lr_body_force in_world = force_on(id, LR_FORCE_MODE_FORCE, LR_FRAME_WORLD, force, torque);
            lr_body_force in_body = force_on(id, LR_FORCE_MODE_FORCE, LR_FRAME_BODY, 0.5 * force, 2.0 * torque);
            lr_batch_force all = initialised(lr_batch_force_init);
            std::copy(in_world.force, in_world.force + 3, all.force);
            std::copy(in_world.torque, in_world.torque + 3, all.torque);
            std::copy(in_body.force, in_body.force + 3, all.body_force);
            std::copy(in_body.torque, in_body.torque + 3, all.body_torque);
            REQUIRE(lr_batch_set_force(whole.get(), batch2, &all) == LR_OK);

            ReferenceBody reference(info_of(asset), scale);
            reference.world_force = join(vec(in_world.force), vec(in_world.torque));
            reference.body_force = join(vec(in_body.force), vec(in_body.torque));
            reference.alpha = [](double, double) { return 3.0; };
            Random same(5);
            const ReferenceBody::State expected = reference.run(reference.begin(turned(same, scale)), time, 4000);

            for (int i = 0; i < 25; ++i) {
                push(single, in_world);
                push(single, in_body);
                steps(single, 1, narrow(time / 25), 40);
                steps(whole, 1, narrow(time / 25), 40);
            }
            const lr_body_state s = state_of(single, id);
            CHECK(hash_of(single) == hash_of(whole));
            const double tolerance = integrator == LR_INTEGRATOR_RK4 ? 1e-4 : 2e-3;
            CHECK(length(vec(s.position) - expected.x) < tolerance);
            check_close(join(vec(s.linear_velocity), vec(s.angular_velocity)),
                        join(reference.velocity(expected), reference.spin(expected)), 3.0 * tolerance);
            REQUIRE(lr_batch_set_force(whole.get(), batch2, nullptr) == LR_OK);
            steps(single, 5, 0.01f, 2);
            steps(whole, 5, 0.01f, 2);
            CHECK(hash_of(single) == hash_of(whole));
        }
    }
}

// Drag of the AGE clock is linear: rho (V + A) alpha v. Velocity relaxes towards the force's balance exactly, as for weight.
TEST_CASE("a body under a steady force settles at its terminal velocity at any step") {
    const Asset asset = make(in_water(ellipsoid(0.02, 0.02, 0.02, 1500.0)));
    const lr_asset_info info = info_of(asset);
    for (float dt : {1e-3f, 0.0166f, 0.1f, 1.0f})
        for (int32_t frame : {LR_FRAME_WORLD, LR_FRAME_BODY}) {
            const World world = weightless();
            lr_batch_desc bd = langevin();
            bd.clock = LR_CLOCK_AGE;
            bd.noise_gain = 0.0f;
            const lr_batch batch = add_batch(world, bd, asset, 1);
            set_constant_table(world, batch, 20.0, 0.3, 2.0); // alpha 40/s
            lr_batch_force f = initialised(lr_batch_force_init);
            (frame == LR_FRAME_WORLD ? f.force : f.body_force)[2] = 0.05f;
            REQUIRE(lr_batch_set_force(world.get(), batch, &f) == LR_OK);
            const lr_body id = add_body(world, batch, body_desc());
            steps(world, dt < 0.01f ? 2000 : 100, dt);
            const double terminal = wide(0.05f) / (1.5 * info.fluid_density * info.volume * 40.0);
            CHECK(wide(state_of(world, id).linear_velocity[2]) == doctest::Approx(terminal).epsilon(1e-4));
        }
}

TEST_CASE("a force against weight holds a body still, whatever the step") {
    const Asset asset = leaf();
    for (float dt : {1e-3f, 0.0166f, 0.1f, 1.0f}) {
        const World world = make(world_desc());
        lr_batch_desc bd = langevin();
        bd.noise_gain = 0.0f;
        const lr_batch batch = add_batch(world, bd, asset, 1);
        const lr_asset_info info = info_of(asset);
        const lr_body id = add_body(world, batch, body_desc());
        for (int i = 0; i < 50; ++i) {
            push(world, force_on(id, LR_FORCE_MODE_FORCE, LR_FRAME_WORLD,
                                 {0.0, 9.81 * (info.mass - info.fluid_density * info.volume), 0.0}));
            steps(world, 1, dt, 2);
        }
        CHECK(length(vec(state_of(world, id).linear_velocity)) < 1e-4 * wide(dt) * 50);
    }
}

// With a force, bodies farther away count as near the ground, and are stepped there with other roundings.
TEST_CASE("forces that cancel, or whose body has ended, leave the bits of all bodies as they were") {
    uint64_t hash[3];
    for (int pushed = 0; pushed < 3; ++pushed) {
        const World world = make(world_desc());
        lr_collider_desc ground = collider_desc(LR_COLLIDER_PLANE);
        ground.position[1] = -1.2f;
        add_collider(world, ground);
        const lr_batch batch = add_batch(world, curled_leaf(), 40);
        Random random(3);
        std::vector<lr_body> bodies;
        for (int i = 0; i < 40; ++i) bodies.push_back(add_body(world, batch, turned(random)));
        lr_body_force f = force_on(bodies[2], LR_FORCE_MODE_FORCE, LR_FRAME_WORLD, {0.0, 1e-3, 0.0});
        if (pushed > 0) push(world, f);
        f.force[1] = -f.force[1];
        if (pushed == 1) push(world, f);
        REQUIRE(lr_body_destroy(world.get(), &bodies[2], 1) == LR_OK);
        steps(world, 3, 1.0f / 60.0f, 2);
        hash[pushed] = hash_of(world);
    }
    CHECK(hash[1] == hash[0]);
    CHECK(hash[2] == hash[0]);
}

TEST_CASE("a pending force goes along with its body when others are destroyed") {
    const Asset asset = foil();
    const World world = weightless();
    const lr_batch batch = add_batch(world, without_loads(LR_INTEGRATOR_DEFAULT), asset, 20);
    lr_body ids[4];
    for (lr_body& id : ids) id = add_body(world, batch, body_desc());
    push(world, force_on(ids[0], LR_FORCE_MODE_FORCE, LR_FRAME_WORLD, {0.0, 0.0, 1.0}));
    push(world, force_on(ids[2], LR_FORCE_MODE_FORCE, LR_FRAME_WORLD, {0.0, 1.0, 0.0}));
    push(world, force_on(ids[3], LR_FORCE_MODE_FORCE, LR_FRAME_WORLD, {1.0, 0.0, 0.0}));
    REQUIRE(lr_body_destroy(world.get(), &ids[0], 1) == LR_OK); // the last body takes its place
    REQUIRE(lr_body_destroy(world.get(), &ids[2], 1) == LR_OK);
    const lr_body spawned = add_body(world, batch, body_desc());
    steps(world, 1, 0.01f);
    CHECK(length(vec(state_of(world, ids[1]).linear_velocity)) == 0.0);
    CHECK(length(vec(state_of(world, spawned).linear_velocity)) == 0.0);
    const lr_body_state s = state_of(world, ids[3]);
    CHECK((s.linear_velocity[0] > 0.0f && s.linear_velocity[1] == 0.0f && s.linear_velocity[2] == 0.0f));
}

TEST_CASE("arrays of forces do what single forces do, with any stride and from any first body") {
    const Asset asset = curled_leaf();
    for (int32_t mode :
         {LR_FORCE_MODE_FORCE, LR_FORCE_MODE_ACCELERATION, LR_FORCE_MODE_IMPULSE, LR_FORCE_MODE_VELOCITY})
        for (int32_t frame : {LR_FRAME_WORLD, LR_FRAME_BODY}) {
            const World one = make(world_desc()), many = make(world_desc());
            const lr_batch b1 = add_batch(one, asset, 100), b2 = add_batch(many, asset, 100);
            Random random(6);
            std::vector<lr_body> ids;
            for (int i = 0; i < 60; ++i) {
                const lr_body_desc d = turned(random, random.uniform(0.5, 2.0));
                ids.push_back(add_body(one, b1, d));
                add_body(many, b2, d);
            }
            struct Vertex {
                float position[3], force[3], torque[3];
            };
            std::vector<Vertex> vertices(40);
            for (size_t i = 0; i < vertices.size(); ++i) {
                for (float& f : vertices[i].force) f = random.real(-1e-4, 1e-4);
                for (float& t : vertices[i].torque) t = random.real(-1e-6, 1e-6);
                push(one, force_on(ids[i + 15], mode, frame, vec(vertices[i].force), vec(vertices[i].torque)));
            }
            lr_force_arrays a = initialised(lr_force_arrays_init);
            a.mode = mode;
            a.frame = frame;
            a.first = 15;
            a.count = 40;
            a.stride = sizeof(Vertex);
            for (size_t i = 0; i < 3; ++i) a.force[i] = &vertices[0].force[i], a.torque[i] = &vertices[0].torque[i];
            REQUIRE(lr_batch_add_forces(many.get(), b2, &a) == LR_OK);
            CHECK(hash_of(one) == hash_of(many));
            steps(one, 2, 0.01f, 2);
            steps(many, 2, 0.01f, 2);
            CHECK(hash_of(one) == hash_of(many));
        }
}

// Pending forces are part of the state: a game that rolls back to the start of a tick has already applied that tick's.
TEST_CASE("pending and steady forces go through snapshots") {
    const Asset asset = foil();
    const auto scene = [&](lr_batch& batch) {
        World world = make(world_desc());
        batch = add_batch(world, asset, 30);
        return world;
    };
    lr_batch batch{}, other{};
    const World world = scene(batch), empty = scene(other);
    std::vector<lr_body> ids;
    for (int i = 0; i < 21; ++i) ids.push_back(add_body(world, batch, body_desc()));
    const std::vector<unsigned char> calm = snapshot_of(world);
    const uint64_t without = hash_of(world);
    for (size_t i = 0; i < 21; i += 2)
        push(world, force_on(ids[i], LR_FORCE_MODE_FORCE, LR_FRAME_WORLD, {0.01 * static_cast<double>(i), 0.0, 0.1}));
    lr_batch_force all = initialised(lr_batch_force_init);
    all.body_angular_acceleration[2] = 1.0f;
    REQUIRE(lr_batch_set_force(world.get(), batch, &all) == LR_OK);
    const uint64_t before = hash_of(world);
    CHECK(before != without);
    const std::vector<unsigned char> snapshot = snapshot_of(world);
    steps(world, 5, 0.01f, 2);
    const uint64_t expected = hash_of(world);
    for (const World* w : {&world, &empty}) {
        REQUIRE(lr_world_snapshot_restore(w->get(), snapshot.data(), snapshot.size()) == LR_OK);
        CHECK(hash_of(*w) == before);
        CHECK(snapshot_of(*w) == snapshot);
        steps(*w, 5, 0.01f, 2);
        CHECK(hash_of(*w) == expected);
    }
    // A snapshot without pending forces removes them.
    REQUIRE(lr_world_snapshot_restore(world.get(), snapshot.data(), snapshot.size()) == LR_OK);
    REQUIRE(lr_world_snapshot_restore(world.get(), calm.data(), calm.size()) == LR_OK);
    CHECK(snapshot_of(world) == calm);
}
