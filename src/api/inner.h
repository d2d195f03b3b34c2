// What the exported functions that take a world do once they may: the same names and arguments. Callers come in by
// api/entry.h alone.
#pragma once

#include "langevin_rigid.h"

extern "C" {

lr_status lr_inner_world_get_info(const lr_world* world, lr_world_info* info);
lr_status lr_inner_world_set_gravity(lr_world* world, const float* gravity);
lr_status lr_inner_world_set_simd_target(lr_world* world, int32_t target);
lr_status lr_inner_world_set_wind(lr_world* world, const lr_wind_desc* desc);
lr_status lr_inner_world_add_wind(lr_world* world, const lr_wind_source_desc* desc, lr_wind_source* out);
lr_status lr_inner_world_update_wind(lr_world* world, lr_wind_source source, const lr_wind_source_desc* desc);
lr_status lr_inner_world_remove_wind(lr_world* world, lr_wind_source source);
lr_status lr_inner_world_set_wind_callback(lr_world* world, lr_wind_fn callback, void* user);
lr_status lr_inner_world_sample_wind(const lr_world* world, const float* positions, uint32_t count, float* velocities);
lr_status lr_inner_world_set_surface(lr_world* world, const lr_surface_desc* desc);
lr_status lr_inner_world_set_surface_callback(lr_world* world, lr_surface_fn callback, void* user);
lr_status lr_inner_world_step(lr_world* world, float dt, uint32_t substeps);
lr_status lr_inner_world_set_budget(lr_world* world, uint64_t body_substeps);
lr_status lr_inner_world_get_step_report(const lr_world* world, lr_step_report* report);
lr_status lr_inner_world_hash(const lr_world* world, uint64_t* out);
uint64_t lr_inner_world_snapshot_size(const lr_world* world);
lr_status lr_inner_world_snapshot_save(const lr_world* world, void* memory, uint64_t size, uint64_t* written);
lr_status lr_inner_world_snapshot_restore(lr_world* world, const void* memory, uint64_t size);
lr_status lr_inner_batch_create(lr_world* world, const lr_batch_desc* desc, lr_batch* out);
lr_status lr_inner_batch_destroy(lr_world* world, lr_batch batch);
lr_status lr_inner_batch_set_turbulence_table(lr_world* world, lr_batch batch, const lr_turbulence_table* table);
lr_status lr_inner_batch_set_aerodynamics(lr_world* world, lr_batch batch, const lr_aerodynamics* aerodynamics);
lr_status lr_inner_batch_get_aerodynamics(const lr_world* world, lr_batch batch, lr_aerodynamics* aerodynamics);
lr_status lr_inner_batch_set_load_gains(lr_world* world, lr_batch batch, const lr_load_gains* gains);
lr_status lr_inner_batch_set_rate(lr_world* world, lr_batch batch, uint32_t divisor);
lr_status lr_inner_batch_get_pace(const lr_world* world, lr_batch batch, lr_batch_pace* pace);
lr_status lr_inner_batch_get_view(const lr_world* world, lr_batch batch, lr_batch_view* view);
lr_status lr_inner_batch_write_transforms(const lr_world* world, lr_batch batch, int32_t format, void* dst,
                                          uint64_t stride, uint32_t count, uint32_t* written);
lr_status lr_inner_body_create(lr_world* world, lr_batch batch, const lr_body_desc* descs, uint32_t count,
                               lr_body* out_ids);
lr_status lr_inner_body_destroy(lr_world* world, const lr_body* bodies, uint32_t count);
lr_status lr_inner_body_get_state(const lr_world* world, lr_body body, lr_body_state* state);
lr_status lr_inner_body_set_state(lr_world* world, lr_body body, const lr_body_state* state);
lr_status lr_inner_body_set_rest(lr_world* world, const lr_body* bodies, uint32_t count, int32_t rest);
lr_status lr_inner_world_wake_box(lr_world* world, const float* low, const float* high, uint32_t* woken);
lr_status lr_inner_body_add_force(lr_world* world, const lr_body_force* forces, uint32_t count);
lr_status lr_inner_batch_add_forces(lr_world* world, lr_batch batch, const lr_force_arrays* arrays);
lr_status lr_inner_batch_set_force(lr_world* world, lr_batch batch, const lr_batch_force* force);
lr_status lr_inner_collider_create(lr_world* world, const lr_collider_desc* descs, uint32_t count,
                                   lr_collider* out_ids);
lr_status lr_inner_collider_destroy(lr_world* world, const lr_collider* colliders, uint32_t count);
lr_status lr_inner_collider_move(lr_world* world, const lr_collider_motion* motions, uint32_t count);
lr_status lr_inner_collider_get_state(const lr_world* world, lr_collider collider, lr_collider_state* state);
lr_status lr_inner_collider_set_surface(lr_world* world, const lr_collider* colliders, uint32_t count,
                                        const lr_collider_surface* surface);
lr_status lr_inner_batch_set_contact(lr_world* world, lr_batch batch, const lr_batch_contact* contact);
lr_status lr_inner_batch_get_contact(const lr_world* world, lr_batch batch, lr_batch_contact* contact);
lr_status lr_inner_batch_set_pair_contact(lr_world* world, lr_batch a, lr_batch b, int32_t enabled);
lr_status lr_inner_batch_get_pair_contact(const lr_world* world, lr_batch a, lr_batch b, int32_t* enabled);
lr_status lr_inner_world_set_contact_events(lr_world* world, uint32_t capacity, uint32_t kinds);
lr_status lr_inner_world_get_contact_events(const lr_world* world, lr_contact_event_list* list);
lr_status lr_inner_world_ray_cast(const lr_world* world, const lr_ray* rays, uint32_t count, lr_ray_hit* hits);
lr_status lr_inner_world_overlap(const lr_world* world, const lr_overlap_desc* desc, lr_body* bodies, uint32_t capacity,
                                 uint32_t* count);
lr_status lr_inner_batch_set_rules(lr_world* world, lr_batch batch, const lr_batch_rules* rules);
lr_status lr_inner_batch_set_fault_policy(lr_world* world, lr_batch batch, int32_t policy);
lr_status lr_inner_batch_get_fault_policy(const lr_world* world, lr_batch batch, int32_t* policy);
lr_status lr_inner_batch_set_emitter(lr_world* world, lr_batch batch, const lr_emitter_desc* desc);
lr_status lr_inner_batch_emit(lr_world* world, lr_batch batch, uint32_t count, lr_body* out_ids);
lr_status lr_inner_batch_get_events(const lr_world* world, lr_batch batch, lr_batch_events* events);

} // extern "C"
