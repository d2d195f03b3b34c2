// NaN, infinities and values out of range in every field of every struct: each is refused with its status, and the world does
// not change.
#include "support/aerodynamic_fields.h"
#include "support/scene.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

using namespace test;

namespace {

struct Field {
    const char* name;
    size_t offset;
    enum Kind { f32, f64, i32, u32 } kind;
    std::vector<double> out_of_range; // finite
    std::vector<double> in_range;
};

void put(void* to, Field::Kind kind, double value) {
    const float f = static_cast<float>(value);
    switch (kind) {
    case Field::f32:
        std::memcpy(to, &f, 4);
        return;
    case Field::f64:
        std::memcpy(to, &value, 8);
        return;
    case Field::i32: {
        const auto i = static_cast<int32_t>(value);
        std::memcpy(to, &i, 4);
        return;
    }
    case Field::u32: {
        const auto u = static_cast<uint32_t>(value);
        std::memcpy(to, &u, 4);
        return;
    }
    }
}

template <class T>
void check_fields(const T& good, const std::vector<Field>& fields, const std::function<lr_status(const T*)>& use,
                  const std::function<uint64_t()>& hash) {
    T copy = good;
    REQUIRE(use(&copy) == LR_OK);
    const uint64_t before = hash();
    for (const Field& field : fields) {
        CAPTURE(field.name);
        const auto with = [&](double value) {
            copy = good;
            put(reinterpret_cast<unsigned char*>(&copy) + field.offset, field.kind, value);
            return use(&copy);
        };
        if (field.kind == Field::f32 || field.kind == Field::f64) {
            const double inf = std::numeric_limits<double>::infinity();
            for (double value : {std::numeric_limits<double>::quiet_NaN(), inf, -inf})
                CHECK(with(value) == LR_ERROR_NOT_FINITE);
        }
        for (double value : field.out_of_range) {
            CAPTURE(value);
            CHECK(with(value) == LR_ERROR_INVALID_ARGUMENT);
        }
        CHECK(hash() == before);
        for (double value : field.in_range) {
            CAPTURE(value);
            CHECK(with(value) == LR_OK);
        }
        copy = good;
        REQUIRE(use(&copy) == LR_OK);
        REQUIRE(hash() == before);
    }
}

std::vector<Field> array(const char* name, size_t offset, size_t count, std::vector<double> bad,
                         std::vector<double> good) {
    std::vector<Field> fields;
    for (size_t i = 0; i < count; ++i) fields.push_back({name, offset + 4 * i, Field::f32, bad, good});
    return fields;
}

std::vector<Field> operator+(std::vector<Field> a, const std::vector<Field>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

template <class T> std::vector<Field> pose_fields() {
    return array("position", offsetof(T, position), 3, {1.1e9, -1e30}, {1e9, -1e9}) +
           array("orientation", offsetof(T, orientation), 4, {1e30, -1e10}, {0.5, -3.0}) +
           array("linear_velocity", offsetof(T, linear_velocity), 3, {1.1e6, -1e20}, {1e6, -1e6}) +
           array("angular_velocity", offsetof(T, angular_velocity), 3, {1.1e6, -1e20}, {1e6, -1e6}) +
           std::vector<Field>{{"scale", offsetof(T, scale), Field::f32, {0.0, -1.0, 9.9e-4, 1001.0, 1e30}, {1e-3, 1e3}},
                              {"age", offsetof(T, age), Field::f32, {-1e-6, -1.0, 1e30}, {0.0, 1e6}}};
}

} // namespace

TEST_CASE("a body is not created from or set to impossible values") {
    const Asset asset = curled_leaf();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 4);
    const lr_body body = add_body(world, batch, body_desc());
    const auto hash = [&] { return hash_of(world); };

    lr_body_state good = body_state();
    good.position[0] = 2.0f;
    check_fields<lr_body_state>(
        good, pose_fields<lr_body_state>(),
        [&](const lr_body_state* s) { return lr_body_set_state(world.get(), body, s); }, hash);

