// Exported functions of batches: how calls come in.
#include "api/entry.h"

using namespace lr::api;

extern "C" {

lr_status lr_batch_create(lr_world* world, const lr_batch_desc* desc, lr_batch* out) {
    if (out) *out = 0;
    return change(world, "lr_batch_create", [&] { return lr_inner_batch_create(world, desc, out); });
}

lr_status lr_batch_destroy(lr_world* world, lr_batch batch) {
    return change(world, "lr_batch_destroy", [&] { return lr_inner_batch_destroy(world, batch); });
}

lr_status lr_batch_set_turbulence_table(lr_world* world, lr_batch batch, const lr_turbulence_table* table) {
    return change(world, "lr_batch_set_turbulence_table",
                  [&] { return lr_inner_batch_set_turbulence_table(world, batch, table); });
}

lr_status lr_batch_set_aerodynamics(lr_world* world, lr_batch batch, const lr_aerodynamics* aerodynamics) {
    return change(world, "lr_batch_set_aerodynamics",
                  [&] { return lr_inner_batch_set_aerodynamics(world, batch, aerodynamics); });
}

lr_status lr_batch_get_aerodynamics(const lr_world* world, lr_batch batch, lr_aerodynamics* aerodynamics) {
    return query(world, "lr_batch_get_aerodynamics",
                 [&] { return lr_inner_batch_get_aerodynamics(world, batch, aerodynamics); });
}

lr_status lr_batch_set_load_gains(lr_world* world, lr_batch batch, const lr_load_gains* gains) {
    return change(world, "lr_batch_set_load_gains", [&] { return lr_inner_batch_set_load_gains(world, batch, gains); });
}

lr_status lr_batch_set_rate(lr_world* world, lr_batch batch, const lr_batch_rate* rate) {
    return change(world, "lr_batch_set_rate", [&] { return lr_inner_batch_set_rate(world, batch, rate); });
}

lr_status lr_batch_get_pace(const lr_world* world, lr_batch batch, lr_batch_pace* pace) {
    return query(world, "lr_batch_get_pace", [&] { return lr_inner_batch_get_pace(world, batch, pace); });
}

lr_status lr_batch_get_view(const lr_world* world, lr_batch batch, lr_batch_view* view) {
    return query(world, "lr_batch_get_view", [&] { return lr_inner_batch_get_view(world, batch, view); });
}

lr_status lr_batch_write_transforms(const lr_world* world, lr_batch batch, int32_t format, void* dst, uint64_t stride,
                                    uint32_t capacity, uint32_t* written) {
    if (written) *written = 0;
    return query(world, "lr_batch_write_transforms",
                 [&] { return lr_inner_batch_write_transforms(world, batch, format, dst, stride, capacity, written); });
}

lr_status lr_batch_write_first_transforms(const lr_world* world, lr_batch batch, int32_t format, void* dst,
                                          uint64_t stride, uint32_t count, uint32_t* written) {
    if (written) *written = 0;
    return query(world, "lr_batch_write_first_transforms", [&] {
        return lr_inner_batch_write_first_transforms(world, batch, format, dst, stride, count, written);
    });
}

lr_status lr_batch_add_forces(lr_world* world, lr_batch batch, const lr_force_arrays* arrays) {
    return change(world, "lr_batch_add_forces", [&] { return lr_inner_batch_add_forces(world, batch, arrays); });
}

lr_status lr_batch_set_force(lr_world* world, lr_batch batch, const lr_batch_force* force) {
    return change(world, "lr_batch_set_force", [&] { return lr_inner_batch_set_force(world, batch, force); });
}

lr_status lr_batch_set_contact(lr_world* world, lr_batch batch, const lr_batch_contact* contact) {
    return change(world, "lr_batch_set_contact", [&] { return lr_inner_batch_set_contact(world, batch, contact); });
}

lr_status lr_batch_get_contact(const lr_world* world, lr_batch batch, lr_batch_contact* contact) {
    return query(world, "lr_batch_get_contact", [&] { return lr_inner_batch_get_contact(world, batch, contact); });
}

lr_status lr_batch_set_pair_contact(lr_world* world, lr_batch a, lr_batch b, int32_t enabled) {
    return change(world, "lr_batch_set_pair_contact",
                  [&] { return lr_inner_batch_set_pair_contact(world, a, b, enabled); });
}

lr_status lr_batch_get_pair_contact(const lr_world* world, lr_batch a, lr_batch b, int32_t* enabled) {
    return query(world, "lr_batch_get_pair_contact",
                 [&] { return lr_inner_batch_get_pair_contact(world, a, b, enabled); });
}

lr_status lr_batch_set_rules(lr_world* world, lr_batch batch, const lr_batch_rules* rules) {
    return change(world, "lr_batch_set_rules", [&] { return lr_inner_batch_set_rules(world, batch, rules); });
}

lr_status lr_batch_set_emitter(lr_world* world, lr_batch batch, const lr_emitter_desc* desc) {
    return change(world, "lr_batch_set_emitter", [&] { return lr_inner_batch_set_emitter(world, batch, desc); });
}

lr_status lr_batch_emit(lr_world* world, lr_batch batch, uint32_t count, lr_body* out_ids) {
    return change(world, "lr_batch_emit", [&] { return lr_inner_batch_emit(world, batch, count, out_ids); });
}

lr_status lr_batch_get_events(const lr_world* world, lr_batch batch, lr_batch_events* events) {
    return query(world, "lr_batch_get_events", [&] { return lr_inner_batch_get_events(world, batch, events); });
}

} // extern "C"
