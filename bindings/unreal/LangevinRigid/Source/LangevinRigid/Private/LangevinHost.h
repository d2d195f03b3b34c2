// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
// Services of the engine for a world of the library: memory, log and tasks.
#pragma once

#include "CoreMinimal.h"
#include "Tasks/Task.h"

#include <langevin_rigid.h>

namespace LangevinHost {
/** FMemory, so that the engine's statistics include the world's memory. */
lr_allocator Allocator();

/** lr_log_fn: logs to LogLangevinRigid. */
void Log(void* User, int32 Level, const char* Message);

/** Logs a failed call; What names the action. Returns whether the status is LR_OK. */
bool Check(lr_status Status, const TCHAR* What);
} // namespace LangevinHost

/** lr_job_system on UE::Tasks. Each world has its own, which outlives it: a world's rounds of tasks never overlap. */
class FLangevinJobs {
public:
    lr_job_system Callbacks();

    /** Threads of a step besides the caller's. */
    static uint32 WorkerCount();

    /** Tasks launched so far. */
    uint64 GetLaunched() const { return Launched; }

private:
    static void* Enqueue(void* User, lr_task_fn Run, void* Task, uint32 Count);
    static void Finish(void* User, void* Token);

    TArray<UE::Tasks::FTask> Tasks;
    uint64 Launched = 0;
};
