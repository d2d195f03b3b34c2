// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
#include "LangevinHost.h"

#include "Async/TaskGraphInterfaces.h"
#include "HAL/UnrealMemory.h"
#include "LangevinRigidModule.h"

namespace LangevinHost {
// uint64_t, as in the library: the engine's uint64 is another type on Linux.
namespace {
void* Allocate(void*, uint64_t Size, uint64_t Alignment) {
    return FMemory::Malloc(static_cast<SIZE_T>(Size), static_cast<uint32>(Alignment));
}

void Release(void*, void* Memory, uint64_t, uint64_t) {
    FMemory::Free(Memory);
}
} // namespace

lr_allocator Allocator() {
    return {nullptr, &Allocate, &Release};
}

void Log(void*, int32 Level, const char* Message) {
    const FString Text = UTF8_TO_TCHAR(Message);
    switch (Level) {
    case LR_LOG_ERROR:
        UE_LOG(LogLangevinRigid, Error, TEXT("%s"), *Text);
        break;
    case LR_LOG_WARNING:
        UE_LOG(LogLangevinRigid, Warning, TEXT("%s"), *Text);
        break;
    default:
        UE_LOG(LogLangevinRigid, Log, TEXT("%s"), *Text);
        break;
    }
}

bool Check(lr_status Status, const TCHAR* What) {
    if (Status == LR_OK) return true;
    UE_LOG(LogLangevinRigid, Error, TEXT("%s: %s"), What, UTF8_TO_TCHAR(lr_status_string(Status)));
    return false;
}
} // namespace LangevinHost

lr_job_system FLangevinJobs::Callbacks() {
    return {this, &Enqueue, &Finish};
}

uint32 FLangevinJobs::WorkerCount() {
    return static_cast<uint32>(FMath::Clamp(FTaskGraphInterface::Get().GetNumWorkerThreads(), 0, 64));
}

void* FLangevinJobs::Enqueue(void* User, lr_task_fn Run, void* Task, uint32 Count) {
    FLangevinJobs& Self = *static_cast<FLangevinJobs*>(User);
    for (uint32 Index = 0; Index < Count; ++Index) {
        Self.Tasks.Add(UE::Tasks::Launch(
            UE_SOURCE_LOCATION, [Run, Task, Index] { Run(Task, Index, Index + 1); }, UE::Tasks::ETaskPriority::High));
    }
    Self.Launched += Count;
    return &Self;
}

// Runs tasks that no thread has taken yet, then waits for the others.
void FLangevinJobs::Finish(void*, void* Token) {
    FLangevinJobs& Self = *static_cast<FLangevinJobs*>(Token);
    UE::Tasks::Wait(Self.Tasks);
    Self.Tasks.Reset();
}
