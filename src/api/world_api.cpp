#include "api/refuse.h"
#include "world/snapshot.h"
#include "world/world.h"

#include <algorithm>

namespace {

using namespace lr::api;

bool known_simd(int32_t target) {
    return target >= LR_SIMD_AUTO && target <= LR_SIMD_PLAIN;
}

} // namespace

extern "C" {

lr_status lr_world_desc_init(lr_world_desc* desc, uint32_t struct_size) {
    const lr_status status = begin_init(desc, struct_size);
    if (status == LR_OK) desc->gravity[1] = -9.81f;
    return status;
}

lr_status lr_world_create(const lr_world_desc* desc, lr_world** out) {
    if (!out) return LR_ERROR_NULL_ARGUMENT;
    *out = nullptr;
    lr_world_desc d;
    lr_status status = read_struct(desc, d);
    if (status != LR_OK) return status;
    if (!finite(d.gravity) || !std::isfinite(d.fluid_density) || !std::isfinite(d.fluid_viscosity))
        return LR_ERROR_NOT_FINITE;
    if (d.worker_count > lr::WorkerPool::max_workers || !in_range(d.fluid_density, 0.0, 1e6) ||
        !known_simd(d.simd_target) || !in_range(d.fluid_viscosity, 0.0, 1e3) || (d.checks & ~LR_CHECK_THREADS) != 0 ||
        d.reserved != 0 || !d.allocator.allocate != !d.allocator.release || !d.jobs.enqueue != !d.jobs.finish)
        return LR_ERROR_INVALID_ARGUMENT;
    if (lr::wrong_gravity(d.gravity)) return LR_ERROR_INVALID_ARGUMENT;
    return guarded([&] {
        *out = lr_world::create(d, status);
        return status;
    });
}

lr_status lr_world_info_init(lr_world_info* info, uint32_t struct_size) {
    return begin_init(info, struct_size);
}

lr_status lr_inner_world_get_info(const lr_world* world, lr_world_info* info) {
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    const lr_status status = check_size(info);
    if (status != LR_OK) return status;
    lr_world_info out{};
    out.simd_target = world->target->simd;
    out.worker_count = world->crew.helpers();
    for (uint32_t i = 0; i < world->batch_slots; ++i) {
        if (!world->batches[i].batch) continue;
        ++out.batch_count;
        out.body_count += world->batches[i].batch->count();
        out.awake_count += world->batches[i].batch->awake();
    }
    out.substep_count = world->substep_count;
    out.time = world->time;
    out.memory_bytes = world->allocator.bytes();
    out.collider_count = world->colliders.count();
    write_struct(out, info);
    return LR_OK;
}

lr_status lr_inner_world_set_gravity(lr_world* world, const float* gravity) {
    if (!world || !gravity) return LR_ERROR_NULL_ARGUMENT;
    float to[3];
    std::copy(gravity, gravity + 3, to);
    if (!finite(to)) return refuse(world, "lr_world_set_gravity", LR_ERROR_NOT_FINITE);
    if (const char* why = lr::wrong_gravity(to))
        return refuse(world, "lr_world_set_gravity", LR_ERROR_INVALID_ARGUMENT, why);
    world->set_gravity(to);
    return LR_OK;
}

lr_status lr_inner_world_set_simd_target(lr_world* world, int32_t target) {
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    if (!known_simd(target)) return refuse(world, "lr_world_set_simd_target", LR_ERROR_INVALID_ARGUMENT);
    const lr::KernelTarget* const found = lr::find_target(target);
    if (!found) return refuse(world, "lr_world_set_simd_target", LR_ERROR_UNSUPPORTED);
    world->target = found;
    world->contact = &lr::contact_target(found->simd);
    return LR_OK;
}

lr_status lr_wind_desc_init(lr_wind_desc* desc, uint32_t struct_size) {
    const lr_status status = begin_init(desc, struct_size);
    if (status == LR_OK) desc->kind = LR_WIND_UNIFORM;
    return status;
}

lr_status lr_inner_world_set_wind(lr_world* world, const lr_wind_desc* desc) {
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    float wind[3] = {0.0f, 0.0f, 0.0f};
    if (desc) {
        lr_wind_desc d;
        const lr_status status = read_struct(desc, d);
        if (status != LR_OK) return refuse(world, "lr_world_set_wind", status);
        if (!finite(d.velocity)) return refuse(world, "lr_world_set_wind", LR_ERROR_NOT_FINITE);
        if ((d.kind != LR_WIND_NONE && d.kind != LR_WIND_UNIFORM) || d.reserved != 0)
            return refuse(world, "lr_world_set_wind", LR_ERROR_INVALID_ARGUMENT, "unknown kind of wind");
        if (const char* why = lr::wrong_wind(d.velocity))
            return refuse(world, "lr_world_set_wind", LR_ERROR_INVALID_ARGUMENT, why);
        if (d.kind == LR_WIND_UNIFORM) std::copy(d.velocity, d.velocity + 3, wind);
    }
    std::copy(wind, wind + 3, world->wind.uniform.wind);
    return LR_OK;
}

lr_status lr_inner_world_step(lr_world* world, float dt, uint32_t substeps) {
    const lr::FloatMode mode;
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    lr_status status = LR_OK;
    if (!std::isfinite(dt))
        status = LR_ERROR_TIMESTEP_NOT_FINITE;
    else if (dt == 0.0f)
        status = LR_ERROR_TIMESTEP_ZERO;
    else if (dt < 0.0f)
        status = LR_ERROR_TIMESTEP_NEGATIVE;
    else if (substeps == 0 || substeps > LR_MAX_SUBSTEPS)
        status = LR_ERROR_SUBSTEPS;
    else if (static_cast<double>(dt) / substeps > static_cast<double>(LR_MAX_SUBSTEP))
        status = LR_ERROR_TIMESTEP_TOO_LARGE;
    if (status != LR_OK) return refuse(world, "lr_world_step", status);
    if (world->step(dt, substeps, mode)) return LR_OK;
    return refuse(world, "lr_world_step", LR_ERROR_OUT_OF_MEMORY,
                  "out of memory: the step was taken, and bodies went through each other in it");
}

lr_status lr_inner_world_hash(const lr_world* world, uint64_t* out) {
    if (!world || !out) return LR_ERROR_NULL_ARGUMENT;
    *out = world->hash();
    return LR_OK;
}

uint64_t lr_inner_world_snapshot_size(const lr_world* world) {
    return world ? lr::snapshot_size(*world) : 0;
}

lr_status lr_inner_world_snapshot_save(const lr_world* world, void* memory, uint64_t size, uint64_t* written) {
    if (written) *written = 0;
    if (!world || !memory) return LR_ERROR_NULL_ARGUMENT;
    const lr_status status = lr::snapshot_save(*world, memory, size, written);
    return status == LR_OK ? status : refuse(world, "lr_world_snapshot_save", status);
}

lr_status lr_inner_world_snapshot_restore(lr_world* world, const void* memory, uint64_t size) {
    const lr::FloatMode mode; // boxes of bodies at rest and constants of loads are made anew
    if (!world || !memory) return LR_ERROR_NULL_ARGUMENT;
    lr_status status = LR_ERROR_SNAPSHOT_FORMAT;
    if (lr::snapshot_is_whole(memory, size))
        status = accepted(world) ? lr::snapshot_restore(*world, memory) : LR_ERROR_OUT_OF_MEMORY;
    return status == LR_OK ? status : refuse(world, "lr_world_snapshot_restore", status);
}

} // extern "C"
