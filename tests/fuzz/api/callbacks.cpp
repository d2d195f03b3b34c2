// Callbacks that return nonsense, and job systems that run tasks in every permitted way.
#include "fuzz/api/model.h"

namespace fuzz {
namespace {

const float nonsense[] = {
    0.0f,   3.0f,  -1001.0f, std::numeric_limits<float>::quiet_NaN(), 1e30f, -std::numeric_limits<float>::infinity(),
    999.0f, 1e-40f};

// A function of position and time alone, as the header requires.
float some(const void* user, float position, uint32_t salt) {
    const auto kind = static_cast<uint32_t>(reinterpret_cast<uintptr_t>(user));
    if (kind == 1) return 0.5f;
    const uint32_t bits = std::bit_cast<uint32_t>(position) * 2654435761u + salt * 40503u;
    return kind == 2 ? static_cast<float>(bits >> 24) * 0.1f : nonsense[bits >> 29];
}

void blow(void* user, const lr_wind_query* q) {
    if (q->count == 0 || q->count > 256) defect("lr_wind_fn", "count", q->count);
    for (uint32_t i = 0; i < q->count; ++i) {
        for (size_t k = 0; k < 3; ++k) {
            if (!std::isfinite(q->position[k][i])) defect("lr_wind_fn", "a position is not finite");
            if (q->velocity[k][i] != 0.0f || q->rate[k][i] != 0.0f) defect("lr_wind_fn", "not 0 at first");
            q->velocity[k][i] = some(user, q->position[k][i], 1);
            q->rate[k][i] = some(user, q->position[k][i], 2);
        }
        for (size_t k = 0; k < 9; ++k) q->gradient[k][i] = some(user, q->position[k % 3][i], 3);
    }
}

void wave(void* user, const lr_water_query* q) {
    if (q->count == 0 || q->count > 256) defect("lr_water_fn", "count", q->count);
    for (uint32_t i = 0; i < q->count; ++i) {
        q->height[i] = some(user, q->position[0][i], 4);
        for (size_t k = 0; k < 3; ++k) {
            if (!std::isfinite(q->position[k][i])) defect("lr_water_fn", "a position is not finite");
            if (q->batch.id % 2 == 0) q->normal[k][i] = some(user, q->position[k][i], 5);
            q->velocity[k][i] = some(user, q->position[k][i], 6);
            q->rate[k][i] = some(user, q->position[k][i], 7);
        }
    }
}

struct Tasks {
    lr_task_fn run;
    void* task;
    uint32_t count;
};

void* at_once(void*, lr_task_fn run, void* task, uint32_t count) {
    run(task, 0, count);
    return nullptr;
}
void nothing(void*, void*) {}

void* backwards(void*, lr_task_fn run, void* task, uint32_t count) {
    for (uint32_t i = count; i-- > 0;) run(task, i, i + 1);
    return reinterpret_cast<void*>(1);
}

void* late(void*, lr_task_fn run, void* task, uint32_t count) {
    return new Tasks{run, task, count};
}
void run_late(void*, void* token) {
    const std::unique_ptr<Tasks> tasks(static_cast<Tasks*>(token));
    tasks->run(tasks->task, 0, tasks->count / 2);
    if (tasks->count / 2 < tasks->count) tasks->run(tasks->task, tasks->count / 2, tasks->count);
}

} // namespace

lr_job_system hostile_jobs(uint32_t kind) {
    switch (kind % 4) {
    case 1:
        return {nullptr, at_once, nothing};
    case 2:
        return {nullptr, backwards, nothing};
    case 3:
        return {nullptr, late, run_late};
    default:
        return {};
    }
}

void set_callbacks(World& w, lr_world* at) {
    const auto user = [](uint32_t kind) { return reinterpret_cast<void*>(static_cast<uintptr_t>(kind)); };
    if (LR_CALL(lr_world_set_wind_callback)(at, w.wind_callback ? blow : nullptr, user(w.wind_callback)) != LR_OK)
        defect("lr_world_set_wind_callback", "failed");
    if (LR_CALL(lr_world_set_water_callback)(at, w.surface_callback ? wave : nullptr, user(w.surface_callback)) !=
        LR_OK)
        defect("lr_world_set_water_callback", "failed");
}

} // namespace fuzz
