/*
 * SPDX-License-Identifier: MIT
 *
 * A program as it was written for version 0.1: built with the header and run with the asset that are frozen beside it, against
 * whatever library is newest. It calls every function of that header, and finds canaries behind all that the library fills.
 *   program leaf.lrb
 */
#include "langevin_rigid.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int checks, failures;

#define EXPECT(condition) (++checks, (condition) ? (void)0 : fail(__LINE__, #condition))
#define OK(call) EXPECT((call) == LR_OK)

static void fail(int line, const char* what) {
    ++failures;
    printf("program.c:%d: %s\n", line, what);
}

/* A struct with bytes behind it that belong to somebody else. */
#define GUARDED(type, name)                                                                                            \
    struct {                                                                                                           \
        type value;                                                                                                    \
        unsigned char behind[64];                                                                                      \
    } name;                                                                                                            \
    memset(&name, 0x5a, sizeof name)
#define INITIALISED(type, name)                                                                                        \
    GUARDED(type, name);                                                                                               \
    OK(type##_init(&name.value, sizeof name.value));                                                                   \
    EXPECT(name.value.struct_size == sizeof name.value);                                                               \
    UNTOUCHED(name)
#define UNTOUCHED(name) EXPECT(all_canaries(name.behind, sizeof name.behind))

static int all_canaries(const unsigned char* bytes, size_t count) {
    size_t i;
    for (i = 0; i < count; ++i)
        if (bytes[i] != 0x5a) return 0;
    return 1;
}

/* --- what a host brings ------------------------------------------------------------------------------------------- */

typedef struct Host {
    long blocks;
    long messages, faults, wind_calls, surface_calls, jobs;
} Host;

static void* take(void* user, uint64_t size, uint64_t alignment) {
    void* memory = NULL;
    const uint64_t whole = (size + alignment - 1) / alignment * alignment;
    ((Host*)user)->blocks++;
    memory = malloc((size_t)(whole + alignment + sizeof(void*)));
    if (memory) { /* aligned by hand: C99 has nothing for it */
        const uintptr_t start = (uintptr_t)memory + sizeof(void*);
        void** const given = (void**)((start + alignment - 1) / alignment * alignment);
        given[-1] = memory;
        return given;
    }
    return NULL;
}

static void give_back(void* user, void* memory, uint64_t size, uint64_t alignment) {
    (void)size, (void)alignment;
    ((Host*)user)->blocks--;
    free(((void**)memory)[-1]);
}

static void* enqueue(void* user, lr_task_fn run, void* task, uint32_t count) {
    ((Host*)user)->jobs++;
    run(task, 0, count);
    return NULL;
}

static void finish(void* user, void* token) {
    (void)user, (void)token;
}

static void message(void* user, int32_t level, const char* text) {
    EXPECT(level >= LR_LOG_ERROR && level <= LR_LOG_INFO && text != NULL);
    ((Host*)user)->messages++;
}

static void fault(void* user, uint32_t number, const char* where, const char* what, const char* remedy) {
    EXPECT(number > 0 && where && what && remedy);
    ((Host*)user)->faults++;
}

static void wind(void* user, const lr_wind_query* query) {
    uint32_t i;
    if (query->struct_size < sizeof *query) return; /* counted below */
    ((Host*)user)->wind_calls++;
    for (i = 0; i < query->count; ++i) {
        query->velocity[0][i] = 0.5f + 0.01f * query->position[1][i];
        query->gradient[1][i] = 0.01f;
        query->rate[0][i] = 0.0f;
    }
}

static void surface(void* user, const lr_surface_query* query) {
    uint32_t i;
    if (query->struct_size < sizeof *query) return;
    ((Host*)user)->surface_calls++;
    for (i = 0; i < query->count; ++i) query->height[i] += 0.01f;
}

/* --- areas -------------------------------------------------------------------------------------------------------- */

static lr_asset* load(const char* path, Host* host) {
    lr_asset *from_file = NULL, *from_memory = NULL;
    unsigned char bytes[65536];
    size_t size = 0;
    FILE* const file = fopen(path, "rb");
    GUARDED(lr_asset_info, a);
    GUARDED(lr_asset_info, b);
    if (file) size = fread(bytes, 1, sizeof bytes, file), fclose(file);
    OK(lr_asset_load_file(path, &from_file));
    OK(lr_asset_load_memory(bytes, size, &from_memory));
    OK(lr_asset_check_memory(bytes, size, fault, host));
    EXPECT(host->faults == 0);
    OK(lr_asset_info_init(&a.value, sizeof a.value));
    OK(lr_asset_info_init(&b.value, sizeof b.value));
    OK(lr_asset_get_info(from_file, &a.value));
    OK(lr_asset_get_info(from_memory, &b.value));
    UNTOUCHED(a);
    UNTOUCHED(b);
    EXPECT(a.value.content_hash == b.value.content_hash && a.value.mass > 0.0 && a.value.added_mass[14] > 0.0);
    lr_asset_release(from_memory);
    bytes[size / 2] ^= 1;
    EXPECT(lr_asset_check_memory(bytes, size, fault, host) == LR_ERROR_ASSET_CORRUPT && host->faults > 0);
    EXPECT(lr_asset_load_memory(bytes, size, &from_memory) == LR_ERROR_ASSET_CORRUPT && from_memory == NULL);
    EXPECT(lr_asset_load_file("no such file.lrb", &from_memory) == LR_ERROR_FILE_NOT_FOUND);
    OK(lr_asset_retain(from_file));
    lr_asset_release(from_file);
    return from_file;
}

static lr_asset* make_card(void) {
    lr_asset *ellipsoid = NULL, *card = NULL;
    INITIALISED(lr_ellipsoid_desc, e);
    INITIALISED(lr_rigid_desc, r);
    INITIALISED(lr_aerodynamics, a);
    e.value.semi_axes[0] = 0.03, e.value.semi_axes[1] = 0.0005, e.value.semi_axes[2] = 0.02;
    e.value.density = 400.0;
    OK(lr_asset_create_ellipsoid(&e.value, &ellipsoid));
    OK(lr_asset_get_aerodynamics(ellipsoid, &a.value));
    UNTOUCHED(a);
    lr_asset_release(ellipsoid);
    r.value.mass = 0.01, r.value.volume = 2e-5;
    r.value.inertia[0] = 1e-5, r.value.inertia[4] = 4e-5, r.value.inertia[8] = 5e-5;
    r.value.added_mass[14] = 1e-3, r.value.added_mass[21] = 1e-7, r.value.added_mass[28] = 3e-7;
    r.value.extents[0] = 0.2, r.value.extents[1] = 0.1, r.value.extents[2] = 0.001;
    r.value.aerodynamics = &a.value;
    OK(lr_asset_create_rigid(&r.value, &card));
    return card;
}

static lr_world* make_world(Host* host) {
    lr_world* world = NULL;
    INITIALISED(lr_world_desc, d);
    EXPECT(d.value.gravity[1] == -9.81f && d.value.allocator.allocate == NULL);
    d.value.seed = 7;
    d.value.worker_count = 2;
    d.value.allocator.user = d.value.log_user = d.value.jobs.user = host;
    d.value.allocator.allocate = take, d.value.allocator.release = give_back;
    d.value.log = message;
    d.value.jobs.enqueue = enqueue, d.value.jobs.finish = finish;
    OK(lr_world_create(&d.value, &world));
    return world;
}

static void blow(lr_world* world, Host* host) {
    lr_wind_source source = 0;
    float place[3] = {0.0f, 2.0f, 0.0f}, velocity[3] = {0.0f, 0.0f, 0.0f};
    INITIALISED(lr_wind_desc, w);
    INITIALISED(lr_wind_source_desc, s);
    INITIALISED(lr_surface_desc, l);
    w.value.velocity[0] = 2.0f;
    OK(lr_world_set_wind(world, &w.value));
    s.value.kind = LR_WIND_SOURCE_RANKINE;
    OK(lr_world_add_wind(world, &s.value, &source));
    s.value.position[0] = 1.0f;
    OK(lr_world_update_wind(world, source, &s.value));
    OK(lr_world_sample_wind(world, place, 1, velocity));
    EXPECT(isfinite(velocity[0]) && velocity[0] > 1.0f);
    OK(lr_world_remove_wind(world, source));
    EXPECT(lr_world_remove_wind(world, source) == LR_ERROR_STALE_WIND_SOURCE);
    OK(lr_world_set_wind_callback(world, wind, host));
    l.value.position[1] = 0.3f;
    l.value.wave_count = 1;
    l.value.waves[0].direction[0] = 1.0f, l.value.waves[0].length = 4.0f, l.value.waves[0].amplitude = 0.1f;
    l.value.reach = 1.0f;
    OK(lr_world_set_surface(world, &l.value));
    OK(lr_world_set_surface_callback(world, surface, host));
}

static void settle_batch(lr_world* world, lr_batch leaves, lr_batch cards) {
    const float chi[2] = {2.0f, 1.0f}, epsilon[2] = {0.02f, 0.01f};
    int32_t meet = -1;
    INITIALISED(lr_turbulence_table, t);
    INITIALISED(lr_load_gains, g);
    INITIALISED(lr_batch_rate, r);
    INITIALISED(lr_batch_force, f);
    INITIALISED(lr_batch_contact, c);
    INITIALISED(lr_batch_rules, u);
    INITIALISED(lr_emitter_desc, e);
    INITIALISED(lr_aerodynamics, a);
    t.value.count = 2, t.value.chi = chi, t.value.epsilon = epsilon;
    t.value.dt = 0.1f, t.value.u0 = 1.0f, t.value.l = 0.02f;
    OK(lr_batch_set_turbulence_table(world, leaves, &t.value));
    g.value.lift = 0.9f;
    OK(lr_batch_set_load_gains(world, leaves, &g.value));
    r.value.divisor = 2;
    OK(lr_batch_set_rate(world, cards, &r.value));
    f.value.acceleration[2] = 0.1f;
    OK(lr_batch_set_force(world, leaves, &f.value));
    c.value.friction = 0.7f;
    OK(lr_batch_set_contact(world, leaves, &c.value));
    c.value.friction = 0.0f;
    OK(lr_batch_get_contact(world, leaves, &c.value));
    UNTOUCHED(c);
    EXPECT(c.value.friction == 0.7f);
    OK(lr_batch_set_pair_contact(world, leaves, leaves, 1));
    OK(lr_batch_get_pair_contact(world, leaves, leaves, &meet));
    EXPECT(meet == 1);
    OK(lr_batch_get_aerodynamics(world, cards, &a.value));
    UNTOUCHED(a);
    OK(lr_batch_set_aerodynamics(world, cards, &a.value));
    e.value.shape = LR_EMIT_SPHERE, e.value.position[1] = 3.0f;
    e.value.size[0] = e.value.size[1] = e.value.size[2] = 1.0f;
    e.value.rate = 60.0f;
    OK(lr_batch_set_emitter(world, leaves, &e.value));
    u.value.action = LR_END_RESPAWN;
    u.value.max_age = 1.5f;
    u.value.volume_count = 1;
    u.value.volumes[0].shape = LR_VOLUME_SPHERE, u.value.volumes[0].side = LR_KILL_OUTSIDE;
    u.value.volumes[0].size[0] = 1000.0f;
    OK(lr_batch_set_rules(world, leaves, &u.value));
    OK(lr_batch_emit(world, leaves, 20, NULL));
}

static lr_collider stand(lr_world* world) {
    lr_collider ids[2] = {0, 0};
    lr_collider_desc two[2];
    INITIALISED(lr_collider_motion, m);
    INITIALISED(lr_collider_state, s);
    INITIALISED(lr_collider_surface, f);
    OK(lr_collider_desc_init(&two[0], sizeof two[0]));
    OK(lr_collider_desc_init(&two[1], sizeof two[1]));
    two[0].kind = LR_COLLIDER_PLANE;
    two[1].kind = LR_COLLIDER_BOX;
    two[1].size[0] = two[1].size[1] = two[1].size[2] = 0.5f;
    two[1].position[0] = 5.0f;
    OK(lr_collider_create(world, two, 2, ids));
    m.value.collider = ids[1];
    m.value.mode = LR_MOVE_PLACE;
    m.value.position[0] = 6.0f;
    OK(lr_collider_move(world, &m.value, 1));
    f.value.friction = 0.3f;
    OK(lr_collider_set_surface(world, ids, 2, &f.value));
    OK(lr_collider_get_state(world, ids[1], &s.value));
    UNTOUCHED(s);
    EXPECT(s.value.position[0] == 6.0f && s.value.friction == 0.3f && s.value.kind == LR_COLLIDER_BOX);
    OK(lr_collider_destroy(world, &ids[1], 1));
    EXPECT(lr_collider_get_state(world, ids[1], &s.value) == LR_ERROR_STALE_COLLIDER);
    return ids[0];
}

static void push(lr_world* world, lr_batch cards, const lr_body* bodies) {
    const float low[3] = {-1.0f, -1.0f, -1.0f}, high[3] = {1.0f, 10.0f, 1.0f};
    const float lift[2] = {0.001f, 0.001f};
    uint32_t woken = 0;
    lr_body_force forces[2];
    INITIALISED(lr_force_arrays, a);
    INITIALISED(lr_body_state, s);
    OK(lr_body_force_init(&forces[0], sizeof forces[0]));
    OK(lr_body_force_init(&forces[1], sizeof forces[1]));
    forces[0].body = bodies[0], forces[0].mode = LR_FORCE_MODE_VELOCITY, forces[0].force[1] = 1.0f;
    forces[1].body = bodies[1], forces[1].mode = LR_FORCE_MODE_IMPULSE, forces[1].force[0] = 0.001f;
    OK(lr_body_add_force(world, forces, 2));
    a.value.count = 2;
    a.value.force[0] = a.value.force[1] = a.value.force[2] = lift;
    OK(lr_batch_add_forces(world, cards, &a.value));
    OK(lr_body_get_state(world, bodies[0], &s.value));
    UNTOUCHED(s);
    EXPECT(s.value.linear_velocity[1] == 1.0f && s.value.resting == LR_REST_AWAKE);
    s.value.position[1] = 4.0f;
    OK(lr_body_set_state(world, bodies[0], &s.value));
    OK(lr_body_set_rest(world, bodies, 2, LR_REST_RESTING));
    OK(lr_body_get_state(world, bodies[1], &s.value));
    EXPECT(s.value.resting == LR_REST_RESTING);
    OK(lr_world_wake_box(world, low, high, &woken));
    EXPECT(woken == 2);
}

static void look(lr_world* world, lr_batch leaves, lr_batch cards, lr_collider ground) {
    static float matrices[256][16];
    lr_ray rays[2];
    lr_ray_hit hits[2];
    lr_body inside[256];
    uint32_t written = 0, first = 0, within = 0;
    uint32_t i;
    GUARDED(lr_batch_view, v);
    INITIALISED(lr_batch_events, e);
    INITIALISED(lr_batch_pace, p);
    INITIALISED(lr_contact_event_list, l);
    INITIALISED(lr_step_report, r);
    INITIALISED(lr_world_info, n);
    INITIALISED(lr_overlap_desc, o);
    OK(lr_batch_view_init(&v.value, sizeof v.value));
    OK(lr_batch_get_view(world, leaves, &v.value));
    UNTOUCHED(v);
    EXPECT(v.value.count > 20 && v.value.awake_count <= v.value.count && v.value.capacity == 256);
    OK(lr_batch_write_transforms(world, leaves, LR_TRANSFORM_4X4_COLUMN_MAJOR, matrices, 0, 256, &written));
    EXPECT(written == v.value.count);
    for (i = 0; i < written; ++i) EXPECT(matrices[i][13] == v.value.position[1][i] && matrices[i][15] == 1.0f);
    OK(lr_batch_write_first_transforms(world, leaves, LR_TRANSFORM_3X4_ROW_MAJOR, matrices, 0, 3, &first));
    EXPECT(first == 3);
    OK(lr_batch_get_events(world, leaves, &e.value));
    UNTOUCHED(e);
    EXPECT(e.value.total_born > 20 && e.value.total_respawned > 0);
    OK(lr_batch_get_pace(world, cards, &p.value));
    UNTOUCHED(p);
    EXPECT(p.value.divisor == 2 && p.value.body_substeps > 0);
    OK(lr_world_get_contact_events(world, &l.value));
    UNTOUCHED(l);
    EXPECT(l.value.events != NULL);
    OK(lr_world_get_step_report(world, &r.value));
    UNTOUCHED(r);
    EXPECT(r.value.body_substeps > 0);
    OK(lr_world_get_info(world, &n.value));
    UNTOUCHED(n);
    EXPECT(n.value.batch_count == 2 && n.value.collider_count == 1 && n.value.memory_bytes > 0 && n.value.time > 1.0);
    OK(lr_ray_init(&rays[0], sizeof rays[0]));
    OK(lr_ray_init(&rays[1], sizeof rays[1]));
    rays[0].origin[1] = rays[1].origin[1] = 100.0f, rays[0].origin[0] = 500.0f;
    rays[1].direction[1] = 1.0f;
    OK(lr_world_ray_cast(world, rays, 2, hits));
    EXPECT(hits[0].collider == ground && hits[0].normal[1] == 1.0f && hits[1].collider == 0 && hits[1].body == 0);
    o.value.size[0] = 1000.0f;
    OK(lr_world_overlap(world, &o.value, inside, 256, &within));
    EXPECT(within == n.value.body_count);
}

static void save_and_restore(lr_world* world) {
    uint64_t before = 0, after = 0, written = 0;
    const uint64_t size = lr_world_snapshot_size(world);
    void* const memory = malloc((size_t)size);
    EXPECT(size > 0 && memory != NULL);
    OK(lr_world_snapshot_save(world, memory, size, &written));
    EXPECT(written <= size);
    OK(lr_world_hash(world, &before));
    OK(lr_world_step(world, 1.0f / 60.0f, 2));
    OK(lr_world_snapshot_restore(world, memory, written));
    OK(lr_world_hash(world, &after));
    EXPECT(before == after);
    ((unsigned char*)memory)[written / 2] ^= 1;
    EXPECT(lr_world_snapshot_restore(world, memory, written) == LR_ERROR_SNAPSHOT_FORMAT);
    free(memory);
}

static uint64_t play(const char* path) {
    const float gravity[3] = {0.0f, -9.8f, 0.0f};
    Host host = {0, 0, 0, 0, 0, 0};
    int32_t targets[16];
    uint32_t target_count = 0;
    uint64_t hash = 0;
    int frame;
    lr_batch leaves = 0, cards = 0;
    lr_body bodies[2] = {0, 0};
    lr_body_desc descs[2];
    lr_collider ground = 0;
    lr_asset *const leaf = load(path, &host), *const card = make_card();
    lr_world* const world = make_world(&host);
    INITIALISED(lr_batch_desc, b);
    INITIALISED(lr_budget, u);
    if (!leaf || !card || !world) return 0;
    b.value.asset = leaf, b.value.capacity = 256;
    OK(lr_batch_create(world, &b.value, &leaves));
    b.value.asset = card, b.value.load_model = LR_LOADS_LANGEVIN;
    OK(lr_batch_create(world, &b.value, &cards));
    blow(world, &host);
    settle_batch(world, leaves, cards);
    ground = stand(world);
    OK(lr_body_desc_init(&descs[0], sizeof descs[0]));
    OK(lr_body_desc_init(&descs[1], sizeof descs[1]));
    descs[0].position[1] = 3.0f, descs[1].position[1] = 2.0f, descs[1].key = 99;
    OK(lr_body_create(world, cards, descs, 2, bodies));
    push(world, cards, bodies);
    OK(lr_world_set_gravity(world, gravity));
    OK(lr_world_set_contact_events(world, 64, LR_EVENTS_ALL));
    u.value.kind = LR_BUDGET_BODY_SUBSTEPS, u.value.body_substeps = 1000000;
    OK(lr_world_set_budget(world, &u.value));
    OK(lr_simd_targets(targets, 16, &target_count));
    for (frame = 0; frame < 120; ++frame) {
        OK(lr_world_set_simd_target(world, targets[(uint32_t)frame % target_count]));
        OK(lr_world_step(world, 1.0f / 60.0f, 2));
    }
    look(world, leaves, cards, ground);
    save_and_restore(world);
    EXPECT(host.wind_calls > 0 && host.surface_calls > 0 && host.messages > 0 && host.blocks > 0);
    OK(lr_body_destroy(world, bodies, 2));
    EXPECT(lr_body_destroy(world, bodies, 2) == LR_ERROR_STALE_BODY);
    OK(lr_world_hash(world, &hash));
    OK(lr_batch_destroy(world, cards));
    EXPECT(lr_batch_destroy(world, cards) == LR_ERROR_STALE_BATCH);
    lr_world_destroy(world);
    lr_asset_release(leaf);
    lr_asset_release(card);
    EXPECT(host.blocks == 0);
    return hash;
}

int main(int count, char** arguments) {
    const uint32_t version = lr_version(), mine = (uint32_t)LR_VERSION_MAJOR << 22 | (uint32_t)LR_VERSION_MINOR << 12;
    uint64_t first, again;
    if (count != 2) return 2;
    EXPECT(version >= mine && version >> 22 == LR_VERSION_MAJOR);
    EXPECT(strcmp(lr_status_string(LR_OK), lr_status_string(12345)) != 0);
    EXPECT(strcmp(lr_simd_target_name(LR_SIMD_AVX2), "AVX2") == 0);
    first = play(arguments[1]);
    again = play(arguments[1]);
    EXPECT(first != 0 && first == again);
    printf("program of 0.1 with a library %u.%u.%u: %d checks, %d failed\n", (unsigned)(version >> 22),
           (unsigned)(version >> 12 & 1023), (unsigned)(version & 4095), checks, failures);
    return failures != 0;
}
