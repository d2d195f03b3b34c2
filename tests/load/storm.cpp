#include "load/storm.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace load {
namespace {

template <class T> T initialised(lr_status (*init)(T*, uint32_t)) {
    T desc;
    must(init(&desc, sizeof desc), "init");
    return desc;
}

lr_asset* ellipsoid(double a, double b, double c, double density) {
    lr_ellipsoid_desc d = initialised(lr_ellipsoid_desc_init);
    d.semi_axes[0] = a, d.semi_axes[1] = b, d.semi_axes[2] = c;
    d.density = density;
    lr_asset* asset = nullptr;
    must(lr_asset_create_ellipsoid(&d, &asset), "asset");
    return asset;
}

lr_kill_volume outside_of(float x, float y, float z) {
    return {LR_VOLUME_BOX, LR_KILL_OUTSIDE, {0.0f, 0.0f, 0.0f}, {x, y, z}};
}

lr_emitter_desc sky(float height, float across) {
    lr_emitter_desc d = initialised(lr_emitter_desc_init);
    d.shape = LR_EMIT_BOX;
    d.position[1] = height;
    d.size[0] = d.size[2] = across;
    d.size[1] = 0.5f;
    d.speed_max = 1.0f;
    d.spread = 1.5f;
    d.spin_max = 5.0f;
    return d;
}

void set_rules(lr_world* world, lr_batch batch, int32_t action, float max_age, const lr_kill_volume& volume) {
    lr_batch_rules r = initialised(lr_batch_rules_init);
    r.action = action;
    r.max_age = max_age;
    r.volume_count = 1;
    r.volumes[0] = volume;
    must(lr_batch_set_rules(world, batch, &r), "rules");
}

} // namespace

void must(lr_status status, const char* what) {
    if (status == LR_OK) return;
    std::fprintf(stderr, "%s: %s\n", what, lr_status_string(status));
    std::exit(1);
}

