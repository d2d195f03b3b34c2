#include "support/determinism_scenes.h"

#include "support/random.h"
#include "support/station_bodies.h"
#include "support/water.h"

#include <algorithm>
#include <cmath>

namespace test {

namespace {

constexpr Source every_source[] = {Source::gusts,       Source::rankine,    Source::lamb_oseen, Source::round_blower,
                                   Source::slot_blower, Source::turbulence, Source::grid,       Source::ground};

} // namespace

std::vector<PlayedScene> played_scenes() {
    std::vector<PlayedScene> all;
    const auto add = [&](const char* name) -> PlayedScene& {
        all.push_back({name});
        return all.back();
    };
    const auto with = [&](const char* name, int32_t loads, int32_t clock = LR_CLOCK_SPEED) -> PlayedScene& {
        PlayedScene& scene = add(name);
        scene.loads = loads, scene.clock = clock;
        return scene;
    };
    // Runge-Kutta diverges for long substeps; separate scenes cover that.
    const auto rk4 = [](PlayedScene& scene, uint32_t substeps = 3) {
        scene.integrator = LR_INTEGRATOR_RK4, scene.substeps = substeps;
    };
    // Loads, clocks, paths and integrators.
    add("speed");
    rk4(add("speed_rk4"));
    add("speed_full").full = true;
    with("age", LR_LOADS_LANGEVIN, LR_CLOCK_AGE);
    PlayedScene& loop = with("age_loop_rk4", LR_LOADS_LANGEVIN, LR_CLOCK_AGE);
    rk4(loop), loop.table_end = LR_TABLE_LOOP;
    with("kirchhoff", LR_LOADS_NONE);
    rk4(with("kirchhoff_rk4", LR_LOADS_NONE), 7);
    with("aerodynamic", LR_LOADS_AERODYNAMIC);
    rk4(with("aerodynamic_rk4", LR_LOADS_AERODYNAMIC));
    with("aerodynamic_full", LR_LOADS_AERODYNAMIC).full = true;
    with("aerodynamic_age", LR_LOADS_AERODYNAMIC, LR_CLOCK_AGE);
    rk4(with("aerodynamic_age_rk4", LR_LOADS_AERODYNAMIC, LR_CLOCK_AGE));

    // Wind: uniform, each kind of source alone, and all together. The ground wind changes the uniform wind.
    add("wind").windy = true;
    const auto blown = [&](const char* name, std::vector<Source> sources) -> PlayedScene& {
        PlayedScene& scene = add(name);
        scene.sources = std::move(sources), scene.windy = true, scene.bodies = 75;
        return scene;
    };
    blown("wind_gusts", {Source::gusts});
    blown("wind_rankine", {Source::rankine});
    blown("wind_lamb_oseen", {Source::lamb_oseen});
    blown("wind_point_blower", {Source::round_blower});
    blown("wind_line_blower", {Source::slot_blower});
    blown("wind_turbulence", {Source::turbulence});
    blown("wind_grid", {Source::grid});
    blown("wind_ground", {Source::ground});
    blown("wind_callback", {}).called_back = true;
    const std::vector<Source> every(std::begin(every_source), std::end(every_source));
    blown("wind_of_all", every).called_back = true;
    blown("wind_of_all_aerodynamic", every).loads = LR_LOADS_AERODYNAMIC;
    blown("wind_kirchhoff", {Source::gusts, Source::turbulence}).loads = LR_LOADS_NONE;
    rk4(blown("wind_of_all_rk4", every), 23);

    // Water.
    const auto at_sea = [&](const char* name, int32_t loads, int32_t clock = LR_CLOCK_SPEED) -> PlayedScene& {
        PlayedScene& scene = with(name, loads, clock);
        scene.afloat = true;
        return scene;
    };
    at_sea("sea", LR_LOADS_AERODYNAMIC);
    at_sea("sea_full", LR_LOADS_LANGEVIN).full = true;
    const auto slowed = [&](PlayedScene& scene) { rk4(scene, 20), scene.dt = 1.0f / 600.0f, scene.bodies = 75; };
    slowed(at_sea("sea_rk4", LR_LOADS_AERODYNAMIC));
    slowed(at_sea("sea_age_rk4", LR_LOADS_LANGEVIN, LR_CLOCK_AGE));
    at_sea("sea_age", LR_LOADS_AERODYNAMIC, LR_CLOCK_AGE).bodies = 75;
    at_sea("sea_kirchhoff", LR_LOADS_NONE).bodies = 75;
    PlayedScene& swell = at_sea("sea_wind_and_callbacks", LR_LOADS_LANGEVIN, LR_CLOCK_AGE);
    swell.sources = every, swell.windy = swell.called_back = true, swell.bodies = 75;

    // Forces, spawns and ends.
    add("forces").forced = true;
    PlayedScene& forces_rk4 = add("forces_rk4");
    rk4(forces_rk4), forces_rk4.forced = true;
    add("births_and_deaths").born_and_dying = true;
    add("rules").governed = true;

    // Batches with two rates, one with fewer substeps and one that waits for some steps; a budget for less than half.
    const auto paced = [&](const char* name, uint32_t a, uint32_t b) -> PlayedScene& {
        PlayedScene& scene = add(name);
        scene.divisors[0] = a, scene.divisors[1] = b, scene.windy = true;
        scene.dt = 1.0f / 240.0f; // in long steps a divisor has no effect
        return scene;
    };
    paced("rates", 2, 7);
    PlayedScene& all_paced = paced("rates_in_everything", 3, 6);
    all_paced.loads = LR_LOADS_AERODYNAMIC, all_paced.sources = every;
    all_paced.afloat = all_paced.forced = all_paced.governed = all_paced.called_back = true;
    all_paced.bodies = 75;
    PlayedScene& short_of = paced("budget", 1, 2);
    short_of.loads = LR_LOADS_AERODYNAMIC, short_of.budget = 333, short_of.born_and_dying = true;
    PlayedScene& little = paced("budget_for_part_of_a_batch", 1, 1);
    little.budget = 50, little.sources = {Source::gusts}, little.governed = true;

    // Bodies put to sleep, and woken in every way.
    PlayedScene& still = add("rest");
    still.resting = still.windy = still.forced = true, still.bodies = 600;
    PlayedScene& still_in_everything = paced("rest_in_everything", 3, 6);
    still_in_everything.loads = LR_LOADS_AERODYNAMIC, still_in_everything.sources = every;
    still_in_everything.afloat = still_in_everything.governed = still_in_everything.called_back = true;
    still_in_everything.born_and_dying = still_in_everything.resting = true, still_in_everything.bodies = 300;

    // Leaves and bricks that land, some asleep at the end.
    const auto landing = [&](const char* name, Solids on) -> PlayedScene& {
        PlayedScene& scene = with(name, LR_LOADS_AERODYNAMIC);
        scene.solids = on, scene.windy = true, scene.dt = 0.05f;
        return scene;
    };
    landing("landing", Solids::ground).bodies = 250;
    landing("landing_on_terrain", Solids::terrain);
    PlayedScene& landing_in_everything = landing("landing_in_everything", Solids::ground);
    landing_in_everything.loads = LR_LOADS_LANGEVIN, landing_in_everything.full = true;
    landing_in_everything.sources = {Source::gusts, Source::rankine, Source::ground};
    landing_in_everything.afloat = landing_in_everything.called_back = true;
    landing_in_everything.divisors[0] = 3, landing_in_everything.divisors[1] = 2;
    landing_in_everything.substeps = 12;
    PlayedScene& landing_on_edges = landing("landing_on_edges", Solids::edges);
    landing_on_edges.born_and_dying = true, landing_on_edges.dt = 0.1f, landing_on_edges.substeps = 6;

    // Leaves and bricks that land on each other.
    const auto pile = [&](const char* name, Solids on) -> PlayedScene& {
        PlayedScene& scene = landing(name, on);
        scene.body_contact = true, scene.bodies = 80;
        return scene;
    };
    pile("pile", Solids::ground);
    pile("pile_on_terrain", Solids::terrain).windy = false;
    PlayedScene& pile_in_field = pile("pile_in_a_field", Solids::terrain);
    pile_in_field.sources = {Source::gusts, Source::rankine}, pile_in_field.forced = true;
    PlayedScene& pile_afloat = pile("pile_afloat", Solids::ground);
    pile_afloat.afloat = true, pile_afloat.full = true, pile_afloat.bodies = 60;
    PlayedScene& paced_pile = pile("pile_at_rates", Solids::ground);
    paced_pile.divisors[0] = 2, paced_pile.divisors[1] = 2, paced_pile.born_and_dying = true;
    paced_pile.dt = 0.0125f, paced_pile.frames = 90;
    PlayedScene& apart_pile = pile("pile_at_two_rates", Solids::terrain);
    apart_pile.divisors[0] = 3, apart_pile.divisors[1] = 1, apart_pile.resting = true;
    apart_pile.dt = 0.0125f, apart_pile.frames = 90;

    // Bodies with stations.
    const auto winged_bodies = [&](PlayedScene& scene) -> PlayedScene& {
        scene.loads = LR_LOADS_AERODYNAMIC, scene.stations = true;
        return scene;
    };
    winged_bodies(add("stations"));
    rk4(winged_bodies(add("stations_rk4")), 12);
    winged_bodies(with("stations_age", LR_LOADS_AERODYNAMIC, LR_CLOCK_AGE)).born_and_dying = true;
    winged_bodies(blown("stations_in_wind_of_all", every)).called_back = true;
    PlayedScene& stations_afloat = winged_bodies(at_sea("stations_at_sea", LR_LOADS_AERODYNAMIC));
    stations_afloat.forced = stations_afloat.governed = true;
    winged_bodies(pile("stations_in_a_pile", Solids::ground));
    PlayedScene& stations_faulty = winged_bodies(add("stations_faults_rk4"));
    rk4(stations_faulty), stations_faulty.faulty = true;

    // Bodies that diverge by forces or in an unstable scheme: in air, wind, water, in front of colliders, in a heap.
    const auto faulty = [&](PlayedScene& scene) -> PlayedScene& {
        scene.faulty = true;
        return scene;
    };
    faulty(with("faults", LR_LOADS_NONE));
    PlayedScene& unstable = faulty(with("faults_rk4", LR_LOADS_AERODYNAMIC));
    rk4(unstable, 1), unstable.dt = 0.2f, unstable.windy = true;
    PlayedScene& faults_in_field = faulty(blown("faults_in_a_field", every));
    rk4(faults_in_field, 2), faults_in_field.afloat = faults_in_field.called_back = true, faults_in_field.bodies = 200;
    PlayedScene& faults_in_landing = faulty(landing("faults_in_landing", Solids::ground));
    rk4(faults_in_landing, 2), faults_in_landing.governed = true;
    PlayedScene& faults_in_pile = faulty(pile("faults_in_a_pile", Solids::ground));
    rk4(faults_in_pile, 2);

    // Storms of more bodies than one chunk.
    const auto storm = [&](const char* name) -> PlayedScene& {
        PlayedScene& scene = add(name);
        scene.windy = scene.born_and_dying = true, scene.bodies = 1100;
        return scene;
    };
    storm("storm");
    storm("aerodynamic_storm").loads = LR_LOADS_AERODYNAMIC;
    PlayedScene& governed = storm("storm_with_rules");
    governed.forced = governed.governed = true;
    PlayedScene& sea_storm = storm("sea_storm");
    sea_storm.loads = LR_LOADS_AERODYNAMIC;
    sea_storm.afloat = sea_storm.forced = sea_storm.governed = true;
    return all;
}

Play::Play(const PlayedScene& scene, const Circumstances& how) : scene_(scene), how_(how), colliders_(scene.solids) {
    assets_[0] = leaf();
    assets_[1] = scene_.stations ? winged() : scene_.solids == Solids::none ? curled_leaf() : brick();
    build();
    colliders_.place(world);
    for (Source kind : scene_.sources) add_source(kind);
    for (size_t b = 0; b < 2 && scene_.body_contact; ++b)
        for (size_t with = 0; with <= b; ++with)
            REQUIRE(lr_batch_set_body_contact(world.get(), batches[b], batches[with], 1) == LR_OK);
    if (scene_.afloat) set_water(world, sea()); // not after a snapshot, which restores it
    for (size_t b = 0; b < 2; ++b) {
        populate(b);
        if (scene_.forced) push_batch(b);
        if (scene_.governed) govern(b);
        if (scene_.faulty)
            REQUIRE(lr_batch_set_divergence_policy(world.get(), batches[b],
                                                   b == 0 ? LR_DIVERGENCE_FREEZE : LR_DIVERGENCE_REMOVE) == LR_OK);
        REQUIRE(lr_batch_set_rate(world.get(), batches[b], scene_.divisors[b]) == LR_OK);
    }
    REQUIRE(lr_world_set_budget(world.get(), scene_.budget) == LR_OK);
}

uint64_t Play::run() {
    for (int frame = 0; frame < scene_.frames; ++frame) {
        if (how_.recording && frame == how_.record_at)
            REQUIRE(lr_world_record_start(world.get(), how_.recording) == LR_OK);
        if (scene_.forced && frame % 3 != 1) push();
        if (frame == scene_.frames / 2 && how_.through_snapshot) {
            const std::vector<unsigned char> snapshot = snapshot_of(world);
            build();
            for (Source kind : scene_.sources)
                if (kind == Source::grid) add_source(kind);
            colliders_.prepare(world);
            REQUIRE(lr_world_snapshot_restore(world.get(), snapshot.data(), snapshot.size()) == LR_OK);
        }
        if (scene_.windy && frame % 10 == 5) set_wind(world, 0.1f * static_cast<float>(frame), 0.0f, 1.0f);
        if (scene_.born_and_dying) turn_over();
        if (scene_.resting) lie_and_wake(static_cast<uint32_t>(frame));
        if (scene_.faulty && frame % 3 == 1) carry_off(static_cast<uint32_t>(frame));
        colliders_.move(world, frame);
        steps(world, 1, scene_.dt, scene_.substeps);
    }
    CHECK(all_finite());
    if (scene_.faulty) check_faults();
    return hash_of(world);
}

void Play::build() {
    lr_world_desc wd = world_desc();
    wd.seed = 0x1234567890abcdefull;
    wd.simd_target = how_.simd;
    wd.worker_count = how_.workers;
    wd.jobs = how_.jobs;
    wd.checks = how_.checks;
    if (how_.checks != 0)
        wd.log = [](void*, int32_t, const char* message) {
            if (std::strstr(message, "inside the same world")) FAIL_CHECK(std::string(message));
        };
    world = make(wd);
    if (how_.recording && how_.record_at < 0) REQUIRE(lr_world_record_start(world.get(), how_.recording) == LR_OK);
    for (size_t b = 0; b < 2; ++b) {
        lr_batch_desc bd = batch_desc();
        bd.load_model = scene_.loads;
        bd.clock = scene_.clock;
        bd.table_end = scene_.table_end;
        bd.integrator = scene_.integrator;
        bd.variation = b == 0 ? 0.0f : 0.15f;
        batches[b] = add_batch(world, bd, assets_[b], scene_.bodies + 40, scene_.full);
    }
    // Not in snapshots: callbacks, and the samples of a grid, which can have another address.
    if (scene_.called_back) {
        REQUIRE(lr_world_set_wind_callback(world.get(), shear, nullptr) == LR_OK);
        REQUIRE(lr_world_set_water_callback(world.get(), swell, nullptr) == LR_OK);
    }
}

void Play::add_source(Source kind) {
    const std::vector<float> samples = grid_samples();
    test::add_source(world, one_of(kind, samples));
}

void Play::shear(void*, const lr_wind_query* q) {
    for (uint32_t i = 0; i < q->count; ++i) {
        const float t = static_cast<float>(q->time);
        q->velocity[0][i] = q->position[2][i] * t;
        q->velocity[1][i] = q->position[0][i] * 0.5f;
        q->rate[0][i] = q->position[2][i];
        q->gradient[2][i] = t;
        q->gradient[3][i] = 0.5f;
    }
}

void Play::swell(void*, const lr_water_query* q) {
    for (uint32_t i = 0; i < q->count; ++i) {
        q->height[i] += 0.1f * static_cast<float>(q->time);
        q->velocity[1][i] += 0.1f;
    }
}

bool Play::all_finite() const {
    bool good = true;
    for (lr_batch batch : batches) {
        const lr_batch_view v = view_of(world, batch);
        const std::vector<Velocity> u = velocities_of(world, batch);
        for (uint32_t i = 0; i < v.count; ++i)
            for (size_t k = 0; k < 3; ++k)
                good = good && std::isfinite(v.position[k][i]) && std::isfinite(u[i].linear[k]) &&
                       std::isfinite(u[i].angular[k]);
    }
    return good;
}

lr_body_desc Play::body(uint32_t noise_seed) const {
    Random random(noise_seed);
    lr_body_desc d = body_desc();
    d.noise_seed = noise_seed;
    for (float& x : d.position) x = random.real(-5.0, 5.0);
    if (scene_.solids != Solids::none) {
        for (float& x : d.position) x *= 0.4f;
        d.position[1] = 0.15f * d.position[1] + 0.35f;
    }
    if (scene_.body_contact) // spread over the box, the sphere and the open ground
        for (size_t k = 0; k < 3; ++k) d.position[k] = k == 1 ? d.position[k] : 0.12f * d.position[k] + 0.5f;
    for (float& q : d.orientation) q = random.real(-1.0, 1.0);
    for (float& v : d.linear_velocity) v = random.real(-0.5, 0.5);
    for (float& w : d.angular_velocity) w = random.real(-5.0, 5.0);
    d.scale = random.real(0.5, 2.0);
    d.age = random.real(0.0, 0.5);
    return d;
}

void Play::check_faults() const {
    for (const lr_batch batch : batches) {
        lr_batch_counts e = initialised(lr_batch_counts_init);
        REQUIRE(lr_batch_get_counts(world.get(), batch, &e) == LR_OK);
        CHECK(e.total_diverged > 5);
        if (batch == batches[0]) CHECK(view_of(world, batch).count > 10); // in the other batch they end
    }
}

void Play::carry_off(uint32_t frame) {
    for (const lr_batch batch : batches) {
        std::vector<lr_body_force> forces;
        const lr_batch_view v = view_of(world, batch);
        for (uint32_t i = 0; i < v.count; ++i) {
            if (v.noise_seed[i] % 31 != frame) continue;
            lr_body_force f = initialised(lr_body_force_init);
            f.body = v.ids[i];
            f.mode = LR_FORCE_MODE_ACCELERATION;
            f.force[v.noise_seed[i] % 3] = 1e9f;
            forces.insert(forces.end(), 40, f);
        }
        REQUIRE(lr_body_add_force(world.get(), forces.data(), static_cast<uint32_t>(forces.size())) == LR_OK);
    }
}

void Play::populate(size_t b) {
    std::vector<lr_body_desc> descs;
    const uint32_t first = b == 0 ? 1 : 100001;
    for (uint32_t i = 0; i < scene_.bodies; ++i) descs.push_back(body(first + i));
    if (how_.permuted) {
        // Creates and destroys other bodies first, so that slots and generations are out of order too.
        std::vector<lr_body> ghosts(30);
        const std::vector<lr_body_desc> ghost(30, body(999));
        REQUIRE(lr_body_create(world.get(), batches[b], ghost.data(), 30, ghosts.data()) == LR_OK);
        std::reverse(descs.begin(), descs.end());
        for (size_t i = 0; i + 7 < descs.size(); i += 5) std::swap(descs[i], descs[i + 7]);
        const size_t half = descs.size() / 2;
        REQUIRE(lr_body_create(world.get(), batches[b], descs.data(), static_cast<uint32_t>(half), nullptr) == LR_OK);
        REQUIRE(lr_body_destroy(world.get(), ghosts.data(), 30) == LR_OK);
        REQUIRE(lr_body_create(world.get(), batches[b], descs.data() + half, static_cast<uint32_t>(descs.size() - half),
                               nullptr) == LR_OK);
    } else {
        REQUIRE(lr_body_create(world.get(), batches[b], descs.data(), static_cast<uint32_t>(descs.size()), nullptr) ==
                LR_OK);
    }
    next_key_[b] = first + scene_.bodies;
}

void Play::push_batch(size_t b) {
    lr_batch_force f = initialised(lr_batch_force_init);
    f.force[0] = f.body_torque[1] = 1e-6f;
    f.acceleration[2] = f.body_acceleration[0] = b == 0 ? 0.5f : -0.25f;
    f.angular_acceleration[1] = 1.0f;
    REQUIRE(lr_batch_set_force(world.get(), batches[b], &f) == LR_OK);
}

void Play::govern(size_t b) {
    lr_emitter_desc e = initialised(lr_emitter_desc_init);
    e.shape = b == 0 ? LR_EMIT_SPHERE : LR_EMIT_BOX_SURFACE;
    for (float& s : e.size) s = 4.0f;
    e.spread = 1.0f;
    e.speed_max = 2.0f;
    e.spin_max = 10.0f;
    e.scale_min = 0.5f;
    e.rate = 37.0f;
    e.burst_count = 5;
    e.burst_interval = 0.13f;
    REQUIRE(lr_batch_set_emitter(world.get(), batches[b], &e) == LR_OK);
    lr_batch_rules r = initialised(lr_batch_rules_init);
    r.action = b == 0 ? LR_END_DESTROY : LR_END_RESPAWN;
    r.max_age = 0.8f;
    r.volume_count = 2;
    r.volumes[0] = {LR_VOLUME_BOX, LR_KILL_OUTSIDE, {0.0f, 0.0f, 0.0f}, {4.9f, 4.9f, 4.9f}};
    r.volumes[1] = {LR_VOLUME_SPHERE, LR_KILL_INSIDE, {1.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}};
    REQUIRE(lr_batch_set_rules(world.get(), batches[b], &r) == LR_OK);
}

void Play::push() {
    for (size_t b = 0; b < 2; ++b) {
        const lr_batch_view v = view_of(world, batches[b]);
        std::vector<float> lift(v.count), still(v.count, 0.0f);
        std::vector<lr_body_force> single;
        for (uint32_t i = 0; i < v.count; ++i) {
            lift[i] = 1e-6f * static_cast<float>(v.noise_seed[i] % 10);
            if (v.noise_seed[i] % 7 != 0) continue;
            lr_body_force f = initialised(lr_body_force_init);
            f.body = v.ids[i];
            f.mode = static_cast<int32_t>(v.noise_seed[i] % 4);
            f.frame = v.noise_seed[i] % 3 == 0 ? LR_FRAME_BODY : LR_FRAME_WORLD;
            if (f.mode == LR_FORCE_MODE_FORCE || f.mode == LR_FORCE_MODE_IMPULSE) f.flags = LR_FORCE_AT_POINT;
            for (size_t k = 0; k < 3; ++k) f.point[k] = (f.frame == LR_FRAME_WORLD ? v.position[k][i] : 0.0f) + 0.01f;
            f.force[1] = f.flags ? 1e-6f : 0.1f;
            f.torque[2] = f.flags ? 1e-8f : 1.0f;
            single.push_back(f);
        }
        lr_force_arrays a = initialised(lr_force_arrays_init);
        a.count = v.count;
        a.frame = LR_FRAME_BODY;
        a.force[0] = a.force[2] = still.data();
        a.force[1] = lift.data();
        REQUIRE(lr_batch_add_forces(world.get(), batches[b], &a) == LR_OK);
        REQUIRE(lr_body_add_force(world.get(), single.data(), static_cast<uint32_t>(single.size())) == LR_OK);
    }
}

void Play::turn_over() {
    for (size_t b = 0; b < 2; ++b) {
        const lr_batch_view v = view_of(world, batches[b]);
        std::vector<std::pair<uint32_t, lr_body>> living;
        for (uint32_t i = 0; i < v.count; ++i) living.emplace_back(v.noise_seed[i], v.ids[i]);
        std::sort(living.begin(), living.end());
        std::vector<lr_body> dying;
        for (size_t i = 3; i < living.size() && dying.size() < 10; i += 17) dying.push_back(living[i].second);
        REQUIRE(lr_body_destroy(world.get(), dying.data(), static_cast<uint32_t>(dying.size())) == LR_OK);
        for (size_t i = 0; i < dying.size(); ++i) add_body(world, batches[b], body(next_key_[b]++));
    }
}

void Play::lie_and_wake(uint32_t frame) {
    for (lr_batch batch : batches) {
        const bool all = batch == batches[0] && frame == 17, none = batch == batches[0] && frame >= 17 && frame < 20;
        const lr_batch_view v = view_of(world, batch);
        std::vector<lr_body> lying, waking;
        for (uint32_t i = 0; i < v.count; ++i) {
            if (all || (v.noise_seed[i] + frame) % 9 == 0) lying.push_back(v.ids[i]);
            if (!none && (v.noise_seed[i] + frame) % 7 == 0) waking.push_back(v.ids[i]);
        }
        const auto set = [&](const std::vector<lr_body>& ids, int32_t rest) {
            REQUIRE(lr_body_set_sleep(world.get(), ids.data(), static_cast<uint32_t>(ids.size()), rest) == LR_OK);
        };
        set(lying, LR_SLEEP_ASLEEP);
        set(waking, LR_SLEEP_AWAKE);
    }
    if (frame % 4 != 1) return;
    const float low[3] = {-1.0f, -2.0f, -5.0f}, high[3] = {3.0f, 2.0f, 0.0f};
    REQUIRE(lr_world_wake_box(world.get(), low, high, nullptr) == LR_OK);
}

uint64_t outcome(const PlayedScene& scene, const Circumstances& how) {
    return Play(scene, how).run();
}

} // namespace test
