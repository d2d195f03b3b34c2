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
    data.stations = some_stations(stations, data.length_d, stations + 20);
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
    loads.light = loads.fluid_inertia_of(info);
    reference.stations = [&](Vec v, Vec w) { return loads(v, w); };

    Random random(4);
    std::vector<lr_body> ids;
    std::vector<ReferenceBody::State> expected;
    for (int i = 0; i < 16; ++i) {
        lr_body_desc d = turned_anyhow(random);
        d.scale = narrow(c.scale);
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

TEST_CASE("stations: RK4 converges at fourth order, the default at second order" * doctest::test_suite("long-exact")) {
    for (const Case& c : cases(true))
        for (int32_t integrator : {LR_INTEGRATOR_RK4, LR_INTEGRATOR_DEFAULT}) {
            std::vector<double> errors;
            for (int count = 4; count <= 256; count *= 2)
                errors.push_back(
                    std::sqrt(compare(c, integrator, 0.15 * std::min(1.0, c.scale), count, 1, true).mean_square));
            const Convergence found = convergence(errors);
            CAPTURE(std::string(c.name));
            CAPTURE(integrator);
            MESSAGE(std::string(c.name), ", integrator ", integrator, ": order ", found.order, " from ", found.coarse,
                    " to ", found.fine, " in ", 2 << (found.halvings + 1), " steps");
            CHECK(found.coarse < 0.05);
            CHECK(found.order > (integrator == LR_INTEGRATOR_RK4 ? 3.7 : 1.8));
        }
}

namespace {

lr_body_desc moving(Random& random, double speed, double spin) {
    lr_body_desc d = turned_anyhow(random);
    for (float& v : d.linear_velocity) v = random.real(-speed, speed);
    for (float& w : d.angular_velocity) w = random.real(-spin, spin);
    return d;
}

// The states of the same twenty bodies after some steps.
std::vector<lr_body_state> flights(const Asset& asset, int32_t integrator, int count = 100, float dt = 5e-3f) {
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, with(integrator), asset, 20);
    Random random(8);
    std::vector<lr_body> ids;
    for (int i = 0; i < 20; ++i) ids.push_back(add_body(world, batch, moving(random, 0.5, 3.0)));
    steps(world, count, dt);
    std::vector<lr_body_state> out;
    for (lr_body id : ids) out.push_back(state_of(world, id));
    return out;
}

double apart(const std::vector<lr_body_state>& a, const std::vector<lr_body_state>& b) {
    double most = 0.0;
    for (size_t i = 0; i < a.size(); ++i)
        most = std::max({most, length(vec(a[i].position) - vec(b[i].position)),
                         length(vec(a[i].linear_velocity) - vec(b[i].linear_velocity)),
                         0.1 * length(vec(a[i].angular_velocity) - vec(b[i].angular_velocity))});
    return most;
}

constexpr int32_t integrators[] = {LR_INTEGRATOR_DEFAULT, LR_INTEGRATOR_RK4};

} // namespace

TEST_CASE("stations: halves of a plate at one place are the plate") {
    lr::AssetData data = body(2, false, true);
    const std::vector<lr::StationData> wings = data.stations;
    const Asset whole = load(data);
    data.stations.clear();
    for (const lr::StationData& s : wings)
        for (const double share : {0.5, 0.25, 0.25}) data.stations.push_back(part_of(s, share));
    const Asset cut = load(data);
    data.stations[0].plate_drag *= 1.5;
    const Asset other = load(data);
    for (const int32_t integrator : integrators) {
        CAPTURE(integrator);
        const std::vector<lr_body_state> expected = flights(whole, integrator);
        CHECK(apart(expected, flights(cut, integrator)) < 5e-4);
        CHECK(apart(expected, flights(other, integrator)) > 1e-2);
    }
}

