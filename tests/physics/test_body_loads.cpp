// lr_body_get_loads: against independent formulas, and the balance of a long fall.
#include "support/reference_body.h"
#include "support/station_bodies.h"
#include "support/water.h"

#include <vector>

using namespace test;

namespace {

lr_body_loads loads_of(const World& w, lr_body body) {
    lr_body_loads loads = initialised(lr_body_loads_init);
    REQUIRE(lr_body_get_loads(w.get(), body, &loads) == LR_OK);
    return loads;
}
Vec station(const float* of_all, uint32_t i) {
    return vec(of_all + size_t{3} * i);
}

lr_batch_desc exact() {
    lr_batch_desc d = batch_desc();
    d.variation = 0.0f;
    return d;
}

} // namespace

TEST_CASE("loads on a body: those of the equations, at its stations or at its load centre" *
          doctest::test_suite("exact")) {
    for (const size_t stations : {size_t{0}, size_t{3}, size_t{8}}) {
        CAPTURE(stations);
        lr::shape::EllipsoidSpec spec;
        spec.semi_axes = {0.04, 0.02, 0.001};
        spec.density = 200.0;
        spec.center_of_mass = {0.008, -0.003, 0.0004};
        lr::AssetData data = ellipsoid_data(spec);
        calm(data.aerodynamics);
        data.aerodynamics.start_drag = 0.3;
        data.stations = some_stations(stations, data.length_d, 5);
        const Asset asset = load(data);
        const lr_asset_info info = info_of(asset);
        const World world = make(world_desc());
        set_wind(world, 0.4f, -0.1f, 0.7f);
        const lr_batch batch = add_batch(world, exact(), asset, 20);
        Random random(stations + 1);
        for (int i = 0; i < 20; ++i) {
            lr_body_desc d = turned_anyhow(random, {1.0, 2.0, -3.0});
            d.scale = random.real(0.3, 3.0);
            for (size_t k = 0; k < 3; ++k)
                d.linear_velocity[k] = random.real(-2.0, 2.0), d.angular_velocity[k] = random.real(-20.0, 20.0);
            const lr_body_loads found = loads_of(world, add_body(world, batch, d));

            const double scale = wide(d.scale);
            ReferenceBody body(info, scale);
            body.wind = {0.4, -0.1, 0.7};
            const ReferenceBody::State s = body.begin(d);
            const Vec v = upper(s.twist), w = lower(s.twist);
            const Vec arm = body.buoyancy_arm + scale * data.aerodynamics.center;
            Vec force, torque, lost, lost_moment;
            if (stations != 0) {
                ReferenceStations parts{data.stations,        data.aerodynamics, scale, info.fluid_density,
                                        info.fluid_viscosity, info.length_d,     arm};
                parts.light = parts.fluid_inertia_of(info);
                const ReferenceStations::Loads sum = parts(v, w);
                force = sum.force, torque = sum.torque, lost = sum.lost, lost_moment = sum.lost_moment;
            } else {
                ReferenceLoads whole;
                whole.at = initialised(lr_aerodynamics_init);
                REQUIRE(lr_batch_get_aerodynamics(world.get(), batch, &whole.at) == LR_OK);
                whole.scale = scale, whole.density = info.fluid_density, whole.viscosity = info.fluid_viscosity;
                whole.length = info.length_d, whole.arm = arm;
                whole.light = fluid_inertia(info, whole.at.axes, whole.normal());
                const ReferenceLoads::Wrench sum = whole(v, w);
                force = sum.force, torque = sum.torque;
                const Vec n = whole.normal_of_body(), moment = cross(arm, n);
                const double momentum = whole.shed(v, w) * body.added_along(n) * (dot(n, v) + dot(moment, w));
                lost = momentum * n, lost_moment = momentum * moment;
            }
            // Momentum left in the wake pushes a body that turns.
            force = force + cross(w, lost);
            torque = torque + cross(w, lost_moment) + cross(v, lost);
            CHECK(length(vec(found.force) - to_world(s.q, force)) < 1e-4 * length(force));
            CHECK(length(vec(found.torque) - to_world(s.q, torque)) <
                  1e-3 * (length(torque) + 0.01 * scale * length(force)));
            CHECK(length(vec(found.stream) + to_world(s.q, v)) < 1e-5);
            CHECK(length(vec(found.wake)) == 0.0);
            CHECK(length(vec(found.shedding)) == 0.0);

            REQUIRE(found.station_count == std::max<size_t>(stations, 1));
            Vec sum{};
            for (uint32_t k = 0; k < found.station_count; ++k) sum = sum + station(found.station_force, k);
            CHECK(length(sum - vec(found.force)) < 1e-5 * length(force));
            for (size_t k = 0; k < stations; ++k) {
                const Vec place = to_world(s.q, scale * data.stations[k].place) + vec(d.position);
                CHECK(length(station(found.station_position, static_cast<uint32_t>(k)) - place) < 1e-5);
            }
            if (stations == 0)
                CHECK(length(station(found.station_position, 0) - (to_world(s.q, arm) + vec(d.position))) < 1e-5);
        }
    }
}

