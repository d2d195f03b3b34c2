// struct_size of every struct: 0, too small, exact, larger with a zero tail, larger with a tail, absurd.
// That each struct and each function that takes one is here: tests/abi/test_check.py.
#include "support/colliders.h"
#include "support/scene.h"

#include <algorithm>
#include <functional>

using namespace test;

namespace {

// The struct at the front of a buffer of zeros, which a newer and larger one would fill.
template <class T> struct Grown {
    explicit Grown(const T& from) { std::memcpy(static_cast<void*>(&value), &from, sizeof(T)); }
    T value;
    unsigned char tail[64] = {};
};

// What callers give who were built with this header, or with a newer one whose structs are larger.
template <class T> std::vector<uint32_t> good_sizes() {
    constexpr auto size = static_cast<uint32_t>(sizeof(T));
    return {size, size + 4, size + 64};
}

// A caller's struct of some size, at the end of what is the caller's: bytes behind it are somebody else's.
class Caller {
public:
    template <class T>
    Caller(const T& from, uint32_t size, unsigned char tail = 0) : words_(size / 8 + 16), size_(size) {
        std::memset(words_.data(), canary, words_.size() * 8);
        std::memset(words_.data(), tail, size);
        std::memcpy(words_.data(), static_cast<const void*>(&from), std::min<size_t>(size, sizeof(T)));
        std::memcpy(words_.data(), &size, sizeof size);
        before_ = words_;
    }
    template <class T> T* as() { return reinterpret_cast<T*>(words_.data()); }
    unsigned char& byte(size_t i) { return bytes()[i]; }
    void remember() { before_ = words_; }
    bool unchanged() const { return words_ == before_; }
    bool says_its_size() { return std::memcmp(bytes(), &size_, sizeof size_) == 0; }
    bool nothing_behind_is_written() {
        return std::all_of(bytes() + size_, bytes() + words_.size() * 8, [](unsigned char b) { return b == canary; });
    }
    bool zero_from(size_t first) {
        return std::all_of(bytes() + first, bytes() + size_, [](unsigned char b) { return b == 0; });
    }

private:
    static constexpr unsigned char canary = 0x5a;
    unsigned char* bytes() { return reinterpret_cast<unsigned char*>(words_.data()); }
    std::vector<uint64_t> words_, before_;
    uint32_t size_;
};

// No caller has these.
template <class T> std::vector<uint32_t> bad_sizes() {
    std::vector<uint32_t> sizes = {65537, 0x7fffffff, 0xffffffff};
    for (uint32_t size = 0; size < sizeof(T); ++size) sizes.push_back(size);
    return sizes;
}

template <class T> void check_init(lr_status (*init)(T*, uint32_t)) {
    CHECK(init(nullptr, sizeof(T)) == LR_ERROR_NULL_ARGUMENT);
    T garbage;
    std::memset(static_cast<void*>(&garbage), 0x5a, sizeof garbage);
    for (uint32_t size : bad_sizes<T>()) {
        CAPTURE(size);
        Caller caller(garbage, sizeof(T));
        CHECK(init(caller.as<T>(), size) == LR_ERROR_STRUCT_SIZE);
        CHECK(caller.unchanged());
    }
    // The part that this library does not know becomes zero.
    for (uint32_t size : good_sizes<T>()) {
        CAPTURE(size);
        Caller caller(garbage, size, 0x5a);
        CHECK(init(caller.as<T>(), size) == LR_OK);
        CHECK(caller.says_its_size());
        CHECK(caller.nothing_behind_is_written());
        if (size > sizeof(T)) CHECK(caller.zero_from(sizeof(T)));
    }
}

// `use` passes the struct to a function that reads its struct_size.
template <class T> void check_use(const T& good, const std::function<lr_status(T*)>& use) {
    for (uint32_t size : bad_sizes<T>()) {
        // On the heap and no larger than it is: a read past its end is a fault under AddressSanitizer.
        const auto bad = std::make_unique<T>(good);
        bad->struct_size = size;
        const T before = *bad;
        CAPTURE(size);
        CHECK(use(bad.get()) == LR_ERROR_STRUCT_SIZE);
        CHECK(std::memcmp(bad.get(), &before, sizeof before) == 0);
    }
    for (uint32_t size : good_sizes<T>()) {
        CAPTURE(size);
        Caller caller(good, size);
        CHECK(use(caller.as<T>()) == LR_OK);
        CHECK(caller.says_its_size());
        CHECK(caller.nothing_behind_is_written());
        if (size > sizeof(T)) CHECK(caller.zero_from(sizeof(T)));
    }
    for (size_t at : {sizeof(T), sizeof(T) + 1, sizeof(T) + 63}) {
        Caller caller(good, sizeof(T) + 64);
        caller.byte(at) = 1;
        caller.remember();
        CAPTURE(at);
        CHECK(use(caller.as<T>()) == LR_ERROR_STRUCT_SIZE);
        CHECK(caller.unchanged());
    }
}

} // namespace

