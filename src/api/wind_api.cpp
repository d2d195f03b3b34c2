#include "api/refuse.h"
#include "field/field_step.h"
#include "world/world.h"

namespace {

using namespace lr::api;

// Checks a description and its samples. `kept`: samples need not be given.
lr_status check(const lr_world* world, const char* function, const lr_wind_source_desc* desc, bool kept,
                lr_wind_source_desc& out) {
    lr_status status = read_struct(desc, out);
    if (status != LR_OK) return refuse(world, function, status);
    const char* why = nullptr;
    status = lr::check_wind_source(out, why);
    if (status != LR_OK) return refuse(world, function, status, why);
    if (out.kind != LR_WIND_SOURCE_GRID) return LR_OK;
    if (!out.samples) return kept ? LR_OK : refuse(world, function, LR_ERROR_NULL_ARGUMENT);
    const uint64_t count = lr::sample_count(out);
    for (uint64_t i = 0; i < count; ++i) {
        if (!std::isfinite(out.samples[i])) return refuse(world, function, LR_ERROR_NOT_FINITE);
        if (!in_range(out.samples[i], -lr::most_wind, lr::most_wind))
            return refuse(world, function, LR_ERROR_INVALID_ARGUMENT, "a sample is over 1000 m/s");
    }
    return LR_OK;
}

} // namespace

extern "C" {

lr_status lr_wind_source_desc_init(lr_wind_source_desc* desc, uint32_t struct_size) {
    const lr_status status = begin_init(desc, struct_size);
    if (status != LR_OK) return status;
    desc->direction[0] = 1.0f;
    desc->side[2] = 1.0f;
    desc->speed = desc->circulation = desc->size = 1.0f;
    desc->range = desc->reference_height = 10.0f;
    desc->spread = 0.1f;
    desc->octaves = 2;
    desc->frames = 1;
    for (float& s : desc->spacing) s = 1.0f;
    return LR_OK;
}

lr_status lr_inner_world_add_wind(lr_world* world, const lr_wind_source_desc* desc, lr_wind_source* out) {
    const lr::FloatMode mode;
    constexpr const char* name = "lr_world_add_wind";
    if (out) *out = 0;
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    lr_wind_source_desc d;
    lr_status status = check(world, name, desc, false, d);
    if (status != LR_OK) return status;
    lr_wind_source unasked = 0;
    status =
        accepted(world) ? world->wind.add(d, world->time, world->seed, out ? *out : unasked) : LR_ERROR_OUT_OF_MEMORY;
    return status == LR_OK ? status : refuse(world, name, status);
}

lr_status lr_inner_world_update_wind(lr_world* world, lr_wind_source source, const lr_wind_source_desc* desc) {
    const lr::FloatMode mode;
    constexpr const char* name = "lr_world_update_wind";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    if (!world->wind.find(source)) return refuse(world, name, LR_ERROR_STALE_WIND_SOURCE);
    lr_wind_source_desc d;
    lr_status status = check(world, name, desc, true, d);
    if (status != LR_OK) return status;
    status = world->wind.update(source, d, world->time, world->seed);
    return status == LR_OK ? status : refuse(world, name, status);
}

lr_status lr_inner_world_remove_wind(lr_world* world, lr_wind_source source) {
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    return world->wind.remove(source) ? LR_OK : refuse(world, "lr_world_remove_wind", LR_ERROR_STALE_WIND_SOURCE);
}

lr_status lr_inner_world_set_wind_callback(lr_world* world, lr_wind_fn callback, void* user) {
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    world->wind.set_callback(callback, user);
    return LR_OK;
}

lr_status lr_inner_world_sample_wind(const lr_world* world, const float* positions, uint32_t count, float* velocities) {
    const lr::FloatMode mode;
    constexpr const char* name = "lr_world_sample_wind";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    if (count == 0) return LR_OK;
    if (!positions || !velocities) return refuse(world, name, LR_ERROR_NULL_ARGUMENT);
    for (uint64_t i = 0; i < uint64_t{3} * count; ++i) {
        if (!std::isfinite(positions[i])) return refuse(world, name, LR_ERROR_NOT_FINITE);
        if (!in_range(positions[i], -1e9, 1e9))
            return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, "position is over 1e9 m");
    }
    world->sample_wind(positions, count, velocities);
    return LR_OK;
}

} // extern "C"