Storm::Storm(uint64_t seed, uint32_t workers) {
    lr_world_desc wd = initialised(lr_world_desc_init);
    wd.seed = seed;
    wd.worker_count = workers;
    must(lr_world_create(&wd, &world_), "world");
    add_wind();
    add_ground();

    // Leaves fall on the ground, lie there, are blown away, and float beside the island.
    const lr_batch leaves = add_batch("leaves", ellipsoid(0.04, 0.01, 0.0001, 700.0), 96, LR_LOADS_AERODYNAMIC, 30.0f);
    lr_emitter_desc e = sky(6.0f, 4.0f);
    e.rate = 1.25f;
    e.burst_count = 8, e.burst_interval = 60.0f;
    must(lr_batch_set_emitter(world_, leaves, &e), "emitter");
    set_rules(world_, leaves, LR_END_DESTROY, 30.0f, outside_of(40.0f, 15.0f, 40.0f));

    // Discs respawn if they leave a box, with the paper's loads.
    const lr_batch discs = add_batch("discs", ellipsoid(0.02, 0.02, 0.0005, 400.0), 24, LR_LOADS_LANGEVIN, 40.0f);
    e = sky(5.0f, 3.0f);
    must(lr_batch_set_emitter(world_, discs, &e), "emitter");
    set_rules(world_, discs, LR_END_RESPAWN, 40.0f, outside_of(20.0f, 10.0f, 20.0f));
    must(lr_batch_spawn(world_, discs, 24, nullptr), "discs");

    // Petals pile up.
    const lr_batch petals =
        add_batch("petals", ellipsoid(0.012, 0.009, 0.0004, 300.0), 24, LR_LOADS_AERODYNAMIC, 14.0f);
    e = sky(1.0f, 0.05f);
    e.rate = 1.0f;
    must(lr_batch_set_emitter(world_, petals, &e), "emitter");
    set_rules(world_, petals, LR_END_DESTROY, 14.0f, outside_of(40.0f, 15.0f, 40.0f));
    must(lr_batch_set_body_contact(world_, petals, petals, 1), "pairs");

    // Seeds have no loads, and take one of two steps.
    const lr_batch seeds = add_batch("seeds", ellipsoid(0.004, 0.003, 0.002, 900.0), 16, LR_LOADS_NONE, 8.0f);
    e = sky(3.0f, 2.0f);
    must(lr_batch_set_emitter(world_, seeds, &e), "emitter");
    set_rules(world_, seeds, LR_END_RESPAWN, 8.0f, outside_of(20.0f, 10.0f, 20.0f));
    must(lr_batch_spawn(world_, seeds, 16, nullptr), "seeds");

    must(lr_batch_set_rate(world_, seeds, 2), "rate");

    // Wanderers are pulled up slightly more than down and tumble through the wind forever; stones lie forever.
    const lr_batch wanderers =
        add_batch("wanderers", ellipsoid(0.03, 0.02, 0.001, 300.0), 16, LR_LOADS_AERODYNAMIC, 0.0f);
    lr_batch_contact none = initialised(lr_batch_contact_init);
    none.layers = 0;
    must(lr_batch_set_contact(world_, wanderers, &none), "contact");
    lr_batch_force lift = initialised(lr_batch_force_init);
    lift.acceleration[1] = 12.0f;
    must(lr_batch_set_force(world_, wanderers, &lift), "force");
    const lr_batch stones = add_batch("stones", ellipsoid(0.03, 0.02, 0.02, 2500.0), 4, LR_LOADS_AERODYNAMIC, 0.0f);
    std::vector<lr_body_desc> bodies(16, initialised(lr_body_desc_init));
    for (size_t i = 0; i < bodies.size(); ++i) {
        bodies[i].position[0] = static_cast<float>(i);
        bodies[i].position[1] = 8.0f;
        bodies[i].angular_velocity[i % 3] = 6.0f;
    }
    must(lr_body_create(world_, wanderers, bodies.data(), 16, nullptr), "wanderers");
    for (lr_body_desc& b : bodies) b.position[1] = 0.02f, b.position[2] = -3.0f, b.angular_velocity[0] = 0.0f;
    std::vector<lr_body> lying(4);
    must(lr_body_create(world_, stones, bodies.data(), 4, lying.data()), "stones");
    must(lr_body_set_sleep(world_, lying.data(), 4, LR_SLEEP_ASLEEP), "rest");
    must(lr_world_set_events(world_, 256, LR_EVENTS_ALL), "events");
}

Storm::~Storm() {
    lr_world_destroy(world_);
    for (lr_asset* asset : assets_) lr_asset_release(asset);
}

lr_batch Storm::add_batch(const char* name, lr_asset* asset, uint32_t capacity, int32_t loads, float max_age) {
    assets_.push_back(asset);
    lr_batch_desc d = initialised(lr_batch_desc_init);
    d.asset = asset;
    d.capacity = capacity;
    d.load_model = loads;
    Kind kind{name};
    kind.max_age = max_age;
    must(lr_batch_create(world_, &d, &kind.batch), "batch");
    kinds_.push_back(kind);
    return kind.batch;
}

void Storm::add_wind() {
    must(lr_world_set_uniform_wind(world_, 1.5f, 0.0f, 0.0f), "wind");
    lr_gusts_desc gusts = initialised(lr_gusts_desc_init);
    gusts.rms = 0.8f, gusts.angle_rms = 0.5f;
    must(lr_world_add_gusts(world_, &gusts, nullptr), "gusts");
    lr_turbulence_desc turbulence = initialised(lr_turbulence_desc_init);
    turbulence.rms = 0.5f;
    must(lr_world_add_turbulence(world_, &turbulence, nullptr), "turbulence");
    const lr_ground_wind_desc ground = initialised(lr_ground_wind_desc_init);
    must(lr_world_add_ground_wind(world_, &ground, nullptr), "ground");
}

