// How batches meet colliders, and which meet each other.
#include "api/refuse.h"
#include "world/world.h"

#include <cmath>

namespace {

using namespace lr::api;

lr_batch_contact initial() {
    lr_batch_contact c{};
    const lr::ContactSettings s;
    c.layers = s.layers;
    c.friction = s.friction;
    c.restitution = s.restitution;
    c.rolling_resistance = s.rolling;
    return c;
}

} // namespace

extern "C" {

lr_status lr_batch_contact_init(lr_batch_contact* contact, uint32_t struct_size) {
    const lr_status status = begin_init(contact, struct_size);
    if (status != LR_OK) return status;
    lr_batch_contact c = initial();
    write_struct(c, contact);
    return LR_OK;
}

lr_status lr_inner_batch_set_contact(lr_world* world, lr_batch batch, const lr_batch_contact* contact) {
    const lr::FloatMode mode;
    constexpr const char* name = "lr_batch_set_contact";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    lr::Batch* const b = world->find(batch);
    if (!b) return refuse(world, name, LR_ERROR_STALE_BATCH);
    lr_batch_contact c = initial();
    if (contact) {
        const lr_status status = read_struct(contact, c);
        if (status != LR_OK) return refuse(world, name, status);
        if (!std::isfinite(c.friction) || !std::isfinite(c.restitution) || !std::isfinite(c.rolling_resistance) ||
            !std::isfinite(c.ground_effect))
            return refuse(world, name, LR_ERROR_NOT_FINITE);
        if ((c.flags & ~LR_CONTACT_NEVER_REST) != 0 || c.reserved != 0)
            return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, "flags has an unknown bit, or reserved is not 0");
    }
    const lr::ContactSettings settings{c.layers,        c.friction,
                                       c.restitution,   c.rolling_resistance,
                                       c.ground_effect, (c.flags & LR_CONTACT_NEVER_REST) == 0};
    if (const char* why = lr::wrong_in(settings)) return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, why);
    b->wake_all();
    b->contact = settings;
    return LR_OK;
}

lr_status lr_inner_batch_get_contact(const lr_world* world, lr_batch batch, lr_batch_contact* contact) {
    constexpr const char* name = "lr_batch_get_contact";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    const lr::Batch* const b = world->find(batch);
    if (!b) return refuse(world, name, LR_ERROR_STALE_BATCH);
    const lr_status status = check_size(contact);
    if (status != LR_OK) return refuse(world, name, status);
    const lr::ContactSettings& s = b->contact;
    lr_batch_contact c{};
    c.layers = s.layers;
    c.friction = s.friction;
    c.restitution = s.restitution;
    c.rolling_resistance = s.rolling;
    c.ground_effect = s.ground_effect;
    c.flags = s.may_rest ? 0 : LR_CONTACT_NEVER_REST;
    write_struct(c, contact);
    return LR_OK;
}

lr_status lr_inner_batch_set_pair_contact(lr_world* world, lr_batch a, lr_batch b, int32_t enabled) {
    const lr::FloatMode mode;
    constexpr const char* name = "lr_batch_set_pair_contact";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    if (!world->find(a) || !world->find(b)) return refuse(world, name, LR_ERROR_STALE_BATCH);
    if (enabled != 0 && enabled != 1)
        return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, "enabled is neither 0 nor 1");
    if (!world->set_pair(lr::unpack_batch(a).index, lr::unpack_batch(b).index, enabled != 0))
        return refuse(world, name, LR_ERROR_OUT_OF_MEMORY);
    return LR_OK;
}

lr_status lr_inner_batch_get_pair_contact(const lr_world* world, lr_batch a, lr_batch b, int32_t* enabled) {
    constexpr const char* name = "lr_batch_get_pair_contact";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    if (!enabled) return refuse(world, name, LR_ERROR_NULL_ARGUMENT);
    if (!world->find(a) || !world->find(b)) return refuse(world, name, LR_ERROR_STALE_BATCH);
    *enabled = world->pairs.has(lr::unpack_batch(a).index, lr::unpack_batch(b).index) ? 1 : 0;
    return LR_OK;
}

} // extern "C"
