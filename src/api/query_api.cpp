#include "api/refuse.h"
#include "world/queries.h"
#include "world/world.h"

#include <algorithm>

namespace {

using namespace lr::api;
using lr::most_place;
using lr::most_size;
using lr::within;

static_assert(sizeof(lr_ray_hit) == 48);

// Null when fine, else what is wrong. Of finite numbers only.
const char* wrong_in(const lr_ray& r) {
    if (r.flags == 0 || (r.flags & ~(LR_RAY_BODIES | LR_RAY_COLLIDERS)) != 0) return "flags are not of LR_RAY_*";
    if (!within(r.origin, most_place)) return "origin is over 1e9 m";
    double square = 0.0;
    for (float x : r.direction) square += static_cast<double>(x) * static_cast<double>(x);
    if (!in_range(square, 0.999e-12, 1.001e12)) return "direction is not 1e-6 to 1e6 long";
    if (!in_range(r.max_distance, 0.0, most_place)) return "max_distance is not 0 to 1e9 m";
    return r.reserved != 0 ? "reserved is not 0" : nullptr;
}

const char* wrong_in(const lr_overlap_desc& d) {
    if (d.shape != LR_OVERLAP_SPHERE && d.shape != LR_OVERLAP_BOX) return "unknown shape";
    if (!within(d.position, most_place)) return "position is over 1e9 m";
    double n = 0.0;
    for (float q : d.orientation) n += static_cast<double>(q) * static_cast<double>(q);
    if (!in_range(n, 1e-12, 1e12)) return "orientation cannot be normalised";
    for (int k = 0; k < (d.shape == LR_OVERLAP_SPHERE ? 1 : 3); ++k)
        if (!(d.size[k] > 0.0f) || !in_range(d.size[k], 0.0, most_size)) return "size is not over 0, up to 1e6 m";
    return d.reserved != 0 ? "reserved is not 0" : nullptr;
}

} // namespace

extern "C" {

lr_status lr_ray_init(lr_ray* ray, uint32_t struct_size) {
    const lr_status status = begin_init(ray, struct_size);
    if (status != LR_OK) return status;
    ray->flags = LR_RAY_BODIES | LR_RAY_COLLIDERS;
    ray->direction[1] = -1.0f;
    ray->max_distance = 1e9f;
    ray->collider_layers = 0xffffffffu;
    return LR_OK;
}

lr_status lr_inner_world_ray_cast(const lr_world* world, const lr_ray* rays, uint32_t count, lr_ray_hit* hits) {
    const lr::FloatMode mode;
    constexpr const char* name = "lr_world_ray_cast";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    if (count == 0) return LR_OK;
    if (!rays || !hits) return refuse(world, name, LR_ERROR_NULL_ARGUMENT);
    const ArrayOf<lr_ray> all(rays);
    lr_ray ray{};
    for (uint32_t i = 0; i < count; ++i) {
        const lr_status status = all.read(i, ray);
        if (status != LR_OK) return refuse(world, name, status);
        if (!finite(ray.origin) || !finite(ray.direction) || !std::isfinite(ray.max_distance))
            return refuse(world, name, LR_ERROR_NOT_FINITE);
        if (const char* why = wrong_in(ray)) return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, why);
        if (ray.batch != 0 && !world->find(ray.batch)) return refuse(world, name, LR_ERROR_STALE_BATCH);
    }
    for (uint32_t i = 0; i < count; ++i) {
        all.read(i, ray);
        hits[i] = lr::cast_ray(*world, ray, ray.batch != 0 ? world->find(ray.batch) : nullptr);
    }
    return LR_OK;
}

lr_status lr_overlap_desc_init(lr_overlap_desc* desc, uint32_t struct_size) {
    const lr_status status = begin_init(desc, struct_size);
    if (status != LR_OK) return status;
    desc->shape = LR_OVERLAP_SPHERE;
    desc->orientation[3] = 1.0f;
    std::fill(desc->size, desc->size + 3, 1.0f);
    return LR_OK;
}

lr_status lr_inner_world_overlap(const lr_world* world, const lr_overlap_desc* desc, lr_body* bodies, uint32_t capacity,
                                 uint32_t* count) {
    const lr::FloatMode mode;
    constexpr const char* name = "lr_world_overlap";
    if (count) *count = 0;
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    if (!count || (!bodies && capacity != 0)) return refuse(world, name, LR_ERROR_NULL_ARGUMENT);
    lr_overlap_desc d;
    const lr_status status = read_struct(desc, d);
    if (status != LR_OK) return refuse(world, name, status);
    if (!finite(d.position) || !finite(d.orientation) || !finite(d.size))
        return refuse(world, name, LR_ERROR_NOT_FINITE);
    if (const char* why = wrong_in(d)) return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, why);
    const lr::Batch* const only = d.batch != 0 ? world->find(d.batch) : nullptr;
    if (d.batch != 0 && !only) return refuse(world, name, LR_ERROR_STALE_BATCH);
    *count = lr::find_overlaps(*world, d, only, bodies, capacity);
    return *count <= capacity ? LR_OK : refuse(world, name, LR_ERROR_BUFFER_TOO_SMALL);
}

} // extern "C"
