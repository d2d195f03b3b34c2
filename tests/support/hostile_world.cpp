#include "support/hostile_world.h"

#include "support/aerodynamic_fields.h"
#include "support/colliders.h"
#include "support/contact_events.h"
#include "support/lifecycle.h"
#include "support/wind.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace test {
namespace {

// Often the minimum or maximum, else of any magnitude in between.
float wild(Random& random, double least, double most) {
    switch (random.below(4)) {
    case 0:
        return narrow(most);
    case 1:
        return narrow(least);
    default:
        return narrow(random.logarithmic(least, most));
    }
}
float either_way(Random& random, double least, double most) {
    const float value = random.below(5) == 0 ? 0.0f : wild(random, least, most);
    return random.below(2) == 0 ? value : -value;
}
bool chance(Random& random, uint32_t one_in) {
    return random.below(one_in) == 0;
}

// From the position alone: numbers, very large numbers, and non-finite ones.
float nonsense(float a, float b) {
    uint32_t bits = 0;
    const float sum = a * 3.0f + b;
    std::memcpy(&bits, &sum, 4);
    switch ((bits * 2654435761u) >> 29) {
    case 0:
        return std::numeric_limits<float>::infinity();
    case 1:
        return std::numeric_limits<float>::quiet_NaN();
    case 2:
        return -3e38f;
    case 3:
        return 1e6f;
    case 4:
        return 999.0f;
    default:
        return 1.0f;
    }
}
void mad_wind(void*, const lr_wind_query* q) {
    for (uint32_t i = 0; i < q->count; ++i) {
        for (size_t k = 0; k < 3; ++k) q->velocity[k][i] = nonsense(q->position[k][i], 1.0f);
        q->rate[0][i] = nonsense(q->position[1][i], 2.0f);
        for (size_t k = 0; k < 9; ++k) q->gradient[k][i] = nonsense(q->position[k % 3][i], 3.0f);
    }
}
void mad_surface(void*, const lr_water_query* q) {
    for (uint32_t i = 0; i < q->count; ++i) {
        q->height[i] = nonsense(q->position[0][i], 4.0f);
        for (size_t k = 0; k < 3; ++k) {
            q->velocity[k][i] = nonsense(q->position[k][i], 5.0f);
            q->rate[k][i] = nonsense(q->position[k][i], 6.0f);
        }
        if (i % 2 == 0) q->normal[0][i] = nonsense(q->position[2][i], 7.0f);
    }
}

Asset mad_asset(Random& random) {
    for (;;) {
        lr_asset* asset = nullptr;
        lr_ellipsoid_desc d = ellipsoid(0.04, 0.01, 0.00005, 800.0);
        switch (random.below(5)) {
        case 0:
            return leaf();
        case 1:
            return curled_leaf();
        case 2:
            return brick();
        case 3:
            for (double& axis : d.semi_axes) axis = random.logarithmic(1e-6, 1e3);
            d.density = random.logarithmic(1e-6, 1e6);
            d.fluid_density = random.logarithmic(1e-3, 1e4);
            d.fluid_viscosity = random.logarithmic(1e-9, 1.0);
            d.intensity = random.below(11);
            break;
        default:
            for (double& axis : d.semi_axes) axis = random.logarithmic(1e-3, 1.0);
            d.center_of_mass[random.below(3)] = 0.4 * *std::min_element(d.semi_axes, d.semi_axes + 3);
            d.density = random.logarithmic(1e-2, 1e4);
            break;
        }
        if (lr_asset_create_ellipsoid(&d, &asset) == LR_OK) return Asset(asset);
    }
}

} // namespace