TEST_CASE("every init function takes exact and larger sizes, refuses others, and writes no further") {
    check_init<lr_ellipsoid_desc>(lr_ellipsoid_desc_init);
    check_init<lr_rigid_desc>(lr_rigid_desc_init);
    check_init<lr_asset_info>(lr_asset_info_init);
    check_init<lr_aerodynamics>(lr_aerodynamics_init);
    check_init<lr_world_desc>(lr_world_desc_init);
    check_init<lr_world_info>(lr_world_info_init);
    check_init<lr_wind_desc>(lr_wind_desc_init);
    check_init<lr_wind_source_desc>(lr_wind_source_desc_init);
    check_init<lr_surface_desc>(lr_surface_desc_init);
    check_init<lr_batch_desc>(lr_batch_desc_init);
    check_init<lr_turbulence_table>(lr_turbulence_table_init);
    check_init<lr_load_gains>(lr_load_gains_init);
    check_init<lr_batch_view>(lr_batch_view_init);
    check_init<lr_body_desc>(lr_body_desc_init);
    check_init<lr_body_state>(lr_body_state_init);
    check_init<lr_body_force>(lr_body_force_init);
    check_init<lr_force_arrays>(lr_force_arrays_init);
    check_init<lr_batch_force>(lr_batch_force_init);
    check_init<lr_batch_rules>(lr_batch_rules_init);
    check_init<lr_emitter_desc>(lr_emitter_desc_init);
    check_init<lr_batch_events>(lr_batch_events_init);
    check_init<lr_batch_pace>(lr_batch_pace_init);
    check_init<lr_step_report>(lr_step_report_init);
    check_init<lr_contact_event_list>(lr_contact_event_list_init);
    check_init<lr_ray>(lr_ray_init);
    check_init<lr_overlap_desc>(lr_overlap_desc_init);
    check_init<lr_collider_desc>(lr_collider_desc_init);
    check_init<lr_collider_motion>(lr_collider_motion_init);
    check_init<lr_collider_state>(lr_collider_state_init);
    check_init<lr_collider_surface>(lr_collider_surface_init);
    check_init<lr_batch_contact>(lr_batch_contact_init);
    check_init<lr_recording_desc>(lr_recording_desc_init);
}

