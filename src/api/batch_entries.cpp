// Exported functions of batches: how calls come in.
#include "api/entry.h"

using namespace lr::api;
using lr::record::BatchRecord;
using lr::record::TableRecord;
using lr::record::Where;

namespace {

void tell_batch(Call& call, const lr_batch_desc* desc) {
    if (!call.reads(desc)) return;
    lr_batch_desc d{};
    read_struct(desc, d);
    const BatchRecord record{call.asset(*d.asset), d.capacity,   d.load_model,   d.clock,
                             d.table_end,          d.integrator, d.damping_gain, d.noise_gain};
    call.value(static_cast<uint32_t>(Where::here));
    call.raw(&record, sizeof record);
}

void tell_table(Call& call, const lr_turbulence_table* table) {
    if (!call.reads(table)) return;
    lr_turbulence_table t{};
    read_struct(table, t);
    const TableRecord record{t.count, t.dt, t.u0, t.l, t.c0, t.stationary, t.reserved};
    call.value(static_cast<uint32_t>(Where::here));
    call.raw(&record, sizeof record);
    call.shared_array(t.chi, sizeof(float) * uint64_t{t.count});
    call.shared_array(t.epsilon, sizeof(float) * uint64_t{t.count});
}

// Arrays without gaps.
void tell_forces(Call& call, const lr_force_arrays* arrays) {
    lr_force_arrays a{};
    if (!call.structure(arrays, a)) return;
    const uint64_t stride = a.stride == 0 ? sizeof(float) : a.stride;
    for (const auto* three : {&a.force, &a.torque})
        for (const float* from : *three) {
            call.value(static_cast<uint32_t>(from ? Where::here : Where::null));
            for (uint32_t i = 0; from && i < a.count; ++i)
                call.raw(reinterpret_cast<const unsigned char*>(from) + stride * i, sizeof(float));
        }
}

} // namespace

extern "C" {

lr_status lr_batch_create(lr_world* world, const lr_batch_desc* desc, lr_batch* out) {
    if (out) *out = 0;
    return change(
        world, Op::batch_create, [&] { return lr_inner_batch_create(world, desc, out); },
        [&](Call& call) {
            tell_batch(call, desc);
            call.output(out);
        });
}

lr_status lr_batch_destroy(lr_world* world, lr_batch batch) {
    return plain_change(world, Op::batch_destroy, &lr_inner_batch_destroy, batch);
}

lr_status lr_batch_set_turbulence_table(lr_world* world, lr_batch batch, const lr_turbulence_table* table) {
    return change(
        world, Op::batch_set_turbulence_table, [&] { return lr_inner_batch_set_turbulence_table(world, batch, table); },
        [&](Call& call) {
            call.value(batch);
            tell_table(call, table);
        });
}

lr_status lr_batch_set_aerodynamics(lr_world* world, lr_batch batch, const lr_aerodynamics* aerodynamics) {
    return plain_change(world, Op::batch_set_aerodynamics, &lr_inner_batch_set_aerodynamics, batch, aerodynamics);
}

lr_status lr_batch_get_aerodynamics(const lr_world* world, lr_batch batch, lr_aerodynamics* aerodynamics) {
    return plain_query(world, "lr_batch_get_aerodynamics", &lr_inner_batch_get_aerodynamics, batch, aerodynamics);
}

lr_status lr_batch_set_load_gains(lr_world* world, lr_batch batch, const lr_load_gains* gains) {
    return plain_change(world, Op::batch_set_load_gains, &lr_inner_batch_set_load_gains, batch, gains);
}

lr_status lr_batch_set_rate(lr_world* world, lr_batch batch, uint32_t divisor) {
    return plain_change(world, Op::batch_set_rate, &lr_inner_batch_set_rate, batch, divisor);
}

lr_status lr_batch_get_pace(const lr_world* world, lr_batch batch, lr_batch_pace* pace) {
    return plain_query(world, "lr_batch_get_pace", &lr_inner_batch_get_pace, batch, pace);
}

lr_status lr_batch_get_view(const lr_world* world, lr_batch batch, lr_batch_view* view) {
    return plain_query(world, "lr_batch_get_view", &lr_inner_batch_get_view, batch, view);
}

lr_status lr_batch_write_transforms(const lr_world* world, lr_batch batch, int32_t format, void* dst, uint64_t stride,
                                    uint32_t count, uint32_t* written) {
    if (written) *written = 0;
    return plain_query(world, "lr_batch_write_transforms", &lr_inner_batch_write_transforms, batch, format, dst, stride,
                       count, written);
}

lr_status lr_batch_add_forces(lr_world* world, lr_batch batch, const lr_force_arrays* arrays) {
    return change(
        world, Op::batch_add_forces, [&] { return lr_inner_batch_add_forces(world, batch, arrays); },
        [&](Call& call) {
            call.value(batch);
            tell_forces(call, arrays);
        });
}

lr_status lr_batch_set_force(lr_world* world, lr_batch batch, const lr_batch_force* force) {
    return plain_change(world, Op::batch_set_force, &lr_inner_batch_set_force, batch, force);
}

lr_status lr_batch_set_contact(lr_world* world, lr_batch batch, const lr_batch_contact* contact) {
    return plain_change(world, Op::batch_set_contact, &lr_inner_batch_set_contact, batch, contact);
}

lr_status lr_batch_get_contact(const lr_world* world, lr_batch batch, lr_batch_contact* contact) {
    return plain_query(world, "lr_batch_get_contact", &lr_inner_batch_get_contact, batch, contact);
}

lr_status lr_batch_set_pair_contact(lr_world* world, lr_batch a, lr_batch b, int32_t enabled) {
    return plain_change(world, Op::batch_set_pair_contact, &lr_inner_batch_set_pair_contact, a, b, enabled);
}

lr_status lr_batch_get_pair_contact(const lr_world* world, lr_batch a, lr_batch b, int32_t* enabled) {
    return plain_query(world, "lr_batch_get_pair_contact", &lr_inner_batch_get_pair_contact, a, b, enabled);
}

lr_status lr_batch_set_fault_policy(lr_world* world, lr_batch batch, int32_t policy) {
    return plain_change(world, Op::batch_set_fault_policy, &lr_inner_batch_set_fault_policy, batch, policy);
}

lr_status lr_batch_get_fault_policy(const lr_world* world, lr_batch batch, int32_t* policy) {
    return plain_query(world, "lr_batch_get_fault_policy", &lr_inner_batch_get_fault_policy, batch, policy);
}

lr_status lr_batch_set_rules(lr_world* world, lr_batch batch, const lr_batch_rules* rules) {
    return plain_change(world, Op::batch_set_rules, &lr_inner_batch_set_rules, batch, rules);
}

lr_status lr_batch_set_emitter(lr_world* world, lr_batch batch, const lr_emitter_desc* desc) {
    return plain_change(world, Op::batch_set_emitter, &lr_inner_batch_set_emitter, batch, desc);
}

lr_status lr_batch_emit(lr_world* world, lr_batch batch, uint32_t count, lr_body* out_ids) {
    return change(
        world, Op::batch_emit, [&] { return lr_inner_batch_emit(world, batch, count, out_ids); },
        [&](Call& call) {
            call.value(batch);
            call.value(count);
            call.output(out_ids, count);
        });
}

lr_status lr_batch_get_events(const lr_world* world, lr_batch batch, lr_batch_events* events) {
    return plain_query(world, "lr_batch_get_events", &lr_inner_batch_get_events, batch, events);
}

} // extern "C"
