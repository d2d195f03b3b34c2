/*
 * SPDX-License-Identifier: MIT
 *
 * A program of version 0.2. It must compile with every later header of the same soname, link with every later library, and mean the
 * same: each function has the type that it had, and a leaf baked by 0.2 falls.
 *   program leaf.lrb
 */
#include "langevin_rigid_research.h"

#include <stdio.h>

/* clang-format off */
uint32_t (*const p_version)(void) = lr_version;
const char* (*const p_status_string)(lr_status status) = lr_status_string;
const char* (*const p_last_error)(void) = lr_last_error;
lr_status (*const p_simd_targets)(lr_simd_target* targets, uint32_t capacity, uint32_t* count) = lr_simd_targets;
const char* (*const p_simd_target_name)(lr_simd_target target) = lr_simd_target_name;
lr_status (*const p_asset_load_file)(const char* path_utf8, lr_asset** out) = lr_asset_load_file;
lr_status (*const p_asset_load_memory)(const void* bytes, uint64_t size, lr_asset** out) = lr_asset_load_memory;
lr_status (*const p_asset_check_memory)(const void* bytes, uint64_t size, lr_fault_fn report, void* user) = lr_asset_check_memory;
lr_status (*const p_ellipsoid_desc_init)(lr_ellipsoid_desc* desc, uint32_t struct_size) = lr_ellipsoid_desc_init;
lr_status (*const p_asset_create_ellipsoid)(const lr_ellipsoid_desc* desc, lr_asset** out) = lr_asset_create_ellipsoid;
lr_status (*const p_asset_retain)(lr_asset* asset) = lr_asset_retain;
void (*const p_asset_release)(lr_asset* asset) = lr_asset_release;
lr_status (*const p_asset_info_init)(lr_asset_info* info, uint32_t struct_size) = lr_asset_info_init;
lr_status (*const p_asset_get_info)(const lr_asset* asset, lr_asset_info* info) = lr_asset_get_info;
lr_status (*const p_world_desc_init)(lr_world_desc* desc, uint32_t struct_size) = lr_world_desc_init;
lr_status (*const p_world_create)(const lr_world_desc* desc, lr_world** out) = lr_world_create;
void (*const p_world_destroy)(lr_world* world) = lr_world_destroy;
lr_status (*const p_world_info_init)(lr_world_info* info, uint32_t struct_size) = lr_world_info_init;
lr_status (*const p_world_get_info)(const lr_world* world, lr_world_info* info) = lr_world_get_info;
lr_status (*const p_world_set_gravity)(lr_world* world, const float* gravity) = lr_world_set_gravity;
lr_status (*const p_world_set_simd_target)(lr_world* world, lr_simd_target target) = lr_world_set_simd_target;
lr_status (*const p_world_set_uniform_wind)(lr_world* world, float x, float y, float z) = lr_world_set_uniform_wind;
lr_status (*const p_world_get_uniform_wind)(const lr_world* world, float* velocity) = lr_world_get_uniform_wind;
lr_status (*const p_gusts_desc_init)(lr_gusts_desc* desc, uint32_t struct_size) = lr_gusts_desc_init;
lr_status (*const p_world_add_gusts)(lr_world* world, const lr_gusts_desc* desc, lr_wind_source* out) = lr_world_add_gusts;
lr_status (*const p_world_update_gusts)(lr_world* world, lr_wind_source source, const lr_gusts_desc* desc) = lr_world_update_gusts;
lr_status (*const p_world_get_gusts)(const lr_world* world, lr_wind_source source, lr_gusts_desc* desc) = lr_world_get_gusts;
lr_status (*const p_vortex_desc_init)(lr_vortex_desc* desc, uint32_t struct_size) = lr_vortex_desc_init;
lr_status (*const p_world_add_vortex)(lr_world* world, const lr_vortex_desc* desc, lr_wind_source* out) = lr_world_add_vortex;
lr_status (*const p_world_update_vortex)(lr_world* world, lr_wind_source source, const lr_vortex_desc* desc) = lr_world_update_vortex;
lr_status (*const p_world_get_vortex)(const lr_world* world, lr_wind_source source, lr_vortex_desc* desc) = lr_world_get_vortex;
lr_status (*const p_blower_desc_init)(lr_blower_desc* desc, uint32_t struct_size) = lr_blower_desc_init;
lr_status (*const p_world_add_blower)(lr_world* world, const lr_blower_desc* desc, lr_wind_source* out) = lr_world_add_blower;
lr_status (*const p_world_update_blower)(lr_world* world, lr_wind_source source, const lr_blower_desc* desc) = lr_world_update_blower;
lr_status (*const p_world_get_blower)(const lr_world* world, lr_wind_source source, lr_blower_desc* desc) = lr_world_get_blower;
lr_status (*const p_turbulence_desc_init)(lr_turbulence_desc* desc, uint32_t struct_size) = lr_turbulence_desc_init;
lr_status (*const p_world_add_turbulence)(lr_world* world, const lr_turbulence_desc* desc, lr_wind_source* out) = lr_world_add_turbulence;
lr_status (*const p_world_update_turbulence)(lr_world* world, lr_wind_source source, const lr_turbulence_desc* desc) = lr_world_update_turbulence;
lr_status (*const p_world_get_turbulence)(const lr_world* world, lr_wind_source source, lr_turbulence_desc* desc) = lr_world_get_turbulence;
lr_status (*const p_wind_grid_desc_init)(lr_wind_grid_desc* desc, uint32_t struct_size) = lr_wind_grid_desc_init;
lr_status (*const p_world_add_wind_grid)(lr_world* world, const lr_wind_grid_desc* desc, lr_wind_source* out) = lr_world_add_wind_grid;
lr_status (*const p_world_update_wind_grid)(lr_world* world, lr_wind_source source, const lr_wind_grid_desc* desc) = lr_world_update_wind_grid;
lr_status (*const p_world_get_wind_grid)(const lr_world* world, lr_wind_source source, lr_wind_grid_desc* desc) = lr_world_get_wind_grid;
lr_status (*const p_ground_wind_desc_init)(lr_ground_wind_desc* desc, uint32_t struct_size) = lr_ground_wind_desc_init;
lr_status (*const p_world_add_ground_wind)(lr_world* world, const lr_ground_wind_desc* desc, lr_wind_source* out) = lr_world_add_ground_wind;
lr_status (*const p_world_update_ground_wind)(lr_world* world, lr_wind_source source, const lr_ground_wind_desc* desc) = lr_world_update_ground_wind;
lr_status (*const p_world_get_ground_wind)(const lr_world* world, lr_wind_source source, lr_ground_wind_desc* desc) = lr_world_get_ground_wind;
lr_status (*const p_world_remove_wind)(lr_world* world, lr_wind_source source) = lr_world_remove_wind;
int32_t (*const p_wind_source_is_valid)(const lr_world* world, lr_wind_source source) = lr_wind_source_is_valid;
lr_status (*const p_world_set_wind_callback)(lr_world* world, lr_wind_fn callback, void* user) = lr_world_set_wind_callback;
lr_status (*const p_world_sample_wind)(const lr_world* world, const float* positions, uint32_t count, float* velocities) = lr_world_sample_wind;
lr_status (*const p_water_desc_init)(lr_water_desc* desc, uint32_t struct_size) = lr_water_desc_init;
lr_status (*const p_world_set_water)(lr_world* world, const lr_water_desc* desc) = lr_world_set_water;
lr_status (*const p_world_get_water)(const lr_world* world, lr_water_desc* desc, int32_t* present) = lr_world_get_water;
lr_status (*const p_world_set_water_callback)(lr_world* world, lr_water_fn callback, void* user) = lr_world_set_water_callback;
lr_status (*const p_world_step)(lr_world* world, float dt, uint32_t substeps) = lr_world_step;
lr_status (*const p_world_set_budget)(lr_world* world, uint64_t body_substeps) = lr_world_set_budget;
lr_status (*const p_step_report_init)(lr_step_report* report, uint32_t struct_size) = lr_step_report_init;
lr_status (*const p_world_get_step_report)(const lr_world* world, lr_step_report* report) = lr_world_get_step_report;
lr_status (*const p_timings_init)(lr_timings* timings, uint32_t struct_size) = lr_timings_init;
lr_status (*const p_world_get_timings)(const lr_world* world, lr_timings* timings) = lr_world_get_timings;
lr_status (*const p_world_hash)(const lr_world* world, uint64_t* out) = lr_world_hash;
uint64_t (*const p_world_snapshot_size)(const lr_world* world) = lr_world_snapshot_size;
lr_status (*const p_world_snapshot_save)(const lr_world* world, void* memory, uint64_t size, uint64_t* written) = lr_world_snapshot_save;
lr_status (*const p_world_snapshot_restore)(lr_world* world, const void* memory, uint64_t size) = lr_world_snapshot_restore;
lr_status (*const p_recording_desc_init)(lr_recording_desc* desc, uint32_t struct_size) = lr_recording_desc_init;
lr_status (*const p_world_record_start)(lr_world* world, const lr_recording_desc* desc) = lr_world_record_start;
lr_status (*const p_world_record_stop)(lr_world* world) = lr_world_record_stop;
lr_status (*const p_batch_desc_init)(lr_batch_desc* desc, uint32_t struct_size) = lr_batch_desc_init;
lr_status (*const p_batch_create)(lr_world* world, const lr_batch_desc* desc, lr_batch* out) = lr_batch_create;
lr_status (*const p_batch_destroy)(lr_world* world, lr_batch batch) = lr_batch_destroy;
int32_t (*const p_batch_is_valid)(const lr_world* world, lr_batch batch) = lr_batch_is_valid;
lr_status (*const p_load_gains_init)(lr_load_gains* gains, uint32_t struct_size) = lr_load_gains_init;
lr_status (*const p_batch_set_load_gains)(lr_world* world, lr_batch batch, const lr_load_gains* gains) = lr_batch_set_load_gains;
lr_status (*const p_batch_get_load_gains)(const lr_world* world, lr_batch batch, lr_load_gains* gains) = lr_batch_get_load_gains;
lr_status (*const p_batch_set_rate)(lr_world* world, lr_batch batch, uint32_t divisor) = lr_batch_set_rate;
lr_status (*const p_batch_pace_init)(lr_batch_pace* pace, uint32_t struct_size) = lr_batch_pace_init;
lr_status (*const p_batch_get_pace)(const lr_world* world, lr_batch batch, lr_batch_pace* pace) = lr_batch_get_pace;
lr_status (*const p_batch_view_init)(lr_batch_view* view, uint32_t struct_size) = lr_batch_view_init;
lr_status (*const p_batch_get_view)(const lr_world* world, lr_batch batch, lr_batch_view* view) = lr_batch_get_view;
lr_status (*const p_batch_get_bounds)(const lr_world* world, lr_batch batch, float* low, float* high) = lr_batch_get_bounds;
lr_status (*const p_batch_write_transforms)(const lr_world* world, lr_batch batch, lr_transform_format format, void* dst, uint64_t stride, uint32_t count, uint32_t* written) = lr_batch_write_transforms;
lr_status (*const p_batch_write_velocities)(const lr_world* world, lr_batch batch, void* dst, uint64_t stride, uint32_t count, uint32_t* written) = lr_batch_write_velocities;
lr_status (*const p_body_desc_init)(lr_body_desc* desc, uint32_t struct_size) = lr_body_desc_init;
lr_status (*const p_body_create)(lr_world* world, lr_batch batch, const lr_body_desc* descs, uint32_t count, lr_body* out_ids) = lr_body_create;
lr_status (*const p_body_destroy)(lr_world* world, const lr_body* bodies, uint32_t count) = lr_body_destroy;
int32_t (*const p_body_is_valid)(const lr_world* world, lr_body body) = lr_body_is_valid;
lr_status (*const p_body_state_init)(lr_body_state* state, uint32_t struct_size) = lr_body_state_init;
lr_status (*const p_body_get_state)(const lr_world* world, lr_body body, lr_body_state* state) = lr_body_get_state;
lr_status (*const p_body_set_state)(lr_world* world, lr_body body, const lr_body_state* state) = lr_body_set_state;
lr_status (*const p_body_set_sleep)(lr_world* world, const lr_body* bodies, uint32_t count, lr_sleep_state sleep_state) = lr_body_set_sleep;
lr_status (*const p_world_wake_box)(lr_world* world, const float* low, const float* high, uint32_t* woken) = lr_world_wake_box;
lr_status (*const p_body_force_init)(lr_body_force* force, uint32_t struct_size) = lr_body_force_init;
lr_status (*const p_body_add_force)(lr_world* world, const lr_body_force* forces, uint32_t count) = lr_body_add_force;
lr_status (*const p_force_arrays_init)(lr_force_arrays* arrays, uint32_t struct_size) = lr_force_arrays_init;
lr_status (*const p_batch_add_forces)(lr_world* world, lr_batch batch, const lr_force_arrays* arrays) = lr_batch_add_forces;
lr_status (*const p_batch_force_init)(lr_batch_force* force, uint32_t struct_size) = lr_batch_force_init;
lr_status (*const p_batch_set_force)(lr_world* world, lr_batch batch, const lr_batch_force* force) = lr_batch_set_force;
lr_status (*const p_batch_get_force)(const lr_world* world, lr_batch batch, lr_batch_force* force) = lr_batch_get_force;
lr_status (*const p_collider_desc_init)(lr_collider_desc* desc, uint32_t struct_size) = lr_collider_desc_init;
lr_status (*const p_collider_create)(lr_world* world, const lr_collider_desc* descs, uint32_t count, lr_collider* out_ids) = lr_collider_create;
lr_status (*const p_collider_destroy)(lr_world* world, const lr_collider* colliders, uint32_t count) = lr_collider_destroy;
int32_t (*const p_collider_is_valid)(const lr_world* world, lr_collider collider) = lr_collider_is_valid;
lr_status (*const p_collider_motion_init)(lr_collider_motion* motion, uint32_t struct_size) = lr_collider_motion_init;
lr_status (*const p_collider_move)(lr_world* world, const lr_collider_motion* motions, uint32_t count) = lr_collider_move;
lr_status (*const p_collider_state_init)(lr_collider_state* state, uint32_t struct_size) = lr_collider_state_init;
lr_status (*const p_collider_get_state)(const lr_world* world, lr_collider collider, lr_collider_state* state) = lr_collider_get_state;
lr_status (*const p_material_init)(lr_material* material, uint32_t struct_size) = lr_material_init;
lr_status (*const p_collider_set_material)(lr_world* world, const lr_collider* colliders, uint32_t count, const lr_material* material) = lr_collider_set_material;
lr_status (*const p_batch_contact_init)(lr_batch_contact* contact, uint32_t struct_size) = lr_batch_contact_init;
lr_status (*const p_batch_set_contact)(lr_world* world, lr_batch batch, const lr_batch_contact* contact) = lr_batch_set_contact;
lr_status (*const p_batch_get_contact)(const lr_world* world, lr_batch batch, lr_batch_contact* contact) = lr_batch_get_contact;
lr_status (*const p_batch_set_body_contact)(lr_world* world, lr_batch a, lr_batch b, int32_t enabled) = lr_batch_set_body_contact;
lr_status (*const p_batch_get_body_contact)(const lr_world* world, lr_batch a, lr_batch b, int32_t* enabled) = lr_batch_get_body_contact;
lr_status (*const p_world_set_events)(lr_world* world, uint32_t capacity, lr_event_kinds kinds) = lr_world_set_events;
lr_status (*const p_event_list_init)(lr_event_list* list, uint32_t struct_size) = lr_event_list_init;
lr_status (*const p_world_get_events)(const lr_world* world, lr_event_list* list) = lr_world_get_events;
lr_status (*const p_ray_init)(lr_ray* ray, uint32_t struct_size) = lr_ray_init;
lr_status (*const p_world_ray_cast)(const lr_world* world, const lr_ray* rays, uint32_t count, lr_ray_hit* hits) = lr_world_ray_cast;
lr_status (*const p_overlap_desc_init)(lr_overlap_desc* desc, uint32_t struct_size) = lr_overlap_desc_init;
lr_status (*const p_world_overlap)(const lr_world* world, const lr_overlap_desc* desc, lr_body* bodies, uint32_t capacity, uint32_t* count) = lr_world_overlap;
lr_status (*const p_batch_rules_init)(lr_batch_rules* rules, uint32_t struct_size) = lr_batch_rules_init;
lr_status (*const p_batch_set_rules)(lr_world* world, lr_batch batch, const lr_batch_rules* rules) = lr_batch_set_rules;
lr_status (*const p_batch_get_rules)(const lr_world* world, lr_batch batch, lr_batch_rules* rules, int32_t* present) = lr_batch_get_rules;
lr_status (*const p_batch_set_divergence_policy)(lr_world* world, lr_batch batch, lr_divergence_policy policy) = lr_batch_set_divergence_policy;
lr_status (*const p_batch_get_divergence_policy)(const lr_world* world, lr_batch batch, lr_divergence_policy* policy) = lr_batch_get_divergence_policy;
lr_status (*const p_emitter_desc_init)(lr_emitter_desc* desc, uint32_t struct_size) = lr_emitter_desc_init;
lr_status (*const p_batch_set_emitter)(lr_world* world, lr_batch batch, const lr_emitter_desc* desc) = lr_batch_set_emitter;
lr_status (*const p_batch_get_emitter)(const lr_world* world, lr_batch batch, lr_emitter_desc* desc, int32_t* present) = lr_batch_get_emitter;
lr_status (*const p_batch_spawn)(lr_world* world, lr_batch batch, uint32_t count, lr_body* out_ids) = lr_batch_spawn;
lr_status (*const p_batch_spawn_box)(lr_world* world, lr_batch batch, const float* low, const float* high, uint32_t count, lr_body* out_ids) = lr_batch_spawn_box;
lr_status (*const p_batch_counts_init)(lr_batch_counts* counts, uint32_t struct_size) = lr_batch_counts_init;
lr_status (*const p_batch_get_counts)(const lr_world* world, lr_batch batch, lr_batch_counts* counts) = lr_batch_get_counts;
lr_status (*const p_aerodynamics_init)(lr_aerodynamics* aerodynamics, uint32_t struct_size) = lr_aerodynamics_init;
lr_status (*const p_asset_get_aerodynamics)(const lr_asset* asset, lr_aerodynamics* aerodynamics) = lr_asset_get_aerodynamics;
lr_status (*const p_batch_set_aerodynamics)(lr_world* world, lr_batch batch, const lr_aerodynamics* aerodynamics) = lr_batch_set_aerodynamics;
lr_status (*const p_batch_get_aerodynamics)(const lr_world* world, lr_batch batch, lr_aerodynamics* aerodynamics) = lr_batch_get_aerodynamics;
lr_status (*const p_rigid_desc_init)(lr_rigid_desc* desc, uint32_t struct_size) = lr_rigid_desc_init;
lr_status (*const p_asset_create_rigid)(const lr_rigid_desc* desc, lr_asset** out) = lr_asset_create_rigid;
lr_status (*const p_turbulence_table_init)(lr_turbulence_table* table, uint32_t struct_size) = lr_turbulence_table_init;
lr_status (*const p_batch_set_turbulence_table)(lr_world* world, lr_batch batch, const lr_turbulence_table* table) = lr_batch_set_turbulence_table;
lr_status (*const p_batch_get_turbulence_table)(const lr_world* world, lr_batch batch, lr_turbulence_table* table, float* chi, float* epsilon, uint32_t capacity) = lr_batch_get_turbulence_table;
/* clang-format on */