std::string beyond_limits(const World& world, lr_batch batch) {
    const lr_batch_view v = view_of(world, batch);
    const std::vector<Velocity> u = velocities_of(world, batch);
    for (uint32_t i = 0; i < v.count; ++i) {
        double turn = 0.0, speed = 0.0, spin = 0.0;
        bool near = true;
        for (size_t k = 0; k < 3; ++k) {
            near = near && std::abs(v.position[k][i]) <= 1e10f;
            speed += wide(u[i].linear[k]) * wide(u[i].linear[k]);
            spin += wide(u[i].angular[k]) * wide(u[i].angular[k]);
        }
        for (const float* q : v.orientation) turn += wide(q[i]) * wide(q[i]);
        if (!near) return "a position";
        if (!(speed <= 4.0001e12)) return "a velocity";
        if (!(spin <= 1.0001e18)) return "a spin";
        if (!(std::abs(turn - 1.0) <= 0.03)) return "an orientation";
        if (!(v.age[i] >= 0.0f && std::isfinite(v.age[i]))) return "an age";
        const lr_body_state s = state_of(world, v.ids[i]);
        for (size_t k = 0; k < 3; ++k)
            if (!std::isfinite(s.position[k]) || !std::isfinite(s.linear_velocity[k]) ||
                !std::isfinite(s.angular_velocity[k]))
                return "a state";
        if (s.sleep_state == LR_SLEEP_HELD && (speed != 0.0 || spin != 0.0)) return "the velocity of one that is held";
    }
    return {};
}

HostileWorld::HostileWorld(uint64_t seed, const How& how) : seed_(seed), how_(how) {
    build();
    Random random(seed_ * 7 + 2);
    for (const lr_batch batch : batches) populate(random, batch, 30);
}

void HostileWorld::build() {
    Random random(seed_ * 7 + 1);
    lr_world_desc d = world_desc();
    d.seed = seed_;
    d.simd_target = how_.simd;
    d.worker_count = how_.workers;
    if (chance(random, 3)) d.fluid_density = wild(random, 1e-3, 1e5);
    if (chance(random, 3)) d.fluid_viscosity = wild(random, 1e-9, 1e2);
    for (float& g : d.gravity) g = chance(random, 3) ? either_way(random, 1e-3, 1e4) : either_way(random, 1.0, 10.0);
    world = make(d);
    REQUIRE(lr_world_set_events(world.get(), 4096, LR_EVENTS_ALL) == LR_OK);
    batches.clear();
    assets_.clear();
    colliders_.clear();
    add_fluids(random);
    add_batches(random);
    add_solids(random);
}

void HostileWorld::add_fluids(Random& random) {
    if (chance(random, 2)) {
        float w[3];
        for (float& v : w) v = either_way(random, 0.1, 1000.0);
        REQUIRE(lr_world_set_uniform_wind(world.get(), w[0], w[1], w[2]) == LR_OK);
    }
    for (uint32_t n = chance(random, 2) ? random.below(4) : 0; n > 0; --n) {
        static const std::vector<float> samples = grid_samples();
        AnySource source = one_of_each(samples)[random.below(8)];
        std::visit(
            [&](auto& s) {
                if constexpr (requires { s.position; })
                    for (float& x : s.position) x = either_way(random, 0.1, 1e6);
                if constexpr (requires { s.rms; }) s.rms = wild(random, 0.1, 1000.0);
                if constexpr (requires { s.speed; }) s.speed = wild(random, 0.1, 1000.0);
                if constexpr (requires { s.circulation; }) s.circulation = either_way(random, 1.0, 1e6);
                if constexpr (requires { s.core_radius; }) s.core_radius = wild(random, 1e-4, 1e3);
                if constexpr (requires { s.nozzle_radius; }) s.nozzle_radius = wild(random, 1e-4, 1e3), s.range = 1e4f;
                if constexpr (requires { s.integral_length; }) s.integral_length = wild(random, 1e-4, 1e3);
                if constexpr (requires { s.roughness_length; }) s.roughness_length = wild(random, 1e-4, 10.0);
                if constexpr (requires { s.octaves; }) s.octaves = 1 + random.below(4);
                if constexpr (requires { s.integral_time; }) s.integral_time = wild(random, 1e-4, 1e6);
                if constexpr (requires { s.eddy_life; }) s.eddy_life = wild(random, 1e-4, 1e6);
            },
            source);
        lr_wind_source unused{};
        add_wind(world.get(), &source, &unused);
    }
    if (chance(random, 4)) REQUIRE(lr_world_set_wind_callback(world.get(), mad_wind, nullptr) == LR_OK);
    if (chance(random, 3)) {
        lr_water_desc s = initialised(lr_water_desc_init);
        s.density = wild(random, 1e-3, 1e6);
        s.viscosity = wild(random, 1e-12, 1e3);
        for (float& v : s.current) v = either_way(random, 0.1, 1000.0);
        s.reach = wild(random, 1.0, 1e6);
        s.wave_count = random.below(3);
        for (uint32_t i = 0; i < s.wave_count; ++i) {
            s.waves[i].direction[0] = 1.0f;
            s.waves[i].length = wild(random, 1e-3, 1e6);
            s.waves[i].amplitude = s.waves[i].length / 8.0f;
        }
        lr_world_set_water(world.get(), &s);
        if (chance(random, 2)) REQUIRE(lr_world_set_water_callback(world.get(), mad_surface, nullptr) == LR_OK);
    }
}