// Momentum stays bounded, so over a long fall loads carry the weight and push nowhere else.
TEST_CASE("loads on a body: their mean over a fall is its weight less its buoyancy") {
    for (const bool water : {false, true}) {
        CAPTURE(water);
        const Asset asset = water ? make(ellipsoid(0.012, 0.012, 0.0012, 2700.0)) : leaf();
        const lr_asset_info info = info_of(asset);
        const World world = make(world_desc());
        double density = info.fluid_density;
        if (water) {
            const lr_water_desc d = initialised(lr_water_desc_init);
            density = d.density;
            REQUIRE(lr_world_set_water(world.get(), &d) == LR_OK);
        } else {
            set_wind(world, 1.0f, 0.0f, 0.0f);
        }
        const lr_batch batch = add_batch(world, batch_desc(), asset, 8);
        Random random(3);
        std::vector<lr_body> bodies;
        for (int i = 0; i < 8; ++i) bodies.push_back(add_body(world, batch, turned_anyhow(random, {0.0, -1.0, 0.0})));
        steps(world, 120, 1.0f / 60.0f, 4); // they fall at their speed
        constexpr int count = 2400;
        Vec mean{};
        double wake = 0.0;
        for (int i = 0; i < count; ++i) {
            steps(world, 1, 1.0f / 240.0f);
            for (const lr_body body : bodies) {
                const lr_body_loads loads = loads_of(world, body);
                mean = mean + vec(loads.force);
                wake += length(vec(loads.wake));
            }
        }
        const double weight = 9.81 * (info.mass - density * info.volume);
        mean = 1.0 / (8.0 * count * weight) * mean;
        INFO(mean[0] << " " << mean[1] << " " << mean[2]);
        CHECK(mean[1] == doctest::Approx(1.0).epsilon(0.05));
        CHECK(std::hypot(mean[0], mean[2]) < 0.05);
        CHECK(wake > 0.0);
    }
}

TEST_CASE("loads on a body: none of LANGEVIN, no wake of sleepers") {
    const World world = make(world_desc());
    set_wind(world, 0.1f, 0.0f, 0.2f);
    const lr_body drawn = add_body(world, add_batch(world, langevin(), brick(), 1), body_desc());
    const lr_body_loads none = loads_of(world, drawn);
    CHECK(none.station_count == 0);
    CHECK(length(vec(none.force)) == 0.0);

    lr_collider_desc floor = initialised(lr_collider_desc_init);
    floor.kind = LR_COLLIDER_PLANE;
    floor.position[1] = -0.1f;
    REQUIRE(lr_collider_create(world.get(), &floor, 1, nullptr) == LR_OK);
    const lr_body lying = add_body(world, add_batch(world, exact(), leaf(), 1), body_desc());
    steps(world, 600, 1.0f / 60.0f, 2);
    REQUIRE(state_of(world, lying).sleep_state == LR_SLEEP_ASLEEP);
    const lr_body_loads still = loads_of(world, lying);
    CHECK(length(vec(still.stream) - Vec{0.1f, 0.0, 0.2f}) < 1e-6);
    CHECK(length(vec(still.wake)) == 0.0);
    CHECK(length(vec(still.force)) > 0.0);
}
