// Loads of a batch other than its asset's.
#include "api/aerodynamics.h"
#include "api/arguments.h"
#include "api/refuse.h"
#include "kernel/aerodynamics.h"
#include "world/world.h"

using lr::api::read_struct;
using lr::api::refuse;

extern "C" {

lr_status lr_inner_batch_set_aerodynamics(lr_world* world, lr_batch batch, const lr_aerodynamics* aerodynamics) {
    const lr::FloatMode mode;
    constexpr const char* name = "lr_batch_set_aerodynamics";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    lr::Batch* const b = world->find(batch);
    if (!b) return refuse(world, name, LR_ERROR_STALE_BATCH);
    if (!aerodynamics) {
        b->set_aerodynamics(b->asset().data.aerodynamics, b->gains());
        return LR_OK;
    }
    lr_aerodynamics a;
    const lr_status status = lr::api::read_loads(aerodynamics, a);
    if (status != LR_OK) return refuse(world, name, status);
    const lr::AerodynamicData loads = lr::api::from_struct(a);
    const char* why = lr::wrong_in(loads);
    if (!why && !b->set_aerodynamics(loads, b->gains())) why = "center is too far";
    if (why) return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, why);
    return LR_OK;
}

lr_status lr_inner_batch_get_aerodynamics(const lr_world* world, lr_batch batch, lr_aerodynamics* aerodynamics) {
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    const lr::Batch* const b = world->find(batch);
    constexpr const char* name = "lr_batch_get_aerodynamics";
    if (!b) return refuse(world, name, LR_ERROR_STALE_BATCH);
    const lr_status status = lr::api::check_size(aerodynamics);
    if (status != LR_OK) return refuse(world, name, status);
    lr::api::write_struct(lr::api::to_struct(b->aerodynamics()), aerodynamics);
    return LR_OK;
}

lr_status lr_load_gains_init(lr_load_gains* gains, uint32_t struct_size) {
    const lr_status status = lr::api::begin_init(gains, struct_size);
    if (status == LR_OK) gains->drag = gains->lift = gains->spin_drag = gains->turbulence = 1.0f;
    return status;
}

lr_status lr_inner_batch_set_load_gains(lr_world* world, lr_batch batch, const lr_load_gains* gains) {
    const lr::FloatMode mode;
    constexpr const char* name = "lr_batch_set_load_gains";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    lr::Batch* const b = world->find(batch);
    if (!b) return refuse(world, name, LR_ERROR_STALE_BATCH);
    lr_load_gains g{};
    lr_load_gains_init(&g, sizeof g);
    if (gains) {
        const lr_status status = read_struct(gains, g);
        if (status != LR_OK) return refuse(world, name, status);
    }
    const float factors[] = {g.drag, g.lift, g.spin_drag, g.turbulence};
    if (!lr::api::finite(factors)) return refuse(world, name, LR_ERROR_NOT_FINITE);
    if (g.reserved != 0) return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, "reserved is not 0");
    lr::Gains all = b->gains();
    all.drag = static_cast<double>(g.drag);
    all.lift = static_cast<double>(g.lift);
    all.spin_drag = static_cast<double>(g.spin_drag);
    all.turbulence = static_cast<double>(g.turbulence);
    if (const char* why = lr::wrong_in(all)) return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, why);
    return b->set_aerodynamics(b->aerodynamics(), all) ? LR_OK : refuse(world, name, LR_ERROR_INTERNAL);
}

} // extern "C"