    check_fields<lr_body_desc>(
        body_desc(),
        pose_fields<lr_body_desc>() +
            std::vector<Field>{{"reserved", offsetof(lr_body_desc, reserved), Field::u32, {1.0, 4294967295.0}, {0.0}}},
        [&](const lr_body_desc* d) {
            // After a valid one: neither is created.
            lr_body_desc pair[2] = {body_desc(), *d};
            lr_body ids[2] = {77, 77};
            const lr_status status = lr_body_create(world.get(), batch, pair, 2, ids);
            if (status == LR_OK)
                CHECK(lr_body_destroy(world.get(), ids, 2) == LR_OK);
            else
                CHECK((ids[0].id == 77 && ids[1].id == 77 && info_of(world).body_count == 1));
            return status;
        },
        hash);

    lr_body_state zero = good;
    for (float& q : zero.orientation) q = 0.0f;
    CHECK(lr_body_set_state(world.get(), body, &zero) == LR_ERROR_INVALID_ARGUMENT);
    zero.orientation[2] = 1e-30f; // its square underflows
    CHECK(lr_body_set_state(world.get(), body, &zero) == LR_ERROR_INVALID_ARGUMENT);
    steps(world, 3, 0.01f, 4);
}

TEST_CASE("an ellipsoid must be one") {
    std::vector<Field> fields;
    for (size_t i = 0; i < 3; ++i) {
        fields.push_back({"semi_axes",
                          offsetof(lr_ellipsoid_desc, semi_axes) + 8 * i,
                          Field::f64,
                          {0.0, -0.1, 0.9e-6, 1001.0, 1e300},
                          {0.05, 0.2}});
        fields.push_back({"center_of_mass",
                          offsetof(lr_ellipsoid_desc, center_of_mass) + 8 * i,
                          Field::f64,
                          {0.1, -0.2, 1e300},
                          {0.05, -0.099}});
    }
    fields.push_back({"density", offsetof(lr_ellipsoid_desc, density), Field::f64, {0.0, -1.0, 1e300}, {1.0, 2e4}});
    fields.push_back(
        {"fluid_density", offsetof(lr_ellipsoid_desc, fluid_density), Field::f64, {0.0, -1.0, 1e300}, {1.0}});
    fields.push_back(
        {"fluid_viscosity", offsetof(lr_ellipsoid_desc, fluid_viscosity), Field::f64, {0.0, -1.0, 1e300}, {1e-6}});
    fields.push_back({"intensity", offsetof(lr_ellipsoid_desc, intensity), Field::f64, {-0.1, 10.1}, {0.0, 10.0}});
    fields.push_back({"reserved", offsetof(lr_ellipsoid_desc, reserved), Field::u32, {1.0}, {0.0}});
    check_fields<lr_ellipsoid_desc>(
        ellipsoid(0.1, 0.1, 0.1, 500.0), fields,
        [](const lr_ellipsoid_desc* d) {
            lr_asset* asset = nullptr;
            const lr_status status = lr_asset_create_ellipsoid(d, &asset);
            CHECK((asset != nullptr) == (status == LR_OK));
            lr_asset_release(asset);
            return status;
        },
        [] { return uint64_t{0}; });
}