void Storm::add_ground() {
    lr_collider_desc d[3] = {initialised(lr_collider_desc_init), initialised(lr_collider_desc_init),
                             initialised(lr_collider_desc_init)};
    std::vector<float> heights; // of an island with a plain, in the sea
    for (int k = -12; k <= 12; ++k)
        for (int i = -12; i <= 12; ++i)
            heights.push_back(-0.15f * static_cast<float>(std::max({std::abs(i), std::abs(k), 4}) - 4));
    d[0].kind = LR_COLLIDER_HEIGHTFIELD;
    d[0].position[0] = d[0].position[2] = -12.0f;
    d[0].counts[0] = d[0].counts[1] = 25;
    d[0].heights = heights.data();
    d[1].kind = LR_COLLIDER_BOX;
    d[1].position[0] = 2.0f, d[1].position[1] = 0.3f;
    d[1].size[0] = 0.1f, d[1].size[1] = 0.3f, d[1].size[2] = 2.0f;
    d[2].kind = LR_COLLIDER_SPHERE; // walks to and fro
    d[2].position[0] = -2.0f, d[2].position[1] = 0.3f, d[2].position[2] = 1.0f;
    d[2].size[0] = 0.3f;
    lr_collider ids[3] = {};
    must(lr_collider_create(world_, d, 3, ids), "colliders");
    walker_ = ids[2];
    lr_water_desc sea = initialised(lr_water_desc_init);
    sea.position[1] = -0.4f;
    sea.wave_count = 2;
    sea.waves[0] = {{1.0f, 0.0f, 0.2f}, 6.0f, 0.15f, 0.0f};
    sea.waves[1] = {{-0.3f, 0.0f, 1.0f}, 2.5f, 0.05f, 1.0f};
    sea.current[0] = 0.1f;
    must(lr_world_set_water(world_, &sea), "sea");
}

// Other calls of a game: one vortex is removed and another added, bodies are created and destroyed, and a snapshot is saved and restored.
void Storm::every_minute() {
    if (vortex_.id) must(lr_world_remove_wind(world_, vortex_), "vortex");
    lr_vortex_desc d = initialised(lr_vortex_desc_init);
    d.core = LR_VORTEX_RANKINE;
    d.position[2] = 2.0f;
    d.circulation = 3.0f, d.core_radius = 0.3f, d.outer_radius = 3.0f;
    must(lr_world_add_vortex(world_, &d, &vortex_), "vortex");
    if (!visitors_.empty()) {
        const lr_status status = lr_body_destroy(world_, visitors_.data(), static_cast<uint32_t>(visitors_.size()));
        if (status != LR_ERROR_STALE_BODY) must(status, "visitors"); // rules have already ended one
    }
    std::vector<lr_body_desc> bodies(8, initialised(lr_body_desc_init));
    for (size_t i = 0; i < bodies.size(); ++i) {
        bodies[i].position[0] = -3.0f + static_cast<float>(i);
        bodies[i].position[1] = 4.0f;
    }
    visitors_.resize(bodies.size());
    must(lr_body_create(world_, kinds_[0].batch, bodies.data(), static_cast<uint32_t>(bodies.size()), visitors_.data()),
         "visitors");
    const uint64_t size = lr_world_snapshot_size(world_);
    if (size > snapshot_.size()) snapshot_.resize(size + size / 4);
    uint64_t written = 0, before = 0, after = 0;
    must(lr_world_snapshot_save(world_, snapshot_.data(), snapshot_.size(), &written), "save");
    must(lr_world_hash(world_, &before), "hash");
    must(lr_world_snapshot_restore(world_, snapshot_.data(), written), "restore");
    must(lr_world_hash(world_, &after), "hash");
    must(before == after ? LR_OK : LR_ERROR_INTERNAL, "a restored state");
}

void Storm::step() {
    if (steps_ % minute == minute / 2) every_minute();
    if (steps_ % (5 * second) == 0) {
        lr_collider_motion m = initialised(lr_collider_motion_init);
        m.mode = LR_MOVE_PLACE;
        m.collider = walker_;
        const bool back = steps_ / (5 * second) % 2 != 0;
        m.position[0] = back ? 1.0f : -2.0f, m.position[1] = 0.3f, m.position[2] = 1.0f;
        m.linear_velocity[0] = back ? -0.6f : 0.6f;
        must(lr_collider_move(world_, &m, 1), "walker");
    }
    must(lr_world_step(world_, frame, 1), "step");
    ++steps_;
}

} // namespace load