TEST_CASE("initial values are those of the header") {
    const lr_world_desc w = world_desc();
    CHECK((w.gravity[0] == 0.0f && w.gravity[1] == -9.81f && w.gravity[2] == 0.0f));
    CHECK((w.worker_count == 0 && w.seed == 0 && w.fluid_density == 0.0f && w.simd_target == LR_SIMD_AUTO));
    CHECK((!w.allocator.allocate && !w.allocator.release && !w.log && !w.jobs.enqueue && !w.jobs.finish));
    const lr_batch_desc b = batch_desc();
    CHECK((b.load_model == LR_LOADS_DEFAULT && b.clock == LR_CLOCK_SPEED && b.table_end == LR_TABLE_CLAMP &&
           b.integrator == LR_INTEGRATOR_DEFAULT));
    CHECK((b.damping_gain == 1.0f && b.noise_gain == 1.0f && b.asset == nullptr));
    const lr_body_desc o = body_desc();
    CHECK((o.orientation[0] == 0.0f && o.orientation[3] == 1.0f && o.scale == 1.0f && o.age == 0.0f && o.key == 0));
    CHECK(wind_desc().kind == LR_WIND_UNIFORM);
    const lr_ray ray = initialised(lr_ray_init);
    CHECK((ray.flags == (LR_RAY_BODIES | LR_RAY_COLLIDERS) && ray.direction[1] == -1.0f && ray.max_distance == 1e9f));
    CHECK((ray.collider_layers == 0xffffffffu && ray.batch == 0 && ray.origin[0] == 0.0f));
    const lr_overlap_desc overlap = initialised(lr_overlap_desc_init);
    CHECK((overlap.shape == LR_OVERLAP_SPHERE && overlap.orientation[3] == 1.0f && overlap.size[2] == 1.0f));
    CHECK(table_desc().c0 == 6.5f);
    const lr_aerodynamics a = initialised(lr_aerodynamics_init);
    for (size_t i = 0; i < 9; ++i) CHECK(a.axes[i] == (i % 4 == 0 ? 1.0 : 0.0));
    CHECK((a.drag[0] == 0.0 && a.spin_drag_stokes[2] == 0.0 && a.intensity == 0.0 && a.length == 1.0));
    const lr_load_gains g = initialised(lr_load_gains_init);
    CHECK((g.drag == 1.0f && g.lift == 1.0f && g.spin_drag == 1.0f && g.turbulence == 1.0f));
    const lr_wind_source_desc s = initialised(lr_wind_source_desc_init);
    CHECK((s.kind == 0 && s.direction[0] == 1.0f && s.side[2] == 1.0f && s.speed == 1.0f && s.circulation == 1.0f));
    CHECK((s.size == 1.0f && s.radius == 0.0f && s.range == 10.0f && s.spread == 0.1f && s.period == 0.0f));
    CHECK((s.reference_height == 10.0f && s.octaves == 2 && s.frames == 1 && s.spacing[1] == 1.0f && !s.samples));
    const lr_ellipsoid_desc e = initialised(lr_ellipsoid_desc_init);
    const lr_emitter_desc m = initialised(lr_emitter_desc_init);
    CHECK((m.orientation[3] == 1.0f && m.body_orientation[3] == 1.0f && m.direction[1] == -1.0f && m.rate == 0.0f));
    CHECK((m.scale_min == 1.0f && m.scale_max == 1.0f && m.shape == LR_EMIT_POINT && m.pose == LR_POSE_RANDOM));
    const lr_batch_rules r = initialised(lr_batch_rules_init);
    CHECK((r.action == LR_END_DESTROY && r.max_age == 0.0f && r.volume_count == 0));
    const lr_body_force f = initialised(lr_body_force_init);
    CHECK((f.mode == LR_FORCE_MODE_FORCE && f.frame == LR_FRAME_WORLD && f.flags == 0));
    const lr_collider_desc c = initialised(lr_collider_desc_init);
    CHECK((c.kind == 0 && c.orientation[3] == 1.0f && c.size[0] == 0.0f && c.friction == 0.5f));
    CHECK((c.restitution == 0.2f && c.layers == 1 && c.flags == 0 && c.spacing[1] == 1.0f && !c.vertices));
    const lr_collider_motion v = initialised(lr_collider_motion_init);
    CHECK((v.mode == LR_MOVE_TO && v.collider == 0 && v.orientation[3] == 1.0f && v.linear_velocity[0] == 0.0f));
    const lr_collider_surface u = initialised(lr_collider_surface_init);
    CHECK((u.layers == 1 && u.friction == 0.5f && u.restitution == 0.2f));
    CHECK((e.fluid_density == 1.2 && e.fluid_viscosity == 1.5e-5 && e.intensity == 1.0));
}

