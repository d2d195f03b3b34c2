#include "api/refuse.h"
#include "world/world.h"

namespace {

using namespace lr::api;

} // namespace

extern "C" {

lr_status lr_batch_rate_init(lr_batch_rate* rate, uint32_t struct_size) {
    const lr_status status = begin_init(rate, struct_size);
    if (status != LR_OK) return status;
    const lr_batch_rate initial = lr::Pace::initial_rate();
    rate->divisor = initial.divisor;
    rate->priority = initial.priority;
    return LR_OK;
}

lr_status lr_inner_batch_set_rate(lr_world* world, lr_batch batch, const lr_batch_rate* rate) {
    constexpr const char* name = "lr_batch_set_rate";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    lr::Batch* const b = world->find(batch);
    if (!b) return refuse(world, name, LR_ERROR_STALE_BATCH);
    if (!rate) {
        b->pace.set_rate(lr::Pace::initial_rate());
        return LR_OK;
    }
    lr_batch_rate r;
    const lr_status status = read_struct(rate, r);
    if (status != LR_OK) return refuse(world, name, status);
    const float numbers[] = {r.priority, r.longest_substep};
    if (!finite(numbers)) return refuse(world, name, LR_ERROR_NOT_FINITE);
    if (const char* why = lr::wrong_in(r)) return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, why);
    b->pace.set_rate(r);
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
    out.divisor = r.rate.divisor;
    out.priority = r.rate.priority;
    out.longest_substep = static_cast<float>(b->pace.longest_substep());
    out.substeps = b->pace.granted();
    out.waited = r.steps;
    out.behind = r.behind;
    out.lost = r.lost;
    out.body_substeps = r.taken;
    write_struct(out, pace);
    return LR_OK;
}

lr_status lr_budget_init(lr_budget* budget, uint32_t struct_size) {
    return begin_init(budget, struct_size);
}

lr_status lr_inner_world_set_budget(lr_world* world, const lr_budget* budget) {
    constexpr const char* name = "lr_world_set_budget";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    lr_budget b;
    lr_budget_init(&b, sizeof b);
    if (budget) {
        const lr_status status = read_struct(budget, b);
        if (status != LR_OK) return refuse(world, name, status);
        if (!std::isfinite(b.seconds)) return refuse(world, name, LR_ERROR_NOT_FINITE);
        if (const char* why = lr::wrong_in(b)) return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, why);
    }
    world->pacing.set_budget(b);
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