// Stations share these loads with a whole body: all but the sharpness of the stall, viscous drag along single axes, and lift of an
// edge. Spin drag in a stream follows another one.
TEST_CASE("stations: two halves at the centre of the loads are the body without stations") {
    lr::AssetData data = body(2, false, false);
    lr::AerodynamicData& a = data.aerodynamics;
    a.axes = turned_axes({0.06, 0.04, -0.2});
    a.lift = a.spin_drag_stream = {};
    a.spin_lift = {0.0, 0.0, a.spin_lift[2]}; // of stations it is that of the stream across the axis
    a.plate_stall = {1.0, 1.0, 1.0};
    a.plate_separated_shedding = 0.0;
    a.drag_layer = {0.002, 0.002, 0.002}, a.drag_stokes = {0.1, 0.1, 0.1};
    a.center = {0.002, -0.001, 0.0005};
    a.wake_length = a.wake_lag = 1.0; // a wake that is made
    a.wake_share = 0.0;
    lr::StationData s;
    s.axes = a.axes;
    for (size_t k = 0; k < 3; ++k) s.place[k] = data.center_of_buoyancy[k] + a.center[k];
#define LR_SAME(name) s.name = a.name;
    LR_SAME(drag)
    LR_SAME(drag_blunt)
    LR_SAME(drag_layer)
    LR_SAME(drag_stokes)
    LR_SAME(plate_lift)
    LR_SAME(plate_vortex)
    LR_SAME(plate_stall)
    LR_SAME(spin_lift)
    LR_SAME(spin_drag)
    LR_SAME(spin_drag_stokes)
#undef LR_SAME
    s.plate_drag = a.plate_drag;
    data.stations = {part_of(s, 0.5), part_of(s, 0.5)};
    // In slow rotation: the memory of stations fades where their ends outrun the fall.
    a.start_drag = 0.0;
    const Asset stations = load(data);
    data.stations.clear();
    const Asset one = load(data);
    for (const auto& [integrator, most] : {std::pair(LR_INTEGRATOR_RK4, 1e-4), std::pair(LR_INTEGRATOR_DEFAULT, 1e-2)})
        CHECK(apart(flights(one, integrator, 400, 5e-4f), flights(stations, integrator, 400, 5e-4f)) < most);
}

// Two plates at both ends of a rod, across the way that they move around its middle: I w' = -2 1/2 rho C r (w r)^2, so w = w0/(1 + c w0 t).
TEST_CASE("stations: ends far from the middle feel the spin") {
    const double r = 0.1, area = 1e-3, spin = 30.0;
    lr::shape::EllipsoidSpec spec;
    spec.semi_axes = {0.1, 0.004, 0.004}, spec.density = 100.0;
    lr::AssetData data = ellipsoid_data(spec);
    calm(data.aerodynamics);
    lr::StationData plate;
    plate.axes = turned_axes({0.0, 0.0, 0.0});
    plate.plate_stall = {0.2, 0.2, 0.2};
    plate.plate_drag = area, plate.place = {r, 0.0, 0.0};
    data.stations = {plate, plate};
    data.stations[1].place[0] = -r;
    const Asset asset = load(data);
    const lr_asset_info info = info_of(asset);
    const double c = info.fluid_density * area * r * r * r / (info.inertia[4] + info.added_mass[28]);
    for (const int32_t integrator : integrators)
        for (const double scale : {1.0, 0.3}) {
            const World world = weightless();
            const lr_batch batch = add_batch(world, with(integrator), asset, 1);
            lr_body_desc d = body_desc();
            d.scale = narrow(scale), d.angular_velocity[1] = narrow(spin);
            const lr_body body = add_body(world, batch, d);
            steps(world, 500, 2e-3f);
            const lr_body_state s = state_of(world, body);
            CAPTURE(integrator);
            CAPTURE(scale);
            CHECK(c * spin > 0.3); // much of the spin is lost
            CHECK(wide(s.angular_velocity[1]) == doctest::Approx(spin / (1.0 + c * spin)).epsilon(1e-4));
            CHECK(length(vec(s.linear_velocity)) < 1e-4);
        }
}

