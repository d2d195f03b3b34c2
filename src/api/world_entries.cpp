// Exported functions of worlds: how calls come in.
#include "api/entry.h"
#include "field/wind_source.h"
#include "world/snapshot.h"

using namespace lr::api;

namespace {

void tell_source(Call& call, const lr_wind_source_desc* desc) {
    lr_wind_source_desc d{};
    if (!call.structure(desc, d)) return;
    const float* const samples = d.kind == LR_WIND_SOURCE_GRID ? d.samples : nullptr;
    call.shared_array(samples, samples ? sizeof(float) * lr::sample_count(d) : 0);
}

} // namespace

extern "C" {

void lr_world_destroy(lr_world* world) {
    if (!world) return;
    if (world->use.checked()) {
        // Kept until the end: whoever calls from another thread, or from the allocator, is told.
        if (lr::enter(*world, "lr_world_destroy") != LR_OK) return;
    }
    if (world->recorder) end_recording(*world, nullptr);
    lr_world::destroy(world);
}

lr_status lr_world_get_info(const lr_world* world, lr_world_info* info) {
    return plain_query(world, "lr_world_get_info", &lr_inner_world_get_info, info);
}

lr_status lr_world_set_gravity(lr_world* world, const float* gravity) {
    return change(
        world, Op::world_set_gravity, [&] { return lr_inner_world_set_gravity(world, gravity); },
        [&](Call& call) { call.array(gravity, 12); });
}

lr_status lr_world_set_simd_target(lr_world* world, int32_t target) {
    return plain_change(world, Op::world_set_simd_target, &lr_inner_world_set_simd_target, target);
}

lr_status lr_world_set_wind(lr_world* world, const lr_wind_desc* desc) {
    return plain_change(world, Op::world_set_wind, &lr_inner_world_set_wind, desc);
}

lr_status lr_world_add_wind(lr_world* world, const lr_wind_source_desc* desc, lr_wind_source* out) {
    if (out) *out = 0;
    return change(
        world, Op::world_add_wind, [&] { return lr_inner_world_add_wind(world, desc, out); },
        [&](Call& call) {
            tell_source(call, desc);
            call.output(out);
        });
}

lr_status lr_world_update_wind(lr_world* world, lr_wind_source source, const lr_wind_source_desc* desc) {
    return change(
        world, Op::world_update_wind, [&] { return lr_inner_world_update_wind(world, source, desc); },
        [&](Call& call) {
            call.value(source);
            tell_source(call, desc);
        });
}

lr_status lr_world_remove_wind(lr_world* world, lr_wind_source source) {
    return plain_change(world, Op::world_remove_wind, &lr_inner_world_remove_wind, source);
}

lr_status lr_world_set_wind_callback(lr_world* world, lr_wind_fn callback, void* user) {
    return change(
        world, Op::world_set_wind_callback,
        [&] {
            const lr_status status = lr_inner_world_set_wind_callback(world, callback, user);
            if (world && world->recorder) world->recorder->listen(*world);
            return status;
        },
        [&](Call& call) { call.value(callback ? 1u : 0u); });
}

lr_status lr_world_sample_wind(const lr_world* world, const float* positions, uint32_t count, float* velocities) {
    return plain_query(world, "lr_world_sample_wind", &lr_inner_world_sample_wind, positions, count, velocities);
}

lr_status lr_world_set_surface(lr_world* world, const lr_surface_desc* desc) {
    return plain_change(world, Op::world_set_surface, &lr_inner_world_set_surface, desc);
}

lr_status lr_world_set_surface_callback(lr_world* world, lr_surface_fn callback, void* user) {
    return change(
        world, Op::world_set_surface_callback,
        [&] {
            const lr_status status = lr_inner_world_set_surface_callback(world, callback, user);
            if (world && world->recorder) world->recorder->listen(*world);
            return status;
        },
        [&](Call& call) { call.value(callback ? 1u : 0u); });
}

lr_status lr_world_step(lr_world* world, float dt, uint32_t substeps) {
    return plain_change(world, Op::world_step, &lr_inner_world_step, dt, substeps);
}

lr_status lr_world_set_budget(lr_world* world, uint64_t body_substeps) {
    return plain_change(world, Op::world_set_budget, &lr_inner_world_set_budget, body_substeps);
}

lr_status lr_world_get_step_report(const lr_world* world, lr_step_report* report) {
    return plain_query(world, "lr_world_get_step_report", &lr_inner_world_get_step_report, report);
}

lr_status lr_world_hash(const lr_world* world, uint64_t* out) {
    return plain_query(world, "lr_world_hash", &lr_inner_world_hash, out);
}

uint64_t lr_world_snapshot_size(const lr_world* world) {
    uint64_t size = 0;
    query(world, "lr_world_snapshot_size", [&] {
        size = lr_inner_world_snapshot_size(world);
        return LR_OK;
    });
    return size;
}

lr_status lr_world_snapshot_save(const lr_world* world, void* memory, uint64_t size, uint64_t* written) {
    if (written) *written = 0;
    return plain_query(world, "lr_world_snapshot_save", &lr_inner_world_snapshot_save, memory, size, written);
}

lr_status lr_world_snapshot_restore(lr_world* world, const void* memory, uint64_t size) {
    return change(
        world, Op::world_snapshot_restore, [&] { return lr_inner_world_snapshot_restore(world, memory, size); },
        [&](Call& call) {
            if (call.reads(memory)) call.array(memory, lr::snapshot_bytes(memory));
        });
}

lr_status lr_world_wake_box(lr_world* world, const float* low, const float* high, uint32_t* woken) {
    if (woken) *woken = 0;
    return change(
        world, Op::world_wake_box, [&] { return lr_inner_world_wake_box(world, low, high, woken); },
        [&](Call& call) {
            call.array(low, 12);
            call.array(high, 12);
            call.output(woken);
        });
}

lr_status lr_world_set_contact_events(lr_world* world, uint32_t capacity, uint32_t kinds) {
    return plain_change(world, Op::world_set_contact_events, &lr_inner_world_set_contact_events, capacity, kinds);
}

lr_status lr_world_get_contact_events(const lr_world* world, lr_contact_event_list* list) {
    return plain_query(world, "lr_world_get_contact_events", &lr_inner_world_get_contact_events, list);
}

lr_status lr_world_ray_cast(const lr_world* world, const lr_ray* rays, uint32_t count, lr_ray_hit* hits) {
    return plain_query(world, "lr_world_ray_cast", &lr_inner_world_ray_cast, rays, count, hits);
}

lr_status lr_world_overlap(const lr_world* world, const lr_overlap_desc* desc, lr_body* bodies, uint32_t capacity,
                           uint32_t* count) {
    if (count) *count = 0;
    return plain_query(world, "lr_world_overlap", &lr_inner_world_overlap, desc, bodies, capacity, count);
}

} // extern "C"