void HostileWorld::add_batches(Random& random) {
    const uint32_t count = 1 + random.below(3);
    for (uint32_t b = 0; b < count; ++b) {
        assets_.push_back(mad_asset(random));
        lr_batch_desc d = batch_desc();
        d.asset = assets_.back().get();
        d.capacity = 40;
        d.load_model = static_cast<int32_t>(random.below(4));
        d.clock = static_cast<int32_t>(random.below(2));
        d.table_end = static_cast<int32_t>(random.below(2));
        d.integrator = static_cast<int32_t>(random.below(3));
        if (chance(random, 3)) d.damping_gain = d.noise_gain = 100.0f;
        lr_batch batch{};
        if (lr_batch_create(world.get(), &d, &batch) != LR_OK)
            continue; // its mass matrix can be singular in that fluid
        batches.push_back(batch);
        if (chance(random, 3)) {
            const float chi[2] = {wild(random, 1e-6, 1e6), wild(random, 1e-6, 3e38)};
            const float epsilon[2] = {wild(random, 1e-6, 3e38), wild(random, 1e-6, 1e6)};
            lr_turbulence_table t = table_desc();
            t.count = 2, t.chi = chi, t.epsilon = epsilon;
            t.dt = wild(random, 1e-9, 1e9), t.u0 = wild(random, 1e-9, 1e6), t.l = wild(random, 1e-9, 1e6);
            lr_batch_set_turbulence_table(world.get(), batch, &t);
        }
        if (chance(random, 3)) {
            lr_load_gains g = initialised(lr_load_gains_init);
            for (float* gain : {&g.drag, &g.lift, &g.spin_drag, &g.turbulence})
                *gain = chance(random, 2) ? 100.0f : 0.0f;
            lr_batch_set_load_gains(world.get(), batch, &g);
        }
        if (chance(random, 3)) {
            lr_aerodynamics a = initialised(lr_aerodynamics_init);
            REQUIRE(lr_batch_get_aerodynamics(world.get(), batch, &a) == LR_OK);
            for (const AerodynamicField& f : aerodynamic_fields)
                for (size_t k = 0; k < f.size && f.offset != offsetof(lr_aerodynamics, center); ++k)
                    f.in(a)[k] = std::clamp(f.in(a)[k] * random.logarithmic(1e-3, 1e6), f.least, f.most);
            lr_batch_set_aerodynamics(world.get(), batch, &a);
        }
        if (chance(random, 3)) REQUIRE(lr_batch_set_rate(world.get(), batch, 1 + random.below(6)) == LR_OK);
        if (chance(random, 3)) {
            lr_batch_force f = initialised(lr_batch_force_init);
            for (float* of : {f.force, f.torque, f.acceleration, f.body_torque})
                of[random.below(3)] = either_way(random, 1e-3, 1e9);
            REQUIRE(lr_batch_set_force(world.get(), batch, &f) == LR_OK);
        }
        REQUIRE(lr_batch_set_divergence_policy(world.get(), batch, static_cast<int32_t>(random.below(3))) == LR_OK);
        if (chance(random, 3)) {
            lr_emitter_desc e = emitter_desc();
            e.shape = LR_EMIT_BOX;
            for (size_t k = 0; k < 3; ++k) e.position[k] = either_way(random, 1.0, 1e9), e.size[k] = 1.0f;
            e.speed_max = wild(random, 1.0, 1e6);
            e.spin_max = wild(random, 1.0, 1e6);
            e.scale_min = 1e-3f, e.scale_max = 1e3f;
            e.rate = 30.0f;
            set_emitter(world, batch, e);
            lr_batch_rules r = rules_desc();
            r.action = chance(random, 2) ? LR_END_RESPAWN : LR_END_DESTROY;
            r.max_age = chance(random, 2) ? 0.0f : 2.0f;
            set_rules(world, batch, r);
        }
        if (chance(random, 2))
            lr_batch_set_body_contact(world.get(), batches[random.below(static_cast<uint32_t>(batches.size()))], batch,
                                      1);
    }
}

