#include "api/refuse.h"
#include "world/lifecycle.h"
#include "world/world.h"

namespace {

using namespace lr::api;

} // namespace

extern "C" {

lr_status lr_batch_rules_init(lr_batch_rules* rules, uint32_t struct_size) {
    return begin_init(rules, struct_size);
}

lr_status lr_inner_batch_set_rules(lr_world* world, lr_batch batch, const lr_batch_rules* rules) {
    const lr::FloatMode mode;
    constexpr const char* name = "lr_batch_set_rules";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    lr::Batch* const b = world->find(batch);
    if (!b) return refuse(world, name, LR_ERROR_STALE_BATCH);
    if (!rules) {
        if (b->lifecycle()) b->lifecycle()->set_rules(nullptr);
        return LR_OK;
    }
    lr_batch_rules r;
    const lr_status status = read_struct(rules, r);
    if (status != LR_OK) return refuse(world, name, status);
    if (!lr::all_finite(r)) return refuse(world, name, LR_ERROR_NOT_FINITE);
    if (const char* why = lr::wrong_in(r)) return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, why);
    if (r.action == LR_END_RESPAWN && (!b->lifecycle() || !b->lifecycle()->has_emitter()))
        return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, "LR_END_RESPAWN needs an emitter: set it first");
    if (!b->reserve_lifecycle()) return refuse(world, name, LR_ERROR_OUT_OF_MEMORY);
    b->lifecycle()->set_rules(&r);
    if (b->resting()) b->resting()->ask_again();
    return LR_OK;
}

lr_status lr_emitter_desc_init(lr_emitter_desc* desc, uint32_t struct_size) {
    const lr_status status = begin_init(desc, struct_size);
    if (status != LR_OK) return status;
    desc->orientation[3] = desc->body_orientation[3] = 1.0f;
    desc->direction[1] = -1.0f;
    desc->scale_min = desc->scale_max = 1.0f;
    return LR_OK;
}

lr_status lr_inner_batch_set_emitter(lr_world* world, lr_batch batch, const lr_emitter_desc* desc) {
    const lr::FloatMode mode;
    constexpr const char* name = "lr_batch_set_emitter";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    lr::Batch* const b = world->find(batch);
    if (!b) return refuse(world, name, LR_ERROR_STALE_BATCH);
    if (!desc) {
        if (!b->lifecycle()) return LR_OK;
        if (b->lifecycle()->respawns())
            return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, "the rules respawn: change them first");
        b->lifecycle()->set_emitter(nullptr);
        return LR_OK;
    }
    lr_emitter_desc d;
    const lr_status status = read_struct(desc, d);
    if (status != LR_OK) return refuse(world, name, status);
    if (!lr::all_finite(d)) return refuse(world, name, LR_ERROR_NOT_FINITE);
    if (const char* why = lr::wrong_in(d)) return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, why);
    if (!b->reserve_lifecycle()) return refuse(world, name, LR_ERROR_OUT_OF_MEMORY);
    b->lifecycle()->set_emitter(&d);
    return LR_OK;
}

lr_status lr_inner_batch_emit(lr_world* world, lr_batch batch, uint32_t count, lr_body* out_ids) {
    const lr::FloatMode mode;
    constexpr const char* name = "lr_batch_emit";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    lr::Batch* const b = world->find(batch);
    if (!b) return refuse(world, name, LR_ERROR_STALE_BATCH);
    if (count == 0) return LR_OK;
    if (!b->lifecycle() || !b->lifecycle()->has_emitter())
        return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, "the batch has no emitter");
    if (count > b->capacity() - b->count()) return refuse(world, name, LR_ERROR_CAPACITY);
    b->lifecycle()->emit(*b, *world, count, out_ids);
    return LR_OK;
}

lr_status lr_inner_batch_set_fault_policy(lr_world* world, lr_batch batch, int32_t policy) {
    constexpr const char* name = "lr_batch_set_fault_policy";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    lr::Batch* const b = world->find(batch);
    if (!b) return refuse(world, name, LR_ERROR_STALE_BATCH);
    if (policy < LR_FAULT_AUTO || policy > LR_FAULT_REMOVE)
        return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, "unknown policy");
    if (policy == LR_FAULT_REMOVE && !b->reserve_lifecycle()) return refuse(world, name, LR_ERROR_OUT_OF_MEMORY);
    b->faults.policy = policy;
    return LR_OK;
}

lr_status lr_inner_batch_get_fault_policy(const lr_world* world, lr_batch batch, int32_t* policy) {
    constexpr const char* name = "lr_batch_get_fault_policy";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    const lr::Batch* const b = world->find(batch);
    if (!b) return refuse(world, name, LR_ERROR_STALE_BATCH);
    if (!policy) return refuse(world, name, LR_ERROR_NULL_ARGUMENT);
    *policy = b->faults.policy;
    return LR_OK;
}

lr_status lr_batch_events_init(lr_batch_events* events, uint32_t struct_size) {
    return begin_init(events, struct_size);
}

lr_status lr_inner_batch_get_events(const lr_world* world, lr_batch batch, lr_batch_events* events) {
    constexpr const char* name = "lr_batch_get_events";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    const lr::Batch* const b = world->find(batch);
    if (!b) return refuse(world, name, LR_ERROR_STALE_BATCH);
    const lr_status status = check_size(events);
    if (status != LR_OK) return refuse(world, name, status);
    lr_batch_events out{};
    if (b->lifecycle()) b->lifecycle()->report(out);
    out.faulted = b->faults.last;
    out.total_faulted = b->faults.total;
    write_struct(out, events);
    return LR_OK;
}

} // extern "C"