TEST_CASE("every function checks struct_size and the tail of a larger struct") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 64);
    const lr_body body = add_body(world, batch, body_desc());
    lr_world* const w = world.get();

    check_use<lr_ellipsoid_desc>(ellipsoid(0.1, 0.1, 0.1, 500.0), [](lr_ellipsoid_desc* d) {
        lr_asset* out = nullptr;
        const lr_status status = lr_asset_create_ellipsoid(d, &out);
        CHECK((out != nullptr) == (status == LR_OK));
        lr_asset_release(out);
        return status;
    });
    check_use<lr_rigid_desc>(rigid_plate(), [](lr_rigid_desc* d) {
        lr_asset* out = nullptr;
        const lr_status status = lr_asset_create_rigid(d, &out);
        CHECK((out != nullptr) == (status == LR_OK));
        lr_asset_release(out);
        return status;
    });
    check_use<lr_aerodynamics>(initialised(lr_aerodynamics_init), [](lr_aerodynamics* a) {
        lr_rigid_desc d = rigid_plate();
        d.aerodynamics = a;
        lr_asset* out = nullptr;
        const lr_status status = lr_asset_create_rigid(&d, &out);
        lr_asset_release(out);
        return status;
    });
    check_use<lr_world_desc>(world_desc(), [](lr_world_desc* d) {
        lr_world* out = nullptr;
        const lr_status status = lr_world_create(d, &out);
        CHECK((out != nullptr) == (status == LR_OK));
        lr_world_destroy(out);
        return status;
    });
    lr_batch_desc b = batch_desc();
    b.asset = asset.get();
    b.capacity = 1;
    check_use<lr_batch_desc>(b, [&](lr_batch_desc* d) {
        lr_batch out = 0;
        const lr_status status = lr_batch_create(w, d, &out);
        CHECK((out != 0) == (status == LR_OK));
        if (out) CHECK(lr_batch_destroy(w, out) == LR_OK);
        return status;
    });
    check_use<lr_wind_desc>(wind_desc(), [&](lr_wind_desc* d) { return lr_world_set_wind(w, d); });
    check_use<lr_surface_desc>(initialised(lr_surface_desc_init),
                               [&](lr_surface_desc* d) { return lr_world_set_surface(w, d); });
    lr_wind_source_desc blower = initialised(lr_wind_source_desc_init);
    blower.kind = LR_WIND_SOURCE_POINT_BLOWER;
    lr_wind_source source = 0;
    check_use<lr_wind_source_desc>(blower, [&](lr_wind_source_desc* d) { return lr_world_add_wind(w, d, &source); });
    REQUIRE(lr_world_add_wind(w, &blower, &source) == LR_OK);
    check_use<lr_wind_source_desc>(blower, [&](lr_wind_source_desc* d) { return lr_world_update_wind(w, source, d); });
    const float sample = 1.0f;
    lr_turbulence_table t = table_desc();
    t.count = 1;
    t.chi = t.epsilon = &sample;
    t.dt = t.u0 = t.l = 1.0f;
    check_use<lr_turbulence_table>(t,
                                   [&](lr_turbulence_table* d) { return lr_batch_set_turbulence_table(w, batch, d); });
    check_use<lr_body_desc>(body_desc(), [&](lr_body_desc* d) { return lr_body_create(w, batch, d, 1, nullptr); });
    check_use<lr_body_state>(body_state(), [&](lr_body_state* s) { return lr_body_set_state(w, body, s); });
    check_use<lr_body_state>(body_state(), [&](lr_body_state* s) { return lr_body_get_state(w, body, s); });
    check_use<lr_asset_info>(initialised(lr_asset_info_init),
                             [&](lr_asset_info* i) { return lr_asset_get_info(asset.get(), i); });
    check_use<lr_aerodynamics>(initialised(lr_aerodynamics_init),
                               [&](lr_aerodynamics* a) { return lr_asset_get_aerodynamics(asset.get(), a); });
    check_use<lr_aerodynamics>(initialised(lr_aerodynamics_init),
                               [&](lr_aerodynamics* a) { return lr_batch_get_aerodynamics(w, batch, a); });
    check_use<lr_aerodynamics>(initialised(lr_aerodynamics_init),
                               [&](lr_aerodynamics* a) { return lr_batch_set_aerodynamics(w, batch, a); });
    check_use<lr_load_gains>(initialised(lr_load_gains_init),
                             [&](lr_load_gains* g) { return lr_batch_set_load_gains(w, batch, g); });
    check_use<lr_world_info>(initialised(lr_world_info_init),
                             [&](lr_world_info* i) { return lr_world_get_info(w, i); });
    lr_body_force f = initialised(lr_body_force_init);
    f.body = body;
    check_use<lr_body_force>(f, [&](lr_body_force* d) { return lr_body_add_force(w, d, 1); });
    check_use<lr_force_arrays>(initialised(lr_force_arrays_init),
                               [&](lr_force_arrays* d) { return lr_batch_add_forces(w, batch, d); });
    check_use<lr_batch_force>(initialised(lr_batch_force_init),
                              [&](lr_batch_force* d) { return lr_batch_set_force(w, batch, d); });
    check_use<lr_batch_rules>(initialised(lr_batch_rules_init),
                              [&](lr_batch_rules* d) { return lr_batch_set_rules(w, batch, d); });
    check_use<lr_emitter_desc>(initialised(lr_emitter_desc_init),
                               [&](lr_emitter_desc* d) { return lr_batch_set_emitter(w, batch, d); });
    check_use<lr_batch_events>(initialised(lr_batch_events_init),
                               [&](lr_batch_events* e) { return lr_batch_get_events(w, batch, e); });
    check_use<lr_batch_pace>(initialised(lr_batch_pace_init),
                             [&](lr_batch_pace* p) { return lr_batch_get_pace(w, batch, p); });
    check_use<lr_step_report>(initialised(lr_step_report_init),
                              [&](lr_step_report* r) { return lr_world_get_step_report(w, r); });
    const lr_collider_desc plane = collider_desc(LR_COLLIDER_PLANE);
    check_use<lr_collider_desc>(plane, [&](lr_collider_desc* d) { return lr_collider_create(w, d, 1, nullptr); });
    lr_collider_motion motion = initialised(lr_collider_motion_init);
    motion.collider = add_collider(world, plane);
    check_use<lr_collider_motion>(motion, [&](lr_collider_motion* m) { return lr_collider_move(w, m, 1); });
    check_use<lr_collider_state>(initialised(lr_collider_state_init),
                                 [&](lr_collider_state* s) { return lr_collider_get_state(w, motion.collider, s); });
    check_use<lr_collider_surface>(initialised(lr_collider_surface_init), [&](lr_collider_surface* s) {
        return lr_collider_set_surface(w, &motion.collider, 1, s);
    });
    check_use<lr_contact_event_list>(initialised(lr_contact_event_list_init),
                                     [&](lr_contact_event_list* l) { return lr_world_get_contact_events(w, l); });
    check_use<lr_ray>(initialised(lr_ray_init), [&](lr_ray* r) {
        lr_ray_hit hit;
        return lr_world_ray_cast(w, r, 1, &hit);
    });
    check_use<lr_overlap_desc>(initialised(lr_overlap_desc_init), [&](lr_overlap_desc* d) {
        lr_body ids[64];
        uint32_t count = 0;
        return lr_world_overlap(w, d, ids, 64, &count);
    });
    check_use<lr_batch_contact>(initialised(lr_batch_contact_init),
                                [&](lr_batch_contact* c) { return lr_batch_set_contact(w, batch, c); });
    check_use<lr_batch_contact>(initialised(lr_batch_contact_init),
                                [&](lr_batch_contact* c) { return lr_batch_get_contact(w, batch, c); });
    lr_recording_desc recording = initialised(lr_recording_desc_init);
    CHECK((recording.flags == LR_RECORD_CALLBACKS && recording.hash_interval == 1 && !recording.write));
    recording.write = [](void*, const void*, uint64_t) -> int32_t { return 0; };
    check_use<lr_recording_desc>(recording, [&](lr_recording_desc* d) {
        const lr_status status = lr_world_record_start(w, d);
        if (status == LR_OK) CHECK(lr_world_record_stop(w) == LR_OK);
        return status;
    });
    check_use<lr_batch_view>(initialised(lr_batch_view_init),
                             [&](lr_batch_view* v) { return lr_batch_get_view(w, batch, v); });
}