void HostileWorld::add_solids(Random& random) {
    if (chance(random, 2)) return;
    static const std::vector<float> heights = [] {
        std::vector<float> h(64);
        for (size_t i = 0; i < h.size(); ++i) h[i] = narrow(static_cast<double>(i * 37 % 11)) * 0.1f;
        return h;
    }();
    const Triangles sheet = bumpy_sheet(6, 3);
    for (uint32_t n = 1 + random.below(4); n > 0; --n) {
        lr_collider_desc d = collider_desc(LR_COLLIDER_PLANE);
        switch (random.below(6)) {
        case 0:
            break;
        case 1:
            d = sphere_collider(wild(random, 1e-3, 1e3));
            break;
        case 2:
            d = box_collider(wild(random, 1e-3, 1e3), 0.1f, wild(random, 1e-3, 1e3));
            break;
        case 3:
            d = heightfield_collider(heights, 8, wild(random, 1e-2, 1e2));
            break;
        case 4:
            d = mesh_collider(sheet);
            break;
        default:
            d = collider_desc(LR_COLLIDER_CAPSULE);
            d.size[0] = 0.1f, d.size[1] = 1.0f;
        }
        for (float& x : d.position) x = either_way(random, 1e-2, 2.0);
        for (float& v : d.linear_velocity) v = either_way(random, 1e-3, 1e6);
        if (chance(random, 2)) d.angular_velocity[1] = either_way(random, 1.0, 1e6);
        d.friction = wild(random, 0.1, 10.0);
        d.restitution = wild(random, 0.1, 1.0);
        colliders_.push_back(add_collider(world, d));
    }
    for (const lr_batch batch : batches) {
        lr_batch_contact c = initialised(lr_batch_contact_init);
        c.friction = wild(random, 0.1, 10.0), c.restitution = wild(random, 0.1, 1.0);
        c.rolling_resistance = wild(random, 0.1, 10.0), c.ground_effect = chance(random, 2) ? 1.0f : 0.0f;
        c.min_thickness = chance(random, 2) ? 0.0f : wild(random, 1e-3, 10.0);
        REQUIRE(lr_batch_set_contact(world.get(), batch, &c) == LR_OK);
    }
}

void HostileWorld::populate(Random& random, lr_batch batch, uint32_t count) {
    const bool together = chance(random, 2), fast = chance(random, 3);
    for (uint32_t i = 0; i < count; ++i) {
        lr_body_desc d = body_desc();
        for (float& x : d.position)
            x = together || !chance(random, 8) ? random.real(-0.3, 0.3) : either_way(random, 1.0, 1e9);
        for (float& q : d.orientation) q = random.real(-1.0, 1.0);
        if (fast || chance(random, 8)) {
            for (float& v : d.linear_velocity) v = either_way(random, 1.0, 1e6);
            for (float& w : d.angular_velocity) w = either_way(random, 1.0, 1e6);
        }
        d.scale = chance(random, 4) ? wild(random, 1.001e-3, 1e3) : 1.0f;
        if (chance(random, 6)) d.age = wild(random, 1.0, 1e9);
        lr_body_create(world.get(), batch, &d, 1, nullptr);
    }
}