#define MUST(call)                                                                                                     \
    if ((call) != LR_OK) {                                                                                             \
        printf("%s: %s\n", #call, p_last_error());                                                                     \
        return 1;                                                                                                      \
    }

int main(int argc, char** argv) {
    lr_world_desc world_desc = LR_WORLD_DESC_INIT;
    lr_batch_desc batch_desc = LR_BATCH_DESC_INIT;
    lr_body_desc body_desc = LR_BODY_DESC_INIT;
    lr_body_state state = LR_BODY_STATE_INIT;
    lr_asset* asset = NULL;
    lr_world* world = NULL;
    lr_batch batch;
    lr_body body;
    int frame;
    if (argc != 2) return 2;
    MUST(p_asset_load_file(argv[1], &asset))
    MUST(p_world_create(&world_desc, &world))
    batch_desc.asset = asset;
    batch_desc.capacity = 10;
    MUST(p_batch_create(world, &batch_desc, &batch))
    body_desc.position[1] = 10.0f;
    body_desc.user = 7;
    MUST(p_body_create(world, batch, &body_desc, 1, &body))
    for (frame = 0; frame < 120; ++frame) MUST(p_world_step(world, 1.0f / 60.0f, 2))
    MUST(p_body_get_state(world, body, &state))
    printf("%.3f m after 2 s\n", (double)state.position[1]);
    p_world_destroy(world);
    p_asset_release(asset);
    return state.user == 7 && state.position[1] < 9.0f && state.position[1] > 5.0f ? 0 : 1;
}
