// Assets, worlds and bodies for tests, through the public API only.
#pragma once

#include "support/handles.h"
#include "support/random.h"

#include <algorithm>
#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

namespace test {

inline double wide(float x) {
    return static_cast<double>(x);
}
inline float narrow(double x) {
    return static_cast<float>(x);
}

struct ReleaseAsset {
    void operator()(lr_asset* a) const { lr_asset_release(a); }
};
struct DestroyWorld {
    void operator()(lr_world* w) const { lr_world_destroy(w); }
};
using Asset = std::unique_ptr<lr_asset, ReleaseAsset>;
using World = std::unique_ptr<lr_world, DestroyWorld>;

template <class T> T initialised(lr_status (*init)(T*, uint32_t)) {
    T desc;
    REQUIRE(init(&desc, sizeof(T)) == LR_OK);
    return desc;
}
inline lr_world_desc world_desc() {
    return initialised(lr_world_desc_init);
}
// Without variation, so that bodies obey the formulas they are compared with.
inline lr_batch_desc batch_desc() {
    lr_batch_desc d = LR_BATCH_DESC_INIT;
    d.variation = 0.0f;
    return d;
}
inline lr_batch_desc langevin() {
    lr_batch_desc d = batch_desc();
    d.load_model = LR_LOADS_LANGEVIN;
    return d;
}
inline lr_body_desc body_desc() {
    return initialised(lr_body_desc_init);
}
// At rest at `place`, m, with any orientation.
inline lr_body_desc turned_anyhow(Random& random, const std::array<double, 3>& place = {}) {
    lr_body_desc d = body_desc();
    for (size_t k = 0; k < 3; ++k) d.position[k] = narrow(place[k]);
    for (float& q : d.orientation) q = random.real(-1.0, 1.0);
    return d;
}
// In any orientation, anywhere in a cube about the origin; extent: m, half its edge.
inline lr_body_desc strewn(Random& random, double extent) {
    const auto along = [&] { return random.uniform(-extent, extent); };
    return turned_anyhow(random, {along(), along(), along()});
}
inline lr_body_state body_state() {
    return initialised(lr_body_state_init);
}
inline lr_turbulence_table table_desc() {
    return initialised(lr_turbulence_table_init);
}

// In air by default.
inline lr_ellipsoid_desc ellipsoid(double a, double b, double c, double density) {
    lr_ellipsoid_desc d = initialised(lr_ellipsoid_desc_init);
    d.semi_axes[0] = a, d.semi_axes[1] = b, d.semi_axes[2] = c;
    d.density = density;
    return d;
}
inline lr_ellipsoid_desc in_water(lr_ellipsoid_desc d) {
    d.fluid_density = 1000.0;
    d.fluid_viscosity = 1e-6;
    return d;
}
// A plate of 20 x 10 cm with round numbers.
inline lr_rigid_desc rigid_plate() {
    lr_rigid_desc d = initialised(lr_rigid_desc_init);
    d.mass = 0.01, d.volume = 2e-5;
    d.inertia[0] = 1e-5, d.inertia[4] = 4e-5, d.inertia[8] = 5e-5;
    d.added_mass[14] = 1e-3, d.added_mass[21] = 1e-7, d.added_mass[28] = 3e-7;
    d.extents[0] = 0.2, d.extents[1] = 0.1, d.extents[2] = 0.001;
    return d;
}
// With the added mass of a sphere of its volume, and some added inertia.
inline lr_rigid_desc rigid_box(double x, double y, double z, double density) {
    lr_rigid_desc d = initialised(lr_rigid_desc_init);
    d.volume = x * y * z;
    d.mass = density * d.volume;
    const double squares[3] = {x * x, y * y, z * z}, sum = squares[0] + squares[1] + squares[2];
    for (size_t k = 0; k < 3; ++k) {
        d.inertia[4 * k] = d.mass / 12.0 * (sum - squares[k]);
        d.added_mass[7 * k] = 0.5 * d.fluid_density * d.volume;
        d.added_mass[7 * (k + 3)] = 0.05 * d.fluid_density * d.inertia[4 * k] / density;
    }
    d.extents[0] = x, d.extents[1] = y, d.extents[2] = z;
    return d;
}
inline Asset make(const lr_rigid_desc& d) {
    lr_asset* asset = nullptr;
    REQUIRE(lr_asset_create_rigid(&d, &asset) == LR_OK);
    return Asset(asset);
}
inline Asset brick() {
    return make(rigid_box(0.06, 0.04, 0.03, 300.0));
}
inline Asset make(const lr_ellipsoid_desc& d) {
    lr_asset* asset = nullptr;
    REQUIRE(lr_asset_create_ellipsoid(&d, &asset) == LR_OK);
    return Asset(asset);
}
// The paper's leaf, and one with its weight off centre: a diagonal and a full 6x6 matrix.
inline Asset leaf() {
    return make(ellipsoid(0.04, 0.01, 0.00005, 800.0));
}
inline Asset curled_leaf() {
    lr_ellipsoid_desc d = ellipsoid(0.03, 0.02, 0.0005, 400.0);
    d.center_of_mass[0] = 0.004, d.center_of_mass[1] = -0.002, d.center_of_mass[2] = 0.0001;
    return make(d);
}

inline World make(const lr_world_desc& d) {
    lr_world* world = nullptr;
    REQUIRE(lr_world_create(&d, &world) == LR_OK);
    return World(world);
}
inline World weightless(uint64_t seed = 0) {
    lr_world_desc d = world_desc();
    d.seed = seed;
    d.gravity[1] = 0.0f;
    return make(d);
}

inline lr_asset_info info_of(const Asset& asset) {
    lr_asset_info info = initialised(lr_asset_info_init);
    REQUIRE(lr_asset_get_info(asset.get(), &info) == LR_OK);
    return info;
}

// full: makes a diagonal body take the path of full mass matrices, by loads slightly off the mirror plane along its widest face.
inline lr_batch add_batch(const World& w, lr_batch_desc d, const Asset& asset, uint32_t capacity, bool full = false) {
    d.asset = asset.get();
    d.capacity = capacity;
    lr_batch batch{};
    REQUIRE(lr_batch_create(w.get(), &d, &batch) == LR_OK);
    if (full) {
        lr_aerodynamics a = initialised(lr_aerodynamics_init);
        REQUIRE(lr_batch_get_aerodynamics(w.get(), batch, &a) == LR_OK);
        const auto* const widest = std::max_element(a.broadside, a.broadside + 3);
        a.center[*widest > 0.0 ? widest - a.broadside : 2] = 1e-5 * info_of(asset).length_d;
        REQUIRE(lr_batch_set_aerodynamics(w.get(), batch, &a) == LR_OK);
    }
    return batch;
}
inline lr_batch add_batch(const World& w, const Asset& asset, uint32_t capacity) {
    return add_batch(w, batch_desc(), asset, capacity);
}
inline lr_body add_body(const World& w, lr_batch batch, const lr_body_desc& d) {
    lr_body body{};
    REQUIRE(lr_body_create(w.get(), batch, &d, 1, &body) == LR_OK);
    return body;
}
inline lr_body_state state_of(const World& w, lr_body body) {
    lr_body_state s = body_state();
    REQUIRE(lr_body_get_state(w.get(), body, &s) == LR_OK);
    return s;
}
inline uint64_t hash_of(const World& w) {
    uint64_t hash = 0;
    REQUIRE(lr_world_hash(w.get(), &hash) == LR_OK);
    return hash;
}
inline lr_world_info info_of(const World& w) {
    lr_world_info info = initialised(lr_world_info_init);
    REQUIRE(lr_world_get_info(w.get(), &info) == LR_OK);
    return info;
}
inline lr_batch_view view_of(const World& w, lr_batch batch) {
    lr_batch_view view = initialised(lr_batch_view_init);
    REQUIRE(lr_batch_get_view(w.get(), batch, &view) == LR_OK);
    return view;
}
struct Velocity {
    float linear[3], angular[3]; // world frame
};
// In the order of the view.
inline std::vector<Velocity> velocities_of(const World& w, lr_batch batch) {
    std::vector<Velocity> all(view_of(w, batch).count);
    const auto count = static_cast<uint32_t>(all.size());
    REQUIRE(lr_batch_write_velocities(w.get(), batch, all.data(), sizeof(Velocity), count, nullptr) == LR_OK);
    return all;
}
// One check for the whole run, because doctest's checks cost about a microsecond.
inline void steps(const World& w, int count, float dt, uint32_t substeps = 1) {
    lr_status status = LR_OK;
    for (int i = 0; i < count && status == LR_OK; ++i) status = lr_world_step(w.get(), dt, substeps);
    REQUIRE(status == LR_OK);
}
inline void set_wind(const World& w, float x, float y, float z) {
    REQUIRE(lr_world_set_uniform_wind(w.get(), x, y, z) == LR_OK);
}
// The same turbulence at every age or, for the SPEED clock, of a body at speed u0.
inline void set_constant_table(const World& w, lr_batch batch, double chi, double epsilon, double c0, double u0 = 1.0,
                               double l = 0.01) {
    const float chis[1] = {narrow(chi)}, epsilons[1] = {narrow(epsilon)};
    lr_turbulence_table t = table_desc();
    t.count = 1;
    t.chi = chis;
    t.epsilon = epsilons;
    t.dt = 1.0f;
    t.u0 = narrow(u0);
    t.l = narrow(l);
    t.c0 = narrow(c0);
    REQUIRE(lr_batch_set_turbulence_table(w.get(), batch, &t) == LR_OK);
}
inline std::vector<unsigned char> snapshot_of(const World& w) {
    std::vector<unsigned char> bytes(static_cast<size_t>(lr_world_snapshot_size(w.get())));
    uint64_t written = 0;
    REQUIRE(lr_world_snapshot_save(w.get(), bytes.data(), bytes.size(), &written) == LR_OK);
    REQUIRE(written == bytes.size());
    return bytes;
}
inline std::vector<int32_t> simd_targets() {
    uint32_t count = 0;
    REQUIRE(lr_simd_targets(nullptr, 0, &count) == LR_OK);
    std::vector<int32_t> targets(count);
    REQUIRE(lr_simd_targets(targets.data(), count, &count) == LR_OK);
    REQUIRE(count == targets.size());
    return targets;
}
inline bool same_bits(const lr_body_state& a, const lr_body_state& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

} // namespace test