TEST_CASE("a rigid body is not made from impossible numbers") {
    std::vector<Field> fields;
    for (size_t i = 0; i < 3; ++i) {
        fields.push_back({"center_of_buoyancy",
                          offsetof(lr_rigid_desc, center_of_buoyancy) + 8 * i,
                          Field::f64,
                          {1.0, -1.0},
                          {0.001, -0.001}});
        fields.push_back({"extents", offsetof(lr_rigid_desc, extents) + 8 * i, Field::f64, {0.0, -1.0, 1e300}, {0.1}});
        fields.push_back({"inertia", offsetof(lr_rigid_desc, inertia) + 32 * i, Field::f64, {0.0, -1e-5, 1e3}, {2e-5}});
    }
    fields.push_back({"inertia, one side", offsetof(lr_rigid_desc, inertia) + 8, Field::f64, {1e-6}, {0.0}});
    for (size_t i = 0; i < 6; ++i)
        fields.push_back(
            {"added mass", offsetof(lr_rigid_desc, added_mass) + 56 * i, Field::f64, {-1.0, 1e6}, {0.0, 1e-7}});
    fields.push_back({"added mass, one side", offsetof(lr_rigid_desc, added_mass) + 8, Field::f64, {1e-4}, {0.0}});
    fields.push_back({"mass", offsetof(lr_rigid_desc, mass), Field::f64, {0.0, -1.0, 1e300}, {0.02}});
    fields.push_back({"volume", offsetof(lr_rigid_desc, volume), Field::f64, {0.0, -1.0, 1e300}, {1e-5}});
    fields.push_back({"fluid_density", offsetof(lr_rigid_desc, fluid_density), Field::f64, {0.0, -1.0, 1e300}, {1.0}});
    fields.push_back(
        {"fluid_viscosity", offsetof(lr_rigid_desc, fluid_viscosity), Field::f64, {0.0, -1.0, 1e300}, {1e-6}});
    fields.push_back({"intensity", offsetof(lr_rigid_desc, intensity), Field::f64, {-0.1, 10.1}, {0.0, 10.0}});
    fields.push_back({"reserved", offsetof(lr_rigid_desc, reserved), Field::u32, {1.0}, {0.0}});
    const auto create = [](const lr_rigid_desc* d) {
        lr_asset* asset = nullptr;
        const lr_status status = lr_asset_create_rigid(d, &asset);
        CHECK((asset != nullptr) == (status == LR_OK));
        lr_asset_release(asset);
        return status;
    };
    check_fields<lr_rigid_desc>(rigid_plate(), fields, create, [] { return uint64_t{0}; });
    // Its loads are checked like a batch's.
    lr_aerodynamics a = initialised(lr_aerodynamics_init);
    lr_rigid_desc d = rigid_plate();
    d.aerodynamics = &a;
    CHECK(create(&d) == LR_OK);
    a.drag[0] = -1.0;
    CHECK(create(&d) == LR_ERROR_INVALID_ARGUMENT);
    a.drag[0] = std::numeric_limits<double>::quiet_NaN();
    CHECK(create(&d) == LR_ERROR_NOT_FINITE);
}

TEST_CASE("a world is not created from impossible values") {
    std::vector<Field> fields = array("gravity", offsetof(lr_world_desc, gravity), 3, {1e5, -1e30}, {0.0, 1e4, -1e4});
    fields.push_back(
        {"fluid_density", offsetof(lr_world_desc, fluid_density), Field::f32, {-1.0, 1e30}, {0.0, 1000.0}});
    fields.push_back(
        {"worker_count", offsetof(lr_world_desc, worker_count), Field::u32, {65.0, 4294967295.0}, {0.0, 1.0}});
    fields.push_back({"simd_target", offsetof(lr_world_desc, simd_target), Field::i32, {-1.0, 8.0, 1e9}, {0.0, 1.0}});
    fields.push_back(
        {"fluid_viscosity", offsetof(lr_world_desc, fluid_viscosity), Field::f32, {-1.0, 1e30}, {0.0, 1e-6}});
    check_fields<lr_world_desc>(
        world_desc(), fields,
        [](const lr_world_desc* d) {
            lr_world* world = nullptr;
            const lr_status status = lr_world_create(d, &world);
            CHECK((world != nullptr) == (status == LR_OK));
            lr_world_destroy(world);
            return status;
        },
        [] { return uint64_t{0}; });
    // One allocator function without the other.
    lr_world_desc d = world_desc();
    lr_world* world = nullptr;
    d.allocator.release = [](void*, void*, uint64_t, uint64_t) {};
    CHECK(lr_world_create(&d, &world) == LR_ERROR_INVALID_ARGUMENT);
    d.allocator.release = nullptr;
    d.allocator.allocate = [](void*, uint64_t, uint64_t) -> void* { return nullptr; };
    CHECK(lr_world_create(&d, &world) == LR_ERROR_INVALID_ARGUMENT);
}