// As a rotor of tilted blades it would take energy from the fall: gutter-shaped petals spun like tops at 20 turns a second.
TEST_CASE("stations: a stream along the normal of a bent body does not drive its spin about the normal") {
    lr::shape::EllipsoidSpec spec;
    spec.semi_axes = {0.02, 0.02, 0.0005}, spec.density = 200.0;
    lr::AssetData data = ellipsoid_data(spec);
    calm(data.aerodynamics);
    for (const double side : {1.0, -1.0}) {
        lr::StationData s;
        s.axes = turned_axes({0.0, 0.17 * side, 0.0});
        s.plate_stall = {0.2, 0.2, 0.2};
        s.spin_lift = {1e-5, 1e-5, 0.0}, s.place = {0.015 * side, 0.0, 0.0};
        data.stations.push_back(s);
    }
    const Asset asset = load(data);
    for (const int32_t integrator : integrators)
        for (const float speed : {1.0f, -1.0f}) {
            const World world = weightless();
            lr_body_desc d = body_desc();
            d.linear_velocity[2] = speed, d.angular_velocity[2] = 30.0f;
            const lr_body body = add_body(world, add_batch(world, with(integrator), asset, 1), d);
            steps(world, 100, 2e-3f);
            const lr_body_state s = state_of(world, body);
            CAPTURE(integrator);
            CHECK(s.angular_velocity[2] == doctest::Approx(30.0).epsilon(1e-3));
            CHECK(s.linear_velocity[2] == doctest::Approx(wide(speed)).epsilon(1e-3));
        }
}

// The mirror image of a motion is the motion of the mirror image: about the plane y = 0, velocities change the sign of y, spins those of x and z.
TEST_CASE("stations: a body with two equal sides keeps its mirror symmetry") {
    lr::shape::EllipsoidSpec spec;
    spec.semi_axes = {0.03, 0.04, 0.001}, spec.density = 300.0;
    spec.center_of_mass = {0.005, 0.0, 0.0005};
    lr::AssetData data = ellipsoid_data(spec);
    calm(data.aerodynamics);
    for (lr::StationData s : some_stations(3, data.length_d, 3)) {
        s.place[1] = std::abs(s.place[1]) + 0.01;
        data.stations.push_back(s);
        s.place[1] = -s.place[1];
        s.hollow[1] = -s.hollow[1];
        for (const size_t i : {1u, 3u, 5u, 7u}) s.axes[i] = -s.axes[i]; // y of chord and normal; x and z of the span
        data.stations.push_back(s);
    }
    const Asset asset = load(data);
    for (const int32_t integrator : integrators) {
        lr_world_desc wd = world_desc();
        wd.gravity[0] = 1.0f, wd.gravity[1] = 0.0f, wd.gravity[2] = -9.0f;
        const World world = make(wd);
        const lr_batch batch = add_batch(world, with(integrator), asset, 40);
        Random random(17);
        std::vector<std::array<lr_body, 2>> pairs;
        for (int i = 0; i < 20; ++i) {
            lr_body_desc d = moving(random, 0.6, 4.0);
            const lr_body one = add_body(world, batch, d);
            for (float* x :
                 {d.orientation, d.orientation + 2, d.linear_velocity + 1, d.angular_velocity, d.angular_velocity + 2})
                *x = -*x;
            pairs.push_back({one, add_body(world, batch, d)});
        }
        steps(world, 60, 5e-3f);
        double apart = 0.0, sideways = 0.0;
        for (const auto& [one, other] : pairs) {
            const lr_body_state a = state_of(world, one), b = state_of(world, other);
            const Vec v = vec(a.linear_velocity), w = vec(a.angular_velocity);
            apart = std::max({apart, length(Vec{v[0], -v[1], v[2]} - vec(b.linear_velocity)),
                              0.1 * length(Vec{-w[0], w[1], -w[2]} - vec(b.angular_velocity))});
            sideways = std::max({sideways, std::abs(v[1]), 0.1 * std::abs(w[0])});
        }
        CAPTURE(integrator);
        CHECK(apart < 1e-3);
        CHECK(sideways > 0.1);
    }
}
