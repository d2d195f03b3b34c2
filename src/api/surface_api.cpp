#include "api/refuse.h"
#include "field/surface.h"

extern "C" {

lr_status lr_surface_desc_init(lr_surface_desc* desc, uint32_t struct_size) {
    const lr_status status = lr::api::begin_init(desc, struct_size);
    if (status != LR_OK) return status;
    desc->normal[1] = 1.0f;
    desc->density = 998.0f;
    desc->viscosity = 1e-6f;
    return LR_OK;
}

lr_status lr_inner_world_set_surface(lr_world* world, const lr_surface_desc* desc) {
    const lr::FloatMode mode;
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    if (!desc) {
        world->surface.clear();
        return LR_OK;
    }
    lr_surface_desc d;
    const char* why = nullptr;
    lr_status status = lr::api::read_struct(desc, d);
    if (status == LR_OK) status = lr::check_surface(d, why);
    if (status != LR_OK)
        return lr::api::refuse(world, "lr_world_set_surface", status,
                               status == LR_ERROR_INVALID_ARGUMENT ? why : nullptr);
    world->surface.set(d, world->gravity);
    return LR_OK;
}

lr_status lr_inner_world_set_surface_callback(lr_world* world, lr_surface_fn callback, void* user) {
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    world->surface.set_callback(callback, user);
    return LR_OK;
}

} // extern "C"
