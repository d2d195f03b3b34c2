#include "api/refuse.h"
#include "world/world.h"

using namespace lr::api;

extern "C" {

lr_status lr_inner_batch_set_rate(lr_world* world, lr_batch batch, uint32_t divisor) {
    constexpr const char* name = "lr_batch_set_rate";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    lr::Batch* const b = world->find(batch);
    if (!b) return refuse(world, name, LR_ERROR_STALE_BATCH);
    if (divisor < 1 || divisor > lr::Pace::largest_of_all)
        return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, "divisor is not 1 to 1024");
    b->pace.set_divisor(divisor);
    return LR_OK;
}

lr_status lr_batch_pace_init(lr_batch_pace* pace, uint32_t struct_size) {
    return begin_init(pace, struct_size);
}

lr_status lr_inner_batch_get_pace(const lr_world* world, lr_batch batch, lr_batch_pace* pace) {
    constexpr const char* name = "lr_batch_get_pace";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    const lr::Batch* const b = world->find(batch);
    if (!b) return refuse(world, name, LR_ERROR_STALE_BATCH);
    const lr_status status = check_size(pace);
    if (status != LR_OK) return refuse(world, name, status);
    const lr::Pace::Record& r = b->pace.record();
    lr_batch_pace out{};
    out.divisor = r.divisor;
    out.substeps = b->pace.granted();
    out.waited = r.steps;
    out.behind = r.behind;
    out.lost = r.lost;
    out.body_substeps = r.taken;
    write_struct(out, pace);
    return LR_OK;
}

lr_status lr_inner_world_set_budget(lr_world* world, uint64_t body_substeps) {
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    if (body_substeps > lr::Pacing::largest_budget)
        return refuse(world, "lr_world_set_budget", LR_ERROR_INVALID_ARGUMENT, "body_substeps is over 2^48");
    world->pacing.set_budget(body_substeps);
    return LR_OK;
}

lr_status lr_step_report_init(lr_step_report* report, uint32_t struct_size) {
    return begin_init(report, struct_size);
}

lr_status lr_inner_world_get_step_report(const lr_world* world, lr_step_report* report) {
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    const lr_status status = check_size(report);
    if (status != LR_OK) return refuse(world, "lr_world_get_step_report", status);
    write_struct(world->pacing.report(), report);
    return LR_OK;
}

} // extern "C"