TEST_CASE("the struct_size of an array of body descs is its stride") {
    const Asset asset = leaf();
    const World world = make(world_desc());
    const lr_batch batch = add_batch(world, asset, 8);
    std::vector<Grown<lr_body_desc>> descs;
    for (int i = 0; i < 3; ++i) {
        descs.emplace_back(body_desc());
        descs.back().value.struct_size = sizeof(Grown<lr_body_desc>);
        descs.back().value.position[1] = static_cast<float>(i);
    }
    lr_body ids[3];
    REQUIRE(lr_body_create(world.get(), batch, &descs[0].value, 3, ids) == LR_OK);
    for (int i = 0; i < 3; ++i) CHECK(state_of(world, ids[i]).position[1] == static_cast<float>(i));
    // An element of another size than the first, or with a tail: none is made.
    descs[2].value.struct_size = sizeof(lr_body_desc);
    CHECK(lr_body_create(world.get(), batch, &descs[0].value, 3, ids) == LR_ERROR_STRUCT_SIZE);
    descs[2].value.struct_size = sizeof(Grown<lr_body_desc>);
    descs[2].tail[5] = 1;
    CHECK(lr_body_create(world.get(), batch, &descs[0].value, 3, ids) == LR_ERROR_STRUCT_SIZE);
    CHECK(info_of(world).body_count == 3);
}