void HostileWorld::push(Random& random) {
    for (const lr_batch batch : batches) {
        const lr_batch_view v = view_of(world, batch);
        for (uint32_t n = 0; n < 12 && v.count != 0; ++n) {
            const lr_body body = view_of(world, batch).ids[random.below(view_of(world, batch).count)];
            lr_body_force f = initialised(lr_body_force_init);
            f.body = body;
            f.mode = static_cast<int32_t>(random.below(4));
            f.frame = static_cast<int32_t>(random.below(2));
            const float size = wild(random, 1e-6, chance(random, 2) ? 1e30 : 1e6);
            f.force[random.below(3)] = size;
            f.torque[random.below(3)] = wild(random, 1e-12, 1e6);
            // A single force beyond the limit is refused, but the sum of many is not.
            if (lr_body_add_force(world.get(), &f, 1) == LR_OK)
                for (int more = 0; more < 20; ++more) lr_body_add_force(world.get(), &f, 1);
        }
    }
    if (chance(random, 4)) {
        const float g[3] = {either_way(random, 1.0, 1e4), either_way(random, 1.0, 1e4), either_way(random, 1.0, 1e4)};
        REQUIRE(lr_world_set_gravity(world.get(), g) == LR_OK);
    }
    for (const lr_collider collider : colliders_) {
        lr_collider_motion m = motion_of(collider, 1 + static_cast<int32_t>(random.below(3)));
        for (float& x : m.position) x = either_way(random, 1e-2, chance(random, 6) ? 1e9 : 20.0);
        for (float& v : m.linear_velocity) v = either_way(random, 1.0, 1e6);
        if (chance(random, 2)) REQUIRE(lr_collider_move(world.get(), &m, 1) == LR_OK);
    }
    for (const lr_batch batch : batches) {
        const lr_batch_view v = view_of(world, batch);
        if (v.count == 0 || !chance(random, 2)) continue;
        const lr_body body = v.ids[random.below(v.count)];
        REQUIRE(lr_body_set_sleep(world.get(), &body, 1, chance(random, 4) ? LR_SLEEP_AWAKE : LR_SLEEP_ASLEEP) ==
                LR_OK);
        const lr_body freed = view_of(world, batch).ids[random.below(v.count)];
        lr_body_state s = state_of(world, freed);
        if (s.sleep_state != LR_SLEEP_HELD) continue;
        for (float& x : s.position) x = std::clamp(x, -1e9f, 1e9f);
        REQUIRE(lr_body_set_state(world.get(), freed, &s) == LR_OK);
        CHECK(state_of(world, freed).sleep_state == LR_SLEEP_AWAKE);
    }
}

void HostileWorld::check() {
    uint64_t counted = 0;
    for (const lr_batch batch : batches) {
        const std::string wrong = beyond_limits(world, batch);
        REQUIRE(wrong == "");
        counted += counts_of(world, batch).diverged;
    }
    const lr_event_list list = event_list(world);
    REQUIRE(list.lost == 0);
    std::vector<lr_body> told;
    for (uint32_t i = 0; i < list.count; ++i) {
        if (list.events[i].kind != LR_EVENT_DIVERGED) continue;
        const lr_body body = list.events[i].body;
        told.push_back(body);
        const bool killed = std::any_of(list.events, list.events + list.count, [&](const lr_event& e) {
            return (e.kind == LR_EVENT_KILLED || e.kind == LR_EVENT_RESPAWNED) && e.body == body;
        });
        lr_body_state s = body_state();
        const bool there = lr_body_get_state(world.get(), body, &s) == LR_OK;
        CHECK((killed || (there && s.sleep_state == LR_SLEEP_HELD)));
    }
    std::sort(told.begin(), told.end());
    CHECK(std::adjacent_find(told.begin(), told.end()) == told.end());
    REQUIRE(told.size() == counted);
    faults_ += counted;
}

void HostileWorld::step(int frame) {
    if (frame == how_.through_snapshot) {
        const std::vector<unsigned char> bytes = snapshot_of(world);
        build();
        REQUIRE(lr_world_snapshot_restore(world.get(), bytes.data(), bytes.size()) == LR_OK);
    }
    Random random(seed_ * 1000 + static_cast<uint64_t>(frame) + 17);
    push(random);
    static constexpr float times[] = {1.0f / 60.0f, 1.0f / 60.0f, 1.0f, 0.1f, 1e-3f, 1e-9f, 1e-30f, 1e-44f};
    const uint32_t substeps = 1 + random.below(4);
    REQUIRE(lr_world_step(world.get(), times[random.below(8)], substeps) == LR_OK);
    check();
}

} // namespace test
