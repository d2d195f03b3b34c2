// Bodies with stations: against an independent integration of their equations, closed forms, and symmetries.
#include "support/reference_body.h"
#include "support/station_bodies.h"

#include <string>

using namespace test;

namespace {

lr_batch_desc with(int32_t integrator) {
    lr_batch_desc d = batch_desc();
    d.load_model = LR_LOADS_AERODYNAMIC;
    d.integrator = integrator;
    d.noise_gain = 0.0f;
    return d;
}

struct Case {
    const char* name;
    lr::AssetData asset;
    double scale;
    Vec wind;
    double speed, spin; // sizes of the initial velocities, m/s and rad/s
};

// All coefficients. The wake's memory and its oscillator advance between substeps, which RK4's order does not survive: it is so long that it
// remains what it was at the start.
lr::AssetData body(size_t stations, bool water, bool camber) {
    lr::shape::EllipsoidSpec spec;
    spec.semi_axes = {0.04, 0.02, water ? 0.01 : 0.001};
    spec.density = water ? 1200.0 : 200.0;
    if (water) spec.fluid_density = 1000.0, spec.fluid_viscosity = 1e-6;
    spec.center_of_mass = {0.008, -0.003, 0.0004};
    lr::AssetData data = ellipsoid_data(spec);
    lr::AerodynamicData& a = data.aerodynamics;
    calm(a);
    a.wake_length = 1e4, a.wake_lag = 1e6;
    a.wake_share = 0.15, a.start_drag = 0.3;
    a.shedding_reynolds = water ? 5e8 : 1e8;
    data.stations = some_stations(stations, data.length_d, stations);
    for (lr::StationData& s : data.stations)
        if (!camber) s.camber = 0.0;
    return data;
}

std::vector<Case> cases(bool camber) {
    return {{"two in air", body(2, false, camber), 1.0, {}, 0.8, 4.0},
            {"five in water", body(5, true, camber), 1.0, {}, 0.3, 3.0},
            {"eight in wind, small", body(8, false, camber), 0.4, {0.3, -0.1, 0.2}, 0.5, 5.0},
            {"eight in water, large", body(8, true, camber), 2.5, {0.2, 0.1, 0.0}, 0.4, 1.5}};
}

struct Error {
    double worst, mean_square; // relative to the motion's size: position, angle, velocity, spin
};

// steady: streams that change no side, where the loads are smooth.
Error compare(const Case& c, int32_t integrator, double time, int count, uint32_t substeps, bool steady) {
    const Asset asset = load(c.asset);
    const lr_asset_info info = info_of(asset);
    lr_world_desc wd = world_desc();
    wd.gravity[0] = 2.0f, wd.gravity[1] = -9.0f, wd.gravity[2] = 1.0f;
    const World world = make(wd);
    const float wind[3] = {narrow(c.wind[0]), narrow(c.wind[1]), narrow(c.wind[2])};
    set_wind(world, wind[0], wind[1], wind[2]);
    const lr_batch batch = add_batch(world, with(integrator), asset, 16);

    ReferenceBody reference(info, c.scale);
    reference.gravity = vec(wd.gravity), reference.wind = vec(wind);
    ReferenceStations loads{c.asset.stations, c.asset.aerodynamics,  c.scale, info.fluid_density, info.fluid_viscosity,
                            info.length_d,    reference.buoyancy_arm};
    loads.arm = loads.arm + c.scale * c.asset.aerodynamics.center;
    reference.stations = [&](Vec v, Vec w) { return loads(v, w); };

    Random random(4);
    std::vector<lr_body> ids;
    std::vector<ReferenceBody::State> expected;
    for (int i = 0; i < 16; ++i) {
        lr_body_desc d = body_desc();
        d.scale = narrow(c.scale);
        for (float& q : d.orientation) q = random.real(-1.0, 1.0);
        Vec v{}, w{};
        for (double& x : v) x = random.uniform(-c.speed, c.speed);
        for (double& x : w) x = random.uniform(-c.spin, c.spin);
        if (steady) v = c.speed * Vec{3.0, 1.0, -2.5} + 0.1 * v, w = 0.05 * w;
        v = to_world(normalised(quat(d.orientation)), v) + reference.wind;
        for (size_t k = 0; k < 3; ++k) d.linear_velocity[k] = narrow(v[k]), d.angular_velocity[k] = narrow(w[k]);
        ids.push_back(add_body(world, batch, d));
        expected.push_back(reference.run(reference.begin(d), time, 2000));
    }
    steps(world, count, narrow(time / count), substeps);
    Error error{};
    for (size_t i = 0; i < ids.size(); ++i) {
        const lr_body_state s = state_of(world, ids[i]);
        const Vec v = reference.velocity(expected[i]), w = reference.spin(expected[i]);
        const Quat e = expected[i].q, apart = product(quat(s.orientation), {-e[0], -e[1], -e[2], e[3]});
        const double speed = c.speed + length(v), spin = c.spin + length(w);
        for (const double from :
             {length(vec(s.position) - expected[i].x) / (speed * time), 2.0 * length({apart[0], apart[1], apart[2]}),
              length(vec(s.linear_velocity) - v) / speed, length(vec(s.angular_velocity) - w) / spin}) {
            error.worst = std::max(error.worst, from);
            error.mean_square += from * from / 64.0;
        }
    }
    return error;
}

} // namespace

TEST_CASE("stations: the motion is that of the equations" * doctest::test_suite("exact")) {
    for (const Case& c : cases(true))
        for (int32_t integrator : {LR_INTEGRATOR_RK4, LR_INTEGRATOR_DEFAULT}) {
            const double error = compare(c, integrator, 0.5, 50, 20, false).worst;
            CAPTURE(std::string(c.name));
            CAPTURE(integrator);
            MESSAGE(std::string(c.name), ", integrator ", integrator, ": ", error);
            CHECK(error < (integrator == LR_INTEGRATOR_RK4 ? 1e-3 : 5e-2));
        }
}

TEST_CASE("stations: RK4 converges at fourth order, the default at second order" * doctest::test_suite("exact")) {
    for (const Case& c : cases(true))
        for (int32_t integrator : {LR_INTEGRATOR_RK4, LR_INTEGRATOR_DEFAULT}) {
            // As in test_equations.cpp: the order is that of the last halving well above rounding.
            std::vector<double> errors;
            for (int count = 4; count <= 256; count *= 2)
                errors.push_back(
                    std::sqrt(compare(c, integrator, 0.15 * std::min(1.0, c.scale), count, 1, true).mean_square));
            const double rounding = *std::min_element(errors.begin(), errors.end());
            size_t last = 1;
            while (last + 1 < errors.size() && errors[last + 1] > 5.0 * rounding) ++last;
            const double order = std::log2(errors[last - 1] / errors[last]);
            CAPTURE(std::string(c.name));
            CAPTURE(integrator);
            MESSAGE(std::string(c.name), ", integrator ", integrator, ": order ", order, " from ", errors[last - 1],
                    " to ", errors[last], " in ", 2 << (last + 1), " steps");
            CHECK(errors[last - 1] < 0.05);
            CHECK(order > (integrator == LR_INTEGRATOR_RK4 ? 3.7 : 1.8));
        }
}