TEST_CASE("snapshots hold what a later header's structs set as this header has it") {
    const Asset asset = leaf();
    std::vector<unsigned char> saved[2];
    for (bool later : {false, true}) {
        const auto give = [&](const auto& desc, auto&& to) {
            Grown grown(desc);
            if (later) grown.value.struct_size = sizeof grown;
            REQUIRE(to(&grown.value) == LR_OK);
        };
        lr_world* w = nullptr;
        give(world_desc(), [&](const lr_world_desc* d) { return lr_world_create(d, &w); });
        const World world(w);
        lr_batch_desc b = batch_desc();
        b.asset = asset.get();
        b.capacity = 8;
        lr_batch batch = 0;
        give(b, [&](const lr_batch_desc* d) { return lr_batch_create(w, d, &batch); });
        give(body_desc(), [&](const lr_body_desc* d) { return lr_body_create(w, batch, d, 1, nullptr); });
        give(wind_desc(), [&](const lr_wind_desc* d) { return lr_world_set_wind(w, d); });
        lr_wind_source source = 0;
        lr_wind_source_desc blower = initialised(lr_wind_source_desc_init);
        blower.kind = LR_WIND_SOURCE_POINT_BLOWER;
        give(blower, [&](const lr_wind_source_desc* d) { return lr_world_add_wind(w, d, &source); });
        give(blower, [&](const lr_wind_source_desc* d) { return lr_world_update_wind(w, source, d); });
        give(initialised(lr_surface_desc_init), [&](const lr_surface_desc* d) { return lr_world_set_surface(w, d); });
        const float sample = 1.0f;
        lr_turbulence_table t = table_desc();
        t.count = 1;
        t.chi = t.epsilon = &sample;
        t.dt = t.u0 = t.l = 1.0f;
        give(t, [&](const lr_turbulence_table* d) { return lr_batch_set_turbulence_table(w, batch, d); });
        give(initialised(lr_aerodynamics_init),
             [&](const lr_aerodynamics* d) { return lr_batch_set_aerodynamics(w, batch, d); });
        give(initialised(lr_load_gains_init),
             [&](const lr_load_gains* d) { return lr_batch_set_load_gains(w, batch, d); });
        give(initialised(lr_batch_force_init),
             [&](const lr_batch_force* d) { return lr_batch_set_force(w, batch, d); });
        give(initialised(lr_batch_rules_init),
             [&](const lr_batch_rules* d) { return lr_batch_set_rules(w, batch, d); });
        give(initialised(lr_emitter_desc_init),
             [&](const lr_emitter_desc* d) { return lr_batch_set_emitter(w, batch, d); });
        give(initialised(lr_batch_contact_init),
             [&](const lr_batch_contact* d) { return lr_batch_set_contact(w, batch, d); });
        lr_collider collider = 0;
        give(collider_desc(LR_COLLIDER_PLANE),
             [&](const lr_collider_desc* d) { return lr_collider_create(w, d, 1, &collider); });
        lr_collider_motion motion = initialised(lr_collider_motion_init);
        motion.collider = collider;
        give(motion, [&](const lr_collider_motion* d) { return lr_collider_move(w, d, 1); });
        give(initialised(lr_collider_surface_init),
             [&](const lr_collider_surface* d) { return lr_collider_set_surface(w, &collider, 1, d); });
        steps(world, 1, 0.01f);
        saved[later] = snapshot_of(world);
    }
    CHECK(saved[0] == saved[1]);
}