TEST_CASE("gravity, wind, batches and tables refuse impossible values and leave the world as it was") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    lr_world* const w = world.get();
    const lr_batch batch = add_batch(world, asset, 4);
    add_body(world, batch, body_desc());
    const std::vector<unsigned char> before = snapshot_of(world);
    const auto unchanged = [&] { return static_cast<uint64_t>(snapshot_of(world) == before); };

    const float bad[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()};
    for (size_t i = 0; i < 3; ++i) {
        for (float value : bad) {
            float g[3] = {0.0f, -9.81f, 0.0f};
            g[i] = value;
            CHECK(lr_world_set_gravity(w, g) == LR_ERROR_NOT_FINITE);
        }
        float g[3] = {0.0f, -9.81f, 0.0f};
        g[i] = 1e9f;
        CHECK(lr_world_set_gravity(w, g) == LR_ERROR_INVALID_ARGUMENT);
    }
    CHECK(unchanged() == 1);

    for (size_t i = 0; i < 3; ++i) {
        float v[3] = {};
        for (float value : bad) {
            v[i] = value;
            CHECK(lr_world_set_uniform_wind(w, v[0], v[1], v[2]) == LR_ERROR_NOT_FINITE);
        }
        for (float value : {1000.1f, -1e9f}) {
            v[i] = value;
            CHECK(lr_world_set_uniform_wind(w, v[0], v[1], v[2]) == LR_ERROR_INVALID_ARGUMENT);
        }
    }
    CHECK(unchanged() == 1);
    float uniform[3] = {9.0f, 9.0f, 9.0f};
    CHECK(lr_world_get_uniform_wind(w, uniform) == LR_OK);
    CHECK((uniform[0] == 0.0f && uniform[1] == 0.0f && uniform[2] == 0.0f));

    std::vector<Field> fields = array("position", offsetof(lr_water_desc, position), 3, {1.1e9, -1e12}, {});
    for (const Field& f : array("current", offsetof(lr_water_desc, current), 3, {1000.1, -1e9}, {}))
        fields.push_back(f);
    fields.push_back({"wave_count", offsetof(lr_water_desc, wave_count), Field::u32, {1.0, 9.0, 4294967295.0}, {}});
    fields.push_back({"density", offsetof(lr_water_desc, density), Field::f32, {0.0, -1.0, 1.1e6}, {}});
    fields.push_back({"viscosity", offsetof(lr_water_desc, viscosity), Field::f32, {0.0, -1.0, 1001.0}, {}});
    fields.push_back({"reach", offsetof(lr_water_desc, reach), Field::f32, {-0.1, 1.1e6}, {}});
    fields.push_back({"normal y", offsetof(lr_water_desc, normal) + 4, Field::f32, {0.0}, {}});
    check_fields<lr_water_desc>(
        initialised(lr_water_desc_init), fields, [&](const lr_water_desc* d) { return lr_world_set_water(w, d); },
        unchanged);
    lr_water_desc waves = initialised(lr_water_desc_init);
    waves.wave_count = LR_MAX_WAVES;
    for (lr_wave& wave : waves.waves) wave = {{1.0f, 0.0f, 0.0f}, 7.0f, 0.9f, 0.0f};
    const size_t last = offsetof(lr_water_desc, waves) + (LR_MAX_WAVES - 1) * sizeof(lr_wave);
    fields = {{"length", last + offsetof(lr_wave, length), Field::f32, {0.0, 6.0, 1.1e6}, {}},
              {"amplitude", last + offsetof(lr_wave, amplitude), Field::f32, {-0.1, 1.1}, {}},
              {"phase", last + offsetof(lr_wave, phase), Field::f32, {1.1e6, -1e9}, {}},
              {"direction", last + offsetof(lr_wave, direction), Field::f32, {0.0}, {}}};
    check_fields<lr_water_desc>(
        waves, fields, [&](const lr_water_desc* d) { return lr_world_set_water(w, d); }, unchanged);
    CHECK(lr_world_set_water(w, &waves) == LR_OK);
    CHECK(unchanged() == 0);
    CHECK(lr_world_set_water(w, nullptr) == LR_OK);
    CHECK(unchanged() == 1);

    fields = {{"capacity", offsetof(lr_batch_desc, capacity), Field::u32, {0.0, 67108865.0, 4294967295.0}, {1.0, 17.0}},
              {"load_model", offsetof(lr_batch_desc, load_model), Field::i32, {-1.0, 4.0, 99.0}, {0.0, 1.0, 2.0, 3.0}},
              {"clock", offsetof(lr_batch_desc, clock), Field::i32, {-1.0, 99.0}, {0.0, 1.0}},
              {"table_end", offsetof(lr_batch_desc, table_end), Field::i32, {-1.0, 99.0}, {0.0, 1.0}},
              {"integrator", offsetof(lr_batch_desc, integrator), Field::i32, {-1.0, 99.0}, {0.0, 1.0}},
              {"damping_gain", offsetof(lr_batch_desc, damping_gain), Field::f32, {-0.1, 100.1}, {0.0, 100.0}},
              {"noise_gain", offsetof(lr_batch_desc, noise_gain), Field::f32, {-0.1, 100.1}, {0.0, 100.0}}};
    lr_batch_desc good = batch_desc();
    good.asset = asset.get();
    good.capacity = 1;
    const World other = make(world_desc());
    check_fields<lr_batch_desc>(
        good, fields,
        [&](const lr_batch_desc* d) {
            lr_batch out{99};
            const lr_status status = lr_batch_create(other.get(), d, &out);
            CHECK((out.id != 0) == (status == LR_OK));
            if (out.id) CHECK(lr_batch_destroy(other.get(), out) == LR_OK);
            return status;
        },
        [&] { return static_cast<uint64_t>(info_of(other).batch_count); });

    const float samples[3] = {1.0f, 2.0f, 3.0f};
    lr_turbulence_table t = table_desc();
    t.count = 3;
    t.chi = t.epsilon = samples;
    t.dt = t.u0 = t.l = 1.0f;
    REQUIRE(lr_batch_set_turbulence_table(w, batch, &t) == LR_OK);
    const std::vector<unsigned char> with_table = snapshot_of(world);
    CHECK(with_table != before);
    fields = {{"count", offsetof(lr_turbulence_table, count), Field::u32, {0.0, 65537.0, 4294967295.0}, {}},
              {"dt", offsetof(lr_turbulence_table, dt), Field::f32, {0.0, -1.0}, {0.5}},
              {"u0", offsetof(lr_turbulence_table, u0), Field::f32, {0.0, -1.0}, {0.5}},
              {"l", offsetof(lr_turbulence_table, l), Field::f32, {0.0, -1.0}, {0.5}},
              {"c0", offsetof(lr_turbulence_table, c0), Field::f32, {-1.0, 0.0}, {0.5}},
              {"stationary", offsetof(lr_turbulence_table, stationary), Field::u32, {3.0, 4294967295.0}, {0.0, 2.0}},
              {"reserved", offsetof(lr_turbulence_table, reserved), Field::u32, {1.0}, {0.0}}};
    check_fields<lr_turbulence_table>(
        t, fields, [&](const lr_turbulence_table* d) { return lr_batch_set_turbulence_table(w, batch, d); },
        [&] { return static_cast<uint64_t>(snapshot_of(world) == with_table); });
    for (size_t i = 0; i < 3; ++i)
        for (float value : {bad[0], bad[1], -1.0f}) {
            float changed[3] = {1.0f, 2.0f, 3.0f};
            changed[i] = value;
            const lr_status expected = std::isfinite(value) ? LR_ERROR_INVALID_ARGUMENT : LR_ERROR_NOT_FINITE;
            lr_turbulence_table wrong = t;
            wrong.chi = changed;
            CHECK(lr_batch_set_turbulence_table(w, batch, &wrong) == expected);
            wrong = t;
            wrong.epsilon = changed;
            CHECK(lr_batch_set_turbulence_table(w, batch, &wrong) == expected);
        }
    CHECK(snapshot_of(world) == with_table);
    REQUIRE(lr_batch_set_turbulence_table(w, batch, nullptr) == LR_OK);
    CHECK(snapshot_of(world) == before); // the asset's own table is restored, bit for bit

    lr_load_gains g = initialised(lr_load_gains_init);
    fields.clear();
    for (size_t i = 0; i < 4; ++i)
        fields.push_back({"gain", offsetof(lr_load_gains, drag) + 4 * i, Field::f32, {-0.1, 100.1}, {0.0, 100.0}});
    fields.push_back({"reserved", offsetof(lr_load_gains, reserved), Field::u32, {1.0}, {0.0}});
    check_fields<lr_load_gains>(
        g, fields, [&](const lr_load_gains* d) { return lr_batch_set_load_gains(w, batch, d); },
        [] { return uint64_t{0}; });
    g.lift = 2.0f;
    REQUIRE(lr_batch_set_load_gains(w, batch, &g) == LR_OK);
    CHECK(snapshot_of(world) != before);
    REQUIRE(lr_batch_set_load_gains(w, batch, nullptr) == LR_OK);
    CHECK(snapshot_of(world) == before);

    lr_aerodynamics a = initialised(lr_aerodynamics_init);
    REQUIRE(lr_batch_get_aerodynamics(w, batch, &a) == LR_OK);
    fields.clear();
    for (const AerodynamicField& f : aerodynamic_fields) {
        // A body's own size limits its centre.
        const double reach = f.offset == offsetof(lr_aerodynamics, center) ? 1e-3 : 1.0;
        for (size_t i = 0; i < f.size; ++i)
            fields.push_back({f.name,
                              f.offset + 8 * i,
                              Field::f64,
                              {f.least - 0.1 * std::abs(f.least) - 1e-9, 1.1 * f.most},
                              {std::max(f.least, -reach), std::min(f.most, reach)}});
    }
    for (size_t i = 0; i < 9; ++i) // still unit vectors, but not orthogonal ones
        fields.push_back({"axes", offsetof(lr_aerodynamics, axes) + 8 * i, Field::f64, {0.5, -1.0}, {}});
    fields.push_back({"reserved", offsetof(lr_aerodynamics, reserved), Field::u32, {1.0}, {0.0}});
    check_fields<lr_aerodynamics>(
        a, fields, [&](const lr_aerodynamics* d) { return lr_batch_set_aerodynamics(w, batch, d); },
        [] { return uint64_t{0}; });
    for (const AerodynamicField& f : aerodynamic_fields) {
        lr_aerodynamics wrong = a;
        const double high = 1.1 * f.most;
        std::memcpy(reinterpret_cast<char*>(&wrong) + f.offset + 8 * (f.size - 1), &high, sizeof high);
        CHECK(lr_batch_set_aerodynamics(w, batch, &wrong) == LR_ERROR_INVALID_ARGUMENT);
        CAPTURE(std::string(lr_last_error()));
        CHECK(std::strstr(lr_last_error(), (std::string(f.name) + " is").c_str()) != nullptr);
    }
    a.drag[1] *= 2.0;
    REQUIRE(lr_batch_set_aerodynamics(w, batch, &a) == LR_OK);
    lr_aerodynamics now = initialised(lr_aerodynamics_init);
    REQUIRE(lr_batch_get_aerodynamics(w, batch, &now) == LR_OK);
    CHECK(std::memcmp(&now, &a, sizeof now) == 0);
    CHECK(snapshot_of(world) != before);
    REQUIRE(lr_batch_set_aerodynamics(w, batch, nullptr) == LR_OK);
    CHECK(snapshot_of(world) == before);
    steps(world, 3, 0.01f, 4);
}
